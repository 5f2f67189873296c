"""Common mistakes in DH tables: each function takes the right table and returns the wrong one that the mistake leads to.

`table_mistakes` gives the mistakes of a problem whose answer is a table, by their names in TABLE_MISTAKES.
"""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from kincourse.sampling.drawn_machines import is_in_several_rows
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import Convention, DHTable
from misstep.mistakes import Mistake, mistake

A, ALPHA, D, THETA = range(4)


def z_on_the_wrong_joint(table: DHTable) -> DHTable:
    """Frames placed by the rule of the other convention, with their rows multiplied by the rule of this one.

    For a standard table z_i lies on the axis of joint i, which is the rule of the modified convention; for a modified
    table z_i lies on the axis of joint i+1.

    >>> z_on_the_wrong_joint(DHTable([[1, 0, 0, 0], [2, 0, 0, 0]], convention="standard")).columns["a"]
    array([0., 1.])
    """
    return table.changed(rows=table.converted(_other(table.convention)).rows)


def alpha_shifted(table: DHTable) -> DHTable:
    """The column alpha shifted by one row: alpha_{i-1} in row i of a standard table, alpha_i in row i of a modified one.

    >>> alpha_shifted(DHTable([[0, 1, 0, 0], [0, 2, 0, 0]], convention="standard")).columns["alpha"]
    array([0., 1.])
    """
    rows = table.rows.copy()
    step = 1 if table.convention == "standard" else -1
    rows[:, ALPHA] = np.roll(rows[:, ALPHA], step)
    rows[0 if step == 1 else -1, ALPHA] = 0.0
    return table.changed(rows=rows)


def in_degrees(table: DHTable) -> DHTable:
    """Angles given in degrees but read as radians, less full turns.

    >>> in_degrees(DHTable([[0, np.pi / 2, 0, 0]], convention="standard")).columns["alpha"].round(4)
    array([2.0354])
    """
    rows = table.rows.copy()
    rows[:, [ALPHA, THETA]] = np.degrees(rows[:, [ALPHA, THETA]]) % (2 * np.pi)
    return table.changed(rows=rows)


def without_offset(table: DHTable) -> DHTable:
    """theta = q without an offset, in the row of each revolute joint."""
    rows = table.rows.copy()
    rows[[letter == "R" for letter in table.joints], THETA] = 0.0
    return table.changed(rows=rows)


def base_in_a_row(table: DHTable) -> DHTable:
    """The translation of the base written into the first row, its x into a and its z into d, and no base."""
    rows = table.rows.copy()
    rows[0, [A, D]] += table.base[[0, 2], 3]
    return table.changed(rows=rows, base=np.eye(4))


def tool_in_a_row(table: DHTable) -> DHTable:
    """The translation of the tool written into the last row, its x into a and its z into d, and no tool."""
    rows = table.rows.copy()
    rows[-1, [A, D]] += table.tool[[0, 2], 3]
    return table.changed(rows=rows, tool=np.eye(4))


def off_the_normal(table: DHTable) -> DHTable:
    """a measured from joint to joint, and no d, so that x_i lies along the link and not along the common normal.

    >>> off_the_normal(DHTable([[3, 0, 4, 0]], convention="standard")).columns["a"]
    array([5.])
    """
    rows = table.rows.copy()
    slanted = np.array([letter != "P" for letter in table.joints]) & (rows[:, A] != 0)
    rows[slanted, A] = np.hypot(rows[slanted, A], rows[slanted, D])
    rows[slanted, D] = 0.0
    return table.changed(rows=rows)


class TableMistake(NamedTuple):
    """A function that makes the mistake in a right table, and the message for a student who made it."""

    change: Callable[[DHTable], DHTable]
    message: str


