"""What the digits of a table's numbers say.

A number that is typed as 0.43 stands for everything between 0.425 and 0.435, so a table with rounded numbers does not have the
poses of its arm, although nobody made a mistake. All lengths of a table are taken to have as many decimals as the one that has
the most, and so are all angles, in radians or in degrees, whichever takes fewer. The sum of what all of them can change is the
bound within which a table is right to the digits that are printed.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.tolerances import TYPED_PI_ERROR
from kinlib.arrays.validation import Array
from kinlib.dh.slips import ANGLES, LENGTHS
from kinlib.dh.table import DHTable, snapped

ALL_DECIMALS = 12
"""A number with so many decimals was not rounded by a person."""

MAX_TYPED_PI_ERROR = 2e-3
"""How far 3.14 is off."""


def typed_half_units(rows: Array) -> tuple[Array, str]:
    """Read from the digits of a table how far its numbers may be off, (m, 4) -> half units (m, 4), and the units in words."""
    lengths, angles = rows[:, LENGTHS].round(ALL_DECIMALS), rows[:, ANGLES]
    # Nobody rounds right angles; but the files of arms have pi / 2 with five digits.
    is_right = (np.abs(np.sin(2 * angles)) < TYPED_PI_ERROR) & (angles != 0)
    typed = angles[~is_right & (angles != 0)].round(ALL_DECIMALS)
    angle_decimals, degree_decimals, unit = _decimals(typed), _decimals(np.degrees(typed).round(9)), 1.0
    if degree_decimals + 3 < angle_decimals:
        angle_decimals, unit = degree_decimals, np.radians(1)
    # Programs print four significant digits: if no number has more, those with four of them may end there.
    digits = [len(_shortest(x).replace(".", "").lstrip("0")) for x in lengths.ravel()]
    ends = [_decimals(x) for x, count in zip(lengths.ravel(), digits, strict=True) if count == max(digits) == 4]
    length_decimals = min(ends, default=_decimals(lengths))
    # Zeros alone do not show how many decimals they have.
    if not typed.size:
        angle_decimals = ALL_DECIMALS if is_right.any() else length_decimals
    if not lengths.any():
        length_decimals = angle_decimals
    half = np.full(rows.shape, 0.5 * 10.0**-length_decimals)
    half[:, ANGLES] = np.maximum(0.5 * unit * 10.0**-angle_decimals, TYPED_PI_ERROR * (is_right | (not typed.size)))
    words = [f"lengths to {10.0**-length_decimals:g} m"] if length_decimals < ALL_DECIMALS else []
    if angle_decimals < ALL_DECIMALS:
        words.append(f"angles to {10.0**-angle_decimals:g}{' rad' if unit == 1 else '°'}")
    return np.maximum(half, np.spacing(np.abs(rows)) / 2), ", ".join(words)


def with_right_angles(table: DHTable) -> DHTable:
    """Return a table whose angles are exactly the multiples of 45 degrees that they have with at least three digits, such as 1.57."""
    right = snapped(table.rows, np.pi / 4, np.minimum(typed_half_units(table.rows)[0], MAX_TYPED_PI_ERROR))
    is_typed = (np.arange(4) % 2 == 1) & (right != 0) & (np.abs(right - table.rows) > 1e-12)
    return table.changed(rows=np.where(is_typed, right, table.rows))


def _shortest(number: float) -> str:
    """Write a number in the shortest form that reads back as the same number."""
    return np.format_float_positional(abs(number), trim="-")


def _decimals(numbers: ArrayLike) -> int:
    """Return how many decimals the number with the most of them has."""
    return max((len(_shortest(number).partition(".")[2]) for number in np.ravel(numbers)), default=0)


def rounding_effect(table: DHTable, half_unit: Array) -> float:
    """Bound the difference in an entry of a pose that the rounding of the numbers can make, in metres and radians.

        sum of the half units of all lengths + reach * sum of the half units of all angles

    The reach is the sum of all lengths, with the tool, and with prismatic joints moved by pi metres; it is at least 1, because a
    rotation matrix changes by the angle itself.
    """
    lengths = np.abs(table.rows[:, LENGTHS]) + half_unit[:, LENGTHS]
    reach = lengths.sum() + np.linalg.norm(table.tool[:3, 3]) + np.pi * table.joints.count("P")
    return float(half_unit[:, LENGTHS].sum() + max(1.0, reach) * half_unit[:, ANGLES].sum())
