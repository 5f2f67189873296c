"""A course that begins with electric circuits."""

from misstep import Course

COURSE = Course("my_course")

# What students import.
open_sheet, ask, attempt, explain = COURSE.open_sheet, COURSE.ask, COURSE.attempt, COURSE.explain
