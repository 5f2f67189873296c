"""The blank steps of lecture 09: a joint of the lamp in the base frame, its screw axis, the home pose, and one rotation."""

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import pose
from kincourse.expressions.screws import direction, revolute
from kincourse.expressions.urdf import rpy_rotation
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import Y, Z
from kinlib.rigid.rpy import origin
from kinlib.rigid.screw import screw
from misstep.mistakes import Mistake
from misstep.mutants.expression import given

RIGHT_ANGLE_RAD = np.pi / 2


@problem("09.a", "A joint in the base frame", points=1, lecture="09_urdf#A worked example")
def place_of_tilt(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give the position of the origin of the lamp's joint `tilt` in {s} when all joint values are 0.",
        answer=VectorsAnswer(np.array([0.0, 0.0, 0.8]), unit="m"),
        mistakes=[
            Mistake(
                "read in the base",
                [0.0, -0.4, 0.0],
                "You gave the `xyz` of the file as it is. It is the position in the frame of the parent link, the rod, and this frame is "
                "above the desk and rotated.",
            ),
            Mistake(
                "added without rotating",
                [0.0, -0.4, 0.4],
                "You added the `xyz` to the position of `lean` without rotating it. The $-y$ direction of the rod "
                "is the $z$ direction of {s}.",
            ),
            Mistake(
                "rotated the other way",
                [0.0, 0.0, 0.0],
                "You rotated the `xyz` in the opposite direction. After a roll by $-90°$ the rod's $y$ axis points down, so $-y$ is up.",
            ),
            Mistake(
                "one joint left out",
                [0.0, 0.0, 0.7],
                "You left out the first origin: the frame of the post is 0.1 m above that of the desk.",
            ),
        ],
    )


@problem("09.b", "A screw axis from a file", points=1, lecture="09_urdf#From the file to screws")
def screw_of_tilt(_draw: ArmSampler) -> Problem:
    p = np.array([0.0, 0.0, 0.8])
    S = revolute(direction("\\omega", Y), given("p", p))
    return Problem(
        statement="Give the screw axis of the lamp's joint `tilt` in {s}.",
        answer=ScrewsAnswer(S),
        mistakes=[
            Mistake(
                "axis read in the base",
                screw(Z, p),
                "You took `0 0 1` as the direction in {s}. An `axis` is given in the joint's own frame, and this frame is rotated: its "
                "$z$ axis is the $y$ axis of {s}.",
            ),
            Mistake(
                "rotated the other way",
                screw(-Y, p),
                "Your axis has the opposite direction. A roll by $-90°$ about $x$ rotates $z$ to $+y$.",
            ),
            Mistake(
                "the joint before",
                screw(Y, (0, 0, 0.4)),
                "This is the screw axis of `lean`. The axis of `tilt` has the same direction, but it is 0.4 m higher.",
            ),
        ],
    )


@problem("09.c", "The home pose from a file", points=1, lecture="09_urdf#From the file to screws")
def home_of_the_lamp(_draw: ArmSampler) -> Problem:
    socket = pose("P_{\\text{tip}}", origin((0.1, 0, 0), (RIGHT_ANGLE_RAD, 0, 0)))
    M = pose("P_1\\,P_2\\,P_3", origin((0, 0, 0.8), (-RIGHT_ANGLE_RAD, 0, 0))) @ socket
    return Problem(
        statement="Give the home pose $M$ of the lamp's bulb.",
        answer=PoseAnswer(M),
        advice={
            "leave out $P_{\\text{tip}}$": "The socket is a fixed joint, but it has a pose as well.",
            "rotation left out": "The `rpy` of the socket is a part of its pose.",
            "order": "The pose of the socket is given in the frame of the shade, so it is the last factor.",
        },
    )


@problem("09.d", "A rotation from three angles", points=1, lecture="09_urdf#Roll, pitch and yaw")
def rotation_of_rpy(_draw: ArmSampler) -> Problem:
    return Problem(
        statement='Write `rpy="0 1.5708 1.5708"` as a rotation matrix, an array of shape (3, 3).',
        answer=RotationAnswer(rpy_rotation("R", np.array([0, RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD]))),
        advice={
            "own axes": "The axes of `rpy` are fixed, so the yaw is the left factor: $R_z R_y$.",
            "rotation transposed": "The columns of $R$ are the axes of the joint frame in the frame of the parent.",
        },
    )
