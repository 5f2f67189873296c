"""A task of a sheet for any robot: a problem whose robot is not chosen yet."""

from collections.abc import Callable
from typing import NamedTuple

from kincourse.sampling.arms import ArmSampler
from kinlib.chains.chain import Chain
from misstep.problem import Problem
from misstep.release.instructor_notebook import Entry

Write = Callable[[Chain, ArmSampler], Problem]


class RobotTask(NamedTuple):
    """A problem without its robot, and its cells in the instructor's notebook.

    lecture  where to re-read, notebook and heading: "03_poe_space#The product"
    write    the function that writes the problem of a robot with a student's numbers
    entry    the cells; {k} in its solution stands for the number of the problem
    """

    title: str
    points: int
    lecture: str
    write: Write
    entry: Entry


def task(title: str, points: int, lecture: str, asked: tuple[str, str], solution: str) -> Callable[[Write], RobotTask]:
    """Decorate a function that writes the problem of a robot, and so make it a task.

    asked  the variable of the answer, and what to answer with
    """
    return lambda write: RobotTask(title, points, lecture, write, Entry(*asked, solution))
