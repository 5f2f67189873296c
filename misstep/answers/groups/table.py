"""Tables as answers: named columns, each a kind of answer of its own, with its own share of the points."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, Unreadable
from misstep.answers.text import forgiving
from misstep.mistakes import Mistake


@dataclass(frozen=True, eq=False)
class Table(Answer):
    """A table of named columns. A column may also be a single value, so that a table is any set of named answers.

    columns  the kind of answer of each column, which has one part

    >>> from misstep.answers.number import Numbers
    >>> table = Table({"k": Numbers([0, 1, 2]), "p": Numbers(["1/4", "1/2", "1/4"])})
    >>> by_column, by_row = {"k": [0, 1, 2], "p": [0.25, 0.5, 0.25]}, [[0, 0.25], [1, 0.5], [2, 0.5]]
    >>> [table.agrees(table.read(given), table.value) for given in (by_column, by_row)]
    [[True, True], [True, False]]
    """

    columns: Mapping[str, Answer]

    def __post_init__(self) -> None:
        if several := [name for name, kind in self.columns.items() if len(kind.parts) != 1]:
            raise ValueError(f"The column {several[0]!r} must have one part, but its kind of answer has several.")
        object.__setattr__(self, "value", {name: kind.value for name, kind in self.columns.items()})

    @property
    def expected(self) -> str:
        columns = "; ".join(f"{name!r}: {kind.expected}" for name, kind in self.columns.items())
        return f"a dictionary with the columns {columns}"

    @property
    def parts(self) -> Sequence[str]:
        return [f"column {name}" for name in self.columns]

    def read(self, given: Any) -> dict[str, Any]:
        given = self._by_column(given)
        read: dict[str, Any] = {}
        for name, kind in self.columns.items():
            try:
                read[name] = kind.read(given[name])
            except Unreadable as error:
                raise Unreadable(f"Column {name!r}: {error}") from error
        return read

    def _by_column(self, given: Any) -> Mapping[str, Any]:
        names = {forgiving(name): name for name in self.columns}
        rows = given.tolist() if isinstance(given, np.ndarray) else given
        if isinstance(rows, list | tuple) and rows:
            if all(isinstance(row, Mapping) for row in rows):
                given = {name: [row.get(name) for row in rows] for name in rows[0]}
            elif all(isinstance(row, list | tuple | np.ndarray) and len(row) == len(names) for row in rows):
                given = dict(zip(self.columns, map(list, zip(*rows, strict=True)), strict=True))
        if not isinstance(given, Mapping):
            shown = validation.brief(given)
            raise Unreadable(f"Expected {self.expected}; got {shown}. Of a DataFrame, give df.to_dict('list').")
        found = {names.get(forgiving(str(name)), str(name)): column for name, column in given.items()}
        if missing := [name for name in self.columns if name not in found]:
            raise Unreadable(f"Expected {self.expected}; the column {missing[0]!r} is missing.")
        if unknown := [name for name in found if name not in self.columns]:
            raise Unreadable(f"Expected {self.expected}; {unknown[0][:40]!r} is none of these columns.")
        return found

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        return [kind.agrees(one[name], other[name], tolerance)[0] for name, kind in self.columns.items()]

    def slips(self) -> Iterator[Mistake]:
        """Yield the slips of each column."""
        for name, kind in self.columns.items():
            for slip in kind.slips():
                value = {**self._right, name: slip.value}
                yield replace(
                    slip, value=value, message=f"Column {name}: {slip.message}", part=slip.part or slip.message
                )

    def explanation(self, given: Any, part: int) -> tuple[str, str] | None:
        name, kind = self._column(part)
        return kind.explanation(given[name], 0)

    def is_rounded(self, given: Any, part: int) -> bool:
        name, kind = self._column(part)
        return kind.is_rounded(given[name], 0)

    def hint(self, given: Any, part: int) -> str:
        name, kind = self._column(part)
        return kind.hint(given[name], 0)

    def _column(self, part: int) -> tuple[str, Answer]:
        return list(self.columns.items())[part]
