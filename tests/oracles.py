"""Who else says so: the implementations that we did not write, by whom each public function of kinlib has been compared.

A test names its oracle, and what it compares with it:

    @pytest.mark.oracle("pinocchio", Chain.fk, Chain.body_jacobian)

An oracle is a package. Where none computes what we compute, it is "printed: ...", with the document whose number or formula
the test holds us to, or "axiom: ...", with what must hold of the true answer and of no other.

The table is read from these lines, as they stand in the files of the tests; there is no other list. Whether they are true
is tried by tests/doubts.py: `python course.py test --oracles` tries them all, and prints the table.
"""

import ast
import inspect
import pkgutil
from collections import defaultdict
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

import kinlib

TESTS = Path(__file__).parent
SHOWN = [
    *("practice.bars", "practice.closed_forms", "practice.formulas"),
    *("view.linkage", "view.motions", "view.moves", "view.scene"),
]
"""Where what people look at and do computes: these modules count like those of the floors below, but for their drawings."""

SPOKEN = {"__str__", "__bool__"}
"""Methods that have no name of their own and say something all the same."""


class Witness(NamedTuple):
    """One comparison: what was compared, with whom, and in which test."""

    function: str
    oracle: str
    test: str


def public():
    """The dotted name of every public function, method and property; a class that reads what it is given is one too."""
    floors = [module.name for module in pkgutil.iter_modules(kinlib.__path__) if not module.ispkg]
    for module in map(import_module, (f"kinlib.{name}" for name in [*floors, *SHOWN] if name[0] != "_")):
        for name, thing in vars(module).items():
            if name.startswith(("_", "draw_")) or getattr(thing, "__module__", "") != module.__name__:
                continue
            if inspect.isfunction(thing):
                yield name_of(thing)
            elif inspect.isclass(thing):
                members = vars(thing)
                yield from [name_of(thing)] * ("__post_init__" in members)
                yield from (
                    f"{name_of(thing)}.{member}"
                    for member, value in members.items()
                    if (member[0] != "_" or member in SPOKEN) and code_of(value)
                )


def code_of(thing):
    """The function behind a function, a method or a property; None for what is only data."""
    behind = getattr(thing, "__func__", None) or getattr(thing, "fget", None) or getattr(thing, "func", None) or thing
    return behind if inspect.isfunction(behind) else None


def name_of(thing):
    """What the table calls a function, a method, a property or a class."""
    behind = code_of(thing) or thing
    return f"{behind.__module__}.{behind.__qualname__}"


def witnesses(folder=TESTS):
    """Every comparison that the tests name, in the order of their files."""
    for path in sorted(folder.glob("test_*.py")):
        if "mark.oracle(" in (source := path.read_text("utf-8")):
            yield from _named_in(ast.parse(source), path)


def _named_in(tree, path):
    names = {}
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom) and "kinlib" in ast.unparse(node):
            exec(compile(ast.Module([node], []), path, "exec"), names)  # what a test calls Chain is what it imports so
    for test in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
        for mark in test.decorator_list:
            if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "pytest.mark.oracle":
                oracle, *things = (eval(ast.unparse(argument), names) for argument in mark.args)
                yield from (Witness(name_of(thing), oracle, f"{path.name}::{test.name}") for thing in things)


def table():
    """The comparisons of each public function; without one, it has an empty list."""
    found = defaultdict(list, {name: [] for name in public()})
    for witness in witnesses():
        found[witness.function].append(witness)
    return dict(found)


def lines():
    """The table as text: a function, its oracles, and in which test each was asked."""
    found = table()
    for name, heard in found.items():
        yield name.removeprefix("kinlib.") + ("" if heard else "    NO WITNESS")
        for oracle in dict.fromkeys(witness.oracle for witness in heard):
            tests = [witness.test for witness in heard if witness.oracle == oracle]
            yield f"    {oracle}: {', '.join(tests)}"
    silent = sum(not heard for heard in found.values())
    asked = {witness.oracle.partition(":")[0] for heard in found.values() for witness in heard}
    count = sum(map(len, found.values()))
    yield f"{len(found)} functions, {count} comparisons with {', '.join(sorted(asked))}; {silent} without a witness"


if __name__ == "__main__":
    print("\n".join(lines()))
