"""Submitted files, in a folder or in a zip file, read without trust and without unpacking the zip file.

Links are not followed, pipes are not opened, zip members with a path outside of the archive are refused, and no more is
read of a file than a notebook may have. Each of these faults is a sentence for the student.
"""

import lzma
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath

from misstep.grading.collect.notebook import MAX_NOTEBOOK_BYTES

MAX_FILES = 100_000
"""The most files that the download of a sheet may have."""

ARCHIVE_ERRORS = (
    *(zipfile.BadZipFile, zlib.error, lzma.LZMAError, struct.error),
    *(NotImplementedError, RuntimeError, ValueError, EOFError, OSError),
)
"""The errors that zipfile raises for damaged archives, depending on which bytes are wrong."""

MAX_NAME_CHARACTERS = 255
"""The longest name of a file or folder, as in file systems; members of a zip file could have longer ones."""

SKIPPED_NAMES = ("__MACOSX", "Thumbs.db", "desktop.ini")

MAX_MB = f"{MAX_NOTEBOOK_BYTES / 1e6:.0f} MB"


class UnreadableFile(ValueError):
    """This file is not read. The message is for the student."""


@dataclass(frozen=True)
class File:
    """A file: its path below the folder or in the archive, and when it was modified (any scale).

    read    returns its bytes, or raises UnreadableFile
    exists  False for the placeholder of an empty folder: its student is known, but submitted nothing
    """

    path: PurePosixPath
    modified: float
    read: Callable[[], bytes]
    exists: bool = True

    @property
    def is_notebook(self) -> bool:
        """Whether its name ends like that of a notebook."""
        return self.path.suffix.lower() == ".ipynb"


def list_files(source: Path) -> list[File]:
    """Every file of a folder or of a zip file, ordered by path. Hidden files and those of file managers are left out.

    Raises ValueError if the source is neither a folder nor a zip file, and for a zip file that cannot be read at all.
    """
    if source.is_dir():
        files = _files_of_folder(source)
    elif zipfile.is_zipfile(source):
        files = _files_of_zip(source)
    else:
        raise ValueError(
            f"{source} is neither a folder nor a zip file. Give the folder or the zip file of the submissions."
        )
    return sorted((file for file in files if not _is_skipped(file.path)), key=lambda file: file.path)


def _is_skipped(path: PurePosixPath) -> bool:
    return any(part.startswith(".") or part in SKIPPED_NAMES or len(part) > MAX_NAME_CHARACTERS for part in path.parts)


def _files_of_folder(folder: Path) -> Iterator[File]:
    count = 0
    for current, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        relative = PurePosixPath(Path(current).relative_to(folder))
        count += len(names)
        if count > MAX_FILES:
            raise ValueError(
                f"{folder} has more than {MAX_FILES} files. Give the folder that has only the submissions."
            )
        for name in names:
            path = Path(current, name)
            yield File(relative / name, path.lstat().st_mtime, partial(_read, path))
        for name in folders:
            if (path := Path(current, name)).is_symlink():
                yield File(relative / name / name, 0.0, partial(_read, path))
        if not names and not folders and relative.parts:
            yield File(relative / "nothing", 0.0, bytes, exists=False)


def _read(path: Path) -> bytes:
    """Read a regular file. The type is checked on the open file, so that it cannot be replaced between check and read."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError as error:
        if path.is_symlink():
            raise UnreadableFile(
                f"{path.name} is a link to another place, not a file. Hand in the notebook itself."
            ) from error
        raise UnreadableFile(f"{path.name} could not be opened: {error.strerror}.") from error
    with os.fdopen(descriptor, "rb") as stream:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise UnreadableFile(f"{path.name} is not a regular file. Hand in the notebook itself.")
        return stream.read(MAX_NOTEBOOK_BYTES + 1)


def _files_of_zip(source: Path) -> Iterator[File]:
    try:
        archive = zipfile.ZipFile(
            source
        )  # it stays open while its files exist, and each file is read when it is needed
    except ARCHIVE_ERRORS as error:
        raise ValueError(f"{source} is damaged: {error}. Download it again.") from error
    members = [member for member in archive.infolist() if not member.is_dir()]
    if len(members) > MAX_FILES:
        raise ValueError(f"{source} has more than {MAX_FILES} files. Is it the download of one sheet?")
    for member in members:
        parts = member.filename.replace("\\", "/").split("/")
        safe_parts = [part for part in parts if part not in {"", ".", ".."} and not part.endswith(":")]
        if safe_parts:
            modified = float("".join(f"{number:04}" for number in member.date_time))
            read = partial(_read_member, archive, member, safe_parts == parts)
            yield File(PurePosixPath(*safe_parts), modified, read)


def _read_member(archive: zipfile.ZipFile, member: zipfile.ZipInfo, is_inside: bool) -> bytes:
    name = PurePosixPath(member.filename).name
    if not is_inside:
        raise UnreadableFile(f"The path of {name} leads out of its archive. Hand in the notebook itself.")
    if stat.S_ISLNK(member.external_attr >> 16):
        raise UnreadableFile(f"{name} is a link to another place, not a file. Hand in the notebook itself.")
    if member.file_size > MAX_NOTEBOOK_BYTES:
        raise UnreadableFile(f"{name} unpacks to {member.file_size / 1e6:.0f} MB; at most {MAX_MB} are read.")
    try:
        with archive.open(member) as stream:
            return stream.read(MAX_NOTEBOOK_BYTES + 1)
    except ARCHIVE_ERRORS as error:
        raise UnreadableFile(f"{name} is damaged or encrypted in its archive: {error}.") from error


def list_names(files: Sequence[File]) -> str:
    """The names of some files, for a sentence; of many, the first five."""
    names = [file.path.name for file in files]
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
