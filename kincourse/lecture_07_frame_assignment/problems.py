"""Sheet 07: the relation of two axes, frames and DH tables of drawn arms, broken rules, and equivalent tables."""

from dataclasses import replace
from functools import partial

import numpy as np

from kincourse.answers.dh_table import DHTableAnswer
from kincourse.answers.frames import DHFramesAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.mistakes.dh import entry_names, rows_of_the_other_convention
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.drawn_machines import is_readable, lengths, misread
from kincourse.text.dh_tables import markdown_table
from kincourse.text.joint_table import end_frames, given_frames, joint_table, rows_from_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import equivalent
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import DHTable, format_rows
from kinlib.rigid.lie import homogeneous
from kinlib.view import draw_joints
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.frames import draw_assignment
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import degrees, number, vector
from misstep.mistakes import Mistake
from misstep.mutants.expression import given
from misstep.mutants.operations import stack

TITLE = "DH frames for any arm"

RIGHT_ANGLE_RAD = np.pi / 2


@problem(
    "07.1",
    "A prismatic joint drawn elsewhere",
    points=2,
    lecture="07_frame_assignment#The axis of a prismatic joint is a free vector",
    level="Warm-up",
)
def prismatic_joint_elsewhere(sampler: ArmSampler) -> Problem:
    first = second = moved = 1.0
    while moved < first + second:  # otherwise an answer without signs would be right
        first, second, moved = sampler.shuffled(
            [sampler.length(0.2, 0.5), sampler.length(0.55, 0.9), sampler.length(0.95, 1.4)]
        )
    reach = first + second
    a_1, a_2, x = given("a_1", first), given("a_2", second), given("x", moved)
    answer = stack(x, a_1 + a_2 - x)
    for name, text, wrong, advice in (
        ("unchanged", "keep both numbers", (a_1, a_2), "The rows measure to the line on which the joint is drawn."),
        ("only the first", "change $a_1$ alone", (x, a_2), "Joint 3 is where it was, so $a_2$ changes too."),
        ("only the second", "change $a_2$ alone", (a_1, a_1 + a_2 - x), "$a_1$ is the distance from axis 1 to the axis of joint 2."),
        ("sign", "take both with the opposite sign", (-x, x - a_1 - a_2), "Both are measured along $x$."),
        ("sign of the second", "take $a_2$ with the opposite sign", (x, x - a_1 - a_2), "$a_2$ is measured along $x$."),
        ("measured from joint 3", "measure from joint 3", (a_1 + a_2 - x, -x), "Row 1 begins at joint 1."),
        ("displacement as a_1", "give the displacement of joint 2 as $a_1$", (x - a_1, a_1 + a_2 - x), "$a_1$ is measured from axis 1."),
        ("position added", "add the new position to $a_2$", (x, x + a_2), "The sum $a_1 + a_2$ stays the same."),
        ("displacement as a_2", "give the displacement of joint 2 as $a_2$", (x, x - a_1), "$a_2$ is measured to axis 3."),
        ("added to both", "add the displacement of joint 2 to both", (x, a_2 + x - a_1), "The sum $a_1 + a_2$ stays the same."),
    ):  # fmt: skip
        answer = answer.mistaken_for((name, text, stack(*wrong), advice))

    def adds_up(both: Array) -> str:
        text = f"$a_1 + a_2$ is the distance from axis 1 to axis 3, {number(reach)} m; yours add up to {number(both.sum())} m."
        return text if abs(both.sum() - reach) > 0.01 else ""

    robot = arm(
        [(Z, (0, 0, 0)), (-Y, (first, 0, 0), SLIDE), (Z, (reach, 0, 0))],
        pose((X, Y, Z), (reach, 0, 0)),
        "Your crane",
        "drawn for you",
    )
    return Problem(
        statement=f"The modified DH table of this arm has $a_1 = {number(first)}$ and $a_2 = {number(second)}$, because its prismatic "
        f"joint is drawn at $x = {number(first)}$. Another drawing has the same joint at $x = {number(moved)}$, with the same direction. "
        f"Give $a_1$ and $a_2$ in the table of the other drawing, with every $x$ axis along $x$ of {{s}}.\n\n{joint_table(robot)}",
        further="At which place of the joint is one of the two lengths 0?",
        figure=partial(draw_joints, robot),
        given={"a_1": first, "a_2": second, "moved_to": moved},
        answer=Numbers(answer, unit="m", test=adds_up),
        advice={"leave out $-x$": "$a_2$ leads from joint 2 to joint 3.", "entries swapped": "$a_1$ leads to joint 2."},
    )


