"""Bodies as SVG: the silhouette of each primitive with bands of shade, the farther ones first.

All primitives are convex from here, so a silhouette is the hull of points on the surface. What is nearer is decided where two of
them overlap, on a coarse raster. The parts of a link that have its colour form one casting: their outlines come before their fills.
"""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas, convex_hull
from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK, lit
from kinlib.view.figures.bodies import EDGE_SHARE, Body, Primitive, circle, rim_points

BANDS = 6
"""The number of bands across a drum or a tube, if there is room for them."""

CELL_PX = 5.0
"""The raster on which it is decided what is nearer."""

CASTING = {"body", "white", "cream", "orange"}
"""Parts of a link in these colours read as one piece."""

OUTLINE, SHADOW = (LIGHT_AND_DARK[name][0] for name in ("edge", "shadow"))


def draw_body(canvas: Canvas, body: Body, moved: Array) -> None:
    """Draw a body whose links have moved from home by moved, (n + 1, 4, 4), with its shadow on the floor."""
    placed = [
        (link, piece._replace(points=piece.points @ T[:3, :3].T + T[:3, 3], axes=T[:3, :3] @ piece.axes))
        for link, (row, T) in enumerate(zip(body.links, moved, strict=True))
        for solid in row
        for piece in _pieces(solid)
    ]
    largest = max(float(piece.sizes.max()) for _, piece in placed)
    hulls = []
    for _, piece in placed:
        radius = float(piece.sizes.max()) * canvas.pixels_per_metre
        count = int(np.clip(3.6 * np.sqrt(radius), 8, 28))  # a chord is a quarter of a pixel off its arc
        hulls.append(convex_hull(canvas.to_pixels(rim_points(piece, canvas.eye, count))))
        if piece.colour != "dark" and piece.sizes.max() > 0.3 * largest:
            fallen = rim_points(piece, np.eye(3)[2], 8) * (1, 1, 0) + (0, 0, body.lowest)
            canvas.shape(convex_hull(canvas.to_pixels(fallen)), SHADOW, level=0.5)
    order = _order(canvas, placed)
    level, step = 3.0, 0.4 / len(order)
    for run in order:
        level += step
        for k in run:
            canvas.shape(hulls[k], OUTLINE, edge=OUTLINE, width=1.8, level=level)
        for k in run:
            _fill(canvas, placed[k][1], hulls[k], level + step / 2)
    canvas.cover(hulls)


def _pieces(solid: Primitive) -> list[Primitive]:
    """Return a primitive in convex pieces: a tube from ball to ball."""
    if solid.kind != "tube":
        return [solid]
    pairs = range(len(solid.points) - 1)
    return [solid._replace(points=solid.points[k : k + 2], sizes=solid.sizes[k : k + 2]) for k in pairs]


def _surface(solid: Primitive) -> Array:
    """Return points all over the surface of a primitive."""
    if solid.kind == "box":
        return np.asarray(solid.points[0] + (CUBE * solid.sizes) @ solid.axes.T)
    (p, q), (r, s) = solid.points, solid.sizes
    ring, shares = circle(solid.along, 16), np.linspace(0, 1, 10)[:, None, None]
    side = p + shares * (q - p) + (r + shares * (s - r)) * ring
    ends = [end + k * radius * ring for end, radius in ((p, r), (q, s)) for k in (0.0, 0.4, 0.75)]
    return np.concatenate([side.reshape(-1, 3), *ends])


_GRID = np.stack(np.meshgrid(np.linspace(-1, 1, 8), np.linspace(-1, 1, 8)), axis=-1).reshape(-1, 2)
CUBE = np.concatenate([np.insert(_GRID, k, s, axis=1) for k in range(3) for s in (-1, 1)])
"""Points all over the surface of a cube."""


