"""Sheet 05: DH tables in the standard convention: reading them from drawings, multiplying rows, finding a faulty entry."""

from functools import partial

import numpy as np

from kincourse.answers.dh_row import DHEntriesAnswer, DHRowAnswer, DHRowsAnswer
from kincourse.answers.dh_table import DHTableAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.links import dh_row, link, links, table_product
from kincourse.expressions.poses import inverse, with_position
from kincourse.expressions.poses import pose as given_pose
from kincourse.mistakes.dh import entry_names, other_entries, rows_of_the_other_convention
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import are_distinguishable
from kincourse.sampling.drawn_machines import (
    draw_table_frames,
    drawn_table_mistakes,
    is_readable,
    lengths,
    table_frames,
)
from kincourse.text.dh_tables import markdown_table
from kincourse.text.joint_table import joint_table, rows_from_frames
from kinlib.chains.robots import X, Y, Z, arm, pose
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import DHTable
from kinlib.view import draw_joints
from kinlib.view.figures.frames import draw_frames, draw_table
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import degrees, matrix, number, vector
from misstep.mutants.expression import Expression, given, product
from misstep.mutants.operations import ANGLE, arctan2, radians, sqrt, square, stack

TITLE = "Denavit-Hartenberg tables in the standard convention"

RIGHT_ANGLE_RAD = np.pi / 2

CLIMBS = ((-1, 3), (3, -1), (1, -3), (-3, 1), (-2, 3), (3, -2), (2, -3), (-3, 2), (-1, -2), (-2, -1))
"""How much the second and the third of three axes are higher: one is lower, and no two of the three differences are as large."""

ORDER_ADVICE = "$A_1$ is leftmost, because joint 1 moves all that follows."
ACROSS = np.array([np.pi / 2, 0, 0])
OFFSETS_ADVICE = "$\\theta_i$ is the angle from $x_{i-1}$ to $x_i$, that is, from one link to the next."
NORMAL_ADVICE = "$a$ is the distance between two axes, along their common normal: $\\sqrt{\\Delta x^2 + \\Delta y^2}$."
HEIGHT_ADVICE = "$d_i$ is measured from $O_{i-1}$ along $z_{i-1}$, so it is the difference of two heights."
BASE_AND_TOOL_ADVICE = (
    "$T_{s0}$ is the first factor and $T_{2b}$ the last one, because neighbouring indices must be equal."
)


@problem(
    "05.1", "Four numbers between two drawn frames", points=3, lecture="05_dh_standard#Four numbers", level="Warm-up"
)
def four_numbers(sampler: ArmSampler) -> Problem:
    start, row = np.eye(4), np.zeros(4)
    # A row without a minus sign would hide all of them.
    while (
        not are_distinguishable([np.zeros(3), start[:3, 3], (start @ link(row, "standard").value)[:3, 3]])
        or (row > 0).all()
    ):
        start = pose(sampler.axes(), np.abs(sampler.point(3)))
        row = np.array(
            [
                sampler.integer(1, 6),
                sampler.choice((-1, 1)) * RIGHT_ANGLE_RAD,
                sampler.choice((-1, 1)) * sampler.integer(1, 6),
                sampler.choice((-1, 1)) * RIGHT_ANGLE_RAD,
            ]
        )
    frames = {"0": start, "1": start @ link(row, "standard").value}
    return Problem(
        statement="Frames 0 and 1 follow the standard convention. Read their row from the drawing: $a_1, \\alpha_1, d_1, \\theta_1$. "
        "Lengths are whole metres, and angles are multiples of 90°.",
        further="Give the row that leads back from frame 1 to frame 0. Is it a standard row?",
        figure=partial(draw_frames, frames, numbers=True),
        answer=DHRowAnswer(row),
        solution=dh_row(*row),
        advice={"degrees": "Give the angles in radians."},
    )


