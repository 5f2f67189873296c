"""The blank steps of lecture 03: a leaning joint, a helical joint, and a joint and the home pose of the youBot."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.space_form import screw_mistakes
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import X, Y, Z, angled_arm, pose, youbot
from kinlib.rigid.screw import screw
from misstep.mistakes import mistake
from misstep.problem import Problem

TILT_RAD = np.radians(30)
"""The tilt of joint 2 of the lecture's angled arm. At 45 degrees sine and cosine are equal, and a swap would not show."""


@problem("03.a", "A joint that leans by 30 degrees", points=1, lecture="03_poe_space#Angled joints")
def leaning_joint(_draw: ArmSampler) -> Problem:
    shoulder = np.array((0, 0, 0.4))
    S = angled_arm(TILT_RAD).screws[1]

    def leaning(z: float, x: float) -> np.ndarray:
        axis = z * Z + x * X
        return np.concatenate([axis, -np.cross(axis, shoulder)])

    return Problem(
        statement="Joint 2 leans from $z$ towards $x$ by 30 degrees and passes through $(0, 0, 0.4)$. Give $S_2$.",
        answer=ScrewsAnswer(S, names=["S_2"]),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "sine and cosine swapped",
                leaning(np.sin(TILT_RAD), np.cos(TILT_RAD)),
                "You swapped sine and cosine. At 0 degrees the joint stands along $z$, so $z$ gets the cosine.",
            ),
            mistake(
                "degrees",
                leaning(np.cos(30), np.sin(30)),
                "You gave degrees to a sine that wants radians. The axis is still of unit length, so the library cannot notice.",
            ),
            mistake(
                "leans the other way",
                leaning(np.cos(TILT_RAD), -np.sin(TILT_RAD)),
                "Your axis leans away from $x$. Towards $x$ means a positive share of $x$.",
            ),
            mistake(
                "not a unit axis",
                leaning(1.0, np.tan(TILT_RAD)),
                "Your $\\omega$ has the right direction and the wrong length: joint 2 would turn too fast. Divide by the norm "
                "before you take the moment.",
            ),
        ],
    )


@problem("03.b", "A spindle that misses the origin", points=1, lecture="03_poe_space#Helical joints")
def spindle(_draw: ArmSampler) -> Problem:
    axis, point, lead = X, np.array((0, 0.3, 0.2)), 0.5
    pitch = lead / (2 * np.pi)
    S = screw(axis, point, pitch)
    return Problem(
        statement="A spindle along $x$ passes through $(0, 0.3, 0.2)$; its nut advances 0.5 m in a full turn. Give its screw axis.",
        answer=ScrewsAnswer(S, names=["the screw axis"]),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "lead as pitch",
                screw(axis, point, lead),
                "You added the lead. The pitch is metres for each radian, and a full turn has $2\\pi$ of them: divide.",
            ),
            mistake(
                "multiplied by 2 pi",
                screw(axis, point, lead * 2 * np.pi),
                "You multiplied by $2\\pi$. One radian is less than a turn, so the pitch is less than the lead.",
            ),
            mistake(
                "no pitch",
                screw(axis, point),
                "This joint turns and stays where it is. A helical joint also travels: add $h\\,\\omega$ to $v$.",
            ),
            mistake(
                "only the pitch",
                np.concatenate([axis, pitch * axis]),
                "You have the travel $h\\,\\omega$, and not the moment: the spindle does not pass through the origin.",
            ),
        ],
    )


@problem("03.c", "Joint 4 of the youBot", points=1, lecture="03_poe_space#Screw axes from a drawing")
def youbot_wrist(_draw: ArmSampler) -> Problem:
    arm = youbot()
    S, wrist = arm.screws[3], arm.joint_points[3]
    return Problem(
        statement="Read $S_4$ off the drawing of the youBot.",
        answer=ScrewsAnswer(S, names=["S_4"]),
        mistakes=[
            *screw_mistakes(S),
            mistake(
                "turned round",
                -S,
                "Your axis points along $+y$. Point the thumb of your right hand along the arrow: this joint lifts the hand.",
            ),
            mistake(
                "the elbow",
                arm.screws[2],
                "This is joint 3. The axes are parallel, so $\\omega$ is the same, and the point makes the difference.",
            ),
            mistake(
                "no shoulder",
                screw(-Y, wrist - 0.033 * X),
                "Your point is 0.033 m short: joint 2 does not stand above joint 1.",
            ),
            mistake(
                "on the floor",
                screw(-Y, wrist * (1, 1, 0)),
                "You took the foot of the dotted line. The joint is 0.147 m above it.",
            ),
        ],
    )


@problem("03.d", "The youBot's home pose", points=1, lecture="03_poe_space#The home pose")
def youbot_home(_draw: ArmSampler) -> Problem:
    M = youbot().home
    tip, wrist = M[:3, 3], youbot().joint_points[3]
    return Problem(
        statement="The hand points along $x$ of {s}, 0.2175 m beyond joint 4. Its own $z$ points along $x$ of {s}, its own $x$ "
        "along $z$ of {s}. Give $M$.",
        answer=PoseAnswer(M),
        mistakes=[
            mistake(
                "parallel to {s}",
                pose((X, Y, Z), tip),
                "Your hand stands parallel to {s}. The columns of the rotation are the hand's axes, written in {s}.",
            ),
            mistake(
                "left-handed",
                pose((Z, Y, X), tip),
                "Your hand is a mirror image. With $x$ and $z$ chosen, $y = z \\times x$ is no longer free: here it is $-y$ of {s}.",
            ),
            mistake(
                "at the wrist",
                pose((Z, -Y, X), wrist),
                "The rotation is right. You stopped at joint 4; the frame {b} sits at the tip, 0.2175 m further.",
            ),
            mistake(
                "no shoulder",
                pose((Z, -Y, X), tip - 0.033 * X),
                "The rotation is right. The position is 0.033 m short: joint 2 does not stand above joint 1.",
            ),
            mistake(
                "seen from the hand",
                np.linalg.inv(M),
                "This is $M^{-1}$, the base seen from the hand. $M = T_{sb}$ takes the hand's coordinates to {s}.",
            ),
        ],
    )


BLANKS = [leaning_joint, spindle, youbot_wrist, youbot_home]
