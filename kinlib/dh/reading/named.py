r"""Read the rows of a table from names with values: calls such as RevoluteDH(a=0.4), dictionaries, numbers by name, lists by column."""

import re
from collections.abc import Mapping
from contextlib import suppress

from kinlib.dh.parsing import ALL_COLUMNS, COLUMN_NAMES, COLUMNS, NEEDED, Entry, Grid, parse_heading, read_entry

NAME = r"\b([a-zA-Z][\w.]*)['\"]?(?:\[\d*\])?[ \t]*[:=](?!=)"
END = rf"[;|&\n]|(?<=\s)(?:[#%]|//)|,(?!\s*\d+\s*(?:[,;)\n]|$))|(?:\band\s+)?['\"]?{NAME}".replace(r"\b(", r"\b(?:")
ASSIGNED = re.compile(
    rf"{NAME}(?:\s*(?:\w+\.\w+\()?(?=[\[{{])|[ \t]*)"
    rf"([\[{{][^\[\]{{}}:=]*[\]}}]|(?:\([^()\n]*\)|\[[^\[\]\n]*\]|(?!{END})[^)}}])*)"
)
"""A name and its value or list: l1 = 0.3, 'd1': 89.2 mm, a = [0, 0.4]. A number behind a comma belongs to the value, as in d=0,3."""

INSIDE = r"((?:[^(){}]|(?<!DH)(?<!Link)(?<!dict)\([^(){}=:]*\))*)"
GROUP = re.compile(rf"([\w.:]*)[ \t]*(?:\({INSIDE}\)|\{{{INSIDE}\}})")
"""The name of a call, or nothing, and what is in its parentheses or braces."""

LINK = re.compile(r"(?!.*(?:Robot|SerialLink|OriginLink|DHTable|::))(?:.*\W)?\w*(?:Revolute|Prismatic|Link|DH)\w*")


def definitions(text: str) -> dict[str, Entry]:
    """Read the values of names, l1 = 0.3 or d1 = 89.2 mm, that a text has; a name with two values has none.

    >>> definitions("with d1 = 89.2 mm")
    {'d1': Entry(value=(0.0892+0j), variables=[], unit='m')}
    """
    known, twice = dict[str, Entry](), set[str]()
    for name, value in ASSIGNED.findall(re.sub(r"[{}]", "", text)):
        if value and name not in COLUMN_NAMES and not re.fullmatch(r"(?:q|theta|alpha)\d*", name):
            with suppress(ValueError):
                entry = read_entry(value.rstrip(" ."), "", known)
                twice |= {name} if entry.variables or known.setdefault(name, entry) != entry else set()
    return {name: entry for name, entry in known.items() if name not in twice}