@problem("05.2", "One row as a matrix", points=2, lecture="05_dh_standard#The general A matrix", level="Warm-up")
def one_row(sampler: ArmSampler) -> Problem:
    a, d = sampler.length(0.2, 0.9), sampler.length(0.2, 0.9)
    alpha, theta = sampler.choice([90, -90, 60, -60, 30, -30]), sampler.degrees(-75, 75)
    A = link([a, np.radians(alpha), d, np.radians(theta)], "standard", label="A_i")
    twice = 2 * np.radians(theta)
    turned_twice = with_position(A.value, np.array([a * np.cos(twice), a * np.sin(twice), d]))
    mirrored = A.value.copy()
    mirrored[[0, 1], [1, 0]] = mirrored[[1, 0], [0, 1]]
    return Problem(
        statement="Give the matrix $A_i$ of the row\n\n| a | alpha | d | theta |\n| --- | --- | --- | --- |\n"
        f"| {number(a)} | {alpha}° | {number(d)} | {theta}° |\n\nin the standard convention. Lengths are in metres.",
        method="$A_i = \\begin{pmatrix} c_\\theta & -s_\\theta c_\\alpha & s_\\theta s_\\alpha & a\\,c_\\theta \\\\ s_\\theta & c_\\theta "
        "c_\\alpha & -c_\\theta s_\\alpha & a\\,s_\\theta \\\\ 0 & s_\\alpha & c_\\alpha & d \\\\ 0 & 0 & 0 & 1 \\end{pmatrix}$, with $c$ "
        "and $s$ for cosine and sine.",
        further="For which rows are the standard and the modified matrix the same?",
        given={"a": a, "alpha_degrees": alpha, "d": d, "theta_degrees": theta},
        answer=PoseAnswer(A.value),
        solution=A.mistaken_for(
            ("inverse", "give the inverse", inverse(A)),
            ("entries swapped", "swap the entries $(1, 2)$ and $(2, 1)$", mirrored),
            ("rotated twice", "rotate $a$ by $\\theta$ twice", turned_twice),
        ),
    )


@problem("05.3", "A whole table from a drawing", points=4, lecture="05_dh_standard#Reading a table off a drawing")
def whole_table(sampler: ArmSampler) -> Problem:
    rows, places = np.zeros((3, 4)), [np.zeros(3)]
    while not are_distinguishable(places):
        d, a = sampler.shuffled(range(1, 4)), sampler.shuffled(range(1, 4))
        turns = [sampler.choice((0, 1, -1)) * RIGHT_ANGLE_RAD for _ in range(3)]
        leans = [sampler.choice((1, -1)) * RIGHT_ANGLE_RAD, sampler.choice((1, -1)) * RIGHT_ANGLE_RAD, 0]
        signs = [1, sampler.choice((-1, 1)), 0]
        rows = np.array([[a[i], leans[i], signs[i] * d[i], turns[i]] for i in range(3)], dtype=float)
        robot = DHTable(rows, convention="standard", name="your arm").to_chain()
        places = [np.zeros(3), rows[0, 2] * Z, *robot.joint_points[1:], robot.home[:3, 3]]
    table = DHTable(rows, convention="standard", name="your arm")
    return Problem(
        statement="Write a table of this arm in the standard convention. The drawing shows $q = 0$; each arrow shows the "
        "direction in which its joint rotates when $q$ grows. Frame 0 is {s} and frame 3 is {b}, so base and tool are the "
        f"identity. A table is right if it gives the pose of {{b}} for every $q$.\n\n{joint_table(robot)}\n\n"
        f"{{b}} is at ${vector(robot.home[:3, 3])}$, its $x$ along ${vector(robot.home[:3, 0])}$, its $z$ along "
        f"${vector(robot.home[:3, 2])}$.",
        method=rows_from_frames(table),
        further="Reverse one inner $x$ axis. Which four numbers of the table change?",
        figure=partial(draw_joints, robot, tool=True),
        shown={"screws": robot.screws, "home": robot.home, "points": robot.joint_points},
        answer=DHTableAnswer(table, anchored=True),
        mistakes=[rows_of_the_other_convention(table)],
    )


