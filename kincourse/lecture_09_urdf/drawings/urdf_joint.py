"""A joint of a URDF: from the frame of the parent link by the origin to the joint frame, and about the axis to the child link."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.rigid.lie import exp
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

STEP_LABELS = [(-26, 14), (26, -14), (-34, -12), (34, 14), (0, 22), (0, -22), (-60, 10), (60, -10)]


def draw_urdf_joint(
    origin: ArrayLike,
    axis: ArrayLike,
    q: float,
    links: tuple[str, str] = ("parent", "child"),
) -> Picture:
    """Draw a revolute joint of a URDF: the frame of the parent link, the origin, the axis, and the frame of the child link at q.

    origin  (4, 4) the joint frame in the frame of the parent link, which is also the frame of the child link at q = 0
    axis    (3,) in the joint frame, of unit length
    q       the joint value, in radians
    links   the names of the parent link and the child link

    >>> from kinlib.rigid.rpy import origin
    >>> draw_urdf_joint(origin((0, 0, 0.3), (-np.pi / 2, 0, 0)), (0, 0, 1), 0.5, ("post", "rod")).alt[:73]
    'The frame {post} of the parent link at (0, 0, 0). The origin leads to the'
    """
    T, a = np.asarray(origin, dtype=float), np.asarray(axis, dtype=float)
    parent, child = links
    moved = T @ exp(q * np.concatenate([a, 0 * a]))
    direction = T[:3, :3] @ a
    length = 0.45 * max(float(np.linalg.norm(T[:3, 3])), 0.2)
    tip = T[:3, 3] + 1.5 * length * direction
    canvas = Canvas(np.array([0 * a, T[:3, 3], tip]), size=(560, 460))
    canvas.arrow(0 * a, T[:3, 3], ORANGE, 2.0, style="--", level=3)
    canvas.label(T[:3, 3] / 2, "origin", ORANGE, STEP_LABELS, 13)
    canvas.line([T[:3, 3] - 0.9 * length * direction, tip], VIOLET, 1.4, ":", level=2)
    canvas.arrow(T[:3, 3], tip, VIOLET, 3.2, level=3)
    canvas.label(tip, "axis", VIOLET, [(24, 6), (-24, 6), (0, 16), (0, -16)], 13)
    canvas.triad(np.eye(4), parent, length)
    if q:
        canvas.triad(T, "", 0.8 * length, (GHOST_GREY,) * 3, level=4)
    canvas.triad(moved, child, length, AXIS_COLOURS, level=6)
    canvas.dot(T[:3, 3], INK)
    alt = (
        f"The frame {{{parent}}} of the parent link at (0, 0, 0). The origin leads to the joint frame at {vector_text(T[:3, 3])}, "
        f"its x along {vector_text(T[:3, 0])}, its z along {vector_text(T[:3, 2])}. The axis {vector_text(a)} of the joint frame has "
        f"the direction {vector_text(direction)} in {{{parent}}}. At q = {q:.3g} rad the frame {{{child}}} of the child link is at "
        f"{vector_text(moved[:3, 3])}, its x along {vector_text(moved[:3, 0])}."
    )
    return canvas.picture(alt, cropped=True)
