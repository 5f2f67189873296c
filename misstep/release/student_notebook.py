"""`misstep release`: the students' notebooks in exercises/, made from the instructors' notebooks in solutions/.

    misstep release           write the worked solutions in solutions/, and every notebook of exercises/ that is stale
    misstep release --check   list the notebooks that are stale, and write nothing

All steps are nbgrader's own, so `nbgrader generate_assignment` and this command release the same notebook.
"""

import argparse
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
    for step in (LockCells, ClearSolutions, ClearOutput, CheckCellMetadata, ComputeChecksums):
        try:
            notebook, _ = step(config=stub).preprocess(notebook, {"nbgrader": {}})
        except ValidationError as error:
            raise ValueError(f"{source}: {error}") from error
    return str(nbformat.writes(notebook)) + "\n"


def find_stale(root: Path) -> dict[Path, str]:
    """Return the files that are missing or stale, with what they must be: of students, and solutions without worked ones."""
    course, stale = find_course(), dict[Path, str]()
    for source in sorted([*(root / "solutions").glob("*/*.ipynb"), *(root / "solutions").glob("*/*.json")]):
        wanted = {root / "exercises" / source.relative_to(root / "solutions"): student_version(source)}
        if source.suffix == ".ipynb" and source.stem in course.sheets():
            wanted[source] = with_worked_solutions(source.read_text("utf-8"), course.find_sheet(source.stem))
        stale.update(
            (path, text) for path, text in wanted.items() if not path.exists() or path.read_text("utf-8") != text
        )
    return stale


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument("--check", action="store_true", help="list the notebooks that are stale, and write nothing")
    parser.add_argument("--root", type=Path, default=Path(), help="the folder that holds solutions/ (default: here)")


def run(options: argparse.Namespace) -> int:
    """Write the notebooks that are stale, or list them. The exit code is 1 for --check with stale notebooks."""
    if not any((options.root / "solutions").glob("*/*.ipynb")):
        raise ValueError(
            f"{options.root.resolve()} has no solutions/*/*.ipynb. Give the folder that contains solutions/ by --root."
        )
    stale = find_stale(options.root)
    for path, text in stale.items():
        print(f"{'stale' if options.check else 'written'}: {path.relative_to(options.root)}")
        if not options.check:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
    return int(bool(stale) and options.check)
