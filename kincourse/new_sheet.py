"""A new sheet: from the URDF of a robot to the instructor's notebook, in one command.

    kincourse new-sheet robot.urdf --out solutions/my_robot

The folder then holds the notebook with its solutions and the robot as a JSON file, which the students' copies need too.
"""

import argparse
import os
import sys
from pathlib import Path

from kincourse import sheets
from kincourse.robot_sheets.robot_sheet import SHEET_NAME, dumps, robot_sheet, tasks_for, with_plain_name
from kinlib.chains.chain import Chain
from misstep.release.instructor_notebook import notebook

IMPORT_LINES = "import numpy as np\n\nimport kinlib as kl\nfrom kincourse import open_sheet"

INTRO_TEMPLATE = """\
{count} problems, {points} points, on {robot}. The numbers are your own: they come from your id. Replace the `...` in each \
answer cell, run the cell, and then run the check below it. You may check as often as you like; the last answer counts.

A wrong answer costs nothing here. If it comes from a common mistake, the card names the mistake and the section to read \
again. The robot is stored in the file `{file}`: keep it in the folder of this notebook."""


def new_sheet(
    robot: Chain | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    base: str | None = None,
    tip: str | None = None,
    name: str | None = None,
    force: bool = False,
) -> Path:
    """Write the sheet of a robot into a folder, and return the path of its notebook.

    robot      a chain, or the path or the text of a URDF
    out        the folder; its name is the name of the sheet, which students pass to open_sheet
    base, tip  the first and the last link of the arm, as for load_urdf
    name       the name of the robot in statements; by default that in its file
    force      whether to overwrite a sheet that is already in the folder

    Raises ValueError if the robot cannot be read, or if the name is invalid or taken.
    Raises FileExistsError if `out` is a file, or a folder that is not empty and `force` is false.
    """
    folder = Path(out)
    sheet_name = folder.name
    if not SHEET_NAME.fullmatch(sheet_name):
        raise ValueError(
            "The name of a sheet must be a letter followed by letters, digits and _, at most 40 characters in all; "
            f"got {sheet_name!r}. It is the name of the folder: try --out solutions/my_robot."
        )
    if sheet_name in sheets():
        raise ValueError(f"The course already has a sheet {sheet_name!r}. Choose another name for the folder.")
    if folder.is_file():
        raise FileExistsError(f"--out must be a folder; {folder} is a file. Choose another folder.")
    if folder.is_dir() and any(folder.iterdir()) and not force:
        raise FileExistsError(
            f"The folder must be empty; {folder} is not. Choose another folder, or overwrite the sheet with --force."
        )
    chain = _load_robot(robot, base, tip)
    chain = with_plain_name(chain.changed(name=name or chain.name))
    sheet = robot_sheet(sheet_name, chain)
    entries = [
        task.entry._replace(solution=task.entry.solution.replace("{k}", str(k)))
        for k, task in enumerate(tasks_for(chain), start=1)
    ]
    intro = INTRO_TEMPLATE.format(count=len(entries), points=sheet.points, robot=chain.name, file=f"{sheet_name}.json")
    text = notebook(sheet, entries, intro, IMPORT_LINES)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{sheet_name}.ipynb"
    path.write_text(text, encoding="utf-8", newline="\n")
    path.with_suffix(".json").write_text(dumps(chain), encoding="utf-8", newline="\n")
    return path


def _load_robot(robot: Chain | str | os.PathLike[str], base: str | None, tip: str | None) -> Chain:
    if isinstance(robot, Chain):
        return robot
    from kinlib.urdf.chains import load_urdf

    try:
        return load_urdf(robot, base, tip)
    except ValueError as fault:
        if str(robot).lstrip().startswith("<"):
            raise
        raise ValueError(f"{robot}: {fault}") from fault


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of the command."""
    parser.add_argument("robot", metavar="robot.urdf", help="the URDF of the robot")
    parser.add_argument("--out", required=True, metavar="FOLDER", help="the folder of the sheet: solutions/my_robot")
    parser.add_argument("--base", metavar="LINK", help="the link whose frame is the robot's base (default: the root)")
    parser.add_argument(
        "--tip", metavar="LINK", help="the link whose frame is its flange (default: the end of the arm)"
    )
    parser.add_argument("--name", help="the name of the robot in statements (default: as in its file)")
    parser.add_argument("--force", action="store_true", help="overwrite a sheet that is already there")


def run(options: argparse.Namespace) -> int:
    """Write the sheet, and return the exit code: 0 done, 2 if it cannot be written, with the reason in one sentence."""
    try:
        path = new_sheet(
            options.robot, options.out, base=options.base, tip=options.tip, name=options.name, force=options.force
        )
    except (ValueError, OSError) as fault:
        print(f"kincourse new-sheet: {fault}", file=sys.stderr)
        return 2
    print(f"written: {path} and {path.with_suffix('.json').name}, the robot")
    print("The students' copy: misstep release")
    return 0
