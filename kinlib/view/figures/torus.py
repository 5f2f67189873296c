"""Drawings of the configuration space of two angles: curves on a torus that is cut open into a square.

Both angles repeat after a full turn, so the left edge of the square is also its right edge, and the lower edge the upper one.
"""

import re
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.angles import wrap_angle
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import GREY, INK, PALE_GREY
from kinlib.view.drawing.picture import Picture

CURVE_STYLES = (("#7d3ac1", "-"), ("#b35900", "--"), ("#0b5cad", ":"))
"""Colour and dash of each curve, so that curves do not differ by colour alone."""

SQUARE_PX, LEFT_PX, TOP_PX = 330.0, 62.0, 16.0
"""The side of the square, and the margins to its left and above it, in pixels."""

TICKS_DEG = (-180, -90, 0, 90, 180)


def draw_torus(
    curves: Mapping[str, ArrayLike],
    marks: Mapping[str, ArrayLike] | None = None,
    *,
    xlabel: str,
    ylabel: str,
    alt: str,
    caption: str = "",
) -> Picture:
    """Draw curves of two angles on the square from -180 to 180 degrees.

    curves  {"name": (m, 2)} angles in radians; each has its own colour and dash, and its name beside it
    marks   {"name": (2,)} points to mark and label, in radians

    The text alternative is alt, and where the marks are.

    Raises ValueError if there are more curves than line styles, or a curve or mark has another shape or contains NaN.

    >>> t = np.linspace(0, 2 * np.pi, 50)
    >>> draw_torus({"once round": np.stack([t, 0.5 * np.sin(t)], 1)}, xlabel="A", ylabel="D", alt="A wave, once round the torus.").alt
    'A wave, once round the torus.'
    """
    if len(curves) > len(CURVE_STYLES):
        raise ValueError(
            f"curves must have at most {len(CURVE_STYLES)} entries, one per line style; got {len(curves)}."
        )
    drawn = [svg.polygon(_place(np.array([[-180, -180], [180, -180], [180, 180], [-180, 180]])), "white", GREY)]
    for tick in TICKS_DEG:
        lines = np.array([[(tick, -180), (tick, 180)], [(-180, tick), (180, tick)]])
        drawn += [svg.polyline(_place(line), PALE_GREY, 1) for line in lines]
        feet = _place(lines[:, 0]) + np.array([(0, 12), (-20, 0)])
        drawn += [svg.text(foot, f"{tick}°", INK, 11) for foot in feet]
    drawn.append(svg.text([LEFT_PX + SQUARE_PX / 2, TOP_PX + SQUARE_PX + 30], xlabel, INK, 12))
    drawn.append(svg.text([LEFT_PX + 26, TOP_PX - 7], ylabel, INK, 12))
    placed = {
        name: _place(np.degrees(wrap_angle(validation.vectors(p, f"mark {name}", 2))))
        for name, p in (marks or {}).items()
    }
    paths = {
        name: split_where_wrapped(validation.vectors(points, f"curve {name}", 2)) for name, points in curves.items()
    }
    labels: list[str] = []
    for (name, pieces), (colour, dash) in zip(paths.items(), CURVE_STYLES, strict=False):
        drawn += [svg.polyline(_place(piece), colour, 2.2, dash) for piece in pieces]
        others = [_place(piece) for other, theirs in paths.items() if other != name for piece in theirs]
        labels.append(
            svg.text(_label_place(_place(np.concatenate(pieces)), list(placed.values()), others), name, colour, 12)
        )
    drawn += labels
    for name, centre in placed.items():
        drawn += [svg.circle(centre, 5, INK), svg.text([centre[0], centre[1] + 14], name, INK, 12)]
    places = [
        f"{name} is at {xlabel} = {angles[0]:.0f}°, {ylabel} = {angles[1]:.0f}°."
        for name, angles in (
            (name, np.degrees(wrap_angle(np.asarray(p, dtype=float)))) for name, p in (marks or {}).items()
        )
    ]
    return Picture(
        svg.document(drawn, LEFT_PX + SQUARE_PX + 24, TOP_PX + SQUARE_PX + 46), " ".join([alt, *places]), caption
    )


def side_by_side(left: Picture, right: Picture, caption: str = "") -> Picture:
    """Combine two pictures side by side into one.

    >>> from kinlib.view import draw_arm
    >>> from kinlib.chains.robots import rpr
    >>> side_by_side(draw_arm(rpr()), draw_arm(rpr())).alt.count("RPR, 3 joints")
    2
    """
    (w, h), (v, g) = _size(left), _size(right)
    shifted = right.svg.replace("<svg ", f'<svg x="{w:g}" ', 1)
    return Picture(svg.document([left.svg, shifted], w + v, max(h, g)), f"{left.alt} Beside it: {right.alt}", caption)


def split_where_wrapped(points: Array) -> list[Array]:
    """Split a curve of angles (m, 2) in radians where it leaves the square, into pieces (k, 2) in degrees.

    >>> [len(piece) for piece in split_where_wrapped(np.radians([[160.0, 0], [170, 0], [190, 0], [200, 0], [210, 0]]))]
    [2, 3]
    """
    angles = np.degrees(wrap_angle(points))
    leaves = (np.abs(np.diff(angles, axis=0)) > 180).any(axis=1)
    return np.split(angles, np.flatnonzero(leaves) + 1)


def _label_place(points: Array, marks: list[Array], others: list[Array]) -> Array:
    """Return the place of a curve's label in pixels: above that point of the curve that is farthest from marks and other curves."""
    inside = points[(np.abs(points[:, 0] - LEFT_PX - SQUARE_PX / 2) < 0.36 * SQUARE_PX) & (points[:, 1] > TOP_PX + 22)]
    candidates = (inside if len(inside) else points) - (0, 12)
    avoided = np.concatenate([np.zeros((1, 2)), *others, *(mark[None] for mark in marks)])
    distance = np.linalg.norm(candidates[:, None] - avoided, axis=-1).min(axis=1)
    place: Array = candidates[int(np.argmax(distance))]
    return place


def _place(degrees: Array) -> Array:
    """Convert angles (..., 2) in degrees to pixels on the sheet."""
    share = (np.asarray(degrees) + 180) / 360
    place: Array = np.stack([LEFT_PX + SQUARE_PX * share[..., 0], TOP_PX + SQUARE_PX * (1 - share[..., 1])], axis=-1)
    return place


def _size(picture: Picture) -> tuple[float, float]:
    found = re.match(r'<svg [^>]*?width="([\d.]+)" height="([\d.]+)"', picture.svg)
    if found is None:
        raise ValueError(
            "side_by_side takes drawings made by kinlib.view, whose svg begins with width and height in pixels."
        )
    return float(found[1]), float(found[2])
