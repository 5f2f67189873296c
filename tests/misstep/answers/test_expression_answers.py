"""Formulas as answers: compared by their values; no input breaks the reader or keeps it busy."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given
from hypothesis import strategies as st

from misstep.answers.base import Unreadable
from misstep.answers.expression import ClosedForm
from misstep.formulas.evaluation import MAX_PARTS, Reader
from misstep.formulas.parsing import FUNCTIONS

q_1, q_2 = sp.symbols("q_1 q_2", real=True)
a_2 = sp.Symbol("a_2", positive=True)
theta = sp.Symbol("theta")

RIGHT = ClosedForm(a_2 * sp.cos(q_1 + q_2) + sp.sin(q_1) ** 2)


def is_right(form, given):
    return all(form.agrees(form.read(given), form.value))


# --- compared by values ---


def test_a_formula_is_right_in_every_form_and_a_different_one_is_wrong():
    for same in (
        RIGHT.value.rewrite(sp.exp),
        a_2 * sp.Symbol("c_12") + sp.Symbol("s_1") ** 2,
        "sp.sin(q1)**2 + a2*sp.cos(q2 + q1)",
        "a2 c12 + 1 - c1^2",
        "a2 (c1 c2 - s1 s2) + s1²",
        "2a2 cos(θ₁ + θ₂)/2 + sin(theta1)**2",
        r"$a_2 \cos\left(\theta_{1} + \theta_{2}\right) + (1 - \cos(2 \theta_1))/2$",
        "a_2·cos(q1+q2) − (−1 + cos(q1)²)",
        "1.0*a2*c12 + s1*s1",
    ):
        assert is_right(RIGHT, same), same
    for other in ("a2 c12 + s1", "a2 c12 + s1^2 + 1/10^9", "a2 cos(q1 - q2) + s1^2", "0.99 a2 c12 + s1^2", 1, "q1"):
        assert not is_right(RIGHT, other), other


def test_decimals_are_compared_to_three_digits_and_exact_formulas_exactly():
    form = ClosedForm(sp.sqrt(2) / 2 * sp.sin(theta))
    for typed in ("0.7071*sin(1*theta)", np.sqrt(2) / 2 * sp.sin(theta), "sin(theta)/√2"):
        assert is_right(form, typed)
    assert not is_right(form, "7071/10000*sin(theta)")
    assert is_right(ClosedForm(0.7071 * sp.sin(theta)), "sin(theta)/√2")
    assert is_right(ClosedForm(sp.sqrt(2) / 2), np.float32(0.7071))
    assert not is_right(ClosedForm(theta), "1.0*theta + 1/10^6")


@given(
    st.recursive(
        st.sampled_from([q_1, q_2, a_2, sp.pi, sp.Integer(2), sp.Rational(-1, 3)]),
        lambda part: st.one_of(
            st.tuples(part, part).map(lambda two: two[0] + two[1]),
            st.tuples(part, part).map(lambda two: two[0] * two[1]),
            part.map(sp.sin),
            part.map(sp.cos),
            part.map(lambda base: base**2),
        ),
        max_leaves=8,
    )
)
@example(sp.sin(q_1**8))
def test_values_agree_with_sympy_also_when_its_text_is_read_back(expression):
    """The oracle is SymPy's own evaluation. The text that SymPy prints is read back as the same formula."""
    reader = Reader([q_1, q_2, a_2])
    made, typed = reader.read(expression), reader.read(str(expression))
    at = {symbol: sp.Float(reader.points[0][symbol.name.replace("_", "")], 30) for symbol in (q_1, q_2, a_2)}
    oracle = float(expression.subs(at).evalf(25))
    assert made.values[0] == pytest.approx(oracle, rel=1e-10, abs=1e-10)
    np.testing.assert_allclose(typed.values, made.values, rtol=1e-14, atol=1e-14)


