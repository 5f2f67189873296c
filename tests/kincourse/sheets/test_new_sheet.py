"""Sheets for any robot: complete, solvable, different for each student, and with clear errors for unusual robots."""

import json
from pathlib import Path

import matplotlib as mpl
import modern_robotics as mr
import nbformat
import numpy as np
import pytest
from odd_robots import ODD_ROBOTS
from urdf_files import ur5e_urdf

import kinlib as kl
from kincourse import find_sheet, open_sheet
from kincourse.__main__ import main
from kincourse.new_sheet import new_sheet
from kincourse.robot_sheets.robot_sheet import dumps, loads, robot_sheet
from kincourse.sampling.arms import ArmSampler
from misstep.cli import main as release
from misstep.judge import judge

STUDENTS = [f"student {i}" for i in range(2)]

UNUSUAL = (
    "one turn",
    "one slide",
    "turn and slide on one axis",
    "all on one axis",
    "helical",
    "in millimetres",
    "narrow",
)


def variants(key, title, students=STUDENTS):
    (template,) = (one for one in robot_sheet("odd", ODD_ROBOTS[key]).problems if one.title == title)
    return [template.variant(student) for student in students]


# --- the tasks ---


@pytest.mark.parametrize("key", UNUSUAL)
def test_every_robot_gets_the_problems_that_suit_it_and_whose_mistakes_can_be_told_apart(key):
    """Rows of a table need two joints, and no DH row can describe a helical joint."""
    robot, sheet = ODD_ROBOTS[key], robot_sheet("odd", ODD_ROBOTS[key])
    assert len(sheet.problems) == (6 if robot.n > 1 and "H" not in robot.joint_types else 4)
    for template in sheet.problems:
        problem = template.variant("ada")
        assert len([*problem.known_mistakes, *problem.slips]) >= 3
        assert judge(problem, problem.answer.value).fraction == 1.0
        for wrong in problem.mistakes:
            assert judge(problem, wrong.value).mistakes == [wrong.name]


@pytest.mark.parametrize("key", ["eight", "gantry", "helical"])
def test_poses_agree_with_modern_robotics(key):
    """FKinSpace and Adjoint of the book's own code, computed from the given values."""
    for problem in variants(key, "Where is the tool?"):
        screws, typed = problem.given["screws"], problem.given["values"]
        q = np.where(screws[:, :3].any(axis=1), np.radians(typed), typed)
        expected = mr.FKinSpace(problem.given["home"], screws.T, q)
        np.testing.assert_allclose(problem.answer.value, expected, atol=1e-6)
    for problem in variants(key, "The same axes in the tool frame"):
        expected = (mr.Adjoint(mr.TransInv(problem.given["home"])) @ problem.given["screws"].T).T
        np.testing.assert_allclose(problem.answer.value, expected, atol=1e-9)


@pytest.mark.parametrize("key", ["SCARA", "gantry"])
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_right_table_has_the_given_end_frames_and_the_drawn_zero_configuration(key, convention):
    for problem in variants(key, f"A table in the {convention} convention", STUDENTS[:1]):
        table, given = problem.answer.value, problem.given
        q = np.random.default_rng(1).uniform(-1, 1, table.n)
        np.testing.assert_allclose(table.fk(q), mr.FKinSpace(given["home"], given["screws"].T, q), atol=1e-6)
        np.testing.assert_array_equal(table.base, given["T_s0"])
        np.testing.assert_allclose(given[f"T_s{table.n}"] @ table.tool, given["home"], atol=1e-12)


def test_a_rounded_quarter_turn_of_a_urdf_leaves_no_tiny_numbers_in_statements():
    """Many files write pi / 2 as 1.5708, which leaves entries such as 3.7e-06 in screws and poses."""
    arm = kl.load_urdf(kl.to_urdf(ODD_ROBOTS["PUMA"]).replace('xyz="0 1 0"', 'xyz="0 1 0.0000037"'))
    assert np.abs(arm.screws[arm.screws != 0]).min() < 1e-5
    for template in robot_sheet("arm", arm).problems:
        assert "e-0" not in template.make_problem(ArmSampler("ada", "arm")).statement


# --- the folder of a sheet ---


