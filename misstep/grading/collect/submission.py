"""Submissions: what a student handed in, read without trust and without nbformat, whatever has become of it.

A notebook may come back from Colab or VS Code, with Windows line ends, with cells deleted, doubled, edited. What it
answers is in its code, so the code runs again, and in place of each check cell the sheet's own runs.
"""

import json
import re
from collections.abc import Mapping, Sequence
from contextlib import chdir
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from misstep.catalog import course_of, find_course

LARGEST = 32 << 20
"""No notebook of this course is larger, in bytes, even with every output in it."""

MOST_CELLS = 1000

MOST_PARTS = 500_000
"""No notebook has more brackets and commas. An empty list takes two letters in the file and sixty bytes in memory."""

CONFLICT = re.compile(r"^(<{7} |={7}$|>{7} )", re.MULTILINE)
OPENED = re.compile(r"open_sheet\(\s*[\"']([^\"']+)[\"']")

KINDS = {
    b"%PDF": "a PDF. Hand in the notebook itself, the file that ends in .ipynb.",
    b"PK\x03\x04": "a zip archive. Hand in the notebook itself, the file that ends in .ipynb.",
    b"\x1f\x8b": "a compressed archive. Hand in the notebook itself, the file that ends in .ipynb.",
    b"<": "a web page. Hand in the notebook itself, the file that ends in .ipynb, not its export.",
}


class Broken(ValueError):
    """Nothing here can be run. The message says why, to the student."""


@dataclass(frozen=True)
class Cell:
    """A code cell of a notebook: its place among all cells, its source, and the name that nbgrader knows it by."""

    place: int
    source: str
    name: str = ""


@dataclass(frozen=True)
class Master:
    """The sheet as it was handed out: its name, its folder, for each problem, from 1, the source of its check cell, its course.

    course  the package of an installed course, or the folder of another one
    """

    name: str
    folder: Path
    checks: Mapping[int, str]
    course: str


@dataclass(frozen=True)
class Step:
    """A cell to run: its source, the problem that it checks, if any, and the place of the submission's own cell."""

    source: str
    problem: int | None = None
    place: int | None = None


@dataclass(frozen=True)
class Plan:
    """What is to be run, in order, and what was odd: for the whole sheet, and by problem."""

    steps: Sequence[Step]
    notes: Sequence[str] = ()
    odd: Mapping[int, Sequence[str]] = field(default_factory=dict)


def master(path: Path, course: str | Path | None = None) -> Master:
    """Read the sheet that was handed out, from solutions/ or exercises/.

    course  the course that has the sheet, by its package or its folder; by default the installed one that has it

    Raises ValueError for a notebook that opens no sheet, or has no check cells, and where no course has the sheet.
    """
    cells = code_cells(path.read_bytes())
    opened = next((found[1] for cell in cells if (found := OPENED.search(cell.source))), None)
    checks = {int(cell.name.removeprefix("check-")): cell.source for cell in cells if _is_check(cell.name)}
    if opened is None or not checks:
        raise ValueError(f"{path} opens no sheet, or none of its cells is named check-1, check-2, ...: is it a sheet?")
    if course:
        return Master(opened, path.parent, checks, find_course(course).reference)
    with chdir(path.parent):  # a course may find sheets by files beside the notebook
        return Master(opened, path.parent, checks, course_of(opened).reference)


def code_cells(content: bytes) -> list[Cell]:
    """The code cells of a notebook.

    Raises Broken, with a sentence for the student, where there is nothing to read.
    """
    notebook = _notebook(content)
    sheets = notebook.get("worksheets")
    cells = notebook.get(
        "cells", sheets[0].get("cells") if isinstance(sheets, list) and sheets and isinstance(sheets[0], dict) else None
    )
    if not isinstance(cells, list):
        raise Broken("The file is JSON, but no notebook: it has no cells. Hand in the file that ends in .ipynb.")
    if len(cells) > MOST_CELLS:
        raise Broken(f"The notebook has {len(cells)} cells; no sheet has more than {MOST_CELLS}.")
    found = (_cell(place, cell) for place, cell in enumerate(cells) if isinstance(cell, dict))
    return [cell for cell in found if cell]


