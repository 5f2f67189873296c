"""Sheets for any robot: complete, solvable, different for each student, and with clear errors for unusual robots."""

import json
from functools import cache
from pathlib import Path

import matplotlib as mpl
import modern_robotics as mr
import nbformat
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from odd_robots import ODD_ROBOTS
from urdf_files import ur5e_urdf

import kinlib as kl
from kincourse import find_sheet, open_sheet
from kincourse.cli import main
from kincourse.new_sheet import new_sheet
from kincourse.robot_sheets.robot_file import dumps, loads
from kincourse.robot_sheets.robot_sheet import PROBLEMS_PER_SHEET, TASK_ORDER, TASKS, robot_sheet, tasks_for
from kincourse.robot_sheets.sampling import random_configuration, random_quarter_turn_configuration
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
each_robot = pytest.mark.parametrize("key", UNUSUAL)


@cache
def tasks_of(key):
    """The tasks that suit a robot. To find them takes a second, so not while the tests are collected."""
    return tasks_for(ODD_ROBOTS[key])


def variants(key, task, students=STUDENTS):
    template = robot_sheet("odd", ODD_ROBOTS[key], [task]).problems[0]
    return [template.variant(student) for student in students]


# --- the tasks ---


@each_robot
def test_every_robot_gets_eight_problems_that_suit_it_and_whose_mistakes_can_be_told_apart(key):
    """A modified row needs two joints, and no DH row can describe a helical joint."""
    tasks, robot = tasks_of(key), ODD_ROBOTS[key]
    assert len(tasks) == PROBLEMS_PER_SHEET >= 8
    is_helical = "H" in robot.joint_types
    unsuited = {"modified_table"} if robot.n == 1 else {"modified_table", "faulty_entry"} if is_helical else set()
    assert not (unsuited | ({"standard_table"} if is_helical else set())) & set(tasks)
    if not unsuited and "axis" not in key:
        assert tasks == list(TASK_ORDER[:PROBLEMS_PER_SHEET])
    for task in tasks:
        for problem in variants(key, task, STUDENTS[:1]):
            assert len([*problem.known_mistakes, *problem.slips]) >= 3
            assert judge(problem, problem.answer.value).fraction == 1.0
            for wrong in problem.mistakes:
                assert judge(problem, wrong.value).mistakes == [wrong.name]


def joint_values(problem):
    slides = ~problem.given["screws" if "screws" in problem.given else "body_screws"][:, :3].any(axis=1)
    typed = problem.given["values"]
    return np.where(slides, typed, np.radians(typed))


@pytest.mark.parametrize("key", ["PUMA", "eight", "gantry", "helical"])
def test_poses_agree_with_modern_robotics(key):
    """FKinSpace, FKinBody and Adjoint of the book's own code, computed from the given values."""
    for problem in variants(key, "where_is_the_tool"):
        expected = mr.FKinSpace(problem.given["home"], problem.given["screws"].T, joint_values(problem))
        np.testing.assert_allclose(problem.answer.value, expected, atol=1e-6)
    for problem in variants(key, "body_form"):
        expected = mr.FKinBody(problem.given["home"], problem.given["body_screws"].T, joint_values(problem))
        np.testing.assert_allclose(problem.answer.value, expected, atol=1e-6)
    for problem in variants(key, "body_screws"):
        expected = (mr.Adjoint(mr.TransInv(problem.given["home"])) @ problem.given["screws"].T).T
        np.testing.assert_allclose(problem.answer.value, expected, atol=1e-9)


@pytest.mark.parametrize("key", ["PUMA", "SCARA", "gantry"])
@pytest.mark.parametrize("task", ["standard_table", "modified_table"])
def test_a_right_table_has_the_given_end_frames_and_the_drawn_zero_configuration(key, task):
    for problem in variants(key, task, STUDENTS[:1]):
        table, given = problem.answer.value, problem.given
        q = np.random.default_rng(1).uniform(-1, 1, table.n)
        np.testing.assert_allclose(table.fk(q), mr.FKinSpace(given["home"], given["screws"].T, q), atol=1e-6)
        np.testing.assert_array_equal(table.base, given["T_s0"])
        np.testing.assert_allclose(given[f"T_s{table.n}"] @ table.tool, given["home"], atol=1e-12)


