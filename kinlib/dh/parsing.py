"""The columns of DH tables, their entries and headings as people type them, and the rows of cells that a text has.

An entry may contain the joint variable (`q1`, `theta_1`, `d_2`), pi, fractions, units, and named lengths.
"""

import ast
import math
import operator
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

COLUMNS = ("a", "alpha", "d", "theta")
ANGLE_COLUMNS = ("alpha", "theta")

UNITS = {"length_unit": {"m": 1.0, "cm": 1e-2, "mm": 1e-3}, "angle_unit": {"rad": 1.0, "deg": math.pi / 180}}
"""The units of lengths in metres and of angles in radians, by the arguments of `read_table`."""

NUMBER = r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"

UNIT = re.compile(rf"({NUMBER})\s*(?:(mm|cm|m)\b|(°|deg(?:rees)?\b)|rad(?:ians)?\b)")

VARIABLE = re.compile(r"(?:q|theta|d)_?\d*", re.ASCII)
"""A joint variable; in another column than d, d_3 is a length whose value is missing."""

OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}

MAX_ENTRY_LENGTH, MAX_LENGTH_M = 200, 1e12
"""The maximum number of characters of an entry; and of a and d in metres, beyond which a pose resolves no millimetre."""


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


class Entry(NamedTuple):
    """An entry: its value, in which the variable is the imaginary unit (0.5 - q1 is 0.5 - 1j), and its variables.

    unit  "m" or "rad" if the entry says the unit of its numbers, which are in metres or radians then; "pi" if it has pi
    """

    value: complex
    variables: Sequence[str] = ()
    unit: str = ""


def read_entry(cell: str, column: str, names: Mapping[str, Entry]) -> Entry:
    """Read an entry of a column: sums, products and fractions of numbers, names and a variable; an empty one is 0, and column "" is any.

    Raises ValueError for anything else.
    """
    text = re.sub(r"[\\{}]|\(\s*var\w*\.?\s*\)|\*$", "", cell.strip(" \r\"'`*")).strip()
    if text in {"", "-", "/", "n.a.", "n/a", "None", "none"}:
        return Entry(0j)
    text = re.sub(r"(?i)^(?:var\w*|joint\w*|theta_?[ijkn]?|q_?[ijkn]?|d_?[ijkn])$", "q", text)
    units = {"m" if unit[2] else "rad" for unit in UNIT.finditer(text)}
    text = UNIT.sub(lambda f: f"({f[1]}*{UNITS['length_unit'][f[2]] if f[2] else 'pi/180' if f[3] else 1})", text)
    text = re.sub(rf"({NUMBER}|\))\s*(?=(?:pi|q_?\d*)\b|theta)", r"\1*", text)
    try:
        # Python also reads 0x1F and 1_000, but people do not.
        if len(cell) > MAX_ENTRY_LENGTH or re.search(r"[^\w\s.+*/()-]|\b\d+_|\b0[xXbBoO]", text):
            raise TypeError("not an entry of a table")
        tree = ast.parse(text, mode="eval").body
        used = list(dict.fromkeys(node.id for node in ast.walk(tree) if isinstance(node, ast.Name)))
        variables = [name for name in used if VARIABLE.fullmatch(name) and (column == "d" or name[0] != "d")]
        values = {**dict.fromkeys(variables, 1j), "pi": math.pi}
        values |= {name: names[name].value for name in used if name in names}
        if not np.isfinite(value := _evaluate(tree, values)):
            raise ValueError("not finite")
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError, ValueError) as error:
        raise ValueError(
            f"an entry must be a number, or a joint variable with a number; got {cell!r:.200}. {_hint(text, column, error)}."
        ) from error
    units |= {names[name].unit for name in used if name in names} - {""}
    if column and units & {"m" if column in ANGLE_COLUMNS else "rad"}:
        raise ValueError(
            f"{cell!r:.200} is no {'angle' if column in ANGLE_COLUMNS else 'length'}. Are two columns swapped?"
        )
    free = [name.replace("_", "") for name in variables if name not in names]
    return Entry(value, free, units.pop() if units else "pi" if "pi" in used else "")


def _hint(text: str, column: str, error: Exception) -> str:
    if comma := re.search(r"(\d*),(\d+)", text):
        return f"The decimal sign is a point: write {comma[1] or 0}.{comma[2]}"
    if isinstance(error, KeyError):
        name = error.args[0]
        variable = f"If {name} is the joint variable, write q{re.sub(r'[^0-9]', '', name)}; if not, write"
        return f"{variable if column in ('d', 'theta') else 'Write'} its value in a line above the table, {name} = 0.3"
    return "Try 0.5, pi/2, q1 + pi/2 or -90°"


