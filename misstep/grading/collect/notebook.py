"""Notebooks that students submit: their code cells, read without trust and without nbformat, in whatever state they are.

A notebook may have been edited in Colab or VS Code, may have Windows line ends, and may be damaged. Each reason why a file
cannot be used is a sentence for the student.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

MAX_NOTEBOOK_BYTES = 32 << 20
"""The largest notebook that is read, in bytes, with all its outputs."""

MAX_CELLS = 1000

MAX_JSON_PARTS = 500_000
"""The most brackets and commas that a notebook may have. An empty list takes two bytes in the file and sixty in memory."""

CONFLICT_MARKER = re.compile(r"^(<{7} |={7}$|>{7} )", re.MULTILINE)

OTHER_FORMATS = {
    b"%PDF": "a PDF. Hand in the notebook itself, the file that ends in .ipynb.",
    b"PK\x03\x04": "a zip archive. Hand in the notebook itself, the file that ends in .ipynb.",
    b"\x1f\x8b": "a compressed archive. Hand in the notebook itself, the file that ends in .ipynb.",
    b"<": "a web page. Hand in the notebook itself, the file that ends in .ipynb, not its export.",
}


class UnusableNotebook(ValueError):
    """The file contains nothing that can be run. The message is for the student."""


@dataclass(frozen=True)
class CodeCell:
    """A code cell of a notebook: its index among all cells, its source, and the name that nbgrader gave it.

    count  its execution count, by which editors number the cells in the order in which they ran; 0 if there is none
    """

    index: int
    source: str
    name: str = ""
    count: int = 0


def code_cells(content: bytes) -> list[CodeCell]:
    """The code cells of a notebook.

    Raises UnusableNotebook, with a sentence for the student, if the file is not a notebook.
    """
    cells = _parse(content).get("cells")
    if not isinstance(cells, list):
        raise UnusableNotebook(
            "The file is JSON but not a notebook, because it has no cells. Hand in the file that ends in .ipynb."
        )
    if len(cells) > MAX_CELLS:
        raise UnusableNotebook(f"The notebook has {len(cells)} cells; a sheet has at most {MAX_CELLS}.")
    parsed = (_code_cell(index, cell) for index, cell in enumerate(cells) if isinstance(cell, dict))
    return [cell for cell in parsed if cell]


def _parse(content: bytes) -> dict[str, Any]:
    if not content.strip():
        raise UnusableNotebook("The file is empty. Save the notebook, and hand it in again.")
    if len(content) > MAX_NOTEBOOK_BYTES:
        raise UnusableNotebook(
            f"The file is larger than {MAX_NOTEBOOK_BYTES / 1e6:.0f} MB, and so it is not read. Clear all outputs, save, and "
            "hand it in again."
        )
    if sum(map(content.count, (b"[", b"{", b","))) > MAX_JSON_PARTS:
        raise UnusableNotebook("The JSON has more parts than any notebook of this course.")
    text = _decode(content)
    try:
        notebook = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UnusableNotebook(_explain(text, content, error)) from error
    if not isinstance(notebook, dict):
        raise UnusableNotebook("The file is JSON but not a notebook. Hand in the file that ends in .ipynb.")
    return notebook


def _decode(content: bytes) -> str:
    encoding = "utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError:
        return content.decode("latin-1")  # the structure of a notebook is ASCII, so at most some letters are wrong


def _explain(text: str, content: bytes, error: Exception) -> str:
    """Why the text is not JSON, in a sentence for the student."""
    if markers := list(CONFLICT_MARKER.finditer(text)):
        line = text[: markers[0].start()].count("\n") + 1
        return (
            f"The file contains an unresolved merge conflict: {len(markers)} marker lines, the first is line {line}. "
            "Resolve the conflict, and open the notebook once before you hand it in."
        )
    start = content.lstrip()
    for signature, description in OTHER_FORMATS.items():
        if start.startswith(signature):
            return f"The file is {description}"
    if isinstance(error, RecursionError):
        return "The JSON is nested too deeply to be a notebook."
    if start.startswith(b"{"):
        return f"The notebook is cut off or damaged: {error}. Open it, save it, and hand it in again."
    return "The file is not a notebook. Hand in the file that ends in .ipynb, not a script or a text."


def _code_cell(index: int, cell: Mapping[str, Any]) -> CodeCell | None:
    if cell.get("cell_type") != "code":
        return None
    source = cell.get("source", "")
    lines = source if isinstance(source, list) else [source]
    text = "".join(line for line in lines if isinstance(line, str)).encode(errors="replace").decode()
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    metadata = cell.get("metadata")
    metadata = metadata if isinstance(metadata, dict) else {}
    nbgrader = metadata.get("nbgrader")
    names = [nbgrader.get("grade_id") if isinstance(nbgrader, dict) else None, cell.get("id"), metadata.get("id")]
    count = cell.get("execution_count")
    return CodeCell(
        index,
        text,
        next((name for name in names if isinstance(name, str) and name), ""),
        count if isinstance(count, int) else 0,
    )
