"""The judge: it draws the variants, reads answers as data, and gives the points. It never runs what a student wrote.

    python -m misstep.grading.judging.judge_process COURSE

COURSE is the package of an installed course, or the folder of another one.

Three messages on stdin, answered on stdout. "problems" asks for their numbers, titles and points. "paper" asks for a
student's sheet without answers, and comes with a seed, from which the inputs of function answers are drawn anew in every
run. "verdicts" hands in answers, with the seed of the paper.

It runs in the folder of the sheet: there the file lies of a robot that brings a sheet of its own.
"""

import os
import secrets
import signal
import sys
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from misstep.catalog import Course, find_course
from misstep.grading.sandbox.confine import set_limits
from misstep.grading.sandbox.redacted_sheet import written
from misstep.grading.sandbox.rpc import pack, receive
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem
from misstep.sheet import Sheet
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict

SECONDS = 4.0
"""Of processor time, for one answer: a busy machine changes no verdict. The slowest that people give, a table that no mistake
explains, takes a tenth of that."""

MEMORY = 2 << 30
"""The most memory that the judge may take: an answer may ask for more than it says."""


def paper(course: Course, sheet: Sheet, student: str) -> dict[str, Any]:
    """A student's sheet without answers, and the seed of this run."""
    seed = secrets.randbits(64)
    return {"seed": seed, "paper": written(sheet, _problems(course, sheet, student, seed))}


def verdicts(course: Course, sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any]) -> dict[str, Any]:
    """Judge the answers, by problem number as text: "1" is the first. A problem without one is blank."""
    problems = _problems(course, sheet, student, seed)
    return {str(k): _verdict(sheet, k, problem, answers.get(str(k))) for k, problem in enumerate(problems, start=1)}


def _problems(course: Course, sheet: Sheet, student: str, seed: int) -> list[Problem]:
    return [problem.with_inputs(seed) for problem in _drawn(course, sheet.name, student)]


@lru_cache(maxsize=16)
def _drawn(course: Course, sheet: str, student: str) -> list[Problem]:
    """A student's variants: drawn for the paper, and soon asked for again."""
    return [template.variant(student) for template in course.find_sheet(sheet).problems]


def _verdict(sheet: Sheet, k: int, problem: Problem, data: Any) -> dict[str, Any]:
    verdict = Verdict(sheet.problems[k - 1], _judged(problem, data))
    return {
        "state": verdict.judgement.state,
        "fraction": verdict.judgement.fraction,
        "mistakes": verdict.judgement.mistakes,
        "text": verdict.card.text(),
        "html": verdict.card.html(),
        "right": to_data(problem.answer.value),
    }


def _judged(problem: Problem, data: Any) -> Judgement:
    """Judge one answer, in the time there is for one: whoever asks for more of it has not answered."""
    answer = problem.answer
    try:
        value = from_data(data)  # before the clock runs: the first formula of all loads SymPy
        if isinstance(value, Opaque):
            return _unreadable(problem, f"Expected {answer.expected}; got {value}.")
        signal.setitimer(signal.ITIMER_PROF, SECONDS)
        return judge(problem, value)
    except Malformed as fault:
        return _unreadable(problem, f"The answer came in no known form. {fault}")
    except Exception as error:  # whatever an answer makes of us, the next one is another problem's
        return _unreadable(
            problem, f"Expected {answer.expected}; the answer could not be judged: {type(error).__name__}."
        )
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def _unreadable(problem: Problem, message: str) -> Judgement:
    return Judgement("unreadable", findings=[Finding(problem.answer.parts, message)])


def _too_long(*_: Any) -> None:
    raise TimeoutError(f"more than {SECONDS:g} s of processor time")


def _answer(course: Course, message: Mapping[str, Any]) -> dict[str, Any]:
    try:
        sheet = course.find_sheet(message["sheet"])
        if message["ask"] == "problems":
            return {"problems": [[template.number, template.title, template.points] for template in sheet.problems]}
        if message["ask"] == "paper":
            return paper(course, sheet, message["student"])
        return {"verdicts": verdicts(course, sheet, message["student"], message["seed"], message["answers"])}
    except Exception as error:  # whatever an answer makes of us, the next message is another student's
        return {"error": f"{type(error).__name__}: {error}"[:500]}


def main(reference: str) -> None:
    """Answer messages until there are no more."""
    course = find_course(reference)
    set_limits({"AS": MEMORY})
    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no message
    signal.signal(signal.SIGPROF, _too_long)
    while (message := receive(inbox)) is not None:
        outbox.write(pack({**_answer(course, message), "id": message["id"]}))
        outbox.flush()


if __name__ == "__main__":
    main(sys.argv[1])
