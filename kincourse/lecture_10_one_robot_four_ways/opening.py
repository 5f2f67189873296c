"""The opening film: an arm moves as a tracker sees it, and as a description of it says."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import plain_arm
from kinlib.rigid.screw import screw
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GHOST_GREY, INK, LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.pictures import Pictures, film, share

END = np.array([1.3, 0.8, 0.15, -1.2])
AROUND = np.array([(-0.4, -0.4, 0), (0.9, 0.9, 1.2)])


def described_arm() -> Chain:
    """The description of the film: the plain arm with the axis of joint 2 tilted by 14 degrees, and no other fault."""
    real, tilt = plain_arm(), np.radians(14)
    screws, points = real.screws.copy(), real.joint_points
    screws[1] = screw((0, -np.cos(tilt), np.sin(tilt)), points[1])
    return Chain(screws, real.home, points, name="described arm")


def opening() -> Pictures:
    """Play an arm, the places where its tool was measured, and where a description with a fault puts it."""

    def draw(t: float) -> Picture:
        return draw_measured(END * share(t, 1, 6), dots=int(max(0.0, 2 * (min(t, 6) - 1)) + 1), described=t > 6.5)

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


def draw_measured(q: Array, *, dots: int = 11, described: bool = True) -> Picture:
    """Draw the plain arm at q (4,), the first places of its tool on the way to END, and in grey the arm of the description."""
    real, other = plain_arm(), described_arm()
    canvas = Canvas(AROUND)
    canvas.floor(AROUND)
    if described:
        canvas.line(stations(other, q), GHOST_GREY, 6)
        said = np.array([other.fk(END * s)[:3, 3] for s in np.linspace(0, 1, 40)])
        canvas.line(said, ORANGE, 1.8, "--")
        canvas.label(said[-1], "described", ORANGE)
    canvas.line(stations(real, q), LINK_GREY, 6)
    for s in np.linspace(0, 1, 11)[:dots]:
        canvas.dot(real.fk(END * s)[:3, 3], INK, 7)
    tip = real.fk(q)[:3, 3]
    canvas.label(tip, "measured", INK)
    apart = np.linalg.norm(other.fk(q)[:3, 3] - tip)
    off = f" The description puts it {1000 * apart:.0f} mm away." if described else ""
    return canvas.picture(f"The tool was last measured at {vector_text(tip)}.{off}")
