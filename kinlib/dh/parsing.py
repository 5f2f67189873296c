"""Parse the rows of DH tables as people type them: lists, dictionaries, or the text of a slide.

In every form, a row becomes four numbers (a, alpha, d, theta), the type of its joint and the joint's sign. An entry may contain
the joint variable (`q1`, `theta_1`, `d_2`), pi, fractions, and named lengths. Angles are in radians, unless the text says
degrees, in the heading of the column or after the number.
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
ANGLE_COLUMNS = ("alpha", "theta")

COLUMN_SYNONYMS = {
    "α": "alpha",
    "θ": "theta",
    "ψ": "alpha",
    "psi": "alpha",
    "twist": "alpha",
    "length": "a",
    "offset": "d",
    "angle": "theta",
}
"""Other names of the columns; the EduFill module writes psi where others write alpha."""

JOINT_VARIABLE = re.compile(r"(q|theta|d)_?\d*", re.ASCII)

ENTRY_SYNTAX = re.compile(r"(?:(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])|[A-Za-z_]\w*\b|[-+*/()\s])*", re.ASCII)
"""The characters of an entry: numbers, names, operators. Python also reads 0x1F and 1_000 as numbers, but people do not."""

MAX_TEXT_LENGTH, MAX_ENTRY_LENGTH = 100_000, 200
"""The maximum length of a text and of an entry, in characters; no table that people type is longer."""

MAX_LENGTH_M = 1e12
"""The maximum of a and d, in metres: beyond it a pose cannot resolve a millimetre. The normals of nearly parallel axes can be far
away, but not that far."""


@dataclass(frozen=True, eq=False)
class Rows:
    """A parsed table: numbers (m, 4) in the order of COLUMNS, joint types as letters R, P or F, and signs (m,).

    The signs are those of the joint variables in the entries. A table of numbers has no variables, so its signs are None.
    """

    numbers: Array
    joints: str
    signs: Array | None


def read_rows(rows: Any, joints: str | None = None, lengths: Mapping[str, float] | None = None) -> Rows:
    """Read a table in any of its forms.

    rows     text with a heading, a sequence of {"a": ..., "alpha": ..., "d": ..., "theta": ...}, or numbers (m, 4) in that order
    joints   letters R, P, F, one per row; by default read from the variables. F is a fixed row, without a joint
    lengths  values of names such as l2 that an entry uses

    Raises ValueError for anything else; the message names the row and the column.

    >>> read_rows('''i | alpha | a  | d  | theta
    ...             1 | 0     | 0  | 0  | q1
    ...             2 | -90°  | l2 | q2 | -90°''', lengths={"l2": 0.5}).numbers.round(3)
    array([[ 0.   ,  0.   ,  0.   ,  0.   ],
           [ 0.5  , -1.571,  0.   , -1.571]])
    """
    if joints is not None and not isinstance(joints, str):
        raise ValueError(f"joints must be a string with a letter for each row; got {validation.describe(joints)}.")
    lengths, degrees = _validate_lengths(lengths), set[str]()
    if isinstance(rows, str):
        rows, degrees = _split_table(rows)
    if not isinstance(rows, Sequence) or not any(isinstance(row, Mapping) for row in rows):
        numbers = validation.vectors(rows, "rows", 4)
        if numbers.ndim != 2:
            raise ValueError(f"rows must have shape (m, 4), with columns {', '.join(COLUMNS)}; got {numbers.shape}.")
        return _validate_rows(numbers, joints or "R" * len(numbers), None)
    cells = [
        [_parse_entry(row, column, number, lengths, column in degrees) for column in COLUMNS]
        for number, row in enumerate(rows, start=1)
    ]
    types, signs = zip(*(_joint_type_and_sign(row, number) for number, row in enumerate(cells, start=1)), strict=True)
    letters = "".join(types)
    if joints is not None and joints != letters:
        raise ValueError(
            f"joints must agree with the variables in the rows, {letters}; got {joints:.60}. Which rows have a joint?"
        )
    return _validate_rows(np.array([[constant for constant, _ in row] for row in cells]), letters, np.array(signs))


def _validate_rows(numbers: Array, joints: str, signs: Array | None) -> Rows:
    if len(joints) != len(numbers) or set(joints) - set("RPF"):
        raise ValueError(
            f"joints must have a letter R, P or F for each of the {len(numbers)} rows; got {joints!r:.60}."
        )
    if set(joints) <= {"F"}:
        raise ValueError("A table must have at least one joint, but every row is fixed. Is q1 missing from an entry?")
    for column in ANGLE_COLUMNS:
        values = numbers[:, COLUMNS.index(column)]
        if (far := np.abs(values) > 4 * np.pi).any():
            row = int(np.argmax(far))
            raise ValueError(
                f"Row {row + 1}: {column} must be at most two full turns; got {values[row]:g} rad. Is it in degrees? "
                f"Then write {values[row]:g}°, or {column} (deg) in the heading of the column."
            )
    for column in ("a", "d"):
        values = numbers[:, COLUMNS.index(column)]
        if (far := np.abs(values) > MAX_LENGTH_M).any():
            row = int(np.argmax(far))
            raise ValueError(f"Row {row + 1}: {column} must be at most {MAX_LENGTH_M:g} m; got {values[row]:g} m.")
    return Rows(numbers, joints, signs)


def _validate_lengths(lengths: Mapping[str, float] | None) -> dict[str, float]:
    """Read the values of names, each of them a single number."""
    if not isinstance(lengths or {}, Mapping):
        raise ValueError(f"lengths must be a dictionary such as {{'l2': 0.5}}; got {validation.describe(lengths)}.")
    values = {name: _single_number(value, f"lengths[{name!r:.60}]") for name, value in (lengths or {}).items()}
    if "pi" in values:
        raise ValueError("lengths must not redefine pi. Choose another name.")
    return values


def _single_number(value: Any, name: str) -> float:
    number = validation.array(value, name)
    if number.ndim:
        raise ValueError(f"{name} must be a single number; got {validation.describe(value)}.")
    return float(number)


def _joint_type_and_sign(row: Sequence[tuple[float, float]], number: int) -> tuple[str, float]:
    """Return the type and the sign of a row's joint, from the coefficients of its variable."""
    moving = {column: factor for column, (_, factor) in zip(COLUMNS, row, strict=True) if factor}
    if not moving:
        return "F", 1.0
    if len(moving) > 1 or set(moving) <= {"a", "alpha"}:
        raise ValueError(
            f"Row {number}: the joint variable must be in theta or in d, once; it is in {', '.join(moving)}."
        )
    ((column, factor),) = moving.items()
    if abs(factor) != 1:
        raise ValueError(
            f"Row {number}: the joint variable in {column} must be q or -q, without a factor; its factor is {factor:g}."
        )
    return ("R" if column == "theta" else "P"), factor


