"""What the digits of a table's numbers say: how far each number may be off, and whether that alone explains other poses.

A number that is typed as 0.43 stands for everything between 0.425 and 0.435, so a table with rounded numbers does not have the
poses of its arm, although nobody made a mistake. All lengths of a table are taken to have as many decimals as the one that has
the most, and so are all angles, in radians or in degrees, whichever takes fewer.
"""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kinlib.arrays.tolerances import EQUIVALENCE_TOL, PARALLEL_TOL_RAD, ROUNDING_ERROR, TYPED_PI_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.chains.joint_maps import CHECKED_CONFIGURATIONS, JointMap, joint_maps, linearized
from kinlib.dh.equivalence import Equivalence, equivalent
from kinlib.dh.invariants import neighbours
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.table import DHTable, _moved_rows
from kinlib.rigid.lie import exp

FIT_STEPS = 60
"""How many corrections are tried until the rounded numbers give the poses of the arm."""

ALMOST_1 = 1.05
"""How much farther than by its rounding a number may be off, because the fit ends before it is exact."""

LARGEST_MAPPED_EFFECT = 0.1
"""If rounding changes the poses by more than this, in metres and radians, or by this fraction of the sine between two axes, no map
of the axes can be found through it."""

ROUGH, MAX_STARTS = 0.5, 6
"""How far the axes may be off then, in metres and radians, and how many maps are tried."""

ROW_SCREWS = {
    "theta": (0, 0, 1, 0, 0, 0),
    "d": (0, 0, 0, 0, 0, 1),
    "a": (0, 0, 0, 1, 0, 0),
    "alpha": (1, 0, 0, 0, 0, 0),
}
"""The screw axes of the four motions of a row, in the frame that it begins with; all of them pass through its origin."""

FACTORS = {"standard": ("theta", "d", "a", "alpha"), "modified": ("alpha", "a", "theta", "d")}
"""The order of these motions by convention."""


@dataclass(frozen=True, eq=False)
class Rounding:
    """How far the numbers of a table may be off, and what that explains.

    half_unit  (m, 4) half a unit in the last decimal of each number, in metres and radians
    units      the last decimals in words
    effect     the largest difference in an entry of a pose that it can make
    verdict    "explains", if some numbers within these bounds give the poses of the arm; "excluded", if none can; or "possible"
    nearest    the comparison of table and arm with the effect as tolerance
    """

    half_unit: Array
    units: str
    effect: float
    verdict: Literal["explains", "possible", "excluded"]
    nearest: Equivalence

    @property
    def limit(self) -> str:
        """A sentence on what rounding explains; empty if no number was rounded."""
        if not self.units:
            return ""
        return f"The rounding of its numbers ({self.units}) explains a difference of at most {self.effect:.2g}."


def judge_rounding(table: DHTable, arm: Chain, fixed: Collection[str]) -> Rounding:
    """Judge whether the rounding of its numbers explains why a table does not have the poses of an arm."""
    half_unit, units = typed_half_units(table.rows)
    effect = rounding_effect(table, half_unit)
    nearest = equivalent(table, arm, fixed=fixed, tolerance=max(effect, EQUIVALENCE_TOL))
    verdict: Literal["explains", "possible", "excluded"] = "possible"
    if nearest.verdict == "same":
        starts = [nearest] if effect <= LARGEST_MAPPED_EFFECT else _starts(table, arm, nearest, frozenset(fixed))
        if any(_fits(table, arm, start, half_unit, frozenset(fixed)) for start in starts):
            verdict = "explains"
    sines = neighbours(arm.lines).sine
    smallest = sines[sines > PARALLEL_TOL_RAD].min(initial=1.0)
    is_far = nearest.verdict == "different" and effect <= LARGEST_MAPPED_EFFECT * smallest
    if verdict == "possible" and (is_far or _is_excluded(table, arm, half_unit)):
        verdict = "excluded"
    return Rounding(half_unit, units, effect, verdict, nearest)


def _starts(table: DHTable, arm: Chain, nearest: Equivalence, fixed: frozenset[str]) -> list[Equivalence | JointMap]:
    """Return maps from which to fit numbers that are rounded so much that the axes agree only roughly."""
    rough = joint_maps(table.to_chain(), arm, fixed, ROUGH)
    return [nearest, *sorted(rough, key=lambda each: each.difference)[:MAX_STARTS]]


def typed_half_units(rows: Array) -> tuple[Array, str]:
    """Read from the digits of a table how far its numbers may be off, (m, 4) -> half units (m, 4), and the units in words."""
    lengths, angles = rows[:, [0, 2]], rows[:, [1, 3]]
    # Nobody rounds right angles; but the files of arms have pi / 2 with five digits.
    is_right = (np.abs(np.sin(2 * angles)) < ROUNDING_ERROR) & (angles != 0)
    typed = angles[~is_right & (angles != 0)]
    degrees, unit = np.degrees(typed), 1.0
    length_decimals, angle_decimals = _decimals(lengths), _decimals(typed)
    # A number in degrees was converted, so its last digit in radians is lost.
    is_in_degrees = (np.abs(degrees - degrees.round(6)) <= 4 * np.spacing(np.abs(degrees))).all()
    if is_in_degrees and _decimals(degrees.round(6)) + 2 < angle_decimals:
        angle_decimals, unit = _decimals(degrees.round(6)), np.radians(1)
    # Zeros alone do not show how many decimals they have.
    if not typed.size:
        angle_decimals = ALL_DECIMALS if is_right.any() else length_decimals
    if not lengths.any():
        length_decimals = angle_decimals
    half = np.empty(rows.shape)
    half[:, [0, 2]] = 0.5 * 10.0**-length_decimals
    half[:, [1, 3]] = np.maximum(0.5 * unit * 10.0**-angle_decimals, TYPED_PI_ERROR * (is_right | (not typed.size)))
    words = [f"lengths to {10.0**-length_decimals:g} m"] if length_decimals < ALL_DECIMALS else []
    if angle_decimals < ALL_DECIMALS:
        words.append(f"angles to {10.0**-angle_decimals:g}{' rad' if unit == 1 else '°'}")
    return np.maximum(half, np.spacing(np.abs(rows)) / 2), ", ".join(words)


