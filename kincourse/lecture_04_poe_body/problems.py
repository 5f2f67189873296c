"""Sheet 04: body screws from a drawing and by the adjoint, M on the left and in the middle, a new tool, a Jacobian column."""

from dataclasses import replace
from functools import partial

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse
from kincourse.expressions.poses import pose as given_pose
from kincourse.expressions.screws import (
    change_frame,
    drawn_revolute,
    exponentials,
    forward_kinematics,
    joint_values,
    screw_axes,
)
from kincourse.mistakes.factor_order import factor_order_mistakes
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler, are_distinguishable, shows_transposes
from kincourse.sampling.configurations import Configuration, configuration_from_typed
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.lie import exp, homogeneous
from kinlib.rigid.screw import screw
from kinlib.view import draw_arm, draw_joints
from misstep.answers.order import Ordering
from misstep.display.text import matrix
from misstep.mistakes import mistake
from misstep.mutants.expression import product
from misstep.problem import Problem
from misstep.sheet import Sheet

HOME_ADVICE = "With body screws $M$ is the first factor, and the factors of the joints follow in their order."
BASE_ADVICE = "The factor of the joint at the base is to the left of all others, in {b} as in {s}."
MIDDLE_ADVICE = "What {s} reads is to the left of $M$, and what {b} reads is to its right."
PASSED_ADVICE = "The joints before joint 2 move its axis and the tool alike: only the joints behind it count."
TO_BODY_ADVICE = "$\\mathrm{Ad}_M$ takes what {b} reads to what {s} reads; here we go the other way."


@problem("04.1", "A body screw off a drawing", points=3, lecture="04_poe_body#A second method")
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
    B = (
        drawn_revolute(axes[joint - 1], points[joint - 1], others)
        .mistaken_for(
            robot.body_screws[neighbour],
            "another joint",
            f"give the body screw of joint {neighbour + 1}",
            "Look for the number beside the joint.",
        )
        .mistaken_for(
            robot.screws[joint - 1],
            "frame not changed",
            "read the axis in {s}",
            "A body screw has the directions and distances of {b}.",
        )
        .mistaken_for(
            screw(robot.screws[joint - 1, :3], robot.joint_points[joint - 1] - origin),
            "only moved",
            "measure from {b} along the axes of {s}",
        )
    )
    return Problem(
        statement=f"Read the body screw of joint {joint} off the drawing: stand at {{b}}, and write the axis with the directions and the "
        "distances of {b}. All joints are revolute; coordinates are whole metres.",
        figure=partial(draw_joints, robot, tool=True),
        answer=ScrewsAnswer(B.value),
        solution=B,
        advice={"sign of a vector": "The arrow in the drawing shows the positive rotation, in {b} as in {s}."},
    )


