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
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath
from typing import Any

from misstep.grading.collect.roster import Roster

CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<key>\d+)_\d+_(?P<file>.+)")
MOODLE = re.compile(r"(?P<name>.+)_(?P<key>\d+)_assignsubmission_[a-z]+_?(?P<file>.*)", re.DOTALL)
GRADESCOPE = "submission_metadata.yml"
COPY = re.compile(r"(.*?)[-_ ]*(?:\(\d+\)|copy\s*\d*|kopie\s*\d*)", re.IGNORECASE)
"""A name that a browser, an editor or a person has made from another one."""

SKIPPED = re.compile(r"\.|(?:__MACOSX|Thumbs\.db|desktop\.ini)$")
MAX_FILES = 100_000
MAX_BYTES = 500_000_000
"""The largest file that is read, with all its outputs."""
ARCHIVE_ERRORS = (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, ValueError, EOFError, OSError)
"""The errors that zipfile raises for damaged archives, depending on which bytes are wrong."""


class Unreadable(ValueError):
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
    """The submissions of a class, ordered by student, the kind of folder or download, and remarks for the instructor."""

    kind: str
    submissions: Sequence[Submission]
    remarks: Sequence[str] = ()


def gather(source: Path, sheet: str, roster: Roster | None = None) -> Gathered:
    """Find what each student handed in: every student of the roster gets a submission, if only an empty one.

    Raises ValueError if there are no files, and if more than half of the students are not in the roster.
    """
    files = [file for file in list_files(source) if not any(map(SKIPPED.match, file.name.parts))]
    if not files:
        raise ValueError(f"{source} contains no submission. Give the folder, or the zip file, of the submissions.")
    kind, owned = _by_owner(files, sheet, roster)
    tests = sorted({owner for owner in owned if roster and owner[1] and owner[1] in roster.test_keys})
    found: dict[str, Submission] = {}
    for (name, key), own in owned.items():
        if (name, key) in tests:
            continue
        id_ = (roster.id_for_key(key) if key else roster.spelled(name)) if roster else None
        student = id_ or (f"{name}_{key}" if key and key != name else name)
        known = found.setdefault(student, Submission(student, id_ or ("" if key else name)))
        found[student] = replace(known, files=[*known.files, *own])
    remarks = [f"Left out, because it is the platform's test student: {name}." for name, _ in tests]
    if roster:
        remarks += _compare(roster, kind, found)
        for id_ in roster.ids:
            found.setdefault(id_, Submission(id_, id_))
    elif kind in ("canvas", "moodle", "gradescope"):
        remarks.append(f"There is no --roster with the ids of this download from {kind.capitalize()}: typed ids count.")
    return Gathered(kind, sorted(found.values(), key=lambda one: (one.student.casefold(), one.student)), remarks)


def _compare(roster: Roster, kind: str, found: Mapping[str, Submission]) -> list[str]:
    unlisted = sorted(set(found) - set(roster.ids))
    if 2 * len(unlisted) > len(found):
        column = roster.columns[roster.key_column if kind == roster.kind else roster.id_column]
        raise ValueError(
            f"{len(unlisted)} of {len(found)} submissions are not in the roster, for example {', '.join(unlisted[:3])}. Its "
            f"column {column!r} has, for example, {', '.join(roster.ids[:3])}. Is it the list of this course, from the same "
            "platform as the submissions?"
        )
    return [
        f"Not in the roster, and so not in the file for the platform: {one}." for one in [", ".join(unlisted)] if one
    ]


# --- files ---


def list_files(source: Path) -> list[SourceFile]:
    """List every file of a folder or of a zip file; links, pipes and folders that cannot be read are listed with their fault.

    Raises ValueError for a source that does not exist, and for a zip file that is damaged.
    """
    if source.is_file() and source.suffix.lower() == ".ipynb":
        return [SourceFile(PurePosixPath(source.name), source, modified=source.stat().st_mtime)]
    if source.is_file() and zipfile.is_zipfile(source):
        return _members(source)
    if not source.is_dir():
        raise ValueError(f"{source} must be a folder, a zip file or a notebook. Check the path.")
    files: list[SourceFile] = []

    def unreadable(error: OSError) -> None:
        folder = Path(error.filename)
        name = PurePosixPath(folder.relative_to(source)) / "folder"
        files.append(SourceFile(name, folder, fault=f"The folder cannot be read: {error.strerror}."))

    for current, folders, names in os.walk(source, onerror=unreadable):
        folder = PurePosixPath(Path(current).relative_to(source))
        links = [one for one in folders if Path(current, one).is_symlink()]
        files += [_file(Path(current, name), folder / name) for name in [*names, *links]]
        if not names and not folders and folder.parts:
            files.append(SourceFile(folder / "folder", Path(current), fault="The folder is empty."))
        if len(files) > MAX_FILES:
            raise ValueError(f"{source} has more than {MAX_FILES} files. Give the folder of one sheet's submissions.")
    zips = [file for file in files if file.name.suffix.lower() == ".zip"]
    if zips and len(zips) == len(files) and all(_is_download(file.path) for file in zips):
        return [member for file in zips for member in _members(file.path)]
    return sorted(files, key=lambda file: file.name)


