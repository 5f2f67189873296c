"""The instructors' guide: its example is a sheet, and its commands are what the programs take."""

import argparse
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from misstep.catalog import Course
from misstep.judge import judge

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "site" / "instructors.md").read_text("utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)
PROBLEM, NOTEBOOK, MISTAKE = (text for language, text in BLOCKS if language == "python")
COMMANDS = [line for language, text in BLOCKS if not language for line in text.splitlines()]


@pytest.fixture(params=["as it is", "with one mistake more"])
def sheet(request, monkeypatch):
    """The sheet of the guide, found as if its module were among the others."""
    names = {}
    more = PROBLEM.replace("    return", f"    {MISTAKE}    return").replace("mistakes=[", "mistakes=[exchanged, ")
    exec(PROBLEM if request.param == "as it is" else more, names)
    monkeypatch.setattr(Course, "find_sheet", lambda *_: names["SHEET"])
    return names["SHEET"]


def test_the_example_is_complete_in_less_than_30_lines():
    assert len(PROBLEM.splitlines()) < 30


@pytest.mark.parametrize("student", [f"student {number}" for number in range(40)])
def test_the_example_knows_what_is_right_and_names_each_mistake(sheet, student):
    problem = sheet.problems[0].variant(student)
    assert judge(problem, problem.answer.value).state == "right"
    assert len(problem.mistakes) in {3, 4}
    for wrong in problem.mistakes:
        told = judge(problem, wrong.value)
        assert (told.state, told.mistakes) == ("wrong", [wrong.name])


def test_the_notebook_of_the_example_solves_it(sheet, tmp_path, monkeypatch):
    nbformat = pytest.importorskip("nbformat")
    monkeypatch.chdir(tmp_path)
    exec(NOTEBOOK, {})
    cells = nbformat.read("solutions/11_warm_up/11_warm_up.ipynb", as_version=4).cells
    names = {}
    for cell in cells:
        if cell.cell_type == "code" and not cell.source.startswith("sheet.show"):
            exec(cell.source, names)
    assert names["sheet"].tally().score == sheet.points


@pytest.mark.skipif(sys.platform != "linux", reason="grading is made of Linux")
def test_the_guide_gives_kinlib_no_option_that_it_does_not_take():
    from misstep.grading.command import add_arguments

    parser = argparse.ArgumentParser(exit_on_error=False)
    add_arguments(parser)
    graded = [shlex.split(line)[2:] for line in COMMANDS if line.startswith("misstep grade")]
    assert len(graded) == 2
    for words in graded:
        sheet = parser.parse_args(words).sheet
        assert (ROOT / sheet).is_file()
    taken = {option for action in parser._actions for option in action.option_strings}
    named = set(re.findall(r"(?<=`)--[a-z-]+", GUIDE))
    assert named <= taken
    assert len(named) >= 7


def test_the_handout_that_the_guide_names_is_there():
    assert "misstep release" in COMMANDS
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    told = subprocess.run(
        [sys.executable, "-m", "misstep", "--help"], env=environment, capture_output=True, text=True, check=True
    )
    assert "grade" in told.stdout
