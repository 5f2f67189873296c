"""What can be asked of a robot that somebody brought: a task is a problem that waits for its robot."""

from collections.abc import Callable
from typing import NamedTuple

from kincourse.sampling.arms import ArmSampler
from kinlib.chains.chain import Chain
from misstep.problem import Problem
from misstep.release.instructor_notebook import Entry


class RobotTask(NamedTuple):
    """A problem before it has a robot, and its cells in the notebook. In a solution, {k} is the number of the problem."""

    title: str
    points: int
    lecture: str
    write: Callable[[Chain, ArmSampler], Problem]
    entry: Entry
