"""Check that every comparison with an oracle can fail: a pytest plugin, loaded by `python course.py test --oracles`.

Each test marked `@pytest.mark.oracle(name, *functions)` must pass as it is, and must fail in two changed worlds:

- without the oracle, because then nothing is left to compare with;
- when a function under test is wrong by 1e-7, because then a comparison must find a difference.

Together these show that the test really uses the oracle that it names, compares with it tightly enough, and does not
compute the oracle's answer with the function under test. Each check runs in a forked process, so a change never outlives it.
"""

import builtins
import copy
import os
import re
import signal
import sys
import traceback
import warnings
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from functools import partial, wraps
from importlib import import_module
from inspect import isfunction, ismodule
from itertools import cycle

import numpy as np
import pytest
import sympy as sp
from hypothesis import Phase, settings
from oracle_table import TESTS, code_of, lines, name_of

PERTURBATION = 1e-7
"""Size of the error put into a function, absolute plus relative. Poses this far off still pass the check for rigidity."""

AXIS, SHIFT = np.array([0.0, 0, 1]), np.array([0.6, 0.8, 0])
MOTION = np.array([[0, -1, 0, 0.6], [1, 0, 0, 0.8], [0, 0, 0, 0], [0, 0, 0, 0]])
"""Direction in which poses and screw axes are moved: within the xy-plane, so that planar linkages stay planar."""

SCALES = cycle([1.0, 0.7, 1.2])
"""Factors for consecutive perturbations: moving all parts of an arm by the same amount would give the same arm."""

LIBRARY = {"kinlib", "misstep", "kincourse"}
"""The packages whose functions are checked."""

TIMEOUT_S = 120
"""Time limit of one check, in seconds: a perturbed function may keep a search from ending."""


def pytest_collection_modifyitems(config, items):
    """Select only the tests that name an oracle."""
    marked = [item for item in items if item.get_closest_marker("oracle")]
    config.hook.pytest_deselected(items=[item for item in items if item not in marked])
    items[:] = marked


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    yield
    check(item)


def pytest_terminal_summary(terminalreporter):
    terminalreporter.section("which oracle verifies which function")
    terminalreporter.write("\n".join(["", *lines(), ""]))


# --- one check ---


def check(item):
    """Fail a passed test if it also passes without its oracle, or with a perturbed function under test."""
    for mark in item.iter_markers("oracle"):
        oracle, *functions = mark.args
        if ":" not in oracle and not fails(item, BaseException, partial(remove, oracle)):
            pytest.fail(f"{item.name} passes without {oracle}, which it names as its oracle.", pytrace=False)
        for function in functions:
            perturb_it = partial(perturb, function)
            if not fails(item, (AssertionError, pytest.fail.Exception), perturb_it):
                message = f"{item.name} finds no difference when {name_of(function)} is wrong by {PERTURBATION}."
                pytest.fail(message, pytrace=False)


def fails(item, expected, change):
    """Return whether a test raises one of the expected exceptions after a change, in a forked process."""
    with warnings.catch_warnings(action="ignore"):  # a fork has none of the parent's threads; the test needs none
        child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    signal.alarm(TIMEOUT_S)
    code = 1
    try:
        change()
        if drawn := getattr(item.obj, "_hypothesis_internal_use_settings", None):
            quick = settings(drawn, database=None, phases=[Phase.explicit, Phase.generate], print_blob=False)
            item.obj._hypothesis_internal_use_settings = quick
        item.runtest()
    except expected:
        code = 0
    except Exception:
        traceback.print_exc()  # the change was noticed, but not by the comparison
    finally:
        os._exit(code)


# --- without an oracle ---


def remove(package):
    """Make a package unavailable to the tests, but not to the library."""
    original = builtins.__import__

    def without(name, scope=None, *rest, **more):
        if name.partition(".")[0] == package and (scope is None or of_tests(scope)):
            raise ImportError(f"{package} is removed")
        return original(name, scope, *rest, **more)

    def skipped(name, *rest, **more):
        return pytest.skip(f"{package} is removed") if name.partition(".")[0] == package else import_module(name)

    builtins.__import__, pytest.importorskip = without, skipped
    for scope in [vars(module) for module in list(sys.modules.values()) if of_tests(vars(module))]:
        for name, value in list(scope.items()):
            home = value.__name__ if ismodule(value) else getattr(value, "__module__", None)
            if str(home).partition(".")[0] == package:
                scope[name] = None


def of_tests(scope):
    return str(scope.get("__file__")).startswith(f"{TESTS}{os.sep}")


# --- with a wrong function ---