TABLE_MISTAKES: Mapping[str, TableMistake] = {
    "the other convention": TableMistake(
        lambda table: table.changed(convention=_other(table.convention)),
        "You multiplied the rows in the other convention. A standard row is $R_z T_z T_x R_x$, joint first; a modified row is "
        "$R_x T_x R_z T_z$, common normal first. The same numbers describe another arm.",
    ),
    "z on the wrong joint": TableMistake(
        z_on_the_wrong_joint,
        "You put $z_i$ on the wrong joint. In the standard convention $z_i$ lies on the axis of joint $i + 1$, in the "
        "modified one on that of joint $i$. Your rows are those of the other convention.",
    ),
    "alpha one row off": TableMistake(
        alpha_shifted,
        "Your column $\\alpha$ is shifted by one row. In a standard table row $i$ holds $\\alpha_i$, from $z_{i-1}$ to $z_i$; "
        "in a modified one it holds $\\alpha_{i-1}$.",
    ),
    "a and d swapped": TableMistake(
        lambda table: table.changed(rows=table.rows[:, [D, ALPHA, A, THETA]]),
        "You swapped $a$ and $d$. $d$ is measured along $z$, the joint axis, and $a$ along $x$, the common normal.",
    ),
    "sign of alpha": TableMistake(
        lambda table: table.changed(rows=table.rows * (1, -1, 1, 1)),
        "Every $\\alpha$ has the wrong sign. Point your right thumb along $x$, the common normal: $\\alpha$ is positive if your "
        "fingers curl from the first $z$ to the next.",
    ),
    "degrees": TableMistake(
        in_degrees,
        "Your angles are in degrees, but numbers without a unit are read as radians. Write `np.pi / 2`, or 90° in a text.",
    ),
    "no offset": TableMistake(
        without_offset,
        "You wrote $\\theta = q$ and left out the offsets. $\\theta$ is the angle between two $x$ axes: its value in the drawing, "
        "where $q = 0$, is added to $q$.",
    ),
    "prismatic variable in theta": TableMistake(
        lambda table: table.changed(joints=table.joints.replace("P", "R")),
        "You put the variable of a prismatic joint into $\\theta$. A prismatic joint changes $d$; its $\\theta$ is a constant.",
    ),
    "off the normal": TableMistake(
        off_the_normal,
        "You measured $a$ from joint to joint. $x_i$ runs along the common normal, perpendicular to both axes; the distance "
        "along the axis is $d$.",
    ),
}


def table_mistakes(table: DHTable, *names: str) -> list[Mistake]:
    """The mistakes of these names for a problem whose answer is the table."""
    found = []
    for name in names:
        change, message = TABLE_MISTAKES[name]
        wrong = change(table)
        found.append(mistake(name, wrong, message, spoils=is_in_several_rows(wrong.rows, table.rows)))
    return found


def _other(convention: Convention) -> Convention:
    return "modified" if convention == "standard" else "standard"


def entry_names(n: int) -> dict[str, str]:
    """The entries of a table with n rows, as a student types them, in words.

    >>> entry_names(1)["alpha1"]
    'alpha in row 1'
    """
    return {f"{column}{row}": f"{column} in row {row}" for row in range(1, n + 1) for column in COLUMNS}


def other_entries(faulty: str, n: int, convention: Convention) -> list[Mistake]:
    """The choices of an entry that agrees with the drawn frames, where one entry of a table with n rows is faulty.

    Each is told what this entry is, and nothing of the faulty one: a row or a column that is right would be half the answer.

    >>> other_entries("d1", 1, "modified")[0].message
    'This entry agrees with the frames: a in row 1 is the distance from $z_0$ to $z_1$ along $x_0$. Compare the others with them.'
    """
    return [_other_entry(chosen, name, convention) for chosen, name in entry_names(n).items() if chosen != faulty]


def _other_entry(chosen: str, name: str, convention: Convention) -> Mistake:
    column, row = chosen[:-1], int(chosen[-1])
    x, z = (row, row - 1) if convention == "standard" else (row - 1, row)
    measured, about = ("z", f"$x_{x}$") if column in ("a", "alpha") else ("x", f"$z_{z}$")
    what = f"angle from ${measured}_{row - 1}$ to ${measured}_{row}$ about {about}"
    if column in ("a", "d"):
        what = f"distance from ${measured}_{row - 1}$ to ${measured}_{row}$ along {about}"
    text = f"This entry agrees with the frames: {name} is the {what}. Compare the others with them."
    return mistake("another entry", chosen, text)
