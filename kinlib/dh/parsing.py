"""The headings and the entries of DH tables as people type them.

An entry may contain the joint variable (`q1`, `theta_1`, `d_2`), pi, fractions, and named lengths. Angles are in radians, unless a
unit says degrees, in the heading of the column or after the number.
"""

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

COLUMNS = ("a", "alpha", "d", "theta")
ANGLE_COLUMNS = ("alpha", "theta")

COLUMN_NAMES = {
    name: column
    for column, names in {
        "a": "a r length linklength aj ai an",
        "alpha": "alpha alfa alph al twist linktwist psi alphaj",
        "d": "d s linkoffset dj di",
        "theta": "theta th q angle jointangle v thetaj var variable",
        "offset": "offset thetaoffset offsettheta theta0 zero jointoffset qoffset",
        "type": "type sigma jointtype kind",
    }.items()
    for name in names.split()
}
"""The names that people give to columns, in small letters without signs and indices. An offset is that of theta, beside a d."""

HEADING_UNIT = re.compile(
    r"[\[(/,_]?\s*(?<![a-zA-Z])(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b\.?\s*[\])]?|°"
)
HEADING_INDEX = re.compile(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$")

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

MAX_ENTRY_LENGTH, MAX_LENGTH_M, MIN_LENGTH_MM = 200, 1e12, 5.0
"""The maximum number of characters of an entry; of a and d in metres, beyond which a pose resolves no millimetre; and the smallest
length that is taken as one in millimetres."""


def joint_entries(joints: str) -> list[tuple[int, int]]:
    """Find the entry that each joint changes: its row and its column, theta for the letter R and d for P."""
    return [(row, 3 if letter == "R" else 2) for row, letter in enumerate(joints) if letter != "F"]


def is_plausible_angle(angle: float) -> bool:
    """Return whether an angle in radians is likely to be meant as it is, and is not in degrees.

    It is if it is at most a full turn, or at most ten turns in whole degrees; or, up to two turns, if it has more than three
    decimals, as sums such as theta + 2 pi have.
    """
    size = abs(angle) - 1e-3  # 6.283 is a full turn
    if size <= 2 * math.pi or size > 20 * math.pi:
        return size <= 2 * math.pi
    degrees, is_typed = math.degrees(angle), abs(angle - round(angle, 3)) < 1e-9
    return abs(degrees - round(degrees)) < 1e-4 or (not is_typed and size <= 4 * math.pi)


def respelled(text: str) -> str:
    """Replace signs that are written on paper by what a keyboard has."""
    for sign, plain in SPELLINGS.items():
        text = text.replace(sign, plain)
    return text


class Heading(NamedTuple):
    """A heading: the name of its column, or its own words if that is no column; its unit, and its indices "i" or "i-1"."""

    name: str
    unit: str = ""
    indices: str = ""


def parse_headings(cells: Sequence[str]) -> list[Heading]:
    """Read the headings of columns; "offset" is d where no other column is."""
    heads = [parse_heading(cell) for cell in cells]
    has_d = any(head.name == "d" for head in heads)
    return [head._replace(name="d") if head.name == "offset" and not has_d else head for head in heads]


def parse_heading(head: str) -> Heading:
    """Read a single heading."""
    plain = head.strip().strip("\"'`*:").replace("\\", "").replace("$", "")
    if len(plain) > MAX_ENTRY_LENGTH or re.search(r"[⁻⁺]|min|max|lim|range", plain):  # limits of a joint
        return Heading(plain.lower())
    unit = ""
    if found := HEADING_UNIT.search(plain):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get((found[1] or "°")[:2], found[1])
        if re.search("[a-zA-Z]", plain[: found.start()]):
            plain = plain[: found.start()] + plain[found.end() :]
    plain = plain.strip().lower()
    index = HEADING_INDEX.search(plain)
    whole, bare = (re.sub("[^a-z0]", "", text) for text in (plain, plain[: index.start()] if index else plain))
    letters = {*re.findall("[a-z]+", plain)} - {"angle", "joint", "length", "link", "offset", "twist"}
    alone = letters.pop() if len(letters) == 1 else ""  # in "link length a"
    name = next((known for text in (whole, bare, alone) if (known := COLUMN_NAMES.get(text))), plain)
    indices = "i-1" if index and index[1] else "i" if index and re.search("[ijkn]", index[0]) else ""
    return Heading(name, unit, indices)


class Entry(NamedTuple):
    """An entry: its value, in which the variable is the imaginary unit (0.5 - q1 is 0.5 - 1j); its variables; and "°", "pi" or ""."""

    value: complex
    variables: Sequence[str] = ()
    unit: str = ""


def joint_of_row(row: Mapping[str, Entry], place: str) -> tuple[str, float, str]:
    """Return the type and the sign of a row's joint, and the name of its variable, from the variables in its entries by column.

    Raises ValueError for a second variable, one in another column than d and theta, and one with a factor.
    """
    moving = {column: entry for column, entry in row.items() if entry.variables}
    if not moving:
        return "F", 1.0, ""
    names, (column, entry) = [name for each in moving.values() for name in each.variables], next(iter(moving.items()))
    if len(names) > 1 or column not in {"d", "theta"} or abs(entry.value.imag) != 1:
        raise ValueError(
            f"{place}: a row must have one joint variable, q or -q without a factor, in theta or in d; got {' and '.join(names)} in "
            f"{' and '.join(moving)}{f', with the factor {entry.value.imag:g}' * (len(names) == 1)}. Are two columns swapped?"
        )
    return ("R" if column == "theta" else "P"), entry.value.imag, names[0]


def evaluate_entry(entry: str, column: str, lengths: Mapping[str, float]) -> Entry:
    """Evaluate an entry of a column; the names of `lengths` have values.

    Raises ValueError for anything but sums, products and fractions of numbers, names and a variable.
    """
    text = re.sub(r"[\\{}]", "", entry)
    text, degrees = re.subn(rf"({NUMBER})\s*(?:°|deg\b)", r"(\1*pi/180)", text)
    text = re.sub(rf"({NUMBER}|\))\s*(?=(?:pi|q_?\d*)\b|theta)", r"\1*", text)
    try:
        # Python also reads 0x1F and 1_000, but people do not.
        if len(entry) > MAX_ENTRY_LENGTH or re.search(r"[^\w\s.+*/()-]|\d_|\b0[xXbBoO]", text):
            raise TypeError("not an entry of a table")
        tree = ast.parse(text, mode="eval").body
        if not np.isfinite(value := _evaluate(tree, column, lengths)):
            raise ValueError("not finite")
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError, ValueError) as error:
        raise ValueError(
            f"an entry must be a number, or a joint variable with a number; got {entry!r:.200}. {_hint(text, column, error)}."
        ) from error
    names = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name))
    variables = (name.replace("_", "") for name in names if name not in lengths and _is_variable(name, column))
    return Entry(value, [*dict.fromkeys(variables)], "°" if degrees else "pi" if re.search(r"\bpi\b", text) else "")


def _hint(text: str, column: str, error: Exception) -> str:
    if comma := re.search(r"(\d*),(\d+)", text):
        return f"The decimal sign is a point: write {comma[1] or 0}.{comma[2]}"
    if isinstance(error, KeyError):
        name = error.args[0]
        variable = f"If {name} is the joint variable, write q{re.sub(r'[^0-9]', '', name)}; if not, write"
        return f"{variable if column in ('d', 'theta') else 'Write'} its value in a line above the table, {name} = 0.3"
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
    return re.fullmatch(r"(?:q|theta|d)_?\d*", name, re.ASCII) is not None and (column == "d" or name[0] != "d")
