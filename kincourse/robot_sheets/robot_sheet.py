"""A sheet for any robot, made of the tasks that make sense for the robot.

For example, a robot with one joint has no DH table worth asking for, and if all joints are prismatic, degrees cannot be
confused with radians. So each task is tried on the robot first, and a task in which too few mistakes can be told apart is
replaced by another one.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from kincourse.robot_sheets.motion_tasks import MOTION_TASKS
from kincourse.robot_sheets.screw_tasks import SCREW_TASKS
from kincourse.robot_sheets.table_tasks import TABLE_TASKS
from kincourse.robot_sheets.task import RobotTask
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.chain import Chain
from misstep.problem import Problem, Template
from misstep.sheet import Sheet

PROBLEMS_PER_SHEET = 8
"""The number of problems of a sheet."""

PROBE_STUDENTS = ("probe 1", "probe 2", "probe 3", "probe 4")
"""The students whose numbers are drawn to try a task on a robot."""

MAX_DRAWS = 8
"""The number of draws within which a task must be discriminating for each of them. A student's own variant has more."""

MIN_MISTAKES = 3
"""A task with fewer mistakes makes no sense for a robot."""

CLEAREST_OF = 4
"""The number of draws of which the one is taken in which the most mistakes can be seen."""

TASKS: dict[str, RobotTask] = {**MOTION_TASKS, **SCREW_TASKS, **TABLE_TASKS}

TASK_ORDER = (
    *("home_pose", "space_screws", "body_screws", "where_is_the_tool"),
    *("standard_table", "modified_table", "faulty_entry", "which_mistake"),
    *("body_form", "point_of_the_tool", "back_to_space", "new_tool"),
)
"""The tasks in order of preference: the last ones replace those before them that make no sense for a robot."""


def tasks_for(robot: Chain) -> list[str]:
    """Choose the eight tasks of the sheet for a robot: the first ones in TASK_ORDER that make sense for it.

    Raises ValueError if fewer than eight make sense.

    >>> from kinlib.chains.robots import rpr
    >>> tasks_for(rpr())[4:]
    ['standard_table', 'modified_table', 'faulty_entry', 'which_mistake']
    """
    fit: list[str] = []
    for name in TASK_ORDER:
        if len(fit) < PROBLEMS_PER_SHEET and _fits(robot, name):
            fit.append(name)
    if len(fit) < PROBLEMS_PER_SHEET:
        raise ValueError(
            f"A sheet needs {PROBLEMS_PER_SHEET} problems; only {len(fit)} of the {len(TASKS)} tasks make sense for {robot.name}: "
            f"{', '.join(fit)}. Check that its joints move its tool."
        )
    return fit


def _fits(robot: Chain, name: str) -> bool:
    if name in TABLE_TASKS and "H" in robot.joint_types:
        return False  # a DH row cannot describe a helical joint
    if name == "modified_table" and robot.n == 1:
        return False  # the only row has no axis before it
    return all(
        any(
            problem.is_discriminating() and _mistake_count(problem) >= MIN_MISTAKES
            for problem in (
                _clearest_problem(TASKS[name], robot, ArmSampler(student, name, attempt))
                for attempt in range(MAX_DRAWS)
            )
        )
        for student in PROBE_STUDENTS
    )


def _mistake_count(problem: Problem) -> int:
    return len(problem.known_mistakes) + len(problem.slips)


def _clearest_problem(task: RobotTask, robot: Chain, sampler: ArmSampler) -> Problem:
    """Write the problem of a task; of a few draws, the one in which the fewest mutants of the solution give the right answer.

    They are declared to be invisible: for a robot whose joints only translate, for example, the order of the joints never matters.
    """
    problems: list[Problem] = []
    while len(problems) < CLEAREST_OF:
        problems.append(task.write(robot, sampler))
        if not problems[-1].hidden and _mistake_count(problems[-1]) >= MIN_MISTAKES:
            return problems[-1]
    clearest = max(problems, key=lambda problem: (-len(problem.hidden), _mistake_count(problem)))
    return replace(clearest, invisible=clearest.hidden)


def with_plain_name(robot: Chain) -> Chain:
    """Return a robot whose name has no characters that Markdown, HTML or LaTeX would interpret, for its statements.

    >>> from kinlib.chains.robots import rpr
    >>> with_plain_name(rpr().changed(name="ur5_robot *left*")).name
    'ur5_robot left'
    """
    return robot.changed(name=re.sub(r"[^\w .()+-]", "", robot.name)[:60].strip() or "the robot")


def robot_sheet(name: str, robot: Chain, tasks: Sequence[str]) -> Sheet:
    """Make the sheet of a robot, with the tasks in this order.

    Raises ValueError if a task is unknown.

    >>> from kinlib.chains.robots import rpr
    >>> robot_sheet("my_robot", rpr(), ["home_pose"]).problems[0].number
    'my_robot.1'
    """
    if unknown := [task for task in tasks if task not in TASKS]:
        raise ValueError(
            f"There is no task {unknown[0]!r}. The tasks are: {', '.join(TASKS)}. If the sheet was made by a newer kincourse, update it."
        )
    templates = [_template(name, k, robot, TASKS[task]) for k, task in enumerate(tasks, start=1)]
    return Sheet(name, f"Forward kinematics of {robot.name}", templates)


def _template(name: str, k: int, robot: Chain, task: RobotTask) -> Template:
    return Template(
        f"{name}.{k}", task.title, task.points, task.lecture, partial(_clearest_problem, task, robot), ArmSampler
    )
