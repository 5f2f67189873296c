"""Answers as data, mangled: whatever lies where a check cell writes its answer, a verdict comes of it, and so do the tables."""

import json
import math
import re
import signal
from functools import cache

from hypothesis import strategies as st
from mangled import assert_explained, mangled, mangled_json, noise, often

from kinlib.grading import judge as judging
from kinlib.grading.matches import matches
from kinlib.grading.pages import STATES
from kinlib.grading.result import ProblemResult, Result
from kinlib.grading.wire import pack
from kinlib.practice import find_sheet, sheets
from kinlib.practice.answer_data import Malformed, from_data
from kinlib.practice.answer_writing import to_data
from kinlib.practice.formulas import Formula
from kinlib.practice.functions import Called

TEMPLATES = [(find_sheet(name), k) for name in sheets() for k in range(len(find_sheet(name).problems))]

FORMS = (
    *({"number": 1e308}, {"text": "a | alpha | d | theta\n1 | 0 | 0 | q1"}, {"array": [None], "shape": [1]}),
    *(
        {"symbolic": "cos(q_1)"},
        {"symbolic": "1/0"},
        {"symbolic": "E**(I*pi)"},
        {"symbolic": "(x+1)**64"},
        {"other": "thing"},
    ),
    *(
        {"matrix": [[{"symbolic": "sin(q_1)"}, {"number": 1.0}]]},
        {"matrix": []},
        {"matrix": [[]]},
        {"map": [["a", None]]},
    ),
    *({"function": "fk", "outputs": [None, {"number": 0.5}]}, {"function": "fk"}, {"list": [{"text": "e_a"}, None]}),
    {"list": [{"map": [["a", {"text": "l1"}], ["alpha", None], ["d", {"number": 1}], ["theta", {"text": "q1"}]]}]},
)


@cache
def problem(place):
    sheet, k = TEMPLATES[place]
    return sheet.problems[k].variant("ada")


@cache
def answers(place):
    """Answers to a problem as they are handed in: the right one, those of its mistakes, and some of its neighbours."""
    asked = problem(place)
    values = [asked.answer.value, *(mistake.value for mistake in asked.mistakes)]
    return [to_data(_typed(value), asked.answer.inputs) for value in values]


def _typed(value):
    value = value.given if isinstance(value, Formula) else value
    return value.function if isinstance(value, Called) else value


@cache
def cases():
    """The place of a problem, and what came as its answer."""
    strings = mangled(noise()).map(lambda text: {"text": text})
    odd = mangled_json(st.sampled_from(FORMS)) | strings

    @cache
    def handed_in(place):
        nearly = mangled_json(st.sampled_from(answers(place)), FORMS)
        return st.tuples(st.just(place), often(20, nearly, odd))

    return st.integers(0, len(TEMPLATES) - 1).flatmap(handed_in)


def check(case):
    place, data = case
    signal.signal(signal.SIGPROF, judging._too_long)
    assert_read_and_written(data)
    sheet, k = TEMPLATES[place]
    template, verdict = sheet.problems[k], judging._verdict(sheet, k + 1, problem(place), data)
    assert_verdict(verdict)
    points = template.points * verdict["fraction"]
    shown = verdict["text"], verdict["html"], verdict["mistakes"]
    result = ProblemResult(template.number, template.title, points, template.points, verdict["state"], *shown)
    theirs = ProblemResult(**{**vars(result), "answer": data, "right": verdict["right"]})
    other = ProblemResult(**{**vars(result), "answer": answers(place)[0], "right": answers(place)[0], "state": "right"})
    matches([_result(student, told) for student, told in {"ada": theirs, "bob": other}.items()])


def assert_read_and_written(data):
    try:
        value = from_data(data)
    except Malformed as error:
        assert_explained(error, Malformed)
    else:
        written = to_data(value)
        if not re.search('"(other|function)"', json.dumps(written)):
            assert json.dumps(to_data(from_data(written))) == json.dumps(written)


def assert_verdict(verdict):
    fraction, state = verdict["fraction"], verdict["state"]
    assert math.isfinite(fraction)
    assert 0 <= fraction <= 1
    assert state in STATES
    assert (state == "right") == (fraction == 1)
    assert (state in {"blank", "unreadable", "wrong", "missing"}) == (fraction == 0)
    assert "could not be judged" not in verdict["text"], verdict["text"][-300:]
    assert state in {"right", "missing"} or len(verdict["text"].splitlines()) > 2, "there is no reason"
    assert len(verdict["text"]) < 5000, verdict["text"][:300]
    pack(verdict)


def _result(student, told):
    return Result(student, "sheet", told.points, told.max, "graded", "", [told])
