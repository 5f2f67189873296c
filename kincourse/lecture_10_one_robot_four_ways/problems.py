"""Sheet 10: problems on the whole course. Each leads from one description of an arm to another."""

from functools import partial

import numpy as np
import sympy as sp

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.dh import other_convention
from kincourse.mistakes.space_form import negate_moment, product, remove_moment, swap_halves
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.dh.formatting import format_rows, markdown_table
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import adjoint, inverse, log
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from kinlib.rigid.screw import screw
from kinlib.view import draw_joints
from misstep.answers.choice import Choice
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.display.text import degrees, matrix, number, vector
from misstep.mistakes import mistake
from misstep.problem import Problem
from misstep.sheet import Sheet

RIGHT_ANGLE_RAD = np.pi / 2

MIN_ENTRY_DIFFERENCE = 0.3
"""The minimum difference of the wrong pose from the right ones in some entry, so that it cannot be taken for rounding."""

REPORTS = {
    "a": "It is one already.",
    "b": "Take its inverse.",
    "c": "$R = R_z(\\text{yaw}) R_y(\\text{pitch}) R_x(\\text{roll})$.",
    "d": "Take its exponential.",
}
"""For each kind of report in problem 3 how it becomes a pose."""


@problem("10.1", "From a table to a screw", points=3, lecture="10_one_robot_four_ways#A table")
def from_a_table(sampler: ArmSampler) -> Problem:
    length = partial(sampler.length, 0.1, 0.9)
    rows = np.array(
        [
            (
                length(),
                sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)),
                length(),
                sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)),
            ),
            (
                length(),
                sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)),
                length(),
                sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)),
            ),
            (length(), 0.0, 0.0, 0.0),
        ]
    )
    table = DHTable(rows, convention="standard")
    screws, last = table.to_chain().screws, table.fk(np.zeros(3))
    S = screws[2]
    return Problem(
        statement="A table in the standard convention, with frame 0 in {s} and three turning joints. Give the screw axis "
        f"$S_3$ of joint 3 in {{s}}, at home.\n\n{_format_table(table)}",
        given={"rows": rows},
        answer=ScrewsAnswer(S),
        mistakes=[
            mistake(
                "axis of frame 3",
                screw(last[:3, 2], last[:3, 3]),
                "You took $z_3$ and $O_3$. In the standard convention joint $i$ turns about $z_{i-1}$: joint 3 about $z_2$.",
            ),
            mistake("axis of joint 1", screws[0], "This is $z_0$, the axis of joint 1. Joint 3 turns about $z_2$."),
            mistake(
                "body screw",
                adjoint(inverse(last)) @ S,
                "This is $B_3$, the screw axis of joint 3 in frame 3. In {s} it is $S_3 = \\mathrm{Ad}_M B_3$.",
            ),
            mistake("axis of joint 2", screws[1], "This is $z_1$, the axis of joint 2. Joint 3 turns about $z_2$."),
            mistake(
                "the other convention",
                other_convention(table).to_chain().screws[2],
                "You multiplied the rows in the modified convention. Standard is $R_z T_z T_x R_x$, joint first.",
            ),
            mistake("omega x q", negate_moment(S), "A moment is $v = -\\omega \\times p$. Yours has the other sign."),
            mistake(
                "no moment", remove_moment(S), "You left $v = 0$. This axis does not pass through the origin of {s}."
            ),
            mistake("halves swapped", swap_halves(S), "You wrote $(v, \\omega)$. Here a screw axis is $(\\omega, v)$."),
        ],
    )


