"""Sheet 03: screw axes of all types of joints in the space frame, and their product of exponentials."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from itertools import accumulate

import numpy as np
import sympy as sp

from kincourse.answers.formulas import PoseExpressionAnswer, ScrewExpressionsAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.expressions.poses import assemble, columns
from kincourse.expressions.poses import pose as given_pose
from kincourse.expressions.screws import (
    direction,
    drawn_revolute,
    exponentials,
    forward_kinematics,
    helical,
    joint_screws,
    moment,
    read_screws,
    screw,
    tilted,
    values_in_radians,
)
from kincourse.lecture_03_poe_space.drawings import draw_lettered_joints
from kincourse.mistakes.factor_order import factor_order_mistakes
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import are_distinguishable
from kincourse.sampling.drawn_machines import is_readable, lengths
from kincourse.sampling.lettered_arms import LetteredArm, draw_lettered_arm
from kincourse.text.joint_table import joint_table
from kinlib.chains.robots import X, Y, Z, angled_arm, arm, pose
from kinlib.rigid.lie import adjoint
from kinlib.symbolic.formulas import exact
from kinlib.symbolic.formulas import screw as symbolic_screw
from kinlib.symbolic.merge_rotations import homogeneous
from kinlib.view import draw_arm, draw_joints
from misstep.answers.function import Function
from misstep.answers.ordering import Ordering
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number, vector
from misstep.mutants.expression import Expression, given, product, total
from misstep.mutants.operations import ANGLE, LENGTH, radians, stack

TITLE = "The product of exponentials in the space frame"

JOINT_ORDER_ADVICE = "The factor of the joint at the base is leftmost, because this joint moves all others."
TOOL_ADVICE = "The $z$ axis of the tool is a column of $M$ and moves with the arm: multiply $M$ by $\\mathrm{Trans}_z$ on the right."


@problem("03.1", "Screw axes of a plain arm", points=2, lecture="03_poe_space#Revolute joints", level="Warm-up")
def plain_arm(sampler: ArmSampler) -> Problem:
    letters = sampler.choice(["RRP", "RPR", "PRR"])
    while True:
        robot = sampler.arm(letters)
        # Where both revolute axes are parallel to y, the sign of the middle entry of a cross product cannot be seen.
        if any(screw[4] for screw in robot.screws if screw[:3].any()):
            break
    axes = robot.lines.axis
    return Problem(
        statement=f"Give the screw axes $S_1, S_2, S_3$ of this arm in {{s}}, as rows.\n\n{joint_table(robot)}",
        method="The direction of joint $i$ is $d_i$ if the joint is prismatic, and $\\omega_i$ if it is revolute.",
        further="Which numbers of your rows change if you take another point on the axis of joint 1?",
        figure=partial(draw_joints, robot),
        given={"letters": robot.joint_types, "axes": axes, "points": robot.joint_points},
        answer=ScrewsAnswer(robot.screws),
        solution=joint_screws(axes, robot.joint_points, robot.lines.pitch),
    )


RIGHT_HAND = "If the thumb of the right hand points along the axis, the fingers show how the body turns."


@problem(
    "03.2", "The velocity of the origin, at sight", points=2, lecture="03_poe_space#Revolute joints", level="Warm-up"
)
def velocity_at_sight(sampler: ArmSampler) -> Problem:
    while True:
        axes, points = np.array(sampler.shuffled([X, Y, Z])), []
        axes *= np.array([[sampler.choice((-1, 1))] for _ in axes])
        for axis in axes:
            side = sampler.choice([one for one in (X, Y, Z, -X, -Y, -Z) if not one @ axis])
            points.append(sampler.integer(2, 4) * side + sampler.choice((-3, -2, 0, 2, 3)) * axis)
        if are_distinguishable([np.zeros(3), *points]):
            break
    robot = arm([*zip(axes, points, strict=True)], pose((X, Y, Z), (0, 0, 0)), "three joints", "drawn for you")
    rows, steps = [], []
    for i, (axis, p) in enumerate(zip(axes, points, strict=True), start=1):
        foot = p - (p @ axis) * axis
        distance, v = np.linalg.norm(foot), np.cross(foot, axis)
        steps.append(f"Axis {i} is {distance:g} m from the origin, which moves along ${vector(v / distance)}$.")
        row = given(f"v_{i}", v).mistaken_for(
            ("sign of a vector", f"use the left hand for axis {i}", -v),
            everywhere="use the left hand",
            advice=RIGHT_HAND,
        )
        row = row.mistaken_for(
            ("length left out", f"give the direction of $v_{i}$ without its size", v / distance),
            ("point as moment", f"give the point where joint {i} is drawn", p),
            ("point as moment", f"give the point of axis {i} nearest to the origin", foot),
            ("axis for velocity", f"give the direction of axis {i}", axis),
            ("along the axis", f"give the distance along axis {i}", distance * axis),
            may_coincide=True,
        )
        rows.append(row)
    every = stack(*rows)
    return Problem(
        statement="Each of the three axes is parallel to an axis of {s}. A large body rotates about one of "
        "them at one radian per second, in the sense of its arrow. With which velocity does its point at the origin of {s} move? Read it "
        "off the drawing without a cross product, by the distance of the origin from the axis and the right-hand rule. Give $v_1$, "
        "$v_2$ and $v_3$ as rows.",
        method="\n".join(steps),
        further="Where would an axis along $z$ have to be, so that its $v$ is $(0, 2, 0)$?",
        figure=partial(draw_joints, robot),
        shown={"axes": axes, "points": robot.joint_points},
        answer=VectorsAnswer(every, names=["v_1", "v_2", "v_3"], unit="m/s"),
        advice={
            "point as moment": "The origin moves perpendicular to the axis and to the line that joins it to the axis."
        },
    )


@problem("03.3", "A joint at an angle", points=2, lecture="03_poe_space#Angled joints")
def angled_joint(sampler: ArmSampler) -> Problem:
    degrees, p = sampler.choice([20, 25, 35, 40, 50, 55, 65, 70]), sampler.point(3)
    upright, toward, names = sampler.choice([(Z, X, "zxy"), (Z, Y, "zyx"), (X, Y, "xyz"), (Y, X, "yxz")])
    third = given(names[2], np.cross(upright, toward))
    u = given(names[0], upright).mistaken_for(("another axis", f"tilt the axis from ${names[2]}$", third))
    t = given(names[1], toward).mistaken_for(("another axis", f"tilt the axis towards ${names[2]}$", third))
    point = given("p", p)
    omega = tilted(u, t, radians(given("\\theta", degrees, ANGLE))).named("\\omega")
    v = moment(omega, point).mistaken_for(
        ("tilt left out", f"take the moment of the axis along ${names[0]}$, without its tilt", moment(u, point))
    )
    S = screw(omega, v)
    robot = arm([(omega.value, p)], pose((X, Y, Z), p + X), "your joint", "drawn for you")
    return Problem(
        statement=f"The axis of a revolute joint is tilted from ${names[0]}$ towards ${names[1]}$ by $\\theta$ = {degrees} degrees, and "
        f"it passes through $p = {vector(p)}$. Give its screw axis.",
        further="At which angle does the moment become largest?",
        figure=partial(draw_joints, robot),
        given={"degrees": degrees, "from_axis": upright, "towards": toward, "point": p},
        answer=ScrewsAnswer(S),
        advice={
            "sign of an angle": f"An axis tilted towards ${names[1]}$ has a positive component along ${names[1]}$."
        },
    )


@problem("03.4", "A helical joint", points=3, lecture="03_poe_space#Helical joints")
def helical_joint(sampler: ArmSampler) -> Problem:
    axis, point, lead = sampler.choice([X, Y, Z, -X, -Y, -Z]), sampler.point(3), sampler.length(0.2, 0.9)
    h = (given("l", lead) / given("2\\pi", 2 * np.pi)).named("h")
    h = h.mistaken_for(
        ("degrees", "divide the lead by 360", lead / 360, "$q$ is in radians: a full turn is $2\\pi$."),
        ("half a turn", "divide the lead by $\\pi$", lead / np.pi, "A full turn is $2\\pi$."),
    )
    S = helical(direction("\\omega", axis), given("p", point), h)
    robot = arm([(axis, point, h.value)], pose((X, Y, Z), point + axis), "your joint", "drawn for you")
    return Problem(
        statement=f"The axis of a right-handed helical joint has the direction ${vector(axis)}$ and passes through "
        f"${vector(point)}$. In one full "
        f"turn the joint climbs {number(lead)} m along the axis. Give its screw axis, for $q$ in radians.",
        further="What is the screw axis of the left-handed joint with the same lead?",
        figure=partial(draw_joints, robot),
        given={"axis": axis, "point": point, "lead": lead},
        answer=ScrewsAnswer(S),
        advice={
            "divisor left out": "The pitch is in metres per radian, so it is the lead divided by $2\\pi$: $h = l / 2\\pi$.",
            "product for division": "One radian is less than a full turn, so the pitch is less than the lead.",
        },
    )


@problem("03.5", "A screw axis from a drawing", points=3, lecture="03_poe_space#Screw axes from a drawing")
def from_a_drawing(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RRR")
    joint = sampler.integer(1, 3)
    points = {f"the point of joint {i}": p for i, p in enumerate(robot.joint_points, start=1) if i != joint}
    S = drawn_revolute(robot.screws[joint - 1, :3], robot.joint_points[joint - 1], points)
    for other in {1, 2, 3} - {joint}:
        text, advice = f"give the screw axis of joint {other}", "The number of a joint is beside it in the drawing."
        S = S.mistaken_for(("another joint", text, robot.screws[other - 1], advice))
    return Problem(
        statement=f"Read the screw axis of joint {joint} off the drawing. All joints are revolute; coordinates are whole metres.",
        further="Which other points of this axis could you have read off the drawing?",
        figure=partial(draw_joints, robot),
        answer=ScrewsAnswer(S),
        advice={
            "sign of a vector": "The arrow in the drawing shows the positive rotation.",
            "coordinates swapped": "Follow the dotted line to the floor, then read along each axis.",
        },
    )


@problem("03.6", "In which order?", points=3, lecture="03_poe_space#The order of the factors")
def which_order(sampler: ArmSampler) -> Problem:
    names = sampler.shuffled("abcd")
    while sum(map(str.__ne__, names, "abcd")) < 3:  # otherwise a slip in the right order would be the alphabet
        names = sampler.shuffled("abcd")
    rides_on = sampler.shuffled([(names[0], "floor"), *zip(names[1:], names[:-1], strict=True)])
    told = [name for name, _ in rides_on]
    listed = "\n".join(
        f"- Joint {name} is fixed to the floor."
        if under == "floor"
        else f"- Joint {name} is mounted on the link that joint {under} moves."
        for name, under in rides_on
    )
    return Problem(
        statement=f"The joints of an arm have letters that do not follow the order of the chain:\n\n{listed}\n- The tool is "
        f"mounted on the link that "
        f"joint {names[3]} moves.\n\nLet $e_a = e^{{[S_a]q_a}}$ and so on, with the screw axes in {{s}} at home. Give the "
        f"factors of $T(q)$ from "
        "left to right, as a list of the names `'e_a'`, `'e_b'`, `'e_c'`, `'e_d'`, `'M'`.",
        method=JOINT_ORDER_ADVICE,
        further="Two neighbouring joints are prismatic. Why may their factors change places?",
        given={"rides_on": dict(rides_on)},
        answer=Ordering([*(f"e_{name}" for name in names), "M"]),
        mistakes=factor_order_mistakes(
            (names, ()),
            {
                "reversed": ((names[::-1], ()), f"The joints are in the reverse order. {JOINT_ORDER_ADVICE}"),
                "by the alphabet": (
                    (sorted(names), ()),
                    "The joints are in alphabetical order. Go from the floor to the tool.",
                ),
                "as listed": ((told, ()), "The joints are in the order of the list. Go from the floor to the tool."),
                "as listed, reversed": (
                    (told[::-1], ()),
                    "The joints are in the reverse order of the list. Go from the floor to the tool.",
                ),
            },
            {
                "home first": (0, "You put $M$ first. With space screws it is last: it acts on the tool first."),
                "home in the middle": (2, "You put $M$ in the middle. With space screws it is last."),
            },
        ),
    )


@problem("03.7", "A camera on a link", points=3, lecture="03_poe_space#The pose of every link")
def camera_on_a_link(sampler: ArmSampler) -> Problem:
    robot, k = sampler.arm("RRRR"), sampler.choice((2, 3))
    camera = pose(sampler.axes(), robot.joint_points[k - 1] + sampler.point(3) / 10)
    q = np.array(sampler.shuffled([0.4, 0.7, 1.1, 1.3])) * np.array([sampler.choice((-1, 1)) for _ in range(4)])
    factors = exponentials(robot.screws, values_in_radians("RRRR", q))
    first = ("joint 1", "joints 1 and 2", "joints 1, 2 and 3", "all joints")
    M = given_pose("M", camera)
    T = forward_kinematics(factors[:k], M).mistaken_for(
        *(
            ("another link", f"multiply the factors of {joints}", product(*factors[:i], M), f"Only {first[k - 1]} move link {k}.")
            for i, joints in enumerate(first, start=1)
            if i not in {k, k - 1}
        ),
        ("joint of the link alone", f"use the factor of joint {k} alone", product(factors[k - 1], M), "All joints below it move it too."),
        ("another joint value", "take for each joint the value of the next one",
         product(*exponentials(robot.screws[:k], values_in_radians("RRR"[:k], q[1 : k + 1])), M)),
        ("joint values reversed", "use all joint values in the reverse order",
         product(*exponentials(robot.screws[:k], values_in_radians("RRR"[:k], q[::-1][:k])), M)),
        ("joints after the link", "use the factors of the joints after the link", product(*factors[k:], M)),
    )  # fmt: skip
    return Problem(
        statement=f"A camera is mounted on link {k} of this arm, between joints {k} and {k + 1}. At home its pose is $M$. Give its pose "
        f"at $q = {vector(q)}$, in radians.\n\n$$S = {matrix(robot.screws)}, \\qquad M = {matrix(camera)}$$",
        further="Which joints could be blocked without changing what the camera sees?",
        figure=partial(draw_joints, robot),
        given={"screws": robot.screws, "camera_home": camera, "q": q},
        shown={"link": k},
        answer=PoseAnswer(T),
        advice={"reversed": JOINT_ORDER_ADVICE, "first factor": "$M$ acts on the camera first, so it is last."},
    )


@problem("03.8", "A longer tool on an angled arm", points=3, lecture="03_poe_space#The home pose")
def longer_tool(sampler: ArmSampler) -> Problem:
    straight = angled_arm(
        np.radians(sampler.choice([30, 40, 50, 60])),
        sampler.length(0.3, 0.8),
        sampler.length(0.4, 0.9),
        sampler.length(0.2, 0.5),
    )
    # The tool is rotated against {s}, because otherwise an extension on the left of M would give the same home pose.
    robot = replace(straight, home=pose((-Z, Y, X), straight.home[:3, 3]))
    longer = sampler.length(0.15, 0.4)
    q = np.array(
        [
            sampler.choice([0.6, 0.9, -0.7]),
            sampler.choice([0.5, -0.8, 1.1]),
            sampler.length(0.1, 0.4),
            sampler.choice([0.7, -0.6, 1.2]),
        ]
    )
    extended = given("\\mathrm{Trans}_z", pose((X, Y, Z), longer * Z))
    extended = extended.mistaken_for(
        ("another axis", "extend the tool along its $x$", pose((X, Y, Z), longer * X)),
        ("another axis", "extend the tool along its $y$", pose((X, Y, Z), longer * Y)),
        ("sign of a length", "shorten the tool instead of extending it", pose((X, Y, Z), -longer * Z)),
    )
    home = (given_pose("M", robot.home) @ extended).named("M'")
    values = values_in_radians(robot.joint_types, q)
    factors = exponentials(robot.screws, values)
    moved = robot.screws @ adjoint(extended.value).T
    T = forward_kinematics(factors, home).mistaken_for(
        ("screws changed", "change the screws with the tool as well", product(*exponentials(moved, values), home)),
        (
            "order",
            "extend the tool along the $z$ of {s}, after the motion",
            extended @ forward_kinematics(factors, given_pose("M", robot.home)),
        ),
    )
    return Problem(
        statement=f"The tool of this arm is replaced by a tool that is {number(longer)} m longer along its own $z$ axis. "
        f"Give $T(q)$ of the new tool at $q = {vector(q)}$.\n\n$$S = {matrix(robot.screws)}, \\qquad M = {matrix(robot.home)}$$",
        further="Which column of $T(q)$ does the longer tool change, and by which vector?",
        figure=partial(draw_arm, robot),
        given={"screws": robot.screws, "home": robot.home, "longer": longer, "q": q},
        answer=PoseAnswer(T),
        invisible=["order"],  # joint 3 translates along the axis of joint 2, so their factors commute
        advice={
            "screws changed": "The joints are where they were, so the screws in {s} stay.",
            "extend the tool along the $z$ of {s}, after the motion": TOOL_ADVICE,
            "leave out $\\mathrm{Trans}_z$": "Without $\\mathrm{Trans}_z$ you have the old tool. The new home pose is $M' = "
            "M\\,\\mathrm{Trans}_z$.",
            "swap $M$ and $\\mathrm{Trans}_z$": f"On the left, $\\mathrm{{Trans}}_z$ is along the $z$ of {{s}}. {TOOL_ADVICE}",
            "reversed": JOINT_ORDER_ADVICE,
            "first factor": "With space screws, the home pose is the last factor.",
        },
    )


@problem("03.9", "The home pose of a whole arm", points=3, lecture="03_poe_space#A whole arm in letters")
def home_of_a_whole_arm(sampler: ArmSampler) -> Problem:
    robot = draw_lettered_arm(sampler)

    def solution(**lengths: float) -> Expression:
        R = columns(*(direction(letter, axis) for letter, axis in zip("xyz", robot.tool, strict=True)))
        return assemble(R, total(*_links(robot, lengths)).named("p"))

    return Problem(
        statement="The drawing shows an arm at home, with the frame {s} at the base and {b} at the end-effector. Each link is parallel to "
        f"an axis of {{s}}, and the letter beside it is its length. Give the home pose $M = T_{{sb}}$ as a matrix of formulas "
        f"in {_listed(robot)}.",
        further="Which entries of $M$ stay the same if {b} is moved to the wrist?",
        figure=partial(draw_lettered_joints, robot.chain, robot.letters),
        given={"L": _symbols(robot)},
        answer=PoseExpressionAnswer(_symbolic_home(robot), _symbols(robot)),
        solution=solution,
        advice={
            "axes in rows": "The columns of $R$ are the axes of {b}, written in {s}.",
            "inverse": "$M = T_{sb}$ gives the frame {b} in coordinates of {s}.",
            "term left out": "Follow the links from {s} to {b}, and add up all of them.",
        },
    )


@problem("03.10", "All screw axes of a whole arm", points=3, lecture="03_poe_space#A whole arm in letters")
def screws_of_a_whole_arm(sampler: ArmSampler) -> Problem:
    robot = draw_lettered_arm(sampler.of_problem("03.9"))
    n = robot.chain.n

    def solution(**lengths: float) -> Expression:
        links, points = _links(robot, lengths), []
        for i, (letter, axis) in enumerate(zip(robot.joint_types, robot.axes, strict=True)):
            if letter == "P":
                points.append(given(f"p_{i + 1}", sum(link.value for link in links[: i + 1])))
                continue
            # A link along the axis leads to another point of the same axis.
            across = [link for link in links[: i + 1] if abs(link.value @ axis) < 1e-9]
            point = total(*across)
            if len(across) > 1:
                point = point.named(f"p_{i + 1}")
                text = f"measure the point of joint {i + 1} from joint {i} instead of from {{s}}"
                point = point.mistaken_for(("from the joint before", text, links[i]))
            points.append(point)
        S = joint_screws(robot.axes, points, robot.chain.lines.pitch)
        return S.mistaken_for(("rows reversed", "list the screws from the last joint to the first", S[::-1]))

    return Problem(
        statement=f"This is the arm of Problem 9. Give its screw axes $S_1$ to $S_{n}$ in {{s}}, in rows: {n} rows of six formulas "
        f"in {_listed(robot)}.",
        further="Two joints have parallel axes. Which entries of their screws must agree?",
        figure=partial(draw_lettered_joints, robot.chain, robot.letters),
        given={"L": _symbols(robot)},
        answer=ScrewExpressionsAnswer(_symbolic_screws(robot), _symbols(robot)),
        solution=solution,
        advice={
            "term left out": "The point of a joint is the sum of all links between the origin of {s} and the joint."
        },
    )


@problem(
    "03.11",
    "The forward kinematics of a whole arm",
    points=3,
    lecture="03_poe_space#A whole arm in letters",
    level="Hard",
)
def kinematics_of_a_whole_arm(sampler: ArmSampler) -> Problem:
    robot = draw_lettered_arm(sampler.of_problem("03.9"))
    types, n = robot.joint_types, robot.chain.n

    def inputs(chance: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        return chance.uniform(0.3, 1.3, n) * chance.choice([-1, 1], n), chance.uniform(0.3, 1.5, n + 1)

    def pose_at(q: np.ndarray, lengths: np.ndarray) -> Expression:
        chain = robot.with_lengths(lengths)
        values = values_in_radians(types, q)
        T = forward_kinematics(exponentials(chain.screws, values), given_pose("M", chain.home))
        for k, letter in enumerate(robot.letters):
            for factor, name, text in ((0, "term left out", "leave out"), (-1, "sign", "negate")):
                other = robot.with_lengths(np.where(np.arange(n + 1) == k, factor, 1) * lengths).fk(q)
                T = T.mistaken_for((name, f"{text} ${letter}$ in $M$ and in the screws", other), may_coincide=True)
            if k:
                other = robot.with_lengths(np.where(np.arange(n + 1) == k, lengths[k - 1], lengths)).fk(q)
                text = f"use ${robot.letters[k - 1]}$, where ${letter}$ belongs"
                T = T.mistaken_for(("another length", text, other), may_coincide=True)
        return T

    units = "in radians, and in metres for a prismatic joint"
    return Problem(
        statement=f"This is the arm of Problems 9 and 10. Write a function `fk(q, L)` that takes the {n} joint values $q$ ({units}) and "
        f"the lengths {_listed(robot)}, and returns $T(q)$. The check calls it with values of its own.",
        method="The screws $S_i$ are those of Problem 10, and $M$ is that of Problem 9.",
        further="Which entries of $T(q)$ do not depend on the last joint value?",
        figure=partial(draw_lettered_joints, robot.chain, robot.letters),
        answer=Function(lambda q, lengths: robot.with_lengths(lengths).fk(q), PoseAnswer(robot.chain.home), inputs),
        solution=pose_at,
        advice={
            "reversed": JOINT_ORDER_ADVICE,
            "first factor": "With space screws, the factor of joint 1 is leftmost, and $M$ is last.",
        },
    )


def _symbols(robot: LetteredArm) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(robot.letters, positive=True))


def _listed(robot: LetteredArm) -> str:
    return f"${robot.letters[0]}, \\ldots, {robot.letters[-1]}$"


def _symbolic_points(robot: LetteredArm) -> list[sp.Matrix]:
    """The points of the joints and of the tool."""
    steps = [letter * exact(link) for letter, link in zip(_symbols(robot), robot.links, strict=True)]
    return list(accumulate(steps))


def _symbolic_home(robot: LetteredArm) -> sp.Matrix:
    return homogeneous(sp.Matrix.hstack(*map(exact, robot.tool)), _symbolic_points(robot)[-1])


def _symbolic_screws(robot: LetteredArm) -> sp.Matrix:
    joints = zip(robot.axes, _symbolic_points(robot)[:-1], robot.chain.lines.pitch, strict=True)
    return sp.Matrix.vstack(*(symbolic_screw(axis, p, pitch).T for axis, p, pitch in joints))


def _links(robot: LetteredArm, lengths: Mapping[str, float]) -> list[Expression]:
    """The links as vectors, each named by its letter, with the mistakes that people make when they read them off a drawing."""
    sizes = list(lengths.values())
    links = []
    for i, (letter, along) in enumerate(zip(robot.letters, robot.links, strict=True)):
        link = given(f"{letter}\\,{vector(along)}", sizes[i] * along, LENGTH)
        for j in {i - 1, i + 1} & set(range(len(sizes))):
            text = f"use ${robot.letters[j]}$, where ${letter}$ belongs"
            link = link.mistaken_for(("another length", text, sizes[j] * along))
        links.append(link.mistaken_for(("term left out", f"leave out ${link.latex}$", 0 * along)))
    return links


@problem("03.12", "A palletizer", points=4, lecture="03_poe_space#Screw axes from a drawing")
def palletizer(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        foot = np.array([a, b, 0.0])
        shoulder = foot + np.array([c, -d, 0.3 + e])
        elbow = shoulder + np.array([f, 0.0, g])
        wrist = elbow + np.array([0.3 + h, a - b, -e])
        points = np.array([shoulder, elbow, wrist])
        if is_readable(points):
            break
    side = sampler.choice((-1, 1)) * Y
    axes = np.array([side, side * sampler.choice((-1, 1)), -Z])
    S = read_screws(axes, points, (2, 3, 4), "s", marks=points)
    drawn = [
        DrawnAxis("1", Z, foot),
        *(DrawnAxis(str(i), w, p) for i, w, p in zip((2, 3, 4), axes, points, strict=True)),
    ]
    marks = dict(zip(("P2", "P3", "P4"), points, strict=True))
    return Problem(
        statement="The drawing shows a palletizer, with four revolute joints, in millimetres. Give the screw axes $S_2$, $S_3$ and $S_4$ "
        "in {s}, as rows, in metres. An axis that points towards you is a ring with a dot, one that points away a ring with a cross.",
        further="The origin of {s} is moved to joint 2. Which numbers of your screws change?",
        figure=lambda: draw_dimensions([foot, np.array([foot[0], foot[1], shoulder[2]]), *points], drawn, marks),
        answer=ScrewsAnswer(S, names=["screw 2", "screw 3", "screw 4"]),
    )


UR5E_M = (0.1625, 0.425, 0.3922, 0.1333, 0.0997)
"""The lengths of the maker's data sheet from the base to joint 6: to the shoulder, two links, and two steps of the wrist."""


