"""Practice: problems with numbers of each student's own, mistakes that are recognised, feedback that explains them."""

from kinlib.practice.ask import ask, explain
from kinlib.practice.quiz import quiz
from kinlib.practice.sheet import attempt, find_sheet, open_sheet, sheets

__all__ = ["ask", "attempt", "explain", "find_sheet", "open_sheet", "quiz", "sheets"]
