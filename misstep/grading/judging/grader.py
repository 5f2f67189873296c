"""Grade one submission: bytes in, a Result out, whatever the bytes are.

The submission runs in the sandbox and emits its answers as data. The judge, in a process that never runs student code, reads
them and computes the points. This module connects the two, and records what happened. It never looks into what a student wrote:
the judge does, within limits.
"""

import time
from collections.abc import Mapping, Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from misstep.catalog import find_course
from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.collect.run_plan import PlannedCell, ReleasedSheet, RunPlan
from misstep.grading.fork_server import ProcessEnded
from misstep.grading.judging.parse_output import ParsedRun
from misstep.grading.judging.redraw import Draw
from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits
from misstep.grading.sandbox.runner import Runner, RunOutcome
from misstep.grading.steps import StepFailed, StepProcess, StepProcesses

DRAW_SECONDS = 60.0
"""Processor time for drawing the numbers of a student."""

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

NOT_JUDGED = "This answer could not be judged. Please tell your instructor."

ENDED_ITSELF = "the process ended itself"


class UnreadInTime(UnusableNotebook):
    """A limit was reached before there was anything to judge."""


@dataclass(frozen=True)
class Run:
    """One run of a submission: how it ended, and what was read of its output."""

    outcome: RunOutcome
    parsed: ParsedRun

    @property
    def limits(self) -> list[str]:
        """The limits that were reached, in words."""
        ended = [self.outcome.end_reason] if self.outcome.end_reason and not self.outcome.ended_by_itself else []
        return [*ended, *(["the time of a cell"] if self.parsed.has_timeout else [])]


def start_judge(sheet: ReleasedSheet, has_gradebook: bool = False) -> StepProcesses:
    """Processes that judge a sheet, and read what students wrote.

    The folder of the sheet may be on another machine; then a robot's own sheet is not found.
    """
    folder = str((sheet.folder if sheet.folder.is_dir() else Path()).resolve())
    setup = {"course": sheet.course, "sheet": sheet.name, "folder": folder, "has_gradebook": has_gradebook}
    return StepProcesses("misstep.grading.judging.judge_process", setup)


