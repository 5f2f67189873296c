"""Fuzz the reader of formulas: corrupted ones are refused with a sentence, valid ones have the values that NumPy computes."""

import numpy as np
import sympy as sp
from assertions import assert_explained
from corruption import corrupted_texts, noise, often, pieces, random_sources
from fuzz_settings import fuzz_settings
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.base import Unreadable
from misstep.answers.expression import ClosedForm
from misstep.formulas.evaluation import MAX_VALUE

q_1, q_2, a = sp.symbols("q_1 q_2 a")
ASKED = {
    "one": ClosedForm(a * sp.cos(q_1 + q_2)),
    "vector": ClosedForm(sp.Matrix([a * sp.cos(q_1), a * sp.sin(q_2)])),
}

TYPED = pieces(r"""
a cos(q_1 + q_2)  2 sin(q1)cos(q1)  a c_{12} - \frac{1}{2} s_1^2  √(a²+1)·cos θ₁  [a c1, a*s2]  2a(q1+1)
Matrix([[c1, -s1], [s1, c1]])  -(-q1)**2/3  atan2(q_1, q_2) + ln(abs(a)) - exp(-q1)  $\sin(\theta_1)\cdot a$
sp.cos(q1)*np.sin(q2)  90° + pi/2  [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]  1e-3 q1  sinc(q1)/cot(a)
""")

WORDS = r"""
q_1  q2  θ_1  a  c12  s1  sin(  cos  sqrt(  √  atan2(  sinc  abs  exp(  log(0)  Matrix(  **  ^  **64  ^-1  /0  *
·  \frac{  }{  _{1}  \left(  °  E  I  pi  ln  acos(2)  1/  lambda  if  for  and  not  True  None  [  ]  ,  =  ==
@  //  **9**9**9  1e308  1e-60
"""

LEAVES = {
    **dict.fromkeys(["q_1", "q1", "θ_1", r"\theta_{1}"], lambda x: x[0]),
    **dict.fromkeys(["q_2", "θ₂", "theta2"], lambda x: x[1]),
    **dict.fromkeys(["c12", "c_{12}", "cos(q1+q2)"], lambda x: np.cos(x[0] + x[1])),
    "a": lambda x: x[2],
    r"\frac{a}{2}": lambda x: x[2] / 2,
    "2a²": lambda x: 2 * x[2] ** 2,
    **{number: lambda _, number=number: float(number) for number in ("2", "0.5", "1.5e-1", ".25", "3.")},
}
ONE = {
    "sin({})": np.sin,
    "cos ({})": np.cos,
    "atan({})": np.arctan,
    "-({})": np.negative,
    "({})/2": lambda x: x / 2,
    **dict.fromkeys(["({})**2", "({})^2", "({})²", "({}) ** 2"], np.square),
}
TWO = {
    "({}+{})": np.add,
    "({} - ({}))": np.subtract,
    "({} − ({}))": np.subtract,
    **dict.fromkeys(["({})*({})", "({}) · ({})", "({}) ({})", "({})({})", r"({}) \cdot ({})"], np.multiply),
}
"""How people write an operation, and the NumPy function for it."""


def spelt(chance, depth=4):
    """A formula as text, and a function of x = (q_1, q_2, a) that gives all intermediate values, and its value last."""
    if depth == 0 or chance.random() < 0.2:
        text, leaf = chance.choice(list(LEAVES.items()))
        return text, lambda x: [leaf(x)]
    one, f = spelt(chance, depth - 1)
    if chance.random() < 0.4:
        text, function = chance.choice(list(ONE.items()))
        return text.format(one), lambda x: [*(way := f(x)), function(way[-1])]
    text, function = chance.choice(list(TWO.items()))
    other, g = spelt(chance, depth - 1)
    return text.format(one, other), lambda x: [*(way := f(x)), *(side := g(x)), function(way[-1], side[-1])]


def cases():
    """The name of the answer, the text, and its values if they are known."""
    asked = st.sampled_from(list(ASKED))
    odd = st.tuples(asked, often(20, corrupted_texts(st.sampled_from(TYPED), WORDS), noise()), st.none())
    known = random_sources().map(lambda chance: ("one", *spelt(chance)))
    return odd | known


@fuzz_settings(100)
@given(st.deferred(cases))
def test_a_formula_is_refused_with_a_sentence_or_has_the_values_that_numpy_computes(case):
    which, text, meaning = case
    answer = ASKED[which]
    points = answer._reader._points
    way = meaning(np.array([points[name] for name in ("q1", "q2", "a")], dtype=float)) if meaning else []
    try:
        formula = answer.read(text)
    except Unreadable as error:
        assert_explained(error, Unreadable)
        if meaning and max(np.abs(value).max() for value in way) <= MAX_VALUE:
            raise AssertionError(f"{text!r} is a formula") from error
        return
    assert np.isfinite(formula.values).all()
    right = answer.agrees(formula, answer.value)
    assert answer.agrees(answer.read(formula.given), formula) == [True] * len(right)
    assert all(right) or answer.resemblance(formula, right.index(False)) != ()
    if meaning:
        expected = np.broadcast_to(way[-1], formula.values.shape)
        np.testing.assert_allclose(formula.values, expected, rtol=1e-9, atol=1e-9)
