"""Grade one submission: bytes in, a Result out, whatever the bytes are.

The submission runs in the sandbox and emits its answers as data. The judge, in a process that never runs student code, reads
them and computes the points. This module connects the two, and records what happened. It never looks into what a student wrote:
a reader does, within limits.
"""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Any, cast

from misstep.catalog import find_course
from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.collect.run_plan import ReleasedSheet, RunPlan, plan_from_data
from misstep.grading.judging.result import ProblemResult, RanCell, Result
from misstep.grading.reading import Reader, StepFailed
from misstep.grading.rpc import ProcessEnded, Worker
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.runner import Runner, RunOutcome, slow_imports

JUDGE_SECONDS = 600.0
"""How long the judge may take for a sheet. It limits the processor time of each answer itself; this is for a fault in it."""

MAX_RUNS = 4
"""How often the cells of one submission are run, each time without one more cell that ended the process."""

REDRAWS = 2
"""With a key: how many draws of other numbers are tried, of which the best one counts."""

PROBES = ("probe 1", "probe 2")
"""With a key: the students for whom the sheet's own solution is tried."""

TYPED_NOTE = (
    "With your own numbers this answer has {:g} points. When your notebook ran with other numbers, your cells did not give "
    "the right answer for them, so problem {} was not computed from sheet.given({}). This sheet is graded with a key: only "
    "what is right for the other numbers too has points."
)

ENDED_ITSELF = "the process ended itself"


class UnreadInTime(UnusableNotebook):
    """A limit was reached before there was anything to judge."""


@dataclass(frozen=True)
class Run:
    """One run of a submission: how it ended, the cells that ran, and what was read of their output.

    check_errors  by problem, why its check cell gave no answer
    limits        the limits that were reached, in words
    """

    outcome: RunOutcome
    cells: Sequence[RanCell]
    answers: Mapping[str, Any]
    typed_id: str
    remarks: Sequence[str]
    check_errors: Mapping[int, Sequence[str]]
    limits: Sequence[str]