@pytest.mark.parametrize("key", ["PUMA", "SCARA", "all on one axis"])
def test_a_faulty_table_has_one_wrong_row_and_it_is_that_of_the_answer(key):
    for problem in variants(key, "faulty_entry"):
        frames, rows, convention = (problem.given[name] for name in ("frames", "rows", "convention"))
        links = kl.inverse(frames[:-1]) @ frames[1:]
        wrong = [
            not np.allclose(kl.dh_transform(*row, convention=convention), link, atol=1e-9)
            for row, link in zip(rows, links, strict=True)
        ]
        assert np.flatnonzero(wrong).tolist() == [int(problem.answer.value[0][-1]) - 1]


@pytest.mark.parametrize("task", TASK_ORDER[PROBLEMS_PER_SHEET:])
def test_students_have_different_answers(task):
    """The first eight tasks are on the sheets of test_sheets.py."""
    answers = set()
    for problem in variants("PUMA", task, [f"s{i}" for i in range(6)]):
        answers.add(np.round(problem.answer.value, 6).tobytes())
    assert len(answers) > 3


angles = st.floats(-1e3, 1e3, allow_subnormal=False).filter(lambda x: abs(x) < 60 or x % 1)  # others look like degrees
limits = st.lists(angles, min_size=2, max_size=2).map(sorted)


@given(st.tuples(limits, limits, limits), st.integers(0, 99))
def test_random_configurations_keep_the_joint_limits(ends, student):
    arm = kl.robots.rpr()
    limited = kl.Chain(arm.screws, arm.home, arm.points, limits=np.array(ends))
    for draw in (random_configuration, random_quarter_turn_configuration):
        q = draw(ArmSampler(str(student), "limits"), limited).q
        slack = 1e-9 * (1 + np.abs(limited.limits).max())
        assert (limited.limits[:, 0] - slack <= q).all()
        assert (q <= limited.limits[:, 1] + slack).all()


def test_a_rounded_quarter_turn_of_a_urdf_leaves_no_tiny_numbers_in_statements():
    """Many files write pi / 2 as 1.5708, which leaves entries such as 3.7e-06 in screws and poses."""
    arm = kl.load_urdf(kl.to_urdf(ODD_ROBOTS["PUMA"]).replace('xyz="0 1 0"', 'xyz="0 1 0.0000037"'))
    assert np.abs(arm.screws[arm.screws != 0]).min() < 1e-5
    for task in TASK_ORDER:
        assert "e-0" not in robot_sheet("arm", arm, [task]).problems[0].variant("ada").statement


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


@pytest.mark.parametrize("key", ["SCARA", "one slide", "helical"])
def test_the_instructors_copy_scores_full_points(key, project, monkeypatch):
    path = new_sheet(ODD_ROBOTS[key], project / "solutions" / "odd_robot")
    monkeypatch.chdir(path.parent)
    sheet = solved(path.parent, "ada")
    assert sheet.tally().score == sheet.sheet.points


def test_the_students_copy_runs_in_its_folder_and_contains_no_solution(project, monkeypatch):
    """A student gets the notebook and the file of the robot, and has the course installed."""
    pytest.importorskip("nbgrader", reason="exercises/ is made with nbgrader")
    from misstep.release import student_notebook

    (project / "ur5e.urdf").write_text(ur5e_urdf(), "utf-8")
    assert main(["new-sheet", "ur5e.urdf", "--out", "solutions/lab_arm", "--name", "UR5e"]) == 0
    assert release(["release"]) == 0
    assert student_notebook.find_stale(project) == []
    folder = project / "exercises" / "lab_arm"
    assert {path.name for path in folder.iterdir()} == {"lab_arm.ipynb", "lab_arm.json"}
    text = (folder / "lab_arm.ipynb").read_text("utf-8")
    assert "BEGIN SOLUTION" not in text
    tasks = loads((folder / "lab_arm.json").read_text("utf-8"), "here")[1]
    assert tasks == list(TASK_ORDER[:PROBLEMS_PER_SHEET])
    for task in tasks:
        for line in TASKS[task].entry.solution.splitlines():
            assert len(line.strip()) < 13 or line.strip() not in text
    nbformat.validate(nbformat.reads(text, as_version=4))
    monkeypatch.chdir(folder)
    assert solved(folder, "ada").tally()._repr_markdown_().count("nothing here yet") == PROBLEMS_PER_SHEET


