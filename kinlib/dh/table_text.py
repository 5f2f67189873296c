r"""Read the rows of a DH table from text: what the text says is taken, and what it only suggests is assumed with a sentence.

The text, written as with a keyboard, becomes rows of cells: by calls, lists, dictionaries, or lines. Then the columns, the units, the
joints and the convention are found. A strict reader, as that of `DHTable` is, refuses what another assumes.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np

from kinlib.arrays.formatting import format_vector
from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_UNITS, COLUMNS, LENGTH_UNITS, MIN_LENGTH_MM, Entry, read_entry
from kinlib.dh.reading.columns import ALL_COLUMNS, Assumption, Grid, parse_heading
from kinlib.dh.reading.lines import MAX_ROWS, read_lines
from kinlib.dh.reading.named import definitions, read_calls, read_columns, read_dictionaries
from kinlib.dh.reading.spelling import plain_text
from kinlib.rigid.lie import homogeneous

Convention = Literal["standard", "modified"]

MAX_TEXT_LENGTH = 100_000
"""The maximum number of characters of a text."""

ORDERS = ("theta d a alpha", "a alpha d theta", "alpha a theta d", "alpha a d theta", "d a alpha theta", "a d alpha theta",
          "d theta a alpha", "theta a d alpha", "alpha a offset d", "theta alpha a d", "a alpha theta d")  # fmt: skip
"""The orders of columns in books and toolboxes, the most usual ones first."""

READERS = (read_calls, read_columns, read_dictionaries, read_lines)

END = re.compile(r"(?m)^[ \t]*(?:[#%]|//)?[ \t]*(base|tool)\s*=\s*(?:SE3\()?(\[\[.*)$")
"""A base or a tool as `print(table)` and the texts to copy write it."""

TOOLBOX_END = re.compile(r"(?m)^.*\b(base|tool)\s*\|\s*t = ([-\d., ]+);\s*rpy/xyz = [-0.°, ]+(?:\|.*)?$")
"""A base or a tool without rotation, as the Robotics Toolbox prints it."""

A_UNIT = r"(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?|°)(?!\w)"
A_NAME = r"(?:a|d|alpha|theta)(?:_?[{(]?i(?:-1)?[)}]?)?"
SAID_UNITS = re.compile(
    rf"(?i)\b(?:lengths?|distances?|dimensions?|angles?|{A_NAME}\s*(?:,|&|\band\b)\s*{A_NAME})(?!\w)[^\n.;\d]{{0,40}}?(?:\bin\b|[:=(\[])\s*{A_UNIT}"
    rf"|\bunits?\b\W{{1,4}}{A_UNIT}(?:\W+(?:and\W+)?{A_UNIT})?"
)
"""A sentence such as "lengths in mm, angles in degrees", "a and d in mm" or "units: mm, deg"."""

SAID_JOINTS = re.compile(r"""\bjoints\s*=\s*["']([RPF]+)["']""")
SAID_SIGNS = re.compile(r"\bsigns\s*=\s*\[([-+\d., ]+)\]")
"""What the code of a `DHTable` says of its joints."""

FIXED = re.compile(r"\b(flange|tool|hand|tcp|end.?effector|ee|fixed|gripper|base)\b", re.IGNORECASE)
"""The labels of rows without a joint."""

SUBSCRIPTS: Mapping[str, Convention] = {"i": "standard", "i-1": "modified"}
CONVENTIONS: Mapping[Convention, str] = {
    "modified": r"(?i)\b(?:modified|craig|mdh|proximal)\b|mdh\(|craig\w*\(",
    "standard": r"\b(?i:standard|classic|distal)\b|[a-z:]DH\(",
}
"""How a text says its convention: by the index of a and alpha, in words, or by the names of its calls."""


class Rows(NamedTuple):
    """The rows that were read: a, alpha, d, theta (m, 4), a letter and a sign per row; convention and ends only as the text says."""

    numbers: Array
    joints: str
    signs: Sequence[float]
    convention: Convention | None
    ends: Mapping[str, Any]
    assumed: Sequence[Assumption]
    suggests: bool = False


def read_rows(
    text: str,
    *,
    strict: bool,
    lengths: Mapping[str, float],
    joints: str = "",
    order: str = "",
    length_unit: str = "",
    angle_unit: str = "",
) -> Rows:
    """Read rows from text; the arguments are those of `read_table`.

    strict  whether what the text only suggests is refused; numbers without a unit are metres and radians then

    Raises ValueError for anything else, with the place of what cannot be read.
    """
    if len(text) > MAX_TEXT_LENGTH:
        raise ValueError(f"A table as text must have at most {MAX_TEXT_LENGTH} characters; got {len(text)}.")
    if re.search(r"[\w.]{500}", text):  # which would take long
        raise ValueError("No table was found: the text has a word of 500 characters or more.")
    ends: dict[str, Any] = {end: _matrix(matrix) for end, matrix in END.findall(text)}
    plain, told = plain_text(SAID_SIGNS.sub("", END.sub("", text))), list[Assumption]()
    for end, place in TOOLBOX_END.findall(plain):
        ends[end] = homogeneous(np.eye(3), [float(number) for number in place.split(",")])
        told.append(Assumption(f"The {end} was read as a translation by {format_vector(ends[end][:3, 3])} m."))
    plain = TOOLBOX_END.sub("", plain)
    if inch := re.search(r"(?i)\b(?:inch(?:es)?|feet|ft)\b|[\[(]in[\])]|\w/in\b", plain):
        raise ValueError(f"Lengths must be in m, cm or mm; the text has {inch[0]!r}. One inch is 25.4 mm.")
    names = definitions(plain) | {plain_text(name): Entry(complex(value)) for name, value in lengths.items()}
    grid = next((found for reader in READERS if (found := reader(plain, names)) and found.rows), None)
    if grid is None:
        raise ValueError(
            "No table was found: no line has four numbers, or more below a heading, and no list names a, alpha, d. "
            "Paste 'a alpha d theta', then one row in a line."
        )
    if len(grid.rows) > MAX_ROWS:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; got {len(grid.rows)}.")
    grid.assumed += told
    if "0" in grid.rows[0]:
        _name_columns(grid, order, bool(re.search(CONVENTIONS["modified"], plain)))
    _complete(grid)
    entries = _evaluate(grid)
    signs = [entry["theta"].value.imag + entry["d"].value.imag for entry in entries]
    if said_signs := SAID_SIGNS.search(text):
        signs = [float(sign) for sign in said_signs[1].split(",")]
    if not joints and (said_joints := SAID_JOINTS.search(text)):
        joints = said_joints[1]
    letters = joints or _joints(grid, entries)
    numbers = np.array([[row[column].value.real for column in COLUMNS] for row in entries])
    said_units = _said_units(plain)
    for argument, given, default in (("length_unit", length_unit, "m"), ("angle_unit", angle_unit, "rad")):
        numbers *= _units(grid, entries, argument, given, said_units.get(argument, ""), default * strict)
    if strict and grid.assumed:
        raise ValueError(f"A DHTable takes only what its rows say; kl.read_table assumes: {grid.assumed[0].text}")
    if fixed := [str(k) for k, letter in enumerate(letters, start=1) if letter == "?"]:
        words = "Row {} has no variable: it was" if len(fixed) == 1 else "Rows {} have no variable: they were"
        grid.assume(f"{words.format(', '.join(fixed))} read as fixed, without a joint.")
    said: set[Convention] = {name for name, pattern in CONVENTIONS.items() if re.search(pattern, plain)}
    suggests = grid.subscript == "i" and "standard" not in said
    convention = SUBSCRIPTS.get(grid.subscript) or (said.pop() if len(said) == 1 else None)
    signs = [sign or 1.0 for sign in signs] if any(signs) else []
    return Rows(numbers, letters.replace("?", "F"), signs, convention, ends, grid.assumed, suggests)


def _matrix(text: str) -> Array:
    """Read [[1, 0, 0, 0], ...]; what is no pose is refused by the table."""
    numbers = [float(number) for number in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text)]
    return np.array(numbers).reshape((4, 4) if len(numbers) == 16 else -1)


