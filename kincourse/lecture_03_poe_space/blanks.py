"""The blank steps of lecture 03: a leaning joint, a helical joint, and a joint and the home pose of the youBot."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import assemble, columns
from kincourse.expressions.screws import direction, helical, moment, revolute, screw, tilted
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import X, Y, Z, youbot
from misstep.mutants.expression import given
from misstep.mutants.operations import radians

SHOULDER_ADVICE = "Joint 2 is 0.033 m away from the axis of joint 1."


@problem("03.a", "A joint tilted by 30 degrees", points=1, lecture="03_poe_space#Angled joints")
def leaning_joint(_draw: ArmSampler) -> Problem:
    # At 45 degrees sine and cosine are equal, so a swap would not show; twice 30 degrees is a swap.
    tilt = given("\\tau", 30.0).mistaken_for(("sign of an angle", "take $\\tau$ with the opposite sign", -30.0))
    omega = tilted(given("z", Z), given("x", X), radians(tilt)).named("\\omega")
    S = screw(omega, moment(omega, given("p", (0, 0, 0.4))))
    return Problem(
        statement="The axis of joint 2 is tilted from $z$ towards $x$ by 30 degrees and passes through $(0, 0, 0.4)$. Give $S_2$.",
        answer=ScrewsAnswer(S, names=["S_2"]),
        advice={
            "sign of an angle": "An axis tilted towards $x$ has a positive component along $x$.",
            "degrees": "The sine and the cosine need radians. The wrong axis still has unit length, so the library cannot "
            "detect the mistake.",
        },
    )


@problem("03.b", "A helical joint away from the origin", points=1, lecture="03_poe_space#Helical joints")
def spindle(_draw: ArmSampler) -> Problem:
    pitch = (given("l", 0.5) / given("2\\pi", 2 * np.pi)).named("h")
    S = helical(direction("\\omega", X), given("p", (0, 0.3, 0.2)), pitch)
    return Problem(
        statement="The axis of a helical joint has the direction $x$ and passes through $(0, 0.3, 0.2)$. The joint advances 0.5 "
        "m in a full turn. Give its screw axis.",
        answer=ScrewsAnswer(S, names=["the screw axis"]),
        advice={
            "divisor left out": "The pitch is in metres per radian, so it is the lead divided by $2\\pi$: $h = l / 2\\pi$.",
            "product for division": "One radian is less than a full turn, so the pitch is less than the lead.",
            "no moment": "The axis does not pass through the origin, so it has a moment.",
        },
    )


@problem("03.c", "Joint 4 of the youBot", points=1, lecture="03_poe_space#Screw axes from a drawing")
def youbot_wrist(_draw: ArmSampler) -> Problem:
    arm = youbot()
    wrist = arm.joint_points[3]
    p = given("p", wrist).mistaken_for(
        ("offset left out", "take a point 0.033 m too close to the base", wrist - 0.033 * X, SHOULDER_ADVICE),
        ("foot of the dotted line", "take the foot of the dotted line as the point", wrist * (1, 1, 0)),
    )
    S = revolute(direction("\\omega", -Y), p).mistaken_for(
        ("another joint", "give the screw axis of joint 3", arm.screws[2])
    )
    return Problem(
        statement="Read $S_4$ off the drawing of the youBot.",
        answer=ScrewsAnswer(S, names=["S_4"]),
        advice={
            "foot of the dotted line": "The joint is 0.147 m above it.",
            "another joint": "The axes are parallel, so $\\omega$ is the same, but the points differ.",
            "sign of a vector": "The arrow of joint 4 points along $-y$. If you point the thumb of your right hand along it, the fingers "
            "show the positive rotation, which lifts the end-effector.",
        },
    )


@problem("03.d", "The youBot's home pose", points=1, lecture="03_poe_space#The home pose")
def youbot_home(_draw: ArmSampler) -> Problem:
    tip, wrist = youbot().home[:3, 3], youbot().joint_points[3]
    R = columns(direction("x", Z), given("y", -Y), direction("z", X)).mistaken_for(
        ("left-handed", "take the $y$ of {s} as the $y$ of {b}, a left-handed frame", np.column_stack([Z, Y, X]))
    )
    p = given("p", tip).mistaken_for(
        ("at the wrist", "stop at joint 4", wrist, "The frame {b} is at the tip, 0.2175 m further."),
        ("offset left out", "take a position 0.033 m too close to the base", tip - 0.033 * X, SHOULDER_ADVICE),
    )
    M = assemble(R, p)
    return Problem(
        statement="The origin of {b} is at the tip of the end-effector, 0.2175 m beyond joint 4 along the $x$ of {s}. The $z$ "
        "axis of {b} points along the $x$ "
        "of {s}, and the $x$ axis of {b} along the $z$ of {s}. Give $M$.",
        answer=PoseAnswer(M),
        advice={
            "left-handed": "The axes $x$ and $z$ of {b} determine its third axis: $y = z \\times x$, here $-y$ of {s}.",
            "rotation left out": "The columns of the rotation are the axes of {b}, written in {s}.",
            "inverse": "$M^{-1} = T_{bs}$ gives the base in the frame {b}. $M = T_{sb}$ takes coordinates in {b} to {s}.",
        },
        invisible=["axes in rows"],  # R = R^T here
    )
