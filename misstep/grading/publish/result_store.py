"""The book of results: a file for each student, written whole or not at all, so that a run may be stopped at any moment.

A result is kept under a mark of all that it came from: the notebook, the sheet, the sandbox, and kinlib itself, where the
problems are. The next run asks for results by their marks, and grades what has none.
"""

import fcntl
import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any
from urllib.parse import quote

from misstep.catalog import find_course
from misstep.grading.collect.submission import Master
from misstep.grading.judging.result import ProblemResult, RanCell, Result
from misstep.grading.sandbox.course_stub import setup_for

FORM = 1
"""The version of the files."""

LONGEST = 100
"""No file name is longer before its ending; file systems allow 255 bytes."""


class Busy(RuntimeError):
    """Another run writes into this folder, or it belongs to another sheet."""


def file_name(student: str) -> str:
    """A name for a student's files: readable where the id is, one for each id, and never a path.

    >>> file_name("ada"), file_name("../ö"), file_name("")
    ('ada', '%2E.%2F%C3%B6', '%')
    """
    name = quote(student, safe=" @+,=", errors="surrogatepass")
    name = name.replace(".", "%2E", 1) if name.startswith(".") else name
    if len(name) > LONGEST:
        name = f"{name[: LONGEST - 17]}%{sha256(_encoded(student)).hexdigest()[:16]}"
    return name or "%"


def mark(sheet: Master, is_safe: bool, parts: Sequence[str | bytes | None]) -> str:
    """What stands for all that a result came from."""
    robot = sheet.folder / f"{sheet.name}.json"
    told = [
        _code(sheet.course),
        sheet.name,
        sorted(sheet.checks.items()),
        is_safe,
        robot.read_text("utf-8") if robot.exists() else "",
    ]
    each = [part if part is None else sha256(_encoded(part)).hexdigest() for part in parts]
    return sha256(json.dumps([*told, each]).encode()).hexdigest()


@cache
def _code(reference: str) -> str:
    """A digest of the engine, the course and what it requires: a problem may be changed after the first submissions were graded."""
    setup = setup_for(find_course(reference))
    modules = sorted(file for folder in (*setup.readable, *setup.hidden) for file in Path(folder).rglob("*.py"))
    return sha256(b"\0".join(module.read_bytes() for module in modules)).hexdigest()


def _encoded(part: str | bytes) -> bytes:
    return part if isinstance(part, bytes) else part.encode(errors="surrogatepass")


def write(path: Path, content: str) -> bool:
    """Write a file whole, in one step, and only where it says something new. Whether it did."""
    data = content.encode(errors="replace")
    if path.exists() and path.read_bytes() == data:
        return False
    path.parent.mkdir(parents=True, exist_ok=True)
    half = path.with_name(f".{path.name}.half")
    half.write_bytes(data)
    half.replace(path)
    return True


class Book:
    """The results in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "results"

    def keep(self, result: Result, mark: str) -> None:
        """Write a result down. After this, no end of the program loses it."""
        told = {"form": FORM, "mark": mark, "result": result.data()}
        write(self._path(result.student), json.dumps(told, ensure_ascii=False) + "\n")

    def kept(self, student: str, mark: str | None = None) -> Result | None:
        """The result of a student, if there is one, and if a mark is given, one that bears it."""
        try:
            told = json.loads(self._path(student).read_text("utf-8"))
            if told["form"] != FORM or mark not in {None, told["mark"]} or told["result"]["student"] != student:
                return None
            return _result(told["result"])
        except (OSError, ValueError, KeyError, TypeError):
            return None  # of an older kinlib, or none of ours: it is made anew

    def _path(self, student: str) -> Path:
        return self.folder / f"{file_name(student)}.json"


@contextmanager
def opened(folder: Path, sheet: str) -> Iterator[Book]:
    """The book of a sheet, for one run at a time.

    Raises Busy while another run has it, and where the folder holds the results of another sheet.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / ".lock").open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # the kernel lets go of it when the process ends, however
        except BlockingIOError as error:
            raise Busy(
                f"Another run writes its results into {folder}. Wait for it, or choose another --out."
            ) from error
        for half in folder.rglob(".*.half"):
            half.unlink()
        of = folder / "results" / "sheet.txt"
        if of.exists() and of.read_text("utf-8").strip() != sheet:
            raise Busy(
                f"{folder} holds the results of sheet {of.read_text('utf-8').strip()}. Choose another --out for {sheet}."
            )
        write(of, f"{sheet}\n")
        yield Book(folder)


def _result(told: dict[str, Any]) -> Result:
    problems = [ProblemResult(**problem) for problem in told.pop("problems")]
    cells = [RanCell(**cell) for cell in told.pop("cells")]
    return Result(**told, problems=problems, cells=cells)
