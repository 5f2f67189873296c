"""Submissions: which files are whose, in folders as people nest them and in the downloads of learning platforms.

folder      ada/anything.ipynb, ada.ipynb, section/ada/anything.ipynb, ada.zip
nbgrader    ada/<sheet>/<sheet>.ipynb, the folder submitted/ of an nbgrader course
Canvas      lovelaceada_[LATE_]1815_99_<sheet>.ipynb                 1815 is the ID of Canvas's gradebook
Moodle      Ada Lovelace_1815_assignsubmission_file_/<sheet>.ipynb   1815 is "Participant 1815" of the worksheet
Gradescope  submission_99/<sheet>.ipynb, and submission_metadata.yml lists the students of submission 99

What a student wrote, the content of a student's zip file included, is read by `notebook`.
"""

import os
import re
import stat
import unicodedata
import zipfile
import zlib
from calendar import timegm
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath
from typing import IO

from misstep.grading.collect.roster import Roster

CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<key>\d+)_\d+_(?P<file>.+)")
MOODLE = re.compile(r"(?P<name>.+)_(?P<key>\d+)_assignsubmission_[a-z]+_?(?P<file>.*)", re.DOTALL)
GRADESCOPE = "submission_metadata.yml"
COPY = re.compile(r"(.*?)[-_ ]*(?:\(\d+\)|copy\s*\d*|kopie\s*\d*)", re.IGNORECASE)
"""A name that a browser, an editor or a person has made from another one."""

SKIPPED = re.compile(r"\.|(?:__MACOSX|Thumbs\.db|desktop\.ini)$")
MAX_BYTES = 500_000_000
"""The largest file that is read, with all its outputs."""
ARCHIVE_ERRORS = (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, ValueError, EOFError, OSError)
"""The errors that zipfile raises for damaged archives, depending on which bytes are wrong."""


class Unreadable(Exception):
    """This file cannot be read. The message is for the student."""


@dataclass(frozen=True)
class SourceFile:
    """A file of a student, or a member of a zip file."""

    name: PurePosixPath  # below the folder of submissions
    path: Path
    member: str = ""  # if the path is a zip file, the member that is meant
    modified: float = 0.0  # in seconds
    fault: str = ""  # why it cannot be read, as far as this is seen without opening it

    @property
    def is_read(self) -> bool:
        """Whether a sheet may be in it."""
        return self.name.suffix.lower() in (".ipynb", ".zip")


@dataclass(frozen=True)
class Submission:
    """What one student handed in."""

    student: str  # the id, or without a roster the name of the folder, or the one that the platform gives
    id: str  # that the student should have typed; "" if nobody knows it
    files: Sequence[SourceFile] = ()


@dataclass(frozen=True)
class Gathered:
    """The submissions of a class, ordered by student, the platform of a download, and remarks for the instructor."""

    platform: str  # canvas, moodle, gradescope; "" for a folder of your own
    submissions: Sequence[Submission]
    remarks: Sequence[str] = ()


def gather(source: Path, sheet: str, roster: Roster | None = None) -> Gathered:
    """Find what each student handed in: every student of the roster gets a submission, if only an empty one.

    Raises ValueError if there are no files.
    """
    files = [file for file in list_files(source) if not any(map(SKIPPED.match, file.name.parts))]
    if not files:
        raise ValueError(
            f"{source} contains no submission. Give the folder, or the zip file, of one sheet's submissions."
        )
    platform, owned = _by_owner(files, sheet, roster)
    remarks: list[str] = []
    found: dict[str, Submission] = {}
    for (name, key), own in owned.items():
        id_ = (roster.by_key if key else roster.by_id).get((key or name).casefold()) if roster else None
        if id_ == "":
            remarks.append(f"Left out, because it is the platform's test student: {name}.")
            continue
        student = id_ or (f"{name}_{key}" if key and key != name else name)
        known = found.get(student, Submission(student, id_ or ("" if key or not _without(sheet, name) else name)))
        found[student] = replace(known, files=[*known.files, *own])
    if roster:
        ids = [*roster.by_id.values()]
        if unlisted := sorted(set(found) - set(ids)):
            remarks.append(f"Not in the roster, and so not in the file for the platform: {', '.join(unlisted)}.")
        found = {id_: Submission(id_, id_) for id_ in ids} | found
    elif platform:
        remarks.append(f"There is no --roster with the ids of {platform.capitalize()}, so those that were typed count.")
    ordered = sorted(found.values(), key=lambda one: (one.student.casefold(), one.student))
    return Gathered(platform, ordered, remarks)


# --- files ---


