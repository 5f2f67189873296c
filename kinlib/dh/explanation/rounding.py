"""What the digits of a table's numbers say, and the few other numbers with which the table would describe an arm.

A number that is typed as 0.43 stands for everything between 0.425 and 0.435, so a table with rounded numbers does not have the
poses of its arm, although nobody made a mistake. All lengths of a table are taken to have as many decimals as the one that has
the most, and so are all angles, in radians or in degrees, whichever takes fewer. The sum of what all of them can change is the
bound within which a table is right to the digits that are printed.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.tolerances import TYPED_PI_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.alignment import COMPARED_CONFIGURATIONS, Map, fitted, nearest_maps
from kinlib.dh.equivalence import ROUGH, equivalent
from kinlib.dh.explanation.search import TableExplanation
from kinlib.dh.parsing import joint_entries
from kinlib.dh.slips import ANGLES, LENGTHS, wrong_number
from kinlib.dh.table import DHTable, snapped
from kinlib.rigid.lie import wrap_angle

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


def explain_by_numbers(
    table: DHTable, arm: Chain, fixed: frozenset[str], half_unit: Array, noise: float
) -> list[TableExplanation]:
    """Find few other numbers with which a table describes the arm, the largest difference first; [] if none are found."""
    if table.joints.replace("F", "") != arm.joint_types:
        return []
    tolerance, half = max(noise, 1e-6), np.maximum(half_unit, 1e-6)
    is_free = np.zeros(half.shape, dtype=bool)
    is_free[tuple(np.transpose(joint_entries(table.joints)))] = "zeros" not in fixed
    same, *rough = nearest_maps(table.to_chain(), arm, fixed, tolerance, ROUGH)
    for start in [same, *sorted(rough, key=lambda each: each.difference)[:2]]:
        change = _few_changes(table, arm, start, fixed, np.where(is_free, 1.0, half))
        is_changed = ~is_free & (np.abs(change) > 1.05 * half)
        right = (table.rows + change).round(7)
        right[:, ANGLES] = wrap_angle(right[:, ANGLES])  # a fit may have made full turns
        nearest = table.changed(rows=np.where(is_changed, right, table.rows))
        if equivalent(nearest, arm, fixed=fixed, tolerance=tolerance).verdict == "same":
            off = np.abs(nearest.rows - table.rows)
            places = sorted(np.argwhere(off > 0).tolist(), key=lambda place: -off[tuple(place)])
            faults = [wrong_number(table, row, column, float(right[row, column])) for row, column in places]
            return [TableExplanation(faults, nearest, 2 * len(faults))]
    return []


def _few_changes(table: DHTable, arm: Chain, start: Map, fixed: frozenset[str], unit: Array) -> Array:
    """Find changes (m, 4) of few numbers after which a table describes an arm, from a map that nearly does.

    The four motions of each row are those of a chain of 4 m joints whose values are the numbers. So its body Jacobian says how
    the poses change with the numbers, and each step is a least-squares problem, in which an entry costs its change in units, and
    less, the more it changed in the step before.
    """
    order = [3, 2, 0, 1] if table.convention == "standard" else [1, 0, 3, 2]
    axes = np.eye(6)[[3, 0, 5, 2]]  # of a, alpha, d, theta in the frame that the row begins with
    motions = Chain(np.tile(axes[order], (len(table.rows), 1)), np.eye(4))
    q = random_configurations(arm.n, COMPARED_CONFIGURATIONS)
    values = np.tile(table.rows, (len(q), 1, 1))
    row, column = np.transpose(joint_entries(table.joints))
    values[:, row, column] += table.signs[row] * (start.signs * q + start.offsets)
    values = values[..., order].reshape(len(q), -1)
    X, Y, target = start.base @ table.base, table.tool @ start.tool, arm.fk(q)
    base, tool = (np.full(6, float(name not in fixed)) for name in ("base", "tool"))
    # Of parallel axes, any d can change; it is the one that is given.
    first, units = np.where(table.rows[:, order] == 0, 0.1, 1.0).ravel(), unit[:, order].ravel()

    def scale(change: Array) -> Array:
        weights = np.abs(change / units) + 1e-2 if change.any() else first
        return np.concatenate([base, units * weights, tool])

    change = fitted(motions, values, X, Y, target, scale, steps=20)[1]
    return change.reshape(-1, 4)[:, np.argsort(order)]