def _name_columns(grid: Grid, order: str, is_modified: bool) -> None:
    """Name the columns of cells without a heading: as `order` says, or in the usual order that suits numbers and convention best."""
    if order and sorted(order.split()) not in [sorted(known.split()) for known in ORDERS]:
        raise ValueError(f'order must name the columns, such as "theta d a alpha"; got {order!r:.60}.')
    numbers = [row["0"].rstrip(".") for row in grid.rows]
    counted = [str((numbers[0] == "1") + k) for k in range(max(3, len(numbers)))]  # from 1 or from 0
    is_numbered = numbers == counted and not order.startswith("theta")
    orders = [known for known in ORDERS if known.endswith("theta") or not is_numbered]
    if is_numbered:
        grid.assume("The first column was read as the numbers of the rows, and each theta as the joint variable.")
        grid.rows = [{**row, "0": row["1"], "1": row["2"], "2": row["3"], "3": "q"} for row in grid.rows]
    suits = []
    for k in "0123":
        text = " ".join(row[k] for row in grid.rows)
        known = dict.fromkeys(re.findall(r"[a-z]\w*", text), Entry(1 + 0j)) | {**grid.names}
        sizes = np.abs([read_entry(row[k], "", known).value.real for row in grid.rows])
        is_angle = bool(re.search("pi|°", text)) or np.isin(sizes.round(2), (1.57, 90, 180, 3.14, 45)).any()
        length, variable = 2 * is_angle or -bool((sizes % 1).any()), 4 * bool(re.search(r"\bq|theta", text))
        craig = (is_modified and k == "0") / 2  # these tables begin with alpha
        suits.append({"a": -length, "alpha": length + craig, "d": -length, "theta": length + variable})
    best = order or max(orders, key=lambda names: sum(suits[k].get(n, 0) for k, n in enumerate(names.split())))
    names = best.replace("offset", "theta").split()
    grid.rows = [{names[int(key)] if key.isdigit() else key: cell for key, cell in row.items()} for row in grid.rows]
    if not order:
        words = f"The columns have no heading that can be read: they were read as {', '.join(names)}."
        grid.assume(words, "order", [best, *(known for known in orders if known != best)][:6])


