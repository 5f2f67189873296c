"""Answers as JSON: they are read back as they were given, and JSON of any other form is refused."""

import json

import numpy as np
import pytest
import sympy as sp
from hostile_answers import Rude
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.storage import OBJECTS, Opaque, Outputs, from_data, to_data


def sent(value, inputs=()):
    """A value that was written as strict JSON and read back."""
    return from_data(json.loads(json.dumps(to_data(value, inputs), allow_nan=False)))


q, a = sp.symbols("q_1 a", positive=True)


def test_a_formula_is_read_back_as_the_same_formula():
    for value in (
        a * sp.cos(q) + sp.sin(q) ** 2 / 3,
        sp.sqrt(2) / 2,
        sp.exp(-q) * sp.atan2(a, q),
        sp.Float("0.25") * a - 7,
        sp.Abs(q - a),
        sp.I * sp.pi * sp.I,
        sp.Rational(3, 7) ** a,
        sp.Matrix([[a, 1], [0, sp.pi]]),
    ):
        right = ClosedForm(value)
        assert all(right.agrees(right.read(sent(value)), value)), value
    numbers = Numbers(np.array([np.pi / 2, 0.25, 2]))
    assert all(numbers.agrees(numbers.read(sent([sp.pi / 2, sp.Rational(1, 4), 2])), numbers.value))


@given(st.lists(st.lists(st.floats(allow_nan=True), min_size=3, max_size=3), min_size=1, max_size=4))
def test_finite_numbers_of_arrays_and_lists_are_read_back_exactly(rows):
    expected = np.where(np.isfinite(rows), rows, np.nan)
    np.testing.assert_array_equal(sent(np.array(rows)), expected)
    np.testing.assert_array_equal(sent(rows), expected)


class Resistor:
    """An object of a course that is an answer."""

    def __init__(self, ohm):
        if not isinstance(ohm, float):
            raise ValueError("The resistance must be a number in ohms.")
        self.ohm = ohm

    def to_dict(self):
        return {"ohm": self.ohm}


OBJECTS["Resistor"] = lambda fields: Resistor(fields["ohm"])


def test_an_object_is_read_back_if_its_class_is_registered_and_its_fields_are_json_and_otherwise_named():
    class Capacitor(Resistor):
        pass

    assert sent(Resistor(4.7)).ohm == 4.7
    assert sent(Capacitor(4.7)) == Opaque("Capacitor")
    for value in (object(), float("nan"), "x" * 200_000, {1j: 2}):
        odd = Resistor(4.7)
        odd.ohm = value
        assert isinstance(sent(odd), Opaque)


def test_a_function_is_called_at_the_inputs_and_cannot_change_them():
    inputs = [(np.ones(2),), (np.zeros(2),)]
    outputs = sent(lambda x: np.add(x, 1, out=x), inputs)
    assert isinstance(outputs, Outputs)
    np.testing.assert_array_equal(outputs.values, [[2, 2], [1, 1]])
    assert inputs[0][0].sum() == 2


def test_a_value_that_cannot_be_stored_is_described():
    assert sent(object()) == Opaque("object")
    for large in (np.zeros((4000, 4000)), [0.5] * 100_000, "x" * 200_000, [[[0.5] * 1000] * 1000] * 1000):
        assert sent(large) == Opaque(f"{type(large).__name__} that is too large")
    assert sent(np.sin) == Opaque("function sin")
    shared, nested = sp.Symbol("x"), [0]
    for _ in range(60):
        shared = sp.sin(shared) + sp.cos(shared)
    for _ in range(2000):
        nested = [nested]
    for odd, error in ((Rude(), "RuntimeError"), (shared, "ValueError"), (nested, "RecursionError")):
        assert sent(odd) == Opaque(f"{type(odd).__name__} that raises {error} when it is read")


MALFORMED = (
    *("text", 7, {}, {7: 7}, {"\ud800": 1}, {"other": None}, {"number": 10**400}, {"text": 7}, {"truth": 1}),
    *({"array": [1, 2], "shape": [3]}, {"array": [1, [2]], "shape": [2]}, {"array": [], "shape": [2**62] * 2}),
    *({"list": [7]}, {"map": {}}, {"map": [["a"]]}, {"function": "f", "outputs": [7]}),
    *(
        {"object": 7, "fields": {}},
        {"object": "Resistor", "fields": {}},
        {"object": "Resistor", "fields": {"ohm": "7"}},
    ),
)


def test_json_of_any_other_form_is_refused():
    for data in MALFORMED:
        with pytest.raises(ValueError, match=r"\w"):
            from_data(data)
