"""kincourse: the course on forward kinematics. Notebooks import what they need from here.

Each lecture has a folder with its problems, its blank steps and its questions. A lecture is imported only when it is used.
"""

from typing import TYPE_CHECKING, Any

from kincourse.catalog import COURSE

if TYPE_CHECKING:
    from kincourse.dh_quiz import quiz
else:

    def __getattr__(name: str) -> Any:
        """Load the quiz, and the drawings that it needs, when it is first used."""
        if name != "quiz":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from kincourse.dh_quiz import quiz

        return quiz


__all__ = [
    "COURSE",
    "ask",
    "attempt",
    "blanks",
    "explain",
    "find_question",
    "find_sheet",
    "open_sheet",
    "quiz",
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
