"""Functions as answers: two functions agree if they give the same values at some random inputs."""

import pickle
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, Quantifier, Unreadable
from misstep.answers.entries import wrong_slips
from misstep.answers.likeness import Likeness, Named
from misstep.answers.number import Numbers
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression
from misstep.storage.deserialize import Outputs

CALL_COUNT = 4
"""The number of inputs at which a function is called."""

Sample = Callable[["np.random.Generator"], tuple[Any, ...]]
"""Draws the arguments of one call."""


def function_mistakes(mistakes_at: Callable[..., Sequence[Mistake]], *example: Any) -> list[Mistake]:
    """Turn the mistakes of a single call into mistakes of a function, which give the wrong answer at any input.

    mistakes_at  returns the mistakes for given arguments, always the same ones in the same order
    example      valid arguments of one call

    >>> at = lambda x: [Mistake("sign", -x, "You turned the wrong way.")]
    >>> function_mistakes(at, 1.0)[0].value(2.0)
    -2.0
    """
    known: dict[bytes, Sequence[Mistake]] = {}

    def value(index: int, *arguments: Any) -> Any:
        # All mistakes are needed at the same inputs, one after the other, so they are computed together.
        key = pickle.dumps(arguments)
        if key not in known:
            known[key] = mistakes_at(*arguments)
        return known[key][index].value

    return [
        Mistake(wrong.name, partial(value, index), wrong.message) for index, wrong in enumerate(mistakes_at(*example))
    ]


@dataclass(frozen=True)
class FunctionCalls:
    """A function, and its outputs at the inputs of the problem. The function is None if only the outputs were stored."""

    function: Callable[..., Any] | None
    outputs: Sequence[Any]


@dataclass(frozen=True, eq=False)
class Function(Answer):
    """A function, judged by its outputs at random inputs. A grader draws other inputs in every run.

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
            object.__setattr__(self, "inputs", self.with_inputs(0).inputs)

    def with_inputs(self, seed: int) -> "Function":
        """Return the same answer with other inputs."""
        generator = np.random.default_rng(seed)
        return replace(self, inputs=[self.sample(generator) for _ in range(CALL_COUNT)])

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

    def _output_of(self, right: Any) -> Any:
        """The kind of answer of a call whose right output is known."""
        return replace(self.output, value=right)  # type: ignore[type-var]

    def _output(self, value: Any) -> Any:
        if value is None or value is ...:
            raise Unreadable(f"Expected {self.expected}; a call gave nothing. Is the return missing?")
        return self.output.read(value)

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        pairs = zip(self._called(one).outputs, self._called(other).outputs, strict=True)
        return [all(all(self.output.agrees(mine, yours, tolerance)) for mine, yours in pairs)]

    def expressions(self, solution: Callable[..., Expression]) -> Iterator[Expression]:
        return (solution(*deepcopy(arguments)) for arguments in self.inputs)

    def collect(self, values: Sequence[Any]) -> FunctionCalls:
        return FunctionCalls(None, [self._output(value) for value in values])

    def may_share(self, given: Any, value: Any, tolerance: float = TOLERANCE, parts: Quantifier = any) -> bool:
        try:
            first = self._output(value)
        except Unreadable:
            return False
        return all(self.output.agrees(self._called(given).outputs[0], first, tolerance))

    def appearance(self, given: FunctionCalls, part: int | None) -> Named | None:
        if not (likenesses := self._likenesses(given)):
            return None
        if part is None:
            return self._at_every_input(likenesses[0].placeholder())
        seen = [likeness.at_sight() for likeness in likenesses[1:]]
        wrong = [named for named, fine in zip(seen, self._parts_right(given), strict=True) if not fine]
        return self._at_every_input(wrong[0]) if wrong and all(named == wrong[0] for named in wrong) else None

    def explanation(self, given: FunctionCalls, part: int) -> Named | None:
        """Return what is the same at every input: the value, or how the wrong parts differ from the right ones."""
        if not isinstance(self.output, Numbers):
            return None
        outputs = np.array(given.outputs)
        if np.abs(outputs - outputs[0]).max() < TOLERANCE < np.abs(np.array(self._right.outputs) - outputs).max():
            return (
                "the same at every input",
                "It gives the same at every input that was tried. Does it use its arguments?",
            )
        if not (likenesses := self._likenesses(given)):
            return None
        right, parts = self._parts_right(given), self.output.parts
        seen = [
            f"{name}: {named[1][:1].lower()}{named[1][1:]}" if len(parts) > 1 else named[1]
            for name, fine, likeness in zip(parts, right, likenesses[1:], strict=True)
            if not fine and (named := likeness.resemblance())
        ]
        if len(seen) < right.count(False):
            return None
        return self._at_every_input(("likeness at every input", " ".join(seen)))

    def description(self, given: FunctionCalls, part: int) -> Named | None:
        right, parts = self._parts_right(given), self.output.parts
        if not any(right):
            return None
        fine, wrong = (
            [name for name, is_fine in zip(parts, right, strict=True) if is_fine is what] for what in (True, False)
        )
        text = (
            f"At every input that was tried, the {' and '.join(fine)} is right, and the {' and '.join(wrong)} is not."
        )
        return f"only the {' and '.join(wrong)}", text

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
        return named and (named[0], f"At every input that was tried: {named[1][:1].lower()}{named[1][1:]}")

    def is_rounded(self, given: FunctionCalls, part: int) -> bool:
        """Return whether every wrong output is the right one, rounded to two or more significant digits."""
        wrong = [
            (self._output_of(right), mine)
            for mine, right in zip(given.outputs, self._right.outputs, strict=True)
            if not all(self.output.agrees(mine, right))
        ]
        return bool(wrong) and all(
            fine or output.is_rounded(mine, k)
            for output, mine in wrong
            for k, fine in enumerate(output.agrees(mine, output.value))
        )

    def slips(self) -> Iterator[Mistake]:
        """Yield functions whose every output has one of the slips of a whole array."""
        if not isinstance(self.output, Numbers):
            return iter(())

        def slips_at(*arguments: Any) -> list[Mistake]:
            output = self._output_of(self._call(self.value, arguments))
            return [Mistake(name, value, "") for name, value, _, _ in output.whole_slips()]

        functions = function_mistakes(slips_at, *self.inputs[0])
        texts = (
            f"At every input that was tried: {text[0].lower()}{text[1:]}" for _, _, text, _ in self.output.whole_slips()
        )
        slips = ((wrong.name, wrong.value, text, "") for wrong, text in zip(functions, texts, strict=True))
        return wrong_slips(self, slips, lambda calls: np.array(calls.outputs))

    def hint(self, given: FunctionCalls, part: int) -> str:
        right = self._right.outputs
        count = sum(all(self.output.agrees(mine, yours)) for mine, yours in zip(given.outputs, right, strict=True))
        return f"It is right at {count} of {len(right)} inputs that were tried." if count else ""

    def _called(self, given: Any) -> Any:
        if given is self.value:
            return self._right
        return given if isinstance(given, FunctionCalls) else self.read(given)
