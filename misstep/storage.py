"""Answers as JSON, which a check cell stores beside its card, so that a grader reads data and never runs what made it.

Writing is lenient: there is a result for every object, whatever errors the object raises. Reading accepts these forms alone,
because anybody can write JSON:

    null                                  a blank answer
    {"number": 1.5}, {"text": "..."}, {"truth": true}  a formula is stored as its text
    {"array": [flat numbers], "shape": [3, 6]}         null stands for NaN and infinity
    {"list": [...]}, {"map": [["a", ...], ...]}
    {"object": "Resistor", "fields": {...}}            an object of a class in OBJECTS
    {"function": "name"}, and with "outputs": [...] if it was called
    {"other": "what it is"}
"""

import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from misstep.validation import TRUTH, is_blank

MIME = "application/vnd.misstep.answer+json"
"""The MIME type of the stored answer in the output of a check cell."""

MAX_PARTS = 16_000
"""The most numbers, and the most values in lists, that are stored of an answer."""

MAX_CHARACTERS = 100_000
"""The most characters of a stored answer."""

OBJECTS: dict[str, Callable[[Mapping[str, Any]], Any]] = {}
"""For each class whose objects are answers, by its name, what makes an object from the fields that its to_dict() returns.

It raises ValueError for fields that to_dict() never returns.
"""

Data = dict[str, Any] | None


@dataclass(frozen=True)
class Opaque:
    """A placeholder for a value that cannot be stored, with its description for messages."""

    name: str

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class Outputs:
    """The outputs of a student's function, one for each input."""

    values: Sequence[Any]


class _TooLarge(Exception):
    """The value has more parts or characters than are stored."""


def to_data(value: Any, inputs: Sequence[Any] = ()) -> Data:
    """Write an answer as JSON. It never raises an error: a value that cannot be stored becomes {"other": ...}.

    inputs  if the answer is a function, the arguments of each call, so that the outputs are stored

    >>> to_data([[1, 2.5]])
    {'array': [1.0, 2.5], 'shape': [1, 2]}
    >>> to_data(["e_a", "M"])
    {'list': [{'text': 'e_a'}, {'text': 'M'}]}
    """
    parts = count()
    try:
        data = _written(value, parts)
        if inputs and callable(value):
            data = {"function": _name(value), "outputs": [_written(value(*deepcopy(one)), parts) for one in inputs]}
        if len(json.dumps(data, allow_nan=False)) > MAX_CHARACTERS:
            raise _TooLarge
        return data
    except _TooLarge:
        return {"other": f"{type(value).__name__} that is too large"}
    except Exception as error:  # reading a student's object may raise any error
        return {"other": f"{type(value).__name__} that raises {type(error).__name__} when it is read"}


def _written(value: Any, parts: Iterator[int]) -> Data:  # noqa: PLR0911 - one for each form
    """Write a value; `parts` counts those that were written before."""
    if next(parts) > MAX_PARTS:
        raise _TooLarge
    if is_blank(value):
        return None
    match value:
        case str():
            return {"text": str(value)}
        case _ if isinstance(value, TRUTH):
            return {"truth": bool(value)}
        case int() | float() | np.integer() | np.floating() | Fraction() | Decimal():
            return {"number": _number(float(value))}
        case complex() | np.complexfloating() | np.ndarray():
            return _array(np.asarray(value), parts)
        case Mapping():
            return {"map": [[str(key), _written(item, parts)] for key, item in value.items()]}
        case list() | tuple():
            return _list([_written(item, parts) for item in value])
    if hasattr(value, "__array__"):  # as matrices of SymPy have, too
        return _array(np.asarray(value), parts)
    if "sympy.core" in sys.modules:  # SymPy is not imported if the student did not do so
        import sympy as sp

        from misstep.formulas.evaluation import text_of

        if isinstance(value, sp.Expr):
            return {"text": text_of(value)}
    if callable(value):
        return {"function": _name(value)}
    # Whether the class is in OBJECTS is known only where the object is read.
    name = type(value).__name__
    return {"object": name, "fields": value.to_dict()} if hasattr(value, "to_dict") else {"other": name}


def _name(function: Any) -> str:
    return str(getattr(function, "__name__", type(function).__name__))


def _number(x: float) -> float | None:
    return x if np.isfinite(x) else None


def _array(values: NDArray[Any], parts: Iterator[int]) -> Data:
    if values.size > MAX_PARTS:
        raise _TooLarge
    if values.dtype.kind == "c" and not np.any(values.imag):  # as np.linalg.eigvals gives them
        values = values.real
    if values.dtype.kind in "iuf":
        return {"array": [_number(x) for x in values.astype(float).ravel().tolist()], "shape": list(values.shape)}
    return _written(values.tolist(), parts) if values.dtype.kind in "bOU" else {"other": f"array of {values.dtype}"}


def _list(items: list[Data]) -> Data:
    """Rows of the same length are an array, whether they were typed as lists or as arrays."""
    rows = [item for item in items if item and ("number" in item or "array" in item)]
    shapes = {tuple(row.get("shape", ())) for row in rows}
    if len(rows) < len(items) or len(shapes) != 1:
        return {"list": items}
    flat = [x for row in rows for x in row.get("array", [row.get("number")])]
    return {"array": flat, "shape": [len(items), *min(shapes)]}


def from_data(data: Any) -> Any:
    """Read a stored answer: arrays as NumPy arrays, formulas as text, and what could not be stored as Opaque.

    Raises ValueError for JSON of any other form.
    """
    try:
        return _read(data)
    except (TypeError, OverflowError, KeyError, RecursionError) as error:
        raise ValueError(f"This is no stored answer: {type(error).__name__}.") from error


def _read(data: Any) -> Any:  # noqa: PLR0911 - one for each form
    match data:
        case None:
            return None
        case {"number": number}:
            return np.array(number, dtype=float)[()]
        case {"text": str(text)} | {"truth": bool(text)}:
            return text
        case {"array": list(flat), "shape": list(shape)}:
            return np.array(flat, dtype=float).reshape(shape)
        case {"list": list(items)}:
            return [_read(item) for item in items]
        case {"map": list(pairs)}:
            return {str(name): _read(item) for name, item in pairs}
        case {"object": str(name), "fields": dict(fields)}:
            return OBJECTS[name](fields) if name in OBJECTS else Opaque(name)
        case {"function": str(), "outputs": list(items)}:
            return Outputs([_read(item) for item in items])
        case {"function": str(name)}:
            return Opaque(f"function {name}")
        case {"other": str(name)}:
            return Opaque(name)
    raise ValueError("A stored answer must be null or a JSON object of a known form.")
