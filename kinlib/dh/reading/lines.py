"""Read the rows of a table from lines of cells, with a heading or without one."""

import re
from collections.abc import Collection, Mapping, Sequence
from itertools import pairwise

from kinlib.dh.parsing import ALL_COLUMNS, COLUMN_NAMES, COLUMNS, NEEDED, NUMBER, Entry, Grid, Heading, parse_heading

MAX_CELLS = 40
"""The maximum number of cells of a line that are read."""

SEPARATORS = ("|", "\t", ";", ",", "  ", " ")
"""What may separate the cells of all rows, the surest first."""

Found = tuple[Sequence[Heading], int, Mapping[int, dict[str, str]]]
"""The headings of the columns, the line that has them, and the rows by their lines."""

UNNAMED = [Heading(str(place)) for place in range(len(COLUMNS))]
"""The headings of rows without a heading."""

ARRAY = re.compile(r"[\[{(]\s*[\[{(]|=\s*[\[{]|[\[{][^\]}]{,999};|\([^()]*\),\s*\(")
COMMENT = re.compile(r"\s*(?:#+|%+|//+|/\*|\(\*|['\"]{3})\s*")
SINGLE_NUMBER = re.compile(rf"(?<![\w.])(?<![\w\]]\[)-?{NUMBER}")

WORDS = re.compile(r"(?:[\s,;|]|\band\b|\bthen\b)+|(?<=[a-zA-Z])[\[({](?=\w+\s*,)")
"""What is between the names of columns in a comment."""

ONE_CELL = [
    (r"(?i)\b(joint|link|axis|row|frame|j)[ _-](?=\d|i\b)", r"\1"), (r" +(?=[\[(](?:[a-zA-Z]+|°|i-1)[\])])", ""),
    (r"(?i)\b(?:(?:link|joint) )?(length|offset|twist|angle)(?: (?:a|d|alpha|theta)\b)?", r"\1"),
    (r" +([+*/]) +|(?<=[\w°)]) +(-) +(?=[\dpq(])", r"\1\2"), (r"(?<=\d) (?=(?:mm|cm|m|deg|rad)\b|°)", ""),
    (r"(?<=[\d°]) *~ *(?=[-+]?\d)", "~"),
]  # fmt: skip
"""What is one cell where spaces separate the cells: Joint 1, alpha (deg), link length a, q1 + 90, 3 mm, -170 ~ 170."""


def read_lines(text: str, names: Mapping[str, Entry]) -> Grid:
    """Read lines of cells: of the separators, that which gives the most rows is taken."""
    lines = [re.sub(r"^([^;]*);$", r"\1", line.strip(" \r").rstrip(",")) for line in _side_by_side(_lines_of(text))]
    grid, separators = Grid(names), [sign for sign in SEPARATORS if sign in text or sign == "\t"]
    layout, start, rows = max((_read(lines, sign, grid) for sign in separators), key=lambda read: len(read[-1]))
    if not rows:
        return grid
    places = [f"Line {k}, {line.strip()!r:.80}" for k, line in enumerate(lines, start=1)]
    grid.rows, grid.places = [*rows.values()], [places[k] for k in rows]
    grid.units = {head.column: head.unit for head in layout if head.unit}
    grid.convention = min({head.convention for head in layout if head.column in COLUMNS[:2]} - {""}, default="")
    if "" in lines[min(rows) : max(rows)]:
        grid.assume("The rows below an empty line were read, too.")
    columns = [head.column for head in layout]
    has_r = start >= 0 and {"a", "alpha"} <= {*columns} and re.search(r"\br(?:_?\{?[ij])?\b", lines[start])
    if has_r and abs(columns.index("a") - columns.index("alpha")) > 1:  # as in alpha, d, theta, r
        grid.assume("The column r was read as a; some papers call d so.")
    # Lines with numbers that are no rows are told; between the rows, and just below them, they are a problem.
    first, last = min(rows) if layout[-1] is UNNAMED[-1] else start, max(rows)
    gap = min([k for k in range(last, len(lines)) if not lines[k].strip()], default=len(lines))
    for k in sorted({*range(len(lines))} - {*rows}):
        count = 0 if COMMENT.match(lines[k]) else len(SINGLE_NUMBER.findall(lines[k]))
        is_row = count >= len(NEEDED) and "=" not in lines[k]
        if count and (first < k < last or (last < k < gap and is_row)):
            raise ValueError(
                f"{places[k]} cannot be read: it does not have as many cells as the other rows, or one of them is no number. Is one empty?"
            )
        if is_row or (count and k > last):
            grid.assume(f"{'No rows were read from here on' if k > last else 'A line was not read'}: {places[k]}.")
            if k > last:
                break
    return grid


def commented_rows(text: str) -> list[str]:
    """Return the lines of a text that are comments and have as many numbers as a row."""
    comments = [line.strip() for line in text.splitlines() if COMMENT.match(line)]
    return [line for line in comments if len(SINGLE_NUMBER.findall(line)) >= len(NEEDED)]


def _lines_of(text: str) -> list[str]:
    """Return the lines of a text, in which each row of an array is one."""
    if ARRAY.search(text):
        text = re.sub(r"\n[ \t]*\n", "\n\0\n", text)
        text = re.sub(r"(?:#|//|%)(?!.*(?:alpha|twist)).*|\.\.\.", "", text)
        # A heading is above the row beside it, or below it if that is the last one.
        text = re.sub(r"(?m)^(.*?)((?:#|//|%).*)$(?=(?s:.*)\n[ \t]*[\[{(])", r"\2\n\1", text)
        text = re.sub(r"(#|//|%)", r"\n\1", text)
        text = re.sub(r"[\[{(]((?:[^\[\]{}()]|\([^(),]*\))*)[\])}],?", _as_lines, text)
        text = re.sub(r"\n\s*\n", "\n", text).replace("\0", "")
    return text.splitlines()


