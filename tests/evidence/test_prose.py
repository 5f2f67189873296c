"""Each formula of a lecture has its assertion nearby; and the rules of evidence/checks/prose_numbers.py detect missing ones."""

from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_output
from prose_numbers import (
    checked,
    formulas_without_check,
    formulas_without_number,
    named,
    numbers_given,
    numbers_in,
    numbers_printed,
    numbers_without_source,
)

LECTURES = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))
each_lecture = pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)


# --- the formulas of the lectures; test_notebooks.py checks the numbers, because it runs the notebooks ---


@each_lecture
def test_every_formula_has_a_number(path):
    bare = list(formulas_without_number(nbformat.read(path, as_version=4).cells))
    assert not bare, "number them, as \\tag{7} or (7), and assert them in a cell nearby:\n" + "\n".join(bare)


@each_lecture
def test_every_number_of_a_formula_has_its_assertion(path):
    unproved = list(formulas_without_check(nbformat.read(path, as_version=4).cells))
    assert not unproved, "\n".join(unproved)


# --- the rules ---


@pytest.mark.parametrize(
    "markdown",
    [
        "$$R = I$$",
        r"so $T_{ab} T_{bc} = T_{ac}$ holds",
        r"and $\mathrm{Ad}_M S \neq S$ in general",
        "(1) first.\n\nThen:\n\n$$a = b$$",
        "$$a = b \\tag{1}$$\n\n$$c = d$$",
        "- (1) $ab = c$\n- $ef = g$",
    ],
)
def test_a_claim_without_a_number_is_reported(markdown):
    assert list(formulas_without_number([new_markdown_cell(markdown)]))


@pytest.mark.parametrize(
    "markdown",
    [
        r"$$R = I \tag{1}$$",
        r"$$\text{(1)} \quad R = I$$",
        "(1) So it is:\n\n$$R = I$$",
        r"it turns by $R R^T = I$. $\quad(1)$",
        r"where $S = (\omega, v)$ and $\hat z = c_1 x$",
        r"at $q_1 = 0$, for $|\omega| = 1$ and $a b = \pi/2$",
        "> $$M = 0$$",
        "$$Z_1 X_1 Z_2$$",
        "`$ab = c$`",
    ],
)
def test_definitions_cases_quotations_and_numbered_claims_are_accepted(markdown):
    assert not list(formulas_without_number([new_markdown_cell(markdown)]))


def test_numbers_of_formulas_are_distinguished_from_other_brackets():
    assert named(
        r"By (1), $\quad(2)$ and $$a = b \tag{c}$$ as in (3.88), $f(4)$, $A_1(5)$, $R^{(6)}$ and 1904 (1954)."
    ) == {*("1", "2", "c")}


def test_only_an_assertion_counts_as_a_check():
    assert list(checked("assert a == b  # (1), (3) to (5)\nc = d  # (2)\nprint('# (6)')")) == ["1", "3", "4", "5"]
    assert list(checked("assert np.allclose(\n    a,  # (a) to (c)\n    b,\n)")) == ["a", "b", "c"]


def test_a_formula_and_its_assertion_must_be_near_each_other():
    formula, check, other = (
        new_markdown_cell("$$ab = c \\tag{1}$$"),
        new_code_cell("assert True  # (1)"),
        new_code_cell("1"),
    )
    assert not list(formulas_without_check([formula, other, check]))
    assert not list(formulas_without_check([check, other, formula]))
    assert list(formulas_without_check([formula, other]))
    assert list(formulas_without_check([check, other]))
    assert not list(formulas_without_check([formula, *3 * [other], check]))
    assert list(formulas_without_check([formula, *4 * [other], check]))


@pytest.mark.parametrize(
    ("code", "is_counted"), [("turning", 0), ("explain('03/order')", 0), ("a = 1", 1), ("a\nb", 1)]
)
def test_a_cell_that_only_shows_one_thing_does_not_separate_a_formula_from_its_assertion(code, is_counted):
    formula, check = new_markdown_cell("$$ab = c \\tag{1}$$"), new_code_cell("assert True  # (1)")
    assert len([*formulas_without_check([formula, *9 * [new_code_cell(code)], check])]) == is_counted


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        ("off by 0.41 m", 0.4055, 0.4155),
        ("off by 0.4055 m", 0.4055, 0.405),
        ("$-0.50$", 0.501, 0.51),
        ("below 1e-9", 1e-9, 1e-8),
        (r"near $10^{-8}$", 9e-9, 9e-8),
        (r"it is $4.5 \cdot 10^{-3}$", 0.00447, 0.0044),
        ("some 300 km away", 314000.0, 414000.0),
        ("at $-3000$ m", 3140.0, 3640.0),
        (r"$2\text{ m}$", 2.0, 3.0),
        ("10 cm to the side", 0.1, 0.2),
        ("90 radians", 90.0, 9.0),
    ],
)
def test_a_number_needs_a_source_that_rounds_to_it(text, right, wrong):
    assert not numbers_without_source(text, [right])
    assert numbers_without_source(text, [wrong])


@pytest.mark.parametrize(
    "text",
    [
        "6 joints, 90 degrees, $-90°$, in 1954",
        "Modern Robotics (3.88)",
        "example 2.3, section 3.4.1",
        "`0.5`",
        "```python\n0.5\n```",
        "> 0.5 as printed",
        "[here](page_0.5.md)",
        r"$\frac12$ and $x_{10}$",
    ],
)
def test_chosen_and_quoted_numbers_need_no_source(text):
    assert not list(numbers_in(text))


def test_pictures_and_questions_are_not_sources():
    picture = new_output(
        "display_data", {"text/html": '<svg viewBox="0 0 0.37 1"/>', "text/plain": "An arm, 0.2 m long."}
    )
    question = new_output("display_data", {"application/vnd.jupyter.widget-view+json": {}, "text/plain": "Is it 0.37?"})
    cell = new_code_cell("1.5", outputs=[picture, question, new_output("stream", text="0.1\n")])
    assert set(numbers_printed([cell])) == {0.2, 0.1}


def test_literals_in_code_are_sources():
    cell = new_code_cell('length = -0.25  # 0.75\ntable = "1 | 0.147"\nflag = True')
    assert set(numbers_given([cell, new_markdown_cell("0.9")])) == {0.25, 1, 0.147}