def _file(path: Path, name: PurePosixPath) -> SourceFile:
    status = path.lstat()
    fault = ""
    if stat.S_ISLNK(status.st_mode):
        fault = f"{path.name} is a link to another place, not a file. Hand in the notebook itself."
    elif not stat.S_ISREG(status.st_mode):
        fault = f"{path.name} is not a regular file. Hand in the notebook itself."
    return SourceFile(name, path, modified=status.st_mtime, fault=fault)


def _is_download(path: Path) -> bool:
    """Whether a zip file is a platform's. One that a student made is never unpacked beside the files of others."""
    if not zipfile.is_zipfile(path):
        return False
    tops = [file.name.parts[0] for file in _members(path)]
    return bool(tops) and (all(map(MOODLE.fullmatch, tops)) or all(map(CANVAS.fullmatch, tops)))


def _members(path: Path) -> list[SourceFile]:
    try:
        with zipfile.ZipFile(path) as archive:
            members = archive.infolist()
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError) as error:
        raise ValueError(f"{path} is damaged: {error}. Download it again.") from error
    if len(members) > MAX_FILES:
        raise ValueError(f"{path} has more than {MAX_FILES} files. Is it the download of one sheet?")
    files = []
    for member in members:
        parts = [part for part in member.filename.replace("\\", "/").split("/") if part not in ("", ".", "..")]
        if parts and not member.is_dir():
            files.append(SourceFile(PurePosixPath(*parts), path, member.filename, zip_time(member)))
    return sorted(files, key=lambda file: file.name)


def zip_time(member: zipfile.ZipInfo) -> float:
    """Return when a member of a zip file was modified, on the scale of the times of files."""
    try:
        return float(timegm((*member.date_time, 0, 0, 0)))
    except ValueError:  # a month 0
        return 0.0


def read_bytes(file: SourceFile) -> bytes:
    """Return the content of a file. Raises Unreadable for one that cannot be read, or is larger than MAX_BYTES."""
    if file.fault:
        raise Unreadable(file.fault)
    try:
        if not file.member:
            with file.path.open("rb") as stream:
                return read_stream(stream, file.name)
        with zipfile.ZipFile(file.path) as archive, archive.open(file.member) as stream:
            return read_stream(stream, file.name)
    except (*ARCHIVE_ERRORS, KeyError) as error:
        raise unreadable(file.name, error) from error


def unreadable(name: PurePosixPath, error: Exception) -> Unreadable:
    """Return the sentence for a file that raises an error when it is read."""
    if isinstance(error, Unreadable):
        return error
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error) or type(error).__name__
    return Unreadable(f"{name.name} could not be read: {reason}.")


def read_stream(stream: Any, name: PurePosixPath) -> bytes:
    """Return the content of an open file. Raises Unreadable if it is larger than MAX_BYTES."""
    content: bytes = stream.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise Unreadable(
            f"{name.name} has more than {MAX_BYTES / 1e6:g} MB. Clear all outputs, run all cells, and save."
        )
    return content


# --- owners ---

Owner = tuple[str, str]
"""The name of a student, and the key by which a platform's roster knows the student, "" in a folder of your own."""


