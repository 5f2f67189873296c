"""Sheet 03: screw axes of all types of joints in the space frame, and their product of exponentials."""

from dataclasses import replace
from functools import partial

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.space_form import (
    negate_moment,
    prismatic_as_revolute,
    product,
    product_mistakes,
    screw_mistakes,
)
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.chains.robots import SLIDE, X, Y, Z, angled_arm, arm, pose
from kinlib.rigid.screw import screw
from kinlib.view import draw_arm, draw_joints
from misstep.answers.function import Function, function_mistakes
from misstep.answers.order import Ordering
from misstep.display.text import matrix, number, vector
from misstep.mistakes import Mistake, mistake
from misstep.problem import Problem
from misstep.sheet import Sheet


@problem("03.1", "Screw axes of a plain arm", points=3, lecture="03_poe_space#Revolute joints")
def plain_arm(sampler: ArmSampler) -> Problem:
    robot = sampler.arm(sampler.choice(["RRP", "RPR", "PRR"]))
    axes = robot.lines.axis
    return Problem(
        statement=f"Give the screw axes $S_1, S_2, S_3$ of this arm in {{s}}, as rows.\n\n{joint_table(robot)}",
        figure=partial(draw_joints, robot),
        given={"letters": robot.joint_types, "axes": axes, "points": robot.joint_points},
        answer=ScrewsAnswer(robot.screws),
        mistakes=[
            *screw_mistakes(robot.screws),
            mistake(
                "slide as turn",
                prismatic_as_revolute(robot),
                "You treated the slide as a turn. A prismatic joint has no $\\omega$: $S = (0, d)$, and no point plays a part.",
            ),
            mistake(
                "slide as turn, and omega x q",
                negate_moment(prismatic_as_revolute(robot)),
                "Two things: a moment is $-\\omega \\times p$, with the minus; and a slide has none, for it does not turn: $S = (0, d)$.",
            ),
        ],
    )


@problem("03.2", "A joint at an angle", points=3, lecture="03_poe_space#Angled joints")
def angled_joint(sampler: ArmSampler) -> Problem:
    degrees, point = sampler.choice([20, 25, 30, 35, 55, 60, 65, 70]), sampler.point(3)
    tilt = np.radians(degrees)
    upright, toward, names = sampler.choice([(Z, X, "zx"), (Z, Y, "zy"), (X, Y, "xy"), (Y, X, "yx")])

    def leaning(cosine: float, sine: float) -> np.ndarray:
        axis = cosine * upright + sine * toward
        return np.concatenate([axis, np.cross(point, axis)])

    S = screw(np.cos(tilt) * upright + np.sin(tilt) * toward, point)
    robot = arm([(S[:3], point)], pose((X, Y, Z), point + X), "your joint", "drawn for you")
    return Problem(
        statement=f"A revolute joint leans from ${names[0]}$ towards ${names[1]}$ by {degrees} degrees. Its axis passes "
        f"through ${vector(point)}$. Give its screw axis.",
        figure=partial(draw_joints, robot),
        given={"degrees": degrees, "from_axis": upright, "towards": toward, "point": point},
        answer=ScrewsAnswer(S),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "sine and cosine swapped",
                leaning(np.sin(tilt), np.cos(tilt)),
                f"You swapped sine and cosine. At 0 degrees the axis is ${names[0]}$, so ${names[0]}$ gets the cosine.",
            ),
            mistake(
                "leans the other way",
                leaning(np.cos(tilt), -np.sin(tilt)),
                f"Your axis leans away from ${names[1]}$. The share of ${names[1]}$ is positive.",
            ),
            mistake(
                "degrees",
                leaning(np.cos(degrees), np.sin(degrees)),
                "You gave degrees to a sine that wants radians: use np.radians first.",
            ),
            mistake(
                "not a unit axis",
                leaning(1.0, np.tan(tilt)),
                "Your $\\omega$ has the right direction and the wrong length. Divide it by its norm before you take the moment.",
            ),
        ],
    )