@problem("07.2", "Frames by the rules", points=3, lecture="07_frame_assignment#The algorithm", level="Warm-up")
def frames_by_the_rules(sampler: ArmSampler) -> Problem:
    robot = sampler.arm("RRR")
    found = assign_frames(robot, convention="standard").frames
    return Problem(
        statement="Place frames 0 to 3 on this arm by the rules of the standard convention. Answer with the four poses of these "
        "frames in {s}, an array of shape (4, 4, 4). Either place the frames by hand in the next cell and copy the poses, or write "
        "each with `pose((x, y, z), origin)` from `kinlib.chains.robots`. Where the rules leave a choice, every choice is right."
        f"\n\n{joint_table(robot)}",
        method="$z_{i-1}$ lies on the axis of joint $i$. The origin $O_i$ is where the common normal of axes $i$ and $i + 1$ meets axis "
        "$i + 1$, and $x_i$ is along this normal. Frame 0 may be anywhere on axis 1. The last frame is free, but the line of its $x$ is "
        "perpendicular to $z_2$ and intersects it. One right choice:",
        further="Where did the rules leave you a choice, and what would the table look like with the other one?",
        figure=partial(draw_joints, robot),
        shown={"arm": robot, "screws": robot.screws, "home": robot.home, "points": robot.joint_points},
        answer=DHFramesAnswer(found, chain=robot, convention="standard"),
        mistakes=[
            Mistake(
                "z on the wrong joint",
                assign_frames(robot, convention="modified").frames,
                "You put $z_i$ on the axis of joint $i$. In the standard convention $z_i$ lies on the axis of joint $i + 1$, so "
                "$z_0$ lies on the axis of joint 1.",
            ),
            Mistake(
                "left-handed",
                found * (1, -1, 1, 1),
                "Your frames are left-handed. A frame is right-handed if $y = z \\times x$: negate every $y$.",
            ),
            Mistake(
                "axes in rows",
                homogeneous(found[:, :3, :3].swapaxes(1, 2), found[:, :3, 3]),
                "You wrote the axes of each frame into the rows of its rotation matrix. They are its columns.",
            ),
        ],
    )


@problem("07.3", "The table of a drawn arm", points=3, lecture="07_frame_assignment#What is free")
def table_of_an_arm(sampler: ArmSampler) -> Problem:
    robot = sampler.arm(sampler.choice(["RRR", "RRRP", "RRRR"]))
    table = assign_frames(robot, convention="standard").table
    return Problem(
        statement="Write a DH table of this arm in the standard convention: text with the header `a | alpha | d | theta` and one row for "
        f"each joint, with `q1`, `q2`, ... for the joint variables. {_given(robot.n)} Every table that gives the pose of frame {robot.n} "
        f"in frame 0 for every $q$ is right, so you may choose the frames between them."
        f"\n\n{joint_table(robot)}\n\n{given_frames(table)}",
        method=rows_from_frames(table),
        further="Find a second table of this arm without a row of yours. How do you prove that they agree?",
        figure=partial(draw_joints, robot),
        shown={"screws": robot.screws, "home": robot.home, "points": robot.joint_points, **end_frames(table)},
        answer=DHTableAnswer(table, anchored=True),
        mistakes=[rows_of_the_other_convention(table)],
    )


