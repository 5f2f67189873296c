"""The opening film: the joints of an arm move one after the other, from the tool to the base."""

import numpy as np

from kinlib.chains.robots import plain_arm
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import draw_arm
from kinlib.view.viewer.film import Film, film, share

END = np.array([0.9, 0.6, 0.15, -1.1])
MOVE_S = 2.0


def opening() -> Film:
    """Play the joints of an arm, the last one first, each about its axis at home.

    >>> opening().alt[:32]
    'An arm at home, with the axes of'
    """
    arm = plain_arm()
    n = arm.n
    around = np.array([(-0.3, -0.35, 0), (0.9, 0.7, 1.1)])

    def draw(t: float) -> Picture:
        starts = 1 + MOVE_S * np.arange(n)[::-1]
        q = END * [share(t, start, start + 0.8 * MOVE_S) for start in starts]  # then a pause
        return draw_arm(arm, q, show=("home axes", "tool", "base"), around=around)

    return film(
        draw,
        [
            (1.0, "An arm at home, with the axes of its joints in grey."),
            *((MOVE_S, f"Joint {i} moves. Is its axis still where the grey arrow is?") for i in range(n, 0, -1)),
            (
                1.0,
                "Each joint was moved once. What would you have to write down for each of them, to compute where the tool is now?",
            ),
        ],
    )