@problem("05.4", "Offsets from a drawn zero", points=3, lecture="05_dh_standard#The offset")
def offsets(sampler: ArmSampler) -> Problem:
    lengths = [sampler.integer(1, 3) for _ in range(3)]
    values = np.ones(3)
    while (values > 0).all() or np.abs(np.sin(values)).min() < 0.1:  # otherwise some sign would not matter
        headings = [sampler.degrees(15, 75), sampler.degrees(-60, 60), sampler.degrees(-150, 150)]
        values = np.radians(np.diff(headings, prepend=0))
    rows = [[a, 0, 0, theta] for a, theta in zip(lengths, values, strict=True)]
    table = DHTable(rows, convention="standard", name="Your planar arm")
    headings_text = ", ".join(f"link {i}: {angle}°" for i, angle in enumerate(headings, start=1))
    h1, h2, h3 = (radians(given(f"\\varphi_{i}", float(angle), ANGLE)) for i, angle in enumerate(headings, start=1))
    c = stack(h1, h2 - h1, h3 - h2)
    # The first offset, and the middle one of a reversed list, come out right by these wrong methods too.
    spoiled = c.mistaken_for(
        ("measured from the base", "measure every link from $x_0$", stack(h1, h2, h3), OFFSETS_ADVICE),
        ("added up", "add up the angles", stack(h1, h1 + h2, h1 + h2 + h3), "They are sums already."),
        ("inner angles", "give the inner angles between the links", np.pi - c, "$\\theta_i$ is 0 for a straight arm."),
        ("reversed", "list the offsets from the last joint to the first", c[::-1]),
        spoils=True,
    )
    c = spoiled.mistaken_for(
        ("sign", "measure backwards, from $x_i$ to $x_{i-1}$", -c, "Anticlockwise is positive here."),
        ("measured to the next link", "subtract the next link", stack(h1 - h2, h2 - h3, h3), OFFSETS_ADVICE),
        ("x across the link", "take $x_i$ perpendicular to link $i$", c + ACROSS, "$x_i$ runs along link $i$."),
        ("x across the link", "take $x_i$ perpendicular to link $i$", c - ACROSS, "$x_i$ runs along link $i$."),
        ("no offset", "leave out all offsets", 0 * c, "$\\theta_i$ is the angle of two $x$ axes, also at $q_i = 0$."),
    )
    return Problem(
        statement="All joint axes of this planar arm point towards you, and $x_i$ runs along link $i$. The manufacturer defines the "
        f"drawn configuration as $q = 0$. There, the links make these angles with $x_0$, anticlockwise positive: {headings_text}. "
        "In the table $\\theta_i = q_i + c_i$. Give the offsets $c_1, c_2, c_3$ in radians.",
        further="The arm is drawn at another zero. Which numbers of the table change, and which do not?",
        figure=partial(draw_table, table, view="top"),
        given={"headings_degrees": np.array(headings)},
        answer=DHEntriesAnswer(c, names=["offset of $\\theta_1$", "offset of $\\theta_2$", "offset of $\\theta_3$"]),
        advice={
            "degrees": "Give the offsets in radians.",
            **{
                f"leave out $-\\varphi_{i}$": f"So link {i + 1} is measured from $x_0$. {OFFSETS_ADVICE}"
                for i in (1, 2)
            },
        },
    )


