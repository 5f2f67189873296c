r"""Read the rows of a table from names with values: calls such as RevoluteDH(a=0.4), dictionaries, lists by column, and d1 = 0.3."""

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress

from kinlib.dh.parsing import COLUMNS, NUMBER, Entry, read_entry
from kinlib.dh.reading.columns import ALL_COLUMNS, COLUMN_NAMES, NEEDED, Grid, column_of, parse_heading
from kinlib.dh.reading.lines import lines_of, split_line

CALL = re.compile(
    r"\b(?!\w*(?:Robot|SerialLink|OriginLink))((?:Frame\W+)?\w*(?:Revolute|Prismatic|Link|DH)\w*)\s*\(((?:[^()]|\([^()]*\))*)\)"
)

PAIR = re.compile(
    r"(?:\b([a-zA-Z]\w*)\s*[:=]|['\"](\w+)['\"]\s*(?:[:=]|,(?=\s*[^\s'\"])))[ \t]*['\"]?([^,=\[\]{}'\"\n;]+?)"
    r"(?=\s*(?:[,\[\]{}'\"\n;]|$)|\s+[a-zA-Z]\w*\s*[:=])"
)

LIST = re.compile(
    r"['\"]?\b([a-zA-Z][\w.]*)['\"]?(?:\[?\d*\])?\s*[=:]\s*(?:\w+\.\w+\()?(?:[\[{]([^\[\]{}]*)[\]}]|\(([^\[\](){}]*)\))"
)

INDEXED = re.compile(r"\b([a-zA-Z]+(?:_[a-zA-Z]+)*)_?(\d{1,2})\s*[=:](?![ \t]*[\[{])[ \t]*([^,;\n}]*)")

STATEMENT = re.compile(r"(?m)(?:^|;)[ \t]*([a-zA-Z]\w*)[ \t]*=[ \t]*([^=;#%\n]{1,200}?)[ \t]*(?=[;#%]|//|$)")
"""A name whose value is computed, deg = pi/180."""

JOINT_TYPES = {"R": r"(?i)revolute|\bRot", "F": r"\b(?:None|Fixed)\b", "P": r"(?i)prismatic|\bTrans"}
"""How the name of a call, or what stands before it, says the type of a joint."""


def definitions(text: str) -> dict[str, Entry]:
    """Read the values of names, l1 = 0.3 or d1 = 89.2 mm, that a text has; and of L = [0.2, 0.3], L0 and L1.

    >>> definitions("with d1 = 89.2 mm")
    {'d1': Entry(value=(0.0892+0j), variables=[], unit='m')}
    """
    plain = re.sub(r"[{}]", "", text)
    found = re.findall(rf"\b([a-zA-Z]\w*)\s*[=:]\s*(-?{NUMBER}(?:\s*(?:mm|cm|m)\b)?)(?![\d.]|\s*[-+*/])", plain)
    found += STATEMENT.findall(text)
    for line in LIST.finditer(text):
        name, *cells = _as_line(line).strip().split("\t")
        found += [(f"{name}{k}", cell) for k, cell in enumerate(cells)]
    known = dict[str, Entry]()
    for name, value in found:
        with suppress(ValueError):
            if name not in COLUMN_NAMES and not (entry := read_entry(value, "", known)).variables:
                known[name] = entry
    return known


def _as_line(found: re.Match[str]) -> str:
    """Return a list as a line of cells that begins with its name."""
    inside = found[2] or found[3] or ""
    cells = re.split("[,;]" if re.search("[,;]", inside) else r"\s+", inside)
    return "\n" + "\t".join([found[1], *(cell.strip() for cell in cells if cell.strip())]) + "\n"


def _pairs(text: str) -> Iterator[tuple[str, str, re.Match[str]]]:
    """Find the names of columns that have a value, and the value."""
    for found in PAIR.finditer(text):
        name, value = found[1] or found[2], found[3].strip()
        if value in {"d", "theta"} and column_of(name) == "theta" != name:  # "variable": "d"
            yield "type", "P" if value == "d" else "R", found
        elif column := column_of(name):
            yield column, value, found


