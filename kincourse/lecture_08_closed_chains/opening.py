"""The opening film: a four-bar linkage whose crank comes to the end of its range."""

import numpy as np

from kincourse.sampling.linkages import FourBar
from kinlib.mechanisms.linkages import four_bar
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.viewer.pictures import Pictures, film, share

LENGTHS = FourBar(0.5, 0.3, 0.3, 0.3)


def opening() -> Pictures:
    """Play a four-bar linkage whose crank rotates to the end of its range, where coupler and rocker are in one line."""
    linkage = four_bar(*LENGTHS)
    last = float(np.arccos(LENGTHS.cos_crank_angle(LENGTHS.coupler + LENGTHS.rocker))) - 1e-12
    around = np.array([(-0.1, -0.05, 0), (0.55, 0.35, 0)])

    def draw(t: float) -> Picture:
        angle = 0.35 * last + share(t, 1, 4.5) * 0.65 * last
        return draw_linkage(linkage, LENGTHS.closed_at(angle), around=around)

    return film(
        draw,
        [
            (1.0, "Four bars in a ring. The motor at A rotates the crank."),
            (4.0, "The crank moves, and the ring forces all other bars to follow."),
            (1.5, "Here the crank can go no further: two bars are in one line. What can happen next?"),
        ],
    )
