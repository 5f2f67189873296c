"""Drawings of frames and points, and of a rotation about a coordinate axis."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from kinlib.view.drawing.canvas import Canvas, view_axes
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text


def draw_frames(
    frames: Mapping[str, ArrayLike],
    points: Mapping[str, ArrayLike] | None = None,
    *,
    arrows: bool = True,
    alt: str | None = None,
    caption: str = "",
    around: ArrayLike | None = None,
    view: str = "default",
    numbers: bool = False,
    axis_length: float | None = None,
) -> Picture:
    """Draw frames by name, with an arrow from each to the next, and points by name.

    frames   {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame
    points   {"p": (x, y, z), ...} in that frame
    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off
    axis_length  the length of the axes in metres; by default a quarter of the size of what is shown

    Raises ValueError if a frame is not a pose, a point does not have three coordinates, or there is no frame.

    >>> draw_frames({"s": np.eye(4)}, {"p": (1, 0, 2)}).alt
    'Frame {s} at (0, 0, 0). Point p at (1, 0, 2).'
    """
    if not frames:
        raise ValueError("frames must contain at least one pose, such as {'s': np.eye(4)}; got none.")
    poses = {name: validation.poses(T, f"frame {name}") for name, T in frames.items()}
    places = {name: validation.vectors(p, f"point {name}", 3) for name, p in (points or {}).items()}
    origins = [T[:3, 3] for T in poses.values()]
    seen = np.array(
        [*origins, *places.values(), *(T[:3, 3] + 0.5 * T[:3, k] for T in poses.values() for k in range(3))]
    )
    if numbers:
        seen = np.concatenate([seen, seen * (1, 1, 0)])
    canvas = Canvas(seen if around is None else around, view)
    canvas.floor(seen if around is None else around, numbers=numbers)
    if numbers:
        canvas.measure(np.array([origin for origin in origins if origin.any()]).reshape(-1, 3), ORANGE)
    for start, end in pairwise(origins if arrows else []):
        canvas.arrow(start, end, GREY, 1.2, level=1)
    for name, T in poses.items():
        canvas.triad(T, name, axis_length or 0.25 * canvas.size)
    for name, p in places.items():
        canvas.dot(p)
        canvas.label(p, name, INK)
    return canvas.picture(alt or _describe(poses, places), caption, cropped=around is None)


def draw_rotation(axis: int, degrees: float, names: tuple[str, str] = ("a", "b")) -> Picture:
    """Draw two frames with a common origin and one common axis, seen along that axis, and the angle between them.

    axis     the common axis: 0 for x, 1 for y, 2 for z; y points away from the viewer, x and z towards the viewer
    degrees  the angle of the rotation about that axis that takes the first frame to the second, by the right-hand rule

    Raises ValueError if axis is not 0, 1 or 2.

    >>> draw_rotation(2, 30).alt
    'Frames {a} and {b} share their z axis, which points at you. x_b is x_a rotated by 30 degrees towards y_a.'
    """
    if axis not in range(3):
        raise ValueError(f"axis must be 0, 1 or 2, for x, y or z; got {axis!r}.")
    view = ("side", "front", "top")[axis]
    first, second = (axis + 1) % 3, (axis + 2) % 3
    R_ab = exp(np.radians(degrees) * np.eye(3)[axis])
    corners = [np.eye(3)[k] * sign for k in (first, second) for sign in (-1.1, 1.1)]
    canvas = Canvas(np.array(corners), view, size=(640, 360))
    for R, name, width in ((np.eye(3), names[0], 1.4), (R_ab, names[1], 2.6)):
        for k in (first, second):
            canvas.arrow(np.zeros(3), R[:, k], AXIS_COLOURS[k], width)
            canvas.label(1.12 * R[:, k], f"${'xyz'[k]}_{name}$", AXIS_COLOURS[k], [(0, 0)], 13)
    start, side = 0.55 * np.eye(3)[first], 0.55 * np.eye(3)[second]
    arc = [np.cos(t) * start + np.sin(t) * side for t in np.linspace(0, np.radians(degrees), 20)]
    canvas.line(arc[:-1], INK, 1.4, level=3)
    canvas.arrow(arc[-2], arc[-1], INK, 1.4)
    canvas.label(arc[10], f"{abs(degrees):.3g}°", INK, [(24, 0), (-24, 0), (0, 18), (0, -18)])
    facing = view_axes(view)[0][axis] > 0
    canvas.arrow(np.zeros(3), 0.5 * np.eye(3)[axis], AXIS_COLOURS[axis], 2.2, level=6)
    shared = "xyz"[axis]
    canvas.label(
        np.zeros(3), f"${shared}_{names[0]} = {shared}_{names[1]}$", AXIS_COLOURS[axis], [(-44, -16), (44, -16)]
    )
    towards = f"{'' if degrees > 0 else '-'}{'xyz'[second]}_{names[0]}"
    return canvas.picture(
        f"Frames {{{names[0]}}} and {{{names[1]}}} share their {shared} axis, which points {'at' if facing else 'away from'} you. "
        f"{'xyz'[first]}_{names[1]} is {'xyz'[first]}_{names[0]} rotated by {abs(degrees):.3g} degrees towards {towards}.",
        cropped=True,
    )


def _describe(poses: Mapping[str, Array], points: Mapping[str, Array]) -> str:
    sentences = [f"Frame {{{name}}} at {vector_text(T[:3, 3])}{_directions(T)}." for name, T in poses.items()]
    sentences += [f"Point {name} at {vector_text(p)}." for name, p in points.items()]
    return " ".join(sentences)


def _directions(T: Array) -> str:
    if np.allclose(T[:3, :3], np.eye(3)):
        return ""
    return f", its x along {vector_text(T[:3, 0])}, its z along {vector_text(T[:3, 2])}"
