"""Typed text and text of SymPy: parsed in the same way, except for implicit products."""

import numpy as np
import pytest
import sympy as sp

from misstep.formulas.evaluation import Reader
from misstep.formulas.parsing import parse
from misstep.formulas.sympy_parsing import expression


@pytest.mark.parametrize(
    "text", ["a*sin(theta_{1})**2/3 - sign(a)", r"\theta_1*2.5e-1 + Abs(a)", "sqrt(2)*atan2(a, theta_1)"]
)
def test_text_of_sympy_and_typed_text_have_the_same_values(text):
    reader = Reader(sp.symbols("a theta_1"))
    np.testing.assert_allclose(reader.read(expression(text)).values, reader.read(text).values, rtol=1e-14)


@pytest.mark.parametrize("text", ["2 a", "a b", "a(b)", "factorial(9)", "2(a)"])
def test_only_typed_text_may_have_implicit_products(text):
    assert parse(text)
    with pytest.raises(ValueError, match=r"formula|not finished"):
        expression(text)
