"""Spellings of formulas as people type them."""

import numpy as np
import pytest
import sympy as sp

from misstep.formulas.evaluation import Reader


def test_spellings_of_paper_are_read():
    reader = Reader(sp.symbols("q theta_1"))
    for typed, plain in {
        r"3\pi/2 + q": "3*pi/2 + q",
        r"5\frac{\pi}{2}": "5*pi/2",
        r"\frac{3\pi}{2}": "3*pi/2",
        "3π/2": "3*pi/2",
        "np.pi/2": "pi/2",
        "-½π": "-pi/2",
        "1½ q": "3*q/2",
        r"2\tfrac{1}{2}": "5/2",
        r"\frac12 q": "q/2",
        r"\frac\pi2": "pi/2",
        "\frac{q}{2}": "q/2",  # what Python makes of the text without an r in front of it
        "\theta_1": "theta_1",
        "q + 90º": "q + pi/2",
        r"90^{\circ}": "pi/2",
        r"45^\circ q": "pi/4*q",
        r"\frac{\theta_{1}}{\sqrt{2}}": "theta_1/sqrt(2)",
        r"\frac{\frac{q}{2}}{3}": "q/6",
    }.items():
        np.testing.assert_allclose(reader.read(typed).values, reader.read(plain).values, rtol=1e-14, err_msg=typed)


def test_a_decimal_comma_is_explained():
    with pytest.raises(
        ValueError, match=r"a vector of 2 formulas\. A comma separates entries; the decimal sign is a point"
    ):
        Reader([]).read("0,5", shape=())
    with pytest.raises(ValueError, match=r"a vector of 2 formulas\.$"):
        Reader([]).read("[1, 2]", shape=())
