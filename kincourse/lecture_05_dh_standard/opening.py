"""The opening film: two joint axes and the shortest connection between them, while the second axis moves."""

import numpy as np

from kincourse.axis_relations import draw_axis_relation
from kinlib.rigid.lie import exp
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.pictures import Pictures, film, share


def opening() -> Pictures:
    """Play the common normal of two axes while the second axis tilts, rotates about the first, comes nearer, and leaves."""

    def draw(t: float) -> Picture:
        tilt = np.radians(70 - 40 * share(t, 2, 5))
        side = 0.9 - 0.9 * share(t, 10, 12) + 0.6 * share(t, 13, 14.5)
        R = exp((0, 0, np.radians(-40) * (share(t, 5.7, 8.7) - share(t, 9.8, 11.8))))
        second = R @ (0, np.sin(tilt), np.cos(tilt)), R @ (side, 0.4, 0.5)
        return draw_axis_relation(((0, 0, 1), (0, 0, 0)), second, film=True)

    return film(
        draw,
        [
            (1.9, "Two joint axes in space, and the shortest connection between them. It is perpendicular to both."),
            (3.6, "The second axis tilts. The connection moves along the first axis, and stays perpendicular to both."),
            (3.8, "The second axis rotates about the first, and the connection rotates with it."),
            (
                5.7,
                "It rotates back, comes nearer, and leaves again. How many numbers say where the second axis is, seen from the first?",
            ),
        ],
    )
