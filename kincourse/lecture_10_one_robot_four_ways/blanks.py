"""The blank steps of lecture 10: a body screw of the RPR arm, and two origins of its URDF."""

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse, pose
from kincourse.expressions.screws import change_frame, screw_axes
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import rpr
from misstep.mutants.expression import given

ARM = rpr()
JOINTS, TOOL = ARM.joint_points, ARM.home[:3, 3]
SEEN_FROM_THE_PARENT = "An origin is given in the frame of the parent."


@problem("10.a", "A body screw", points=1, lecture="04_poe_body#The adjoint")
def body_screw(_draw: ArmSampler) -> Problem:
    B = change_frame(inverse(pose("M", ARM.home)), screw_axes("S_3", ARM.screws[2]))
    return Problem(
        statement="Give the body screw $B_3$ of the RPR arm.",
        answer=ScrewsAnswer(B),
        invisible=["sign of v"],  # the moment of S_3 is zero
        advice={
            "inverse left out": "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here.",
            "frame not changed": "This is the screw axis in {s}. In {b} the same line has other numbers.",
            "position left out": "A moment depends on the origin: the adjoint of a pose with $R$ and $p$ has the block $[p] R$.",
        },
    )


@problem("10.b", "An origin in a file", points=1, lecture="09_urdf#From the file to screws")
def origin_of_joint_3(_draw: ArmSampler) -> Problem:
    p_2 = given("p_2", JOINTS[1]).mistaken_for(
        ("the wrong parent", "measure from the tool", TOOL, "The parent of joint 3 is the link that joint 2 moves.")
    )
    step = given("p_3", JOINTS[2]) - p_2
    step = step.mistaken_for(
        ("opposite direction", "take the vector from joint 3 to joint 2", -step, SEEN_FROM_THE_PARENT)
    )
    return Problem(
        statement="With all frames parallel to {s}, give the `xyz` of joint 3.",
        answer=VectorsAnswer(step, unit="m"),
        advice={
            "leave out $-p_2$": "In a URDF the origin of joint 3 is given in the frame of joint 2, which is at $(-4, -2, 0)$."
        },
    )


@problem("10.c", "The last step to the tool", points=1, lecture="09_urdf#From the file to screws")
def origin_of_tool(_draw: ArmSampler) -> Problem:
    step = given("p_b", TOOL) - given("p_3", JOINTS[2])
    step = step.mistaken_for(
        ("opposite direction", "take the vector from the tool to joint 3", -step, SEEN_FROM_THE_PARENT),
        ("axes of the tool", "give the components along the axes of {b}", ARM.home[:3, :3].T @ step),
    )
    return Problem(
        statement="With the frame of joint 3 parallel to {s}, give the `xyz` of the fixed joint to the tool.",
        answer=VectorsAnswer(step, unit="m"),
        advice={
            "axes of the tool": "The `xyz` of an origin has its components along the parent's axes, which are parallel to those "
            "of {s} here.",
            "leave out $-p_3$": "This is the position in $M$, measured from {s}. The file measures it from joint 3, at $(0, -4, 0)$.",
        },
    )
