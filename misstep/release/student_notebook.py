"""`misstep release`: the students' notebooks in exercises/, made from the instructors' notebooks in solutions/.

    misstep release           write the worked solutions in solutions/, and every notebook of exercises/ that is stale
    misstep release --check   list the notebooks that are stale, and write nothing

All steps are nbgrader's own, so `nbgrader generate_assignment` and this command release the same notebook.
"""

import argparse
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from misstep.catalog import find_course
from misstep.release.instructor_notebook import WORKED, with_worked_solutions

STUB = "# your lines here"
"""The comment that replaces a solution. The line above it, for example `voltage_1 = ...`, names the answer."""


def student_version(source: Path) -> str:
    """Return the text of the student's version of a file: a notebook without its solutions, or any other file unchanged.

    Raises ValueError if two cells have the same grade_id, or if nbgrader refuses the metadata of a cell.
    """
    if source.suffix != ".ipynb":
        return source.read_text(encoding="utf-8")
    # They come with the extra `release`, and `misstep release --help` works without it.
    import nbformat
    from nbgrader.nbgraderformat import ValidationError
    from nbgrader.preprocessors import CheckCellMetadata, ClearOutput, ClearSolutions, ComputeChecksums, LockCells
    from traitlets.config import Config

    stub = Config({"ClearSolutions": {"code_stub": {"python": STUB}}})
    notebook = nbformat.read(source, as_version=4)
    notebook.cells = [cell for cell in notebook.cells if not cell.get("id", "").startswith(WORKED)]
    ids = Counter(cell.metadata.nbgrader.get("grade_id") for cell in notebook.cells if "nbgrader" in cell.metadata)
    if repeated := ", ".join(repr(name) for name, times in ids.items() if times > 1):
        raise ValueError(
            f"{source}: each cell must have a grade_id of its own; got {repeated} more than once. A copied cell keeps the "
            "grade_id: delete the copy."
        )
    for step in (LockCells, ClearSolutions, ClearOutput, CheckCellMetadata, ComputeChecksums):
        try:
            notebook, _ = step(config=stub).preprocess(notebook, {"nbgrader": {}})
        except ValidationError as error:
            raise ValueError(f"{source}: {error}") from error
    return str(nbformat.writes(notebook)) + "\n"


def sheet_files(root: Path) -> Iterator[tuple[Path, Path]]:
    """Yield each notebook and JSON file in solutions/, with the path of its student's version in exercises/."""
    for source in sorted([*(root / "solutions").glob("*/*.ipynb"), *(root / "solutions").glob("*/*.json")]):
        yield source, root / "exercises" / source.relative_to(root / "solutions")


def find_unworked(root: Path) -> dict[Path, str]:
    """Return the notebooks in solutions/ of the course's sheets whose worked solutions are stale, with what they must be."""
    course = find_course()
    found = {}
    for source, _ in sheet_files(root):
        if source.suffix == ".ipynb" and source.stem in course.sheets():
            text = source.read_text(encoding="utf-8")
            if (worked := with_worked_solutions(text, course.find_sheet(source.stem))) != text:
                found[source] = worked
    return found


def find_stale(root: Path) -> list[Path]:
    """Return the student's files that are missing, or that differ from what their source releases."""
    return [
        target
        for source, target in sheet_files(root)
        if not target.exists() or target.read_text(encoding="utf-8") != student_version(source)
    ]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument("--check", action="store_true", help="list the notebooks that are stale, and write nothing")
    parser.add_argument("--root", type=Path, default=Path(), help="the folder that holds solutions/ (default: here)")


def run(options: argparse.Namespace) -> int:
    """Write the notebooks that are stale, or list them. The exit code is 1 for --check with stale notebooks."""
    if not any(sheet_files(options.root)):
        raise ValueError(
            f"{options.root.resolve()} has no solutions/*/*.ipynb. Give the folder that contains solutions/ by --root."
        )
    unworked = find_unworked(options.root)
    for source, text in unworked.items():
        print(f"{'stale' if options.check else 'written'}: {source.relative_to(options.root)}")
        if not options.check:
            source.write_text(text, encoding="utf-8", newline="\n")
    for target in (stale := find_stale(options.root)):
        source = options.root / "solutions" / target.relative_to(options.root / "exercises")
        released = student_version(source)
        print(f"{'stale' if options.check else 'written'}: {target.relative_to(options.root)}")
        if not options.check:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(released, encoding="utf-8", newline="\n")
    if not stale and not options.check:
        print(f"Nothing to write: the notebooks in {options.root / 'exercises'} are those of solutions.")
    return 1 if (stale or unworked) and options.check else 0
