"""The course on which an author works: the one in the folder where a command runs."""

from argparse import ArgumentParser
from pathlib import Path

from misstep.catalog import Course, find_course


def add_course_argument(parser: ArgumentParser) -> None:
    """Add the option that names another course."""
    parser.add_argument(
        "--course", help="the folder of the package, or the name of an installed course (default: the one here)"
    )


def find_course_here(reference: str | None, here: Path) -> Course:
    """Find a course by its reference, or the only one in a folder.

    Raises ValueError if there is none, or more than one.
    """
    if reference:
        return find_course(reference)
    found = [path.parent for path in sorted(here.glob("*/__init__.py")) if "COURSE = " in path.read_text("utf-8")]
    if len(found) != 1:
        names = ", ".join(path.name for path in found) or "none"
        raise ValueError(
            f"The folder {here} must have one course, a package that defines COURSE; it has {names}. "
            "Run the command in the folder of the course, or name the course by --course."
        )
    return find_course(found[0])
