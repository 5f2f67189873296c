"""The result store: a file for each student, written completely or not at all, so that grading can be stopped at any moment.

A result is stored with its fingerprint. The next run asks for results by their fingerprints, and grades only what has none.
"""

import fcntl
import json
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from urllib.parse import quote

from misstep.grading.judging.result import Result

MAX_NAME_LENGTH = 100
"""The longest file name without its ending; file systems allow 255 bytes."""


class FolderInUse(RuntimeError):
    """Another run writes into this folder, or it has the results of another sheet."""


def file_name(student: str) -> str:
    """A file name for a student: readable if the id is, different for each id, and never a path.

    >>> file_name("ada"), file_name("../ö"), file_name("")
    ('ada', '%2E.%2F%C3%B6', '%')
    """
    name = quote(student, safe=" @+,=", errors="surrogatepass")
    name = name.replace(".", "%2E", 1) if name.startswith(".") else name
    if len(name) > MAX_NAME_LENGTH:
        name = f"{name[: MAX_NAME_LENGTH - 17]}%{sha256(student.encode(errors='surrogatepass')).hexdigest()[:16]}"
    return name or "%"


def write_if_changed(path: Path, content: str) -> bool:
    """Write a file in one step, and only if its content changes. Returns whether it was written."""
    data = content.encode(errors="replace")
    if path.exists() and path.read_bytes() == data:
        return False
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.partial")
    partial.write_bytes(data)
    partial.replace(path)
    return True


class ResultStore:
    """The results in a folder, one file for each student."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "results"

    def save(self, result: Result, fingerprint: str) -> None:
        """Store a result. After this call it is not lost, however the program ends."""
        record = {"fingerprint": fingerprint, "result": result.to_dict()}
        write_if_changed(self._path(result.student), json.dumps(record, ensure_ascii=False) + "\n")

    def load(self, student: str, fingerprint: str | None = None) -> Result | None:
        """The result of a student; None if there is none, or, if a fingerprint is given, if it has another one."""
        try:
            record = json.loads(self._path(student).read_text("utf-8"))
            is_current = fingerprint in {None, record["fingerprint"]} and record["result"]["student"] == student
            return Result.from_dict(record["result"]) if is_current else None
        except (OSError, ValueError, KeyError, TypeError):
            return None  # an older version, or not one of these files: the submission is graded again

    def _path(self, student: str) -> Path:
        return self.folder / f"{file_name(student)}.json"


def stored_results(folder: Path) -> Iterator[Result]:
    """The results of all students in a folder, in the order of the file names. Files of older versions are left out."""
    store = ResultStore(folder)
    for path in sorted(store.folder.glob("*.json")):
        with suppress(ValueError, KeyError, TypeError):
            if result := store.load(json.loads(path.read_text("utf-8"))["result"]["student"]):
                yield result


@contextmanager
def open_results(folder: Path, sheet: str) -> Iterator[ResultStore]:
    """The result store of a sheet, for one run at a time.

    Raises FolderInUse while another run uses the folder, and if the folder has the results of another sheet.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / ".lock").open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # the kernel releases it when the process ends
        except BlockingIOError as error:
            raise FolderInUse(
                f"Another run writes its results into {folder}. Wait for it to end, or choose another --out."
            ) from error
        for partial in folder.rglob(".*.partial"):
            partial.unlink()
        owner = folder / "results" / "sheet.txt"
        if owner.exists() and owner.read_text("utf-8").strip() != sheet:
            raise FolderInUse(
                f"{folder} has the results of sheet {owner.read_text('utf-8').strip()}. Choose another --out for {sheet}."
            )
        write_if_changed(owner, f"{sheet}\n")
        yield ResultStore(folder)