@problem("05.5", "The faulty entry", points=3, lecture="05_dh_standard#Reading a table off a drawing")
def faulty_entry(sampler: ArmSampler) -> Problem:
    rows, places = np.zeros((3, 4)), [np.zeros(3)]
    while not are_distinguishable(places):
        rows = np.array(
            [
                [sampler.integer(1, 3), sampler.choice((-1, 1)), sampler.integer(1, 3), sampler.choice((-1, 0, 1, 2))]
                for _ in range(3)
            ],
            dtype=float,
        ) * (1, RIGHT_ANGLE_RAD, 1, RIGHT_ANGLE_RAD)
        table = DHTable(rows, convention="standard", name="Frames 0 to 3")
        places = [*table_frames(table)[:, :3, 3]]
    # half a turn could be typed with either sign
    i, k = sampler.choice([(i, k) for i in range(3) for k in range(4) if k in {0, 2} or rows[i, k] < 3])
    wrong = rows.copy()
    if k in {0, 2}:
        wrong[i, k] = sampler.choice([length for length in (1, 2, 3, -rows[i, k]) if length != rows[i, k]])
    else:
        quarter = round(rows[i, k] / RIGHT_ANGLE_RAD)
        wrong[i, k] = RIGHT_ANGLE_RAD * sampler.choice([other for other in (-1, 0, 1, 2) if (other - quarter) % 4])
    answer = f"{COLUMNS[k]}{i + 1}"
    printed = markdown_table([[number(a), degrees(alpha), number(d), degrees(theta)] for a, alpha, d, theta in wrong])
    problem = Problem(
        statement="The table below was read from the drawn frames, at $q = 0$, in the standard convention. One entry is wrong. "
        "Which one, and what is its right value? Answer with its column and row, and with the value in metres or radians, such as "
        f"`('d2', 1.5)`.\n\n{printed}",
        method=f"{rows_from_frames(table)}\nOnly {entry_names(3)[answer]} of the given table does not agree with them. It must be:",
        further="Where does the table, as it is printed, put the last frame?",
        figure=partial(draw_table, table, numbers=True),
        given={"frames": table_frames(table), "rows": wrong},
        answer=Choice(answer, entry_names(3)),
        mistakes=other_entries(answer, 3, "standard"),
    )
    return problem.with_reason(Numbers(np.array(rows[i, k])), "the value")


@problem("05.6", "Base and tool", points=2, lecture="05_dh_standard#Base and tool")
def base_and_tool(sampler: ArmSampler) -> Problem:
    rows = [
        [sampler.length(0.2, 0.6), sampler.choice([1, -1]) * RIGHT_ANGLE_RAD, sampler.length(0.2, 0.6), 0],
        [sampler.length(0.3, 0.8), 0, 0, 0],
    ]
    up, forward, sideways = sampler.length(1.2, 2.4), sampler.length(0.2, 0.8), sampler.length(0.2, 0.8)
    hangs = sampler.choice([(X, -Y, -Z), (-X, Y, -Z), (Y, X, -Z), (Y, Z, X), (Z, X, Y)])
    base = pose(hangs, (forward, sideways, up))
    looks = sampler.choice([(Y, Z, X), (Z, X, Y), (X, Z, -Y), (-Z, Y, X)])
    tool = pose(looks, (sampler.length(0.1, 0.3), 0, sampler.length(0.1, 0.3)))
    table = DHTable(rows, convention="standard", base=base, tool=tool, name="your arm")
    q = np.array([np.radians(sampler.degrees(20, 80)), np.radians(sampler.degrees(-80, -20))]).round(3)
    T_s0, T_2b = given_pose("T_{s0}", base), given_pose("T_{2b}", tool)
    A = links(rows, "RR", q, "standard")
    T = table_product(rows, "RR", q, "standard", [T_s0], [T_2b])
    unrotated = with_position(T.value, sum(factor.value[:3, 3] for factor in (T_s0, *A, T_2b)))
    T = T.mistaken_for(
        ("positions added", "add the positions without rotating them", unrotated),
        ("base and tool swapped", "swap $T_{s0}$ and $T_{2b}$", product(T_2b, *A, T_s0)),
        advice=BASE_AND_TOOL_ADVICE,
    )
    return Problem(
        statement=f"An arm has two rows, $(a, \\alpha, d, \\theta) = {_format_row(rows[0], 1)}$ and "
        f"${_format_row(rows[1], 2)}$, in the standard "
        f"convention. Its base frame 0 is at $T_{{s0}}$, and a camera {{b}} is mounted on frame 2 at $T_{{2b}}$:\n\n"
        f"$$T_{{s0}} = {matrix(base)}, \\qquad T_{{2b}} = {matrix(tool)}.$$\n\nGive the pose $T_{{sb}}(q)$ at $q = {vector(q)}$.",
        further="Can the base be written as a further row in front of the table? What must be true of it?",
        # drawn at zero, because the text alternative at q would give the answer away
        figure=partial(draw_table, table),
        given={"rows": np.array(rows), "base": base, "tool": tool, "q": q},
        answer=PoseAnswer(T),
        advice={
            "leave out $T_{s0}$": f"This is the pose of the camera in frame 0. {BASE_AND_TOOL_ADVICE}",
            "leave out $T_{2b}$": f"This is the pose of frame 2, without the tool. {BASE_AND_TOOL_ADVICE}",
            "reversed": ORDER_ADVICE,
            "order": ORDER_ADVICE,
        },
    )


