"""Answers of the course as JSON: they are judged from JSON as they are judged in the notebook."""

import json

import numpy as np
import pytest
from hostile_answers import HOSTILE, Rude
from typed_answers import as_typed, typable

from kincourse import find_sheet, sheets
from kinlib.dh.table import DHTable
from misstep.judge import judge
from misstep.storage.deserialize import Malformed, from_data
from misstep.storage.serialize import to_data

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


def sent(value, inputs=()):
    """A value after its journey: to JSON as strict as there is, and back."""
    return from_data(json.loads(json.dumps(to_data(value, inputs), allow_nan=False)))


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_an_answer_is_judged_from_json_as_in_the_notebook(template):
    problem = template.variant("ada")
    typed = [
        problem.answer.value,
        *(wrong.value for wrong in typable(problem)[:12]),
    ]
    for value in [*map(as_typed, typed), ..., None, *HOSTILE.values(), Rude()]:
        home, away = judge(problem, value), judge(problem, sent(value, problem.answer.inputs))
        assert (away.state, away.fraction, away.mistakes) == (home.state, home.fraction, home.mistakes)


def test_a_table_comes_back_with_signs_base_and_tool():
    typed = "a | alpha | d | theta\n 0.4 | pi/2 | 0.1 | 0.3 - q1\n 0.3 | 0 | q2 - 1 | 1e-7\n 0.1 | 0 | 0.2 | 0"
    table = DHTable(typed, convention="modified", base=np.diag([1, -1, -1, 1.0]), tool=np.diag([-1, -1, 1, 1.0]))
    back = sent(table)
    assert (back.joints, back.convention) == (table.joints, "modified") == ("RPF", "modified")
    at = np.array([0.7, -0.2])
    np.testing.assert_allclose(back.fk(at), table.fk(at), rtol=0, atol=1e-15)


def a_table(**odd):
    pose = np.eye(4).tolist()
    right = {"rows": [[0, 0, 0, 0]], "convention": "standard", "joints": "R", "signs": [1], "base": pose, "tool": pose}
    return {"object": "DHTable", "fields": {**right, **odd}}


def test_a_table_of_plain_numbers_is_read():
    assert from_data(a_table()).joints == "R"


MALFORMED = {
    "a key missing": {"object": "DHTable", "fields": {"rows": [[0, 0, 0, 0]]}},
    "an unknown key": a_table(score=3),
    "another convention": a_table(convention="other"),
    "empty poses": a_table(base=[], tool=[]),
    "a number as rows": a_table(rows=7),
    "every type wrong": a_table(rows=[["x"]], convention=[], joints={}, signs=1, base=None, tool=7),
    "signs as text": a_table(signs="1"),
    "joints as a list": a_table(joints=["R"]),
    "an unknown joint type": a_table(joints="X"),
    "2000 unknown joint types": a_table(rows=[[0] * 4] * 2000, joints="X" * 2000, signs=[1] * 2000),
    "a sign of 0.5": a_table(signs=[0.5]),
    "a sign that is a truth value": a_table(signs=[True]),
    "a number as text": a_table(rows=[["0", 0, 0, 0]]),
    "a whole number beyond floats": a_table(rows=[[10**400, 0, 0, 0]]),
    "infinity": a_table(rows=[[1e400, 0, 0, 0]]),
    "a ragged pose": a_table(base=[[1, 0, 0, 0], [0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    "a row of three numbers": a_table(rows=[[0, 0, 0]]),
    "a sign too many": a_table(signs=[1, 1]),
    "a joint too many": a_table(joints="RR"),
    "5000 fixed rows": a_table(rows=[[0, 0, 0, 0]] * 5000, joints="F" * 5000, signs=[1] * 5000),
}


@pytest.mark.parametrize("data", MALFORMED.values(), ids=MALFORMED)
def test_a_table_of_any_other_form_is_refused(data):
    with pytest.raises(Malformed, match=r"^This is not a DHTable: ") as refused:
        from_data(data)
    assert str(refused.value).encode().endswith((b".", b"?")), "a complete sentence that a screen can show"
    assert len(str(refused.value)) < 500
