"""The course on which an author works, the one in the folder where a command runs, and where it raised an error."""

import json
import re
import traceback
from pathlib import Path

from misstep.catalog import Course
from misstep.sheet import Sheet


class FaultOfCourse(ValueError):
    """The code of a course raised an error. The message names the file, the line and the error."""


def import_sheet(course: Course, name: str) -> Sheet:
    """Find a sheet of a course, whose code is that of an author. Raises FaultOfCourse if it cannot be imported."""
    try:
        return course.find_sheet(name)
    except Exception as error:  # it is the author's code that was imported
        raise FaultOfCourse(
            f"{place_of(error, course)}sheet {name} cannot be imported: {type(error).__name__}: {error}"
        ) from error


def headings_of(lecture: Path) -> list[str]:
    """Return the headings of the notebook of a lecture, in order; none if there is no such file."""
    cells = json.loads(lecture.read_text("utf-8"))["cells"] if lecture.is_file() else []
    texts = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    return [heading.strip() for text in texts for heading in re.findall(r"(?m)^#+ (.+)", text)]


def place_of(error: BaseException, course: Course) -> str:
    """The file and the line of the course at which an error was raised, before a sentence; "" if it was raised elsewhere."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{error.filename}:{error.lineno}: "
    frames = [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if Path(frame.filename).is_relative_to(course.folder)
    ]
    return f"{frames[-1].filename}:{frames[-1].lineno}: " if frames else ""
