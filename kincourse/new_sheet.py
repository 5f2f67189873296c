"""A new sheet: from a robot's URDF to an instructor's notebook, in one command.

    kincourse new-sheet robot.urdf --out solutions/my_robot

The folder holds the notebook with its solutions, and the robot as data, which travels with the students' copies.
"""

import argparse
import os
import re
import sys
from dataclasses import replace
from pathlib import Path

from kincourse import sheets
from kincourse.robot_sheets.robot_file import dumps, validate_name
from kincourse.robot_sheets.robot_sheet import TASKS, robot_sheet, tasks_for
from kinlib.chains.chain import Chain
from misstep.release.instructor_notebook import notebook

IMPORT_LINES = "import numpy as np\n\nimport kinlib as kl\nfrom kincourse import open_sheet"

INTRO_TEMPLATE = """\
{count} problems, {points} points, on {robot}. The numbers are your own: they come from your id. Fill the cells that end in \
`...`, run them, and run the check below each. You may check as often as you like; the last answer counts.

A wrong answer costs nothing here. If it is one that people often give, the card says which step went astray and where to \
re-read. The robot travels in the file `{file}`: keep it beside this notebook."""

COUNT_WORDS = ("No", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten")


def new_sheet(
    robot: Chain | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    base: str | None = None,
    tip: str | None = None,
    name: str | None = None,
    force: bool = False,
) -> Path:
    """Write the sheet of a robot into a folder, and give the path of its notebook.

    robot      a chain, or the path or the text of a URDF
    out        the folder; its name is that of the sheet, which students give to open_sheet
    base, tip  from which link to which, as load_urdf takes them
    name       what the robot is called on the page; as in its file by default
    force      whether a sheet that is already in the folder may be written anew

    Raises ValueError for a robot that cannot be read, moves nothing or bears too few problems, and for a name that is none
    or is taken; FileExistsError for a folder that holds something already.

    >>> import tempfile
    >>> from kinlib.chains.robots import rpr
    >>> new_sheet(rpr(), Path(tempfile.mkdtemp(), "my_crane")).name
    'my_crane.ipynb'
    """
    folder = Path(out)
    sheet_name = validate_name(folder.name)
    if sheet_name in sheets():
        raise ValueError(f"The course has a sheet {sheet_name!r} already. Call the folder by another name.")
    if folder.is_file():
        raise FileExistsError(f"{folder} is a file. The sheet wants a folder of its own.")
    if folder.is_dir() and any(folder.iterdir()) and not force:
        raise FileExistsError(f"{folder} holds something already. Take another folder, or write it anew with --force.")
    chain = _load_robot(robot, base, tip)
    robot_name = _plain_name(name or chain.name)
    chain = replace(chain, name=robot_name)
    tasks = tasks_for(chain)
    sheet = robot_sheet(sheet_name, chain, tasks)
    entries = [TASKS[task].entry for task in tasks]
    numbered_entries = [
        entry._replace(solution=entry.solution.replace("{k}", str(k))) for k, entry in enumerate(entries, start=1)
    ]
    intro = INTRO_TEMPLATE.format(
        count=COUNT_WORDS[len(tasks)], points=sheet.points, robot=robot_name, file=f"{sheet_name}.json"
    )
    text = notebook(sheet, numbered_entries, intro, IMPORT_LINES)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{sheet_name}.ipynb"
    path.write_text(text, encoding="utf-8", newline="\n")
    path.with_suffix(".json").write_text(dumps(chain, tasks), encoding="utf-8", newline="\n")
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


def _plain_name(name: str) -> str:
    """A robot's name as a page can show it: nothing in it that Markdown or mathematics would read.

    >>> _plain_name("ur5_robot *left*")
    'ur5_robot left'
    """
    return re.sub(r"[^\w .()+-]", "", name)[:60].strip() or "the robot"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("robot", metavar="robot.urdf", help="the URDF of the robot")
    parser.add_argument("--out", required=True, metavar="FOLDER", help="where the sheet goes: solutions/my_robot")
    parser.add_argument("--base", metavar="LINK", help="the link whose frame is the robot's base (default: the root)")
    parser.add_argument("--tip", metavar="LINK", help="the link whose frame is its flange (default: the only tip)")
    parser.add_argument("--name", help="what the robot is called on the page (default: as in its file)")
    parser.add_argument("--force", action="store_true", help="write a sheet anew that is already there")


def run(options: argparse.Namespace) -> int:
    """Write the sheet, or say in a sentence why not."""
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
