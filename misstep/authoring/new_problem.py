"""`misstep new-problem 01_ohm "Power"`: add a problem that works to a sheet, and its four cells to the instructor's notebook.

It writes a function into problems.py, its name into the list of the SHEET there, and the cells with their metadata of nbgrader
into the notebook. What is left to the author is to change the function, and the solution in the notebook.
"""

import ast
import json
import re
import unicodedata
from argparse import ArgumentParser, Namespace
from pathlib import Path

from misstep.authoring.course_here import headings_of, import_sheet
from misstep.catalog import FOLDER_PREFIX, Course, add_course_argument, find_course
from misstep.release.instructor_notebook import Entry, problem_cells

PLACEHOLDER = "Replace this statement."
"""The beginning of the statement of a new problem; `misstep check` looks for it."""

PLACEHOLDER_SOLUTION = "# replace this solution"
"""The comment behind the solution of a new problem; `misstep check` looks for it."""

SKELETON = '''@problem({number!r}, {title!r}, points={points}, lecture={lecture!r})
def {name}(sampler: Sampler) -> Problem:
    """Say what the problem is about."""
    a, b = sampler.integer(2, 9), sampler.integer(2, 9)
    return Problem(
        statement=f"{placeholder} What is the product of {{a}} and {{b}}?",
        given={{"a": a, "b": b}},
        answer=Numbers(a * b),
        mistakes=[mistake("sum", a + b, "You added the numbers. Multiply them.")],
    )


'''

IMPORTS = {
    "misstep": ("Problem", "Sampler", "mistake", "problem"),
    "misstep.answers.number": ("Numbers",),
}


def add_problem(course: Course, sheet: str, title: str, points: int) -> tuple[Path, Path]:
    """Add a problem to a sheet, and return the two files that were changed.

    Raises ValueError for an unknown sheet, for points that are no positive number, and for a file without a list of problems.
    """
    if points < 1:
        raise ValueError(f"A problem must have at least one point; got {points}.")
    if sheet not in course.sheets():
        raise ValueError(f"There is no sheet {sheet!r}. The sheets are: {', '.join(course.sheets())}.")
    position = len(import_sheet(course, sheet).problems) + 1
    source = course.folder / f"{FOLDER_PREFIX}{sheet}" / "problems.py"
    notebook = notebook_of(course, sheet)
    content = json.loads(notebook.read_text("utf-8"))
    text = source.read_text("utf-8")
    name = _free_name(title, text)
    headings = headings_of(course.folder.parent / "notebooks" / f"{sheet}.ipynb") or ["A heading of the lecture"]
    skeleton = SKELETON.format(
        number=f"{sheet.partition('_')[0]}.{position}",
        title=title,
        points=points,
        lecture=f"{sheet}#{headings[-1]}",
        name=name,
        placeholder=PLACEHOLDER,
    ).replace("'", '"')
    source.write_text(_with_problem(text, skeleton, name, source), "utf-8")
    entry = Entry(name, "", f"{name}_{position} = given.a * given.b  {PLACEHOLDER_SOLUTION}")
    add_cells(content, position, title, points, entry)
    notebook.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", "utf-8")
    return source, notebook


def notebook_of(course: Course, sheet: str) -> Path:
    """The instructor's notebook of a sheet."""
    return course.folder.parent / "solutions" / sheet / f"{sheet}.ipynb"


def add_cells(content: dict[str, list[dict[str, object]]], k: int, title: str, points: int, entry: Entry) -> None:
    """Add the cells of a problem to the content of a notebook, before those that count the points."""
    cells = content["cells"]
    end = next((i for i, cell in enumerate(cells) if cell.get("id") == "together"), len(cells))
    cells[end:end] = problem_cells(k, title, points, entry)


def _with_problem(text: str, skeleton: str, name: str, source: Path) -> str:
    tree = ast.parse(text)
    sheet = next(
        (node for node in tree.body if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "SHEET"), None
    )
    listed = [node for node in ast.walk(sheet.value) if isinstance(node, ast.List)] if sheet else []
    if sheet is None or not listed:
        raise ValueError(
            f"{source} must end in SHEET = Sheet(name, title, [problem, ...]), with the list in square brackets."
        )
    lines = text.splitlines(keepends=True)
    end = listed[0].elts[-1] if listed[0].elts else None
    row = (end and end.end_lineno) or listed[0].lineno
    column = (end and end.end_col_offset) or listed[0].col_offset + 1
    line = lines[row - 1].encode()
    lines[row - 1] = (line[:column] + f"{', ' if end else ''}{name}".encode() + line[column:]).decode()
    lines.insert(sheet.lineno - 1, skeleton)
    imports = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    known = {alias.asname or alias.name for node in imports for alias in node.names}
    missing = {module: [one for one in names if one not in known] for module, names in IMPORTS.items()}
    added = [f"from {module} import {', '.join(names)}\n" for module, names in missing.items() if names]
    after = imports[-1].end_lineno if imports else 0
    return "".join([*lines[:after], *added, *lines[after:]])


def _free_name(title: str, text: str) -> str:
    letters = unicodedata.normalize("NFKD", title.casefold())
    name = re.sub(r"[^a-z0-9]+", "_", "".join(one for one in letters if not unicodedata.combining(one))).strip("_")[:40]
    name = name if name.isidentifier() else f"problem_{name}".rstrip("_")
    return name if not re.search(rf"\b{name}\b", text) else f"{name}_{len(text)}"


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep new-problem`."""
    parser.add_argument("sheet", help="the name of the sheet, such as 01_ohm")
    parser.add_argument("title", help="the title of the problem, in quotes")
    parser.add_argument("--points", type=int, default=2, help="the full score (2)")
    add_course_argument(parser)


def run(options: Namespace) -> int:
    """Add the problem, print what to do next, and return 0."""
    course = find_course(options.course)
    source, notebook = add_problem(course, options.sheet, options.title, options.points)
    print(f"Added a problem that works. Change it at the end of {source}, and its solution in {notebook}.")
    print("Then run: misstep check")
    return 0