ALL_DECIMALS = 15
"""A number with as many decimals was not rounded by a person."""


def _decimals(numbers: Array) -> int:
    """Return how many decimals the number with the most of them has, in the shortest form that reads back as the same number."""
    texts = (np.format_float_positional(number, trim="-") for number in numbers.ravel())
    return max((len(text.partition(".")[2]) for text in texts), default=0)


def rounding_effect(table: DHTable, half_unit: Array) -> float:
    """Bound the difference in an entry of a pose that the rounding of the numbers can make, in metres and radians.

        sum of the half units of all lengths + reach * sum of the half units of all angles

    The reach is the sum of all lengths, with the tool, and with prismatic joints moved by pi metres; it is at least 1, because a
    rotation matrix changes by the angle itself.
    """
    lengths = np.abs(table.rows[:, [0, 2]]) + half_unit[:, [0, 2]]
    reach = lengths.sum() + np.linalg.norm(table.tool[:3, 3]) + np.pi * table.joints.count("P")
    return float(half_unit[:, [0, 2]].sum() + max(1.0, reach) * half_unit[:, [1, 3]].sum())


def _fits(table: DHTable, arm: Chain, nearest: Equivalence | JointMap, half_unit: Array, fixed: frozenset[str]) -> bool:
    """Whether some numbers within half a unit of the typed ones give the poses of the arm, up to the choices that are free.

    The four motions of each row are those of a chain of 4 m joints whose values are the numbers. So its body Jacobian says how
    the poses change with the numbers, and the smallest change of all numbers that closes the gap is found by least squares, and
    brought back into the bounds, in turn.
    """
    order = [COLUMNS.index(name) for name in FACTORS[table.convention]]
    motions = Chain(np.tile([ROW_SCREWS[COLUMNS[k]] for k in order], (len(table.rows), 1)), np.eye(4))
    q = random_configurations(arm.n, CHECKED_CONFIGURATIONS)
    numbers = _moved_rows(table, table.rows, nearest.signs * q + nearest.offsets)
    scale, bounded = half_unit.copy(), np.ones(half_unit.shape, bool)
    for entry in joint_entries(table.joints) if "zeros" not in fixed else ():
        scale[entry], bounded[entry] = 1.0, False
    ends = [np.full(6, float(name not in fixed)) for name in ("base", "tool")]
    scales, is_bounded = scale[:, order].ravel(), bounded[:, order].ravel()
    values, changes = numbers[:, :, order].reshape(len(q), -1), np.zeros(scales.size)
    X, Y, target = nearest.base @ table.base, table.tool @ nearest.tool, arm.fk(q)
    for _ in range(FIT_STEPS):
        error, J = linearized(X, motions, values + scales * changes, Y, target)
        step = np.linalg.lstsq(J * [*ends[0], *scales, *ends[1]], -error, rcond=1e-12)[0]
        if not np.isfinite(step).all() or np.abs(step).max() > MAX_STEP:
            return False  # the fit does not converge
        X, Y, changes = exp(ends[0] * step[:6]) @ X, Y @ exp(ends[1] * step[-6:]), changes + step[6:-6]
        if np.abs(scales * changes).max() > MAX_STEP:
            return False
        is_near = np.abs(changes[is_bounded]).max() <= ALMOST_1
        if is_near and largest_difference(X @ motions.fk(values + scales * changes) @ Y, target) <= EQUIVALENCE_TOL:
            return True
        changes[is_bounded] = changes[is_bounded].clip(-1, 1)
    return False


MAX_STEP = 1e6
"""A fit with a larger step, in metres, radians and half units, does not converge."""


def _is_excluded(table: DHTable, arm: Chain, half_unit: Array) -> bool:
    """Whether two neighbouring axes have an angle or a distance that no table has whose numbers round to these.

    The angle is alpha itself and the distance a itself, unless a row without a joint lies between, or the axes are so nearly
    parallel that another alpha would make it another distance.
    """
    if "F" in table.joints:
        return False
    length, angle = half_unit[:, [0, 2]].max() + EQUIVALENCE_TOL, half_unit[:, [1, 3]].max() + EQUIVALENCE_TOL
    ours, right = neighbours(table.to_chain().lines), neighbours(arm.lines)
    if (np.abs(ours.angle - right.angle) > ALMOST_1 * angle).any():
        return True
    between_lines = [arm.joint_types[i : i + 2] == "RR" for i in range(arm.n - 1)]
    is_fixed = between_lines & (np.minimum(ours.angle, right.angle) > 2 * angle + 1e-3)
    return bool((is_fixed & (np.abs(ours.distance - right.distance) > ALMOST_1 * length)).any())