def perturb(thing):
    """Make a function, method, property or class return slightly wrong values, wherever it is used."""
    original = code_of(thing) or thing.__post_init__
    path, _, name = f"{original.__module__}.{original.__qualname__}".rpartition(".")
    owner = sys.modules.get(path) or getattr(import_module(original.__module__), path.rpartition(".")[2])

    @wraps(original)
    def wrong_function(*args, **kwargs):
        value = original(*args, **kwargs)
        return perturb_fields(args[0]) if value is None else perturbed(value)  # no result: the object it has changed

    if not ismodule(owner):
        kind = type(vars(owner)[name])
        kind = (
            kind
            if kind in (classmethod, staticmethod)
            else (lambda f: f)
            if code_of(vars(owner)[name]) is vars(owner)[name]
            else property
        )
        setattr(owner, name, kind(wrong_function))
        return
    for module in list(sys.modules.values()):
        if of_tests(vars(module)) or getattr(module, "__name__", "").partition(".")[0] in LIBRARY:
            for other, value in list(vars(module).items()):
                if value is original:
                    setattr(module, other, wrong_function)


def perturb_fields(thing):
    """Change the fields of a dataclass, but not its parent: its numbers; without numbers, its booleans; without either, its text."""
    values = {field.name: getattr(thing, field.name, None) for field in fields(thing) if field.name != "parent"}
    texts = {
        name
        for name, x in values.items()
        if x is None or isinstance(next(iter(x.values()), "") if isinstance(x, dict) else x, str)
    }
    numbers = {name for name in values if name not in texts and not isinstance(values[name], bool)}
    for name in numbers or values.keys() - texts or texts:
        object.__setattr__(thing, name, perturbed(values[name], words=not values.keys() - texts))


def perturbed(x, words=True):  # noqa: PLR0911 - one line for each type
    """Return a slightly wrong copy: floats by PERTURBATION, counts by one, booleans negated, text by its numbers or a letter."""
    if words and isinstance(x, str):
        return perturbed_text(x)
    if isinstance(x, sp.MatrixBase):
        return x.applyfunc(perturbed)
    if isinstance(x, sp.Expr):
        return x + sp.Rational(1, 10**7)
    if isinstance(x, bool | int | float | complex | np.ndarray | np.generic):
        wrong = perturbed_number(np.asarray(x))[()]
        return type(x)(wrong) if isinstance(x, bool | int | float | complex) else wrong
    if isinstance(x, dict):
        return {key: perturbed(value, words) for key, value in x.items()}
    if isinstance(x, tuple) and hasattr(x, "_fields"):
        return type(x)(*(perturbed(value, words) for value in x))
    if isinstance(x, list | tuple | Iterator):
        return (list if isinstance(x, Iterator) else type(x))(perturbed(value, words) for value in x)
    if isinstance(x, Exception):
        return type(x)(perturbed(str(x)))
    if is_dataclass(x):
        x = copy.copy(x)
        for cached in set(getattr(x, "__dict__", {})) - {field.name for field in fields(x)}:
            del x.__dict__[cached]
        perturb_fields(x)
    elif hasattr(x, "__dict__") and not callable(x):
        x = copy.copy(x)
        vars(x).update({name: perturbed(value, words=False) for name, value in vars(x).items()})
    elif isfunction(x):
        return lambda *args, **kwargs: perturbed(x(*args, **kwargs))
    return x


def perturbed_number(x):
    if x.dtype.kind not in "biufc":
        return x
    if x.dtype.kind in "biu":
        return ~x if x.dtype == bool else x - 1  # one less is still a valid index
    # An invalid pose or screw axis would be refused before it is compared, so these are rotated and translated instead.
    off = PERTURBATION * next(SCALES)
    if x.shape[-2:] in {(3, 3), (4, 4)}:
        R = x[..., :3, :3]
        if np.allclose(R @ np.swapaxes(R, -1, -2), np.eye(3)):
            return x + off * MOTION[: x.shape[-1], : x.shape[-1]] @ x
    if x.shape[-1:] == (6,):
        omega, v = x[..., :3], x[..., 3:]
        if np.allclose(np.linalg.norm(np.where(omega.any(axis=-1, keepdims=True), omega, v), axis=-1), 1):
            return x + off * np.concatenate(
                [np.cross(AXIS, omega), np.cross(AXIS, v) + np.cross(SHIFT, omega)], axis=-1
            )
    return x + off * (1 + np.abs(np.where(np.isfinite(x), x, 0)))


def perturbed_text(text):
    number = r'(?<![\w.])(?<!version=")(?<!name=")-?\d+(\.\d+)?(?![\w.])'
    other = re.sub(number, lambda match: repr(float(perturbed(float(match[0])))), text)
    return other if other != text else f"{text}?"
