"""The judge: it draws the variants, reads answers as data, and computes the points. It never runs student code.

    python -m misstep.grading.judging.judge_process DESCRIPTOR

This is the server of the processes that judge, with the course and the sheet; each step is done in one of them. "problems" returns the
results of a student of whom no answer was received. "redacted sheet" returns a student's sheet without answers, and a seed from which the
inputs of function answers are drawn anew in every run. "verdict" judges one answer. The kernel ends a process if one answer takes longer
than it may, also inside a single call of C code; the answers after it are judged in the next process. So a slow answer costs its own
problem, and no other.

It runs in the folder of the sheet, because a robot's own sheet is described by a file there.
"""

import gc
import json
import os
import secrets
import socket
from contextlib import suppress
from functools import lru_cache, partial
from importlib import import_module
from typing import Any

from misstep.catalog import Course, find_course
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading.fork_server import greet, run_server
from misstep.grading.judging.redraw import Draw, redraw
from misstep.grading.judging.result import ProblemResult
from misstep.grading.redacted_sheet import redact
from misstep.grading.steps import Steps, serve_steps
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import SAMPLE_ID
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict, observation

UNSOLVED = {"partly", "wrong", "unreadable"}
"""The states of an answer that must be mended, for which feedback shows the figure of the problem."""

NO_ANSWER = "No answer was received for this problem."

GC_THRESHOLD = 100_000
"""How many objects are made before garbage is collected: mutants make many, and with Python's 700 it took a sixth of the time."""


def steps_of(course: Course, sheet: str) -> Steps:
    """What a process of the judge does for a sheet."""
    steps: Steps = {"problems": problems, "redacted sheet": redacted_sheet, "verdict": verdict}
    return {name: partial(step, course, sheet) for name, step in steps.items()}


def problems(course: Course, sheet: str) -> list[ProblemResult]:
    """The results of a student of whom no answer was received."""
    return [
        ProblemResult(template.number, template.title, 0.0, template.points, "missing", NO_ANSWER)
        for template in course.find_sheet(sheet).problems
    ]


def redacted_sheet(course: Course, sheet: str, student: str, draw: Draw | None = None) -> tuple[int, str]:
    """The seed of this run, and a student's sheet without answers."""
    seed = secrets.randbits(64)
    drawn = [problem.with_inputs(seed) for problem in _problems(course, sheet, student, draw)]
    return seed, redact(course.find_sheet(sheet), drawn)


def verdict(
    course: Course, sheet: str, student: str, k: int, data: Any, *, seed: int, site: str = "", draw: Draw | None = None
) -> ProblemResult:
    """Judge the answer to problem k, from 1, of a run with this seed; without an answer, the problem is blank.

    site  the address of the course's site
    """
    template = course.find_sheet(sheet).problems[k - 1]
    problem = _problems(course, sheet, student, draw)[k - 1].with_inputs(seed)
    return verdict_on(template, problem, data, page_address(template.lecture, site))


def verdict_on(template: Template, problem: Problem, data: Any, address: str) -> ProblemResult:
    """Judge an answer to a variant of a problem.

    address  of the section that the verdict names
    """
    made = Verdict(template, _judge_answer(problem, data), address=address)
    card, seen = made.card, observation(template, problem, [made.judgement])
    return ProblemResult(
        template.number,
        template.title,
        template.points * float(made.judgement.fraction),
        template.points,
        made.judgement.state,
        card.text(),
        statement=problem.statement,
        mistakes=[*made.judgement.mistakes],
        answer=data,
        right=to_data(problem.answer.value),
        possible=[*seen.possible],
        explanations=seen.explanations,
        address=card.body[-1].address if isinstance(card.body[-1], Link) else "",
        figure=figure_html(problem) if made.judgement.state in UNSOLVED else "",
    )


@lru_cache(maxsize=2)  # the student's own numbers, and with a key other ones, are needed for each answer
def _problems(course: Course, sheet: str, student: str, draw: Draw | None) -> list[Problem]:
    """A student's variants; with a draw, some of them with other numbers."""
    templates = course.find_sheet(sheet).problems
    if draw is None:
        return [template.variant(student) for template in templates]
    return [
        (k in draw.problems and redraw(template, own, student, draw)) or own
        for k, (template, own) in enumerate(
            zip(templates, _problems(course, sheet, student, None), strict=True), start=1
        )
    ]


def figure_html(problem: Problem) -> str:
    """The figure of a problem as HTML; "" if it has none, or if it cannot be drawn."""
    try:
        figure = problem.figure() if problem.figure else None
        bundle = figure._repr_mimebundle_() if figure is not None and hasattr(figure, "_repr_mimebundle_") else {}
    except Exception:  # a figure is not worth a grade
        return ""
    return str(bundle.get("text/html", ""))


def _judge_answer(problem: Problem, data: Any) -> Judgement:
    """Judge one answer. An answer that raises an error is unreadable."""
    answer = problem.answer
    try:
        value = from_data(data)
        if isinstance(value, Opaque):
            return _unreadable(problem, f"Expected {answer.expected}; got {value}.")
        return judge(problem, value)
    except Malformed as error:
        return _unreadable(problem, f"The data of this answer has no known form. {error}")
    except Exception as error:  # whatever error an answer causes, the other problems must still be judged
        return _unreadable(
            problem, f"Expected {answer.expected}; the answer could not be judged: {type(error).__name__}."
        )


def _unreadable(problem: Problem, message: str) -> Judgement:
    return Judgement("unreadable", findings=[Finding(problem.answer.parts, message)])


def _warm_up(course: Course, sheet: str) -> None:
    """Do before the forks what every process needs: draw the numbers and a first figure, and import SymPy for answers in letters."""
    with suppress(Exception):  # the step "problems" has the error
        drawn = _problems(course, sheet, SAMPLE_ID, None)
        text = json.dumps([to_data(problem.answer.value) for problem in drawn])
        if '"symbolic"' in text or '"matrix"' in text:
            import_module("sympy")
        figure_html(next(problem for problem in drawn if problem.figure))
    gc.collect()
    gc.freeze()  # a collection in a fork would touch every object, and so copy every page of memory


def main(parent: socket.socket, setup: dict[str, str]) -> None:
    """Import the course, and fork until the socket closes."""
    gc.set_threshold(GC_THRESHOLD)
    os.chdir(setup["folder"])
    try:
        course = find_course(setup["course"])
    except (ImportError, ValueError) as error:
        greet(parent, unavailable=str(error))
        return
    _warm_up(course, setup["sheet"])
    greet(parent)
    serve_steps(parent, steps_of(course, setup["sheet"]))


if __name__ == "__main__":
    run_server(main)
