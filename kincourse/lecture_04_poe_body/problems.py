"""Sheet 04: body screws from a drawing and by the adjoint, M on the left and in the middle, a new tool, a Jacobian column."""

from dataclasses import replace
from functools import partial

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.body_form import (
    body_product_mistakes,
    body_screw_mistakes,
    rotate_only,
    space_screw_mistakes,
    transform_screws,
)
from kincourse.mistakes.space_form import product
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler, are_distinguishable
from kincourse.sampling.configurations import Configuration, configuration_from_typed
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.lie import exp, homogeneous, inverse
from kinlib.view import draw_arm, draw_joints
from misstep.answers.order import Ordering
from misstep.display.text import matrix
from misstep.mistakes import mistake
from misstep.problem import Problem
from misstep.sheet import Sheet


@problem("04.1", "A body screw off a drawing", points=3, lecture="04_poe_body#A second method")
def body_screw_off_a_drawing(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RRR")
    while not are_distinguishable([robot.home[:3, 3], np.zeros(3), *robot.joint_points]):
        robot = sampler.arm("RRR")
    joint = sampler.integer(1, 3)
    B, neighbour = robot.body_screws[joint - 1], joint % 3
    return Problem(
        statement=f"Read the body screw of joint {joint} off the drawing: stand at {{b}}, and write the axis with the directions and the "
        "distances of {b}. All joints are revolute; coordinates are whole metres.",
        figure=partial(draw_joints, robot, tool=True),
        answer=ScrewsAnswer(B),
        mistakes=[
            *body_screw_mistakes(robot.screws[joint - 1], robot.home),
            mistake(
                "turned round",
                -B,
                "Your axis points the other way. The arrow in the drawing shows the positive turn, whoever reads it.",
            ),
            mistake(
                "another joint",
                robot.body_screws[neighbour],
                f"This is the body screw of joint {neighbour + 1}. Look for the number beside the joint.",
            ),
        ],
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
        mistakes=body_screw_mistakes(robot.screws, robot.home),
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
        mistakes=space_screw_mistakes(robot.body_screws, robot.home),
    )


@problem("04.4", "Where M stands", points=2, lecture="04_poe_body#The mid-formula form")
def where_home_stands(sampler: ArmSampler) -> Problem:
    names, k = sampler.shuffled("abcd"), sampler.integer(1, 2)
    listed = ", ".join(f"then comes joint {name}" for name in names[1:])
    factors = [f"e_{name}" for name in names]
    before, after = factors[:k], factors[k:]
    axes_in_space = f"axis of joint {names[0]} is" if k == 1 else f"axes of joints {names[0]} and {names[1]} are"
    return Problem(
        statement=f"Joint {names[0]} of an arm stands on the floor, {listed}, and the tool is last. "
        f"The {axes_in_space} read in {{s}}, all others in {{b}}. So $e_a$ is $e^{{[S_a]q_a}}$ or $e^{{[B_a]q_a}}$, and so on. Put the "
        "factors of $T(q)$ in order, from left to right: a list of the names `'e_a'`, `'e_b'`, `'e_c'`, `'e_d'`, `'M'`.",
        given={"from_floor_to_tool": names, "read_in_s": names[:k]},
        answer=Ordering([*before, "M", *after]),
        mistakes=[
            mistake(
                "home last",
                [*factors, "M"],
                "You put $M$ at the end, as in the space form. It stops where the reader changes: right of it stands what {b} reads.",
            ),
            mistake(
                "home first",
                ["M", *factors],
                "You put $M$ in front, as in the body form. It stops where the reader changes: left of it stands what {s} reads.",
            ),
            mistake(
                "body part reversed",
                [*before, "M", *after[::-1]],
                "You turned the part behind $M$ round. The tool reads the axes, but the joints keep their order.",
            ),
            mistake(
                "all reversed",
                [*factors[::-1][:k], "M", *factors[::-1][k:]],
                "You started at the tool. The joint next to the floor moves everything after it, so its factor stands leftmost.",
            ),
            mistake(
                "sides exchanged",
                [*after, "M", *before],
                "You exchanged the sides. What {s} reads stands to the left of $M$, and with it the joints next to the floor.",
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
        mistakes=body_product_mistakes(robot, q),
    )


@problem("04.6", "M in the middle", points=3, lecture="04_poe_body#The mid-formula form")
def home_in_the_middle(sampler: ArmSampler) -> Problem:
    robot, k = _random_arm(sampler, sampler.choice(["RRRR", "RRPR", "RPRR"])), 2
    typed, q, words = _random_configuration(sampler, robot)
    S, B, M = robot.screws, robot.body_screws, robot.home
    mixed = np.concatenate([S[:k], B[k:]])
    e = exp(mixed * q[:, None])
    in_degrees = exp(mixed * np.where(mixed[:, :3].any(axis=-1), np.degrees(q), q)[:, None])
    return Problem(
        statement=f"The first two joints of this arm are read in {{s}}, the others in {{b}}: below stand $S_1, S_2, B_3, B_4$. The joints "
        f"are at {words}. Give $T(q)$.\n\n$${matrix(mixed)}$$\n\n$$M = {matrix(M)}$$",
        figure=partial(draw_arm, robot),
        given={"screws": mixed, "home": M, "values": typed},
        answer=PoseAnswer(robot.fk(q)),
        mistakes=[
            mistake(
                "home last",
                product(mixed, q, M),
                "You put $M$ at the end. It stands between the last screw that {s} reads and the first that {b} reads.",
            ),
            mistake(
                "home first",
                product(mixed, q, M, "home first"),
                "You put $M$ in front. It stands between the last screw that {s} reads and the first that {b} reads.",
            ),
            mistake(
                "sides exchanged",
                e[2] @ e[3] @ M @ e[0] @ e[1],
                "You exchanged the sides. What {s} reads stands to the left of $M$, and with it the joints next to the base.",
            ),
            mistake(
                "body part reversed",
                e[0] @ e[1] @ M @ e[3] @ e[2],
                "You turned the part behind $M$ round. The tool reads the axes, but the joints keep their order.",
            ),
            mistake(
                "one joint late",
                e[0] @ e[1] @ e[2] @ M @ e[3],
                "You put $M$ after joint 3. Its screw is read in {b}, so $M$ has passed it: it stands behind joint 2.",
            ),
            mistake(
                "degrees",
                in_degrees[0] @ in_degrees[1] @ M @ in_degrees[2] @ in_degrees[3],
                "You used degrees as radians. The exponential wants radians; slides stay in metres.",
            ),
        ],
    )


@problem("04.7", "A new tool", points=3, lecture="04_poe_body#Check yourself")
def new_tool(sampler: ArmSampler) -> Problem:
    robot = _random_arm(sampler, sampler.choice(["RRP", "RPR", "PRR"]))
    turn = _rotation(sampler.choice([X, Y]), sampler.choice([30, 40, -50, -60, 70]))
    H = pose((X, Y, Z), (sampler.length(0.1, 0.4), 0, sampler.length(0.5, 0.9))) @ turn
    B, M = robot.body_screws, robot.home
    from_space = inverse(H @ M)
    return Problem(
        statement="The tool of this arm is replaced. The new one has its frame {t} where the old one saw $T_{bt}$. Below are the body "
        f"screws as {{b}} read them. Give them as {{t}} reads them.\n\n$$B = {matrix(B)}$$\n\n$$T_{{bt}} = {matrix(H)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "T_bt": H, "home": M},
        answer=ScrewsAnswer(transform_screws(inverse(H), B)),
        mistakes=[
            mistake(
                "the old ones",
                B,
                "These are the old body screws. The axes stay, and the space screws with them; but body screws are read by the tool, and "
                "another tool reads other numbers.",
            ),
            mistake(
                "the other way",
                transform_screws(H, B),
                "You carried the screws with $\\mathrm{Ad}_{T_{bt}}$. That takes what {t} reads to what {b} reads; here it is $T_{tb}$.",
            ),
            mistake(
                "only rotated",
                rotate_only(inverse(H), B),
                "You turned both halves, but {t} also stands elsewhere: its origin is another, so the moments change.",
            ),
            mistake(
                "moved in {s}",
                transform_screws(from_space, robot.screws),
                "You moved the tool along the axes of {s}: $T_{bt} M$. {t} is seen from {b}, so the new home pose is $M\\,T_{bt}$.",
            ),
            mistake(
                "space screws",
                robot.screws,
                "These are the space screws. They do not change with the tool, and the tool does not read them.",
            ),
        ],
    )


@problem("04.8", "A column of the body Jacobian", points=2, lecture="04_poe_body#Body screws and the body Jacobian")
def jacobian_column(sampler: ArmSampler) -> Problem:
    robot, i = _random_arm(sampler, sampler.choice(["RRRR", "RRPR", "PRRR"])), 1
    typed, q, words = _random_configuration(sampler, robot)
    B = robot.body_screws
    e = exp(B * q[:, None])
    in_degrees = exp(B * np.where(B[:, :3].any(axis=-1), np.degrees(q), q)[:, None])
    return Problem(
        statement=f"The joints of this arm stand at {words}. Give column {i + 1} of the body Jacobian: the axis of joint {i + 1}, as the "
        f"tool reads it now.\n\n$$B = {matrix(B)}$$",
        figure=partial(draw_arm, robot),
        given={"body_screws": B, "values": typed},
        answer=ScrewsAnswer(robot.body_jacobian(q)[:, i]),
        mistakes=[
            mistake(
                "at home",
                B[i],
                f"This is $B_{i + 1}$, read at home. Since then joints {i + 2} and {i + 3} have moved the tool.",
            ),
            mistake(
                "space column",
                robot.jacobian(q)[:, i],
                "This is the column of the space Jacobian: the axis as {s} reads it now.",
            ),
            mistake(
                "joints before",
                transform_screws(inverse(e[0]), B[i]),
                f"You carried the axis past joint 1. That joint moves axis {i + 1} and the tool alike: only joints between the two count.",
            ),
            mistake(
                "not inverted",
                transform_screws(e[2] @ e[3], B[i]),
                "The product is right, its inverse is missing: the tool has moved, so it reads backwards, $\\mathrm{Ad}^{-1}$.",
            ),
            mistake(
                "reversed",
                transform_screws(inverse(e[3] @ e[2]), B[i]),
                "You took the joints behind in the other order. Inside the inverse they stand as in the body form, joint 3 first.",
            ),
            mistake(
                "degrees",
                transform_screws(inverse(in_degrees[2] @ in_degrees[3]), B[i]),
                "You used degrees as radians. The exponential wants radians; slides stay in metres.",
            ),
        ],
    )


def _random_arm(sampler: ArmSampler, joint_types: str) -> Chain:
    """Draw an arm whose tool is rotated by an angle of the student's own, so that no rotation is its own inverse."""
    robot = sampler.arm(joint_types)
    home = robot.home @ _rotation(sampler.choice([X, Y, Z]), sampler.choice([20, 30, -40, 50, -60, 70]))
    return replace(robot, home=home)


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
