r"""Read the rows of a DH table from text: what the text says is taken, and what it only suggests is assumed with a sentence.

The text, written as with a keyboard, becomes rows of cells: by calls and dictionaries, by lists, or by lines. Then the columns, the
units, the joints and the convention are found. A strict reader, as that of `DHTable` is, refuses what another assumes.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ALL_COLUMNS, COLUMNS, NUMBER, UNITS, Assumption, Entry, Grid, parse_heading, read_entry
from kinlib.dh.reading.lines import commented_rows, read_lines
from kinlib.dh.reading.named import definitions, read_named
from kinlib.dh.reading.spelling import plain_text

MAX_TEXT_LENGTH, MAX_ROWS, MIN_LENGTH_MM = 40_000, 60, 5.0
"""The maximum number of characters of a text, and of rows of a table; and the smallest length that is taken as one in millimetres."""

ORDERS = ("theta d a alpha", "a alpha d theta", "alpha a theta d", "alpha a d theta", "d a alpha theta", "a d alpha theta",
          "d theta a alpha", "theta a d alpha", "theta alpha a d", "a alpha theta d")  # fmt: skip
"""The orders of columns in books and toolboxes, the most usual ones first."""

END = re.compile(r"(?m)^[ \t]*(?:[#%]|//)?[ \t]*(base|tool)\s*=\s*(?:SE3\()?(\[\[.*)$")
JOINTS = re.compile(r"""\bjoints\s*=\s*["']([RPF]+)["']""")
SIGNS = re.compile(r"\bsigns\s*=\s*\[([-+\d., ]+)\]")
"""A base, a tool, joints and signs as `print(table)` and the texts to copy write them."""

SAID_UNITS = re.compile(
    r"(?i)\b(?:lengths?|distances?|dimensions?|angles?)(?!\w)[^\n.;\d]{0,40}?(?:\bin\b|[:=(\[])\s*"
    r"(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?|°)(?!\w)"
)
"""A sentence such as "lengths in mm, angles in degrees"."""

FOREIGN = re.compile(r"(?i)\b(?:inch(?:es)?|feet|ft)\b|[\[(]in[\])]|\w/in\b|\d ?in\b")
GROUPED, DECIMAL_COMMA = (
    re.compile(p) for p in (r"(?<![\d.,\[({])[1-9]\d{0,2},\d{3}(?![\d.,])", r"\b0,\d|\d,(?:\d{1,2}|\d{4,})(?!\d)")
)
"""Units that are not read, and numbers such as 1,250; if the text also has 0,3 or 89,2, its comma is a decimal sign."""

FIXED = re.compile(r"(?i)\b(flange|tool|hand|tcp|end.?effector|ee|fixed|gripper|base)\b")
TYPES = {"r": "R", "0": "R", "p": "P", "1": "P", "f": "F"}
"""The labels of rows without a joint, and how the types of joints begin."""

CONVENTIONS = {
    "modified": r"(?i)\b(?:modified|craig|mdh|proximal)\b|mdh\(|craig\w*\(",
    "standard": r"\b(?i:standard|classic|distal)\b|[a-z:]DH\(",
}
"""How a text says its convention, in words or by the names of its calls; the index of a and alpha says it, too."""


class Rows(NamedTuple):
    """The rows that were read: a, alpha, d, theta (m, 4), a letter and a sign per row; convention and ends only as the text says."""

    numbers: Array
    joints: str
    signs: Sequence[float]
    convention: str | None
    ends: Mapping[str, Any]
    assumed: Sequence[Assumption]


def read_rows(text: str, *, strict: bool, lengths: Mapping[str, float], joints: str = "", **said: str | None) -> Rows:
    """Read rows from text; joints and what else is said are the arguments of `read_table`.

    strict  whether what the text only suggests is refused; numbers without a unit are metres and radians then

    Raises ValueError for anything else, with the place of what cannot be read.
    """
    if len(text) > MAX_TEXT_LENGTH:
        raise ValueError(f"A table as text must have at most {MAX_TEXT_LENGTH} characters; got {len(text)}.")
    if re.search(r"[\w.]{500}|\t{500}", text):  # which would take long
        raise ValueError("No table was found: the text has a word of 500 characters or more, or as many tabs.")
    own_joints, own_signs = JOINTS.search(text), SIGNS.search(text)
    plain = plain_text(END.sub("", SIGNS.sub("", JOINTS.sub("", text))))
    if unit := FOREIGN.search(plain):
        raise ValueError(f"Lengths must be in m, cm or mm; the text has {unit[0]!r}. One inch is 25.4 mm.")
    names = definitions(plain) | {plain_text(name): Entry(complex(value)) for name, value in lengths.items()}
    grid = _grid(plain, names)
    if "0" in grid.rows[0]:
        _name_columns(grid, said.get("order") or "a alpha d theta" * ("DHTable(" in plain))
    _complete(grid)
    entries = _evaluate(grid)
    letters = joints or (own_joints[1] if own_joints else _joints(grid, entries))
    signs = [entry["theta"].value.imag + entry["d"].value.imag for entry in entries]
    signs = [float(sign) for sign in own_signs[1].split(",")] if own_signs else signs
    numbers = np.array([[row[column].value.real for column in COLUMNS] for row in entries])
    for argument in UNITS:
        for i, column, factor in _units(grid, entries, plain, argument, said.get(argument) or "", strict=strict):
            numbers[i, COLUMNS.index(column)] *= factor
    if strict and grid.assumed:
        raise ValueError(f"A DHTable takes only what its rows say; kl.read_table assumes: {grid.assumed[0].text}")
    for line in commented_rows(plain)[:2]:
        grid.assume(f"A comment was not read: {line!r:.80}.")
    if fixed := [str(k) for k, letter in enumerate(letters, start=1) if letter == "?"]:
        grid.assume(f"Rows without a variable were read as fixed, without a joint: {', '.join(fixed)}.")
    named = [name for name, pattern in CONVENTIONS.items() if re.search(pattern, plain)]
    found = grid.convention or (named[0] if len(named) == 1 else None)
    if not strict and not said.get("convention"):
        suggests = grid.convention == "standard" and "standard" not in named
        words = f"The convention is {found}, as the {'index i of a and alpha suggests' if suggests else 'text says'}."
        words = words if found else "The text does not say which convention: standard was taken."
        grid.assume(words, *(("convention", ("standard", "modified")) if suggests or not found else ()))
    signs = [sign or 1.0 for sign in signs] if any(signs) else []
    ends = {}
    for end, matrix in END.findall(text):
        entry = np.array(re.findall(rf"-?{NUMBER}", matrix), float)
        ends[end] = entry.reshape((4, 4) if entry.size == 16 else -1)  # the table refuses what is no pose
    return Rows(numbers, letters.replace("?", "F"), signs, found, ends, grid.assumed)


def _grid(plain: str, names: Mapping[str, Entry]) -> Grid:
    """Return the rows of cells as the first reader finds them, and tell what it does not read of the text."""
    readers = (read_named, read_lines)
    grid = next((found for reader in readers if (found := reader(plain, names)).rows), Grid(names))
    if not grid.rows:
        raise ValueError(
            "No table was found: no line has four numbers, or more below a heading, and no list names a, alpha, d. "
            "Paste 'a alpha d theta', then one row in a line."
        )
    if len(grid.rows) > MAX_ROWS:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; got {len(grid.rows)}.")
    if end := re.search(r"(?i)\b(base|tool)\s*(?:=|\|\s*t =).*", plain):
        grid.assume(f"The {end[1]} was not read: {end[0]!r:.80}.")
    if (number := GROUPED.search(plain)) and not DECIMAL_COMMA.search(plain):
        grid.assume(f"The comma of {number[0]} was read as a decimal sign.")
    return grid


def _name_columns(grid: Grid, order: str) -> None:
    """Name the columns of cells without a heading: as `order` says, or in the usual order that suits their numbers best."""
    if order and sorted(order.split()) != sorted(COLUMNS):
        raise ValueError(f'order must name the columns, such as "theta d a alpha"; got {order!r:.60}.')
    if not order and _is_counted([row["0"] for row in grid.rows]):
        raise ValueError("The first column only counts the rows. Name the columns above them, as in 'i a alpha d'.")
    suits = []
    for k in "0123":
        text = " ".join(row[k] for row in grid.rows)
        sizes = np.array(re.findall(NUMBER, text), float)
        is_angle = bool(re.search("pi|°", text)) or np.isin(sizes.round(2), (1.57, 90, 180, 3.14, 45)).any()
        angle, variable = 2 * is_angle or -bool((sizes % 1).any()), 4 * bool(re.search(r"\bq|theta", text))
        suits.append({"a": -angle, "alpha": angle, "d": -angle, "theta": angle + variable})
    best = order or max(ORDERS, key=lambda names: sum(suits[k][name] for k, name in enumerate(names.split())))
    names = dict(zip("0123", best.split(), strict=True))
    grid.rows = [{names.get(key, key): cell for key, cell in row.items()} for row in grid.rows]
    if not order:
        words = f"The columns have no heading: they were taken as {', '.join(best.split())}."
        grid.assume(words, "order", [best, *(known for known in ORDERS if known != best)][:6])


def _is_counted(labels: list[str]) -> bool:
    return labels in ([str(k + start) for k in range(len(labels))] for start in (0, 1))


def _complete(grid: Grid) -> None:
    """Give all rows the columns that any of them has; a column that no row has is 0, and theta then is the variable."""
    columns = {name for row in grid.rows for name in row} & ALL_COLUMNS
    for name in sorted({*COLUMNS} - columns - ({"theta"} if "offset" in columns else set())):
        grid.assume(f"There is no column {name}: it was read as {'the joint variable' if name == 'theta' else 0}.")
    empty = {name: "" if name in columns else "0" for name in ALL_COLUMNS}
    types = [TYPES.get(row.get("type", "")[:1].lower(), "?") for row in grid.rows]
    grid.rows = [empty | row | {"type": letter} for row, letter in zip(grid.rows, types, strict=True)]
    if count := sum(not row[name].strip() for row in grid.rows for name in columns):
        grid.assume(f"{count} empty cells were read as 0." if count > 1 else "An empty cell was read as 0.")
    labels = [row.get("label", "").rstrip(".") for row in grid.rows]
    if all(label.isdigit() for label in labels) and not _is_counted(labels):
        grid.assume(f"The rows have the numbers {', '.join(labels)}: they were read as they stand.")


def _evaluate(grid: Grid) -> list[dict[str, Entry]]:
    """Evaluate all cells, and add the offset of a joint to its variable; ValueError with the place of what has no sense."""
    entries = []
    for row, place in zip(grid.rows, grid.places, strict=True):
        read, moving = dict[str, Entry](), "d" if row["type"] == "P" else "theta"
        for column in (*COLUMNS, "offset"):
            moving = "d" if column == "offset" and read["d"].variables else moving
            try:
                read[column] = read_entry(row[column], moving if column == "offset" else column, grid.names)
            except ValueError as error:
                raise ValueError(f"{place}, {column}: {error}") from error
        one, other = read[moving], read.pop("offset")
        read[moving] = Entry(one.value + other.value, [*one.variables, *other.variables], one.unit or other.unit)
        names = [name for each in read.values() for name in each.variables]
        factors = {column: entry.value.imag for column, entry in read.items() if entry.variables}
        if len(names) > 1 or not {*factors} <= {"d", "theta"} or not {*factors.values()} <= {1, -1}:
            factor = f", with the factor {next(iter(factors.values())):g}" * (len(names) == 1)
            raise ValueError(
                f"{place}: a row must have one joint variable, q or -q without a factor, in theta or in d; got {' and '.join(names)} in "
                f"{' and '.join(factors)}{factor}. Are two columns swapped?"
            )
        entries.append(read)
    return entries


def _joints(grid: Grid, entries: list[dict[str, Entry]]) -> str:
    """Find the letter of the joint of each row: from its variable, a column of types, or because all rows have one; "?" if none says it."""
    columns = [next((name for name in ("theta", "d") if entry[name].variables), "") for entry in entries]
    letters = [{"theta": "R", "d": "P"}.get(name, row["type"]) for name, row in zip(columns, grid.rows, strict=True)]
    variables = [entry[column].variables[0] for entry, column in zip(entries, columns, strict=True) if column]
    numbers = [int(number) for name in variables if (number := re.sub(r"\D", "", name))]
    if numbers and numbers != [*range(1, len(variables) + 1)]:
        grid.assume(f"The variables are {', '.join(variables)}, not 1, 2, ...: each is the joint of its row.")
    if {*letters} <= {"?", "P"} and "?" in letters:
        fixed = [k for k, row in enumerate(grid.rows) if FIXED.search(row.get("label", "")) and k]
        letters = ["F" if k in fixed else letter.replace("?", "R") for k, letter in enumerate(letters)]
        others = "each other row" if "P" in letters or fixed else "each row"
        named = "".join(f"row {k + 1} is fixed, as its name says, and " for k in fixed)
        if named or not any("no column theta" in each.text for each in grid.assumed):
            grid.assume(f"theta has no variable: {named}{others} is a revolute joint, with the number as its offset.")
    return "".join(letters)


def _units(
    grid: Grid, entries: list[dict[str, Entry]], plain: str, argument: str, given: str, *, strict: bool
) -> list[tuple[int, str, float]]:
    """Return row, column and factor of the numbers that have no unit, to convert them to metres or radians.

    Their unit is that of the argument, of their heading, of a sentence, of the only heading that has one, or what the sizes suggest.
    """
    units, is_length = UNITS[argument], argument == "length_unit"
    if given and given not in units:
        raise ValueError(f"{argument} must be one of {', '.join(units)}; got {given!r:.60}.")
    columns = ("a", "d") if is_length else ("alpha", "theta")
    heads = {column: unit for column, unit in grid.units.items() if column in columns and unit in units}
    by_sentence = {parse_heading(f"a [{unit}]").unit for unit in SAID_UNITS.findall(plain)} & {*units}
    default = ("m" if is_length else "rad") * strict
    said = by_sentence.pop() if len(by_sentence) == 1 else default
    said = said or (next(iter(heads.values())) if len({*heads.values()}) == 1 else "")
    places = [(i, k) for i, row in enumerate(entries) for k in columns if not row[k].unit and row[k].value.real]
    sizes = [abs(entries[i][k].value.real) for i, k in places if k not in heads]
    if sizes and not given and not (default and said == default):
        is_large = max(sizes) > (MIN_LENGTH_MM if is_length else 2 * np.pi + 0.01)
        has_right_angle = not is_length and np.isclose(sizes, np.pi / 2, atol=1e-2).any()
        unit = said or (("m", "mm") if is_length else ("rad", "deg"))[is_large]
        kind, options = argument.replace("_unit", "s"), (unit, *(other for other in units if other != unit))
        if not said:
            words = f"The text does not say the unit of its {kind}: {unit} was taken, because the largest is {max(sizes):.6g}."
            grid.assume(words, *(() if has_right_angle else (argument, options)))
        elif {"m": is_large, "deg": has_right_angle, "rad": False}.get(said, max(sizes) < 1):
            words = f"The text says that its {kind} are in {said}, and this was taken, although the largest is {max(sizes):.6g}."
            grid.assume(words, argument, options)
        said = unit
    return [(i, k, units[given or heads.get(k, said)]) for i, k in places]
