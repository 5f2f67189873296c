"""What a student handed in, read without trust: the answers that check cells have stored in a notebook.

Nothing of a notebook is run. Long outputs are cut out before the JSON is read, so they cost no memory. Each reason why a file
cannot be used is a sentence for the student. Call this in a process that may be ended (`workers`), because bytes can be made
to be slow.
"""

import io
import json
import re
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from misstep import storage as stored
from misstep.grading.collect.submissions import (
    COPY,
    SourceFile,
    Unreadable,
    notebook_name,
    read_bytes,
    read_stream,
    reading,
    zip_time,
)

MAX_NOTEBOOKS = 10
"""How many notebooks of one student are looked at, the newest first."""
STRING = rb'"(?:[^"\\]++|\\.)*+"'
VALUE = rb"""[\[{](?:%b|[^\[\]{}"]++)*+[\]}]""" % STRING
for _ in range(12):  # levels of nesting; what is nested more deeply is read like the rest
    VALUE = rb"""[\[{](?:%b|[^\[\]{}"]++|%b)*+[\]}]""" % (STRING, VALUE)
OUTPUT = re.compile(
    rb'"(?:(?:text|image|audio|video|application(?!/vnd\.misstep\.answer))/[^"\\]*+"\s*+:\s*+(?:%b|%b)|text"\s*+:\s*+%b)'
    % (STRING, VALUE, VALUE),
    re.DOTALL,
)
"""An output of a cell with its MIME type, stored answers excepted, or a list of printed lines. A text cannot look like one,
because its quotes are escaped in JSON."""

MAX_ANSWER = 400_000
MAX_ID = 200
"""The longest stored answer and the longest id, in characters."""

ANSWER_CELL = re.compile(r"answer-(\d{1,3})\n|.*\ngiven = sheet\.given\((\d{1,3})\)")
"""The id of an answer cell in a sheet as it was released, or else how its lines begin."""

HAND_IN = "Hand in the file that ends in .ipynb."
FORMATS = {b"%PDF": "a PDF", b"PK\x03\x04": "a zip archive", b"\x1f\x8b": "a compressed archive", b"<": "a web page"}
"""How the bytes of files begin that are handed in instead of a notebook."""


@dataclass(frozen=True)
class Work:
    """What a notebook stores for one sheet."""

    answers: Mapping[int, tuple[str, str]]  # by problem, the last answer as JSON, and the id for which it was checked
    stale: Sequence[int]  # the problems whose answer cell was run after its check, as far as the execution counts show
    is_sheet: bool  # whether the notebook is of this sheet at all

    @property
    def ids(self) -> list[str]:
        """The ids for which the answers were checked, each once."""
        return list(dict.fromkeys(id_ for _, id_ in self.answers.values()))


@dataclass(frozen=True)
class Chosen:
    """The notebook of a student that counts, its name, remarks, and the ids in all notebooks of the student."""

    work: Work
    name: str
    notes: Sequence[str]
    ids: Sequence[str]


def choose(files: Sequence[SourceFile], sheet: str) -> Chosen:
    """Read the notebooks of one student, and choose the newest one that has answers to a sheet.

    Raises Unreadable if no file is a notebook of the sheet.
    """
    notebooks = sorted((one for file in files if file.is_read or file.fault for one in _unpacked(file)), key=_age)
    if not any(file.name.suffix.lower() == ".ipynb" or file.fault for file, _ in notebooks):
        names = ", ".join(file.name.name for file in files[:5])
        raise Unreadable(f"There is no notebook, only: {names}. {HAND_IN}")
    found: list[tuple[str, Work]] = []
    faults: list[str] = []
    for file, content in notebooks[: -MAX_NOTEBOOKS - 1 : -1]:
        try:
            work = read_work(read_bytes(file) if content is None else content, sheet)
        except Unreadable as error:
            faults.append(f"{file.name.name}: {error}" if len(notebooks) > 1 else str(error))
            continue
        if work.is_sheet:
            found.append((file.name.name, work))
        else:
            faults.append(f"{file.name.name} has no cell of the sheet {sheet}. Was another sheet handed in?")
    if not found:
        raise Unreadable(" ".join(faults[:3]))
    name, work = max(found, key=lambda one: bool(one[1].answers))  # the first of them, which is the newest
    notes = [fault for fault in faults if "could not" in fault]
    if len(found) > 1:
        notes.append(f"Of {len(found)} notebooks of this sheet, {name} counts, the newest with answers.")
    return Chosen(work, name, notes, list(dict.fromkeys(id_ for _, one in found for id_ in one.ids)))


