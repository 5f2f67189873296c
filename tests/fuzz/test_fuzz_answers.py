"""Fuzz the judge: whatever data is found where a check cell writes its answer, the result is a complete verdict."""

import json
import re
from dataclasses import replace
from functools import cache

from assertions import assert_explained, assert_verdict, limit_processor_time
from corruption import corrupted_json, corrupted_texts, noise, often
from fuzz_settings import fuzz_settings
from hypothesis import given
from hypothesis import strategies as st
from typed_answers import as_typed, typable

from kincourse import find_sheet, sheets
from misstep.grading.judging import judge_process as judging
from misstep.grading.judging.result import Result
from misstep.grading.publish.shared_answers import find_matches
from misstep.grading.sandbox.limits import Limits
from misstep.storage.deserialize import Malformed, from_data
from misstep.storage.serialize import to_data

TEMPLATES = [(find_sheet(name), k) for name in sheets() for k in range(len(find_sheet(name).problems))]

FORMS = (
    *({"number": 1e308}, {"text": "a | alpha | d | theta\n1 | 0 | 0 | q1"}, {"array": [None], "shape": [1]}),
    *({"symbolic": text} for text in ("cos(q_1)", "1/0", "E**(I*pi)", "(x+1)**64")),
    *({"matrix": [[{"symbolic": "sin(q_1)"}, {"number": 1.0}]]}, {"matrix": []}, {"matrix": [[]]}, {"other": "thing"}),
    *({"map": [["a", None]]}, {"function": "fk", "outputs": [None, {"number": 0.5}]}, {"function": "fk"}),
    {"list": [{"text": "e_a"}, None]},
    {"list": [{"map": [["a", {"text": "l1"}], ["alpha", None], ["d", {"number": 1}], ["theta", {"text": "q1"}]]}]},
)


@cache
def problem(place):
    sheet, k = TEMPLATES[place]
    return sheet.problems[k].variant("ada")


@cache
def answers(place):
    """Answers to a problem as data: the right one, and those of its mistakes."""
    asked = problem(place)
    values = [asked.answer.value, *(mistake.value for mistake in typable(asked)[:12])]
    return [to_data(as_typed(value), asked.answer.inputs) for value in values]


def cases():
    """The index of a problem, and the data of its answer."""
    strings = corrupted_texts(noise()).map(lambda text: {"text": text})
    odd = corrupted_json(st.sampled_from(FORMS)) | strings

    @cache
    def handed_in(place):
        nearly = corrupted_json(st.sampled_from(answers(place)), FORMS)
        return st.tuples(st.just(place), often(20, nearly, odd))

    return st.integers(0, len(TEMPLATES) - 1).flatmap(handed_in)


@fuzz_settings(20)
@given(st.deferred(cases))
def test_any_answer_data_gets_a_complete_verdict(case):
    place, data = case
    assert_read_and_written(data)
    sheet, k = TEMPLATES[place]
    template = sheet.problems[k]
    with limit_processor_time(Limits.answer_seconds):
        verdict = judging.verdict_on(template, problem(place), data, "")
    assert_verdict(verdict)
    other = replace(verdict, answer=answers(place)[0], right=answers(place)[0], state="right")
    find_matches([_result(student, told) for student, told in {"ada": verdict, "bob": other}.items()])


def assert_read_and_written(data):
    try:
        value = from_data(data)
    except Malformed as error:
        assert_explained(error, Malformed)
    else:
        written = to_data(value)
        if not re.search('"(other|function)"', json.dumps(written)):
            assert json.dumps(to_data(from_data(written))) == json.dumps(written)


def _result(student, told):
    return Result(student, "sheet", told.points, told.max, "graded", "", [told])
