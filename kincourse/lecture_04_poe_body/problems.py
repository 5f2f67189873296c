"""Sheet 04: body screws from a drawing and by the adjoint, M on the left and in the middle, a new tool, the body Jacobian."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import combinations_with_replacement

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer, TwistAnswer
from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.expressions.poses import inverse
from kincourse.expressions.poses import pose as given_pose
from kincourse.expressions.screws import (
    change_frame,
    change_frame_of_rows,
    drawn_revolute,
    exponentials,
    forward_kinematics,
    joint_values,
    read_screws,
    screw_axes,
)
from kincourse.mistakes.factor_order import factor_order_mistakes
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import Configuration, are_distinguishable, configuration_from_typed, shows_transposes
from kincourse.sampling.drawn_machines import is_readable, lengths
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.lie import exp, homogeneous
from kinlib.rigid.screw import screw
from kinlib.view import draw_arm, draw_joints
from misstep.answers.number import Numbers
from misstep.answers.ordering import Ordering
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number
from misstep.mistakes import Mistake
from misstep.mutants.expression import Operation, given, product, total

TITLE = "The product of exponentials in the body frame"

HOME_ADVICE = "With body screws $M$ is the first factor, and the factors of the joints follow in their order."
BASE_ADVICE = "The factor of the joint at the base is to the left of all others, in {b} as in {s}."
MIDDLE_ADVICE = "Exponentials of screws in {s} are to the left of $M$, and those of screws in {b} are to its right."
CARRY_ADVICE = "Column $i$ of $J_b$ is the body screw $B_i$, changed by the joints between axis $i$ and the tool."
TO_BODY_ADVICE = "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here."


@problem("04.1", "A body screw off a drawing", points=3, lecture="04_poe_body#A second method", level="Warm-up")
def body_screw_off_a_drawing(sampler: ArmSampler) -> Problem:
    joint = sampler.integer(1, 3)
    while True:
        robot = sampler.arm("RRR")
        R, origin = robot.home[:3, :3], robot.home[:3, 3]
        axes, points = robot.screws[:, :3] @ R, (robot.joint_points - origin) @ R
        apart = are_distinguishable([origin, np.zeros(3), *robot.joint_points])
        if apart and shows_transposes(robot) and _has_different_entries(robot.body_screws[joint - 1, 3:]):
            break
    others = {f"the point of joint {i}": p for i, p in enumerate(points, start=1) if i != joint}
    others["the point of the joint, seen from {s},"] = robot.joint_points[joint - 1] @ R
    neighbour = joint % 3
    B = drawn_revolute(axes[joint - 1], points[joint - 1], others).mistaken_for(
        ("another joint", f"give the body screw of joint {neighbour + 1}", robot.body_screws[neighbour]),
        ("frame not changed", "read the axis in {s}", robot.screws[joint - 1]),
        (
            "rotation left out",
            "measure from the origin of {b}, but along the axes of {s}",
            screw(robot.screws[joint - 1, :3], robot.joint_points[joint - 1] - origin),
        ),
    )
    return Problem(
        statement=f"Read the body screw of joint {joint} off the drawing: give the direction and the moment of its axis in the frame "
        "{b} of the end-effector. All joints are revolute; coordinates are whole metres.",
        further="Give the space screw of the same joint. Which half of it do you know without computing?",
        figure=partial(draw_joints, robot, tool=True),
        answer=ScrewsAnswer(B),
        advice={
            "another joint": "The joints are numbered in the drawing.",
            "frame not changed": "For a body screw, direction and point are given in {b}.",
            "sign of a vector": "The arrow in the drawing shows the positive rotation, in {b} as in {s}.",
        },
    )


@problem("04.2", "Body screws by the adjoint", points=2, lecture="04_poe_body#The adjoint", level="Warm-up")
def by_the_adjoint(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    return Problem(
        statement="This arm has the space screws $S_i$ and the home pose $M$. Give its body screws $B_1, B_2, B_3$, as rows.\n\n"
        f"$$S = {matrix(robot.screws)}$$\n\n$$M = {matrix(robot.home)}$$",
        further="Which body screw would not change if the tool were longer along its own $z$ axis?",
        figure=partial(draw_arm, robot),
        given={"screws": robot.screws},
        shown={"home": robot.home},
        answer=ScrewsAnswer(robot.body_screws),
        solution=change_frame_of_rows(inverse(given_pose("M", robot.home)), screw_axes("S", robot.screws)),
        method="The screws are rows: $B_i = \\mathrm{Ad}_{M^{-1}} S_i$ for each of them.",
        advice={
            "inverse left out": TO_BODY_ADVICE,
            "frame not changed": "These are the space screws; {b} has another origin and other axes.",
            "position left out": "The origin moved too: $v$ is the velocity at the new origin $p$, $R^T (v + \\omega \\times p)$.",
            "rotation left out": "{b} also has other axes than {s}, so both halves are rotated by $R^T$.",
        },
    )


@problem("04.3", "The place of M", points=3, lecture="04_poe_body#The mid-formula form")
def where_home_stands(sampler: ArmSampler) -> Problem:
    k, names = sampler.integer(1, 3), sampler.shuffled("abcd")
    while [names[:k], names[k:]] == [sorted(names[:k]), sorted(names[k:])]:  # too close to the alphabet
        names = sampler.shuffled("abcd")
    left, right = names[:k], names[k:]
    by_alphabet = ["e_a", "e_b", "e_c", "e_d"]
    orders = {
        "reversed": ((names[::-1][:k], names[::-1][k:]), "The joints are in the reverse order."),
        "sides swapped": ((right, left), "The joints that are given in {b} come before those that are given in {s}."),
    }
    if k < 3:  # one joint alone has no order
        text = "The joints whose axes are given in {b} are in the reverse order."
        orders["body part reversed"] = (left, right[::-1]), text
    if k > 1:
        text = "The joints whose axes are given in {s} are in the reverse order."
        orders["space part reversed"] = (left[::-1], right), text
    if k == 2:
        text = "The joints on both sides of $M$ are in the reverse order."
        orders["both parts reversed"] = (left[::-1], right[::-1]), text
    listed = ", ".join(f"then comes joint {name}" for name in names[1:])
    in_space = f"axis of joint {names[0]} is" if k == 1 else f"axes of joints {', '.join(left[:-1])} and {left[-1]} are"
    in_body = "all others" if k < 3 else f"that of joint {names[3]}"
    return Problem(
        statement=f"Joint {names[0]} of an arm is fixed to the floor, {listed}, and the tool is last. "
        f"The {in_space} given in {{s}}, {in_body} in {{b}}. The factor of joint a is $e_a$: it is "
        "$e^{[S_a]q_a}$ if its axis is given in {s}, and $e^{[B_a]q_a}$ if it is given in {b}; and so on. Put the factors "
        "of $T(q)$ in order, from left to right: a list of the names `'e_a'`, `'e_b'`, `'e_c'`, `'e_d'`, `'M'`.",
        method="Factors with an axis in {s} are on the left of $M$, and those with an axis in {b} on its right; on each side they are in "
        "the order of the chain.",
        further="How many other places of $M$ are possible if each screw may be written in either frame?",
        given={"from_floor_to_tool": names, "read_in_s": left},
        answer=Ordering([*(f"e_{name}" for name in left), "M", *(f"e_{name}" for name in right)]),
        mistakes=[
            *factor_order_mistakes(
                (left, right),
                {name: (sides, f"{text} {BASE_ADVICE}") for name, (sides, text) in orders.items()},
                {
                    "home last": (4, f"You put $M$ at the end, as in the space form. {MIDDLE_ADVICE}"),
                    "home first": (0, f"You put $M$ in front, as in the body form. {MIDDLE_ADVICE}"),
                },
            ),
            *(
                Mistake("by the alphabet", order, f"The joints are in the order of the alphabet. {BASE_ADVICE}")
                for order in ([*by_alphabet, "M"], ["M", *by_alphabet])
            ),
        ],
    )


@problem("04.4", "The body form", points=3, lecture="04_poe_body#The body form")
def body_form(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRR", "RPR", "RRP"]))
    typed, q, words = _random_configuration(sampler, robot)
    return Problem(
        statement=f"This arm is given by its body screws and its home pose. Its joint values are {words}. Give $T(q)$.\n\n"
        f"$$B = {matrix(robot.body_screws)}$$\n\n$$M = {matrix(robot.home)}$$",
        further="Write the same pose with space screws. Which factor stays as it is?",
        figure=partial(draw_arm, robot),
        given={"body_screws": robot.body_screws, "home": robot.home, "values": typed},
        answer=PoseAnswer(robot.fk(q)),
        solution=forward_kinematics(
            [],
            given_pose("M", robot.home),
            exponentials(robot.body_screws, joint_values(robot.joint_types, typed), "B"),
        ).mistaken_for(
            (
                "space screws",
                "use the space screws $S_i$",
                robot.home @ np.linalg.multi_dot(list(exp(robot.screws * q[:, None]))),
            )
        ),
        advice={
            "space screws": "To the right of $M$ belong the body screws $B_i$.",
            "last factor": HOME_ADVICE,
            "reversed": BASE_ADVICE,
        },
    )


@problem("04.5", "M in the middle", points=4, lecture="04_poe_body#The mid-formula form")
def home_in_the_middle(sampler: ArmSampler) -> Problem:
    robot, k = _random_arm(sampler, sampler.choice(["RRRR", "RRPR", "RPRR"])), 2
    typed, _, words = _random_configuration(sampler, robot)
    mixed = np.concatenate([robot.screws[:k], robot.body_screws[k:]])
    e = exponentials(mixed, joint_values(robot.joint_types, typed), "SSBB")
    home = given_pose("M", robot.home)
    T = forward_kinematics(e[:k], home, e[k:])
    T = T.mistaken_for(
        (
            "sides swapped",
            "put the factors of {b} to the left of $M$, those of {s} to its right",
            product(*e[k:], home, *e[:k]),
        )
    )
    return Problem(
        statement=f"The screw axes of the first two joints of this arm are given in {{s}}, the others in {{b}}: the rows below are "
        f"$S_1, S_2, B_3, B_4$. The joint values are {words}. Give $T(q)$.\n\n$${matrix(mixed)}$$\n\n$$M = {matrix(robot.home)}$$",
        further="Move $M$ one place to the left. Which screw must be rewritten?",
        figure=partial(draw_arm, robot),
        given={"screws": mixed, "home": robot.home, "values": typed},
        answer=PoseAnswer(T),
        advice={
            "sides swapped": MIDDLE_ADVICE,
            "first factor": MIDDLE_ADVICE,
            "last factor": MIDDLE_ADVICE,
            "reversed": BASE_ADVICE,
        },
    )


@problem("04.6", "A new tool", points=4, lecture="04_poe_body#The adjoint")
def new_tool(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    turn = _rotation(sampler.choice([X, Y]), sampler.choice([30, 40, -50, -60, 70]))
    H = pose((X, Y, Z), (sampler.length(0.1, 0.4), 0, sampler.length(0.5, 0.9))) @ turn
    B, home, T_bt = robot.body_screws, given_pose("M", robot.home), given_pose("T_{bt}", H)
    new = change_frame_of_rows(inverse(T_bt), screw_axes("B", B)).mistaken_for(
        ("space screws", "give the space screws", robot.screws),
        ("another pose", "use $M$, where $T_{bt}$ belongs", change_frame(inverse(home), B)),
    )
    for T, name, text in (
        (T_bt @ home, "order", "move the tool along the axes of {s}: $T_{bt}\\,M$ for the new home pose"),
        (home @ T_bt, "frame changed twice", "change the frame from {s} to {t}, although $B$ is written in {b}"),
    ):
        S = robot.screws if name == "order" else B
        new = new.mistaken_for((name, text, change_frame(inverse(T), S), "The new home pose is $M\\,T_{bt}$."))
    return Problem(
        statement="The tool of this arm is replaced. The frame {t} of the new tool has the pose $T_{bt}$ in the frame {b} of the old one. "
        f"Below are the body screws in {{b}}. Give them in {{t}}, as rows.\n\n$$B = {matrix(B)}$$\n\n$$T_{{bt}} = {matrix(H)}$$",
        method="The screws are rows: each of them is multiplied by $\\mathrm{Ad}_{T_{bt}^{-1}}$.",
        further="For which new tools do the $\\omega$ of all body screws stay as they are?",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "T_bt": H, "home": robot.home},
        answer=ScrewsAnswer(new),
        advice={
            "space screws": "They do not change with the tool, but they are screws in {s} and not in {t}.",
            "frame not changed": "The axes stay where they are, but body screws are given in the tool frame, which is {t} now.",
            "inverse left out": "$\\mathrm{Ad}_{T_{bt}}$ takes screws in {t} to screws in {b}; here you need the opposite direction.",
            "position left out": "{t} also has another origin, so the moments change.",
        },
    )


@problem("04.7", "The twist of the tool", points=4, lecture="04b_velocity#Joint rates and the twist of the tool")
def twist_of_the_tool(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRR", "RPR", "RRP"]))
    typed, q, words = _random_configuration(sampler, robot)
    rates, qdot, rate_words = _random_configuration(sampler, robot)
    B = robot.body_screws
    e = exponentials(B, joint_values(robot.joint_types, typed), "B")
    dq = joint_values(robot.joint_types, rates, "\\dot q")
    axes = [screw_axes(f"B_{i}", screw) for i, screw in enumerate(B, start=1)]
    columns = [change_frame(inverse(e[1] @ e[2]), axes[0]), change_frame(inverse(e[2]), axes[1]), axes[2]]
    V = total(*(rate * column for rate, column in zip(dq, columns, strict=True)))
    V = V.mistaken_for(
        ("space Jacobian", "use the space Jacobian", robot.jacobian(q) @ qdot, "It gives the twist in {s}."),
        ("at home", "use the body screws at home as columns", B.T @ qdot, "The joints have moved since."),
        ("joint values for rates", "multiply by the joint values", robot.body_jacobian(q) @ q),
        ("rates reversed", "use the rates in the reverse order", robot.body_jacobian(q) @ qdot[::-1], ""),
        ("degrees", "use degrees per second as radians per second", robot.body_jacobian(q) @ rates),
        ("degrees", "use the degrees of $q$ as radians", robot.body_jacobian(np.array(typed)) @ qdot),
        ("rates swapped", "swap the joint values and the rates", robot.body_jacobian(qdot) @ q, ""),
        ("sign of a joint value", "take every joint value with the opposite sign", robot.body_jacobian(-q) @ qdot, ""),
        ("joint values reversed", "use the joint values in the reverse order", robot.body_jacobian(q[::-1]) @ qdot, ""),
        ("rates left out", "add up the columns without the rates", robot.body_jacobian(q).sum(axis=1)),
        *(
            ("one column", f"give column {i} alone", robot.body_jacobian(q)[:, i - 1], "Every joint adds its column.")
            for i in (1, 2, 3)
        ),
        ("joints before", "move each axis by the joints before it", Chain(B, robot.home).jacobian(q) @ qdot),
    )
    per_second = rate_words.replace("degrees", "degrees/s").replace(" m", " m/s")
    return Problem(
        statement=f"The joint values of this arm are {words}, and its joint rates $\\dot q_i$ are {per_second}. Give the twist "
        f"$\\mathcal{{V}}_b = J_b(q)\\,\\dot q$ of the tool in {{b}}: six numbers $(\\omega, v)$, in rad/s and m/s.\n\n$$B = {matrix(B)}$$",
        method="Column $i$ of $J_b$ is $B_i$, changed by the joints between axis $i$ and the tool. Rates and angles are in radians.",
        further="At which rates does the tool stand still in this configuration, other than 0?",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "values": typed, "rates": rates},
        answer=TwistAnswer(V),
        advice={
            "joint values for rates": "Multiply by the rates.",
            "degrees": "Use `np.radians` first.",
            "rates left out": "Multiply by the rates.",
            "joints before": CARRY_ADVICE,
            "inverse left out": "The columns of $J_b$ are the axes as seen from the moved tool, so they need $\\mathrm{Ad}^{-1}$.",
            "order": "Inside the inverse the factors have the order of the body form, joint 2 first.",
            "frame not changed": CARRY_ADVICE,
            "term left out": "Every joint that moves adds its column times its rate.",
            "use degrees as radians": "Both $q$ and $\\dot q$ are given in degrees: use `np.radians` on each.",
        },
    )


size = Operation("size", np.abs, "|{0}|".format)
in_order = Operation("in order", lambda *x: np.sort(x), "({0}, {1}, {2}, {3})".format)


@problem(
    "04.8",
    "All singular configurations of a planar arm",
    points=4,
    lecture="04b_velocity#Singular configurations",
    level="Hard",
)
def planar_arm(sampler: ArmSampler) -> Problem:
    while True:
        L = np.array([sampler.length(0.2, 0.9) for _ in range(3)])
        reach = np.abs(np.array([(1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1)]) @ L)
        if np.diff(np.sort([0, *reach])).min() > 0.05:
            break
    a, b, c = (given(f"L_{i}", x) for i, x in enumerate(L, start=1))
    far, folded_3, folded_2, back = a + b + c, size(a + b - c), size(a - b + c), size(a - b - c)
    distances = in_order(*sorted((back, folded_2, folded_3, far), key=lambda one: float(one.value)))
    distances = distances.mistaken_for(
        ("order", "list the largest first", np.sort(reach)[::-1]),
        ("pairs of links", "take the differences of two links each", np.sort([*np.abs(L - np.roll(L, 1)), L.sum()])),
        ("sums of pairs", "take the sums of two links each", np.sort([*(L + np.roll(L, 1)), L.sum()])),
        ("stretched alone", "count only the stretched arm", np.full(4, L.sum())),
        ("right angles", "take right angles between the links", np.hypot(reach, L[2])),
        ("zero for folded", "put the folded tip on joint 1", np.array([0, 0, 0, L.sum()])),
        ("squares", "give the squares of the distances", np.sort(reach) ** 2),
        ("not sized", "leave a negative distance", np.sort([L @ w for w in ((1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1))])),
        ("links themselves", "give the three links and their sum", np.sort([*L, L.sum()])),
        ("term left out", "stop at joint 3, without the last link", np.sort([L[0] + L[1], abs(L[0] - L[1])] * 2)),
        ("term left out", "begin at joint 2, without the first link", np.sort([L[1] + L[2], abs(L[1] - L[2])] * 2)),
        may_coincide=True,
    )  # fmt: skip
    return Problem(
        statement=f"A planar arm has three revolute joints and links of {number(L[0])}, {number(L[1])} and {number(L[2])} m. Only the "
        "position of its tip counts. In which configurations is there a direction in which the tip cannot move? Give the distances of the "
        "tip from joint 1 in all of them: four numbers in metres, the smallest first.",
        further="Now the direction of the last link counts as well. Which of these configurations are still singular, and which are new?",
        given={"links": L},
        answer=Numbers(distances, unit="m"),
        mistakes=[
            Mistake(
                "counted twice",
                np.array(some),
                "Each of these distances is right, but two of the four are the same configuration.",
            )
            for some in combinations_with_replacement(np.sort(reach), 4)
            if 1 < len(set(some)) < 4
        ],
    )


def _has_different_entries(v: Array) -> bool:
    """Whether the moment of an axis along x, y or z has two entries besides 0, of different sizes, so that no swap is missed."""
    return len({0.0, *np.abs(v).round(6)}) == 3


def _random_arm(sampler: ArmSampler, joint_types: str) -> Chain:
    """Draw an arm whose tool is rotated by an angle of the student's own, so that no rotation is taken for its inverse."""
    while True:
        robot = sampler.arm(joint_types)
        home = robot.home @ _rotation(sampler.choice([X, Y, Z]), sampler.choice([20, 30, -40, 50, -60, 70]))
        if shows_transposes(robot := replace(robot, home=home)):
            return robot


