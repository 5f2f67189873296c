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

from kinlib.arrays import validation
from kinlib.arrays.validation import Array

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

VARIABLE = re.compile(r"(q|theta|d)_?\d*", re.ASCII)

WORDS = re.compile(r"(?:(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])|[A-Za-z_]\w*\b|[-+*/()\s])*", re.ASCII)
"""What an entry is written in: numbers, names, signs. Python reads 0x1F and 1_000 as numbers too; people do not."""

LARGEST, LONGEST = 100_000, 200
"""The largest text and the longest entry that are read, in letters: no table that people type has more."""

FARTHEST = 1e12
"""The longest a and d, in metres: beyond it a pose keeps no millimetre. Nearly parallel axes are met far away, but not there."""


@dataclass(frozen=True, eq=False)
class Rows:
    """A table that was read: numbers (m, 4) in the order of COLUMNS, joint kinds as letters R, P or F, signs (m,).

    The signs are those of the joint variables in the entries. A table of numbers has none, so its signs are None.
    """

    numbers: Array
    joints: str
    signs: Array | None


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
    if joints is not None and not isinstance(joints, str):
        raise ValueError(f"joints should be text, a letter for each row; got {validation.describe(joints)}.")
    lengths, degrees = _lengths(lengths), set[str]()
    if isinstance(rows, str):
        rows, degrees = _table(rows)
    if not isinstance(rows, Sequence) or not any(isinstance(row, Mapping) for row in rows):
        numbers = validation.vectors(rows, "rows", 4)
        if numbers.ndim != 2:
            raise ValueError(f"rows should have shape (m, 4), with columns {', '.join(COLUMNS)}; got {numbers.shape}.")
        return _finished(numbers, joints or "R" * len(numbers), None)
    cells = [
        [_cell(row, column, number, lengths, column in degrees) for column in COLUMNS]
        for number, row in enumerate(rows, start=1)
    ]
    found, signs = zip(*(_joint(row, number) for number, row in enumerate(cells, start=1)), strict=True)
    letters = "".join(found)
    if joints is not None and joints != letters:
        raise ValueError(
            f"joints says {joints:.60}, and the variables in the table say {letters}. Which rows have a joint?"
        )
    return _finished(np.array([[constant for constant, _ in row] for row in cells]), letters, np.array(signs))


def _finished(numbers: Array, joints: str, signs: Array | None) -> Rows:
    if len(joints) != len(numbers) or set(joints) - set("RPF"):
        raise ValueError(
            f"joints should have a letter R, P or F for each of the {len(numbers)} rows; got {joints!r:.60}."
        )
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
    for column in ("a", "d"):
        values = numbers[:, COLUMNS.index(column)]
        if (far := np.abs(values) > FARTHEST).any():
            row = int(np.argmax(far))
            raise ValueError(f"Row {row + 1}: {column} = {values[row]:g} m is farther than any arm reaches.")
    return Rows(numbers, joints, signs)


def _lengths(lengths: Mapping[str, float] | None) -> dict[str, float]:
    """The values of names, each of them one number."""
    if not isinstance(lengths or {}, Mapping):
        raise ValueError(f"lengths should be a dictionary such as {{'l2': 0.5}}; got {validation.describe(lengths)}.")
    found = {name: _one(value, f"lengths[{name!r:.60}]") for name, value in (lengths or {}).items()}
    if "pi" in found:
        raise ValueError("lengths gives pi a value, and pi has one. Choose another name.")
    return found


def _one(value: Any, name: str) -> float:
    number = validation.array(value, name)
    if number.ndim:
        raise ValueError(f"{name} should be one number; got {validation.describe(value)}.")
    return float(number)


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


