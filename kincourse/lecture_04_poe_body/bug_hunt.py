"""What the bug hunt of lecture 04 finds. It is here because a cell that repairs the lines would tell what is wrong."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import exp


def errors_of_lines(arm: Chain) -> str:
    """Return how wrong the printed lines are for an arm with four joints, in three cases, and the third line repaired."""
    cases = {
        "some configuration": (arm, np.array([0.4, 0.5, 0.6, 0.7])),
        "at home": (arm, np.zeros(4)),
        "arm with M = I": (Chain(arm.screws, np.eye(4)), np.array([0.4, 0.5, 0.6, 0.7])),
    }
    lines = ["largest error    second line   third line   third line without its second M"]
    for name, (robot, q) in cases.items():
        gaps = [np.abs(line - robot.fk(q)).max() for line in _lines(robot, q)]
        lines.append(f"{name:18}{gaps[0]:7.3f}{gaps[1]:13.3f}{gaps[2]:33.3f}")
    return "\n".join(lines)


def _lines(arm: Chain, q: Array) -> tuple[Array, Array, Array]:
    E, F, M = exp(arm.screws * q[:, None]), exp(arm.body_screws * q[:, None]), arm.home
    return E[0] @ M @ F[3], E[0] @ E[1] @ M @ F[2] @ M @ F[3], E[0] @ E[1] @ M @ F[2] @ F[3]
