"""The opening film: two joint axes and the shortest connection between them, while the second axis moves."""

import numpy as np

from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.axis_relations import draw_moving_normal
from kinlib.view.viewer.film import Film, film, share


def opening() -> Film:
    """Play the common normal of two axes while the second axis moves: skew, crossing, and skew again."""

    def draw(t: float) -> Picture:
        tilt = np.radians(70 - 40 * share(t, 2, 5))
        side = 0.9 - 0.9 * share(t, 6, 8) + 0.6 * share(t, 9, 10.5)
        return draw_moving_normal(tilt, side)

    return film(
        draw,
        [
            (1.9, "Two joint axes in space, and the shortest connection between them. It is perpendicular to both."),
            (3.6, "The second axis tilts. The connection slides along the first axis and turns about it."),
            (
                5.5,
                "The second axis comes nearer, and leaves again. How many numbers say where the second axis is, seen from the first?",
            ),
        ],
    )