@problem("04.2", "Body screws by the adjoint", points=3, lecture="04_poe_body#The adjoint")
def by_the_adjoint(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    return Problem(
        statement="This arm has the space screws $S_i$ and the home pose $M$. Give its body screws $B_1, B_2, B_3$, as rows.\n\n"
        f"$$S = {matrix(robot.screws)}$$\n\n$$M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"screws": robot.screws, "home": robot.home},
        answer=ScrewsAnswer(robot.body_screws),
        solution=change_frame(inverse(given_pose("M", robot.home)), screw_axes("S", robot.screws)),
        advice={
            "inverse left out": TO_BODY_ADVICE,
            "frame not changed": "{b} stands elsewhere and reads other numbers than {s}.",
            "only rotated": "The origin moved too: $v$ is the velocity at the new origin $p$, $R^T (v + \\omega \\times p)$.",
            "only moved": "{b} reads along axes of its own: both halves are rotated by $R^T$.",
        },
    )


@problem("04.3", "Back to space screws", points=2, lecture="04_poe_body#The adjoint")
def back_to_space(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    return Problem(
        statement="A colleague wrote this arm down as its tool sees it: body screws $B_i$, and the home pose $M$. Give the space screws "
        f"$S_1, S_2, S_3$, as rows.\n\n$$B = {matrix(robot.body_screws)}$$\n\n$$M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": robot.body_screws, "home": robot.home},
        answer=ScrewsAnswer(robot.screws),
        solution=change_frame(given_pose("M", robot.home), screw_axes("B", robot.body_screws)),
        advice={
            "inverted": "$\\mathrm{Ad}_{M^{-1}}$ takes what {s} reads to what {b} reads; here we go back.",
            "frame not changed": "These are the body screws, as the tool reads them.",
            "only rotated": "The origin moved too: $[\\mathrm{Ad}_M]$ has $[p] R$ in its lower left corner.",
            "only moved": "{s} reads along axes of its own: both halves are rotated by $R$.",
        },
    )


@problem("04.4", "Where M stands", points=2, lecture="04_poe_body#The mid-formula form")
def where_home_stands(sampler: ArmSampler) -> Problem:
    k, names = sampler.integer(1, 3), sampler.shuffled("abcd")
    while [names[:k], names[k:]] == [sorted(names[:k]), sorted(names[k:])]:  # too close to the alphabet
        names = sampler.shuffled("abcd")
    left, right = names[:k], names[k:]
    orders = {
        "reversed": ((names[::-1][:k], names[::-1][k:]), "The joints are in the reverse order."),
        "sides exchanged": ((right, left), "The factors of {s} and {b} are on the wrong sides of $M$."),
    }
    if k < 3:  # one joint alone has no order
        text = "The joints that {b} reads are in the reverse order."
        orders["body part reversed"] = (left, right[::-1]), text
    if k > 1:
        text = "The joints that {s} reads are in the reverse order."
        orders["space part reversed"] = (left[::-1], right), text
    if k == 2:
        text = "The joints on both sides of $M$ are in the reverse order."
        orders["both parts reversed"] = (left[::-1], right[::-1]), text
    listed = ", ".join(f"then comes joint {name}" for name in names[1:])
    in_space = f"axis of joint {names[0]} is" if k == 1 else f"axes of joints {', '.join(left[:-1])} and {left[-1]} are"
    in_body = "all others" if k < 3 else f"that of joint {names[3]}"
    return Problem(
        statement=f"Joint {names[0]} of an arm stands on the floor, {listed}, and the tool is last. "
        f"The {in_space} read in {{s}}, {in_body} in {{b}}. So $e_a$ is $e^{{[S_a]q_a}}$ or $e^{{[B_a]q_a}}$, and so on. Put the "
        "factors of $T(q)$ in order, from left to right: a list of the names `'e_a'`, `'e_b'`, `'e_c'`, `'e_d'`, `'M'`.",
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
            mistake(
                "by the alphabet",
                ["e_a", "e_b", "e_c", "e_d", "M"],
                f"The joints are in the order of the alphabet. {BASE_ADVICE}",
            ),
        ],
    )


@problem("04.5", "The body form", points=3, lecture="04_poe_body#The body form")
def body_form(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRR", "RPR", "RRP"]))
    typed, q, words = _random_configuration(sampler, robot)
    return Problem(
        statement=f"This arm is given by its body screws and its home pose. Its joints stand at {words}. Give $T(q)$.\n\n"
        f"$$B = {matrix(robot.body_screws)}$$\n\n$$M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": robot.body_screws, "home": robot.home, "values": typed},
        answer=PoseAnswer(robot.fk(q)),
        solution=forward_kinematics(
            [],
            given_pose("M", robot.home),
            exponentials(robot.body_screws, joint_values(robot.joint_types, typed), "B"),
        ).mistaken_for(
            robot.home @ np.linalg.multi_dot(list(exp(robot.screws * q[:, None]))),
            "space screws",
            "use the space screws $S_i$",
            "Behind $M$ stand the screws that the tool reads: $B_i$.",
        ),
        advice={"last factor": HOME_ADVICE, "reversed": BASE_ADVICE},
    )


@problem("04.6", "M in the middle", points=3, lecture="04_poe_body#The mid-formula form")
def home_in_the_middle(sampler: ArmSampler) -> Problem:
    robot, k = _random_arm(sampler, sampler.choice(["RRRR", "RRPR", "RPRR"])), 2
    typed, _, words = _random_configuration(sampler, robot)
    mixed = np.concatenate([robot.screws[:k], robot.body_screws[k:]])
    e = exponentials(mixed, joint_values(robot.joint_types, typed), "SSBB")
    home = given_pose("M", robot.home)
    T = forward_kinematics(e[:k], home, e[k:])
    T = T.mistaken_for(
        product(*e[k:], home, *e[:k]), "sides exchanged", "put the factors of {b} to the left of $M$", MIDDLE_ADVICE
    )
    return Problem(
        statement=f"The first two joints of this arm are read in {{s}}, the others in {{b}}: below stand $S_1, S_2, B_3, B_4$. The joints "
        f"are at {words}. Give $T(q)$.\n\n$${matrix(mixed)}$$\n\n$$M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"screws": mixed, "home": robot.home, "values": typed},
        answer=PoseAnswer(T.value),
        solution=T,
        advice={"first factor": MIDDLE_ADVICE, "last factor": MIDDLE_ADVICE, "reversed": BASE_ADVICE},
    )


