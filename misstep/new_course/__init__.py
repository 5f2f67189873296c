"""`misstep new-course my_course`: write a small course that works, as the beginning of one's own.

The folder `template` is this course, under the name my_course. It is copied, and the name replaced.
"""

import keyword
import shutil
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

TEMPLATE = Path(__file__).parent / "template"
TEMPLATE_NAME = "my_course"


def write_course(folder: Path) -> None:
    """Write a new course into a folder that does not exist yet; its name becomes the name of the Python package.

    Raises ValueError if the name cannot be that of a package, or if the folder exists.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as parent:
    ...     write_course(Path(parent, "thermodynamics"))
    ...     (Path(parent) / "thermodynamics" / "thermodynamics" / "lecture_01_ohm").is_dir()
    True
    """
    name = folder.name
    if not (name.isidentifier() and name.isascii() and name.islower()) or keyword.iskeyword(name):
        raise ValueError(
            f"The name of a course must consist of small letters, digits and underscores; got {name!r}. Try: my_course"
        )
    if name in sys.stdlib_module_names or name in ("misstep", "tests", "notebooks", "solutions"):
        raise ValueError(f"The name of a course must not be that of another package; got {name!r}. Try: {name}_course")
    if folder.exists():
        raise ValueError(f"A new course needs a folder that does not exist yet; {folder} exists. Try another name.")
    shutil.copytree(TEMPLATE, folder, ignore=shutil.ignore_patterns("__pycache__"))
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        file.write_text(file.read_text("utf-8").replace(TEMPLATE_NAME, name), "utf-8")
    (folder / TEMPLATE_NAME).rename(folder / name)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep new-course`."""
    parser.add_argument("folder", type=Path, help="the folder to be made; its name is that of the course")


def run(options: Namespace) -> int:
    """Write the course, print what to do next, and return 0; 2 if the request is invalid."""
    try:
        write_course(options.folder.absolute())
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    print(f"{options.folder} has a course with one lecture and one sheet. Read {options.folder / 'README.md'} next.")
    return 0
