r"""Read a DH table as people paste it: from a data sheet, a web page, a spreadsheet, a paper, or code.

The text becomes a grid of cells by one of five readers: calls such as RevoluteDH(a=0.4), dictionaries by row, lists by column, names
with indices such as d1 = 0.3, or lines of cells. Then the columns, the units, the joints and the convention are found. What the text
says is taken; what it only suggests is assumed with a sentence, and where the numbers alone suggest it, the assumption lists the
options, so that a person can be asked. `kinlib.dh.parsing` evaluates the entries, for this and for the strict tables of `DHTable`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from kinlib.arrays.formatting import format_vector
from kinlib.arrays.validation import describe
from kinlib.dh.parsing import COLUMNS, MAX_TEXT_LENGTH, NUMBER, Entry, evaluate_entry, respelled
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.rigid.lie import homogeneous

MAX_LINES, MAX_CELLS, MAX_ROWS = 2000, 40, 60
"""The maximum number of lines and of cells in a line that are read, and of rows of a table."""

SYNONYMS = {
    **dict.fromkeys(("a", "r", "length", "linklength", "aj", "ai", "an"), "a"),
    **dict.fromkeys(("alpha", "alfa", "alph", "twist", "linktwist", "psi", "alphaj"), "alpha"),
    **dict.fromkeys(("d", "s", "linkoffset", "dj", "di"), "d"),
    **dict.fromkeys(("theta", "th", "q", "angle", "jointangle", "v", "thetaj", "var", "variable"), "theta"),
    **dict.fromkeys(("offset", "thetaoffset", "offsettheta", "theta0", "zero", "jointoffset", "qoffset"), "offset"),
    **dict.fromkeys(("type", "sigma", "jointtype", "kind"), "type"),
}
"""The names that people give to columns, in small letters without signs and indices."""

ORDERS = ("theta d a alpha", "a alpha d theta", "alpha a theta d", "alpha a d theta", "d a alpha theta", "a d alpha theta",
          "d theta a alpha", "theta a d alpha", "alpha a offset d", "theta alpha a d", "a alpha theta d")  # fmt: skip
"""The orders of columns in books and toolboxes, the most usual ones first."""

LENGTH_UNITS, ANGLE_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}, {"rad": 1.0, "deg": np.pi / 180}

MIN_MILLIMETRES = 5.0
"""Lengths of arms in metres are smaller."""

TOOL_WORDS = re.compile(r"\b(flange|tool|hand|tcp|end.?effector|ee|fixed|gripper|base)\b", re.IGNORECASE)

LABEL = re.compile(r"\b(joint|link|axis|j|l|link_?joint|row|frame)[\s_-]?(\d+)\b", re.IGNORECASE)


class Assumption(NamedTuple):
    """What was assumed: a sentence; and if the numbers alone suggest it, the argument that says otherwise, and its values."""

    text: str
    argument: str = ""
    options: Sequence[str] = ()


class Reading(NamedTuple):
    """A table that was read, and what was assumed for it."""

    table: DHTable
    assumed: Sequence[Assumption]


@dataclass
class _Grid:
    """Rows of cells by column name, or in an order that is not known, with their places in the text and the units of the columns."""

    rows: list[dict[str, str]] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    cells: list[list[str]] = field(default_factory=list)
    units: dict[str, str] = field(default_factory=dict)
    modified: bool | None = None
    notes: list[str] = field(default_factory=list)


def read_table(
    text: str,
    *,
    convention: Convention | None = None,
    order: str = "",
    length_unit: str = "",
    angle_unit: str = "",
    joints: str = "",
    lengths: Mapping[str, float] | None = None,
    name: str = "table",
) -> Reading:
    r"""Read a table that was pasted, and list what was assumed.

    convention   "standard" or "modified"; by default as the text says, and otherwise asked
    order        the columns of a text without a heading, for example "theta d a alpha"
    length_unit  "m", "cm" or "mm"; angle_unit  "rad" or "deg"; by default as the text says, or as the numbers suggest
    joints       a letter for each row, R, P or F; by default those that have a variable, or all rows
    lengths      values in metres of names in the entries

    Raises ValueError for a text without a table, with the line that cannot be read and what to try.

    >>> table, assumed = read_table("theta(deg); d(mm); a(mm); alpha(deg)\n0; 89,2; 0; 90\n0; 0; -425; 0", convention="standard")
    >>> table.rows.round(4)[:, :3]
    array([[ 0.    ,  1.5708,  0.0892],
           [-0.425 ,  0.    ,  0.    ]])
    >>> [each.text for each in assumed if "theta" in each.text]
    ['theta has no variable: each row is a revolute joint, with the number as its offset.']
    """
    if not isinstance(text, str):
        raise ValueError(f"text must be the text of a table; got {describe(text)}. Pass rows of numbers to DHTable.")
    if len(text) > MAX_TEXT_LENGTH:
        raise ValueError(f"A table as text must have at most {MAX_TEXT_LENGTH} characters; got {len(text)}.")
    plain, values, ends = _plain(text), dict(lengths or {}), dict[str, Any]()
    for end, place, angles in re.findall(r"\b(base|tool)\s*\|\s*t = ([-\d., ]+);\s*rpy/xyz = ([-\d.°, ]+)\|?", plain):
        if not re.search("[1-9]", angles):  # printed by the Robotics Toolbox
            ends[end] = homogeneous(np.eye(3), [float(number) for number in place.split(",")])
            plain = re.sub(rf"^.*\b{end}\s*\|\s*t = .*$", "", plain, flags=re.MULTILINE)
    grid = next((found for reader in READERS if (found := reader(plain)) and (found.rows or found.cells)), None)
    if grid is None:
        raise ValueError(
            "No table was found: no line has four numbers, and no call or list names a, alpha, d and theta. Paste the rows with a "
            "heading such as 'a alpha d theta', one row in a line."
        )
    values |= {key: value for key, value in _definitions(plain).items() if key not in values}
    assumed = [Assumption(note) for note in grid.notes]
    assumed += [
        Assumption(f"The {end} was read as a translation by {format_vector(T[:3, 3])} m.") for end, T in ends.items()
    ]
    if not grid.rows:
        _name_columns(grid, order, values, assumed)
    if len(grid.rows) > MAX_ROWS:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; got {len(grid.rows)}.")
    entries = _evaluate(grid, values, assumed)
    if {"theta", "offset"} <= {*entries[0]}:
        entries = [row | {"theta": _sum(row["theta"], row["offset"])} for row in entries]
    elif "offset" in entries[0]:
        entries = [row | {"theta": row["offset"]} for row in entries]
    letters, signs = _joints(grid, entries, joints, assumed)
    numbers = np.array([[row[column].value.real for column in COLUMNS] for row in entries])
    numbers *= _scales(grid, entries, numbers, length_unit, angle_unit, assumed)
    if convention is None:
        said = _said_convention(plain, grid)
        convention = said or "standard"
        if said:
            assumed.append(Assumption(f"The convention is {said}, as the text says."))
        else:
            words = "The text does not say which convention: standard was taken."
            assumed.append(Assumption(words, "convention", ("standard", "modified")))
    table = DHTable(numbers, validate_convention(convention), joints=letters, signs=signs, name=name, **ends)
    return Reading(table, assumed)


def _plain(text: str) -> str:
    """Replace what HTML, LaTeX, terminals and code write for signs and separators by what a keyboard has."""
    import html  # for tables that were pasted; `import kinlib` loads no more than NumPy

    text = re.sub(r"\x1b\[[0-9;]*m|[\u200b\u200e\ufeff]", "", html.unescape(text))
    if re.search(r"<t[dh][\s>]", text):
        text = re.sub(r"\s*\n\s*", " ", text)
    text = re.sub(r"</t[dh]>\s*<t[dh][^>]*>", " | ", text)
    text = re.sub(r"</?(?:tr|table|br|p)\b[^>]*>", "\n", text)
    text = re.sub(r"<su[bp]>(.*?)</su[bp]>", r"_\1", text)
    text = re.sub(r"<[a-zA-Z/][^>]{0,200}>", " ", text)
    if re.search(r"\\(?:begin|hline|\\|frac|alpha|theta)|\$", text):
        text = re.sub(
            r"\\(?:begin|end)\{\w+\*?\}(?:\{[^}]*\})?|\\(?:hline|(?:top|mid|bottom)rule|cline\{[^}]*\})", "\n", text
        )
        text = re.sub(r"\\(?:text|mathrm|textbf|mathbf|mathit)\{([^{}]*)\}", r"\1", text)
        text = re.sub(r"\^\{?\s*\\circ\s*\}?|\\degree", "°", text)
        text = re.sub(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", text)
        text = re.sub(r"\\\\(?:\[[^]]*\])?", "\n", text).replace("&", " | ").replace("\\,", "").replace("$", "")
        text = re.sub(
            r"\\(alpha|theta|pi|cdot|times)\b", lambda found: {"cdot": "*", "times": "*"}.get(found[1], found[1]), text
        )
    for sign, plain in {
        "⍺": "alpha",
        "ⱼ": "_j",
        "ₙ": "_n",
        "’": "'",
        "\xa0": " ",
        "½": "1/2",
        "┃": "|",
        "│": "|",
        "║": "|",
    }.items():
        text = text.replace(sign, plain)
    text = re.sub(r"[─━═┌┐└┘├┤┬┴┼╔╗╚╝╠╣╦╩╬┏┓┗┛┳┻╋┠┨]+", "", respelled(text))
    text = re.sub(
        r"\b(?:M_PI|(?:np|numpy|math|Math|sp|sympy)\.(?:pi|PI)|PI)(?=_|\b)(_[24])?",
        lambda f: f"pi{(f[1] or '').replace('_', '/')}",
        text,
    )
    return re.sub(r"\b(?:(?:np|numpy|math)\.)?(?:deg2rad|radians)\(([^()]*)\)", r"\1°", text)


def _column(head: str) -> tuple[str, str, str]:
    """Return the name of a column, its unit, and its index "i" or "i-1", each "" if there is none."""
    if re.search(r"[⁻⁺]|min|max|lim|range", head):
        return "", "", ""
    unit = ""
    if found := re.search(
        r"[\[(/,]?\s*\b(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b\.?\s*[\])]?|°", head
    ):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get(
            found[0] if found[0] == "°" else found[1][:2], found[1]
        )
        head = (
            head[: found.start()] + head[found.end() :]
            if re.sub(r"[^a-z]", "", head[: found.start()].lower())
            else head
        )
    plain = head.strip().strip("\"'`*:").lower()
    index = re.search(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$", plain)
    bare = re.sub(r"[^a-z0]", "", plain[: index.start()] if index and index.start() else plain)
    name = SYNONYMS.get(re.sub(r"[^a-z0]", "", plain)) or SYNONYMS.get(bare, "")
    return name, unit, ("i-1" if index and index[1] else "i" if index and re.search("[ijkn]", index[0]) else "")


CALL = re.compile(
    r"\b(?!\w*Robot)(\w*?)(Revolute|Prismatic|DHLink|Link|DH_Craig1989|DH|DHRevolute|DHPrismatic)(M?DH)?\w*\s*\(((?:[^()]|\([^()]*\))*)\)"
)


def _from_calls(text: str) -> _Grid | None:
    """Read calls: RevoluteDH(d=0.1, a=0.2), Link([0 0.1 0.2 pi/2]), DH_Craig1989(a, alpha, d, theta)."""
    grid = _Grid()
    for found in CALL.finditer(text):
        kind, inside = found[0].partition("(")[0], found[4]
        named = dict(re.findall(r"['\"]?\b([a-zA-Z]\w*)['\"]?\s*(?:=|,(?=\s*[-\d]))\s*([^,=\[\]]+)", inside))
        row = {_column(key)[0] or key: value.strip() for key, value in named.items()}
        positional = [cell for cell in re.split(r"[,\s]+", re.sub(r"[\[\]{}]", " ", inside).strip()) if cell]
        if ({*row} & {*COLUMNS, "offset"} or not positional) and not re.match(r"\s*[\[{]", inside):
            row = {column: row.get(column, "0") for column in (*COLUMNS, "offset")}
        elif len(positional) >= 4 and all(_is_entry(cell) for cell in positional[:4]):
            is_kdl = "Frame" in text[max(0, found.start() - 8) : found.start()] or "Craig" in kind
            row = dict(
                zip(("a", "alpha", "d", "theta") if is_kdl else ("theta", "d", "a", "alpha"), positional, strict=False)
            )
            row |= {"type": positional[4]} if len(positional) > 4 and positional[4] in "01" else {}
            note = f"{kind}(...) was read as ({', '.join([*row][:4])})."
            grid.notes = [note]
        else:
            continue
        if re.search("revolute", kind, re.IGNORECASE):
            row |= {"type": "R", "theta": "0"} if "offset" in row and named.get("offset") else {"type": "R"}
        elif re.search("prismatic", kind, re.IGNORECASE):
            row |= {"type": "P", "d": row.get("offset") or row["d"], "offset": "0"}
        grid.rows.append(row)
        grid.places.append(f"Call {len(grid.rows)}, {found[0]:.60}")
        if re.search(r"MDH|Craig|modified", kind):
            grid.modified = True
        elif re.search("DH$", kind) and "DH" in kind:
            grid.modified = bool(grid.modified)
    return _uniform(grid) if len(grid.rows) > 1 else None


def _from_dictionaries(text: str) -> _Grid | None:
    """Read dictionaries by row: {"a": 0, "alpha": pi/2, "d": 0.1, "theta": "q1"}."""
    grid = _Grid()
    for found in re.finditer(r"\{([^{}]*)\}|(?:^|\n)\s*-\s+(\w+\s*:[^\n]*(?:\n\s+\w+\s*:[^\n]*)*)", text):
        inside = found[1] or found[2]
        pairs = re.findall(r"['\"]?(\w+)['\"]?\s*[:=]\s*['\"]?([^,'\"\n;]+)", inside)
        named = [(_column(key)[0], value.strip()) for key, value in pairs if _column(key)[0]]
        row = dict(named)
        if {"a", "alpha", "d"} <= {*row} and len(row) == len(named):
            grid.rows.append(row)
            grid.places.append(f"Row {len(grid.rows)}, {found[0].strip():.60}")
    return _uniform(grid) if grid.rows else None


def _from_columns(text: str) -> _Grid | None:
    """Read lists by column, a = [0, -0.425, ...], and names with indices, d1 = 0.1; a2 = -0.425."""
    lists, modified = dict[str, list[str]](), None
    for found in re.finditer(
        r"['\"]?\b([a-zA-Z][\w.]*)['\"]?\]?\s*[=:]\s*(?:\w+\.\w+\()?[\[({]([^\[\](){}]*)[\])}]", text
    ):
        column = _column(found[1].rpartition(".")[2])[0] or _column(found[1].rpartition("_")[2])[0]
        cells = [cell for cell in re.split(r"[,;]|\s+(?![*/+-]\s)", found[2].strip()) if cell.strip()]
        if column and cells and all(_is_entry(cell) for cell in cells):
            lists[column] = cells
    if not {"a", "alpha", "d"} <= {*lists}:
        lists, by_index = {}, dict[str, dict[int, str]]()
        for name, number, value in re.findall(r"\b([a-zA-Z]+)_?(\d{1,2})\s*[=:]\s*([^,;\n}]+)", text):
            if (column := _column(name)[0]) and _is_entry(value):
                by_index.setdefault(column, {})[int(number)] = value
        if not {"a", "alpha", "d"} <= {*by_index}:
            return None
        modified = min(*by_index["a"], *by_index["alpha"]) < min(by_index["d"]) == 1  # a_0 and alpha_0, but d_1
        for column in ("a", "alpha") if modified else ():
            by_index[column] = {k + 1: value for k, value in by_index[column].items()}
        indices = sorted({k for column in by_index.values() for k in column})
        lists = {column: [cells.get(k, "") for k in indices] for column, cells in by_index.items()}
    count = max(map(len, lists.values()))
    if short := [f"{column} ({len(cells)})" for column, cells in lists.items() if len(cells) != count]:
        raise ValueError(
            f"The lists must have the same length, {count}; {', '.join(short)} has another. Is an entry missing?"
        )
    rows = [{column: cells[k] for column, cells in lists.items()} for k in range(count)]
    return _uniform(_Grid(rows, [f"Entry {k + 1} of the lists" for k in range(count)], modified=modified or None))


def _from_lines(text: str) -> _Grid | None:
    """Read lines of cells, with a heading or without one."""
    if re.search(r"[\[{(]\s*[\[{(]|=\s*[\[{]|[\[{][^\]}]*;", text) and not re.search(r"\[(?:mm?|cm|rad|deg|°)\]", text):
        text = re.sub(r"^[^\n#%/]*?[=(]\s*(?=[\[{])", "", text, flags=re.MULTILINE)  # the name of an array
        text = re.sub(r"[\[\]{}]", " ", re.sub(r"[\]})]\s*[,;]?\s*(?=[\[{(])|;", "\n", text))
    grid, heads, is_after_gap, widths = _Grid(), list[str](), False, set[int]()
    lines = text.splitlines()[:MAX_LINES]
    if columns := _across(lines):
        return columns
    for number, raw in enumerate(lines, start=1):
        line = LABEL.sub(r"\1\2", re.sub(r"^\s*(?:#+|%+|//+|/?\*+|>+)\s*", "", raw)).strip().rstrip(",")
        line = re.sub(r"\s+(?=[\[(](?:mm?|cm|rad|deg\w*|°|i|i-1)[\])])", "", line)
        if not re.sub(r"[|\s:+=-]", "", line):
            is_after_gap = True
            continue
        place, splits = f"Line {number}, {raw.strip()!r:.80}", _splits(line)
        if is_after_gap and widths:  # another table may follow
            splits = [cells for cells in splits if len(cells) in widths]
        if not grid.rows and any(names := [_heading(cells, grid) for cells in splits]):
            heads, grid.cells, grid.places = next(filter(None, names)), [], []
        elif heads and (row := next(filter(None, (_row(cells, heads) for cells in splits)), None)):
            grid.rows.append(row)
            grid.places.append(place)
            widths |= {len(cells) for cells in splits if _row(cells, heads) == row}
        elif not heads and (plain := next(filter(None, map(_plain_row, splits)), None)):
            grid.cells.append(plain)
            grid.places.append(place)
        elif heads or grid.cells:
            numbers = len(re.findall(rf"(?<![\w.])-?{NUMBER}", line))
            has_rows = bool(grid.rows or grid.cells)
            if has_rows and (is_after_gap or (numbers and ("=" in line or numbers < 3))):
                grid.notes.append(f"What follows the table was not read, from line {number}: {raw.strip()!r:.60}.")
                break
            if numbers >= 3:
                raise ValueError(
                    f"{place} cannot be read: it has another number of cells than the heading, or a cell that is no number. Write 0 into "
                    "empty cells, and one cell for each heading."
                )
        is_after_gap = False
    return _uniform(grid) if grid.rows else grid


def _across(lines: Sequence[str]) -> _Grid | None:
    """Read a table whose columns are the rows: lines that begin with a, alpha, d and theta."""
    found = [cells for line in lines for cells in _splits(line.strip())[-1:] if len(cells) > 2 and _is_entry(cells[1])]
    named = {_column(cells[0])[0]: cells[1:] for cells in found}
    count = len(named.get("a", ()))
    if not {"a", "alpha", "d"} <= {*named} or len(named["alpha"]) != count or len(named["d"]) != count:
        return None
    named = {name: cells for name, cells in named.items() if name and len(cells) == count}
    rows = [{name: cells[k] for name, cells in named.items()} for k in range(count)]
    notes = ["Each row is a column of the text."]
    return _uniform(_Grid(rows, [f"Column {k + 1}" for k in range(count)], notes=notes))


def _heading(cells: list[str], grid: _Grid) -> list[str]:
    """Return the names of the columns if the cells are a heading, and keep their units and their convention."""
    found = [_column(cell) for cell in cells]
    heads = [name for name, _, _ in found]
    if "offset" in heads and "d" not in heads:
        heads = ["d" if name == "offset" else name for name in heads]
    names = [name for name in heads if name in {*COLUMNS, "offset"}]
    if len({*names}) < 3 or len({*names}) < len(names) or any(re.fullmatch(NUMBER, cell) for cell in cells):
        return []
    grid.units = {name: unit for name, (_, unit, _) in zip(heads, found, strict=True) if name and unit}
    indices = {index for name, _, index in found if name in {"a", "alpha"} and index}
    grid.modified = "i-1" in indices if indices else None
    return heads


def _row(cells: list[str], heads: list[str]) -> dict[str, str] | None:
    """Return the cells of a row by column name; the label of a row may have no heading. None if the line is no row."""
    label = cells[0] if not heads[0] else ""
    if len(cells) == len(heads) + 1 and (not _is_entry(cells[0]) or cells[0].rstrip(".").isdigit()):
        label, cells = cells[0], cells[1:]
    is_short = heads[0] == "" and len(cells) >= len(heads) - 1
    row = {name: cell for name, cell in zip(heads, cells, strict=False) if name}
    readable = sum(_is_entry(cell) or not cell.strip() for name, cell in row.items() if name != "type")
    if not (len(cells) == len(heads) or is_short) or readable < max(3, len({*row} & {*COLUMNS})):
        return None
    return row | ({"label": label} if label else {})


def _plain_row(cells: list[str]) -> list[str]:
    """Return the cells that are entries, at least four, without the label of the row; [] if the line is no row."""
    entries = [cell for cell in cells if _is_entry(cell)]
    if len(entries) > 4 and re.fullmatch(r"[A-Za-z]+\d+", entries[0]):
        entries = entries[1:]
    return entries if len(entries) >= 4 else []


def _splits(line: str) -> list[list[str]]:
    """Split a line into cells at the separators that it may have, the surest first."""
    if "|" in line or "\t" in line or ";" in line:
        separator = "|" if "|" in line else "\t" if "\t" in line else ";"
        cells = line.strip().strip("|").split(separator) if separator == "|" else line.split(separator)
        split = [[_cell(cell, decimal_comma=True) for cell in cells[:MAX_CELLS]]]
        return split + ([line.split()[:MAX_CELLS]] if separator == "\t" else [])
    found = []
    if ("," in line and not re.fullmatch(r"(?:\S*\d,\d\S*|[^,\s]+)(?:\s+(?:\S*\d,\d\S*|[^,\s]+))*", line)) or (
        line.count(",") >= 3 and " " not in line
    ):
        found.append([_cell(cell) for cell in line.split(",")[:MAX_CELLS]])
    spaced = re.sub(r"\s*([+*/])\s*|(?<=[\w°)])\s+(-)\s+(?=\d|pi)", lambda f: f[1] or f[2], line)
    found += [
        [_cell(cell, decimal_comma=True) for cell in re.split(pattern, spaced)[:MAX_CELLS]]
        for pattern in (r"\s{2,}", r"\s+")
    ]
    return found


def _cell(cell: str, decimal_comma: bool = False) -> str:
    cell = cell.strip().strip("\"'`").strip("*").strip()
    for bracket, other in ("()", ")("):
        if cell.count(bracket) > cell.count(other):
            cell = cell.strip(bracket).strip()
    return re.sub(r"(?<=\d),(?=\d)", ".", cell) if decimal_comma else cell


def _entry(cell: str, column: str, lengths: Mapping[str, float]) -> Entry:
    """Evaluate a cell: an empty one is 0, "theta" or "var" is a variable, and a length may have its unit, in metres then."""
    cell = re.sub(r"\(\s*var\w*\s*\)|\*$|\b(?:rad|radians)$", "", _cell(cell)).strip()
    if cell in {"", "-", "/", "n.a.", "n/a", "None", "none"}:
        return Entry(0j)
    if re.fullmatch(r"(?:var\w*|joint\w*|theta[_{]*[ijkn]?\}*|q[_{]*[ijkn]?\}*|d_?[ijkn])", cell, re.IGNORECASE):
        cell = "q"
    if unit := re.fullmatch(rf"(-?\s*{NUMBER})\s*(mm|cm|m)", cell):
        return Entry(complex(float(unit[1].replace(" ", "")) * LENGTH_UNITS[unit[2]]), (), unit[2])
    cell = re.sub(r"(theta|q|d)_?\{?(\d+)\}?\*?", r"\1\2", cell).replace("degrees", "°").replace("deg", "°")
    return evaluate_entry(cell.lstrip("+"), column, lengths)


def _is_entry(cell: str) -> bool:
    """Whether a cell can be an entry, with whatever values its names have."""
    names = dict.fromkeys(re.findall(r"\b[a-zA-Z]_?\{?\d+\}?", cell), 1.0)
    try:
        _entry(cell, "theta", {re.sub("[{}]", "", name): value for name, value in names.items() if name[0] not in "qt"})
    except ValueError:
        return False
    return bool(cell.strip())


def _uniform(grid: _Grid) -> _Grid:
    """Give all rows the columns that any of them has; a column that no row has is 0, and theta then is the variable."""
    columns = {name for row in grid.rows for name in row} & {*COLUMNS, "offset"}
    if missing := [name for name in ("a", "alpha", "d") if name not in columns]:
        grid.notes.append(f"There is no column {' and '.join(missing)}: it was read as 0.")
    if not columns & {"theta", "offset"}:
        grid.notes.append("There is no column theta: each theta was read as the joint variable.")
    grid.rows = [
        {name: row.get(name, "" if name in columns else "0") for name in (*COLUMNS, *columns)} | row
        for row in grid.rows
    ]
    return grid


def _name_columns(grid: _Grid, order: str, lengths: Mapping[str, float], assumed: list[Assumption]) -> None:
    """Name the columns of cells without a heading: as `order` says, or in the usual order that suits the numbers best."""
    width = min(map(len, grid.cells))
    counted = [
        [row[0] for row in grid.cells] == [str(k) for k in range(start, start + len(grid.cells))] for start in (0, 1)
    ]
    if width > 4 and any(counted):
        grid.cells = [row[1:] for row in grid.cells]
    if order and sorted(order.split()) not in [sorted(known.split()) for known in ORDERS]:
        raise ValueError(f'order must name the columns, such as "theta d a alpha"; got {order!r:.60}.')
    values = [
        [_entry(cell, "theta", dict.fromkeys(re.findall(r"[a-z]\w*", cell), 1.0) | {**lengths}) for cell in row[:4]]
        for row in grid.cells
    ]
    texts = [" ".join(row[k] for row in grid.cells) for k in range(4)]

    def fits(names: str) -> int:
        """How well the numbers suit an order: right angles and variables are in the angles, and no length is one."""
        score = 0
        for k, name in enumerate(names.split()):
            column = np.array([row[k].value.real for row in values])
            is_angle = bool(re.search("pi|°", texts[k])) or bool(
                np.any(np.isin(np.abs(column).round(2), (1.57, 90, 180, 3.14, 45)))
            )
            score += 2 * is_angle * (1 if name in {"alpha", "theta"} else -1)
            score += 2 * bool(re.search(r"\bq|theta", texts[k])) * (1 if name == "theta" else -1)
            is_length = bool((column % 1 != 0).any()) and not is_angle
            score += is_length * (1 if name in {"a", "d"} else -1)
        return score

    best = order or max(ORDERS, key=fits)
    names = best.replace("offset", "theta").split()
    grid.rows = [dict(zip(names, row, strict=False)) for row in grid.cells]
    if not order:
        words = f"The columns have no heading: they were read as {', '.join(names)}."
        assumed.append(Assumption(words, "order", [best, *(known for known in ORDERS if known != best)][:6]))


def _evaluate(grid: _Grid, lengths: Mapping[str, float], assumed: list[Assumption]) -> list[dict[str, Entry]]:
    """Evaluate all cells; the place of one that cannot be read is told."""
    entries, empty = [], 0
    for row, place in zip(grid.rows, grid.places, strict=False):
        read = {}
        for column in [name for name in row if name in {*COLUMNS, "offset"}]:
            cell = row[column]
            empty += not cell.strip()
            try:
                read[column] = _entry(cell, "theta" if column == "offset" else column, lengths)
            except ValueError as error:
                raise ValueError(f"{place}: {column}: {error}") from error
        entries.append(read)
    if empty and not any("There is no column" in note for note in grid.notes):
        assumed.append(Assumption(f"{empty} empty cells were read as 0."))
    return entries


def _sum(one: Entry, other: Entry) -> Entry:
    return Entry(one.value + other.value, [*one.variables, *other.variables], one.unit or other.unit)


def _joints(
    grid: _Grid, entries: list[dict[str, Entry]], joints: str, assumed: list[Assumption]
) -> tuple[str, list[float]]:
    """Find the letter and the sign of the joint of each row: from its variable, a column of types, or because all rows have one."""
    letters, signs = "", [1.0] * len(entries)
    for k, (row, cells) in enumerate(zip(entries, grid.rows, strict=True)):
        kind = cells.get("type", "").strip().lower()[:1]
        moving = [name for name in ("theta", "d") if row[name].variables]
        letter = {"r": "R", "0": "R", "p": "P", "1": "P", "f": "F"}.get(kind, "")
        if len(moving) > 1:
            raise ValueError(
                f"{grid.places[k]}: theta and d have a variable; one must be a number. Give lengths={{'d1': ...}}?"
            )
        if moving and abs(row[moving[0]].value.imag) != 1:
            raise ValueError(f"{grid.places[k]}: the joint variable must be q or -q, without a factor.")
        if moving:
            letter, signs[k] = {"theta": "R", "d": "P"}[moving[0]], row[moving[0]].value.imag
        letters += letter or "?"
    if joints:
        return joints, signs
    if "?" in letters and set(letters) <= {"?", "P"}:
        words = "theta has no variable: each row is a revolute joint, with the number as its offset."
        fixed = [k for k, row in enumerate(grid.rows) if TOOL_WORDS.search(row.get("label", "")) and k]
        letters = "".join("F" if k in fixed else letter.replace("?", "R") for k, letter in enumerate(letters))
        if fixed:
            words = f"{words[:-1]}; row {fixed[0] + 1} is fixed, as its name says."
        if not any("There is no column theta" in note for note in grid.notes):
            assumed.append(Assumption(words))
    elif "?" in letters:
        rows = ", ".join(str(k + 1) for k, letter in enumerate(letters) if letter == "?")
        assumed.append(Assumption(f"Row {rows} has no variable: it was read as fixed, without a joint."))
        letters = letters.replace("?", "F")
    return letters, signs


def _scales(  # noqa: PLR0917
    grid: _Grid,
    entries: list[dict[str, Entry]],
    numbers: np.ndarray,
    length_unit: str,
    angle_unit: str,
    assumed: list[Assumption],
) -> np.ndarray:
    """Find the factor of each number to metres and radians: by its own unit, the heading, the argument, or the numbers."""
    factors = np.ones(numbers.shape)
    for columns, given, units, argument in (
        ((0, 2), length_unit, LENGTH_UNITS, "length_unit"),
        ((1, 3), angle_unit, ANGLE_UNITS, "angle_unit"),
    ):
        if given and given not in units:
            raise ValueError(f"{argument} must be one of {', '.join(units)}; got {given!r:.60}.")
        names = [COLUMNS[k] for k in columns]
        plain = [(i, k) for i, row in enumerate(entries) for k in columns if not row[COLUMNS[k]].unit and numbers[i, k]]
        size = max((abs(float(numbers[place])) for place in plain), default=0.0)
        said = {grid.units[name] for name in names if grid.units.get(name) in units}
        unit = given or (said.pop() if len(said) == 1 else "")
        if not unit and plain:
            unit = ("m", "mm")[size > MIN_MILLIMETRES] if columns[0] == 0 else ("rad", "deg")[size > 2 * np.pi + 0.01]
            what = "lengths" if columns[0] == 0 else "angles"
            words = (
                f"The text does not say the unit of its {what}: {unit} was taken, because the largest is {size:.6g}."
            )
            is_sure = columns[0] == 1 and any(abs(abs(float(numbers[p])) - np.pi / 2) < 1e-2 for p in plain)
            assumed.append(
                Assumption(
                    words, "" if is_sure else argument, () if is_sure else (unit, *(u for u in units if u != unit))
                )
            )
        for i, k in plain:
            own = grid.units.get(COLUMNS[k], "")
            factors[i, k] = units[given or (own if own in units else unit)]
    return factors


def _said_convention(text: str, grid: _Grid) -> Convention | None:
    """The convention that the text names, in words, in the indices of its headings, or in the names of its calls."""
    if grid.modified is not None:
        return "modified" if grid.modified else "standard"
    said = {
        word.lower()
        for word in re.findall(r"\b(modified|craig|mdh|standard|classic|proximal|distal)\b", text, re.IGNORECASE)
    }
    modified, standard = said & {"modified", "craig", "mdh", "proximal"}, said & {"standard", "classic", "distal"}
    return None if bool(modified) == bool(standard) else "modified" if modified else "standard"


def _definitions(text: str) -> dict[str, float]:
    """Read the values of names, l1 = 0.3 or d1 = 89.2 mm, that stand beside a table."""
    found = re.findall(rf"\b([a-zA-Z]+_?\{{?\d+\}}?)\s*=\s*(-?{NUMBER})\s*(mm|cm|m)?\b", text)
    return {re.sub(r"[_{}]", "", name): float(value) * LENGTH_UNITS[unit or "m"] for name, value, unit in found}


READERS = (_from_calls, _from_dictionaries, _from_columns, _from_lines)
"""The readers of a text, the most specific first."""
