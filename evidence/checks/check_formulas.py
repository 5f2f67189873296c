"""Check that the assertion of each numbered formula of a lecture can fail: change the formula, and it must.

    python evidence/checks/check_formulas.py notebooks/03_poe_space.ipynb ...

An assertion with the comment `# (7)` claims that formula (7) holds. This tool plants changes in the code of the formula, one at a
time: the sign of a term, a factor of two, the order of two factors, sine for cosine, the exponent of a power. Then it runs the
cells again. A change that the assertion does not notice is reported.

The code of the formula is the asserted expression, and all code whose result reaches only one side of it. Code whose result
reaches both sides defines the case in which the formula is tried, so changing it proves nothing.

A change that leaves the formula true, because two factors commute for example, is listed in equivalent_changes.toml with its
reason.
"""

import ast
import builtins
import contextlib
import copy
import io
import signal
import sys
import tomllib
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import nbformat
import numpy as np
from prose_numbers import checked, named

EQUIVALENT = Path(__file__).with_name("equivalent_changes.toml")

TIME_LIMIT_S = 60
"""Time for the cells with one change, in seconds: a change may keep a search from ending."""

SKIN = {"abs", "max", "norm", "simplify", "expand", "round", "all", "any", "applyfunc", "sum", "trigsimp", "ravel"}
"""Functions and methods around a difference that is asserted to be 0."""

COMPARISONS = {"allclose", "isclose", "array_equal"}
SWAPPED = {"sin": "cos", "cos": "sin"}


@dataclass(frozen=True)
class Change:
    """One planted change: the numbers of the formula, what the changed code was and is, and the cells with the change from `first` on."""

    formulas: list[str]
    before: str
    after: str
    first: int
    cells: list[str]


@dataclass(frozen=True, eq=False)
class Statement:
    """A statement or the head of a loop, with the names that it defines and those that it uses."""

    cell: int
    node: ast.AST
    defines: frozenset[str]
    uses: frozenset[str]


class Lecture:
    """The code of a lecture, and its namespaces before each cell."""

    def __init__(self, path: Path) -> None:
        cells = nbformat.read(path, as_version=4).cells
        self.numbers = set().union(*(named(cell.source) for cell in cells if cell.cell_type == "markdown"))
        self.sources = [cell.source for cell in cells if cell.cell_type == "code"]
        self.trees = [ast.parse(source) for source in self.sources]
        self.statements = [
            statement for place, tree in enumerate(self.trees) for statement in statements_of(place, tree)
        ]
        self.namespaces: list[dict[str, object]] = []

    def run(self) -> None:
        """Run all cells; each is later run again from a copy of the names before it."""
        names: dict[str, object] = {"__name__": "__main__", "display": lambda *_: None, "__builtins__": builtins}
        for source in self.sources:
            self.namespaces.append(dict(names))
            execute(source, names)

    def changes(self) -> Iterator[Change]:
        """Yield every change of every formula."""
        for place, tree in enumerate(self.trees):
            for node in ast.walk(tree):
                if isinstance(node, ast.Assert):
                    numbers = list(checked_by(node, self.sources[place]))
                    pieces = self.code_of(node, place) if numbers else []
                    found = [change for piece in pieces for change in self.changes_in(*piece, place, node, numbers)]
                    if not found:  # no arithmetic: the sides themselves are the formula
                        found = [
                            change
                            for side in (self.sides(node.test, place) if numbers else ())
                            for change in self.changes_in(side, place, place, node, numbers, changes=changes_of_side)
                        ]
                    yield from found

    def changes_in(
        self,
        root: ast.AST,
        cell: int,
        place: int,
        claim: ast.Assert,
        numbers: list[str],
        *,
        changes: Callable[[ast.AST], Iterator[ast.AST]] | None = None,
    ) -> Iterator[Change]:
        for node in [root] if changes else list(ast.walk(root)):
            for changed in (changes or changes_of)(node):
                if ast.dump(changed) == ast.dump(node):
                    continue  # W @ W in the other order
                before = ast.unparse(node)
                original = copy.copy(node.__dict__)
                node.__dict__.update(changed.__dict__)
                kind, node.__class__ = node.__class__, changed.__class__
                cells = [ast.unparse(tree) for tree in self.trees[cell:place]]
                cells.append(ast.unparse(up_to(self.trees[place], claim)))
                after = ast.unparse(node)
                node.__class__ = kind
                node.__dict__.clear()
                node.__dict__.update(original)
                yield Change(numbers, before, after, cell, cells)

    def code_of(self, claim: ast.Assert, place: int) -> list[tuple[ast.AST, int]]:
        """Return the code of an asserted formula: each piece with its cell."""
        sides = self.sides(claim.test, place)
        reached = [self.reaching(side, place) for side in sides]
        everywhere = set.intersection(*reached) if len(reached) > 1 else set()
        one_sided = sorted(set().union(*reached) - everywhere, key=lambda found: (found.cell, found.node.lineno))
        return [(side, place) for side in sides] + [
            (statement.node, statement.cell)
            for statement in one_sided
            if not any(side in ast.walk(statement.node) for side in sides)
        ]

    def sides(self, test: ast.expr, place: int) -> list[ast.expr]:
        """Return the sides of an assertion."""
        inner = None  # what the sides are the sides of
        if isinstance(test, ast.Call) and name_of(test.func) in COMPARISONS:
            return test.args[:2]
        if isinstance(test, ast.BinOp) and isinstance(test.op, ast.Sub):
            return [test.left, test.right]
        if isinstance(test, ast.Compare):
            sides = [test.left, *test.comparators]
            varying = [side for side in sides if names_in(side)]
            if len(varying) > 1:
                return sides
            inner = varying[0] if varying else None
        elif isinstance(test, ast.UnaryOp):
            inner = test.operand
        elif isinstance(test, ast.Call) and name_of(test.func) in SKIN:
            is_method = isinstance(test.func, ast.Attribute) and not is_module(test.func.value)
            inner = test.func.value if is_method else test.args[0]
        elif isinstance(test, ast.Name):
            found = [s.node for s in self.defining(test.id, place) if isinstance(s.node, ast.Assign)]
            inner = found[0].value if len(found) == 1 else None
        return [test] if inner is None else self.sides(inner, place)

    def defining(self, name: str, place: int) -> list[Statement]:
        """Return the statements that define a name: those of this cell, or of the nearest cell before."""
        found = [s for s in self.statements if name in s.defines and s.cell <= place]
        return [s for s in found if s.cell == found[-1].cell]

    def reaching(self, side: ast.expr, place: int) -> set[Statement]:
        """Return the statements whose results reach an expression."""
        found: set[Statement] = set()
        open_names = [(name, place) for name in names_in(side)]
        while open_names:
            name, at = open_names.pop()
            for statement in self.defining(name, at):
                if statement not in found:
                    found.add(statement)
                    open_names += [(used, statement.cell) for used in statement.uses]
        return found

    def notices(self, change: Change) -> bool:
        """Return whether the cells with a change fail."""
        names = dict(self.namespaces[change.first])
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, TIME_LIMIT_S)
        try:
            for source in change.cells:
                execute(source, names)
        except (Exception, KeyboardInterrupt):  # any error stops the reader; the alarm is a KeyboardInterrupt
            return True
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        return False


