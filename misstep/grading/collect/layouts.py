"""Layouts: which student a file belongs to, by its path, in your own folders and in downloads of learning platforms.

folder      ada/anything.ipynb, or ada.ipynb
nbgrader    ada/<sheet>/<sheet>.ipynb, the folder submitted/ of an nbgrader course
Canvas      lovelaceada_[LATE_]1815_99_<sheet>.ipynb         1815 is the ID of Canvas's gradebook
Moodle      Ada Lovelace_1815_assignsubmission_file_/<sheet>.ipynb   1815 is "Participant 1815" of the worksheet
Gradescope  submission_99/<sheet>.ipynb, and submission_metadata.yml lists the students of submission 99
"""

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

from misstep.grading.collect.files import File

CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<key>\d+)_\d+_(?P<file>.+)")
MOODLE = re.compile(r"(?P<name>.+)_(?P<key>\d+)_assignsubmission_[a-z]+_?(?P<file>.*)", re.DOTALL)
GRADESCOPE = "submission_metadata.yml"

COPY = re.compile(r"(.+?)[-_ ]*(\(\d+\)|copy\d*)", re.IGNORECASE)
"""A name that a browser or an editor has made from another one."""


@dataclass
class StudentFiles:
    """The files of one student.

    name   the student: the course id in your own folder, otherwise the name that the platform gives
    key    the number by which the platform's roster identifies the student, "" in your own folder
    files  pairs of the file name that the student chose and the file
    """

    name: str
    key: str = ""
    files: list[tuple[str, File]] = field(default_factory=list)


def detect_layout(files: Sequence[File], sheet: str) -> tuple[str, list[StudentFiles]]:
    """Detect how the files are organised, and sort them by student. Returns the kind of the folder or download, and the students.

    Raises ValueError if there is no file.
    """
    if not files:
        raise ValueError("It contains no submission.")
    if metadata := _gradescope_metadata(files):
        return "gradescope", _gradescope_students(files, metadata)
    files = _without_wrapping_folder(files)
    tops = {file.path.parts[0] for file in files}
    if any(MOODLE.fullmatch(top) for top in tops):
        return "moodle", _sort_by_student(files, lambda path: _owner_on_platform(MOODLE, path))
    flat = [file.path.name for file in files if len(file.path.parts) == 1 and file.is_notebook]
    if flat and all(CANVAS.fullmatch(name) for name in flat):
        return "canvas", _sort_by_student(files, lambda path: _owner_on_platform(CANVAS, path))
    if any(file.path.parts[1:-1] == (sheet,) for file in files):
        return "nbgrader", _sort_by_student(files, lambda path: _owner_in_nbgrader(path, sheet))
    return "folder", _sort_by_student(files, lambda path: _owner_in_folder(path, sheet))


Owner = tuple[str, str, str]
"""The student's name, the key, and the name of the file; an empty file name if the file is not part of the submission."""


def _sort_by_student(files: Sequence[File], find_owner: Callable[[PurePosixPath], Owner | None]) -> list[StudentFiles]:
    students: dict[str, StudentFiles] = {}
    for file in files:
        if (owner := find_owner(file.path)) is not None:
            name, key, file_name = owner
            name = name.encode(errors="replace").decode().strip()
            student = students.setdefault(key or name, StudentFiles(name, key))
            if file_name and file.exists:
                student.files.append((file_name, file))
    for name in [name for name, student in students.items() if not student.key]:
        if (copy := COPY.fullmatch(name)) and copy[1] in students:
            students[copy[1]].files += students.pop(name).files
    # macOS decomposes accents. Two names that differ only in this are two students, so then they stay as they are.
    composed = Counter(unicodedata.normalize("NFC", student.name) for student in students.values() if not student.key)
    for student in students.values():
        if composed[name := unicodedata.normalize("NFC", student.name)] < 2:
            student.name = name
    return list(students.values())


def _owner_in_folder(path: PurePosixPath, sheet: str) -> Owner | None:
    if len(path.parts) > 1:
        return path.parts[0], "", path.name
    if path.suffix.lower() != ".ipynb":
        return None  # a list or a note of the instructor
    student = re.sub(rf"^{re.escape(sheet)}[-_ ]+|[-_ ]+{re.escape(sheet)}$", "", path.stem)
    return student, "", f"{sheet}.ipynb"


def _owner_in_nbgrader(path: PurePosixPath, sheet: str) -> Owner | None:
    """A student who has a folder, but none for this sheet, submitted nothing."""
    if len(path.parts) < 2:
        return None
    return path.parts[0], "", path.name if path.parts[1] == sheet else ""


def _owner_on_platform(pattern: re.Pattern[str], path: PurePosixPath) -> Owner | None:
    match = pattern.fullmatch(path.parts[0])
    if match is None:
        return None
    return match["name"], match["key"], path.name if len(path.parts) > 1 else match["file"]


def _without_wrapping_folder(files: Sequence[File]) -> Sequence[File]:
    """The files without the single folder around them that unpacking a download may have made."""
    tops = {file.path.parts[0] for file in files}
    inner = [file.path.parts[1:] for file in files]
    is_wrapped = len(tops) == 1 and all(inner) and not MOODLE.fullmatch(next(iter(tops)))
    known = [parts[0] for parts in inner if parts and (MOODLE.fullmatch(parts[0]) or CANVAS.fullmatch(parts[0]))]
    if not is_wrapped or not known:
        return files
    return [File(PurePosixPath(*file.path.parts[1:]), file.modified, file.read) for file in files]


def _gradescope_metadata(files: Sequence[File]) -> File | None:
    """Gradescope's list: all files are below its folder. One that a student handed in is in a folder of that student."""
    lists = (file for file in files if file.path.name == GRADESCOPE)
    return next((one for one in lists if all(file.path.is_relative_to(one.path.parent) for file in files)), None)


def _gradescope_students(files: Sequence[File], metadata: File) -> list[StudentFiles]:
    import yaml  # here, because only a download of Gradescope has such a file

    # The base loader makes only strings, lists and dictionaries: 007 stays 007, and Ruby's own objects are not built.
    loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
    try:
        records = yaml.load(metadata.read().decode(), loader)  # noqa: S506
    except (yaml.YAMLError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"{GRADESCOPE} cannot be read: {error}. Download the submissions again.") from error
    if not isinstance(records, Mapping):
        raise ValueError(f"{GRADESCOPE} must have a list of submissions. Download them again.")
    depth = len(metadata.path.parts) - 1
    students = []
    for submission, record in records.items():
        own_files = [(file.path.name, file) for file in files if str(submission) in file.path.parts[depth : depth + 1]]
        for person in _submitters(record):
            sid, email, called = (_text(person.get(kind)) for kind in (":sid", ":email", ":name"))
            key = sid or email
            name = called or key or str(submission)
            students.append(StudentFiles(name, key or str(submission), own_files))
    if not students:
        raise ValueError(f"{GRADESCOPE} lists no student. Download the submissions again.")
    return students


def _text(value: Any) -> str:
    """A text of the list; an alias of YAML could stand for more than fits into memory."""
    return value.strip() if isinstance(value, str) else ""


def _submitters(record: Any) -> list[Mapping[str, Any]]:
    people = record.get(":submitters") if isinstance(record, Mapping) else None
    return [person for person in people if isinstance(person, Mapping)] if isinstance(people, list) else []
