"""A sheet for any robot: which problems it bears.

A robot with one joint has no table worth asking for, and where all joints slide nobody confuses degrees with radians. So
each task is tried on the robot first; one that has too few mistakes to tell apart makes room for another.
"""

from collections.abc import Sequence
from functools import partial

from kincourse.robot_sheets.motion_tasks import MOTION_TASKS
from kincourse.robot_sheets.screw_tasks import SCREW_TASKS
from kincourse.robot_sheets.table_tasks import TABLE_TASKS
from kincourse.robot_sheets.task import RobotTask
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.chain import Chain
from misstep.problem import Template
from misstep.sheet import Sheet

PROBLEMS_PER_SHEET = 8
"""How many problems a sheet has."""

PROBE_STUDENTS = ("probe 1", "probe 2", "probe 3", "probe 4")
"""The students for whom a task is tried."""

MAX_DRAWS = 8
"""Within how many draws a task has to be telling for each of them. A student's own draws go on far longer."""

TASKS: dict[str, RobotTask] = {**MOTION_TASKS, **SCREW_TASKS, **TABLE_TASKS}

TASK_ORDER = (
    *("home_pose", "space_screws", "body_screws", "where_is_the_tool"),
    *("standard_table", "modified_table", "faulty_entry", "which_mistake"),
    *("body_form", "point_of_the_tool", "back_to_space", "new_tool"),
)
"""The tasks in the order in which a robot gets them: the last ones stand in for those before that make no sense for it."""


def tasks_for(robot: Chain) -> list[str]:
    """The names of the eight tasks that make sense for a robot, in the order of the sheet.

    Raises ValueError when there are not enough of them.

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
            f"{robot.name} bears {len(fit)} problems, and a sheet has {PROBLEMS_PER_SHEET}: {', '.join(fit)}. Do its joints move anything?"
        )
    return fit


def _fits(robot: Chain, name: str) -> bool:
    if name in TABLE_TASKS and "H" in robot.joint_types:
        return False  # no row of a table holds a helical joint
    return all(
        any(TASKS[name].write(robot, ArmSampler(student, name, attempt)).telling() for attempt in range(MAX_DRAWS))
        for student in PROBE_STUDENTS
    )


def robot_sheet(name: str, robot: Chain, tasks: Sequence[str]) -> Sheet:
    """The sheet of a robot, with the tasks in this order.

    Raises ValueError for a task that there is not.

    >>> from kinlib.chains.robots import rpr
    >>> robot_sheet("my_robot", rpr(), ["home_pose"]).problems[0].number
    'my_robot.1'
    """
    if unknown := [task for task in tasks if task not in TASKS]:
        raise ValueError(
            f"There is no task {unknown[0]!r}. Was the sheet made by a newer kinlib? The tasks are: {', '.join(TASKS)}."
        )
    templates = [_template(name, k, robot, TASKS[task]) for k, task in enumerate(tasks, start=1)]
    return Sheet(name, f"Forward kinematics of {robot.name}", templates)


def _template(name: str, k: int, robot: Chain, task: RobotTask) -> Template:
    return Template(f"{name}.{k}", task.title, task.points, task.lecture, partial(task.write, robot), ArmSampler)