def read_calls(text: str, names: Mapping[str, Entry]) -> Grid | None:
    """Read calls, RevoluteDH(d=0.1, a=0.2) or Link([0 0.1 0.2 pi/2]); what is not given is 0."""
    grid, end = Grid(names), 0
    later = {int(number): value for name, number, value in INDEXED.findall(text) if column_of(name) == "offset"}
    for found in CALL.finditer(text):
        kind, inside = found.groups()
        cells = re.sub(r"'[^']*'|[\[\]{},]", " ", inside).split()
        row = {column: value for column, value, _ in _pairs(inside)}
        if not row and len(cells) >= 4 and all(map(grid.is_entry, cells[:4])):
            order = COLUMNS if re.search("Frame|Craig", kind) else ("theta", "d", "a", "alpha", "type", "offset")
            row = dict(zip(order, [*cells, "0", "0"], strict=False))
            if not grid.assumed:
                grid.assume(f"{kind.rpartition(':')[2]}(...) was read as ({', '.join(order[:4])}).")
        elif cells and not row:
            continue
        before = text[max(end, text.rfind("\n", 0, found.start()) + 1) : found.start()]  # Joint(Joint::TransZ) of KDL
        types = [letter for letter, pattern in JOINT_TYPES.items() if re.search(pattern, f"{before} {kind}")]
        if re.match(r"\s*['\"]", inside):  # of MATLAB: what is not given is the variable
            types += ["R" if "theta" not in row else "P" if "d" not in row else "F"]
        row = dict.fromkeys((*COLUMNS, "offset"), "0") | row | {"type": [*types, row.get("type", "")][0]}
        if row["offset"] == "0":  # L(2).offset = pi/2 below the calls
            row["offset"] = later.get(len(grid.rows) + 1, "0")
        if row["type"] == "P":
            row |= {"d": f"{row['d']} + {row['offset']}", "offset": "0"}
        if re.search(r"\bflip\s*[=:]\s*(?:[Tt]rue|1)", inside):
            column = "d" if row["type"] == "P" else "theta"
            row[column] = f"-q + {row[column]}"
        grid.rows.append(row)
        grid.places.append(f"Call {len(grid.rows)}, {found[0].strip():.60}")
        end = found.end()
    return grid if len(grid.rows) > 1 else None


def read_columns(text: str, names: Mapping[str, Entry]) -> Grid | None:
    """Read names with indices, d1 = 0.1; lists by column, a = [0, -0.425]; or lines that begin with the names of columns."""
    grid, as_lines = Grid(names), LIST.sub(_as_line, text)
    lists, others, columns = [found[1] for found in LIST.finditer(text)], list[str](), _by_index(text, grid)
    if not lists and not columns:
        grid.assume("Each row is a column of the text.")
    for line in [] if columns else lines_of(as_lines):
        for name, *cells in split_line(line.strip())[::-1]:
            column = column_of(name)
            is_list = name in lists or (column in ALL_COLUMNS and len(cells) > 1)
            if not is_list or not all(not cell or grid.is_entry(cell) for cell in cells):
                continue
            if column in ALL_COLUMNS:
                columns[column], grid.units[column] = cells, parse_heading(name).unit
            else:
                others.append(name)
    has_all, counts = {*columns} >= NEEDED, {name: len(cells) for name, cells in columns.items()}
    if not has_all and not (lists and len(NEEDED & {*columns}) > 1):
        return None
    if not has_all or len({*counts.values()}) > 1:
        found = ", ".join(f"{name} ({count})" for name, count in counts.items())
        raise ValueError(f"a, alpha and d must be lists of the same length; got {found}. Paste all of them.")
    used = " ".join(cell for cells in columns.values() for cell in cells)
    for name in others:
        if not re.search(rf"\b{name}\d", used):  # L0 is of the list L
            grid.assume(f"The list {name} was not read.")
    grid.rows = [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]
    grid.places = [f"Entry {k + 1} of the lists" for k in range(len(grid.rows))]
    return grid


def _by_index(text: str, grid: Grid) -> dict[str, list[str]]:
    """Return the columns of names with indices, d1 = 0.1; {} if there are none."""
    found = dict[str, dict[int, str]]()
    for name, number, value in INDEXED.findall(text):
        if column := column_of(name):
            found.setdefault(column, {})[int(number)] = value
    if not {*found} >= NEEDED:
        return {}
    if min(*found["a"], *found["alpha"]) < min(found["d"]) == 1:  # a_0 and alpha_0, but d_1
        grid.subscript = "i-1"
        for column in ("a", "alpha"):
            found[column] = {k + 1: value for k, value in found[column].items()}
    indices = sorted({k for cells in found.values() for k in cells})
    if joints := [k for k in indices if k not in found.get("theta", indices)]:
        grid.assume(f"There is no theta{joints[0]}: each theta without a value was read as the joint variable.")
        found["theta"] |= {k: f"q{k}" for k in joints}
    return {column: [cells.get(k, "") for k in indices] for column, cells in found.items()}


def read_dictionaries(text: str, names: Mapping[str, Entry]) -> Grid | None:
    """Read names with values, row by row: dictionaries, items of YAML or TOML, attributes of XML, or lines."""
    # Rows of cells are for another reader, and alpha = dh[:, 0] takes a column.
    text = re.sub(r"(?m)^.*\|.*$|=\s*\w+[\[(][^\])\n]{,40},.*", "", text)
    grid, end, pairs = Grid(names, rows=[{}]), 0, [*_pairs(text)]
    # beside d, d4 = 0.3 is the value of a name
    bare = [pair for pair in pairs if not re.match(r"\w*\d\s*[:=]", pair[2][0])]
    for column, value, found in bare if {column for column, _, _ in bare} >= NEEDED else pairs:
        if grid.rows[-1] and (column in grid.rows[-1] or re.search("[)}]", text[end : found.start()])):
            grid.rows.append({})
        grid.rows[-1][column], end = value, found.end()
    grid.places = [f"Row {k + 1}" for k in range(len(grid.rows))]
    return grid if all({*row} >= NEEDED for row in grid.rows) else None