@problem("04.7", "A new tool", points=3, lecture="04_poe_body#Check yourself")
def new_tool(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    turn = _rotation(sampler.choice([X, Y]), sampler.choice([30, 40, -50, -60, 70]))
    H = pose((X, Y, Z), (sampler.length(0.1, 0.4), 0, sampler.length(0.5, 0.9))) @ turn
    B, home, T_bt = robot.body_screws, given_pose("M", robot.home), given_pose("T_{bt}", H)
    new = change_frame(inverse(T_bt), screw_axes("B", B)).mistaken_for(
        robot.screws,
        "space screws",
        "give the space screws",
        "They do not change with the tool, but the tool does not read them.",
    )
    for T, name, text in (
        (T_bt @ home, "order", "move the tool along the axes of {s}: $T_{bt}\\,M$ for the new home pose"),
        (home @ T_bt, "frame changed twice", "change the frame from {s} to {t}, although $B$ is read in {b}"),
    ):
        S = robot.screws if name == "order" else B
        new = new.mistaken_for(change_frame(inverse(T), S), name, text, "The new home pose is $M\\,T_{bt}$.")
    return Problem(
        statement="The tool of this arm is replaced. The new one has its frame {t} where the old one saw $T_{bt}$. Below are the body "
        f"screws as {{b}} read them. Give them as {{t}} reads them.\n\n$$B = {matrix(B)}$$\n\n$$T_{{bt}} = {matrix(H)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "T_bt": H, "home": robot.home},
        answer=ScrewsAnswer(new.value),
        solution=new,
        advice={
            "frame not changed": "The axes stay where they are; but body screws are read by the tool, and another tool reads other "
            "numbers.",
            "inverse left out": "$\\mathrm{Ad}_{T_{bt}}$ takes what {t} reads to what {b} reads; here we go the other way.",
            "only rotated": "The origin of {t} is another one too, so the moments change.",
        },
    )


@problem("04.8", "A column of the body Jacobian", points=2, lecture="04_poe_body#Body screws and the body Jacobian")
def jacobian_column(sampler: ArmSampler) -> Problem:
    robot, i = _random_arm(sampler, sampler.choice(["RRRR", "RRPR", "PRRR"])), 1
    typed, q, words = _random_configuration(sampler, robot)
    B = robot.body_screws
    e = exponentials(B, joint_values(robot.joint_types, typed), "B")
    axis = screw_axes(f"B_{i + 1}", B[i])
    column = change_frame(inverse(e[2] @ e[3]), axis)
    for passed, text in (
        (e[0], "joint 1 only"),
        (e[0] @ e[2] @ e[3], "joints 1, 3 and 4"),
        (product(*e), "all joints"),
    ):
        column = column.mistaken_for(
            change_frame(inverse(passed), axis), "joints before", f"carry the axis past {text}", PASSED_ADVICE
        )
    column = column.mistaken_for(
        change_frame(e[0], axis), "joints before", "carry the axis past joint 1, as for a space screw", PASSED_ADVICE
    )
    for k in (0, 2):
        rest = change_frame(inverse(product(*e[k + 1 :])), screw_axes(f"B_{k + 1}", B[k]))
        column = column.mistaken_for(rest, "another joint", f"give column {k + 1}")
    column = column.mistaken_for(
        robot.jacobian(q)[:, i],
        "space column",
        "give the column of the space Jacobian",
        "It is the axis as {s} reads it now.",
    )
    return Problem(
        statement=f"The joints of this arm stand at {words}. Give column {i + 1} of the body Jacobian: the axis of joint {i + 1}, as the "
        f"tool reads it now.\n\n$$B = {matrix(B)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "values": typed},
        answer=ScrewsAnswer(column.value),
        solution=column,
        advice={
            "frame not changed": f"$B_{i + 1}$ is read at home. Since then joints 3 and 4 have moved the tool.",
            "inverse left out": "The tool has moved, so it reads backwards: $\\mathrm{Ad}^{-1}$.",
            "order": "Inside the inverse the factors stand as in the body form, joint 3 first.",
        },
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


SHEET = Sheet(
    "04_poe_body",
    "The product of exponentials in the body frame",
    [
        body_screw_off_a_drawing,
        by_the_adjoint,
        back_to_space,
        where_home_stands,
        body_form,
        home_in_the_middle,
        new_tool,
        jacobian_column,
    ],
)