@problem("03.3", "A slide at an angle", points=3, lecture="03_poe_space#Prismatic joints")
def leaning_slide(sampler: ArmSampler) -> Problem:
    sides = np.array(sampler.shuffled([0, *sampler.choice([(3, 4), (5, 12), (8, 15)])]), dtype=float)
    direction = sides * np.array([sampler.choice((-1, 1)) for _ in range(3)])
    d, point = direction / np.linalg.norm(direction), sampler.point(3)
    S = screw(d, pitch=SLIDE)
    robot = arm([(d, point, SLIDE)], pose((X, Y, Z), point + d), "your slide", "drawn for you")
    return Problem(
        statement=f"A prismatic joint is mounted at ${vector(point)}$ and slides along ${vector(direction)}$. Give its screw axis.",
        figure=partial(draw_joints, robot),
        given={"direction": direction, "point": point},
        answer=ScrewsAnswer(S),
        mistakes=[
            mistake(
                "direction in omega",
                np.concatenate([d, np.zeros(3)]),
                "You put the direction into $\\omega$: that is a turn about a line through the origin. A slide is $(0, d)$.",
            ),
            mistake(
                "as a turn",
                screw(d, point),
                "You wrote the screw axis of a turn about this line. A slide does not turn: $\\omega = 0$, and $v$ is the direction.",
            ),
            mistake(
                "not a unit direction",
                np.concatenate([np.zeros(3), direction]),
                "Your $v$ has the right direction and the wrong length: so one unit of $q$ would not be one metre. Divide by the norm.",
            ),
            mistake(
                "moment of the point",
                np.concatenate([np.zeros(3), np.cross(point, d)]),
                "You took a moment. Every point of the body slides alike, so where the slide is mounted plays no part.",
            ),
        ],
    )


@problem("03.4", "A helical joint", points=3, lecture="03_poe_space#Helical joints")
def helical_joint(sampler: ArmSampler) -> Problem:
    axis, point, lead = sampler.choice([X, Y, Z, -X, -Y, -Z]), sampler.point(3), sampler.length(0.2, 0.9)
    S = screw(axis, point, lead / (2 * np.pi))
    robot = arm([(axis, point, lead / (2 * np.pi))], pose((X, Y, Z), point + axis), "your spindle", "drawn for you")
    return Problem(
        statement=f"A spindle along ${vector(axis)}$ passes through ${vector(point)}$. In one full turn its nut climbs "
        f"{number(lead)} m along the axis, right-handed. Give the screw axis, for $q$ in radians.",
        figure=partial(draw_joints, robot),
        given={"axis": axis, "point": point, "lead": lead},
        answer=ScrewsAnswer(S),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "lead taken as pitch",
                screw(axis, point, lead),
                "You used the climb of a full turn as the pitch. The pitch is metres for each radian: divide by $2\\pi$.",
            ),
            mistake(
                "no climb",
                screw(axis, point),
                "This joint turns and does not climb. Add the pitch along the axis: $v = -\\omega \\times p + h\\,\\omega$.",
            ),
            mistake(
                "left-handed",
                screw(axis, point, -lead / (2 * np.pi)),
                "Your nut climbs the wrong way. A right-handed spindle moves along $+\\omega$ as it turns about $+\\omega$.",
            ),
        ],
    )


@problem("03.5", "A screw axis from a drawing", points=3, lecture="03_poe_space#Screw axes from a drawing")
def from_a_drawing(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RRR")
    joint = sampler.integer(1, 3)
    S, axis, point = robot.screws[joint - 1], robot.screws[joint - 1, :3], robot.joint_points[joint - 1]
    neighbour = joint % 3
    return Problem(
        statement=f"Read the screw axis of joint {joint} off the drawing. All joints are revolute; coordinates are whole metres.",
        figure=partial(draw_joints, robot),
        answer=ScrewsAnswer(S),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "turned round",
                -S,
                "Your axis points the other way, so your joint turns the other way. The arrow in the drawing shows the positive turn.",
            ),
            mistake(
                "another joint",
                robot.screws[neighbour],
                f"This is the screw axis of joint {neighbour + 1}. Look for the number beside the joint.",
            ),
            mistake(
                "another joint's point",
                screw(axis, robot.joint_points[neighbour]),
                f"The direction is right, but you took the point of joint {neighbour + 1}.",
            ),
            mistake(
                "coordinates swapped",
                screw(axis, point[[1, 0, 2]]),
                "You swapped the point's $x$ and $y$. Follow the dotted line to the floor, then read along each axis.",
            ),
        ],
    )


