"""What can be asked of a robot that somebody brought: a task is a problem that waits for its robot."""

from collections.abc import Callable
from typing import NamedTuple

from kinlib.chain import Chain
from kinlib.practice.draw import Draw
from kinlib.practice.notebook import Entry
from kinlib.practice.problem import Problem


class Task(NamedTuple):
    """A problem before it has a robot, and its cells in the notebook. In a solution, {k} is the number of the problem."""

    title: str
    points: int
    lecture: str
    write: Callable[[Chain, Draw], Problem]
    entry: Entry
