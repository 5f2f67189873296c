"""What the feedback may do to the answers from outside: tests/evidence judges some of them in each run, evidence/ all every night."""

from collections import Counter
from dataclasses import replace

from evidence.outside import outside_answers
from evidence.outside.right import RIGHT
from kincourse import find_sheet, sheets
from kincourse.robot_sheets.robot_sheet import TASKS, robot_sheet
from kinlib.chains.robots import rpr
from misstep.census import census_of

STUDENTS = ["a student of the tests", "another one"]

MAX_SHARE = {"full marks": 0.0, "refused": 0.0, "false": 0.01, "undeserved": 0.0, "unnamed": 0.1}
"""The largest share of the wrong answers to one problem of which this may be said."""

MORE = (
    ("false", 0.05, "01.2 04.1 06.8 09.2", "with the numbers of one student, another mistake leads to the same answer"),
    (
        "undeserved",
        0.1,
        "04.3 robot.back_to_space",
        "omega and v earn points by themselves, and omega is right without p",
    ),
    ("undeserved", 0.2, "08.9", "1 is one of its three numbers"),
    (
        "unnamed",
        0.3,
        "07.9 09.12 10.5 10.8 10.11 10.13",
        "nothing looks for numbers that are doubled or in another order",
    ),
)
"""What is more than that: the share that it has, the problems, and why."""

ALLOWED = {(number, what): share for what, share, numbers, _ in MORE for number in numbers.split()}


def a_third_of_each_sheet():
    """Return a third of the problems of each sheet, first what is of a kind of answer that was chosen least often, or that is rare."""
    chosen, often, kinds = [], Counter(), Counter(kind for kind, _ in RIGHT.values())
    for name in sheets():
        left = list(find_sheet(name).problems)
        for _ in range(round(len(left) / 3)):
            best = min(left, key=lambda template: (often[kind_of(template)], kinds[kind_of(template)]))
            left.remove(best)
            chosen.append(best)
            often[kind_of(best)] += 1
    assert set(often) == set(kinds)
    return chosen


def kind_of(template):
    return RIGHT[template.number][0]


def tasks_of_a_robot():
    """Return the problems of a robot sheet, with the names of their tasks as numbers."""
    problems = robot_sheet("robot", rpr(), [*TASKS]).problems
    return [replace(template, number=f"robot.{task}") for task, template in zip(TASKS, problems, strict=True)]


def assert_feedback_is_true(template, students):
    """Judge the answers from outside of some students to a problem."""
    row = census_of(template, students, outside_answers, own=False)
    wrong = row.outside["wrong"]
    assert wrong, f"no answers to {template.number}"
    for what, share in MAX_SHARE.items():
        allowed = ALLOWED.get((template.number, what), share)
        assert row.outside[what] <= allowed * wrong, row.examples[f"outside, {what}"]