@problem("07.4", "Parallel and antiparallel axes", points=3, lecture="07_frame_assignment#The algorithm")
def parallel_axes(sampler: ArmSampler) -> Problem:
    height, upper_arm, forearm, wrist = (sampler.integer(1, 4) for _ in range(4))
    sideways, backwards = sampler.integer(1, 3), sampler.choice((-1, 1)) * sampler.integer(1, 3)
    sign = sampler.choice((-1, 1))
    points = np.cumsum(
        [(0, 0, height), (upper_arm, 0, 0), (forearm, sideways, 0), (0, backwards, wrist)], axis=0
    ).astype(float)
    axes = [Z, sign * Y, sign * Y, -sign * Y, X]
    robot = arm(
        [*zip(axes, [np.zeros(3), *points], strict=True)], pose((X, Y, Z), points[-1] + X), "Your arm", "drawn for you"
    )
    table = assign_frames(robot, convention="modified").table
    same_direction, without_d = table.rows.copy(), table.rows.copy()
    same_direction[3, 1], without_d[:, 2] = 0.0, 0.0
    return Problem(
        statement="Axes 2, 3 and 4 of this arm are parallel lines, and axis 4 has the opposite direction. Write a DH table in the "
        f"modified convention. {_given(robot.n)} Every table that gives the pose of frame {robot.n} in frame 0 for every $q$ is right. "
        f"\n\n{joint_table(robot)}\n\n{given_frames(table)}",
        method=rows_from_frames(table),
        further="Turn axis 4 so that it has the direction of axis 3. Which rows change?",
        figure=partial(draw_joints, robot),
        shown={"screws": robot.screws, "home": robot.home, "points": robot.joint_points, **end_frames(table)},
        answer=DHTableAnswer(table, anchored=True),
        mistakes=[
            Mistake(
                "alpha left out",
                table.changed(rows=same_direction),
                "Your table moves as if the axis of one joint had the opposite direction.\n"
                "Axes 3 and 4 have opposite directions, so $\\alpha_3 = \\pi$.",
            ),
            Mistake(
                "d left out",
                table.changed(rows=without_d),
                "Your table moves as if every $d$ were 0. You may move an origin along parallel axes, but the distance between "
                "the first and the last common normal does not change: some $d$ must contain the displacement along $y$.",
            ),
            rows_of_the_other_convention(table),
        ],
    )


RULES = {
    "a": "$x_i$ is not perpendicular to $z_{i-1}$",
    "b": "the line of $x_i$ does not intersect the axis $z_{i-1}$",
    "c": "$z_i$ is not parallel to the axis of joint $i + 1$",
    "d": "the origin does not lie on the axis of joint $i + 1$",
    "e": "no rule: the frame is legal",
}

RULE_EXPLANATIONS = {
    "a": "Compute the scalar product of $x_i$ and $z_{i-1}$: it is 0 if they are perpendicular.",
    "b": "Check whether the line through the origin of frame $i$ along $x_i$ has a point in common with the axis $z_{i-1}$.",
    "c": "Compare $z_i$ with the axis direction of joint $i + 1$, not of joint $i$.",
    "d": "Check whether the vector from the origin to a point on the axis of joint $i + 1$ is a multiple of its direction.",
    "e": "Check the rules one by one, with the numbers.",
}


@problem("07.5", "Which rule is broken?", points=3, lecture="07_frame_assignment#When a table is wrong")
def which_rule(sampler: ArmSampler) -> Problem:
    robot, right = sampler.arm("RRR"), sampler.choice(list(RULES))
    found = assign_frames(robot, convention="standard")
    i, frames = sampler.integer(1, 2), found.frames.copy()
    T, distance = frames[i], sampler.choice((-1, 1)) * sampler.integer(1, 2)
    angle = sampler.choice((-1, 1)) * np.radians(sampler.choice([30, 45, 60]))
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = T[:3, :3].T
    axes, origin = {
        "a": ((c * x + s * y, c * y - s * x, z), T[:3, 3]),
        "b": ((x, y, z), T[:3, 3] + distance * z),
        "c": ((x, c * y + s * z, c * z - s * y), T[:3, 3]),
        "d": ((x, y, z), T[:3, 3] + distance * x),
        "e": ((-x, -y, z), T[:3, 3]),
    }[right]
    frames[i] = pose(axes, origin)
    before = frames[i - 1]
    step = origin - before[:3, 3]
    shows, shown = {
        "a": (axes[0] @ before[:3, 2], f"$x_{i} \\cdot z_{i - 1}$ must be 0, and it is"),
        "b": (
            abs(np.cross(axes[0], before[:3, 2]) @ step),
            f"$|(x_{i} \\times z_{i - 1}) \\cdot (O_{i} - O_{i - 1})|$, the distance between the two lines, must be 0, and it is",
        ),
        "c": (axes[2] @ robot.screws[i, :3], f"$z_{i}$ must be parallel to the axis, but the scalar product is"),
        "d": (
            np.linalg.norm(np.cross(origin - robot.joint_points[i], robot.screws[i, :3])),
            f"$O_{i}$ must lie on the axis of joint {i + 1}, and its distance from there is",
        ),
        "e": (before[:3, 2] @ step, f"All rules hold. $d_{i} = z_{i - 1} \\cdot (O_{i} - O_{i - 1})$, which is"),
    }[right]
    listed = "\n".join(f"- {letter}) {rule}" for letter, rule in RULES.items())
    problem = Problem(
        statement=f"Frames were placed on this arm in the standard convention. Frame {i - 1} is right: its origin is at "
        f"${vector(before[:3, 3])}$, and $z_{i - 1} = {vector(before[:3, 2])}$. Frame {i} has its origin at ${vector(origin)}$, with "
        f"$x_{i} = {vector(axes[0])}$ and $z_{i} = {vector(axes[2])}$. Which rule does frame $i = {i}$ break?"
        f"\n\n{joint_table(robot)}\n\n{listed}\n\nAnswer with a letter and a number that shows it, such as `('a', 0.5)`: for a) the "
        "scalar product of $x_i$ and $z_{i-1}$, for b) the distance of the line from the axis, for c) the scalar product of $z_i$ and the "
        "direction of joint $i + 1$, for d) the distance of the origin from the axis of joint $i + 1$, and for e) $d_i$.",
        method=f"{shown} ${number(float(shows))}$.",
        further="Change one frame so that exactly two rules are broken.",
        figure=partial(_with_frames, robot, frames),
        given={"frame": i, "frames": frames, "screws": robot.screws, "points": robot.joint_points},
        answer=Choice(right, RULES),
        mistakes=[_rule_mistake(wrong, right) for wrong in RULES if wrong != right],
    )
    return problem.with_reason(Numbers(np.array(float(shows))), "the number")


