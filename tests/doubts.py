"""Whether a witness can be believed: every test that names an oracle is doubted, once for each thing that it claims.

It has to fail without its oracle; and it has to find a difference when the function that it is about errs by a ten-millionth.
So it asks whom it names, compares what it says, and no part of the oracle's answer comes from the function itself.
Each doubt is raised in a process of its own, a fork, so that no lie outlives it.
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
from functools import wraps
from importlib import import_module
from inspect import isfunction, ismodule
from itertools import cycle

import numpy as np
import pytest
import sympy as sp
from hypothesis import Phase, settings
from oracles import TESTS, code_of, lines, name_of

OFF = 1e-7
"""By how much a lie is off, and a little more where the truth is large. Poses off by so little still pass for rigid."""

AXIS, SHIFT = np.array([0.0, 0, 1]), np.array([0.6, 0.8, 0])
MOTION = np.array([[0, -1, 0, 0.6], [1, 0, 0, 0.8], [0, 0, 0, 0], [0, 0, 0, 0]])
"""How poses and screw axes are moved: within the plane, where planar linkages stay planar."""

SIZES = cycle([1.0, 0.7, 1.2])
"""Of one lie and the next: an arm of which all parts are moved alike would be the same arm."""

PATIENCE = 120
"""Seconds after which a doubt is given up: a lie may keep a search going for ever."""


def pytest_collection_modifyitems(config, items):
    """Run what names an oracle, and nothing else."""
    named = [item for item in items if item.get_closest_marker("oracle")]
    config.hook.pytest_deselected(items=[item for item in items if item not in named])
    items[:] = named


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    yield
    doubt(item)


def pytest_terminal_summary(terminalreporter):
    terminalreporter.section("who was asked about what")
    terminalreporter.write("\n".join(["", *lines(), ""]))


# --- a doubt ---


def doubt(item):
    """Fail a test that passed, if it passes without its oracle too, or while a function that it is about errs."""
    for mark in item.iter_markers("oracle"):
        oracle, *things = mark.args
        if ":" not in oracle and not fails(item, BaseException, lambda oracle=oracle: remove(oracle)):
            pytest.fail(f"{item.name} passes without {oracle}, whom it names as its oracle.", pytrace=False)
        for thing in things:
            if not fails(item, (AssertionError, pytest.fail.Exception), lambda thing=thing: lie(thing)):
                pytest.fail(f"{item.name} finds no difference when {name_of(thing)} errs by {OFF}.", pytrace=False)


def fails(item, expected, change):
    """Whether a test raises what is expected, in a world that is changed."""
    with warnings.catch_warnings(action="ignore"):  # threads stay behind in a fork; none is needed there
        child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    signal.alarm(PATIENCE)
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
        traceback.print_exc()  # it was noticed, but not by the oracle
    finally:
        os._exit(code)


# --- a world without an oracle ---


def remove(package):
    """Take a package from the tests: from their names, and from what they import; kinlib itself keeps it."""
    honest = builtins.__import__

    def without(name, scope=None, *rest, **more):
        if name.partition(".")[0] == package and (scope is None or of_tests(scope)):
            raise ImportError(f"{package} is not there")
        return honest(name, scope, *rest, **more)

    def skipped(name, *rest, **more):
        return pytest.skip(f"{package} is not there") if name.partition(".")[0] == package else import_module(name)

    builtins.__import__, pytest.importorskip = without, skipped
    for scope in [vars(module) for module in list(sys.modules.values()) if of_tests(vars(module))]:
        for name, value in list(scope.items()):
            home = value.__name__ if ismodule(value) else getattr(value, "__module__", None)
            if str(home).partition(".")[0] == package:
                scope[name] = None


def of_tests(scope):
    return str(scope.get("__file__")).startswith(f"{TESTS}{os.sep}")


# --- a world in which a function errs ---


def lie(thing):
    """Let a function, a method, a property or a class give what is a little wrong, wherever it is asked."""
    honest = code_of(thing) or thing.__post_init__
    path, _, name = f"{honest.__module__}.{honest.__qualname__}".rpartition(".")
    owner = sys.modules.get(path) or getattr(import_module(honest.__module__), path.rpartition(".")[2])

    @wraps(honest)
    def liar(*args, **kwargs):
        told = honest(*args, **kwargs)
        return spoil(args[0]) if told is None else wrong(told)  # what it gives, or else what it has changed

    if not ismodule(owner):
        kind = type(vars(owner)[name])
        kind = (
            kind
            if kind in (classmethod, staticmethod)
            else (lambda f: f)
            if code_of(vars(owner)[name]) is vars(owner)[name]
            else property
        )
        setattr(owner, name, kind(liar))
        return
    for module in list(sys.modules.values()):
        if of_tests(vars(module)) or getattr(module, "__name__", "").partition(".")[0] == "kinlib":
            for other, value in list(vars(module).items()):
                if value is honest:
                    setattr(module, other, liar)


def spoil(thing):
    """Put wrong numbers into the fields of a dataclass; if it has none, no for yes; and if it has words only, other words."""
    told = {field.name: getattr(thing, field.name, None) for field in fields(thing) if field.name != "inside"}
    said = {
        name
        for name, x in told.items()
        if x is None or isinstance(next(iter(x.values()), "") if isinstance(x, dict) else x, str)
    }
    counted = {name for name in told if name not in said and not isinstance(told[name], bool)}
    for name in counted or told.keys() - said or said:
        object.__setattr__(thing, name, wrong(told[name], words=not told.keys() - said))


def wrong(x, words=True):  # noqa: PLR0911 - one line a kind
    """The same, a little off: numbers by OFF, counts by one, no for yes; and words, by the numbers in them or by a letter."""
    if words and isinstance(x, str):
        return misprinted(x)
    if isinstance(x, sp.MatrixBase):
        return x.applyfunc(wrong)
    if isinstance(x, sp.Expr):
        return x + sp.Rational(1, 10**7)
    if isinstance(x, bool | int | float | complex | np.ndarray | np.generic):
        off = wrong_number(np.asarray(x))[()]
        return type(x)(off) if isinstance(x, bool | int | float | complex) else off
    if isinstance(x, dict):
        return {key: wrong(value, words) for key, value in x.items()}
    if isinstance(x, tuple) and hasattr(x, "_fields"):
        return type(x)(*(wrong(value, words) for value in x))
    if isinstance(x, list | tuple | Iterator):
        return (list if isinstance(x, Iterator) else type(x))(wrong(value, words) for value in x)
    if isinstance(x, Exception):
        return type(x)(wrong(str(x)))
    if is_dataclass(x):
        x = copy.copy(x)
        for cached in set(getattr(x, "__dict__", {})) - {field.name for field in fields(x)}:
            del x.__dict__[cached]
        spoil(x)
    elif hasattr(x, "__dict__") and not callable(x):
        x = copy.copy(x)
        vars(x).update({name: wrong(value, words=False) for name, value in vars(x).items()})
    elif isfunction(x):
        return lambda *args, **kwargs: wrong(x(*args, **kwargs))
    return x


def wrong_number(x):
    if x.dtype.kind not in "biufc":
        return x
    if x.dtype.kind in "biu":
        return ~x if x.dtype == bool else x - 1  # one less is an index too
    # Poses and screw axes that are none would be refused, and never compared: these are turned and shifted.
    off = OFF * next(SIZES)
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


def misprinted(text):
    number = r'(?<![\w.])(?<!version=")(?<!name=")-?\d+(\.\d+)?(?![\w.])'
    other = re.sub(number, lambda found: repr(float(wrong(float(found[0])))), text)
    return other if other != text else f"{text}?"