def _complete(grid: Grid) -> None:
    """Give all rows the columns that any of them has; a column that no row has is 0, and theta then is the variable."""
    columns = {name for row in grid.rows for name in row} & ALL_COLUMNS
    if missing := [name for name in ("a", "alpha", "d") if name not in columns]:
        grid.assume(f"There is no column {' and '.join(missing)}: it was read as 0.")
    if not columns & {"theta", "offset"}:
        grid.assume("There is no column theta: each theta was read as the joint variable.")
    filled = {name: "" if name in columns else "0" for name in (*COLUMNS, *columns)}
    grid.rows = [filled | row for row in grid.rows]
    if empty := sum(not row[name].strip() for row in grid.rows for name in filled):
        grid.assume(f"{empty} empty cells were read as 0." if empty > 1 else "An empty cell was read as 0.")
    labels = [row.get("label", "").rstrip(".") for row in grid.rows]
    numbers = [int(label) for label in labels if re.fullmatch(r"\d{1,2}", label, re.ASCII)]
    if len(numbers) == len(labels) and numbers != [*range(numbers[0], numbers[0] + len(numbers))]:
        grid.assume(f"The rows have the numbers {', '.join(map(str, numbers))}: they were read as they stand.")


def _evaluate(grid: Grid) -> list[dict[str, Entry]]:
    """Evaluate all cells, and add the offset of theta to it; ValueError with the place of what cannot be read, or has no sense."""
    entries = []
    for row, place in zip(grid.rows, grid.places, strict=True):
        read = dict[str, Entry]()
        for column in ALL_COLUMNS & {*row}:
            try:
                read[column] = read_entry(row[column], "theta" if column == "offset" else column, grid.names)
            except ValueError as error:
                raise ValueError(f"{place}, {column}: {error}") from error
        one, other = read["theta"], read.pop("offset", Entry(0j))
        read["theta"] = Entry(one.value + other.value, [*one.variables, *other.variables], one.unit or other.unit)
        moving = {column: entry for column, entry in read.items() if entry.variables}
        names = [name for each in moving.values() for name in each.variables]
        factors = [each.value.imag for each in moving.values()]
        if moving and (len(names) > 1 or not {*moving} <= {"d", "theta"} or abs(factors[0]) != 1):
            raise ValueError(
                f"{place}: a row must have one joint variable, q or -q without a factor, in theta or in d; got {' and '.join(names)} in "
                f"{' and '.join(moving)}{f', with the factor {factors[0]:g}' * (len(names) == 1)}. Are two columns swapped?"
            )
        entries.append(read)
    return entries


