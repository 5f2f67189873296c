"""The file in which a robot travels beside the notebook of its sheet, and where it is looked for.

It holds the robot and the names of its problems, and no answer: every student's are computed from their own numbers.
"""

import json
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from kincourse.robot_sheets.robot_sheet import robot_sheet
from kinlib.chains.chain import Chain
from misstep.sheet import Sheet

FORMAT_VERSION = 1
"""The version of the file."""

SHEET_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
"""What a sheet may be called: a word that is a file's name on every system, and no path."""


def dumps(robot: Chain, tasks: Sequence[str]) -> str:
    """A robot and its tasks as the text of a file: numbers to the last digit, so that every machine draws the same.

    >>> from kinlib.chains.robots import rpr
    >>> loads(dumps(rpr(), ["home_pose"]), "a test")[1]
    ['home_pose']
    """
    limits = (
        None
        if robot.limits is None
        else [[_limit_to_json(low), _limit_to_json(high)] for low, high in robot.limits.tolist()]
    )
    data = {
        "kinlib sheet": FORMAT_VERSION,
        "tasks": list(tasks),
        "name": robot.name,
        "source": robot.source,
        "joint_names": list(robot.joint_names),
        "screws": robot.screws.tolist(),
        "home": robot.home.tolist(),
        "points": robot.joint_points.tolist(),
        "limits": limits,
    }
    return json.dumps(data, ensure_ascii=False) + "\n"


def loads(text: str, where: str) -> tuple[Chain, list[str]]:
    """Read a robot and its tasks back.

    Raises ValueError for a text that is none of ours, and says where it stood.
    """
    try:
        data = json.loads(text)
        if data["kinlib sheet"] != FORMAT_VERSION:
            raise ValueError(f"it has form {data['kinlib sheet']!r}, and this kinlib reads form {FORMAT_VERSION}")
        limits = None if data["limits"] is None else np.array([_limits_from_json(*ends) for ends in data["limits"]])
        robot = Chain(
            data["screws"],
            data["home"],
            data["points"],
            str(data["name"]),
            str(data["source"]),
            limits,
            tuple(map(str, data["joint_names"])),
        )
        return robot, [str(task) for task in data["tasks"]]
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f"{where} holds no robot of a sheet: {error}. Was it changed by hand? Take a fresh copy."
        ) from error


def _limit_to_json(end: float) -> float | None:
    """A limit as JSON has it, which knows no infinity."""
    return end if np.isfinite(end) else None


def _limits_from_json(low: float | None, high: float | None) -> tuple[float, float]:
    return -np.inf if low is None else low, np.inf if high is None else high


def validate_name(name: str) -> str:
    """Pass a name on under which a sheet can go.

    Raises ValueError for any other.

    >>> validate_name("my_robot")
    'my_robot'
    """
    if not SHEET_NAME.fullmatch(name):
        raise ValueError(
            f"A sheet's name is a letter and then letters, digits and _, at most 40 in all; got {name!r}. It is the name of the folder: "
            "try --out solutions/my_robot."
        )
    return name


def search_paths(name: str) -> list[Path]:
    """Where the robot of a sheet may lie: beside the notebook, or in the sheet's folder below a project's root."""
    return [Path(f"{name}.json"), *(Path(folder, name, f"{name}.json") for folder in ("", "solutions", "exercises"))]


def find(name: str) -> Sheet | None:
    """The sheet of a robot that lies beside the notebook; None if none does.

    Raises ValueError for a file that cannot be read as one.

    >>> find("nobodys_robot") is None
    True
    """
    for path in search_paths(name) if SHEET_NAME.fullmatch(str(name)) else ():
        if path.is_file():
            return robot_sheet(name, *loads(path.read_text(encoding="utf-8"), str(path)))
    return None