def execute(source: str, names: dict[str, object]) -> None:
    # a lecture also changes how arrays are printed, which the rest of the process must not see
    with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(), np.printoptions():
        warnings.simplefilter("ignore")
        exec(source, names)


def statements_of(cell: int, tree: ast.AST) -> Iterator[Statement]:
    """Yield the simple statements of a cell, those in its loops included; a function is one statement."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.For):
            yield Statement(cell, node.iter, frozenset(names_in(node.target)), frozenset(names_in(node.iter)))
            yield from statements_of(cell, ast.Module([*node.body, *node.orelse], []))
        elif isinstance(node, ast.If | ast.With | ast.Try | ast.While):
            yield from statements_of(
                cell, ast.Module([n for n in ast.iter_child_nodes(node) if isinstance(n, ast.stmt)], [])
            )
        elif isinstance(node, ast.FunctionDef):
            own = {arg.arg for arg in ast.walk(node) if isinstance(arg, ast.arg)}
            own |= {
                part.id for part in ast.walk(node) if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)
            }
            yield Statement(cell, node, frozenset([node.name]), frozenset(names_in(node)) - own)
        elif (several := pairs_of(node)) is not None:
            for target, value in several:
                yield Statement(cell, value, frozenset(names_in(target)), frozenset(names_in(value)))
        elif isinstance(node, ast.Assign | ast.AugAssign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            defined = frozenset(name for target in targets for name in names_in(target))
            yield Statement(cell, node, defined, frozenset(names_in(node)))
        elif (
            isinstance(node, ast.Expr)
            and isinstance(node.value, ast.Call)
            and isinstance(node.value.func, ast.Attribute)
        ):
            called = node.value.func.value  # screws.append(...) defines screws further
            if isinstance(called, ast.Name):
                yield Statement(cell, node, frozenset([called.id]), frozenset(names_in(node.value)))


def pairs_of(node: ast.AST) -> list[tuple[ast.expr, ast.expr]] | None:
    """Return the targets and values of `a, b = c, d`, because each value reaches one name only."""
    if isinstance(node, ast.Assign) and len(node.targets) == 1:
        target, value = node.targets[0], node.value
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple) and len(target.elts) == len(value.elts):
            return list(zip(target.elts, value.elts, strict=True))
    return None


def names_in(node: ast.AST) -> list[str]:
    return [part.id for part in ast.walk(node) if isinstance(part, ast.Name)]


def name_of(function: ast.expr) -> str:
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def is_module(node: ast.expr) -> bool:
    return isinstance(node, ast.Attribute) or (isinstance(node, ast.Name) and node.id in {"np", "sp", "kl"})


def checked_by(claim: ast.Assert, source: str) -> Iterator[str]:
    lines = source.splitlines()[claim.lineno - 1 : claim.end_lineno]
    yield from checked("\n".join(line.removeprefix(" " * claim.col_offset) for line in lines))


def up_to(tree: ast.Module, claim: ast.Assert) -> ast.Module:
    """Return a cell without what comes after an assertion, and without the other assertions."""
    body = next(index for index, node in enumerate(tree.body) if claim in ast.walk(node))
    return ast.Module(tree.body[: body + 1], [])


def changes_of(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the expressions that a changed formula could have in the place of a part. Numbers alone are a case, no formula."""
    if {"np", "sp", "kl"}.issuperset(names_in(node)):
        return
    if isinstance(node, ast.BinOp):
        if isinstance(node.op, ast.Add | ast.Sub):
            opposite = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
            yield ast.BinOp(node.left, opposite, node.right)
        elif isinstance(node.op, ast.MatMult):
            yield ast.BinOp(node.right, ast.MatMult(), node.left)
        elif isinstance(node.op, ast.Mult | ast.Div):
            yield ast.BinOp(ast.Constant(2), ast.Mult(), ast.BinOp(node.left, node.op, node.right))
        elif isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant):
            yield ast.BinOp(node.left, ast.Pow(), ast.Constant(node.right.value + 1))
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield ast.BinOp(ast.Constant(1), ast.Mult(), node.operand)
    elif isinstance(node, ast.Call):
        name = name_of(node.func)
        if name == "cross" and len(node.args) == 2:
            yield ast.Call(node.func, node.args[::-1], node.keywords)
        elif name == "cross" and isinstance(node.func, ast.Attribute):
            yield ast.Call(ast.Attribute(node.args[0], "cross", ast.Load()), [node.func.value], [])
        elif name in SWAPPED and isinstance(node.func, ast.Attribute):
            yield ast.Call(ast.Attribute(node.func.value, SWAPPED[name], ast.Load()), node.args, node.keywords)


