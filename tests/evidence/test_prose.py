"""Each formula of a lecture has its assertion nearby; and the rules of evidence/checks/prose_numbers.py detect missing ones."""

import re
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
from reading_time import minutes, stated

from kincourse import COURSE

LECTURES = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))


# --- the formulas of the lectures; test_notebooks.py checks the numbers, because it runs the notebooks ---


@pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)
def test_every_formula_has_a_number_and_its_assertion(path):
    cells = nbformat.read(path, as_version=4).cells
    bare = list(formulas_without_number(cells))
    assert not bare, "number them, as \\tag{7} or (7), and assert them in a cell nearby:\n" + "\n".join(bare)
    assert list(formulas_without_check(cells)) == []


# --- the rules ---


def test_a_claim_without_a_number_is_reported_and_definitions_cases_and_quotations_are_not():
    for markdown in (
        "$$R = I$$",
        r"so $T_{ab} T_{bc} = T_{ac}$ holds",
        r"and $\mathrm{Ad}_M S \neq S$ in general",
        "(1) first.\n\nThen:\n\n$$a = b$$",
        "$$a = b \\tag{1}$$\n\n$$c = d$$",
        "- (1) $ab = c$\n- $ef = g$",
    ):
        assert list(formulas_without_number([new_markdown_cell(markdown)])), markdown
    for markdown in (
        r"$$R = I \tag{1}$$",
        r"$$\text{(1)} \quad R = I$$",
        "(1) So it is:\n\n$$R = I$$",
        r"it turns by $R R^T = I$. $\quad(1)$",
        r"where $S = (\omega, v)$ and $\hat z = c_1 x$",
        r"at $q_1 = 0$, for $|\omega| = 1$ and $a b = \pi/2$",
        "> $$M = 0$$",
        "$$Z_1 X_1 Z_2$$",
        "`$ab = c$`",
    ):
        assert not list(formulas_without_number([new_markdown_cell(markdown)])), markdown


def test_numbers_of_formulas_are_distinguished_from_other_brackets():
    assert named(
        r"By (1), $\quad(2)$ and $$a = b \tag{c}$$ as in (3.88), $f(4)$, $A_1(5)$, $R^{(6)}$ and 1904 (1954)."
    ) == {*("1", "2", "c")}


def test_only_an_assertion_counts_as_a_check():
    assert list(checked("assert a == b  # (1), (3) to (5)\nc = d  # (2)\nprint('# (6)')")) == ["1", "3", "4", "5"]
    assert list(checked("assert np.allclose(\n    a,  # (a) to (c)\n    b,\n)")) == ["a", "b", "c"]


def test_a_formula_and_its_assertion_must_be_near_each_other():
    formula, check = new_markdown_cell("$$ab = c \\tag{1}$$"), new_code_cell("assert True  # (1)")
    for cells, is_reported in [
        ([formula, new_code_cell("1"), check], False),
        ([check, new_code_cell("1"), formula], False),
        ([formula], True),
        ([check], True),
        ([formula, *3 * [new_code_cell("1")], check], False),
        ([formula, *4 * [new_code_cell("1")], check], True),
        *(([formula, *9 * [new_code_cell(shown)], check], False) for shown in ("turning", "explain('03/order')")),
        *(([formula, *9 * [new_code_cell(code)], check], True) for code in ("a = 1", "a\nb")),
    ]:
        assert bool([*formulas_without_check(cells)]) == is_reported


def test_a_number_needs_a_source_that_rounds_to_it():
    for text, right, wrong in [
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
    ]:
        assert not numbers_without_source(text, [right])
        assert numbers_without_source(text, [wrong])
    for text in (
        *("6 joints, 90 degrees, $-90°$, in 1954", "Modern Robotics (3.88)", "example 2.3, section 3.4.1", "`0.5`"),
        *("```python\n0.5\n```", "> 0.5 as printed", "[here](page_0.5.md)", r"$\frac12$ and $x_{10}$"),
    ):
        assert not list(numbers_in(text)), "what is chosen or quoted needs no source"


def test_what_is_printed_and_literals_in_code_are_sources_and_pictures_and_questions_are_not():
    picture = new_output(
        "display_data", {"text/html": '<svg viewBox="0 0 0.37 1"/>', "text/plain": "An arm, 0.2 m long."}
    )
    question = new_output("display_data", {"application/vnd.jupyter.widget-view+json": {}, "text/plain": "Is it 0.37?"})
    cell = new_code_cell("1.5", outputs=[picture, question, new_output("stream", text="0.1\n")])
    assert set(numbers_printed([cell])) == {0.2, 0.1}
    cell = new_code_cell('length = -0.25  # 0.75\ntable = "1 | 0.147"\nflag = True')
    assert set(numbers_given([cell, new_markdown_cell("0.9")])) == {0.25, 1, 0.147}


def test_the_stated_times_are_those_that_the_counts_give():
    """Within a fifth, so that a lecture that grows says so; the table in lecture 00 has a time from this range."""
    table = next(cell.source for cell in nbformat.read(LECTURES[0], as_version=4).cells if cell.id == "summary")
    listed = {
        number: int(time) for number, time in re.findall(r"^\| \[?(\d\d[a-z]?) .* \| (\d+) \|$", table, re.MULTILINE)
    }
    wrong = {}
    for number, questions in COURSE.questions().items():
        (path,) = (path for path in LECTURES if path.name.startswith(f"{number}_"))
        notebook = nbformat.read(path, as_version=4)
        counted, (low, high) = minutes(notebook, len(questions)), stated(notebook)
        if not 0.8 * counted <= low <= listed[number] <= high <= 1.2 * counted:
            wrong[path.stem] = f"counted {counted:.0f}, stated {low} to {high}, listed {listed[number]}"
    assert wrong == {}
