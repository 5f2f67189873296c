"""The opening film: a four-bar linkage whose crank comes to the end of its range."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.linkages import four_bar
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.viewer.film import Film, film, share

GROUND, CRANK, COUPLER, ROCKER = 0.5, 0.3, 0.3, 0.3


def opening() -> Film:
    """Play a four-bar linkage whose crank rotates to the end of its range, where coupler and rocker are in one line.

    >>> opening().alt[:39]
    'Four bars in a ring. The motor at A rot'
    """
    linkage = four_bar(GROUND, CRANK, COUPLER, ROCKER)
    cosine = (GROUND**2 + CRANK**2 - (COUPLER + ROCKER) ** 2) / (2 * GROUND * CRANK)
    last = float(np.arccos(cosine))
    around = np.array([(-0.1, -0.05, 0), (0.55, 0.35, 0)])

    def draw(t: float) -> Picture:
        angle = 0.35 * last + share(t, 1, 4.5) * 0.65 * last
        return draw_linkage(linkage, _configuration(angle), around=around)

    return film(
        draw,
        [
            (1.0, "Four bars in a ring. The motor at A rotates the crank."),
            (4.0, "The crank moves, and the ring forces all other bars to follow."),
            (1.5, "Here the crank can go no further: two bars are in one line. What can happen next?"),
        ],
    )


def _configuration(crank: float) -> Array:
    """The joint values A, B, D, C of the linkage at an angle of the crank, with joint C above the line from B to D."""
    b, d = CRANK * np.array([np.cos(crank), np.sin(crank)]), np.array([GROUND, 0.0])
    across = d - b
    distance = float(np.linalg.norm(across))
    along = (distance**2 + COUPLER**2 - ROCKER**2) / (2 * distance)
    height = np.sqrt(max(0.0, COUPLER**2 - along**2))
    unit = across / distance
    c = b + along * unit + height * np.array([-unit[1], unit[0]])
    coupler, rocker = np.arctan2(*(c - b)[::-1]), np.arctan2(*(c - d)[::-1])
    return np.array([crank, coupler - crank, rocker, coupler - rocker])
