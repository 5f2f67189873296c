r"""Read the rows of a DH table from text, in any form in which people write one.

The text becomes rows of cells by one of three readers: calls and dictionaries by row, such as RevoluteDH(a=0.4); lists by column and
names with indices, such as d1 = 0.3; or lines of cells. Then the columns, the units, the joints and the convention are found. What the
text says is taken; what it only suggests is assumed with a sentence, or refused if the reader is strict, as that of `DHTable` is.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from kinlib.arrays.formatting import format_vector
from kinlib.arrays.validation import Array
from kinlib.dh.parsing import (
    COLUMN_NAMES,
    COLUMNS,
    MIN_LENGTH_MM,
    NUMBER,
    Entry,
    Heading,
    evaluate_entry,
    joint_of_row,
    parse_heading,
    parse_headings,
    respelled,
)
from kinlib.rigid.lie import homogeneous

MAX_TEXT_LENGTH, MAX_LINES, MAX_CELLS, MAX_ROWS = 100_000, 2000, 40, 60
"""The maximum number of characters of a text, of its lines and of the cells in a line that are read, and of rows of a table."""

ORDERS = ("theta d a alpha", "a alpha d theta", "alpha a theta d", "alpha a d theta", "d a alpha theta", "a d alpha theta",
          "d theta a alpha", "theta a d alpha", "alpha a offset d", "theta alpha a d", "a alpha theta d")  # fmt: skip
"""The orders of columns in books and toolboxes, the most usual ones first."""

LENGTH_UNITS, ANGLE_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}, {"rad": 1.0, "deg": np.pi / 180}

NEEDED, ALL_COLUMNS = {"a", "alpha", "d"}, {*COLUMNS, "offset"}

LABEL = re.compile(r"\b(joint|link|axis|j|l|link_?joint|row|frame)[\s_-]?(\d+)\b", re.IGNORECASE)

REPLACEMENTS = [
    (r"\x1b\[[0-9;]*m|[\u200b\u200e\ufeff]|(?<= {99}) +", ""),
    (r"<\w+\s([^<>]*\balpha\s*=[^<>]*?)/?>", r"{\1}"), (r"</t[dh]>\s*<t[dh][^>]*>", " | "), (r"</?(?:tr|table|br|p)\b[^>]*>", "\n"),
    (r"<su[bp]>(.*?)</su[bp]>", r"_\1"), (r"<[a-zA-Z/][^>]{0,200}>", " "),
    (r"\\(?:begin|end)\{\w+\*?\}(?:\{[^}]*\})?|\\(?:hline|(?:top|mid|bottom)rule|cline\{[^}]*\})", "\n"),
    (r"\\ang\{([^{}]*)\}", r"\1°"), (r"\\milli\\met(?:re|er)", "mm"), (r"\\met(?:re|er)\b", "m"),
    (r"\\(?:SI|qty)\{([^{}]*)\}\{([^{}]*)\}", r"\1 \2"), (r"\\(?:si|unit)\{([^{}]*)\}", r"\1"),
    (r"\\(?:text|mathrm|textbf|mathbf|mathit)\{([^{}]*)\}", r"\1"), (r"\^\{?\s*\\circ\s*\}?|\\degree", "°"),
    (r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"(\1)/(\2)"), (r"\\\\(?:\[[^]]*\])?", "\n"), (r"\\,|\$", ""),
    (r"(?m)^\s*(?:\{\|.*|\|[-}]\s*)$", ""), (r"!!|\|\|", "|"), (r"(?m)^\s*!", "|"),  # of a wiki
    (r"\\(?:cdot|times)\b", "*"), (r"\\(alpha|theta|psi|pi)(?![a-zA-Z])", r"\1"), ("&", " | "), (r"\(\*|\*\)", "\n"),
    ("⍺", "alpha"), ("ⱼ", "_j"), ("ₙ", "_n"), ("’", "'"), ("\xa0", " "), ("½", "1/2"), ("[┃│║]", "|"), ("[\u2500-\u257f]+", ""),
    (r"\b(?:M_PI|PI|FRAC_PI)_([24])\b", r"pi/\1"), (r"\b(?:M_PI|(?:np|numpy|math|Math|sp|sympy)\.(?:pi|PI)|PI|Pi)\b(?:\(\))?", "pi"),
    (r"\b(?:(?:np|numpy|math)\.)?(?:deg2rad|radians|RADIANS)\(([^()]*)\)", r"\1°"),
    (r"(?m)(^|[\t;,|])[ ]*=", r"\1"),  # of a cell in a spreadsheet
    (r"\b((?:theta|q|d)_?\{?\d+\}?)\*(?![\w(.]|-1\b)", r"\1"),  # the sign of a variable
    (r"(?<=\d)f\b|(?<=\d\.)f\b", ""), (r"(?<=\d)\s*\*\s*([mc]m)(?:_?(?:2|to)_?m)?\b", r" \1"),  # 0.1f and 145 * mm2m of code
    (r"\((?:float|double|real_t)\)", ""), (r"\b\w+[(\[](\d+)[)\]]\.(\w+)\s*=(?!=)", r"\2\1 ="),  # L(1).a = 0.1
    (r"\b([a-zA-Z]\w*)\[(\d+)\](?!\s*[\[.])", r"\1\2"), (r"(?<=[\[,])\s*\[([^\[\],]*\d[^\[\],]*)\](?=\s*[,\]])", r"\1"),
    (r"(?m)^[ \t]*-[ \t]+\[([^\[\]\n]*)\]", r"\1"), (r"(?m)^[ \t]*\(?\d+\)[ \t]+(?=[-\w.])", ""),  # of YAML, and 1) of lists
    (r"(?mi)^.*?(?<![:.\w])(?:\w+_)?dh(?:_\w+)?\(((?:[^=,\n]{0,60},){3}[^=,\n]{0,60})\)\W*$", r"\1"),  # T = T @ dh(q1, 0.3, 0, pi/2)
    (r"\bth_?(\d+)\b", r"theta\1"), (r"(?m)^[ \t]*#define\s+(\w+)\s+", r"\1 = "), (r"\b\w+\s*<<\s*(?=\S)", ""),
]  # fmt: skip
"""What terminals, HTML, LaTeX and code write for signs and separators, and what a keyboard has for them."""

CALL = re.compile(
    r"\b(?!\w*(?:Robot|SerialLink))((?:Frame\W+)?\w*(?:Revolute|Prismatic|Link|DH)\w*)\s*\(((?:[^()]|\([^()]*\))*)\)"
)

PAIR = re.compile(
    r"(?:\b([a-zA-Z]\w*)\s*[:=]|['\"](\w+)['\"]\s*(?:[:=]|,(?=\s*[^\s'\"])))[ \t]*['\"]?([^,=\[\]{}'\"\n;]+?)"
    r"(?=\s*(?:[,\[\]{}'\"\n;]|$)|\s+[a-zA-Z]\w*\s*[:=])"
)

LIST = re.compile(
    r"['\"]?\b([a-zA-Z][\w.]*)['\"]?(?:\[?\d*\])?\s*[=:]\s*(?:\w+\.\w+\()?(?:[\[{]([^\[\]{}]*)[\]}]|\(([^\[\](){}]*)\))"
)

TUPLE = re.compile(r"(?m)^[ \t]*(\w+(?:[ \t]*,[ \t]*\w+)+)[ \t]*=[ \t]*(\S.*)$")
"""Values for several names in a line: a1, a2 = 0.4, 0.3, or a, d = [...], [...]."""

END = re.compile(r"^[ \t]*(base|tool)\s*=\s*(\[\[.*)$", re.MULTILINE)
"""A base or a tool as `print(table)` writes it."""


class Assumption(NamedTuple):
    """What was assumed: a sentence; and if the numbers alone suggest it, the argument that says otherwise, and its values."""

    text: str
    argument: str = ""
    options: Sequence[str] = ()


class Rows(NamedTuple):
    """The rows that were read: a, alpha, d, theta (m, 4), a letter and a sign per row; convention and ends only as the text says."""

    numbers: Array
    joints: str
    signs: Sequence[float]
    convention: Literal["standard", "modified"] | None
    ends: Mapping[str, Any]
    assumed: Sequence[Assumption]
    suggests: bool = False


@dataclass
class _Grid:
    """Rows of cells by column name, or in an order that is not known, with their places in the text and the units of the columns.

    names    that have values
    suggests whether only the index i of a and alpha says that the convention is standard
    guesses  what a strict reader refuses
    """

    names: Mapping[str, float]
    rows: list[dict[str, str]] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    cells: list[list[str]] = field(default_factory=list)
    units: dict[str, str] = field(default_factory=dict)
    modified: bool | None = None
    suggests: bool = False
    assumed: list[Assumption] = field(default_factory=list)
    guesses: list[str] = field(default_factory=list)

    def assume(self, text: str, argument: str = "", options: Sequence[str] = ()) -> None:
        self.assumed.append(Assumption(text, argument, options))
        self.guesses.append(text)

    def is_entry(self, cell: str) -> bool:
        """Whether a cell can be an entry, with whatever values its names have."""
        found = {name for name in re.findall(r"\b[a-zA-Z]\d+", cell) if name[0] not in "qt"}
        try:
            _entry(cell, "theta", {**dict.fromkeys(found, 1.0), **self.names})
        except ValueError:
            return False
        return bool(cell.strip())


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
    ends: dict[str, Any] = {end: _matrix(matrix) for end, matrix in END.findall(text)}
    plain, told = _plain(END.sub("", text)), list[Assumption]()
    for end, place, angles in re.findall(r"\b(base|tool)\s*\|\s*t = ([-\d., ]+);\s*rpy/xyz = ([-\d.°, ]+)\|?", plain):
        if not re.search("[1-9]", angles):  # as the Robotics Toolbox prints them
            ends[end] = homogeneous(np.eye(3), [float(number) for number in place.split(",")])
            told.append(Assumption(f"The {end} was read as a translation by {format_vector(ends[end][:3, 3])} m."))
            plain = re.sub(rf"^.*\b{end}\s*\|\s*t = .*$", "", plain, flags=re.MULTILINE)
    names = _definitions(plain) | {_plain_name(name): value for name, value in lengths.items()}
    if not strict and "t1" not in names and "theta" in plain and re.search(r"\bt_?1\b", plain):
        plain = re.sub(r"\bt_?(\d+)\b", r"theta\1", plain)
        told.append(Assumption("t1, t2, ... were read as the joint variables."))
    readers = (_from_calls, _from_columns, _from_pairs, _from_lines)
    grid = next((g for reader in readers if (g := reader(plain, names)) and (g.rows or g.cells)), None)
    if grid is None:
        raise ValueError(
            "No table was found: no line has four numbers, and no list names a, alpha, d. Paste 'a alpha d theta', then one row in a line."
        )
    grid.assumed += told
    if not grid.rows:
        _name_columns(grid, order)
    if len(grid.rows) > MAX_ROWS:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; got {len(grid.rows)}.")
    entries = _evaluate(grid)
    letters, signs = _joints(grid, entries, joints)
    numbers = np.array([[row[column].value.real for column in COLUMNS] for row in entries])
    _scale(grid, entries, numbers, "length_unit", length_unit, strict)
    _scale(grid, entries, numbers, "angle_unit", angle_unit, strict)
    if strict and grid.guesses:
        raise ValueError(f"A DHTable takes only what its rows say; kl.read_table assumes: {grid.guesses[0]}")
    return Rows(numbers, letters, signs, _said_convention(plain, grid), ends, grid.assumed, grid.suggests)


def _matrix(text: str) -> Array:
    """Read [[1, 0, 0, 0], ...]; what is no pose is refused by the table."""
    numbers = [float(number) for number in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text)]
    return np.array(numbers).reshape((4, 4) if len(numbers) == 16 else -1)


def _plain(text: str) -> str:
    """Write a text as with a keyboard, a row in each line, also if each cell is in a line of its own, as copied from a PDF."""
    import html

    text = respelled(html.unescape(text))
    for pattern, plain in REPLACEMENTS:
        text = re.sub(pattern, plain, text)
    text = TUPLE.sub(_one_by_one, _plain_name(text))
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    heads = [parse_heading(line).name for line in lines[:8]]
    count = next((k for k, line in enumerate(lines[:8]) if re.fullmatch(NUMBER, line)), 0)
    if not {*heads[:count]} >= {*COLUMNS} or len(lines) % count or any("\t" in line or "|" in line for line in lines):
        return text
    return "\n".join("\t".join(lines[k : k + count]) for k in range(0, len(lines), count))


def _one_by_one(found: re.Match[str]) -> str:
    """Return values for several names as a line for each of them."""
    values = re.split(r",\s*(?![^\[\]{}()]*[\])}])", found[2].strip())
    names = re.split(r"\s*,\s*", found[1])
    return "\n".join(map(" = ".join, zip(names, values, strict=True))) if len(names) == len(values) else found[0]


def _column_in(name: str) -> str:
    """Return the column that a part of a name stands for, as in arm.dh_alpha_values; "" if there is none, or several."""
    whole = name.rpartition(".")[2]
    if "home" in whole:  # q_home_offset of a controller
        return ""
    found = {column for part in whole.split("_") if (column := _column(part) or _column(part.removesuffix("s")))}
    return _column(whole) or ("offset" if "offset" in found else found.pop() if len(found) == 1 else "")


def _column(name: str) -> str:
    """Return the column that a name stands for; "" if there is none."""
    found = parse_heading(name).name
    return found if found in COLUMN_NAMES.values() else ""


def _from_calls(text: str, names: Mapping[str, float]) -> _Grid | None:
    """Read calls, RevoluteDH(d=0.1, a=0.2) or Link([0 0.1 0.2 pi/2])."""
    grid, note, end = _Grid(names), "", 0
    for found in CALL.finditer(text):
        kind, inside = found[1], found[2]
        named = {column: value.strip() for n, quoted, value in PAIR.findall(inside) if (column := _column(n or quoted))}
        cells = re.sub(r"[\[\]{},]", " ", inside).split()
        if (named or not cells) and not re.match(r"\s*[\[{]", inside):
            row = {column: named.get(column, "0") for column in (*COLUMNS, "offset")}
        elif len(cells) >= 4 and all(map(grid.is_entry, cells[:4])):
            is_matlab = not re.search("Frame|Craig", kind)
            columns = ("theta", "d", "a", "alpha", "type", "offset") if is_matlab else COLUMNS
            row = {"offset": "0"} | dict(zip(columns, [*cells, "0", "0"], strict=False))
            note = f"{kind.rpartition(':')[2]}(...) was read as ({', '.join(columns[:4])})."
        else:
            continue
        before = text[max(end, text.rfind("\n", 0, found.start()) + 1) : found.start()]  # Joint(Joint::TransZ) of KDL
        end = found.end()
        is_link = kind.endswith("Link") and bool(named)  # of MATLAB: what is not given is the variable
        if re.search(r"revolute|\bRot", before + kind, re.IGNORECASE) or (is_link and "theta" not in named):
            row["type"] = "R"
        elif re.search(r"\bNone\b|\bFixed\b", before):
            row["type"] = "F"
        elif re.search(r"prismatic|\bTrans", before + kind, re.IGNORECASE) or (is_link and "d" not in named):
            row |= {"type": "P", "d": row["offset"] if row["offset"] != "0" else row["d"], "offset": "0"}
        if re.search(r"\bflip\s*[=:]\s*(?:[Tt]rue|1)", inside):
            row |= {"d": f"-q + {row['d']}"} if row.get("type") == "P" else {"theta": f"-q + {row['theta']}"}
        grid.rows.append(row)
        grid.places.append(f"Call {len(grid.rows)}, {found[0].strip():.60}")
        if re.search("mdh|craig|modif", kind, re.IGNORECASE):
            grid.modified = True
        elif kind.endswith("DH"):
            grid.modified = bool(grid.modified)
    if note:
        grid.assume(note)
    return _uniform(grid) if len(grid.rows) > 1 else None


def _from_pairs(text: str, names: Mapping[str, float]) -> _Grid | None:
    """Read names with values, row by row: dictionaries, items of YAML or TOML, attributes of XML, or lines."""
    grid, end = _Grid(names, rows=[{}]), 0
    for found in PAIR.finditer(text):
        if column := _column(found[1] or found[2]):
            if column in grid.rows[-1] or re.search("[)}]", text[end : found.start()]):
                grid.rows.append({})
            grid.rows[-1][column], end = found[3].strip(), found.end()
    grid.places = [f"Row {k + 1}" for k in range(len(grid.rows))]
    return _uniform(grid) if all({*row} >= NEEDED for row in grid.rows) else None


def _from_columns(text: str, names: Mapping[str, float]) -> _Grid | None:
    """Read lists by column, a = [0, -0.425, ...]; names with indices, d1 = 0.1; or lines that begin with the names of columns."""
    lists, grid = dict[str, list[str]](), _Grid(names)
    for name, square, round_ in LIST.findall(text):
        inside, column = square or round_, _column_in(name)
        separators = "[,;]" if re.search("[,;]", inside) else r"\s+"
        cells = [cell for cell in re.split(separators, inside) if cell.strip()]
        if cells and all(map(grid.is_entry, cells)):
            lists[column or name] = cells
    others = [name for name in lists if name not in ALL_COLUMNS]
    lists = {name: cells for name, cells in lists.items() if name not in others}
    if {*lists} >= NEEDED:
        used = " ".join(cell for cells in lists.values() for cell in cells)  # L0 of L
        unread = [name for name in others if not re.search(rf"\b{name}\d", used)]
        grid.assumed += [Assumption(f"The list {name} was not read.") for name in unread]
    else:
        found = _by_index(text, grid)
        if len(lists) > 1 and not found:
            missing = ", ".join(sorted(NEEDED - {*lists}))
            raise ValueError(f"The lists {', '.join(lists)} were found, {missing} was not. Paste a, alpha and d.")
        lists = found
    if not lists:
        lines = [cells for line in _lines(text) for cells in _splits(line.strip())[::-1]]
        columns = [line for line in lines if len(line) > 2 and all(map(grid.is_entry, line[1:]))]
        heads = [(parse_heading(line[0]), line[1:]) for line in columns]
        named = {head.name: cells for head, cells in heads if head.name in ALL_COLUMNS}
        if not {*named} >= NEEDED or len({len(named[column]) for column in NEEDED}) > 1:
            return None
        lists = {name: cells for name, cells in named.items() if len(cells) == len(named["a"])}
        grid.units = {head.name: head.unit for head, _ in heads if head.unit}
        grid.assume("Each row is a column of the text.")
    count = max(map(len, lists.values()))
    if short := [f"{column} ({len(cells)})" for column, cells in lists.items() if len(cells) != count]:
        raise ValueError(f"The lists must have the same length, {count}; {', '.join(short)} has another.")
    grid.rows = [{column: cells[k] for column, cells in lists.items()} for k in range(count)]
    grid.places = [f"Entry {k + 1} of the lists" for k in range(count)]
    return _uniform(grid)


def _by_index(text: str, grid: _Grid) -> dict[str, list[str]]:
    """Return the columns of names with indices, d1 = 0.1; {} if there are none."""
    found = dict[str, dict[int, str]]()
    for name, number, value in re.findall(r"\b([a-zA-Z]+(?:_[a-zA-Z]+)*)_?(\d{1,2})\s*[=:]\s*([^,;\n}]+)", text):
        if column := _column_in(name):
            found.setdefault(column, {})[int(number)] = value
    if not {*found} >= NEEDED:
        return {}
    if min(*found["a"], *found["alpha"]) < min(found["d"]) == 1:  # a_0 and alpha_0, but d_1
        grid.modified = True
        for column in ("a", "alpha"):
            found[column] = {k + 1: value for k, value in found[column].items()}
    indices = sorted({k for cells in found.values() for k in cells})
    if joints := [k for k in indices if k not in found.get("theta", indices)]:
        grid.assume(f"There is no theta{joints[0]}: each theta without a value was read as the joint variable.")
        found["theta"] |= {k: f"q{k}" for k in joints}
    return {column: [cells.get(k, "") for k in indices] for column, cells in found.items()}


def _from_lines(text: str, names: Mapping[str, float]) -> _Grid | None:
    """Read lines of cells, with a heading or without one."""
    grid, heads, is_after_gap, is_spreadsheet, widths = _Grid(names), list[str](), False, False, set[int]()
    for number, raw in enumerate(_lines(_in_lines(text)), start=1):
        line = _plain_line(raw)
        if not re.sub(r"[|\s:+=-]", "", line):
            is_after_gap = True
            continue
        # after a gap another table may follow
        splits = [cells for cells in _splits(line) if not (is_after_gap and widths) or len(cells) in widths]
        place = f"Line {number}, {raw.strip()!r:.80}"
        numbers = len(re.findall(rf"(?<![\w.])-?{NUMBER}", line))
        if is_spreadsheet and "\t" in line:  # a spreadsheet drops empty cells at the end
            splits[0] += [""] * (len(heads) - len(splits[0]))
        exact = sorted(splits, key=lambda cells: len(cells) != len(heads))
        read = [(cells, row) for cells in exact if (row := _row(cells, heads, grid))] if heads else []
        plain = [] if heads else [entries for cells in splits if len(entries := _entries(cells, grid)) >= 4]
        if not grid.rows and (named := _heading(raw, splits, heads, grid)):
            if grid.cells and all(len(cells) == len(named) for cells in grid.cells):  # a comment below the rows
                named = ["offset" if name == "" and "theta" not in named else name for name in named]
                grid.rows = [dict(zip(named, cells, strict=True)) for cells in grid.cells]
                heads = named
                continue
            if grid.cells:
                grid.assume(f"What stands above the heading in line {number} was not read.")
            heads, grid.cells, grid.places = named, [], []
            is_spreadsheet = "\t" in line
        elif read:
            grid.cells.append(read[0][0])
            grid.rows.append(read[0][1])
            grid.places.append(place)
            widths |= {len(cells) for cells, row in read if row == read[0][1]}
        elif plain:
            grid.cells.append(plain[0])
            grid.places.append(place)
        else:
            is_row = any(cells[0].rstrip(".") == str(len(grid.rows) + 1) for cells in splits) or (
                not is_after_gap and re.fullmatch(rf"[+-]?{NUMBER}", line)
            )
            is_table = bool(grid.rows or grid.cells)
            if is_table and not (grid.rows and is_row) and (is_after_gap or (numbers and ("=" in line or numbers < 3))):
                grid.assume(f"From line {number} on, {raw.strip()!r:.60}, no rows were read.")
                break
            if (grid.rows and is_row) or ((heads or grid.cells) and numbers >= 3):
                raise ValueError(
                    f"{place} cannot be read: it has another number of cells than the heading, or one is no number. Is one empty?"
                )
            if numbers >= 4 and not is_table:
                grid.assume(f"Line {number} was not read: {raw.strip()!r:.60}.")
        is_after_gap = False
    return _uniform(_with_all_columns(grid, heads)) if grid.rows else grid


def _with_all_columns(grid: _Grid, heads: list[str]) -> _Grid:
    """Refuse rows with a number whose column has no name."""
    count = min(sum(map(grid.is_entry, cells)) for cells in grid.cells) - _is_numbered(grid.cells)
    if (missing := sorted(NEEDED - {*heads})) and count >= len(COLUMNS):
        raise ValueError(
            f"The heading has no {' and no '.join(missing)}, but each row has {count} numbers. Name every column above the rows."
        )
    return grid


def _is_numbered(rows: list[list[str]]) -> bool:
    """Whether the first cells are the numbers of the rows, from 0 or from 1, perhaps with a word."""
    firsts = [re.sub(r"(?!q|theta)[A-Za-z]*(\d+)\.?", r"\1", cells[0]) for cells in rows]
    return any(firsts == [str(k + first) for k in range(len(rows))] for first in (0, 1))


def _in_lines(text: str) -> str:
    """Write each row of an array in a line, without brackets, and a comment only if it is a heading."""
    if re.search(r"[\[{(]\s*[\[{(]|=\s*[\[{]|[\[{][^\]}]{,999};", text):
        text = re.sub(r"[\]})]\s*,\s*['\"]?\w+['\"]?\s*[:=]\s*(?=[\[{(])", "\n", text)  # another one
        # its name
        text = re.sub(r"(?m)^(?:(?:[^\n#%/=]*=|[^\n#%/]*?[=(:])\s*(?=[\[{])|[^\n#%/{\[]*(?=\{\s*\{))", "", text)
        text = re.sub(r"[\[\]{}]", " ", re.sub(r"[\]})]\s*[,;]?\s*(?=[\[{(])|;", "\n", text))
    # The comment of a row may be a heading.
    text = re.sub(r"(?<=\S)[ \t]+(?:#|//|%)[ \t]*(?=.{,99}\balpha\b)", "\n# ", text)
    return re.sub(r"(?m)(?<=[\d,;i])[ \t]+(?:#|//|%)[ \t].*$", "", text)


def _lines(text: str) -> list[str]:
    """Return the lines of a text, which must not have more than a table can have."""
    if len(lines := text.splitlines()) > MAX_LINES:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; the text has {len(lines)} lines.")
    return lines


def _plain_line(raw: str) -> str:
    """Remove from a line what code and lists write around the cells, and the space before a unit."""
    line = LABEL.sub(r"\1\2", re.sub(r"^\s*(?:#+|%+|//+|/?\*+|>+)\s*", "", raw)).strip(" \r").rstrip(",")
    line = line.rstrip("); ") if line.count(")") > line.count("(") or line.find(";") == len(line) - 1 else line
    line = re.sub(r"^(\w+):\s+(?=.*,)", r"\1, ", line)
    line = re.sub(r"\s+in\s+(?=(?:mm?|cm|rad|deg\w*|°)(?!\w))", "/", line)
    return re.sub(r"\s+(?=[\[(](?:mm?|cm|rad|deg\w*|°|i|i-1)[\])])", "", line)


def _heading(line: str, splits: list[list[str]], before: list[str], grid: _Grid) -> list[str]:
    """Return the names of the columns if a line is a heading, in prose its longest run of names; keep units and convention."""
    run = [] if re.search(r"[|\t]", line) else _run_of_names(line)
    is_comment = bool(re.match(r"\s*(?:[#%*'\"]|//|/\*|--)", line))
    found = list[list[Heading]]()
    for cells in (*splits, run):
        names = _columns_of(heads := parse_headings(cells))
        if len({*names}) < max(3, len(names)):
            continue
        places = [k for k, head in enumerate(heads) if head.name in names]
        others = places[-1] - places[0] + 1 - len(names) - any(head.name == "type" for head in heads)
        # In a comment, and below another heading, no other word stands between the names.
        if others <= 0 or not (is_comment or before):
            found.append(heads)
    is_behind_words = is_comment and not any(heads[0].name in ALL_COLUMNS for heads in found[:-1])
    is_labelled = re.match(r"(?i)\W*(?:joint|link|axis|frame|row|[ijkn]|no|nr)\b", line)
    prefers_run = is_behind_words and len(run) > 3 and not is_labelled
    found.sort(key=lambda heads: (len(_columns_of(heads)), prefers_run and len(heads) == len(run)), reverse=True)
    if not found:
        return []
    heads = found[0]
    grid.units = {head.name: head.unit for head in heads if head.name in ALL_COLUMNS and head.unit}
    indices = {head.indices for head in heads if head.name in {"a", "alpha"} and head.indices}
    grid.modified, grid.suggests = "i-1" in indices if indices else None, indices == {"i"}
    return [head.name if head.name in {*ALL_COLUMNS, "type"} else "" for head in heads]


def _columns_of(heads: Sequence[Heading]) -> list[str]:
    return [head.name for head in heads if head.name in ALL_COLUMNS]


def _run_of_names(line: str) -> list[str]:
    """Return the longest run of names of columns in a line of prose, the last one of several."""
    run, longest = dict[str, str](), list[str]()
    for word in re.split(r"[\s,;|]+|/(?!\s*(?:mm?|cm|rad|deg|°))|(?<=[a-zA-Z])[\[({](?=\w+\s*,)", line):
        name = parse_heading(word).name
        if name in {*ALL_COLUMNS, "type"}:
            run.setdefault(name, word)
        elif re.search(r"\w", word) and word not in {"and", "then"}:
            run = {}
        longest = [*run.values()] if len(run) >= len(longest) else longest
    return longest if {*_columns_of(parse_headings(longest))} >= NEEDED else []


def _row(cells: list[str], heads: list[str], grid: _Grid) -> dict[str, str] | None:
    """Return the cells of a row by column name; the label of a row may have no heading. None if the line is no row."""
    label = cells[0] if not heads[0] else ""
    if len(cells) == len(heads) + 1 and (not grid.is_entry(cells[0]) or re.fullmatch(r"[A-Za-z]*\d+\.?", cells[0])):
        label, cells = cells[0], cells[1:]
    named = [k for k, name in enumerate(heads) if name]
    if len(cells) == named[-1] - named[0] + 1 < len(heads):  # without what has no name
        label, heads = "", heads[named[0] : named[-1] + 1]
    row = {name: cell for name, cell in zip(heads, cells, strict=False) if name}
    readable = sum(grid.is_entry(cell) or not cell.strip() for name, cell in row.items() if name != "type")
    if len(cells) != len(heads) or readable < 3:  # a single cell that cannot be read is told with its column
        return None
    return row | ({"label": label} if label else {})


def _entries(cells: list[str], grid: _Grid) -> list[str]:
    """Return the cells of a line that are entries, without the label of the row; none of a sentence with numbers."""
    entries = [cell for cell in cells if grid.is_entry(cell)]
    if 2 * len(entries) <= len([cell for cell in cells if cell]):
        return []
    return entries[len(entries) > 4 and bool(re.fullmatch(r"[A-Za-z]+\d+", entries[0])) :]


def _splits(line: str) -> list[list[str]]:
    """Split a line into cells at the separators that it may have, the surest first."""
    if separator := next((sign for sign in "|\t;" if sign in line), ""):
        cells = (line.strip().strip("|") if separator == "|" else line).split(separator)
        split = [[_cell(cell, decimal_comma=True) for cell in cells[:MAX_CELLS]]]
        others = [line.split(",")] * (line.count(",") >= len(COLUMNS) - 1) + [line.split()]
        return split + [[_cell(cell) for cell in cells[:MAX_CELLS]] for cells in others if separator == "\t"]
    found = []
    has_decimal_commas = re.fullmatch(r"(?:\S*\d,\d\S*|[^,\s]+)(?:\s+(?:\S*\d,\d\S*|[^,\s]+))*", line)
    if ("," in line and not has_decimal_commas) or (line.count(",") >= 3 and " " not in line):
        found.append([_cell(cell) for cell in line.split(",")[:MAX_CELLS]])
    spaced = re.sub(r"\s+([+*/])\s+|\s*([*/])\s*|(?<=[\w°)])\s+(-)\s+(?=\d|pi)", lambda f: f[1] or f[2] or f[3], line)
    # a space before a minus is enough after a number or a label: "1 -0.2", where "1 - 0.2" is a difference
    wide = re.sub(rf"(^\s*(?!theta|[qdt]_?\d)[A-Za-z]+\d+|{NUMBER})\s(?=-{NUMBER})", r"\1  ", spaced)
    splits = (re.split(pattern, wide)[:MAX_CELLS] for pattern in (r"\s{2,}", r"\s+"))
    return found + [[_cell(cell, decimal_comma=True) for cell in cells] for cells in splits]


def _cell(cell: str, decimal_comma: bool = False) -> str:
    cell = cell.strip().strip("\"'`").strip("*").strip()
    for bracket, other in ("()", ")("):
        if cell.count(bracket) > cell.count(other):
            cell = cell.strip(bracket).strip()
    cell = re.sub(r"^(?:a|d|l|alpha)_?\d+\s*=\s*", "", cell)
    return re.sub(r"(?<=\d),(?=\d)", ".", re.sub(r",(?=\d{3}\.)", "", cell)) if decimal_comma else cell


def _entry(cell: str, column: str, names: Mapping[str, float]) -> Entry:
    """Evaluate a cell: an empty one is 0, "theta" or "var" is a variable, and a length may have its unit, in metres then."""
    cell = re.sub(r"\(\s*var\w*\.?\s*\)|\*$|\b(?:rad|radians)$", "", _cell(cell)).strip()
    if cell in {"", "-", "/", "n.a.", "n/a", "None", "none"}:
        return Entry(0j)
    if re.fullmatch(r"(?:var\w*|joint\w*|theta[_{]*[ijkn]?\}*|q[_{]*[ijkn]?\}*|d_?[ijkn])", cell, re.IGNORECASE):
        cell = "q"
    if unit := re.fullmatch(rf"(-?\s*{NUMBER})\s*(mm|cm|m)", cell):
        return Entry(complex(float(unit[1].replace(" ", "")) * LENGTH_UNITS[unit[2]]), (), unit[2])
    return evaluate_entry(cell.replace("degrees", "°").replace("deg", "°").lstrip("+"), column, names)


def _uniform(grid: _Grid) -> _Grid:
    """Give all rows the columns that any of them has; a column that no row has is 0, and theta then is the variable."""
    columns = {name for row in grid.rows for name in row} & ALL_COLUMNS
    if missing := [name for name in ("a", "alpha", "d") if name not in columns]:
        grid.assume(f"There is no column {' and '.join(missing)}: it was read as 0.")
    if not columns & {"theta", "offset"}:
        grid.assume("There is no column theta: each theta was read as the joint variable.")
    filled = {name: "" if name in columns else "0" for name in (*COLUMNS, *columns)}
    grid.rows = [filled | row for row in grid.rows]
    labels = [row.get("label", "").rstrip(".") for row in grid.rows]
    numbers = [int(label) for label in labels if re.fullmatch(r"\d{1,2}", label, re.ASCII)]
    if len(numbers) == len(labels) and numbers != [*range(numbers[0], numbers[0] + len(numbers))]:
        grid.assume(f"The rows have the numbers {', '.join(map(str, numbers))}: they were read as they stand.")
    return grid


def _name_columns(grid: _Grid, order: str) -> None:
    """Name the columns of cells without a heading: as `order` says, or in the usual order that suits the numbers best."""
    if min(map(len, grid.cells)) > 4 and _is_numbered(grid.cells):
        grid.cells = [row[1:] for row in grid.cells]
    if order and sorted(order.split()) not in [sorted(known.split()) for known in ORDERS]:
        raise ValueError(f'order must name the columns, such as "theta d a alpha"; got {order!r:.60}.')
    suits = []
    for texts in zip(*(row[:4] for row in grid.cells), strict=True):
        text, known = " ".join(texts), dict.fromkeys(re.findall(r"[a-z]\w*", " ".join(texts)), 1.0) | {**grid.names}
        column = np.array([_entry(cell, "theta", known).value.real for cell in texts])
        has_right_angles = np.isin(np.abs(column).round(2), (1.57, 90, 180, 3.14, 45)).any()
        is_angle, is_variable = bool(re.search("pi|°", text) or has_right_angles), bool(re.search(r"\bq|theta", text))
        length = 2 * is_angle - bool((column % 1 != 0).any() and not is_angle)
        suits.append({"a": -length, "alpha": length, "d": -length, "theta": length + 4 * is_variable})
    best = order or max(ORDERS, key=lambda names: sum(suits[k].get(n, 0) for k, n in enumerate(names.split())))
    names = best.replace("offset", "theta").split()
    grid.rows = [dict(zip(names, row, strict=False)) for row in grid.cells]
    if not order:
        words = f"The columns have no heading: they were read as {', '.join(names)}."
        grid.assume(words, "order", [best, *(known for known in ORDERS if known != best)][:6])


def _evaluate(grid: _Grid) -> list[dict[str, Entry]]:
    """Evaluate all cells, and add the offset of theta to it; the place of a cell that cannot be read is told."""
    entries, empty = [], 0
    for row, place in zip(grid.rows, grid.places, strict=False):
        read = dict[str, Entry]()
        for column in [name for name in row if name in ALL_COLUMNS]:
            empty += not row[column].strip()
            try:
                read[column] = _entry(row[column], "theta" if column == "offset" else column, grid.names)
            except ValueError as error:
                raise ValueError(f"{place}, {column}: {error}") from error
            if column in {"a", "d"} and read[column].unit == "°":
                raise ValueError(f"{place}, {column}: {row[column]!r} is no length. Are two columns swapped?")
        offset, theta = read.pop("offset", Entry(0j)), read["theta"]
        variables, unit = [*theta.variables, *offset.variables], theta.unit or offset.unit
        entries.append(read | {"theta": Entry(theta.value + offset.value, variables, unit)})
    if empty and not any("There is no column" in each.text for each in grid.assumed):
        grid.assume(f"{empty} empty cells were read as 0." if empty > 1 else "An empty cell was read as 0.")
    return entries


def _joints(grid: _Grid, entries: list[dict[str, Entry]], given: str) -> tuple[str, list[float]]:
    """Find the letter and the sign of the joint of each row: from its variable, a column of types, or because all rows have one.

    If no row has a variable, the signs are [].
    """
    letters, signs, variables = "", list[float](), list[str]()
    for row, cells, place in zip(entries, grid.rows, grid.places, strict=False):
        letter, sign, variable = joint_of_row(row, place)
        kind = {"r": "R", "0": "R", "p": "P", "1": "P", "f": "F"}.get(cells.get("type", "").strip().lower()[:1], "?")
        letters, signs = letters + (letter if variable else kind), [*signs, sign]
        variables += [variable] if variable else []
    if given:
        return given, signs if variables else []
    numbers = [int(number) for name in variables if (number := re.sub(r"\D", "", name))]
    if numbers and numbers != [*range(1, len(variables) + 1)]:
        grid.assume(f"The variables are {', '.join(variables)}, not 1, 2, ...: each is the joint of its row.")
    if "?" in letters and set(letters) <= {"?", "P"}:
        others = "each row" if "P" not in letters else "each row that is not prismatic"
        words = f"theta has no variable: {others} is a revolute joint, with the number as its offset."
        tools = re.compile(r"\b(flange|tool|hand|tcp|end.?effector|ee|fixed|gripper|base)\b", re.IGNORECASE)
        fixed = [k for k, row in enumerate(grid.rows) if tools.search(row.get("label", "")) and k]
        letters = "".join("F" if k in fixed else letter.replace("?", "R") for k, letter in enumerate(letters))
        if fixed:
            words = f"{words[:-1]}; row {fixed[0] + 1} is fixed, as its name says."
        if not any("There is no column theta" in each.text for each in grid.assumed):
            grid.assume(words)
    elif "?" in letters:
        rows = [str(k + 1) for k, letter in enumerate(letters) if letter == "?"]
        words = "Row {} has no variable: it was" if len(rows) == 1 else "Rows {} have no variable: they were"
        grid.assumed.append(Assumption(f"{words.format(', '.join(rows))} read as fixed, without a joint."))
    return letters.replace("?", "F"), signs


def _scale(  # noqa: PLR0917
    grid: _Grid, entries: list[dict[str, Entry]], numbers: Array, argument: str, given: str, strict: bool
) -> None:
    """Convert the lengths or the angles to metres or radians: by their own unit, the argument, the heading, or their sizes."""
    is_length = argument == "length_unit"
    units, columns, basic = (LENGTH_UNITS, (0, 2), "m") if is_length else (ANGLE_UNITS, (1, 3), "rad")
    if given and given not in units:
        raise ValueError(f"{argument} must be one of {', '.join(units)}; got {given!r:.60}.")
    plain = [(i, k) for i, row in enumerate(entries) for k in columns if not row[COLUMNS[k]].unit and numbers[i, k]]
    said = {unit for k in columns if (unit := grid.units.get(COLUMNS[k], "")) in units}
    unit = given or (said.pop() if len(said) == 1 and not strict else basic if strict else "")
    if not unit and plain:
        sizes = [abs(float(numbers[place])) for place in plain]
        is_large = max(sizes) > (MIN_LENGTH_MM if is_length else 2 * np.pi + 0.01)
        unit = (("m", "mm") if is_length else ("rad", "deg"))[is_large]
        is_sure = not is_length and any(abs(size - np.pi / 2) < 1e-2 for size in sizes)
        kind = "lengths" if is_length else "angles"
        what = f"The text does not say the unit of its {kind}: {unit} was taken, because"
        options = (unit, *(other for other in units if other != unit))
        grid.assume(f"{what} the largest is {max(sizes):.6g}.", *(() if is_sure else (argument, options)))
    for i, k in plain:
        own = grid.units.get(COLUMNS[k], "")
        numbers[i, k] *= units[given or (own if own in units else unit)]


def _said_convention(text: str, grid: _Grid) -> Literal["standard", "modified"] | None:
    """The convention that the text names, in words, in the indices of its headings, or in the names of its calls."""
    modified = re.search(r"\b(modified|craig|mdh|proximal)\b", text, re.IGNORECASE)
    standard = re.search(r"\b(standard|classic|distal)\b", text, re.IGNORECASE)
    if grid.modified is not None:
        grid.suggests = grid.suggests and not standard
        return "modified" if grid.modified else "standard"
    grid.suggests = False
    return None if bool(modified) == bool(standard) else "modified" if modified else "standard"


def _definitions(text: str) -> dict[str, float]:
    """Read the values of names, l1 = 0.3 or d1 = 89.2 mm, that stand beside a table."""
    found = re.findall(rf"\b([a-zA-Z]\w*)\s*[=:]\s*(-?{NUMBER})\s*(mm|cm|m)?\b", re.sub(r"[{}]", "", text))
    values = {name: float(value) * LENGTH_UNITS[unit or "m"] for name, value, unit in found if name not in COLUMN_NAMES}
    for name, *inside in LIST.findall(text):  # L = [0.2, 0.3], of which L0 was L[0]
        numbers = re.split(r"[,\s]+", "".join(inside).strip())
        if all(re.fullmatch(rf"-?{NUMBER}", number) for number in numbers):
            values |= {f"{name}{k}": float(number) for k, number in enumerate(numbers)}
    return values


def _plain_name(text: str) -> str:
    """Write names with an index without the underscore and the braces: l_{1} and l_1 as l1."""
    return re.sub(r"\b([a-zA-Z]+)_?(?:\{(\d+)\}|(\d+))", r"\1\2\3", text)