def _format_row(row: list[float], i: int) -> str:
    a, alpha, d, _ = row
    lean = {1: "\\pi/2", -1: "-\\pi/2", 0: "0"}[round(alpha / RIGHT_ANGLE_RAD)]
    return f"({number(a)}, {lean}, {number(d)}, q_{i})"


@problem("05.7", "Parallel axes", points=4, lecture="05_dh_standard#Special cases", level="Hard")
def parallel_axes(sampler: ArmSampler) -> Problem:
    sides = np.zeros((2, 2))
    while abs(np.linalg.det(sides)) < 1 or abs(sides[0] @ sides[1]) < 1:  # no angle between them is a multiple of 90°
        pairs = sampler.shuffled([(3, 4), (6, 8), (5, 12)])[:2]  # of different lengths
        sides = np.array(
            [np.array(sampler.shuffled(pair)) * (sampler.choice((-1, 1)), sampler.choice((-1, 1))) for pair in pairs]
        )
    climbs = sampler.choice(CLIMBS)
    # no height is as large as a step
    free = [z for z in range(6, 13) if not {z, z + climbs[0], z + sum(climbs)} & {5, 10, 13}]
    first = np.array((0, 0, sampler.choice(free)), dtype=float)
    second = first + np.append(sides[0], climbs[0])
    third = second + np.append(sides[1], climbs[1])
    points = np.array([first, second, third])
    robot = arm([(Z, point) for point in points], pose((X, Y, Z), third), "Three upright joints", "drawn for you")
    z = [given(f"z_{i}", height) for i, height in enumerate(points[:, 2], start=1)]
    steps = [_axis_distance(i, *step) for i, step in enumerate(np.diff(points, axis=0), start=1)]
    a, d, theta = [a for a, _, _ in steps], [z[1] - z[0], z[2] - z[1]], steps[1][2] - steps[0][2]
    far, rise = float(np.hypot(*(third - first)[:2])), z[2] - z[0]
    d[1] = d[1].mistaken_for(("measured from joint 1", "measure $d_2$ from joint 1", rise, "Row 2 begins at joint 2."))
    answer = stack(a[0], d[0], a[1], d[1], theta)
    for name, text, wrong, advice in (
        ("off the normal", "measure $a$ from joint to joint", (steps[0][1], 0.0, steps[1][1], 0.0), NORMAL_ADVICE),
        ("a and d swapped", "swap $a$ and $d$", (d[0], a[0], d[1], a[1]), "$d$ is measured along $z$, and $a$ along $x$."),
        ("order of the numbers", "give $a_1, a_2, d_1, d_2$ in this order", (*a, *d), ""),
        ("height above the floor", "take the height above the floor for $d$", (a[0], z[1], a[1], z[2]), HEIGHT_ADVICE),
        ("sign of d", "measure $d$ downwards", (a[0], -d[0], a[1], -d[1]), "$d$ grows along $z$, which points up."),
        ("measured from joint 1", "measure both rows from joint 1", (a[0], d[0], far, rise), "Row 2 begins at joint 2."),
    ):  # fmt: skip
        answer = answer.mistaken_for(
            (name, text, stack(*wrong, theta), advice), spoils=name in {"measured from joint 1", "order of the numbers"}
        )
    return Problem(
        statement="Three parallel joint axes point up. The table gives a point of each joint. For parallel axes, the origin may be "
        "anywhere on its axis; here $O_0$ is at joint 1, $O_1$ at joint 2 and $O_2$ at joint 3. Each $x_i$ points from axis $i$ "
        f"to axis $i + 1$. Give $a_1, d_1, a_2, d_2$ and the angle $\\theta_2$ of this configuration, in metres and radians."
        f"\n\n{joint_table(robot)}",
        further="Move every origin to the height 0. What do the rows say now?",
        figure=partial(draw_joints, robot),
        given={"points": points},
        answer=DHEntriesAnswer(answer, names=["a_1", "d_1", "a_2", "d_2", "theta_2"]),
        advice={
            "leave out $-\\varphi_1$": "$\\theta_2$ is the angle from $x_1$ to $x_2$, and $x_1$ is not the $x$ axis of {s}.",
            "root left out": NORMAL_ADVICE,
            "square left out": NORMAL_ADVICE,
            **{f"leave out $-z_{i}$": HEIGHT_ADVICE for i in (1, 2)},
        },
    )