def solved(folder, student):
    """Run the code cells of a sheet in an empty namespace, as a kernel in its folder would, and return the open sheet."""
    namespace = {"display": lambda *_: None}
    notebook = json.loads((folder / f"{folder.name}.ipynb").read_text("utf-8"))
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]).replace('"your id"', repr(student)), namespace)
    return namespace["sheet"]


@pytest.fixture
def project(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    mpl.use("agg")
    return tmp_path


@pytest.mark.parametrize("key", ["SCARA", "helical"])
def test_the_instructors_copy_scores_full_points(key, project, monkeypatch):
    path = new_sheet(ODD_ROBOTS[key], project / "solutions" / "odd_robot")
    monkeypatch.chdir(path.parent)
    sheet = solved(path.parent, "ada")
    assert sheet.tally().score == sheet.sheet.points


def test_the_students_copy_runs_in_its_folder_and_contains_no_solution(project, monkeypatch):
    """A student gets the notebook and the file of the robot, and has the course installed."""
    pytest.importorskip("nbgrader", reason="exercises/ is made with nbgrader")
    assert release(["release"]) == 2, "there is no folder with solutions"
    (project / "ur5e.urdf").write_text(ur5e_urdf(), "utf-8")
    assert main(["new-sheet", "ur5e.urdf", "--out", "solutions/lab_arm", "--name", "UR5e"]) == 0
    assert [release(["release", *more]) for more in (["--check"], [], ["--check"])] == [1, 0, 0]
    folder = project / "exercises" / "lab_arm"
    assert {path.name for path in folder.iterdir()} == {"lab_arm.ipynb", "lab_arm.json"}
    text = (folder / "lab_arm.ipynb").read_text("utf-8")
    assert "BEGIN SOLUTION" not in text
    nbformat.validate(nbformat.reads(text, as_version=4))
    monkeypatch.chdir(folder)
    assert solved(folder, "ada").tally()._repr_markdown_().count("nothing here yet") == 6


def test_a_sheet_is_found_beside_the_notebook_and_below_the_root_and_replaces_no_other(project, monkeypatch):
    path = new_sheet(ODD_ROBOTS["one slide"], "solutions/lab_arm", name="**arm** $x$ | <b>")
    assert loads(path.with_suffix(".json").read_text("utf-8"), "here").name == "arm x  b", "without Markdown"
    from_root = open_sheet("lab_arm", "ada").problem(1).statement
    monkeypatch.chdir("solutions/lab_arm")
    assert open_sheet("lab_arm", "ada").problem(1).statement == from_root
    Path("03_poe_space.json").write_text(dumps(ODD_ROBOTS["PUMA"]), "utf-8")
    assert find_sheet("03_poe_space").title == "The product of exponentials in the space frame"
    Path("inside").mkdir()
    monkeypatch.chdir("inside")
    with pytest.raises(ValueError, match="no sheet"):
        find_sheet("../lab_arm")
    with pytest.raises(ValueError, match=r"no sheet 'lab_arm'.*needs its file lab_arm.json beside the notebook"):
        open_sheet("lab_arm", "ada")
    with pytest.raises(ValueError, match="letters"):
        new_sheet(ODD_ROBOTS["PUMA"], "03_poe_space")


@pytest.mark.usefixtures("project")
def test_an_invalid_request_is_refused_in_one_sentence_and_force_keeps_other_files(capsys):
    Path("lift.urdf").write_text(kl.to_urdf(ODD_ROBOTS["one slide"]), "utf-8")
    Path("torn.urdf").write_text("<robot", "utf-8")
    Path("full").mkdir()
    Path("full", "notes.txt").write_text("mine", "utf-8")
    for arguments, words in [
        (["nowhere.urdf", "--out", "arm"], "nowhere.urdf"),
        (["torn.urdf", "--out", "arm"], "torn.urdf"),
        (["lift.urdf", "--out", "arm", "--tip", "nose"], "nose"),
        (["lift.urdf", "--out", "full"], "must be empty"),
        (["lift.urdf", "--out", "my robot"], "letters, digits and _"),
    ]:
        assert main(["new-sheet", *arguments]) == 2
        error = capsys.readouterr().err
        assert words in error
        assert error.startswith("kincourse new-sheet: ")
        assert "Traceback" not in error
    assert not Path("arm").exists()
    assert main(["new-sheet", "lift.urdf", "--out", "full", "--force"]) == 0
    assert Path("full", "full.ipynb").exists()
    assert Path("full", "notes.txt").read_text("utf-8") == "mine"
