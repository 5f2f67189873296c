"""Frames and points, drawn: which frame is which, and where each one stands in another."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib import check
from kinlib.check import Array
from kinlib.view.canvas import GREY, INK, Canvas
from kinlib.view.picture import Picture, spoken


def draw_frames(
    frames: Mapping[str, ArrayLike],
    points: Mapping[str, ArrayLike] | None = None,
    *,
    arrows: bool = True,
    alt: str | None = None,
    caption: str = "",
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw frames by name, with an arrow from each to the next, and points by name.

    frames  {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame
    points  {"p": (x, y, z), ...} in that frame

    Raises ValueError for what is no pose, and for nothing to draw.

    >>> draw_frames({"s": np.eye(4)}, {"p": (1, 0, 2)}).alt
    'Frame {s} at (0, 0, 0). Point p at (1, 0, 2).'
    """
    if not frames:
        raise ValueError("frames should name at least one pose, such as {'s': np.eye(4)}; got none.")
    poses = {name: check.poses(T, f"frame {name}") for name, T in frames.items()}
    places = {name: check.vectors(p, f"point {name}", 3) for name, p in (points or {}).items()}
    origins = [T[:3, 3] for T in poses.values()]
    seen = np.array(
        [*origins, *places.values(), *(T[:3, 3] + 0.5 * T[:3, k] for T in poses.values() for k in range(3))]
    )
    canvas = Canvas(seen if around is None else around, view)
    canvas.floor(seen if around is None else around)
    for start, end in pairwise(origins if arrows else []):
        canvas.arrow(start, end, GREY, 1.2, level=1)
    for name, T in poses.items():
        canvas.triad(T, name, 0.25 * canvas.size)
    for name, p in places.items():
        canvas.dot(p)
        canvas.label(p, name, INK)
    return canvas.picture(alt or _in_words(poses, places), caption)


def _in_words(poses: Mapping[str, Array], points: Mapping[str, Array]) -> str:
    said = [f"Frame {{{name}}} at {spoken(T[:3, 3])}{_turned(T)}." for name, T in poses.items()]
    said += [f"Point {name} at {spoken(p)}." for name, p in points.items()]
    return " ".join(said)


def _turned(T: Array) -> str:
    if np.allclose(T[:3, :3], np.eye(3)):
        return ""
    return f", its x along {spoken(T[:3, 0])}, its z along {spoken(T[:3, 2])}"
