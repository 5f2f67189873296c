"""The opening film: a wrist whose three axes meet in one point."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, arm, pose
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import carried_axes, draw_joint_body
from kinlib.view.viewer.pictures import Pictures, film, share

CENTRE, REACH = np.array([0.0, 0.0, 0.0]), 0.9
PLACES = (-0.75, 0.0, 0.4)
"""Where on its axis each joint is built."""

NAMED_ENDS = (0.8, 0.8, -0.8)
"""Where on its axis its name stands: that of axis 6 away from the tool, whose frame has letters of its own."""


def opening() -> Pictures:
    """Play the three joints of a spherical wrist, one after the other and then together."""
    wrist = arm([(X, CENTRE), (Y, CENTRE), (X, CENTRE)], pose((Y, Z, X), (REACH, 0, 0)), "wrist", "")
    start = np.array([0.0, 0.6, 0.0])
    around = np.array([(-1.1, -0.9, -0.9), (1.0, 0.9, 0.9)])

    def values(t: float) -> Array:
        turns = np.array([1.6 * share(t, 0.5, 2.5), -1.3 * share(t, 3, 5), 1.8 * share(t, 5.5, 7)])
        together = share(t, 8, 11) * np.array([-2.4, 1.5, 1.0])
        q: Array = start + turns + together
        return q

    def draw(t: float) -> Picture:
        q = values(t)
        links, tip = wrist.link_poses(q), wrist.fk(q)
        canvas = Canvas(around)
        trace = np.array([wrist.fk(values(s))[:3, 3] for s in np.linspace(max(0, t - 4), t, 30)])
        canvas.line(trace, ORANGE, 1.4, ":")
        axes = carried_axes(wrist, links)
        canvas.line([-1.05 * X, CENTRE], LINK_GREY, 7)
        canvas.line([CENTRE, tip[:3, 3]], LINK_GREY, 5)
        for number, axis, place, end in zip("456", axes, PLACES, NAMED_ENDS, strict=True):
            canvas.axis(CENTRE - 0.8 * axis, CENTRE + 0.8 * axis)
            canvas.label(CENTRE + end * axis, f"axis {number}", VIOLET)
            draw_joint_body(canvas, "R", axis, CENTRE + place * axis)
        canvas.triad(tip, "b", 0.22)
        canvas.dot(CENTRE, INK, 9, level=6)
        return canvas.picture(
            f"Three axes 4, 5 and 6 that meet in one point. The tool is at {vector_text(tip[:3, 3])} from there."
        )

    return film(
        draw,
        [
            (2.7, "A wrist has three joints. Joint 4 rotates."),
            (2.5, "Joint 5 rotates, and carries joint 6 with it."),
            (2.3, "Joint 6 rotates. The three axes always meet in the same point."),
            (4.0, "All three rotate together. What can they change, and what must the arm before them do?"),
        ],
    )
