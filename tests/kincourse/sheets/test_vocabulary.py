"""What all problems say: one name for what people do, so that a mistake that returns can be counted, and formulas that can be set."""

import re
from collections import defaultdict

import pytest
from latex2mathml.converter import convert

from kincourse import find_sheet, sheets
from misstep.grading.pages import SMALL_FRACTION

SYMBOL = re.compile(r"\$[^$]*\$")

SYNONYMS = (
    {"inverse", "inverted"},
    {"rotation transposed", "R^T"},
    {"rotation left out", "not rotated", "only moved"},
    {"alpha left out", "alpha 0", "every alpha 0"},
    {"d left out", "d forgotten", "every d 0"},
    {"no offset", "offset forgotten"},
    {"half a turn", "half a turn off"},
    {"angles swapped", "alpha and theta swapped"},
    {"halved", "half the angle"},
    {"doubled", "double the angle"},
    {"omega x p", "omega x q"},
    {"prismatic as revolute", "slide as turn"},
    {"revolute as prismatic", "turn as slide"},
    {"millimetres", "unit of length"},
    {"the other convention", "other convention", "another convention"},
)
"""Names of one misconception, of which only one occurs."""


@pytest.fixture(scope="module")
def problems():
    return [template.variant("student 0") for name in sheets() for template in find_sheet(name).problems]


def test_one_change_has_one_name_and_no_name_has_a_synonym(problems):
    names_of, all_names = defaultdict(set), set()
    for problem in problems:
        all_names.update(mistake.name for mistake in [*problem.known_mistakes, *problem.slips])
        for mistake in [*problem.mutants, *problem.slips]:
            if mistake.did and not SYMBOL.search(mistake.did):  # a symbol may be an angle here and a length there
                names_of[mistake.did].add(mistake.name)
    assert {did: names for did, names in names_of.items() if len(names) > 1} == {}
    assert [names & all_names for names in SYNONYMS if len(names & all_names) > 1] == []


def test_every_formula_of_a_statement_and_of_a_message_can_be_set(problems):
    """On the page of feedback an invalid one would stand as it was typed."""
    formulas = set()
    for problem in problems:
        mistakes = [*problem.mistakes, *problem.mutants]
        for text in (problem.statement, *(text for one in mistakes for text in (one.message, one.part))):
            formulas |= {*re.findall(r"\$\$?([^$]+)\$\$?", text)}
    assert len(formulas) > 100
    for formula in formulas:
        assert convert(SMALL_FRACTION.sub(r"\\frac", formula)).startswith("<math"), formula
