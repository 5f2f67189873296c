"""Functions as answers: two functions agree if they give the same values at some random inputs."""

from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Named, Unreadable
from misstep.mutants.expression import Expression, Slip
from misstep.storage import Outputs

CALL_COUNT = 4
"""The number of inputs at which a function is called."""


@dataclass(frozen=True, eq=False)
class Function(Answer):
    """A function, judged by its outputs at random inputs.

    value   the right function
    output  the kind of answer that each call gives
    sample  draws the arguments of one call from a random generator

    >>> from misstep.answers.number import Numbers
    >>> square = Function(np.square, Numbers(np.array(0.0)), lambda chance: (chance.uniform(1, 2),))
    >>> square.agrees(square.read(lambda x: x * x), square.read(np.square))
    [True]
    """

    value: Callable[..., Any]
    output: Answer
    sample: Callable[[np.random.Generator], tuple[Any, ...]]
    inputs: Sequence[tuple[Any, ...]] = field(default=())

    def __post_init__(self) -> None:
        if not self.inputs:
            generator = np.random.default_rng(0)
            object.__setattr__(self, "inputs", [self.sample(generator) for _ in range(CALL_COUNT)])

    parts = ("the function",)

    @property
    def expected(self) -> str:
        return f"a function whose every call gives {self.output.expected}"

    def read(self, given: Any) -> Outputs:
        if isinstance(given, Outputs):
            if len(given.values) != len(self.inputs):
                raise Unreadable(
                    f"Expected {self.expected}; it gave {len(given.values)} outputs for {len(self.inputs)} calls."
                )
            return Outputs([self._output(value) for value in given.values])
        if not callable(given) or isinstance(given, type):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return Outputs([self._output(self._call(given, arguments)) for arguments in self.inputs])

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
        called = (self._right if given is self.value else given for given in (one, other))
        pairs = zip(*(given.values for given in called), strict=False)
        return [all(all(self.output.agrees(mine, yours, tolerance)) for mine, yours in pairs)]

    @property
    def slips(self) -> Sequence[Slip]:
        return self.output.slips

    def at_inputs(self, solution: Callable[..., Expression] | None = None) -> Iterator[Expression | Any]:
        if solution is None:
            return iter(self._right.values)
        return (solution(*deepcopy(arguments)) for arguments in self.inputs)

    @cached_property
    def _right(self) -> Outputs:
        return self.read(self.value)

    def collect(self, values: Sequence[Any]) -> Outputs:
        return Outputs([self._output(value) for value in values])

    def placeholder(self, given: Outputs) -> Named | None:
        return self._at_every_input(given, lambda answer, mine: answer.placeholder(mine))

    def seen(self, given: Outputs, part: int) -> Named | None:
        def ask(answer: Answer, mine: Any) -> Named | None:
            right = answer.agrees(mine, answer.value)
            return next((answer.seen(mine, k) for k, fine in enumerate(right) if not fine), answer.placeholder(mine))

        return self._at_every_input(given, ask)

    def resemblance(self, given: Outputs, part: int) -> Named | None:
        """Return what is the same at every input: which parts are wrong, or how they differ from the right ones."""
        agrees = [self.output.agrees(mine, right) for mine, right in zip(given.values, self._right.values, strict=True)]
        parts = list(zip(self.output.parts, map(all, zip(*agrees, strict=True)), strict=True))
        fine, wrong = (" and ".join(name for name, is_fine in parts if is_fine is what) for what in (True, False))
        if fine:
            return f"only the {wrong}", f"At every input that was tried, the {fine} is right, and the {wrong} is not."
        return self._at_every_input(given, lambda answer, mine: answer.resemblance(mine, 0))

    def _at_every_input(self, given: Outputs, ask: Callable[[Answer, Any], Named | None]) -> Named | None:
        """Return what is to be said of the outputs, if it is the same at every input."""
        pairs = zip(given.values, self._right.values, strict=True)
        found = {ask(replace(self.output, value=right), mine) for mine, right in pairs}  # type: ignore[type-var]
        if len(found) > 1 or not (named := found.pop()):
            return None
        return named[0], f"At every input that was tried: {named[1][:1].lower()}{named[1][1:]}"
