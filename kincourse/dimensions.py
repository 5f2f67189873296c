"""Dimensioned drawings: two views of a machine with its joint axes, its marks, and the distances between them in millimetres.

The top view is above the front view, as on a drawing of a workshop, so that both share the dimensions along x. Each row of
dimensions is a chain: it leads from one mark to the next, and a coordinate in {s} is the sum of the steps from {s}. Both views
are on one canvas that is seen from the front: the top view is the machine itself, rotated about x.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import homogeneous
from kinlib.view.drawing.canvas import LABEL_OFFSETS, Canvas, moved
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, GREY, INK, VIOLET
from kinlib.view.drawing.picture import Picture, crop

SHEET_PX = (640.0, 900.0)
TOP_FROM_FRONT = np.array([(1.0, 0, 0), (0, 0, -1), (0, 1, 0)])
"""The rotation by which the front view shows a machine as it is seen from above."""

AXIS_PX, ARROW_PX, ROOM_PX = 34.0, 26.0, 46.0
"""The lengths of one half of a joint axis and of an arrow, and the distance of the dimensions from the machine."""

WIDE = 3.5
"""The width of an axis that is seen end-on, whose ring must be larger than the mark in it."""

SAME_MM = 0.5
"""Marks that are nearer to each other than this have the same coordinate."""

Arrows = Mapping[str, tuple[ArrayLike, ArrayLike]]
Steps = Sequence[tuple[float, list[str]]]
"""The different values of a coordinate in millimetres, in order, each with the marks that have it."""


@dataclass(frozen=True, eq=False)
class DrawnAxis:
    """A joint axis in a drawing: its name, its positive direction along x, y or z, a point on it, and whether it is prismatic."""

    name: str
    direction: Array
    point: Array
    slides: bool = False


def draw_dimensions(
    body: ArrayLike,
    axes: Sequence[DrawnAxis],
    marks: Mapping[str, ArrayLike],
    *,
    arrows: Arrows | None = None,
    origin: str = "{s}",
) -> Picture:
    """Draw a machine in a top view and a front view, with the distances between its marks in millimetres.

    body    (m, 3) the links as one line, in metres in {s}
    axes    its joint axes, along x, y or z of {s}
    marks   the points that the dimensions lead to, by name, in metres
    arrows  directions that are drawn, by name: a point and a unit vector along x, y or z
    origin  the name of the frame in which all of this is given; its origin is always a mark

    The text alternative contains the same chains of dimensions in words.

    >>> crane = [DrawnAxis("1", np.array([0, 0, 1]), np.array([0.2, 0, 0]))]
    >>> drawn = draw_dimensions([(0.2, 0, 0), (0.2, 0, 0.5), (0.6, 0, 0.5)], crane, {"A": (0.2, 0, 0.5), "B": (0.6, 0, 0.5)})
    >>> drawn.alt[drawn.alt.index("Along x") :]
    'Along x: {s}, then 200 mm to A, then 400 mm to B. Along y: {s}, A and B. Along z: {s}, then 500 mm to A and B.'
    """
    links, arrows = np.asarray(body, dtype=float), arrows or {}
    points = {origin: np.zeros(3), **{name: np.asarray(point, dtype=float) for name, point in marks.items()}}
    around = np.array([*links, *points.values(), *(axis.point for axis in axes)])
    low, high = around.min(axis=0), around.max(axis=0)
    wide, deep, tall = extent = np.maximum(high - low, 0.05)
    shift = np.array([0.0, 0.0, low[2] + tall + 0.25 * max(wide, deep + tall) - low[1]])
    views = {"Front view": (np.eye(4), 2), "Top view": (homogeneous(TOP_FROM_FRONT, shift), 1)}
    canvas = Canvas([moved(T, corner) for T, _ in views.values() for corner in (low, low + extent)], "front", SHEET_PX)
    room = ROOM_PX / canvas.pixels_per_metre
    for title, (T, up) in views.items():
        canvas.line(moved(T, links), GHOST_GREY, 7, level=1)
        canvas.line(moved(T, links), "white", 4, level=1.1)
        _draw_view(canvas, T, axes, points, arrows)
        level = np.array([low[0], 0, moved(T, low)[2]]) - room * np.array([1, 0, 1])
        places = {name: moved(T, point) for name, point in points.items()}
        for side, coordinate in ((0, 0), (1, up))[title == "Top view" :]:
            _draw_chain(canvas, places, _steps(points, coordinate), side, level)
        head = moved(T, np.where([False, up == 1, up == 2], low + extent, low)) + room * np.array([-1, 0, 1])
        canvas.label(head, f"{title}: x →, {'xyz'[up]} ↑", GREY, [(0, -4), (0, 10), (0, 22)], 8)
    return crop([canvas.picture(_describe(axes, points, arrows))], SHEET_PX)[0]


def _draw_view(
    canvas: Canvas, T: Array, axes: Sequence[DrawnAxis], points: Mapping[str, Array], arrows: Arrows
) -> None:
    """Draw what one view shows of the machine, but for its dimensions: T takes it to where that view is on the sheet."""
    pixel = 1 / canvas.pixels_per_metre
    shown: list[tuple[Array, Array, list[str]]] = []  # axes that cover each other in this view share a label
    for axis in axes:
        centre, way = moved(T, axis.point), T[:3, :3] @ axis.direction
        half = AXIS_PX * pixel * way
        is_end_on = abs(way @ canvas.eye) > 0.5
        for back in (0, 7) if axis.slides and not is_end_on else (0,):  # two heads: it translates
            canvas.axis(centre - half, centre + half - back * pixel * way, width=WIDE if is_end_on else 1.5)
        for k, (tip, other, names) in enumerate(shown):
            along = float((centre + half - tip) @ way)
            apart = canvas.to_pixels(centre + half - along * way) - canvas.to_pixels(tip)
            if other @ way > 0.5 and np.abs(apart).max() < 1 and (is_end_on or abs(along) < 2 * AXIS_PX * pixel):
                shown[k] = (tip + max(0.0, along) * way, way, [*names, axis.name])
                break
        else:
            shown.append((centre + half, way, [axis.name]))
    for tip, way, names in shown:
        end_on = [(34, 14), (-34, 14), (34, -14), (-34, -14)]
        offsets = end_on if abs(way @ canvas.eye) > 0.5 else [(0, 14), (0, -16), (32, 0), (-32, 0)]
        text = f"{'axis' if len(names) == 1 else 'axes'} {', '.join(names)}"
        canvas.label(tip, text, VIOLET, [*offsets, *LABEL_OFFSETS], 9.6)
    for name, (point, direction) in arrows.items():
        start, way = moved(T, np.asarray(point, dtype=float)), T[:3, :3] @ np.asarray(direction, dtype=float)
        if facing := round(float(way @ canvas.eye)):
            text, tip = f"{name} {'towards you' if facing > 0 else 'away'}", start
            offsets = [(0, -28), (0, 28), (60, -16), (-60, -16), (60, 16), (-60, 16)]
        else:
            text, tip = name, start + ARROW_PX * pixel * way
            canvas.arrow(start, tip, AXIS_COLOURS[0], 1.8)
            right, up = 12 * canvas.along(start, tip)
            offsets = [(right, up), (14, 0), (-14, 0), (0, 12), (0, -12)]
        canvas.label(tip, text, AXIS_COLOURS[0], [*offsets, *LABEL_OFFSETS], 9.6)
    together: dict[tuple[int, ...], list[str]] = {}  # marks that cover each other in this view share a label
    for name, point in points.items():
        canvas.dot(moved(T, point), INK, 5)
        together.setdefault(tuple(canvas.to_pixels(moved(T, point)).round().astype(int)), []).append(name)
    for names in together.values():
        canvas.label(moved(T, points[names[0]]), ", ".join(names), INK, LABEL_OFFSETS, 9.6)


def _draw_chain(canvas: Canvas, places: Mapping[str, Array], steps: Steps, side: int, level: Array) -> None:
    """Draw the dimensions along the sheet: below the view if side is 0, at its left if it is 1, where level says."""
    pixel, along = 1 / canvas.pixels_per_metre, np.array([(1.0, 0, 0), (0, 0, 1)])[side]
    outwards = np.array([(0.0, 0, -1), (-1, 0, 0)])[side]
    places_of_number = ([(0, -12), (0, -27), (0, -42)], [(-18, 0), (-48, 0), (-78, 0)])[side]
    stops = []
    for _, names in steps:
        here = np.array([places[name] for name in names])
        place = here[0] * along
        stops.append(place + level * np.abs(outwards))
        mark = place + here[np.argmax(here @ outwards)] * np.abs(outwards)
        canvas.line([mark + 5 * pixel * outwards, stops[-1] + 4 * pixel * outwards], GREY, 0.6, level=0)
    stroke = 3 * pixel * np.array([1, 0, 1])  # across each end: it stays readable if the line is short
    for (start, end), ((one, _), (other, _)) in zip(pairwise(stops), pairwise(steps), strict=True):
        canvas.line([start, end], INK, 0.8)
        for stop in (start, end):
            canvas.line([stop - stroke, stop + stroke], INK, 1.2)
        canvas.label((start + end) / 2, format_number(other - one, 4), INK, places_of_number, 8)


def _steps(shown: Mapping[str, Array], coordinate: int) -> Steps:
    found: list[tuple[float, list[str]]] = []
    for name, point in sorted(shown.items(), key=lambda item: float(item[1][coordinate])):
        value = 1000 * float(point[coordinate])
        if found and value - found[-1][0] < SAME_MM:
            found[-1][1].append(name)
        else:
            found.append((value, [name]))
    return found


def _describe(axes: Sequence[DrawnAxis], points: Mapping[str, Array], arrows: Arrows) -> str:
    joints = [
        f"Joint {a.name} {'translates along' if a.slides else 'rotates about'} {_letter(a.direction)}." for a in axes
    ]
    directions = [f"{name} is along {_letter(np.asarray(direction))}." for name, (_, direction) in arrows.items()]
    head = (
        "Top view and front view of a machine, with dimensions in millimetres; x is to the right, y up in the top view, "
        "z up in the front view."
    )
    chains = [f"Along {'xyz'[k]}: {_in_words(_steps(points, k))}." for k in range(3)]
    return " ".join([head, *joints, *directions, *chains])


def _in_words(steps: Steps) -> str:
    listed = [" and ".join(filter(None, [", ".join(names[:-1]), names[-1]])) for _, names in steps]
    lengths = [format_number(other - one, 4) for (one, _), (other, _) in pairwise(steps)]
    return ", then ".join(
        [listed[0], *(f"{far} mm to {there}" for far, there in zip(lengths, listed[1:], strict=True))]
    )


def _letter(direction: Array) -> str:
    k = int(np.argmax(np.abs(direction)))
    return f"{'-' if direction[k] < 0 else '+'}{'xyz'[k]}"