def read_named(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read calls, RevoluteDH(d=0.1, a=0.2) or Link([0 0.1 0.2 pi/2]), dictionaries, or lines such as a=0.2 alpha=90° d=0."""
    groups = [(found[0].strip(), found[1], found[2] or found[3] or "") for found in GROUP.finditer(text)]
    calls = [group for group in groups if LINK.fullmatch(group[1])]
    if len(calls) < sum(bool(LINK.fullmatch(name)) for name in re.findall(r"([\w.:]+)[ \t]*\(", text)):
        raise ValueError("A call such as RevoluteDH(a=0.4) must have numbers, and no other calls, in its parentheses.")
    if not calls and (columns := _read_columns(text, names)).rows:
        return columns
    grid, lines = Grid(names), [(line, "", line) for line in text.splitlines()]
    named = ([each for each in some if {name for name, _ in _cells(each[2])} >= NEEDED] for some in (groups, lines))
    records = calls or next(filter(None, named), [])
    if len(records) < 2:
        return grid
    for source, kind, inside in records:
        place, cells = f"Row {len(grid.rows) + 1}, {source.strip():.80}", _cells(inside)
        if len({column for column, _ in cells}) < len(cells):
            raise ValueError(f"{place}: each name must have one value. Write each row in a line.")
        grid.rows.append(_link(kind, inside, dict(cells), grid, place) if calls else dict(cells))
        grid.places.append(place)
        text = text.replace(source, "", 1)
    for line in text.splitlines():
        if any(parse_heading(name).column and name not in names for name, _ in ASSIGNED.findall(line)):
            grid.assume(f"{line.strip()!r:.80} was not read.")
    return grid


def _cells(inside: str) -> list[tuple[str, str]]:
    """Return the columns that are named, and their values; a list of more numbers is no value of a row."""
    named = re.sub(r"['\"](\w+)['\"]\s*,(?!\s*(?:['\"]|\w+\s*=))", r"\1=", inside)
    pairs = ((parse_heading(name).column, value.strip()) for name, value in ASSIGNED.findall(named))
    return [(column, cell) for column, cell in pairs if column and not re.match(r"\[.*[\s,;]", cell)]


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
    slides = "Prismatic" in kind or (re.match(r"\s*['\"]", inside) and "theta" in row and "d" not in row)
    row = {"type": "P" if slides else "R"} | row
    if row.pop("flip", "").lower() in {"true", "1"}:
        moving = "theta" if row["type"] in {"R", "0"} else "d"
        row[moving] = f"-q + {row.get(moving, '0')}"
    return dict.fromkeys((*COLUMNS, "offset"), "0") | row


def _read_columns(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read lists by column, a = [0, -0.425], or entries with the numbers of their rows, d1 = 0.3 or L(1).d = 0.3."""
    grid, lists, entries = Grid(names), dict[str, dict[int, str]](), dict[str, dict[int, str]]()
    twice = set[str]()
    for name, value in ASSIGNED.findall(re.sub(r"\b\w+\((\d+)\)\.(\w+)", r"\2\1", text)):
        is_list, stem = bool(re.fullmatch(r"(?s)[\[{].*[\]}]", value)), name.rstrip("0123456789")
        column, unit, _ = parse_heading(name if is_list else stem)
        cells = re.split(r"\s*[,;]\s*" if re.search("[,;]", value) else r"\s+", value.strip("[]{},; \n"))
        if is_list and not (column in ALL_COLUMNS and all(map(grid.is_entry, cells))):
            grid.assume(f"The list {name} was not read.")
        elif column in ALL_COLUMNS and (is_list or stem != name):
            found, start = (lists, 1) if is_list else (entries, int(name[len(stem) :]))
            grid.units |= {column: unit} if unit else {}
            for k, cell in enumerate(cells if is_list else [value.strip()], start):
                twice |= {name} if found.setdefault(column, {}).setdefault(k, cell) != cell else set()
    found = lists if len(NEEDED & {*lists}) > 1 else entries if {*entries} >= NEEDED else {}
    if not found:
        return Grid(names)
    a_and_alpha = {*found.get("a", ()), *found.get("alpha", ())}
    if 0 in a_and_alpha and 0 not in found.get("d", [0]):  # a_0 and alpha_0, but d_1
        grid.convention = "modified"
        found |= {name: {k + 1: value for k, value in found[name].items()} for name in ("a", "alpha")}
    indices = {k for cells in found.values() for k in cells}
    if found is entries and (joints := sorted(indices - {*found.get("theta", indices)})):
        grid.assume(f"There is no theta{joints[0]}: each theta without a value was read as the joint variable.")
        found["theta"] |= {k: f"q{k}" for k in joints}
    if twice or not {*found} >= NEEDED or any({*cells} != indices for cells in found.values()):
        counts = ", ".join(f"{name} ({len(cells)})" for name, cells in found.items())
        raise ValueError(
            f"a, alpha and d must have one value for each row, with its number or as lists of the same length; got "
            f"{counts}{', and two values for ' * bool(twice)}{', '.join(sorted(twice))}. Paste all of one arm."
        )
    grid.rows = [{column: cells[k] for column, cells in found.items()} for k in sorted(indices)]
    grid.places = [f"Row {k}" for k, _ in enumerate(grid.rows, start=1)]
    return grid
