"""The opening film: one arm in two configurations, and joints that rotate at the same rate in both."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, arm, pose
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.viewer.pictures import Pictures, film, share

STARTS = np.radians([(10, 40), (10, 130)])
APART = np.array([1.7, 0.0, 0.0])
"""From the left arm to the right one."""

TURN_1, TURN_2 = 0.6, 0.5
"""How far joint 1 and joint 2 rotate, in radians."""


def opening() -> Pictures:
    """Play the same rotations of two joints, of an arm that is almost straight and of the same arm with a bent elbow."""
    chain = arm([(Z, (0, 0, 0)), (Z, (0.6, 0, 0))], pose((X, Y, Z), (1.1, 0, 0)), "plane arm", "")
    around = np.array([(-0.25, -0.3, 0), (2.6, 1.2, 0)])

    def turned(t: float) -> Array:
        return np.array([TURN_1 * share(t, 1.5, 4), TURN_2 * share(t, 5, 7.5)])

    def draw(t: float) -> Picture:
        canvas = Canvas(around, view="top")
        tools = []
        for start, base in zip(STARTS, (0 * APART, APART), strict=True):
            trace = np.array([chain.fk(start + turned(s))[:3, 3] for s in np.linspace(0, t, 40)])
            elbow = chain.link_poses(start + turned(t))[1, :3, 3]
            canvas.line(trace + base, ORANGE, 2.4, ":")
            canvas.line(np.array([np.zeros(3), elbow, trace[-1]]) + base, LINK_GREY, 6)
            for number, joint in (("1", np.zeros(3)), ("2", elbow)):
                canvas.dot(joint + base, LINK_GREY, 12)
                canvas.label(joint + base, number, INK, [(14, -12)], 12)
            canvas.dot(trace[-1] + base, ORANGE, 9, level=6)
            tools.append(vector_text(trace[-1].round(2) + 0.0))
        return canvas.picture(
            f"The same arm in two configurations, seen from above. From its base, the left tool is at {tools[0]}, "
            f"and the right one at {tools[1]}."
        )

    return film(
        draw,
        [
            (1.5, "One arm, in two configurations."),
            (3.0, "Joint 1 rotates, at the same rate in both. Compare the paths of the two tools."),
            (3.0, "Joint 2 rotates, again at the same rate in both."),
            (
                1.0,
                "The rates are equal, and the velocities of the tools are not. How do you get from the rates to a velocity?",
            ),
        ],
    )
