"""`misstep new-course my_course`: write a small course that works, as the beginning of one's own.

The folder `template` is the course without a lecture, under the name my_course, as if its lecture were that on Ohm's law. Each
folder of `examples` is a lecture with its sheet on another subject; its notebooks are made from lecture.md and solutions.toml.
"""

import keyword
import shutil
import sys
import tomllib
from argparse import ArgumentParser, Namespace
from pathlib import Path

from misstep.catalog import FOLDER_PREFIX, forget_package, load_course
from misstep.release.instructor_notebook import Entry, notebook, notebook_of

TEMPLATE = Path(__file__).parent / "template"
EXAMPLES = {"alternating-current": "ohm", "probability": "dice", "linear-algebra": "eigenvalues"}
"""The subjects with which a course may begin, each with its folder in `examples`."""

OPENING = """import numpy as np

from my_course import open_sheet"""


def write_course(folder: Path, subject: str = "alternating-current") -> None:
    """Write a new course into a folder that does not exist yet; its name becomes the name of the Python package.

    subject  a key of EXAMPLES

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
    ignored = shutil.ignore_patterns("__pycache__", "lecture.md", "solutions.toml")
    source, lecture = TEMPLATE.with_name("examples") / EXAMPLES[subject], f"01_{EXAMPLES[subject]}"
    shutil.copytree(TEMPLATE, folder, ignore=ignored)
    package = folder / "my_course" / f"{FOLDER_PREFIX}{lecture}"
    shutil.copytree(source, package, ignore=ignored)
    (package / "__init__.py").write_text(f'"""Lecture 01: {EXAMPLES[subject]}."""\n', "utf-8")
    (folder / "notebooks").mkdir()
    text = (source / "lecture.md").read_text("utf-8")
    (folder / "notebooks" / f"{lecture}.ipynb").write_text(notebook_of(text), "utf-8")
    entries = [Entry(**one) for one in tomllib.loads((source / "solutions.toml").read_text("utf-8"))["problem"]]
    try:
        sheet = load_course(package.parent).find_sheet(lecture)
    finally:
        forget_package(package.parent.name)
        for cache in list(folder.rglob("__pycache__")):
            shutil.rmtree(cache)
    solutions = folder / "solutions" / lecture / f"{lecture}.ipynb"
    solutions.parent.mkdir(parents=True)
    intro = "Type your id, run the cells, and replace each `...` by your answer."
    solutions.write_text(notebook(sheet, entries, intro, OPENING), "utf-8")
    words = {"my_course": name, "01_ohm": lecture, "electric circuits": subject.replace("-", " ")}
    for file in [path for path in folder.rglob("*") if path.is_file()]:
        text = file.read_text("utf-8")
        for old, new in words.items():
            text = text.replace(old, new)
        file.write_text(text, "utf-8")
    package.parent.rename(folder / name)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep new-course`."""
    parser.add_argument("folder", type=Path, help="the folder to be made; its name is that of the course")
    parser.add_argument("--subject", choices=EXAMPLES, default=next(iter(EXAMPLES)), help="of its first lecture")


def run(options: Namespace) -> int:
    """Write the course, print what to do next, and return 0."""
    write_course(options.folder.absolute(), options.subject)
    print(f"{options.folder} has a course with one lecture and one sheet. Read {options.folder / 'README.md'} next.")
    return 0
