"""One vocabulary: what people do has one name in every problem, so that a mistake that returns can be counted."""

import re
from collections import defaultdict

from kincourse import find_sheet, sheets

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


def test_one_change_has_one_name_and_no_name_has_a_synonym():
    names_of, all_names = defaultdict(set), set()
    for name in sheets():
        for template in find_sheet(name).problems:
            problem = template.variant("student 0")
            all_names.update(mistake.name for mistake in [*problem.known_mistakes, *problem.slips])
            for mistake in [*problem.mutants, *problem.slips]:
                if mistake.did and not SYMBOL.search(mistake.did):  # a symbol may be an angle here and a length there
                    names_of[mistake.did].add(mistake.name)
    assert {did: names for did, names in names_of.items() if len(names) > 1} == {}
    assert [names & all_names for names in SYNONYMS if len(names & all_names) > 1] == []
