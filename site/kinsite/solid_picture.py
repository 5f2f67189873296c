"""Pictures of robots as solids, in the colours of the viewer: for the gallery, whose small pictures must be legible.

A drawing of lines is too thin at this size, and a build has no graphics card. So each solid is intersected with the parallel
rays of the pixels, by formulas. The picture has no background, and fits a light page and a dark one.
"""

import base64
import io
from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from PIL import Image, ImageFilter

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import perpendicular
from kinlib.view.drawing.canvas import axes_of_view
from kinlib.view.figures.linkage import is_planar, linkage_geometry
from kinlib.view.viewer.linkage_driver import PLANAR_VIEW_DEG, SPATIAL_VIEW_DEG
from kinlib.view.viewer.scene import arm_data, body_motions, extent

WIDTH, HEIGHT, OVERSAMPLING = 480, 360, 2
MARGIN_SHARE = 0.05
UP = np.eye(3)[2]
LINK, JOINT, CAP, ROD, INK = "#7f9bb5", "#f0cf94", "#c9a15c", "#b9c4cd", "#2f3b47"
FRAME = ("#e0404a", "#2f9e4f", "#3b82d6")
LIGHT = np.array([-0.45, 0.62, 0.64])
"""The direction towards the light: to the left, up, towards the viewer."""
LIGHT_DEG = (-100.0, 74.0)
"""The same for the shadow on the floor, as azimuth and elevation."""


class Solid(NamedTuple):
    """A capsule, a cylinder or a box of square section between two points; a capsule between equal points is a ball."""

    shape: str
    start: Array
    end: Array
    radius: float
    colour: str


def arm_picture(chain: Chain, q: ArrayLike) -> str:
    """Draw an arm at q (n,) with the frame of its tool, as SVG text."""
    motions, arm, size = body_motions(chain, np.asarray(q, dtype=float)), arm_data(chain, range(chain.n)), extent(chain)
    solids = [Solid(s.shape, _moved(motions[body], s.start), _moved(motions[body], s.end), s.radius, s.colour)
              for body, s in _arm_solids(arm, size)]  # fmt: skip
    for joint, before, after in zip(arm["joints"], motions, motions[1:], strict=False):
        if joint["travel"]:  # the rod of a prismatic or helical joint
            ends = _moved(before, joint["point"]), _moved(after, joint["point"])
            solids.append(Solid("capsule", *ends, 0.03 * size, ROD))
    tool = chain.fk(q)
    for axis, colour in zip(tool[:3, :3].T, FRAME, strict=True):
        tip = tool[:3, 3] + 0.2 * size * axis
        solids.append(Solid("capsule", tool[:3, 3], tip, 0.014 * size, colour))
        solids += [Solid("cylinder", a, b, r * size, colour) for a, b, r in _cone(tip, 0.085 * size * axis)]
    return _picture(solids, size, SPATIAL_VIEW_DEG, feet=[np.zeros(3)])


def linkage_picture(mechanism: Mechanism, q: ArrayLike) -> str:
    """Draw a linkage at q (n,), as SVG text."""
    geometry = linkage_geometry(mechanism, q)
    size = float(np.ptp(geometry.all, axis=0).max())
    solids, feet = [], []
    for joint, at, there, axis in zip(mechanism.joints, geometry.first, geometry.second, geometry.axes, strict=True):
        if joint.dof > 1:
            solids.append(Solid("capsule", at, at, 0.05 * size, JOINT))
        elif joint.screws[0, :3].any():
            solids.append(Solid("cylinder", at - 0.06 * size * axis, at + 0.06 * size * axis, 0.05 * size, JOINT))
        else:
            solids.append(Solid("box", at - 0.075 * size * axis, at + 0.075 * size * axis, 0.042 * size, JOINT))
            solids.append(Solid("capsule", joint.position, there, 0.022 * size, ROD))
        feet += [at] * (mechanism.ground in joint.bodies)
    for body, corners in geometry.corners.items():
        if body != mechanism.ground:
            ends = [*corners, corners[0]] if len(corners) > 2 else corners
            solids += [Solid("capsule", a, b, 0.03 * size, LINK) for a, b in pairwise(ends)]
    return _picture(solids, size, PLANAR_VIEW_DEG if is_planar(mechanism) else SPATIAL_VIEW_DEG, feet)


def _moved(T: Array, point: ArrayLike) -> Array:
    moved: Array = T[:3, :3] @ np.asarray(point) + T[:3, 3]
    return moved


def _cone(base: Array, along: Array) -> Iterator[tuple[Array, Array, float]]:
    """Yield the slices of a cone: their two ends and their radius, as a share of the arm's size."""
    for share in np.arange(8) / 8:
        yield base + share * along, base + (share + 0.125) * along, 0.034 * (1 - share)