def _rule_mistake(wrong: str, right: str) -> Mistake:
    if wrong == "e":
        return Mistake("called legal", wrong, f"This frame breaks a rule. {RULE_EXPLANATIONS[right]}")
    text = f"The frame obeys this rule{', but it breaks another one' * (right != 'e')}. {RULE_EXPLANATIONS[wrong]}"
    return Mistake(f"rule {wrong}", wrong, text + " The direction of $x$ may also be reversed." * (right == "e"))


def _with_frames(robot: Chain, frames: Array) -> Picture:
    return draw_assignment(replace(assign_frames(robot, convention="standard"), frames=frames))


@problem("07.6", "A table to correct", points=3, lecture="07_frame_assignment#When a table is wrong")
def table_to_mend(sampler: ArmSampler) -> Problem:
    rows = np.zeros((4, 4))
    for i in range(4):
        rows[i] = sampler.integer(1, 3), sampler.choice((-1, 1)) * RIGHT_ANGLE_RAD, sampler.integer(1, 3), 0.0
    table = DHTable(rows, convention="standard", name="Your arm")
    robot = table.to_chain()
    i, k = sampler.choice([(1, 0), (2, 0), (1, 2), (2, 2)])
    error = sampler.choice([step for step in (-2, -1, 1, 2) if rows[i, k] + step > 0])
    printed = rows.copy()
    printed[i, k] += error
    wrong_sign, other_length = printed.copy(), printed.copy()
    wrong_sign[i, k] += error
    other_length[i, 2 - k] -= error
    return Problem(
        statement="This DH table was written for the arm below, in the standard convention, but one of its lengths is wrong. Compare "
        f"the table with the axes, and give the corrected table. {_given(4)}"
        f"\n\n{_format_table(table.changed(rows=printed))}\n\n{joint_table(robot)}\n\n{given_frames(table)}",
        method=f"The table has ${COLUMNS[k]}_{i + 1} = {number(printed[i, k])}$, but the distance of "
        + (f"axes {i + 1} and {i + 2}" if k == 0 else f"the common normals on axis {i + 1}")
        + f" is {number(rows[i, k])} m. The rows at $q = 0$, where each $q_i$ is added to $\\theta_i$:",
        further="Which measurement of the arm would have shown this fault first?",
        figure=partial(draw_joints, robot),
        given={"rows": printed},
        shown={"screws": robot.screws, "home": robot.home, "points": robot.joint_points, **end_frames(table)},
        answer=DHTableAnswer(table, anchored=True, printed=True),
        mistakes=[
            Mistake(
                "as printed",
                table.changed(rows=printed),
                "This is the table as it is printed. One of its lengths does not agree with the axes.",
            ),
            Mistake(
                "wrong sign of the correction",
                table.changed(rows=wrong_sign),
                "The entry is the right one, but you changed it with the wrong sign: its error is twice as large now.",
            ),
            Mistake(
                "other length",
                table.changed(rows=other_length),
                "The row is the right one, but you changed its other length. $a$ is the distance between two axes, $d$ the distance "
                "between two common normals.",
            ),
        ],
    )