def test_a_sheet_is_found_beside_the_notebook_and_below_the_root_and_replaces_no_other(project, monkeypatch):
    path = new_sheet(ODD_ROBOTS["one slide"], "solutions/lab_arm", name="**arm** $x$ | <b>")
    assert loads(path.with_suffix(".json").read_text("utf-8"), "here")[0].name == "arm x  b", "without Markdown"
    from_root = open_sheet("lab_arm", "ada").problem(1).statement
    monkeypatch.chdir("solutions/lab_arm")
    assert open_sheet("lab_arm", "ada").problem(1).statement == from_root
    Path("03_poe_space.json").write_text(dumps(ODD_ROBOTS["PUMA"], TASK_ORDER[:PROBLEMS_PER_SHEET]), "utf-8")
    assert find_sheet("03_poe_space").title == "The product of exponentials in the space frame"
    Path("inside").mkdir()
    monkeypatch.chdir("inside")
    with pytest.raises(ValueError, match="no sheet"):
        find_sheet("../lab_arm")
    with pytest.raises(ValueError, match=r"no sheet 'lab_arm'.*needs its file lab_arm.json beside the notebook"):
        open_sheet("lab_arm", "ada")
    with pytest.raises(ValueError, match="letters"):
        new_sheet(ODD_ROBOTS["PUMA"], "03_poe_space")


# --- the file of the robot ---


@each_robot
def test_a_robot_and_its_tasks_are_read_back_from_its_file_to_the_last_digit(key):
    text = dumps(ODD_ROBOTS[key], tasks_of(key))
    robot, tasks = loads(text, "here")
    assert (robot.to_dict(), tasks) == (ODD_ROBOTS[key].to_dict(), tasks_of(key))


def test_a_damaged_file_is_refused():
    puma = dumps(ODD_ROBOTS["PUMA"], [])
    for text, words in [
        ("", "not a valid file"),
        ("[]", "not a valid file"),
        ("{}", "not a valid file"),
        ('{"kinlib sheet": 2}', "format is 2"),
        (puma.replace("[0.0, 0.0, 1.0, ", "[0.0, 0.5, 1.0, ", 1), "screw axes"),
        (puma.replace('"screws"', '"axes"'), "screws"),
    ]:
        with pytest.raises(ValueError, match=words) as error:
            loads(text, "robot.json")
        assert "robot.json is not a valid file of a robot sheet" in str(error.value)
    with pytest.raises(ValueError, match=r"no task 'dance'.*newer kincourse"):
        robot_sheet("x", ODD_ROBOTS["PUMA"], ["dance"])


# --- invalid requests ---

NOTHING_MOVES = """<robot name="statue"><link name="a"/><link name="b"/>
<joint name="weld" type="fixed"><parent link="a"/><child link="b"/></joint></robot>"""


@pytest.fixture
def urdf(project):
    Path("lift.urdf").write_text(kl.to_urdf(ODD_ROBOTS["one slide"]), "utf-8")
    Path("statue.urdf").write_text(NOTHING_MOVES, "utf-8")
    Path("torn.urdf").write_text(NOTHING_MOVES[:60], "utf-8")
    Path("mine").write_text("mine", "utf-8")
    Path("full").mkdir()
    Path("full", "notes.txt").write_text("mine", "utf-8")
    return project


def test_an_invalid_request_is_refused_in_one_sentence_and_force_keeps_other_files(urdf, capsys):
    for arguments, words in [
        (["nowhere.urdf", "--out", "arm"], "nowhere.urdf"),
        (["torn.urdf", "--out", "arm"], "torn.urdf"),
        (["statue.urdf", "--out", "arm"], "statue.urdf"),
        (["lift.urdf", "--out", "arm", "--tip", "nose"], "nose"),
        (["lift.urdf", "--out", "full"], "must be empty"),
        (["lift.urdf", "--out", "mine"], "is a file"),
        (["lift.urdf", "--out", "lift.urdf"], "letters, digits and _"),
        (["lift.urdf", "--out", "my robot"], "letters, digits and _"),
        (["lift.urdf", "--out", "1st"], "letters, digits and _"),
    ]:
        assert main(["new-sheet", *arguments]) == 2
        error = capsys.readouterr().err
        assert words in error
        assert error.startswith("kincourse new-sheet: ")
        assert "Traceback" not in error
    assert not Path("arm").exists()
    assert Path("mine").read_text("utf-8") == "mine"
    assert main(["new-sheet", "lift.urdf", "--out", "full", "--force"]) == 0
    assert Path("full", "full.ipynb").exists()
    assert Path("full", "notes.txt").read_text("utf-8") == "mine"