def _axis_distance(i: int, x: float, y: float, z: float) -> tuple[Expression, float, Expression]:
    """The distance of two vertical axes, that of two points on them, and the direction of their normal, from the step between them."""
    dx, dy, between = given(f"\\Delta x_{i}", x), given(f"\\Delta y_{i}", y), float(np.linalg.norm((x, y, z)))
    a = sqrt(square(dx) + square(dy)).named(f"a_{i}")
    a = a.mistaken_for(
        ("off the normal", f"take the distance of the joints as $a_{i}$", between),
        ("sum of the steps", f"add the steps along $x$ and $y$ for $a_{i}$", abs(x) + abs(y)),
        ("one step alone", f"take the step along $x$ alone as $a_{i}$", dx),
        ("one step alone", f"take the step along $y$ alone as $a_{i}$", dy),
        advice=NORMAL_ADVICE,
    )
    return a, between, arctan2(dy, dx).named(f"\\varphi_{i}")


@problem(
    "05.8", "A SCARA from its drawing", points=4, lecture="05_dh_standard#Reading a table off a drawing", level="Hard"
)
def scara(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7)
        turn = sampler.choice((-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD))
        rows = [(a, 0, b, turn), (c, np.pi, d, -turn), (0, 0, e, sampler.choice((RIGHT_ANGLE_RAD, -RIGHT_ANGLE_RAD)))]
        table = DHTable(rows, convention="standard", joints="RRP", base=pose((X, Y, Z), (f, g, 0)))
        if is_readable(table_frames(table)[:, :3, 3]):
            break
    return Problem(
        statement="The drawing shows a SCARA with joints RRP at home, in millimetres, with its standard frames: "
        "the origin of frame $i$ is D$i$, $z_i$ is the axis of joint $i + 1$, the arrow is $x_i$, and $z_3$ is along $z_2$. Give "
        "the three rows $a, \\alpha, d, \\theta$ at home, in metres and radians.",
        method=rows_from_frames(table),
        further="The arm is measured at another $q$. Which numbers of your rows do you see again?",
        figure=partial(draw_table_frames, table),
        answer=DHRowsAnswer(table.rows),
        mistakes=drawn_table_mistakes(table),
    ).without_duplicates()


@problem(
    "05.9",
    "Two tables without a common row",
    points=3,
    lecture="05_dh_standard#Reading a table off a drawing",
    level="Open",
)
def no_common_row(_: ArmSampler) -> Problem:
    return Problem(
        statement="Take the machine of Problem 8, and write a second table of it in the standard convention that has no row in common "
        "with yours. Frame 0 and the last frame stay where they are. Say for each change which rule allows it, and show that "
        "both tables give the same pose for every $q$, and not only for those that you tried.",
        answer=Prose(
            "Reverse $x_1$ and $x_2$, and move the origins along the parallel axes. Reversing $x_i$ negates $a_i$ and $\\alpha_i$, and "
            "adds $\\pi$ to $\\theta_i$ and $-\\pi$ to $\\theta_{i+1}$; moving $O_i$ by $h$ along $z_i$ subtracts $h$ from $d_{i+1}$, and "
            "adds it to $d_i$ if $z_{i-1}$ is parallel to $z_i$, or subtracts it there if it is antiparallel. In the product, $A_i$ is "
            "multiplied by $F$ and $A_{i+1}$ by $F^{-1}$ beside it, where $F$ is the change of frame $i$. They cancel for every $q$, "
            "because $F$ contains none.",
            {
                "a table without a common row": 1,
                "each change is one that the rules leave free, and is named": 1,
                "a proof for every $q$: the changes of a frame cancel in the product": 1,
            },
        ),
    )
