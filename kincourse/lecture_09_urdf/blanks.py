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
        statement="Where does the lamp's joint `tilt` stand in {s}, at home?",
        answer=VectorsAnswer(np.array([0.0, 0.0, 0.8]), unit="m"),
        mistakes=[
            mistake(
                "read in the base",
                [0.0, -0.4, 0.0],
                "You took the origin as it stands. It is read in the frame of the parent link, the rod, which is rolled and raised.",
            ),
            mistake(
                "added without turning",
                [0.0, -0.4, 0.4],
                "You added the step to where the rod starts, and did not turn it. The rod's $-y$ is the base's $z$.",
            ),
            mistake(
                "turned the other way",
                [0.0, 0.0, 0.0],
                "You turned the step the other way: rolled by $-90°$, the rod's $y$ points down, so its $-y$ points up.",
            ),
            mistake(
                "one joint left out",
                [0.0, 0.0, 0.7],
                "You left out the first origin: the post stands 0.1 m above the desk.",
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
                "You took `0 0 1` as it stands. An axis is written in the joint's own frame, and that frame is rolled: its $z$ is "
                "the base's $y$.",
            ),
            mistake(
                "turned the other way",
                screw(-Y, p),
                "Your axis points the other way. Rolled by $-90°$ about $x$, $z$ goes to $+y$.",
            ),
            mistake(
                "the joint before",
                screw(Y, (0, 0, 0.4)),
                "This is the screw axis of `lean`. `tilt` points the same way, and stands 0.4 m higher.",
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
                "You stopped at the last joint that moves. The socket is a fixed joint, and a pose all the same: "
                "$M = J_3 O_{\\text{tip}}$.",
            ),
            mistake(
                "weld without its turn",
                rolled @ origin((0.1, 0, 0)),
                "You shifted by the socket's `xyz` and left out its `rpy`.",
            ),
            mistake(
                "weld on the left",
                origin((0.1, 0, 0), (RIGHT_ANGLE_RAD, 0, 0)) @ rolled,
                "You multiplied the socket from the left. It is read in the shade's frame, so it stands on the right.",
            ),
        ],
    )


@problem("09.d", "A rotation from three angles", points=1, lecture="09_urdf#Roll, pitch and yaw")
def rotation_of_rpy(_draw: ArmSampler) -> Problem:
    rpy = (0, RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)
    right = origin(rpy=rpy)[:3, :3].round()
    own = (origin(rpy=(0, RIGHT_ANGLE_RAD, 0)) @ origin(rpy=(0, 0, RIGHT_ANGLE_RAD)))[:3, :3].round()
    return Problem(
        statement='Write `rpy="0 1.5708 1.5708"` as a rotation, (3, 3).',
        answer=RotationAnswer(right),
        mistakes=[
            mistake(
                "about its own axes",
                own,
                "You pitched, and then yawed about the frame's own $z$: $R_y R_z$. The axes are fixed, so the yaw stands left: $R_z R_y$.",
            ),
            mistake(
                "transposed",
                right.T,
                "This is $R^T$. The columns of $R$ are the turned axes, seen from the parent.",
            ),
            mistake(
                "the other way",
                origin(rpy=(0, -RIGHT_ANGLE_RAD, -RIGHT_ANGLE_RAD))[:3, :3].round(),
                "You turned against the right hand: a positive pitch takes $z$ to $x$, a positive yaw takes $x$ to $y$.",
            ),
        ],
    )


BLANKS = [place_of_tilt, screw_of_tilt, home_of_the_lamp, rotation_of_rpy]
