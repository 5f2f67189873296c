"""Drawings of linkages: bodies as bars and plates, joints with their names, the ground hatched, and gaps where a loop is open.

A planar linkage is seen from above, any other in the projection of draw_arm.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import exp, inverse
from kinlib.rigid.screw import line
from kinlib.view.drawing.canvas import Canvas, moved, view_axes
from kinlib.view.drawing.figure_colours import GHOST_GREY, GREY, INK, LINK_GREY, ORANGE, PALE_GREY
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.drawing.svg import GREEK
from kinlib.view.figures.joint_bodies import JOINT_RADIUS, NUMBER_OFFSETS, draw_joint_body

GAP_TOL_M = 1e-6
"""If the two halves of a joint are farther apart than this, the gap is drawn."""

Points = Mapping[str, tuple[str, ArrayLike]]


@dataclass(frozen=True, eq=False)
class LinkageGeometry:
    """The positions of everything that is drawn of a linkage.

    first, second  (j, 3)  the point of each joint on its first and on its second body; equal if the loop is closed
    axes           (j, 3)  the direction of each joint's first axis
    corners                the points of each body, (k, 3)
    points                 named points of bodies
    """

    first: Array
    second: Array
    axes: Array
    corners: Mapping[str, Array]
    points: Mapping[str, Array]

    @property
    def all(self) -> Array:
        """All points that are drawn, (m, 3)."""
        return np.concatenate([self.first, self.second, *(point[None] for point in self.points.values())])

    @property
    def gap(self) -> Array:
        """The distance between the two halves of each joint, (j,)."""
        return np.asarray(np.linalg.norm(self.first - self.second, axis=1))


def linkage_geometry(mechanism: Mechanism, q: JointValues, points: Points | None = None) -> LinkageGeometry:
    """Compute where joints, bodies and named points are in a configuration; the arguments are those of `draw_linkage`.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage_geometry(four_bar(4, 1, 3.5, 3), [np.pi / 2, 0, 0, 0]).gap.round(3)      # at q = 0 it is drawn open
    array([0.   , 0.   , 0.   , 8.322])
    """
    validation.instance(mechanism, "mechanism", Mechanism)
    values = validation.single(mechanism.in_order(q), "q")
    poses = mechanism.poses(values)
    if wrong := [body for body, _ in (points or {}).values() if body not in poses]:
        raise ValueError(f"{mechanism.name} has the bodies {', '.join(poses)}; got {wrong[0]!r}.")
    named = {
        name: moved(poses[body], validation.vectors(p, f"point {name}", 3))
        for name, (body, p) in (points or {}).items()
    }
    home = body_points(mechanism)
    corners = {body: moved(T, home[body]) for body, T in poses.items()}
    first, second, axes = [], [], []
    own_values = np.split(values, np.cumsum([joint.dof for joint in mechanism.joints])[:-1])
    for joint, own in zip(mechanism.joints, own_values, strict=True):
        here, there = (poses[body] for body in joint.bodies)
        carried = reduce(np.matmul, exp(joint.screws * own[:, None]), here)
        # A prismatic joint moves its second body along; the other joints keep both bodies at one point.
        first.append(moved(carried, joint.position))
        second.append(moved(there @ inverse(joint.closing_offset), joint.position))
        axes.append(here[:3, :3] @ line(joint.screws[0]).axis)
    for name, (body, _) in (points or {}).items():
        corners[body] = np.concatenate([corners[body], named[name][None]])
    return LinkageGeometry(np.array(first), np.array(second), np.array(axes), corners, named)


def body_points(mechanism: Mechanism) -> dict[str, Array]:
    """Return for each body the points of its joints, (k, 3), which move with it."""
    found: dict[str, list[Array]] = {body: [] for body in mechanism.bodies}
    for joint in mechanism.joints:
        found[joint.bodies[0]].append(joint.position)
        found[joint.bodies[1]].append(moved(inverse(joint.closing_offset), joint.position))
    return {body: np.array(places) for body, places in found.items()}


def draw_linkage(
    mechanism: Mechanism,
    q: JointValues,
    *,
    ghost: JointValues | None = None,
    points: Points | None = None,
    around: ArrayLike | None = None,
    size: tuple[float, float] = (640, 440),
    names: bool = True,
    caption: str = "",
) -> Picture:
    """Draw a linkage in a configuration, in which its loops need not be closed.

    q       (n,) joint values, or a mapping from their names to values
    ghost   (n,) another configuration, drawn in grey
    points  {"P": ("coupler", (x, y, z))}: points of bodies to label, in the coordinates in which the joints are given
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale
    size    width and largest height in pixels
    names   whether joints are labelled

    An orange dotted line connects the two halves of a joint that is not closed.

    Raises ValueError if q or ghost does not have n values or contains NaN, if the linkage has no body of a given name, or if
    the view is unknown.

    >>> from kinlib.mechanisms.linkages import slider_crank
    >>> print(draw_linkage(slider_crank(1, 3), [0, 0, 4, 0]).alt)       # doctest: +NORMALIZE_WHITESPACE
    slider-crank with the bodies ground, crank, slider, rod. A joins ground and crank at (0, 0); B joins crank and rod
    at (1, 0); slide joins ground and slider at (4, 0); C joins slider and rod at (4, 0). All lengths in metres. It is
    closed.
    """
    geometry = linkage_geometry(mechanism, q, points)
    shade = None if ghost is None else linkage_geometry(mechanism, ghost)
    planar = is_planar(mechanism)
    view = "top" if planar else "default"
    seen = np.concatenate([geometry.all, *([] if shade is None else [shade.all])])
    seen = seen if around is None else np.reshape(np.asarray(around, dtype=float), (-1, 3))
    # No axis or frame extends beyond the joints, so the margin can be smaller, most of all for a planar linkage.
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    canvas = Canvas(middle + (0.72 if planar else 0.9) * (seen - middle), view, size)
    canvas.floor(seen)
    if shade is not None:
        _draw_bars(canvas, mechanism, shade, GHOST_GREY, 1.0)
    _draw_bars(canvas, mechanism, geometry, LINK_GREY, 2.0)
    _draw_ground(canvas, mechanism, geometry, view)
    for joint, here, there, axis in zip(mechanism.joints, geometry.first, geometry.second, geometry.axes, strict=True):
        prismatic = not joint.screws[0, :3].any()
        if np.linalg.norm(here - there) > GAP_TOL_M:
            canvas.line([here, there], ORANGE, 2.2, ":", level=3.6)
            canvas.dot(there, ORANGE, 7)
        # A spherical joint looks the same from everywhere: like a revolute joint that is seen along its axis.
        draw_joint_body(canvas, "P" if prismatic else "R", canvas.eye if joint.dof == 3 else axis, here)
        if names:
            canvas.label(here, _joint_label(joint.name), INK, NUMBER_OFFSETS, 11)
    for name, point in geometry.points.items():
        canvas.dot(point, INK, 8)
        canvas.label(point, name, INK)
    return canvas.picture(describe_linkage(mechanism, geometry, shade), caption, cropped=around is None)


def describe_linkage(mechanism: Mechanism, geometry: LinkageGeometry, ghost: LinkageGeometry | None = None) -> str:
    """Return the text alternative of a drawing of a linkage: its bodies, where its joints are, and whether it is closed.

    ghost  the configuration that is drawn in grey
    """
    shown = slice(2) if is_planar(mechanism) else slice(3)
    joints = [
        f"{joint.name} joins {' and '.join(joint.bodies)} at {vector_text(place[shown])}"
        for joint, place in zip(mechanism.joints, geometry.first, strict=True)
    ]
    named = "".join(f" {name} is at {vector_text(point[shown])}." for name, point in geometry.points.items())
    widest = int(np.argmax(geometry.gap))
    closed = "It is closed."
    if geometry.gap[widest] > GAP_TOL_M:
        closed = f"It is open: at {mechanism.joints[widest].name} a gap of {geometry.gap[widest]:.2g} is left."
    bodies = ", ".join(mechanism.bodies)
    if ghost is not None:
        places = zip(mechanism.joints, ghost.first, strict=True)
        closed += f" In grey: {', '.join(f'{joint.name} at {vector_text(place[shown])}' for joint, place in places)}."
    return f"{mechanism.name} with the bodies {bodies}. {'; '.join(joints)}.{named} All lengths in metres. {closed}"


def is_planar(mechanism: Mechanism) -> bool:
    """Whether a linkage moves in the x-y plane only: all rotations are about z, and all translations perpendicular to z."""
    screws = np.concatenate([joint.screws for joint in mechanism.joints])
    return bool(np.allclose(screws[:, [0, 1, 5]], 0))


def _joint_label(name: str) -> str:
    """Return the label of a joint: for theta_1 the Greek letter with its subscript, for "joint 3" the number."""
    head, _, low = name.removeprefix("joint ").partition("_")
    return rf"$\{head}_{{{low}}}$" if low and head in GREEK else name.removeprefix("joint ")


def _draw_bars(canvas: Canvas, mechanism: Mechanism, geometry: LinkageGeometry, colour: str, level: float) -> None:
    """Draw each moving body: a bar through two joints, a plate through more."""
    for body, corners in geometry.corners.items():
        if body == mechanism.ground:
            continue
        shape = np.unique(corners.round(9), axis=0)
        plate = len(shape) > 2 and np.linalg.matrix_rank(shape - shape[0], tol=1e-6 * canvas.size) > 1
        if plate:
            canvas.body(shape, PALE_GREY, level - 0.1, edge=colour)
        if not plate or len(shape) == 3:
            canvas.line(shape[[*range(len(shape)), 0]], colour, 6.0, level=level)


def _draw_ground(canvas: Canvas, mechanism: Mechanism, geometry: LinkageGeometry, view: str) -> None:
    """Draw the ground: a hatched base under each of its joints, a hatched rail along each prismatic one."""
    right, up = sheet = view_axes(view)[1]
    if view != "top":
        canvas.line(geometry.corners[mechanism.ground], GREY, 1.3, "--", level=1.8)
    for joint, foot, axis in zip(mechanism.joints, geometry.first, geometry.axes, strict=True):
        if mechanism.ground not in joint.bodies:
            continue
        if joint.screws[0, :3].any():
            wide, deep = 1.7 * JOINT_RADIUS * canvas.size * right, -2.4 * JOINT_RADIUS * canvas.size * up
            canvas.line([foot + deep - wide, foot, foot + deep + wide], INK, 1.3, level=2.5)
            _hatch(canvas, np.array([foot + deep - 1.3 * wide, foot + deep + 1.3 * wide]), up)
        else:
            _rail(canvas, joint.position, foot, axis, sheet)


def _rail(canvas: Canvas, start: Array, slider: Array, axis: Array, sheet: Array) -> None:
    """Draw the rail of a prismatic joint, below its box: a little longer than the box has moved."""
    across = np.array([-sheet[1] @ axis, sheet[0] @ axis]) @ sheet
    across *= np.sign(across @ sheet[1] or 1.0) / max(np.linalg.norm(across), 1e-9)
    along = np.sort([axis @ (start - slider), 0.0]) + np.array([-0.15, 0.15]) * canvas.size
    _hatch(canvas, slider + np.outer(along, axis) - JOINT_RADIUS * canvas.size * across, across)


def _hatch(canvas: Canvas, ends: Array, up: Array) -> None:
    """Draw a line with short strokes below it, the usual symbol of the ground."""
    canvas.line(ends, INK, 1.6, level=2.5)
    length, step = np.linalg.norm(ends[1] - ends[0]), 0.6 * JOINT_RADIUS * canvas.size
    along = (ends[1] - ends[0]) / length
    for share in np.linspace(0, 1, max(3, int(length / step))):
        root = ends[0] + share * length * along
        canvas.line([root, root - step * (along + up)], GREY, 1.0, level=2.4)