def list_files(source: Path) -> list[SourceFile]:
    """List every file of a folder or of a zip file; links, pipes and folders that cannot be read are listed with their fault.

    Raises ValueError for a source that does not exist, and for a zip file that is damaged.
    """
    files: list[SourceFile] = []

    def add(path: Path, modified: float = 0.0, fault: str = "") -> None:
        files.append(SourceFile(notebook_name(path.relative_to(source).as_posix()), path, "", modified, fault))

    def refused(error: OSError) -> None:
        add(Path(error.filename, "folder"), fault=f"The folder cannot be read: {error.strerror}.")

    if source.is_file() and source.suffix.lower() == ".ipynb":
        return [SourceFile(PurePosixPath(source.name), source, modified=source.stat().st_mtime)]
    if source.is_file() and zipfile.is_zipfile(source):
        return _members(source)
    if not source.is_dir():
        raise ValueError(f"{source} must be a folder, a zip file or a notebook. Check the path.")
    for current, folders, names in os.walk(source, onerror=refused):
        for path in (Path(current, name) for name in [*names, *folders]):
            status = path.lstat()
            if stat.S_ISREG(status.st_mode):
                add(path, status.st_mtime)
            elif not stat.S_ISDIR(status.st_mode):
                add(path, fault=f"{path.name} is a link, or no regular file. Hand in the notebook itself.")
        if not names and not folders and current != str(source):
            add(Path(current, "folder"), fault="The folder is empty.")
    read = [file for file in files if file.is_read and not file.fault]
    if len(read) == 1 and zipfile.is_zipfile(read[0].path):  # a folder that was made for the download of a platform
        members = _members(read[0].path)
        if any(GRADESCOPE in one.name.parts or MOODLE.fullmatch(one.name.parts[0]) for one in members) or (
            len(members) > 1 and all(CANVAS.fullmatch(one.name.name) for one in members)
        ):
            return members
    return sorted(files, key=lambda file: file.name)


def _members(path: Path) -> list[SourceFile]:
    try:
        with zipfile.ZipFile(path) as archive:
            members = archive.infolist()
    except ARCHIVE_ERRORS as error:
        raise ValueError(f"{path} is damaged: {error}. Download it again.") from error
    files = []
    for member in members:
        parts = [part for part in member.filename.replace("\\", "/").split("/") if part not in ("", ".", "..")]
        if parts and not member.is_dir():
            files.append(SourceFile(notebook_name("/".join(parts)), path, member.filename, zip_time(member)))
    return sorted(files, key=lambda file: file.name)


def notebook_name(name: str) -> PurePosixPath:
    """Return x.ipynb for x.ipynb.txt and x.ipynb.json, as some browsers save it, and every other name as it is."""
    return PurePosixPath(re.sub(r"(\.ipynb)\.(txt|json)$", r"\1", name, flags=re.IGNORECASE))


def zip_time(member: zipfile.ZipInfo) -> float:
    """Return when a member of a zip file was modified, on the scale of the times of files."""
    try:
        return float(timegm((*member.date_time, 0, 0, 0)))
    except ValueError:  # a month 0
        return 0.0


@contextmanager
def reading(name: PurePosixPath) -> Iterator[None]:
    """Raise Unreadable, with a sentence for the student, for each error of files and of archives."""
    try:
        yield
    except (*ARCHIVE_ERRORS, KeyError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error) or type(error).__name__
        raise Unreadable(f"{name.name} could not be read: {reason}.") from error


def read_bytes(file: SourceFile) -> bytes:
    """Return the content of a file. Raises Unreadable for one that cannot be read, or is larger than MAX_BYTES."""
    if file.fault:
        raise Unreadable(file.fault)
    with reading(file.name):
        if not file.member:
            with file.path.open("rb") as stream:
                return read_stream(stream, file.name)
        with zipfile.ZipFile(file.path) as archive, archive.open(file.member) as stream:
            return read_stream(stream, file.name)


def read_stream(stream: IO[bytes], name: PurePosixPath) -> bytes:
    """Return the content of an open file. Raises Unreadable if it is larger than MAX_BYTES."""
    content = stream.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise Unreadable(f"{name.name} has over {MAX_BYTES / 1e6:g} MB. Clear all outputs, run all cells, and save.")
    return content


# --- owners ---

Owned = dict[tuple[str, str], list[SourceFile]]
"""Files by the name of the student, and the key by which a platform's roster knows the student, "" in a folder of your own."""