@problem("10.2", "Another tool", points=3, lecture="10_one_robot_four_ways#What changes when a frame moves")
def another_tool(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RR")
    turned = sampler.choice(((X, Y, Z), (Y, Z, X), (Z, X, Y)))
    step = pose(turned, sampler.point(3) / 10)
    home, S, B = robot.home, robot.screws, robot.body_screws

    def seen_from(T: Array) -> Array:
        return S @ adjoint(inverse(T)).T

    return Problem(
        statement="The body screws of an arm are\n\n"
        f"$$B = {matrix(B)},$$\n\none row a joint. A gripper is mounted; its frame {{c}} stands in the old tool frame at\n\n"
        f"$$T_{{bc}} = {matrix(step)}.$$\n\nGive the body screws for {{c}}, as rows.",
        given={"body_screws": B, "T_bc": step},
        answer=ScrewsAnswer(seen_from(home @ step)),
        mistakes=[
            mistake(
                "the old tool", B, "These are the screws as {b} sees them. From {c} the same axes have other numbers."
            ),
            mistake(
                "adjoint of T",
                B @ adjoint(step).T,
                "You used $\\mathrm{Ad}_{T_{bc}}$, which takes twists in {c} to {b}. Here they go from {b} to {c}: take the "
                "adjoint of the inverse.",
            ),
            mistake(
                "only turned",
                np.concatenate([B[:, :3] @ step[:3, :3], B[:, 3:] @ step[:3, :3]], axis=1),
                "You turned both halves and left out the shift. Where {c} stands changes the moments.",
            ),
            mistake(
                "only shifted",
                B @ adjoint(inverse(pose((X, Y, Z), step[:3, 3]))).T,
                "You shifted the frame and did not turn it. {c} stands turned in {b}.",
            ),
            mistake(
                "halves swapped",
                swap_halves(seen_from(home @ step)),
                "You wrote $(v, \\omega)$. Here a twist is $(\\omega, v)$.",
            ),
        ],
    )


@problem("10.3", "One of four is wrong", points=3, lecture="10_one_robot_four_ways#Bug hunt")
def one_of_four(sampler: ArmSampler) -> Problem:
    names = {"a": "space screws", "b": "body screws", "c": "table", "d": "file"}
    wrong = sampler.choice("abcd")
    right = fault = np.eye(4)
    while np.abs(right - fault).max() < MIN_ENTRY_DIFFERENCE:
        robot = sampler.arm(sampler.choice(("RRR", "RPR", "RRP")), reach=3)
        q = np.array([sampler.choice((0.3, 0.5, 0.7, 0.9)) for _ in range(3)])
        right, fault = robot.fk(q), product(robot.screws, q, robot.home, "reversed")
    told = [fault if letter == wrong else right for letter in names]
    T, T_inverse, placed, twist = told[0], inverse(told[1]), told[2], log(told[3])
    xyz, rpy = placed[:3, 3], roll_pitch_yaw(placed[:3, :3])
    return Problem(
        statement="Four descriptions of one arm were evaluated at the same $q$, and one of them is wrong. Each program reports "
        "the tool in its own way. Which description is the wrong one? Answer with its letter.\n\n"
        f"- (a) space screws: $T_{{sb}} = {matrix(T)}$\n"
        f"- (b) body screws: {{s}} as the tool sees it, $T_{{bs}} = {matrix(T_inverse)}$\n"
        f"- (c) table: `xyz` = ${vector(xyz)}$ m and `rpy` = ${vector(rpy)}$ rad, as a URDF means them\n"
        f"- (d) file: the twist ${vector(twist)}$ whose exponential is $T_{{sb}}$",
        given={"T_sb": T, "T_bs": T_inverse, "xyz": xyz, "rpy": rpy, "twist": twist},
        answer=Choice(wrong, names),
        mistakes=[
            mistake(
                letter,
                letter,
                f"The {name}: this report agrees with two others as soon as all four are written as $T_{{sb}}$. "
                f"{REPORTS[letter]} The wrong one agrees with nobody.",
            )
            for letter, name in names.items()
            if letter != wrong
        ],
    )


@problem("10.4", "The origin of a joint", points=3, lecture="10_one_robot_four_ways#A file")
def joint_origin(sampler: ArmSampler) -> Problem:
    roll = sampler.choice((90, -90))
    degrees = [roll, 0, -roll]  # with equal angles, yaw and roll could be exchanged
    here, there = sampler.point(4) / 10, sampler.point(4) / 10
    parent = origin(here, np.radians(degrees))
    R = parent[:3, :3]
    step = R.T @ (there - here)
    return Problem(
        statement=f"In the frame of the base, joint 1 of a file has the origin `xyz` = ${vector(here)}$ and "
        f"`rpy` = ${vector(degrees)}$ degrees. At home joint 2 stands at ${vector(there)}$ in {{s}}. "
        "Give the `xyz` that joint 2 has in the file, in metres.",
        given={"xyz_1": here, "rpy_1_in_degrees": np.array(degrees, dtype=float), "place_2": there},
        answer=VectorsAnswer(step, unit="m"),
        mistakes=[
            mistake(
                "from the base", there, "This is where joint 2 stands in {s}. A file writes it as seen from joint 1."
            ),
            mistake(
                "not turned",
                there - here,
                "The step is right, its axes are not: they are those of {s}. Joint 1 stands turned, so read it along its axes.",
            ),
            mistake(
                "turned the other way",
                R @ (there - here),
                "You turned the step by $R$. $R$ takes coordinates in joint 1 to those in {s}; here it goes the other way, $R^T$.",
            ),
            mistake(
                "way back",
                R.T @ (here - there),
                "This leads from joint 2 to joint 1. An origin is seen from the parent.",
            ),
            mistake(
                "yaw first",
                origin(rpy=np.radians(degrees[::-1]))[:3, :3].T @ (there - here),
                "This is right if the angles are yaw, pitch, roll. The first of the three is the roll, about $x$.",
            ),
            mistake(
                "about its own axes",
                (origin(rpy=np.radians([roll, 0, 0])) @ origin(rpy=np.radians([0, 0, -roll])))[:3, :3].T
                @ (there - here),
                "This is right if joint 1 turns about its own axes, $R_x R_y R_z$. The axes of `rpy` are fixed: $R_z R_y R_x$.",
            ),
            mistake(
                "turned, not shifted",
                R.T @ there,
                "You turned the place of joint 2 and forgot that joint 1 does not stand in the base.",
            ),
        ],
    )


@problem("10.5", "The same in letters", points=3, lecture="05_dh_standard#The product of the A matrices")
def in_letters(sampler: ArmSampler) -> Problem:
    q1, q2 = sp.symbols("q1 q2")
    a, b = (sp.Rational(round(100 * sampler.length(*limits)), 100) for limits in ((0.2, 0.5), (0.6, 0.9)))
    lift = sampler.choice((-1, 1))
    if slides := sampler.choice((True, False)):
        radius, height, mirrored = a + q2, lift * b, -lift * b
        words = (
            f"At $q = 0$ a boom leaves its axis along $x$ of {{s}}, {number(b)} m {'above' if lift > 0 else 'below'} the "
            f"origin. Joint 2 slides along the boom; at $q_2 = 0$ the tool is {number(a)} m from the axis."
        )
    else:
        up = lift * b * sp.sin(q2)
        radius, height, mirrored = b * sp.cos(q2), a + up, a - up
        words = (
            f"Joint 2 sits on this axis, {number(a)} m above the origin, and turns about ${'-y' if lift > 0 else 'y'}$ of {{s}} "
            f"at $q = 0$. It carries a boom of {number(b)} m, which lies along $x$ then, with the tool at its end."
        )
    right = sp.Matrix([radius * sp.cos(q1), radius * sp.sin(q1), height])
    swapped = sp.Matrix([radius * sp.sin(q1), radius * sp.cos(q1), height])
    return Problem(
        statement=f"Joint 1 turns about $z$ of {{s}}, through its origin. {words} Give $x$, $y$ and $z$ of the tool in the "
        "letters $q_1$ and $q_2$: text such as `'0.5*cos(q1)'`, or SymPy.",
        given={"a": float(a), "b": float(b), "slides": slides, "lift": lift},
        answer=ClosedForm(right, symbols=(q1, q2)),
        mistakes=[
            mistake(
                "sine and cosine swapped",
                swapped,
                "You swapped sine and cosine of $q_1$. At $q_1 = 0$ the boom lies along $x$.",
            ),
            mistake(
                "other sense",
                sp.Matrix([right[0], -right[1], right[2]]),
                "Your turret turns clockwise. About $+z$ the turn leads from $x$ to $y$.",
            ),
            mistake(
                "upside down",
                sp.Matrix([right[0], right[1], mirrored]),
                "Your height is mirrored: look which side the boom is on, or which way joint 2 turns.",
            ),
            mistake(
                "joint 1 forgotten",
                sp.Matrix([radius, 0, height]),
                "This holds in the plane of the boom. Joint 1 turns the plane: its $x$ becomes $(\\cos q_1, \\sin q_1)$.",
            ),
        ],
    )


@problem("10.6", "Two hands", points=3, lecture="10_one_robot_four_ways#Two arms, one tray")
def two_hands(sampler: ArmSampler) -> Problem:
    flat = sampler.choice((True, False))
    low, high = (4, 7) if flat else (7, 9)  # an arm of 3 or 6 joints would add no freedom
    arms = [sampler.integer(low, high), sampler.integer(low, high), sampler.integer(low, high)]
    d, held = (3, "plate that stays on a table, all axes upright") if flat else (6, "crate in space")
    n = sum(arms)
    return Problem(
        statement=f"Three arms of {arms[0]}, {arms[1]} and {arms[2]} joints grip one {held}, each of them rigidly. Nothing is "
        "in a special position. How many freedoms has the whole?",
        given={"joints": np.array(arms, dtype=float)},
        answer=Numbers(np.array(float(n - 2 * d))),
        mistakes=[
            mistake("no loop", float(n), "You added the joints. Each loop that closes takes its equations away."),
            mistake(
                "three loops",
                float(n - 3 * d),
                "One arm carries; the second and the third each close a loop. That is two.",
            ),
            *(
                [
                    mistake("one loop", float(n - d), "Three branches that meet close two loops, not one."),
                    mistake("in space", float(n - 12), "You took six equations for a loop. In the plane it is three."),
                ]
                if flat
                else [
                    mistake(
                        "six equations in all",
                        float(n - 6),
                        "You took six equations away. Three branches close two loops, and in space each of them takes six.",
                    )
                ]
            ),
        ],
    )


@problem("10.7", "Where is the tool?", points=3, lecture="10_one_robot_four_ways#Two products of exponentials")
def where_is_the_tool(sampler: ArmSampler) -> Problem:
    robot = sampler.arm(sampler.choice(("RPR", "RRP", "PRR")))
    degrees = [sampler.degrees(-80, 80) for _ in range(3)]
    slide = sampler.length(0.2, 0.9)
    is_turn = np.array([letter == "R" for letter in robot.joint_types])
    q = np.where(is_turn, np.radians(degrees), slide)
    words = ", ".join(
        f"$q_{i + 1} = {degrees[i]}$ degrees" if turns else f"$q_{i + 1} = {number(slide)}$ m"
        for i, turns in enumerate(is_turn)
    )
    right, B = robot.fk(q), robot.body_screws
    return Problem(
        statement=f"Give the tool's pose $T_{{sb}}$ at {words}, by any of the four ways.\n\n{joint_table(robot)}\n\n"
        f"The home pose is\n\n$$M = {matrix(robot.home)}.$$",
        figure=partial(draw_joints, robot),
        given={
            "letters": robot.joint_types,
            "axes": robot.lines.axis,
            "points": robot.joint_points,
            "home": robot.home,
            "q": q,
        },
        answer=PoseAnswer(right),
        mistakes=[
            mistake(
                "body screws, M on the right",
                product(B, q, robot.home),
                "These are body screws with $M$ behind them. They read the axes from the tool, so $M$ stands in front.",
            ),
            mistake(
                "space screws, M in front",
                product(robot.screws, q, robot.home, "home first"),
                "These are space screws with $M$ in front. They read the axes from {s}, so $M$ stands behind.",
            ),
            mistake(
                "reversed",
                product(robot.screws, q, robot.home, "reversed"),
                "You multiplied from the last joint to the first. The factor of joint 1 stands leftmost.",
            ),
            mistake(
                "Ad(M) for Ad(M^-1)",
                robot.home @ product(robot.screws @ adjoint(robot.home).T, q, np.eye(4)),
                "Your body screws came from $\\mathrm{Ad}_M$. It leads from {b} to {s}; you need $\\mathrm{Ad}_{M^{-1}}$.",
            ),
            mistake(
                "degrees",
                product(robot.screws, np.where(is_turn, degrees, slide), robot.home),
                "You used degrees as radians. `given.q` holds radians and metres.",
            ),
        ],
    )


def _format_table(table: DHTable) -> str:
    """Write a table of revolute joints in Markdown, with its lengths in metres and angles in degrees."""
    rows = format_rows(table, length=number, angle=degrees, variable="$q_{}$".format)
    return markdown_table(rows, ["row", "$a$ (m)", "$\\alpha$", "$d$ (m)", "$\\theta$"])


SHEET = Sheet(
    "10_one_robot_four_ways",
    "One robot, four ways",
    [from_a_table, another_tool, one_of_four, joint_origin, in_letters, two_hands, where_is_the_tool],
)
