"""The opening film: one motion of an arm, seen from its base and from its tool."""

import numpy as np

from kinlib.chains.robots import plain_arm
from kinlib.rigid.lie import inverse
from kinlib.view.drawing.canvas import Canvas, moved
from kinlib.view.drawing.figure_colours import LINK_GREY
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.pictures import Pictures, film, share

END = np.array([1.2, 0.7, 0.15, -1.3])
APART = np.array([1.75, 1.0, 0.0])
"""From the picture that the base sees to that which the tool sees."""

SEEN, REST = np.array([(-0.6, -0.5, 0.0), (0.75, 0.6, 1.3)]), np.array([-0.55, 0.1, 0.0])
"""The space that the right picture needs, and where in it the tool is at rest."""


def opening() -> Pictures:
    """Play one motion twice, side by side: with the base at rest, and with the tool at rest."""
    arm = plain_arm()
    around = np.array([(-0.45, -0.4, 0), (0.8, 0.7, 1.05), APART + SEEN[0], APART + SEEN[1]])
    rest = arm.home.copy()
    rest[:3, 3] += APART + REST

    def draw(t: float) -> Picture:
        q = END * share(t, 2, 6)
        canvas = Canvas(around)
        path = stations(arm, q)
        seen = rest @ inverse(arm.fk(q))
        for points, base, tool in ((path, np.eye(4), arm.fk(q)), (moved(seen, path), seen, rest)):
            canvas.line(points, LINK_GREY, 6)
            for joint in points[1:-1]:
                canvas.dot(joint, LINK_GREY, 12)
            canvas.triad(base, "s", 0.2)
            canvas.triad(tool, "b", 0.2)
        return canvas.picture(
            f"On the left {{s}} is at rest, and {{b}} is at {vector_text(arm.fk(q)[:3, 3])} in {{s}}. On the right {{b}} is at rest, and "
            f"{{s}} is at {vector_text(inverse(arm.fk(q))[:3, 3])} in {{b}}."
        )

    return film(
        draw,
        [
            (2.0, "One arm, two pictures. On the left you are at the base, on the right you sit on the tool."),
            (4.2, "The same motion of the same joints. On the left the tool moves, on the right the base."),
            (1.0, "Which numbers would somebody write down who describes the joints from the tool?"),
        ],
    )