@problem("07.7", "Which table is the same arm?", points=3, lecture="07_frame_assignment#Two right tables", level="Hard")
def same_arm(sampler: ArmSampler) -> Problem:
    table, changed, entry = _tables_to_compare(sampler)
    names = list(changed)
    order = sampler.shuffled(names)
    letters = dict(zip("abcd", order, strict=True))
    right = next(letter for letter, name in letters.items() if name == "legal")
    shown = "\n\n".join(f"**{letter})**\n\n{_format_table(changed[name])}" for letter, name in letters.items())
    why = {
        "x reversed in part": "In this table $a_3$ has the other sign, as if $x_3$ were reversed. But if $x_3$ is reversed, "
        "$\\alpha_3$ changes its sign too.",
        "origin moved in part": "In this table $d_2$ is changed, as if $O_2$ were moved along the parallel axes 2 and 3. But then "
        "$d_3$ must change by the same amount with the opposite sign.",
        "one sign": "In this table one entry has the other sign, and no other entry compensates for it.",
    }
    spoiled = next(letter for letter, name in letters.items() if name == "one sign")
    problem = Problem(
        statement=f"Here is a DH table in the standard convention:\n\n{_format_table(table)}\n\nWhich of the following tables "
        f"describes the same mechanism? And which single entry of table {spoiled}) must change, so that it does so as well?\n\n{shown}\n\n"
        "Answer with a letter and an entry, such as `('a', 'd2')`.",
        method="Reversing $x_3$ negates $a_3$ and $\\alpha_3$, and adds $180°$ to $\\theta_3$ and $-180°$ to $\\theta_4$. Moving $O_2$ "
        "along the parallel "
        f"axes 2 and 3 adds to $d_2$ what it takes from $d_3$. Only table {right}) has both changes complete. Table {spoiled}) has them "
        f"as well, "
        "and the other sign in one more entry.",
        further="Write one more table of the same arm that looks as different as possible.",
        given={"table": table.rows, "tables": {letter: changed[name].rows for letter, name in letters.items()}},
        shown={"spoiled": spoiled},
        answer=Choice(right, dict.fromkeys("abcd", "a table")),
        mistakes=[Mistake(name, letter, why[name]) for letter, name in letters.items() if name != "legal"],
    )
    return problem.with_reason(Choice(entry, entry_names(5)), "the entry")


def _tables_to_compare(sampler: ArmSampler) -> tuple[DHTable, dict[str, DHTable], str]:
    """Draw a table with parallel axes 2 and 3, an equivalent one, three with an incomplete change, and the one entry of the last."""
    entry, (row, column) = sampler.choice((("d4", (3, 2)), ("a4", (3, 0)), ("alpha4", (3, 1))))
    while True:
        rows = np.zeros((5, 4))
        for i in range(5):
            rows[i] = (
                sampler.length(0.1, 0.6),
                np.radians(sampler.choice([90, -90, 60, -60])),
                sampler.length(0.1, 0.6),
                0.0,
            )
        rows[1, 1], shift = 0.0, sampler.length(0.1, 0.4)
        table = DHTable(rows, convention="standard")
        reversed_x = rows.copy()
        reversed_x[2] = reversed_x[2] * (-1, -1, 1, 1) + (0, 0, 0, np.pi)
        reversed_x[3, 3] -= np.pi
        part_of_x = reversed_x * np.where(np.outer(np.eye(5)[2], np.eye(4)[1]) == 1, -1, 1)
        legal = reversed_x + shift * np.outer(np.eye(5)[1] - np.eye(5)[2], np.eye(4)[2])
        part_of_origin = reversed_x + shift * np.outer(np.eye(5)[1], np.eye(4)[2])
        sign = legal * np.where(np.outer(np.eye(5)[row], np.eye(4)[column]) == 1, -1, 1)
        rows_by_name = {
            "legal": legal,
            "x reversed in part": part_of_x,
            "origin moved in part": part_of_origin,
            "one sign": sign,
        }
        changed = {name: table.changed(rows=new) for name, new in rows_by_name.items()}
        if [bool(equivalent(table, other)) for other in changed.values()] == [True, False, False, False]:
            return table, changed, entry


