r"""Read the rows of a table from names with values: calls such as RevoluteDH(a=0.4), dictionaries, and lists by column."""

import re
from collections.abc import Mapping
from contextlib import suppress

from kinlib.dh.parsing import ALL_COLUMNS, COLUMN_NAMES, COLUMNS, NEEDED, Entry, Grid, parse_heading, read_entry

DEFINITION = re.compile(
    r"(?m)\b([a-zA-Z]\w*)[ \t]*[=:][ \t]*([^=:,;&|\n#%]{1,60}?)[ \t]*(?=[,;&|\n#%)}]|//|\band\b|\.?$)"
)
"""A name whose value is given or computed: l1 = 0.3, d1 = 89.2 mm, deg = pi/180."""

INSIDE = r"((?:[^(){}]|(?<!DH)(?<!Link)(?<!dict)\([^(){}=:]*\))*)"
GROUP = re.compile(rf"([\w.:]*)[ \t]*(?:\({INSIDE}\)|\{{{INSIDE}\}})")
"""The name of a call, or nothing, and what is in its parentheses or braces."""

LINK = re.compile(r"(?!.*(?:Robot|SerialLink|OriginLink|DHTable|::))(?:.*\W)?\w*(?:Revolute|Prismatic|Link|DH)\w*")

LIST = re.compile(r"['\"]?\b([a-zA-Z][\w.]*)['\"]?(?:\[\d*\])?[ \t]*[=:]\s*(?:\w+\.\w+\()?[\[{]([^\[\]{}]*)[\]}]")
"""A column as a list, a = [0, 0.4]."""

INDEXED = re.compile(r"\b([a-zA-Z]+(?:_[a-zA-Z]+)*)_?(\d{1,2})['\"]?\s*[=:](?![ \t]*[\[{])[ \t]*([^,;\n}]*)")
"""An entry with the number of its row, d1 = 0.3."""


def definitions(text: str) -> dict[str, Entry]:
    """Read the values of names, l1 = 0.3 or d1 = 89.2 mm, that a text has; a name with two values has none.

    >>> definitions("with d1 = 89.2 mm")
    {'d1': Entry(value=(0.0892+0j), variables=[], unit='m')}
    """
    known, twice = dict[str, Entry](), set[str]()
    for name, value in DEFINITION.findall(re.sub(r"[{}]", "", text)):
        with suppress(ValueError):
            entry = read_entry(value, "", known)
            if name not in COLUMN_NAMES and not re.fullmatch(r"(?:q|theta|alpha)\d*", name) and not entry.variables:
                twice |= {name} if known.setdefault(name, entry) != entry else set()
    return {name: entry for name, entry in known.items() if name not in twice}


