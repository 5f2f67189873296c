"""The opening film: the common normal of two axes slides away while the axes become parallel."""

import numpy as np

from kincourse.axis_relations import draw_axis_relation
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.pictures import Pictures, film, share


def opening() -> Pictures:
    """Play the common normal of two axes while the second axis turns towards the direction of the first."""

    def draw(t: float) -> Picture:
        tilt = np.radians(75 - 63 * share(t, 3, 8) - 12 * share(t, 9.5, 10.5))
        return draw_axis_relation(((0, 0, 1), (0, 0, 0)), ((0, np.sin(tilt), np.cos(tilt)), (0.8, 0.4, 0.5)), film=True)

    return film(
        draw,
        [
            (3.0, "The common normal, the shortest line between two axes, is perpendicular to both at its feet."),
            (7.6, "The second axis turns slowly towards the direction of the first. Watch the feet."),
            (1.9, "Now the axes have the same direction. Where would you put the x axis of a frame?"),
        ],
    )
