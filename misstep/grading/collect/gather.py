"""Gathering: from a folder or a download to what each student handed in, each with what was odd about it."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from misstep.grading.collect.files import File, Refused, files, named
from misstep.grading.collect.layouts import Layout, Pile, layout
from misstep.grading.collect.roster import Roster
from misstep.grading.collect.submission import Broken, code_cells

TYPED = re.compile(r"^student\s*=\s*([\"'])(.{1,200}?)\1", re.MULTILINE)
"""The line in which a sheet names its student."""


@dataclass(frozen=True)
class Handed:
    """What one student handed in.

    student    who it is: the id of the course, or what the platform calls them where no roster tells
    drawn_for  the id that the numbers come from; "" for the one that the notebook names
    notebook   the file to grade; None where nothing was handed in
    notes      what was odd about the files
    """

    student: str
    drawn_for: str
    notebook: File | None
    notes: Sequence[str] = field(default=())

    def content(self) -> bytes | None:
        """The notebook as bytes; None where there is none. Raises Refused for a file that is not read."""
        return self.notebook.read() if self.notebook else None


@dataclass(frozen=True)
class Gathered:
    """Everybody's submission, by student, and what the instructor should know about the whole."""

    kind: str
    handed: Sequence[Handed]
    remarks: Sequence[str] = ()


def gather(source: Path, sheet: str, roster: Roster | None = None) -> Gathered:
    """Find what each student handed in. With a roster, everybody in it has a place, and one who is not in it is said.

    Raises ValueError where there are no submissions.
    """
    laid = layout(files(source), sheet)
    remarks: list[str] = []
    found = [_handed(pile, sheet, laid, roster) for pile in laid.piles]
    if laid.kind in {"canvas", "moodle", "gradescope"} and roster is None:
        remarks.append(
            f"This is a download from {laid.kind.capitalize()}, and no --roster says who has which id: each sheet is graded "
            "with the numbers of the id that stands in it. Whoever types another's id goes unnoticed."
        )
    if roster:
        here = {handed.student.casefold() for handed in found}
        listed = {name.casefold() for name in roster.ids}
        found += [Handed(name, name, None) for name in roster.ids if name.casefold() not in here]
        strangers = sorted(handed.student for handed in found if handed.student.casefold() not in listed)
        if strangers:
            remarks.append(f"Not in the roster, and so in no file for the platform: {', '.join(strangers)}.")
    return Gathered(laid.kind, sorted(_once(found), key=lambda handed: handed.student.casefold()), remarks)


def typed_id(content: bytes) -> str:
    """The id that a notebook names, read off its code; "" if it names none."""
    try:
        cells = code_cells(content)
    except Broken:
        return ""
    told = next((told for cell in cells if (told := TYPED.search(cell.source))), None)
    return told[2].strip() if told else ""


def _handed(pile: Pile, sheet: str, laid: Layout, roster: Roster | None) -> Handed:
    notebook, notes = _chosen(pile.files, sheet)
    if not pile.key:
        return Handed(pile.name, pile.name, notebook, notes)
    if roster is None:
        told = pile.key if laid.kind == "gradescope" else f"{pile.name}_{pile.key}"
        return Handed(told, "", notebook, notes)
    if student := roster.found(pile.key):
        return Handed(student, student, notebook, notes)
    return Handed(f"{pile.name}_{pile.key}", "", notebook, notes)


def _chosen(pile: Sequence[tuple[str, File]], sheet: str) -> tuple[File | None, list[str]]:
    """The file to grade: the one with the sheet's name, or a copy of it, or else one that opens the sheet; the newest."""
    notebooks = [(name, file) for name, file in pile if name.lower().endswith(".ipynb")]
    if not notebooks:
        others = [file for _, file in pile]
        return (others[0], [f"No notebook among what was handed in: {named(others)}."]) if others else (None, [])
    exact = [file for name, file in notebooks if name.casefold() == f"{sheet}.ipynb".casefold()]
    copy = re.compile(rf"{re.escape(sheet)}[-_ ]*(\(?\d+\)?|copy\d*|kopie\d*)\.ipynb", re.IGNORECASE)
    copies = [file for name, file in notebooks if copy.fullmatch(name)]
    rest = [file for _, file in notebooks]
    if not exact and not copies and len(rest) > 1:
        rest = [file for file in rest if _opens(file, sheet)] or rest
    best = max(exact or copies or rest, key=lambda file: (file.changed, file.path))
    if len(notebooks) == 1:
        return best, []
    return best, [f"{len(notebooks)} notebooks were handed in; {best.path} was graded."]


def _opens(file: File, sheet: str) -> bool:
    try:
        return sheet.encode() in file.read()
    except Refused:
        return False


def _once(found: Sequence[Handed]) -> list[Handed]:
    """Everybody once: where two places belong to one id, the one whose notebook is newer."""
    of: dict[str, list[Handed]] = {}
    for handed in found:
        of.setdefault(handed.student.strip().casefold(), []).append(handed)
    return [_newest(same) for same in of.values()]


def _newest(same: Sequence[Handed]) -> Handed:
    best = max(
        same, key=lambda handed: (handed.notebook is not None, handed.notebook.changed if handed.notebook else 0.0)
    )
    if len(same) == 1 or best.notebook is None:
        return best
    note = f"{len(same)} submissions belong to this id; {best.notebook.path} was graded, the newest."
    return Handed(best.student, best.drawn_for, best.notebook, [*best.notes, note])
