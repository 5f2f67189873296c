"""Feedback is held against answers that share no code with it: a third of the problems of each sheet, and one student, in each run."""

import ast
from collections import Counter
from pathlib import Path

import pytest

from kincourse import find_sheet, sheets
from outside.judging import counts_of
from outside.right import RIGHT

PROBLEMS = [problem for name in sheets() for problem in find_sheet(name).problems[int(name[:2]) % 3 :: 3]]
MAX_FALSE = 1
"""With the numbers of one student, another mistake may lead to the same answer."""


@pytest.fixture(scope="module")
def counts():
    return {problem.number: counts_of(problem, "student 0") for problem in PROBLEMS}


def test_no_answer_has_marks_that_it_does_not_deserve_none_is_refused_and_no_right_part_is_called_wrong(counts):
    for _, examples in counts.values():
        for what in ("full marks", "undeserved", "refused", "blamed"):
            assert not examples.get(what), examples[what][:5]


def test_cards_have_the_word_of_what_the_maker_did_and_say_nothing_false(counts):
    total = sum((counted for counted, _ in counts.values()), Counter())
    assert total["wrong"] > 500
    assert total["told"] >= 0.93 * total["with a name"]
    assert total["unnamed"] <= 0.03 * total["with a name"]
    assert total["false"] <= MAX_FALSE * len(counts) / 10, [
        one for _, examples in counts.values() for one in examples.get("false", ())
    ]


def test_every_problem_has_answers_and_they_share_no_code_with_what_they_test():
    problems = [problem for name in sheets() for problem in find_sheet(name).problems]
    assert {problem.number for problem in problems if problem.level != "Open"} <= set(RIGHT)
    for path in Path(__file__).parent.glob("*.py"):
        if path.name not in {"judging.py", "test_outside.py"}:
            nodes = ast.walk(ast.parse(path.read_text("utf-8")))
            imports = [node for node in nodes if isinstance(node, ast.Import | ast.ImportFrom)]
            names = {getattr(node, "module", None) or node.names[0].name for node in imports}
            assert not {name.partition(".")[0] for name in names} & {"kinlib", "misstep", "kincourse"}, path.name
