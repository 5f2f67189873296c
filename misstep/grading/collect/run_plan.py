"""What is run of a submission: the student's cells in their order, with the sheet's own check cells instead of the student's.

The answers of a submission are in its code, so its code is run again. Check cells may have been deleted, duplicated,
edited or moved, so the released sheet's own check cells are run in their place, and where the answer is set further down,
also there. The sheet's own opening cell runs first, and at the end those cells run again that failed.
"""

import ast
import builtins
import re
import warnings
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import chdir, nullcontext, suppress
from dataclasses import dataclass, field
from pathlib import Path

from misstep.catalog import Course, course_in, course_of, find_course
from misstep.grading.collect.notebook import CodeCell, UnusableNotebook, code_cells
from misstep.sheet import SAMPLE_ID

OPEN_SHEET_CALL = re.compile(r"open_sheet\(\s*[\"']([^\"']+)[\"']")

CHECK_CALL = re.compile(r"\.check\(\s*(\d+)\s*,\s*(\w+)\s*\)")
"""The call of a check cell: the number of the problem and the variable that is handed in."""

STUDENT_ASSIGNMENT = re.compile(r"^student\s*=\s*([\"'])(.{1,200}?)\1", re.MULTILINE)
"""The line of a sheet in which the student's id is typed."""

MAX_CELL_CHARACTERS = 1_000_000
"""The longest cell that is run. A sheet has 20,000 characters of code."""

RERUN_SOURCE = "# Once more, in their order: the cells that failed, and the checks that got no answer."
"""The source of the cell at which `run_cells` runs these cells again."""

PASSED_OVER = "Passed over while grading: "
"""The beginning of a line of output that says what of a cell could not be run."""


@dataclass(frozen=True)
class ReleasedSheet:
    """A sheet as students received it.

    name    the name that open_sheet takes
    folder  the folder of its notebook
    checks  the source of the check cell of each problem, by the problem's number, from 1
    opening the source of the cell that opens the sheet, with an empty id
    key     the instructor's key, by which other numbers are drawn; "" if points are for practice
    solution   with a key, the notebook itself
    course  the package of an installed course, or the folder of another one
    site    the address of the course's site, to which feedback links; "" if it has none
    """

    name: str
    folder: Path
    checks: Mapping[int, str]
    course: str
    site: str = ""
    opening: str = ""
    key: str = field(default="", repr=False)
    solution: bytes = field(default=b"", repr=False)


@dataclass(frozen=True)
class PlannedCell:
    """A cell to run: its source, the problem that it checks, if any, and the index of the cell in the submission.

    is_fallback  whether its answer counts only if no other check cell of this problem has one
    """

    source: str
    problem: int | None = None
    index: int | None = None
    is_fallback: bool = False


@dataclass(frozen=True)
class RunPlan:
    """The cells to run, in order, and remarks on the check cells of each problem, such as that one was edited.

    typed_id  the id that is typed in the notebook, found in its code; "" if there is none
    """

    cells: Sequence[PlannedCell]
    remarks: Mapping[int, Sequence[str]] = field(default_factory=dict)
    typed_id: str = ""

    @property
    def problems(self) -> Sequence[int]:
        """The problems that are checked."""
        return sorted({cell.problem for cell in self.cells if cell.problem})


