"""The product of two factors for each row along an arm, whose partial products are the frames of both conventions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.view.viewer.steps import Motion, Steps, Track, play_tracks


def play_walk(rows: ArrayLike, *, after: Any = None) -> Steps:
    """Play the product Z_1 X_1 Z_2 X_2 ... along an arm, with the frames of both conventions.

    rows   (m, 4) standard rows a, alpha, d, theta; each is two factors, and each factor is one screw motion
    after  a question; the picture stays covered until a prediction is committed

    The pose after Z_i is frame i of the modified convention, the pose after X_i is frame i of the standard one.

    >>> player = play_walk([[0.4, 0, 0.1, 0]])
    >>> player.at = 2
    >>> player.alt
    'Motions that move a frame: 2 of 2 done. The moving frame is at (0.4, 0, 0.1), x along x, y along y, z along z.'
    """
    motions, spans, names = [], [], {0: ("0", "0")}
    for i, (a, alpha, d, theta) in enumerate(np.atleast_2d(validation.vectors(rows, "rows", 4)), start=1):
        along, across = f"Z_{i}: along and about the axis of joint {i}.", f"X_{i}: along and about the common normal."
        motions += [
            Motion("z", theta, d, f"Z_{i}", f"Z{i}", f"{along} Frame {i} of the modified convention is here."),
            Motion("x", alpha, a, f"X_{i}", f"X{i}", f"{across} Frame {i} of the standard convention is here."),
        ]
        spans.append((f"axis {i}", 2 * i - 2, 2 * i - 1))
        names |= {2 * i - 1: (f"{i}", f"{i} mod"), 2 * i: (f"{i}", f"{i} std")}
    return play_tracks({"": Track(motions, spans, names)}, after)
