"""The project of lecture 10: a planted fault is found and named, and no description passes that was computed from another."""

import re
from functools import reduce
from itertools import count

import numpy as np
import pytest

from kincourse.lecture_10_one_robot_four_ways.arms import KINDS, draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import CONTACT_M, EFFECTS, effect_of
from kincourse.lecture_10_one_robot_four_ways.project import Project
from kincourse.text.urdf_text import UrdfJoint, serial_urdf
from kinlib.chains.robots import pose
from kinlib.dh.assignment import assign_frames
from kinlib.rigid.lie import adjoint, exp, inverse
from kinlib.rigid.rpy import roll_pitch_yaw
from kinlib.urdf.chains import load_urdf, to_urdf


def student_with(machine):
    """The first id whose machine is of this kind."""
    return next(student for student in map("student {}".format, count()) if draw_machine(student).name == machine)


STUDENTS = [student_with(kind.name) for kind in KINDS]
each_machine = pytest.mark.parametrize("student", STUDENTS, ids=[kind.name for kind in KINDS])


def write_urdf(frames, joints, limits):
    """Write a URDF from frames in {s}: the base, one for each joint with its axis along z, and the tool."""
    steps = inverse(frames[:-1]) @ frames[1:]
    kinds = [{"P": "prismatic", "R": "revolute"}[letter] for letter in joints]
    further = [[f'<limit lower="{low:.4f}" upper="{high:.4f}" effort="1" velocity="1"/>'] for low, high in limits]
    written = [
        UrdfJoint(f"joint_{i}", step[:3, 3], roll_pitch_yaw(step[:3, :3]), kind=kind, further=limit)
        for i, (step, kind, limit) in enumerate(zip(steps, [*kinds, "fixed"], [*further, []], strict=True), start=1)
    ]
    return serial_urdf(written, ["base", *(f"link_{i}" for i in range(1, len(joints) + 1)), "tool"])


def descriptions(student):
    """The right descriptions of a student's machine."""
    right = draw_machine(student)
    urdf = write_urdf(right.file_frames, right.table.joints, right.limits)
    return {"screws": (right.chain.screws, right.chain.home, right.points), "table": right.table, "urdf": urdf}


@each_machine
def test_right_descriptions_agree_with_the_log_and_with_each_other(student):
    project = Project(student)
    result = project.verify(**descriptions(student))
    assert result.passed, str(result)
    assert str(result).count("agrees") == 9 + 3


def planted_in_screws(right):
    S, M, points = right["screws"]
    for i in range(len(S)):
        for wrong in (-S[i], S[i] - 0.03 * np.roll(np.eye(6)[3 + int(np.argmax(np.abs(S[i, :3] + S[i, 3:])))], 1)):
            if np.allclose(wrong[:3], S[i, :3]) and not S[i, :3].any():
                continue  # the length of a prismatic screw is its direction
            yield f"joint {i + 1}", (np.array([*S[:i], wrong, *S[i + 1 :]]), M, points)
    yield "M", (S, M @ pose(np.eye(3), (0.02, 0, 0)), points)


def planted_in_table(right):
    table = right["table"]
    for i in range(table.n):
        for column, change in ((0, 0.04), (1, np.pi), (2, -0.03), (3, np.pi / 2)):
            rows = table.rows.copy()
            rows[i, column] += change
            yield f"row {i + 1}", table.changed(rows=rows)


def planted_in_urdf(right):
    origins = list(re.finditer(r'<origin xyz="(.*?)"', right["urdf"]))
    for i, found in enumerate(origins):
        xyz = np.array(found[1].split(), dtype=float)
        xyz[i % 3] += 0.04
        text = f'<origin xyz="{" ".join(map(str, xyz))}"'
        place = f"joint {i + 1}" if i < len(origins) - 1 else "the tool"
        yield place, right["urdf"][: found.start()] + text + right["urdf"][found.end() :]
    for i, found in enumerate(re.finditer('axis xyz="0 0 1"', right["urdf"])):
        yield f"joint {i + 1}", right["urdf"][: found.start()] + 'axis xyz="0 0 -1"' + right["urdf"][found.end() :]


@pytest.mark.parametrize(("name", "student"), [*zip(("screws", "table", "urdf"), STUDENTS, strict=False)])
def test_a_planted_fault_is_found_and_named_at_its_joint(name, student):
    project, right = Project(student), descriptions(student)
    faults = {"screws": planted_in_screws, "table": planted_in_table, "urdf": planted_in_urdf}[name](right)
    shown = "URDF" if name == "urdf" else name
    for place, wrong in faults:
        result = project.verify(**{**right, name: wrong})
        assert not result.passed
        assert [finding.name for finding in result.findings if not finding.agrees] == [shown], (place, str(result))
        assert result[shown].place == place, (place, str(result))
        own = project.log.distances_mm(product_poses(name, wrong, project.log.q))
        assert result[shown].worst_mm == pytest.approx(own.max())


def product_poses(name, description, q):
    """The forward kinematics of the library, which does not use the products that are verified."""
    if name == "screws":
        S, M, _ = description
        return np.array([reduce(np.matmul, [*exp(S * values[:, None]), M]) for values in q])
    return description.fk(q) if name == "table" else load_urdf(description).fk(q)


def test_two_faults_are_not_blamed_on_one_joint():
    student = STUDENTS[0]
    project, right = Project(student), descriptions(student)
    rows = right["table"].rows.copy()
    rows[0, 0], rows[3, 2] = rows[0, 0] + 0.05, rows[3, 2] - 0.06
    rows[1, 1] += 0.4
    finding = project.verify(**{**right, "table": right["table"].changed(rows=rows)})["table"]
    assert not finding.agrees
    assert not finding.places
    assert "more than one is wrong" in str(finding)


def test_no_description_passes_that_is_computed_from_another():
    student = STUDENTS[0]
    project, right = Project(student), descriptions(student)
    from_screws, from_file, from_table = (
        draw_machine(student).chain,
        load_urdf(right["urdf"]),
        right["table"].to_chain(),
    )
    for chain in (from_screws, from_file, from_table):
        for name, computed in {
            "screws": (chain.screws, chain.home, chain.joint_points),
            "table": assign_frames(chain, convention="standard").table,
            "urdf": to_urdf(chain),
        }.items():
            if name == "screws" and chain is from_screws:
                continue  # they are what the student wrote
            result = project.verify(**{**right, name: computed})
            finding = result["URDF" if name == "urdf" else name]
            assert finding.agrees, str(result)
            assert finding.off_mark, str(result)
            assert not result.passed
            assert "read them off the drawing" in str(finding)


@each_machine
def test_the_received_description_is_wrong_at_one_joint(student):
    project, right = Project(student), draw_machine(student).chain
    finding = project.verify(received=(project.received, right.home))["body screws"]
    assert not finding.agrees
    wrong = np.abs(project.received @ adjoint(right.home).T - right.screws).max(axis=1) > 1e-3
    (joint,) = np.flatnonzero(wrong)
    assert finding.place == f"joint {joint + 1}"


def test_each_path_has_its_effect_and_no_other():
    student = STUDENTS[1]
    paths, chain = Project(student).paths.values(), draw_machine(student).chain
    effects = [effect_of(chain, path) for path in paths]
    assert sorted(effects) == sorted(EFFECTS)
    file = load_urdf(descriptions(student)["urdf"])
    assert [effect_of(file, path) for path in paths] == effects  # limits are in the file too
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
