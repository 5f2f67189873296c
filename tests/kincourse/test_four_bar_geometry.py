"""Four-bars in closed form, against SymPy, mpmath and printed values."""

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath_oracle import intersections

from kincourse.sampling.four_bar_geometry import FourBar
from kinlib.rigid.angles import wrap_angle

lengths = st.floats(0.1, 2)
angles = st.floats(-np.pi, np.pi)


def test_what_has_no_solution_is_refused():
    with pytest.raises(ValueError, match="B and D are 5 m apart: circles with radii 1 and 1 m do not meet"):
        FourBar(4, 1, 1, 1).pin_positions(np.pi)
    with pytest.raises(ValueError, match="B must not coincide with D"):
        FourBar(1, 1, 2, 2).pin_positions(0.0)


# --- against libraries and printed values ---


@given(st.tuples(lengths, lengths, lengths, lengths), angles)
def test_the_pins_are_at_the_intersections_of_circles_with_30_digits(four, A):
    ground, crank, coupler, rocker = four
    B, D = crank * np.array([np.cos(A), np.sin(A)]), np.array([ground, 0.0])
    assume(np.linalg.norm(B - D) > 1e-2)
    left_and_right = intersections(B, coupler, D, rocker)
    assume(left_and_right)
    C = np.array(left_and_right)
    assume(np.linalg.norm(C[0] - C[1]) > 1e-2)
    four_bar = FourBar(*four)
    for got, expected in zip(four_bar.pin_positions(A), (B, D, C), strict=True):
        np.testing.assert_allclose(got, expected, rtol=0, atol=1e-11)
    directions = [[mpmath.arg(mpmath.mpc(*(c - foot))) for foot in (B, D)] for c in C]
    q = [[A, b - A, d, b - d] for b, d in directions]
    turned = np.array([[float(mpmath.arg(mpmath.expj(angle))) for angle in row] for row in q])
    np.testing.assert_allclose(np.exp(1j * four_bar.assembly_modes(A)), np.exp(1j * turned), rtol=0, atol=1e-9)
    inside = np.abs(np.abs(turned) - np.pi) > 1e-6
    np.testing.assert_allclose(wrap_angle(np.array(q, dtype=float))[inside], turned[inside], rtol=0, atol=1e-11)
