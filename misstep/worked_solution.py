"""Worked solutions: the expression that judges an answer, written step by step with the numbers of the student."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from misstep.answers.base import at_inputs
from misstep.answers.choice import Choice, ReasonedChoice
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number, vector
from misstep.mutants.expression import Expression
from misstep.mutants.operations import radians
from misstep.problem import Problem

MAX_GIVEN, MAX_STEPS, MAX_ENTRIES = 14, 8, 42
"""How many given values and steps are written, and the entries of the largest array."""


def worked_solution(problem: Problem) -> Sequence[str]:
    r"""Return the steps to the right answer of a problem, each in a sentence or a formula.

    >>> from misstep.answers.number import Numbers
    >>> from misstep.mutants.expression import given
    >>> reach = (given("a", 0.5) + given("b", 0.25)).named("r")
    >>> worked_solution(Problem("", Numbers(np.array(1.5)), solution=2 * reach))
    ['$a = 0.5$, $b = 0.25$', '$r = a + b = 0.75$', '$2\\,r = 1.5$']
    """
    answer, solution = problem.answer, problem.solution
    if isinstance(answer, ReasonedChoice):
        both = (answer.choice, answer.reason)
        return [step for one in both for step in worked_solution(Problem("", one))]
    if isinstance(answer, Choice):
        text = answer.options[answer.value]
        return [answer.value if answer.value == text else f"{answer.value}: {text}"]
    if isinstance(answer, Prose):
        rubric = [f"{earns} point{'s' * (earns != 1)}: {text}" for text, earns in answer.rubric.items()]
        return [*rubric, f"A model answer: {answer.value}"]
    steps: list[str] = []
    if isinstance(solution, Expression):
        return list(dict.fromkeys(_steps(solution)))
    if solution is not None:
        root = next(at_inputs(answer, solution))
        named = [node for node in dict.fromkeys(_in_order(root)) if node.arguments and node.label and node is not root]
        steps = list(dict.fromkeys(f"${node.label} = {node.formula}$" for node in named[-MAX_STEPS:]))
        steps.append(f"${root.formula}$")
    if hasattr(answer.value, "free_symbols"):  # a formula of SymPy, which a page loads only when a cell uses it
        import sympy as sp

        return [*steps, f"${sp.latex(answer.value)}$"]
    value = getattr(answer.value, "rows", answer.value)
    if written := "" if callable(value) else _written(value):
        steps.append(f"${written}$")
    elif isinstance(value, Sequence):
        steps.append(", ".join(map(str, value)))
    elif isinstance(value, np.ndarray):
        steps += [f"${matrix(one)}$" for one in value]
    return steps


def _steps(root: Expression) -> Iterator[str]:
    nodes = list(dict.fromkeys(_in_order(root)))
    leaves = [node for node in nodes if not node.arguments and not _is_number(node.label)]
    in_degrees = {id(node.arguments[0]) for node in nodes if node.operation is radians}
    given = [
        f"${node.label} = {text}{'°' if id(node) in in_degrees else ''}$"
        for node in leaves
        if (text := _written(node.value)) and "$" not in node.label
    ]
    if given:
        yield ", ".join(dict.fromkeys(given[:MAX_GIVEN]))
    named = [node for node in nodes if node.arguments and node.label and node is not root]
    for node in [*named[-MAX_STEPS:], root]:
        # A column or an entry has the formula of the whole; a label in brackets is that of a sum within a product.
        formula = "" if node.operation.name == "entry" else node.formula
        label = "" if node.label == f"({formula})" else node.label
        parts = dict.fromkeys(filter(None, (label, formula, _written(node.value))))
        yield f"${' = '.join(parts)}$"


def _in_order(node: Expression) -> Iterator[Expression]:
    """Yield the parts of an expression, each after its own parts."""
    for argument in node.arguments:
        yield from _in_order(argument)
    yield node


def _written(value: Any) -> str:
    """Return a number, a vector or a matrix in LaTeX; "" for anything else."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return ""
    if array.size > MAX_ENTRIES or array.ndim > 2:
        return ""
    return matrix(array) if array.ndim == 2 else vector(array) if array.ndim else number(float(array))


def _is_number(label: str) -> bool:
    return label.removesuffix("^\\circ").lstrip("-").replace(".", "", 1).isdigit()