def _split_table(text: str) -> tuple[list[dict[str, str]], set[str]]:
    """Split a text into rows of entries by column name, and find the columns whose numbers are degrees."""
    if len(text) > MAX_TEXT_LENGTH:
        raise ValueError(f"A table as text must have at most {MAX_TEXT_LENGTH} characters; got {len(text)}.")
    lines = [line for line in text.strip().splitlines() if line.strip(" |-+:\t")]
    if len(lines) < 2:
        raise ValueError("A table as text must have a heading, such as 'a | alpha | d | theta', and at least one row.")
    head = [_parse_heading(cell) for cell in _split_line(lines[0])]
    names = [name for name, _ in head]
    if sorted(name for name in names if name in COLUMNS) != sorted(COLUMNS):
        raise ValueError(
            f"The heading must name the columns {', '.join(COLUMNS)}, each once; got {lines[0].strip()!r:.100}."
        )
    rows = []
    for number, line in enumerate(lines[1:], start=1):
        cells = _split_line(line)
        if len(cells) == len(head) + 1 and cells[0].rstrip(".") == str(number):
            cells = cells[1:]  # the rows are numbered, but their column has no heading
        if len(cells) != len(head):
            raise ValueError(
                f"Row {number} must have {len(head)} entries, one per heading; got {len(cells)}: {line.strip()!r:.100}."
            )
        rows.append(dict(zip(names, cells, strict=True)))
    return rows, {name for name, degrees in head if degrees}


def _split_line(line: str) -> list[str]:
    line = line.strip()
    if "|" in line:
        return [cell.strip() for cell in line.strip("|").split("|")]
    return re.split(r"\s{2,}|\t", line) if re.search(r"\s{2,}|\t", line) else line.split()