class Grader:
    """Grades submissions of one sheet. Any number of threads may use one grader. Close it after use.

    reader  reads what students wrote; by default the grader has one of its own

    Raises SandboxUnavailable if this machine cannot provide a layer of the sandbox, unless is_safe is False; ValueError
    for a sheet that the judge cannot open.
    """

    def __init__(
        self, sheet: ReleasedSheet, limits: Limits | None = None, is_safe: bool = True, reader: Reader | None = None
    ) -> None:
        self.sheet, self.is_safe = sheet, is_safe
        self._limits = limits or Limits()
        self._runner_lock, self._judge_lock, self._is_closed = Lock(), Lock(), False
        self._runner = cast("Runner | None", None)
        self._judge = self._start_judge()  # first, because it imports while the server does
        self._reader, self._has_own_reader = reader or Reader(), reader is None
        try:
            self._judge.send(
                {"request": "problems", "sheet": sheet.name}
            )  # it imports the sheet while the server starts
            setup = setup_for(find_course(sheet.course), sheet.folder)
            self._setup = replace(setup, imports=sorted(slow_imports(sheet.opening)))
            self._runner = Runner(self._setup, is_safe)
            answer = self._ask_judge({"request": "problems"})
        except BaseException:
            self.close()
            raise
        if "error" in answer:
            self.close()
            raise ValueError(f"The judge cannot open sheet {sheet.name}. {answer['error']}")
        self._templates: list[tuple[str, str, int]] = [(n, title, points) for n, title, points in answer["problems"]]
        self._covered: Sequence[int] = ()
        if sheet.key:
            self._covered = self._covered_problems()

    def __enter__(self) -> "Grader":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """End the server, the judge, and the reader if it is its own. Submissions that are graded meanwhile fail at once."""
        self._is_closed = True
        if self._runner:
            self._runner.close()
        self._judge.stop()
        if self._has_own_reader:
            self._reader.close()

    def grade(self, student: str, content: bytes | None, seed_id: str | None = None) -> Result:
        """Grade the notebook of a student; content is None if nothing was submitted.

        seed_id  the id from which the numbers are drawn, by default the student's name; "" for the one that is typed in the notebook

        No error in the submission makes it raise: each one becomes the reason of a result.
        """
        start = time.monotonic()
        digest = sha256(content).hexdigest() if content is not None else ""
        try:
            if content is None:
                raise UnusableNotebook("Nothing was handed in.")
            plan = self._plan(content)
            seed_id = student if seed_id is None else seed_id or plan.typed_id or student
            seed, redacted = self._redacted_sheet(seed_id)
            run = self._run_until_complete(redacted, plan, seed_id)
        except UnusableNotebook as error:
            problems = self._problem_results({}, {}, {})
            limits = [str(error)] if isinstance(error, UnreadInTime) else []
            return self._result(student, "broken", str(error), problems, digest=digest, start=start, limits=limits)
        notes = {k: [*plan.remarks.get(k, ()), *run.check_errors.get(k, ())] for k in self.sheet.checks}
        verdicts, judge_limits = self._verdicts(seed_id, seed, run.answers)
        limits = [*run.limits, *judge_limits]
        if any(verdicts.get(str(k), NO_ANSWER)["fraction"] for k in self._covered):
            redrawn, more_limits = self._redrawn_fractions(seed_id, plan, self._covered, run.answers)
            verdicts |= {k: {**verdicts[k], "redrawn": redrawn[k]} for k in redrawn if k in verdicts}
            limits += more_limits
        status, reason = _status(plan, run)
        return self._result(
            student,
            status,
            reason,
            self._problem_results(verdicts, run.answers, notes),
            notes=run.remarks,
            typed_id=run.typed_id,
            digest=digest,
            start=start,
            cells=[cell for cell in run.cells if cell.index is not None or cell.problem],
            limits=list(dict.fromkeys(limits)),
        )

    def _plan(self, content: bytes) -> RunPlan:
        sheet = {"name": self.sheet.name, "checks": dict(self.sheet.checks), "opening": self.sheet.opening}
        return plan_from_data(self._read("plan", "The notebook", sheet=sheet, content=content))

    def _read(self, step: str, what: str, **arguments: Any) -> Any:
        """Let the reader do a step. Raises UnreadInTime if it reaches a limit."""
        try:
            return self._reader.do(step, seconds=self._limits.reading_seconds, **arguments)
        except StepFailed as error:
            raise UnreadInTime(f"{what} could not be read: {error}.") from error

    def _result(
        self, student: str, status: str, reason: str, problems: Sequence[ProblemResult], *, start: float, **more: Any
    ) -> Result:
        return Result(
            student,
            self.sheet.name,
            sum(problem.points for problem in problems),
            sum(problem.max for problem in problems),
            status,
            reason,
            problems,
            is_safe=self.is_safe,
            seconds=time.monotonic() - start,
            **more,
        )

    def _problem_results(
        self, verdicts: Mapping[str, Any], answers: Mapping[str, Any], notes: Mapping[int, Sequence[str]]
    ) -> list[ProblemResult]:
        results = []
        for k, (number, title, max_points) in enumerate(self._templates, start=1):
            verdict = verdicts.get(str(k)) or NO_ANSWER
            counting = min(verdict["fraction"], verdict.get("redrawn", 1.0))
            own_points = max_points * float(verdict["fraction"])
            typed = [TYPED_NOTE.format(own_points, number, k)] if counting < verdict["fraction"] else []
            results.append(
                ProblemResult(
                    number,
                    title,
                    max_points * float(counting),
                    max_points,
                    verdict["state"] if str(k) in answers else "missing",
                    verdict["text"],
                    verdict.get("statement", ""),
                    verdict["mistakes"],
                    [*notes.get(k, ()), *typed],
                    answers.get(str(k)),
                    verdict.get("right"),
                    verdict["possible"],
                    verdict["explanations"],
                    verdict["address"],
                    verdict.get("figure", ""),
                    own_points if k in self._covered else None,
                )
            )
        return results

    def _start_judge(self) -> Worker:
        # On another machine the folder may not exist; then a robot's own sheet is not found, and the judge says so.
        return Worker(
            "misstep.grading.judging.judge_process",
            self.sheet.folder if self.sheet.folder.is_dir() else Path(),
            self.sheet.course,
        )

    def _run_until_complete(self, redacted: str, plan: RunPlan, student: str) -> "Run":
        """Run the cells and read their output. If a cell ends the process, run the others again without it.

        So a crash in one problem costs only that problem. All runs together have the time of one. The longest run counts.
        """
        cells, left = list(plan.cells), self._limits
        runs: list[Run] = []
        deadline = time.monotonic() + left.wall_seconds
        while len(runs) < MAX_RUNS:
            outcome = self._run(redacted, [cell.source for cell in cells], left)
            said = {"cells": [vars(cell) for cell in plan.cells], "remarks": {}, "typed_id": ""}
            told = self._read(
                "parse", "What it wrote", sheet=self.sheet.name, plan=said, output=outcome.output, student=student
            )
            runs.append(_read_run(plan, outcome, told))
            count = len(runs[-1].cells)
            seconds, wall_seconds = left.seconds - outcome.processor_seconds, deadline - time.monotonic()
            if count == len(cells) or not outcome.ended_by_itself or min(seconds, wall_seconds) <= 0:
                break
            left = replace(left, seconds=seconds, wall_seconds=wall_seconds)
            reason = outcome.end_reason or ENDED_ITSELF
            message = f"This cell was left out, and the other cells were run without it: {reason}."
            cells[count] = replace(cells[count], source=f"raise RuntimeError({message!r})")
        return max(runs, key=lambda run: len(run.cells))

    def _run(self, redacted: str, sources: Sequence[str], limits: Limits) -> RunOutcome:
        """Run the cells once. If the server has ended, it is restarted once."""
        for _ in range(2):
            runner = self._runner
            try:
                if runner:
                    return runner.run(redacted, sources, limits)
            except ProcessEnded:
                with self._runner_lock:
                    if self._is_closed:
                        raise
                    if runner and self._runner is runner:
                        runner.close()
                        self._runner = Runner(self._setup, self.is_safe)
        raise UnreadInTime("This submission crashed the grader twice. Please tell your instructor.")

    def _covered_problems(self) -> list[int]:
        """The problems that the sheet's own solution solves for other students and for other numbers.

        In the others, the solution itself is typed for the drawing of one student, so they cannot be tried with other numbers.
        """
        covered = set(self.sheet.checks)
        for student in PROBES:
            try:
                plan = self._plan(self.sheet.solution)
                seed, redacted = self._redacted_sheet(student)
                answers = self._run_until_complete(redacted, plan, student).answers
                own, _ = self._verdicts(student, seed, answers)
                redrawn, _ = self._redrawn_fractions(student, plan, sorted(covered), answers)
            except UnusableNotebook:
                covered.clear()
                break
            covered = {k for k in covered if redrawn.get(str(k)) == own.get(str(k), NO_ANSWER)["fraction"] == 1.0}
            if not covered:
                break
        if not covered:
            self.close()
            raise ValueError(
                "With a key, SHEET must be the notebook with the solution, solutions/X/X.ipynb: the key applies to the "
                "problems that it solves from sheet.given(k). It solves none."
            )
        return sorted(covered)

    def _redrawn_fractions(
        self, student: str, plan: RunPlan, problems: Sequence[int], own_answers: Mapping[str, Any]
    ) -> tuple[dict[str, float], list[str]]:
        """How much of each answer is right when the sheet runs with other numbers, in the best of some draws; and reached limits.

        An answer that stays the same although the right one is another has no part right, even where the two agree.
        """
        best, limits = {str(k): 0.0 for k in problems}, list[str]()
        for draw in range(REDRAWS):
            redraw = [self.sheet.key, draw, " ".join(map(str, problems))]
            seed, redacted = self._redacted_sheet(student, redraw)
            run = self._run_until_complete(redacted, plan, student)
            verdicts, judge_limits = self._verdicts(student, seed, run.answers, redraw)
            changed = [k for k in best if run.answers.get(k) != own_answers.get(k)]
            best |= {k: max(best[k], verdicts.get(k, NO_ANSWER)["fraction"]) for k in changed}
            limits += [*run.limits, *judge_limits]
        return best, limits

    def _redacted_sheet(self, student: str, redraw: Sequence[Any] | None = None) -> tuple[int, str]:
        """The student's redacted sheet, and the seed of this run."""
        answer = self._ask_judge({"request": "redacted sheet", "student": student, "redraw": redraw})
        if "error" in answer:
            raise UnusableNotebook(f"The numbers of {student!r} could not be drawn: {answer['error']}")
        return answer["seed"], answer["sheet"]

    def _verdicts(
        self, student: str, seed: int, answers: Mapping[str, Any], redraw: Sequence[Any] | None = None
    ) -> tuple[dict[str, Any], list[str]]:
        """The verdicts by problem number, and the limits that were reached."""
        message = {
            "request": "verdicts",
            "student": student,
            "seed": seed,
            "site": self.sheet.site,
            "redraw": redraw,
            "answers": answers,
            "answer_seconds": self._limits.answer_seconds,
        }
        answer = self._ask_judge(message)
        if "verdicts" not in answer:
            return dict.fromkeys(answers, NOT_JUDGED), [f"the judge: {answer['error']}"]
        return answer["verdicts"], answer["limits"]

    def _ask_judge(self, message: Mapping[str, Any]) -> dict[str, Any]:
        """Send a request to the judge. If the judge has ended, it is restarted once; the answer may have the key "error"."""
        for _ in range(2):
            judge = self._judge
            try:
                return judge.request({**message, "sheet": self.sheet.name}, JUDGE_SECONDS)
            except ProcessEnded as error:
                reason = str(error)
                with self._judge_lock:
                    if self._is_closed:
                        raise
                    if self._judge is judge:
                        judge.stop()
                        self._judge = self._start_judge()
        return {"error": reason}


