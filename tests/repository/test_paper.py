"""What a reader or a reviewer sees first: the paper, its checklist, the READMEs. Their numbers, links and names are right."""

import json
import re
import tomllib
from collections import Counter
from pathlib import Path

import pytest

from evidence.outside.right import read_from_a_drawing

ROOT = Path(__file__).parents[2]
PAPER = (ROOT / "paper" / "paper.md").read_text("utf-8")
CENSUS = json.loads((ROOT / "site" / "census.json").read_text("utf-8"))
OUTSIDE = sum((Counter(row) for row in CENSUS["outside"]["problems"].values()), Counter())


def table_row(wrong, students, full_marks, false, unnamed):
    cells = [f"{wrong:,}", f"{students}", f"{full_marks:,}", false, unnamed]
    return f"| {' | '.join(cells)} |"


def share(count, wrong):
    return f"{count / wrong:.1%}".replace("%", " %") if count else "0"


def test_the_evidence_is_that_of_the_census():
    counts = sum((Counter(row["counts"]) for row in CENSUS["problems"]), Counter())
    assert not counts["full_marks"] + counts["false"] + counts["misnamed"]  # so that the row of the engine says 0
    engine = sum(row["wrong"] for row in CENSUS["problems"])
    students = CENSUS["students"]
    row = table_row(engine, students, 0, "0", share(counts["unnamed"], engine))
    assert f"| made by the engine itself, which only tests it {row}" in PAPER
    shares = (share(OUTSIDE[what], OUTSIDE["wrong"]) for what in ("false", "unnamed"))
    row = table_row(OUTSIDE["wrong"], CENSUS["outside"]["students"], OUTSIDE["full marks"], *shares)
    assert f"| from outside, by code that shares none with the engine {row}" in PAPER
    drawn = [number for number in read_from_a_drawing if number in CENSUS["outside"]["problems"]]
    assert (
        f"For {len(drawn)} of {len(CENSUS['outside']['problems'])} problems, whose answer stands in a drawing" in PAPER
    )
    assert f"For {students} simulated students" in PAPER


def test_each_reference_is_cited_and_each_citation_has_a_reference():
    references = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "paper" / "paper.bib").read_text("utf-8"), re.MULTILINE))
    assert set(re.findall(r"@(\w+)", PAPER.partition("# Summary")[2])) == references


def test_each_point_of_the_checklist_names_a_file_that_exists():
    text = (ROOT / "paper" / "CHECKLIST.md").read_text("utf-8")
    points = [
        line
        for line in text.splitlines()
        if line.startswith("| ") and not line.startswith(("| **", "| ---", "| point"))
    ]
    assert len(points) > 20
    for point in points:
        files = re.findall(r"\]\(([^)#]+)", point)
        assert files, point
        assert [file for file in files if not (ROOT / "paper" / file).is_file()] == []
    sections = set(re.findall(r"^#+ (.+)$", "".join(path.read_text("utf-8") for path in GUIDES), re.MULTILINE))
    assert [name for name in re.findall(r"section \*(.+?)\*", text) if name not in sections] == []


GUIDES = [ROOT / "README.md", ROOT / "site" / "instructors.md", ROOT / "paper" / "paper.md"]


def test_the_authors_are_those_of_the_citation_everywhere():
    (author,) = re.findall(r"^authors:\n  - name: (.+)$", (ROOT / "CITATION.cff").read_text("utf-8"), re.MULTILINE)
    for file in ("pyproject.toml", "kinlib/pyproject.toml", "misstep/pyproject.toml", "kincourse/pyproject.toml"):
        assert tomllib.loads((ROOT / file).read_text("utf-8"))["project"]["authors"] == [{"name": author}]
    assert f"\n  - name: {author}\n" in PAPER
    assert f'\nauthor = "{author}"\n' in (ROOT / "site" / "conf.py").read_text("utf-8")


def test_the_readme_shows_a_mistake_and_two_commands_first_and_links_to_the_site_if_there_is_one():
    text = (ROOT / "README.md").read_text("utf-8")
    first = text.partition("\n## ")[0]
    assert first.index("](site/readme.png)") < first.index("\npython course.py open\npython course.py test\n")
    site = tomllib.loads((ROOT / "site" / "settings.toml").read_text("utf-8"))["site"]
    assert f"**Live site:** {site or 'not published yet'}" in first


@pytest.mark.parametrize("package", ["kinlib", "misstep", "kincourse"])
def test_the_readme_of_a_package_has_no_link_that_a_package_index_cannot_follow(package):
    """An index shows the README alone: a path of the repository leads nowhere there."""
    text = (ROOT / package / "README.md").read_text("utf-8")
    targets = re.findall(r"\]\(([^)]+)\)|(?:src|href)=\"([^\"]+)", text)
    assert [target for pair in targets for target in pair if target and not target.startswith("https://")] == []
