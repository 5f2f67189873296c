"""Drawings of joints: a cylinder for a revolute joint, a box for a prismatic one, a cylinder with rings for a helical one."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import inverse
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK
from kinlib.view.figures.bodies import drum, slab
from kinlib.view.figures.body_drawing import draw_solid

JOINT_RADIUS = 0.035
"""The radius of a joint, as a share of the size of what is shown."""

JOINT_SPACING = 3.3 * JOINT_RADIUS
"""The distance of joints that are drawn side by side on one axis, as a share of the same size."""

MAX_DISTANCE_IN_ARM_SIZES = 3.0
"""Frames and normals farther from the arm than this are left out, as those of nearly parallel axes can be."""


def draw_joint_bodies(canvas: Canvas, chain: Chain, frames: Array) -> None:
    """Draw the joints of a chain with their numbers, where the frames (n, 4, 4) of its links are."""
    axes = carried_axes(chain, frames)
    for i, (z, shift) in enumerate(zip(axes, axial_offsets(axes, frames[:, :3, 3]), strict=True)):
        centre = frames[i, :3, 3] + JOINT_SPACING * canvas.size * shift * z
        draw_joint_body(canvas, chain.joint_types[i], z, centre)
        canvas.label(centre, str(i + 1), INK)


def draw_joint_body(canvas: Canvas, letter: str, z: Array, centre: Array) -> None:
    """Draw one joint R, P or H with its axis along z, (3,)."""
    r = JOINT_RADIUS * canvas.size
    level = 3.0 + 0.01 * float(canvas.eye @ centre) / canvas.size  # a nearer joint hides a farther one
    solids = [slab(z, centre, 0.8 * r, -1.5 * r, 1.5 * r, colour="joint")]
    if letter != "P":
        solids = [drum(z, centre, r, -1.5 * r, 1.5 * r, colour="joint")]
    if letter == "H":
        solids += [drum(z, centre, 1.15 * r, (k - 0.15) * r, (k + 0.15) * r, colour="joint") for k in (-0.9, 0, 0.9)]
    for k, solid in enumerate(solids):
        draw_solid(canvas, solid, level + 1e-4 * k)


def stations(chain: Chain, q: ArrayLike | None = None) -> Array:
    """Return the points (n + 2, 3) through which an arm runs: the base, every joint, the tool; at home by default."""
    if q is None:
        return np.array([np.zeros(3), *chain.joint_points, chain.home[:3, 3]])
    return np.array([np.zeros(3), *chain.link_poses(q)[:, :3, 3], chain.fk(q)[:3, 3]])


def body_motions(chain: Chain, q: ArrayLike) -> Array:
    """Return the motion of each body from home to q, (n + 1, 4, 4): body 0 is the base, body i is what joint i moves."""
    moved = chain.link_poses(q) @ inverse(chain.link_poses(np.zeros(chain.n)))
    return np.concatenate([np.eye(4)[None], moved])


def arm_size(*arms: Chain) -> float:
    """Return the longest side of arms at home, in metres: the unit of length of what is not drawn to scale; 1 if it is 0."""
    side = float(np.ptp(np.concatenate([stations(arm) for arm in arms]), axis=0).max())
    return side if side > 1e-9 else 1.0


def are_near(points: ArrayLike, size: float) -> NDArray[np.bool_]:
    """Return which of the points (..., 3) are near enough to an arm of that size to be drawn with it."""
    return np.asarray(np.abs(points).max(axis=-1) < MAX_DISTANCE_IN_ARM_SIZES * size)


def carried_axes(chain: Chain, frames: Array) -> Array:
    """Return the direction of each joint's axis in the current configuration, (n, 3)."""
    return np.asarray((frames[:, :3, :3] @ chain.lines.axis[:, :, None])[..., 0])


def axial_offsets(axes: Array, points: Array) -> Array:
    """Return how far each joint is drawn from its point along its axis, (n,), in units of JOINT_SPACING.

    Joints with the same point and axis would hide each other. A joint may be drawn anywhere on its axis, because its screw and
    therefore its motion stay the same.
    """
    same = np.linalg.norm(points[:, None] - points, axis=-1) < 1e-6
    same &= np.abs(axes @ axes.T) > 1 - 1e-6
    rank = np.tril(same, -1).sum(axis=1) - (same.sum(axis=1) - 1) / 2
    # Along the direction of the first one, even if others point in the opposite direction.
    return np.asarray(rank * np.sign((axes * axes[same.argmax(axis=1)]).sum(axis=1)))
