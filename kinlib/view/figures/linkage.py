"""Linkages as machines: drums and balls at the joints, tubes between them, feet, and gaps where a loop is open.

A planar linkage is seen from above, any other in the projection of draw_arm.
"""

from dataclasses import dataclass
from functools import reduce
from itertools import chain, pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import exp, inverse
from kinlib.rigid.screw import line
from kinlib.view.drawing.canvas import Canvas, moved
from kinlib.view.drawing.figure_colours import GHOST_GREY, INK, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.drawing.svg import GREEK
from kinlib.view.figures.bodies import Body, Primitive, ball, drum, slab, tube
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import JOINT_RADIUS

Z = np.array([0.0, 0, 1])

GAP_TOL_M = 1e-6
"""If the two halves of a joint are farther apart than this, the gap is drawn."""


@dataclass(frozen=True, eq=False)
class LinkageGeometry:
    """The positions of everything that is drawn of a linkage.

    poses                  the motion of each body from home, (b, 4, 4)
    first, second  (j, 3)  the point of each joint on its first and on its second body; equal if the loop is closed
    """

    poses: Array
    first: Array
    second: Array

    @property
    def all(self) -> Array:
        """All points that are drawn, (m, 3)."""
        return np.concatenate([self.first, self.second])


def linkage_geometry(mechanism: Mechanism, q: JointValues) -> LinkageGeometry:
    """Compute where joints and bodies are in a configuration (n,)."""
    validation.instance(mechanism, "mechanism", Mechanism)
    values = validation.single(mechanism.in_order(q), "q")
    poses = mechanism.poses(values)
    first, second = [], []
    own_values = np.split(values, np.cumsum([joint.dof for joint in mechanism.joints])[:-1])
    for joint, own in zip(mechanism.joints, own_values, strict=True):
        here, there = (poses[body] for body in joint.bodies)
        # A prismatic joint moves its second body along; the other joints keep both bodies at one point.
        first.append(moved(reduce(np.matmul, exp(joint.screws * own[:, None]), here), joint.point))
        second.append(moved(there @ inverse(joint.closing_offset), joint.point))
    moves = np.array([poses[body] for body in mechanism.bodies])
    return LinkageGeometry(moves, np.array(first), np.array(second))


def body_points(mechanism: Mechanism) -> dict[str, Array]:
    """Return for each body the points of its joints, (k, 3), which move with it."""
    found: dict[str, list[Array]] = {body: [] for body in mechanism.bodies}
    for joint in mechanism.joints:
        found[joint.bodies[0]].append(joint.point)
        found[joint.bodies[1]].append(moved(inverse(joint.closing_offset), joint.point))
    return {body: np.array(places) for body, places in found.items()}


def draw_linkage(
    mechanism: Mechanism,
    q: JointValues,
    *,
    ghost: JointValues | None = None,
    around: ArrayLike | None = None,
    names: bool = True,
    caption: str = "",
) -> Picture:
    """Draw a linkage in a configuration, in which its loops need not be closed.

    q       (n,) joint values, or a mapping from their names to values
    ghost   (n,) another configuration, drawn in grey
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale
    names   whether joints are labelled

    An orange dotted line connects the two halves of a joint that is not closed.

    Raises ValueError if q or ghost does not have n values or contains NaN.

    >>> print(draw_linkage(kl.linkages.slider_crank(1, 3), [0, 0, 4, 0]).alt)       # doctest: +NORMALIZE_WHITESPACE
    slider-crank with the bodies ground, crank, slider, rod. A joins ground and crank at (0, 0); B joins crank and rod
    at (1, 0); x joins ground and slider at (4, 0); C joins slider and rod at (4, 0). All lengths in metres. It is closed.
    """
    geometry = linkage_geometry(mechanism, q)
    shade = None if ghost is None else linkage_geometry(mechanism, ghost)
    drawn = [geometry.all] if shade is None else [geometry.all, shade.all]
    seen = np.reshape(np.concatenate(drawn) if around is None else np.asarray(around, dtype=float), (-1, 3))
    # No axis or frame extends beyond the joints, so the margin can be smaller.
    canvas = Canvas(0.75 * seen + 0.25 * seen.mean(axis=0), "top" if is_planar(mechanism) else "default")
    body = linkage_body(mechanism, mechanism.in_order(q)[None])
    canvas.floor(seen, height=body.lowest)
    for T, (name, ends) in zip(shade.poses, body_points(mechanism).items(), strict=True) if shade else ():
        if name != mechanism.ground:
            canvas.line(moved(T, np.array([*ends, ends[0]])), GHOST_GREY, 6.0, level=1)
    draw_body(canvas, body, geometry.poses)
    for joint, here, there in zip(mechanism.joints, geometry.first, geometry.second, strict=True):
        if np.linalg.norm(here - there) > GAP_TOL_M:
            canvas.line([here, there], ORANGE, 2.2, ":", level=3.6)
            canvas.dot(there, ORANGE, 7)
        if names:
            label = joint.name.removeprefix("joint ")
            head, _, low = label.partition("_")  # for theta_1 the Greek letter with its subscript
            canvas.label(here, rf"$\{head}_{{{low}}}$" if low and head in GREEK else label, INK)
    return canvas.picture(describe_linkage(mechanism, geometry, shade), caption, cropped=around is None)


