"""The colours of bodies: each in several shades from its dark side to its highlight, on a light and on a dark page."""

from functools import cache

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK

LIGHT = np.array([-0.42, 0.78, 0.52]) / np.linalg.norm([-0.42, 0.78, 0.52])
"""The direction to the light in the axes of the picture: right, up, towards the viewer. js/scene/body.js has the same."""

LEVELS = 9
"""The number of shades of a colour."""


BODY_COLOURS = ("body", "metal", "grip", "dark", "blue", "white", "slate", "cream", "steel", "orange", "black")


@cache
def shade(colour: str, level: int, page: int) -> str:
    """Return a colour in one of LEVELS shades, from the dark side to the highlight, on a light (0) or a dark page (1).

    >>> shade("body", 4, 0), shade("body", 8, 1)
    ('#b9c2d0', '#dee3e8')
    """
    base = np.array([int(LIGHT_AND_DARK[colour][page][k : k + 2], 16) / 255 for k in (1, 3, 5)])
    cool = base * ([0.5, 0.56, 0.66], [0.34, 0.38, 0.46])[page]
    k = level / (LEVELS - 1)
    lit = np.clip((k - 0.15) / 0.6, 0, 1)
    mixed = cool + (base - cool) * lit * lit * (3 - 2 * lit)
    high = np.clip((k - 0.85) / 0.15, 0, 1)
    return "#" + "".join(f"{round(255 * x):02x}" for x in np.clip(mixed + (1 - mixed) * 0.45 * high, 0, 1))


SHADES = {shade(name, level, 0): shade(name, level, 1) for name in BODY_COLOURS for level in range(LEVELS)}
"""The colour on a dark page for each shade on white paper."""


def lit(colour: str, n: Array) -> str:
    """Return the shade of a surface with the normal n, in the axes of the picture."""
    k = (float(n @ LIGHT) / max(float(np.linalg.norm(n)), 1e-9)) / 2 + 0.5
    return shade(colour, round(k * (LEVELS - 1)), 0)
