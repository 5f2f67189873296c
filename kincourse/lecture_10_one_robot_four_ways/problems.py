"""Sheet 10: problems on the whole course. Each leads from one description of an arm to another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kincourse.answers.dh_row import DHRowsAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.links import link
from kincourse.expressions.poses import inverse
from kincourse.expressions.screws import change_frame, joint_screws, revolute
from kincourse.expressions.urdf import rpy_rotation
from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import effect_of
from kincourse.lecture_10_one_robot_four_ways.project import Project, open_project
from kincourse.mistakes.dh import is_in_several_rows
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG
from kincourse.sampling.drawn_machines import drawn_table_mistakes, misread
from kincourse.text.dh_tables import markdown_table
from kincourse.text.joint_table import rows_from_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable, format_rows
from kinlib.rigid.lie import adjoint, homogeneous, log
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import inverse as inverted
from kinlib.rigid.rpy import roll_pitch_yaw
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.likeness import LENGTH, PURE
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import degrees, matrix, number, vector
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression, given, product
from misstep.mutants.operations import radians

TITLE = "One robot, four ways"

RIGHT_ANGLE_RAD = np.pi / 2

MIN_ENTRY_DIFFERENCE = 0.3
"""The minimum difference of the wrong pose from the right ones in some entry, so that it cannot be taken for rounding."""

REPORTS = {
    "a": "This one is $T_{sb}$ already.",
    "b": "Take its inverse.",
    "c": "$R = R_z(\\text{yaw}) R_y(\\text{pitch}) R_x(\\text{roll})$.",
    "d": "Take its exponential.",
}
"""For each kind of report in problem 3 how it becomes a pose."""


@problem("10.1", "From a table to a screw", points=2, lecture="10_one_robot_four_ways#A table", level="Warm-up")
def from_a_table(sampler: ArmSampler) -> Problem:
    length = partial(sampler.length, 0.1, 0.9)
    right_angle = partial(sampler.choice, (-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD))

    def theta() -> float:
        # With a right angle a length of row 1 would lie along z_2, and change no moment.
        return float(np.radians(sampler.choice((-1, 1)) * sampler.choice(PLAIN_ANGLES_DEG)))

    rows = np.array([(length(), right_angle(), length(), theta()) for _ in range(2)] + [(length(), 0.0, 0.0, 0.0)])
    A = [link(row, "standard", i) for i, row in enumerate(rows, start=1)]
    table = DHTable(rows, convention="standard")

    def axis_of(T: Expression, k: int) -> Expression:
        return revolute(T[:3, 2].named(f"z_{k}"), T[:3, 3].named(f"O_{k}"))

    T_02, T_03 = A[0] @ A[1], product(*A)
    z, O = T_02[:3, 2].named("z_2"), T_02[:3, 3].named("O_2")
    z = z.mistaken_for(
        ("another axis", "take $x_2$ instead of $z_2$", T_02[:3, 0]),
    )
    for k, T in ((1, A[0]), (3, T_03)):
        O = O.mistaken_for(("another point", f"take $O_{k}$ instead of $O_2$", T[:3, 3]))
    S = revolute(z, O)
    S = S.mistaken_for(
        ("another joint", "take $z_3$ and $O_3$", axis_of(T_03, 3)),
        ("another joint", "take $z_1$ and $O_1$, the axis of joint 2", axis_of(A[0], 1)),
        ("another joint", "take $z_0$ and $O_0$, the axis of joint 1", axis_of(given("I", np.eye(4)), 0)),
        ("body screw", "give $B_3$, the screw axis in frame 3", change_frame(inverse(T_03), S)),
    )
    return Problem(
        statement="The table of an arm with three revolute joints is in the standard convention, and its frame 0 is {s}. Give the screw "
        f"axis $S_3$ of joint 3 in {{s}}, at home.\n\n{_format_table(table)}",
        method="$z_2$ is the third column of $A_1 A_2$, the axis of joint 3, and $O_2$ its last column.",
        further="Which entries of the screw depend on the choice of $x_2$?",
        given={"rows": rows},
        answer=ScrewsAnswer(S),
        advice={
            "another joint": "In the standard convention joint $i$ rotates about $z_{i-1}$, so joint 3 rotates about $z_2$.",
            "body screw": "In {s} it is $S_3 = \\mathrm{Ad}_M B_3$.",
        },
    )


@problem("10.2", "The origin of a joint", points=2, lecture="10_one_robot_four_ways#A file", level="Warm-up")
def joint_origin(sampler: ArmSampler) -> Problem:
    # With two right angles, fixed and moving axes could be swapped.
    degrees = [sampler.choice((90, -90)), 0, sampler.choice((-60, -30, 30, 60))]
    here, there = sampler.point(4) / 10, sampler.point(4) / 10
    R = rpy_rotation("R", radians(given("\\mathrm{rpy}", np.array(degrees))))
    step = (given("p_2", there) - given("p_1", here)).named("(p_2 - p_1)")
    step = step.mistaken_for(("order", "take the vector from joint 2 to joint 1", here - given("p_2", there)))
    xyz = R.T @ step
    for name, text, place in (
        ("from the base", "give the position of joint 2 in {s}", there),
        ("another joint", "give the position of joint 1", here),
        ("order", "rotate the position of joint 2 before subtracting that of joint 1", R.T @ there - here),
        ("placed by joint 1", "take the position of joint 2 as given in the frame of joint 1", here + R @ there),
    ):
        advice = "The `xyz` of joint 2 has its components in the frame of joint 1. The problem gives the position of joint 2 in {s}."
        xyz = xyz.mistaken_for((name, text, place, advice))
    return Problem(
        statement=f"In a URDF file, the origin of joint 1 in the base frame {{s}} is `xyz` = ${vector(here)}$ and "
        f"`rpy` = ${vector(degrees)}$ degrees. At home the position of joint 2 is ${vector(there)}$ in {{s}}. "
        "Give the `xyz` of joint 2, whose parent is the link of joint 1, in metres.",
        further="With which `rpy` of joint 2 would its frame be parallel to {s}?",
        given={"xyz_1": here, "rpy_1_in_degrees": np.array(degrees, dtype=float), "place_2": there},
        answer=VectorsAnswer(xyz, unit="m"),
        advice={
            "transpose left out": "$R$ takes components in the frame of joint 1 to components in {s}; here you need $R^T$.",
            "factor left out": "The frame of joint 1 is rotated: give the components along its axes.",
            "term left out": "The origin of joint 1 is not at the origin of the base frame.",
        },
    )


@problem("10.3", "One of four is wrong", points=3, lecture="10_one_robot_four_ways#Do they agree?")
def one_of_four(sampler: ArmSampler) -> Problem:
    names = {"a": "space screws", "b": "body screws", "c": "table", "d": "file"}
    wrong = sampler.choice("abcd")
    right = fault = np.eye(4)
    while np.linalg.norm((right - fault)[:3, 3]) < MIN_ENTRY_DIFFERENCE:
        robot = sampler.arm(sampler.choice(("RRR", "RPR", "RRP")), reach=3)
        q = np.array([sampler.choice((0.3, 0.5, 0.7, 0.9)) for _ in range(3)])
        right, fault = robot.fk(q), np.linalg.multi_dot([*exponential(robot.screws * q[:, None])[::-1], robot.home])
    poses = [fault if letter == wrong else right for letter in names]
    T, T_inverse, placed, twist = poses[0], inverted(poses[1]), poses[2], log(poses[3])
    xyz, rpy = placed[:3, 3], roll_pitch_yaw(placed[:3, :3])
    problem = Problem(
        statement="Four descriptions of one arm were evaluated at the same $q$, and one of them is wrong. Each report gives "
        "the pose of the tool in another format. Which description is wrong, and how far from the others, in metres, does it put "
        "the tool? Answer with its letter and the distance, such as `('a', 0.5)`.\n\n"
        f"- (a) space screws: $T_{{sb}} = {matrix(T)}$\n"
        f"- (b) body screws: the pose of {{s}} in {{b}}, $T_{{bs}} = {matrix(T_inverse)}$\n"
        f"- (c) table: `xyz` = ${vector(xyz)}$ m and `rpy` = ${vector(rpy)}$ rad, as in a URDF\n"
        f"- (d) file: the twist ${vector(twist)}$ whose exponential is $T_{{sb}}$",
        method="As $T_{sb}$, the reports put the tool at "
        + ", ".join(f"({letter}) ${vector(pose[:3, 3])}$" for letter, pose in zip(names, poses, strict=True))
        + ": invert (b), and take the exponential of (d).",
        further="How many configurations do you need to find the wrong description for certain?",
        given={"T_sb": T, "T_bs": T_inverse, "xyz": xyz, "rpy": rpy, "twist": twist},
        answer=Choice(wrong, names),
        mistakes=[
            Mistake(
                letter,
                letter,
                f"You answered {name}, but this report agrees with two others if you write all four as $T_{{sb}}$. "
                f"{REPORTS[letter]} The wrong report agrees with none of the others.",
            )
            for letter, name in names.items()
            if letter != wrong
        ],
    )
    return problem.with_reason(Numbers(np.array(np.linalg.norm((right - fault)[:3, 3])), unit="m"), "the distance")


@dataclass(frozen=True, eq=False)
class OriginsAnswer(Numbers):
    """Poses of frames, each in the frame before it, (k, 4, 4), as the origins of a URDF file; each pose is a part."""

    noun: ClassVar[str] = "the origins of the joints and of the tool, an array"
    alike_rows: ClassVar[bool] = True

    @property
    def parts(self) -> Sequence[str]:
        return [*(f"the origin of joint {i}" for i in range(1, len(self.value))), "the origin of the tool"]

    def kinds(self) -> NDArray[np.int_]:
        return np.broadcast_to([[PURE] * 3 + [LENGTH]] * 3 + [[PURE] * 4], np.shape(self.value))


def misread_origins(T: Array) -> Iterator[tuple[str, Array, str]]:
    """Yield how people get the origins (k, 4, 4) of a drawn file wrong: the name, the wrong poses, and what is true of them."""
    R, p, in_base = T[:, :3, :3], T[:, :3, 3], np.array(list(accumulate(T, np.matmul)))
    transposed, straight = homogeneous(R.swapaxes(1, 2), p), homogeneous(np.eye(3), p)
    moved = homogeneous(R, np.diff(in_base[:, :3, 3], axis=0, prepend=0))
    yield "inverse", inverted(T), "Every pose is the inverse: the parent seen from the child."
    yield "rotation transposed", transposed, "In every origin, the rotation is the transpose of the right one."
    yield "no rpy", straight, "Every xyz is right, and every rpy is left at 0."
    yield ("rotation left out", moved, "Every xyz is in the axes of {s}. It is wanted in those of the parent.")
    yield "in the base", in_base, "Every pose is in the frame of the base. An origin is in the frame of the parent."


def _listed(wrong: Iterator[tuple[str, Any, str]], right: Array) -> list[Mistake]:
    n = len(right)
    return [
        Mistake(name, value, text, spoils=is_in_several_rows(value.reshape(n, -1), right.reshape(n, -1)))
        for name, value, text in wrong
    ]


def _begin(project: Project) -> str:
    kinds = {"R": "revolute", "P": "prismatic"}
    joints = ", ".join(f"{i} {kinds[letter]}" for i, letter in enumerate(project.joints, start=1))
    return f"Your machine is the {project.name} of your project. Its joints are {joints}. "


@problem("10.4", "Project: the marks of the axes", points=2, lecture="10_one_robot_four_ways#The project")
def marks_of_the_axes(sampler: ArmSampler) -> Problem:
    project, right = open_project(sampler.student), draw_machine(sampler.student)
    points = np.array([*right.points, right.chain.home[:3, 3]])
    names = [*(f"P{i}" for i in range(1, len(points))), "T"]
    return Problem(
        statement=f"{_begin(project)}Read the points P1 to P{len(points) - 1} and T off sheet 1 of the drawing: their coordinates in "
        "{s}, in metres, one point in each row.",
        method="The top view shows $x$ and $y$, the front view $x$ and $z$. Add up the steps from {s} to each mark.",
        further="Which mark would you measure again, because an error there does the most harm?",
        figure=lambda: project.drawing("screws"),
        answer=VectorsAnswer(points, unit="m", names=names),
        mistakes=_listed(misread(points), points),
    ).without_duplicates()


@problem("10.5", "Project: the screws", points=2, lecture="10_one_robot_four_ways#The project")
def screws_of_the_project(sampler: ArmSampler) -> Problem:
    project, right = open_project(sampler.student), draw_machine(sampler.student)
    pitches = np.array([np.inf if letter == "P" else 0.0 for letter in project.joints])
    S = joint_screws(right.chain.lines.axis, right.points, pitches)
    S = S.mistaken_for(
        ("body screws", "give the body screws", right.chain.body_screws, "The screws in {s} are wanted.")
    )
    return Problem(
        statement=f"{_begin(project)}Give the screw axes in {{s}}, one in each row, from the same sheet. The arrow at an axis is its "
        "positive direction: a ring with a dot points towards you, a ring with a cross away from you.",
        further="Check one screw by the velocity of a point. Which point do you take?",
        figure=lambda: project.drawing("screws"),
        answer=ScrewsAnswer(S),
    )


@problem("10.6", "Project: the table", points=3, lecture="10_one_robot_four_ways#The project")
def table_of_the_project(sampler: ArmSampler) -> Problem:
    project, table = open_project(sampler.student), draw_machine(sampler.student).table
    return Problem(
        statement=f"{_begin(project)}Sheet 2 of the drawing shows frames 0 to {table.n} of the controller, in the standard convention: "
        "the origin of frame i is Di, z_i is the axis of joint i + 1, and the arrow is x_i; "
        f"z_{table.n} is parallel to "
        f"z_{table.n - 1}. Give the {table.n} rows a, alpha, d, theta at home, in metres and radians.",
        method=rows_from_frames(table),
        further="Which entry would you change if the controller counted joint 2 in the other direction?",
        figure=lambda: project.drawing("table"),
        answer=DHRowsAnswer(table.rows),
        mistakes=drawn_table_mistakes(table),
    ).without_duplicates()


@problem("10.7", "Project: the file", points=3, lecture="10_one_robot_four_ways#The project")
def origins_of_the_file(sampler: ArmSampler) -> Problem:
    project, frames = open_project(sampler.student), draw_machine(sampler.student).file_frames
    origins = inverted(frames[:-1]) @ frames[1:]
    return Problem(
        statement=f"{_begin(project)}Sheet 3 of the drawing shows the frames of the file: the frame of joint i has its origin at Fi, its "
        "z along the axis of the joint, and its x along the arrow. The base is {s}, and the last frame is that of the tool at T, with the "
        "arrows xT and zT. Give the origins of the joints and of the tool, each as a pose in the frame before it, in metres: an array of "
        f"shape ({len(project.joints) + 1}, 4, 4).",
        method="With the frames as poses in {s}, the origin of joint $i$ is $T_{i-1}^{-1}\\,T_i$. Their origins: "
        + ", ".join(f"${vector(p)}$" for p in frames[1:, :3, 3])
        + ".",
        further="Which numbers of the file say nothing about the motion?",
        figure=lambda: project.drawing("URDF"),
        answer=OriginsAnswer(origins),
        mistakes=_listed(misread_origins(origins), origins),
    ).without_duplicates()


@problem("10.8", "Project: the wrong joint", points=1, lecture="10_one_robot_four_ways#The report")
def wrong_joint(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, names = project.received, {str(i): f"joint {i}" for i in range(1, len(project.joints) + 1)}
    own = draw_machine(sampler.student).chain.body_screws
    off = np.abs(received - own).max(axis=1)
    right = str(1 + off.argmax())
    agrees = "The body screw of this joint is that of your own screws: $B_i = \\mathrm{Ad}_{M^{-1}} S_i$."
    problem = Problem(
        statement=f"{_begin(project)}You received its body screws\n\n$$B = {matrix(received)},$$\n\none row for each joint. Exactly one "
        "is wrong. Which one, and how large is the largest difference between an entry of it and the right one? Answer with the number of "
        "the joint and the difference, such as `('1', 0.5)`.",
        method=f"$B_i = \\mathrm{{Ad}}_{{M^{{-1}}}} S_i$, with your own screws and $M$. Joint {right} must have "
        f"${vector(own[int(right) - 1])}$; all others agree.",
        further="Which log would not have shown this error?",
        given={"body_screws": received},
        answer=Choice(right, names),
        mistakes=[Mistake(k, k, f"You answered {name}. {agrees}") for k, name in names.items() if k != right],
    )
    return problem.with_reason(Numbers(np.array(off.max())), "the difference")


@problem("10.9", "Project: how far off", points=2, lecture="10_one_robot_four_ways#The report")
def how_far_off(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, log, right = project.received, project.log, draw_machine(sampler.student).chain
    wrong = Chain(received @ adjoint(right.home).T, right.home)
    fk = wrong.fk(log.q)
    gaps, off = log.distances_mm(fk), 1000 * np.abs(fk[:, :3, 3] - log.poses[:, :3, 3])
    worst = int(gaps.argmax())
    in_space = log.distances_mm(Chain(received, right.home).fk(log.q))
    of_degrees = log.distances_mm(wrong.fk(np.where(np.array(list(project.joints)) == "P", 1.0, np.pi / 180) * log.q))
    mistakes = {
        "mean": (gaps.mean(), "This is the mean of the distances. The question is about the largest one."),
        "degrees": (log.angles_deg(fk).max(), "This is the largest angle in degrees by which the tool is rotated."),
        "largest component": (
            off.max(),
            "This is the largest difference along x, y or z alone. The distance is the length of the difference.",
        ),
        "own screws": (
            log.distances_mm(right.fk(log.q)).max(),
            "This is what your own screws give. The question is about the received ones.",
        ),
        "body screws": (in_space.max(), "This uses the body screws as space screws, with $M$ last."),
        "radians as degrees": (of_degrees.max(), "This takes the angles of the log as degrees. They are in radians."),
    }
    return Problem(
        statement=f"{_begin(project)}With the received body screws and your own home pose, how far is the tool at worst from where the "
        "tracker measured it? The origin of the home pose is T, and the arrows xT and zT are two of its axes. `given.q` has the joint "
        "values of the log, one row for each pose in `given.poses`. Answer in millimetres, with two decimals.",
        method=f"$T(q) = M\\,e^{{[B_1]q_1}} \\cdots e^{{[B_{right.n}]q_{right.n}}}$ for each row of the log. The distance is largest at "
        f"pose {worst + 1}, where it puts the tool at ${vector(fk[worst, :3, 3])}$ and the tracker measured "
        f"${vector(log.poses[worst, :3, 3])}$.",
        further="What is special about the joint values at the pose with the largest distance?",
        figure=lambda: project.drawing("screws"),
        given={"body_screws": received, "q": log.q, "poses": log.poses},
        answer=Numbers(np.array(float(gaps.max())), unit="mm"),
        mistakes=[Mistake(name, np.array(float(value)), text) for name, (value, text) in mistakes.items()],
    ).without_duplicates()


@problem("10.10", "Project: the pen", points=2, lecture="10_one_robot_four_ways#The pen", level="Hard")
def which_path_writes(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    paths, chain = project.paths, draw_machine(sampler.student).chain
    effects = {name: effect_of(chain, path) for name, path in paths.items()}
    (right,) = (name for name, effect in effects.items() if effect == "writes")
    table = next(iter(paths.values())).table_m
    what = {
        "hits": "the pen goes below the table",
        "leaves": "a joint leaves its limits",
        "hovers": "the pen stays above the table",
        "writes": "the pen stays on the table, and each joint within its limits",
    }
    problem = Problem(
        statement=f"{_begin(project)}The table is the plane $z = {table:.4f}$ m of {{s}}, and the pen is the origin of the tool. `given` "
        "has four joint paths A, B, C and D, a configuration in each row, and the limits of the joints. Exactly one path keeps the pen "
        "on the table, to a millimetre, within the limits. Which one, and where in {s} does its line end? Answer with its name and the "
        "point, such as `('A', [0.1, 0.2, 0])`.",
        method="The forward kinematics of every row, and its joint values, show it. "
        + " ".join(f"Path {name}: {what[effect]}." for name, effect in effects.items()),
        further="Which joint limits the path, and how would you move the paper?",
        given={**{name: path.q for name, path in paths.items()}, "limits": project.limits, "table": table},
        answer=Choice(right, {name: f"path {name}" for name in paths}),
        mistakes=[
            Mistake(effect, name, f"You answered {name}. On this path {what[effect]}.")
            for name, effect in effects.items()
            if effect != "writes"
        ],
    )
    return problem.with_reason(Numbers(chain.fk(paths[right].q[-1])[:3, 3], unit="m"), "the point")


@problem("10.11", "An offset from a log", points=3, lecture="10_one_robot_four_ways#Do they agree?", level="Hard")
def offset_from_a_log(sampler: ArmSampler) -> Problem:
    robot, joint = sampler.arm("RRRR"), sampler.integer(1, 4)
    offset = np.radians(sampler.choice((-1, 1)) * sampler.integer(8, 30) / 10)
    q = np.array([[sampler.integer(-12, 12) / 10 for _ in range(4)] for _ in range(5)])
    poses = robot.fk(q + offset * np.eye(4)[joint - 1])
    names = {str(i): f"joint {i}" for i in (1, 2, 3, 4)}
    no_fit = "No single offset of this joint explains all poses of the log."
    problem = Problem(
        statement="The zero of one joint of an arm is off: the joint value is larger than its encoder says by a constant offset. You "
        "have a log of encoder values in radians, a row of `q` for each pose in `poses`, and the screw axes and the home pose of the arm, "
        "which are right. Which joint is it, and what is the offset in radians? Answer with the number of the joint and the offset, such "
        "as `('1', 0.0213)`. A negative offset means that the joint value is smaller.",
        method="$T_k$ is the measured pose of row $k$, and $T(q_k)$ the computed one. An offset $\\delta$ of joint $j$ leaves "
        "$\\log(T_k\\,T(q_k)^{-1}) = \\delta\\,\\mathrm{Ad}_P S_j$, with $P = e^{[S_1]q_1} \\cdots e^{[S_{j-1}]q_{j-1}}$. "
        f"Only for joint {joint} is the left side such a multiple in every row, and each time by the same number:",
        further="Two joints with parallel axes both have an offset. Which of the two could you still find?",
        given={"screws": robot.screws, "home": robot.home, "q": q, "poses": poses},
        answer=Choice(str(joint), names),
        mistakes=[Mistake(name, k, f"You answered {name}. {no_fit}") for k, name in names.items() if k != str(joint)],
    )
    return problem.with_reason(Angles(np.array(offset)), "the offset")


def _format_table(table: DHTable) -> str:
    """Write a table of revolute joints in Markdown, with its lengths in metres and angles in degrees."""
    rows = format_rows(table, length=number, angle=degrees, variable="$q_{}$".format)
    return markdown_table(rows, ["row", "$a$ (m)", "$\\alpha$", "$d$ (m)", "$\\theta$"])


@problem(
    "10.12",
    "A problem of your own",
    points=3,
    lecture="10_one_robot_four_ways#What changes when a frame moves",
    level="Open",
)
def your_own_problem(_: ArmSampler) -> Problem:
    return Problem(
        statement="Write a problem about your machine that belongs on this sheet. Give its right answer, and a wrong answer that a good "
        "student might give. Then write the card for this wrong answer in one or two sentences: it names the idea that went "
        "wrong, and not the number. How do you know that no other mistake leads to the same wrong answer?",
        answer=Prose(
            "For example: give the body screw of joint 2 after the tool is lengthened by $l$ along its $z$. Right is "
            "$\\mathrm{Ad}_{T^{-1}} B_2$; a good student multiplies by $\\mathrm{Ad}_{T}$. Card: “You moved the tool the other way. "
            "The new frame is farther out, so the joint is farther behind it.” A wrong sign of $l$ gives the same numbers, and the "
            "card is true of it as well; the transposed adjoint gives others.",
            {
                "a problem with a right answer, about the own machine": 1,
                "a wrong answer that is likely, with its numbers": 1,
                "a card that is true and names the idea, and a comparison with other mistakes": 1,
            },
        ),
    )