def describe_linkage(mechanism: Mechanism, geometry: LinkageGeometry, ghost: LinkageGeometry | None = None) -> str:
    """Return the text alternative of a drawing of a linkage: its bodies, where its joints are, and whether it is closed."""
    shown = slice(2) if is_planar(mechanism) else slice(3)
    joints = [
        f"{joint.name} joins {' and '.join(joint.bodies)} at {vector_text(place[shown])}"
        for joint, place in zip(mechanism.joints, geometry.first, strict=True)
    ]
    gaps = np.linalg.norm(geometry.first - geometry.second, axis=1)
    widest, closed = int(np.argmax(gaps)), "It is closed."
    if gaps[widest] > GAP_TOL_M:
        closed = f"It is open: at {mechanism.joints[widest].name} a gap of {gaps[widest]:.2g} is left."
    if ghost is not None:
        places = zip(mechanism.joints, ghost.first, strict=True)
        closed += f" In grey: {', '.join(f'{joint.name} at {vector_text(place[shown])}' for joint, place in places)}."
    head = f"{mechanism.name} with the bodies {', '.join(mechanism.bodies)}."
    return f"{head} {'; '.join(joints)}. All lengths in metres. {closed}"


def is_planar(mechanism: Mechanism) -> bool:
    """Whether a linkage moves in the x-y plane only: all rotations are about z, and all translations perpendicular to z."""
    return bool(np.allclose(mechanism.screws[:, [0, 1, 5]], 0))


def linkage_body(mechanism: Mechanism, configurations: Array) -> Body:
    """Return the body of a linkage: its ground, and what joints and links look like; bodies move from home by their poses.

    configurations  (m, n) those in which it is drawn: rails and rods are as long as they need
    """
    q, ends, ground = configurations, body_points(mechanism), mechanism.ground
    links: dict[str, list[Primitive]] = {body: [] for body in mechanism.bodies}
    size = max(float(np.ptp(linkage_geometry(mechanism, q[0]).all, axis=0).max()), 1e-3)
    planar, R = is_planar(mechanism), JOINT_RADIUS * size
    columns = np.cumsum([0, *(joint.dof for joint in mechanism.joints)])
    standing: list[Array] = []
    for joint, column in zip(mechanism.joints, columns, strict=False):
        first, second = joint.bodies
        p, there = joint.point, moved(inverse(joint.closing_offset), joint.point)
        axis, slides = line(joint.screws[0]).axis, not joint.screws[0, :3].any()
        if ground in joint.bodies and not slides:
            standing.append(p if first == ground else there)
        if joint.dof > 1:
            links[first].append(ball(p, 1.1 * R, "metal"))
        elif not slides:
            links[first].append(drum(axis, p, R, -1.3 * R, 1.3 * R))
            links[second] += [drum(axis, there, 0.8 * R, s * 1.3 * R, s * 1.6 * R, colour="blue") for s in (-1, 1)]
        else:
            low, high = min(0.0, float(q[:, column].min())), max(0.0, float(q[:, column].max()))
            links[second].append(slab(axis, there, 0.75 * R, -1.4 * R, 1.4 * R, colour="blue"))
            if first == ground:  # a rail as long as the way of the slider, or else a sleeve and a rod
                rail = p - (0, 0, 0.9 * R)
                links[first].append(slab(axis, rail, 0.4 * R, low - 3 * R, high + 3 * R, colour="dark"))
            else:
                links[first] += [drum(axis, p, 0.8 * R, -3 * R, 0), drum(axis, p, R, -1.2 * R, 0, colour="blue")]
                links[second].append(drum(axis, there, 0.42 * R, -high - R, 0))
    # a link is a bar from joint to joint, or a frame through more joints, in their order
    for body, own in ends.items():
        ways = pairwise([*own, *own[: len(own) > 2]]) if body != ground else ()
        tubes = [tube([*a, 0.6 * R], [*b, 0.6 * R]) for a, b in ways if np.linalg.norm(b - a) > 1e-9]
        links[body] += chain.from_iterable(tubes)
    places = np.unique(np.round(standing or ends[ground], 9), axis=0)
    low = float(places[:, 2].min()) - (0.1 if planar else 0.06) * size
    feet = places * (1, 1, 0) + (0, 0, low)  # one under each joint of the ground, with a column up to it
    links[ground] += [drum(Z, foot, 1.8 * R, 0, 0.4 * R, colour="dark") for foot in feet]
    for foot, top in zip(feet, places + 1e-6 * Z, strict=True):
        links[ground] += tube([*foot, 0.7 * R], [*top, 0.6 * R], colour="dark")
    return Body(tuple(tuple(links[body]) for body in mechanism.bodies))
