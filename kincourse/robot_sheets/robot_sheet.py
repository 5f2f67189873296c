"""A sheet for any robot, made of the tasks that make sense for the robot, and the JSON file that holds the robot.

The file lies beside the notebook of the sheet. It holds no answers, because they depend on the student's numbers.
"""

import json
import re
from dataclasses import replace
from functools import partial
from pathlib import Path

from kincourse.robot_sheets.tasks import TABLE_TASKS, TASKS, RobotTask
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.chain import Chain
from misstep.problem import Problem, Template
from misstep.sheet import Sheet

CLEAREST_OF = 4
"""The number of draws of which the one is taken in which the most mistakes can be seen."""

ENOUGH_MISTAKES = 3
"""A draw with as many mistakes, none of which gives the right answer, is taken at once."""

FORMAT_VERSION = 2
"""The version of the file format."""

SHEET_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
"""The names that a sheet may have: they are valid file names on every system, and contain no path."""


def tasks_for(robot: Chain) -> list[RobotTask]:
    """Return the tasks that make sense for a robot."""
    has_rows = robot.n > 1 and "H" not in robot.joint_types
    return [*TASKS, *(TABLE_TASKS if has_rows else ())]


def robot_sheet(name: str, robot: Chain) -> Sheet:
    """Make the sheet of a robot."""
    templates = [
        Template(f"{name}.{k}", task.title, task.points, task.lecture, partial(_clearest, task, robot), ArmSampler)
        for k, task in enumerate(tasks_for(robot), start=1)
    ]
    return Sheet(name, f"Forward kinematics of {robot.name}", templates)


def _clearest(task: RobotTask, robot: Chain, sampler: ArmSampler) -> Problem:
    """Write the problem of a task; of a few draws, the one in which the fewest mutants of the solution give the right answer.

    They are declared to be invisible: for a robot whose joints only translate, for example, the order of the joints never matters.
    """

    def count(problem: Problem) -> int:
        return len(problem.known_mistakes) + len(problem.slips)

    problems: list[Problem] = []
    while len(problems) < CLEAREST_OF:
        problem = task.write(robot, sampler)
        hidden = [one.name for one in problem.hidden_mutants()]
        if not hidden and count(problem) >= ENOUGH_MISTAKES:
            return problem
        problems.append(replace(problem, invisible=hidden))
    return max(problems, key=lambda problem: (-len(problem.invisible), count(problem)))


def with_plain_name(robot: Chain) -> Chain:
    """Return a robot whose name has no characters that Markdown, HTML or LaTeX would interpret, for its statements."""
    return robot.changed(name=re.sub(r"[^\w .()+-]", "", robot.name)[:60].strip() or "the robot")


def dumps(robot: Chain) -> str:
    """Write a robot as the text of a JSON file. Numbers keep all their digits, so that variants are reproducible."""
    return json.dumps({"kinlib sheet": FORMAT_VERSION, **robot.to_dict()}, ensure_ascii=False) + "\n"


def loads(text: str, source: str) -> Chain:
    """Read a robot from the text of a file that `dumps` wrote.

    source  the path of the file, for error messages

    Raises ValueError if the text is not such a file.
    """
    try:
        data = json.loads(text)
        if (version := data.pop("kinlib sheet")) != FORMAT_VERSION:
            raise ValueError(f"its format is {version!r}, and this kincourse reads format {FORMAT_VERSION}")
        return Chain.from_dict(data)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f"{source} is not a valid file of a robot sheet: {error}. If it was edited by hand, take a fresh copy."
        ) from error


def find(name: str) -> Sheet | None:
    """Find the sheet of a robot by its name, through its file; None if there is none.

    It is searched for beside the notebook, then in the folder of its sheet below the project's root.

    Raises ValueError if the file is not a valid file of a robot sheet.
    """
    folders = (Path(), *(Path(folder, str(name)) for folder in ("", "solutions", "exercises")))
    for path in (folder / f"{name}.json" for folder in folders) if SHEET_NAME.fullmatch(str(name)) else ():
        if path.is_file():
            return robot_sheet(name, loads(path.read_text(encoding="utf-8"), str(path)))
    return None
