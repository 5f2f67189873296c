"""The opening film: an arm moves as a tracker sees it, and as a description of it says."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.robots import angled_arm, plain_arm
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GHOST_GREY, INK, LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.film import Film, film, share

END = np.array([1.3, 0.8, 0.15, -1.2])


def opening() -> Film:
    """Play an arm, the places where its tool was measured, and where a description with a fault puts it.

    >>> opening().alt[:40]
    'This arm is being measured: a tracker se'
    """
    real, described = plain_arm(), angled_arm(tilt=np.radians(14))
    around = np.array([(-0.4, -0.4, 0), (0.9, 0.9, 1.2)])

    def at(t: float) -> Array:
        q: Array = END * share(t, 1, 6)
        return q

    def draw(t: float) -> Picture:
        q = at(t)
        canvas = Canvas(around)
        canvas.floor(around)
        if t > 6.5:
            canvas.line(stations(described, q), GHOST_GREY, 6)
            said = np.array([described.fk(at(s))[:3, 3] for s in np.linspace(0, 6, 40)])
            canvas.line(said, ORANGE, 1.8, "--")
            canvas.label(said[-1], "described", ORANGE)
        canvas.line(stations(real, q), LINK_GREY, 6)
        for s in np.arange(1, min(t, 6) + 0.01, 0.5):
            canvas.dot(real.fk(at(s))[:3, 3], INK, 7)
        tip = real.fk(q)[:3, 3]
        canvas.label(tip, "measured", INK)
        apart = np.linalg.norm(described.fk(q)[:3, 3] - tip)
        other = f" The description puts it {1000 * apart:.0f} mm away." if t > 6.5 else ""
        return canvas.picture(f"The tool was last measured at {vector_text(tip)}.{other}")

    return film(
        draw,
        [
            (
                6.4,
                "This arm is being measured: a tracker sees its tool, and writes down each place with the joint values.",
            ),
            (
                2.6,
                "And this is where a description of the arm puts the tool at the same joint values. Which of its joints is wrong?",
            ),
        ],
    )
