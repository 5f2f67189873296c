"""Publish: from the stored results to the pages and tables that people open."""

from collections import Counter
from collections.abc import Container, Sequence
from dataclasses import replace
from pathlib import Path

from misstep.grading.collect.gather import Submission
from misstep.grading.collect.roster import Roster
from misstep.grading.judging.result import ABSENT, Result
from misstep.grading.publish.feedback import feedback_page
from misstep.grading.publish.grades import grades_table
from misstep.grading.publish.pages import format_points
from misstep.grading.publish.platform_exports import export
from misstep.grading.publish.report import report_page
from misstep.grading.publish.result_store import ResultStore, file_name, write_if_changed
from misstep.grading.publish.shared_answers import find_matches, matches_table


def publish_feedback(out: Path, result: Result) -> None:
    """Write a student's page."""
    write_if_changed(out / "feedback" / f"{file_name(result.student)}.html", feedback_page(result))


def publish(
    out: Path,
    submissions: Sequence[Submission],
    store: ResultStore,
    roster: Roster | None,
    column: str | None,
    *,
    published: Container[str] = (),
) -> list[str]:
    """Write all pages and tables, and return a short summary. Files whose content stays the same are not touched.

    column     the column of the sheet on the platform
    published  the students whose pages are already written
    """
    results = []
    for submission in submissions:
        if result := store.load(submission.student):
            if submission.student not in published:
                publish_feedback(out, result)
            results.append(replace(result, cells=()))  # a thousand results with all pictures would not fit into memory
    if not results:
        return ["Nothing is graded yet."]
    matches = find_matches(results)
    write_if_changed(out / "grades.csv", grades_table(results))
    write_if_changed(out / "matches.csv", matches_table(matches))
    write_if_changed(out / "report.html", report_page(results, matches))
    if roster and (text := export(roster, results, column)):
        write_if_changed(out / f"{roster.kind}.csv", text)
    statuses = Counter(result.status for result in results)
    counts = ", ".join(f"{count} {status}" for status, count in sorted(statuses.items()))
    present = [result for result in results if result.status != ABSENT]
    mean = format_points(sum(result.points for result in present) / max(len(present), 1))
    suspects = sorted({match.student for match in matches if match.shared_count > 1})
    average = f"{mean} of {format_points(results[0].max)} points on average, of those who submitted something"
    return [
        f"{len(results)} of {len(submissions)} submissions: {counts}. {average}.",
        *([f"Several answers right for one other student (matches.csv): {', '.join(suspects)}."] if suspects else []),
        f"The results are in {out}: open report.html, then grades.csv.",
    ]
