"""Sheet 09: reading URDF files by hand: poses, axes, screws, the home pose, trees, and a faulty line."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from typing import Any

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import OriginAnswer, PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.space_form import screw_mistakes
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.text.urdf_text import UrdfJoint, fence_urdf, format_values, random_right_angles, robot_urdf, serial_urdf
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z
from kinlib.rigid.lie import homogeneous
from kinlib.rigid.rpy import origin
from kinlib.rigid.screw import screw
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import number
from misstep.mistakes import Mistake, mistake
from misstep.problem import Problem
from misstep.sheet import Sheet

LINKS = ("base", "boom", "forearm", "hand")
ROUNDING_NOTE = "Take `1.5708` for a right angle."


@problem("09.1", "The pose of a joint", points=3, lecture="09_urdf#Roll, pitch and yaw")
def pose_of_a_joint(sampler: ArmSampler) -> Problem:
    xyz, rpy = sampler.point(3), random_right_angles(sampler, sampler.choice([2, 3]))
    right = origin(xyz, rpy)
    own = _about_moving_axes(rpy)
    element = f'<origin xyz="{format_values(xyz)}" rpy="{format_values(rpy)}"/>'
    return Problem(
        statement=f"A joint of a URDF says\n\n{fence_urdf(element)}\n\nGive its pose in the frame of the parent link, "
        f"at $q = 0$. {ROUNDING_NOTE}",
        given={"xyz": xyz, "rpy": rpy},
        answer=PoseAnswer(right),
        mistakes=[
            mistake(
                "about its own axes",
                homogeneous(own[:3, :3], xyz),
                "You turned about the frame's own axes, in the order roll, pitch, yaw: $R_x R_y R_z$. These axes are fixed: "
                "what comes later stands further left, $R_z R_y R_x$.",
                "This is $R_x R_y R_z$, the rotation about the frame's own axes. URDF's axes are fixed: $R_z R_y R_x$.",
            ),
            mistake(
                "yaw first",
                homogeneous(origin(rpy=rpy[::-1])[:3, :3], xyz),
                "You read the angles as yaw, pitch, roll. The first is the roll, about $x$.",
                "This is the rotation with the angles read as yaw, pitch, roll. The first is the roll, about $x$.",
            ),
            mistake(
                "transposed",
                homogeneous(right.T[:3, :3], xyz),
                "This is $R^T$, the parent seen from the joint. The columns of $R$ are the joint's axes, seen from the parent.",
                "This is $R^T$. The columns of $R$ are the joint's axes, seen from the parent.",
            ),
            mistake(
                "degrees",
                origin(xyz, np.radians(rpy)),
                "You took the angles for degrees. URDF writes radians: 1.5708 is a right angle.",
                "This is the rotation with the angles read as degrees. URDF writes radians: 1.5708 is a right angle.",
            ),
            mistake(
                "turned before it was shifted",
                homogeneous(right[:3, :3], right[:3, :3] @ xyz),
                "You turned the shift as well. `xyz` is already read in the parent's frame: it is the last column as it stands.",
                "This is $R\\,p$. `xyz` is already read in the parent's frame: it is the last column as it is.",
            ),
        ],
    )


@problem("09.2", "Which way does it point?", points=2, lecture="09_urdf#What a joint says")
def way_it_points(sampler: ArmSampler) -> Problem:
    rpy, signs = random_right_angles(sampler, 2), np.array([sampler.choice((-1, 1)) for _ in range(3)])
    axis = np.array(sampler.shuffled([0.0, 0.6, 0.8])) * signs
    R = origin(rpy=rpy)[:3, :3]
    own = _about_moving_axes(rpy)[:3, :3]
    element = f'<origin xyz="0 0 1" rpy="{format_values(rpy)}"/>\n<axis xyz="{format_values(axis)}"/>'
    return Problem(
        statement=f"A joint of a URDF says\n\n{fence_urdf(element)}\n\nWhich way does its axis point in the frame of the parent link? "
        f"Give three numbers. {ROUNDING_NOTE}",
        given={"rpy": rpy, "axis": axis},
        answer=VectorsAnswer(R @ axis),
        mistakes=[
            mistake(
                "read in the parent",
                axis,
                "You took the axis as it stands. It is written in the joint's own frame, and `rpy` has turned that frame.",
            ),
            mistake(
                "transposed",
                R.T @ axis,
                "You went from parent to joint, with $R^T$. The axis is known in the joint's frame and wanted in the parent's: $R\\,a$.",
            ),
            mistake(
                "about its own axes",
                own @ axis,
                "You turned about the frame's own axes. Roll, pitch and yaw are about fixed axes: $R = R_z R_y R_x$.",
            ),
            mistake(
                "yaw first",
                origin(rpy=rpy[::-1])[:3, :3] @ axis,
                "This is right if the angles are yaw, pitch, roll. The first of the three is the roll, about $x$.",
            ),
            mistake(
                "turned round", -R @ axis, "Your axis points the other way. By the right hand, roll takes $y$ to $z$."
            ),
        ],
    )


def _about_moving_axes(rpy: Array) -> Array:
    """The pose (4, 4) of rotations by roll, pitch and yaw about the moving axes x, y, z: R = R_x R_y R_z."""
    roll, pitch, yaw = rpy
    T: Array = origin(rpy=(roll, 0, 0)) @ origin(rpy=(0, pitch, 0)) @ origin(rpy=(0, 0, yaw))
    return T


def _three_joints(sampler: ArmSampler) -> tuple[list[UrdfJoint], list[Array]]:
    """Draw three joints of an arm, each rotated against the one before, and their poses in the base frame."""
    joints = [
        UrdfJoint(f"joint_{k + 1}", sampler.point(3), random_right_angles(sampler, sampler.choice([1, 2])))
        for k in range(3)
    ]
    return joints, list(accumulate((joint.pose for joint in joints), np.matmul))


@problem("09.3", "A joint deep in the file", points=3, lecture="09_urdf#What a joint says")
def joint_deep_in_the_file(sampler: ArmSampler) -> Problem:
    joints, at = _three_joints(sampler)
    first, second, third = (joint.pose for joint in joints)
    step, start = third[:3, 3], at[1][:3, 3]
    moving = [homogeneous(_about_moving_axes(np.asarray(joint.rpy))[:3, :3], joint.xyz) for joint in joints]
    text = serial_urdf(joints, LINKS)
    return Problem(
        statement="Where does `joint_3` of this file stand in the frame of the base, when all joints are at 0? "
        f"{ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        given={"urdf": text},
        answer=VectorsAnswer(at[2][:3, 3], unit="m"),
        mistakes=[
            mistake(
                "read in the base",
                step,
                "You took the origin of `joint_3` as it stands. It is read in its parent's frame, not in the base's.",
            ),
            mistake(
                "added without turning",
                first[:3, 3] + second[:3, 3] + step,
                "You added the three origins as they stand. Each is read in the frame of its parent, which the joints before it "
                "have turned.",
            ),
            mistake(
                "turned by its own angles too",
                start + at[2][:3, :3] @ step,
                "You turned the step of `joint_3` by its own `rpy` as well. `xyz` is read in the parent's frame; `rpy` turns what "
                "comes behind.",
            ),
            mistake(
                "by the last turn only",
                first[:3, 3] + second[:3, 3] + second[:3, :3] @ step,
                "You turned each step by its parent's own `rpy` only. The turns pile up: $p_3 = p_2 + R_1 R_2\\, xyz_3$, and "
                "$p_2 = p_1 + R_1\\, xyz_2$.",
            ),
            mistake(
                "about their own axes",
                moving[0][:3, 3] + moving[0][:3, :3] @ (second[:3, 3] + moving[1][:3, :3] @ step),
                "This is right if each joint turns about its own axes, $R_x R_y R_z$. The axes of `rpy` are fixed: $R_z R_y R_x$.",
            ),
            mistake(
                "turns in the wrong order",
                start + second[:3, :3] @ first[:3, :3] @ step,
                "You multiplied the turns the wrong way round. From the base outwards, the first joint stands on the left: $R_1 R_2$.",
            ),
        ],
    )


@problem("09.4", "A screw axis from a file", points=3, lecture="09_urdf#From the file to screws")
def screw_from_a_file(sampler: ArmSampler) -> Problem:
    joints, at = _three_joints(sampler)
    axis, point = sampler.choice([X, Y, Z, -X, -Y, -Z]), at[2][:3, 3]
    joints[2] = UrdfJoint("joint_3", joints[2].xyz, joints[2].rpy, axis)
    S = screw(at[2][:3, :3] @ axis, point)
    text = serial_urdf(joints, LINKS)
    return Problem(
        statement=f"Give the screw axis of `joint_3` in the frame of the base. {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        given={"urdf": text},
        answer=ScrewsAnswer(S),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "axis read in the base",
                screw(axis, point),
                "The point is right. But you took the axis as it stands: it is written in the joint's own frame, which all three "
                "`rpy` have turned.",
            ),
            mistake(
                "turned the other way",
                screw(at[2][:3, :3].T @ axis, point),
                "The point is right. But you turned the axis by $R^T$, which takes the base's coordinates to those of the joint. "
                "Here it goes the other way: $\\omega = R\\,a$.",
            ),
            mistake(
                "its own turn left out",
                screw(at[1][:3, :3] @ axis, point),
                "You read the axis in the frame of the parent. The joint's own `rpy` turns it too: the axis stands in the joint's "
                "own frame.",
            ),
            mistake(
                "in its own frame",
                screw(axis, 0 * point),
                "This is the screw axis in the frame of `joint_3`, where the axis is as written and passes through the origin. In the "
                "frame of the base it has another direction, and another moment.",
            ),
            mistake(
                "axis of joint 2",
                screw(at[1][:3, 2], at[1][:3, 3]),
                "This is the screw axis of `joint_2`. The question is about `joint_3`, the last joint of the file.",
            ),
            mistake(
                "axis of joint 1",
                screw(at[0][:3, 2], at[0][:3, 3]),
                "This is the screw axis of `joint_1`. The question is about `joint_3`, the last joint of the file.",
            ),
            mistake(
                "point read in the base",
                screw(S[:3], joints[2].pose[:3, 3]),
                "The direction is right. But you took the `xyz` of `joint_3` for a point of the base: it is read in the parent's frame.",
            ),
        ],
    )


@problem("09.5", "The home pose from a file", points=3, lecture="09_urdf#From the file to screws")
def home_from_a_file(sampler: ArmSampler) -> Problem:
    joints, at = _three_joints(sampler)
    weld = UrdfJoint("weld", sampler.point(3), random_right_angles(sampler, 1), kind="fixed")
    drawn = sampler.point(3)
    text = serial_urdf([*joints[:2], weld], LINKS)
    box = f'  <visual>\n    <origin xyz="{format_values(drawn)}"/>\n    <geometry> <box size="1 1 1"/> </geometry>\n  </visual>'
    visual = f'<link name="hand">\n{box}\n</link>'
    text = text.replace('<link name="hand"/>', visual)
    return Problem(
        statement=f"Give the home pose $M$ of the link `hand` in the frame of the base. {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        given={"urdf": text},
        answer=PoseAnswer(at[1] @ weld.pose),
        mistakes=[
            mistake(
                "transposed",
                homogeneous((at[1] @ weld.pose)[:3, :3].T, (at[1] @ weld.pose)[:3, 3]),
                "The position is right, the rotation is $R^T$. The columns of $R$ are the axes of the hand in the frame of the base.",
                "This is $R^T$. The columns of $R$ are the axes of the hand in the frame of the base.",
            ),
            mistake(
                "weld forgotten",
                at[1],
                "You stopped at the last joint that moves. A fixed joint does not move, and it is a pose all the same.",
            ),
            mistake(
                "weld on the left",
                weld.pose @ at[1],
                "You multiplied the weld from the left. It is read in the forearm's frame, so it stands on the right.",
            ),
            mistake(
                "reversed",
                weld.pose @ joints[1].pose @ joints[0].pose,
                "You multiplied from the tip to the base. Each origin is read in the frame before it, so the base's joint stands "
                "leftmost.",
            ),
            mistake(
                "where it is drawn",
                at[1] @ weld.pose @ origin(drawn),
                "You went on to the `origin` in `visual`. That says where the box is drawn on the hand, and moves no frame.",
            ),
            mistake(
                "drawn instead of welded",
                at[1] @ origin(drawn),
                "You took the `origin` of the `visual` for that of the fixed joint.",
            ),
        ],
    )


FAULTY_ELEMENTS = {
    "no such link": "<child",
    "exchanged": "<limit",
    "zero": "<axis",
    "degrees": "<origin",
    "second parent": "<child",
}
"""The faults that a URDF reader refuses, and the element in which each of them is."""


@problem("09.6", "Which line is wrong?", points=2, lecture="09_urdf#Bug hunt")
def which_line(sampler: ArmSampler) -> Problem:
    fault = sampler.choice(list(FAULTY_ELEMENTS))
    where = 2 if fault == "second parent" else sampler.choice([1, 2])
    links, names = (
        sampler.shuffled(["post", "boom", "rod", "hand"]),
        sampler.shuffled(["swivel", "lift", "reach", "weld"]),
    )
    links = ["base", *links]
    elements = [
        f'<joint name="{names[0]}" type="continuous">\n  <parent link="base"/>\n  <child link="{links[1]}"/>\n</joint>',
        *(_limited_joint(sampler, names[k], links[k : k + 2], "" if k != where else fault, links[1]) for k in (1, 2)),
    ]
    ends = f'  <parent link="{links[3]}"/>\n  <child link="{links[4]}"/>\n'
    weld = f'<joint name="{names[3]}" type="fixed">\n{ends}  <axis xyz="0 0 0"/>\n</joint>'
    text = robot_urdf(links, [*elements, weld])
    lines = text.splitlines()
    begins = [next(i for i, line in enumerate(lines, 1) if f'<joint name="{name}"' in line) for name in names]

    def line_of(k: int, mark: str) -> float:
        return float(next(i for i, line in enumerate(lines, 1) if i >= begins[k] and mark in line))

    wrong = line_of(where, FAULTY_ELEMENTS[fault])
    first_parent = mistake(
        "the first parent",
        line_of(0, "<child"),
        "Here the link gets its first parent, and that is in order. Another line gives it a second one.",
    )
    return Problem(
        statement="A reader refuses this file, for one fault. In which line does the faulty element stand? Lines count from 1."
        f"\n\n{fence_urdf(_number_lines(lines))}",
        given={"urdf": text},
        answer=FaultyLineAnswer(
            np.array(wrong), lines=lines, joint=range(begins[where], int(line_of(where, "</joint")) + 1)
        ),
        mistakes=[
            mistake(
                "joint without limits",
                float(begins[0]),
                "This joint is in order: a continuous one needs no limits, an axis that is left out is $x$, an origin that is left "
                "out is the parent's.",
            ),
            mistake(
                "axis of a weld",
                line_of(3, "<axis"),
                "This axis is zero, but the joint is fixed: it has no axis, and nobody reads it.",
            ),
            mistake(
                "axis that is long",
                line_of(3 - where, "<axis"),
                "This axis is not of unit length. That is bad style and no fault: its direction counts, and readers shorten it.",
            ),
            mistake(
                "counted from 0",
                wrong - 1,
                "This is the line above. Lines count from 1, as in the message of a reader.",
            ),
            mistake(
                "the end of the joint",
                line_of(where, "</joint"),
                "The joint is the right one, and ends here. Which of its elements cannot be?",
            ),
            *([first_parent] if fault == "second parent" else []),
        ],
    )


@dataclass(frozen=True, eq=False)
class FaultyLineAnswer(Numbers):
    """The number of the line of a file with the faulty element, counted from 1.

    lines  the lines of the file
    joint  the numbers of the lines of the faulty joint

    >>> answer = FaultyLineAnswer(np.array(2.0), lines=['<joint>', '<axis xyz="0 0 0"/>', '</joint>', '<joint/>'], joint=range(1, 4))
    >>> answer.explanation(np.array(4.0), 0)
    ('a line that is in order', 'Line 4 is in order: `<joint/>`.')
    """

    lines: Sequence[str] = field(kw_only=True)
    joint: range = field(kw_only=True)

    def slips(self) -> Iterator[Mistake]:
        return iter(())

    def explanation(self, given: Array, part: int) -> tuple[str, str]:
        """Say of the line that was given what it is."""
        if given not in range(1, len(self.lines) + 1):
            return "no line", f"The file has the lines 1 to {len(self.lines)}. Give one of these numbers."
        line = f"`{self.lines[int(given) - 1].strip()}`"
        if given in self.joint:
            return (
                "another line of the joint",
                f"The fault is in this joint, but this line is in order: {line}. Look at its other elements.",
            )
        return "a line that is in order", f"Line {number(float(given))} is in order: {line}."


def _limited_joint(sampler: ArmSampler, name: str, links: list[str], fault: str, taken: str) -> str:
    """Write a joint with limits and possibly a fault. Without a fault its axis is not of unit length, as a decoy."""
    bound, xyz = sampler.length(0.5, 2.0), sampler.point(3)
    lower, upper = (bound, -bound) if fault == "exchanged" else (-bound, bound)
    child = {"no such link": f"{links[1]}_link", "second parent": taken}.get(fault, links[1])
    axis = {"zero": "0 0 0", "": "0 0 2"}.get(fault, "0 0 1")
    return (
        f'<joint name="{name}" type="revolute">\n  <parent link="{links[0]}"/>\n  <child link="{child}"/>\n'
        f'  <origin xyz="{format_values(xyz)}" rpy="0 {"90" if fault == "degrees" else "1.5708"} 0"/>\n  <axis xyz="{axis}"/>\n'
        f'  <limit lower="{number(lower)}" upper="{number(upper)}"/>\n</joint>'
    )


def _number_lines(lines: list[str]) -> str:
    return "\n".join(f"{i:2}  {line}" for i, line in enumerate(lines, start=1))


@problem("09.7", "The way through a tree", points=2, lecture="09_urdf#A URDF is a tree")
def way_through_a_tree(sampler: ArmSampler) -> Problem:
    a, b, c, d = sampler.shuffled(["pan", "tilt", "swing", "twist", "bend", "yaw"])[:4]
    near, far = sampler.shuffled(["left", "right"])
    joints = [
        (a, "torso", f"{near}_arm", "continuous"),
        (b, f"{near}_arm", f"{near}_wrist", "continuous"),
        (f"{near}_weld", f"{near}_wrist", f"{near}_hand", "fixed"),
        (c, "torso", f"{far}_arm", "continuous"),
        (d, f"{far}_arm", f"{far}_wrist", "continuous"),
        (f"{far}_weld", f"{far}_wrist", f"{far}_hand", "fixed"),
        ("neck", "torso", "head", "continuous"),
    ]
    shown = sampler.shuffled(joints)
    links = ["torso", *sorted(child for _, _, child, _ in joints)]
    text = robot_urdf(
        links,
        (
            f'<joint name="{name}" type="{kind}">\n  <parent link="{parent}"/> <child link="{child}"/>\n</joint>'
            for name, parent, child, kind in shown
        ),
    )
    ways = {
        "right": [b, a, c, d],
        "from the root": [a, b, c, d],
        "below the root only": [c, d],
        "welds too": [f"{near}_weld", b, a, c, d, f"{far}_weld"],
        "as in the file": [name for name, *_ in shown if name in {a, b, c, d}],
    }
    why = {
        "from the root": f"You listed the {near} arm from the torso outwards. The way starts at the hand: on it you meet `{b}` first.",
        "below the root only": f"You started at the torso. The arm stands on the {near} hand, so the joints from there to the torso "
        "move the tip as well.",
        "welds too": "Fixed joints are on the way, and have no joint value: $q$ counts what moves.",
        "as in the file": "This is the order of the file. Lines of a URDF may stand in any order; only parents and children count.",
    }
    letters = dict(zip("abcde", sampler.shuffled(list(ways)), strict=True))
    options = {letter: ways[name] for letter, name in letters.items()}
    listed = "\n".join(f"- {letter}) {', '.join(f'`{name}`' for name in way)}" for letter, way in options.items())
    return Problem(
        statement=f"An arm is made of this file with the base `{near}_hand` and the tip `{far}_hand`. Which joints does $q$ count, in "
        f"which order?\n\n{fence_urdf(text)}\n\n{listed}\n\nAnswer with a letter, such as `'a'`.",
        given={"urdf": text, "base": f"{near}_hand", "tip": f"{far}_hand", "options": options},
        answer=Choice(
            next(letter for letter, name in letters.items() if name == "right"),
            {letter: ", ".join(way) for letter, way in options.items()},
        ),
        mistakes=[mistake(name, letter, why[name]) for letter, name in letters.items() if name != "right"],
    )


@problem("09.8", "From a DH row to a URDF", points=3, lecture="09_urdf#The youBot, from a table and from a file")
def from_a_dh_row(sampler: ArmSampler) -> Problem:
    a, d = sampler.length(0.2, 0.9), sampler.length(0.2, 0.9)
    degrees = sampler.choice([-90, -60, -30, 30, 60, 90])  # not 45, whose sine is its cosine
    alpha = np.radians(degrees)
    right = np.array([[a, -d * np.sin(alpha), d * np.cos(alpha)], [alpha, 0, 0]])

    def wrong(name: str, xyz: Any, rpy: Any, message: str) -> Mistake:
        return mistake(name, [xyz, rpy], message)

    return Problem(
        statement=f"A modified DH table holds the row $a_{{i-1}} = {number(a)}$ m, $\\alpha_{{i-1}} = {degrees}°$, $d_i = {number(d)}$ m, "
        '$\\theta_i = q_i$. Write it as a joint of a URDF with `<axis xyz="0 0 1"/>`. Which `xyz` and which `rpy` does its `origin` '
        "hold, for the same frames? Give two rows, metres and radians.",
        given={"a": a, "alpha": alpha, "d": d},
        answer=OriginAnswer(right),
        mistakes=[
            wrong(
                "d along the old z",
                [a, 0, d],
                right[1],
                "You went $d$ along the $z$ of the frame before. In the modified convention $d_i$ is measured along the new $z$, which "
                "$\\alpha$ has turned: $T_i = R_x(\\alpha)\\,T_x(a)\\,R_z(q)\\,T_z(d)$.",
            ),
            wrong(
                "z turned the other way",
                [a, d * np.sin(alpha), d * np.cos(alpha)],
                right[1],
                "The new $z$ leans the other way: a roll by $\\alpha$ takes $z$ to $(0, -\\sin\\alpha, \\cos\\alpha)$.",
            ),
            wrong("degrees", right[0], [degrees, 0, 0], "`rpy` is in radians."),
            wrong(
                "alpha as yaw",
                right[0],
                [0, 0, alpha],
                "You put $\\alpha$ into the yaw. It turns about $x$, so it is the roll, the first of the three.",
            ),
            wrong(
                "a and d exchanged",
                [d, -a * np.sin(alpha), a * np.cos(alpha)],
                right[1],
                "You exchanged $a$ and $d$: $a$ runs along $x$, $d$ along the joint.",
            ),
        ],
    )


SHEET = Sheet(
    "09_urdf",
    "Robots as URDF files",
    [
        pose_of_a_joint,
        way_it_points,
        joint_deep_in_the_file,
        screw_from_a_file,
        home_from_a_file,
        which_line,
        way_through_a_tree,
        from_a_dh_row,
    ],
)