def _evaluate(node: ast.expr, values: Mapping[str, complex]) -> complex:
    """Evaluate sums, differences, products and fractions; no other syntax is accepted, so nothing else can be executed."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return complex(value)
        case ast.Name(id=name):
            return values[name]
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=operand):
            return _evaluate(operand, values) * (-1 if isinstance(sign, ast.USub) else 1)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            one, other = _evaluate(left, values), _evaluate(right, values)
            # A variable times or divided by a variable is no entry, and its square would be the square of the imaginary unit.
            if not other.imag or isinstance(op, ast.Add | ast.Sub) or (isinstance(op, ast.Mult) and not one.imag):
                return complex(OPERATORS[type(op)](one, other))
    raise TypeError(ast.dump(node))


COLUMN_NAMES = {
    name: column
    for column, names in {
        "a": "a r length linklength",
        "alpha": "alpha alfa alph al twist linktwist psi",
        "d": "d s linkoffset",
        "theta": "theta th q angle jointangle v var variable",
        "offset": "offset thetaoffset offsettheta theta0 zero jointoffset qoffset",
        "type": "type sigma jointtype kind",
        "flip": "flip",
    }.items()
    for name in names.split()
}
"""The names that people give to columns, in small letters without signs and indices."""

OTHER_WORDS = {"angle", "joint", "length", "link", "offset", "twist", "dh", "arm", "self", "robot", "value", "val", "list"}  # fmt: skip
"""The words that may be beside the name of a column: link length a, dh_alpha_values."""

NEEDED, ALL_COLUMNS = {"a", "alpha", "d"}, {*COLUMNS, "offset"}

HEADING_UNIT = re.compile(
    r"(?:\bin\b)?[\[(/,_]?\s*(?:(?<![a-zA-Z])(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b|°)\.?\s*[\])]?"
)
INDEX = re.compile(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$")


class Heading(NamedTuple):
    """A heading: its column, or "" if it is none; its unit, and the convention whose index it has: i standard, i-1 modified."""

    column: str
    unit: str = ""
    convention: str = ""


def parse_heading(head: str) -> Heading:
    """Read a heading, or the name that code has for a column.

    >>> parse_heading("alpha_{i-1} (deg)")
    Heading(column='alpha', unit='deg', convention='modified')
    """
    plain, unit = head.strip(" \"'`*:!{}").replace("\\", "").lower(), ""
    if len(plain) > MAX_ENTRY_LENGTH or re.search(r"[⁻⁺]|min|max|lim(?!e)|range", plain):  # limits of a joint
        return Heading("")
    if found := HEADING_UNIT.search(plain):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get((found[1] or "°")[:2], found[1])
        plain = (plain[: found.start()] + plain[found.end() :]) if found.start() else plain
    index = INDEX.search(plain)
    stem = plain[: index.start()] if index else plain
    words = [word[:1] + word[1:].removesuffix("s") for word in re.findall(r"(?<![\[(a-z])[a-z]+", stem)]
    alone = [word for word in words if word not in OTHER_WORDS]  # in "link length a" and "alpha [grados]"
    known = [re.sub("[^a-z0]", "", plain), "".join(words), *alone[: len(alone) == 1]]
    column = next((COLUMN_NAMES[text] for text in known if text in COLUMN_NAMES), "")
    convention = "" if not index else "modified" if index[1] else "standard" * bool(re.search("[ijkn]", index[0]))
    return Heading("offset" if column == "theta" and "offset" in words else column, unit, convention)


class Assumption(NamedTuple):
    """What was assumed: a sentence; and if the numbers alone suggest it, the argument that says otherwise, and its values."""

    text: str
    argument: str = ""
    options: Sequence[str] = ()


@dataclass
class Grid:
    """Rows of cells by column, or by their places, from "0" on, if the text has no heading, and where the rows are in the text.

    names, units  the values that names have, and the units of the columns
    convention    whose index a and alpha have, or ""
    """

    names: Mapping[str, Entry]
    rows: list[dict[str, str]] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    units: dict[str, str] = field(default_factory=dict)
    assumed: list[Assumption] = field(default_factory=list)
    convention: str = ""

    def assume(self, text: str, argument: str = "", options: Sequence[str] = ()) -> None:
        """Note what was assumed."""
        self.assumed.append(Assumption(text, argument, options))

    def is_entry(self, cell: str) -> bool:
        """Whether a cell can be an entry, with whatever values its names have."""
        unknown = {name: Entry(1 + 0j) for name in re.findall(r"\b[a-pr-su-zA-Z]\d+", cell)}
        try:
            return bool(read_entry(cell, "", {**unknown, **self.names})) and bool(cell.strip())
        except ValueError:
            return False
