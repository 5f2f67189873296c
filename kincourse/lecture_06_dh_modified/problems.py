"""Sheet 06: rows as two screw motions, link transforms, both conventions of one arm, a faulty entry, wrists, chains."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import accumulate
from typing import ClassVar

import numpy as np

from kincourse.answers.dh_row import DHRowsAnswer
from kincourse.answers.dh_table import DHTableAnswer
from kincourse.answers.pose import EulerAnglesAnswer, PoseAnswer, RotationAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.links import link, table_product
from kincourse.expressions.poses import inverse, rotation_about, rotation_of
from kincourse.expressions.screws import joint_screws
from kincourse.expressions.wrist import wrist_angles, wrist_rotation
from kincourse.mistakes.dh import is_in_several_rows, rows_of_the_other_convention
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import are_distinguishable
from kincourse.sampling.drawn_machines import (
    draw_table_frames,
    drawn_table_mistakes,
    is_readable,
    lengths,
    table_frames,
)
from kincourse.text.dh_tables import in_latex, markdown_table
from kincourse.text.joint_table import joint_table, rows_from_frames
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import Convention, DHTable, add_variable, headings
from kinlib.rigid.lie import homogeneous
from kinlib.view import draw_arm, draw_frames, draw_joints
from misstep.answers.base import TOLERANCE, Named
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import degrees, matrix, number, vector
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression, given, product
from misstep.mutants.operations import stack

TITLE = "Denavit-Hartenberg tables in the modified convention"

RIGHT_ANGLE_RAD = np.pi / 2

MIN_HEIGHT_M = 0.5
"""The minimum height of the joints of a drawn arm above the floor, at which their drop lines can be read."""

ALPHAS_DEG = (-90, 90, -60, 60, -45, 45, -30, 30)
"""Values of alpha that are easy to type. None is 0, because parallel joint axes would hide half of the mistakes."""

LINK = [0, 1]
"""The columns that belong to the link: a and alpha."""

WRIST_ADVICE = "The wrist is $R_y(\\theta_4)\\,R_z(\\theta_5)\\,R_y(\\theta_6)\\,R_x(-90°)$. With all angles 0 only the constant is left."

OFF_THE_NORMAL = (
    "You took the distance of the origins as $a$, and 0 as $d$. $a_{i-1}$ is measured along $x_{i-1}$, from axis to axis, and "
    "$d_i$ along $z_i$."
)


def wrong_conversions(given: Array, right: DHTable) -> Iterator[tuple[str, Array, str]]:
    """Yield wrong conversions of standard rows (n, 4) to a modified table: the name, the rows, and what is true of them."""
    kept, folded = _moved(given, 1, LINK), _moved(given, 1, LINK)
    kept[0, LINK], folded[0, LINK] = given[0, LINK], given[-1, LINK]
    yield from (
        ("not converted", given, "These are the rows of the given table, not converted."),
        ("moved the other way", _moved(given, -1, LINK), "$a$ and $\\alpha$ are moved in the wrong direction."),
        ("whole rows moved", _moved(given, 1, [0, 1, 2, 3]), "Whole rows are moved: $d$ and $\\theta$ stay with their joint."),
        ("rows moved", right.rows[[0, 0, 1, 2]], "These are the right rows, each one row too low."),
        ("d and theta moved", _moved(given, 1, [2, 3]), "$d$ and $\\theta$ are moved in place of $a$ and $\\alpha$."),
        ("a alone moved", _moved(given, 1, [0]), "$a$ is moved, and $\\alpha$ is not. Both belong to the link."),
        ("alpha alone moved", _moved(given, 1, [1]), "$\\alpha$ is moved, and $a$ is not. Both belong to the link."),
        ("two rows too far", _moved(given, 2, LINK), "$a$ and $\\alpha$ are moved by two rows instead of one."),
        ("end kept", kept, "The row at the empty end keeps its $a$ and $\\alpha$, but they belong to the row beside it."),
        ("end folded in", folded, "The left-over $a$ and $\\alpha$ were put in the row at the other end. They belong in no row."),
    )  # fmt: skip


def _moved(rows: Array, by: int, columns: list[int]) -> Array:
    """Rows with some columns moved down by some rows, and 0 in what is left empty."""
    moved = np.array(rows)
    moved[:, columns] = np.roll(rows[:, columns], by, axis=0)
    moved[slice(None, by) if by > 0 else slice(by, None), columns] = 0.0
    return moved


@dataclass(frozen=True, eq=False)
class WristAnglesAnswer(EulerAnglesAnswer):
    """Angles theta_4, theta_5, theta_6 of a wrist in rows, in radians; the second row is at the singular configuration."""

    noun: ClassVar[str] = "theta_4, theta_5, theta_6 in radians, one row for each rotation, an array"
    meaning: Callable[[Array], Array] = field(default=wrist_rotation, kw_only=True)

    def resemblance(self, given: Array, part: int) -> Named | None:
        mine, right = np.cos(given[part, 1]), np.cos(self.value[part, 1])
        at_a_right_angle = (
            "At $\\theta_5 = \\pm 90°$ axes 4 and 6 are perpendicular. At which $\\theta_5$ are they collinear?"
        )
        beyond = "The cosine of your $\\theta_5$ has the wrong sign: it is off by half a turn, or its supplement."
        their_sum = (
            "Your $\\theta_5$ is right. There $R_2$ determines only $\\theta_4 + \\theta_6$, and your sum is wrong."
        )
        cases = (
            (part == 1 and abs(mine) < TOLERANCE, "singular at a right angle", at_a_right_angle),
            (abs(mine + right) < TOLERANCE < abs(mine), "theta_5 beyond a right angle", beyond),
            (abs(mine - right) > TOLERANCE, "another theta_5", "No solution has this $\\theta_5$."),
            (part == 0, "theta_4 and theta_6", "Your $\\theta_5$ is possible, but not with your other angles."),
            (part == 1, "the sum of theta_4 and theta_6", their_sum),
        )
        return next((name, text) for is_so, name, text in cases if is_so)

    def remark(self, given: Array) -> str:
        if np.cos(given[0, 0] - self.value[0, 0]) > 0:
            return ""
        return "For $R_1$ you found the second solution, $(\\theta_4 + \\pi, -\\theta_5, \\theta_6 + \\pi)$."


@problem("06.1", "The link transform of a row", points=2, lecture="06_dh_modified#The general matrix", level="Warm-up")
def link_transform(sampler: ArmSampler) -> Problem:
    row = _random_row(sampler)
    a, alpha, d, theta = row
    T = link(row, "modified", label="{}^{i-1}T_i")
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    swapped, mirrored = T.value.copy(), T.value.copy()
    swapped[1, 0], swapped[2, 1] = c * sa, s * ca
    mirrored[[0, 1], [1, 0]] = mirrored[[1, 0], [0, 1]]
    return Problem(
        statement="Give the link transform ${}^{i-1}T_i$ of this row of a modified table, with the given $d$ and $\\theta$.\n\n"
        + _format_table([row], "modified"),
        method="${}^{i-1}T_i = \\begin{pmatrix} c_\\theta & -s_\\theta & 0 & a \\\\ s_\\theta c_\\alpha & c_\\theta c_\\alpha & "
        "-s_\\alpha & -d\\,s_\\alpha \\\\ s_\\theta s_\\alpha & c_\\theta s_\\alpha & c_\\alpha & d\\,c_\\alpha \\\\ 0 & 0 & 0 & 1 "
        "\\end{pmatrix}$, with $c$ and $s$ for cosine and sine.",
        further="Which three entries above the last row are the same in the standard matrix of this row?",
        given={"a": a, "alpha": alpha, "d": d, "theta": theta},
        answer=PoseAnswer(T.value),
        solution=(
            T.mistaken_for(
                ("inverse", "give the inverse", inverse(T)),
                (
                    "entries swapped",
                    "swap the entries $(2, 1)$ and $(3, 2)$, as a printed matrix of the lecture does",
                    swapped,
                ),
                ("entries swapped", "swap the entries $(1, 2)$ and $(2, 1)$", mirrored),
            )
        ),
        advice={
            "swap the entries $(2, 1)$ and $(3, 2)$, as a printed matrix of the lecture does": "The columns are then not perpendicular."
        },
    )


@problem("06.2", "The pose of an RPR arm", points=2, lecture="06_dh_modified#A worked example", level="Warm-up")
def chain(sampler: ArmSampler) -> Problem:
    a1 = d2 = sampler.length(0.3, 0.9)
    while d2 == a1:
        d2 = sampler.length(0.2, 0.9)
    degrees = 0, 0
    while any(abs((sum_ + 45) % 90 - 45) < 5 for sum_ in (sum(degrees), degrees[0] - degrees[1])):
        degrees = sampler.degrees(-75, 75), sampler.degrees(-75, 75)  # otherwise R may be its own transpose
    rows: list[list[float]] = [[0, 0, 0, 0], [a1, np.pi / 2, 0, 0], [0, -np.pi / 2, 0, 0]]
    table = DHTable(rows, convention="modified", joints="RPR", name="RPR")
    T = table_product(table.rows, "RPR", [np.radians(degrees[0]), d2, np.radians(degrees[1])], "modified")
    return Problem(
        statement=f"The RPR arm of this table is at $\\theta_1 = {degrees[0]}$ degrees, $d_2 = {number(d2)}$ m, "
        f"$\\theta_3 = {degrees[1]}$ degrees. Give ${{}}^0T_3 = {{}}^0T_1\\,{{}}^1T_2\\,{{}}^2T_3$.\n\n"
        + _format_table(table.rows, "modified", "RPR"),
        further="The prismatic joint moves by 0.1 m. In which direction does the end-effector move?",
        figure=partial(draw_arm, table.to_chain()),
        given={"rows": table.rows, "values": np.array([degrees[0], d2, degrees[1]])},
        answer=PoseAnswer(T),
    )


@problem("06.3", "From standard to modified", points=4, lecture="06_dh_modified#Converting")
def to_modified(sampler: ArmSampler) -> Problem:
    table = _random_table(sampler, "standard")
    right, ends = table.converted("modified"), {"end kept", "end folded in"}
    return Problem(
        statement="Convert this standard table to the modified convention. Frame 0 stays the same. The $a$ and $\\alpha$ that are "
        "left over become the tool, which is not part of the answer. Give four rows $a_{i-1}, \\alpha_{i-1}, d_i, \\theta_i$ at "
        "$q = 0$, angles in radians.\n\n" + _format_table(table.rows, "standard", table.joints),
        method="The joints stay in their rows, with $d_i$ and $\\theta_i$. Row $i$ of the modified table begins with the link before: "
        "$a_{i-1}$ and $\\alpha_{i-1}$ of the standard table move one row down, and row 1 begins with 0 and 0. The rows at $q = 0$:",
        further="What happens to the last $a$ and $\\alpha$ if there is no tool?",
        shown={"rows": table.rows, "joints": table.joints},
        answer=DHTableAnswer(right, anchored=True),
        # Where whole columns are moved wrongly, a row that comes out right does so by chance.
        mistakes=[
            Mistake(name, right.changed(rows=rows), text, spoils=name not in ends)
            for name, rows, text in wrong_conversions(table.rows, right)
        ],
    )


@problem("06.4", "The rotation of a wrist", points=3, lecture="06b_puma#The wrist")
def wrist(sampler: ArmSampler) -> Problem:
    degrees = [0, 0, 0]
    while (
        any(angle % 45 == 0 for angle in degrees) or len({*map(abs, degrees)}) < 3
    ):  # otherwise some wrong wrists have the same pose
        degrees = [sampler.degrees(-80, 80) for _ in range(3)]
    rows = np.array([(0.0, -np.pi / 2, 0.0, 0.0), (0.0, np.pi / 2, 0.0, 0.0), (0.0, -np.pi / 2, 0.0, 0.0)])
    T = table_product(rows, "RRR", np.radians(degrees), "modified", first=4)
    angles = [factor.arguments[3] for factor in T.arguments]
    constant = rotation_about(0, given("-90°", -np.pi / 2))
    R = rotation_of(T)

    def euler(axes: str) -> Expression:
        return product(*(rotation_about("xyz".index(axis), angle) for axis, angle in zip(axes, angles, strict=True)))

    R = R.mistaken_for(
        ("no constant", "leave out the constant $R_x(-90°)$ behind the Y-Z-Y Euler angles", euler("yzy")),
        ("constant on the left", "put the constant $R_x(-90°)$ on the left of Y-Z-Y", constant @ euler("yzy")),
        ("sign of the constant", "take $R_x(+90°)$ as the constant", euler("yzy") @ constant.T),
        ("Z-Y-Z", "give Z-Y-Z Euler angles, without a constant", euler("zyz")),
        advice=WRIST_ADVICE,
    )
    return Problem(
        statement="These are rows 4 to 6 of the modified table of a PUMA 560, that is, its wrist. Give ${}^3R_6$ at "
        f"$(\\theta_4, \\theta_5, \\theta_6) = {vector(degrees)}$ degrees.\n\n"
        + _format_table(rows, "modified", "RRR", first=4),
        further="For which angles is ${}^3R_6 = R_x(-90°)$?",
        given={"degrees": degrees},
        answer=RotationAnswer(R),
    )


@problem("06.5", "Which convention is this?", points=2, lecture="06_dh_modified#Which convention is this?")
def which_convention(sampler: ArmSampler) -> Problem:
    truth = sampler.choice("abcd")
    rows = np.array([_random_row(sampler), _random_row(sampler)])
    rows[:, 3] = 0.0
    q = np.radians([sampler.degrees(20, 80), sampler.degrees(-80, -20)])
    if truth == "c":  # without d and theta all motions are screws along the same x axis, and they commute
        rows[:, 2], q = 0.0, np.zeros(2)
    poses = {name: DHTable(rows, convention=name).fk(q) for name in ("standard", "modified")}
    faulty = DHTable(rows * (1, -1, 1, 1), convention=sampler.choice(["standard", "modified"])).fk(q)
    T = {"a": poses["standard"], "b": poses["modified"], "c": poses["standard"], "d": faulty}[truth]
    off = {name: float(np.linalg.norm(pose[:3, 3] - T[:3, 3])) for name, pose in poses.items()}
    turned = {name: not np.allclose(pose[:3, :3], T[:3, :3]) for name, pose in poses.items()}
    options = {
        "a": "standard",
        "b": "modified",
        "c": "both conventions give this pose, so it does not decide",
        "d": "neither convention gives this pose, so the table has a fault",
    }
    why = {
        "c": "The two conventions do not give the same pose here. Multiply the rows in both, and compare each product with $T$.",
        "d": "At least one of the two conventions gives this pose. Compare all sixteen entries.",
    }
    for letter, name, other in (("a", "standard", "modified"), ("b", "modified", "standard")):
        place = f"In the {name} convention, the table puts the end-effector {number(off[name])} m from the measured position"
        why[letter] = place + (", with another orientation." if turned[name] else ".")
        if truth == "c":
            why[letter] = (
                f"It may be {name}. But the {other} convention gives the same pose, because all $d$ and $\\theta$ are 0 here."
            )
    listed = "\n".join(f"- `'{letter}'`: {text}" for letter, text in options.items())
    problem = Problem(
        statement="The table of an arm with two revolute joints does not say in which convention it is. Base and tool are "
        "the identity. On the real arm, the pose $T$ of the end-effector was measured at "
        f"$q = {vector(np.degrees(q))}$ degrees. What does the measurement tell you?\n\n"
        f"{_format_table(rows, '', 'RR')}\n\n$$T = {matrix(T)}$$\n\n{listed}\n\nAnswer with a letter, and with the x coordinates "
        "of the end-effector that the table gives in the standard and in the modified convention, such as `('a', [0.4, 0.7])`.",
        method="\n".join(
            f"In the {name} convention the product of the rows at this $q$ is ${matrix(pose)}$, and it "
            f"{'agrees' if np.allclose(pose, T) else 'does not agree'} with $T$."
            for name, pose in poses.items()
        ),
        further="Which one further measurement would decide every such question?",
        figure=partial(draw_frames, {"0": np.eye(4), "2": T}),
        given={"rows": rows, "q": q, "pose": T},
        answer=Choice(truth, options),
        mistakes=[Mistake(options[letter], letter, why[letter]) for letter in options if letter != truth],
    )
    return problem.with_reason(Numbers(np.array([pose[0, 3] for pose in poses.values()]), unit="m"), "the coordinates")


@problem("06.6", "The angles of a wrist", points=3, lecture="06b_puma#Angles from a rotation")
def angles_of_a_wrist(sampler: ArmSampler) -> Problem:
    first, last = sampler.shuffled([sampler.degrees(15, 75), -sampler.degrees(105, 165)])
    degrees = [[first, sampler.degrees(25, 80), last], [0, 0, sampler.choice((-1, 1)) * sampler.degrees(15, 75)]]
    rotations = [wrist_rotation(angles) for angles in np.radians(degrees)]
    angles = stack(*(wrist_angles(f"R_{i}", R) for i, R in enumerate(rotations, start=1)))
    return Problem(
        statement="The wrist of a PUMA 560 has the rotation ${}^3R_6 = R_y(\\theta_4)\\,R_z(\\theta_5)\\,R_y(\\theta_6)\\,R_x(-90°)$. "
        "It is to reach these two values of ${}^3R_6$:\n\n"
        f"$$R_1 = {matrix(rotations[0])}, \\qquad R_2 = {matrix(rotations[1])}.$$\n\n"
        "Give $(\\theta_4, \\theta_5, \\theta_6)$ in radians for each, in two rows. Every solution is right. One of the two is at "
        "the singular configuration of the wrist, where axes 4 and 6 are collinear.",
        method="Without the constant, $E = R\\,R_x(90°) = R_y(\\theta_4)\\,R_z(\\theta_5)\\,R_y(\\theta_6)$: $\\theta_5 = "
        "\\operatorname{atan2}(\\sqrt{E_{21}^2 + E_{23}^2}, E_{22})$, $\\theta_4 = \\operatorname{atan2}(E_{32}, -E_{12})$ and $\\theta_6 "
        "= \\operatorname{atan2}(E_{23}, E_{21})$. For $R_2$ all arguments of the last two are 0: with $\\theta_4 = 0$, $\\theta_6 = "
        "\\operatorname{atan2}(E_{13}, E_{33})$. YZY stands for these formulas.",
        further="How many solutions does each of the two orientations have?",
        given={"rotations": np.array(rotations)},
        answer=WristAnglesAnswer(angles),
    )


@problem("06.7", "A whole arm from a drawing", points=4, lecture="06_dh_modified#Frame labelling in eight steps")
def whole_arm(sampler: ArmSampler) -> Problem:
    places, tellable = [np.zeros(3)], 0
    while tellable < 2 or not are_distinguishable(places) or min(place[2] for place in places[1:]) < MIN_HEIGHT_M:
        joints = sampler.choice(["RRRRR", "RRPRR", "RPRRR", "RRRRRR", "RRRPRR"])
        kinds = sampler.shuffled(["parallel", "intersecting", "skew", "skew", "intersecting"])[: len(joints) - 1]
        rows, letters = _letter_rows(sampler, kinds)
        tellable = int((np.abs(rows[:, 1]) != np.abs(rows[:, 3])).sum())  # rows that show which angle is which
        table = DHTable(rows, convention="modified", joints=joints, name="your arm")
        robot = table.to_chain()
        places = [np.zeros(3), *robot.joint_points]
    points = _letter_points(table, letters)
    lengths = ", ".join(f"$l_{k} = {number(length)}$" for k, length in enumerate(letters, start=1))
    reach = np.hypot(rows[:, 0], rows[:, 2])
    between_origins = table.changed(rows=np.column_stack([reach, rows[:, 1], 0 * reach, rows[:, 3]]))
    return Problem(
        statement=f"Write a table of this arm with {len(joints)} joints in the modified convention. The drawing shows $q = 0$; each "
        "arrow shows the direction in which its joint moves when $q$ grows. Frame 0 is {s}, and "
        f"frame {len(joints)} is {{b}}, so base and tool are the identity. A table is right if it gives the pose of {{b}} for every "
        f"$q$. Lengths may be typed as letters, such as `-l_2`, or as numbers: {lengths} (metres).\n\n"
        f"{joint_table(robot, points=points)}\n\n{{b}} is at ${points[-1]}$, its $x$ along ${vector(robot.home[:3, 0])}$, its $z$ "
        f"along ${vector(robot.home[:3, 2])}$.",
        method=rows_from_frames(table),
        further="Which of your rows would a second correct table share with yours?",
        figure=partial(draw_joints, robot, tool=True),
        given={"lengths": np.array(letters)},
        shown={"screws": robot.screws, "home": robot.home, "points": robot.joint_points},
        answer=DHTableAnswer(
            table, anchored=True, lengths={f"l_{k}": length for k, length in enumerate(letters, start=1)}
        ),
        mistakes=[
            rows_of_the_other_convention(table),
            Mistake(
                "off the normal",
                between_origins,
                OFF_THE_NORMAL,
                spoils=is_in_several_rows(between_origins.rows, table.rows),
            ),
        ],
    )


def _letter_rows(sampler: ArmSampler, kinds: Sequence[str]) -> tuple[Array, Sequence[float]]:
    """Draw the rows of a modified table, and the lengths in it, each of which is in one entry.

    kinds  how each axis is related to the next one
    """
    lengths = sampler.shuffled([1.1, 1.3, 1.4, 1.6, 1.7, 1.9, 2.1, 2.2, 2.3, 2.4])
    used: list[float] = []

    def length() -> float:
        used.append(lengths[len(used)])
        return float(used[-1]) * sampler.choice((1, 1, -1))

    rows = [[0.0, 0.0, abs(length()), 0.0]]
    for kind in kinds:
        alpha = 0.0 if kind == "parallel" else sampler.choice((1, -1)) * RIGHT_ANGLE_RAD
        a = 0.0 if kind == "intersecting" else abs(length())
        d = 0.0 if kind == "parallel" else length()
        rows.append([a, alpha, d, sampler.choice((0, 1, -1)) * RIGHT_ANGLE_RAD])
    return np.array(rows), used


def _letter_points(table: DHTable, lengths: Sequence[float]) -> list[str]:
    """The origins of frames 1 to n at q = 0 in LaTeX, in letters of the lengths l_1, l_2, ...; angles are right angles."""
    unit_tables = [
        table.changed(rows=np.where(np.abs(table.rows) == length, np.sign(table.rows), table.rows * (0, 1, 0, 1)))
        for length in lengths
    ]
    steps = [unit.link_transforms(np.zeros(table.n)) for unit in unit_tables]
    origins = np.array([[T[:3, 3] for T in accumulate(links, np.matmul)] for links in steps]).round().astype(int)
    return [f"({', '.join(_letter_sum(column) for column in origin.T)})" for origin in origins.transpose(1, 0, 2)]


def _letter_sum(coefficients: Sequence[int]) -> str:
    """A sum of the lengths l_1, l_2, ... in LaTeX."""
    terms = [f"{'-' if c < 0 else '+'} l_{k}" for k, c in enumerate(coefficients, start=1) if c]
    return " ".join(terms).removeprefix("+ ").replace("- ", "-", 1 if terms and terms[0][0] == "-" else 0) or "0"


def _random_row(sampler: ArmSampler) -> tuple[float, float, float, float]:
    """Draw a row without zeros, with a and d different, so that a swap changes it."""
    a, d = sampler.shuffled([sampler.length(0.2, 0.5), sampler.length(0.6, 0.9)])
    alpha, theta = sampler.choice(ALPHAS_DEG), sampler.degrees(-80, 80)
    return a, float(np.radians(alpha)), d, float(np.radians(theta))


def _random_table(sampler: ArmSampler, convention: Convention) -> DHTable:
    """Draw a table of four rows, one of them with a prismatic joint."""
    rows = np.array([_random_row(sampler) for _ in range(4)])
    rows[:, 0] = np.array(sampler.shuffled([0.2, 0.3, 0.4, 0.5, 0.6]))[:4]
    return DHTable(rows, convention=convention, joints=sampler.choice(["RRPR", "RPRR", "RRRP"]))


def _format_table(
    rows: Array | Sequence[tuple[float, float, float, float]], convention: str, joints: str = "", first: int = 1
) -> str:
    """Write a table in Markdown, with angles in degrees and the variable of each joint in its column."""
    columns = headings(convention)[1:] if convention else COLUMNS
    heading = " | ".join(["$i$" if convention else "row", *(f"${in_latex(column)}$" for column in columns)])
    lines = [f"| {heading} |", "|" + " --- |" * 5]
    for k, (a, alpha, d, theta) in enumerate(rows):
        kind, name = joints[k : k + 1], f"q_{k + first}"
        length = add_variable(name, number(d)) if kind == "P" else number(d)
        angle = add_variable(name, degrees(theta)) if kind == "R" else degrees(theta)
        lines.append(f"| {k + first} | {number(a)} | {degrees(alpha)} | ${length}$ | ${angle}$ |")
    return "\n".join(lines)


@problem(
    "06.8",
    "A telescope mount from its drawing",
    points=4,
    lecture="06_dh_modified#Frame labelling in eight steps",
    level="Hard",
)
def telescope_mount(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7)
        first, second = (sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD)) for _ in range(2))
        rows = [(0, 0, a, 0), (b, first, c, sampler.choice((0, RIGHT_ANGLE_RAD))), (d, second, e, RIGHT_ANGLE_RAD)]
        table = DHTable(rows, convention="modified", joints="RRR", base=pose((X, Y, Z), (f, g, 0)))
        if is_readable(table_frames(table)[:, :3, 3]):
            break
    return Problem(
        statement="The drawing shows the mount of a telescope at home, in millimetres, with modified frames: joint 1 "
        "is the azimuth, joint 2 the altitude, joint 3 rotates the camera. The origin of frame $i$ is D$i$, $z_i$ is the axis of joint "
        "$i$, and the arrow is $x_i$; $z_0$ is along $z_1$. Give the three rows $a_{i-1}, \\alpha_{i-1}, d_i, \\theta_i$ at home, in "
        "metres and radians.",
        method=rows_from_frames(table),
        further="Where would the frames be in the standard convention?",
        figure=partial(draw_table_frames, table),
        answer=DHRowsAnswer(table.rows),
        mistakes=drawn_table_mistakes(table),
    ).without_duplicates()


PANDA_M = np.array([
    (0, 0, 0.333), (0, -1, 0), (0, 1, 0.316), (0.0825, 1, 0), (-0.0825, -1, 0.384), (0, 1, 0), (0.088, 1, 0)
])  # fmt: skip
"""The rows of the maker's table: a, alpha in right angles, and d."""


