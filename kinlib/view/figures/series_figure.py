"""Motions along screws, drawn: the exponential series as a walk to its goal, and the way that a frame goes."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp, hat
from kinlib.rigid.screw import axes, is_prismatic, line
from kinlib.view.drawing.canvas import GREY, INK, ORANGE, PALE, VIOLET, Canvas
from kinlib.view.drawing.picture import Picture, spoken

WAYS = (("#0b5cad", "-"), ("#b35900", "--"), ("#1a7f37", ":"), ("#1f2328", "-."))
"""Colour and dash of each way: never told apart by colour alone."""


def series_walk(S: ArrayLike, q: float, point: ArrayLike, terms: int) -> Array:
    """Where the first 1, 2, ... terms of e^[S]q = I + [S]q + [S]^2 q^2 / 2! + ... take a point, (terms, 3).

    Raises ValueError for what is no screw axis, for no term at all, and for a point of another size.

    >>> series_walk([0, 0, 1, 0, 0, 0], 1.0, [1, 0, 0], 3)
    array([[1. , 0. , 0. ],
           [1. , 1. , 0. ],
           [0.5, 1. , 0. ]])
    """
    if terms < 1:
        raise ValueError(f"terms counts from 1, the identity; got {terms!r}.")
    step = hat(axes(S, "S") * q)
    term = np.append(validation.vectors(point, "point", 3), 1.0)
    walk = [term]
    for k in range(1, terms):
        term = step @ term / k
        walk.append(walk[-1] + term)
    return np.array(walk)[:, :3]


def draw_series(
    S: ArrayLike, q: float, point: ArrayLike, terms: int, *, most: int | None = None, view: str = "default"
) -> Picture:
    """Draw the first terms of e^[S]q as arrows, head to tail, from a point towards where the motion takes it.

    S     (6,) the axis of a revolute joint
    most  how many terms the picture leaves room for, so that pictures of different sums share one scale

    The pale circle is where every turn about S would put the point: a sum that ends off it is no rotation.

    Raises ValueError for a screw axis that is not that of a turn, and for no term at all.

    >>> from kinlib.chains.robots import rpr
    >>> draw_series(rpr().screws[0], np.pi / 2, (0, 0, 1), 2).alt        # doctest: +NORMALIZE_WHITESPACE
    'Terms of the exponential as arrows, head to tail, for a turn of 90 degrees. The first 2 take the point from
    (0, 0, 1) to (-1.57, 0, 7.28). That is 4.75 m from its goal (-5, 0, 4), and 3.55 m off the circle.'
    """
    S = axes(S, "S")
    axis, foot, pitch = line(S)
    if abs(pitch) > validation.UNIT:
        raise ValueError(f"draw_series draws turns, in a plane; got a screw axis of pitch {pitch:g}.")
    walk = series_walk(S, q, point, max(terms, most or terms))
    circle = _way(S * 2 * np.pi, walk[0])
    goal, reached = _way(S * q, walk[0])[-1], walk[terms - 1]
    seen = np.concatenate([walk, circle])
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    canvas = Canvas(
        middle + 0.7 * (seen - middle), view
    )  # no axes and frames reach out here: most of the margin may go
    canvas.line(circle, PALE, 2.0, level=1)
    canvas.line(_way(S * q, walk[0]), GREY, 3.0, level=1.5)
    centre = foot + axis * (axis @ (walk[0] - foot))
    canvas.dot(centre, VIOLET, 6)
    canvas.label(centre, "$S$", VIOLET)
    for k in range(1, terms):
        colour = (VIOLET, ORANGE)[k % 2]
        canvas.arrow(walk[k - 1], walk[k], colour, 1.6)
        if np.linalg.norm(walk[k] - walk[k - 1]) > 0.06 * canvas.size:
            canvas.label((walk[k - 1] + walk[k]) / 2, str(k), colour, size=9)
    canvas.dot(goal, GREY, 9, level=4)
    canvas.label(goal, "goal", GREY)
    canvas.dot(walk[0], INK, 4)
    canvas.dot(reached, INK, 6)
    canvas.label(reached, "sum", INK)
    far = float(np.linalg.norm(reached - goal))
    off = float(np.linalg.norm(reached - centre) - np.linalg.norm(walk[0] - centre))
    told = f"{_metres(far)} from its goal"
    alt = (
        f"Terms of the exponential as arrows, head to tail, for a turn of {np.degrees(q):.4g} degrees. "
        f"The first {terms} take the point from {spoken(walk[0])} to {spoken(reached)}. "
        f"That is {told} {spoken(goal)}, and {_metres(abs(off))} off the circle."
    )
    caption = f"{terms} term{'s' * (terms > 1)}: the sum is {told}, {_metres(abs(off))} off the circle"
    return canvas.picture(alt, caption)


def draw_motions(
    start: ArrayLike, motions: Mapping[str, ArrayLike], caption: str = "", view: str = "default"
) -> Picture:
    """Draw how a frame goes from its start along twists, one way for each name.

    start    (4, 4) the pose {a} from which all ways begin
    motions  {"name": x, ...}, twists (6,) in {s}; each way runs through exp(x t) start for t from 0 to 1

    Raises ValueError for what is no pose or no twist, for no motion, and for more than there are ways to tell apart.

    >>> from kinlib.chains.robots import hrr
    >>> draw_motions(hrr().home, {"spindle": hrr().screws[0] * 10}).alt  # doctest: +NORMALIZE_WHITESPACE
    'A frame starts at (0.8, 0, 0) m. Way "spindle": a turn by 573 degrees about (0, 0, 1), 1 m along it, to
    (-0.671, -0.435, 1).'
    """
    T = validation.poses(start, "start")
    if not 0 < len(motions) <= len(WAYS):
        raise ValueError(f"motions should name 1 to {len(WAYS)} twists; got {len(motions)}.")
    twists = {name: validation.vectors(x, f"motion {name}", 6) for name, x in motions.items()}
    ways = {name: _way(x, T[:3, 3]) for name, x in twists.items()}
    feet = [_axis(x)[1] for x in twists.values() if x[:3].any()]
    canvas = Canvas(np.concatenate([*ways.values(), *(np.atleast_2d(foot) for foot in feet)]), view)
    canvas.floor(np.concatenate(list(ways.values())))
    drawn: list[Array] = []
    for (name, way), (colour, dash) in zip(ways.items(), WAYS, strict=False):
        x = twists[name]
        if x[:3].any():
            _draw_axis(canvas, x, way)
        canvas.line(way, colour, 2.2, dash, level=3)
        canvas.label(way[len(way) // 3], name, colour, size=10)
        end = exp(x) @ T
        if not any(np.allclose(end, other) for other in drawn):
            drawn.append(end)
            canvas.triad(end, "b" if len(ways) == 1 else "", 0.16 * canvas.size)
    canvas.triad(T, "a", 0.16 * canvas.size)
    said = " ".join(f'Way "{name}": {_said(x)}, to {spoken((exp(x) @ T)[:3, 3])}.' for name, x in twists.items())
    return canvas.picture(f"A frame starts at {spoken(T[:3, 3])} m. {said}", caption)


def _way(x: Array, point: Array) -> Array:
    """Points of a motion (m, 3): where exp(x t) takes a point, t from 0 to 1."""
    turns = float(np.linalg.norm(x[:3])) / (2 * np.pi)
    t = np.linspace(0, 1, 3 + int(48 * turns))
    T = exp(t[:, None] * x)
    return T[:, :3, :3] @ point + T[:, :3, 3]


def _axis(x: Array) -> tuple[Array, Array, float]:
    """Direction, nearest point and pitch of a twist that turns."""
    axis, foot, pitch = line(x / np.linalg.norm(x[:3]))
    return axis, foot, float(pitch)


def _draw_axis(canvas: Canvas, x: Array, way: Array) -> None:
    axis, foot, _ = _axis(x)
    along = (way - foot) @ axis
    low, high = along.min() - 0.15 * canvas.size, along.max() + 0.25 * canvas.size
    canvas.line([foot + low * axis, foot + high * axis], VIOLET, 1.3, "--", level=1)
    canvas.arrow(foot + (high - 0.01 * canvas.size) * axis, foot + high * axis, VIOLET, 1.3)


def _said(x: Array) -> str:
    if is_prismatic(x):
        return f"a slide by {np.linalg.norm(x[3:]):.3g} m"
    axis, _, pitch = _axis(x)
    angle = float(np.linalg.norm(x[:3]))
    along = f", {pitch * angle:.3g} m along it" if abs(pitch) > validation.UNIT else ""
    return f"a turn by {np.degrees(angle):.3g} degrees about {spoken(axis)}{along}"


def _metres(x: float) -> str:
    if x < 1e-12:
        return "less than 1e-12 m"  # from there on, the digits are those of the machine and not of the series
    return f"{x:.1e} m" if x < 1e-3 else f"{x:.3g} m"
