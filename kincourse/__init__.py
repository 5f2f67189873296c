"""kincourse: the course on forward kinematics. Notebooks import what they need from here.

Each lecture has a folder with its problems, its blank steps and its questions. A lecture is imported only when it is used.
"""

from kincourse.catalog import COURSE

__all__ = [
    "COURSE",
    "ask",
    "attempt",
    "blanks",
    "explain",
    "find_question",
    "find_sheet",
    "open_sheet",
    "sheets",
]

ask = COURSE.ask
attempt = COURSE.attempt
blanks = COURSE.blanks
explain = COURSE.explain
find_question = COURSE.find_question
find_sheet = COURSE.find_sheet
open_sheet = COURSE.open_sheet
sheets = COURSE.sheets