def test_a_matrix_or_vector_may_be_given_as_sympy_text_or_rows():
    R = sp.Matrix([[sp.cos(q_1), -sp.sin(q_1), a_2], [sp.sin(q_1), sp.cos(q_1), 0], [0, 0, 1]])
    text = "[[c1, -s1, a2], [s1, c1, 0], [0, 0, 1]]"
    for matrix in (sp.ImmutableMatrix(R), f"Matrix({text})", np.array(R), [str(row) for row in R.tolist()]):
        assert is_right(ClosedForm(R), matrix)
    assert not is_right(ClosedForm(R), text.replace("a2", "2 a2"))
    vector = ClosedForm(sp.Matrix([q_1, 0, a_2]))
    assert all(is_right(vector, v) for v in ("[q1, 0, a2]", [["q1", "0", "a2"]], sp.Matrix([[q_1, 0, a_2]])))
    form = ClosedForm(q_1)
    for bracketed in ([[["q1"]]], [["Matrix([q1])"]], [[np.array("[q1]")]], np.array("[[[q1]]]")):
        assert is_right(form, bracketed)
        with pytest.raises(Unreadable, match="more entries than any matrix"):
            form.read([bracketed])


def test_an_angle_may_be_called_q_or_theta():
    angles = sp.symbols("theta_1 theta_2")
    form = ClosedForm(sp.cos(sum(angles)) + angles[0])
    assert is_right(form, "cos(q1 + q_2) + θ₁")
    assert is_right(form, "c12 + q1")
    assert is_right(ClosedForm(sp.cos(q_1 + q_2) + q_1), "cos(θ₁ + theta_2) + q1")


def test_spellings_of_paper_are_read():
    reader = Reader(sp.symbols("q theta_1"))
    for typed, plain in {
        r"3\pi/2 + q": "3*pi/2 + q",
        "3π/2": "3*pi/2",
        "np.pi/2": "pi/2",
        "-½π": "-pi/2",
        "\theta_1": "theta_1",
        "q + 90º": "q + pi/2",
        "exp(I q)^2 exp(-2 I q)": "1",
    }.items():
        np.testing.assert_allclose(reader.read(typed).values, reader.read(plain).values, rtol=1e-14, err_msg=typed)


# --- refused ---

UNREADABLE = (
    ("9**9**9**9", "grows beyond"),
    ("__import__('os').system('true')", "is not part of a formula"),
    ("[q1, q2][0]", "Only numbers, names"),
    ("eval(q1)", "eval is none of the symbols"),
    ("a3 c12", "a3 is none of the symbols here: a_2, q_1, q_2"),
    ("sin q1", "Write functions with brackets"),
    ("sin(q1", "a bracket is missing"),
    ("1/(q1 - q1)", "divides by zero"),
    (float("nan"), "grows beyond|NaN or infinity"),
    ("sqrt(-1 - q1^2)", "not real"),
    ("[q1, q2]", "Yours is a vector of 2 formulas"),
    ("0,5", "vector of 2 formulas. The decimal sign is a point"),
    ([["q1"], ["q1", "q2"]], "rows differ in length"),
    ([], "It is empty"),
    ("q1+" * 10_000 + "q1", "at most 10000 characters"),
    (sp.Add(*[q_1] * MAX_PARTS, evaluate=False), f"more than {MAX_PARTS} parts"),
    (np.sin, "is not a formula"),
    ("atan2(I, q1)", "no value"),
)


def test_anything_but_a_formula_is_refused_with_a_reason():
    for hostile, words in UNREADABLE:
        with pytest.raises(Unreadable, match=f"(?s)^Expected one formula in a_2, q_1, q_2: .*({words})"):
            RIGHT.read(hostile)


def test_every_function_has_the_values_of_sympy():
    x = sp.Symbol("x", positive=True)
    reader = Reader([x])
    at = {x: sp.Float(reader.points[0]["x"], 30)}
    for name in {*FUNCTIONS} - {"Matrix", "atan2"}:
        value = ({"abs": sp.Abs}.get(name) or getattr(sp, name))(x / 3)
        oracle = complex(value.subs(at).evalf(20)).real
        for form in (f"{name}(x/3)", value):
            assert reader.read(form).values[0] == pytest.approx(oracle, rel=1e-12), name
