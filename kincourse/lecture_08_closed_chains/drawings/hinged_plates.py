"""Linkages of hinged plates: each body is a plate as wide as its hinges, so that one can see which edges are joined."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.screw import line
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, JOINT_FILL, LINK_GREY, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Gallery, Picture, vector_text
from kinlib.view.figures.linkage import linkage_geometry

HALF_WIDTH_M = 0.14


def draw_hinged_plates(mechanism: Mechanism, configurations: ArrayLike) -> Gallery:
    """Draw a linkage whose joints are hinges as plates, in several configurations side by side.

    configurations  (k, n) joint values, in which the loop closes

    >>> draw_hinged_plates(kl.linkages.sarrus(), np.zeros((1, 6))).pictures[0].alt[:62]
    "Sarrus's linkage as plates: ground, lower plate x, upper plate"
    """
    values = np.atleast_2d(np.asarray(configurations, dtype=float))
    around = np.concatenate([linkage_geometry(mechanism, q).all for q in values])
    return Gallery(tuple(_draw(mechanism, q, around) for q in values))


def _draw(mechanism: Mechanism, q: Array, around: Array) -> Picture:
    geometry = linkage_geometry(mechanism, q)
    canvas = Canvas(around, "facing", (330, 330))
    hinges: dict[str, list[Array]] = {}
    poses = dict(zip(mechanism.bodies, geometry.poses, strict=True))
    for joint, place in zip(mechanism.joints, geometry.first, strict=True):
        axis = poses[joint.bodies[0]][:3, :3] @ line(joint.screws[0]).axis
        edge = np.array([place - HALF_WIDTH_M * axis, place + HALF_WIDTH_M * axis])
        for body in joint.bodies:
            hinges.setdefault(body, []).append(edge)
        canvas.line(edge, VIOLET, 3.0, level=4)
    for body, edges in hinges.items():
        corners = np.concatenate(edges)
        nearness = float(canvas.eye @ corners.mean(axis=0))
        fill = JOINT_FILL if body == "top" else PALE_GREY
        canvas.body(corners, fill, level=2 + 0.5 * nearness, edge=LINK_GREY)
        if body in {"ground", "top"}:
            canvas.label(corners.mean(axis=0), body, INK)
    top = np.concatenate(hinges["top"]).mean(axis=0)
    return canvas.picture(
        f"{mechanism.name} as plates: {', '.join(hinges)}. Two chains of plates fold in perpendicular planes, and the middle of the "
        f"top is at {vector_text(top)}.",
        cropped=True,
    )
