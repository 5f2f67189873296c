"""The course: its package, what submissions may import, and how sheets of other robots are found."""

import os

from misstep.catalog import Course
from misstep.sheet import Sheet


def find_robot_sheet(name: str) -> Sheet | str:
    """Return the sheet of a robot whose file is beside the notebook, or what to try."""
    from kincourse.robot_sheets.robot_sheet import find  # imported only if needed

    return find(name) or f"The sheet of another robot needs its file {name}.json beside the notebook."


COURSE = Course(
    "kincourse",
    requires=("kinlib",),
    fallback=find_robot_sheet,
    site=os.environ.get("KINLIB_SITE_URL", ""),  # as in site/conf.py
)
