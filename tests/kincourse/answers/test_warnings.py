"""Reading an answer never warns: what is an exception in these tests would be a warning to a student, with other feedback."""

import warnings

import numpy as np
from hostile_answers import HOSTILE

from kincourse import find_sheet, sheets
from misstep.judge import judge

PROBLEMS = [template.variant("ada") for name in sheets() for template in find_sheet(name).problems]
ONE_OF_EACH_KIND = {type(problem.answer).__name__: problem for problem in PROBLEMS}

BEYOND_DOUBLES = np.longdouble("1e400")


def odd_values(right):
    """Make values that look like the right answer, and whose conversion to floats loses something or fails."""
    if callable(right):
        return [lambda *_, odd=odd: odd for odd in [*HOSTILE.values(), *odd_values(np.eye(4))]]
    try:
        numbers = np.asarray(right, dtype=float)
    except (TypeError, ValueError):  # a table, a choice or a formula
        return ["1/0", "log(0)", "sqrt(-1)", "10**400"]
    return [
        *(numbers + 1j, numbers + 0j, (numbers + 1j).tolist(), numbers.astype(object), numbers.astype(str)),
        *(np.full(numbers.shape, BEYOND_DOUBLES), np.full(numbers.shape, 10**400, dtype=object), numbers * 1e300),
        *(np.full(numbers.shape, np.float16(6e4)), np.where(numbers == numbers.flat[0], np.nan, numbers)),
        *(np.ma.masked_array(numbers, mask=True), [np.array([x]) for x in numbers.flat]),
    ]


def feedback(problem, value, action):
    """Return what a student reads, and the warnings that are shown beside it."""
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter(action)
        judgement = judge(problem, value)
    texts = [finding.message for finding in judgement.findings]
    return (judgement.state, judgement.fraction, texts), [str(warning.message) for warning in shown]


def test_feedback_is_the_same_whether_warnings_are_shown_or_raised():
    for kind, problem in ONE_OF_EACH_KIND.items():
        for value in [*HOSTILE.values(), *odd_values(problem.answer.value)]:
            seen, shown = feedback(problem, value, "always")
            assert shown == [], kind
            assert feedback(problem, value, "error") == (seen, []), kind
