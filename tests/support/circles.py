"""Where two circles meet, with 30 digits."""

import mpmath
import numpy as np


def meeting_points(one, r, other, s):
    """Where a circle of radius r about one point meets one of radius s about another, with 30 digits; [] if nowhere."""
    with mpmath.workdps(30):
        way = mpmath.mpc(*other) - mpmath.mpc(*one)
        d = abs(way)
        along = (d * d + r * r - s * s) / (2 * d)
        square = r * r - along * along
        if square < 0:
            return []
        points = [mpmath.mpc(*one) + way / d * mpmath.mpc(along, sign * mpmath.sqrt(square)) for sign in (1, -1)]
        return [np.array([float(p.real), float(p.imag)]) for p in points]
