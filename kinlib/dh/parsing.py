"""Parse the rows of DH tables as people type them: numbers, dictionaries, or text with a heading.

A row becomes four numbers (a, alpha, d, theta), the type of its joint and the joint's sign. An entry may contain the joint variable
(`q1`, `theta_1`, `d_2`), pi, fractions, and named lengths. Angles are in radians, unless the text says degrees, in the heading of the
column or after the number. What is written is honoured or refused; `kinlib.dh.read_table` reads what is not written like this.
"""

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.validation import Array

COLUMNS = ("a", "alpha", "d", "theta")
ANGLE_COLUMNS = ("alpha", "theta")

COLUMN_NAMES = {
    name: column
    for column, names in {
        "a": "a r length linklength aj ai an",
        "alpha": "alpha alfa alph twist linktwist psi alphaj",
        "d": "d s linkoffset dj di",
        "theta": "theta th q angle jointangle v thetaj var variable",
        "offset": "offset thetaoffset offsettheta theta0 zero jointoffset qoffset",
        "type": "type sigma jointtype kind",
    }.items()
    for name in names.split()
}
"""The names that people give to columns, in small letters without signs and indices. An offset is that of theta, beside a d."""

ROW_NUMBER_HEADINGS = ("i", "j", "k", "n", "#", "no", "no.", "nr", "row", "link", "joint", "index", "axis", "frame")
"""Headings of a column that counts the rows."""

