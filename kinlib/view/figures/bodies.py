"""The body of an arm: for each link drums, tubes and boxes, given at home in {s}, so that link i moves by the first i screws.

Known robots are described in kinlib/view/bodies.json. Any other arm gets a body from its screw axes and its joint points:
a barrel around each revolute joint, a sleeve with a rod at each prismatic one, tapered tubes between them, a foot and a gripper.
The links of a URDF show the boxes, cylinders and spheres of their <visual> elements; viewer/meshes.py reads meshes.
"""

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import perpendicular
from kinlib.rigid.screw import screw
from kinlib.urdf.links_and_joints import origin_of
from kinlib.urdf.xml_elements import Element

SAME_AXES_TOL_M = 1e-3
"""An arm whose screws differ by less than this from those of a known robot, in metres and radians, has its body."""

EDGE_SHARE = 0.16
"""How far the edges of drums and boxes are rounded, as a share of the radius or of the smallest half side."""

X = np.array([1.0, 0, 0])


class Primitive(NamedTuple):
    """A solid of a link.

    kind     "drum": a cylinder between two points; "tube": two balls joined by a cone; "box": half sides along three axes
    points   (k, 3) the ends of a drum, the balls of a tube, the centre of a box
    sizes    (k,) the radius at each point; (3,) the half sides of a box
    colour   its name in colours.json, or #rrggbb of a file
    axes     (3, 3) the directions of a box, in columns
    """

    kind: str
    points: Array
    sizes: Array
    colour: str = "body"
    axes: Array = np.eye(3)

    @property
    def along(self) -> Array:
        """The unit vector along a drum, or between the balls of a tube, (3,)."""
        way = self.points[1] - self.points[0]
        return np.asarray(way / np.linalg.norm(way))


@dataclass(frozen=True, eq=False)
class Body:
    """The body of an arm.

    links   the primitives of link 0 to link n
    pose    (n,) a configuration of an arm that shows its shape
    source  where its dimensions come from
    """

    links: tuple[tuple[Primitive, ...], ...]
    pose: Array = field(default_factory=lambda: np.zeros(0))
    source: str = "By rule, from the screw axes and the joint points."

    @cached_property
    def lowest(self) -> float:
        """The height of the floor, on which the base is."""
        standing = next((link for link in self.links if link), ())
        return min((float(rim_points(solid, X)[:, 2].min()) for solid in standing), default=0.0)

    def extent(self, moved: Array) -> Array:
        """Return the ends and centres of all primitives after motions of the links (n + 1, 4, 4), (m, 3), and their feet."""
        solids = [(solid, T) for link, T in zip(self.links, moved, strict=True) for solid in link]
        points = np.concatenate([solid.points @ T[:3, :3].T + T[:3, 3] for solid, T in solids])
        return np.concatenate([points, points * (1, 1, 0) + (0, 0, self.lowest)])


def solid_data(links: Sequence[Sequence[Primitive]]) -> list[list[dict[str, Any]]]:
    """Return the primitives of links as data for the page."""

    def data(solid: Primitive) -> dict[str, Any]:
        numbers = {"points": solid.points, "sizes": solid.sizes, "axes": solid.axes.T}
        return {"kind": solid.kind, "colour": solid.colour} | {k: v.round(6).tolist() for k, v in numbers.items()}

    return [[data(solid) for solid in link] for link in links]


def shapes(link: Element) -> Iterator[tuple[Element, Element]]:
    """Yield the shapes that a link shows, each with its <visual>."""
    for visual in (child for child in link.children if child.tag == "visual"):
        for geometry in (child for child in visual.children if child.tag == "geometry"):
            yield from ((visual, shape) for shape in geometry.children)


def visual_colour(visual: Element) -> str | None:
    """Return the colour of a visual as #rrggbb, by its own material or by that of the robot of the same name."""
    own = [child for child in visual.children if child.tag == "material"]
    robot = visual.parent.parent if visual.parent else None
    others = [child for child in robot.children if child.tag == "material"] if robot and own else []
    named = [other for other in others if other.attributes.get("name") == own[0].attributes.get("name")]
    for colour in (child for material in own + named for child in material.children if child.tag == "color"):
        with suppress(ValueError):
            return "#" + "".join(f"{round(255 * x):02x}" for x in np.clip(colour.numbers("rgba", 4), 0, 1)[:3])
    return None


