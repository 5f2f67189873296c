"""Values that are no answer to any problem, as students or attackers may hand them in."""

import numpy as np
import sympy

from misstep.answers.number import Numbers

HOSTILE = {
    "a string": "screw",
    "an empty list": [],
    "a ragged list": [[1, 2], [3]],
    "a dictionary": {"S": 1},
    "NaN in every shape": np.full((4, 4), np.nan),
    "infinity": np.full(6, np.inf),
    "a symbol": sympy.Symbol("x"),
    "a symbolic matrix": sympy.Matrix(sympy.symarray("x", (4, 4))),
    "complex numbers": np.full((3, 6), 1j),
    "a huge array": np.zeros((4000, 4000)),
    "a long list": [0.0] * 100_000,
    "a deep list": [[[[[[0.0]]]]]],
    "a function": np.sin,
    "a class": Numbers,
    "objects": np.array([[object()] * 4] * 4),
    "a list of None": [None] * 6,
    "bytes": b"\x00" * 6,
}


class Rude:
    """An object that raises whenever NumPy asks it for anything."""

    def __array__(self, *args, **kwargs):
        raise RuntimeError("no")

    def __repr__(self):
        raise RuntimeError("no")
