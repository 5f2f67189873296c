"""Bodies as SVG: the silhouette of each primitive, shaded by a gradient, the farther ones first.

All primitives are convex from here, so a silhouette is the hull of points on the surface. What is nearer is decided where two of
them overlap, on a coarse raster. The parts of a link that have its colour form one casting: their outlines come before their fills.
"""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas, convex_hull
from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK, lit
from kinlib.view.figures.bodies import EDGE_SHARE, Body, Primitive, circle, rim_points

SHADES_ACROSS = np.linspace(-1, 1, 7)
"""Where the gradient across a drum or a tube has its colours, from one side to the other."""

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
        for piece in row
    ]
    largest = max(float(piece.sizes.max()) for _, piece in placed)
    hulls = [_silhouette(canvas, piece) for _, piece in placed]
    for _, piece in placed:
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


def draw_solid(canvas: Canvas, solid: Primitive, level: float) -> None:
    """Draw one drum or box by itself."""
    hull = _silhouette(canvas, solid)
    canvas.shape(hull, OUTLINE, edge=OUTLINE, width=1.8, level=level)
    _fill(canvas, solid, hull, level)
    canvas.cover([hull])


def _silhouette(canvas: Canvas, solid: Primitive) -> Array:
    radius = float(solid.sizes.max()) * canvas.pixels_per_metre
    count = int(np.clip(3.6 * np.sqrt(radius), 8, 28))  # a chord is a quarter of a pixel off its arc
    return convex_hull(canvas.to_pixels(rim_points(solid, canvas.eye, count)))


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
    """Fill a silhouette: the faces of a box, a gradient across a drum or a tube, and the end of a drum that is seen."""
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
    way, middle = across[:2] * (1, -1), canvas.to_pixels(solid.points).mean(axis=0)
    half = float(np.abs((hull - middle) @ way).max())
    colours = [lit(solid.colour, across * s + out * np.sqrt(1 - s * s)) for s in SHADES_ACROSS]
    canvas.shape(hull, canvas.gradient(middle - half * way, middle + half * way, colours), level=level)
    if solid.kind == "drum" and abs(d[2]) > 0.06:
        end = solid.points[1] if d[2] > 0 else solid.points[0]
        rim = canvas.to_pixels(end + (1 - EDGE_SHARE / 2) * solid.sizes[0] * circle(z, 12 if half < 12 else 24))
        canvas.shape(rim, lit(solid.colour, np.sign(d[2]) * d), level=level)
