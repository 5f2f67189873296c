"""Every formula of a statement and of a message can be set: on the page of feedback an invalid one would stand as it was typed."""

import re

import pytest
from latex2mathml.converter import convert

from kincourse import find_sheet, sheets
from misstep.grading.publish.mathml import SMALL_FRACTION

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_every_formula_is_valid_latex(template):
    problem = template.variant("ada")
    mistakes = [*problem.mistakes, *problem.mutants]
    texts = {problem.statement, *(text for one in mistakes for text in (one.message, one.part))}
    for formula in {found for text in texts for found in re.findall(r"\$\$?([^$]+)\$\$?", text)}:
        assert convert(SMALL_FRACTION.sub(r"\\frac", formula)).startswith("<math")
