"""Answers of the course as JSON: they are judged from JSON as they are judged in the notebook."""

import json

import pytest
from hostile_answers import HOSTILE, Rude

from kincourse import find_sheet, sheets
from kinlib.dh.table import DHTable
from misstep.answers.function import FunctionCalls
from misstep.formulas.evaluation import Formula
from misstep.judge import judge
from misstep.storage.deserialize import Malformed, from_data
from misstep.storage.serialize import to_data


def sent(value, inputs=()):
    """A value after its journey: to JSON as strict as there is, and back."""
    return from_data(json.loads(json.dumps(to_data(value, inputs), allow_nan=False)))


def as_typed(value):
    """What was read goes back to what was typed; mutants of functions and formulas are numbers alone, which gives None."""
    value = value.given if isinstance(value, Formula) else value
    return value.function if isinstance(value, FunctionCalls) else value


def test_an_answer_of_each_kind_is_judged_from_json_as_in_the_notebook():
    drawn = [template.variant("ada") for name in sheets() for template in find_sheet(name).problems]
    for problem in {type(problem.answer): problem for problem in drawn}.values():
        typed = [as_typed(one) for one in (problem.answer.value, *(wrong.value for wrong in problem.known_mistakes))]
        for value in [*(one for one in typed if one is not None), ..., *HOSTILE.values(), Rude()]:
            home, away = judge(problem, value), judge(problem, sent(value, problem.answer.inputs))
            assert (away.state, away.fraction, away.mistakes) == (home.state, home.fraction, home.mistakes)


def a_table(**odd):
    right = DHTable([[0, 0, 0, 0]], convention="standard").to_dict()
    return {"object": "DHTable", "fields": {**right, **odd}}


def test_a_table_of_any_other_form_is_refused():
    """In a complete sentence that a screen can show, however large the table is; kinlib's own tests have the forms."""
    assert from_data(a_table()).joints == "R"
    for data in (
        {"object": "DHTable", "fields": {"rows": [[0, 0, 0, 0]]}},
        a_table(score=3),
        a_table(rows=7),
        *(a_table(rows=[[number, 0, 0, 0]]) for number in ("0", 10**400, 1e400)),
        *(a_table(rows=[[0] * 4] * 2000, joints=letter * 2000, signs=[1] * 2000) for letter in "XF"),
    ):
        with pytest.raises(Malformed, match=r"^This is not a DHTable: ") as refused:
            from_data(data)
        assert str(refused.value).encode().endswith((b".", b"?"))
        assert len(str(refused.value)) < 500