def _rotation(axis: Array, degrees: float) -> Array:
    return homogeneous(exp(np.radians(degrees) * axis), np.zeros(3))


def _random_configuration(sampler: ArmSampler, robot: Chain) -> Configuration:
    """Draw a configuration with angles up to 75 degrees and translations up to 1 m."""
    typed = [sampler.degrees(-75, 75) if kind == "R" else sampler.length(0.2, 1.0) for kind in robot.joint_types]
    return configuration_from_typed(robot, typed)


@problem("04.9", "A wrist with offsets", points=4, lecture="04_poe_body#A second method", level="Hard")
def drawn_wrist(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7, 0.04, 0.3)
        fourth, fifth, sixth = np.array([-a - b - c, d, e + f]), np.array([-a - b, d - g, e]), np.array([-a, -g, -f])
        points = np.array([fourth, fifth, sixth])
        if is_readable(points):
            break
    axes = np.array([sampler.choice((-1, 1)) * axis for axis in (Z, Y, X)])
    B = read_screws(axes, points, (4, 5, 6), "b")
    drawn = [DrawnAxis(str(i), w, p) for i, w, p in zip((4, 5, 6), axes, points, strict=True)]
    marks = dict(zip(("P4", "P5", "P6"), points, strict=True))
    return Problem(
        statement="The drawing shows the wrist of an arm, at home, in millimetres. All of it is measured from the frame {b} of the tool, "
        "whose $x$ is to the right, whose $y$ is up in the top view, and whose $z$ is up in the front view. Give the body screws $B_4$, "
        "$B_5$ and $B_6$, as rows, in metres.",
        further="With all offsets 0, which entries of the three screws vanish?",
        figure=lambda: draw_dimensions([*points, (0, 0, 0)], drawn, marks, origin="{b}"),
        answer=ScrewsAnswer(B, names=["screw 4", "screw 5", "screw 6"]),
        advice={"sign of a length": "The wrist is behind the tool, so most coordinates in {b} are negative."},
    )


