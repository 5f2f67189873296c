"""Reading answers from JSON.

A check cell stores the answer beside its card, so that a grader reads data and never runs what made it. Serializing is
lenient: there is a result for every object, whatever errors the object raises. Deserializing is strict: it accepts the
following forms and refuses all others, because anybody can write JSON.

    null                                  a blank answer
    {"number": 1.5}, {"text": "..."}, {"truth": true}  a formula is stored as its text
    {"array": [flat numbers], "shape": [3, 6]}         null stands for NaN and infinity
    {"list": [...]}, {"map": [["a", ...], ...]}
    {"object": "Resistor", "fields": {...}}            an object of a class that a kind of answer has registered
    {"function": "name"}, and with "outputs": [...] if it was called
    {"other": "what it is"}
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from misstep.formulas.parsing import MAX_CHARACTERS
from misstep.validation import Array

MIME = "application/vnd.misstep.answer+json"
"""The MIME type of the stored answer in the output of a check cell."""

MAX_ENTRIES = 4096
"""The most numbers of an array, and the most entries of a list."""

MAX_DEPTH = 5
"""The most levels of nested lists."""

OBJECTS: dict[str, Callable[[Mapping[str, Any]], Any]] = {}
"""For each registered class, by its name, the function that makes an object from its fields."""


class Malformed(ValueError):
    """JSON that has none of the forms of an answer."""


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


def from_data(data: Any, depth: int = 0) -> Any:  # noqa: PLR0911 - one for each form
    """Read a stored answer: arrays as NumPy arrays, formulas as SymPy, and what could not be stored as Opaque.

    depth  in how many lists it is

    Raises Malformed for JSON of any other form.

    >>> from_data({"array": [1.0, None], "shape": [2]})
    array([ 1., nan])
    """
    if data is None:
        return None
    match data, len(data) if isinstance(data, dict) and depth <= MAX_DEPTH + 1 else 0:
        case {"number": number}, 1:
            return _numbers([number], [])[()]
        case {"text": str(text)}, 1 if len(text) <= MAX_CHARACTERS:
            return text
        case {"truth": bool(is_true)}, 1:
            return is_true
        case {"array": list(flat), "shape": list(shape)}, 2:
            return _numbers(flat, shape)
        case {"list": list(items)}, 1 if len(items) <= MAX_ENTRIES:
            return [from_data(item, depth + 1) for item in items]
        case {"map": list(pairs)}, 1 if len(pairs) <= MAX_ENTRIES and all(map(_is_named, pairs)):
            return {name[:80]: from_data(item, depth + 1) for name, item in pairs}
        case {"object": str(name), "fields": dict(fields)}, 2 if all(isinstance(key, str) for key in fields):
            return _object(name[:80], fields)
        case {"function": str(name)}, 1:
            return Opaque(f"function {name[:80]}")
        case {"function": str(), "outputs": list(items)}, 2 if len(items) <= MAX_ENTRIES:
            return Outputs([from_data(item, depth + 1) for item in items])
        case {"other": str(name)}, 1:
            return Opaque(name[:200])
    raise Malformed("An answer must be null or a JSON object of a known form and size.")


def _is_named(pair: Any) -> bool:
    return isinstance(pair, list) and len(pair) == 2 and isinstance(pair[0], str)


def _numbers(flat: list[Any], shape: list[Any]) -> Array:
    sizes = [size for size in shape if isinstance(size, int) and not isinstance(size, bool) and size >= 0]
    is_small = len(flat) <= MAX_ENTRIES and len(shape) <= MAX_DEPTH + 1
    are_numbers = all(x is None or (isinstance(x, int | float) and not isinstance(x, bool)) for x in flat)
    if not (is_small and are_numbers and sizes == shape):
        raise Malformed(f"An array must have at most {MAX_ENTRIES} numbers, and a shape of whole numbers.")
    try:
        return np.array([np.nan if x is None else float(x) for x in flat]).reshape(sizes)
    except (OverflowError, ValueError) as error:
        raise Malformed("The numbers of an array must fill its shape.") from error


def _object(name: str, fields: dict[str, Any]) -> Any:
    """Return an object of a registered class, or Opaque for any other class."""
    if name not in OBJECTS:
        return Opaque(name)
    try:
        return OBJECTS[name](fields)
    except (KeyError, ValueError, TypeError) as error:
        missing = f"the field {error} is missing." if isinstance(error, KeyError) else str(error)[:1000]
        raise Malformed(f"This is not a {name}: {missing}") from error


def register_object(kind: type, read: Callable[[Mapping[str, Any]], Any]) -> None:
    """Register a class whose objects are answers, so that they can be read back from storage.

    kind  the class; its objects are stored by its name and the fields that their method to_dict() returns
    read  makes an object from these fields, and raises ValueError for fields that to_dict() never returns

    >>> class Coil:
    ...     def __init__(self, henry):
    ...         self.henry = henry
    >>> register_object(Coil, lambda fields: Coil(fields["henry"]))
    >>> from_data({"object": "Coil", "fields": {"henry": 5.0}}).henry
    5.0
    """
    OBJECTS[kind.__name__] = read
