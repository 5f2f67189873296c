"""Functions as answers: two functions agree if they give the same values at some random inputs."""

from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, AtInputs, Named, Quantifier, Unreadable
from misstep.answers.likeness import Likeness
from misstep.answers.number import Numbers
from misstep.mutants.expression import Expression, Slip
from misstep.storage import Outputs

CALL_COUNT = 4
"""The number of inputs at which a function is called."""

Sample = Callable[["np.random.Generator"], tuple[Any, ...]]
"""Draws the arguments of one call."""


@dataclass(frozen=True)
class FunctionCalls:
    """A function, and its outputs at the inputs of the problem. The function is None if only the outputs were stored."""

    function: Callable[..., Any] | None
    outputs: Sequence[Any]


@dataclass(frozen=True, eq=False)
class Function(AtInputs):
    """A function, judged by its outputs at random inputs.

    value   the right function
    output  the kind of answer that each call gives
    sample  draws the arguments of one call from a random generator

    >>> square = Function(np.square, Numbers(np.array(0.0)), lambda chance: (chance.uniform(1, 2),))
    >>> square.agrees(square.read(lambda x: x * x), square.read(np.square))
    [True]
    """

    value: Callable[..., Any]
    output: Answer
    sample: Sample
    inputs: Sequence[tuple[Any, ...]] = field(default=())

    def __post_init__(self) -> None:
        if not self.inputs:
            generator = np.random.default_rng(0)
            object.__setattr__(self, "inputs", [self.sample(generator) for _ in range(CALL_COUNT)])

    parts = ("the function",)

    @property
    def expected(self) -> str:
        return f"a function whose every call gives {self.output.expected}"

    def read(self, given: Any) -> FunctionCalls:
        if isinstance(given, FunctionCalls):
            if given.function is None:
                return given
            given = given.function
        if isinstance(given, Outputs):
            if len(given.values) != len(self.inputs):
                raise Unreadable(
                    f"Expected {self.expected}; it gave {len(given.values)} outputs for {len(self.inputs)} calls."
                )
            return FunctionCalls(None, [self._output(value) for value in given.values])
        if not callable(given) or isinstance(given, type):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.{self._remedy(given)}")
        return FunctionCalls(given, [self._output(self._call(given, arguments)) for arguments in self.inputs])

    def _remedy(self, given: Any) -> str:
        """Return how to give the function instead of this, with a leading space; "" if that is not known."""
        if isinstance(given, str):
            return " Give the function itself, without quotes."
        try:
            self.output.read(given)
        except Exception:  # reading a student's object may raise any error
            return ""
        return " This is what one call gives. Leave the brackets off: fk, not fk(q)."

    def _call(self, function: Callable[..., Any], arguments: Sequence[Any]) -> Any:
        try:
            return function(*deepcopy(arguments))  # a function may change its arguments, but not those of later calls
        except Exception as error:
            raise Unreadable(
                f"Expected {self.expected}; called with {', '.join(map(str, arguments))} it raised "
                f"{type(error).__name__}: {error}"
            ) from error

    def _output(self, value: Any) -> Any:
        if value is None or value is ...:
            raise Unreadable(f"Expected {self.expected}; a call gave nothing. Is the return missing?")
        return self.output.read(value)

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        pairs = zip(self._called(one).outputs, self._called(other).outputs, strict=True)
        return [all(all(self.output.agrees(mine, yours, tolerance)) for mine, yours in pairs)]

    @property
    def slips(self) -> Sequence[Slip]:
        return self.output.slips

    def at_inputs(self, solution: Callable[..., Expression] | None = None) -> Iterator[Expression | Any]:
        if solution is None:
            return iter(self._right.outputs)
        return (solution(*deepcopy(arguments)) for arguments in self.inputs)

    @cached_property
    def _right(self) -> FunctionCalls:
        return self.read(self.value)

    def collect(self, values: Sequence[Any]) -> FunctionCalls:
        return FunctionCalls(None, [self._output(value) for value in values])

    def may_share(self, given: Any, value: Any, tolerance: float = TOLERANCE, parts: Quantifier = any) -> bool:
        try:
            first = self._output(value)
        except Unreadable:
            return False
        return all(self.output.agrees(self._called(given).outputs[0], first, tolerance))

    def seen(self, given: FunctionCalls, part: int | None) -> Named | None:
        if not (likenesses := self._likenesses(given)):
            return None
        if part is None:
            return self._at_every_input(likenesses[0].placeholder())
        seen = [likeness.at_sight() for likeness in likenesses[1:]]
        wrong = [named for named, fine in zip(seen, self._parts_right(given), strict=True) if not fine]
        return self._at_every_input(wrong[0]) if wrong and all(named == wrong[0] for named in wrong) else None

    def resemblance(self, given: FunctionCalls, part: int | None) -> Named | None:
        """Return what is the same at every input: the value, or how the wrong parts differ from the right ones."""
        if not (likenesses := self._likenesses(given)):
            return None
        outputs = np.array(given.outputs)
        if np.abs(outputs - outputs[0]).max() < TOLERANCE < np.abs(np.array(self._right.outputs) - outputs).max():
            text = "It gives the same at every input that was tried. Does it use its arguments?"
            return "the same at every input", text
        right, parts = self._parts_right(given), self.output.parts
        pairs = list(zip(parts, right, likenesses[1:], strict=True))
        seen = [(name, likeness.resemblance()) for name, fine, likeness in pairs if not fine]
        if all(named for _, named in seen):
            text = " ".join(
                f"{name}: {_small(named[1])}" if len(parts) > 1 else named[1] for name, named in seen if named
            )
            return self._at_every_input((seen[0][1][0] if seen[0][1] else "", text))
        wrong, fine = ([name for name, is_fine, _ in pairs if is_fine is what] for what in (False, True))
        if fine:
            text = f"At every input that was tried, the {' and '.join(fine)} is right, and the {' and '.join(wrong)} is not."
            return f"only the {' and '.join(wrong)}", text
        found = self._right.outputs
        count = sum(all(self.output.agrees(mine, yours)) for mine, yours in zip(given.outputs, found, strict=True))
        return ("", f"It is right at {count} of {len(found)} inputs that were tried.") if count else None

    def _parts_right(self, given: FunctionCalls) -> list[bool]:
        """Return, for each part of the outputs, whether it is right at every input."""
        pairs = zip(given.outputs, self._right.outputs, strict=True)
        return [all(fine) for fine in zip(*(self.output.agrees(mine, yours) for mine, yours in pairs), strict=True)]

    def _likenesses(self, given: FunctionCalls) -> list[Likeness]:
        """Return the outputs beside the right ones: the whole first, and then each part; nothing for outputs without numbers."""
        if not isinstance(self.output, Numbers):
            return []
        mine, right = (np.moveaxis(np.array(x.outputs), 0, -1) for x in (given, self._right))
        whole = replace(self.output, value=self._right.outputs[0])
        found = []
        for part in (None, *range(len(whole.parts))):
            piece = ... if part is None else whole.core_indices()[part]
            found.append(replace(whole.likeness(given.outputs[0], part), mine=mine[piece], right=right[piece]))
        return found

    @staticmethod
    def _at_every_input(named: Named | None) -> Named | None:
        return named and (named[0], f"At every input that was tried: {_small(named[1])}")

    def _called(self, given: Any) -> Any:
        if given is self.value:
            return self._right
        return given if isinstance(given, FunctionCalls) else self.read(given)


def _small(text: str) -> str:
    return text[:1].lower() + text[1:]