def _parse_heading(head: str) -> tuple[str, bool]:
    """Return the name of a column, and whether its numbers are degrees: "alpha_{i-1} (deg)" is ("alpha", True).

    Any other name is returned unchanged: a column of row numbers or of joint types is not read.
    """
    if unit := re.search(r"\b[mc]m\b", head):
        raise ValueError(
            f"Lengths must be in metres, but the heading {head!r:.60} says {unit[0]}. Write 0.4 for 400 mm."
        )
    degrees = bool(re.search(r"deg|°", head))
    name = re.sub(r"\([^()]*\)|\[[^\[\]]*\]|[\\${}]|_.*|°", "", head).strip().lower()
    return COLUMN_SYNONYMS.get(name, name), degrees


def _parse_entry(
    row: Any, column: str, number: int, lengths: Mapping[str, float], in_degrees: bool
) -> tuple[float, float]:
    """Evaluate an entry as (constant, factor of the joint variable)."""
    if not isinstance(row, Mapping) or column not in row:
        given = "" if isinstance(row, Mapping) else f"; it is {validation.describe(row)}"
        raise ValueError(
            f"Row {number} has no {column}{given}. Each row must have all of {', '.join(COLUMNS)}; write 0 for an empty entry."
        )
    entry = row[column]
    place = f"Row {number}, {column}"
    if not isinstance(entry, str):
        return _single_number(entry, place), 0.0
    if len(entry) > MAX_ENTRY_LENGTH:
        raise ValueError(
            f"{place}: an entry must have at most {MAX_ENTRY_LENGTH} characters; {entry[:20]!r}... has {len(entry)}."
        )
    text = entry.replace("−", "-").replace("π", "pi").replace("θ", "theta").strip()
    text = re.sub(r"\\?d?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)", text)
    text = re.sub(r"[\\{}$]", "", text)
    has_unit = re.search("°|deg", text) is not None
    if (has_unit or in_degrees) and column not in ANGLE_COLUMNS:
        raise ValueError(f"{place}: {entry!r} is an angle, but {column} is a length. Are two columns swapped?")
    text = re.sub(r"(\d+\.?\d*|\.\d+)\s*(°|deg\b)", r"(\1*pi/180)", text)
    try:
        if not ENTRY_SYNTAX.fullmatch(text):
            raise TypeError("not an entry of a table")
        constant, factor = _evaluate(ast.parse(text, mode="eval").body, column, lengths)
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError) as error:
        hint = (
            f"Give lengths={{{error.args[0]!r}: ...}}"
            if isinstance(error, KeyError)
            else "Try 0.5, pi/2, q1 + pi/2 or -90°"
        )
        raise ValueError(
            f"{place}: an entry must be a number, or a joint variable with a number; got {entry!r}. {hint}."
        ) from error
    if not np.isfinite([constant, factor]).all():
        raise ValueError(f"{place}: an entry must be a finite number; got {entry!r}.")
    # A heading in degrees applies to bare numbers; an entry with pi or a degree sign has its own unit.
    is_bare = in_degrees and not has_unit and not re.search(r"\bpi\b", text)
    return (constant * np.pi / 180 if is_bare else constant), factor


def _evaluate(node: ast.expr, column: str, lengths: Mapping[str, float]) -> tuple[float, float]:
    """Evaluate sums, differences, products and fractions; no other syntax is accepted, so nothing else can be executed."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return float(value), 0.0
        case ast.Name(id=name):
            return _evaluate_name(name, column, lengths)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=operand):
            constant, factor = _evaluate(operand, column, lengths)
            return (-constant, -factor) if isinstance(sign, ast.USub) else (constant, factor)
        case ast.BinOp(left=left, op=op, right=right):
            return _combine(op, _evaluate(left, column, lengths), _evaluate(right, column, lengths))
    raise TypeError(ast.dump(node))


def _evaluate_name(name: str, column: str, lengths: Mapping[str, float]) -> tuple[float, float]:
    if name in lengths:
        return lengths[name], 0.0
    if name == "pi":
        return np.pi, 0.0
    # In another column, d_3 is a length whose value is missing; in the column d it is the joint variable.
    if JOINT_VARIABLE.fullmatch(name) and (column == "d" or name[0] != "d"):
        return 0.0, 1.0
    raise KeyError(name)


def _combine(op: ast.operator, one: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
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