def _arm_solids(arm: dict[str, Any], size: float) -> Iterator[tuple[int, Solid]]:
    """Yield the solids of an arm at home, each with its body: the same as in js/scene/parts.js."""
    for body, path in enumerate(arm["links"]):
        for a, b in pairwise(map(np.array, path)):
            yield body, Solid("capsule", a, b, 0.04 * size, LINK)
    r = 0.064 * size
    for i, joint in enumerate(arm["joints"]):
        axis = np.array(joint["axis"])
        centre = np.array(joint["point"]) + 3.3 * r * joint["shift"] * axis
        if joint["kind"] == "P":
            yield i, Solid("box", centre - 1.6 * r * axis, centre + 1.6 * r * axis, 0.92 * r, JOINT)
            continue
        yield i + 1, Solid("cylinder", centre - 1.5 * r * axis, centre + 1.5 * r * axis, r, JOINT)
        yield i + 1, Solid("cylinder", centre - 1.64 * r * axis, centre + 1.64 * r * axis, 0.55 * r, CAP)
        if joint["kind"] == "H":
            side = perpendicular(axis)
            for angle in np.linspace(0, 6 * np.pi, 240):
                out = r * (np.cos(angle) * side + np.sin(angle) * np.cross(axis, side))
                at = centre + (angle / (3 * np.pi) - 1) * 1.3 * r * axis + out
                yield i + 1, Solid("capsule", at, at, 0.1 * r, INK)


def _picture(solids: list[Solid], size: float, look: Iterable[float], feet: list[Array]) -> str:
    """Draw solids and their shadow on the floor, on which each foot has a column."""
    lowest = min(min(solid.start[2], solid.end[2]) for solid in solids)
    floor = lowest - 0.1 * size
    for foot in feet:
        ground = np.array([foot[0], foot[1], floor])
        solids.append(Solid("capsule", ground, foot, 0.045 * size, ROD))
        solids.append(Solid("cylinder", ground, ground + 0.02 * size * UP, 0.12 * size, ROD))
    eye, plane = axes_of_view(*look)
    ends = np.array([[s.start, s.end] for s in solids]) @ plane.T
    radii = np.array([s.radius for s in solids])[:, None, None]
    light = axes_of_view(*LIGHT_DEG)[0]
    cast = np.array([[point - (point[2] - floor) / light[2] * light for point in (s.start, s.end)] for s in solids])
    ends = np.concatenate([ends, cast @ plane.T])
    low, high = (ends - np.tile(radii, (2, 1, 1))).min((0, 1)), (ends + np.tile(radii, (2, 1, 1))).max((0, 1))
    pixels = np.array([WIDTH, HEIGHT]) * OVERSAMPLING
    pitch = float(((high - low) / pixels).max()) / (1 - 2 * MARGIN_SHARE)
    x, y = ((low[k] + high[k]) / 2 + pitch * (np.arange(pixels[k]) - pixels[k] / 2 + 0.5) * (1, -1)[k] for k in (0, 1))
    camera = np.vstack([plane, eye])
    depth, normal, which = _cast(solids, camera, x, y)
    depth[which < 0] = depth[which >= 0].min() - size
    shade = 0.5 + 0.5 * np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0, 1) + 0.06 * normal[..., 1]
    gloss = 0.35 * np.clip(normal @ _unit(LIGHT + UP), 0, 1) ** 24
    paints = np.array([[int(s.colour[k : k + 2], 16) / 255 for k in (1, 3, 5)] for s in solids] + [[0, 0, 0]])
    colours = np.array([s.colour for s in solids] + [""])[which]
    image = np.clip(paints[which] * shade[..., None] + gloss[..., None], 0, 1)
    edge = np.zeros_like(depth, dtype=bool)
    for side in (0, 1):
        jump = (np.diff(depth, axis=side, prepend=0) > 0.02 * size) | (np.roll(colours, 1, side) != colours)
        edge |= jump | np.roll(jump, -1, side)
    solid = which >= 0
    image[edge & solid] = np.array([0x2F, 0x3B, 0x47]) / 255
    alpha = np.where(solid, 1.0, 0.28 * _shadow(solids, camera, x, y, floor))
    image[~solid] = 0
    rgba = (
        np.dstack([image * alpha[..., None], alpha]).reshape(HEIGHT, OVERSAMPLING, WIDTH, OVERSAMPLING, 4).mean((1, 3))
    )
    rgba[..., :3] /= np.maximum(rgba[..., 3:], 1e-6)
    buffer = io.BytesIO()
    Image.fromarray((255 * np.clip(rgba, 0, 1) + 0.5).astype(np.uint8), "RGBA").save(
        buffer, "WEBP", quality=82, method=4
    )
    data = base64.b64encode(buffer.getvalue()).decode()
    box = f'width="{WIDTH}" height="{HEIGHT}"'
    drawn = f'<image {box} href="data:image/webp;base64,{data}"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {box} viewBox="0 0 {WIDTH} {HEIGHT}">{drawn}</svg>'


def _unit(v: ArrayLike) -> Array:
    unit: Array = np.asarray(v) / np.linalg.norm(v)
    return unit


