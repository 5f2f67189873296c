"""Release: the students' notebooks in exercises/, made from the instructors' notebooks in solutions/.

    misstep release           write every notebook of exercises/ that is stale
    misstep release --check   name the notebooks that are stale, and write nothing

The steps are nbgrader's own, so that `nbgrader generate_assignment` and this command release the same notebook.
"""

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import nbformat
from nbgrader.preprocessors import CheckCellMetadata, ClearOutput, ClearSolutions, ComputeChecksums, LockCells
from traitlets.config import Config

STEPS = (LockCells, ClearSolutions, ClearOutput, CheckCellMetadata, ComputeChecksums)

STUB = Config({"ClearSolutions": {"code_stub": {"python": "# your lines here"}}})
"""What a student finds where the solution stood. The line above it, `screws_1 = ...`, names what to fill."""


def student_version(source: Path) -> str:
    """The student's version of an instructor's notebook, as the text of a file. The file of a robot stays as it is."""
    if source.suffix != ".ipynb":
        return source.read_text(encoding="utf-8")
    notebook = nbformat.read(source, as_version=4)
    for step in STEPS:
        notebook, _ = step(config=STUB).preprocess(notebook, {"nbgrader": {}})
    return str(nbformat.writes(notebook)) + "\n"


def sheet_files(root: Path) -> Iterator[tuple[Path, Path]]:
    """Every file of a sheet below a project's root: the instructor's notebook or a robot, and where the student's belongs."""
    for source in sorted([*(root / "solutions").glob("*/*.ipynb"), *(root / "solutions").glob("*/*.json")]):
        yield source, root / "exercises" / source.relative_to(root / "solutions")


def find_stale(root: Path) -> list[Path]:
    """The student's files that are missing, or differ from what their source releases."""
    return [
        target
        for source, target in sheet_files(root)
        if not target.exists() or target.read_text(encoding="utf-8") != student_version(source)
    ]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument("--check", action="store_true", help="name the notebooks that are stale, and write nothing")
    parser.add_argument("--root", type=Path, default=Path(), help="the folder that holds solutions/ (default: here)")


def run(options: argparse.Namespace) -> int:
    """Write the notebooks that are stale, or name them. The exit code is 1 for --check with stale notebooks."""
    if not any(sheet_files(options.root)):
        print(
            f"misstep release: {options.root.resolve()} has no solutions/*/*.ipynb. Are you at the top of the project?",
            file=sys.stderr,
        )
        return 2
    for target in (late := find_stale(options.root)):
        print(f"{'stale' if options.check else 'written'}: {target.relative_to(options.root)}")
        if not options.check:
            target.parent.mkdir(parents=True, exist_ok=True)
            source = options.root / "solutions" / target.relative_to(options.root / "exercises")
            target.write_text(student_version(source), encoding="utf-8", newline="\n")
    return 1 if late and options.check else 0
