"""The four angles of a four-bar, each drawn as an arc between the two arrows that it is measured between."""

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import wrap_angle
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.linkage import linkage_geometry


def draw_angles(linkage: Mechanism, q: ArrayLike) -> Picture:
    """Draw a four-bar with its angles A, B, D, C: dashed, the direction from which each is measured.

    >>> linkage = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    >>> print(draw_angles(linkage, linkage.assembly_modes(hold={"A": 1.0})[0]).alt[:79])
    Four-bar. A = 57.3°, from the x axis to the crank AB; B = -121°, from AB to BC;
    """
    A, B, D, C = wrap_angle(np.asarray(q, dtype=float))
    pins = dict(zip("ABDC", linkage_geometry(linkage, np.array([A, B, D, C])).first, strict=True))
    bars = {"AB": A, "BC": A + B, "DC": D}  # the direction of each arrow, from the x axis
    size = float(np.ptp(list(pins.values()), axis=0).max())
    reach = 0.2 * size * np.array([[1, 1, 0], [-1, -1, 0]])
    canvas = Canvas(np.concatenate([[p, *(p + reach)] for p in pins.values()]), "top", (560, 420))
    canvas.line([pins["A"], pins["D"]], GREY, 1.4, "--")
    for one, other in map(tuple, bars):
        canvas.arrow(pins[one], pins[other], LINK_GREY, 3.0, level=2)
    measured = {"A": (0.0, A), "B": (bars["AB"], B), "D": (0.0, D), "C": (bars["DC"], C)}
    for (name, (start, angle)), colour in zip(measured.items(), (VIOLET, ORANGE, VIOLET, ORANGE), strict=True):
        p, radius = pins[name], 0.14 * size
        canvas.line([p, p + 1.5 * radius * _unit(start)], colour, 1.3, "--", level=3)
        arc = [p + radius * _unit(start + share * angle) for share in np.linspace(0, 1, 40)]
        for one, other in pairwise(arc[:-1]):
            canvas.line([one, other], colour, 1.8, level=3)
        canvas.arrow(arc[-4], arc[-1], colour, 1.8, level=3)
        canvas.label(p + 1.35 * radius * _unit(start + angle / 2), f"${name}$", colour, size=14)
        canvas.dot(p, INK, 7)
    values = "; ".join(
        f"{name} = {np.degrees(value):.3g}°, from {way}"
        for name, value, way in (
            ("A", A, "the x axis to the crank AB"), ("B", B, "AB to BC"), ("D", D, "the x axis to DC"), ("C", C, "DC to BC")
        )
    )  # fmt: skip
    caption = f"The linkage of {linkage.source}, with the angles of this course."
    return canvas.picture(f"Four-bar. {values}.", caption, cropped=True)


def _unit(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle), 0.0])
