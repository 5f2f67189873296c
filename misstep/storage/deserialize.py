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


def from_data(data: Any) -> Any:
    """Read a stored answer: arrays as NumPy arrays, formulas as SymPy, and what could not be stored as Opaque.

    Raises Malformed for JSON of any other form.

    >>> from_data({"array": [1.0, None], "shape": [2]})
    array([ 1., nan])
    """
    return _read(data, 0)


def _read(data: Any, depth: int) -> Any:
    if data is None:
        return None
    if not isinstance(data, dict) or depth > MAX_DEPTH + 1:
        raise Malformed("An answer must be null or a JSON object of a known form, and not nested without end.")
    read = READERS.get(frozenset(data))
    if read is None:
        raise Malformed(f"An answer has none of the forms with the keys {', '.join(sorted(map(str, data)))!r:.80}.")
    return read(next(iter(data.values())) if len(data) == 1 else data, depth)


def _string(text: Any, _: int) -> str:
    if not isinstance(text, str) or len(text) > MAX_CHARACTERS:
        raise Malformed(f"A text must be a string of at most {MAX_CHARACTERS} characters.")
    return text


def _items(items: Any, depth: int) -> list[Any]:
    if not isinstance(items, list) or len(items) > MAX_ENTRIES:
        raise Malformed(f"A list must be a JSON list of at most {MAX_ENTRIES} entries.")
    return [_read(item, depth + 1) for item in items]


def _entries(entries: Any, depth: int) -> dict[str, Any]:
    if not isinstance(entries, list) or len(entries) > MAX_ENTRIES:
        raise Malformed("A map must be a list of pairs of a name and a value.")
    return dict(_entry(entry, depth) for entry in entries)


def _numbers(flat: Any, shape: Any) -> Array:
    if not isinstance(flat, list) or not isinstance(shape, list):
        raise Malformed("An array must be a list of numbers, with the list of its sizes.")
    sizes = [size for size in shape if isinstance(size, int) and not isinstance(size, bool) and size >= 0]
    if len(flat) > MAX_ENTRIES or len(sizes) != len(shape) or len(shape) > MAX_DEPTH + 1:
        raise Malformed(f"An array must have a shape of whole numbers, and at most {MAX_ENTRIES} numbers.")
    if any(x is not None and (isinstance(x, bool) or not isinstance(x, int | float)) for x in flat):
        raise Malformed("An array must contain numbers only.")
    try:
        values = np.array([np.nan if x is None else float(x) for x in flat])
        return values.reshape(sizes)
    except (OverflowError, ValueError) as error:
        raise Malformed("The numbers of an array must fill its shape.") from error


def _truth(is_true: Any, _: int) -> bool:
    if not isinstance(is_true, bool):
        raise Malformed("A truth must be true or false.")
    return is_true


def _entry(entry: Any, depth: int) -> tuple[str, Any]:
    match entry:
        case [str() as key, value]:
            return key[:80], _read(value, depth + 1)
    raise Malformed("A map must be a list of pairs of a name and a value.")


def _object(data: dict[str, Any], depth: int) -> Any:
    """Return an object of a registered class, or Opaque for any other class."""
    name = _string(data["object"], depth)[:80]
    read = OBJECTS.get(name)
    fields = data["fields"]
    if not isinstance(fields, dict) or not all(isinstance(key, str) for key in fields):
        raise Malformed("An object must have the name of its class, and its fields by name.")
    if read is None:
        return Opaque(name)
    try:
        return read(fields)
    except KeyError as error:
        raise Malformed(f"This is not a {name}: the field {error} is missing.") from error
    except (ValueError, TypeError) as error:
        raise Malformed(f"This is not a {name}: {str(error)[:1000]}") from error


OBJECTS: dict[str, Callable[[Mapping[str, Any]], Any]] = {}
"""For each registered class, by its name, the function that makes an object from its fields."""


def register_object(kind: type, read: Callable[[Mapping[str, Any]], Any]) -> None:
    """Register a class whose objects are answers, so that they can be read back from storage.

    kind  the class; its objects are stored by its name and the fields that their method to_dict() returns
    read  makes an object from these fields, and raises ValueError for fields that to_dict() never returns

    >>> class Resistor:
    ...     def __init__(self, ohm):
    ...         self.ohm = ohm
    >>> register_object(Resistor, lambda fields: Resistor(fields["ohm"]))
    >>> from_data({"object": "Resistor", "fields": {"ohm": 5.0}}).ohm
    5.0
    """
    OBJECTS[kind.__name__] = read


READERS: dict[frozenset[str], Callable[[Any, int], Any]] = {
    frozenset({"number"}): lambda number, _: _numbers([number], [])[()],
    frozenset({"text"}): _string,
    frozenset({"array", "shape"}): lambda data, _: _numbers(data["array"], data["shape"]),
    frozenset({"truth"}): _truth,
    frozenset({"list"}): _items,
    frozenset({"map"}): _entries,
    frozenset({"object", "fields"}): _object,
    frozenset({"function"}): lambda name, depth: Opaque(f"function {_string(name, depth)[:80]}"),
    frozenset({"function", "outputs"}): lambda data, depth: Outputs(_items(data["outputs"], depth)),
    frozenset({"other"}): lambda name, depth: Opaque(_string(name, depth)[:200]),
}
"""How each form is read, by its set of keys. A form with a single key gets the value, other forms get the whole object."""