def _age(one: tuple[SourceFile, bytes | None]) -> tuple[float, int, str]:
    """Return what grows with a newer file: a browser calls the newer of two downloads X (1).ipynb."""
    stem = one[0].name.stem
    number = re.search(r"(\d+)\)?$", stem) if COPY.fullmatch(stem) else None
    return one[0].modified, int(number[1][:9]) if number else int(bool(COPY.fullmatch(stem))), str(one[0].name)


def _unpacked(file: SourceFile) -> Iterator[tuple[SourceFile, bytes | None]]:
    """Yield a file itself, or the notebooks in it if it is a zip file, with their content. Nothing is written to the disk."""
    if file.fault or file.name.suffix.lower() != ".zip":
        yield file, None
        return
    try:
        with reading(file.name), zipfile.ZipFile(io.BytesIO(read_bytes(file))) as archive:
            members = [one for one in archive.infolist() if notebook_name(one.filename).suffix.lower() == ".ipynb"]
            members = [one for one in members if not re.search(r"(^|[/\\])(\.|__MACOSX)", one.filename)]
            for member in sorted(members, key=lambda one: one.date_time)[-MAX_NOTEBOOKS:]:
                name = file.name.parent / notebook_name(member.filename.replace("\\", "/")).name
                with archive.open(member) as stream:
                    yield replace(file, name=name, modified=zip_time(member)), read_stream(stream, name)
    except Unreadable as error:
        yield replace(file, fault=str(error)), None


def read_work(content: bytes, sheet: str) -> Work:
    """Read the stored answers to a sheet from the bytes of a notebook.

    Raises Unreadable, with a sentence for the student, if the bytes are no notebook.

    >>> output = {"data": {stored.MIME: {"sheet": "01_x", "problem": 2, "student": "ada", "answer": {"number": 1.5}}}}
    >>> cell = {"cell_type": "code", "source": "sheet.check(2, x)", "outputs": [output]}
    >>> read_work(json.dumps({"cells": [cell]}).encode(), "01_x").answers
    {2: ('{"number": 1.5}', 'ada')}
    """
    answers: dict[int, tuple[str, str]] = {}
    checked, written = dict[int, int](), dict[int, int]()  # when check cells and answer cells ran, by the cells' counts
    is_sheet = False
    for cell in _cells(content):
        if not isinstance(cell, dict) or cell.get("cell_type") != "code":
            continue
        source = "".join(line for line in _list(cell.get("source")) if isinstance(line, str))
        count = count if isinstance(count := cell.get("execution_count"), int) else 0
        found = [one for output in _list(cell.get("outputs")) if (one := _stored(output, sheet))]
        is_sheet = is_sheet or bool(found) or f'"{sheet}"' in source.replace("'", '"')
        for number, text, student in found:
            if count >= checked.get(number, 0):
                answers[number], checked[number] = (text, student), count
        if written_in := ANSWER_CELL.match(f"{cell.get('id')}\n{source}"):
            number = int(written_in[1] or written_in[2])
            written[number] = max(written.get(number, 0), count)
    stale = [number for number, count in checked.items() if 0 < count < written.get(number, 0)]
    return Work(answers, stale, is_sheet)


def _stored(output: Any, sheet: str) -> tuple[int, str, str] | None:
    """Return the problem, the answer as JSON and the id that an output of a check cell stores; None for any other output."""
    match output:
        case {"data": {stored.MIME: {"sheet": name, "problem": int(k), "student": str(id_), "answer": one}}} if (
            name == sheet
        ):
            with suppress(RecursionError):
                if len(text := json.dumps(one)) <= MAX_ANSWER:
                    return k, text, id_[:MAX_ID].encode(errors="replace").decode().strip()
    return None


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def _cells(content: bytes) -> list[Any]:
    """Return the cells of a notebook, or raise Unreadable with the reason why the bytes are none."""
    start = content.lstrip()
    try:
        notebook = json.loads(OUTPUT.sub(b'"cut":0', content).decode("utf-8-sig", errors="replace"))
    except RecursionError as error:
        raise Unreadable("The JSON is nested too deeply to be a notebook.") from error
    except ValueError as error:
        if start.startswith(b"{"):
            text = f"The notebook is cut off or damaged: {error}. Open it, save it, and hand it in again."
            raise Unreadable(text) from error
        formats = (name for signature, name in FORMATS.items() if start.startswith(signature))
        what = next(formats, "not a notebook" if start else "empty")
        raise Unreadable(f"The file is {what}. {HAND_IN}") from error
    match notebook:
        case {"cells": list(cells)}:
            return cells
    raise Unreadable(f"The file is JSON but not a notebook: it has no cells. {HAND_IN}")