@problem("04.10", "What the controller should store", points=3, lecture="04_poe_body#The adjoint", level="Open")
def what_to_store(_: ArmSampler) -> Problem:
    return Problem(
        statement="A controller can store space screws with $M$, or body screws with $M$. In the next year the tool will be changed "
        "twice, the robot will be moved to another hall, where {s} is the corner of the hall, and the zero of joint 2 will be "
        "set anew. Which of $S_i$, $B_i$ and $M$ change in each of the three cases, and by which formula? Which description "
        "would you store?",
        answer=Prose(
            "With a new tool $T_{bt}$, $M$ becomes $M\\,T_{bt}$ and every $B_i$ becomes $\\mathrm{Ad}_{T_{bt}^{-1}} B_i$; no $S_i$ "
            "changes. In the new hall $M$ is multiplied from the left by the pose of the old {s}, and so are the $S_i$ by its "
            "adjoint; no $B_i$ changes. A new zero of joint 2 changes $M$, the $S_i$ after joint 2 and the $B_i$ before joint 2. As "
            "the tool changes more often than the hall, space screws are changed less often; any choice with such a reason is "
            "right.",
            {
                "the new tool: $M$ and all $B_i$, with the adjoint": 1,
                "the new hall: $M$ and all $S_i$": 1,
                "the new zero: which screws move with joint 2; and a choice that follows from the three cases": 1,
            },
        ),
    )