def read_records(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read calls, RevoluteDH(d=0.1, a=0.2) or Link([0 0.1 0.2 pi/2]), dictionaries, or lines such as a=0.2 alpha=90° d=0."""
    grid = Grid(names)
    groups = [(found[0].strip(), found[1], found[2] or found[3] or "") for found in GROUP.finditer(text)]
    calls = [group for group in groups if LINK.fullmatch(group[1])]
    if len(calls) < sum(bool(LINK.fullmatch(name)) for name in re.findall(r"([\w.:]+)[ \t]*\(", text)):
        raise ValueError("A call such as RevoluteDH(a=0.4) must have numbers, and no other calls, in its parentheses.")
    lines = [(line, "", line) for line in text.splitlines()]
    named = ([each for each in some if {name for name, _ in _pairs(each[2])} >= NEEDED] for some in (groups, lines))
    records = calls or next(filter(None, named), [])
    if len(records) < 2:
        return grid
    for source, kind, inside in records:
        place, pairs = f"Row {len(grid.rows) + 1}, {source.strip():.80}", _pairs(inside)
        if len({column for column, _ in pairs} - {""}) < len(pairs):
            raise ValueError(f"{place}: each name must have one value, with a decimal point. Write each row in a line.")
        grid.rows.append(_link(kind, inside, dict(pairs), grid, place) if calls else dict(pairs))
        grid.places.append(place)
        text = text.replace(source, "", 1)
    for line in text.splitlines():
        values = re.findall(r"\b([a-zA-Z]\w*)['\"]?\s*[:=](?!=)", line)
        if any(parse_heading(name).column and name not in names for name in values):
            grid.assume(f"{line.strip()!r:.80} was not read.")
    return grid


def _pairs(inside: str) -> list[tuple[str, str]]:
    """Return the columns that are named and their values, no lists; a number without a name has the column "", as in d=0,3."""
    named = re.sub(r"['\"](\w+)['\"]\s*(?:[:=]|,(?!\s*(?:['\"]|\w+\s*=)))\s*", r"\1=", inside)
    named = re.sub(r"\w+\s*[:=]\s*\[[^\[\]]*[\s,;][^\[\]]*\]", "", named)
    pairs, is_value = list[tuple[str, str]](), False
    for item in re.split(r"[,;\n]", re.sub(r"\s+(?=[a-zA-Z]\w*\s*[=:])", ",", named)):
        found = re.fullmatch(r"\s*([a-zA-Z]\w*)\s*[=:]\s*(.*?)\s*", item)
        if found and (column := parse_heading(found[1]).column):
            pairs.append((column, found[2]))
        elif is_value and re.fullmatch(r"\s*\d+\s*", item):
            pairs.append(("", item))
        is_value = bool(found)
    return pairs


def _link(kind: str, inside: str, row: dict[str, str], grid: Grid, place: str) -> dict[str, str]:
    """Return the cells of a call of a toolbox, in which what is not given is 0, with the type of its joint."""
    cells, order = re.sub(r"'[^']*'|[\[\]{},]", " ", inside).split(), ("theta", "d", "a", "alpha", "type", "offset")
    if not row and cells and "=" not in inside:
        if not 4 <= len(cells) <= len(order) or not all(map(grid.is_entry, cells)):
            raise ValueError(f"{place} cannot be read. Write its values with names, as in RevoluteDH(a=0.4).")
        row = dict(zip(order, cells, strict=False))
        if not grid.assumed:
            grid.assume(f"{kind}(...) was read as ({', '.join(order[:4])}).")
    # Of MATLAB's Link('d', 0.1), what is not given is the variable.
    is_variable = "d" if re.match(r"\s*['\"]", inside) and "theta" in row and "d" not in row else "theta"
    row = {"type": "PR"["Prismatic" not in kind and is_variable == "theta"]} | row
    if row.pop("flip", "").lower() in {"true", "1"}:
        moving = "theta" if row["type"] in {"R", "0"} else "d"
        row[moving] = f"-q + {row.get(moving, '0')}"
    return dict.fromkeys((*COLUMNS, "offset"), "0") | row


def read_numbered(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read entries with the numbers of their rows, d1 = 0.3 or L(1).d = 0.3."""
    grid, found = Grid(names), dict[str, dict[int, str]]()
    for name, number, value in INDEXED.findall(re.sub(r"\b\w+\((\d+)\)\.(\w+)", r"\2\1", text)):
        if (column := parse_heading(name).column) in ALL_COLUMNS:
            found.setdefault(column, {})[int(number)] = value.strip()
    if not {*found} >= NEEDED:
        return grid
    if min(*found["a"], *found["alpha"]) < min(found["d"]) == 1:  # a_0 and alpha_0, but d_1
        grid.convention = "modified"
        found |= {name: {k + 1: value for k, value in found[name].items()} for name in ("a", "alpha")}
    indices = sorted({k for cells in found.values() for k in cells})
    if joints := [k for k in indices if k not in found.get("theta", indices)]:
        grid.assume(f"There is no theta{joints[0]}: each theta without a value was read as the joint variable.")
        found["theta"] |= {k: f"q{k}" for k in joints}
    grid.rows = [{column: cells.get(k, "") for column, cells in found.items()} for k in indices]
    return grid


def read_lists(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read lists by column, a = [0, -0.425]."""
    grid, columns = Grid(names), dict[str, list[str]]()
    for name, inside in LIST.findall(text):
        heading, sign = parse_heading(name), "[,;]" if re.search("[,;]", inside) else r"\s+"
        cells = [cell.strip() for cell in re.split(sign, inside.strip().rstrip(",;"))]
        if heading.column in ALL_COLUMNS and all(map(grid.is_entry, cells)):
            columns[heading.column], grid.units[heading.column] = cells, heading.unit
        else:
            grid.assume(f"The list {name} was not read.")
    if len(NEEDED & {*columns}) < 2:
        return Grid(names)
    if not {*columns} >= NEEDED or len({len(cells) for cells in columns.values()}) > 1:
        found = ", ".join(f"{name} ({len(cells)})" for name, cells in columns.items())
        raise ValueError(f"a, alpha and d must be lists of the same length; got {found}. Paste all of them.")
    grid.rows = [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]
    return grid
