"""What the bug hunt of lecture 03 finds. It is here because a cell that corrects the values would tell which are wrong."""

import numpy as np

from kinlib.chains.chain import Chain
from kinlib.chains.robots import rpr


def corrections() -> str:
    """Return what the library says of the printed values, and what they should be."""
    printed, s_1 = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0]]), np.array([4, 0, 0, 0, 0, 0])
    said = []
    for screws, home in zip((s_1[None], rpr().screws), (np.eye(4), printed), strict=True):
        try:
            Chain(screws, home)
        except ValueError as error:
            said.append(str(error))
    M = printed.copy()
    M[3, 3] = 1  # not I: one number
    M[2, :3] = np.cross(printed[0, :3], printed[1, :3])  # two rows of a rotation determine the third one
    s_1 = np.append([0, -1, 0], -np.cross([0, -1, 0], [-4, -2, 0])) + 0
    return "\n".join([*said, f"\n{np.sum(printed != M)} entries corrected; M =", str(M), f"s_1 = {s_1}"])
