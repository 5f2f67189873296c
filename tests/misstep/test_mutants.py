"""Solutions as expressions, and their mutants: what a change leads to, compared with the same change made by hand in NumPy."""

import numpy as np
import pytest
import sympy as sp

from misstep.answers.angle import Angles
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.mistakes import Mistake
from misstep.mutants.expression import given
from misstep.mutants.operations import ANGLE, LENGTH, SLIDE, cos, inverse, radians, sin, stack
from misstep.problem import Problem, problem

rng = np.random.default_rng(5)
A, B, C = rng.uniform(1, 2, (3, 3, 3))
a, b, c = given("A", A), given("B", B), given("C", C)
SOLUTION = inverse(a) @ b @ c

BY_HAND = {
    "reversed": C @ B @ np.linalg.inv(A),
    "order": np.linalg.inv(A) @ C @ B,
    "inverse left out": A @ B @ C,
    "transpose for inverse": A.T @ B @ C,
    "factor left out": np.linalg.inv(A) @ C,
    "entry by entry": np.linalg.inv(A) * B * C,
    "last factor": B @ C @ np.linalg.inv(A),
}


def matrices(solution=SOLUTION, **options):
    return Problem("Multiply.", Numbers(solution.value), solution=solution, **options)


def test_one_change_is_named_with_its_factor():
    for name, value in BY_HAND.items():
        [finding] = judge(matrices(), value).findings
        assert finding.mistake == name
        assert finding.message.startswith("This is what you get if you ")


def test_both_places_are_named_at_which_one_change_leads_to_the_answer():
    [finding] = judge(Problem("", Numbers(given("A", 2.0) + given("B", 2.0))), 2.0).findings
    assert finding.message == "This is what you get if you leave out $A$, or if you leave out $B$."


def test_a_mistake_of_the_author_comes_before_the_mutants():
    own = Mistake("my own name", BY_HAND["reversed"], "My own words.")
    assert judge(matrices(mistakes=[own]), BY_HAND["reversed"]).mistakes == ["my own name"]


def test_advice_replaces_the_general_one_by_name_or_by_text():
    named = matrices(advice={"inverse left out": "Use the letters."})
    assert judge(named, BY_HAND["inverse left out"]).findings[0].message.endswith("belongs. Use the letters.")
    by_text = matrices(advice={"leave out $B$": "B is needed."})
    message = judge(by_text, BY_HAND["factor left out"]).findings[0].message
    assert message == "This is what you get if you leave out $B$. B is needed."
    assert judge(by_text, B @ C).findings[0].message == "This is what you get if you leave out $A^{-1}$."


def test_a_change_in_all_places_is_one_and_in_one_place_another():
    p, q = (radians(given(name, value, ANGLE)) for name, value in (("p", 40.0), ("q", 70.0)))
    solution = stack(sin(p), cos(q))
    both = Problem("", Numbers(solution.value), solution=solution)
    assert "if you use degrees as radians." in judge(both, [np.sin(40.0), np.cos(70.0)]).findings[0].message
    alone = judge(both, [np.sin(np.radians(40)), np.cos(70.0)]).findings[0].message
    assert "if you use the degrees of $q$ as radians." in alone
    swapped = [np.cos(np.radians(40)), np.sin(np.radians(70))]
    assert judge(both, swapped).mistakes == ["sine and cosine swapped"]
    sizes = stack(radians(given("q_1", 40.0, ANGLE)), given("q_2", 0.6, SLIDE))
    asked = Problem("", Numbers(sizes.value), solution=sizes)
    assert judge(asked, [np.radians(40), np.radians(0.6)]).mistakes == ["length in radians"]
    p = given("p", 3.0, LENGTH)
    asked = Problem("", Numbers(np.array([3.0, 9.0])), solution=stack(p, 3 * p))
    assert judge(asked, [-3.0, -9.0]).mistakes == ["sign of a length"]


def test_the_mutants_of_a_formula_are_compared_as_functions():
    q = sp.Symbol("q")
    asked = Problem("", ClosedForm(3 * sp.sin(q)), solution=lambda q: 3 * sin(given("q", q, ANGLE)))
    assert judge(asked, "3*cos(q)").mistakes == ["sine and cosine swapped"]
    assert judge(asked, "-3 sin(q)").mistakes == ["sign of an angle"]
    assert judge(asked, "3 sin(2q)").mistakes == ["doubled"]


@pytest.mark.parametrize(
    "make",
    [
        lambda x: Problem(f"{x}", Numbers(np.array(x)), [Mistake("sign", np.array(-x), "Sign.")]),
        lambda x: Problem(f"{x}", Numbers(given("p", x, LENGTH) * 3)),
    ],
    ids=["of the author", "mutant"],
)
def test_a_draw_in_which_a_mistake_gives_the_right_answer_is_drawn_again_or_refused(make):
    kind = problem("99.2", "A number", points=1, lecture="none#none")
    zero_or_not, zero = kind(lambda draw: make(2.0 * draw.integer(0, 1))), kind(lambda _: make(0.0))
    assert {zero_or_not.variant(f"s{i}").statement for i in range(20)} == {"2.0"}
    with pytest.raises(ValueError, match=r"Problem 99\.2.*last draw, .*the right answer.*wider range"):
        zero.variant("ada")


def test_a_solution_that_does_not_lead_to_the_answer_is_refused():
    asked = Problem("", Numbers(np.array(5.0)), solution=given("a", 2.0) + 2)
    with pytest.raises(ValueError, match=r"must lead to the answer; it gives 4\.0, and the answer is 5\.0"):
        _ = asked.known_mistakes


def test_a_change_that_would_have_changed_a_right_part_is_not_told():
    a, b = given("a", 0.7, ANGLE), given("b", 0.4, ANGLE)
    asked = Problem("", Angles(stack(a, a + b).value), solution=stack(a, a + b))
    assert judge(asked, [0.7, -0.3]).mistakes == ["sign"]
    assert judge(asked, [-0.7, -0.3]).mistakes == ["sign of an angle"]


def test_a_slip_without_its_brackets_is_refused():
    for slips in (("name", "do it", 2.0), (("name", 2.0),), (("name", 2.0, "do it"),)):
        with pytest.raises(ValueError, match=r"must be \(name, text, value\) in brackets of its own; got .*name"):
            given("x", 1.0).mistaken_for(*slips)