def _table(text: str) -> tuple[list[dict[str, str]], set[str]]:
    """Cut a text into rows of entries by column name; and the columns whose numbers are degrees."""
    if len(text) > LARGEST:
        raise ValueError(f"A table as text has at most {LARGEST} letters; this has {len(text)}.")
    lines = [line for line in text.strip().splitlines() if line.strip(" |-+:\t")]
    if len(lines) < 2:
        raise ValueError("A table as text needs a head and at least one row, such as 'a | alpha | d | theta'.")
    head = [_column(cell) for cell in _cells(lines[0])]
    names = [name for name, _ in head]
    if sorted(name for name in names if name in COLUMNS) != sorted(COLUMNS):
        raise ValueError(
            f"The head should name the columns {', '.join(COLUMNS)}, each once; got {lines[0].strip()!r:.100}."
        )
    rows = []
    for number, line in enumerate(lines[1:], start=1):
        cells = _cells(line)
        if len(cells) == len(head) + 1 and cells[0].rstrip(".") == str(number):
            cells = cells[1:]  # rows are numbered under a head that leaves their column without a name
        if len(cells) != len(head):
            raise ValueError(f"Row {number} has {len(cells)} entries under {len(head)} heads: {line.strip()!r:.100}.")
        rows.append(dict(zip(names, cells, strict=True)))
    return rows, {name for name, degrees in head if degrees}


def _cells(line: str) -> list[str]:
    line = line.strip()
    if "|" in line:
        return [cell.strip() for cell in line.strip("|").split("|")]
    return re.split(r"\s{2,}|\t", line) if re.search(r"\s{2,}|\t", line) else line.split()


def _column(head: str) -> tuple[str, bool]:
    """The name of a column, and whether its numbers are degrees: "alpha_{i-1} (deg)" is ("alpha", True).

    Any other name stays as it is: a column that counts the rows, or says of what kind a joint is, is not read.
    """
    if unit := re.search(r"\b[mc]m\b", head):
        raise ValueError(f"The head {head!r:.60} says {unit[0]}, and lengths are metres here: write 0.4 for 400 mm.")
    degrees = bool(re.search(r"deg|°", head))
    name = re.sub(r"\([^()]*\)|\[[^\[\]]*\]|[\\${}]|_.*|°", "", head).strip().lower()
    return NAMES.get(name, name), degrees


def _cell(row: Any, column: str, number: int, lengths: Mapping[str, float], in_degrees: bool) -> tuple[float, float]:
    """An entry as (constant, factor of the joint variable)."""
    if not isinstance(row, Mapping) or column not in row:
        came = "" if isinstance(row, Mapping) else f"; it is {validation.describe(row)}"
        raise ValueError(
            f"Row {number} has no {column}{came}. Each row names all of {', '.join(COLUMNS)}; write 0 for nothing."
        )
    entry = row[column]
    place = f"Row {number}, {column}"
    if not isinstance(entry, str):
        return _one(entry, place), 0.0
    if len(entry) > LONGEST:
        raise ValueError(f"{place}: {entry[:20]!r}... has {len(entry)} letters; an entry has at most {LONGEST}.")
    text = entry.replace("−", "-").replace("π", "pi").replace("θ", "theta").strip()
    text = re.sub(r"\\?d?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)", text)
    text = re.sub(r"[\\{}$]", "", text)
    has_unit = re.search("°|deg", text) is not None
    if (has_unit or in_degrees) and column not in ANGLES:
        raise ValueError(f"{place}: {entry!r} is an angle, and {column} is a length. Are two columns exchanged?")
    text = re.sub(r"(\d+\.?\d*|\.\d+)\s*(°|deg\b)", r"(\1*pi/180)", text)
    try:
        if not WORDS.fullmatch(text):
            raise TypeError("no entry of a table")
        constant, factor = _value(ast.parse(text, mode="eval").body, column, lengths)
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError) as error:
        hint = (
            f"Give lengths={{{error.args[0]!r}: ...}}"
            if isinstance(error, KeyError)
            else "Try 0.5, pi/2, q1 + pi/2 or -90°"
        )
        raise ValueError(f"{place}: {entry!r} is no number with at most a joint variable. {hint}.") from error
    if not np.isfinite([constant, factor]).all():
        raise ValueError(f"{place}: {entry!r} is larger than any number here.")
    # A head in degrees holds for bare numbers; where pi stands, or a degree sign, the entry says its own unit.
    is_bare = in_degrees and not has_unit and not re.search(r"\bpi\b", text)
    return (constant * np.pi / 180 if is_bare else constant), factor


def _value(node: ast.expr, column: str, lengths: Mapping[str, float]) -> tuple[float, float]:
    """Work out sums, differences and fractions; nothing else is in the language, so nothing else can be run."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
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
        return lengths[name], 0.0
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
