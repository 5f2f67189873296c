"""A canvas for drawings of robots: an orthographic projection of space onto a sheet, in which parallel lines stay parallel.

Each mark has a level, and higher levels are drawn later. Labels are placed last: beside what they name, not over each other, and off
the lines if there is room.
"""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, crop

VIEWS = {
    "default": (-60.0, 22.0),
    "front": (-90.0, 0.0),
    "side": (0.0, 0.0),
    "top": (-90.0, 90.0),
    "facing": (-22.0, 28.0),
}
"""Named views: azimuth and elevation of the viewing direction, in degrees."""

SMALLEST_TEXT_PX = 13.0
"""The least size of a letter in a drawing."""

MARGIN_SHARE = 0.33
"""Margin around what is shown, as a share of its size, because axes and frames extend a little beyond the last joint."""

BORDER_PX = 20.0
"""Border in pixels for the labels at the tips of arrows."""

Offset = tuple[float, float]

LABEL_OFFSETS: tuple[Offset, ...] = (
    *((11, 9), (-11, 9), (11, -11), (-11, -11), (0, 16), (0, -18), (19, 0), (-19, 0)),
    *((24, 19), (-24, 19), (24, -21), (-24, -21), (0, 30), (0, -32), (36, 0), (-36, 0)),
    *((34, 32), (-34, 32), (34, -34), (-34, -34), (0, 44), (0, -46), (50, 0), (-50, 0)),
)
"""Where a label may be placed: offsets in pixels to the right of what it names and above it, nearer ones first."""

OVERLAP_COST, OFF_SHEET_COST, BODY_COST, LINE_CROSSING_COST = 100.0, 100.0, 25.0, 8.0
"""What a place costs, beside its number in the list; crossing a line costs as much as eight places down the list."""


def view_axes(view: str | Sequence[float]) -> tuple[Array, Array]:
    """Return the unit vector towards the viewer, (3,), and those that point right and up on the sheet, (2, 3).

    view  one of VIEWS, or azimuth and elevation in degrees

    Raises ValueError for another name.
    """
    if isinstance(view, str) and view not in VIEWS:
        raise ValueError(f"view must be one of {', '.join(VIEWS)}; got {view!r}.")
    angles = np.radians(VIEWS[view] if isinstance(view, str) else view)
    (ca, ce), (sa, se) = np.cos(angles), np.sin(angles)
    return np.array([ce * ca, ce * sa, se]), np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]])


class Label(NamedTuple):
    """A label that is still to be placed, at one of several offsets from its anchor, in pixels."""

    anchor: Array
    text: str
    colour: str
    offsets: Sequence[Offset]
    size: float


