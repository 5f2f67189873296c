"""The judge: it draws the variants, reads answers as data, and computes the points. It never runs student code.

    python -m misstep.grading.judging.judge_process COURSE

COURSE is the package of an installed course, or the folder of another one.

It answers three kinds of requests from stdin on stdout. "problems" returns the numbers, titles and points of the sheet's
problems. "redacted sheet" returns a student's sheet without answers, and a seed from which the inputs of function answers
are drawn anew in every run. "verdicts" judges answers; the request has the seed of the redacted sheet, and the address of the
course's site.

It runs in the folder of the sheet, because a robot's own sheet is described by a file there.
"""

import os
import secrets
import signal
import sys
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from misstep.catalog import Course, find_course
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading.sandbox.confine import set_resource_limits
from misstep.grading.sandbox.redacted_sheet import redact
from misstep.grading.sandbox.rpc import encode_message, receive_message
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import Sheet
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict, observation

ANSWER_SECONDS = 4.0
"""Processor time for one answer, so that a busy machine changes no verdict. The slowest answers that people give, tables that
no mistake explains, take a tenth of it."""

MEMORY_BYTES = 2 << 30
"""The most memory that the judge may use, because a short answer may need a lot of memory to read."""


def redacted_sheet(course: Course, sheet: Sheet, student: str) -> dict[str, Any]:
    """A student's sheet without answers, and the seed of this run."""
    seed = secrets.randbits(64)
    return {"seed": seed, "sheet": redact(sheet, _problems(course, sheet, student, seed))}


def verdicts(
    course: Course, sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any], *, site: str = ""
) -> dict[str, Any]:
    """Judge the answers, by problem number as text: "1" is the first. A problem without an answer is blank."""
    problems = _problems(course, sheet, student, seed)
    return {
        str(k): _verdict(template, problem, answers.get(str(k)), page_address(template.lecture, site))
        for k, (template, problem) in enumerate(zip(sheet.problems, problems, strict=True), start=1)
    }


def _problems(course: Course, sheet: Sheet, student: str, seed: int) -> list[Problem]:
    return [problem.with_inputs(seed) for problem in _variants(course, sheet.name, student)]


@lru_cache(maxsize=16)
def _variants(course: Course, sheet: str, student: str) -> list[Problem]:
    """A student's variants, cached because they are needed for the redacted sheet and soon again for the verdicts."""
    return [template.variant(student) for template in course.find_sheet(sheet).problems]


def _verdict(template: Template, problem: Problem, data: Any, address: str) -> dict[str, Any]:
    verdict = Verdict(template, _judge_answer(problem, data), address=address)
    card, seen = verdict.card, observation(template, problem, [verdict.judgement])
    return {
        "state": verdict.judgement.state,
        "fraction": verdict.judgement.fraction,
        "mistakes": verdict.judgement.mistakes,
        "possible": seen.possible,
        "explanations": seen.explanations,
        "text": card.text(),
        "html": card.html(),
        "address": card.body[-1].address if isinstance(card.body[-1], Link) else "",
        "right": to_data(problem.answer.value),
    }


def _judge_answer(problem: Problem, data: Any) -> Judgement:
    """Judge one answer within its processor time. An answer that takes longer, or raises an error, is unreadable."""
    answer = problem.answer
    try:
        value = from_data(data)  # before the clock starts, because the first formula imports SymPy
        if isinstance(value, Opaque):
            return _unreadable(problem, f"Expected {answer.expected}; got {value}.")
        signal.setitimer(signal.ITIMER_PROF, ANSWER_SECONDS)
        return judge(problem, value)
    except Malformed as error:
        return _unreadable(problem, f"The data of this answer has no known form. {error}")
    except Exception as error:  # whatever error an answer causes, the other problems must still be judged
        return _unreadable(
            problem, f"Expected {answer.expected}; the answer could not be judged: {type(error).__name__}."
        )
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def _unreadable(problem: Problem, message: str) -> Judgement:
    return Judgement("unreadable", findings=[Finding(problem.answer.parts, message)])


def _raise_timeout(*_: Any) -> None:
    raise TimeoutError(f"more than {ANSWER_SECONDS:g} s of processor time")


def _respond(course: Course, message: Mapping[str, Any]) -> dict[str, Any]:
    try:
        sheet = course.find_sheet(message["sheet"])
        if message["request"] == "problems":
            return {"problems": [[template.number, template.title, template.points] for template in sheet.problems]}
        if message["request"] == "redacted sheet":
            return redacted_sheet(course, sheet, message["student"])
        arguments = (message[name] for name in ("student", "seed", "answers"))
        return {"verdicts": verdicts(course, sheet, *arguments, site=message["site"])}
    except Exception as error:  # whatever error an answer causes, the next message is about another student
        return {"error": f"{type(error).__name__}: {error}"[:500]}


def main(course_reference: str) -> None:
    """Answer requests until stdin ends."""
    course = find_course(course_reference)
    set_resource_limits({"AS": MEMORY_BYTES})
    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints must not mix with the messages
    signal.signal(signal.SIGPROF, _raise_timeout)
    while (message := receive_message(inbox)) is not None:
        outbox.write(encode_message({**_respond(course, message), "id": message["id"]}))
        outbox.flush()


if __name__ == "__main__":
    main(sys.argv[1])
