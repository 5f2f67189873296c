"""Answers written as data: whatever a student's value is, something comes out, and JSON can hold it.

The forms are those of `answer_data`, which reads them back.
"""

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

import numpy as np

from misstep.formulas.sympy_parsing import MAX_CHARACTERS
from misstep.storage.deserialize import MAX_DEPTH, MAX_ENTRIES
from misstep.validation import Array, is_blank

MAX_PARTS = 4 * MAX_ENTRIES
"""So many entries are looked at, of all lists together: a list of long lists of lists would take for ever."""

MAX_OBJECT_CHARACTERS = 100_000
"""The most characters that the fields of an object may take as JSON."""

Data = dict[str, Any] | None


class _TooMuch(Exception):
    """The value has more parts than any answer."""


@dataclass
class _Place:
    """How deep in the value we are, and how much of it has been looked at."""

    depth: int = 0
    seen: list[int] = field(default_factory=lambda: [0])

    def inside(self) -> "_Place":
        self.seen[0] += 1
        if self.seen[0] > MAX_PARTS:
            raise _TooMuch
        return _Place(self.depth + 1, self.seen)


def to_data(value: Any, inputs: Sequence[Any] = ()) -> Data:
    """Write an answer as JSON. It never raises: a value that is no answer becomes {"other": ...}.

    inputs  where a function is asked for, the arguments of each call: then its outputs are written

    >>> to_data([[1, 2.5]])
    {'array': [1.0, 2.5], 'shape': [1, 2]}
    >>> to_data(["e_a", "M"])
    {'list': [{'text': 'e_a'}, {'text': 'M'}]}
    """
    place = _Place()
    try:
        if inputs and callable(value):
            called = [_written(value(*deepcopy(arguments)), place.inside()) for arguments in inputs]
            return {"function": str(getattr(value, "__name__", "function"))[:80], "outputs": called}
        return _written(value, place)
    except _TooMuch:
        return {"other": f"{_kind(value)} of more than {MAX_PARTS} parts"}
    except Exception as error:  # a student's object may raise anything when it is looked at
        return {"other": f"{type(value).__name__} that raises {type(error).__name__} when it is read"}


def _written(value: Any, place: _Place) -> Data:
    if is_blank(value):
        return None
    if place.depth > MAX_DEPTH:
        return {"other": f"{_kind(value)}, nested deeper than {MAX_DEPTH}"}
    for kinds, write in WRITERS:
        if isinstance(value, kinds):
            return write(value, place)
    return _symbolic(value, place) or _unusual(value, place)


def _unusual(value: Any, place: _Place) -> Data:
    """What has no kind of its own here: functions, and what turns into an array."""
    if callable(value):
        return {"function": str(getattr(value, "__name__", _kind(value)))[:80]}
    if hasattr(value, "__array__"):
        return _array(np.asarray(value), place)
    return _object(value) if hasattr(value, "to_dict") else {"other": _kind(value)}


def _object(value: Any) -> Data:
    """The fields of an object that writes itself down. Whether its kind is an answer is for the reader to say."""
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


def _array(values: Array, place: _Place) -> Data:
    if values.size > MAX_ENTRIES or values.ndim > MAX_DEPTH:
        return {"other": f"array of shape {values.shape}"}
    if values.dtype.kind in "biuf":
        flat = [_number(x) for x in values.astype(float).ravel().tolist()]
        return {"array": flat, "shape": list(values.shape)}
    if values.dtype.kind in "OU":
        return _written(values.tolist(), place)
    return {"other": f"array of {values.dtype}"}


def _list(values: Sequence[Any], place: _Place) -> Data:
    if len(values) > MAX_ENTRIES:
        return {"other": f"list of {len(values)} entries"}
    items = [_written(item, place.inside()) for item in values]
    rows = [item for item in items if item and ("number" in item or "array" in item)]
    shapes = {tuple(row.get("shape", ())) for row in rows}
    flat = [x for row in rows for x in row.get("array", [row.get("number")])]
    if len(rows) == len(items) and len(shapes) == 1 and len(flat) <= MAX_ENTRIES:
        # Rows of one length are an array, however they were typed.
        return {"array": flat, "shape": [len(items), *min(shapes)]}
    return {"list": items}


def _map(value: Mapping[Any, Any], place: _Place) -> Data:
    if len(value) > MAX_ENTRIES:
        return {"other": f"dictionary of {len(value)} entries"}
    return {"map": [[str(key)[:80], _written(item, place.inside())] for key, item in value.items()]}


WRITERS: tuple[tuple[Any, Callable[[Any, _Place], Data]], ...] = (
    (str, _text),
    ((bool, int, float, np.bool_, np.integer, np.floating), lambda value, _: {"number": _number(float(value))}),
    (np.ndarray, lambda value, place: _array(np.asarray(value), place)),
    (Mapping, _map),
    ((list, tuple), _list),
)


def _symbolic(value: Any, place: _Place) -> Data:
    """SymPy's kinds, without loading SymPy for those who never used it."""
    sympy = sys.modules.get("sympy")
    if sympy is None:
        return None
    if isinstance(value, sympy.MatrixBase):
        return {"matrix": [[_written(entry, place.inside()) for entry in row] for row in value.tolist()]}
    if isinstance(value, sympy.Expr):
        # Parts that an expression shares are written out each time, and a small one may have millions: count before.
        if sum(1 for _ in islice(sympy.preorder_traversal(value), MAX_ENTRIES + 1)) > MAX_ENTRIES:
            return {"other": f"formula of more than {MAX_ENTRIES} parts"}
        text = str(value)
        return {"symbolic": text} if len(text) <= MAX_CHARACTERS else {"other": f"formula of {len(text)} characters"}
    return None