def changes_of_side(node: ast.AST) -> Iterator[ast.AST]:
    """Yield what a side of a formula without arithmetic could be instead: another entry, or twice as much."""
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Tuple):
        *first, last = node.slice.elts
        if isinstance(last, ast.Constant):
            yield ast.Subscript(node.value, ast.Tuple([*first, ast.Constant(last.value ^ 1)]), ast.Load())
    elif isinstance(node, ast.expr) and names_in(node) and not isinstance(node, ast.Constant):
        yield ast.BinOp(ast.Constant(2), ast.Mult(), copy.copy(node))


def check(path: Path) -> tuple[dict[str, int], list[Change]]:
    """Return how many changes were planted for each formula of a lecture, and those that no assertion noticed."""
    lecture = Lecture(path)
    lecture.run()
    planted = dict.fromkeys(sorted(lecture.numbers, key=lambda number: (len(number), number)), 0)
    unnoticed = []
    for change in lecture.changes():
        for number in change.formulas:
            planted[number] = planted.get(number, 0) + 1
        if not lecture.notices(change):
            unnoticed.append(change)
    return planted, unnoticed


def equivalent_changes(lecture: str) -> dict[tuple[str, str], str]:
    """Return the changes that leave a formula true, as the code before and after, with the reason."""
    listed = tomllib.loads(EQUIVALENT.read_text("utf-8")).get(lecture, [])
    return {(entry["before"], entry["after"]): entry["reason"] for entry in listed}


def assert_formulas_are_asserted(path: Path) -> None:
    """Each numbered formula has an assertion that notices each change of it, but for those listed as equivalent."""
    planted, unnoticed = check(path)
    assert not [number for number, count in planted.items() if not count], "formulas that no code states"
    found = {(change.before, change.after): change.formulas for change in unnoticed}
    listed = equivalent_changes(path.stem)
    assert not {change: numbers for change, numbers in found.items() if change not in listed}
    assert not listed.keys() - found.keys(), "these are noticed: remove them from equivalent_changes.toml"


def main(paths: list[str]) -> None:
    for path in map(Path, paths):
        planted, unnoticed = check(path)
        listed = equivalent_changes(path.stem)
        new = [change for change in unnoticed if (change.before, change.after) not in listed]
        counts = f"{len(planted)} formulas, {sum(planted.values())} changes, {len(unnoticed) - len(new)} equivalent"
        print(f"{path.stem}: {counts}, {len(new)} unnoticed")
        for number in (number for number, count in planted.items() if not count):
            print(f"  ({number}) has no code that could be changed")
        for change in new:
            print(f"  {', '.join(change.formulas)}:  {change.before}  ->  {change.after}")


if __name__ == "__main__":
    main(sys.argv[1:])
