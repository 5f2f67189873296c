"""Every problem is tried with the numbers of many students and with every mistake that is known, and has its cells."""

from misstep.authoring.check import what_is_missing
from my_course import COURSE


def test_nothing_is_missing_in_the_course():
    assert not list(what_is_missing(COURSE, students=40))
