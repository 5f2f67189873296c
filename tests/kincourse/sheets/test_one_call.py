"""A problem is not its answer: hardly any falls to one call of a public function of kinlib on what is given."""

import inspect
import reprlib
from dataclasses import replace
from itertools import combinations, permutations
from types import FunctionType, MethodType

import numpy as np
import pytest

import kinlib as kl
from kincourse import find_sheet, sheets

MAX_PROBLEMS, MAX_POINTS = 6, 15
CONVENTIONS = ({"convention": "standard"}, {"convention": "modified"})
SLOW = {"assembly_modes", "diagnose", "finite_mobility", "mobility", "show"}
"""Searches that no problem asks for, and pictures."""
FUNCTIONS = [
    function
    for space in (kl, kl.symbolic, kl.Tree, kl.Mechanism)
    for name in dir(space)
    if not name.startswith("_") and name not in SLOW
    if isinstance(function := getattr(space, name), type | FunctionType | MethodType)
]


def attempt(function, *arguments, **options):
    try:
        return function(*arguments, **options)
    except Exception:  # any call is tried
        return None


def results(function, given):
    """Yield what a function gives for up to four of the given values, or the entries of one, and for those with names that it knows."""
    parameters, values = inspect.signature(function).parameters, list(given.values())
    count = sum(one.default is one.empty for one in parameters.values())
    chosen = [(), *(one for one in values if isinstance(one, np.ndarray | list | tuple) and 1 < np.shape(one)[0] < 7)]
    for k in {1, count, count + 1} & {1, 2, 3, 4}:
        chosen += (permutations if k < 3 else combinations)(values, k)
    for option in CONVENTIONS if "convention" in parameters else ({},):
        for arguments in chosen:
            named = {name: given[name] for name in [*parameters][len(arguments) :] if name in given}
            for further in (named, {}) if named else ({},):
                yield attempt(function, *arguments, **further, **option)


def contents(result, values):
    """Yield a result, its entries, and what its attributes and its methods with at most one given value give."""
    found = [result]
    if type(result).__module__.startswith("kinlib"):
        for value in (attempt(getattr, result, name) for name in dir(result) if name[0] != "_" and name not in SLOW):
            arguments = [(), *((one,) for one in (*values, "standard", "modified"))] if callable(value) else []
            found += [value, *(attempt(value, *one) for one in arguments)]
    for one in found:
        yield from (one, getattr(one, "table", None), getattr(one, "rows", None))
        if isinstance(one, np.ndarray) and one.ndim:
            yield from (*one[:12], *one.T[:12])


def solving_call(problem):
    """Return the name of a function of which one call solves a problem; "" if none does."""
    answer = replace(problem.answer, printed=True) if hasattr(problem.answer, "printed") else problem.answer
    is_formula = hasattr(answer.value, "free_symbols")  # otherwise the functions of numbers give the same, and sooner
    values = list(problem.given.values())

    def solves(value):
        is_letter = isinstance(value, str) and len(value) == 1  # of an option, which names a joint as well
        return value is not None and not is_letter and all(answer.agrees(answer.read(value), answer.value))

    for function in FUNCTIONS if values else ():
        for result in results(function, problem.given) if is_formula or "symbolic" not in function.__module__ else ():
            if any(attempt(solves, value) for value in contents(result, values)):
                return function.__qualname__
    return ""


@pytest.mark.filterwarnings("ignore")
def test_few_problems_fall_to_one_call(monkeypatch):
    problems = [one for name in sheets() for one in find_sheet(name).problems]
    monkeypatch.setattr(reprlib, "repr", lambda _: "")  # nearly all calls fail, and nobody reads their messages
    with np.errstate(all="ignore"):
        falling = {one: call for one in problems if (call := solving_call(one.variant("ada")))}
    monkeypatch.undo()
    listed = {one.number: call for one, call in falling.items()}
    assert len(falling) <= MAX_PROBLEMS, listed
    assert sum(one.points for one in falling) <= MAX_POINTS, listed
