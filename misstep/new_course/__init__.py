"""`misstep new-course my_course`: write a small course that works, as the beginning of one's own.

The folder `template` is this course, on alternating current, under the name my_course. It is copied, and the name replaced. The
folders of `examples` have the lecture and the sheet of a course on another subject, which take the place of those of the template.
"""

import json
import keyword
import re
import shutil
import sys
import tomllib
from argparse import ArgumentParser, Namespace
from pathlib import Path

from misstep.catalog import FOLDER_PREFIX, forget_package, load_course
from misstep.release.instructor_notebook import Entry, notebook

TEMPLATE = Path(__file__).parent / "template"
TEMPLATE_NAME = "my_course"
TEMPLATE_LECTURE, TEMPLATE_QUESTION = "01_ohm", "01/brightness"

EXAMPLES = {"alternating-current": "", "probability": "dice", "linear-algebra": "eigenvalues"}
"""The subjects with which a course may begin, each with its folder in `examples`; the first one is that of the template."""

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
    shutil.copytree(TEMPLATE, folder, ignore=shutil.ignore_patterns("__pycache__"))
    if EXAMPLES[subject]:
        _take_example(folder, EXAMPLES[subject])
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        file.write_text(file.read_text("utf-8").replace(TEMPLATE_NAME, name), "utf-8")
    (folder / TEMPLATE_NAME).rename(folder / name)


def _take_example(folder: Path, example: str) -> None:
    """Replace the lecture and the sheet of the template by those of an example."""
    source, lecture = TEMPLATE.with_name("examples") / example, f"01_{example}"
    subject = next(name for name, one in EXAMPLES.items() if one == example).replace("-", " ")
    for part in (f"{TEMPLATE_NAME}/{FOLDER_PREFIX}{TEMPLATE_LECTURE}", f"solutions/{TEMPLATE_LECTURE}"):
        shutil.rmtree(folder / part)
    package = folder / TEMPLATE_NAME / f"{FOLDER_PREFIX}{lecture}"
    package.mkdir()
    (package / "__init__.py").write_text(f'"""Lecture 01: {example}."""\n', "utf-8")
    for name in ("problems.py", "questions.toml"):
        shutil.copy(source / name, package)
    question = f"01/{next(iter(tomllib.loads((source / 'questions.toml').read_text('utf-8'))))}"
    old = folder / "notebooks" / f"{TEMPLATE_LECTURE}.ipynb"
    content = json.loads(old.read_text("utf-8"))
    first, opening, *_, ask, explain = content["cells"]
    title, *sections = re.split(r"(?m)^(?=## )", (source / "lecture.md").read_text("utf-8"))
    texts = [title.strip() + "\n\nRun each cell with Shift + Enter.", *map(str.strip, sections)]
    cells = [{**first, "id": f"text-{k}", "source": text.splitlines(keepends=True)} for k, text in enumerate(texts)]
    content["cells"] = [cells[0], opening, *cells[1:], ask, explain]
    old.unlink()
    text = json.dumps(content, indent=1, ensure_ascii=False).replace(TEMPLATE_QUESTION, question)
    old.with_name(f"{lecture}.ipynb").write_text(text + "\n", "utf-8")
    for file in (folder / "README.md", folder / "instructors.md", folder / TEMPLATE_NAME / "__init__.py"):
        text = file.read_text("utf-8").replace(TEMPLATE_LECTURE, lecture).replace("electric circuits", subject)
        file.write_text(text.replace("Electric circuits", subject.capitalize()), "utf-8")
    try:
        sheet = load_course(folder / TEMPLATE_NAME).find_sheet(lecture)
    finally:
        forget_package(TEMPLATE_NAME)
        for cache in list(folder.rglob("__pycache__")):
            shutil.rmtree(cache)
    entries = [Entry(**one) for one in tomllib.loads((source / "solutions.toml").read_text("utf-8"))["problem"]]
    solutions = folder / "solutions" / lecture / f"{lecture}.ipynb"
    solutions.parent.mkdir()
    intro = "Type your id, run the cells, and replace each `...` by your answer."
    solutions.write_text(notebook(sheet, entries, intro, OPENING), "utf-8")


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep new-course`."""
    parser.add_argument("folder", type=Path, help="the folder to be made; its name is that of the course")
    parser.add_argument("--subject", choices=EXAMPLES, default=next(iter(EXAMPLES)), help="of its first lecture")


def run(options: Namespace) -> int:
    """Write the course, print what to do next, and return 0; 2 if the request is invalid."""
    try:
        write_course(options.folder.absolute(), options.subject)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    print(f"{options.folder} has a course with one lecture and one sheet. Read {options.folder / 'README.md'} next.")
    return 0
