"""Answers by hand to sheet 06: DH tables in the modified convention."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common.kinematics import at, chain, link, one_entry, ordinary_forms, pose_slips, turn
from evidence.answers_by_hand.common.motions import Array, product
from evidence.answers_by_hand.common.tables import SIGN, as_text, legal_tables, table_slips
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP, row_slips
from kinlib.dh.table import DHTable

RADIANS_TO_DEGREES = (1, 180 / np.pi, 1, 180 / np.pi)


@wrong_answers("06.1")
def link_transform(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from row_slips((given.a, given.alpha, given.d, given.theta), "modified")


@wrong_answers("06.2")
def axial_screws(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    a, alpha, d, theta = given.a, given.alpha, given.d, given.theta

    def pair(alpha: float, a: float, theta: float, d: float) -> Array:
        return np.array([[alpha, 0, 0, a, 0, 0], [0, 0, theta, 0, 0, d]])

    x = pair(alpha, a, theta, d)
    halves, deg = np.roll(x, 3, axis=1), np.degrees
    yield from wrong(
        {
            "halves swapped": (halves, "(v, half, halves, " + SWAP),
            "joint first": (x[::-1], "first, order, convention"),
            "theta for alpha": (pair(theta, a, theta, d), "theta, alpha"),
            "alpha and theta swapped": (pair(theta, a, alpha, d), "theta, alpha, " + SWAP),
            "a and d swapped": (pair(alpha, d, theta, a), SWAP),
            "unit screws": (pair(1, a / alpha, 1, d / theta), "unit, angle, radian, axis"),
            "unit axes, lengths kept": (pair(1, a, 1, d), "unit, angle, radian, axis"),
            "lengths over the angles": (pair(alpha, a / alpha, theta, d / theta), "pitch, angle, divid, unit"),
            "lengths times the angles": (pair(alpha, a * alpha, theta, d * theta), "pitch, angle, multipl"),
            "degrees": (pair(deg(alpha), a, deg(theta), d), "degree, radian"),
            "one angle in degrees": (pair(deg(alpha), a, theta, d), "degree, radian"),
            "alpha negated": (pair(-alpha, a, theta, d), "alpha, " + SIGN),
            "theta negated": (pair(alpha, a, -theta, d), "theta, " + SIGN),
            "d negated": (pair(alpha, a, theta, -d), SIGN),
            "all negated": (-x, SIGN + ", invers"),
            "axes x and z swapped": ([[0, 0, alpha, 0, 0, a], [theta, 0, 0, d, 0, 0]], "axis, about, " + SWAP),
            "a along z, d along x": ([[alpha, 0, 0, 0, 0, a], [0, 0, theta, d, 0, 0]], "along, axis, " + SWAP),
            "a along y": ([[alpha, 0, 0, 0, a, 0], [0, 0, theta, 0, d, 0]], "along, axis, " + SWAP),
            "no lengths": (pair(alpha, 0, theta, 0), "length, shift, translation, slide, moment, " + LEFT_OUT),
            "no angles": (pair(0, a, 0, d), "angle, turn, rotation, omega, " + LEFT_OUT),
            "d left out": (pair(alpha, a, theta, 0), "moment, " + LEFT_OUT),
            "second screw seen from frame i-1": (
                [x[0], [0, -theta * np.sin(alpha), theta * np.cos(alpha), 0, -d * np.sin(alpha), d * np.cos(alpha)]],
                "frame, already, turned"),
            "halves swapped, joint first": (halves[::-1], f"(v, half, order, first, {SWAP}, convention"),
            "degrees, a and d swapped": (pair(deg(alpha), d, deg(theta), a), f"degree, radian, {SWAP}"),
            "halves swapped, alpha negated": (np.roll(pair(-alpha, a, theta, d), 3, axis=1), f"(v, half, alpha, {SIGN}, {SWAP}"),
        }
    )  # fmt: skip
    yield from right({**ordinary_forms(x), "alpha plus a full turn": pair(alpha + 2 * np.pi, a, theta, d)})


def _conversions(given: Any, down: bool) -> Iterator[WrongAnswer]:
    """A table of the other convention is the same numbers with a and alpha in the next row (down) or in the one before."""
    rows, (by, empty) = np.array(given.rows), (1, 0) if down else (-1, -1)
    n = len(rows)

    def moved(columns: Any, by: int = by, lost: int | None = empty) -> Array:
        changed = rows.copy()
        changed[:, columns] = np.roll(rows[:, columns], by, axis=0)
        if lost is not None:
            changed[lost, columns] = 0.0
        return changed

    T = moved([0, 1])
    kept = T.copy()
    kept[empty, :2] = rows[empty, :2]
    shift = "row, next, previous, move, belong"
    inner = np.arange(n) == 2
    yield from wrong(
        {
            "as printed": (rows, "as they stand, not converted, printed, convention"),
            "the other way": (moved([0, 1], -by, -1 if down else 0), shift),
            "whole rows moved": (moved([0, 1, 2, 3]), shift),
            "d and theta moved": (moved([2, 3], -by, -1 if down else 0), shift),
            "alpha alone moved": (moved([1]), shift + ", alpha"),
            "a alone moved": (moved([0]), shift + ", alpha"),
            "alpha and theta moved": (moved([1, 3]), shift + ", theta"),
            "the end folded in": (moved([0, 1], by, None), shift + ", left over, left-over, base, tool, empty"),
            "the end kept": (kept, shift + ", left over, left-over, base, tool, empty, twice"),
            "two rows too far": (moved([0, 1], 2 * by, None), shift + ", two"),
            "degrees": (T * RADIANS_TO_DEGREES, "degree, radian"),
            "only alpha in degrees": (T * (1, 180 / np.pi, 1, 1), "degree, radian"),
            "alpha negated": (T * (1, -1, 1, 1), f"alpha, {SIGN}"),
            "alpha of row 3 negated": (np.where(np.outer(inner, np.arange(4) == 1), -T, T), f"alpha, {SIGN}"),
            "theta of row 3 negated": (np.where(np.outer(inner, np.arange(4) == 3), -T, T), f"theta, {SIGN}"),
            "d of row 3 negated": (np.where(np.outer(inner, np.arange(4) == 2), -T, T), SIGN),
            "a and d swapped": (T[:, [2, 1, 0, 3]], SWAP),
            "alpha and theta swapped": (T[:, [0, 3, 2, 1]], SWAP),
            "in Craig's order alpha, a, d, theta": (T[:, [1, 0, 2, 3]], f"order, column, {SWAP}"),
            "rows in reverse": (T[::-1], "row, reverse, order"),
            "theta 0 where it moves": (
                np.where(np.outer([j == "R" for j in given.joints], np.arange(4) == 3), 0.0, T), "theta, offset, q = 0"),
            "millimetres": (T * (1000, 1, 1000, 1), "millimet, mm, 1000, unit"),
            "whole rows moved, degrees": (moved([0, 1, 2, 3]) * RADIANS_TO_DEGREES, shift + ", degree"),
            "alpha alone moved, degrees": (moved([1]) * RADIANS_TO_DEGREES, shift + ", degree"),
            "the other way, alpha negated": (moved([0, 1], -by, -1 if down else 0) * (1, -1, 1, 1), shift + ", alpha"),
        }
    )  # fmt: skip
    flipped, k = T.copy(), 1 if down else 0
    flipped[k, :2] *= -1
    flipped[:2, 3] += (np.pi, -np.pi)
    turned = T + 2 * np.pi * np.outer(np.arange(n) == 1, np.arange(4) == 1)
    yield from right({**ordinary_forms(T), "alpha_1 plus a turn": turned, "x_1 flipped": flipped})


@wrong_answers("06.3")
def to_modified(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _conversions(given, down=True)


@wrong_answers("06.4")
def to_standard(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _conversions(given, down=False)


@wrong_answers("06.5")
def which_convention(given: Any, answer: str) -> Iterator[WrongAnswer]:
    words = {
        "a": "standard",
        "b": "modified",
        "c": "both, either, same pose, two readings",
        "d": "fault, neither, readings, one of the two conventions",
    }
    yield from other_letters(words, answer)


@wrong_answers("06.6")
def faulty_entry(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    row, column, value = answer
    printed = given.rows[int(row) - 1, int(column) - 1]
    other, axis = {1: 3, 2: 4, 3: 1, 4: 2}[int(column)], {1: 2, 2: 1, 3: 4, 4: 3}[int(column)]
    R, p = given.poses[int(row) - 1][:3, :3], given.poses[int(row) - 1][:3, 3]
    whole = {
        1: p[0],
        2: np.arctan2(-R[1, 2], R[2, 2]),
        3: p[2],
        4: np.arctan2(-R[0, 1], R[0, 0]),
    }[int(column)]
    lines = "row, Row"
    yield from wrong(
        {
            "counted from 0": ([row - 1, column - 1, value], "from 0, Python"),
            "only the row from 0": ([row - 1, column, value], lines),
            "only the column from 0": ([row, column - 1, value], "column, from 0"),
            "the next row": ([row % 3 + 1, column, value], lines),
            "the other of its kind": ([row, other, value], f"column, kind, along, about, x_, z_, {SWAP}"),
            "the other of its axis": ([row, axis, value], "column, angle, length"),
            "in the order column, row": ([column, row, value], f"order, row, column, {SWAP}"),
            "what is printed": ([row, column, printed], "printed, value"),
            "negated": ([row, column, -value], f"{SIGN}, invers, way back"),
            "the difference": ([row, column, value - printed], "differ, value, correction"),
            "corrected the wrong way": ([row, column, 2 * printed - value], f"wrong way, {SIGN}, value"),
            "0": ([row, column, 0], "value"),
            "read off the pose in frame 0": ([row, column, whole], "frame 0, {}^0, i-1, value"),
            "from 0, printed value": ([row - 1, column - 1, printed], "from 0, Python, printed, value"),
            "row before, printed value": ([row - 1, column, printed], "row, printed, value"),
            "row before, negated": ([row - 1, column, -value], f"row, {SIGN}, invers"),
            **({"degrees": ([row, column, np.degrees(value)], "degree, radian"),
                "from 0, degrees": ([row - 1, column - 1, np.degrees(value)], "degree, radian, from 0, Python")}
               if column in (2, 4) else
               {"millimetres": ([row, column, 1000 * value], "millimet, mm, 1000, unit"),
                "from 0, negated": ([row - 1, column - 1, -value], f"from 0, Python, {SIGN}, invers")}),
        }
        | ({} if row != column else {"in the order column, row": ([row, column, -value], SIGN + ", invers, way back")})
    )  # fmt: skip
    turned = {"the angle plus a turn": [row, column, value + 2 * np.pi]} if column in (2, 4) else {}
    yield from right({**ordinary_forms(answer), "a tuple": (int(row), int(column), round(value, 4)), **turned})


@wrong_answers("06.7")
def wrist(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    degrees = np.array(given.degrees)
    t = np.radians(degrees)
    alphas = np.array([-1, 1, -1]) * np.pi / 2

    def wrist_of(t: Any, alphas: Any = alphas, convention: str = "modified") -> Array:
        return chain([(0, alpha, 0, angle) for alpha, angle in zip(alphas, t, strict=True)], convention)[:3, :3]

    factors = [wrist_of([angle], [alpha]) for angle, alpha in zip(t, alphas, strict=True)]
    yzy = product(turn("y", t[0]), turn("z", t[1]), turn("y", t[2]))
    C, R = turn("x", -np.pi / 2), wrist_of(t)
    yield from wrong(
        {
            "Y-Z-Y alone": (yzy, "constant, Euler, R_x"),
            "constant on the left": (C @ yzy, "left, constant, order"),
            "constant inverted": (yzy @ C.T, "constant, +90, R_x"),
            "Z-Y-Z alone": (product(turn("z", t[0]), turn("y", t[1]), turn("z", t[2])), "constant, Z-Y-Z, Euler, R_x"),
            "standard": (wrist_of(t, alphas, "standard"), "standard, convention"),
            "last row first": (product(*factors[::-1]), "order, reverse, row 6, theta_6, exchang"),
            "rows 4 and 5 swapped": (product(factors[1], factors[0], factors[2]), f"order, row, {SWAP}"),
            "degrees": (wrist_of(degrees), "degree, radian"),
            "transposed": (R.T, "transpos, R^T, invers, {}^6R_3"),
            "every alpha negated": (wrist_of(t, -alphas), "alpha"),
            "alpha_4 negated": (wrist_of(t, alphas * (1, -1, 1)), "alpha"),
            "alpha_3 negated": (wrist_of(t, alphas * (-1, 1, 1)), "alpha"),
            "every alpha 0": (wrist_of(t, 0 * alphas), "alpha"),
            "first alpha left out": (wrist_of(t, alphas * (0, 1, 1)), "alpha"),
            "alpha one row off": (wrist_of(t, [0, *alphas[:2]]), "alpha, row"),
            "theta_5 negated": (wrist_of(t * (1, -1, 1)), f"theta, {SIGN}"),
            "every theta negated": (wrist_of(-t), f"theta, {SIGN}, backward"),
            "theta_5 left out": (wrist_of(t * (1, 0, 1)), f"theta, {LEFT_OUT}"),
            "at zero": (wrist_of(0 * t), f"zero, {LEFT_OUT}, joint values"),
            "the last row left out": (product(*factors[:2]), LEFT_OUT + ", row, stopped"),
            "entry by entry": (factors[0] * factors[1] * factors[2], "element, entry, matrix product, rotation"),
            "X-Y-Z": (product(turn("x", t[0]), turn("y", t[1]), turn("z", t[2])), "axis, axes, alpha, about"),
            "alpha and theta swapped": (wrist_of(alphas, t), SWAP),
            "sign of one entry": (one_entry(R, (0, 0), -R[0, 0]), f"{SIGN}, entry, rotation"),
            "standard, last row first": (wrist_of(t[::-1], alphas[::-1], "standard"), "standard, convention, order, reverse"),
            "Y-Z-Y alone, theta_5 negated": (product(turn("y", t[0]), turn("z", -t[1]), turn("y", t[2])), f"constant, R_x, {SIGN}"),
            "transposed, every alpha negated": (wrist_of(t, -alphas).T, "transpos, R^T, invers, alpha"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(R))


@wrong_answers("06.8")
def rpr(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    rows, values = np.array(given.rows), np.array(given.values)
    q = values * (np.pi / 180, 1, np.pi / 180)
    T = [link(row, "modified") for row in at(rows, "RPR", q)]
    M = product(*T)

    def of(rows: Any, q: Any = q, joints: str = "RPR", convention: str = "modified") -> Array:
        return chain(at(rows, joints, q), convention)

    shifted = np.column_stack([rows[:, 0], np.roll(rows[:, 1], -1), rows[:, 2:]])
    in_a = of(rows + np.outer([0, 1, 0], [q[1], 0, 0, 0]), q * (1, 0, 1))
    yield from wrong(
        {
            **pose_slips(M),
            "last row first": (product(*T[::-1]), "order, reverse, last"),
            "rows 2 and 3 swapped": (product(T[0], T[2], T[1]), f"order, row, {SWAP}"),
            "the other convention": (of(rows, convention="standard"), "convention"),
            "the prismatic variable in theta": (of(rows, joints="RRR"), "prismatic, slide, theta, column"),
            "the prismatic variable in a": (in_a, "a_1, along, slide, z_2"),
            "degrees": (of(rows, values), "degree, radian"),
            "d_2 converted to radians too": (of(rows, np.radians(values)), "degree, radian, slide, length"),
            "alpha negated": (of(rows * (1, -1, 1, 1)), "alpha"),
            "alpha of row 2 negated": (of(one_entry(rows, (1, 1), -rows[1, 1])), "alpha"),
            "alpha of row 3 negated": (of(one_entry(rows, (2, 1), -rows[2, 1])), "alpha"),
            "alpha one row off": (of(shifted), "alpha, row, convention"),
            "alpha 0": (of(rows * (1, 0, 1, 1)), "alpha"),
            "a_1 left out": (of(rows * (0, 1, 1, 1)), LEFT_OUT + ", a_1"),
            "d_2 left out": (of(rows, q * (1, 0, 1)), LEFT_OUT + ", d_2, slide"),
            "d_2 negated": (of(rows, q * (1, -1, 1)), SIGN + ", slide, d_2"),
            "theta_1 negated": (of(rows, q * (-1, 1, 1)), SIGN + ", theta"),
            "theta_3 negated": (of(rows, q * (1, 1, -1)), SIGN + ", theta"),
            "every joint backwards": (of(rows, -q), SIGN + ", backward, transpos"),
            "theta_1 and theta_3 swapped": (of(rows, q[::-1]), SWAP + ", order, theta"),
            "a_1 and d_2 swapped": (of(one_entry(rows, (1, 0), q[1]), (q[0], rows[1, 0], q[2])), SWAP),
            "at zero": (of(rows, 0 * q), "zero, home, joint values, left out, not moved"),
            "the last row left out": (T[0] @ T[1], f"{LEFT_OUT}, row, stopped"),
            "entry by entry": (T[0] * T[1] * T[2], "element, entry, matrix product"),
            "other convention, alpha negated": (of(rows * (1, -1, 1, 1), convention="standard"), "convention, alpha"),
            "last row first, variable in theta": (
                chain(at(rows, "RRR", q)[::-1], "modified"), "order, reverse, last, slide, theta, prismatic"),
            "alpha negated, theta_1 negated": (of(rows * (1, -1, 1, 1), q * (-1, 1, 1)), f"alpha, {SIGN}"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(M))


def _yzy(E: Array) -> Array:
    """The angles of E = R_y(a) R_z(b) R_y(c), by the textbook formula for b in (0, pi)."""
    b = np.arccos(np.clip(E[1, 1], -1, 1))
    return np.array([np.arctan2(E[2, 1], -E[0, 1]), b, np.arctan2(E[1, 2], E[1, 0])])


@wrong_answers("06.9")
def angles_of_a_wrist(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    first, second = np.array(given.rotations)
    C = turn("x", -np.pi / 2)
    t4, t5, t6 = regular = _yzy(first @ C.T)
    S = second @ C.T
    total = np.arctan2(S[0, 2], S[2, 2])
    singular = np.array([0, 0, total])
    constant = "constant, R_x"

    def both(one: Any, other: Any = singular) -> Array:
        return np.array([one, other], dtype=float)

    yield from wrong(
        {
            "the constant left in R": (both(_yzy(first), _yzy(second)), constant),
            "the constant removed with the wrong sign": (both(_yzy(first @ C), _yzy(second @ C)), constant),
            "the constant removed from the left": (both(_yzy(C.T @ first), _yzy(C.T @ second)), constant),
            "R transposed": (both(_yzy(first.T @ C.T), _yzy(second.T @ C.T)), "transpos, R^T, invers"),
            "degrees": (np.degrees(both(regular)), "degree, radian"),
            "the first in degrees": (both(np.degrees(regular)), "degree, radian"),
            "theta_6 first": (both(regular[::-1], singular[::-1]), "order, reverse"),
            "theta_5 negated": (both(regular * (1, -1, 1)), "theta_5, half, 180, " + SIGN),
            "all negated": (-both(regular), SIGN),
            "theta_4 off by half a turn": (both([t4 + np.pi, t5, t6]), "half, 180, theta_4"),
            "theta_6 off by half a turn": (both([t4, t5, t6 - np.pi]), "half, 180, theta_6"),
            "theta_4 and theta_6 by arctan": (both([t4 + np.pi, t5, t6 + np.pi]), "half, 180, theta"),
            "theta_4 left at 0": (both([0, t5, t6]), f"theta_4, {LEFT_OUT}"),
            "theta_6 left at 0": (both([t4, t5, 0]), f"theta_6, {LEFT_OUT}"),
            "the sum twice": (both(regular, [total, 0, total]), "sum, collinear"),
            "the singular one left at 0": (both(regular, [0, 0, 0]), f"theta_6, collinear, {LEFT_OUT}"),
            "the singular sum negated": (both(regular, [0, 0, -total]), f"collinear, {SIGN}"),
            "rotations swapped": (both(singular, regular), SWAP + ", row"),
            "degrees, constant left in": (np.degrees(both(_yzy(first), _yzy(second))), f"{constant}, degree, radian"),
        }
    )
    other = both([t4 + np.pi, -t5, t6 + np.pi], [0.4, 0, total - 0.4])
    yield from right(
        {**ordinary_forms(both(regular)), "the second solution": other, "with full turns": both(regular) + 2 * np.pi}
    )


@wrong_answers("06.10")
def whole_arm(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    yield from wrong(table_slips(answer))
    text = as_text(answer.rows, answer.joints, answer.signs)
    for k, length in enumerate(given.lengths, start=1):
        text = text.replace(f"{length:g}", f"l_{k}")
    yield from right({**legal_tables(answer), "lengths as letters": text})


@wrong_answers("06.11")
def telescope_mount(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.rows(answer))
