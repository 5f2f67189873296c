"""Functions as answers: judged by what they give, wherever anybody looks."""

import numpy as np
import pytest

from misstep.answers.base import Unreadable
from misstep.answers.function import CALL_COUNT, Function, function_mistakes
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.mistakes import Mistake
from misstep.problem import Problem
from misstep.storage.deserialize import Outputs


def squares(**more):
    return Function(np.square, Numbers(np.zeros(2)), lambda chance: (chance.uniform(1, 2, 2),), **more)


def asked():
    return Problem(
        "Square.", squares(), function_mistakes(lambda x: [Mistake("doubled", 2 * x, "You doubled.")], np.ones(2))
    )


def test_a_function_is_right_however_it_is_written():
    assert judge(asked(), lambda x: [v**2 for v in x]).state == "right"


def test_a_mistake_of_a_function_is_named():
    judgement = judge(asked(), lambda x: x + x)
    assert judgement.mistakes == ["doubled"]
    assert judgement.findings[0].message == "You doubled."


def test_a_function_whose_outputs_were_rounded_on_the_way_is_told_so():
    assert "looks rounded" in judge(asked(), lambda x: np.square(x) + 0.01).findings[0].message


def test_the_inputs_are_other_ones_for_each_seed_and_the_same_for_one():
    inputs = {seed: np.array(squares().with_inputs(seed).inputs) for seed in (0, 1)}
    assert len(inputs[0]) == CALL_COUNT
    assert not np.isclose(inputs[0], inputs[1]).any()
    np.testing.assert_array_equal(inputs[0], squares().with_inputs(0).inputs)
    np.testing.assert_array_equal(inputs[0], squares().inputs)


def test_two_functions_may_be_compared_as_they_are():
    answer = squares()
    assert answer.agrees(np.square, lambda x: x * x) == [True]
    assert answer.agrees(lambda x: 2 * x, np.square) == [False]
    assert answer.agrees(lambda x: 2 * x, lambda x: x + x) == [True]


def test_a_function_that_knows_the_inputs_of_home_is_wrong_elsewhere():
    problem = asked()
    known = {tuple(x): x**2 for (x,) in problem.answer.inputs}
    assert judge(problem, lambda x: known[tuple(x)]).state == "right"
    assert judge(problem.with_inputs(1), lambda x: known.get(tuple(x), np.zeros(2))).fraction == 0


def test_the_mistakes_follow_to_other_inputs():
    assert judge(asked().with_inputs(7), lambda x: 2 * x).mistakes == ["doubled"]


def test_outputs_from_elsewhere_are_judged_like_the_function():
    problem = asked().with_inputs(3)
    outputs = Outputs([np.square(x) for (x,) in problem.answer.inputs])
    assert judge(problem, outputs).state == "right"
    fewer = judge(problem, Outputs(outputs.values[1:]))
    assert fewer.state == "unreadable"
    assert fewer.findings[0].message.endswith(f"it gave {CALL_COUNT - 1} outputs for {CALL_COUNT} calls.")
    assert judge(problem, Outputs([None] * CALL_COUNT)).state == "unreadable"


def test_a_function_that_is_right_at_some_inputs_is_told_so():
    problem = asked()
    first = problem.answer.inputs[0][0]
    judgement = judge(problem, lambda x: x**2 if np.array_equal(x, first) else 0 * x)
    assert judgement.findings[0].message == f"It is right at 1 of {CALL_COUNT} inputs that were tried."
    assert judge(problem, lambda x: 0 * x).findings[0].message.startswith("None of the mistakes that we know")


def test_a_function_cannot_change_the_inputs_of_others():
    problem = asked()
    before = np.array(problem.answer.inputs)
    judge(problem, lambda x: x.fill(0))
    np.testing.assert_array_equal(problem.answer.inputs, before)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        (np.ones(2), r"Leave the brackets off"),
        (float, "got type"),
        (lambda: 1, "raised TypeError"),
        (lambda _: 1 / 0, "raised ZeroDivisionError: division by zero"),
        (lambda _: None, "Is the return missing"),
        (lambda x: x[:1], r"shape \(1,\)"),
        (lambda _: "text", "got str"),
        (lambda x: x * np.nan, "NaN"),
    ],
)
def test_what_is_no_such_function_is_told_why(given, told):
    with pytest.raises(Unreadable, match=told):
        squares().read(given)
