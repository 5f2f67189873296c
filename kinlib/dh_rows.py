"""Rows of DH tables as people type them: lists, dictionaries, or the text of a slide.

Whatever the form, a row ends up as four numbers (a, alpha, d, theta), the kind of its joint and the joint's sign. An
entry may hold the joint variable (`q1`, `theta_1`, `d_2`), pi, fractions, and lengths that have names. Angles are radians;
degrees count as degrees only where the text says so, in the head of the column or behind the number.
"""

import ast
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from kinlib import check
from kinlib.check import Array

COLUMNS = ("a", "alpha", "d", "theta")
ANGLES = ("alpha", "theta")

NAMES = {
    "α": "alpha",
    "θ": "theta",
    "ψ": "alpha",
    "psi": "alpha",
    "twist": "alpha",
    "length": "a",
    "offset": "d",
    "angle": "theta",
}
"""What other documents call the columns; the EduFill module writes psi where others write alpha."""

INDEX = {"", "i", "link", "joint", "row", "#"}
VARIABLE = re.compile(r"(q|theta|d)_?\d*")


@dataclass(frozen=True, eq=False)
class Rows:
    """A table that was read: numbers (m, 4) in the order of COLUMNS, joint kinds as letters R, P or F, signs (m,)."""

    numbers: Array
    joints: str
    signs: Array


def read_rows(rows: Any, joints: str | None = None, lengths: Mapping[str, float] | None = None) -> Rows:
    """Read a table in any of its forms.

    rows     text with a head, a sequence of {"a": ..., "alpha": ..., "d": ..., "theta": ...}, or numbers (m, 4) in that order
    joints   letters R, P, F, one a row; read from the variables if they are there. F is a row without a joint
    lengths  values for names such as l2 that an entry uses

    Raises ValueError that names the row and the column.

    >>> read_rows('''i | alpha | a  | d  | theta
    ...             1 | 0     | 0  | 0  | q1
    ...             2 | -90°  | l2 | q2 | -90°''', lengths={"l2": 0.5}).numbers.round(3)
    array([[ 0.   ,  0.   ,  0.   ,  0.   ],
           [ 0.5  , -1.571,  0.   , -1.571]])
    """
    if isinstance(rows, str):
        rows = _table(rows)
    if not isinstance(rows, Sequence) or not any(isinstance(row, Mapping) for row in rows):
        numbers = check.vectors(rows, "rows", 4)
        if numbers.ndim != 2:
            raise ValueError(f"rows should have shape (m, 4), with columns {', '.join(COLUMNS)}; got {numbers.shape}.")
        return _finished(numbers, joints or "R" * len(numbers), np.ones(len(numbers)))
    cells = [
        [_cell(row, column, number, lengths or {}) for column in COLUMNS] for number, row in enumerate(rows, start=1)
    ]
    found, signs = zip(*(_joint(row, number) for number, row in enumerate(cells, start=1)), strict=True)
    letters = "".join(found)
    if joints is not None and joints != letters:
        raise ValueError(
            f"joints says {joints}, and the variables in the table say {letters}. Which rows have a joint?"
        )
    return _finished(np.array([[constant for constant, _ in row] for row in cells]), letters, np.array(signs))


def _finished(numbers: Array, joints: str, signs: Array) -> Rows:
    if len(joints) != len(numbers) or set(joints) - set("RPF"):
        raise ValueError(f"joints should have a letter R, P or F for each of the {len(numbers)} rows; got {joints!r}.")
    if set(joints) <= {"F"}:
        raise ValueError(
            "A table should have at least one joint; every row here is fixed. Is q1 missing from an entry?"
        )
    for column in ANGLES:
        values = numbers[:, COLUMNS.index(column)]
        if (far := np.abs(values) > 4 * np.pi).any():
            row = int(np.argmax(far))
            raise ValueError(
                f"Row {row + 1}: {column} = {values[row]:g} rad is more than two full turns. Is it in degrees? "
                f"Then write {values[row]:g}°, or head the column {column} (deg)."
            )
    return Rows(numbers, joints, signs)


def _joint(row: Sequence[tuple[float, float]], number: int) -> tuple[str, float]:
    """The kind and the sign of a row's joint, from the coefficients of its variable."""
    moving = {column: factor for column, (_, factor) in zip(COLUMNS, row, strict=True) if factor}
    if not moving:
        return "F", 1.0
    if len(moving) > 1 or set(moving) <= {"a", "alpha"}:
        raise ValueError(
            f"Row {number}: the joint variable belongs in theta or in d, once; it stands in {', '.join(moving)}."
        )
    ((column, factor),) = moving.items()
    if abs(factor) != 1:
        raise ValueError(
            f"Row {number}: the joint variable in {column} should stand alone, as q or -q; its factor is {factor:g}."
        )
    return ("R" if column == "theta" else "P"), factor


