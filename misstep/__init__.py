"""misstep: sheets of problems that check themselves and name the mistake, for courses on any subject.

Each student gets individual numbers. A problem computes its right answer, and the wrong answers to which common mistakes lead.
Start with `problem`, `mistakes` and `answers/base`, then read `judge`, `sheet` and `catalog`. `grading` is for instructors.
"""

from misstep.catalog import Course, find_course
from misstep.mistakes import Mistake
from misstep.problem import Problem, Template, problem
from misstep.sampling import Sampler
from misstep.sheet import OpenSheet, Sheet

__all__ = [
    "Course",
    "Mistake",
    "OpenSheet",
    "Problem",
    "Sampler",
    "Sheet",
    "Template",
    "find_course",
    "problem",
]
