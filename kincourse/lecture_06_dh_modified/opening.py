"""The opening film: a link between two joints, and two places where its frame may be."""

import numpy as np

from kinlib.chains.robots import X, Y, Z, arm, pose
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import LINK_GREY
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import carried_axes, draw_joint_body
from kinlib.view.viewer.pictures import Pictures, film, share

ELBOW, TIP = np.array([0.7, 0.0, 0.0]), np.array([1.2, 0.0, 0.0])


def opening() -> Pictures:
    """Play two joints of an arm. The link between them has two frames, one at each of its ends."""
    chain = arm([(Z, (0, 0, 0)), (Y, ELBOW)], pose((X, Y, Z), TIP), "two joints", "")
    around = np.array([(-0.35, -0.5, -0.5), (1.3, 0.8, 0.6)])

    def draw(t: float) -> Picture:
        q = np.array([0.7 * share(t, 2, 4.2) - 0.9 * share(t, 8, 11), -0.8 * share(t, 5, 7.2) + 1.1 * share(t, 8, 11)])
        links, tip = chain.link_poses(q), chain.fk(q)[:3, 3]
        near, far = links[0], links[0] @ pose((X, -Z, Y), ELBOW)
        canvas = Canvas(around)
        canvas.line([near[:3, 3], far[:3, 3]], LINK_GREY, 8)
        canvas.line([far[:3, 3], tip], LINK_GREY, 4)
        for number, axis, place in zip("12", carried_axes(chain, links), (near, far), strict=True):
            canvas.axis(place[:3, 3] - 0.45 * axis, place[:3, 3] + 0.45 * axis, f"axis {number}")
            draw_joint_body(canvas, "R", axis, place[:3, 3])
        for place in (near, far):
            canvas.triad(place, "", 0.22)
        return canvas.picture(
            f"A link, and a joint at each end. One frame of the link is at {vector_text(near[:3, 3])}, another one at "
            f"{vector_text(far[:3, 3])}. The tip of the next link is at {vector_text(tip)}."
        )

    return film(
        draw,
        [
            (2.0, "A link between two joints. A frame may be at each of its two ends, with z on the axis there."),
            (2.6, "Joint 1 rotates. Both frames move with the link."),
            (2.8, "Joint 2 rotates. Both frames stay where they are, because they belong to the link before it."),
            (4.0, "Either of them is a frame of this link. What changes in the table if you choose the other one?"),
        ],
    )
