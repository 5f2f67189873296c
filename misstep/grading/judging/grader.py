"""Grade one submission: bytes in, a Result out, whatever the bytes are.

The submission runs in the sandbox and emits its answers as data. The judge, in a process that never runs student code, reads
them and computes the points. This module connects the two, and records what happened.
"""

import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Any

from misstep.catalog import find_course
from misstep.grading.collect.notebook import UnusableNotebook
from misstep.grading.collect.run_plan import ReleasedSheet, RunPlan, plan_run
from misstep.grading.judging.parse_output import ParsedOutput, parse_output
from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.sandbox.course_stub import setup_for
from misstep.grading.sandbox.limits import Limits, SandboxUnavailable
from misstep.grading.sandbox.rpc import ProcessEnded, Worker
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


class Grader:
    """Grades submissions of one sheet. Any number of threads may use one grader. Close it after use.

    Raises SandboxUnavailable if this machine cannot provide a layer of the sandbox, unless is_safe is False; ValueError
    for a sheet that the judge cannot open.
    """

    def __init__(self, sheet: ReleasedSheet, limits: Limits | None = None, is_safe: bool = True) -> None:
        self.sheet, self.is_safe = sheet, is_safe
        self._limits = limits or Limits()
        self._runner_lock, self._judge_lock = Lock(), Lock()
        self._judge = self._start_judge()  # first, because it imports while the server does
        try:
            with ThreadPoolExecutor(1) as pool:
                problems = pool.submit(self._ask_judge, {"request": "problems"})
                setup = setup_for(find_course(sheet.course), sheet.folder)
                self._setup = replace(setup, imports=sorted(slow_imports(sheet.opening)))
                self._runner = Runner(self._setup, is_safe)
        except (SandboxUnavailable, ValueError):
            self._judge.stop()
            raise
        answer = problems.result()
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
        """End the server and the judge."""
        self._runner.close()
        self._judge.stop()

    def grade(self, student: str, content: bytes | None) -> Result:
        """Grade the notebook of a student; content is None if nothing was submitted.

        No error in the submission makes it raise: each one becomes the reason of a result.
        """
        start = time.monotonic()
        digest = sha256(content).hexdigest() if content is not None else ""
        try:
            if content is None:
                raise UnusableNotebook("Nothing was handed in.")
            plan = plan_run(self.sheet, content)
            seed, redacted = self._redacted_sheet(student)
            outcome, parsed = self._run_until_complete(redacted, plan)
        except UnusableNotebook as error:
            problems = self._problem_results({}, {}, {})
            return self._result(student, "broken", str(error), problems, digest=digest, start=start)
        notes = {k: [*plan.remarks.get(k, ()), *parsed.check_errors(k)] for k in self.sheet.checks}
        verdicts = self._verdicts(student, seed, parsed.answers)
        if any(verdicts.get(str(k), NO_ANSWER)["fraction"] for k in self._covered):
            redrawn = self._redrawn_fractions(student, plan, self._covered, parsed.answers)
            verdicts |= {k: {**verdicts[k], "redrawn": redrawn[k]} for k in redrawn if k in verdicts}
        status, reason = _status(plan, outcome, parsed)
        return self._result(
            student,
            status,
            reason,
            self._problem_results(verdicts, parsed.answers, notes),
            notes=parsed.remarks(student),
            typed_id=parsed.typed_id,
            digest=digest,
            start=start,
            cells=parsed.own_cells,
        )

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

    def _run_until_complete(self, redacted: str, plan: RunPlan) -> tuple[RunOutcome, ParsedOutput]:
        """Run the cells and parse their output. If a cell ends the process, run the others again without it.

        So a crash in one problem costs only that problem. All runs together have the time of one. The longest run counts.
        """
        sources = [cell.source for cell in plan.cells]
        runs: list[tuple[RunOutcome, ParsedOutput]] = []
        deadline = time.monotonic() + self._limits.seconds
        while len(runs) < MAX_RUNS and (remaining := deadline - time.monotonic()) > 0:
            outcome = self._run(redacted, sources, replace(self._limits, seconds=remaining))
            parsed = parse_output(self.sheet.name, plan, outcome.output)
            runs.append((outcome, parsed))
            if len(parsed.cells) == len(sources) or not outcome.ended_by_itself:
                break
            reason = outcome.end_reason or ENDED_ITSELF
            message = f"This cell was left out, and the other cells were run without it: {reason}."
            sources[len(parsed.cells)] = f"raise RuntimeError({message!r})"
        return max(runs, key=lambda run: len(run[1].cells))

    def _run(self, redacted: str, sources: Sequence[str], limits: Limits) -> RunOutcome:
        """Run the cells once. If the server has ended, it is restarted once."""
        for _ in range(2):
            runner = self._runner
            try:
                return runner.run(redacted, sources, limits)
            except ProcessEnded:
                with self._runner_lock:
                    if self._runner is runner:
                        runner.close()
                        self._runner = Runner(self._setup, self.is_safe)
        raise UnusableNotebook("This submission crashed the grader twice. Please tell your instructor.")

    def _covered_problems(self) -> list[int]:
        """The problems that the sheet's own solution solves for other students and for other numbers.

        In the others, the solution itself is typed for the drawing of one student, so they cannot be tried with other numbers.
        """
        covered = set(self.sheet.checks)
        for student in PROBES:
            try:
                plan = plan_run(self.sheet, self.sheet.solution)
                seed, redacted = self._redacted_sheet(student)
                answers = self._run_until_complete(redacted, plan)[1].answers
                own = self._verdicts(student, seed, answers)
                redrawn = self._redrawn_fractions(student, plan, sorted(covered), answers)
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
    ) -> dict[str, float]:
        """How much of each answer is right when the sheet runs with other numbers, in the best of some draws.

        An answer that stays the same although the right one is another has no part right, even where the two agree.
        """
        best = {str(k): 0.0 for k in problems}
        for draw in range(REDRAWS):
            redraw = [self.sheet.key, draw, " ".join(map(str, problems))]
            seed, redacted = self._redacted_sheet(student, redraw)
            answers = self._run_until_complete(redacted, plan)[1].answers
            verdicts = self._verdicts(student, seed, answers, redraw)
            changed = [k for k in best if answers.get(k) != own_answers.get(k)]
            best |= {k: max(best[k], verdicts.get(k, NO_ANSWER)["fraction"]) for k in changed}
        return best

    def _redacted_sheet(self, student: str, redraw: Sequence[Any] | None = None) -> tuple[int, str]:
        """The student's redacted sheet, and the seed of this run."""
        answer = self._ask_judge({"request": "redacted sheet", "student": student, "redraw": redraw})
        if "error" in answer:
            raise UnusableNotebook(f"The numbers of {student!r} could not be drawn: {answer['error']}")
        return answer["seed"], answer["sheet"]

    def _verdicts(
        self, student: str, seed: int, answers: Mapping[str, Any], redraw: Sequence[Any] | None = None
    ) -> dict[str, Any]:
        message = {
            "request": "verdicts",
            "student": student,
            "seed": seed,
            "site": self.sheet.site,
            "redraw": redraw,
            "answers": answers,
        }
        return dict(self._ask_judge(message).get("verdicts") or dict.fromkeys(answers, NOT_JUDGED))

    def _ask_judge(self, message: Mapping[str, Any]) -> dict[str, Any]:
        """Send a request to the judge. If the judge has ended, it is restarted once; the answer may have the key "error"."""
        for _ in range(2):
            judge = self._judge
            try:
                return judge.request({**message, "sheet": self.sheet.name}, JUDGE_SECONDS)
            except ProcessEnded as error:
                reason = str(error)
                with self._judge_lock:
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


def _status(plan: RunPlan, outcome: RunOutcome, parsed: ParsedOutput) -> tuple[str, str]:
    """Whether the run came to its end, and if not, where it stopped and why."""
    count = len(parsed.cells)
    if count == len(plan.cells):
        return "graded", ""
    reason = outcome.end_reason or ENDED_ITSELF
    own = [place for place, planned in enumerate(plan.cells) if planned.index is not None]
    cell = f"code cell {sum(place <= count for place in own)} of {len(own)}"
    return "stopped", f"The run stopped in {cell}: {reason}. The answers before it count."
