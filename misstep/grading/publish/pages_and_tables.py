"""Publish: from the stored results to the pages and tables that people open."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from misstep.grading.collect.roster import Roster
from misstep.grading.judging.result import ABSENT
from misstep.grading.publish.grades_csv import grades_table, record_changes
from misstep.grading.publish.marking_page import marking_page
from misstep.grading.publish.overrides import UNMARKED, LateRule, apply_overrides, read_overrides
from misstep.grading.publish.pages import feedback_page, format_points
from misstep.grading.publish.platform_exports import export
from misstep.grading.publish.report import report_page
from misstep.grading.publish.result_store import ResultStore, file_name, write_if_changed
from misstep.grading.publish.shared_answers import find_matches, matches_table

LEFT_OUT = "This page has only your points, because the rest of it could not be made within the limits. Please tell your instructor."


def write_page(out: Path, student: str, late: LateRule | None, is_short: bool = False) -> None:
    """Write a student's page from the stored result, if there is one.

    late      the rule for late days
    is_short  whether the page has the points only, because nothing else of this result can be read within the limits
    """
    if result := ResultStore(out).load(student):
        result = apply_overrides(result, read_overrides(out).get(student, ()), late)
        if is_short:
            problems = [
                replace(one, verdict=LEFT_OUT, notes=[], statement="", figure="", address="") for one in result.problems
            ]
            result = replace(result, cells=[], notes=[LEFT_OUT], problems=problems, reason="")
        write_if_changed(out / "feedback" / f"{file_name(student)}.html", feedback_page(result))


def write_tables(
    out: Path,
    students: Sequence[str],
    roster: Roster | None = None,
    column: str | None = None,
    *,
    limits: str = "",
    late: LateRule | None = None,
) -> list[str]:
    """Write all tables and the report, and return a short summary. Files whose content stays the same are not touched.

    column  the column of the sheet on the platform
    limits  what each submission might use, in words
    late    the rule for late days
    """
    store = ResultStore(out)
    # A thousand results with all pictures would not fit into memory.
    loaded = (replace(result, cells=()) for student in students if (result := store.load(student)))
    overrides = read_overrides(out)
    graded = list(loaded)
    results = [apply_overrides(result, overrides.get(result.student, ()), late) for result in graded]
    if not results:
        return ["Nothing is graded yet."]
    if to_mark := marking_page(graded, overrides):
        write_if_changed(out / "marking.html", to_mark)
    left = sum(problem.state == UNMARKED for result in results for problem in result.problems)
    matches = find_matches(results)
    changed = record_changes(out / "changes.csv", out / "grades.csv", results)
    write_if_changed(out / "grades.csv", grades_table(results))
    write_if_changed(out / "matches.csv", matches_table(matches))
    write_if_changed(out / "report.html", report_page(results, matches, limits))
    if roster and (text := export(roster, results, column)):
        write_if_changed(out / f"{roster.kind}.csv", text)
    statuses = Counter(result.status for result in results)
    counts = ", ".join(f"{count} {status}" for status, count in sorted(statuses.items()))
    present = [result for result in results if result.status != ABSENT]
    mean = format_points(sum(result.points for result in present) / max(len(present), 1))
    suspects = sorted({match.student for match in matches if match.shared_count > 1})
    unknown = sorted({*overrides} - {*students})
    by_hand = [result.student for result in results if result.changes]
    average = f"{mean} of {format_points(results[0].max)} points on average, of those who submitted something"
    return [
        f"{len(results)} of {len(students)} submissions: {counts}. {average}.",
        *([f"Several answers right for one other student (matches.csv): {', '.join(suspects)}."] if suspects else []),
        *([f"overrides.csv: there is no submission of {', '.join(unknown)}."] if unknown else []),
        *([f"{left} answers are not marked yet: open marking.html, and save its marks.csv in {out}."] if left else []),
        *([f"By hand (overrides.csv, formgrader): {', '.join(by_hand)}."] if by_hand else []),
        *([f"Points that are others than after the last run (changes.csv): {changed}."] if changed else []),
        f"The results are in {out}: open report.html, then grades.csv.",
    ]
