"""The blank steps of lecture 10: a body screw of the first arm of the UIUC deck, and two origins of its URDF."""

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.space_form import negate_moment, swap_halves
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import rpr
from kinlib.rigid.lie import adjoint, inverse
from misstep.mistakes import mistake
from misstep.problem import Problem

ARM = rpr()
JOINTS, TOOL = ARM.joint_points, ARM.home[:3, 3]


@problem("10.a", "A body screw", points=1, lecture="04_poe_body#The adjoint")
def body_screw(_draw: ArmSampler) -> Problem:
    S, M, B = ARM.screws[2], ARM.home, ARM.body_screws[2]
    return Problem(
        statement="Give the body screw $B_3$ of the UIUC deck's first arm.",
        answer=ScrewsAnswer(B),
        mistakes=[
            mistake(
                "adjoint of M",
                adjoint(M) @ S,
                "You used $\\mathrm{Ad}_M$, which leads from {b} to {s}. The other way is $\\mathrm{Ad}_{M^{-1}}$.",
            ),
            mistake("space screw", S, "This is $S_3$, seen from {s}. From the tool the same line has other numbers."),
            mistake(
                "only the rotation",
                np.concatenate([M[:3, :3].T @ S[:3], M[:3, :3].T @ S[3:]]),
                "You turned $\\omega$ and $v$ and left out where {b} stands. A moment depends on the origin: the adjoint has a "
                "block $[p] R$.",
            ),
            mistake(
                "omega x q",
                negate_moment(B),
                "Your $v$ has the wrong sign: seen from {b} too, it is $-\\omega \\times p$.",
            ),
            mistake("halves swapped", swap_halves(B), "You wrote $(v, \\omega)$. Here a screw is $(\\omega, v)$."),
        ],
    )


@problem("10.b", "An origin in a file", points=1, lecture="09_urdf#From the file to screws")
def origin_of_joint_3(_draw: ArmSampler) -> Problem:
    step = JOINTS[2] - JOINTS[1]
    return Problem(
        statement="With all frames parallel to {s}, give the `xyz` of joint 3.",
        answer=VectorsAnswer(step, unit="m"),
        mistakes=[
            mistake(
                "from the base",
                JOINTS[2],
                "This is where joint 3 stands in {s}. A file writes where it stands in the frame of the joint before, at "
                "$(-4, -2, 0)$.",
            ),
            mistake("way back", -step, "This leads from joint 3 back to joint 2. An origin is seen from the parent."),
            mistake(
                "the wrong parent",
                JOINTS[2] - TOOL,
                "You measured from the tool. The parent of joint 3 is the link that joint 2 carries.",
            ),
        ],
    )


@problem("10.c", "The last step to the tool", points=1, lecture="09_urdf#From the file to screws")
def origin_of_tool(_draw: ArmSampler) -> Problem:
    step = TOOL - JOINTS[2]
    return Problem(
        statement="With the frame of joint 3 parallel to {s}, give the `xyz` of the fixed joint to the tool.",
        answer=VectorsAnswer(step, unit="m"),
        mistakes=[
            mistake(
                "from the base",
                TOOL,
                "This is the tool in {s}, the last column of $M$. The file counts from joint 3, at $(0, -4, 0)$.",
            ),
            mistake("way back", -step, "This leads from the tool back to joint 3. An origin is seen from the parent."),
            mistake(
                "seen from the tool",
                -(inverse(ARM.home) @ np.append(JOINTS[2], 1.0))[:3],
                "You have the right step, read in the axes of {b}. The `xyz` of an origin is read in the parent's axes, here "
                "those of {s}.",
            ),
        ],
    )


BLANKS = [body_screw, origin_of_joint_3, origin_of_tool]
