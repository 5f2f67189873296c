"""Writing answers as JSON: there is a result for every value that a student may give.

The forms are described in `deserialize`, which reads them back.
"""

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from misstep.formulas.sympy_parsing import MAX_CHARACTERS
from misstep.storage.deserialize import MAX_DEPTH, MAX_ENTRIES
from misstep.validation import TRUTH, is_blank

MAX_PARTS = 4 * MAX_ENTRIES
"""The most entries that are read, of all nested lists together. Lists of long lists would take too long otherwise."""

MAX_OBJECT_CHARACTERS = 100_000
"""The most characters of the fields of an object as JSON."""

Data = dict[str, Any] | None


class _TooManyParts(Exception):
    """The value has more than MAX_PARTS parts."""


@dataclass
class _Place:
    """The depth in a nested value, and the number of parts that have been read so far."""

    depth: int = 0
    seen: list[int] = field(default_factory=lambda: [0])

    def inside(self) -> "_Place":
        self.seen[0] += 1
        if self.seen[0] > MAX_PARTS:
            raise _TooManyParts
        return _Place(self.depth + 1, self.seen)


def to_data(value: Any, inputs: Sequence[Any] = ()) -> Data:
    """Write an answer as JSON. It never raises an error: a value that cannot be stored becomes {"other": ...}.

    inputs  if the answer is a function, the arguments of each call, so that the outputs are stored

    >>> to_data([[1, 2.5]])
    {'array': [1.0, 2.5], 'shape': [1, 2]}
    >>> to_data(["e_a", "M"])
    {'list': [{'text': 'e_a'}, {'text': 'M'}]}
    """
    place = _Place()
    try:
        if inputs and callable(value):
            outputs = [_serialized(value(*deepcopy(arguments)), place.inside()) for arguments in inputs]
            return {"function": str(getattr(value, "__name__", "function"))[:80], "outputs": outputs}
        return _serialized(value, place)
    except _TooManyParts:
        return {"other": f"{_kind(value)} of more than {MAX_PARTS} parts"}
    except Exception as error:  # reading a student's object may raise any error
        return {"other": f"{type(value).__name__} that raises {type(error).__name__} when it is read"}


def _serialized(value: Any, place: _Place) -> Data:
    if is_blank(value):
        return None
    if place.depth > MAX_DEPTH:
        return {"other": f"{_kind(value)}, nested deeper than {MAX_DEPTH}"}
    for kinds, write in WRITERS:
        if isinstance(value, kinds):
            return write(value, place)
    return _symbolic(value, place) or _other(value, place)


def _other(value: Any, place: _Place) -> Data:
    """Write a function, an object that converts to an array, or an object with a method to_dict()."""
    if callable(value):
        return {"function": str(getattr(value, "__name__", _kind(value)))[:80]}
    if hasattr(value, "__array__"):
        return _array(np.asarray(value), place)
    return _object(value) if hasattr(value, "to_dict") else {"other": _kind(value)}


def _object(value: Any) -> Data:
    """Write the fields of an object. Whether its class is registered is known only where it is read."""
    fields = value.to_dict()
    text = json.dumps(fields, allow_nan=False) if isinstance(fields, dict) else ""
    if not text or len(text) > MAX_OBJECT_CHARACTERS:
        return {"other": _kind(value)}
    return {"object": _kind(value), "fields": json.loads(text)}


def _kind(value: Any) -> str:
    return type(value).__name__[:80]


def _text(value: str, _: _Place) -> Data:
    return {"text": str(value)} if len(value) <= MAX_CHARACTERS else {"other": f"text of {len(value)} characters"}


def _number(x: float) -> float | None:
    return x if np.isfinite(x) else None


def _array(values: NDArray[Any], place: _Place) -> Data:
    if values.size > MAX_ENTRIES or values.ndim > MAX_DEPTH:
        return {"other": f"array of shape {values.shape}"}
    if values.dtype.kind == "c" and not np.any(values.imag):  # as np.linalg.eigvals gives them
        values = values.real
    if values.dtype.kind in "iuf":
        flat = [_number(x) for x in values.astype(float).ravel().tolist()]
        return {"array": flat, "shape": list(values.shape)}
    if values.dtype.kind in "bOU":
        return _serialized(values.tolist(), place)
    return {"other": f"array of {values.dtype}"}


def _list(values: Sequence[Any], place: _Place) -> Data:
    if len(values) > MAX_ENTRIES:
        return {"other": f"list of {len(values)} entries"}
    items = [_serialized(item, place.inside()) for item in values]
    rows = [item for item in items if item and ("number" in item or "array" in item)]
    shapes = {tuple(row.get("shape", ())) for row in rows}
    flat = [x for row in rows for x in row.get("array", [row.get("number")])]
    if len(rows) == len(items) and len(shapes) == 1 and len(flat) <= MAX_ENTRIES:
        # Rows of the same length are an array, whether they were typed as lists or as arrays.
        return {"array": flat, "shape": [len(items), *min(shapes)]}
    return {"list": items}


def _map(value: Mapping[Any, Any], place: _Place) -> Data:
    if len(value) > MAX_ENTRIES:
        return {"other": f"dictionary of {len(value)} entries"}
    return {"map": [[str(key)[:80], _serialized(item, place.inside())] for key, item in value.items()]}


WRITERS: tuple[tuple[Any, Callable[[Any, _Place], Data]], ...] = (
    (str, _text),
    (TRUTH, lambda value, _: {"truth": bool(value)}),
    ((int, float, np.integer, np.floating, Fraction, Decimal), lambda value, _: {"number": _number(float(value))}),
    ((complex, np.complexfloating), lambda value, place: _array(np.asarray(value), place)),
    (np.ndarray, lambda value, place: _array(np.asarray(value), place)),
    (Mapping, _map),
    ((list, tuple), _list),
)


def _symbolic(value: Any, place: _Place) -> Data:
    """Write a SymPy matrix or expression; None for anything else. SymPy is not imported if the student did not import it."""
    sympy = sys.modules.get("sympy")
    if sympy is None or "sympy.core" not in sys.modules:  # on a page of the site it may be imported, but not loaded
        return None
    if isinstance(value, sympy.MatrixBase):
        return {"matrix": [[_serialized(entry, place.inside()) for entry in row] for row in value.tolist()]}
    if isinstance(value, sympy.Expr):
        # `str` writes shared parts once for each occurrence, so even a small expression may become huge. Count first.
        if sum(1 for _ in islice(sympy.preorder_traversal(value), MAX_ENTRIES + 1)) > MAX_ENTRIES:
            return {"other": f"formula of more than {MAX_ENTRIES} parts"}
        text = str(value)
        return {"symbolic": text} if len(text) <= MAX_CHARACTERS else {"other": f"formula of {len(text)} characters"}
    return None
