"""Publishing: from the book of results to the pages and tables that people open."""

from collections import Counter
from collections.abc import Container, Sequence
from dataclasses import replace
from pathlib import Path

from misstep.grading.collect.gather import Handed
from misstep.grading.collect.roster import Roster
from misstep.grading.judging.result import Result
from misstep.grading.publish.feedback import feedback
from misstep.grading.publish.grades import grades
from misstep.grading.publish.pages import points
from misstep.grading.publish.platform_exports import export
from misstep.grading.publish.report import report
from misstep.grading.publish.result_store import Book, file_name, write
from misstep.grading.publish.shared_answers import matches, matches_table


def publish_page(out: Path, result: Result) -> None:
    """Write a student's page."""
    write(out / "feedback" / f"{file_name(result.student)}.html", feedback(result))


def publish(
    out: Path,
    handed: Sequence[Handed],
    book: Book,
    roster: Roster | None,
    column: str | None,
    *,
    done: Container[str] = (),
) -> list[str]:
    """Write everything that the results tell, and say in a few lines what that is. Nothing is touched that says the same.

    done  the students whose pages were written from what the book holds
    """
    results = []
    for each in handed:
        if result := book.kept(each.student):
            if each.student not in done:
                publish_page(out, result)
            results.append(replace(result, cells=()))  # a thousand of them with all pictures would not fit
    if not results:
        return ["Nothing is graded yet."]
    found = matches(results)
    write(out / "grades.csv", grades(results))
    write(out / "matches.csv", matches_table(found))
    write(out / "report.html", report(results, found))
    if roster and (text := export(roster, results, column)):
        write(out / f"{roster.kind}.csv", text)
    states = Counter(result.status for result in results)
    told = ", ".join(f"{count} {status}" for status, count in sorted(states.items()))
    mean = points(sum(result.points for result in results) / len(results))
    several = sorted({match.student for match in found if match.together > 1})
    return [
        f"{len(results)} of {len(handed)} submissions: {told}. {mean} of {points(results[0].max)} points on average.",
        *([f"Several answers right for one other student (matches.csv): {', '.join(several)}."] if several else []),
        f"All of it is in {out}: open report.html, then grades.csv.",
    ]
