"""The blank steps of lecture 09: a joint of the lamp in the base frame, its screw axis, the home pose, and one rotation."""

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.screws import direction, revolute
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.rpy import origin
from kinlib.rigid.screw import screw
from misstep.mistakes import mistake
from misstep.mutants.expression import given
from misstep.problem import Problem

RIGHT_ANGLE_RAD = np.pi / 2


@problem("09.a", "A joint in the base frame", points=1, lecture="09_urdf#A worked example")
def place_of_tilt(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give the position of the origin of the lamp's joint `tilt` in {s} when all joint values are 0.",
        answer=VectorsAnswer(np.array([0.0, 0.0, 0.8]), unit="m"),
        mistakes=[
            mistake(
                "read in the base",
                [0.0, -0.4, 0.0],
                "You gave the `xyz` of the file as it is. It is the position in the frame of the parent link, the rod, and this frame is "
                "above the desk and rotated.",
            ),
            mistake(
                "added without rotating",
                [0.0, -0.4, 0.4],
                "You added the `xyz` to the position of `lean` without rotating it. The $-y$ direction of the rod "
                "is the $z$ direction of {s}.",
            ),
            mistake(
                "rotated the other way",
                [0.0, 0.0, 0.0],
                "You rotated the `xyz` in the opposite direction. After a roll by $-90°$ the rod's $y$ axis points down, so $-y$ is up.",
            ),
            mistake(
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
        answer=ScrewsAnswer(S.value),
        solution=S,
        mistakes=[
            mistake(
                "axis read in the base",
                screw(Z, p),
                "You took `0 0 1` as the direction in {s}. An `axis` is given in the joint's own frame, and this frame is rotated: its "
                "$z$ axis is the $y$ axis of {s}.",
            ),
            mistake(
                "rotated the other way",
                screw(-Y, p),
                "Your axis has the opposite direction. A roll by $-90°$ about $x$ rotates $z$ to $+y$.",
            ),
            mistake(
                "the joint before",
                screw(Y, (0, 0, 0.4)),
                "This is the screw axis of `lean`. The axis of `tilt` has the same direction, but it is 0.4 m higher.",
            ),
        ],
    )


@problem("09.c", "The home pose from a file", points=1, lecture="09_urdf#From the file to screws")
def home_of_the_lamp(_draw: ArmSampler) -> Problem:
    rolled = origin((0, 0, 0.8), (-RIGHT_ANGLE_RAD, 0, 0))
    return Problem(
        statement="Give the home pose $M$ of the lamp's bulb.",
        answer=PoseAnswer(pose((X, Y, Z), (0.1, 0, 0.8))),
        mistakes=[
            mistake(
                "weld forgotten",
                rolled,
                "You stopped at the last joint that moves. The socket is a fixed joint, but it has a pose as well: "
                "$M = P_1 P_2 P_3 P_{\\text{tip}}$.",
            ),
            mistake(
                "weld without its rotation",
                rolled @ origin((0.1, 0, 0)),
                "You used the `xyz` of the socket and left out its `rpy`.",
            ),
            mistake(
                "weld on the left",
                origin((0.1, 0, 0), (RIGHT_ANGLE_RAD, 0, 0)) @ rolled,
                "You multiplied by the pose of the socket from the left. It is given in the frame of the shade, so it is the last factor.",
            ),
        ],
    )


@problem("09.d", "A rotation from three angles", points=1, lecture="09_urdf#Roll, pitch and yaw")
def rotation_of_rpy(_draw: ArmSampler) -> Problem:
    rpy = (0, RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)
    right = origin(rpy=rpy)[:3, :3].round()
    own = (origin(rpy=(0, RIGHT_ANGLE_RAD, 0)) @ origin(rpy=(0, 0, RIGHT_ANGLE_RAD)))[:3, :3].round()
    return Problem(
        statement='Write `rpy="0 1.5708 1.5708"` as a rotation matrix, an array of shape (3, 3).',
        answer=RotationAnswer(right),
        mistakes=[
            mistake(
                "about its own axes",
                own,
                "You rotated by the pitch and then by the yaw about the frame's own $z$ axis: $R_y R_z$. The axes of `rpy` are fixed, so "
                "the yaw is the left factor: $R_z R_y$.",
            ),
            mistake(
                "transposed",
                right.T,
                "This is $R^T$. The columns of $R$ are the axes of the joint frame in the frame of the parent.",
            ),
            mistake(
                "the other way",
                origin(rpy=(0, -RIGHT_ANGLE_RAD, -RIGHT_ANGLE_RAD))[:3, :3].round(),
                "You rotated by the left-hand rule. By the right-hand rule a positive pitch rotates $z$ to $x$, and a positive yaw "
                "$x$ to $y$.",
            ),
        ],
    )


BLANKS = [place_of_tilt, screw_of_tilt, home_of_the_lamp, rotation_of_rpy]
