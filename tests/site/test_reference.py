"""The reference of the site: everything that it lists has a docstring with an example that runs."""

import doctest
import importlib
import inspect
import re

from kinsite.generated import reference

MODULES = [importlib.import_module(name) for names in reference.MODULES.values() for name in names]
SHOWN = [(module, name, member) for module in MODULES for name, member in reference.members(module)]


def executed(member):
    """Collect the source of the examples in a docstring, without those that are skipped."""
    examples = doctest.DocTestParser().get_examples(inspect.getdoc(member) or "")
    return "".join(example.source for example in examples if not example.options.get(doctest.SKIP))


def test_everything_in_the_reference_has_an_example_that_runs():
    """A function has it in its own docstring, a method there or in that of its class. Properties need none."""
    assert len(SHOWN) > 50
    missing = []
    for module, name, member in SHOWN:
        if not inspect.isclass(member):
            missing += [] if re.search(rf"\b{name}\b", executed(member)) else [f"{module.__name__}.{name}"]
            continue
        assert (inspect.getdoc(member) or "").strip(), f"{name} has no docstring"
        for method, kind, value in reference.attributes(member):
            examples = executed(value) or executed(member)
            if kind != "py:property" and not re.search(rf"\.{method}\(", examples):
                missing.append(f"{module.__name__}.{name}.{method}")
    assert not missing, f"{len(missing)} have no example: {missing}"
