"""Judge what one student handed in: stored answers in, a Result out, whatever the files are.

The numbers are drawn anew from the id that the student should have, so nothing that a notebook says about points counts.
"""

import json
from collections.abc import Mapping, Sequence
from contextlib import chdir, nullcontext
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from misstep.catalog import find_course
from misstep.diagnosis.explanation import Finding
from misstep.display.card import Link
from misstep.display.lecture_address import page_address
from misstep.grading import result as states
from misstep.grading.collect.notebook import Work, choose
from misstep.grading.collect.submissions import Submission, Unreadable
from misstep.grading.escape import format_points
from misstep.grading.overrides import Override
from misstep.grading.pages import feedback_page
from misstep.grading.result import ProblemResult, Result
from misstep.grading.similarity import relation
from misstep.judge import Judgement, judge
from misstep.problem import Problem, Template
from misstep.sheet import SAMPLE_ID, Sheet
from misstep.storage import Opaque, from_data, to_data
from misstep.verdict import Verdict

NO_ANSWER = (
    "No answer is stored: the check cell was not run or ended with an error, or the notebook was not saved afterwards."
)


@dataclass(frozen=True)
class SheetName:
    """A sheet, as another process finds it."""

    name: str
    folder: str = ""  # where the file of a robot's own sheet is, "" for a sheet of a lecture
    site: str = ""  # the address of the course's site, "" if it has none

    @cache  # noqa: B019 - there are few of them, and they live as long as the process
    def find(self) -> Sheet:
        """Return the sheet itself."""
        with chdir(self.folder) if self.folder else nullcontext():
            return find_course().find_sheet(self.name)


@dataclass(frozen=True)
class Request:
    """What is needed to grade one student."""

    sheet: SheetName
    submission: Submission
    overrides: Sequence[Override] = ()
    uses_typed_id: bool = False  # also where another id is expected


def grade(request: Request) -> Result:
    """Grade one student. Every fault of the submission is in the result."""
    sheet, one = request.sheet.find(), request.submission
    if not one.files:
        return ungraded(request, states.ABSENT, "Nothing was handed in.", "absent")
    try:
        chosen = choose(one.files, sheet.name)
    except (Unreadable, MemoryError) as error:
        reason = str(error) or "The notebook needs too much memory. Clear all outputs, run all cells, and save."
        return ungraded(request, states.UNREADABLE, reason, "unreadable")
    work, typed = chosen.work, chosen.work.ids
    # The id that was typed last, if several were, because its numbers are those that the student saw last.
    id_ = typed[-1] if typed and (request.uses_typed_id or not one.id) else one.id
    problems, notes = _problems(request, work, id_), list(chosen.notes)
    flags = _flags(one, problems, work, id_)
    reason = "" if work.answers else f"{states.FLAGS['not run']}."
    if len(chosen.ids) > 2:
        flags["several ids"] = ", ".join(chosen.ids[:5])
    if "other id" in flags:
        names = ", ".join(map(repr, typed[:3]))
        notes.append(f"The answers were checked for {names}, and are judged with the numbers of {id_!r}.")
        points = format_points(sum(each.points for each in _problems(request, work, typed[-1])))
        flags["other id"] = f"typed {names}; with the numbers of {typed[-1]!r}, {points} points"
    status = states.GRADED if work.answers else states.NOT_RUN
    earned = sum(each.points for each in problems)
    result = Result(one.student, earned, sheet.points, status, problems, reason, notes, flags, typed, chosen.name)
    return finished(result, request)


def ungraded(request: Request, status: str, reason: str, flag: str) -> Result:
    """Return the result of a submission in which no answer could be judged."""
    sheet = request.sheet.find()
    problems = [ProblemResult(one.number, one.title, 0.0, one.points, "missing", [NO_ANSWER]) for one in sheet.problems]
    result = Result(request.submission.student, 0.0, sheet.points, status, problems, reason, flags={flag: reason})
    return finished(result, request)


