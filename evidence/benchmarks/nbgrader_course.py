"""A plain nbgrader course for comparison: the same sheet, whose check cells assert that the answer is right.

nbgrader gives a cell its points if it runs without an error. Therefore each check is `assert sheet.check(k, ...).score == 3`,
as an instructor would write it with this course and no grader but nbgrader.
"""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

from submissions import SHEET, as_bytes, problem_of

ROOT = Path(__file__).parents[2]


class Course:
    """An nbgrader course in a new folder, with the released sheet and its submissions."""

    def __init__(self, folder):
        self.folder = Path(folder)
        source = self.folder / "source" / SHEET
        source.mkdir(parents=True)
        notebook = json.loads((ROOT / "solutions" / SHEET / f"{SHEET}.ipynb").read_text("utf-8"))
        (source / f"{SHEET}.ipynb").write_bytes(as_bytes(with_assertions(notebook)))
        self.call("generate_assignment", SHEET, "--create", "--force")

    def hand_in(self, student, notebook):
        """Write a submission into the folder in which nbgrader looks for it."""
        place = self.folder / "submitted" / student / SHEET
        place.mkdir(parents=True)
        (place / f"{SHEET}.ipynb").write_bytes(as_bytes(with_assertions(notebook)))

    def autograde(self):
        """Grade all submissions. nbgrader reports those in which a cell fails as not graded, and goes on."""
        self.call("autograde", SHEET, check=False)

    def call(self, *arguments, check=True):
        """Run a command of nbgrader in the folder of the course."""
        scripts = str(Path(sys.executable).parent)  # nbgrader starts alembic by its name
        paths = {"PATH": f"{scripts}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(ROOT)}
        command = [sys.executable, "-m", "nbgrader", *arguments, "--CourseDirectory.course_id=course"]
        subprocess.run(command, cwd=self.folder, env=os.environ | paths, check=check, capture_output=True)


def with_assertions(notebook):
    """Return the notebook with checks that raise an error if the answer is wrong."""
    cells = [dict(cell) for cell in notebook["cells"]]
    for cell in cells:
        if problem_of(cell, "check"):
            cell["source"] = re.sub(r"^(sheet\.check\(.*\))$", r"assert \1.score == 3", "".join(cell["source"]))
    return {**notebook, "cells": cells}
