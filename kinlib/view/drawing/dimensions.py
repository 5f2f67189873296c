"""Dimensioned drawings: two views of a machine with its joint axes, its marks, and the distances between them in millimetres.

The top view is above the front view, as on a drawing of a workshop, so that both share the dimensions along x. Each row of
dimensions is a chain: it leads from one mark to the next, and a coordinate in {s} is the sum of the steps from {s}.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, GREY, INK, VIOLET
from kinlib.view.drawing.labels import LABEL_OFFSETS, Label, place_labels
from kinlib.view.drawing.picture import Picture

WIDTH_PX, TALLEST_PX = 400.0, 300.0
"""The size of a view at most, without its dimensions."""

ROOM_PX, GAP_PX = 46.0, 84.0
"""The room around a view for axes and labels, and that between the views for the dimensions along x."""

CHARACTER_PX, ROW_PX, COLUMN_PX = 6.2, 15.0, 30.0
"""The width of a digit, and the distances of the rows and of the columns of dimensions if numbers need more than one."""

AXIS_PX, ARROW_PX = 34.0, 26.0
"""The lengths on the sheet of one half of a joint axis, and of an arrow that shows a direction."""

DOT_PX, RING_PX = 3.0, 8.0
"""The radius of a mark, and that of an axis which leads towards the viewer or away."""

SLANT = np.array([3.0, -3.0])
"""Half of the stroke across the end of a dimension, in pixels."""

VIEWS = {"Top view": (0, 1, 2), "Front view": (0, 2, 1)}
"""For each view the coordinates to the right and up, and the one along which it looks."""

SAME_MM = 0.5
"""Marks that are nearer to each other than this have the same coordinate."""


@dataclass(frozen=True, eq=False)
class DrawnAxis:
    """A joint axis in a drawing.

    name       its label, such as "1"
    direction  (3,) a unit vector along x, y or z: the positive direction of the joint
    point      (3,) a point on it, in metres
    slides     whether the joint is prismatic
    """

    name: str
    direction: Array
    point: Array
    slides: bool = False


def draw_dimensions(
    body: ArrayLike,
    axes: Sequence[DrawnAxis],
    marks: Mapping[str, ArrayLike],
    *,
    arrows: Mapping[str, tuple[ArrayLike, ArrayLike]] | None = None,
    origin: str = "{s}",
) -> Picture:
    """Draw a machine in a top view and a front view, with the distances between its marks in millimetres.

    body    (m, 3) the links as one line, in metres in {s}
    axes    its joint axes, along x, y or z of {s}
    marks   the points that the dimensions lead to, by name, in metres
    arrows  directions that are drawn, by name: a point and a unit vector along x, y or z
    origin  the name of the frame in which all of this is given; its origin is always a mark

    The text alternative contains the same chains of dimensions in words.

    Raises ValueError if there is no mark.

    >>> crane = [DrawnAxis("1", np.array([0, 0, 1]), np.array([0.2, 0, 0]))]
    >>> drawn = draw_dimensions([(0.2, 0, 0), (0.2, 0, 0.5), (0.6, 0, 0.5)], crane, {"A": (0.2, 0, 0.5), "B": (0.6, 0, 0.5)})
    >>> drawn.alt[drawn.alt.index("Along x") :]
    'Along x: {s}, then 200 mm to A, then 400 mm to B. Along y: {s}, A and B. Along z: {s}, then 500 mm to A and B.'
    """
    if not marks:
        raise ValueError("marks must name at least one point; got none.")
    points = {origin: np.zeros(3), **{name: np.asarray(point, dtype=float) for name, point in marks.items()}}
    line, arrows = np.asarray(body, dtype=float), arrows or {}
    around = np.concatenate([line, list(points.values()), [axis.point for axis in axes]])
    low, high = around.min(axis=0), around.max(axis=0)
    extent = np.maximum(high - low, 0.05)
    scale = float(min(WIDTH_PX / extent[0], TALLEST_PX / extent[1], TALLEST_PX / extent[2]))
    marks_px, layout = [], _Layout()
    top, left = 0.0, ROOM_PX + 3 * COLUMN_PX
    for title, (right, up, depth) in VIEWS.items():
        corner = np.array([left, top + ROOM_PX + scale * extent[up]])
        view = _View(corner, low[[right, up]], scale, right, up, depth)
        bottom = top + 2 * ROOM_PX + scale * float(extent[up])
        for k, text in enumerate((title, f"{'xyz'[right]} →, {'xyz'[up]} ↑")):
            marks_px.append(svg.text([left - 2.2 * COLUMN_PX, top + 8 + ROW_PX * k], text, GREY, 10))
        marks_px += _links(view, line)
        for axis in axes:
            marks_px += _axis(view, axis, layout)
        for name, (point, direction) in arrows.items():
            ends = np.asarray(point, dtype=float), np.asarray(direction, dtype=float)
            marks_px += _arrow(view, *ends, name, layout)
        marks_px += _dots(view, points, layout)
        if title == "Front view":
            marks_px += _chain(view, points, 0, bottom)
        marks_px += _chain(view, points, 1, left - ROOM_PX)
        top = bottom + (GAP_PX - ROOM_PX if title == "Top view" else 3 * ROW_PX)
    sheet = np.array([left + scale * extent[0] + 2 * ROOM_PX, top + ROW_PX])
    lines = np.array(layout.strokes).reshape(-1, 2, 2)
    for label, centre in place_labels(layout.labels, lines, np.array(layout.covered), sheet):
        marks_px.append(svg.text(centre, label.text, label.colour, 10.5))
    return Picture(svg.document(marks_px, *sheet), _describe(axes, points, arrows))


@dataclass(frozen=True)
class _Layout:
    """The labels that are still to be placed, and what they should not cover: lines, and boxes around marks."""

    labels: list[Label] = field(default_factory=list)
    strokes: list[Array] = field(default_factory=list)
    covered: list[Array] = field(default_factory=list)


@dataclass(frozen=True)
class _View:
    """One view on the sheet: which coordinates it shows, and where."""

    corner: Array
    low: Array
    scale: float
    right: int
    up: int
    depth: int

    def at(self, points: ArrayLike) -> Array:
        """The pixels of points (..., 3)."""
        flat = np.asarray(points, dtype=float)[..., [self.right, self.up]]
        pixels: Array = self.corner + (flat - self.low) * self.scale * (1, -1)
        return pixels

    def towards(self, direction: Array) -> float:
        """How much a direction leads towards the viewer: the front view looks along y, the top view down."""
        return float(direction[self.depth]) * (-1 if self.depth == 1 else 1)


def _links(view: _View, line: Array) -> Iterator[str]:
    path = view.at(line)
    yield svg.polyline(path, GHOST_GREY, 7)
    yield svg.polyline(path, "white", 4)


def _axis(view: _View, axis: DrawnAxis, layout: _Layout) -> Iterator[str]:
    centre, name = view.at(axis.point), f"axis {axis.name}"
    if facing := round(view.towards(axis.direction)):
        yield svg.circle(centre, RING_PX, "none", edge=VIOLET)
        layout.covered.append(_box(centre, RING_PX))
        if facing > 0:
            yield svg.circle(centre, 3.2, VIOLET)
        else:
            for end in ((5.5, 5.5), (5.5, -5.5)):
                yield svg.polyline(np.array([centre - end, centre + end]), VIOLET, 1.6)
        layout.labels.append(
            Label(centre, name, VIOLET, [(30, 14), (-30, 14), (30, -14), (-30, -14), *LABEL_OFFSETS], 12)
        )
        return
    along = axis.direction[[view.right, view.up]] * (1, -1)
    ends = np.array([centre - AXIS_PX * along, centre + AXIS_PX * along])
    yield svg.polyline(ends, VIOLET, 1.4, "--")
    yield _head(ends[1], along, VIOLET)
    if axis.slides:  # two heads: it translates
        yield _head(ends[1] - 7 * along, along, VIOLET)
    layout.strokes.append(ends)
    layout.labels.append(Label(ends[1], name, VIOLET, [(0, 12), (0, -14), (30, 0), (-30, 0), *LABEL_OFFSETS], 12))


def _arrow(view: _View, point: Array, direction: Array, name: str, layout: _Layout) -> Iterator[str]:
    colour, start = AXIS_COLOURS[0], view.at(point)
    if facing := round(view.towards(direction)):
        text = f"{name} {'towards you' if facing > 0 else 'away'}"
        layout.labels.append(
            Label(
                start, text, colour, [(0, -28), (0, 28), (60, -16), (-60, -16), (60, 16), (-60, 16), *LABEL_OFFSETS], 12
            )
        )
        return
    along = direction[[view.right, view.up]] * (1, -1)
    tip = start + ARROW_PX * along
    yield svg.polyline(np.array([start, tip]), colour, 1.8)
    yield _head(tip, along, colour)
    layout.strokes.append(np.array([start, tip + 7 * along]))
    beyond = (16 * along[0], -16 * along[1])
    layout.labels.append(Label(tip, name, colour, [beyond, (14, 0), (-14, 0), (0, 12), (0, -12), *LABEL_OFFSETS], 12))


def _box(centre: Array, half: float) -> Array:
    return np.array([centre - half, centre + half])


def _head(tip: Array, along: Array, colour: str) -> str:
    across = np.array([-along[1], along[0]])
    return svg.polygon(np.array([tip + 7 * along, tip + 3 * across, tip - 3 * across]), colour)


def _dots(view: _View, points: Mapping[str, Array], layout: _Layout) -> Iterator[str]:
    """A dot at each mark; marks that cover each other in this view share a label."""
    together: dict[tuple[int, int], list[str]] = {}
    for name, point in points.items():
        pixel = view.at(point)
        yield svg.circle(pixel, DOT_PX, INK)
        layout.covered.append(_box(pixel, DOT_PX))
        together.setdefault((round(pixel[0]), round(pixel[1])), []).append(name)
    for place, names in together.items():
        layout.labels.append(Label(np.array(place, dtype=float), ", ".join(names), INK, LABEL_OFFSETS, 12))


def _steps(shown: Mapping[str, Array], coordinate: int) -> list[tuple[float, list[str]]]:
    """The different values of a coordinate in millimetres, in order, each with the marks that have it."""
    found: list[tuple[float, list[str]]] = []
    for name, point in sorted(shown.items(), key=lambda item: float(item[1][coordinate])):
        value = 1000 * float(point[coordinate])
        if found and value - found[-1][0] < SAME_MM:
            found[-1][1].append(name)
        else:
            found.append((value, [name]))
    return found


def _chain(view: _View, shown: Mapping[str, Array], axis: int, level: float) -> Iterator[str]:
    """The dimensions along the sheet: below the view if axis is 0, to its left if it is 1, at this level of the other coordinate."""
    steps, out = _steps(shown, (view.right, view.up)[axis]), (1, -1)[axis]

    def at(along: float, across: float) -> tuple[float, float]:
        return (along, across) if axis == 0 else (across, along)

    for _, names in steps:
        pixels = np.array([view.at(shown[name]) for name in names])
        outermost = float(max(out * pixels[:, 1 - axis])) * out
        place = float(pixels[0, axis])
        yield svg.polyline(np.array([at(place, outermost + 5 * out), at(place, level + 4 * out)]), GREY, 0.6)
    last, row = -np.inf, 0
    for (one, names), (other, more) in pairwise(steps):
        ends = [float(view.at(shown[who[0]])[axis]) for who in (names, more)]
        yield from _dimension(np.array([at(ends[0], level), at(ends[1], level)]))
        text = format_number(other - one, 4)
        middle, half = out * sum(ends) / 2, 6.0 if axis else CHARACTER_PX * len(text) / 2 + 3
        row = (row + 1) % 3 if middle - half < last else 0
        last = max(last, middle + half)
        off = 16 + COLUMN_PX * row if axis else 11 + ROW_PX * row
        yield svg.text(at(out * middle, level + out * off), text, INK, 10)


def _dimension(ends: Array) -> Iterator[str]:
    """A line with a stroke across each end, which stays readable if the line is short."""
    yield svg.polyline(ends, INK, 0.8)
    for end in ends:
        yield svg.polyline(np.array([end - SLANT, end + SLANT]), INK, 1.2)


def _describe(
    axes: Sequence[DrawnAxis], shown: Mapping[str, Array], arrows: Mapping[str, tuple[ArrayLike, ArrayLike]]
) -> str:
    kinds = [
        f"Joint {axis.name} {'translates along' if axis.slides else 'rotates about'} {_letter(axis.direction)}."
        for axis in axes
    ]
    directions = [f"{name} is along {_letter(np.asarray(direction))}." for name, (_, direction) in arrows.items()]
    chains = [f"Along {'xyz'[k]}: {_chain_in_words(_steps(shown, k))}." for k in range(3)]
    head = (
        "Top view and front view of a machine, with dimensions in millimetres; x is to the right, y up in the top view, "
        "z up in the front view."
    )
    return " ".join([head, *kinds, *directions, *chains])


def _chain_in_words(steps: Sequence[tuple[float, list[str]]]) -> str:
    words = [_listed(steps[0][1])]
    words += [
        f"then {format_number(other - one, 4)} mm to {_listed(names)}" for (one, _), (other, names) in pairwise(steps)
    ]
    return ", ".join(words)


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _letter(direction: Array) -> str:
    k = int(np.argmax(np.abs(direction)))
    return f"{'-' if direction[k] < 0 else '+'}{'xyz'[k]}"
