"""Answers as a student types them."""

from misstep.answers.function import FunctionCalls
from misstep.formulas.evaluation import Formula


def as_typed(value):
    """What was read goes back to what was typed."""
    value = value.given if isinstance(value, Formula) else value
    return value.function if isinstance(value, FunctionCalls) else value