def _table(text: str) -> list[dict[str, str]]:
    """Cut a text into rows of entries by column name."""
    lines = [line for line in text.strip().splitlines() if line.strip(" |-+:\t")]
    if len(lines) < 2:
        raise ValueError("A table as text needs a head and at least one row, such as 'a | alpha | d | theta'.")
    head = [_column(cell) for cell in _cells(lines[0])]
    names = [name for name, _ in head]
    if sorted(name for name in names if name in COLUMNS) != sorted(COLUMNS):
        raise ValueError(f"The head should name the columns {', '.join(COLUMNS)}, each once; got {', '.join(names)}.")
    rows = []
    for number, line in enumerate(lines[1:], start=1):
        cells = _cells(line)
        if len(cells) == len(head) + 1 and cells[0].rstrip(".") == str(number):
            cells = cells[1:]  # rows are numbered under a head that leaves their column without a name
        if len(cells) != len(head):
            raise ValueError(f"Row {number} has {len(cells)} entries under {len(head)} heads: {line.strip()!r}.")
        entries = zip(head, cells, strict=True)
        rows.append({name: f"{cell}°" if degrees and _is_plain(cell) else cell for (name, degrees), cell in entries})
    return rows


def _cells(line: str) -> list[str]:
    line = line.strip()
    if "|" in line:
        return [cell.strip() for cell in line.strip("|").split("|")]
    return re.split(r"\s{2,}|\t", line) if re.search(r"\s{2,}|\t", line) else line.split()


def _column(head: str) -> tuple[str, bool]:
    """The name of a column, and whether its numbers are degrees: "alpha_{i-1} (deg)" is ("alpha", True)."""
    degrees = bool(re.search(r"deg|°", head))
    name = re.sub(r"\(.*?\)|\[.*?\]|[\\${}]|_.*|°", "", head).strip().lower()
    return ("index" if name in INDEX else NAMES.get(name, name)), degrees


def _is_plain(cell: str) -> bool:
    return bool(re.fullmatch(r"[-+−]?[\d.]+", cell.strip()))


def _cell(row: Mapping[str, Any], column: str, number: int, lengths: Mapping[str, float]) -> tuple[float, float]:
    """An entry as (constant, factor of the joint variable)."""
    if column not in row:
        raise ValueError(
            f"Row {number} has no {column}. Each row names all of {', '.join(COLUMNS)}; write 0 for nothing."
        )
    entry = row[column]
    place = f"Row {number}, {column}"
    if not isinstance(entry, str):
        return float(check.array(entry, place)), 0.0
    text = entry.replace("−", "-").replace("π", "pi").replace("θ", "theta").replace("^", "**").replace(" ", "")
    text = re.sub(r"\\?d?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)", text)
    text = re.sub(r"[\\{}$]", "", text)
    if ("°" in text or "deg" in text) and column not in ANGLES:
        raise ValueError(f"{place}: {entry!r} is an angle, and {column} is a length. Are two columns exchanged?")
    text = re.sub(r"([\d.]+)(°|deg)", r"(\1*pi/180)", text)
    try:
        return _value(ast.parse(text, mode="eval").body, column, lengths)
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError) as error:
        hint = (
            f"Give lengths={{{error.args[0]!r}: ...}}"
            if isinstance(error, KeyError)
            else "Try 0.5, pi/2, q1 + pi/2 or -90°"
        )
        raise ValueError(f"{place}: {entry!r} is no number with at most a joint variable. {hint}.") from error


def _value(node: ast.expr, column: str, lengths: Mapping[str, float]) -> tuple[float, float]:
    """Work out sums, differences and fractions; nothing else is in the language, so nothing else can be run."""
    match node:
        case ast.Constant(value=int() | float() as value):
            return float(value), 0.0
        case ast.Name(id=name):
            return _named(name, column, lengths)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=operand):
            constant, factor = _value(operand, column, lengths)
            return (-constant, -factor) if isinstance(sign, ast.USub) else (constant, factor)
        case ast.BinOp(left=left, op=op, right=right):
            return _combined(op, _value(left, column, lengths), _value(right, column, lengths))
    raise TypeError(ast.dump(node))


def _named(name: str, column: str, lengths: Mapping[str, float]) -> tuple[float, float]:
    if name in lengths:
        return float(lengths[name]), 0.0
    if name == "pi":
        return np.pi, 0.0
    # d_3 beside theta_3 is a length that was not given; alone in the column d it is what moves.
    if VARIABLE.fullmatch(name) and (column == "d" or name[0] != "d"):
        return 0.0, 1.0
    raise KeyError(name)


def _combined(op: ast.operator, one: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    (x, p), (y, r) = one, other
    match op:
        case ast.Add():
            return x + y, p + r
        case ast.Sub():
            return x - y, p - r
        case ast.Mult() if not (p and r):
            return x * y, p * y + r * x
        case ast.Div() if not r:
            return x / y, p / y
    raise TypeError(ast.dump(op))
