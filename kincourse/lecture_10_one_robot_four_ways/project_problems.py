"""The graded part of the project: three descriptions from three drawings, the report on a received one, and the paths.

All of them are about the machine of the student's project, so nothing here is drawn again. Each description has marks of its
own, so one that is computed from another has other numbers.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np

from kincourse.answers.dh_row import DHEntriesAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.screws import joint_screws
from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import effect_of
from kincourse.lecture_10_one_robot_four_ways.project import Project, open_project
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import misread
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.parsing import COLUMNS
from kinlib.rigid.lie import adjoint, inverse
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import matrix
from misstep.mistakes import Mistake, mistake
from misstep.problem import Problem

LECTURE = "10_one_robot_four_ways#"


@dataclass(frozen=True, eq=False)
class OriginsAnswer(Numbers):
    """Poses of frames, each in the frame before it, (k, 4, 4), as the origins of a URDF file; each pose is a part.

    >>> OriginsAnswer(np.array([np.eye(4)] * 2)).parts
    ['the origin of joint 1', 'the origin of the tool']
    """

    noun: ClassVar[str] = "the origins of the joints and of the tool, an array"

    @property
    def parts(self) -> Sequence[str]:
        return [*(f"the origin of joint {i}" for i in range(1, len(self.value))), "the origin of the tool"]

    def part_indices(self) -> list[int]:
        return list(range(len(self.value)))


def misread_origins(T: Array) -> Iterator[tuple[str, Array, str]]:
    """Yield how people get the origins (k, 4, 4) of a drawn file wrong: the name, the wrong poses, and what is true of them."""
    transposed, straight = T.copy(), T.copy()
    transposed[:, :3, :3] = T[:, :3, :3].swapaxes(1, 2)
    straight[:, :3, :3] = np.eye(3)
    in_base = np.array(list(accumulate(T, np.matmul)))
    yield "inverse", inverse(T), "Every pose is the inverse: the parent seen from the child."
    yield "R^T", transposed, "In every origin, the rotation is the transpose of the right one."
    yield "no rpy", straight, "Every xyz is right, and every rpy is left at 0."
    yield "in the base", in_base, "Every pose is in the frame of the base. An origin is in the frame of the parent."


def _listed(wrong: Iterator[tuple[str, Any, str]]) -> list[Mistake]:
    # By these methods what is nearest to the base comes out right too.
    nearest = {"in the base", "steps not added"}
    return [mistake(name, value, text, spoils=name in nearest) for name, value, text in wrong]


def _begin(project: Project) -> str:
    kinds = {"R": "revolute", "P": "prismatic"}
    joints = ", ".join(f"{i} {kinds[letter]}" for i, letter in enumerate(project.joints, start=1))
    return f"Your machine is the {project.name} of your project. Its joints are {joints}. "


@problem("10.8", "Project: the marks of the axes", points=2, lecture=f"{LECTURE}The project")
def marks_of_the_axes(sampler: ArmSampler) -> Problem:
    project, right = open_project(sampler.student), draw_machine(sampler.student)
    points = np.array([*right.points, right.chain.home[:3, 3]])
    names = [*(f"P{i}" for i in range(1, len(points))), "T"]
    return Problem(
        statement=f"{_begin(project)}Read the points P1 to P{len(points) - 1} and T off sheet 1 of the drawing: their coordinates in "
        "{s}, in metres, one point in each row.",
        figure=lambda: project.drawing("screws"),
        answer=VectorsAnswer(points, unit="m", names=names),
        mistakes=_listed(misread(points)),
    ).without_duplicates()


@problem("10.9", "Project: the screws", points=2, lecture=f"{LECTURE}The project")
def screws_of_the_project(sampler: ArmSampler) -> Problem:
    project, right = open_project(sampler.student), draw_machine(sampler.student)
    pitches = np.array([np.inf if letter == "P" else 0.0 for letter in project.joints])
    S = joint_screws(right.chain.lines.axis, right.points, pitches)
    return Problem(
        statement=f"{_begin(project)}Give the screw axes in {{s}}, one in each row, from the same sheet. The arrow at an axis is its "
        "positive direction: a ring with a dot points towards you, a ring with a cross away from you.",
        figure=lambda: project.drawing("screws"),
        answer=ScrewsAnswer(S.value),
        solution=S,
        invisible={"another point"},
    )


@problem("10.10", "Project: the table", points=3, lecture=f"{LECTURE}The project")
def table_of_the_project(sampler: ArmSampler) -> Problem:
    project, table = open_project(sampler.student), draw_machine(sampler.student).table
    rows, names = table.rows, [f"{column}_{i}" for i in range(1, table.n + 1) for column in COLUMNS]
    modified = table.converted("modified").rows

    def wrong_rows() -> Iterator[tuple[str, Array, str]]:
        yield (
            "the other convention",
            modified,
            "These are the rows of the modified convention, with a and alpha of the link before.",
        )
        yield (
            "every alpha",
            rows * (1, -1, 1, 1),
            "Every alpha has the wrong sign. It leads from one z to the next, about x.",
        )
        yield (
            "every theta",
            rows * (1, 1, 1, -1),
            "Every theta has the wrong sign. It leads from one x to the next, about z.",
        )
        yield (
            "alpha and theta swapped",
            rows[:, [0, 3, 2, 1]],
            "alpha and theta are swapped: alpha is about x, theta about z.",
        )
        yield "a and d swapped", rows[:, [2, 1, 0, 3]], "a and d are swapped: a is along x, d along z."
        yield (
            "no theta",
            rows * (1, 1, 1, 0),
            "Every theta is 0. Theta is the angle from one x axis to the next, at home.",
        )

    return Problem(
        statement=f"{_begin(project)}Sheet 2 of the drawing shows frames 0 to {table.n} of the controller, in the standard convention: "
        "the origin of frame i is Di, z_i is the axis of joint i + 1, and the arrow is x_i; z_{table.n} is parallel to "
        f"z_{table.n - 1}. Give the rows a, alpha, d, theta at home one after the other: {rows.size} numbers, in metres and radians.",
        figure=lambda: project.drawing("table"),
        answer=DHEntriesAnswer(rows.ravel(), names=names),
        mistakes=[mistake(name, value.ravel(), text) for name, value, text in wrong_rows()],
    ).without_duplicates()


@problem("10.11", "Project: the file", points=3, lecture=f"{LECTURE}The project")
def origins_of_the_file(sampler: ArmSampler) -> Problem:
    project, frames = open_project(sampler.student), draw_machine(sampler.student).file_frames
    origins = inverse(frames[:-1]) @ frames[1:]
    return Problem(
        statement=f"{_begin(project)}Sheet 3 of the drawing shows the frames of the file: the frame of joint i has its origin at Fi, its "
        "z along the axis of the joint, and its x along the arrow. The base is {s}, and the last frame is that of the tool at T, with the "
        "arrows xT and zT. Give the origins of the joints and of the tool, each as a pose in the frame before it: an array of shape "
        f"({len(project.joints) + 1}, 4, 4).",
        figure=lambda: project.drawing("URDF"),
        answer=OriginsAnswer(origins),
        mistakes=_listed(misread_origins(origins)),
    ).without_duplicates()


@problem("10.12", "Project: the wrong joint", points=1, lecture=f"{LECTURE}The report")
def wrong_joint(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, names = project.received, {str(i): f"joint {i}" for i in range(1, len(project.joints) + 1)}
    right = str(1 + np.abs(received.body_screws - draw_machine(sampler.student).chain.body_screws).max(axis=1).argmax())
    return Problem(
        statement=f"{_begin(project)}You received its home pose, which is right, and its body screws\n\n"
        f"$$B = {matrix(received.body_screws)},$$\n\none row for each joint. Exactly one is wrong. Which one? Answer with its number, "
        "as a text.",
        given={"body_screws": received.body_screws, "home": received.home},
        answer=Choice(right, names),
        mistakes=[
            mistake(
                number,
                number,
                f"You answered {name}. The body screw of this joint is that of your own screws: $B_i = \\mathrm{{Ad}}_{{M^{{-1}}}} S_i$.",
            )
            for number, name in names.items()
            if number != right
        ],
    )


@problem("10.13", "Project: how far off", points=2, lecture=f"{LECTURE}The report")
def how_far_off(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, log = project.received, project.log
    wrong = Chain(received.body_screws @ adjoint(received.home).T, received.home)
    gaps = log.distances_mm(wrong.fk(log.q))
    turned = np.degrees(
        np.arccos(np.clip((np.einsum("kij,kij->k", wrong.fk(log.q)[:, :3, :3], log.poses[:, :3, :3]) - 1) / 2, -1, 1))
    )
    worst = float(gaps.max())
    return Problem(
        statement=f"{_begin(project)}With the received body screws, how far is the tool at worst from where the tracker measured it? "
        "`given.q` has the joint values of the log, one row for each pose in `given.poses`. Answer in millimetres.",
        given={"body_screws": received.body_screws, "home": received.home, "q": log.q, "poses": log.poses},
        answer=Numbers(np.array(worst), unit="mm"),
        mistakes=[
            mistake(
                "mean",
                np.array(float(gaps.mean())),
                "This is the mean of the distances. The question is about the largest one.",
            ),
            mistake(
                "first pose",
                np.array(float(gaps[0])),
                "This is the distance at the first pose of the log, and not the largest one.",
            ),
            mistake("least", np.array(float(gaps.min())), "This is the smallest of the distances."),
            mistake(
                "degrees",
                np.array(float(turned.max())),
                "This is the largest angle in degrees by which the tool is rotated.",
            ),
            mistake(
                "largest component",
                np.array(float(1000 * np.abs(wrong.fk(log.q)[:, :3, 3] - log.poses[:, :3, 3]).max())),
                "This is the largest difference along x, y or z alone. The distance is the length of the difference.",
            ),
        ],
    ).without_duplicates()


@problem("10.14", "Project: the pen", points=2, lecture=f"{LECTURE}The pen")
def which_path_writes(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    paths, chain = project.paths, draw_machine(sampler.student).chain
    effects = {name: effect_of(chain, path) for name, path in paths.items()}
    (right,) = (name for name, effect in effects.items() if effect == "writes")
    table = next(iter(paths.values())).table_m
    said = {
        "hits": "On this path the pen goes below the table.",
        "leaves": "On this path a joint leaves its limits.",
        "hovers": "On this path the pen stays above the table, and never touches it.",
    }
    return Problem(
        statement=f"{_begin(project)}The table is the plane $z = {table:.4f}$ m of {{s}}, and the pen is the origin of the tool. `given` "
        "has four joint paths A, B, C and D, a configuration in each row, and the limits of the joints. Exactly one path keeps the pen "
        "on the table, to a millimetre, within the limits. Which one?",
        given={**{name: path.q for name, path in paths.items()}, "limits": project.limits, "table": table},
        answer=Choice(right, {name: f"path {name}" for name in paths}),
        mistakes=[
            mistake(effect, name, f"You answered {name}. {said[effect]}")
            for name, effect in effects.items()
            if effect != "writes"
        ],
    )


PROJECT_PROBLEMS = [
    *(marks_of_the_axes, screws_of_the_project, table_of_the_project, origins_of_the_file),
    *(wrong_joint, how_far_off, which_path_writes),
]
