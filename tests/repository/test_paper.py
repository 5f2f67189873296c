"""The paper in paper/: its numbers are those of the course and of the census, and its references are complete."""

import json
import re
from collections import Counter
from pathlib import Path

from kincourse import find_sheet, sheets

ROOT = Path(__file__).parents[2]
PAPER = (ROOT / "paper" / "paper.md").read_text("utf-8")
CENSUS = json.loads((ROOT / "site" / "census.json").read_text("utf-8"))
COLUMNS = ("full_marks", "misnamed", "false", "coincident")
WORDS = {8: "eight", 9: "nine", 10: "ten", 11: "eleven", 12: "twelve"}


def test_the_size_of_the_course_is_said_as_it_is():
    lectures = len(list((ROOT / "notebooks").glob("[0-9]*.ipynb")))
    problems = sum(len(find_sheet(name).problems) for name in sheets())
    readme = (ROOT / "README.md").read_text("utf-8")
    for text in (PAPER, readme):
        assert re.search(rf"\b{WORDS[lectures]} lecture", text)
        assert re.search(rf"\b{WORDS[len(sheets())]} (exercise )?sheets with {problems}\s+problems", text)


def test_the_evidence_is_that_of_the_census():
    counts = sum((Counter(row["counts"]) for row in CENSUS["problems"]), Counter())
    wrong = sum(row["wrong"] for row in CENSUS["problems"])
    cells = [f"{wrong:,}", *(f"{counts[what]:,}" for what in COLUMNS), f"{counts['unnamed'] / wrong:.1%}"]
    assert f"| {' | '.join(cells)} |".replace("%", " %") in PAPER
    assert f"For {CENSUS['students']} simulated students" in PAPER


def test_each_reference_is_cited_and_each_citation_has_a_reference():
    references = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "paper" / "paper.bib").read_text("utf-8"), re.MULTILINE))
    assert set(re.findall(r"@(\w+)", PAPER.partition("# Summary")[2])) == references


def test_the_paper_has_the_sections_and_the_length_that_the_journal_asks_for():
    headings = re.findall(r"^# (.+)$", PAPER, re.MULTILINE)
    assert {"Summary", "Statement of need", "Learning objectives", "References"} <= set(headings)
    assert 700 < len(PAPER.split()) < 1200
