"""A plain nbgrader course for comparison: the same sheet, whose check cells assert that the answer is right.

nbgrader gives a cell its points if it runs without an error. Therefore each check is `assert sheet.check(k, ...).score == 3`,
as an instructor would write it with this course and no grader but nbgrader.
"""

import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

from submissions import SHEET, as_bytes, problem_of

ROOT = Path(__file__).parents[2]

CONFIG = """
c = get_config()
c.CourseDirectory.course_id = "course"
c.CourseDirectory.root = {root!r}
c.Execute.timeout = {timeout}
c.Execute.error_on_timeout = {{}}
c.Application.log_level = 40
"""


class Course:
    """An nbgrader course in an empty folder, with the released sheet and its submissions."""

    def __init__(self, folder, timeout=10, is_asserting=True):
        self.folder = Path(folder)
        self.folder.mkdir(exist_ok=True)
        (self.folder / "nbgrader_config.py").write_text(CONFIG.format(root=str(self.folder), timeout=timeout))
        source = self.folder / "source" / SHEET
        source.mkdir(parents=True)
        notebook = json.loads((ROOT / "solutions" / SHEET / f"{SHEET}.ipynb").read_text("utf-8"))
        (source / f"{SHEET}.ipynb").write_bytes(as_bytes(with_assertions(notebook) if is_asserting else notebook))
        self.call("generate_assignment", SHEET, "--create", "--force")

    def hand_in(self, student, notebook):
        """Write a submission into the folder in which nbgrader looks for it."""
        place = self.folder / "submitted" / student / SHEET
        place.mkdir(parents=True)
        (place / f"{SHEET}.ipynb").write_bytes(as_bytes(with_assertions(notebook)))

    def autograde(self, *options):
        """Grade all submissions, and return the seconds."""
        start = time.perf_counter()
        self.call("autograde", SHEET, *options, check=False)
        return time.perf_counter() - start

    def scores(self):
        """Return the points of each student with a grade."""
        from nbgrader.api import Gradebook

        with Gradebook(f"sqlite:///{self.folder / 'gradebook.db'}") as book:
            return {submission.student.id: submission.score for submission in book.assignment_submissions(SHEET)}

    def call(self, *arguments, check=True):
        scripts = str(Path(sys.executable).parent)  # nbgrader starts alembic by its name
        paths = {"PATH": f"{scripts}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(ROOT)}
        command = [sys.executable, "-m", "nbgrader", *arguments]
        return subprocess.run(
            command, cwd=self.folder, env=os.environ | paths, check=check, capture_output=True, text=True
        )


def with_assertions(notebook):
    """Return the notebook with checks that raise an error if the answer is wrong."""
    cells = [dict(cell) for cell in notebook["cells"]]
    for cell in cells:
        if problem_of(cell, "check"):
            cell["source"] = re.sub(r"^(sheet\.check\(.*\))$", r"assert \1.score == 3", "".join(cell["source"]))
    return {**notebook, "cells": cells}
