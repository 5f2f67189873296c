"""The opening film: the velocity field of a twist, and points that flow along it."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp, hat
from kinlib.rigid.screw import screw
from kinlib.view.drawing.canvas import Canvas, moved
from kinlib.view.drawing.figure_colours import GREY, LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.pictures import Pictures, film

AXIS, PLACE, PITCH = np.array([0.0, 0.0, 1.0]), np.array([0.2, 0.1, 0.0]), 0.08
ARROW_S = 0.22
"""For how many seconds of motion an arrow stands."""

RATE = 0.65
"""How fast the plate rotates, in rad/s: at the end it is not seen edge-on."""

BODY = np.array([(0.75, 0.1, 0), (0.75, 0.1, 0.3), (1.05, 0.1, 0.3), (1.05, 0.1, 0), (0.75, 0.1, 0)])


def opening() -> Pictures:
    """Play the velocity field of a twist, and a body that flows along it."""
    S = screw(AXIS, PLACE, pitch=PITCH)
    grid = np.array([(x, y, 0.0) for x in np.linspace(-0.8, 1.2, 6) for y in np.linspace(-0.8, 1.0, 5)])
    around = np.array([(-1.0, -1.0, 0), (1.3, 1.2, 0.9)])

    def draw(t: float) -> Picture:
        angle = max(0.0, t - 3) * RATE
        canvas = Canvas(around)
        canvas.axis(PLACE, PLACE + 0.9 * AXIS, "$S$", width=2)
        for p, v in zip(grid, _velocity(S, grid), strict=True):
            canvas.arrow(p, p + ARROW_S * v, GREY, 1.3)
        if t > 2:
            body = moved(exp(S * angle), BODY)
            trace = np.array([moved(exp(S * a), BODY[1]) for a in np.linspace(0, angle, 40)])
            canvas.line(trace, ORANGE, 1.6, ":")
            canvas.line(body, LINK_GREY, 5)
            for p, v in zip(body[:-1], _velocity(S, body[:-1]), strict=True):
                canvas.arrow(p, p + ARROW_S * v, ORANGE, 2.0)
        where = " A plate stands among them." if 2 < t <= 3 else ""
        if angle:
            where = f" A plate has rotated by {angle:.1f} radians along the arrows."
        return canvas.picture(f"Arrows on the floor around an axis S, longer the farther they are from it.{where}")

    return film(
        draw,
        [
            (2.0, "A twist gives each point of space a velocity: the arrow at that point."),
            (1.0, "Here is a plate. Each of its points moves with the velocity of the arrow at its place."),
            (
                6.5,
                "The plate moves, and the velocities of its points change. The twist does not. How do you get the pose from it?",
            ),
        ],
    )


def _velocity(S: Array, points: Array) -> Array:
    velocity: Array = points @ hat(S[:3]).T + S[3:]
    return velocity