def visual_solids(link: Element, T: Array) -> list[Primitive]:
    """Return what a link shows, at the pose T of its frame; nothing of meshes, nor of elements that are not as they should be."""
    found = []
    for visual, shape in shapes(link):
        with suppress(ValueError):
            pose = T @ origin_of(visual)
            at, z, colour = pose[:3, 3], pose[:3, 2], visual_colour(visual) or "body"
            if shape.tag == "box":
                found.append(box(at, np.array(shape.numbers("size", 3)) / 2, colour, pose[:3, :3]))
            elif shape.tag == "cylinder":
                (radius,), (length,) = shape.numbers("radius", 1), shape.numbers("length", 1)
                found.append(drum(z, at, radius, -length / 2, length / 2, colour=colour))
            elif shape.tag == "sphere":
                found.append(ball(at, shape.numbers("radius", 1)[0], colour))
    return found


@lru_cache(maxsize=32)
def body_of(chain: Chain, *, hand: bool = True) -> Body:
    """Return the body of an arm: the one in bodies.json if it has the same screws as a known robot, or else one by rule.

    hand  whether an arm by rule has a gripper
    """
    for known, described in _known_robots():
        if known.shape == chain.screws.shape and np.allclose(known, chain.screws, atol=SAME_AXES_TOL_M):
            own = {"cap": "blue", **described.get("colours", {})}
            links = tuple(
                tuple(
                    solid._replace(colour=own.get(solid.colour, solid.colour)) for row in rows for solid in _solids(row)
                )
                for rows in described["links"]
            )
            return Body(links, np.array(described["pose"], dtype=float), described["source"])
    built = _Builder(chain, hand)
    return Body(tuple(map(tuple, built.links)), built.pose)


def rim_points(solid: Primitive, eye: Array, count: int = 24) -> Array:
    """Return points on a primitive, (m, 3), whose hull is its silhouette, seen along eye: rings of count points, or corners."""
    if solid.kind == "box":
        return np.asarray(solid.points[0] + (CORNERS * solid.sizes) @ solid.axes.T)
    ring = circle(solid.along if solid.kind == "drum" else eye, count)
    return np.concatenate([p + r * ring for p, r in zip(solid.points, solid.sizes, strict=True)])


CORNERS = np.stack(np.meshgrid(*[(-1.0, 1.0)] * 3), axis=-1).reshape(-1, 3)
"""The corners of a cube."""


def circle(z: Array, count: int) -> Array:
    """Return points (count, 3) of the unit circle perpendicular to a unit vector."""
    a, b, c = z.tolist()  # plain numbers are faster here than arrays
    far = np.hypot(a, b) if abs(c) < 0.9 else np.hypot(b, c)
    x = (b / far, -a / far, 0.0) if abs(c) < 0.9 else (0.0, c / far, -b / far)
    y = (b * x[2] - c * x[1], c * x[0] - a * x[2], a * x[1] - b * x[0])
    return np.asarray(_unit_circle(count) @ np.array([x, y]))


@cache
def _unit_circle(count: int) -> Array:
    angles = np.arange(count) * 2 * np.pi / count
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def drum(axis: ArrayLike, point: ArrayLike, radius: float, *ends: float, colour: str = "body") -> Primitive:
    """Return a cylinder along an axis through a point; its ends are measured from there."""
    z, p = np.asarray(axis, dtype=float), np.asarray(point, dtype=float)
    low, high = sorted(ends)
    return Primitive("drum", np.array([p + low * z, p + high * z]), np.array([radius, radius]), colour)


def tube(*balls: Sequence[float], colour: str = "body") -> list[Primitive]:
    """Return a tapered tube through balls (x, y, z, radius), from each to the next."""
    pairs = (np.array(pair, dtype=float) for pair in pairwise(balls))
    return [Primitive("tube", pair[:, :3], pair[:, 3], colour) for pair in pairs]


def ball(centre: ArrayLike, radius: float, colour: str = "body") -> Primitive:
    """Return a ball."""
    up = 1e-4 * radius * np.eye(3)[2]
    return Primitive("tube", np.array([centre - up, centre + up]), np.array([radius, radius]), colour)


