"""The columns of a DH table as a text has them: their headings, and rows of cells by column."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from kinlib.dh.parsing import COLUMNS, MAX_ENTRY_LENGTH, Entry, read_entry

COLUMN_NAMES = {
    name: column
    for column, names in {
        "a": "a r length linklength",
        "alpha": "alpha alfa alph al twist linktwist psi",
        "d": "d s linkoffset",
        "theta": "theta th q angle jointangle v var variable",
        "offset": "offset thetaoffset offsettheta theta0 zero jointoffset qoffset",
        "home": "home",
        "type": "type sigma jointtype kind",
    }.items()
    for name in names.split()
}
"""The names that people give to columns, in small letters without signs and indices. An offset is that of theta
beside a d, and home is one if there is no theta."""

NEEDED, ALL_COLUMNS = {"a", "alpha", "d"}, {*COLUMNS, "offset"}

UNIT = re.compile(
    r"[\[(/,_]?\s*(?:(?<![a-zA-Z])(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b|°)\.?\s*[\])]?"
)
INDEX = re.compile(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$")


class Heading(NamedTuple):
    """A heading: its column, or "" if it is none; its unit, and "i" or "i-1" if it has this index."""

    column: str
    unit: str = ""
    subscript: str = ""


def parse_heading(head: str) -> Heading:
    """Read a heading.

    >>> parse_heading("alpha_{i-1} (deg)")
    Heading(column='alpha', unit='deg', subscript='i-1')
    """
    plain = head.strip(" \"'`*:{}").replace("\\", "").replace("$", "")
    if len(plain) > MAX_ENTRY_LENGTH or re.search(r"[⁻⁺]|min|max|lim(?!e)|range", plain):  # limits of a joint
        return Heading("")
    unit = ""
    if found := UNIT.search(plain):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get((found[1] or "°")[:2], found[1])
        if re.search("[a-zA-Z]", plain[: found.start()]):
            plain = plain[: found.start()] + plain[found.end() :]
    plain = plain.strip().lower()
    index = INDEX.search(plain)
    stem = plain[: index.start()] if index else plain
    whole, bare = (re.sub("[^a-z0]", "", text) for text in (plain, stem))
    words = {*re.findall(r"(?<![\[(a-z])[a-z]+", stem)} - {"angle", "joint", "length", "link", "offset", "twist"}
    alone = words.pop() if len(words) == 1 else ""  # in "link length a" and "alpha [grados]"
    column = next((COLUMN_NAMES[text] for text in (whole, bare, alone) if text in COLUMN_NAMES), "")
    subscript = "i" * bool(index and re.search("[ijkn]", index[0]))
    return Heading(column, unit, "i-1" if index and index[1] else subscript)


def column_of(name: str) -> str:
    """Return the column that a name in code stands for, as arm.dh_alpha_values does; "" if there is none, or several."""
    parts = [] if "home" in name else re.split("[._]", re.sub(r"[\d_]+$", "", name.lower()))
    known = {COLUMN_NAMES.get(part) or COLUMN_NAMES.get(part.removesuffix("s"), "") for part in parts} - {""}
    return parse_heading(name).column or ("offset" if "offset" in known else known.pop() if len(known) == 1 else "")


def headings_in(line: str, splits: Sequence[Sequence[str]], is_first: bool) -> list[list[Heading]]:
    """Return the ways of reading a line as headings of at least three columns, those of most: by its cells, and in prose.

    Between the names in a comment, and below other headings, there is no other word.
    """
    is_comment = bool(re.match(r"\s*(?:[#%*'\"]|//|/\*|--)", line))
    words = re.split(r"(?:[\s,;|]|\band\b|\bthen\b)+|/(?!\s*(?:mm?|cm|rad|deg|°))|(?<=[a-zA-Z])[\[({](?=\w+\s*,)", line)
    prose = [parse_heading(word) for word in words if re.search(r"\w", word)]
    runs = [prose[k : k + count] for count in (5, 4, 3) for k in range(len(prose) - count + 1)]
    run = next(
        (run for run in runs if len(found := {head.column for head in run} - {""}) == len(run) and found >= NEEDED), []
    )
    ways, most = list[list[Heading]](), 3
    for kind in (*([parse_heading(cell) for cell in cells] for cells in splits), run):
        columns = [head.column for head in kind]
        others = {"offset": "d"} if "d" not in columns else {"home": "offset"} if "theta" not in columns else {}
        columns = [others.get(name, name) for name in columns]
        names = [name for name in columns if name in ALL_COLUMNS]
        places = [k for k, name in enumerate(columns) if name]
        if len({*names}) < max(most, len(names)):
            continue
        if (is_first and not is_comment) or places[-1] - places[0] < len(places):
            heads = [head._replace(column=name) for head, name in zip(kind, columns, strict=True)]
            ways, most = [*(ways if len(names) == most else []), heads], len(names)
    return ways


class Assumption(NamedTuple):
    """What was assumed: a sentence; and if the numbers alone suggest it, the argument that says otherwise, and its values."""

    text: str
    argument: str = ""
    options: Sequence[str] = ()


@dataclass
class Grid:
    """Rows of cells by column, or by their places if the text has no heading.

    names      that have values
    places     of the rows in the text
    units      of the columns
    subscript  of a and alpha: "i" in the standard convention, "i-1" in the modified one, "" if they have none
    """

    names: Mapping[str, Entry]
    rows: list[dict[str, str]] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    units: dict[str, str] = field(default_factory=dict)
    subscript: str = ""
    assumed: list[Assumption] = field(default_factory=list)

    def assume(self, text: str, argument: str = "", options: Sequence[str] = ()) -> None:
        """Note what was assumed."""
        self.assumed.append(Assumption(text, argument, options))

    def is_entry(self, cell: str) -> bool:
        """Whether a cell can be an entry, with whatever values its names have."""
        unknown = {name: Entry(1 + 0j) for name in re.findall(r"\b[a-zA-Z]\d+", cell) if name[0] not in "qt"}
        try:
            read_entry(cell, "", {**unknown, **self.names})
        except ValueError:
            return False
        return bool(cell.strip())
