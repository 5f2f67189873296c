"""The rows of a DH table as a text has them: cells by column, the headings of the columns, and what was assumed."""

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
        "type": "type sigma jointtype kind",
        "flip": "flip",
    }.items()
    for name in names.split()
}
"""The names that people give to columns, in small letters without signs and indices."""

OTHER_WORDS = {"angle", "joint", "length", "link", "offset", "twist", "dh", "arm", "self", "robot", "value", "val", "list"}  # fmt: skip
"""The words that may be beside the name of a column: link length a, dh_alpha_values."""

NEEDED, ALL_COLUMNS = {"a", "alpha", "d"}, {*COLUMNS, "offset"}

UNIT = re.compile(
    r"(?:\bin\b)?[\[(/,_]?\s*(?:(?<![a-zA-Z])(mm|cm|m|millimet\w+|met(?:er|re)s?|rad|radians?|deg|degrees?)\b|°)\.?\s*[\])]?"
)
INDEX = re.compile(r"[_\s({\[]*(?:[ijkn]|\d)\s*(-\s*1)?[)}\]]*\s*$")


class Heading(NamedTuple):
    """A heading: its column, or "" if it is none; its unit, and "i" or "i-1" if it has this index."""

    column: str
    unit: str = ""
    subscript: str = ""


def parse_heading(head: str) -> Heading:
    """Read a heading, or the name that code has for a column.

    >>> parse_heading("alpha_{i-1} (deg)")
    Heading(column='alpha', unit='deg', subscript='i-1')
    """
    plain, unit = head.strip(" \"'`*:!{}").replace("\\", "").lower(), ""
    if len(plain) > MAX_ENTRY_LENGTH or re.search(r"[⁻⁺]|min|max|lim(?!e)|range", plain):  # limits of a joint
        return Heading("")
    if found := UNIT.search(plain):
        unit = {"°": "deg", "mi": "mm", "me": "m", "ra": "rad", "de": "deg"}.get((found[1] or "°")[:2], found[1])
        plain = (plain[: found.start()] + plain[found.end() :]) if found.start() else plain
    index = INDEX.search(plain)
    stem = plain[: index.start()] if index else plain
    words = [word[:1] + word[1:].removesuffix("s") for word in re.findall(r"(?<![\[(a-z])[a-z]+", stem)]
    alone = [word for word in words if word not in OTHER_WORDS]  # in "link length a" and "alpha [grados]"
    known = [re.sub("[^a-z0]", "", plain), re.sub("[^a-z0]", "", stem), "".join(words), *alone[: len(alone) == 1]]
    column = next((COLUMN_NAMES[text] for text in known if text in COLUMN_NAMES), "")
    subscript = "" if not index else "i-1" if index[1] else "i" * bool(re.search("[ijkn]", index[0]))
    return Heading("offset" if column == "theta" and "offset" in words else column, unit, subscript)


class Assumption(NamedTuple):
    """What was assumed: a sentence; and if the numbers alone suggest it, the argument that says otherwise, and its values."""

    text: str
    argument: str = ""
    options: Sequence[str] = ()


@dataclass
class Grid:
    """Rows of cells by column, or by their places, from "0" on, if the text has no heading, and the place of each row in the text.

    names, units  the values that names have, and the units of the columns
    subscript     of a and alpha: "i" in the standard convention, "i-1" in the modified one, "" if they have none
    problem       the place of a line that should be a row, but cannot be read
    """

    names: Mapping[str, Entry]
    rows: list[dict[str, str]] = field(default_factory=list)
    places: list[str] = field(default_factory=list)
    units: dict[str, str] = field(default_factory=dict)
    assumed: list[Assumption] = field(default_factory=list)
    subscript: str = ""
    problem: str = ""

    def assume(self, text: str, argument: str = "", options: Sequence[str] = ()) -> None:
        """Note what was assumed."""
        self.assumed.append(Assumption(text, argument, options))

    def is_entry(self, cell: str) -> bool:
        """Whether a cell can be an entry, with whatever values its names have."""
        unknown = {name: Entry(1 + 0j) for name in re.findall(r"\b[a-pr-su-zA-Z]\d+", cell)}
        try:
            return bool(read_entry(cell, "", {**unknown, **self.names})) and bool(cell.strip())
        except ValueError:
            return False
