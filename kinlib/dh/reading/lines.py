"""Read the rows of a table from lines of cells, with a heading, without one, or with a heading at the beginning of each line."""

import re
from collections.abc import Mapping, Sequence

from kinlib.dh.parsing import COLUMNS, NUMBER, Entry
from kinlib.dh.reading.columns import NEEDED, Grid, Heading, headings_in, parse_heading
from kinlib.dh.reading.spelling import cells_of_line, rows_in_lines

MAX_LINES, MAX_CELLS, MAX_ROWS = 2000, 40, 60
"""The maximum number of lines of a text and of cells in a line that are read, and of rows of a table."""

UNNAMED = [Heading(str(place)) for place in range(len(COLUMNS))]
"""The headings of rows without a heading."""


def read_lines(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read lines of cells, with a heading or without one: columns without a name have their places, from "0" on."""
    grid, heads, read, is_after_gap, is_spreadsheet = Grid(names), [UNNAMED], list[list[str]](), False, False
    for number, raw in enumerate(lines_of(rows_in_lines(text)), start=1):
        line, place = cells_of_line(raw), f"Line {number}, {raw.strip()!r:.80}"
        if not re.sub(r"[|\s:+=-]", "", line):
            is_after_gap = True
            continue
        widths = {len(cells) for cells in read} if is_after_gap else set[int]()  # after a gap another table may follow
        splits = [cells for cells in split_line(line) if not widths or len(cells) in widths]
        if is_spreadsheet and "\t" in line and splits:  # it drops empty cells at the end
            splits[0] += [""] * (len(heads[0]) - len(splits[0]))
        if not (has_heading := heads != [UNNAMED]):
            splits += [[cell for cell in cells if cell] for cells in splits[:1]]  # tabs may only align
        is_prose = not read and bool(re.match(r"\s*(?:#|%|//)(?=.*(?:[a-zA-Z]{2,} ){3})", raw))
        ways = [(cells, kind) for kind in heads for cells in splits] * (not is_prose)
        fits = [(*way, row) for way in ways if (row := _row(*way, grid))]
        found = [] if (has_heading and (read or fits)) else headings_in(raw, splits, not has_heading)
        if found:  # above the rows, or below them
            found.sort(key=lambda kind: {len(kind)} != {len(cells) for cells in read})
            grid.rows = [_row(cells, found[0], grid) for cells in read if len(cells) == len(found[0])]
            if len(grid.rows) < len(read):
                grid.assume(f"What stands above the heading in line {number} was not read.")
                grid.rows, grid.places, read = [], [], []
            heads, is_spreadsheet = found, "\t" in raw
            continue
        if fits:
            cells, kind, row = min(fits, key=lambda fit: len(fit[0]) != len(fit[1]))
            heads = [kind]
            read.append(cells)
            grid.rows.append(row)
            grid.places.append(place)
        elif not is_prose and _is_end(place, line, splits, grid, is_after_gap=is_after_gap, has_heading=has_heading):
            break
        is_after_gap = False
    grid.units = {head.column: head.unit for head in heads[0] if head.unit}
    grid.subscript = max(head.subscript for head in heads[0] if head.column in {*COLUMNS[:2], "0"})
    return grid


def _row(cells: list[str], heads: Sequence[Heading], grid: Grid) -> dict[str, str]:
    """Return the cells of a row by column; the label of a row may have no heading. {} if the line is no row."""
    is_number = cells[0].rstrip(".") in {str(len(grid.rows)), str(len(grid.rows) + 1)}  # counted from 0 or from 1
    is_name = re.fullmatch(r"[A-Za-z]+\d+\.?", cells[0])
    if len(cells) == len(heads) + 1 and (is_number or is_name or not grid.is_entry(cells[0])):
        heads = [Heading(""), *heads]
    named = [k for k, head in enumerate(heads) if head.column]
    if len(cells) == named[-1] - named[0] + 1:  # without what has no name
        heads = heads[named[0] : named[-1] + 1]
    row = {
        head.column or "label": cell
        for head, cell in zip(heads, cells, strict=False)
        if head.column or head is heads[0]
    }
    readable = [
        name for name in {*row} - {"label", "type"} if grid.is_entry(row[name]) or (not row[name] and "0" not in row)
    ]
    enough = 4 if "0" in row else 3  # of cells with names, one that cannot be read is told with its column
    if len(cells) != len(heads) or len(readable) < enough:
        return {}
    numbers = sum(map(grid.is_entry, cells)) - is_number
    if (missing := sorted(NEEDED - {*row})) and "0" not in row and numbers >= len(COLUMNS):
        raise ValueError(
            f"The heading has no {' and no '.join(missing)}, but each row has {numbers} numbers. Name every column above the rows."
        )
    return row


def _is_end(
    place: str, line: str, splits: list[list[str]], grid: Grid, *, is_after_gap: bool, has_heading: bool
) -> bool:
    """Whether a line that is no row ends the table; ValueError if it looks like a row."""
    numbers = len(re.findall(rf"(?<![\w.])-?{NUMBER}", line))
    is_number = not is_after_gap and re.fullmatch(rf"[+-]?{NUMBER}", line)
    is_next = (
        has_heading
        and grid.rows
        and (is_number or any(cells[0].rstrip(".") == str(len(grid.rows) + 1) for cells in splits))
    )
    if grid.rows and not is_next and (is_after_gap or (numbers and "=" in line) or 0 < numbers < 3):
        grid.assume(f"No rows were read from here on: {place}.")
        return True
    if is_next or (numbers >= 3 and (has_heading or grid.rows)):
        raise ValueError(
            f"{place} cannot be read: it has another number of cells than the heading, or one is no number. Is one empty?"
        )
    if numbers >= len(COLUMNS):
        grid.assume(f"{place} was not read.")
    return False


def lines_of(text: str) -> list[str]:
    """Return the lines of a text, also if each cell is in a line of its own, as copied from a PDF."""
    if len(lines := text.splitlines()) > MAX_LINES:
        raise ValueError(f"A table must have at most {MAX_ROWS} rows; the text has {len(lines)} lines.")
    cells = [line.strip() for line in lines if line.strip()]
    width = next((k for k, cell in enumerate(cells[:8]) if re.fullmatch(NUMBER, cell)), 0)
    heads = {parse_heading(cell).column for cell in cells[:width]}
    if not heads >= {*COLUMNS} or len(cells) % width or "|" in text or "\t" in text:
        return lines
    return ["\t".join(cells[k : k + width]) for k in range(0, len(cells), width)]


def split_line(line: str) -> list[list[str]]:
    """Split a line into cells at the separators that it may have, the surest first."""
    if separator := next((sign for sign in "|\t;" if sign in line), ""):
        line = re.sub(r"(?<=\S) {2,}(?=\S)", "\t", line) if separator == "\t" else line  # code may align by both
        cells = (re.sub(r"^\||\|$", "", line.strip()) if separator == "|" else line).split(separator)
        return [[_cell(cell, decimal_comma=True) for cell in cells[:MAX_CELLS]]]
    found = []
    spaced = re.sub(r"\s+([+*/])\s+|\s*([*/])\s*|(?<=[\w°)])\s+(-)\s+(?=\d|pi)", lambda f: f[1] or f[2] or f[3], line)
    has_decimal_commas = re.fullmatch(r"(?:\S*\d,\d\S*|[^,\s]+)(?:\s+(?:\S*\d,\d\S*|[^,\s]+))*", line)
    if ("," in line and not has_decimal_commas) or (line.count(",") >= 3 and " " not in spaced):
        found.append([_cell(cell) for cell in line.split(",")[:MAX_CELLS]])
    # a space before a minus is enough after a number or a label: "1 -0.2", where "1 - 0.2" is a difference
    wide = re.sub(rf"(^\s*(?!theta|[qdt]_?\d)[A-Za-z]+\d+|{NUMBER})\s(?=-{NUMBER})", r"\1  ", spaced)
    splits = (re.split(pattern, wide)[:MAX_CELLS] for pattern in (r"\s{2,}", r"\s+"))
    return found + [[_cell(cell, decimal_comma=True) for cell in cells] for cells in splits]


def _cell(cell: str, decimal_comma: bool = False) -> str:
    cell = re.sub(r"^(?:a|d|l|alpha)_?\d+\s*=\s*", "", cell.strip().strip("\"'`*").strip())
    return re.sub(r"(?<=\d),(?=\d)", ".", re.sub(r",(?=\d{3}\.)", "", cell)) if decimal_comma else cell
