"""One reader of formulas for what people type and for what SymPy writes, and what only one of them may leave out."""

import numpy as np
import pytest
import sympy as sp

from misstep.formulas.evaluation import Reader
from misstep.formulas.parsing import parse
from misstep.formulas.sympy_parsing import expression


@pytest.mark.parametrize(
    "text", ["a*sin(theta_{1})**2/3 - sign(a)", r"\theta_1*2.5e-1 + Abs(a)", "sqrt(2)*atan2(a, theta_1)"]
)
def test_what_sympy_writes_and_what_people_type_goes_one_way(text):
    reader = Reader(sp.symbols("a theta_1"))
    np.testing.assert_allclose(reader.read(expression(text)).values, reader.read(text).values, rtol=1e-14)


@pytest.mark.parametrize("text", ["2 a", "a b", "a(b)", "factorial(9)", "2(a)"])
def test_what_stands_side_by_side_is_a_product_on_paper_only(text):
    assert parse(text)
    with pytest.raises(ValueError, match=r"formula|not finished"):
        expression(text)
