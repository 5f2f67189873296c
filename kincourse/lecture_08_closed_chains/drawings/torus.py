"""Drawings of the configuration space of two angles: curves on a torus that is cut open into a square.

Both angles repeat after a full revolution, so the left edge of the square is also its right edge, and the lower edge the upper one.
"""

import re
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.rigid.angles import wrap_angle
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import GREY, INK, PALE_GREY
from kinlib.view.drawing.labels import LABEL_OFFSETS, Label, Offset, place_labels
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
) -> Picture:
    """Draw curves of two angles on the square from -180 to 180 degrees.

    curves  {"name": (m, 2)} angles in radians; each has its own colour and dash, and its name beside it
    marks   {"name": (2,)} points to mark and label, in radians

    >>> t = np.linspace(0, 2 * np.pi, 50)
    >>> curve = np.stack([t, 0.5 * np.sin(t)], 1)
    >>> print(draw_torus({"wave": curve}, {"now": curve[7]}, xlabel="A", ylabel="D").alt)    # doctest: +NORMALIZE_WHITESPACE
    The square of all angles A and D, whose opposite edges are the same. Curve "wave": A from -176° to 176°, D from -28.6° to
    28.6°. now is at A = 51.4°, D = 22.4°.
    """
    drawn = [svg.polygon(_place(np.array([[-180, -180], [180, -180], [180, 180], [-180, 180]])), "white", GREY)]
    for tick in TICKS_DEG:
        lines = np.array([[(tick, -180), (tick, 180)], [(-180, tick), (180, tick)]])
        drawn += [svg.polyline(_place(line), PALE_GREY, 1) for line in lines]
        feet = _place(lines[:, 0]) + np.array([(0, 12), (-20, 0)])
        drawn += [svg.text(foot, f"{tick}°", INK, 11) for foot in feet]
    drawn.append(svg.text([LEFT_PX + SQUARE_PX / 2, TOP_PX + SQUARE_PX + 30], xlabel, INK, 12))
    drawn.append(svg.text([LEFT_PX + 26, TOP_PX - 7], ylabel, INK, 12))
    placed = {name: np.degrees(wrap_angle(np.asarray(p))) for name, p in (marks or {}).items()}
    pieces = {name: split_where_wrapped(np.asarray(p)) for name, p in curves.items()}
    labels = []
    for (name, parts), (colour, dash) in zip(pieces.items(), CURVE_STYLES, strict=False):
        drawn += [svg.polyline(_place(piece), colour, 2.2, dash) for piece in parts]
        labels.append(Label(np.zeros(2), name, colour, _label_offsets(_place(np.concatenate(parts))), 12))
    for name, mark in placed.items():
        drawn.append(svg.circle(_place(mark), 5, INK))
        labels.insert(0, Label(_place(mark), name, INK, LABEL_OFFSETS, 12))
    strokes = [np.stack([line[:-1], line[1:]], axis=1) for parts in pieces.values() for line in map(_place, parts)]
    discs = np.array([[_place(mark) - 5, _place(mark) + 5] for mark in placed.values()]).reshape(-1, 2, 2)
    sheet = np.array([LEFT_PX + SQUARE_PX + 24, TOP_PX + SQUARE_PX + 46])
    inside = np.array([LEFT_PX + SQUARE_PX, TOP_PX + SQUARE_PX])
    for label, centre in place_labels(labels, np.concatenate([np.zeros((0, 2, 2)), *strokes]), discs, inside):
        drawn.append(svg.text(centre, label.text, label.colour, label.size))
    places = [f"{name} is at {xlabel} = {x:.3g}°, {ylabel} = {y:.3g}°." for name, (x, y) in placed.items()]
    return Picture(svg.document(drawn, *sheet), " ".join([_describe(xlabel, ylabel, pieces), *places]))


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


def _label_offsets(points: Array) -> list[Offset]:
    """Return the places for a curve's label: above, below and beside twelve of its points, those in the middle first."""
    inside = points[(points[:, 0] > LEFT_PX + 30) & (points[:, 0] < LEFT_PX + SQUARE_PX - 30)]
    chosen = (inside if len(inside) else points)[:: max(1, len(inside) // 12)]
    nearest_first = chosen[np.argsort(np.abs(chosen - chosen.mean(axis=0)).sum(axis=1), kind="stable")]
    return [(x + dx, dy - y) for x, y in nearest_first for dx, dy in ((0, 13), (0, -13), (44, 0), (-44, 0))]


def _describe(xlabel: str, ylabel: str, pieces: Mapping[str, list[Array]]) -> str:
    """Describe the curves by the range of each, in degrees."""
    sentences = [f"The square of all angles {xlabel} and {ylabel}, whose opposite edges are the same."]
    for name, parts in pieces.items():
        (a, d), (b, e) = np.concatenate(parts).min(axis=0), np.concatenate(parts).max(axis=0)
        sentences.append(f'Curve "{name}": {xlabel} from {a:.3g}° to {b:.3g}°, {ylabel} from {d:.3g}° to {e:.3g}°.')
    return " ".join(sentences)


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
