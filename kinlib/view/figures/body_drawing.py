"""Bodies as SVG: the silhouette of each primitive with bands of shade, the farther ones first.

All primitives are convex from here, so a silhouette is the hull of points on the surface. What is nearer is decided where two of
them overlap, on a coarse raster. The parts of a link that have its colour form one casting: their outlines come before their fills.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas, convex_hull
from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK
from kinlib.view.drawing.shades import lit
from kinlib.view.figures.bodies import EDGE_SHARE, Body, Primitive, circle, rim_points

BANDS = 7
"""The number of bands across a drum or a tube."""

CELL_PX = 5.0
"""The raster on which it is decided what is nearer."""


def draw_body(canvas: Canvas, body: Body, moved: Array) -> None:
    """Draw a body whose links have moved from home by moved, (n + 1, 4, 4), with its shadow on the floor."""
    placed = [
        (link, _moved(piece, moved[link]))
        for link, row in enumerate(body.links)
        for solid in row
        for piece in _pieces(solid)
    ]
    largest = max(float(piece.sizes.max()) for _, piece in placed)
    for _, piece in placed:
        if piece.colour != "dark" and piece.sizes.max() > 0.3 * largest:
            fallen = rim_points(piece, np.array([0, 0, 1.0]), 10) * (1, 1, 0) + (0, 0, body.lowest)
            canvas.shape(_simple(convex_hull(canvas.to_pixels(fallen)), 1.0), SHADOW, level=0.5)
    hulls = []
    for _, piece in placed:
        count = 24 if piece.sizes.max() * canvas.pixels_per_metre > 14 else 14
        hulls.append(_simple(convex_hull(canvas.to_pixels(rim_points(piece, canvas.eye, count)))))
    order = _order(canvas, placed)
    level, step = 3.0, 0.4 / max(len(order), 1)
    for run in order:
        level += step
        for k in run:
            canvas.shape(hulls[k], OUTLINE, edge=OUTLINE, width=1.8, level=level)
        for k in run:
            _fill(canvas, placed[k][1], hulls[k], level + step / 2)
    canvas.cover(hulls)


OUTLINE, SHADOW = (LIGHT_AND_DARK[name][0] for name in ("edge", "shadow"))


def _moved(solid: Primitive, T: Array) -> Primitive:
    return solid._replace(points=solid.points @ T[:3, :3].T + T[:3, 3], axes=T[:3, :3] @ solid.axes)


def _simple(hull: Array, tolerance: float = 0.35) -> Array:
    """Return a convex polygon without the corners that hardly matter: fewer pixels than the tolerance off its edges."""
    kept = list(range(len(hull)))
    k = 0
    while len(kept) > 4 and k < len(kept):
        (ax, ay), (bx, by), (cx, cy) = (hull[kept[i % len(kept)]] for i in (k - 1, k, k + 1))
        if abs((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) < tolerance * np.hypot(cx - ax, cy - ay):
            kept.pop(k)  # the next one stays, so that errors do not add up
        k += 1
    return hull[kept]


def _pieces(solid: Primitive) -> list[Primitive]:
    """Return a primitive in convex pieces: a tube from ball to ball."""
    if solid.kind != "tube":
        return [solid]
    pairs = range(len(solid.points) - 1)
    return [solid._replace(points=solid.points[k : k + 2], sizes=solid.sizes[k : k + 2]) for k in pairs]


def _surface(solid: Primitive) -> Array:
    """Return points all over the surface of a primitive."""
    if solid.kind == "box":
        grid = np.stack(np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9)), axis=-1).reshape(-1, 2)
        faces = [np.insert(grid, k, s, axis=1) for k in range(3) for s in (-1, 1)]
        return np.asarray(solid.points[0] + (np.concatenate(faces) * solid.sizes) @ solid.axes.T)
    (p, q), (r, s) = solid.points, solid.sizes
    z = (q - p) / np.linalg.norm(q - p)
    ring, shares = circle(z, 20), np.linspace(0, 1, 12)
    side = [p + k * (q - p) + (r + k * (s - r)) * ring for k in shares]
    ends = [end + k * radius * ring for end, radius in ((p, r), (q, s)) for k in (0.0, 0.35, 0.7)]
    return np.concatenate([*side, *ends])


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
    nearer = np.array([[votes[np.ix_(a, b)].sum() for b in groups] for a in groups])
    np.fill_diagonal(nearer, 0)
    return [_sorted(groups[g], votes) for g in _sorted(range(len(groups)), nearer)]


CASTING = {"body", "white", "cream", "orange"}
"""Parts of a link in these colours read as one piece."""


def _sorted(ids: Sequence[int], nearer: Array) -> list[int]:
    """Return ids so that each is in front of as few of those that follow as possible."""
    left, order = list(ids), []
    while left:
        cost = np.clip(nearer[np.ix_(left, left)], 0, None).sum(axis=1)
        order.append(left.pop(int(np.argmin(cost))))
    return order


def _fill(canvas: Canvas, solid: Primitive, hull: Array, level: float) -> None:
    """Fill a silhouette: the faces of a box, bands along a drum or a tube, and the end of a drum that is seen."""
    view = np.array([*canvas.sheet_axes, canvas.eye])
    if solid.kind == "box":
        for k in range(3):
            for sign in (-1, 1):
                n = sign * solid.axes[:, k]
                if n @ canvas.eye > 0.02:
                    corners = np.insert(np.array([(-1, -1), (-1, 1), (1, 1), (1, -1)]), k, sign, axis=1) * solid.sizes
                    face = canvas.to_pixels(solid.points[0] + corners @ solid.axes.T)
                    canvas.shape(face, lit(solid.colour, view @ n), level=level)
        return
    ends = solid.points
    z = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    d = view @ z
    flat = float(np.hypot(d[0], d[1]))
    across = np.array([-d[1], d[0], 0]) / flat if flat > 0.05 else np.array([1.0, 0, 0])
    out = np.cross(d, across)
    out *= np.sign(out[2]) or 1
    middle = canvas.to_pixels(ends).mean(axis=0)
    side = across[:2] * (1, -1)
    off = (hull - middle) @ side
    half = max(float(np.abs(off).max()), 1e-9)
    colours: list[Any] = []
    bands = int(np.clip(half / 2.5, 2, BANDS))
    for s in np.linspace(-1, 1, bands + 1)[:-1]:
        at = s + 1 / bands
        colour = lit(solid.colour, across * at + out * np.sqrt(max(0.0, 1 - at * at)))
        if s > -1 and colour == colours[-1][0]:
            colours[-1][2] = s + 2 / bands
        else:
            colours.append([colour, s, s + 2 / bands])
    for colour, low, high in colours:  # each goes a little below the next one, so that no gap shows
        start = _cut(hull, off - low * half)
        end = _cut(start, high * half + 0.7 - (start - middle) @ side)
        canvas.shape(_simple(end), colour, level=level)
    if solid.kind == "drum" and abs(d[2]) > 0.06:
        end = ends[1] if d[2] > 0 else ends[0]
        rim = end + (1 - EDGE_SHARE / 2) * solid.sizes[0] * circle(z, 24)
        canvas.shape(_simple(convex_hull(canvas.to_pixels(rim))), lit(solid.colour, np.sign(d[2]) * d), level=level)


def _cut(hull: Array, off: Array) -> Array:
    """Return the part of a convex polygon where off is positive."""
    kept = []
    for k in range(len(hull)):
        here, there = off[k - 1], off[k]
        if (here > 0) != (there > 0):
            kept.append(hull[k - 1] + here / (here - there) * (hull[k] - hull[k - 1]))
        if there > 0:
            kept.append(hull[k])
    return np.array(kept).reshape(-1, 2)
