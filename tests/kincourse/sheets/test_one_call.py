"""A problem is not its answer: hardly any falls to one call of a public function of kinlib on what is given."""

import inspect
import reprlib
from dataclasses import replace
from itertools import combinations, permutations
from types import FunctionType, ModuleType

import numpy as np
import pytest

import kinlib as kl
from kincourse import find_sheet, sheets

MAX_PROBLEMS, MAX_POINTS = 6, 15
MAX_ROWS = 12
CONVENTIONS = ({"convention": "standard"}, {"convention": "modified"})
SLOW = {"assembly_modes", "finite_mobility", "mobility", "draw", "show"}
"""Searches that no problem asks for, and pictures."""


def public_callables():
    """The public functions and classes of kinlib and of its public modules, and the class methods that construct."""
    modules = [value for value in vars(kl).values() if isinstance(value, ModuleType) and "kinlib" in value.__name__]
    found = []
    for space in (kl, *modules):
        for name in getattr(space, "__all__", [one for one in vars(space) if not one.startswith("_")]):
            value = getattr(space, name)
            if inspect.isclass(value):
                found += [getattr(value, one) for one, kind in vars(value).items() if isinstance(kind, classmethod)]
            if isinstance(value, FunctionType | type) and not name.startswith(
                ("draw", "show", "place", "explore", "play")
            ):
                found.append(value)
    return [one for one in dict.fromkeys(found) if "robots" not in one.__module__]


CALLABLES = public_callables()


def attempt(function, *arguments, **options):
    try:
        return function(*arguments, **options)
    except Exception:  # any call is tried
        return None


def calls(function, given):
    """Yield what a function gives for some of the given values: alone, unpacked, together, and by their names."""
    try:
        parameters = inspect.signature(function).parameters
    except (TypeError, ValueError):
        return
    values = list(given.values())
    if "kinlib.dh" in function.__module__:  # no table of a machine has as many rows as a recorded path
        values = [value for value in values if not isinstance(value, np.ndarray) or value.size <= 6 * MAX_ROWS]
    named = {name: given[name] for name in parameters if name in given}
    count = sum(one.default is one.empty and one.kind == one.POSITIONAL_OR_KEYWORD for one in parameters.values())
    chosen = [(value,) for value in values]
    chosen += [
        tuple(value)
        for value in values
        if isinstance(value, np.ndarray | list | tuple)
        and not np.isscalar(value)
        and 1 < (attempt(len, value) or 0) < 7
    ]
    chosen += [
        more for k in {count, count + 1} & {2, 3, 4} for more in (permutations if k == 2 else combinations)(values, k)
    ]
    for option in CONVENTIONS if "convention" in parameters else ({},):
        for arguments in chosen:
            yield attempt(function, *arguments, **option)
            if rest := {name: value for name, value in named.items() if not any(value is one for one in arguments)}:
                yield attempt(function, *arguments, **option, **rest)
        if named:
            yield attempt(function, **named, **option)


def seen_in(result, given, depth=1):
    """Yield a result, its entries, and what its attributes and its methods with at most one given value give."""
    if result is None:
        return
    yield result
    if isinstance(result, np.ndarray | list | tuple):
        if getattr(result, "ndim", 1):
            yield from result[:12]
        if isinstance(result, np.ndarray) and result.ndim == 2:
            yield from result.T
    elif depth and type(result).__module__.startswith("kinlib"):
        for name in dir(result):
            if name.startswith("_") or name in SLOW:
                continue
            value = attempt(getattr, result, name)
            if not callable(value):
                yield from seen_in(value, given, 0)
                continue
            for arguments in ((), *((one,) for one in (*given.values(), "standard", "modified"))):
                made = attempt(value, *arguments)
                yield from seen_in(made, given, 0)
                yield getattr(made, "rows", None)


def solving_call(problem):
    """Return the name of a function whose one call, also on a chain or a table of what is given, solves a problem; "" if none does."""
    answer = replace(problem.answer, printed=True) if hasattr(problem.answer, "printed") else problem.answer
    is_formula = hasattr(answer.value, "free_symbols")  # otherwise the functions of numbers give the same, and sooner
    functions = [one for one in CALLABLES if is_formula or "symbolic" not in one.__module__]
    for function in functions if problem.given else ():
        for result in calls(function, problem.given):
            made = [result]
            if isinstance(result, kl.Chain | kl.DHTable):
                made += [
                    attempt(one, result, **option)
                    for one in (kl.assign_frames, kl.equivalent)
                    for option in CONVENTIONS
                ]
            for value in (value for one in made for value in seen_in(one, problem.given)):
                if isinstance(value, str) and len(value) == 1:
                    continue  # the letter of an option, which is the name of a joint as well
                if attempt(lambda value=value: all(answer.agrees(answer.read(value), answer.value))):
                    return function.__qualname__
    return ""


@pytest.mark.filterwarnings("ignore")
def test_few_problems_fall_to_one_call(monkeypatch):
    problems = [one for name in sheets() for one in find_sheet(name).problems]
    monkeypatch.setattr(reprlib.Repr, "repr", lambda *_: "")  # nearly all calls fail, and nobody reads their messages
    with np.errstate(all="ignore"):
        falling = {one: call for one in problems if (call := solving_call(one.variant("ada")))}
    listed = {one.number: call for one, call in falling.items()}
    assert len(falling) <= MAX_PROBLEMS, listed
    assert sum(one.points for one in falling) <= MAX_POINTS, listed
