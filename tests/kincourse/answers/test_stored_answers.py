"""Answers of the course as JSON: they are judged from JSON as they are judged in the notebook."""

import json

from hostile_answers import HOSTILE, Rude

from kincourse import find_sheet, sheets
from misstep.formulas.evaluation import Formula
from misstep.judge import judge
from misstep.storage import Outputs, from_data, to_data


def sent(value, inputs=()):
    """A value after its journey: to JSON as strict as there is, and back."""
    return from_data(json.loads(json.dumps(to_data(value, inputs), allow_nan=False)))


def test_an_answer_of_each_kind_is_judged_from_json_as_in_the_notebook():
    drawn = [template.variant("ada") for name in sheets() for template in find_sheet(name).problems]
    for problem in {type(problem.answer): problem for problem in drawn}.values():
        values = [problem.answer.value, *(wrong.value for wrong in problem.known_mistakes[:5])]
        typed = [value for value in values if not isinstance(value, (Formula, Outputs))]  # these are numbers alone
        for value in [*typed, ..., *HOSTILE.values(), Rude()]:
            home, away = judge(problem, value), judge(problem, sent(value, problem.answer.inputs))
            assert (away.state, away.fraction, away.mistakes) == (home.state, home.fraction, home.mistakes)
