"""The census: what feedback says to many wrong answers of many students, and how much of it is true.

For each problem and student it judges every mutant of the solution, every mistake of the author, and every slip of the kind of
answer, and counts full marks for a wrong answer, names that are not what was done, messages whose claim is false, and mistakes
without a name.
"""

import json
from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from typing import Any

from misstep.catalog import add_course_argument, find_course
from misstep.diagnosis.bugs import inseparable_pairs
from misstep.diagnosis.explanation import CONSEQUENCES, SAME_CONSEQUENCE
from misstep.display.sentences import BY_CHANCE
from misstep.judge import Finding, judge
from misstep.mistakes import Mistake
from misstep.problem import Problem, Template

COUNTS = {
    "full_marks": "full marks for a wrong answer",
    "misnamed": "a name that is not what was done",
    "false": "false claims",
    "unnamed": "without a name",
}
"""What is counted, with its heading."""

MAX_EXAMPLES = 5
"""How many examples of each count are kept for a problem."""


@dataclass
class Row:
    """The counts of one problem.

    wrong     the number of wrong answers that were judged
    examples  for each count, some answers that were counted: the student, what was done, and what feedback said
    """

    number: str
    wrong: int = 0
    counts: Counter[str] = field(default_factory=Counter)
    examples: dict[str, list[str]] = field(default_factory=dict)

    def count(self, what: str, example: str) -> None:
        """Count an answer, and keep it if it is one of the first."""
        self.counts[what] += 1
        if len(self.examples.setdefault(what, [])) < MAX_EXAMPLES:
            self.examples[what].append(example)


def census_of(template: Template, students: Iterable[str]) -> Row:
    """Judge the wrong answers of some students to one problem.

    >>> import numpy as np
    >>> from misstep import problem
    >>> from misstep.answers.number import Numbers
    >>> from misstep.mutants.expression import given
    >>> @problem("01.1", "A half", points=1, lecture="01_halves#Halves")
    ... def half(sampler):
    ...     solution = given("x", float(sampler.integer(3, 9))) / 2
    ...     return Problem("Give half of x.", Numbers(np.array(solution.value)), solution=solution)
    >>> row = census_of(half, ["ada", "bob"])
    >>> row.counts["full_marks"], row.counts["misnamed"], row.counts["unnamed"]
    (0, 0, 0)
    """
    row = Row(template.number)
    for student in students:
        problem = template.variant(student)
        for wrong in chain(problem.known_mistakes, problem.slips):
            is_seen = wrong.name not in problem.invisible
            if is_seen or not all(problem.answer.agrees(wrong.value, problem.answer.value)):
                _count(row, student, problem, wrong)
    return row


def is_observation(problem: Problem, value: Any, finding: Finding) -> bool:
    """Return whether a finding says only what the answer itself shows beside the right one, and nothing of how it came about."""
    answer, part = problem.answer, list(problem.answer.parts).index(finding.parts[0])
    seen = [answer.appearance(value, None), answer.arrangement(value)]
    seen += [look(value, part) for look in (answer.appearance, answer.explanation, answer.description)]
    return any(one and one[1] == finding.message for one in seen) or finding.mistake == "given unchanged"


def is_true(problem: Problem, value: Any, finding: Finding) -> bool:
    """Return whether a message that names a mistake is true of an answer that was read.

    Each name and each sentence must be that of a mistake whose answer the student gave, in all parts or in the parts that the
    finding speaks of. This looks for the sentence, not for the answer, so it does not repeat the search that found it.
    """
    if finding.mistake is None or finding.alternatives in ((("rounded",),), ()):
        return True
    parts = [list(problem.answer.parts).index(part) for part in finding.parts]
    if is_observation(problem, value, finding):
        return True
    known = [*problem.mistakes, *problem.mutants, *problem.slips]
    if any(len(names) > 1 for names in finding.alternatives):
        known += problem.double_mutants(value)
    claims: dict[str, bool] = {}
    message = finding.message.replace(SAME_CONSEQUENCE, CONSEQUENCES[0])
    for mistake in known:
        agrees = problem.answer.shows(value, mistake.value)
        in_parts = all(agrees[part] for part in parts)
        for text, holds in (
            (mistake.message, all(agrees)),
            (mistake.possible, all(agrees)),
            (mistake.part, in_parts),
        ):
            # Of two long stories only their first sentences are told.
            for said in {text, f"{text.partition('. ')[0].removesuffix('.')}."} if text else ():
                if said in message and mistake.names in finding.alternatives:
                    claims[said] = claims.get(said, False) or holds
    # A sentence may be the beginning of a longer one, which then is the one that was said.
    told = [text for text in claims if not any(text != other and text in other for other in claims)]
    return bool(told) and all(claims[text] for text in told)


