"""List which independent implementation (oracle) verifies each public function of kinlib that computes.

A test names its oracle and the functions that it compares with it:

    @pytest.mark.oracle("pinocchio", Chain.fk, Chain.body_jacobian)

An oracle is a package. Where no package computes the same, it is "printed: ...", with the document whose number or formula
the test compares with, or "axiom: ...", with a property that only the right answer has.

The table is read from these markers in the source of the tests, so there is no second list to maintain.
check_oracles.py checks that each marker is true: `python course.py test --oracles` runs it and prints the table.
"""

import ast
import inspect
import re
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

import kinlib

TESTS = Path(__file__).resolve().parents[2] / "tests"


class Comparison(NamedTuple):
    """One comparison: the function, the oracle, and the test that compares them."""

    function: str
    oracle: str
    test: str


def public():
    """Yield the dotted name of each function, method and property that computes, of those that a user reaches by `kl.`."""
    things = [getattr(kinlib, name) for name in dir(kinlib) if name != "show"]  # what it draws is in kinlib.view
    things += [getattr(kinlib.symbolic, name) for name in kinlib.symbolic.__all__]
    for module in (kinlib.linkages, kinlib.robots):
        own = [one for name, one in vars(module).items() if name[0] != "_"]
        things += [one for one in own if getattr(one, "__module__", "") == module.__name__]
    for thing in dict.fromkeys(one for one in things if getattr(one, "__module__", "").startswith("kinlib.")):
        members = (
            [value for name, value in vars(thing).items() if name[0] != "_"] if inspect.isclass(thing) else [thing]
        )
        yield from (name_of(one) for one in members if computes(one))


def computes(thing):
    """Whether a function, method or property returns more than a text."""
    code = code_of(thing)
    return code is not None and code.__annotations__.get("return") not in (str, None, "str", "None")


def code_of(thing):
    """Return the function that a function, method or property runs; None for data."""
    behind = getattr(thing, "__func__", None) or getattr(thing, "fget", None) or getattr(thing, "func", None) or thing
    return behind if inspect.isfunction(behind) else None


def name_of(thing):
    """Return the dotted name of a function, method, property or class."""
    behind = code_of(thing) or thing
    return f"{behind.__module__}.{behind.__qualname__}"


def comparisons(folder=TESTS):
    """Yield every comparison that the tests name, in the order of their files."""
    for path in sorted(folder.rglob("test_*.py")):
        if "mark.oracle(" in (source := path.read_text("utf-8")):
            yield from _comparisons_in(ast.parse(source), path, path.relative_to(folder).as_posix())


def _comparisons_in(tree, path, file):
    names = {}
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom) and re.search("kinlib|misstep|kincourse", ast.unparse(node)):
            exec(
                compile(ast.Module([node], []), path, "exec"), names
            )  # so that a name means what the test imports by it
    for test in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
        for mark in test.decorator_list:
            if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "pytest.mark.oracle":
                oracle, *things = (eval(ast.unparse(argument), names) for argument in mark.args)
                yield from (Comparison(name_of(thing), oracle, f"{file}::{test.name}") for thing in things)


def table():
    """Return the comparisons of each public function; the list is empty if there is none."""
    rows = defaultdict(list, {name: [] for name in public()})
    for comparison in comparisons():
        rows[comparison.function].append(comparison)
    return dict(rows)


def lines():
    """Yield the table as text: each function, its oracles, and the tests that compare them."""
    rows = table()
    for name, comparisons in rows.items():
        yield name.removeprefix("kinlib.") + ("" if comparisons else "    NO ORACLE")
        for oracle in dict.fromkeys(comparison.oracle for comparison in comparisons):
            tests = [comparison.test for comparison in comparisons if comparison.oracle == oracle]
            yield f"    {oracle}: {', '.join(tests)}"
    missing = sum(not comparisons for comparisons in rows.values())
    oracles = {comparison.oracle.partition(":")[0] for comparisons in rows.values() for comparison in comparisons}
    count = sum(map(len, rows.values()))
    yield f"{len(rows)} functions, {count} comparisons with {', '.join(sorted(oracles))}; {missing} without an oracle"


if __name__ == "__main__":
    print("\n".join(lines()))
