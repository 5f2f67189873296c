"""A canvas for drawings of robots: space seen from far away, on a flat sheet.

Seen orthographically, parallel lines stay parallel and lengths along an axis compare, as in a book's drawing. Projecting
takes two lines; what is drawn is kept with its level, and names are placed last, where they cover least.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.view.drawing import svg
from kinlib.view.drawing.labels import LABEL_OFFSETS, Label, Offset, place_labels
from kinlib.view.drawing.picture import Picture

INK, GREY, PALE_GREY, VIOLET, ORANGE = "#1f2328", "#8c959f", "#d9dee3", "#7d3ac1", "#b35900"
AXIS_COLOURS = ("#c1121f", "#1a7f37", "#0b5cad")
"""x red, y green, z blue; the letters at the tips say the same without colour."""

VIEWS = {"default": (-60.0, 22.0), "front": (-90.0, 0.0), "side": (0.0, 0.0), "top": (-90.0, 90.0)}
"""Named views as azimuth and elevation of the eye, in degrees."""

MARGIN_SHARE = 0.33
"""Room around what is shown, as a share of its size: axes and frames reach a little beyond the last joint."""

BORDER_PX = 20.0
"""Room in pixels for the names at the tips."""

HEIGHT_LABEL_OFFSETS = [(20, 0), (-20, 0), (20, 12), (-20, -12)]
FOOT_LABEL_OFFSETS = [
    (0, -14),
    (38, -6),
    (-38, -6),
    (0, 14),
    (0, -28),
    (46, -18),
    (-46, -18),
    (46, 10),
    (-46, 10),
    (0, 28),
]
"""Where the names of heights and of feet on the floor may stand, in pixels right and up."""


def view_axes(view: str) -> tuple[Array, Array]:
    """The unit vector towards the eye, (3,), and the two that point right and up on the sheet, (2, 3).

    Raises ValueError for a view that there is not.

    >>> view_axes("front")[1].round(3) + 0.0
    array([[1., 0., 0.],
           [0., 0., 1.]])
    """
    if view not in VIEWS:
        raise ValueError(f"view should be one of {', '.join(VIEWS)}; got {view!r}.")
    (ca, ce), (sa, se) = (f(np.radians(VIEWS[view])) for f in (np.cos, np.sin))
    return np.array([ce * ca, ce * sa, se]), np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]])


class Canvas:
    """A sheet that shows the points around which it is made, and keeps labels off each other and off the drawing.

    around  points (..., 3) to show
    sizes   points (..., 3) whose extent is the measure for marks; those to show, if not given
    view    one of VIEWS
    size    width and greatest height in pixels; a flat drawing takes less

    Raises ValueError for a view that there is not.
    """

    def __init__(
        self,
        around: ArrayLike,
        view: str = "default",
        size: tuple[float, float] = (640, 440),
        sizes: ArrayLike | None = None,
    ) -> None:
        self.eye, self._plane = view_axes(view)
        around = np.reshape(np.asarray(around, dtype=float), (-1, 3))
        self._extent = max(float(np.ptp(around, axis=0).max()), 1e-3)
        measured = 0.0 if sizes is None else float(np.ptp(np.reshape(sizes, (-1, 3)), axis=0).max())
        # Where an arm is small in its room, its marks stay large enough to tell apart.
        self.size = self._extent if sizes is None else max(measured, 0.6 * self._extent)
        """The longest side of what is shown, in metres: the measure for everything drawn to look right, not to scale."""
        self._sheet = np.array(size, dtype=float)
        flat = self.flat(around)
        tiles = self.flat(
            np.array([(x, y, 0.0) for x in self._tiles(around, 0, 0.5) for y in self._tiles(around, 1, 0.5)])
        )
        low = np.minimum(flat.min(axis=0) - MARGIN_SHARE * self.size, tiles.min(axis=0))
        high = np.maximum(flat.max(axis=0) + MARGIN_SHARE * self.size, tiles.max(axis=0))
        # One scale for both directions, or a circle would not look like one.
        self._scale = float(((self._sheet - 2 * BORDER_PX) / (high - low)).min())
        self._sheet[1] = (high - low)[1] * self._scale + 2 * BORDER_PX
        self._middle = (low + high) / 2
        self._marks: list[tuple[float, str]] = []
        self._labels: list[Label] = []
        self._strokes: list[Array] = []
        self._bodies: list[Array] = []

    def flat(self, points: ArrayLike) -> Array:
        """Where points (..., 3) of space appear to the eye, (..., 2), in metres."""
        seen: Array = np.asarray(points, dtype=float) @ self._plane.T
        return seen

    def pixels(self, points: ArrayLike) -> Array:
        """Where points (..., 3) of space appear on the sheet, (..., 2), from its upper left corner."""
        place: Array = self._sheet / 2 + (self.flat(points) - self._middle) * self._scale * (1, -1)
        return place

    def line(
        self, points: ArrayLike, colour: str = INK, width: float = 1.0, style: str = "-", level: float = 2.0
    ) -> None:
        """A line through points, above what has a lower level. Names keep off it, unless it lies on the floor, level 0."""
        path = self.pixels(points)
        self._marks.append((level, svg.stroke(path, colour, width, style)))
        if level > 0:
            self._strokes.append(np.stack([path[:-1], path[1:]], axis=1))

    def arrow(
        self,
        start: ArrayLike,
        end: ArrayLike,
        colour: str = INK,
        width: float = 1.5,
        *,
        style: str = "-",
        level: float = 4.0,
    ) -> None:
        """An arrow from one point to another. Pointing at the eye it is a ring with a dot, away from it one with a cross."""
        tail, tip = self.pixels(start), self.pixels(end)
        true = self._scale * float(np.linalg.norm(np.subtract(end, start)))
        seen = float(np.linalg.norm(tip - tail))
        if seen < 0.03 * true:
            self._end_on(tip, towards=float(self.eye @ np.subtract(end, start)) > 0, colour=colour, level=level)
            return
        along = (tip - tail) / max(seen, 1e-9)
        head = (6 + 1.5 * width) * min(1.0, 2 * seen / max(true, 1e-9))  # foreshortened, but not as soon as its stem
        neck, across = tip - head * along, 0.36 * head * along[::-1] * (-1, 1)
        self._marks.append((level, svg.stroke(np.array([tail, neck]), colour, width, style)))
        self._marks.append((level, svg.outline(np.array([tip, neck + across, neck - across]), colour)))
        self._strokes.append(np.array([[tail, tip]]))

    def body(self, corners: ArrayLike, colour: str, level: float = 3.0, edge: str = INK) -> None:
        """The outline of a convex body, from points on its surface."""
        hull = convex_hull(self.pixels(corners))
        self._marks.append((level, svg.outline(hull, colour, edge)))
        self._bodies.append(np.array([hull.min(axis=0), hull.max(axis=0)]))

    def dot(self, point: ArrayLike, colour: str = INK, size: float = 5.0, level: float = 5.0) -> None:
        """A point, marked."""
        self._marks.append((level, svg.disc(self.pixels(point), size / 2, colour)))

    def label(
        self,
        point: ArrayLike,
        text: str,
        colour: str = INK,
        places: Sequence[Offset] = LABEL_OFFSETS,
        size: float = 11.0,
    ) -> None:
        """A name beside a point, in that one of the places where it covers least; an earlier place wins a draw."""
        self._labels.append(Label(self.pixels(point), text, colour, places, 1.25 * size))

    def measure(self, points: Array, colour: str) -> None:
        """Drop each point to the floor by a dotted line, with the numbers that a reader needs: its height, and its foot."""
        # Joints may share a point, and then share its numbers.
        for point in np.unique(points.round(6), axis=0) + 0.0:
            foot = point * (1, 1, 0)
            self.line([foot, point], colour, 1.5, ":", level=1)
            self.dot(foot, colour, 5, level=6)
            if point[2]:
                self.label((foot + point) / 2, f"{point[2]:.4g}", colour, HEIGHT_LABEL_OFFSETS, 9)
            self.label(foot, f"({foot[0]:.4g}, {foot[1]:.4g})", colour, FOOT_LABEL_OFFSETS, 9)

    def floor(self, points: ArrayLike, numbers: bool = False) -> None:
        """A grid at height 0 under the points, in steps of 1, 2 or 5; with numbers along x and y where asked."""
        points = np.reshape(np.asarray(points, dtype=float), (-1, 3))
        # Numbers stand at the border: with a little room they stay off joints that stand at the border too.
        room = 0.5 if numbers else 0.0
        xs, ys = self._tiles(points, 0, room), self._tiles(points, 1, room)
        for x in xs:
            self.line([(x, ys[0], 0), (x, ys[-1], 0)], PALE_GREY, 1.0, level=0)
        for y in ys:
            self.line([(xs[0], y, 0), (xs[-1], y, 0)], PALE_GREY, 1.0, level=0)
        if not numbers:
            self.label(
                (xs[-1], ys[0], 0), f"grid {xs[1] - xs[0]:.3g} m", GREY, [(0, -12), (36, -8), (-40, -12), (36, 8)], 8
            )
            return
        for x in xs[:-1]:
            self.label((x, ys[0], 0), format_number(x, 3), AXIS_COLOURS[0], [(-3, -10)], 8)
        for y in ys[1:]:
            self.label((xs[-1], y, 0), format_number(y, 3), AXIS_COLOURS[1], [(11, -3)], 8)
        self.label((xs.mean(), ys[0], 0), "x in m", AXIS_COLOURS[0], [(-8, -26)], 9)
        self.label((xs[-1], ys.mean(), 0), "y in m", AXIS_COLOURS[1], [(40, -8)], 9)

    def triad(
        self, T: Array, name: str, length: float, colours: Sequence[str] = AXIS_COLOURS, level: float = 5.0
    ) -> None:
        """A frame: three rods with x, y, z at their tips and the frame's name at its origin."""
        origin = T[:3, 3]
        for axis, letter, colour in zip(T[:3, :3].T, "xyz", colours, strict=True):
            tip = origin + length * axis
            self.arrow(origin, tip, colour, 2.2, level=level)
            # Beyond the tip, along the rod: a letter beside it might belong to a neighbour.
            away = self.flat(tip) - self.flat(origin)
            away = 9 * away / max(float(np.linalg.norm(away)), 1e-9)
            self.label(tip, letter, colour, [(away[0], away[1]), *LABEL_OFFSETS], 10)
        if name:
            self.label(origin, f"{{{name}}}", INK, [(-15, -11), (15, -13), (-28, -15), (28, -17), *LABEL_OFFSETS], 11)

    def picture(self, alt: str, caption: str = "") -> Picture:
        """Finish the drawing."""
        marks = [mark for _, mark in sorted(self._marks, key=lambda mark: mark[0])]
        nothing = np.zeros((0, 2, 2))
        strokes, bodies = (
            np.concatenate([nothing, *self._strokes]),
            np.array([*nothing, *self._bodies]).reshape(-1, 2, 2),
        )
        for label, centre in place_labels(self._labels, strokes, bodies, self._sheet):
            marks.append(svg.words(centre, label.text, label.colour, label.size))
        return Picture(svg.document(marks, *self._sheet), alt, caption)

    def _tiles(self, points: Array, side: int, room: float) -> Array:
        """Where the lines of the floor run that cover points along x (side 0) or y (side 1): at least two tiles.

        room  how much farther than the points the floor reaches, in tiles
        """
        step = _step(self._extent / 6)
        low, high = points[:, side].min() / step - room, points[:, side].max() / step + room
        low, high = np.floor(low + 0.01), np.ceil(high - 0.01)
        if high - low < 2:
            low, high = low - 1, high + 1
        lines: Array = np.arange(low, high + 0.5) * step
        return lines

    def _end_on(self, centre: Array, towards: bool, colour: str, level: float) -> None:
        """An arrow seen from its tip, or from its feathers."""
        self._marks.append((level, svg.disc(centre, 6, "white", edge=colour)))
        if towards:
            self._marks.append((level, svg.disc(centre, 2, colour)))
            return
        for end in ((4, 4), (4, -4)):
            self._marks.append((level, svg.stroke(np.array([centre - end, centre + end]), colour, 1.3)))


def _step(rough: float) -> float:
    """The length 1, 2 or 5 times a power of ten that is nearest above a rough one."""
    power: float = 10.0 ** np.floor(np.log10(rough))
    return next(power * digit for digit in (1, 2, 5, 10) if power * digit >= rough * 0.999)


def convex_hull(points: Array) -> Array:
    """The convex hull of points in the plane, anticlockwise (Andrew's monotone chain)."""
    order = sorted(points.tolist())

    def chain(row: list[list[float]]) -> list[list[float]]:
        kept: list[list[float]] = []
        for point in row:
            while len(kept) > 1 and _turns_right(kept[-2], kept[-1], point):
                kept.pop()
            kept.append(point)
        return kept[:-1]

    return np.array(chain(order) + chain(order[::-1]))


def _turns_right(a: list[float], b: list[float], c: list[float]) -> bool:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0
