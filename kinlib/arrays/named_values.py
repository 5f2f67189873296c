"""Joint values by name: a mapping from the name of each joint to its value, put in the order of the joints."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array

JointValues = ArrayLike | Mapping[str, ArrayLike]
"""The values q (..., n) of n joints, or the value (...) of each of them by its name."""


def in_order(values: Mapping[str, ArrayLike], names: Sequence[str], robot: str) -> Array:
    """Return the values (..., n) in the order of the n names; single numbers are repeated for every configuration.

    robot  its name, for messages

    Raises ValueError for a name that is not one of them, if one is missing, and for values of several shapes.

    >>> in_order({"knee": [1, 2, 3], "hip": 0.5}, ["hip", "knee"], "leg")
    array([[0.5, 1. ],
           [0.5, 2. ],
           [0.5, 3. ]])
    """
    if values and not names:
        raise ValueError(
            f"q must be an array, because the joints of {robot} have no names; got {validation.describe(values)}. Pass their "
            "values in order, or name the joints of a chain first, chain.changed(joint_names=[...])."
        )
    if unknown := [name for name in values if name not in names]:
        from difflib import get_close_matches

        close = get_close_matches(str(unknown[0]), names, n=1)
        advice = f"Did you mean {close[0]}?" if close else f"Its joint values are {_listed(names)}."
        raise ValueError(f"q must have the names of the joint values of {robot}; got {unknown[0]!r}. {advice}")
    if missing := [name for name in names if name not in values]:
        raise ValueError(
            f"q must have a value for each joint of {robot}; got none for {_listed(missing)}. "
            "Where no other value is given, it is 0 with dict.fromkeys(names, 0.0) | {...}."
        )
    columns = [validation.array(values[name], f"q[{name!r}]") for name in names]
    try:
        columns = [*np.broadcast_arrays(*columns)]
    except ValueError as error:
        shapes = ", ".join(f"{name} {column.shape}" for name, column in zip(names, columns, strict=True))
        raise ValueError(f"The values in q must have one shape, or be single numbers; got {shapes}.") from error
    return np.stack(columns, axis=-1) if columns else np.zeros(0)


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:12]) + ", ..." * (len(names) > 12)