class Canvas:
    """A sheet that shows given points, and places labels so that they do not cover each other or the drawing.

    around  points (..., 3) that must be in view
    sizes   points (..., 3) whose extent sets the size of joints, frames and arrows; by default those of around
    view    one of VIEWS
    size    width and largest height in pixels; a flat drawing is less high
    """

    def __init__(
        self, around: ArrayLike, view: str = "default", size: tuple[float, float] = (640, 440), sizes: Any = None
    ) -> None:
        self.eye, self.sheet_axes = view_axes(view)
        around = np.reshape(np.asarray(around, dtype=float), (-1, 3))
        self._extent = max(float(np.ptp(around, axis=0).max()), 1e-3)
        measured = self._extent if sizes is None else float(np.ptp(np.reshape(sizes, (-1, 3)), axis=0).max())
        # If an arm is small compared with what is shown, its marks must stay large enough to be distinguished.
        self.size = max(measured, 0.6 * self._extent)
        """The longest side of what is shown, in metres: the unit of length of everything that is not drawn to scale."""
        self._sheet = np.array(size, dtype=float)
        xs, ys = (self._tiles(around, side, 0.5) for side in (0, 1))
        flat, tiles = self.project(around), self.project([(x, y, 0.0) for x in xs for y in ys])
        low = np.minimum(flat.min(axis=0) - MARGIN_SHARE * self.size, tiles.min(axis=0))
        high = np.maximum(flat.max(axis=0) + MARGIN_SHARE * self.size, tiles.max(axis=0))
        # The same scale in both directions, so that a circle stays a circle.
        self.pixels_per_metre = float(((self._sheet - 2 * BORDER_PX) / (high - low)).min())
        self._sheet[1] = (high - low)[1] * self.pixels_per_metre + 2 * BORDER_PX
        self._middle = (low + high) / 2
        self._marks: list[tuple[float, str]] = []
        self._labels: list[Label] = []
        self._strokes: list[Array] = []
        self._bodies: list[Array] = []
        self._content: list[Array] = []

    def project(self, points: ArrayLike) -> Array:
        """Project points (..., 3) onto the plane of the sheet, (..., 2), in metres."""
        return np.asarray(np.asarray(points, dtype=float) @ self.sheet_axes.T)

    def to_pixels(self, points: ArrayLike) -> Array:
        """Project points (..., 3) to pixels (..., 2), measured from the upper left corner of the sheet."""
        return np.asarray(self._sheet / 2 + (self.project(points) - self._middle) * self.pixels_per_metre * (1, -1))

    def along(self, start: ArrayLike, end: ArrayLike) -> Array:
        """Return the direction from one point to another on the sheet, (2,), to the right and up; 0 if it is seen end-on."""
        way = self.project(end) - self.project(start)
        return np.asarray(way / max(float(np.linalg.norm(way)), 1e-9))

    def line(
        self, points: ArrayLike, colour: str = INK, width: float = 1.0, style: str = "-", level: float = 2.0
    ) -> None:
        """Draw a line through points, above all marks of a lower level. Labels avoid it unless its level is 0, the floor."""
        path = self.to_pixels(points)
        self._marks.append((level, svg.polyline(path, colour, width, style)))
        self._content.append(path)
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
        level: float = 4,
    ) -> None:
        """Draw an arrow. One that points at the viewer is a ring with a dot, one that points away a ring with a cross."""
        tail, tip = self.to_pixels(start), self.to_pixels(end)
        true = self.pixels_per_metre * float(np.linalg.norm(np.subtract(end, start)))
        seen = float(np.linalg.norm(tip - tail))
        if seen < 0.03 * true:
            self._end_on(tip, max(6.0, 2.3 * width), float(self.eye @ np.subtract(end, start)) > 0, colour, level)
            return
        along = (tip - tail) / max(seen, 1e-9)
        head = (6 + 1.5 * width) * min(1.0, 2 * seen / max(true, 1e-9))  # foreshortened, but not as soon as its stem
        neck, across = tip - head * along, 0.36 * head * along[::-1] * (-1, 1)
        self._marks.append((level, svg.polyline(np.array([tail, neck]), colour, width, style)))
        self._marks.append((level, svg.polygon(np.array([tip, neck + across, neck - across]), colour)))
        self._content.append(np.array([tail, tip, neck + across, neck - across]))
        self._strokes.append(np.array([[tail, tip]]))

    def axis(self, start: Array, tip: Array, name: str = "", colour: str = VIOLET, width: float = 1.5) -> None:
        """Draw a joint axis: a dashed violet arrow in the positive direction, with its name at the tip."""
        self.arrow(start, tip, colour, width, style="--", level=3.5)
        if name:
            self.label(tip, name, colour)

    def body(self, corners: ArrayLike, colour: str, level: float = 3.0, edge: str = INK) -> None:
        """Draw the outline of a convex body, given points on its surface."""
        hull = convex_hull(self.to_pixels(corners))
        self.shape(hull, colour, edge=edge, level=level)
        self.cover([hull])

    def shape(self, pixels: Array, colour: str, *, edge: str = "none", width: float = 1.0, level: float = 3.0) -> None:
        """Fill a polygon that is given in pixels, (m, 2)."""
        if len(pixels) > 2:
            self._marks.append((level, svg.polygon(pixels, colour, edge, width)))
            self._content.append(pixels)

    def gradient(self, start: Array, end: Array, colours: Sequence[str]) -> str:
        """Return the colour of a shape that changes evenly from one place to another, both in pixels."""
        name, mark = svg.gradient(start, end, colours)
        self._marks.append((0.0, mark))
        return f"url(#{name})"

    def cover(self, hulls: Sequence[Array]) -> None:
        """Keep labels off polygons that are given in pixels."""
        self._bodies += [np.array([hull.min(axis=0), hull.max(axis=0)]) for hull in hulls]

    def dot(self, point: ArrayLike, colour: str = INK, size: float = 5.0, level: float = 5.0) -> None:
        """Mark a point by a dot."""
        self._marks.append((level, svg.circle(self.to_pixels(point), size / 2, colour)))
        self._content.append(self.to_pixels(point)[None])

    def label(
        self,
        point: ArrayLike,
        text: str,
        colour: str = INK,
        offsets: Sequence[Offset] = LABEL_OFFSETS,
        size: float = 11,
    ) -> None:
        """Label a point, at that one of the offsets where the text covers least; of equal ones the first is taken."""
        self._labels.append(Label(self.to_pixels(point), text, colour, offsets, max(SMALLEST_TEXT_PX, 1.25 * size)))

    def measure(self, points: Array, colour: str) -> None:
        """Draw a dotted line from each point down to the floor, labelled with its height and with the x and y of its foot."""
        # Joints that share a point share its labels.
        places = np.unique(points.round(6), axis=0) + 0.0
        for point in places:
            foot = point * (1, 1, 0)
            self.line([foot, point], colour, 1.5, ":", level=1)
            self.dot(foot, colour, 5, level=6)
            if point[2]:
                self.label((foot + point) / 2, f"{point[2]:.4g}", colour, size=9)
            # first those offsets at which a label is nearer to its own foot than to any other one
            steps = self.to_pixels(places * (1, 1, 0)) - self.to_pixels(foot)
            others, ways = steps[np.abs(steps).max(axis=-1) > 1], np.array(LABEL_OFFSETS) * (1, -1)
            other = np.linalg.norm(ways[:, None] - others, axis=-1).min(axis=1, initial=np.inf)
            order = np.argsort(np.linalg.norm(ways, axis=-1) >= other, kind="stable")
            offsets = [LABEL_OFFSETS[k] for k in order]
            self.label(foot, f"({foot[0]:.4g}, {foot[1]:.4g})", colour, offsets, 9)

    def floor(self, points: ArrayLike, numbers: bool = False, height: float = 0.0) -> None:
        """Draw a grid at a height under the points, in steps of 1, 2 or 5, with numbers along x and y if numbers is true."""
        points = np.reshape(np.asarray(points, dtype=float), (-1, 3))
        # Numbers are written at the border; half a tile keeps them off joints that are at the border too.
        room = 0.5 if numbers else 0.0
        xs, ys = self._tiles(points, 0, room), self._tiles(points, 1, room)
        for start, end in [*(((x, ys[0]), (x, ys[-1])) for x in xs), *(((xs[0], y), (xs[-1], y)) for y in ys)]:
            self.line([(*start, height), (*end, height)], PALE_GREY, 1.0, level=0)
        if not numbers:
            places = [(0, -12), (36, -8), (-40, -12), (36, 8), (0, -24), (-40, -24), (0, 14), (-40, 14)]
            self.label((xs[-1], ys[0], height), f"grid {xs[1] - xs[0]:.3g} m", GREY, places, 8)
            return
        red, green, _ = AXIS_COLOURS
        for x in xs[:-1]:
            self.label((x, ys[0], 0), format_number(x, 3), red, [(-3, -11), (-3, -22), (-14, -20)], 8)
        for y in ys[1:]:
            self.label((xs[-1], y, 0), format_number(y, 3), green, [(13, -4), (26, -2), (30, -14), (44, -4)], 8)
        self.label((xs.mean(), ys[0], 0), "x in m", red, [(-8, -28), (-8, -40), (24, -40), (-40, -40)], 9)
        self.label((xs[-1], ys.mean(), 0), "y in m", green, [(42, -8), (60, -8), (48, -24), (66, -24)], 9)

    def triad(
        self,
        T: Array,
        name: str,
        length: float,
        colours: Sequence[str] = AXIS_COLOURS,
        level: float = 5.0,
        *,
        letters: str = "xyz",
    ) -> None:
        """Draw a frame: arrows with x, y, z at their tips, or some of them, and the frame's name at its origin."""
        origin = T[:3, 3]
        for letter in letters:
            k = "xyz".index(letter)
            tip = origin + length * T[:3, k]
            self.arrow(origin, tip, colours[k], 2.2, level=level)
            # Beyond the tip, along the arrow, because a letter beside it could be read as that of another arrow.
            right, up = 9 * self.along(origin, tip)
            self.label(tip, letter, colours[k], [(right, up), *LABEL_OFFSETS], 10)
        if name:
            self.label(origin, f"{{{name}}}", INK, [(-15, -11), (15, -13), (-28, -15), (28, -17), *LABEL_OFFSETS], 11)

    def picture(self, alt: str, caption: str = "", *, cropped: bool = False) -> Picture:
        """Place the labels, and return the drawing with its text alternative.

        cropped  whether empty borders are cut off; pictures of one slider must keep them, or be cropped together
        """
        marks = [mark for _, mark in sorted(self._marks, key=lambda mark: mark[0])]
        nothing = np.zeros((0, 2, 2))
        strokes, bodies = np.concatenate([nothing, *self._strokes]), np.reshape([*nothing, *self._bodies], (-1, 2, 2))
        for label, centre, half in place_labels(self._labels, strokes, bodies, self._sheet):
            way = centre - label.anchor
            border = centre - way / max(1.0, float(np.abs(way / half).max()))
            if np.linalg.norm(border - label.anchor) > label.size:  # a thin line leads to what it names
                marks.append(svg.polyline(np.array([label.anchor, border]), GREY, 0.8))
            marks.append(svg.text(centre, label.text, label.colour, label.size))
            self._content.append(np.array([centre - half, centre + half]))
        points = np.concatenate([*self._content, self._sheet[None] / 2])
        picture = Picture(svg.document(marks, *self._sheet), alt, caption, (*points.min(axis=0), *points.max(axis=0)))
        return crop([picture])[0] if cropped else picture

    def _tiles(self, points: Array, side: int, room: float) -> Array:
        """Return the positions of grid lines along x (side 0) or y (side 1), in steps of 1, 2 or 5, around points: at least two tiles.

        room  how much farther than the points the floor extends, in tiles
        """
        rough = self._extent / 6
        power = 10.0 ** np.floor(np.log10(rough))
        step = next(power * digit for digit in (1, 2, 5, 10) if power * digit >= rough * 0.999)
        low, high = points[:, side].min() / step - room, points[:, side].max() / step + room
        low, high = np.floor(low + 0.01), np.ceil(high - 0.01)
        if high - low < 2:
            low, high = low - 1, high + 1
        return np.asarray(np.arange(low, high + 0.5) * step)

    def _end_on(self, centre: Array, radius: float, towards: bool, colour: str, level: float) -> None:
        """Draw an arrow that points towards the viewer or away."""
        marks = [svg.circle(centre, radius, "white", edge=colour)]
        self._content.append(np.array([centre - radius, centre + radius]))
        if towards:
            marks.append(svg.circle(centre, radius / 3, colour))
        else:
            strokes = radius * np.array([(1, 1), (1, -1)]) * 2 / 3
            marks += [svg.polyline(np.array([centre - stroke, centre + stroke]), colour, 1.3) for stroke in strokes]
        self._marks += [(level, mark) for mark in marks]