def box(centre: ArrayLike, half: ArrayLike, colour: str = "body", axes: Array | None = None) -> Primitive:
    """Return a box with half sides along the columns of axes."""
    own = np.eye(3) if axes is None else axes
    return Primitive("box", np.array([centre], dtype=float), np.array(half, dtype=float), colour, own)


def slab(axis: Array, point: Array, half: float, *ends: float, colour: str = "body") -> Primitive:
    """Return a square bar along an axis through a point, with half its side; its ends are measured from there."""
    x, (low, high) = perpendicular(axis), ends
    axes = np.stack([x, np.cross(axis, x), axis], axis=1)
    return box(point + (low + high) / 2 * axis, (half, half, (high - low) / 2), colour, axes)


def gripper(point: Array, direction: ArrayLike, opening: ArrayLike, size: float) -> list[Primitive]:
    """Return a gripper with two fingers: a palm at a point, fingers along a direction, which open along another one."""
    z, y = np.asarray(direction, dtype=float), np.asarray(opening, dtype=float)
    axes = np.stack([np.cross(y, z), y, z], axis=1)

    parts: list[Any] = [(0, 0.27, (0.25, 0.56, 0.23), "grip")]
    parts += [(s * 0.37, 0.6, (0.17, 0.14, 0.14), "dark") for s in (-1, 1)]
    parts += [(s * 0.32, 1.08, (0.12, 0.07, 0.42), "metal") for s in (-1, 1)]
    return [
        box(point + size * (across * y + along * z), size * np.array(half), colour, axes)
        for across, along, half, colour in parts
    ]


def _axis(name: Any) -> Array:
    return np.asarray(np.eye(3)["xyz".index(name[-1])] * (-1 if name[0] == "-" else 1))


def _solids(row: list[Any]) -> list[Primitive]:
    """Return the primitives of a row of bodies.json."""
    kind, *rest = row
    if kind == "drum":
        return [drum(_axis(rest[0]), *rest[1:5], colour=(*rest, "body")[5])]
    if kind == "tube":
        balls = [ball for ball in rest if not isinstance(ball, str)]
        return tube(*balls, colour=(*rest, "body")[len(balls)])
    if kind == "box":
        return [box(*rest)]
    point, direction, opening, size = rest
    return gripper(np.array(point), _axis(direction), _axis(opening), size)


@cache
def _known_robots() -> list[tuple[Array, dict[str, Any]]]:
    def screws(axes: list[Any]) -> Array:
        pitch = [np.inf if len(axis) > 2 else 0.0 for axis in axes]
        return screw([_axis(axis[0]) for axis in axes], [axis[1] for axis in axes], pitch)

    robots = json.loads(Path(__file__).parents[1].joinpath("bodies.json").read_text("utf-8")).values()
    return [(screws(described["axes"]), described) for described in robots]


