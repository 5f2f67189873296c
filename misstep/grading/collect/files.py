"""Files that somebody handed in, in a folder or a zip, read without trust and never unpacked.

A link is not followed, a pipe is not opened, a member of a zip that says it lies outside is not believed, and nothing is
read beyond what a notebook may have. Each of these is a fault with a sentence, which becomes a student's reason.
"""

import lzma
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Protocol

from misstep.grading.collect.submission import LARGEST

MOST_FILES = 100_000
"""A download of more files than that is none of a course."""

DAMAGED = (
    *(zipfile.BadZipFile, zlib.error, lzma.LZMAError, struct.error),
    *(NotImplementedError, RuntimeError, ValueError, EOFError, OSError),
)
"""What comes of a zip whose bytes were changed, depending on which."""

SKIPPED = ("__MACOSX", "Thumbs.db", "desktop.ini")


class Refused(ValueError):
    """This file is not read. The message says why, to the student."""


class Read(Protocol):
    """Gives the bytes of a file, or raises Refused."""

    def __call__(self) -> bytes: ...


@dataclass(frozen=True)
class File:
    """A file: its path below the folder or in the archive, when it was changed (any scale), and how to read it.

    is_there  False for what stands in an empty folder: somebody is known who handed nothing in
    """

    path: PurePosixPath
    changed: float
    read: Read
    is_there: bool = True

    @property
    def is_notebook(self) -> bool:
        """Whether its name ends as that of a notebook."""
        return self.path.suffix.lower() == ".ipynb"


def files(source: Path) -> list[File]:
    """Every file of a folder, or of a zip, in the order of paths. Hidden ones, and those of file managers, are left out.

    Raises ValueError for what is neither, and for a zip that cannot be read at all.
    """
    if source.is_dir():
        found = _of_folder(source)
    elif zipfile.is_zipfile(source):
        found = _of_zip(source)
    else:
        raise ValueError(f"{source} is neither a folder nor a zip. Give what holds the submissions.")
    return sorted((file for file in found if not _is_skipped(file.path)), key=lambda file: file.path)


def _is_skipped(path: PurePosixPath) -> bool:
    return any(part.startswith(".") or part in SKIPPED for part in path.parts)


def _of_folder(folder: Path) -> Iterator[File]:
    count = 0
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        below = PurePosixPath(Path(place).relative_to(folder))
        count += len(names)
        if count > MOST_FILES:
            raise ValueError(f"{folder} holds more than {MOST_FILES} files. Give the folder of the submissions alone.")
        for name in names:
            path = Path(place, name)
            yield File(below / name, path.lstat().st_mtime, partial(_read, path))
        for name in folders:
            if (path := Path(place, name)).is_symlink():
                yield File(below / name / name, 0.0, partial(_read, path))
        if not names and not folders and below.parts:
            yield File(below / "nothing", 0.0, bytes, is_there=False)


def _read(path: Path) -> bytes:
    """Read a plain file. What is looked at is what was opened: nobody swaps it in between."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError as error:
        if path.is_symlink():
            raise Refused(
                f"{path.name} is a link to another place, not a file. Hand in the notebook itself."
            ) from error
        raise Refused(f"{path.name} could not be opened: {error.strerror}.") from error
    with os.fdopen(descriptor, "rb") as stream:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise Refused(f"{path.name} is no plain file. Hand in the notebook itself.")
        return stream.read(LARGEST + 1)


def _of_zip(source: Path) -> Iterator[File]:
    try:
        archive = zipfile.ZipFile(source)  # open as long as its files are: each is read when its turn comes
    except DAMAGED as error:
        raise ValueError(f"{source} is damaged: {error}. Download it again.") from error
    members = [member for member in archive.infolist() if not member.is_dir()]
    if len(members) > MOST_FILES:
        raise ValueError(f"{source} holds more than {MOST_FILES} files. Is it the download of one sheet?")
    for member in members:
        steps = member.filename.replace("\\", "/").split("/")
        inside = [step for step in steps if step not in {"", ".", ".."} and not step.endswith(":")]
        if inside:
            when = float("".join(f"{number:04}" for number in member.date_time))
            yield File(PurePosixPath(*inside), when, partial(_unpacked, archive, member, inside == steps))


def _unpacked(archive: zipfile.ZipFile, member: zipfile.ZipInfo, is_inside: bool) -> bytes:
    name = PurePosixPath(member.filename).name
    if not is_inside:
        raise Refused(f"The path of {name} leads out of its archive. Hand in the notebook itself.")
    if stat.S_ISLNK(member.external_attr >> 16):
        raise Refused(f"{name} is a link to another place, not a file. Hand in the notebook itself.")
    if member.file_size > LARGEST:
        raise Refused(
            f"{name} unpacks to {member.file_size / 1e6:.0f} MB, and more than {LARGEST / 1e6:.0f} is not read."
        )
    try:
        with archive.open(member) as stream:
            return stream.read(LARGEST + 1)
    except DAMAGED as error:
        raise Refused(f"{name} is damaged or locked in its archive: {error}.") from error


def named(found: Sequence[File]) -> str:
    """Some files by their names, for a sentence."""
    names = [file.path.name for file in found]
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