def plan(master: Master, content: bytes) -> Plan:
    """Decide what to run: the submission's cells in their order, with the sheet's own check cells.

    Raises Broken where there is nothing to run, or where it is another sheet.
    """
    cells = code_cells(content)
    problems = [_problem_of(cell, master) for cell in cells]
    opened = {name for cell in cells for name in OPENED.findall(cell.source)}
    if master.name not in opened and (opened or not any(problems)):
        which = f"it opens {', '.join(sorted(opened))}" if opened else "none of its cells belongs to it"
        raise Broken(f"This is not sheet {master.name}: {which}. Was another file handed in by mistake?")
    steps, odd = [], {k: list[str]() for k in master.checks}
    for cell, k in zip(cells, problems, strict=True):
        steps.append(Step(cell.source if k is None else master.checks[k], k, cell.place))
        if k is not None and _bare(cell.source) != _bare(master.checks[k]):
            odd[k].append("Its check cell was edited; the sheet's own was run in its place.")
    for k, source in master.checks.items():
        count = problems.count(k)
        if count == 0:
            steps.append(Step(source, k))
            odd[k].append("Its check cell was deleted; the sheet's own was run at the end.")
        elif count > 1:
            odd[k].append(f"Its check cell is there {count} times; the last one counts.")
    return Plan(steps, (), {k: told for k, told in odd.items() if told})


def _notebook(content: bytes) -> dict[str, Any]:
    if not content.strip():
        raise Broken("The file is empty. Save the notebook, and hand it in again.")
    if len(content) > LARGEST:
        raise Broken(
            f"The file has {len(content) / 1e6:.0f} MB, and more than {LARGEST / 1e6:.0f} is not read. Clear all outputs, "
            "save, and hand it in again."
        )
    if sum(map(content.count, (b"[", b"{", b","))) > MOST_PARTS:
        raise Broken("The file is JSON of more parts than any notebook has.")
    text = _text(content)
    try:
        found = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Broken(_why(text, content, error)) from error
    if not isinstance(found, dict):
        raise Broken("The file is JSON, but no notebook. Hand in the file that ends in .ipynb.")
    return found


def _text(content: bytes) -> str:
    coding = "utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    try:
        return content.decode(coding)
    except UnicodeDecodeError:
        return content.decode("latin-1")  # the outline of the notebook is plain ASCII; only umlauts may be off


def _why(text: str, content: bytes, error: Exception) -> str:
    if marks := list(CONFLICT.finditer(text)):
        line = text[: marks[0].start()].count("\n") + 1
        return (
            f"A merge left its marks in the file: {len(marks)} lines such as line {line}. Resolve the conflict, and open "
            "the notebook once before you hand it in."
        )
    start = content.lstrip()
    for sign, what in KINDS.items():
        if start.startswith(sign):
            return f"The file is {what}"
    if isinstance(error, RecursionError):
        return "The file nests without end. It is no notebook that an editor wrote."
    if start.startswith(b"{"):
        return f"The notebook is cut off or damaged: {error}. Open it, save it, and hand it in again."
    return "The file is no notebook. Hand in the file that ends in .ipynb, not a script or a text."


def _cell(place: int, cell: Mapping[str, Any]) -> Cell | None:
    if cell.get("cell_type") != "code":
        return None
    source = cell.get("source", cell.get("input", ""))
    lines = source if isinstance(source, list) else [source]
    text = "".join(line for line in lines if isinstance(line, str)).encode(errors="replace").decode()
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    metadata = cell.get("metadata")
    metadata = metadata if isinstance(metadata, dict) else {}
    graded = metadata.get("nbgrader")
    names = [graded.get("grade_id") if isinstance(graded, dict) else None, cell.get("id"), metadata.get("id")]
    return Cell(place, text, next((name for name in names if isinstance(name, str) and name), ""))


def _problem_of(cell: Cell, master: Master) -> int | None:
    """The problem that a cell checks: by its name, or, where an editor lost that, by its source."""
    if _is_check(cell.name) and (k := int(cell.name.removeprefix("check-"))) in master.checks:
        return k
    return next((k for k, source in master.checks.items() if _bare(source) == _bare(cell.source)), None)


def _is_check(name: str) -> bool:
    return re.fullmatch(r"check-\d{1,3}", name) is not None


def _bare(source: str) -> str:
    """The source without blanks and comments, which may change at a touch."""
    return re.sub(r"#.*|\s", "", source)