def _is_named(problem: Problem, mistake: Mistake, findings: Sequence[Finding]) -> bool:
    """Return whether a finding has the name of a mistake, of the same one in other words, or the author's for its answer."""
    if mistake in problem.slips:
        return True  # it says how the answer differs, so it cannot contradict a finding that says what was done
    same = [one for one in problem.mutants if one.key == mistake.key]
    own = [one for one in problem.mistakes if all(problem.answer.agrees(mistake.value, one.value))]
    return any(one.names in finding.alternatives for finding in findings for one in (mistake, *same, *own))


def _count(row: Row, student: str, problem: Problem, wrong: Mistake) -> None:
    judgement = judge(problem, wrong.value)
    said = " | ".join(f"{finding.mistake}: {finding.message}" for finding in judgement.findings)
    example = f"{student}: {wrong.name}: {said}"
    row.wrong += 1
    if judgement.state == "right":
        row.count("full_marks", example)
        return
    named = [finding for finding in judgement.findings if finding.mistake]
    unnamed = [finding for finding in judgement.findings if not finding.mistake and finding.message != BY_CHANCE]
    if unnamed and judgement.state != "unreadable":
        row.count("unnamed", example)
    if not named:
        return
    value = problem.answer.read(wrong.value)
    if not all(is_true(problem, value, finding) for finding in named):
        row.count("false", example)
    if not _is_named(problem, wrong, named) and any(_claims_a_method(problem, value, finding) for finding in named):
        row.count("misnamed", example)


def wrong_answers(problem: Problem) -> list[list[tuple[str, ...]]]:
    """Return the wrong answers of a problem, each as the names of the mistakes that lead to it."""
    reached: list[tuple[Any, list[tuple[str, ...]]]] = []
    for mistake in chain(problem.mistakes, problem.mutants, problem.slips):
        for value, names in reached:
            if all(problem.answer.agrees(mistake.value, value)):
                names.append(mistake.names)
                break
        else:
            reached.append((mistake.value, [mistake.names]))
    return [names for _, names in reached]


def _claims_a_method(problem: Problem, value: Any, finding: Finding) -> bool:
    """Return whether a finding says what was done. A slip only says how the answer differs from the right one."""
    if is_observation(problem, value, finding):
        return False
    slips = {slip.names for slip in problem.slips}
    return not slips.issuperset(finding.alternatives)


def table(rows: Sequence[Row]) -> str:
    """Return the counts as a table in Markdown, with a line for all problems together."""
    lines = ["| problem | wrong answers | " + " | ".join(COUNTS.values()) + " |", "| --- " * (len(COUNTS) + 2) + "|"]
    total = Row("**together**")
    for row in rows:
        total.wrong += row.wrong
        total.counts += row.counts
    for row in (*rows, total):
        counts = [str(row.counts[what]) for what in COUNTS if what != "unnamed"]
        counts.append(_share(row.counts["unnamed"], row.wrong))
        lines.append(f"| {row.number} | {row.wrong} | {' | '.join(counts)} |")
    return "\n".join(lines)


def _share(part: int, whole: int) -> str:
    return f"{part / whole:.0%}" if whole else "–"


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep census`."""
    add_course_argument(parser)
    parser.add_argument("--students", type=int, default=60, help="how many students (60)")
    parser.add_argument("--sheet", action="append", help="only this sheet; may be repeated")
    parser.add_argument("--examples", action="store_true", help="print examples of what was counted")
    parser.add_argument("--save", type=Path, help="write the counts into this JSON file")


def run(options: Namespace) -> int:
    """Take the census of a course, print it, and return 0 if nothing wrong has full marks, a wrong name or a false claim."""
    course = find_course(options.course)
    students = [f"student {k}" for k in range(options.students)]
    sheets = options.sheet or course.sheets()
    reference = options.course or course.reference
    jobs = [(reference, sheet, k, students) for sheet in sheets for k in range(len(course.find_sheet(sheet).problems))]
    with ProcessPoolExecutor() as pool:
        rows = list(pool.map(_row, *zip(*jobs, strict=True)))
    print(table(rows))
    pairs = {}
    for sheet in sheets:
        problems = [template.variant(students[0]) for template in course.find_sheet(sheet).problems]
        pairs[sheet] = inseparable_pairs(map(wrong_answers, problems))
        listed = ", ".join(f"{one} / {other}" for one, other in pairs[sheet])
        print(f"\n{sheet}: no problem tells these mistakes apart: {listed or 'none'}")
    if options.examples:
        for row in rows:
            for what, examples in row.examples.items():
                print(f"\n{row.number}, {COUNTS[what]}:", *examples, sep="\n- ")
    if options.save:
        saved = json.loads(options.save.read_text("utf-8")) if options.save.exists() else {}
        counted = [{**vars(row), "examples": {}} for row in rows]  # examples contain answers
        saved |= {"students": len(students), "problems": counted, "inseparable": pairs}
        options.save.write_text(json.dumps(saved, indent=1) + "\n", encoding="utf-8")
    return int(any(row.counts[what] for row in rows for what in ("full_marks", "misnamed", "false")))


def _row(reference: str, sheet: str, position: int, students: Sequence[str]) -> Row:
    return census_of(find_course(reference).find_sheet(sheet).problems[position], students)