def _order(canvas: Canvas, placed: Sequence[tuple[int, Primitive]]) -> list[list[int]]:
    """Return runs of items from the farthest to the nearest; a run is the casting of a link, or one item."""
    count = len(placed)
    surfaces = [_surface(piece) for _, piece in placed]
    points = np.concatenate(surfaces)
    items = np.repeat(np.arange(count), [len(surface) for surface in surfaces])
    cells = np.floor(canvas.to_pixels(points) / CELL_PX).astype(int)
    cells -= cells.min(axis=0)
    size = cells.max(axis=0) + 1
    depth = np.full((count, size[0] * size[1]), -np.inf)
    np.maximum.at(depth, (items, cells[:, 0] * size[1] + cells[:, 1]), points @ canvas.eye)
    # In each cell the nearest item votes against those behind it.
    front, nearest = depth.argmax(axis=0), depth.max(axis=0)
    behind, cell = np.nonzero(np.isfinite(depth))
    votes = np.zeros((count, count))
    gap = np.minimum((nearest[cell] - depth[behind, cell]) / (0.012 * canvas.size), 1.0)
    np.add.at(votes, (front[cell], behind), gap)
    votes -= votes.T.copy()
    runs: dict[tuple[int, ...], list[int]] = {}
    for k, (link, piece) in enumerate(placed):
        runs.setdefault((link,) if piece.colour in CASTING and piece.kind != "box" else (link, k), []).append(k)
    groups = list(runs.values())
    member = np.array([[k in group for k in range(count)] for group in groups], dtype=float)
    nearer = member @ votes @ member.T
    return [_sorted(groups[g], votes) for g in _sorted(range(len(groups)), nearer)]


def _sorted(ids: Sequence[int], nearer: Array) -> list[int]:
    """Return ids so that each is in front of as few of those that follow as possible."""
    left, order = np.array(ids), []
    ahead = np.clip(nearer[left][:, left], 0, None)
    cost = ahead.sum(axis=1)
    for _ in ids:
        first = int(np.argmin(cost))
        order.append(int(left[first]))
        cost = cost - ahead[:, first]
        cost[first] = np.inf
    return order


def _fill(canvas: Canvas, solid: Primitive, hull: Array, level: float) -> None:
    """Fill a silhouette: the faces of a box, bands along a drum or a tube, and the end of a drum that is seen."""
    view = np.array([*canvas.sheet_axes, canvas.eye])
    if solid.kind == "box":
        for k in range(3):
            n = view @ solid.axes[:, k]
            sign = 1 if n[2] > 0 else -1
            if abs(n[2]) > 0.02:
                corners = np.insert(np.array([(-1, -1), (-1, 1), (1, 1), (1, -1)]), k, sign, axis=1) * solid.sizes
                face = canvas.to_pixels(solid.points[0] + corners @ solid.axes.T)
                canvas.shape(face, lit(solid.colour, sign * n), level=level)
        return
    z = solid.along
    d = view @ z
    flat = float(np.hypot(d[0], d[1]))
    across = np.array([-d[1], d[0], 0]) / flat if flat > 0.05 else np.array([1.0, 0, 0])
    out = np.array([-d[2] * across[1], d[2] * across[0], flat])  # perpendicular to the axis, towards the viewer
    off = (hull - canvas.to_pixels(solid.points).mean(axis=0)) @ (across[:2] * (1, -1))
    half = max(float(np.abs(off).max()), 1e-9)
    count = int(np.clip(half / 3, 2, BANDS))
    middles = (2 * np.arange(count) + 1) / count - 1
    colours = [lit(solid.colour, across * s + out * np.sqrt(1 - s * s)) for s in middles]
    for k, colour in enumerate(colours):
        low = (2 * k / count - 1) * half
        if k:  # what is left is drawn over the bands before, so that no gap shows
            hull, above = _cut(hull, off - low)
            off = above + low
        if not k or colour != colours[k - 1]:
            canvas.shape(hull, colour, level=level)
    if solid.kind == "drum" and abs(d[2]) > 0.06:
        end = solid.points[1] if d[2] > 0 else solid.points[0]
        rim = canvas.to_pixels(end + (1 - EDGE_SHARE / 2) * solid.sizes[0] * circle(z, 12 if half < 12 else 24))
        canvas.shape(rim, lit(solid.colour, np.sign(d[2]) * d), level=level)


def _cut(hull: Array, off: Array) -> tuple[Array, Array]:
    """Return the part of a convex polygon where off is positive, and off at its corners."""
    kept: list[Array] = []
    values: list[float] = []
    for k in range(len(hull)):
        here, there = off[k - 1], off[k]
        if (here > 0) != (there > 0):
            kept.append(hull[k - 1] + here / (here - there) * (hull[k] - hull[k - 1]))
            values.append(0.0)
        if there > 0:
            kept.append(hull[k])
            values.append(float(there))
    return np.array(kept).reshape(-1, 2), np.array(values)
