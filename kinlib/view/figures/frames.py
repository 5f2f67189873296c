"""Drawings of frames."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, ORANGE
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text


def draw_frames(
    frames: Mapping[str, ArrayLike],
    *,
    arrows: bool = True,
    numbers: bool = False,
) -> Picture:
    """Draw frames by name, with an arrow from each to the next.

    frames   {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame
    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off

    Raises ValueError if a frame is not a pose.

    >>> draw_frames({"s": np.eye(4)}).alt
    'Frame {s} at (0, 0, 0), x along x, y along y, z along z.'
    """
    poses = {name: validation.poses(T, f"frame {name}") for name, T in frames.items()}
    origins = [T[:3, 3] for T in poses.values()]
    seen = np.array([*origins, *(T[:3, 3] + 0.5 * T[:3, k] for T in poses.values() for k in range(3))])
    if numbers:
        seen = np.concatenate([seen, seen * (1, 1, 0)])
    canvas = Canvas(seen)
    canvas.floor(seen, numbers=numbers)
    if numbers:
        canvas.measure(np.array([origin for origin in origins if origin.any()]).reshape(-1, 3), ORANGE)
    for start, end in pairwise(origins if arrows else []):
        canvas.arrow(start, end, GREY, 1.2, level=1)
    for name, T in poses.items():
        canvas.triad(T, name, 0.25 * canvas.size)
    return canvas.picture(" ".join(map(frame_text, poses.items())), cropped=True)
