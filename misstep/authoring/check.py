"""`misstep check`: what is missing in a course, in sentences that name the problem and the line.

It draws the numbers of several students, judges every mistake that is known, and looks for the cells of each problem in the
notebook of its sheet. `misstep check --repair` adds the cells that are missing, and corrects the points in their metadata.
"""

import inspect
import json
import re
from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Iterator
from typing import Any

from misstep.authoring.course_here import (
    FaultOfCourse,
    headings_of,
    import_sheet,
    place_of,
)
from misstep.authoring.new_problem import PLACEHOLDER, PLACEHOLDER_SOLUTION, add_cells, notebook_of
from misstep.catalog import Course, add_course_argument, find_course
from misstep.census import COUNTS, census_of
from misstep.problem import Problem, Template
from misstep.release.instructor_notebook import Entry


def what_is_missing(course: Course, students: int = 10) -> Iterator[str]:
    """Yield a sentence for each thing that is missing or wrong in a course."""
    seen = Counter[str]()
    for name in course.sheets():
        try:
            sheet = import_sheet(course, name)
        except FaultOfCourse as error:
            yield str(error)
            continue
        if sheet.name != name:
            yield f"Sheet {name}: its SHEET has the name {sheet.name!r}, which must be that of the folder, {name!r}."
        for template in sheet.problems:
            seen[template.number] += 1
            if seen[template.number] == 2:
                yield f"{_line(template)}: problem {template.number} has the number of another problem."
            yield from _of_problem(template, course, students)
            yield from _of_lecture(template, course)
        yield from _of_notebook(course, name)


def _of_problem(template: Template, course: Course, students: int) -> Iterator[str]:
    names = [f"student {k}" for k in range(students)]
    try:
        problem = template.variant(names[0])
        row = census_of(template, names)
    except Exception as error:
        where = place_of(error, course) or f"{_line(template)}: "
        text = (
            str(error)
            if str(error).startswith("Problem ")
            else f"Problem {template.number}: {type(error).__name__}: {error}"
        )
        yield f"{where}{text}"
        return
    for what, count in row.counts.items():
        if what in ("full_marks", "misnamed", "false"):
            yield f"{_line(template)}: problem {template.number}: {COUNTS[what]}, {count} times. For example, {row.examples[what][0]}"
    try:
        if problem.figure:
            problem.figure()
    except Exception as error:  # it is the author's code that draws
        yield (
            f"{place_of(error, course) or f'{_line(template)}: '}the figure of problem {template.number}: "
            f"{type(error).__name__}: {error}"
        )
    for text in _of_variant(template, problem):
        yield f"{_line(template)}: problem {template.number} {text}"


def _of_variant(template: Template, problem: Problem) -> Iterator[str]:
    if problem.statement.startswith(PLACEHOLDER):
        yield "still has the statement of a new problem."
    rubric = problem.answer.rubric
    if rubric and sum(rubric.values()) != template.points:
        yield f"has {template.points} points, and the criteria of its rubric {sum(rubric.values()):g} together."
    if not rubric and not problem.known_mistakes:
        yield "has neither a solution as an expression nor mistakes, so feedback cannot name any."


def _of_lecture(template: Template, course: Course) -> Iterator[str]:
    lecture, _, section = template.lecture.partition("#")
    file = course.folder.parent / "notebooks" / f"{lecture}.ipynb"
    if not file.is_file():
        yield f"{_line(template)}: problem {template.number} names the lecture {lecture!r}, but there is no {file}."
    elif section not in headings_of(file):
        yield f"{_line(template)}: problem {template.number} names the section {section!r}, which is no heading of {file}."


def _of_notebook(course: Course, sheet: str) -> Iterator[str]:
    file = notebook_of(course, sheet)
    if not file.is_file():
        yield f"{file} is missing: the notebook of the sheet, with the solutions."
        return
    cells = json.loads(file.read_text("utf-8"))["cells"]
    sources = ["".join(cell["source"]) for cell in cells]
    if not any(re.search(rf"open_sheet\(\s*['\"]{re.escape(sheet)}['\"]", source) for source in sources):
        yield f'{file} does not open the sheet. Its first cell must have open_sheet("{sheet}", student).'
    problems = course.find_sheet(sheet).problems
    for k in sorted({int(k) for source in sources for k in re.findall(r"sheet\.(?:check|show)\((\d+)", source)}):
        if k > len(problems):
            yield f"{file}: there are cells of a problem {k}, and the sheet has {len(problems)}. Delete them."
    for k, template in enumerate(problems, start=1):
        what = f"{file}: problem {template.number}"
        checks = [cell for cell, source in zip(cells, sources, strict=True) if f"sheet.check({k}," in source]
        if not checks:
            yield f"{what} has no cell with sheet.check({k}, ...). `misstep check --repair` adds its cells."
        elif _points(checks[0]) != template.points:
            shown = _points(checks[0])
            yield f"{what} has {template.points} points, and its check cell {shown}. `misstep check --repair` corrects it."
        if any(PLACEHOLDER_SOLUTION in source and f"_{k} = " in source for source in sources):
            yield f"{what} still has the solution of a new problem. Replace it, and the comment behind it."
        if not any(f"sheet.show({k})" in source for source in sources):
            yield f"{what} has no cell with sheet.show({k})."


def repair(course: Course) -> None:
    """Add the cells of problems that have none, and give each check cell the points of its problem."""
    for sheet in course.sheets():
        file = notebook_of(course, sheet)
        content = json.loads(file.read_text("utf-8"))
        for k, template in enumerate(course.find_sheet(sheet).problems, start=1):
            checks = [cell for cell in content["cells"] if f"sheet.check({k}," in "".join(cell["source"])]
            if not checks:
                name = getattr(template.make_problem, "__name__", "answer")
                entry = Entry(name, "", f"{name}_{k} = ...  {PLACEHOLDER_SOLUTION}")
                add_cells(content, k, template.title, template.points, entry)
            elif "nbgrader" in checks[0]["metadata"]:
                checks[0]["metadata"]["nbgrader"]["points"] = template.points
        file.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", "utf-8")


def _points(cell: dict[str, Any]) -> Any:
    return cell["metadata"].get("nbgrader", {}).get("points")


def _line(template: Template) -> str:
    make = inspect.unwrap(template.make_problem)
    return f"{inspect.getsourcefile(make)}:{inspect.getsourcelines(make)[1]}"


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of `misstep check`."""
    parser.add_argument("--students", type=int, default=10, help="how many students (10)")
    parser.add_argument(
        "--repair", action="store_true", help="add missing cells to the notebooks, and correct their points"
    )
    add_course_argument(parser)


def run(options: Namespace) -> int:
    """Print what is missing; return 0 if nothing is, and 1 otherwise."""
    course = find_course(options.course)
    if options.repair:
        repair(course)
    missing = list(what_is_missing(course, options.students))
    print(*missing, sep="\n") if missing else print(
        f"{course.package}: nothing is missing in {', '.join(course.sheets())}."
    )
    return int(bool(missing))
