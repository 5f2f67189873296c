"""The course: which package it is, and what submissions need besides it."""

from misstep.catalog import Course
from misstep.sheet import Sheet


def robot_sheet_beside(name: str) -> Sheet | None:
    """The sheet of a robot whose file lies beside the notebook; None if there is none.

    Raises ValueError for a file that is not the file of a robot sheet.
    """
    from kincourse.robot_sheets.robot_file import found  # problems of any robot are loaded only if there is one

    return found(name)


COURSE = Course(
    "kincourse",
    requires=("kinlib",),
    warm_up=("import numpy as np\nimport kinlib as kl\nnp.eye(4)", "%time kl.exp([0, 0, 1])", "import kinlib.view"),
    fallback=robot_sheet_beside,
    fallback_hint="The sheet of another robot needs its file {name}.json beside the notebook.",
)