@problem("03.6", "In which order?", points=3, lecture="03_poe_space#The order of the factors")
def which_order(sampler: ArmSampler) -> Problem:
    names = sampler.shuffled("abcd")
    rides_on = sampler.shuffled([(names[0], "floor"), *zip(names[1:], names[:-1], strict=True)])
    listed = "\n".join(
        f"- Joint {name} stands on the floor."
        if under == "floor"
        else f"- Joint {name} rides on the link that joint {under} moves."
        for name, under in rides_on
    )
    return Problem(
        statement=f"The joints of an arm were named as they were built:\n\n{listed}\n- The tool rides on joint {names[3]}.\n\n"
        "With $e_a = e^{[S_a]q_a}$ and so on, and space screws, put the factors of $T(q)$ in order, from left to right: "
        "a list of the names `'e_a'`, `'e_b'`, `'e_c'`, `'e_d'`, `'M'`.",
        given={"rides_on": dict(rides_on)},
        answer=Ordering([*(f"e_{name}" for name in names), "M"]),
        mistakes=[
            mistake(
                "reversed",
                [*(f"e_{name}" for name in names[::-1]), "M"],
                "You started at the tool. The joint nearest the base moves everything after it, so its factor stands leftmost.",
            ),
            mistake(
                "home first",
                ["M", *(f"e_{name}" for name in names)],
                "You put $M$ in front. It acts on the tool's own coordinates first, so with space screws it stands on the right.",
            ),
            mistake(
                "read from right to left",
                ["M", *(f"e_{name}" for name in names[::-1])],
                "You wrote the factors in the order in which they act. In a product the first to act stands on the right.",
            ),
            mistake(
                "by the alphabet",
                ["e_a", "e_b", "e_c", "e_d", "M"],
                "You followed the names. Follow the arm instead, from the floor to the tool: names carry no order.",
            ),
        ],
    )


@problem("03.7", "Where is the tool, at any q?", points=3, lecture="03_poe_space#The product")
def where_is_the_tool(sampler: ArmSampler) -> Problem:
    robot = sampler.arm(sampler.choice(["RRR", "RPR", "RRP"]))

    def joint_values(chance: np.random.Generator) -> tuple[np.ndarray]:
        return (chance.uniform(0.3, 1.3, 3) * chance.choice([-1, 1], 3),)

    return Problem(
        statement="This arm has the screws $S_i$ and the home pose $M$ below. Write a function that takes $q$, three numbers in "
        "radians and metres, and gives $T(q)$. The check calls it with values of its own.\n\n"
        f"$$S = {matrix(robot.screws)}, \\qquad M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"screws": robot.screws, "home": robot.home},
        answer=Function(robot.fk, PoseAnswer(robot.home), joint_values),
        mistakes=[
            *function_mistakes(partial(product_mistakes, robot), np.ones(3)),
            Mistake(
                "stays at home",
                lambda _: robot.home,
                "Your function gives the home pose, whatever $q$ is. Does the loop over the joints change the product?",
            ),
        ],
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
    extension = pose((X, Y, Z), longer * Z)
    return Problem(
        statement=f"The tool of this arm is replaced by one that reaches {number(longer)} m further along the tool's own $z$. "
        f"Give the new tool's $T(q)$ at $q = {vector(q)}$.\n\n$$S = {matrix(robot.screws)}, \\qquad M = {matrix(robot.home)}$$",
        figure=partial(draw_arm, robot),
        given={"screws": robot.screws, "home": robot.home, "longer": longer, "q": q},
        answer=PoseAnswer(robot.fk(q) @ extension),
        mistakes=[
            mistake(
                "the old tool",
                robot.fk(q),
                "This is where the old tool ends. The screws stay; the home pose changes to $M' = M\\,\\mathrm{Trans}_z$.",
            ),
            mistake(
                "extended in {s}",
                extension @ robot.fk(q),
                "You lengthened the tool along the $z$ of {s}, after the motion. The tool's own $z$ turns with it: multiply on the right.",
            ),
            mistake(
                "extended in {s} at home",
                replace(robot, home=extension @ robot.home).fk(q),
                "You lengthened $M$ along the $z$ of {s}: $\\mathrm{Trans}_z\\, M$. Its own $z$ is a column of $M$: multiply on the right.",
            ),
            mistake(
                "reversed",
                product(robot.screws, q, robot.home @ extension, "reversed"),
                "The new $M$ is right, but you multiplied from the last joint to the first. Joint 1 stands leftmost.",
            ),
            mistake(
                "home first",
                product(robot.screws, q, robot.home @ extension, "home first"),
                "The new $M$ is right, but you put it in front. With space screws it stands on the right.",
            ),
        ],
    )


SHEET = Sheet(
    "03_poe_space",
    "The product of exponentials in the space frame",
    [
        plain_arm,
        angled_joint,
        leaning_slide,
        helical_joint,
        from_a_drawing,
        which_order,
        where_is_the_tool,
        longer_tool,
    ],
)