class Grader:
    """Grades submissions of one sheet. Any number of threads may use one grader. Close it after use.

    judge  from `start_judge`; by default the grader has one of its own

    Raises SandboxUnavailable if this machine cannot provide a layer of the sandbox, unless is_safe is False; ValueError
    for a sheet that the judge cannot open.
    """

    def __init__(
        self,
        sheet: ReleasedSheet,
        limits: Limits | None = None,
        is_safe: bool = True,
        judge: StepProcesses | None = None,
    ) -> None:
        self.sheet, self.is_safe = sheet, is_safe
        self._limits, self._covered = limits or Limits(), list[int]()
        with ExitStack() as opened:
            self._judge = judge or opened.enter_context(start_judge(sheet))
            self._runner = Runner(setup_for(find_course(sheet.course), sheet.folder), is_safe)
            opened.callback(self._runner.close)
            try:
                self._unanswered: list[ProblemResult] = self._judge.do("problems")
            except StepFailed as error:
                raise ValueError(f"The judge cannot open sheet {sheet.name}: {error}") from error
            if sheet.key:
                self._covered = self._covered_problems()
            self._opened = opened.pop_all()

    def __enter__(self) -> "Grader":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the server, and the judge if it is its own. Submissions that are graded meanwhile fail at once."""
        self._opened.close()

    def grade(self, student: str, content: bytes | None, seed_id: str | None = None) -> Result:
        """Grade the notebook of a student; content is None if nothing was submitted.

        seed_id  the id from which the numbers are drawn, by default the student's name; "" for the one that is typed in the notebook

        No error in the submission makes it raise: each one becomes the reason of a result.
        """
        digest = sha256(content).hexdigest() if content is not None else ""
        with self._judge.process() as judge:
            try:
                if content is None:
                    raise UnusableNotebook("Nothing was handed in.")
                plan = self._plan(judge, content)
                seed_id = student if seed_id is None else seed_id or plan.typed_id or student
                run, verdicts, limits = self._attempt(judge, plan, seed_id)
                redrawn = dict[int, float]()
                if any(verdicts[k].points for k in self._covered):
                    redrawn, more = self._redrawn_points(judge, plan, seed_id, self._covered, run.parsed.answers)
                    limits += more
            except UnusableNotebook as error:
                limits = [str(error)] if isinstance(error, UnreadInTime) else []
                return self._result(student, "broken", str(error), self._unanswered, digest=digest, limits=limits)
        notes = {
            k: [*plan.remarks.get(k, ()), *filter(None, [run.parsed.check_errors.get(k)])] for k in self.sheet.checks
        }
        status, reason = _status(plan, run)
        return self._result(
            student,
            status,
            reason,
            self._problem_results(verdicts, run.parsed.answers, notes, redrawn),
            notes=run.parsed.remarks,
            typed_id=run.parsed.typed_id,
            digest=digest,
            cells=[cell for cell in run.parsed.cells if cell.index is not None or cell.problem],
            limits=list(dict.fromkeys(limits)),
        )

    def _plan(self, judge: StepProcess, content: bytes) -> RunPlan:
        plan: RunPlan = self._read(judge, "plan", "The notebook", sheet=self.sheet, content=content)
        return plan

    def _read(self, judge: StepProcess, step: str, what: str, **arguments: Any) -> Any:
        """Let a process read what a student wrote. Raises UnreadInTime if it reaches a limit."""
        try:
            return judge.do(step, seconds=self._limits.reading_seconds, **arguments)
        except StepFailed as error:
            raise UnreadInTime(f"{what} could not be read: {error}.") from error

    def _result(self, student: str, status: str, reason: str, problems: Sequence[ProblemResult], **more: Any) -> Result:
        return Result(
            student,
            self.sheet.name,
            sum(problem.points for problem in problems),
            sum(problem.max for problem in problems),
            status,
            reason,
            problems,
            is_safe=self.is_safe,
            **more,
        )

    def _problem_results(
        self,
        verdicts: Mapping[int, ProblemResult],
        answers: Mapping[int, Any],
        notes: Mapping[int, Sequence[str]],
        redrawn: Mapping[int, float],
    ) -> list[ProblemResult]:
        """The verdicts with what else is known: the notes on cells, and the points with other numbers, if there are any."""
        results = []
        for k, one in verdicts.items():
            points = min(one.points, redrawn.get(k, one.points))
            typed = [TYPED_NOTE.format(one.points, one.number, k)] if points < one.points else []
            state = one.state if k in answers else "missing"
            known: dict[str, Any] = {"answer": answers.get(k), "notes": [*notes.get(k, ()), *typed]}
            if k in self._covered:
                known["own_points"] = one.points
            results.append(replace(one, points=points, state=state, **known))
        return results

    def _attempt(
        self, judge: StepProcess, plan: RunPlan, student: str, draw: Draw | None = None
    ) -> tuple[Run, dict[int, ProblemResult], list[str]]:
        """Run a submission with the numbers of a student, or with others; its verdicts, and the limits it reached."""
        try:
            seed, redacted = judge.do("redacted sheet", seconds=DRAW_SECONDS, student=student, draw=draw)
        except StepFailed as error:
            raise UnreadInTime(f"The numbers of {student!r} could not be drawn: {error}") from error
        run = self._run_until_complete(judge, redacted, plan, student)
        verdicts, limits = self._verdicts(judge, student, seed, run.parsed.answers, draw)
        return run, verdicts, [*run.limits, *limits]

    def _run_until_complete(self, judge: StepProcess, redacted: str, plan: RunPlan, student: str) -> Run:
        """Run the cells and read their output. If a cell ends the process, run the others again without it.

        So a crash in one problem costs only that problem. All runs together have the time of one. The longest run counts.
        """
        cells, left = list(plan.cells), self._limits
        runs: list[Run] = []
        deadline = time.monotonic() + left.wall_seconds
        while len(runs) < MAX_RUNS:
            outcome = self._run(redacted, cells, left)
            written = {"sheet": self.sheet.name, "plan": plan, "output": outcome.output, "student": student}
            parsed: ParsedRun = self._read(judge, "parse", "What it wrote", **written)
            runs.append(Run(outcome, parsed))
            count = len(parsed.cells)
            seconds, wall_seconds = left.seconds - outcome.processor_seconds, deadline - time.monotonic()
            if count == len(cells) or not outcome.ended_by_itself or min(seconds, wall_seconds) <= 0:
                break
            left = replace(left, seconds=seconds, wall_seconds=wall_seconds)
            reason = outcome.end_reason or ENDED_ITSELF
            message = f"This cell was left out, and the other cells were run without it: {reason}."
            cells[count] = replace(cells[count], source=f"raise RuntimeError({message!r})")
        return max(runs, key=lambda run: len(run.parsed.cells))

    def _run(self, redacted: str, cells: Sequence[PlannedCell], limits: Limits) -> RunOutcome:
        """Run the cells once, and once more if the server ended meanwhile."""
        sources = [cell.source for cell in cells]
        with suppress(ProcessEnded):
            return self._runner.run(redacted, sources, limits)
        try:
            return self._runner.run(redacted, sources, limits)
        except ProcessEnded as error:
            raise UnreadInTime("This submission crashed the grader twice. Please tell your instructor.") from error

    def _covered_problems(self) -> list[int]:
        """The problems that the sheet's own solution solves for other students and for other numbers.

        In the others, the solution itself is typed for the drawing of one student, so they cannot be tried with other numbers.
        """
        covered = set(self.sheet.checks)
        with self._judge.process() as judge:
            for student in PROBES:
                try:
                    plan = self._plan(judge, self.sheet.solution)
                    run, own, _ = self._attempt(judge, plan, student)
                    redrawn, _ = self._redrawn_points(judge, plan, student, sorted(covered), run.parsed.answers)
                except UnusableNotebook:
                    covered.clear()
                    break
                covered = {k for k in covered if redrawn[k] == own[k].points == own[k].max}
        if not covered:
            raise ValueError(
                "With a key, SHEET must be the notebook with the solution, solutions/X/X.ipynb: the key applies to the "
                "problems that it solves from sheet.given(k). It solves none."
            )
        return sorted(covered)

    def _redrawn_points(
        self, judge: StepProcess, plan: RunPlan, student: str, problems: Sequence[int], own_answers: Mapping[int, Any]
    ) -> tuple[dict[int, float], list[str]]:
        """The points of each answer when the sheet runs with other numbers, in the best of some draws; and reached limits.

        An answer that stays the same although the right one is another has no part right, even where the two agree.
        """
        best, limits = dict.fromkeys(problems, 0.0), list[str]()
        for number in range(REDRAWS):
            draw = Draw(self.sheet.key, number, frozenset(problems))
            run, verdicts, more = self._attempt(judge, plan, student, draw)
            changed = [k for k in best if run.parsed.answers.get(k) != own_answers.get(k)]
            best |= {k: max(best[k], verdicts[k].points) for k in changed}
            limits += more
        return best, limits

    def _verdicts(
        self, judge: StepProcess, student: str, seed: int, answers: Mapping[int, Any], draw: Draw | None = None
    ) -> tuple[dict[int, ProblemResult], list[str]]:
        """The verdict on each problem, and the limits that were reached. An answer that reaches one is judged as unreadable."""
        verdicts, limits = dict[int, ProblemResult](), list[str]()
        common = {"student": student, "seed": seed, "site": self.sheet.site, "draw": draw}
        for k, unanswered in enumerate(self._unanswered, start=1):
            verdicts[k] = replace(unanswered, state="unreadable", verdict=NOT_JUDGED)
            data = answers.get(k)
            for _ in range(2):
                try:
                    verdicts[k] = judge.do("verdict", seconds=self._limits.answer_seconds, k=k, data=data, **common)
                    break
                except StepFailed as error:
                    limits.append(f"answer {k}: {error}")
                    data = {"other": f"an answer that cannot be judged: {error}"}
            judge.is_spoiled |= verdicts[k].state == "unreadable"
        return verdicts, limits


def _status(plan: RunPlan, run: Run) -> tuple[str, str]:
    """Whether the run came to its end, and if not, where it stopped and why."""
    count = len(run.parsed.cells)
    if count == len(plan.cells):
        return "graded", ""
    reason = run.outcome.end_reason or ENDED_ITSELF
    own = [place for place, planned in enumerate(plan.cells) if planned.index is not None]
    cell = f"code cell {sum(place <= count for place in own)} of {len(own)}"
    return "stopped", f"The run stopped in {cell}: {reason}. The answers before it count."