def _by_owner(
    files: Sequence[SourceFile], sheet: str, roster: Roster | None
) -> tuple[str, dict[Owner, list[SourceFile]]]:
    if metadata := next((file for file in files if file.name.name == GRADESCOPE), None):
        inside = metadata.name.parent
        if all(file.name.is_relative_to(inside) for file in files):
            return "gradescope", _gradescope(files, metadata)
    owned: dict[Owner, list[SourceFile]] = {}
    for kind, pattern in (("moodle", MOODLE), ("canvas", CANVAS)):
        matches = [(file, _match(pattern, file)) for file in files]
        wanted = [match for file, match in matches if file.is_read]
        if (any if kind == "moodle" else all)(wanted) and any(match for _, match in matches):
            for file, match in matches:
                if match:
                    owned.setdefault((_normal(match["name"]), match["key"]), []).append(file)
            return kind, owned
    is_nbgrader = any(len(file.name.parts) > 2 and file.name.parts[-2] == sheet for file in files)
    known = {file: _known(file, sheet, roster) for file in files}
    level = _level([file for file in files if not known[file]], sheet)
    for file in files:
        if name := known[file] or _owner(file, sheet, level):
            # A student with a folder of nbgrader, but none for this sheet, handed nothing in.
            is_other = is_nbgrader and file.name.parent.name not in (sheet, name)
            owned.setdefault((name, ""), []).extend([] if is_other else [file])
    for name, key in list(owned):
        if (copy := COPY.fullmatch(name)) and (copy[1], "") in owned:
            owned[copy[1], ""] += owned.pop((name, key))
    return "nbgrader" if is_nbgrader else "folder", owned


def _match(pattern: re.Pattern[str], file: SourceFile) -> re.Match[str] | None:
    return next(filter(None, map(pattern.fullmatch, file.name.parts)), None)


def _normal(name: str) -> str:
    """Return a name as it is compared: a Mac takes accents apart, and old zip files have bytes that are no letters."""
    return unicodedata.normalize("NFC", name.encode(errors="replace").decode().strip())


def _folders(file: SourceFile, sheet: str) -> tuple[str, ...]:
    parts = file.name.parts[:-1]
    return parts[:-1] if len(parts) > 1 and parts[-1] == sheet else parts


def _level(files: Sequence[SourceFile], sheet: str) -> int:
    """Return how deep the folders of students are: where most files of sheets are, or higher if names repeat there."""
    depths = Counter(len(_folders(file, sheet)) for file in files if file.is_read or file.fault)
    level = max(depths, key=lambda depth: (depths[depth], -depth), default=1)
    while level > 1:
        folders = {_folders(file, sheet)[:level] for file in files if len(_folders(file, sheet)) >= level}
        if 2 * len({folder[-1] for folder in folders}) > len(folders) or len(folders) == 1:
            break
        level -= 1
    return level


def _stem(file: SourceFile, sheet: str) -> str:
    """Return the name of a file without the name of the sheet; "" for a file that is named after nobody."""
    copy = COPY.fullmatch(file.name.stem)
    if not file.is_read or sheet in (file.name.stem, copy and copy[1]):
        return ""
    return re.sub(rf"^{re.escape(sheet)}[-_ ]+|[-_ ]+{re.escape(sheet)}$", "", file.name.stem)


def _known(file: SourceFile, sheet: str, roster: Roster | None) -> str:
    """Return the id of a roster that is in the path of a file, "" if there is none."""
    names = [_stem(file, sheet), *reversed(_folders(file, sheet))]
    return next((id_ for name in names if (id_ := roster.spelled(_normal(name)))), "") if roster else ""


def _owner(file: SourceFile, sheet: str, level: int) -> str:
    """Return the name of the student to whom a file belongs in a folder of your own; "" for a list or a note of yours."""
    names, level = _folders(file, sheet), max(level, 1)
    if not (file.is_read or file.fault) and len(names) < level:
        return ""
    if len(names) < level and (stem := _stem(file, sheet)):
        names = (*names, stem)
    return _normal(names[min(level, len(names)) - 1] if names else file.name.stem)


def _gradescope(files: Sequence[SourceFile], metadata: SourceFile) -> dict[Owner, list[SourceFile]]:
    import yaml  # here, because only a download of Gradescope has such a file

    # The base loader makes only texts, lists and mappings: 007 stays 007, and Ruby's own objects are not built.
    loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
    try:
        records = yaml.load(read_bytes(metadata).decode(), loader)  # noqa: S506
        people = {str(key): record[":submitters"] for key, record in records.items()}
    except (yaml.YAMLError, ValueError, RecursionError, KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"{GRADESCOPE} must list the submissions: {error!r}. Download them again.") from error
    depth = len(metadata.name.parts) - 1
    owned = {}
    for submission, submitters in people.items():
        own = [file for file in files if file.name.parts[depth : depth + 1] == (submission,)]
        for person in submitters:
            key, name = (_text(person, ":sid") or _text(person, ":email") or submission, _text(person, ":name"))
            owned[key if key != submission else name or key, key] = own
    return owned


def _text(person: Any, kind: str) -> str:
    value = person.get(kind) if isinstance(person, Mapping) else None
    return value.strip() if isinstance(value, str) else ""