def _joint_before(base: Array, axes: Array, points: Array) -> tuple[Array, Array]:
    return np.vstack([base[:3, 2], axes[:-1]]), np.vstack([base[:3, 3], points[:-1]])


@problem("06.9", "A Panda on a wall", points=4, lecture="06_dh_modified#The maker's own table", level="Hard")
def panda_on_a_wall(sampler: ArmSampler) -> Problem:
    place = lengths(sampler, 3, 0.2, 0.9) * [sampler.choice((-1, 1)) for _ in range(3)]
    base = pose(sampler.choice(((Y, Z, X), (Y, -Z, -X), (-Z, Y, X), (Z, X, Y), (X, -Z, Y))), place)
    quarters = np.array([0, sampler.choice((0, 1)), 0, -1, sampler.choice((0, 1, -1)), 1, 0])
    rows = np.column_stack([PANDA_M * (1, RIGHT_ANGLE_RAD, 1), RIGHT_ANGLE_RAD * quarters])

    def axes_and_points(rows: Array, convention: Convention = "modified", base: Array = base) -> tuple[Array, Array]:
        frames = table_frames(DHTable(rows, convention=convention, base=base))
        of = frames[1:] if convention == "modified" else frames[:-1]
        return of[:, :3, 2].round(9), of[:, :3, 3]

    axes, points = axes_and_points(rows)
    S = joint_screws(axes, [given(f"O_{i}", p) for i, p in enumerate(points, start=1)], np.zeros(7))
    at_zero, negated = rows * (1, 1, 1, 0), rows * (1, 1, 1, -1)
    for name, text, (w, p) in (
        ("the other convention", "read the table as a standard one", axes_and_points(rows, "standard")),
        ("joint before", "take $z_{i-1}$ and $O_{i-1}$ for joint $i$", _joint_before(base, axes, points)),
        ("no offset", "leave every $q$ at 0", axes_and_points(at_zero)),
        ("sign of the offset", "take every $q$ with the opposite sign", axes_and_points(negated)),
        ("base left out", "leave out the base", axes_and_points(rows, base=np.eye(4))),
        ("base not rotated", "leave out the rotation of the base", axes_and_points(rows, base=pose((X, Y, Z), place))),
        ("base not moved", "leave out the position of the base", axes_and_points(rows, base=homogeneous(base[:3, :3], 0 * place))),
        ("sign of alpha", "take every $\\alpha$ with the opposite sign", axes_and_points(rows * (1, -1, 1, 1))),
        ("a and d swapped", "swap $a$ and $d$", axes_and_points(rows[:, [2, 1, 0, 3]])),
    ):  # fmt: skip
        S = S.mistaken_for((name, text, joint_screws(w, p, np.zeros(7)).value))
    return Problem(
        statement="A Panda is mounted on a wall, and $z$ of {s} points up. This is its maker's table, modified, in metres and degrees, "
        "with the configuration in which it waits.\n\n"
        + markdown_table(
            [
                [f"{a:g}", f"{90 * turn:g}°", f"{d:g}", f"{90 * q:g}°"]
                for (a, turn, d), q in zip(PANDA_M, quarters, strict=True)
            ],
            ["joint", "$a_{i-1}$", "$\\alpha_{i-1}$", "$d_i$", "$q_i$"],
        )
        + f"\n\nThe pose of frame 0 in {{s}} is\n\n$$T_{{s0}} = {matrix(base)}$$\n\nGive the screw axes $S_1$ to $S_7$ in {{s}} in this "
        "configuration, as rows.",
        method="$\\omega_i$ is $z_i$, and $O_i$ the origin, of $T_{s0}\\,{}^0T_1 \\cdots {}^{i-1}T_i$.",
        further="Which rows of the table would stay the same if the maker had chosen the standard convention?",
        shown={"rows": rows, "base": base},
        answer=ScrewsAnswer(S),
    )


@problem(
    "06.10",
    "A table without a word on its convention",
    points=3,
    lecture="06_dh_modified#Which convention is this?",
    level="Open",
)
def settle_the_convention(_: ArmSampler) -> Problem:
    return Problem(
        statement="A maker sends the table of an arm with six joints, and does not say which convention it is in. One sign may be "
        "misprinted. You have the arm, and can measure the position of a point of the flange to a millimetre. Plan as few "
        "measurements as you can that decide the convention and find the misprint. Which misprints can your plan not find?",
        answer=Prose(
            "Compute the position in both conventions for some $q$, and choose a $q$ at which they differ by centimetres. Then move "
            "one joint at a time: each circle gives the line of one axis, and so $a$, $\\alpha$ and $d$ between neighbours. One "
            "further $q$ with all joints moved is a test of the whole. A misprint that changes no motion of the point is not found: "
            "a sign of the last $\\alpha$ or $\\theta$, which only rotates the flange, or one that another row makes up for.",
            {
                "a configuration in which both conventions clearly differ": 1,
                "a plan that finds the row of the misprint, such as one joint at a time": 1,
                "at least one misprint that it cannot find, with a reason": 1,
            },
        ),
    )
