"""The judge: it draws the variants, reads answers as data, and gives the points. It never runs what a student wrote.

    python -m kinlib.grading.judge

Two messages on stdin, answered on stdout. "paper" asks for a student's sheet without answers, and comes with a seed, from
which the inputs of function answers are drawn anew in every run. "verdicts" hands in answers, with the seed of the paper.
"""

import os
import resource
import secrets
import sys
from collections.abc import Mapping
from typing import Any

from kinlib.grading.paper import written
from kinlib.grading.wire import pack, receive
from kinlib.practice.answer_data import Malformed, Opaque, from_data
from kinlib.practice.judge import Finding, Judgement, judge
from kinlib.practice.problem import Problem
from kinlib.practice.sheet import Sheet, find_sheet
from kinlib.practice.verdict import Verdict

MEMORY = 2 << 30
"""The most memory that the judge may take: an answer may ask for more than it says."""


def paper(sheet: Sheet, student: str) -> dict[str, Any]:
    """A student's sheet without answers, and the seed of this run."""
    seed = secrets.randbits(64)
    return {"seed": seed, "paper": written(sheet, _problems(sheet, student, seed))}


def verdicts(sheet: Sheet, student: str, seed: int, answers: Mapping[str, Any]) -> dict[str, Any]:
    """Judge the answers, by problem number as text: "1" is the first. A problem without one is blank."""
    problems = _problems(sheet, student, seed)
    return {str(k): _verdict(sheet, k, problem, answers.get(str(k))) for k, problem in enumerate(problems, start=1)}


def _problems(sheet: Sheet, student: str, seed: int) -> list[Problem]:
    problems = [template.variant(student) for template in sheet.problems]
    return [problem.again(seed) for problem in problems]


def _verdict(sheet: Sheet, k: int, problem: Problem, data: Any) -> dict[str, Any]:
    verdict = Verdict(sheet.problems[k - 1], _judged(problem, data))
    return {
        "state": verdict.judgement.state,
        "fraction": verdict.judgement.fraction,
        "mistakes": verdict.judgement.mistakes,
        "text": verdict.card.text(),
        "html": verdict.card.html(),
    }


def _judged(problem: Problem, data: Any) -> Judgement:
    answer = problem.answer
    try:
        value = from_data(data)
    except (Malformed, RecursionError) as fault:
        return Judgement("unreadable", findings=[Finding(answer.parts, f"The answer came in no known form. {fault}")])
    if isinstance(value, Opaque):
        return Judgement("unreadable", findings=[Finding(answer.parts, f"Expected {answer.expected}; got {value}.")])
    return judge(problem, value)


def _answer(message: Mapping[str, Any]) -> dict[str, Any]:
    try:
        sheet = find_sheet(message["sheet"])
        if message["ask"] == "paper":
            return paper(sheet, message["student"])
        return {"verdicts": verdicts(sheet, message["student"], message["seed"], message["answers"])}
    except Exception as error:  # whatever an answer makes of us, the next message is another student's
        return {"error": f"{type(error).__name__}: {error}"[:500]}


def main() -> None:
    """Answer messages until there are no more."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    inbox, outbox = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    while (message := receive(inbox)) is not None:
        outbox.write(pack({**_answer(message), "id": message["id"]}))
        outbox.flush()


if __name__ == "__main__":
    main()
