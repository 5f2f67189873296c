"""Slips in a whole DH table, and legal tables in another form, as the text that a student hands in."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from evidence.answers_by_hand.common.motions import Array, negated
from kinlib.dh.table import DHTable

A, ALPHA, D, THETA = range(4)
SIGN = "sign, negat, opposite, minus, other way"
NORMAL = "normal, joint to joint, distance"


def as_text(
    rows: Any, joints: str, signs: Any = None, *, labels: Sequence[int] | None = None, head: str = "", unit: str = "°"
) -> str:
    """Write a table as students do: angles in degrees, and q1, q2, ... in the column that moves.

    >>> print(as_text([[1, np.pi / 2, 0, -np.pi / 2]], "R"))
    a | alpha | d | theta
    1 | 90° | 0 | q1 - 90°
    """
    lines = [head or "a | alpha | d | theta"]
    for i, row in enumerate(rows):
        numbers = np.round([row[A], np.degrees(row[ALPHA]), row[D], np.degrees(row[THETA])], 9)
        cells = [f"{abs(x):.9g}{unit * (k % 2)}" if x else "0" for k, x in enumerate(numbers)]
        minus = [bool(x < 0) for x in numbers]
        k = THETA if joints[i] == "R" else D
        q = f"{'-' if signs is not None and signs[i] < 0 else ''}q{labels[i] if labels else i + 1}"
        texts = ["-" * below + cell for cell, below in zip(cells, minus, strict=True)]
        texts[k] = q + (f" {'-' if minus[k] else '+'} {cells[k]}" if numbers[k] else "")
        lines.append(" | ".join(texts))
    return "\n".join(lines)


def _link_columns_moved(rows: Array, convention: str) -> Array:
    """The rows of the other convention: a and alpha in the next row, or from modified in the one before."""
    step, empty = (1, 0) if convention == "standard" else (-1, -1)
    moved = rows.copy()
    moved[:, :2] = np.roll(rows[:, :2], step, axis=0)
    moved[empty, :2] = 0
    return moved


def table_slips(table: DHTable) -> dict[str, tuple[Any, str]]:
    """Wrong tables as text, by what was done, with the words for it; those that change no number are left out."""
    rows, joints, n, convention = np.round(table.rows, 12), table.joints, len(table.rows), table.convention
    turns = np.array([letter == "R" for letter in joints])[:, None] & (np.arange(4) == THETA)
    lengths, step = np.arange(4) % 2 == 0, 1 if convention == "standard" else -1
    other = _link_columns_moved(rows, convention)
    rolled = {k: np.where(np.arange(4) == k, np.roll(rows, step, axis=0), rows) for k in range(4)}
    reach = np.hypot(rows[:, A], rows[:, D])
    on_links = rows.copy()
    on_links[:, A], on_links[:, D] = reach, 0.0
    first, swap = int(np.argmax(rows[:, ALPHA] != 0)), [*reversed(range(min(n, 2))), *range(2, n)]

    def flipped(i: int, k: int) -> Array:
        return negated(rows, (i, k))

    wrong: dict[str, tuple[Array, str]] = {
        "a and d swapped": (rows[:, [2, 1, 0, 3]], "swap, exchang, interchang"),
        "alpha and theta swapped": (rows[:, [0, 3, 2, 1]], "swap, exchang, interchang"),
        "both pairs of columns swapped": (rows[:, [2, 3, 0, 1]], "swap, exchang, interchang, order of the columns"),
        "rows one place down": (np.roll(rows, 1, axis=0), "row, convention"),
        "rows one place up": (np.roll(rows, -1, axis=0), "row, convention"),
        "rows 1 and 2 swapped": (rows[swap], "row"),
        "rows in reverse": (rows[::-1], "row, reverse"),
        "alpha one row off": (rolled[ALPHA], "alpha, row, convention"),
        "a one row off": (rolled[A], "column a, row, convention, $a$"),
        "d one row off": (rolled[D], "column d, row, $d$"),
        "rows of the other convention": (other, "convention, other joint, wrong joint, row"),
        "every alpha negated": (rows * (1, -1, 1, 1), "alpha"),
        "every a negated": (rows * (-1, 1, 1, 1), SIGN),
        "every d negated": (rows * (1, 1, -1, 1), SIGN),
        "every theta negated": (rows * (1, 1, 1, -1), SIGN + ", theta, offset, zero"),
        "every number negated": (-rows, SIGN),
        "no minus sign anywhere": (np.abs(rows), SIGN + ", absolute"),
        "no offsets": (np.where(turns, 0.0, rows), "offset, theta, zero"),
        "every alpha 0": (rows * (1, 0, 1, 1), "alpha"),
        "0 for one right angle": (rows * np.where(np.outer(np.arange(n) == first, np.arange(4) == ALPHA), 0, 1), "alpha"),
        "a from joint to joint": (on_links, f"{NORMAL}, d has a wrong number, a has a wrong number"),
        "d left out": (rows * (1, 1, 0, 1), "left out, forgot, missing, $d$, every d, column d, look again at d"),
        "lengths in millimetres": (np.where(lengths, 1000, 1) * rows, "millimet, mm, 1000, unit"),
        "lengths in centimetres": (np.where(lengths, 100, 1) * rows, "centimet, cm, 100, unit"),
        "a and d swapped, alpha negated": (rows[:, [2, 1, 0, 3]] * (1, -1, 1, 1), "swap, exchang, alpha, " + SIGN),
        "no offsets, alpha one row off": (np.where(turns, 0.0, rolled[ALPHA]), "offset, alpha, row"),
        "rows 1 and 2 swapped, a negated": (rows[swap] * (-1, 1, 1, 1), "row, " + SIGN),
        **{
            f"{name}{i + 1} negated": (flipped(i, k), f"{name} in row {i + 1}, {SIGN}" + (", theta, zero" if k == THETA else ""))
            for i in range(n)
            for k, name in enumerate(("a", "alpha", "d", "theta"))
        },
        **{
            f"{name}{i + 1} too long": (rows + rows[i, k] / 2 * np.outer(np.arange(n) == i, np.arange(4) == k), "entry, row, length")
            for i, k, name in ((0, D, "d"), (n - 1, A, "a"), (n // 2, A, "a"))
        },
    }  # fmt: skip
    texts = {
        label: (as_text(changed, joints, table.signs), words)
        for label, (changed, words) in wrong.items()
        if not _same_numbers(changed, rows)
    }
    head = "a_{i-1} | alpha_{i-1} | d_i | theta_i" if convention == "standard" else "a_i | alpha_i | d_i | theta_i"
    labels = {"q2, q1": [2, 1, *range(3, n + 1)], "q1, q1": [1, 1, *range(3, n + 1)]} if n > 1 else {}
    if (degrees := as_text(rows, joints, table.signs, unit="")) != as_text(rows, joints, table.signs):
        texts["degrees without a degree sign"] = degrees, "degree, radian"
    return texts | {
        **{
            f"labels {first_two}": (as_text(rows, joints, table.signs, labels=order), "q1, q2, label, order, twice")
            for first_two, order in labels.items()
        },
        "variables in the other column": (
            as_text(rows, joints.translate(str.maketrans("RP", "PR")), table.signs), "column, theta, prismatic, revolute, joints"),
        "a joint's variable in d": (as_text(rows, _other_letter(joints, 0), table.signs), "column, theta, prismatic, revolute, joints"),
        "heading and rows of the other convention": (as_text(other, joints, table.signs, head=head), "convention, i-1, heading"),
        "an object of the other convention": (table.converted("modified" if convention == "standard" else "standard"), "convention"),
    }  # fmt: skip


def legal_tables(table: DHTable) -> dict[str, Any]:
    """The same table in other forms: an inner x or z flipped, angles plus a turn, origins moved along parallel axes."""
    rows, n, standard = np.array(table.rows), len(table.rows), table.convention == "standard"
    signs, joints = np.array(table.signs, dtype=float), table.joints
    turned = signs * np.where(np.arange(n) == 1, -1, 1)
    full_turn = 2 * np.pi * np.outer(np.arange(n) == n - 1, np.arange(4) == THETA)
    forms: dict[str, Any] = {
        "theta less a full turn": as_text(rows - full_turn, joints, signs),
        "alpha plus a full turn": as_text(rows + full_turn[:, [0, 3, 2, 1]], joints, signs),
        "a DHTable": DHTable(rows, convention=table.convention, joints=joints, signs=signs, base=table.base, tool=table.tool),
    }  # fmt: skip
    if n > 1:
        flip, k = (
            rows.copy(),
            0 if standard else 1,
        )  # the normal along x_1 is in the first row, of a modified table in the second
        flip[k, :2] *= -1
        flip[:2, THETA] += (np.pi, -np.pi)
        forms["x_1 flipped"] = as_text(flip, joints, signs)
    if n > 2 or (standard and n == 2):
        z_flip, k = rows.copy(), 0 if standard else 1  # joint 2 moves about z_1, of a modified table about z_2
        z_flip[1, 2:] *= -1
        z_flip[k : k + 2, ALPHA] += np.pi
        forms["z of joint 2 flipped, with -q2"] = as_text(z_flip, joints, turned)
    for i in range(1, n):  # axes of joints i and i + 1, counted from 1
        row = i - 1 if standard else i
        if abs(np.sin(rows[row, ALPHA])) < 1e-9:
            slid = rows.copy()
            slid[i - 1, D] += 0.25
            slid[i, D] -= 0.25 * np.cos(rows[row, ALPHA])
            forms[f"origin moved along the parallel axes {i} and {i + 1}"] = as_text(slid, joints, signs)
            break
    return forms


def _other_letter(joints: str, i: int) -> str:
    return joints[:i] + {"R": "P", "P": "R"}[joints[i]] + joints[i + 1 :]


def _same_numbers(one: Array, other: Array) -> bool:
    """Whether two tables hold the same numbers, angles modulo a turn."""
    difference = one - other
    return bool(np.allclose(difference[:, ::2], 0) and np.allclose(np.sin(difference[:, 1::2] / 2), 0))
