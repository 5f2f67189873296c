"""The judge: it draws the variants, reads what students wrote, and computes the points. It never runs student code.

    python -m misstep.grading.judging.judge_process DESCRIPTOR

This is the server of the processes that judge one sheet; each step is done in one of them. "problems" returns the results
of a student of whom no answer was received. "redacted sheet" returns a student's sheet without answers, and a seed from which
the inputs of function answers are drawn anew in every run. "verdict" judges one answer. The other steps read what students
wrote: a notebook is planned, the output of a run is parsed, a page is written, and the answers of a class are compared and
written into tables.

The kernel ends a process if a step takes longer than it may, also inside a single call of C code; the next step is done in
the next process. So a slow answer costs its own problem, and no other.
"""

import gc
import json
import secrets
import socket
from contextlib import chdir, suppress
from functools import lru_cache
from importlib import import_module
from pkgutil import resolve_name
from typing import Any

from misstep.catalog import find_course
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading.fork_server import greet, run_server
from misstep.grading.judging.redraw import Draw, redraw
from misstep.grading.judging.result import ProblemResult
from misstep.grading.redacted_sheet import redact
from misstep.grading.steps import serve_steps
from misstep.judge import Finding, Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import SAMPLE_ID, Sheet
from misstep.storage.deserialize import Malformed, Opaque, from_data
from misstep.storage.serialize import to_data
from misstep.verdict import Verdict, observation

READING = {
    "plan": "misstep.grading.collect.run_plan:plan_run",
    "parse": "misstep.grading.judging.parse_output:parse_output",
    "page": "misstep.grading.publish.pages_and_tables:write_page",
    "tables": "misstep.grading.publish.pages_and_tables:write_tables",
}
"""By step, the module and the function that does it."""

GRADEBOOK = {"autograded notebook": "misstep.grading.nbgrader.autograded:write_notebook"}
"""The step that writes a notebook for formgrader. It needs nbgrader, which takes a second to import."""

UNSOLVED = {"partly", "wrong", "unreadable"}
"""The states of an answer that must be mended, for which feedback shows the figure of the problem."""

NO_ANSWER = "No answer was received for this problem."

GC_THRESHOLD = 100_000
"""How many objects are made before garbage is collected: mutants make many, and with Python's 700 it took a sixth of the time."""


class Judge:
    """What a process knows that judges one sheet. Its methods are steps."""

    def __init__(self, sheet: Sheet) -> None:
        self._sheet = sheet
        # The student's own numbers, and with a key other ones, are needed for each answer.
        self.variants = lru_cache(maxsize=2)(self._draw_variants)
        self.steps: dict[str, Any] = {
            "problems": self.problems,
            "redacted sheet": self.redacted_sheet,
            "verdict": self.verdict,
        }

    def problems(self) -> list[ProblemResult]:
        """The results of a student of whom no answer was received."""
        return [
            ProblemResult(template.number, template.title, 0.0, template.points, "missing", NO_ANSWER)
            for template in self._sheet.problems
        ]

    def redacted_sheet(self, student: str, draw: Draw | None = None) -> tuple[int, str]:
        """The seed of this run, and a student's sheet without answers."""
        seed = secrets.randbits(64)
        return seed, redact(self._sheet, [problem.with_inputs(seed) for problem in self.variants(student, draw)])

    def verdict(
        self, student: str, k: int, data: Any, *, seed: int, site: str = "", draw: Draw | None = None
    ) -> ProblemResult:
        """Judge the answer to problem k, from 1, of a run with this seed; without an answer, the problem is blank.

        site  the address of the course's site
        """
        template = self._sheet.problems[k - 1]
        problem = self.variants(student, draw)[k - 1].with_inputs(seed)
        return verdict_on(template, problem, data, page_address(template.lecture, site))

    def _draw_variants(self, student: str, draw: Draw | None) -> list[Problem]:
        """A student's variants; with a draw, some of them with other numbers."""
        if draw is None:
            return [template.variant(student) for template in self._sheet.problems]
        return [
            (k in draw.problems and redraw(template, own, student, draw)) or own
            for k, (template, own) in enumerate(
                zip(self._sheet.problems, self.variants(student, None), strict=True), start=1
            )
        ]


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


def main(parent: socket.socket, setup: dict[str, Any]) -> None:
    """Open the sheet, import what reads, and fork until the socket closes."""
    gc.set_threshold(GC_THRESHOLD)
    try:
        with chdir(setup["folder"]):  # a robot's own sheet is described by a file there
            judge = Judge(find_course(setup["course"]).find_sheet(setup["sheet"]))
        places = READING | (GRADEBOOK if setup["has_gradebook"] else {})
        reading = {step: resolve_name(place) for step, place in places.items()}
    except Exception as error:  # whatever is wrong with the course, it is said
        greet(parent, unavailable=f"{type(error).__name__}: {error}")
        return
    _warm_up(judge)
    greet(parent)
    serve_steps(parent, judge.steps | reading)


def _warm_up(judge: Judge) -> None:
    """Do before the forks what every process needs: draw the numbers and a first figure, and import SymPy for answers in letters."""
    with suppress(Exception):  # the first student whose numbers are drawn has the error
        drawn = judge.variants(SAMPLE_ID, None)
        text = json.dumps([to_data(problem.answer.value) for problem in drawn])
        if '"symbolic"' in text or '"matrix"' in text:
            import_module("sympy")
        figure_html(next(problem for problem in drawn if problem.figure))
    gc.collect()
    gc.freeze()  # a collection in a fork would touch every object, and so copy every page of memory


if __name__ == "__main__":
    run_server(main)
