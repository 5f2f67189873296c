"""Layouts: whose a file is, told from where it lies, in a folder of one's own and in downloads of learning platforms.

folder      ada/anything.ipynb, or ada.ipynb
nbgrader    ada/<sheet>/<sheet>.ipynb, the submitted/ of a course
Canvas      lovelaceada_[LATE_]1815_99_<sheet>.ipynb         1815 is the ID of Canvas's gradebook
Moodle      Ada Lovelace_1815_assignsubmission_file_/<sheet>.ipynb   1815 is "Participant 1815" of the worksheet
Gradescope  submission_99/<sheet>.ipynb, and submission_metadata.yml says whose number 99 is
"""

import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

import yaml

from misstep.grading.collect.files import File

CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<key>\d+)_\d+_(?P<file>.+)")
MOODLE = re.compile(r"(?P<name>.+)_(?P<key>\d+)_assignsubmission_[a-z]+_?(?P<file>.*)", re.DOTALL)
GRADESCOPE = "submission_metadata.yml"


@dataclass
class Pile:
    """The files of one student.

    name   who it is: the id of the course in a folder of one's own, elsewhere what the platform calls them
    key    the number by which the platform's roster knows them, "" in a folder of one's own
    files  the file name that the student chose, with its file
    """

    name: str
    key: str = ""
    files: list[tuple[str, File]] = field(default_factory=list)


@dataclass(frozen=True)
class Layout:
    """How submissions lie, and the pile of each student."""

    kind: str
    piles: Sequence[Pile]


def layout(found: Sequence[File], sheet: str) -> Layout:
    """Tell how the files lie, and sort them into piles.

    Raises ValueError where there is no file.
    """
    if not found:
        raise ValueError("There is no submission in it.")
    if metadata := [file for file in found if file.path.name == GRADESCOPE]:
        return Layout("gradescope", _gradescope(found, metadata[0]))
    found = _without_wrapping(found)
    tops = {file.path.parts[0] for file in found}
    if any(MOODLE.fullmatch(top) for top in tops):
        return Layout("moodle", _piles(found, lambda path: _of_platform(MOODLE, path)))
    flat = [file.path.name for file in found if len(file.path.parts) == 1 and file.is_notebook]
    if flat and all(CANVAS.fullmatch(name) for name in flat):
        return Layout("canvas", _piles(found, lambda path: _of_platform(CANVAS, path)))
    if any(file.path.parts[1:-1] == (sheet,) for file in found):
        return Layout("nbgrader", _piles(found, lambda path: _of_course(path, sheet)))
    return Layout("folder", _piles(found, lambda path: _of_folder(path, sheet)))


Owner = tuple[str, str, str]
"""Name, key, and the name of the file."""


def _piles(found: Sequence[File], owner: Callable[[PurePosixPath], Owner | None]) -> list[Pile]:
    piles: dict[str, Pile] = {}
    for file in found:
        if (of := owner(file.path)) is not None:
            name, key, called = of
            pile = piles.setdefault(key or _plain(name).casefold(), Pile(_plain(name), key))
            if called and file.is_there:
                pile.files.append((called, file))
    return list(piles.values())


def _plain(name: str) -> str:
    """A name in the one form that others write it in too: a Mac takes its accents apart, an old zip spoils them."""
    return unicodedata.normalize("NFC", name.encode(errors="replace").decode()).strip()


def _of_folder(path: PurePosixPath, sheet: str) -> Owner | None:
    if len(path.parts) > 1:
        return path.parts[0], "", path.name
    if path.suffix.lower() != ".ipynb":
        return None  # a list, a note: whoever collected put it there
    student = re.sub(rf"^{re.escape(sheet)}[-_ ]+|[-_ ]+{re.escape(sheet)}$", "", path.stem)
    return student, "", f"{sheet}.ipynb"


def _of_course(path: PurePosixPath, sheet: str) -> Owner | None:
    """A student who has a folder, but none for this sheet, handed nothing in."""
    if len(path.parts) < 2:
        return None
    return path.parts[0], "", path.name if path.parts[1] == sheet else ""


def _of_platform(pattern: re.Pattern[str], path: PurePosixPath) -> Owner | None:
    of = pattern.fullmatch(path.parts[0])
    if of is None:
        return None
    return of["name"], of["key"], path.name if len(path.parts) > 1 else of["file"]


def _without_wrapping(found: Sequence[File]) -> Sequence[File]:
    """What lies in one folder alone, which somebody's unpacking left, without that folder."""
    tops = {file.path.parts[0] for file in found}
    inner = [file.path.parts[1:] for file in found]
    is_wrapped = len(tops) == 1 and all(inner) and not MOODLE.fullmatch(next(iter(tops)))
    known = [parts[0] for parts in inner if parts and (MOODLE.fullmatch(parts[0]) or CANVAS.fullmatch(parts[0]))]
    if not is_wrapped or not known:
        return found
    return [File(PurePosixPath(*file.path.parts[1:]), file.changed, file.read) for file in found]


def _gradescope(found: Sequence[File], metadata: File) -> list[Pile]:
    # The base loader makes texts, lists and maps, nothing else: 007 stays 007, and Ruby's own objects stay away.
    loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
    try:
        told = yaml.load(metadata.read().decode(), loader)  # noqa: S506
    except (yaml.YAMLError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"{GRADESCOPE} cannot be read: {error}. Download the submissions again.") from error
    if not isinstance(told, Mapping):
        raise ValueError(f"{GRADESCOPE} holds no list of submissions. Download them again.")
    here = len(metadata.path.parts) - 1
    piles = []
    for submission, record in told.items():
        own = [(file.path.name, file) for file in found if str(submission) in file.path.parts[here : here + 1]]
        for person in _submitters(record):
            key = str(person.get(":sid") or person.get(":email") or "")
            piles.append(Pile(str(person.get(":name") or key or submission), key or str(submission), own))
    if not piles:
        raise ValueError(f"{GRADESCOPE} names nobody. Download the submissions again.")
    return piles


def _submitters(record: Any) -> list[Mapping[str, Any]]:
    people = record.get(":submitters") if isinstance(record, Mapping) else None
    return [person for person in people if isinstance(person, Mapping)] if isinstance(people, list) else []