HEADING_UNIT = re.compile(
    r"[\[(/,_]?\s*(?<![a-zA-Z])(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b\.?\s*[\])]?|°"
)
HEADING_INDEX = re.compile(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$")

JOINT_VARIABLE = re.compile(r"(?:q|theta|d)_?(\d*)", re.ASCII)

NUMBER = r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"

SPELLINGS = {
    "\theta": "theta", "\alpha": "alpha", "\frac": "\\frac",  # without r in front of a text, Python reads \t, \a and \f
    **dict.fromkeys("−–—", "-"), "⁄": "/", **dict.fromkeys("·×⋅", "*"), **dict.fromkeys(("º", "˚", r"^{\circ}", r"^\circ"), "°"),
    **{subscript: str(digit) for digit, subscript in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    "₋": "-", "ᵢ": "i", "π": "pi", "θ": "theta", "ϑ": "theta", "α": "alpha", "ψ": "psi",
}  # fmt: skip
"""Signs that are written on paper, as a keyboard has them."""

OPERATORS: dict[type[ast.operator], Callable[[complex, complex], complex]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}

MAX_TEXT_LENGTH, MAX_ENTRY_LENGTH, MAX_LENGTH_M = 100_000, 200, 1e12
"""The maximum number of characters of a text and of an entry, and of a and d in metres: beyond it a pose resolves no millimetre."""


def joint_entries(joints: str) -> list[tuple[int, int]]:
    """Find the entry that each joint changes: its row and its column, theta for the letter R and d for P.

    >>> joint_entries("RFP")
    [(0, 3), (2, 2)]
    """
    return [(row, 3 if letter == "R" else 2) for row, letter in enumerate(joints) if letter != "F"]


def is_plausible_angle(angle: float) -> bool:
    """Return whether an angle in radians is likely to be meant as it is, and is not in degrees.

    It is if it is at most a full turn, or at most ten turns in whole degrees; or, up to two turns, if it has more than three
    decimals, as sums such as theta + 2 pi have.

    >>> [is_plausible_angle(angle) for angle in (-np.pi, 5 * np.pi / 2, 1.2345 + 2 * np.pi, 10, 22.5, 90)]
    [True, True, True, False, False, False]
    """
    size = abs(angle) - 1e-3  # 6.283 is a full turn
    if size <= 2 * math.pi or size > 20 * math.pi:
        return size <= 2 * math.pi
    degrees, is_typed = math.degrees(angle), abs(angle - round(angle, 3)) < 1e-9
    return abs(degrees - round(degrees)) < 1e-4 or (not is_typed and size <= 4 * math.pi)


class Rows(NamedTuple):
    """A parsed table: numbers (m, 4) in the order of COLUMNS, joint types as letters R, P or F, and signs (m,) of the variables.

    A table of numbers has no variables, so its signs are None.
    """

    numbers: Array
    joints: str
    signs: Array | None


def read_rows(
    rows: Any, joints: str | None = None, lengths: Mapping[str, float] | None = None, convention: str | None = None
) -> Rows:
    """Read a table in any of its forms.

    rows        text with a heading, a sequence of {"a": ..., "alpha": ..., "d": ..., "theta": ...}, or numbers (m, 4) in that order
    joints      letters R, P, F, one per row; by default read from the variables. F is a fixed row, without a joint
    lengths     values of names such as l2 that an entry uses
    convention  "standard" or "modified", which the indices in the heading must not contradict; None does not check them

    Raises ValueError for anything else, for variables in another order than 1, 2, ..., and for angles that are not plausible as
    radians; the message names the row and the column.

    >>> read_rows('''i | alpha | a  | d  | theta
    ...             1 | 0     | 0  | 0  | q1
    ...             2 | -90°  | l2 | q2 | -90°''', lengths={"l2": 0.5}).numbers.round(3)
    array([[ 0.   ,  0.   ,  0.   ,  0.   ],
           [ 0.5  , -1.571,  0.   , -1.571]])
    """
    if not isinstance(lengths or {}, Mapping):
        raise ValueError(f"lengths must be a dictionary such as {{'l2': 0.5}}; got {validation.describe(lengths)}.")
    values = {name: _single_number(value, f"lengths[{name!r:.60}]") for name, value in (lengths or {}).items()}
    if "pi" in values:
        raise ValueError("lengths must not redefine pi. Choose another name.")
    degrees = set[str]()
    if isinstance(rows, str):
        rows, degrees = _split_table(rows, convention)
    if not isinstance(rows, Sequence) or not any(isinstance(row, Mapping) for row in rows):
        numbers = validation.vectors(rows, "rows", 4)
        if numbers.ndim != 2:
            raise ValueError(f"rows must have shape (m, 4), with columns {', '.join(COLUMNS)}; got {numbers.shape}.")
        letters, signs = ("R" * len(numbers) if joints is None else joints), None
    else:
        cells = [
            [_parse_entry(row, column, i, values, column in degrees) for column in COLUMNS]
            for i, row in enumerate(rows, 1)
        ]
        kinds = [joint_of_row(dict(zip(COLUMNS, row, strict=True)), f"Row {i}") for i, row in enumerate(cells, 1)]
        _validate_labels([name for _, _, name in kinds if name])
        numbers, signs = (
            np.array([[entry.value.real for entry in row] for row in cells]),
            np.array([sign for _, sign, _ in kinds]),
        )
        letters = "".join(letter for letter, _, _ in kinds)
        if joints is not None and joints != letters:
            raise ValueError(
                f"joints must agree with the variables in the rows, {letters}; got {joints!r:.60}. Which rows have a joint?"
            )
    _validate_rows(numbers, letters)
    return Rows(numbers, letters, signs)


def _validate_rows(numbers: Array, joints: Any) -> None:
    if not isinstance(joints, str) or len(joints) != len(numbers) or set(joints) - set("RPF"):
        raise ValueError(
            f"joints must have a letter R, P or F for each of the {len(numbers)} rows; got {joints!r:.60}."
        )
    if set(joints) <= {"F"}:
        raise ValueError("A table must have at least one joint, but every row is fixed. Is q1 missing from an entry?")
    for (row, column), value in np.ndenumerate(numbers):
        name = COLUMNS[column]
        if name in ANGLE_COLUMNS and not is_plausible_angle(value):
            raise ValueError(
                f"Row {row + 1}, {name}: an angle must be at most a full turn, 2 pi, or at most ten turns in whole degrees; got "
                f"{value:g} rad. If the number is in degrees, write {value:g}°; if not, subtract full turns."
            )
        if name not in ANGLE_COLUMNS and abs(value) > MAX_LENGTH_M:
            raise ValueError(f"Row {row + 1}: {name} must be at most {MAX_LENGTH_M:g} m; got {value:g} m.")


def _validate_labels(names: Sequence[str]) -> None:
    """Refuse variables that are not numbered 1, 2, ... in the order of the rows; q without a number is the joint of its row."""
    digits = [re.sub(r"\D", "", name) for name in names]
    numbers = [int(digit) if digit else position for position, digit in enumerate(digits, start=1)]
    if numbers == [*range(1, len(numbers) + 1)]:
        return
    twice = next((number for number in numbers if numbers.count(number) > 1), None)
    hint = "Is a row missing? The joints are counted from 1. A variable without a number, q, is the joint of its row."
    if twice is not None:
        hint = f"Two rows have the variable of joint {twice}, but each joint has one row."
    elif {*numbers} == {*range(1, len(numbers) + 1)}:
        hint = "Give the rows in the order of the joints, because each row begins at the frame of the row before."
    raise ValueError(
        f"The joint variables must be numbered 1, 2, ... in the order of the rows; got {', '.join(names):.100}. {hint}"
    )


def _single_number(value: Any, name: str) -> float:
    number = validation.array(value, name)
    if number.ndim:
        raise ValueError(f"{name} must be a single number; got {validation.describe(value)}.")
    return float(number)


def _split_table(text: str, convention: str | None) -> tuple[list[dict[str, str]], set[str]]:
    """Split a text into rows of entries by column name, and find the columns whose numbers are degrees."""
    if len(text) > MAX_TEXT_LENGTH:
        raise ValueError(f"A table as text must have at most {MAX_TEXT_LENGTH} characters; got {len(text)}.")
    lines = [line for line in respelled(text).strip().splitlines() if line.strip(" |-+:\t")]
    if len(lines) < 2:
        raise ValueError("A table as text must have a heading, such as 'a | alpha | d | theta', and at least one row.")
    heads = parse_headings(_split_line(lines[0]))
    for head in heads:
        _validate_heading(head, convention)
    if sorted(head.name for head in heads if head.name in (*COLUMNS, "offset")) != sorted(COLUMNS):
        raise ValueError(
            f"The heading must name the columns {', '.join(COLUMNS)}, each once; got {lines[0].strip()!r:.100}."
        )
    rows = []
    for number, line in enumerate(lines[1:], start=1):
        cells = _split_line(line)
        if len(cells) == len(heads) + 1 and cells[0].rstrip(".") == str(number):
            cells = cells[1:]  # the rows are numbered, but their column has no heading
        if len(cells) != len(heads):
            raise ValueError(
                f"Row {number} must have {len(heads)} entries, one per heading; got {len(cells)}: {line.strip()!r:.100}."
            )
        rows.append({head.name: cell for head, cell in zip(heads, cells, strict=True)})
    for name in {head.name for head in heads} & {*ROW_NUMBER_HEADINGS}:
        labels = [row[name].rstrip(".") for row in rows]
        are_numbers = all(re.fullmatch(r"\d{1,4}", label, re.ASCII) for label in labels)
        if are_numbers and [*map(int, labels)] != [*range(int(labels[0]), int(labels[0]) + len(labels))]:
            raise ValueError(
                f"The rows must be in the order of their numbers, none of them missing or twice; got {', '.join(labels):.100}. "
                "Sort the rows, because each of them begins at the frame of the row before."
            )
    return rows, {head.name for head in heads if head.unit == "deg"}


def _split_line(line: str) -> list[str]:
    """Split a line at bars, as in Markdown, or at white space."""
    line = line.strip()
    if "|" in line:
        return [cell.strip() for cell in line.strip("|").split("|")]
    return re.split(r"\s{2,}|\t", line) if re.search(r"\S(\s{2,}|\t)", line) else line.split()


def respelled(text: str) -> str:
    """Replace signs that are written on paper by what a keyboard has.

    >>> respelled("θ₁ − π")
    'theta1 - pi'
    """
    for sign, plain in SPELLINGS.items():
        text = text.replace(sign, plain)
    return text


class Heading(NamedTuple):
    """A heading: the name of its column, or its own text if that is no column of a table; its unit, and its indices "i" or "i-1"."""

    name: str
    unit: str = ""
    indices: str = ""
    text: str = ""


def parse_headings(cells: Sequence[str]) -> list[Heading]:
    """Read the headings of columns; "offset" is d where no other column is.

    >>> [head[:3] for head in parse_headings(["alpha_{i-1} (deg)", "Offset", "No."])]
    [('alpha', 'deg', 'i-1'), ('d', '', ''), ('no.', '', '')]
    """
    heads = [parse_heading(cell) for cell in cells]
    has_d = any(head.name == "d" for head in heads)
    return [head._replace(name="d") if head.name == "offset" and not has_d else head for head in heads]


def parse_heading(head: str) -> Heading:
    """Read a single heading.

    >>> parse_heading("d_i [mm]")
    Heading(name='d', unit='mm', indices='i', text='d_i [mm]')
    """
    plain = head.strip().strip("\"'`*:").replace("\\", "").replace("$", "")
    if re.search(r"[⁻⁺]|min|max|lim|range", plain):  # of a joint
        return Heading(plain.lower(), text=head)
    unit = ""
    if found := HEADING_UNIT.search(plain):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get((found[1] or "°")[:2], found[1])
        if re.search("[a-zA-Z]", plain[: found.start()]):
            plain = plain[: found.start()] + plain[found.end() :]
    plain = plain.strip().lower()
    index = HEADING_INDEX.search(plain)
    whole, bare = (re.sub("[^a-z0]", "", text) for text in (plain, plain[: index.start()] if index else plain))
    name = COLUMN_NAMES.get(whole) or COLUMN_NAMES.get(bare) or plain
    return Heading(
        name, unit, "i-1" if index and index[1] else "i" if index and re.search("[ijkn]", index[0]) else "", head
    )


def _validate_heading(head: Heading, convention: str | None) -> None:
    """Refuse millimetres, and an index that contradicts the convention."""
    if head.unit in {"mm", "cm"}:
        raise ValueError(
            f"Lengths must be in metres, but the heading {head.text!r:.60} says {head.unit}. Write 0.4 for 400 mm."
        )
    said = {"i": "standard", "i-1": "modified"}.get(head.indices, convention)
    if head.name in ("a", "alpha") and convention in ("standard", "modified") and said != convention:
        raise ValueError(
            f"The heading {head.text!r:.60} is that of a {said} table, but convention is {convention!r}. These two are often confused: "
            "row i has a_i and alpha_i in the standard convention, and a_{i-1} and alpha_{i-1} in the modified one (Craig). Write "
            f"convention={said!r}, or, if the numbers are those of a {convention} table, write {head.name} without an index."
        )


class Entry(NamedTuple):
    """An entry: its value, in which the variable is the imaginary unit (0.5 - q1 is 0.5 - 1j); its variables; and "°", "pi" or ""."""

    value: complex
    variables: Sequence[str] = ()
    unit: str = ""


def _parse_entry(row: Any, column: str, number: int, lengths: Mapping[str, float], in_degrees: bool) -> Entry:
    if not isinstance(row, Mapping) or column not in row:
        given = "" if isinstance(row, Mapping) else f"; it is {validation.describe(row)}"
        raise ValueError(
            f"Row {number} has no {column}{given}. Each row must have all of {', '.join(COLUMNS)}; write 0 for an empty entry."
        )
    text, place = row[column], f"Row {number}, {column}"
    if not isinstance(text, str):
        return Entry(complex(_single_number(text, place)))
    try:
        entry = evaluate_entry(text, column, lengths)
    except ValueError as error:
        raise ValueError(f"{place}: {error}") from error
    if column not in ANGLE_COLUMNS and entry.unit == "°":
        raise ValueError(f"{place}: {text!r} is an angle, but {column} is a length. Are two columns swapped?")
    # A heading in degrees applies to bare numbers; an entry with pi or a unit has its own unit.
    factor = math.pi / 180 if in_degrees and not entry.unit else 1.0
    return entry._replace(value=complex(entry.value.real * factor, entry.value.imag))


def joint_of_row(row: Mapping[str, Entry], place: str) -> tuple[str, float, str]:
    """Return the type and the sign of a row's joint, and the name of its variable, from the variables in its entries by column.

    Raises ValueError for a second variable, one in another column than d and theta, and one with a factor.

    >>> joint_of_row({"d": Entry(1 - 1j, ["q1"])}, "Row 1")
    ('P', -1.0, 'q1')
    """
    moving = {column: entry for column, entry in row.items() if entry.variables}
    for column, entry in moving.items():
        if len(entry.variables) > 1:
            raise ValueError(
                f"{place}, {column}: an entry must have one joint variable, that of its own joint; got "
                f"{' and '.join(entry.variables)}. If the angle depends on two joints, their mechanism is not a chain of rows."
            )
    if not moving:
        return "F", 1.0, ""
    columns = ", ".join(moving)
    if columns not in ("d", "theta"):
        swapped = {"a": " Are the columns a and d swapped?", "alpha": " Are the columns alpha and theta swapped?"}
        raise ValueError(
            f"{place}: the joint variable must be in theta or in d, once; it is in {columns}.{swapped.get(columns, '')}"
        )
    value, names, _ = moving[columns]
    if abs(value.imag) != 1:
        raise ValueError(
            f"{place}: the joint variable in {columns} must be q or -q, without a factor; its factor is {value.imag:g}."
        )
    return ("R" if columns == "theta" else "P"), value.imag, names[0]


def evaluate_entry(entry: str, column: str, lengths: Mapping[str, float]) -> Entry:
    """Evaluate an entry of a column; the names of `lengths` have values.

    Raises ValueError for anything but sums, products and fractions of numbers, names and a variable.

    >>> evaluate_entry("-90° + q2", "theta", {})
    Entry(value=(-1.5707963267948966+1j), variables=['q2'], unit='°')
    """
    if len(entry) > MAX_ENTRY_LENGTH:
        raise ValueError(
            f"an entry must have at most {MAX_ENTRY_LENGTH} characters; {entry[:20]!r}... has {len(entry)}."
        )
    text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", respelled(entry)).strip()
    text = re.sub(r"[\\{}$]|\b(?:np|math)\.", "", text)
    text, degrees = re.subn(rf"({NUMBER})\s*(?:°|deg\b)", r"(\1*pi/180)", text)
    text = re.sub(rf"({NUMBER}|\))\s*(?=(?:pi|q_?\d*)\b|theta)", r"\1*", text)
    try:
        if re.search(r"[^\w\s.+*/()-]|\d_|\b0[a-zA-Z]", text):  # Python also reads 0x1F and 1_000, but people do not
            raise TypeError("not an entry of a table")
        tree = ast.parse(text, mode="eval").body
        value = _evaluate(tree, column, lengths)
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError, ValueError) as error:
        raise ValueError(
            f"an entry must be a number, or a joint variable with a number; got {entry!r}. {_hint(text, column, error)}."
        ) from error
    if not np.isfinite(value):
        raise ValueError(f"an entry must be a finite number; got {entry!r}.")
    names = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name))
    variables = (name.replace("_", "") for name in names if name not in lengths and _is_variable(name, column))
    return Entry(value, [*dict.fromkeys(variables)], "°" if degrees else "pi" if re.search(r"\bpi\b", text) else "")


