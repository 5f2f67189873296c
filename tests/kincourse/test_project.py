"""The project of lecture 10: right descriptions agree with the log, wrong ones do not, and nothing shown says the answers."""

import re
from itertools import count

import numpy as np
import pytest

from kincourse.lecture_10_one_robot_four_ways.arms import KINDS, draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import CONTACT_M, EFFECTS, effect_of
from kincourse.lecture_10_one_robot_four_ways.project import Project
from kincourse.text.urdf_text import UrdfJoint, serial_urdf
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, inverse
from kinlib.rigid.rpy import roll_pitch_yaw

STUDENTS = [next(s for s in map("student {}".format, count()) if draw_machine(s).name == name) for name, *_ in KINDS]
"""For each kind of machine the first id that has it."""
each_machine = pytest.mark.parametrize("student", STUDENTS, ids=[name for name, *_ in KINDS])


def write_urdf(frames, joints):
    """Write a URDF from frames in {s}: the base, one for each joint with its axis along z, and the tool."""
    steps = inverse(frames[:-1]) @ frames[1:]
    kinds = [*({"P": "prismatic", "R": "revolute"}[letter] for letter in joints), "fixed"]
    limit = ['<limit lower="-9" upper="9" effort="1" velocity="1"/>']
    written = [
        UrdfJoint(
            f"joint_{i}", T[:3, 3], roll_pitch_yaw(T[:3, :3]), kind=kind, further=limit if kind != "fixed" else []
        )
        for i, (T, kind) in enumerate(zip(steps, kinds, strict=True), start=1)
    ]
    return serial_urdf(written, ["base", *(f"link_{i}" for i in range(1, len(joints) + 1)), "tool"])


@each_machine
def test_right_descriptions_agree_with_the_log_and_wrong_ones_are_as_far_off_as_the_tool(student):
    project, machine = Project(student), draw_machine(student)
    S, M, table = machine.chain.screws, machine.chain.home, machine.table
    urdf = write_urdf(machine.file_frames, table.joints)
    right = {"screws": (S, M), "table": table, "urdf": urdf}
    assert project.verify(**right).count("agrees") == 9 + 3
    for wrong in (
        {"screws": (S * ([-1], [1], [1], [1]), M)},
        {"table": table.changed(rows=table.rows + 0.05 * np.eye(4)[[1]])},
        {"urdf": urdf.replace('axis xyz="0 0 1"', 'axis xyz="0 0 -1"', 1)},
    ):
        assert project.verify(**right | wrong).count("agrees") == 5 + 2
    received = project.verify(received=(project.received, M)).splitlines()[1]
    off = project.log.distances_mm(Chain(project.received @ adjoint(M).T, M).fk(project.log.q))
    assert f"{off.max():.0f} mm" in received
    assert sum(np.abs(project.received @ adjoint(M).T - S).max(axis=1) > 1e-3) == 1


def test_what_is_not_written_is_left_out_and_a_missing_joint_is_refused():
    project, chain = Project("ada"), draw_machine("ada").chain
    assert "nothing to verify" in project.verify(screws=(..., ...), table=...)
    with pytest.raises(ValueError, match="must have 4 joints"):
        project.verify(screws=(chain.screws[:3], chain.home))


def test_each_path_has_its_effect_and_no_other():
    student = STUDENTS[1]
    paths, chain = Project(student).paths.values(), draw_machine(student).chain
    effects = [effect_of(chain, path) for path in paths]
    assert sorted(effects) == sorted(EFFECTS)
    (leaves,) = (path for path, effect in zip(paths, effects, strict=True) if effect == "leaves")
    assert np.abs(chain.fk(leaves.q)[:, 2, 3] - leaves.table_m).max() < CONTACT_M  # so the pen alone does not show it


def test_nothing_that_a_student_can_print_says_the_answers():
    """A cell that ends in `received` or `project.paths` shows their repr."""
    project = Project("ada")
    for shown in (project, *project.paths.values()):
        names = set(re.findall(r"(\w+)=", repr(shown))) | {name for name in vars(shown) if not name.startswith("_")}
        assert names <= {"q", "table_m", "log", "paths"}, names


def test_the_drawing_says_in_words_what_the_descriptions_need():
    project, machine = Project("ada"), draw_machine("ada")
    chains = {}
    for letter, steps in re.findall(r"Along (.): (.*?)\.", project.drawing("screws").alt):
        value, values = 0.0, {}
        for step in steps.split(", then "):
            length, names = re.fullmatch(r"(?:(\S+) mm to )?(.*)", step).groups()
            value += float(length or 0)
            values.update(dict.fromkeys(re.split(", | and ", names), value))
        chains[letter] = {name: x - values["{s}"] for name, x in values.items()}
    for i, point in enumerate(machine.points, start=1):
        assert [chains[letter][f"P{i}"] for letter in "xyz"] == pytest.approx(1000 * point, abs=0.6)
