"""nbgrader: its own commands make the sheet and hand it out, and `misstep grade --gradebook` is the one path to points."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from submissions import NAME, ROOT, SHEET, answered, write

from misstep.cli import main

nbgrader = pytest.importorskip("nbgrader.api")


def run(course, *command):
    """Run a command of nbgrader, which starts `alembic` from the same environment."""
    paths = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    words = [sys.executable, "-m", "nbgrader", *command]
    return subprocess.run(words, cwd=course, env=paths, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """The course as the repository has it, with one sheet generated, and what two students handed in."""
    folder = tmp_path_factory.mktemp("course")
    shutil.copy(ROOT / "nbgrader_config.py", folder)
    for top in ("solutions", "exercises"):
        shutil.copytree(ROOT / top / SHEET, folder / top / SHEET)
    made = run(folder, "generate_assignment", SHEET, "--force")
    assert made.returncode == 0, made.stderr
    assert (folder / "exercises" / SHEET / NAME).read_bytes() == (ROOT / "exercises" / SHEET / NAME).read_bytes()
    people = {"ada": answered("ada", text=True), "bob": answered("bob", wrong=[9])}
    return write(folder, **{f"submitted/{name}/{SHEET}/{NAME}": one for name, one in people.items()})


def gradebook(course):
    return nbgrader.Gradebook(f"sqlite:///{course}/gradebook.db")


def scores(course):
    with gradebook(course) as book:
        return {one.student.id: one.score for one in book.assignment_submissions(SHEET)}


def grade(course):
    out, submitted = str(course / "out"), str(course / "submitted")
    return main(["grade", submitted, "--sheet", "01", "--out", out, "--workers", "1", "--gradebook", str(course)])


def test_points_are_in_the_gradebook_and_a_grade_by_hand_stays(course):
    assert grade(course) == 1  # a text waits for its points
    assert scores(course) == {"ada": 22, "bob": 19}
    with gradebook(course) as book:
        assert book.find_grade("answer-11", SHEET, SHEET, "ada").needs_manual_grade
        grade_cell = book.find_grade("check-9", SHEET, SHEET, "bob")
        grade_cell.manual_score = 1.5
        book.db.commit()
    assert grade(course) == 1
    assert scores(course) == {"ada": 22, "bob": 20.5}


def test_autograde_gives_no_points_and_says_what_to_do(course):
    refused = run(course, "autograde", SHEET, "--student", "ada")
    assert refused.returncode != 0
    assert "misstep grade submitted --sheet NAME --out results --gradebook ." in refused.stderr + refused.stdout
