"""Worked solutions: the expression that judges an answer, written step by step with the numbers of the student."""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from misstep.answers.base import Answer
from misstep.answers.choice import Choice, ReasonedChoice
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number, vector
from misstep.mutants.expression import Expression
from misstep.mutants.operations import radians
from misstep.problem import Problem

MAX_GIVEN, MAX_STEPS, MAX_ENTRIES = 14, 8, 42
"""How many given values and steps are written, and the entries of the largest array."""


def worked_solution(problem: Problem) -> Sequence[str]:
    r"""Return the steps to the right answer of a problem, each in a sentence or a formula: first its method.

    >>> from misstep.answers.number import Numbers
    >>> from misstep.mutants.expression import given
    >>> reach = (given("a", 0.5) + given("b", 0.25)).named("r")
    >>> worked_solution(Problem("", Numbers(np.array(1.5)), solution=2 * reach))
    ['$a = 0.5$, $b = 0.25$', '$r = a + b = 0.75$', '$2\\,r = 1.5$']
    """
    answer, solution = problem.answer, problem.solution
    if isinstance(answer, Prose):
        rubric = [f"{earns} point{'s' * (earns != 1)}: {text}" for text, earns in answer.rubric.items()]
        return [*rubric, f"A model answer: {answer.value}"]
    if solution is None:
        return [*problem.method.splitlines(), *_result(answer)]
    roots, value = list(answer.at_inputs(solution)), ""
    if hasattr(answer.value, "free_symbols"):  # a formula of SymPy, which a page loads only when a cell uses it
        import sympy as sp

        value = sp.latex(answer.value, mat_str="matrix", mat_delim="(")
    return [*problem.method.splitlines(), *dict.fromkeys(_steps(roots[0], roots[1] if len(roots) > 1 else None, value))]


def _result(answer: Answer) -> Iterator[str]:
    """Yield the right answer."""
    value = getattr(answer.value, "rows", answer.value)
    if isinstance(answer, ReasonedChoice):
        yield from (step for one in (answer.choice, answer.reason) for step in _result(one))
    elif isinstance(answer, Choice):
        yield value if value == answer.options[value] else f"`'{value}'`: {answer.options[value]}"
    elif written := _written(value):
        yield f"${written}$"
    elif isinstance(value, np.ndarray):
        yield from (f"${matrix(one)}$" for one in value)
    else:
        yield ", ".join(map(str, value))


def _steps(root: Expression, other: Expression | None = None, result: str = "") -> Iterator[str]:
    """Yield the given values, the named parts and the whole.

    other   the same solution at another input, if it is a formula; values that differ there are left out
    result  the formula to which it leads
    """
    nodes, others = (list(_in_order(node)) for node in (root, other or root))
    constant = {id(a) for a, b in zip(nodes, others, strict=True) if np.array_equal(a.value, b.value)}
    in_degrees = {id(node.arguments[0]) for node in nodes if node.operation is radians}

    def written(node: Expression) -> str:
        unit = ("°/\\mathrm{s}" if "dot" in node.label else "°") if id(node) in in_degrees else ""
        return f"{text}{unit}" if id(node) in constant and (text := _written(node.value)) else ""

    leaves = [
        node
        for node in nodes
        if not node.arguments and not node.label.lstrip("-")[:1].isdigit() and "$" not in node.label
    ]
    if given := [f"${a.label} = {text}$" for a in _by_index(leaves) if (text := written(a)) not in {"", a.label}]:
        listed = list(dict.fromkeys(given))
        yield ", ".join([*listed[:MAX_GIVEN], *["and others"] * (len(listed) > MAX_GIVEN)])
    named = [node for node in nodes if node.arguments and node.label and node is not root]
    for node in [*_by_index(named, max)[-MAX_STEPS:], root]:
        # A column or an entry has the formula of the whole; a label in brackets is that of a sum within a product.
        formula = "" if node.operation.name == "entry" else node.formula
        label = "" if node.label == f"({formula})" else node.label
        end = result if node is root and other else written(node)
        yield f"${' = '.join(dict.fromkeys(filter(None, (label, formula, end))))}$"


def _in_order(node: Expression) -> Iterator[Expression]:
    """Yield the parts of an expression, each after its own parts."""
    for argument in node.arguments:
        yield from _in_order(argument)
    yield node


def _by_index(nodes: Sequence[Expression], place: Callable[[Sequence[int]], int] = min) -> list[Expression]:
    """Return nodes by letter, then by index. A letter stands at its first node; with max at its last, after all their parts."""
    letters = [re.sub(r"\d", "", node.label) for node in nodes]
    places = {one: place([k for k, letter in enumerate(letters) if letter == one]) for one in letters}
    return sorted(dict.fromkeys(nodes), key=lambda node: (places[re.sub(r"\d", "", node.label)], node.label))


def _written(value: Any) -> str:
    """Return a number, a vector or a matrix in LaTeX; "" for anything else."""
    try:
        array = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return ""
    if array.size > MAX_ENTRIES or array.ndim > 2:
        return ""
    return matrix(array) if array.ndim == 2 else vector(array) if array.ndim else number(float(array))