def _by_owner(files: Sequence[SourceFile], sheet: str, roster: Roster | None) -> tuple[str, Owned]:
    metadata = next((file for file in files if file.name.name == GRADESCOPE), None)
    if metadata and all(file.name.is_relative_to(metadata.name.parent) for file in files):  # not one of a student
        return "gradescope", _gradescope(files, metadata)
    owned: Owned = {}
    for platform, pattern, enough in (("moodle", MOODLE, any), ("canvas", CANVAS, all)):
        matches = {file: next(filter(None, map(pattern.fullmatch, file.name.parts)), None) for file in files}
        wanted = [match for file, match in matches.items() if file.is_read]
        if wanted and enough(wanted):
            for file, match in matches.items():
                if match:
                    owned.setdefault((_normal(match["name"]), match["key"]), []).append(file)
            return platform, owned
    is_nbgrader = any(len(file.name.parts) > 2 and file.name.parts[-2] == sheet for file in files)
    level = _level([file for file in files if not _listed(file, sheet, roster)], sheet)
    for file in files:
        if name := _listed(file, sheet, roster) or _owner(file, sheet, level):
            # A student with a folder of nbgrader, but none for this sheet, handed nothing in.
            is_other = is_nbgrader and file.name.parent.name not in (sheet, name)
            owned.setdefault((name, ""), []).extend([] if is_other else [file])
    for name, key in list(owned):
        if (copy := COPY.fullmatch(name)) and (copy[1], "") in owned:
            owned[copy[1], ""] += owned.pop((name, key))
    return "", owned


def _normal(name: str) -> str:
    """Return a name as it is compared: a Mac takes accents apart, and old zip files have bytes that are no letters."""
    return unicodedata.normalize("NFC", name.encode(errors="replace").decode().strip())


def _folders(file: SourceFile, sheet: str) -> tuple[str, ...]:
    parts = file.name.parts[:-1]
    return parts[:-1] if len(parts) > 1 and parts[-1] == sheet else parts


def _level(files: Sequence[SourceFile], sheet: str) -> int:
    """Return how deep the folders of students are: where most files of sheets are, or higher if names repeat there."""
    folders = [_folders(file, sheet) for file in files if file.is_read or file.fault]
    depths = Counter(map(len, folders))
    level = max(depths, key=lambda depth: (depths[depth], -depth), default=1)
    while level > 1:
        paths = {folder[:level] for folder in folders if len(folder) >= level}
        if len(paths) == 1 or 2 * len({path[-1] for path in paths}) > len(paths):
            break
        level -= 1
    return max(level, 1)


def _stem(file: SourceFile, sheet: str) -> str:
    """Return the name of a file without its ending and the name of the sheet; "" for one that holds no sheet."""
    return _without(sheet, file.name.stem) if file.is_read else ""


def _without(sheet: str, name: str) -> str:
    """Return a name without that of the sheet; "" if it is that of the sheet or of a copy of it, and so of nobody."""
    copy = COPY.fullmatch(name)
    is_sheet = sheet in (name, copy and copy[1])
    return "" if is_sheet else re.sub(rf"^{re.escape(sheet)}[-_ ]+|[-_ ]+{re.escape(sheet)}$", "", name)


def _listed(file: SourceFile, sheet: str, roster: Roster | None) -> str:
    """Return the id of a roster that is in the path of a file, "" if there is none."""
    names = [_stem(file, sheet), *reversed(_folders(file, sheet))]
    return next(filter(None, (roster.by_id.get(_normal(name).casefold()) for name in names)), "") if roster else ""


def _owner(file: SourceFile, sheet: str, level: int) -> str:
    """Return the name of the student to whom a file belongs in a folder of your own; "" for a list or a note of yours."""
    names = _folders(file, sheet)
    if len(names) < level:
        if not (file.is_read or file.fault):
            return ""
        names = (*names, *filter(None, [_stem(file, sheet)])) or (file.name.stem,)
    return _normal(names[min(level, len(names)) - 1])


def _gradescope(files: Sequence[SourceFile], metadata: SourceFile) -> Owned:
    import yaml  # here, because only a download of Gradescope has such a file

    owned: Owned = {}
    depth = len(metadata.name.parts) - 1
    try:
        # The base loader makes only texts, lists and mappings: 007 stays 007, and Ruby's own objects are not built.
        records = yaml.load(read_bytes(metadata).decode(), yaml.BaseLoader)  # noqa: S506
        for submission, record in records.items():
            for person in record[":submitters"]:
                key, name = person.get(":sid") or person.get(":email") or submission, person.get(":name")
                own = [file for file in files if file.name.parts[depth : depth + 1] == (submission,)]
                owned[(name or key) if key == submission else key, key] = own
    except (yaml.YAMLError, Unreadable, ValueError, RecursionError, KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"{GRADESCOPE} must list the submissions: {error!r}. Download them again.") from error
    return owned