class _Builder:
    """The body of any arm. Lengths are shares of its reach: the sum of the distances from joint to joint, and to the tool."""

    def __init__(self, chain: Chain, hand: bool) -> None:
        self.chain, n = chain, chain.n
        self.axes = chain.lines.axis
        self.slides = [letter == "P" for letter in chain.joint_types]
        self.tip, self.tool = chain.home[:3, 3], chain.home[:3, :3]
        path = np.array([*chain.joint_points, self.tip])
        sizes = np.linalg.norm(np.diff(path, axis=0), axis=1).sum(), np.linalg.norm(path[0]), 1.0
        reach = next(size for size in map(float, sizes) if size > 1e-9)  # less is a rounding error
        self.radius = (0.078 - 0.0035 * min(n, 10)) * reach
        self.sleeve = 0.24 * reach
        self.centres = path[:-1].copy()
        self.grip_at = self.tip
        self.links: list[list[Primitive]] = [[] for _ in range(n + 1)]
        # a configuration within the limits that is not stretched out
        shown = np.where(self.slides, 0.25 * self.sleeve, [(0.35, -0.5, 0.6)[i % 3] for i in range(n)])
        self.pose = shown if chain.limits is None else np.clip(shown, *chain.limits.T)
        self._separate()
        for i in range(n):
            self._joint(i)
        if hand:
            self._hand()
        self._foot()

    def r(self, i: int) -> float:
        """The radius of joint i, which decreases towards the tool."""
        return self.radius * (1 - 0.38 * i / self.chain.n)

    def _separate(self) -> None:
        """Move drums along their axes, and sleeves anywhere, so that joints that share a point are apart: from the tool back."""
        c, n, R = self.centres, self.chain.n, self.radius
        last, z = n - 1, self.tool[:, 2]
        if np.linalg.norm(self.tip - c[last]) < 0.6 * R:
            if not self.slides[last] and abs(self.axes[last] @ z) > 0.9:
                c[last] = self.tip - 1.3 * self.r(last) * z
            else:
                self.grip_at = self.tip + 1.1 * self.r(last) * z
        for i in range(n - 2, -1, -1):
            a, r, there = self.axes[i], self.r(i), c[i + 1]
            way = there - c[i]
            along = float(way @ a)
            across = float(np.linalg.norm(way - along * a))
            if self.slides[i]:
                if across < 0.6 * R and along < self.sleeve / 2 + 1.5 * r:
                    c[i] = there - (self.sleeve / 2 + 1.6 * r) * a
            elif not self.slides[i + 1] and np.linalg.norm(way) < 0.8 * r:
                sign = -1.0 if i == 0 else float(np.sign((c[i - 1] - c[i]) @ a)) or 1.0
                c[i] = c[i] + sign * 1.9 * r * a
            elif abs(along) < 0.75 * np.linalg.norm(way) and (i > 0 or (along > 0 and a[2] > 0.9)):
                c[i] = c[i] + along * a  # level with what it carries

    def _foot(self) -> None:
        """Add a round plate on the floor and a column up to the first joint."""
        at, R = self.centres[0], self.radius
        upright = abs(self.axes[0][2]) > 0.9
        drop = (2.5 if upright else 3.2) * R
        parts = [rim_points(solid, X)[:, 2].min() - 0.1 * R for link in self.links for solid in link]
        low = min(at[2] - drop, 0.0, *parts)
        ground, height = np.array([at[0], at[1], low]), at[2] - low
        z = np.eye(3)[2]
        self.links[0] += [
            drum(z, ground, 1.7 * R, 0, 0.24 * R, colour="dark"),
            drum(z, ground, 1.2 * R, 0.2 * R, 0.55 * R),
            drum(z, ground, (0.97 if upright else 0.8) * R, 0.54 * R, height - (0.86 if upright else 0.6) * R),
        ]

    def _joint(self, i: int) -> None:
        n, a, p, r = self.chain.n, self.axes[i], self.centres[i], self.r(i)
        there = self.centres[i + 1] if i + 1 < n else self.grip_at
        thin = 0.6 * self.r(i + 1) if i + 1 < n else 0.5 * r
        way = there - p
        length = float(np.linalg.norm(way))
        before, after = self.links[i], self.links[i + 1]
        if self.slides[i]:
            half, S = 0.74 * r, self.sleeve
            out = max(float(way @ a), 0.62 * S)
            before.append(slab(a, p, half, -S / 2, S / 2))
            before += [slab(a, p, 1.12 * half, q * S, (q + 0.07) * S, colour="blue") for q in (-0.52, 0.45)]
            after.append(slab(a, p, 0.56 * half, -0.45 * S, out, colour="metal"))
            end = p + out * a
            if np.linalg.norm(there - end) >= r:
                after.append(slab(a, p, 0.95 * half, out - 0.1 * S, out + 0.1 * S, colour="blue"))
                after += tube([*end, 0.6 * half], [*there, thin])
            return
        half = 0.92 * r
        before.append(drum(a, p, r, -half, half))
        after += [drum(a, p, 0.88 * r, s * (half + 0.01 * r), s * (half + 0.3 * r), colour="blue") for s in (-1, 1)]
        if length > 1.6 * r:
            after += tube([*p, 0.66 * r], [*there, thin])

    def _hand(self) -> None:
        n, r = self.chain.n, self.r(self.chain.n)
        way = self.tip - self.centres[-1]
        far = float(np.linalg.norm(way))
        z = way / far if self.grip_at is self.tip and far > 0.3 * r else self.tool[:, 2]
        side = self.tool[:, 0] if abs(self.tool[:, 1] @ z) > 0.7 else self.tool[:, 1]
        y = side - (side @ z) * z
        self.links[n] += [
            drum(z, self.grip_at, 0.8 * r, -0.35 * r, 0.02 * r, colour="metal"),
            *gripper(self.grip_at, z, y / np.linalg.norm(y), 1.75 * r),
        ]
