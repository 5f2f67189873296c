"""The velocity that each joint gives to the end-effector, and the direction in which the end-effector cannot move."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies, stations

VELOCITY_SHARE = 0.45
"""The length of the longest velocity, as a share of the size of the drawing."""

LOST_RATIO = 1e-9
"""A singular value below this share of the largest one counts as zero."""


def draw_tool_velocities(chain: Chain, q: ArrayLike, *, around: ArrayLike | None = None) -> Picture:
    """Draw an arm at q, and for each joint the velocity of the origin of {b} at a rate of 1 rad/s or 1 m/s of this joint alone.

    q       (n,) the joint values
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    If the velocities of all joints are perpendicular to one direction, a dashed line shows it: the origin of {b} cannot move
    in this direction, whatever the joint rates are. Velocities that are zero are not drawn.

    >>> print(draw_tool_velocities(kl.robots.youbot(), np.zeros(5)).alt)                       # doctest: +NORMALIZE_WHITESPACE
    youBot at q = (0, 0, 0, 0, 0). Velocity of the origin of {b} by joint 1: (0, 0.54, 0); by joint 2: (0, 0, 0.507);
    by joint 3: (0, 0, 0.352); by joint 4: (0, 0, 0.217); by joint 5: (0, 0, 0). No joint rates move it along (1, 0, 0).
    """
    q = np.asarray(q, dtype=float)
    tool, velocities = chain.fk(q)[:3, 3], tool_velocities(chain, q)
    path = stations(chain, q)
    canvas = Canvas(path if around is None else around)
    canvas.floor(path if around is None else around)
    canvas.line(path, LINK_GREY, 6.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(q))
    canvas.triad(np.eye(4), "s", 0.13 * canvas.size)
    lost = lost_directions(velocities)
    for direction in lost:
        reach = 0.33 * canvas.size * direction
        canvas.line([tool - reach, tool + reach], ORANGE, 2.0, "--", level=1.5)
        canvas.label(tool + reach, "no motion", ORANGE, size=10)
    sizes = np.linalg.norm(velocities, axis=1)
    scale = VELOCITY_SHARE * canvas.size / max(float(sizes.max()), 1e-9)
    for i, (velocity, size) in enumerate(zip(velocities, sizes, strict=True), start=1):
        if size > 1e-9:
            canvas.arrow(tool, tool + scale * velocity, VIOLET, 2.4, level=6)
            canvas.label(tool + scale * velocity, f"joint {i}", VIOLET, size=10)
    canvas.dot(tool, INK, 7, level=7)
    by_joint = "; ".join(f"by joint {i}: {vector_text(velocity)}" for i, velocity in enumerate(velocities, start=1))
    alt = f"{chain.name} at q = {vector_text(q)}. Velocity of the origin of {{b}} {by_joint}. "
    along = " or ".join(vector_text(direction) for direction in lost)
    return canvas.picture(
        alt + (f"No joint rates move it along {along}." if along else "Joint rates move it in every direction."),
    )


def tool_velocities(chain: Chain, q: Array) -> Array:
    """Return the velocity of the origin of {b} in {s} for a unit rate of each joint, (n, 3): v + omega x p of the columns of J_s.

    >>> tool_velocities(kl.robots.rpr(), np.zeros(3))[1]
    array([0., 0., 1.])
    """
    J = chain.jacobian(q)
    velocities: Array = (J[3:] + np.cross(J[:3], chain.fk(q)[:3, 3], axisa=0, axisc=0)).T
    return velocities


def lost_directions(velocities: Array) -> Array:
    """Return unit vectors (k, 3) perpendicular to all of the vectors (n, 3): none if they span the space.

    >>> lost_directions(np.array([[0, 2.0, 0], [0, 0, 1], [0, 1, 1]]))
    array([[1., 0., 0.]])
    """
    _, sizes, directions = np.linalg.svd(np.concatenate([velocities, np.zeros((3, 3))]))
    lost = directions[sizes < LOST_RATIO * max(float(sizes[0]), 1e-300)]
    signs = np.sign(lost[np.arange(len(lost)), np.abs(lost).argmax(axis=1)])
    found: Array = (signs[:, None] * lost).round(12) + 0.0
    return found
