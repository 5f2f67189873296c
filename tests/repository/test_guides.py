"""What the guides tell an instructor or a contributor to write works, and their commands have valid options."""

import argparse
import re
import shlex
import textwrap
from pathlib import Path

import numpy as np
import pytest

import kincourse.lecture_03_poe_space.problems as sheet_03
from kinlib import robots
from misstep.catalog import Course
from misstep.census import census_of
from misstep.grading.command import add_arguments
from misstep.judge import judge

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "site" / "instructors.md").read_text("utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)
PROBLEM, NOTEBOOK, MISTAKE = (text for language, text in BLOCKS if language == "python")
COMMANDS = [line for language, text in BLOCKS if not language for line in text.splitlines()]


@pytest.fixture(params=["original", "with another mistake"])
def sheet(request, monkeypatch):
    """The sheet of the guide, which the course finds like its own sheets."""
    names = {}
    more = PROBLEM.replace("    return", f"    {MISTAKE}    return")
    exec(PROBLEM if request.param == "original" else more, names)
    monkeypatch.setattr(Course, "find_sheet", lambda *_: names["SHEET"])
    monkeypatch.setattr("kincourse.find_sheet", lambda _: names["SHEET"])
    return names["SHEET"]


def test_the_mistake_that_is_added_is_named(sheet, request):
    problem = sheet.problems[0].variant("ada")
    (a, b), (p, q) = problem.given["links"], np.radians(problem.given["degrees"])
    swapped = judge(problem, [b * np.cos(p) + a * np.cos(p + q), b * np.sin(p) + a * np.sin(p + q)])
    assert ("links swapped" in swapped.mistakes) == ("another" in request.node.name)


def test_the_example_accepts_the_right_answer_and_identifies_each_mistake(sheet):
    for number in range(15):
        problem = sheet.problems[0].variant(f"student {number}")
        assert judge(problem, problem.answer.value).state == "right"
        assert len(problem.mutants) > 10
        for wrong in problem.mutants:
            judgement = judge(problem, wrong.value)
            assert judgement.state == "wrong"
            same = {one.names for one in problem.mutants if one.key == wrong.key}  # one mistake, described in two ways
            assert same & set(judgement.findings[0].alternatives)


def test_the_notebook_of_the_example_gets_full_marks(sheet, tmp_path, monkeypatch):
    nbformat = pytest.importorskip("nbformat")
    monkeypatch.chdir(tmp_path)
    exec(NOTEBOOK, {})
    cells = nbformat.read("solutions/11_warm_up/11_warm_up.ipynb", as_version=4).cells
    names = {}
    for cell in cells:
        if cell.cell_type == "code" and not cell.source.startswith("sheet.show"):
            exec(cell.source, names)
    assert names["sheet"].tally().score == sheet.points


def test_every_option_in_the_guide_is_an_option_of_misstep_grade():
    parser = argparse.ArgumentParser(exit_on_error=False)
    add_arguments(parser)
    commands = [shlex.split(line)[2:] for line in COMMANDS if line.startswith("misstep grade")]
    assert len(commands) >= 2
    for arguments in commands:
        parser.parse_args(arguments)
    known = {option for action in parser._actions for option in action.option_strings}
    named = set(re.findall(r"(?<=`)--[a-z-]+", GUIDE))
    assert named <= known
    assert len(named) >= 7


# --- the guides of contributors ---


def run_block(guide, section, namespace):
    """Run the Python block of a section of a guide, and return the names that it defines."""
    text = (ROOT / "guides" / guide).read_text("utf-8").partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    (block,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    defined = dict(namespace)
    exec(textwrap.dedent(block), defined)
    return defined


def test_the_robot_of_the_guide_is_a_robot():
    robot = run_block("library.md", "How to add a robot", vars(robots))["two_link"]()
    assert robot.joint_types == "RR"
    assert "page" in robot.source
    np.testing.assert_allclose(robot.fk([np.pi / 2, 0])[:3, 3], (0, 0.9, 0), atol=1e-15)


def test_the_problem_of_the_guide_is_true_of_what_students_answer():
    template = run_block("lectures.md", "How to add a problem", vars(sheet_03))["revolute_joint"]
    row = census_of(template, [f"student {k}" for k in range(5)])
    assert row.wrong > 5
    assert not row.counts, row.examples