@problem("03.13", "A UR5e on its stand", points=4, lecture="03_poe_space#The UR5e, from its data sheet", level="Hard")
def ur5e_on_a_stand(sampler: ArmSampler) -> Problem:
    place = lengths(sampler, 3, 0.3, 0.8) * (sampler.choice((-1, 1)), sampler.choice((-1, 1)), 1)
    forward = sampler.choice((X, -X))  # in the plane of the front view
    heading = np.column_stack([forward, np.cross(Z, forward), Z])
    upper, fore = sampler.choice(((Z, X), (Z, -X), (X, Z), (-X, Z)))
    shoulder, upper_arm, forearm, wrist_1, wrist_2 = UR5E_M

    def points_of(upper: np.ndarray, fore: np.ndarray, foot: np.ndarray = place) -> np.ndarray:
        steps = [0 * Z, shoulder * Z, upper_arm * upper, forearm * fore, -wrist_1 * Y, -wrist_2 * Z]
        return np.array(foot + np.cumsum(steps, axis=0) @ heading.T)

    axes, points = np.array([Z, -Y, -Y, -Y, -Z, -Y]) @ heading.T, points_of(upper, fore)
    S = joint_screws(axes, [given(f"P_{i}", p) for i, p in enumerate(points, start=1)], np.zeros(6))
    for name, text, other in (
        ("another origin", "measure from the base of the robot", points - place),
        ("term left out", "leave out the height of the stand", points_of(upper, fore, place * (1, 1, 0))),
        ("term left out", "leave out the height of the shoulder", points - np.outer(np.arange(6) > 0, shoulder * Z)),
        ("another configuration", "take the configuration of the data sheet, with both links horizontal", points_of(-X, -X)),
        ("links swapped", "swap the directions of the two links", points_of(fore, upper)),
        ("sign of a coordinate", "put the base on the other side of the origin of {s} along x", points - 2 * place * X),
        ("sign of a coordinate", "put the base on the other side of the origin of {s} along y", points - 2 * place * Y),
        ("sign of a length", "lay both steps of the wrist to the other side", 2 * points[[0, 1, 2, 3, 3, 3]] - points),
    ):  # fmt: skip
        S = S.mistaken_for((name, text, joint_screws(axes, other, np.zeros(6)).value))
    apart = points - np.outer((1, 0, 0, 0, 0, 0), place * Z / 2) + np.outer((0, 0, 0, 0, 1, 0), 0.24 * Z)
    drawn = [DrawnAxis(str(i), axis, p) for i, (axis, p) in enumerate(zip(axes, apart, strict=True), start=1)]
    body = [place * (1, 1, 0), *points]
    ways = {tuple(way): name for way, name in ((X, "+x"), (-X, "-x"), (Y, "+y"), (-Y, "-y"), (Z, "+z"), (-Z, "-z"))}
    first, second, third = (f"${ways[tuple((heading @ way).round() + 0.0)]}$" for way in (upper, fore, -Y))
    return Problem(
        statement="A UR5e is mounted on a stand; the drawing has the place of its base in millimetres. The maker's lengths, from the base "
        f"on, are 162.5 up to joint 2, 425 along {first} to joint 3, 392.2 along {second} to joint 4, 133.3 along {third} to joint 5 and "
        "99.7 down to joint 6. Give the screw axes $S_1$ to $S_6$ in {s} in this configuration, as rows, in metres.",
        further="Give the home pose $M$ of the flange, which is 99.6 mm beyond joint 6 along its axis, with $z$ pointing out of it.",
        figure=lambda: draw_dimensions(body, drawn, {"base": place}),
        shown={"axes": axes, "points": points},
        answer=ScrewsAnswer(S),
    )


@problem("03.14", "A base frame of your choice", points=3, lecture="03_poe_space#Revolute joints", level="Open")
def another_base_frame(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RRPR")
    return Problem(
        statement=f"You may put the base frame of this arm where you like, with axes parallel to those of {{s}}. Where do you put it, so "
        "that as many $v_i$ as possible are 0? Give the new screw axes, and argue that no other place does "
        f"better.\n\n{joint_table(robot)}",
        figure=partial(draw_joints, robot),
        answer=Prose(
            "$v = -\\omega \\times p$ is 0 exactly if the axis of a revolute joint passes through the origin; that of a prismatic "
            "joint is never 0. So the origin belongs on as many revolute axes as possible. Two axes that intersect have one common "
            "point; where no two of them do, every point of one axis gives one $v_i = 0$, and none gives two. The new moments are "
            "$-\\omega_i \\times (p_i - o)$, and no $\\omega_i$ changes.",
            {
                "$v_i = 0$ exactly if a revolute axis passes through the origin, and never for the prismatic joint": 1,
                "a place with its screw axes, all of them right": 1,
                "an argument from the common points of the axes that no place does better": 1,
            },
        ),
    )
