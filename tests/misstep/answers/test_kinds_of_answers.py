# ruff: noqa: E501 - tables of what people type
"""Each kind of answer: ten right ways to type an answer, and ten wrong ones, as typed and as stored for the grader.

A wrong one stands with the mistake that feedback must name, "unreadable", or "" for one of which nothing is known.
"""

import json
from fractions import Fraction
from math import pi

import numpy as np
import pytest
import sympy as sp

from misstep import Problem
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Equivalent, Numbers
from misstep.answers.ordering import Ordering
from misstep.judge import judge
from misstep.storage import from_data, to_data

BAD = "unreadable"
MATRIX = [[1, 2], [3, 4]]

KINDS = {
    "number": (
        Numbers(5.25, unit="m"),
        [5.25, "5.25", "5.25 m", "21/4", "2.1*2.5", Fraction(21, 4), sp.Rational(21, 4), np.float32(5.25), np.array(5.25 + 0j), [5.25]],
        [(-5.25, "all signs"), (5.3, ""), (5250, "millimetres"), (10.5, "doubled"), (True, BAD), (5.25j, BAD), ("5,25", BAD),
         ("five", BAD), ([5.25, 1], BAD), (float("nan"), BAD)],
    ),
    "matrix": (
        Numbers(MATRIX),
        [MATRIX, np.array(MATRIX), np.array(MATRIX, float), [[Fraction(1), 2], [3, 4]], [["1", "2"], ["3", "4"]], ((1, 2), (3, 4)),
         sp.Matrix(MATRIX), np.linalg.inv(np.linalg.inv(MATRIX)), [[1.0, 2], [3, "4"]], np.array(MATRIX, dtype=object)],
        [([[1, 3], [2, 4]], "transposed"), ([[3, 4], [1, 2]], "rows in another order"), ([[1, 2], [3, 4.01]], "one entry"), ([1, 2, 3, 4], BAD),
         ([[-1, -2], [-3, -4]], "all signs"), ([[1, 2], [3, True]], BAD), ([[2, 1], [4, 3]], "columns in another order"),
         ([[1, 2], [3]], BAD), ([[1, -2], [3, 4]], "signs"), ([[1, 2], [3, 4j]], BAD)],
    ),
    "eigenvector": (
        Equivalent(np.array([1.0, 2.0]), meaning=lambda v: np.outer(v, v) / max(v @ v, 1e-9)),
        [[1, 2], [2, 4], [-1, -2], (0.5, 1), np.array([-3, -6]), ["1", "2"], [Fraction(1, 3), Fraction(2, 3)], [[1, 2]], [0.4472, 0.8944],
         np.linalg.eigh([[1, 2], [2, 4]])[1][:, 1]],
        [([2, 1], ""), ([1, -2], ""), ([1, 0], ""), ([0, 0], "placeholder"), ([1, 2.1], ""), ([1, 2, 0], BAD), (2, BAD), ([1, 2j], BAD),
         ([True, 2], BAD), ("1, 2", BAD)],
    ),
    "angle in radians": (
        Angles(1.5 * pi),
        [1.5 * pi, -pi / 2, 3.5 * pi, 4.712, -1.5708, "4.7124", sp.pi * Fraction(3, 2), np.array(4.7124), "270°", "3pi/2"],
        [(pi / 2, "sign or half a turn"), (270, "degrees"), (0, "placeholder"), (pi, "complement or doubled"), (True, BAD), ("3pi/2 m", BAD), (1, ""), (-90, "degrees"), (4.6, ""), ({}, BAD)],
    ),
    "choice": (
        Choice("b", {"a": "to the left", "b": "to the right"}),
        ["b", "B", "(b)", "b)", "option b", "to the right", "To the right.", "b: to the right", "Answer B", "[b]"],
        [("a", ""), ("to the left", ""), ("A", ""), ("option a", ""), ("c", BAD), ("right", BAD), (2, BAD), ("ab", BAD), ("", BAD), (["b"], BAD)],
    ),
    "order": (
        Ordering(["Li", "Na", "K"]),
        [["Li", "Na", "K"], ("Li", "Na", "K"), "Li, Na, K", "Li < Na < K", "Li -> Na -> K", "Li; Na; K", ["li", "na", "k"], [" Li", "Na ", "K"],
         np.array(["Li", "Na", "K"]), "[Li, Na, K]"],
        [(["K", "Na", "Li"], "reversed"), ("Li, K, Na", "neighbours swapped"), (["K", "Li", "Na"], "one in the wrong place"), (["Li", "Na"], "left out"),
         (["Li", "Na", "Na"], BAD), ("Li Na K", BAD), (["Li", "Na", "Rb"], BAD), (3, BAD), ([], BAD), ("Na, Li, K", "neighbours swapped")],
    ),
    "formula": (
        ClosedForm(sp.exp(-sp.Symbol("x")) * sp.sin(2 * sp.Symbol("x"))),
        ["exp(-x) sin(2x)", "e^(-x) sin(2x)", "sin(2x)/e^x", "2 sin(x) cos(x) e^-x", "y = exp(-x)*sin(2*x)", "f(x) = exp(-x) sin(2x)", r"e^{-x}\sin(2x)",
         "sin(2·x) e**(−x)", "sin(x+x) / exp(x)", sp.sin(2 * sp.Symbol("x")) / sp.exp(sp.Symbol("x"))],
        [("-exp(-x) sin(2x)", "all signs"), ("exp(x) sin(2x)", ""), ("exp(-x) cos(2x)", ""), ("e - x sin(2x)", ""), ("exp(-t) sin(2t)", BAD), ("sin 2x", BAD),
         ("", BAD), ("0", "left at 0"), (3, ""), ("x == 2", BAD)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_ten_right_and_ten_wrong_ways_to_type_an_answer(kind):
    answer, right, wrong = KINDS[kind]
    problem = Problem("", answer)
    assert len(right) == len(wrong) == 10
    for value, name in [*((one, "right") for one in right), *wrong]:
        stored = from_data(json.loads(json.dumps(to_data(value, answer.inputs), allow_nan=False)))
        for typed in (value, stored):
            judgement = judge(problem, typed)
            found = "" if judgement.state in {"wrong", "partly"} else judgement.state
            assert (judgement.mistakes[0] if judgement.mistakes else found) == name, (typed, judgement)


def test_a_text_that_would_take_long_or_overflow_is_unreadable():
    for text in ("9**9**9**9", "9^9^9^9", "1e999", "(" * 999):
        for kind in ("number", "angle in radians", "formula"):
            assert judge(Problem("", KINDS[kind][0]), text).state == "unreadable", (kind, text)
