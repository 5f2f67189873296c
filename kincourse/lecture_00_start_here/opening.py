"""The opening film: an arm moves, and its joint values are known at each moment."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.robots import youbot
from kinlib.view.figures.arm import draw_arm
from kinlib.view.viewer.film import Film, film, share

POSES = np.radians([(0, 0, 0, 0, 0), (50, 40, 30, -40, 0), (-35, 75, -60, 50, 60)])


def opening() -> Film:
    """Play an arm that moves from one configuration to another.

    >>> opening().alt[:53]
    'Five joints move at once. The values of all of them a'
    """
    arm = youbot()
    around = np.array([(-0.2, -0.3, 0), (0.5, 0.4, 0.75)])

    def at(t: float) -> Array:
        first, second = share(t, 0, 3), share(t, 4, 7)
        q: Array = POSES[0] + first * (POSES[1] - POSES[0]) + second * (POSES[2] - POSES[1])
        return q

    return film(
        lambda t: draw_arm(arm, at(t), show=("tool",), around=around),
        [
            (3.5, "Five joints move at once. The values of all of them are known at each moment."),
            (
                4.0,
                "The gripper has been carried by every joint. Where is it now, and in which direction does it point?",
            ),
        ],
    )
