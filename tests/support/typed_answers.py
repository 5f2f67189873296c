"""Answers as a student types them."""

from misstep.answers.function import FunctionCalls
from misstep.formulas.evaluation import Formula


def typable(problem):
    """The mistakes of a problem that can be typed: all but the mutants of functions and formulas, which are numbers alone."""
    return [wrong for wrong in problem.known_mistakes if as_typed(wrong.value) is not None]


def as_typed(value):
    """What was read goes back to what was typed."""
    value = value.given if isinstance(value, Formula) else value
    return value.function if isinstance(value, FunctionCalls) else value
