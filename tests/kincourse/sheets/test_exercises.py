"""exercises/ contains what `misstep release` writes from solutions/, and no line of a solution."""

import json
from pathlib import Path

import pytest

from kincourse import find_sheet
from misstep.cli import main

pytest.importorskip("nbgrader", reason="exercises/ is made with nbgrader")

ROOT = Path(__file__).parents[3]
SOURCES = sorted((ROOT / "solutions").glob("*/*.ipynb"))


def test_every_sheet_in_exercises_is_up_to_date(committed):
    assert main(["release", "--check", "--root", str(committed)]) == 0, "run misstep release, and commit what it wrote"


def test_preview_shows_the_right_answer_with_its_worked_solution_and_each_mistake_with_its_card(capsys):
    assert main(["preview", "03.13"]) == 0
    right, *wrong = capsys.readouterr().out.split("\n\nMistake: ")
    assert "Right\n  4 of 4 points.\n  One way to it:" in right
    assert "The drawing: Top view and front view" in right
    assert {"halves swapped", "another point"} <= {one.partition(",")[0] for one in wrong}
    assert not [one for one in wrong if "Re-read: section" not in one]
    assert main(["preview", "03.99"]) == 2
    assert "There is no problem '03.99'. The problems are: 01.1, " in capsys.readouterr().err


def test_preview_shows_a_blank_step_too(capsys):
    assert main(["preview", "05.a"]) == 0
    assert "Problem 05.a: Right" in capsys.readouterr().out


def test_every_problem_has_its_cells_and_its_points_in_the_sheet():
    for source in SOURCES:
        cells = {cell["id"]: cell for cell in json.loads(source.read_text(encoding="utf-8"))["cells"]}
        problems = find_sheet(source.stem).problems
        for k, template in enumerate(problems, start=1):
            check = cells[f"check-{k}"]
            assert f"sheet.show({k})" in "".join(cells[f"show-{k}"]["source"])
            assert cells[f"answer-{k}"]["metadata"]["nbgrader"]["solution"]
            assert f"sheet.check({k}, " in "".join(check["source"])
            # nbgrader asks a person for the points of a text
            scored = cells[f"answer-{k}"] if template.level == "Open" else check
            assert scored["metadata"]["nbgrader"]["points"] == template.points
        assert f"check-{len(problems) + 1}" not in cells


def test_no_line_of_a_solution_is_released():
    for source in SOURCES:
        released = (ROOT / "exercises" / source.relative_to(ROOT / "solutions")).read_text(encoding="utf-8")
        hidden = []
        for cell in json.loads(source.read_text(encoding="utf-8"))["cells"]:
            text = "".join(cell["source"])
            if "### BEGIN SOLUTION" in text:
                hidden += text.split("### BEGIN SOLUTION")[1].split("### END SOLUTION")[0].strip().splitlines()
        assert hidden, source.stem
        assert not [line for line in hidden if len(line.strip()) > 12 and line.strip() in released]
