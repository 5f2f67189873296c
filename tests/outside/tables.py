"""Tables as the text that a student hands in: wrong ones, and right ones in another form."""

# fmt: off
from typing import Any

import numpy as np

from outside import Kinds, kinds_of, right_forms_of
from outside.motions import Array, at, chain
from outside.right import moved_columns
from outside.shared import CENTI, DEGREES, PLACEHOLDER, SIGN, SWAP, UNIT

TABLES = ("05.3", "06.7", "07.3", "07.4", "07.6")
A, ALPHA, D, THETA = range(4)


def as_text(rows: Any, joints: str, signs: Any = None, *, labels: Any = None, unit: str = "°") -> str:
    """Write a table as students do: angles in degrees, and q1, q2, ... in the column that moves.

    >>> print(as_text([[1, np.pi / 2, 0, -np.pi / 2]], "R"))
    a | alpha | d | theta
    1 | 90° | 0 | q1 - 90°
    """
    lines = ["a | alpha | d | theta"]
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


def moves_alike(table: Any, rows: Any, signs: Any) -> bool:
    """Whether rows move the tool as those of a table do, so that they are right too."""
    def poses(rows: Any, signs: Any) -> list[Array]:
        values = np.sin(np.outer(np.arange(1, 4), np.arange(1, table.n + 1)))
        return [chain(at(rows, table.joints, q * signs), table.convention) for q in values]

    return np.allclose(poses(rows, signs), poses(table.rows, table.signs), atol=1e-6)


def _with_a_slip(rows: Array) -> Kinds:
    """One number of the table is wrong."""
    negated, digit, one = rows.copy(), rows.copy(), rows.copy()
    negated[int(np.argmax(np.abs(rows[:, ALPHA]) > 0.1)), ALPHA] *= -1
    last = len(rows) - 1
    places = [(int(i), 2 * int(k)) for i, k in np.argwhere(np.abs(rows[:, [A, D]]) > 0)] or [(last, D)]
    place = (last, D) if abs(rows[last, D]) > 0 else places[-1]
    digit[place] += np.sign(rows[place]) or 1
    one[places[0]] *= -1
    return {
        "negated one alpha": (negated, SIGN + "|alpha"),
        "misread one length": (digit, "wrong number|look again|d|a|number"),
        "negated one length": (one, SIGN + "|wrong number|look again|a|d"),
    }


def _as_a_whole(rows: Array, joints: str, convention: str) -> Kinds:
    """All rows have the same fault."""
    n, off, reach = len(rows), rows.copy(), rows * (0, 1, 0, 1)
    off[np.array([[j == "R"] for j in joints]) & (np.arange(4) == THETA)] = 0
    reach[:, A] = np.hypot(rows[:, A], rows[:, D])
    swapped = [*reversed(range(min(n, 2))), *range(2, n)]
    shift = "row|convention|shift|a and alpha|column|one row"
    return {
        "dropped the offsets": (off, "offset|theta|zero|start"),
        "moved a and alpha one row, with 0 in the empty row": (moved_columns(rows, 1 if convention == "standard" else -1), shift),
        "negated every alpha": (rows * (1, -1, 1, 1), SIGN + "|alpha"),
        "swapped a and d in every row": (rows[:, [2, 1, 0, 3]], SWAP),
        "swapped alpha and theta in every row": (rows[:, [0, 3, 2, 1]], SWAP),
        "gave lengths in millimetres": (rows * (1000, 1, 1000, 1), UNIT),
        "gave lengths in centimetres": (rows * (100, 1, 100, 1), CENTI),
        "left every number at 0": (0 * rows, PLACEHOLDER + "|every"),
        "swapped rows 1 and 2": (rows[swapped], "row|order|swap"),
        "left every d at 0": (rows * (1, 1, 0, 1), "d|0"),
        "measured a from joint to joint": (reach, "normal|joint to joint|distance|d|a"),
    }


@kinds_of(*TABLES)
def tables(g: Any, table: Any) -> Kinds:
    rows, joints, signs = np.round(table.rows, 12), table.joints, np.array(table.signs, dtype=float)
    n = len(rows)
    first, last = np.where(np.arange(n) == 0, -1, 1), np.where(np.arange(n) == n - 1, -1, 1)
    made: Kinds = {
        "turned one joint the other way": ((rows, first * signs), SIGN + "|direction|q_1|joint 1"),
        "turned the last joint the other way": ((rows, last * signs), SIGN + "|direction"),
        "negated all theta and q": ((rows * (1, 1, 1, -1), -signs), SIGN + "|direction|theta"),
        **_with_a_slip(rows),
        **_as_a_whole(rows, joints, table.convention),
    }
    if hasattr(g, "home") and not np.allclose(table.base, np.eye(4)):
        moved = rows + np.outer(np.arange(n) == 0, np.arange(4) == D) * table.base[2, 3]
        made["forgot that frame 0 is not {s}"] = (moved, "base|frame 0|T_{s0}|d|start")
    texts: Kinds = {}
    for label, (changed, words) in made.items():
        of, turned = changed if isinstance(changed, tuple) else (changed, signs)
        if not moves_alike(table, of, turned):
            texts[label] = (as_text(of, joints, turned), words)
    return texts | _written_otherwise(rows, joints, signs)


def _written_otherwise(rows: Array, joints: str, signs: Array) -> Kinds:
    """The right numbers, written so that they say something else."""
    n, other = len(rows), joints.translate(str.maketrans("RP", "PR"))
    made: Kinds = {
        "typed angles in degrees without a sign": (as_text(rows, joints, signs, unit=""), DEGREES),
        "gave two joints the label q1": (as_text(rows, joints, signs, labels=[1, 1, *range(3, n + 1)]), "q1|q2|label|twice"),
        "put the variables in the other column": (as_text(rows, other, signs), "column|theta|prismatic|revolute|joints"),
    }
    return {label: case for label, case in made.items() if n > 1 or "label" not in label}


@right_forms_of(*TABLES)
def legal_tables(g: Any, table: Any) -> dict[str, Any]:
    """The same table in other forms: an inner x or z flipped, angles plus a turn, origins moved along parallel axes."""
    rows, n, k = np.array(table.rows), table.n, 0 if table.convention == "standard" else 1
    joints, signs = table.joints, np.array(table.signs, dtype=float)
    turn = 2 * np.pi * np.outer(np.arange(n) == n - 1, np.arange(4) == THETA)
    forms = {"theta less a full turn": as_text(rows - turn, joints, signs), "a table object": table}
    if n > 1:  # the normal along x_1 is in the first row, of a modified table in the second
        flip = rows.copy()
        flip[k, :2] *= -1
        flip[:2, THETA] += (np.pi, -np.pi)
        forms["x_1 flipped"] = as_text(flip, joints, signs)
    if n > 2 or (k == 0 and n == 2):  # joint 2 moves about z_1, of a modified table about z_2
        flip = rows.copy()
        flip[1, 2:] *= -1
        flip[k:k + 2, ALPHA] += np.pi
        forms["z of joint 2 flipped, with -q2"] = as_text(flip, joints, signs * np.where(np.arange(n) == 1, -1, 1))
    parallel = [i for i in range(1, n) if abs(np.sin(rows[i - 1 + k, ALPHA])) < 1e-9]
    for i in parallel[:1]:
        slid = rows.copy()
        slid[i - 1:i + 1, D] += 0.25, -0.25 * np.cos(rows[i - 1 + k, ALPHA])
        forms["an origin moved along parallel axes"] = as_text(slid, joints, signs)
    return forms
