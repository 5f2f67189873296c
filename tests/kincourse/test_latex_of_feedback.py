"""Every formula of a statement and of a message can be set: on the page of feedback an invalid one would stand as it was typed."""

import re

from latex2mathml.converter import convert

from kincourse import find_sheet, sheets
from misstep.grading.pages import SMALL_FRACTION


def test_every_formula_is_valid_latex():
    formulas = set()
    for problem in (template.variant("ada") for name in sheets() for template in find_sheet(name).problems):
        mistakes = [*problem.mistakes, *problem.mutants]
        for text in (problem.statement, *(text for one in mistakes for text in (one.message, one.part))):
            formulas |= {*re.findall(r"\$\$?([^$]+)\$\$?", text)}
    assert len(formulas) > 100
    for formula in formulas:
        assert convert(SMALL_FRACTION.sub(r"\\frac", formula)).startswith("<math"), formula
