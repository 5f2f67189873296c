"""Sheet 10: problems on the whole course. Each leads from one description of an arm to another."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import sympy as sp

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.links import link
from kincourse.expressions.poses import inverse
from kincourse.expressions.poses import pose as given_pose
from kincourse.expressions.screws import (
    change_frame,
    exponentials,
    forward_kinematics,
    joint_values,
    revolute,
    screw_axes,
)
from kincourse.expressions.urdf import rpy_rotation
from kincourse.lecture_10_one_robot_four_ways.project_problems import PROJECT_PROBLEMS
from kincourse.problem import problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG, ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.dh.formatting import markdown_table
from kinlib.dh.table import DHTable, format_rows
from kinlib.rigid.lie import adjoint, log
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import inverse as inverted
from kinlib.rigid.rpy import roll_pitch_yaw
from kinlib.rigid.screw import screw
from kinlib.view import draw_joints
from misstep.answers.choice import Choice
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.display.text import degrees, matrix, number, vector
from misstep.mistakes import mistake
from misstep.mutants.expression import Expression, given, product
from misstep.mutants.operations import ANGLE, LENGTH, SLIDE, cos, radians, sin, stack
from misstep.problem import Problem
from misstep.sheet import Sheet

RIGHT_ANGLE_RAD = np.pi / 2

MIN_ENTRY_DIFFERENCE = 0.3
"""The minimum difference of the wrong pose from the right ones in some entry, so that it cannot be taken for rounding."""

REPORTS = {
    "a": "This one is $T_{sb}$ already.",
    "b": "Take its inverse.",
    "c": "$R = R_z(\\text{yaw}) R_y(\\text{pitch}) R_x(\\text{roll})$.",
    "d": "Take its exponential.",
}
"""For each kind of report in problem 3 how it becomes a pose."""


@problem(
    "10.1",
    "From a table to a screw",
    points=3,
    lecture="10_one_robot_four_ways#A table",
    further="Which entries of the screw depend on the choice of $x_2$?",
)
def from_a_table(sampler: ArmSampler) -> Problem:
    length = partial(sampler.length, 0.1, 0.9)
    right_angle = partial(sampler.choice, (-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD))

    def theta() -> float:
        # With a right angle a length of row 1 would lie along z_2, and change no moment.
        return float(np.radians(sampler.choice((-1, 1)) * sampler.choice(PLAIN_ANGLES_DEG)))

    rows = np.array([(length(), right_angle(), length(), theta()) for _ in range(2)] + [(length(), 0.0, 0.0, 0.0)])
    A = [link(row, "standard", i) for i, row in enumerate(rows, start=1)]
    table = DHTable(rows, convention="standard")

    def axis_of(T: Expression, k: int) -> Expression:
        return revolute(T[:3, 2].named(f"z_{k}"), T[:3, 3].named(f"O_{k}"))

    T_02, T_03 = A[0] @ A[1], product(*A)
    z, O = T_02[:3, 2].named("z_2"), T_02[:3, 3].named("O_2")
    z = z.mistaken_for(
        ("another axis", "take $x_2$ instead of $z_2$", T_02[:3, 0]),
        ("row for column", "take the third row of the rotation instead of its third column", T_02[2, :3]),
    )
    for k, T in ((1, A[0]), (3, T_03)):
        O = O.mistaken_for(("another point", f"take $O_{k}$ instead of $O_2$", T[:3, 3]))
    S = revolute(z, O)
    modified = product(*(link(row, "modified", i) for i, row in enumerate(rows, start=1)))
    S = S.mistaken_for(
        ("another joint", "take $z_3$ and $O_3$", axis_of(T_03, 3)),
        ("another joint", "take $z_1$ and $O_1$, the axis of joint 2", axis_of(A[0], 1)),
        ("another joint", "take $z_0$ and $O_0$, the axis of joint 1", axis_of(given("I", np.eye(4)), 0)),
        ("the other convention", "take $z_3$ and $O_3$ of the modified convention", axis_of(modified, 3)),
        ("body screw", "give $B_3$, the screw axis in frame 3", change_frame(inverse(T_03), S)),
    )
    return Problem(
        statement="The table of an arm with three revolute joints is in the standard convention, and its frame 0 is {s}. Give the screw "
        f"axis $S_3$ of joint 3 in {{s}}, at home.\n\n{_format_table(table)}",
        given={"rows": rows},
        answer=ScrewsAnswer(S.value),
        solution=S,
        advice={
            "another joint": "In the standard convention joint $i$ rotates about $z_{i-1}$, so joint 3 rotates about $z_2$.",
            "body screw": "In {s} it is $S_3 = \\mathrm{Ad}_M B_3$.",
        },
    )


@problem(
    "10.2",
    "Another tool",
    points=3,
    lecture="10_one_robot_four_ways#What changes when a frame moves",
    further="For which tools is the change of the body screws a rotation alone?",
)
def another_tool(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RR")
    turned = sampler.choice(((X, Y, Z), (Y, Z, X), (Z, X, Y)))
    step, B = pose(turned, sampler.point(3) / 10), robot.body_screws
    seen = change_frame(inverse(given_pose("T_{bc}", step)), screw_axes("B", B))
    return Problem(
        statement="The body screws of an arm are\n\n"
        f"$$B = {matrix(B)},$$\n\none row for each joint. A gripper is mounted; the pose of its frame {{c}} in {{b}} is\n\n"
        f"$$T_{{bc}} = {matrix(step)}.$$\n\nGive the body screws in {{c}}, as rows.",
        given={"body_screws": B},
        shown={"T_bc": step},
        answer=ScrewsAnswer(seen.value),
        solution=seen,
        advice={
            "inverse left out": "$\\mathrm{Ad}_{T_{bc}}$ takes screws in {c} to screws in {b}; here you need the opposite direction.",
            "position left out": "{c} also has another origin than {b}, so the moments change.",
            "rotation left out": "{c} also has other axes than {b}.",
            "frame not changed": "These are the screws in {b}. In {c} the same axes have other numbers.",
        },
    )


@problem(
    "10.3",
    "One of four is wrong",
    points=3,
    lecture="10_one_robot_four_ways#Do they agree?",
    further="How many configurations do you need to find the wrong description for certain?",
)
def one_of_four(sampler: ArmSampler) -> Problem:
    names = {"a": "space screws", "b": "body screws", "c": "table", "d": "file"}
    wrong = sampler.choice("abcd")
    right = fault = np.eye(4)
    while np.linalg.norm((right - fault)[:3, 3]) < MIN_ENTRY_DIFFERENCE:
        robot = sampler.arm(sampler.choice(("RRR", "RPR", "RRP")), reach=3)
        q = np.array([sampler.choice((0.3, 0.5, 0.7, 0.9)) for _ in range(3)])
        right, fault = robot.fk(q), np.linalg.multi_dot([*exponential(robot.screws * q[:, None])[::-1], robot.home])
    poses = [fault if letter == wrong else right for letter in names]
    T, T_inverse, placed, twist = poses[0], inverted(poses[1]), poses[2], log(poses[3])
    xyz, rpy = placed[:3, 3], roll_pitch_yaw(placed[:3, :3])
    problem = Problem(
        statement="Four descriptions of one arm were evaluated at the same $q$, and one of them is wrong. Each report gives "
        "the pose of the tool in another format. Which description is wrong, and how far from the others, in metres, does it put "
        "the tool? Answer with its letter and the distance, such as `('a', 0.5)`.\n\n"
        f"- (a) space screws: $T_{{sb}} = {matrix(T)}$\n"
        f"- (b) body screws: the pose of {{s}} in {{b}}, $T_{{bs}} = {matrix(T_inverse)}$\n"
        f"- (c) table: `xyz` = ${vector(xyz)}$ m and `rpy` = ${vector(rpy)}$ rad, as in a URDF\n"
        f"- (d) file: the twist ${vector(twist)}$ whose exponential is $T_{{sb}}$",
        given={"T_sb": T, "T_bs": T_inverse, "xyz": xyz, "rpy": rpy, "twist": twist},
        answer=Choice(wrong, names),
        mistakes=[
            mistake(
                letter,
                letter,
                f"You answered {name}, but this report agrees with two others if you write all four as $T_{{sb}}$. "
                f"{REPORTS[letter]} The wrong report agrees with none of the others.",
            )
            for letter, name in names.items()
            if letter != wrong
        ],
    )
    return problem.with_reason(Numbers(np.array(np.linalg.norm((right - fault)[:3, 3])), unit="m"))


@problem(
    "10.4",
    "The origin of a joint",
    points=3,
    lecture="10_one_robot_four_ways#A file",
    further="Which `rpy` would give the same origin with another axis?",
)
def joint_origin(sampler: ArmSampler) -> Problem:
    # With two right angles, fixed and moving axes could be swapped.
    degrees = [sampler.choice((90, -90)), 0, sampler.choice((-60, -30, 30, 60))]
    here, there = sampler.point(4) / 10, sampler.point(4) / 10
    R = rpy_rotation("R", radians(given("\\mathrm{rpy}", np.array(degrees))))
    step = (given("p_2", there) - given("p_1", here)).named("(p_2 - p_1)")
    step = step.mistaken_for(
        ("order", "take the vector from joint 2 to joint 1", here - given("p_2", there)),
        ("sign", "add the two positions instead of subtracting them", here + given("p_2", there)),
    )
    xyz = R.T @ step
    for name, text, place in (
        ("from the base", "give the position of joint 2 in {s}", there),
        ("another joint", "give the position of joint 1", here),
        ("rotated and not moved", "multiply the position of joint 2 by $R$", R @ there),
        ("order", "rotate the position of joint 2 before subtracting that of joint 1", R.T @ there - here),
        (
            "placed by joint 1",
            "treat the position of joint 2 as if it were given in the frame of joint 1",
            here + R @ there,
        ),
    ):
        advice = "The `xyz` of joint 2 has its components in the frame of joint 1. The problem gives the position of joint 2 in {s}."
        xyz = xyz.mistaken_for((name, text, place, advice))
    return Problem(
        statement=f"In a URDF file, the origin of joint 1 in the base frame {{s}} is `xyz` = ${vector(here)}$ and "
        f"`rpy` = ${vector(degrees)}$ degrees. At home the position of joint 2 is ${vector(there)}$ in {{s}}. "
        "Give the `xyz` of joint 2, whose parent is the link of joint 1, in metres.",
        given={"xyz_1": here, "rpy_1_in_degrees": np.array(degrees, dtype=float), "place_2": there},
        answer=VectorsAnswer(xyz.value, unit="m"),
        solution=xyz,
        advice={
            "transpose left out": "$R$ takes components in the frame of joint 1 to components in {s}; here you need $R^T$.",
            "factor left out": "The frame of joint 1 is rotated: give the components along its axes.",
            "term left out": "The origin of joint 1 is not at the origin of the base frame.",
        },
    )


@problem(
    "10.5",
    "The same in letters",
    points=3,
    lecture="05_dh_standard#The product of the A matrices",
    further="At which $q_2$ does the position not depend on $q_1$?",
)
def in_letters(sampler: ArmSampler) -> Problem:
    a, b = sampler.length(0.2, 0.5), sampler.length(0.6, 0.9)
    lift = sampler.choice((-1, 1))
    if slides := sampler.choice((True, False)):
        words = (
            f"At $q = 0$ a boom, that is, a straight beam, begins at this axis, along $x$ of {{s}}, "
            f"{number(b)} m {'above' if lift > 0 else 'below'} the origin. Joint 2 is prismatic and "
            f"translates along the boom; at $q_2 = 0$ the tool is {number(a)} m from the axis."
        )
    else:
        words = (
            f"Joint 2 is on this axis, {number(a)} m above the origin, and rotates about ${'-y' if lift > 0 else 'y'}$ of {{s}} "
            f"at $q = 0$. It moves a boom, that is, a straight beam, of {number(b)} m, which is along $x$ at $q = 0$, with the "
            "tool at its end."
        )
    place = partial(_tool_on_a_boom, a, lift * b, slides)
    symbols = sp.symbols("q1 q2")
    right = _formulas(sp.Rational(str(a)), sp.Rational(str(lift * b)), slides, *symbols)
    return Problem(
        statement=f"Joint 1 rotates about $z$ of {{s}}, through its origin. {words} Give $x$, $y$ and $z$ of the tool as formulas in "
        "$q_1$ and $q_2$: text such as `'0.5*cos(q1)'`, or SymPy expressions.",
        given={"a": a, "b": b, "slides": slides, "lift": lift},
        answer=ClosedForm(right, symbols=symbols),
        solution=place,
        advice={"sine and cosine swapped": "At $q = 0$ the boom is along $x$."},
    )


def _formulas(a: sp.Expr, b: sp.Expr, slides: bool, q1: sp.Expr, q2: sp.Expr) -> sp.Matrix:
    """The position of a tool on a boom along which joint 2 translates, or which it rotates; b is a height or a length with a sign."""
    radius, height = (a + q2, b) if slides else (abs(b) * sp.cos(q2), a + b * sp.sin(q2))
    return sp.Matrix([radius * sp.cos(q1), radius * sp.sin(q1), height])


def _tool_on_a_boom_of(slides: bool, a: float, b: float, q1: float, q2: float) -> Array:
    return np.array(_formulas(a, b, slides, q1, q2), dtype=float).ravel()


def _tool_on_a_boom(a: float, b: float, slides: bool, q1: float, q2: float) -> Expression:
    """The same as an expression."""
    first, second = given("q_1", q1, ANGLE), given("q_2", q2, SLIDE if slides else ANGLE)
    offset, up, boom = given("a", a), given("b", b, LENGTH), given("b", abs(b))

    def place(radius: Any, height: Any, angle: Expression = first) -> Expression:
        return stack(radius * cos(angle), radius * sin(angle), height)

    radius, height = (offset + second, up) if slides else (boom * cos(second), offset + up * sin(second))
    own = (
        (
            ("slide along z", "let joint 2 translate along $z$ instead of the boom", place(offset, up + second)),
            ("prismatic as revolute", "let joint 2 rotate", place(offset * cos(second), up + offset * sin(second))),
            ("lengths swapped", "swap the two lengths", place(abs(b) + second, a * np.sign(b) * given("1", 1.0))),
            ("product for sum", "multiply the length of the boom by $q_2$", place(offset * second, up)),
            ("prismatic as revolute", "let joint 2 rotate about $z$", place(offset, up, first + second)),
            ("length left out", "leave out the length of the boom", place(second, up)),
            ("height added", "add the height to the length of the boom", place(offset + up + second, up)),
        )
        if slides
        else (
            (
                "lengths swapped",
                "swap the two lengths",
                place(offset * cos(second), boom + a * np.sign(b) * sin(second)),
            ),
            ("revolute as prismatic", "let joint 2 translate", place(boom + second, offset)),
            ("joint 2 left out", "leave joint 2 at 0", place(boom, offset)),
            ("angles added", "add the two angles, as for parallel axes", place(boom, height, first + second)),
            ("prismatic as revolute", "let joint 2 rotate about $z$", place(boom, offset, first + second)),
            ("not shortened", "leave out that the raised boom reaches less far", place(boom, height)),
        )
    )
    p = place(radius, height)
    swapped = (
        place(offset + first, up, second) if slides else place(boom * cos(first), offset + up * sin(first), second)
    )
    return p.mistaken_for(
        *own,
        ("height left out", "leave out the height", place(radius, 0.0)),
        ("radius left out", "leave out the distance from the axis of joint 1", place(1.0, height)),
        ("angles added", "add the angles $q_1$ and $q_2$", place(radius, height, first + second)),
        (
            "another kind of joint",
            f"take joint 2 as a {'revolute' if slides else 'prismatic'} one",
            _tool_on_a_boom_of(not slides, a, b, q1, q2),
        ),
        ("at home", "give the place at $q = 0$", stack(a if slides else abs(b), 0.0, b if slides else a)),
        (
            "degrees",
            "convert both angles, which are in radians, as if they were in degrees",
            place(radius, height, radians(first))
            if slides
            else _tool_on_a_boom_of(slides, a, b, *np.radians([q1, q2])),
        ),
        ("joint 1 left out", "leave out joint 1", stack(radius, 0.0 * radius, height)),
        ("joint values swapped", "swap $q_1$ and $q_2$", swapped),
        (
            "degrees",
            "convert $q_1$, which is in radians, as if it were in degrees",
            place(radius, height, radians(first)),
        ),
        (
            "tangent for sine",
            "use the tangent of $q_1$ instead of its sine",
            stack(radius * cos(first), radius * np.tan(q1), height),
        ),
    )


@problem(
    "10.6",
    "Three arms, one object",
    points=3,
    lecture="10_one_robot_four_ways#Two arms, one tray",
    further="One arm lets go. How many degrees of freedom are left?",
)
def three_arms(sampler: ArmSampler) -> Problem:
    flat = sampler.choice((True, False))
    low, high = (4, 9) if flat else (7, 12)  # an arm of 3 or 6 joints would add no freedom
    arms = [sampler.integer(low, high), sampler.integer(low, high), sampler.integer(low, high)]
    d, held = (3, "plate that stays on a table, with all axes vertical") if flat else (6, "crate in space")
    n, right = sum(arms), float(sum(arms) - 2 * d)
    joints, loops = given("\\text{the number of joints}", float(n)), given("\\text{the number of loops}", 2.0)
    equations = given("d", float(d))
    for name, text, count in (
        ("one loop", "count one loop", 1.0),
        ("three loops", "count three loops, one for each arm", 3.0),
    ):
        loops = loops.mistaken_for(
            (name, text, count, "The second and the third arm each close a loop with the first one.")
        )
    place = "In the plane it is three." if flat else "In space it is six."
    equations = equations.mistaken_for(("another d", f"take {9 - d} equations for a loop", 9.0 - d, place))
    mobility = joints - (loops * equations).named("\\text{the equations of all loops}")
    mobility = mobility.mistaken_for(
        ("three loops, another d", f"count three loops with {9 - d} equations each", n - 3.0 * (9 - d)),
        ("one loop, another d", f"count one loop with {9 - d} equations", n - (9.0 - d)),
        ("the object", "add one degree of freedom for the object", right + 1),
        ("the object", "give the degrees of freedom of the object alone", float(d)),
        ("one arm", "give the degrees of freedom of one arm", float(arms[0])),
        ("one arm", "give the smallest number of joints of an arm", float(min(arms))),
        (
            "redundancy",
            "add up the joints that each arm has beyond the degrees of freedom of the object",
            float(n - 3 * d),
        ),
        ("equations", "give the number of equations", 2.0 * d),
        ("one less", "subtract one more degree of freedom", right - 1),
        ("one arm forgotten", "leave out the third arm", float(arms[0] + arms[1] - d)),
        ("fixed", "say that nothing moves", 0.0),
        ("sign", "give the negative of the number", -right),
    )
    return Problem(
        statement=f"Three arms of {arms[0]}, {arms[1]} and {arms[2]} joints hold one {held}, each of them rigidly. No axes are "
        "in a special position. How many degrees of freedom does the whole mechanism have? Here $d$ is the number of "
        "equations of a loop.",
        given={"joints": np.array(arms, dtype=float)},
        answer=Numbers(np.array(right)),
        solution=mobility,
        advice={"term left out": "Each closed loop subtracts the number of its equations."},
    )


@problem(
    "10.7",
    "Where is the tool?",
    points=3,
    lecture="10_one_robot_four_ways#Two products of exponentials",
    further="Compute it by the body form as well. Which factor do both forms share?",
)
def where_is_the_tool(sampler: ArmSampler) -> Problem:
    robot = sampler.arm(sampler.choice(("RPR", "RRP", "PRR")))
    degrees = [sampler.degrees(-80, 80) for _ in range(3)]
    slide = sampler.length(0.2, 0.9)
    is_turn = np.array([letter == "R" for letter in robot.joint_types])
    typed = np.where(is_turn, degrees, slide)
    words = ", ".join(
        f"$q_{i + 1} = {degrees[i]}$ degrees" if turns else f"$q_{i + 1} = {number(slide)}$ m"
        for i, turns in enumerate(is_turn)
    )
    S, M, q = robot.screws, given_pose("M", robot.home), joint_values(robot.joint_types, typed)
    e, b = exponentials(S, q), exponentials(robot.body_screws, q, "B")
    T = forward_kinematics(e, M)
    bent = np.array([screw(w, p) for w, p in zip(robot.lines.axis, robot.joint_points, strict=True)])
    straight = np.where(is_turn[:, None] & (np.arange(6) > 2), 0.0, S)
    places, axes = robot.joint_points, robot.lines.axis

    def with_moments(moments: Array) -> Expression:
        wrong = np.where(is_turn[:, None], np.concatenate([axes, moments], axis=1), S)
        return product(*exponentials(wrong, q), M)

    last, first = np.flatnonzero(is_turn)[[-1, 0]]
    moved = np.where(np.arange(3)[:, None] == last, places[first], places)
    for name, text, wrong in (
        ("point as moment", "take the points as the moments", with_moments(places)),
        (
            "another point",
            "use the point of the next joint for each axis",
            with_moments(np.cross(np.roll(places, -1, axis=0), axes)),
        ),
        (
            "another point",
            "use the point of the first revolute joint for the last one",
            with_moments(np.cross(moved, axes)),
        ),
        ("body screws", "use the body screws with $M$ last", product(*b, M)),
        ("body screws", "multiply the body screws from the last joint to the first", product(M, *b[::-1])),
        (
            "adjoint",
            "use $\\mathrm{Ad}_M$ instead of $\\mathrm{Ad}_{M^{-1}}$ for the body screws",
            product(M, *exponentials(S @ adjoint(robot.home).T, q, "B")),
        ),
        ("prismatic as revolute", "treat the prismatic joint as a revolute one", product(*exponentials(bent, q), M)),
        ("no moment", "leave out all moments", product(*exponentials(straight, q), M)),
        (
            "space screws",
            "use $\\mathrm{Ad}_{M}$ instead of the screws in {s}",
            product(*exponentials(S @ adjoint(robot.home).T, q), M),
        ),
    ):
        is_place = name in {"body screws", "adjoint", "space screws"}
        advice = "With screws in {s}, $M$ is last; with screws in {b}, it is first." if is_place else ""
        T = T.mistaken_for((name, text, wrong, advice))
    return Problem(
        statement=f"Give the pose $T_{{sb}}$ of the tool at {words}, by any of the four descriptions.\n\n{joint_table(robot)}\n\n"
        f"The home pose is\n\n$$M = {matrix(robot.home)}.$$",
        figure=partial(draw_joints, robot),
        given={
            "letters": robot.joint_types,
            "axes": robot.lines.axis,
            "points": robot.joint_points,
            "home": robot.home,
            "q": np.where(is_turn, np.radians(degrees), slide),
        },
        answer=PoseAnswer(T.value),
        solution=T,
        advice={"reversed": "The factor of joint 1 is leftmost.", "degrees": "`given.q` holds radians and metres."},
    )


def _format_table(table: DHTable) -> str:
    """Write a table of revolute joints in Markdown, with its lengths in metres and angles in degrees."""
    rows = format_rows(table, length=number, angle=degrees, variable="$q_{}$".format)
    return markdown_table(rows, ["row", "$a$ (m)", "$\\alpha$", "$d$ (m)", "$\\theta$"])


SHEET = Sheet(
    "10_one_robot_four_ways",
    "One robot, four ways",
    [
        *(from_a_table, another_tool, one_of_four, joint_origin, in_letters, three_arms, where_is_the_tool),
        *PROJECT_PROBLEMS,
    ],
)
