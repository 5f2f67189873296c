"""Spellings of formulas as people type them."""

import numpy as np
import pytest
import sympy as sp

from misstep.formulas.evaluation import Reader


def test_spellings_of_paper_are_read():
    reader = Reader(sp.symbols("q theta_1"))
    for typed, plain in {
        r"3\pi/2 + q": "3*pi/2 + q",
        "3π/2": "3*pi/2",
        "np.pi/2": "pi/2",
        "-½π": "-pi/2",
        "\theta_1": "theta_1",
        "q + 90º": "q + pi/2",
    }.items():
        np.testing.assert_allclose(reader.read(typed).values, reader.read(plain).values, rtol=1e-14, err_msg=typed)


def test_a_decimal_comma_is_explained():
    with pytest.raises(
        ValueError, match=r"a vector of 2 formulas\. A comma separates entries; the decimal sign is a point"
    ):
        Reader([]).read("0,5", shape=())
    with pytest.raises(ValueError, match=r"a vector of 2 formulas\.$"):
        Reader([]).read("[1, 2]", shape=())
