"""Grading one submission: bytes in, a Result out, whatever the bytes are.

The submission runs in a sandbox and gives answers as data. The judge, in a process that never runs what a student wrote,
reads them and gives the points. This module carries messages between the two, and says what happened.
"""

import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Any

from misstep.catalog import find_course
from misstep.grading.collect.submission import Broken, Master, Plan, plan
from misstep.grading.judging.parse_output import Heard, hear
from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits, Missing
from misstep.grading.sandbox.rpc import Gone, Peer
from misstep.grading.sandbox.runner import Ran, Runner

JUDGING = 60.0
"""Seconds that the judge may take for a sheet, and then for each problem by itself."""

MOST_RUNS = 4
"""So often the cells of one submission run: each time without one more that ended the process."""

ENDED_ITSELF = "the process ended itself"


class Grader:
    """Grades submissions of one sheet. Any number of threads may use one grader; close it when all is done.

    Raises misstep.grading.sandbox.limits.Missing when the sandbox lacks a layer here, unless is_safe is False; ValueError for a sheet
    that the judge cannot find.
    """

    def __init__(self, sheet: Master, limits: Limits | None = None, is_safe: bool = True) -> None:
        self.sheet, self.is_safe = sheet, is_safe
        self._limits = limits or Limits()
        self._lock, self._judging = Lock(), Lock()
        self._judge = self._new_judge()  # it imports while the server does
        try:
            self._setup = setup_for(find_course(sheet.course))
            self._runner = Runner(self._setup, is_safe)
        except Missing:
            self._judge.end()
            raise
        told = self._ask({"ask": "problems"})
        if "error" in told:
            self.close()
            raise ValueError(f"The judge cannot open sheet {sheet.name}. {told['error']}")
        self._templates: list[tuple[str, str, int]] = [(n, title, points) for n, title, points in told["problems"]]

    def __enter__(self) -> "Grader":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """End the server and the judge."""
        self._runner.close()
        self._judge.end()

    def grade(self, student: str, content: bytes | None) -> Result:
        """Grade what a student handed in; None where nothing was. It never raises for what is in the submission."""
        began = time.monotonic()
        digest = sha256(content).hexdigest() if content is not None else ""
        try:
            if content is None:
                raise Broken("Nothing was handed in.")
            planned = plan(self.sheet, content)
            seed, paper = self._paper(student)
            ran, heard = self._heard(paper, planned)
        except Broken as fault:
            problems = self._problems({}, {}, {})
            return self._result(student, "broken", str(fault), problems, digest=digest, began=began)
        odd = {k: [*planned.odd.get(k, ()), *heard.faults(k)] for k in self.sheet.checks}
        verdicts = self._verdicts(student, seed, heard.answers)
        status, reason = _ending(planned, ran, heard)
        return self._result(
            student,
            status,
            reason,
            self._problems(verdicts, heard.answers, odd),
            notes=heard.remarks(student),
            typed_id=heard.typed_id,
            digest=digest,
            began=began,
            cells=heard.cells,
        )

    def _result(
        self, student: str, status: str, reason: str, problems: Sequence[ProblemResult], *, began: float, **more: Any
    ) -> Result:
        points, most = sum(problem.points for problem in problems), sum(problem.max for problem in problems)
        seconds = time.monotonic() - began
        return Result(
            student,
            self.sheet.name,
            points,
            most,
            status,
            reason,
            problems,
            is_safe=self.is_safe,
            seconds=seconds,
            **more,
        )

    def _problems(
        self, verdicts: Mapping[str, Any], answers: Mapping[str, Any], odd: Mapping[int, Sequence[str]]
    ) -> list[ProblemResult]:
        found = []
        for k, (number, title, most) in enumerate(self._templates, start=1):
            verdict = verdicts.get(str(k)) or UNHEARD
            state = verdict["state"] if str(k) in answers else "missing"
            points = most * float(verdict["fraction"])
            text, html, mistakes = verdict["text"], verdict["html"], verdict["mistakes"]
            of_problem = number, title, points, most, state
            data = answers.get(str(k)), verdict.get("right")
            found.append(ProblemResult(*of_problem, text, html, mistakes, odd.get(k, ()), *data))
        return found

    def _new_judge(self) -> Peer:
        # On another machine the folder may be missing; then there is no robot's own sheet, and the judge says so.
        return Peer(
            "misstep.grading.judging.judge_process",
            self.sheet.folder if self.sheet.folder.is_dir() else Path(),
            self.sheet.course,
        )

    def _heard(self, paper: str, planned: Plan) -> tuple[Ran, Heard]:
        """Run the cells, and hear what they gave. If one ends the process, the others run again without it.

        A crash in one problem costs that problem, and no later one. All runs together have the time of one.
        """
        sources = [step.source for step in planned.steps]
        told: list[tuple[Ran, Heard]] = []
        end = time.monotonic() + self._limits.seconds
        while len(told) < MOST_RUNS and (left := end - time.monotonic()) > 0:
            ran = self._run(paper, sources, replace(self._limits, seconds=left))
            heard = hear(self.sheet.name, planned, ran.said)
            told.append((ran, heard))
            if len(heard.cells) == len(sources) or not ran.by_itself:
                break
            why = f"This cell was left out, and the others ran without it: {ran.ended or ENDED_ITSELF}."
            sources[len(heard.cells)] = f"raise RuntimeError({why!r})"
        return max(told, key=lambda each: len(each[1].cells))

    def _run(self, paper: str, sources: Sequence[str], limits: Limits) -> Ran:
        """Run the cells once. A server that has ended is started anew, once."""
        for _ in range(2):
            runner = self._runner
            try:
                return runner.run(paper, sources, limits)
            except Gone:
                with self._lock:
                    if self._runner is runner:
                        runner.close()
                        self._runner = Runner(self._setup, self.is_safe)
        raise Broken("The run took the server of forks down twice. Please tell whoever grades.")

    def _paper(self, student: str) -> tuple[int, str]:
        """The student's paper and its seed."""
        told = self._ask({"ask": "paper", "student": student})
        if "error" in told:
            raise Broken(f"The sheet could not be drawn for {student!r}: {told['error']}")
        return told["seed"], told["paper"]

    def _verdicts(self, student: str, seed: int, answers: Mapping[str, Any]) -> dict[str, Any]:
        """Judge the answers; if that fails for all together, one by one, so that one answer costs one problem."""
        message = {"ask": "verdicts", "student": student, "seed": seed}
        told = self._ask({**message, "answers": answers})
        if "verdicts" in told:
            return dict(told["verdicts"])
        found = {}
        for k, answer in answers.items():
            alone = self._ask({**message, "answers": {k: answer}})
            found[k] = alone.get("verdicts", {}).get(k) or UNJUDGED
        return found

    def _ask(self, message: Mapping[str, Any]) -> dict[str, Any]:
        """Ask the judge; one that has ended is started anew, and says so by an error."""
        with self._judging:  # one at a time, so that nobody's seconds run while another is judged
            try:
                return self._judge.ask({**message, "sheet": self.sheet.name}, JUDGING)
            except Gone as gone:
                self._judge.end()
                self._judge = self._new_judge()
                return {"error": str(gone)}


def _zero(state: str, text: str) -> dict[str, Any]:
    return {"state": state, "fraction": 0.0, "mistakes": [], "text": text, "html": f"<p>{text}</p>"}


UNHEARD = _zero("missing", "No answer came from this problem.")
UNJUDGED = _zero("unreadable", "This answer could not be judged in the time there is for it.")


def _ending(planned: Plan, ran: Ran, heard: Heard) -> tuple[str, str]:
    """Whether the run came to its end, and if not, why and where."""
    count = len(heard.cells)
    if count == len(planned.steps):
        return "graded", ""
    why = ran.ended or ENDED_ITSELF
    return (
        "stopped",
        f"The run stopped in code cell {count + 1} of {len(planned.steps)}: {why}. What was answered before counts.",
    )