def _joints(grid: Grid, entries: list[dict[str, Entry]]) -> str:
    """Find the letter of the joint of each row: from its variable, a column of types, or because all rows have one; "?" if none says it."""
    types = {"r": "R", "0": "R", "p": "P", "1": "P", "f": "F"}
    letters = [
        "R"
        if entry["theta"].variables
        else "P"
        if entry["d"].variables
        else types.get(row.get("type", "").strip()[:1].lower(), "?")
        for row, entry in zip(grid.rows, entries, strict=True)
    ]
    variables = [name for entry in entries for column in ("theta", "d") for name in entry[column].variables]
    numbers = [int(number) for name in variables if (number := re.sub(r"\D", "", name))]
    if numbers and numbers != [*range(1, len(variables) + 1)]:
        grid.assume(f"The variables are {', '.join(variables)}, not 1, 2, ...: each is the joint of its row.")
    if {*letters} <= {"?", "P"} and "?" in letters:
        others = "each row" if "P" not in letters else "each row that is not prismatic"
        words = f"theta has no variable: {others} is a revolute joint, with the number as its offset"
        fixed = [k for k, row in enumerate(grid.rows) if FIXED.search(row.get("label", "")) and k]
        letters = ["F" if k in fixed else letter.replace("?", "R") for k, letter in enumerate(letters)]
        if not any("no column theta" in each.text for each in grid.assumed):
            grid.assume(f"{words}; row {fixed[0] + 1} is fixed, as its name says." if fixed else f"{words}.")
    return "".join(letters)


def _said_units(text: str) -> dict[str, str]:
    """Return the units that sentences say, by the argument of `read_table`; not of what they contradict."""
    units = {parse_heading(f"a [{unit}]").unit for found in SAID_UNITS.findall(text) for unit in found if unit}
    kinds = {"length_unit": units & {*LENGTH_UNITS}, "angle_unit": units & {*ANGLE_UNITS}}
    return {argument: one.pop() for argument, one in kinds.items() if len(one) == 1}


def _units(  # noqa: PLR0917
    grid: Grid, entries: list[dict[str, Entry]], argument: str, given: str, in_words: str, default: str
) -> Array:
    """Return the factors (m, 4) that convert the numbers to metres or radians.

    Each number has its own unit, or that of the argument, of its heading, of a sentence, of the only heading that has one, or as the
    sizes suggest.
    """
    units, columns = (LENGTH_UNITS, (0, 2)) if argument == "length_unit" else (ANGLE_UNITS, (1, 3))
    if given and given not in units:
        raise ValueError(f"{argument} must be one of {', '.join(units)}; got {given!r:.60}.")
    cells = [[row[column] for column in COLUMNS] for row in entries]
    plain = [(i, k) for i, row in enumerate(cells) for k in columns if not row[k].unit and row[k].value.real]
    said = {unit for k in columns if (unit := grid.units.get(COLUMNS[k], "")) in units}
    sizes = [abs(cells[i][k].value.real) for i, k in plain if grid.units.get(COLUMNS[k], "") not in units]
    unit = given or in_words or default or (said.pop() if len(said) == 1 else "")
    if sizes and not given and (in_words or not unit):
        is_length = 0 in columns
        is_large = max(sizes) > (MIN_LENGTH_MM if is_length else 2 * np.pi + 0.01)
        has_right_angle = not is_length and any(abs(size - np.pi / 2) < 1e-2 for size in sizes)
        kind = "lengths" if is_length else "angles"
        unit = in_words or (("m", "mm") if is_length else ("rad", "deg"))[is_large]
        options = (unit, *(other for other in units if other != unit))
        if not in_words:
            words = f"The text does not say the unit of its {kind}: {unit} was taken, because the largest is {max(sizes):.6g}."
            grid.assume(words, *(() if has_right_angle else (argument, options)))
        elif {"m": is_large, "deg": has_right_angle, "rad": False}.get(unit, max(sizes) < 1):
            words = f"The text says that its {kind} are in {unit}, and this was taken, although the largest is {max(sizes):.6g}."
            grid.assume(words, argument, options)
    factors = np.ones((len(cells), 4))
    for i, k in plain:
        own = grid.units.get(COLUMNS[k], "")
        factors[i, k] = units[given or (own if own in units else unit)]
    return factors
