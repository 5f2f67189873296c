"""Intersections of two circles, with 30 digits."""

import mpmath
import numpy as np


def intersections(one, r, other, s):
    """The intersections of a circle of radius r about one point with one of radius s about another, with 30 digits; [] if none."""
    with mpmath.workdps(30):
        offset = mpmath.mpc(*other) - mpmath.mpc(*one)
        d = abs(offset)
        along = (d * d + r * r - s * s) / (2 * d)
        square = r * r - along * along
        if square < 0:
            return []
        points = [mpmath.mpc(*one) + offset / d * mpmath.mpc(along, sign * mpmath.sqrt(square)) for sign in (1, -1)]
        return [np.array([float(p.real), float(p.imag)]) for p in points]
