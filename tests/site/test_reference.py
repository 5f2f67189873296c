"""The reference of the site: what it shows of kinlib is explained, and by an example that runs."""

import doctest
import importlib
import inspect
import re
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "site"))

from kinsite import reference

MODULES = [importlib.import_module(name) for names in reference.MODULES.values() for name in names]
SHOWN = [(module, name, member) for module in MODULES for name, member in reference.members(module)]


def ran(member):
    """What the examples of a docstring run, as text; what is skipped is not run."""
    examples = doctest.DocTestParser().get_examples(inspect.getdoc(member) or "")
    return "".join(example.source for example in examples if not example.options.get(doctest.SKIP))


@pytest.mark.parametrize(("module", "name", "member"), SHOWN, ids=lambda part: getattr(part, "__name__", part))
def test_whatever_the_reference_shows_has_an_example_that_runs(module, name, member):
    """A function in its own docstring; a method there, or in that of its class. What only holds values needs none."""
    assert (inspect.getdoc(member) or "").strip(), f"{name} is not explained"
    if not inspect.isclass(member):
        assert re.search(rf"\b{name}\b", ran(member)), f"{module.__name__}.{name} has no example"
        return
    for method, kind, value in reference.attributes(member):
        if kind != "py:property":
            told = ran(value) or ran(member)
            assert re.search(rf"\.{method}\(", told), f"{module.__name__}.{name}.{method} has no example"


def test_a_function_without_an_example_is_noticed():
    def bare():
        """Say nothing."""

    def skipped():
        """Say it and do not do it.

        >>> skipped()  # doctest: +SKIP
        """

    assert not ran(bare)
    assert not ran(skipped)
