"""A canvas for drawings of robots: space seen from far away, on a flat sheet.

Seen orthographically, parallel lines stay parallel and lengths along an axis compare, as in a book's drawing. Projecting
by hand takes two lines and leaves a plain 2-D figure, which draws ten times faster than matplotlib's 3-D axes.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from numpy.typing import ArrayLike

from kinlib.check import Array
from kinlib.view.picture import Picture, picture

INK, GREY, PALE, VIOLET, ORANGE = "#1f2328", "#8c959f", "#d9dee3", "#7d3ac1", "#b35900"
AXIS_COLOURS = ("#c1121f", "#1a7f37", "#0b5cad")
"""x red, y green, z blue; the letters at the tips say the same without colour."""

VIEWS = {"default": (-60.0, 22.0), "front": (-90.0, 0.0), "side": (0.0, 0.0), "top": (-90.0, 89.9)}
"""Named views as azimuth and elevation of the eye, in degrees."""

MARGIN = 0.33
"""Room around what is shown, as a share of its size: axes and frames reach a little beyond the last joint."""

Offset = tuple[float, float]
AROUND: tuple[Offset, ...] = (
    (9, 7),
    (-9, 7),
    (9, -9),
    (-9, -9),
    (0, 13),
    (0, -15),
    (16, 0),
    (-16, 0),
    (20, 16),
    (-20, 16),
    (20, -18),
    (-20, -18),
)
"""Where a label may stand, in points from what it names; the first free place is taken."""


def seen_from(view: str) -> tuple[Array, Array]:
    """The unit vector towards the eye, (3,), and the two that point right and up on the sheet, (2, 3).

    >>> seen_from("front")[1].round(3) + 0.0
    array([[1., 0., 0.],
           [0., 0., 1.]])
    """
    if view not in VIEWS:
        raise ValueError(f"view should be one of {', '.join(VIEWS)}; got {view!r}.")
    azimuth, elevation = np.radians(VIEWS[view])
    eye = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    return eye, np.array([right, np.cross(eye, right)])


class Canvas:
    """A sheet that shows the points around which it is made, and keeps labels off each other."""

    def __init__(self, around: ArrayLike, view: str = "default", size: tuple[float, float] = (6.4, 4.4)) -> None:
        self.eye, self._plane = seen_from(view)
        around = np.reshape(np.asarray(around, dtype=float), (-1, 3))
        self.size = max(float(np.ptp(around, axis=0).max()), 1e-3)
        """The longest side of what is shown, in metres: the measure for everything drawn to look right, not to scale."""
        self.figure = Figure(figsize=size)
        self._axes = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self._axes.set_axis_off()
        flat = self.flat(around)
        low, high = flat.min(axis=0) - MARGIN * self.size, flat.max(axis=0) + MARGIN * self.size
        # One scale for both directions, or a circle would not look like one.
        self._scale = 72 * min(size[0] / (high - low)[0], size[1] / (high - low)[1])
        middle, half = (low + high) / 2, 72 * np.array(size) / self._scale / 2
        self._axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
        self._axes.set_ylim(middle[1] - half[1], middle[1] + half[1])
        self._taken: list[Array] = []

    def flat(self, points: ArrayLike) -> Array:
        """Where points (..., 3) of space appear on the sheet, (..., 2)."""
        seen: Array = np.asarray(points, dtype=float) @ self._plane.T
        return seen

    def line(
        self, points: ArrayLike, colour: str = INK, width: float = 1.0, style: str = "-", level: float = 2.0
    ) -> None:
        """A line through points, above what has a lower level."""
        x, y = self.flat(points).T
        self._axes.plot(x, y, color=colour, linewidth=width, linestyle=style, zorder=level, solid_capstyle="round")

    def arrow(
        self,
        start: ArrayLike,
        end: ArrayLike,
        colour: str = INK,
        width: float = 1.5,
        level: float = 4.0,
    ) -> None:
        """An arrow from one point to another."""
        head = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
        self._axes.annotate("", xy=tuple(self.flat(end)), xytext=tuple(self.flat(start)), arrowprops=head, zorder=level)

    def body(self, corners: ArrayLike, colour: str, level: float = 3.0, edge: str = INK) -> None:
        """The outline of a convex body, from points on its surface."""
        outline = _hull(self.flat(corners))
        self._axes.add_patch(Polygon(outline, facecolor=colour, edgecolor=edge, linewidth=1.0, zorder=level))

    def dot(self, point: ArrayLike, colour: str = INK, size: float = 5.0, level: float = 5.0) -> None:
        """A point, marked."""
        x, y = self.flat(point)
        self._axes.plot([x], [y], "o", color=colour, markersize=size, zorder=level)

    def label(
        self, point: ArrayLike, text: str, colour: str = INK, places: Sequence[Offset] = AROUND, size: float = 11.0
    ) -> None:
        """A name beside a point, in the first of the places where no other label stands."""
        x, y = self.flat(point)
        anchor = np.array([x, y]) * self._scale
        half = np.array([0.33 * size * len(text.replace("$", "")), 0.6 * size])
        for offset in places:
            box = anchor + offset + np.array([-half, half])
            if not any(((box[0] < other[1]) & (other[0] < box[1])).all() for other in self._taken):
                break
        self._taken.append(box)
        halo = {"boxstyle": "round,pad=0.08", "facecolor": "white", "edgecolor": "none", "alpha": 0.75}
        self._axes.annotate(
            text,
            (x, y),
            offset,
            textcoords="offset points",
            color=colour,
            fontsize=size,
            ha="center",
            va="center",
            zorder=9,
            bbox=halo,
        )

    def floor(self, points: ArrayLike, numbers: bool = False) -> None:
        """A grid at height 0 under the points, in steps of 1, 2 or 5; with numbers along x and y where asked."""
        points = np.reshape(np.asarray(points, dtype=float), (-1, 3))
        step = _step(self.size / 8)
        low = np.floor((points[:, :2].min(axis=0) - step / 2) / step) * step
        high = np.ceil((points[:, :2].max(axis=0) + step / 2) / step) * step
        xs, ys = (np.arange(start, stop + step / 2, step) for start, stop in zip(low, high, strict=True))
        for x in xs:
            self.line([(x, ys[0], 0), (x, ys[-1], 0)], PALE, 0.7, level=0)
        for y in ys:
            self.line([(xs[0], y, 0), (xs[-1], y, 0)], PALE, 0.7, level=0)
        if numbers:
            for x in xs[1:-1]:
                self.label((x, ys[0], 0), f"{x + 0.0:g}", AXIS_COLOURS[0], [(0, -9)], 8)
            for y in ys[1:-1]:
                self.label((xs[-1], y, 0), f"{y + 0.0:g}", AXIS_COLOURS[1], [(10, -4)], 8)
            self.label((xs[-1], ys[0], 0), "x", AXIS_COLOURS[0], [(-4, -16)], 10)
            self.label((xs[-1], ys[-1], 0), "y", AXIS_COLOURS[1], [(14, 6)], 10)

    def triad(
        self, T: Array, name: str, length: float, colours: Sequence[str] = AXIS_COLOURS, level: float = 5.0
    ) -> None:
        """A frame: three rods with x, y, z at their tips and the frame's name at its origin."""
        origin = T[:3, 3]
        for axis, letter, colour in zip(T[:3, :3].T, "xyz", colours, strict=True):
            tip = origin + length * axis
            self.arrow(origin, tip, colour, 2.0, level=level)
            # Beyond the tip, along the rod: a letter beside it might belong to a neighbour.
            away = self.flat(tip) - self.flat(origin)
            away = 8 * away / max(float(np.linalg.norm(away)), 1e-9)
            self.label(tip, letter, colour, [(away[0], away[1]), *AROUND], 9)
        if name:
            self.label(origin, f"{{{name}}}", INK, [(-14, -10), (14, -12), *AROUND], 10)

    def picture(self, alt: str, caption: str = "") -> Picture:
        """Finish the drawing."""
        return picture(self.figure, alt, caption)


def _step(rough: float) -> float:
    """The length 1, 2 or 5 times a power of ten that is nearest above a rough one."""
    power: float = 10.0 ** np.floor(np.log10(rough))
    return next(power * digit for digit in (1, 2, 5, 10) if power * digit >= rough * 0.999)


def _hull(points: Array) -> Array:
    """The convex hull of points in the plane, anticlockwise (Andrew's monotone chain)."""
    order = points[np.lexsort((points[:, 1], points[:, 0]))]

    def chain(sorted_points: Array) -> list[Array]:
        kept: list[Array] = []
        for point in sorted_points:
            while len(kept) > 1 and _turns_right(kept[-2], kept[-1], point):
                kept.pop()
            kept.append(point)
        return kept[:-1]

    return np.array(chain(order) + chain(order[::-1]))


def _turns_right(a: Array, b: Array, c: Array) -> bool:
    return bool((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0)
