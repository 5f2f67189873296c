"""The JSON file of a robot, which lies beside the notebook of its sheet: how it is written, read and found.

The file holds the robot and the names of the tasks. It holds no answers, because they depend on the student's numbers.
"""

import json
import re
from collections.abc import Sequence
from pathlib import Path

from kincourse.robot_sheets.robot_sheet import robot_sheet
from kinlib.chains.chain import Chain
from misstep.sheet import Sheet

FORMAT_VERSION = 1
"""The version of the file format."""

SHEET_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
"""The names that a sheet may have: they are valid file names on every system, and contain no path."""


def dumps(robot: Chain, tasks: Sequence[str]) -> str:
    """Write a robot and its tasks as the text of a JSON file. Numbers keep all their digits, so that variants are reproducible.

    >>> from kinlib.chains.robots import rpr
    >>> loads(dumps(rpr(), ["home_pose"]), "a test")[1]
    ['home_pose']
    """
    data = {"kinlib sheet": FORMAT_VERSION, "tasks": list(tasks), **robot.to_dict()}
    return json.dumps(data, ensure_ascii=False) + "\n"


def loads(text: str, source: str) -> tuple[Chain, list[str]]:
    """Read a robot and its tasks from the text of a file that `dumps` wrote.

    source  the path of the file, for error messages

    Raises ValueError if the text is not such a file.
    """
    try:
        data = json.loads(text)
        if (version := data.pop("kinlib sheet")) != FORMAT_VERSION:
            raise ValueError(f"its format is {version!r}, and this kincourse reads format {FORMAT_VERSION}")
        tasks = [str(task) for task in data.pop("tasks")]
        return Chain.from_dict(data), tasks
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f"{source} is not a valid file of a robot sheet: {error}. If it was edited by hand, take a fresh copy."
        ) from error


def validate_name(name: str) -> str:
    """Return the name of a sheet if it is a valid one.

    Raises ValueError if it is not: a letter, then letters, digits and underscores, at most 40 characters.

    >>> validate_name("my_robot")
    'my_robot'
    """
    if not SHEET_NAME.fullmatch(name):
        raise ValueError(
            "The name of a sheet must be a letter followed by letters, digits and _, at most 40 characters in all; "
            f"got {name!r}. It is the name of the folder: try --out solutions/my_robot."
        )
    return name


def search_paths(name: str) -> list[Path]:
    """Where the file of a robot is searched for: beside the notebook, then in the folder of its sheet below the project's root."""
    return [Path(f"{name}.json"), *(Path(folder, name, f"{name}.json") for folder in ("", "solutions", "exercises"))]


def find(name: str) -> Sheet | None:
    """Find the sheet of a robot by its name, through the robot's file in one of `search_paths`; None if there is no file.

    Raises ValueError if the file is not a valid file of a robot sheet.

    >>> find("nobodys_robot") is None
    True
    """
    for path in search_paths(name) if SHEET_NAME.fullmatch(str(name)) else ():
        if path.is_file():
            return robot_sheet(name, *loads(path.read_text(encoding="utf-8"), str(path)))
    return None