def finished(result: Result, request: Request) -> Result:
    """Return a result as the instructor decided, with its page."""
    problems = []
    decisions = {one.problem: one for one in request.overrides}
    for problem in result.problems:
        if decided := decisions.get(problem.number):
            points = problem.points if decided.points is None else decided.points
            note, state = decided.sentence(problem.points), problem.state
            if state == "open" and decided.points is not None:
                note, state = f"Marked by your instructor. {decided.comment}".strip(), "marked"
            problem = replace(problem, points=points, note=note, state=state)  # noqa: PLW2901
        problems.append(problem)
    total, notes = sum(problem.points for problem in problems), list(result.notes)
    if unmarked := ", ".join(problem.number for problem in problems if problem.state == "open"):
        notes.append(f"The points of {unmarked} are not yet counted: your instructor marks this text.")
        result = replace(result, flags={**result.flags, "unmarked": unmarked})
    if decided := decisions.get(""):
        notes.append(decided.sentence(total))
        total = total if decided.points is None else decided.points
    result = replace(result, points=total, problems=problems, notes=notes)
    return replace(result, page=feedback_page(result, request.sheet.name))


def _flags(one: Submission, problems: Sequence[ProblemResult], work: Work, id_: str) -> dict[str, str]:
    flags, ids = {}, {typed.casefold() for typed in work.ids}
    if not work.answers:
        flags["not run"] = ""
    elif missing := ", ".join(problem.number for problem in problems if problem.state == "missing"):
        flags["partly run"] = missing
    if stale := [problems[k - 1].number for k in work.stale if 1 <= k <= len(problems)]:
        flags["changed"] = ", ".join(stale)
    if ids - {(one.id or id_).casefold()} or SAMPLE_ID in ids:
        flags["other id"] = ""
    return flags


def _problems(request: Request, work: Work, id_: str) -> list[ProblemResult]:
    templates = enumerate(request.sheet.find().problems, start=1)
    return [_judged(template, id_, work, k, request.sheet.site) for k, template in templates]


def _judged(template: Template, id_: str, work: Work, k: int, site: str) -> ProblemResult:
    if k not in work.answers:
        return ProblemResult(template.number, template.title, 0.0, template.points, "missing", [NO_ANSWER])
    problem, data, typed = template.variant(id_), *work.answers[k]
    data = json.loads(data)
    judgement = judged_data(problem, data)
    is_of_other = typed.casefold() != id_.casefold()
    if is_of_other and judgement.state in ("wrong", "partly", "unreadable"):
        # no mistake explains it, because it answers a question with other numbers
        text = f"This answer was checked for {typed!r}, and so with other numbers than those of {id_!r}."
        parts = [part for part in problem.answer.parts if part not in judgement.right_parts]
        judgement = replace(judgement, findings=[Finding(parts, text)])
    verdict = Verdict(template, judgement, address=page_address(template.lecture, site))
    card = verdict.card
    is_unnamed = judgement.state in ("wrong", "partly") and not (judgement.mistakes or is_of_other)
    right = to_data(problem.answer.value, problem.answer.inputs) if is_unnamed else None
    return ProblemResult(
        *(template.number, template.title, verdict.score, template.points, judgement.state),
        lines=[line.strip() for line in card.text().splitlines()[1:] if line.strip()],
        address=next((part.address for part in card.body if isinstance(part, Link)), ""),
        answer=None if judgement.state == "unreadable" else data,
        mistakes=judgement.mistakes,
        unnamed=(relation(data, right), right) if is_unnamed else None,
    )


def judged_data(problem: Problem, data: Mapping[str, Any] | None) -> Judgement:
    """Judge an answer that is data. One that raises an error is unreadable."""
    try:
        value = from_data(data)
        if not isinstance(value, Opaque):
            return judge(problem, value)
        reason = f"got {value}"
    except Exception as error:  # whatever error an answer causes, the other problems must still be judged
        reason = f"what is stored could not be judged: {type(error).__name__}"
    text = f"Expected {problem.answer.expected}; {reason}."
    return Judgement("unreadable", findings=[Finding(problem.answer.parts, text)])