def _shadow(solids: list[Solid], camera: Array, x: Array, y: Array, floor: float) -> Array:
    """Return how dark the floor is at each pixel, from 0 to 1."""
    right, up, eye = camera
    light, sheet = axes_of_view(*LIGHT_DEG)
    points = x[None, :, None] * right + y[:, None, None] * up
    points = points + ((floor - points[..., 2]) / eye[2])[..., None] * eye
    u, v = np.moveaxis(points @ sheet.T, -1, 0)
    grid = [np.linspace(side.min(), side.max(), 500) for side in (u, v)]
    hit = _cast(solids, np.vstack([sheet, light]), *grid)[2] >= 0
    columns, rows = (np.clip(np.searchsorted(g, side), 0, 499) for g, side in zip(grid, (u, v), strict=True))
    drawn = Image.fromarray(np.where(hit[rows, columns], 255, 0).astype(np.uint8))
    return np.asarray(drawn.filter(ImageFilter.GaussianBlur(6 * OVERSAMPLING)), dtype=float) / 255


def _cast(solids: list[Solid], camera: Array, x: Array, y: Array) -> tuple[Array, Array, Array]:
    """Find the nearest solid at each pixel: its depth towards the camera (-inf for none), its normal, its index (-1 for none).

    camera  (3, 3) the directions to the right, up and towards the viewer; x, y  the positions of columns and rows
    """
    depth = np.full((len(y), len(x)), -np.inf)
    normal, which = np.zeros((*depth.shape, 3)), np.full(depth.shape, -1)
    for index, solid in enumerate(solids):
        a, b = camera @ solid.start, camera @ solid.end
        reach = 1.5 * solid.radius
        columns, rows = (
            np.flatnonzero((side > min(a[k], b[k]) - reach) & (side < max(a[k], b[k]) + reach))
            for k, side in enumerate((x, y))
        )
        if not (len(columns) and len(rows)):
            continue
        part = np.ix_(rows, columns)
        pixels = np.zeros((len(rows), len(columns), 3))
        pixels[..., 0], pixels[..., 1] = x[columns], y[rows, None]
        for z, n in _surfaces(solid, a, b, camera, pixels):
            nearer = z > depth[part]  # a comparison with NaN, where the ray misses, is false
            at = rows[np.nonzero(nearer)[0]], columns[np.nonzero(nearer)[1]]
            depth[at], normal[at], which[at] = z[nearer], n[nearer], index
    return depth, normal, which


def _surfaces(solid: Solid, a: Array, b: Array, camera: Array, pixels: Array) -> Iterator[tuple[Array, Array]]:
    """Yield the depth and the normal of each surface of a solid at each pixel; the depth is NaN where the ray misses."""
    r, length = solid.radius, float(np.linalg.norm(b - a))
    axis = (b - a) / length if length > 1e-9 else np.array([0.0, 0, 1])
    with np.errstate(invalid="ignore", divide="ignore"):
        if solid.shape == "capsule":
            for centre in (a, b):
                z = centre[2] + np.sqrt(r**2 - ((pixels - centre)[..., :2] ** 2).sum(-1))
                yield z, _at(pixels, z) / r - centre / r
        if solid.shape in ("capsule", "cylinder") and length > 1e-9 and abs(axis[2]) < 1 - 1e-9:
            across = np.array([0, 0, 1]) - axis[2] * axis
            offset = pixels - a
            offset = offset - (offset @ axis)[..., None] * axis
            p, q, c = across @ across, offset @ across, (offset**2).sum(-1) - r**2
            z = (-q + np.sqrt(q**2 - p * c)) / p
            along = (_at(pixels, z) - a) @ axis
            yield np.where((along >= 0) & (along <= length), z, np.nan), (offset + z[..., None] * across) / r
        sides: list[tuple[Array, Array]] = []
        if solid.shape == "box":
            own = np.linalg.inv(camera) @ axis
            u = camera @ perpendicular(own)
            frame = np.array([axis, u, np.cross(axis, u)])
            sides = [(sign * v, (a + b) / 2 + sign * h * v) for sign in (1, -1)
                     for v, h in zip(frame, (length / 2, r, r), strict=True)]  # fmt: skip
        elif solid.shape == "cylinder":
            sides = [(axis, b), (-axis, a)]
        for n, centre in sides:
            if n[2] > 1e-9:
                z = ((centre - pixels) @ n) / n[2]
                out = _at(pixels, z) - (a + b) / 2
                if solid.shape == "box":
                    inside = (np.abs(out @ frame.T) <= np.array([length / 2, r, r]) + 1e-9).all(-1)
                else:
                    inside = ((_at(pixels, z) - centre) ** 2).sum(-1) <= r**2
                yield np.where(inside, z, np.nan), np.broadcast_to(n, pixels.shape)


def _at(pixels: Array, z: Array) -> Array:
    """Return the points of the rays at a depth."""
    return np.dstack([pixels[..., :2], z])
