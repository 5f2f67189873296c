"""Practice: problems with numbers of each student's own, mistakes that are recognised, feedback that explains them."""

from kincourse import ask, attempt, explain, find_sheet, open_sheet, sheets
from kincourse.quiz import quiz

__all__ = ["ask", "attempt", "explain", "find_sheet", "open_sheet", "quiz", "sheets"]