def _side_by_side(lines: Sequence[str]) -> Sequence[str]:
    """Write cells that are below each other, as copied from a PDF, in lines."""
    cells = [line.strip() for line in lines if line.strip()]
    width = next((k for k, cell in enumerate(cells[:9]) if re.fullmatch(NUMBER, cell)), 0)
    if not {*COLUMNS} <= {parse_heading(cell).column for cell in cells[:width]} or len(cells) % width:
        return lines
    return ["\t".join(cells[k : k + width]) for k in range(0, len(cells), width)]


def _as_lines(group: re.Match[str]) -> str:
    """Write what is between two brackets as lines, if it has the cells of a row."""
    is_row = len(re.findall(r"[^\s,;]+", group[1])) >= len(NEEDED)
    return "\n" + group[1].replace(";", "\n") + "\n" if is_row else group[0]


def _read(lines: Sequence[str], separator: str, grid: Grid) -> Found:
    """Read the rows that this separator gives below the first heading that has some, or above it; all rows have one layout."""
    named = [k for k, line in enumerate(lines) if re.search("(?i)al|twist|psi", line)]
    headings = {k: heads for k in named if (heads := _heading(lines[k], separator))}
    ends = [*headings, len(lines)]
    for start, end in [*pairwise(ends), (-1, ends[0])]:
        block = [k for k in range(start + 1, end) if re.search(r"\w", lines[k]) and not COMMENT.match(lines[k])]
        heads = headings.get(start, headings.get(end, []))
        cells = {k: _split(lines[k], separator) for k in block}
        if separator == "\t":  # a spreadsheet leaves out empty cells at the end
            cells = {k: each + [""] * (len(heads) - len(each)) * ("\t" in lines[k]) for k, each in cells.items()}
        if layout := _layout(cells.values(), heads, grid) or _layout(cells.values(), UNNAMED, grid):
            return layout, start, {k: row for k, each in cells.items() if (row := _row(each, layout, grid))}
    return [], -1, {}


def _heading(line: str, separator: str) -> list[Heading]:
    """Return a line as headings of at least three columns, with this separator, blanks, or as words; [] if it is none.

    In a comment the names have nothing between them, and what is beside them is no column.
    """
    comment, best, most = COMMENT.match(line), list[Heading](), len(NEEDED) - 1
    line = line[comment.end() :] if comment else line
    for cells in (_split(line, separator), _split(line, " "), WORDS.split(line)[:MAX_CELLS]):
        heads = [parse_heading(cell) for cell in cells]
        if "d" not in {head.column for head in heads}:
            heads = [head._replace(column="d") if head.column == "offset" else head for head in heads]
        named = [k for k, head in enumerate(heads) if head.column]
        places = [k for k in named if heads[k].column in ALL_COLUMNS]
        if len(places) <= most or len({heads[k].column for k in places}) < len(places):
            continue
        heads = heads[named[0] : named[-1] + 1] if comment else heads
        if not comment or len(heads) == len(named):
            heads[0] = heads[0] if heads[0].column else Heading("label")
            best, most = heads, len(places)
    return best


def _layout(lines: Collection[list[str]], heads: list[Heading], grid: Grid) -> list[Heading]:
    """Return the headings in the way that makes a line a row; one for a label is added if there is none. [] if no line is a row."""
    ways = [each for each in (heads, [Heading("label"), *heads]) if each[1:] and each[1].column != "label"]
    return next((each for cells in lines for each in ways if _row(cells, each, grid)), [])


def _row(cells: list[str], layout: Sequence[Heading], grid: Grid) -> dict[str, str]:
    """Return the cells of a row by column; {} if the line is none, because it has other cells."""
    row = {head.column: cell for head, cell in zip(layout, cells, strict=False) if head.column}
    label, (empty, least) = row.get("label", ""), ("", 4) if "0" in row else ("0", 3)
    is_label = re.fullmatch(r"\d{1,2}\.?|[A-Za-z]+\d+\.?", label) or not grid.is_entry(label)
    is_label = is_label and label.lower() not in COLUMN_NAMES  # then rows and columns are swapped
    readable = [name for name, cell in row.items() if name not in {"label", "type"} and grid.is_entry(cell or empty)]
    return row if len(cells) == len(layout) and is_label and len(readable) >= least else {}


def _split(line: str, separator: str) -> list[str]:
    """Split a line into cells."""
    if separator == "|":
        line = re.sub(r"^\||\|$", "", line)
    elif separator == "\t":
        line = re.sub(r"(?<=\S) {2,}(?=\S)", "\t", line)  # code may align by both
    elif separator == " ":
        for pattern, joined in ONE_CELL:
            line = re.sub(pattern, joined, line)
    cells = re.split(separator.replace("|", r"\|") + "+" * (separator[0] == " "), line)[:MAX_CELLS]
    cells = [re.sub(r"^[a-zA-Z]+_?\d+\s*=\s*", "", cell.strip().strip("\"'`*").strip()) for cell in cells]
    if separator != ",":
        cells = [re.sub(r"(?<=\d),(?=\d)", ".", re.sub(r",(?=\d{3}\.)", "", cell)) for cell in cells]
    return cells
