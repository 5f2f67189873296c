"""The course: which package it is, and what submissions need besides it."""

from misstep.catalog import Course
from misstep.sheet import Sheet


def find_robot_sheet(name: str) -> Sheet | None:
    """The sheet of a robot whose file lies beside the notebook; None if there is none.

    Raises ValueError for a file that is not the file of a robot sheet.
    """
    from kincourse.robot_sheets.robot_file import find  # problems of any robot are loaded only if there is one

    return find(name)


COURSE = Course(
    "kincourse",
    requires=("kinlib",),
    warm_up=("import numpy as np\nimport kinlib as kl\nnp.eye(4)", "%time kl.exp([0, 0, 1])", "import kinlib.view"),
    fallback=find_robot_sheet,
    fallback_hint="The sheet of another robot needs its file {name}.json beside the notebook.",
)
