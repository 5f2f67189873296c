"""Writing answers as JSON: there is a result for every value that a student may give.

The forms are described in `deserialize`, which reads them back.
"""

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from decimal import Decimal
from fractions import Fraction
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from misstep.formulas.parsing import MAX_CHARACTERS
from misstep.storage.deserialize import MAX_DEPTH, MAX_ENTRIES
from misstep.validation import TRUTH, is_blank

MAX_PARTS = 4 * MAX_ENTRIES
"""The most entries that are read, of all nested lists together. Lists of long lists would take too long otherwise."""

MAX_OBJECT_CHARACTERS = 100_000
"""The most characters of the fields of an object as JSON."""

Data = dict[str, Any] | None


class _TooManyParts(Exception):
    """The value has more than MAX_PARTS parts."""


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
        if inputs and callable(value):
            outputs = [_serialized(value(*deepcopy(arguments)), 1, parts) for arguments in inputs]
            return {"function": str(getattr(value, "__name__", "function"))[:80], "outputs": outputs}
        return _serialized(value, 0, parts)
    except _TooManyParts:
        return {"other": f"{_kind(value)} of more than {MAX_PARTS} parts"}
    except Exception as error:  # reading a student's object may raise any error
        return {"other": f"{type(value).__name__} that raises {type(error).__name__} when it is read"}


def _serialized(value: Any, depth: int, parts: Iterator[int]) -> Data:  # noqa: PLR0911, PLR0912 - one for each form
    """Write a value.

    depth  in how many lists it is
    parts  counts the values that were read so far
    """
    if next(parts) > MAX_PARTS:
        raise _TooManyParts
    if is_blank(value):
        return None
    if depth > MAX_DEPTH:
        return {"other": f"{_kind(value)}, nested deeper than {MAX_DEPTH}"}
    match value:
        case str():
            return _text(str(value), "text")
        case _ if isinstance(value, TRUTH):
            return {"truth": bool(value)}
        case int() | float() | np.integer() | np.floating() | Fraction() | Decimal():
            return {"number": _number(float(value))}
        case complex() | np.complexfloating() | np.ndarray():
            return _array(np.asarray(value), depth, parts)
        case Mapping() | list() | tuple() if len(value) > MAX_ENTRIES:
            return {"other": f"{'dictionary' if isinstance(value, Mapping) else 'list'} of {len(value)} entries"}
        case Mapping():
            return {"map": [[str(key)[:80], _serialized(item, depth + 1, parts)] for key, item in value.items()]}
        case list() | tuple():
            return _list([_serialized(item, depth + 1, parts) for item in value])
    if symbolic := _symbolic(value, depth, parts):
        return symbolic
    if callable(value):
        return {"function": str(getattr(value, "__name__", _kind(value)))[:80]}
    if hasattr(value, "__array__"):
        return _array(np.asarray(value), depth, parts)
    # Whether the class is registered is known only where the object is read.
    fields = value.to_dict() if hasattr(value, "to_dict") else None
    text = json.dumps(fields, allow_nan=False) if isinstance(fields, dict) else ""
    if not text or len(text) > MAX_OBJECT_CHARACTERS:
        return {"other": _kind(value)}
    return {"object": _kind(value), "fields": json.loads(text)}


def _kind(value: Any) -> str:
    return type(value).__name__[:80]


def _text(text: str, kind: str) -> Data:
    return {"text": text} if len(text) <= MAX_CHARACTERS else {"other": f"{kind} of {len(text)} characters"}


def _number(x: float) -> float | None:
    return x if np.isfinite(x) else None


def _array(values: NDArray[Any], depth: int, parts: Iterator[int]) -> Data:
    if values.size > MAX_ENTRIES or values.ndim > MAX_DEPTH:
        return {"other": f"array of shape {values.shape}"}
    if values.dtype.kind == "c" and not np.any(values.imag):  # as np.linalg.eigvals gives them
        values = values.real
    if values.dtype.kind in "iuf":
        return {"array": [_number(x) for x in values.astype(float).ravel().tolist()], "shape": list(values.shape)}
    is_of_objects = values.dtype.kind in "bOU"
    return _serialized(values.tolist(), depth, parts) if is_of_objects else {"other": f"array of {values.dtype}"}


def _list(items: list[Data]) -> Data:
    """Rows of the same length are an array, whether they were typed as lists or as arrays."""
    rows = [item for item in items if item and ("number" in item or "array" in item)]
    shapes = {tuple(row.get("shape", ())) for row in rows}
    flat = [x for row in rows for x in row.get("array", [row.get("number")])]
    is_array = len(rows) == len(items) and len(shapes) == 1 and len(flat) <= MAX_ENTRIES
    return {"array": flat, "shape": [len(items), *min(shapes)]} if is_array else {"list": items}


def _symbolic(value: Any, depth: int, parts: Iterator[int]) -> Data:
    """Write a SymPy matrix or expression as text; None for anything else. SymPy is not imported if the student did not do so."""
    if "sympy.core" not in sys.modules:
        return None
    import sympy as sp

    from misstep.formulas.evaluation import text_of

    if isinstance(value, sp.MatrixBase):
        return {"list": [_serialized(row, depth + 1, parts) for row in value.tolist()]}
    try:
        return _text(text_of(value), "formula") if isinstance(value, sp.Expr) else None
    except ValueError as error:
        return {"other": f"a formula that cannot be written: {error}"}