def read_released_sheet(
    path: Path, course: str | Path | None = None, site: str | None = None, key: str = ""
) -> ReleasedSheet:
    """Read the notebook of a released sheet, from solutions/ or exercises/.

    course  the course that has the sheet, by its package or its folder; by default the installed course that has it
    site    the address of the course's site; by default the one that the course names
    key     the instructor's key; the notebook must have the solution then

    Raises ValueError for a notebook that opens no sheet or has no check cells, or two of the same name, if no course has the
    sheet, and for a site whose address is not complete.
    """
    try:
        content = path.read_bytes()
        cells = code_cells(content)
    except OSError as error:
        raise ValueError(f"SHEET must be the notebook of a sheet; {path} cannot be read: {error.strerror}.") from error
    except UnusableNotebook as error:
        raise ValueError(
            f"SHEET must be the notebook of a sheet, such as solutions/X/X.ipynb; {path} is none."
        ) from error
    opening = next((cell.source for cell in cells if OPEN_SHEET_CALL.search(cell.source)), "")
    opened = match[1] if (match := OPEN_SHEET_CALL.search(opening)) else None
    checks = {int(cell.name.removeprefix("check-")): cell.source for cell in cells if _is_check(cell.name)}
    if opened is None or not checks:
        raise ValueError(
            f"{path} must call open_sheet and have cells named check-1, check-2, ...; is it the notebook of a sheet?"
        )
    names = Counter(cell.name for cell in cells if _is_check(cell.name))
    if repeated := ", ".join(name for name, count in names.items() if count > 1):
        raise ValueError(
            f"{path}: each cell must have a grade_id of its own; got {repeated} more than once. A copied cell keeps the "
            "grade_id: change it in the metadata of the copy."
        )
    complete = path.resolve()
    with (
        chdir(path.parent) if course is None else nullcontext()
    ):  # a course may find a sheet by a file beside the notebook
        owner = find_course(course) if course else _owner(opened, complete)
    site = owner.site if site is None else site
    if site and not site.startswith(("https://", "http://")):
        raise ValueError(f"The address of the site must begin with https:// or http://; got {site!r}.")
    opening = re.sub(rf"(['\"]){SAMPLE_ID}\1", '""', opening)
    return ReleasedSheet(opened, path.parent, checks, owner.reference, site, opening, key, content if key else b"")


def _owner(sheet: str, path: Path) -> Course:
    """The installed course that has a sheet, or else the course in the folder that has solutions/ with its notebook."""
    try:
        return course_of(sheet)
    except ValueError as not_installed:
        try:
            beside = course_in(path.parents[2])
        except (ValueError, IndexError):
            raise not_installed from None
        if sheet not in beside.sheets():
            raise not_installed
        return beside


def plan_run(sheet: ReleasedSheet, content: bytes) -> RunPlan:
    """Decide what to run: the submission's cells in their order, with the sheet's own check cells.

    Raises UnusableNotebook if the file has nothing to run, or is another sheet.
    """
    cells = code_cells(content)
    checks = {_normalize(source): k for k, source in sheet.checks.items()}
    problems = [_problem_of(cell, checks) for cell in cells]
    opened = {name for cell in cells for name in OPEN_SHEET_CALL.findall(cell.source)}
    if sheet.name not in opened and (opened or not any(problems)):
        shown = ", ".join(sorted(name[:80] for name in opened)[:5])
        reason = f"it opens {shown}" if opened else "none of its cells belongs to it"
        raise UnusableNotebook(f"This is not sheet {sheet.name}: {reason}. Was another file handed in by mistake?")
    planned = [PlannedCell(sheet.opening)] if sheet.opening else []
    remarks = {k: list[str]() for k in sheet.checks}
    where = _where_checked(sheet, cells, problems)
    for place, (cell, k) in enumerate(zip(cells, problems, strict=True)):
        planned.append(PlannedCell(_runnable(cell) if k is None else sheet.checks[k], k, cell.index))
        if k is not None and _normalize(cell.source) != _normalize(sheet.checks[k]):
            remarks[k].append("Its check cell was edited; the sheet's own check cell was run instead.")
            if any(int(call[1]) == k for call in CHECK_CALL.finditer(cell.source)):
                planned.append(PlannedCell(_runnable(cell), k, is_fallback=True))
                remarks[k][-1] = (
                    "Its check cell was edited; the sheet's own check cell was run too, and counts if it has an answer."
                )
        planned += [where[own][1] for own in sheet.checks if where[own][0] == place]
    planned += [cell for place, cell in where.values() if place == len(cells)]
    for k in sheet.checks:
        count = problems.count(k)
        if count == 0:
            remarks[k].append("Its check cell was deleted; the sheet's own check cell was run.")
        elif count > 1:
            remarks[k].append(f"Its check cell occurs {count} times; the last one that has an answer counts.")
    remarks = {k: lines for k, lines in remarks.items() if lines}
    return RunPlan([*planned, PlannedCell(RERUN_SOURCE)], remarks, typed_id(cells))


def typed_id(cells: Sequence[CodeCell]) -> str:
    """The id that is typed in the cells; "" if there is none."""
    match = next((match for cell in cells if (match := STUDENT_ASSIGNMENT.search(cell.source))), None)
    return match[2].strip() if match else ""