def moved(T: Array, points: Array) -> Array:
    """Return points (..., 3) after the motion T."""
    return np.asarray(points @ T[:3, :3].T + T[:3, 3])


def convex_hull(points: Array) -> Array:
    """Return the convex hull of points in the plane, anticlockwise (Andrew's monotone chain)."""
    order, hull = sorted(points.tolist()), []
    for row in (order, order[::-1]):
        kept: list[list[float]] = []
        for x, y in row:
            while len(kept) > 1:
                (a, b), (c, d) = kept[-2:]
                if (c - a) * (y - b) > (d - b) * (x - a):  # it turns left at the last corner
                    break
                kept.pop()
            kept.append([x, y])
        hull += kept[:-1]
    return np.array(hull)


def place_labels(
    labels: Sequence[Label], strokes: Array, bodies: Array, sheet: Array
) -> Iterator[tuple[Label, Array, Array]]:
    """Find for each label, in their order, the centre where it costs least, and half of its size; all in pixels.

    strokes (m, 2, 2) from point to point; bodies (k, 2, 2) upper left and lower right corners; sheet (2,).
    A label with the same text at the same point as an earlier one is left out.
    """
    taken = np.zeros((0, 2, 2))
    kept: list[Label] = []
    for label in labels:
        if any(label.text == other.text and np.abs(label.anchor - other.anchor).max() < 4 for other in kept):
            continue
        kept.append(label)
        half = np.array([0.29 * len(svg.plain_text(label.text)) + 0.1, 0.5]) * label.size
        centres = label.anchor + np.array(label.offsets, dtype=float) * (1, -1)
        boxes = np.stack([centres - half, centres + half], axis=1)
        is_off = ((boxes[:, 0] < 2) | (boxes[:, 1] > sheet - 2)).any(axis=-1)
        cost = np.arange(len(boxes)) + OFF_SHEET_COST * is_off + OVERLAP_COST * _overlaps(boxes, taken)
        cost += BODY_COST * np.minimum(_overlaps(boxes, bodies), 2) + LINE_CROSSING_COST * _crossings(boxes, strokes)
        best = int(np.argmin(cost))
        taken = np.concatenate([taken, boxes[best : best + 1]])
        yield label, centres[best], half


def _overlaps(boxes: Array, others: Array) -> Array:
    """Count how many of the other boxes each box overlaps."""
    apart = (boxes[:, None, 0] >= others[None, :, 1]) | (others[None, :, 0] >= boxes[:, None, 1])
    return np.asarray((~(apart[..., 0] | apart[..., 1])).sum(axis=-1).astype(float))


def _crossings(boxes: Array, strokes: Array) -> Array:
    """Count the strokes that pass through each box: those whose part between the box's four borders is not empty."""
    start, along = strokes[None, :, 0], strokes[None, :, 1] - strokes[None, :, 0]
    along = np.where(np.abs(along) < 1e-9, 1e-9, along)
    one, other = (boxes[:, None, 0] - start) / along, (boxes[:, None, 1] - start) / along
    first, last = np.minimum(one, other), np.maximum(one, other)  # where it passes the borders of x and those of y
    enters = np.maximum(first[..., 0], first[..., 1]).clip(min=0.0)
    leaves = np.minimum(last[..., 0], last[..., 1]).clip(max=1.0)
    return np.asarray((enters < leaves).sum(axis=-1).astype(float))