def _hint(text: str, column: str, error: Exception) -> str:
    if comma := re.search(r"(\d*),(\d+)", text):
        return f"The decimal sign is a point: write {comma[1] or 0}.{comma[2]}"
    if unit := re.search(r"\d\s*([mc]?m)\b", text):
        return f"Lengths are in metres: write 0.4 for 400 mm, without {unit[1]}"
    if isinstance(error, KeyError):
        name = error.args[0]
        variable = f"If {name} is the joint variable, write q{re.sub(r'[^0-9]', '', name)}; if not, give"
        return f"{variable if column in ('d', 'theta') else 'Give'} lengths={{{name!r}: ...}}"
    return "Try 0.5, pi/2, q1 + pi/2 or -90°"


def _evaluate(node: ast.expr, column: str, lengths: Mapping[str, float]) -> complex:
    """Evaluate sums, differences, products and fractions; no other syntax is accepted, so nothing else can be executed."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return complex(value)
        case ast.Name(id=name) if name in lengths or name == "pi":
            return complex(lengths.get(name, math.pi))
        case ast.Name(id=name) if _is_variable(name, column):
            return 1j
        case ast.Name(id=name):
            raise KeyError(name)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=operand):
            return _evaluate(operand, column, lengths) * (-1 if isinstance(sign, ast.USub) else 1)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            one, other = _evaluate(left, column, lengths), _evaluate(right, column, lengths)
            # A variable times or divided by a variable is no entry, and its square would be the square of the imaginary unit.
            if not other.imag or isinstance(op, ast.Add | ast.Sub) or (isinstance(op, ast.Mult) and not one.imag):
                return OPERATORS[type(op)](one, other)
    raise TypeError(ast.dump(node))


def _is_variable(name: str, column: str) -> bool:
    """Whether a name is that of a joint variable: in another column than d, d_3 is a length whose value is missing."""
    return JOINT_VARIABLE.fullmatch(name) is not None and (column == "d" or name[0] != "d")