def _given(n: int) -> str:
    return (
        "The arm is drawn at $q = 0$, and each $q$ is positive about or along the direction of its joint. The poses of frame 0 and "
        f"frame {n} in {{s}} are given."
    )


def _format_table(table: DHTable) -> str:
    return markdown_table(format_rows(table, length=number, angle=degrees))


@problem("07.8", "The leg of a walking machine", points=4, lecture="07_frame_assignment#The algorithm", level="Hard")
def leg(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        hip = np.array([a, b, 0.9 + h])
        roll = hip + np.array([c, -d, -e])
        knee = roll + np.array([f, a, -g])
        if is_readable([hip, roll, knee]) and knee[2] > 0.1:
            break
    axes = [sampler.choice((-1, 1)) * axis for axis in (Z, X, Y)]
    origins = np.array([(hip[0], roll[1], roll[2]), (knee[0], roll[1], knee[2])])
    drawn = [DrawnAxis(str(i), w, p) for i, w, p in zip((1, 2, 3), axes, (hip, roll, knee), strict=True)]
    first_feet = np.array([(hip[0], hip[1], roll[2]), (knee[0], roll[1], roll[2])])
    wrong = [
        (
            "the other foot",
            first_feet,
            "Your points are the feet of the common normals on the first of the two axes. O_i is the foot on axis i + 1.",
        ),
        (
            "marks for feet",
            np.array([roll, knee]),
            "Your points are the marks of joints 2 and 3. An origin is where the common normal meets the axis.",
        ),
        (
            "marks for feet",
            np.array([hip, roll]),
            "Your points are the marks of joints 1 and 2, and no feet of normals.",
        ),
        ("origins swapped", origins[::-1], "The two origins are swapped: O_1 is on axis 2, O_2 on axis 3."),
    ]
    return Problem(
        statement="The drawing shows the leg of a walking machine at home, in millimetres: joint 1 is the yaw of the hip, 2 its roll, "
        "and 3 the knee, all of them revolute. Where are the origins $O_1$ and $O_2$ of the frames of the standard convention? Give "
        "their coordinates in {s}, in metres, as rows.",
        method="Axis 1 is vertical, axis 2 along $x$ and axis 3 along $y$. $O_1$ is the point of axis 2 above or below which axis 1 "
        "passes: it has the $x$ of P1, and $y$ and $z$ of P2. $O_2$ is the point of axis 3 nearest to axis 2: it has $x$ and $z$ of P3, "
        "and the $y$ of P2.",
        further="Axis 1 is moved by 0.1 m along $x$. Which origin moves, and in which direction?",
        figure=lambda: draw_dimensions(
            [hip, (hip[0], hip[1], roll[2]), roll, knee, knee * (1, 1, 0)], drawn, {"P1": hip, "P2": roll, "P3": knee}
        ),
        answer=VectorsAnswer(origins, unit="m", names=["O_1", "O_2"]),
        mistakes=[Mistake(name, value, text) for name, value, text in (*wrong, *misread(origins))],
    ).without_duplicates()


@problem("07.9", "Where the rules leave a choice", points=3, lecture="07_frame_assignment#What is free", level="Open")
def choices_of_the_rules(_: ArmSampler) -> Problem:
    return Problem(
        statement="Take a machine that you can look at, such as a lamp, an excavator or a door closer, with at least three joints, of "
        "which two neighbours have parallel axes. Describe its axes. Where do the rules of the standard convention leave you a "
        "choice, and how do you decide it? Then one of the parallel axes is mounted half a degree off. What happens to your "
        "frames and to your table?",
        answer=Prose(
            "For parallel axes the common normal may be anywhere along them; put it where the neighbouring row gets $d = 0$. The "
            "direction of every $x_i$ along a normal, that of $z_0$ and the whole of the last frame are free as well. If the axes "
            "are half a degree off, they have exactly one common normal, which may be metres away: $O_i$ jumps there, $d$ becomes "
            "large with opposite signs in two rows, and small errors of the angle change it by much.",
            {
                "the axes of a real machine, two of them parallel, described so that they can be drawn": 1,
                "all choices that the rules leave there, each with a decision": 1,
                "the common normal jumps, and large lengths come up that nearly cancel": 1,
            },
        ),
    )
