"""The graded part of the project: three descriptions from three drawings, the report on a received one, and the paths.

All of them are about the machine of the student's project, so nothing here is drawn again. Each description has marks of its
own, so one that is computed from another has other numbers.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np

from kincourse.answers.dh_row import DHRowsAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.screws import joint_screws
from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import effect_of
from kincourse.lecture_10_one_robot_four_ways.project import Project, open_project
from kincourse.mistakes.dh import is_in_several_rows
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import drawn_table_mistakes, misread
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, homogeneous, inverse
from misstep.answers.base import Named
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.diagnosis.explanation import explain
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

    @property
    def rows_are_alike(self) -> bool:
        return True

    def resemblance(self, given: Array, part: int | None) -> Named | None:
        """Return what is to be said of this pose alone."""
        if part is None:
            return super().resemblance(given, None)
        pose = PoseAnswer(self.value[part])
        wrong = [k for k, is_right in enumerate(pose.agrees(given[part], pose.value)) if not is_right]
        found = explain(Problem("", pose), given[part], wrong)
        told = [f"{pose.parts[k].capitalize()}: {one.message}" for one in found for k in one.parts]
        if len(found) == 1 and (found[0].is_whole or len(found[0].parts) > 1):
            told = [found[0].message]
        return (" and ".join(one.mistakes[0].name for one in found), " ".join(told)) if found else None


def misread_origins(T: Array) -> Iterator[tuple[str, Array, str]]:
    """Yield how people get the origins (k, 4, 4) of a drawn file wrong: the name, the wrong poses, and what is true of them."""
    R, p, in_base = T[:, :3, :3], T[:, :3, 3], np.array(list(accumulate(T, np.matmul)))
    transposed, straight = homogeneous(R.swapaxes(1, 2), p), homogeneous(np.eye(3), p)
    moved = homogeneous(R, np.diff(in_base[:, :3, 3], axis=0, prepend=0))
    yield "inverse", inverse(T), "Every pose is the inverse: the parent seen from the child."
    yield "rotation transposed", transposed, "In every origin, the rotation is the transpose of the right one."
    yield "no rpy", straight, "Every xyz is right, and every rpy is left at 0."
    yield (
        "rotation left out",
        moved,
        "Every xyz is in the axes of {s}. It is wanted in those of the frame of the parent.",
    )
    yield "in the base", in_base, "Every pose is in the frame of the base. An origin is in the frame of the parent."


def _listed(wrong: Iterator[tuple[str, Any, str]], right: Array) -> list[Mistake]:
    n = len(right)
    return [
        mistake(name, value, text, spoils=is_in_several_rows(value.reshape(n, -1), right.reshape(n, -1)))
        for name, value, text in wrong
    ]


def _begin(project: Project) -> str:
    kinds = {"R": "revolute", "P": "prismatic"}
    joints = ", ".join(f"{i} {kinds[letter]}" for i, letter in enumerate(project.joints, start=1))
    return f"Your machine is the {project.name} of your project. Its joints are {joints}. "


@problem(
    "10.4",
    "Project: the marks of the axes",
    points=2,
    lecture=f"{LECTURE}The project",
    further="Which mark would you measure again, because an error there does the most harm?",
)
def marks_of_the_axes(sampler: ArmSampler) -> Problem:
    project, right = open_project(sampler.student), draw_machine(sampler.student)
    points = np.array([*right.points, right.chain.home[:3, 3]])
    names = [*(f"P{i}" for i in range(1, len(points))), "T"]
    return Problem(
        statement=f"{_begin(project)}Read the points P1 to P{len(points) - 1} and T off sheet 1 of the drawing: their coordinates in "
        "{s}, in metres, one point in each row.",
        figure=lambda: project.drawing("screws"),
        answer=VectorsAnswer(points, unit="m", names=names),
        mistakes=_listed(misread(points), points),
    ).without_duplicates()


@problem(
    "10.5",
    "Project: the screws",
    points=2,
    lecture=f"{LECTURE}The project",
    further="Check one screw by the velocity of a point. Which point do you take?",
)
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
        figure=lambda: project.drawing("screws"),
        answer=ScrewsAnswer(S.value),
        solution=S,
        invisible={"another point"},
    )


@problem(
    "10.6",
    "Project: the table",
    points=3,
    lecture=f"{LECTURE}The project",
    further="Which entry would you change if the controller counted joint 2 in the other direction?",
)
def table_of_the_project(sampler: ArmSampler) -> Problem:
    project, table = open_project(sampler.student), draw_machine(sampler.student).table
    return Problem(
        statement=f"{_begin(project)}Sheet 2 of the drawing shows frames 0 to {table.n} of the controller, in the standard convention: "
        "the origin of frame i is Di, z_i is the axis of joint i + 1, and the arrow is x_i; "
        f"z_{table.n} is parallel to "
        f"z_{table.n - 1}. Give the {table.n} rows a, alpha, d, theta at home, in metres and radians.",
        figure=lambda: project.drawing("table"),
        answer=DHRowsAnswer(table.rows),
        mistakes=drawn_table_mistakes(table),
    ).without_duplicates()


@problem(
    "10.7",
    "Project: the file",
    points=3,
    lecture=f"{LECTURE}The project",
    further="Which numbers of the file say nothing about the motion?",
)
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
        mistakes=_listed(misread_origins(origins), origins),
    ).without_duplicates()


@problem(
    "10.8",
    "Project: the wrong joint",
    points=1,
    lecture=f"{LECTURE}The report",
    further="Which log would not have shown this error?",
)
def wrong_joint(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, names = project.received, {str(i): f"joint {i}" for i in range(1, len(project.joints) + 1)}
    off = np.abs(received - draw_machine(sampler.student).chain.body_screws).max(axis=1)
    right = str(1 + off.argmax())
    problem = Problem(
        statement=f"{_begin(project)}You received its body screws\n\n$$B = {matrix(received)},$$\n\none row for each joint. Exactly one "
        "is wrong. Which one, and how large is the largest difference between an entry of it and the right one? Answer with the number of "
        "the joint and the difference, such as `('1', 0.5)`.",
        given={"body_screws": received},
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
    return problem.with_reason(Numbers(np.array(off.max())))


@problem(
    "10.9",
    "Project: how far off",
    points=2,
    lecture=f"{LECTURE}The report",
    further="Where is the pen if joint 1 is off by one degree as well?",
)
def how_far_off(sampler: ArmSampler) -> Problem:
    project = open_project(sampler.student)
    received, log, right = project.received, project.log, draw_machine(sampler.student).chain
    wrong = Chain(received @ adjoint(right.home).T, right.home)
    fk = wrong.fk(log.q)
    gaps, off = log.distances_mm(fk), 1000 * np.abs(fk[:, :3, 3] - log.poses[:, :3, 3])
    in_space = log.distances_mm(Chain(received, right.home).fk(log.q))
    of_degrees = log.distances_mm(wrong.fk(np.where(np.array(list(project.joints)) == "P", 1.0, np.pi / 180) * log.q))
    mistakes = {
        "mean": (gaps.mean(), "This is the mean of the distances. The question is about the largest one."),
        "median": (np.median(gaps), "This is the median of the distances. The question is about the largest one."),
        "sum": (gaps.sum(), "This is the sum of all distances. The question is about the largest one."),
        "root mean square": (
            np.sqrt((gaps**2).mean()),
            "This is the root mean square of the distances. The question is about the largest one.",
        ),
        "first pose": (gaps[0], "This is the distance at the first pose of the log, and not the largest one."),
        "last pose": (gaps[-1], "This is the distance at the last pose of the log, and not the largest one."),
        "least": (gaps.min(), "This is the smallest of the distances."),
        "degrees": (log.angles_deg(fk).max(), "This is the largest angle in degrees by which the tool is rotated."),
        "largest component": (
            off.max(),
            "This is the largest difference along x, y or z alone. The distance is the length of the difference.",
        ),
        "components added": (
            off.sum(axis=1).max(),
            "This adds the differences along x, y and z. The distance is the length of the difference.",
        ),
        "root left out": (
            gaps.max() ** 2 / 1000,
            "This is 1000 times the square of the distance in metres. Take its root first.",
        ),
        "own screws": (
            log.distances_mm(right.fk(log.q)).max(),
            "This is what your own screws give. The question is about the received ones.",
        ),
        "body screws": (in_space.max(), "This uses the body screws as space screws, with $M$ last."),
        "from home": (
            log.distances_mm(np.broadcast_to(right.home, fk.shape)).max(),
            "This is the largest distance of a measured pose from the home pose.",
        ),
        "radians as degrees": (of_degrees.max(), "This takes the angles of the log as degrees. They are in radians."),
    }
    return Problem(
        statement=f"{_begin(project)}With the received body screws and your own home pose, how far is the tool at worst from where the "
        "tracker measured it? The origin of the home pose is T, and the arrows xT and zT are two of its axes. `given.q` has the joint "
        "values of the log, one row for each pose in `given.poses`. Answer in millimetres.",
        figure=lambda: project.drawing("screws"),
        given={"body_screws": received, "q": log.q, "poses": log.poses},
        answer=Numbers(np.array(float(gaps.max())), unit="mm"),
        mistakes=[mistake(name, np.array(float(value)), text) for name, (value, text) in mistakes.items()],
    ).without_duplicates()


@problem(
    "10.10",
    "Project: the pen",
    points=2,
    lecture=f"{LECTURE}The pen",
    further="Which joint limits the path, and how would you move the paper?",
    level="Hard",
)
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
    problem = Problem(
        statement=f"{_begin(project)}The table is the plane $z = {table:.4f}$ m of {{s}}, and the pen is the origin of the tool. `given` "
        "has four joint paths A, B, C and D, a configuration in each row, and the limits of the joints. Exactly one path keeps the pen "
        "on the table, to a millimetre, within the limits. Which one, and where in {s} does its line end? Answer with its name and the "
        "point, such as `('A', [0.1, 0.2, 0])`.",
        given={**{name: path.q for name, path in paths.items()}, "limits": project.limits, "table": table},
        answer=Choice(right, {name: f"path {name}" for name in paths}),
        mistakes=[
            mistake(effect, name, f"You answered {name}. {said[effect]}")
            for name, effect in effects.items()
            if effect != "writes"
        ],
    )
    return problem.with_reason(Numbers(chain.fk(paths[right].q[-1])[:3, 3], unit="m"))


PROJECT_PROBLEMS = [
    *(marks_of_the_axes, screws_of_the_project, table_of_the_project, origins_of_the_file),
    *(wrong_joint, how_far_off, which_path_writes),
]
