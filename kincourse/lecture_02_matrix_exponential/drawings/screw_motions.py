"""Drawings of screw motions: the paths of a frame along one or several twists."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from kinlib.rigid.screw import is_prismatic, line
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

MOTION_STYLES = (("#0b5cad", "-"), ("#b35900", "--"), ("#1a7f37", ":"), ("#1f2328", "-."))
"""Colour and dash of each path, so that paths do not differ by colour alone."""


def draw_motions(start: ArrayLike, motions: Mapping[str, ArrayLike]) -> Picture:
    """Draw the paths of a frame along twists.

    start    (4, 4) the pose {a} at which all motions start
    motions  {"name": x, ...}, twists (6,) in {s}; the pose at time t, from 0 to 1, is exp(x t) start

    >>> draw_motions(kl.robots.hrr().home, {"screw": kl.robots.hrr().screws[0] * 10}).alt  # doctest: +NORMALIZE_WHITESPACE
    'A frame starts at (0.8, 0, 0) m. Motion "screw": a rotation by 573 degrees about (0, 0, 1), 1 m along it, to
    (-0.671, -0.435, 1).'
    """
    T = np.asarray(start, dtype=float)
    twists = {name: np.asarray(x, dtype=float) for name, x in motions.items()}
    paths = {name: motion_path(x, T[:3, 3]) for name, x in twists.items()}
    feet = [_axis(x)[1] for x in twists.values() if x[:3].any()]
    canvas = Canvas(np.concatenate([*paths.values(), *(np.atleast_2d(foot) for foot in feet)]))
    canvas.floor(np.concatenate(list(paths.values())))
    drawn: list[Array] = []
    for (name, path), (colour, dash) in zip(paths.items(), MOTION_STYLES, strict=False):
        x = twists[name]
        if x[:3].any():
            axis, foot, _ = _axis(x)
            along = (path - foot) @ axis
            low, high = along.min() - 0.15 * canvas.size, along.max() + 0.25 * canvas.size
            canvas.line([foot + low * axis, foot + high * axis], VIOLET, 1.3, "--", level=1)
            canvas.arrow(foot + (high - 0.01 * canvas.size) * axis, foot + high * axis, VIOLET, 1.3)
        canvas.line(path, colour, 2.2, dash, level=3)
        canvas.label(path[len(path) // 3], name, colour, size=10)
        end = exp(x) @ T
        if not any(np.allclose(end, other) for other in drawn):
            drawn.append(end)
            canvas.triad(end, "b" if len(paths) == 1 else "", 0.16 * canvas.size)
    canvas.triad(T, "a", 0.16 * canvas.size)
    sentences = " ".join(
        f'Motion "{name}": {_describe(x)}, to {vector_text((exp(x) @ T)[:3, 3])}.' for name, x in twists.items()
    )
    return canvas.picture(f"A frame starts at {vector_text(T[:3, 3])} m. {sentences}", cropped=True)


def motion_path(x: Array, point: Array) -> Array:
    """Return points (m, 3) of the path of a point under exp(x t), for t from 0 to 1."""
    revolutions = float(np.linalg.norm(x[:3])) / (2 * np.pi)
    t = np.linspace(0, 1, 3 + int(48 * revolutions))
    T = exp(t[:, None] * x)
    return T[:, :3, :3] @ point + T[:, :3, 3]


def _axis(x: Array) -> tuple[Array, Array, float]:
    """Return direction, nearest point and pitch of a twist with a rotation."""
    axis, foot, pitch = line(x / np.linalg.norm(x[:3]))
    return axis, foot, float(pitch)


def _describe(x: Array) -> str:
    if is_prismatic(x):
        return f"a translation by {np.linalg.norm(x[3:]):.3g} m"
    axis, _, pitch = _axis(x)
    angle = float(np.linalg.norm(x[:3]))
    along = f", {pitch * angle:.3g} m along it" if abs(pitch) > tolerances.UNIT_LENGTH_TOL else ""
    return f"a rotation by {np.degrees(angle):.3g} degrees about {vector_text(axis)}{along}"
