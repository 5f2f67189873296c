"""The cross product as a matrix and the matrix of a twist: what is drawn is what the matrices are."""

import re

import numpy as np

from kincourse.lecture_02_matrix_exponential.drawings import draw_cross_product, draw_twist_matrix
from kinlib.rigid.lie import hat

TWISTS = [(1, 2, 3, 4, 5, 6), (0, -1, 0, 0, 0, 4), (0.5, -0.25, 2, 0, 7, -3)]


def matrix_in(alt):
    """The matrix that the text alternative gives, entry by entry."""
    M = np.zeros((4, 4))
    for i, row in enumerate(re.findall(r"Row \d(?:: (.*?), zero elsewhere| is zero)\.", alt)):
        for value, column in re.findall(r"= (-?[\d.]+) in column (\d)", row):
            M[i, int(column) - 1] = float(value)
    return M


def test_the_text_alternative_and_the_drawing_give_the_matrix():
    for S in TWISTS:
        picture, expected = draw_twist_matrix(S), hat(np.array(S, dtype=float))
        np.testing.assert_array_equal(matrix_in(picture.alt), expected)
        drawn = [float(text.replace("−", "-")) for text in re.findall(r">([−\d.]+)</text>", picture.svg)[-16:]]
        np.testing.assert_array_equal(np.reshape(drawn, (4, 4)), expected)


def test_the_rows_of_the_cross_product_are_its_components():
    omega, p = np.array([2.0, 3.0, 5.0]), np.array([7.0, 11.0, 13.0])
    names = {f"omega_{x}": value for x, value in zip("xyz", omega, strict=True)}
    names |= {f"p_{x}": value for x, value in zip("xyz", p, strict=True)}
    alt = draw_cross_product().alt
    for i, component in enumerate(re.findall(r"[xyz]: (omega_. p_. - omega_. p_.)\.", alt)):
        assert eval(component.replace(" p", " * p"), {}, names) == np.cross(omega, p)[i]
    rows = re.findall(r"Row \d of \[omega\]: (.*?)\.", alt)
    np.testing.assert_array_equal([eval(f"[{row}]", {}, names) for row in rows], hat(omega))
