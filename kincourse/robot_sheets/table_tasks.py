"""Tasks on the DH tables of any robot: a standard table, a modified table, and a table with a faulty entry.

The zero configuration is the student's own, so that the offsets of the table are their own too. The first and the last
frame are given, and every choice that the rules leave open between them is right.
"""

from functools import partial

import numpy as np

from kincourse.answers.dh_table import DHTableAnswer
from kincourse.mistakes.dh import entry_names, other_entries, rows_of_the_other_convention
from kincourse.robot_sheets.sampling import (
    random_aligned_base,
    random_configuration,
    rebased,
    step_size,
    truncated,
    with_zero_at,
)
from kincourse.robot_sheets.task import task
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import table_frames
from kincourse.text.joint_table import end_frames, given_frames, joint_table
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.formatting import markdown_table
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS
from kinlib.dh.table import Convention, DHTable, format_rows
from kinlib.view import draw_joints
from kinlib.view.figures.dh_table import draw_table
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import number
from misstep.problem import Problem

MAX_ROWS = 7
"""The maximum number of rows of a table. A robot with more joints is cut off after this joint."""

TABLE = (
    "table",
    "Answer with a table: text with the header `a | alpha | d | theta`, a row for each joint, and `q1`, `q2`, ...; angles as `90°`.",
)
ENTRY = "entry", "Answer with a pair: column and row in quotes, and a number."

TABLE_SOLUTION = """\
arm = kl.Chain(given.screws, given.home, given.points)
table_{k} = kl.assign_frames(arm, convention="standard").table
"""

MODIFIED_SOLUTION = TABLE_SOLUTION.replace("standard", "modified")

FAULTY_ENTRY_SOLUTION = """\
link = kl.inverse(given.frames[:-1]) @ given.frames[1:]
R, p = link[:, :3, :3], link[:, :3, 3]
if given.convention == "standard":  # the entries of Rz Tz Tx Rx, read backwards
    alpha, theta = np.arctan2(R[:, 2, 1], R[:, 2, 2]), np.arctan2(R[:, 1, 0], R[:, 0, 0])
    a, d = np.cos(theta) * p[:, 0] + np.sin(theta) * p[:, 1], p[:, 2]
else:  # those of Rx Tx Rz Tz
    alpha, theta = np.arctan2(-R[:, 1, 2], R[:, 2, 2]), np.arctan2(-R[:, 0, 1], R[:, 0, 0])
    a, d = p[:, 0], np.cos(alpha) * p[:, 2] - np.sin(alpha) * p[:, 1]
read = np.column_stack([a, alpha, d, theta])
off = given.rows - read
off[:, [1, 3]] = np.sin(off[:, [1, 3]] / 2)  # whole turns count nothing
row, column = np.unravel_index(np.argmax(np.abs(off)), off.shape)
entry_{k} = (f"{('a', 'alpha', 'd', 'theta')[column]}{row + 1}", read[row, column])
"""


@task("A table in the standard convention", 4, "05_dh_standard#Reading a table off a drawing", TABLE, TABLE_SOLUTION)
def standard_table(robot: Chain, sampler: ArmSampler) -> Problem:
    """The table in the standard convention between two given frames."""
    return _table(robot, sampler, "standard")


@task(
    "A table in the modified convention", 4, "06_dh_modified#Frame labelling in eight steps", TABLE, MODIFIED_SOLUTION
)
def modified_table(robot: Chain, sampler: ArmSampler) -> Problem:
    """The table in the modified convention between two given frames."""
    return _table(robot, sampler, "modified")


@task("The faulty entry", 3, "05_dh_standard#The four motions", ENTRY, FAULTY_ENTRY_SOLUTION)
def faulty_entry(robot: Chain, sampler: ArmSampler) -> Problem:
    """The one entry of a table that does not fit the drawn frames."""
    arm, cut, _ = _arm(robot, sampler)
    table = _assigned_table(arm, sampler.choice(("standard", "modified")))
    # half a turn could be typed with either sign
    places = [(i, k) for i in range(table.n) for k in range(4) if k in (0, 2) or abs(table.rows[i, k]) < np.pi - 1e-3]
    i, k = sampler.choice(places)
    wrong = table.rows.copy()
    wrong[i, k] = _wrong_entry(sampler, wrong[i, k], COLUMNS[k], step_size(robot))
    answer = f"{COLUMNS[k]}{i + 1}"
    problem = Problem(
        statement=f"The table below was read off the drawn frames of {robot.name}{cut}, in the {table.convention} convention, in the "
        "configuration of the drawing. One entry is wrong. Which one, and what is its right value? Answer with its column and row, and "
        "with the value in metres or radians, such as `('d2', 0.5)`. The poses "
        f"of the frames in {{s}} are in `given.frames`.\n\n{_format_table(table.changed(rows=wrong))}",
        figure=partial(draw_table, table, numbers=True, path=False),
        given={"frames": table_frames(table), "rows": wrong, "convention": table.convention},
        answer=Choice(answer, entry_names(table.n)),
        mistakes=other_entries(answer, table.n, table.convention),
    )
    return problem.with_reason(Numbers(np.array(table.rows[i, k])), "the value")


def _table(robot: Chain, sampler: ArmSampler, convention: Convention) -> Problem:
    arm, cut, words = _arm(robot, sampler)
    table = _assigned_table(arm, convention)
    n = table.n
    return Problem(
        statement=f"{robot.name}{cut} is drawn with its joints at {words}; let $q = 0$ in this configuration. Write its table in the "
        f"{convention} convention. Each $q_i$ is positive about or along the direction of its joint. The poses of frame 0 and frame {n} in "
        "{s} are given. Where the rules leave a choice, it is yours: every table that fits is right. "
        f"\n\n{joint_table(arm)}\n\n{given_frames(table)}",
        figure=partial(draw_joints, arm),
        given={"screws": arm.screws, "points": arm.joint_points, "home": arm.home, **end_frames(table)},
        answer=DHTableAnswer(table, anchored=True),
        mistakes=[rows_of_the_other_convention(table)],
    ).without_duplicates()


def _arm(robot: Chain, sampler: ArmSampler) -> tuple[Chain, str, str]:
    """The robot with the student's base and zero configuration, where it is cut off, and the configuration in words."""
    part = truncated(robot, MAX_ROWS)
    at = random_configuration(sampler, part, quarters=True)
    arm = rebased(with_zero_at(part, at.q), random_aligned_base(sampler, robot), np.eye(4))
    cut = f", up to joint {MAX_ROWS}," if part.n < robot.n else ""
    return arm, cut, at.words


def _assigned_table(arm: Chain, convention: Convention) -> DHTable:
    """The table of the frames that `assign_frames` chooses."""
    return assign_frames(arm, convention=convention).table.changed(name=arm.name)


def _wrong_entry(sampler: ArmSampler, value: float, column: str, step: float) -> float:
    """Draw a wrong number in place of a right one: simple, and far enough from it."""
    if column in ANGLE_COLUMNS:
        return value + float(np.radians(sampler.choice([90, -90, 180])))
    off = sampler.choice((-1, 1)) * sampler.integer(1, 3) * step
    return sampler.choice([-value, value + off]) if abs(value) > step / 2 else value + off


def _format_table(table: DHTable) -> str:
    """Write a table in Markdown, with angles in degrees."""
    return markdown_table(format_rows(table, length=number, angle=lambda angle: f"{number(_wrapped_degrees(angle))}°"))


def _wrapped_degrees(angle: float) -> float:
    """An angle, given in radians, in degrees within (-180, 180], rounded to three decimals."""
    return float(180 - (180 - np.degrees(angle).round(3)) % 360)
