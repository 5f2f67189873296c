"""Expressions: a solution as a tree of operations on given values, which is written as with NumPy and can be changed.

    T_to = inverse(T_st) @ T_sc @ T_co

is an expression if the poses are; its `value` is the pose. An operation also says in which ways people get it wrong, each as
another expression. Expressions never change: a changed expression shares all unchanged parts with the original one, and with
them their values, so that hundreds of mutants are evaluated in the time of a few.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property, reduce
from operator import matmul, mul
from typing import Any

import numpy as np

SUM, PRODUCT, ATOM = 1, 2, 3
"""How tightly an operation binds: a sum within a product needs brackets, and both need them before an exponent."""


@dataclass(frozen=True)
class Slip:
    """One way in which people go wrong: its name, what they do, and what that leads to.

    name          the name of the misconception, the same wherever it occurs: "inverse left out"
    did           what is done, from the verb on: "use $T_{st}$, where its inverse belongs"; or the whole message, a sentence
    wrong         what stands in the place of the right thing: an expression, or for any answer of a kind a function of the right value
    everywhere    the same as `did` for what people do in all places at once; "" if each place is a slip of its own
    advice        a sentence on what is right
    one_by_one    whether people also do it in one of several places alone
    in_parts      whether one part of an answer can show it; otherwise only the whole answer does
    may_coincide  whether it may lead to the right answer for some numbers
    spoils        whether it is a wrong method for the whole answer, so that a part that comes out right earns nothing
    """

    name: str
    did: str
    wrong: Any = field(default=None, repr=False)
    everywhere: str = ""
    advice: str = ""
    one_by_one: bool = True
    in_parts: bool = True
    may_coincide: bool = False
    spoils: bool = False


Slips = Iterator[Slip]


@dataclass(frozen=True, eq=False)
class Operation:
    """A function of arrays, how it is written in LaTeX, and how people get it wrong.

    name         a word for it
    function     takes the values of the arguments
    latex        takes the LaTeX of the arguments
    slips        takes an expression with this operation; yields the slips in it
    binds        SUM, PRODUCT or ATOM: where brackets are needed
    involution   whether applying it twice is doing nothing, as with an inverse
    associative  whether nested applications are one: (A B) C = A B C

    >>> double = Operation("double", lambda x: 2 * x, "2 {0}".format)
    >>> x = given("x", 3.0)
    >>> double(x).value, double(x).latex
    (6.0, '2 x')
    """

    name: str
    function: Callable[..., Any]
    latex: Callable[..., str]
    slips: Callable[["Expression"], Slips] = lambda _: iter(())
    binds: int = ATOM
    involution: bool = False
    associative: bool = False

    def __call__(self, *arguments: Any) -> "Expression":
        nodes = [as_expression(argument) for argument in arguments]
        if self.involution and nodes[0].operation is self:
            return nodes[0].arguments[0]
        if self.associative:
            # A part with a name of its own stays one part, because the author thinks of it as one.
            merged = [node.operation is self and not (node.label or node.alternatives) for node in nodes]
            nodes = [
                part
                for node, is_merged in zip(nodes, merged, strict=True)
                for part in (node.arguments if is_merged else (node,))
            ]
        return nodes[0] if self.associative and len(nodes) == 1 else Expression(self, tuple(nodes))


@dataclass(frozen=True, eq=False)
class Expression:
    r"""An operation on expressions, or a value that is given. Its `value` is computed once.

    Python's operators @, +, -, *, / and the attribute T make expressions.

    operation     what is done, or for a given value its kind
    arguments     what it is done to; none for a given value
    known         the value, if it is given
    label         its own name in LaTeX
    alternatives  the changes that belong to this place of this problem alone

    >>> a, b = given("a", 2.0), given("b", 3.0)
    >>> (a * b - a).value
    4.0
    >>> (a * (b - a)).latex
    'a\\,(b - a)'
    """

    operation: Operation
    arguments: tuple["Expression", ...] = ()
    known: Any = field(default=None, repr=False)
    label: str = ""
    alternatives: tuple[Slip, ...] = field(default=(), repr=False)

    __iter__ = None  # an entry is an expression for every index, so a loop would not end
    __array_ufunc__ = None  # so that an array to the left of an operator leaves the operation to the expression

    @cached_property
    def value(self) -> Any:
        """The value. An error of the operation is not caught."""
        return self.operation.function(*(node.value for node in self.arguments)) if self.arguments else self.known

    @cached_property
    def parts(self) -> frozenset["Expression"]:
        """All its parts, itself included."""
        return frozenset([self]).union(*(node.parts for node in self.arguments))

    @cached_property
    def latex(self) -> str:
        """The expression in LaTeX."""
        if self.label or not self.arguments:
            return self.label
        return self.formula

    @property
    def formula(self) -> str:
        """The operation on its arguments in LaTeX, without its own name; "" for a given value."""
        text = self.operation.latex(*map(self._bracketed, self.arguments)) if self.arguments else ""
        for inner in {self._bracketed(node) for node in self.arguments} - {node.latex for node in self.arguments}:
            # Between brackets or commas an argument needs no brackets of its own.
            alone = rf"(?<=[(|{{,])( ?){re.escape(inner)}(?=[)|}},])"
            text = re.sub(alone, r"\g<1>" + inner[1:-1].replace("\\", "\\\\"), text)
        return text

    def _bracketed(self, node: "Expression") -> str:
        is_loose = not node.label and len(node.arguments) > 1 and node.operation.binds < self.operation.binds
        return f"({node.latex})" if is_loose else node.latex

    def slips(self) -> Slips:
        """Yield the slips in this operation alone."""
        yield from self.alternatives
        yield from self.operation.slips(self)

    def named(self, label: str) -> "Expression":
        """Return the same expression with a name of its own in LaTeX, by which messages speak of it."""
        return replace(self, label=label)

    def mistaken_for(self, *slips: Any, advice: str = "", **fields: Any) -> "Expression":
        """Return the same expression with further slips: here, and in this problem, people take other values.

        slips   (name, text, value) or (name, text, value, advice)
        fields  of all these slips, such as spoils=True

        Raises ValueError for a slip that is no such tuple.
        """
        if odd := [one for one in slips if type(one) is not tuple or len(one) not in (3, 4) or type(one[1]) is not str]:
            raise ValueError(f"Each slip must be (name, text, value) in brackets of its own; got {odd[0]!r:.80}.")
        further = [
            Slip(name, text, as_expression(other), advice=why[0] if why else advice, **fields)
            for name, text, other, *why in slips
        ]
        return replace(self, alternatives=(*self.alternatives, *further))

    @property
    def T(self) -> "Expression":
        """The transpose."""
        return transpose(self)

    def __matmul__(self, other: Any) -> "Expression":
        return product(self, other)

    def __rmatmul__(self, other: Any) -> "Expression":
        return product(other, self)

    def __add__(self, other: Any) -> "Expression":
        return total(self, other)

    def __radd__(self, other: Any) -> "Expression":
        return total(other, self)

    def __sub__(self, other: Any) -> "Expression":
        return total(self, negative(other))

    def __rsub__(self, other: Any) -> "Expression":
        return total(other, negative(self))

    def __mul__(self, other: Any) -> "Expression":
        return multiple(self, other)

    def __rmul__(self, other: Any) -> "Expression":
        return multiple(other, self)

    def __truediv__(self, other: Any) -> "Expression":
        return quotient(self, other)

    def __neg__(self) -> "Expression":
        return negative(self)

    def __getitem__(self, index: Any) -> "Expression":
        return _entry(index)(self)


GIVEN = Operation("given", lambda: None, str)
"""The kind of a given value about which people make no mistake of their own."""


def given(label: str, value: Any, kind: Operation = GIVEN) -> Expression:
    """Make an expression of a given value.

    label  its name in LaTeX, without dollar signs
    kind   an operation without arguments whose changes are those of such a value, such as POSE or ANGLE
    """
    return Expression(kind, (), value if np.isscalar(value) else np.asarray(value, dtype=float), label)


def as_expression(value: Any) -> Expression:
    """Return an expression unchanged, and anything else as a given value, whose name is the number that it is."""
    if isinstance(value, Expression):
        return value
    return given(f"{float(value):g}" if np.ndim(value) == 0 else "\\ldots", value)


def table(*rows: tuple[Any, ...], of_values: bool = False) -> Callable[[Expression], Slips]:
    """Return the slips in an operation or a kind of given value as data: a row (name, text, change, advice, fields) for each.

    text       what is done: {} is the expression in LaTeX and {0}, {1} its arguments; after a bar, what is done in all places at
               once, in the same words if nothing follows
    change     from the arguments, or from a given value itself, to the wrong expression; None if the operation is left out
    advice     written like the text; it may be left out, and so may the further fields of Slip, as a dictionary
    of_values  whether the changes are functions of the values of the arguments

    >>> squares = Operation("square", np.square, "{0}^2".format, table(("doubled", "double ${0}$ |double everything", lambda x: 2 * x)))
    >>> [(slip.name, slip.did, slip.everywhere, slip.wrong.value) for slip in squares(given("x", 3.0)).slips()]
    [('doubled', 'double $x$', 'double everything', 6.0)]
    """

    def slips(node: Expression) -> Slips:
        arguments = node.arguments or (node,)
        place = re.compile(r"\{(\d?)\}")
        for name, text, change, *more in rows:
            said, advice = (
                place.sub(lambda k: (arguments[int(k[1])] if k[1] else node).latex, one)
                for one in (text, more[0] if more else "")
            )
            did, bar, everywhere = (part.strip() for part in said.partition(" |"))
            make = Operation(name, change, node.operation.latex) if of_values else change
            wrong = as_expression(make(*arguments) if change else arguments[0])
            yield Slip(name, did, wrong, everywhere or did * bool(bar), advice, **(more[1] if len(more) > 1 else {}))

    return slips


ALL_AT_ONCE = {"one_by_one": False}
"""The field of a slip that people make in all places or in none."""

MAY_COINCIDE = {"may_coincide": True}
"""The field of a slip that may lead to the right answer for some numbers."""


def _quoted(*nodes: Expression) -> str:
    """The names of expressions for a message: "$A$ and $B$"."""
    return " and ".join(f"${node.latex}$" for node in nodes)


def _put(items: tuple[Expression, ...], i: int, *instead: Expression) -> tuple[Expression, ...]:
    """Return the items with others in the place of one."""
    return (*items[:i], *instead, *items[i + 1 :])


def _product_slips(node: Expression) -> Slips:
    factors, last = node.arguments, len(node.arguments) - 1
    advice = "A product of matrices depends on the order of its factors."
    first, end = _quoted(factors[0]), _quoted(factors[-1])
    for place, order in (
        ("", factors[::-1]),
        (f"after {first} ", (factors[0], *factors[:0:-1])),
        (f"before {end} ", (*factors[-2::-1], factors[-1])),
    ):
        if last > (2 if place else 1):
            text = f"multiply the factors {place}in the reverse order"
            yield Slip("reversed", text, product(*order), advice=advice)
    for i in range(last):
        swapped = product(*factors[:i], factors[i + 1], factors[i], *factors[i + 2 :])
        yield Slip("order", f"swap {_quoted(*factors[i : i + 2])}", swapped, advice=advice)
    for i, factor in enumerate(factors):
        rest = _put(factors, i)
        yield Slip("factor left out", f"leave out {_quoted(factor)}", product(*rest))
        for place, to, moved in (("first", 0, (factor, *rest)), ("last", last, (*rest, factor))):
            if abs(to - i) > 1:
                yield Slip(f"{place} factor", f"put {_quoted(factor)} {place}", product(*moved), advice=advice)
    if all(np.ndim(factor.value) == 2 for factor in factors):
        by_entry = "multiply entry by entry (`*` instead of `@`)"
        yield Slip("entry by entry", by_entry, _entrywise(*factors), everywhere=by_entry)


def _sum_slips(node: Expression) -> Slips:
    for i, term in enumerate(node.arguments):
        negated = total(*_put(node.arguments, i, negative(term)))
        yield Slip("sign", f"take {_quoted(term)} with the opposite sign", negated)
        yield Slip("term left out", f"leave out {_quoted(term)}", total(*_put(node.arguments, i)))


def _multiple_slips(node: Expression) -> Slips:
    for i, factor in enumerate(node.arguments):
        others = multiple(*_put(node.arguments, i))
        yield Slip("factor left out", f"leave out the factor {_quoted(factor)}", others)
        if np.ndim(factor.value) == 0 and len(node.arguments) > 1:
            text = f"divide by {_quoted(factor)} instead of multiplying by it"
            yield Slip("division for product", text, quotient(others, factor))


def _joined_sum(*terms: str) -> str:
    return " + ".join(terms).replace("+ -", "- ")


def _side_by_side(*factors: str) -> str:
    return "\\,".join(factors)


def _reduced(by: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    return lambda *factors: reduce(by, factors)


def power(exponent: str) -> Callable[[str], str]:
    """Return the LaTeX of a power; a base that is a power itself gets brackets, because LaTeX refuses two exponents.

    >>> power("{-1}")("A"), power("{-1}")("e^{X}")
    ('A^{-1}', '(e^{X})^{-1}')
    """
    return lambda base: f"({base})^{exponent}" if "^" in base and not base.endswith(")") else f"{base}^{exponent}"


product = Operation("product", _reduced(matmul), _side_by_side, _product_slips, PRODUCT, associative=True)
"""The product of matrices, A @ B."""

_entrywise = Operation("entry by entry", _reduced(mul), lambda *factors: " * ".join(factors), binds=PRODUCT)

total = Operation("sum", lambda *terms: sum(terms[1:], terms[0]), _joined_sum, _sum_slips, SUM, associative=True)
"""The sum, A + B; a difference is a sum with `negative`."""

multiple = Operation("multiple", _reduced(mul), _side_by_side, _multiple_slips, PRODUCT, associative=True)
"""The product of numbers, or of a number and an array, a * B."""

quotient = Operation("quotient", lambda a, b: a / b, "{0} / {1}".format, table(
    ("divisor left out", "forget to divide by ${1}$", lambda a, _: a),
    ("product for division", "multiply by ${1}$ instead of dividing by it", lambda a, b: multiple(a, b)),
), PRODUCT)  # fmt: skip
"""The quotient, A / b."""

negative = Operation("negative", lambda a: -a, "-{0}".format, table(
    ("sign", "leave out the minus sign of ${}$", lambda a: a),
), PRODUCT, involution=True)  # fmt: skip
"""The opposite, -A."""

transpose = Operation("transpose", np.transpose, power("T"), table(
    ("transpose left out", "use ${0}$, where its transpose belongs |leave out every transpose", lambda a: a),
), involution=True)  # fmt: skip
"""The transpose, A.T."""


def _entry(index: Any) -> Operation:
    return Operation("entry", lambda array: array[index], "{0}".format)