def _runnable(cell: CodeCell) -> str:
    """The source of a cell, or, of one that is too long, a line that says so."""
    if len(cell.source) <= MAX_CELL_CHARACTERS:
        return cell.source
    size = f"{len(cell.source) / 1e6:.1f} MB"
    message = f"This cell was left out: it has {size} of code, and at most {MAX_CELL_CHARACTERS / 1e6:g} MB are run."
    return f"raise RuntimeError({message!r})"


def _where_checked(
    sheet: ReleasedSheet, cells: Sequence[CodeCell], problems: Sequence[int | None]
) -> dict[int, tuple[int, PlannedCell]]:
    """Where else each problem is checked, after which cell, and by which cell: where its variable is set for the last time.

    If its check cell is below that, there is nothing to add, and the place is -1. If it is above, it was the last to run only if
    the student ran it again, as the execution counts show; otherwise the check that is added is a fallback.
    """
    variables = {k: call[2] for k, source in sheet.checks.items() if (call := CHECK_CALL.search(source))}
    last_set, last_check = dict[str, int](), dict[int, int]()
    for place, (cell, problem) in enumerate(zip(cells, problems, strict=True)):
        if problem is None:
            last_set |= dict.fromkeys(_assigned_names(cell.source, set(variables.values())), place)
        else:
            last_check[problem] = place
    where = {}
    for k, source in sheet.checks.items():
        setting = last_set.get(variables.get(k, ""))
        checking = last_check.get(k)
        if checking is not None and (setting is None or setting < checking):
            where[k] = -1, PlannedCell(source, k)
            continue
        counts = [cell.count for cell, problem in zip(cells, problems, strict=True) if problem == k]
        was_run_again = setting is not None and any(0 < cells[setting].count < count for count in counts)
        is_fallback = checking is not None and not was_run_again
        where[k] = (len(cells) if setting is None else setting), PlannedCell(source, k, is_fallback=is_fallback)
    return where


def _assigned_names(source: str, names: set[str]) -> set[str]:
    """Which of these names a cell sets, to something else than `...` or `None`."""
    if not any(name in source for name in names) or len(source) > MAX_CELL_CHARACTERS:
        return set()
    for python in (source, "\n".join(map(_python_line, source.split("\n")))):
        with suppress(SyntaxError, ValueError, RecursionError, MemoryError), warnings.catch_warnings(action="ignore"):
            return names & set(_set_names(ast.parse(python)))
    return set()  # the whole cell fails when it is run


def _python_line(line: str) -> str:
    """A line of IPython as Python: what it measures stays, what a program or a magic returns is 0, any other magic is left out."""
    text = line.lstrip()
    indent = line[: len(line) - len(text)]
    if text.startswith("%time "):
        return indent + text.removeprefix("%time").lstrip()
    if text.startswith(("%", "!", "?")) or text.rstrip().endswith("?"):
        return f"{indent}pass"
    head, _, value = line.partition("=")
    return f"{head}= 0" if value.lstrip().startswith(("%", "!")) else line


def _set_names(tree: ast.AST) -> Iterator[str]:
    """The names that are set, or of which an item or an attribute is set; without those that are set to `...` or `None`."""
    blank = set[ast.AST]()
    for node in ast.walk(tree):
        match node:
            case ast.Assign(targets=targets, value=ast.Constant(value=None | builtins.Ellipsis)):
                blank.update(targets)
            case ast.AnnAssign(target=target, value=None | ast.Constant(value=None | builtins.Ellipsis)):
                blank.add(target)
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.alias(name=name, asname=other):
                yield other or name
            case ast.Name(ctx=ast.Store()) | ast.Attribute(ctx=ast.Store()) | ast.Subscript(ctx=ast.Store()):
                part: ast.AST = node
                while isinstance(part, ast.Attribute | ast.Subscript):
                    part = part.value
                if isinstance(part, ast.Name) and node not in blank:
                    yield part.id


def _problem_of(cell: CodeCell, checks: Mapping[str, int]) -> int | None:
    """The problem that a cell checks: by its name, or, if an editor lost the name, by its source."""
    if _is_check(cell.name) and (k := int(cell.name.removeprefix("check-"))) in checks.values():
        return k
    return checks.get(_normalize(cell.source))


def _is_check(name: str) -> bool:
    return re.fullmatch(r"check-\d{1,3}", name) is not None


def _normalize(source: str) -> str:
    """The source without whitespace and comments, which editors change."""
    return re.sub(r"#.*|\s", "", source)
