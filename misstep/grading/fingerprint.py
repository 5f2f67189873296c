"""Fingerprints: a digest of everything that a result depends on. The next run grades only what has another one.

Problems may be corrected later, and then the class is graded again; but not for a change in the sheet of another lecture, nor
in what writes pages and tables, because these are written again in each run.
"""

import json
from collections.abc import Sequence, Set
from functools import cache
from hashlib import sha256
from pathlib import Path

from misstep.catalog import FOLDER_PREFIX, find_course
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.sandbox.course_stub import engine_folder, required_folders

PUBLISHING = {Path(__file__).with_name(name) for name in ("publish", "nbgrader")}
"""Folders on which no result depends."""


def fingerprint(sheet: ReleasedSheet, way: str, parts: Sequence[str | bytes | None]) -> str:
    """A digest of everything that a result depends on.

    way    how submissions run: the limits, and whether in the sandbox
    parts  what belongs to one submission
    """
    robot = sheet.folder / f"{sheet.name}.json"
    common = [
        code_digest(sheet.course, sheet.name),
        sheet.name,
        sheet.site,
        sheet.opening,
        sheet.key,
        sha256(sheet.solution).hexdigest(),
        sorted(sheet.checks.items()),
        way,
        robot.read_text("utf-8") if robot.exists() else "",
    ]
    encoded = [part.encode(errors="surrogatepass") if isinstance(part, str) else part for part in parts]
    digests = [part if part is None else sha256(part).hexdigest() for part in encoded]
    return sha256(json.dumps([*common, digests]).encode()).hexdigest()


@cache
def code_digest(course: str, sheet: str) -> str:
    """A digest of the code that the results of a sheet depend on: the engine, the course, and the packages that it requires.

    Other lectures are left out, unless the code names their folder, as an import does. A sheet that no lecture has, such as
    that of a robot, may need all of them.
    """
    owner = find_course(course)
    own = owner.folder / f"{FOLDER_PREFIX}{sheet}"
    others = {*owner.folder.glob(f"{FOLDER_PREFIX}*")} - {own} if own.is_dir() else set[Path]()
    code = _code_in(owner.folder, others)
    while named := [folder for folder in sorted(others) if folder.name.encode() in code]:
        code += b"".join(_code_in(folder) for folder in named)
        others -= {*named}
    beside = [_code_in(folder, PUBLISHING) for folder in (engine_folder(), *required_folders(owner))]
    return sha256(b"".join([code, *beside])).hexdigest()


def _code_in(folder: Path, left_out: Set[Path] = frozenset()) -> bytes:
    """All Python files of a folder, without those in some folders."""
    files = sorted(file for file in folder.rglob("*.py") if not left_out & {*file.parents})
    return b"\0".join(file.read_bytes() for file in files)
