"""Functions as answers: judged by their outputs at random inputs."""

import numpy as np
import pytest

from misstep.answers.base import Unreadable
from misstep.answers.function import Function
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.mistakes import Mistake
from misstep.mutants.expression import given as of_solution
from misstep.problem import Problem


def squares(**more):
    return Function(np.square, Numbers(np.zeros(2)), lambda chance: (chance.uniform(1, 2, 2),), **more)


def asked():
    return Problem("Square.", squares(), [Mistake("doubled", lambda x: 2 * x, "You doubled.")])


def test_a_solution_with_other_changes_at_another_input_is_refused():
    first = squares().inputs[0][0]

    def solution(x):
        value = of_solution("x", x)
        return value * value if np.array_equal(x, first) else value * value + of_solution("0", np.zeros(2))

    with pytest.raises(ValueError, match="the same changes at each input"):
        _ = Problem("Square.", squares(), solution=solution).known_mistakes


def test_mistakes_of_functions_are_recognised():
    problem = asked()
    (finding,) = judge(problem, lambda x: 2 * x).findings
    assert (finding.mistake, finding.message) == ("doubled", "You doubled.")
    assert judge(problem, lambda x: [v**2 for v in x]).state == "right"


def test_what_is_the_same_at_every_input_is_told():
    assert judge(asked(), lambda x: 0 * x).findings[0].mistake == "placeholder"
    swapped = judge(Problem("Square.", squares()), lambda x: x[::-1] ** 2).findings[0].message
    assert swapped == "At every input that was tried: these are the right numbers, but not in the right order."


def test_anything_but_such_a_function_is_refused_with_a_reason():
    for odd, message in [
        (np.ones(2), "got ndarray"),
        (lambda: 1, "raised TypeError"),
        (lambda _: 1 / 0, "raised ZeroDivisionError: division by zero"),
        (lambda _: None, "Is the return missing"),
        (lambda x: x[:1], r"shape \(1,\)"),
        (lambda x: x * np.nan, "NaN"),
    ]:
        with pytest.raises(Unreadable, match=message):
            squares().read(odd)