def _zero_points(state: str, text: str) -> dict[str, Any]:
    return {
        "state": state,
        "fraction": 0.0,
        "mistakes": [],
        "possible": [],
        "explanations": [],
        "address": "",
        "text": text,
    }


NO_ANSWER = _zero_points("missing", "No answer was received for this problem.")
NOT_JUDGED = _zero_points("unreadable", "This answer could not be judged. Please tell your instructor.")


def _read_run(plan: RunPlan, outcome: RunOutcome, told: Mapping[str, Any]) -> Run:
    """The run, from what the step "parse" returns."""
    cells = [
        RanCell(cell.source, cell.problem, cell.index, outputs)
        for cell, outputs in zip(plan.cells, told["outputs"], strict=False)
    ]
    errors = {int(k): lines for k, lines in told["check_errors"].items()}
    limits = [outcome.end_reason] if outcome.end_reason and not outcome.ended_by_itself else []
    return Run(outcome, cells, told["answers"], told["typed_id"], told["remarks"], errors, [*limits, *told["limits"]])


def _status(plan: RunPlan, run: Run) -> tuple[str, str]:
    """Whether the run came to its end, and if not, where it stopped and why."""
    count = len(run.cells)
    if count == len(plan.cells):
        return "graded", ""
    reason = run.outcome.end_reason or ENDED_ITSELF
    own = [place for place, planned in enumerate(plan.cells) if planned.index is not None]
    cell = f"code cell {sum(place <= count for place in own)} of {len(own)}"
    return "stopped", f"The run stopped in {cell}: {reason}. The answers before it count."
