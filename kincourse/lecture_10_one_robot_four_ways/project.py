"""The project of lecture 10: the drawings of a machine, a log, a received description with a fault, and joint paths.

The student writes three descriptions, each from a drawing of its own with its own marks. `verify` holds them against each other
and against the log; the sheet judges their numbers.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import JointPath, draw_paths
from kincourse.sampling.drawn_machines import draw_table_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import adjoint, inverse, log
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from kinlib.urdf.chains import load_urdf
from kinlib.view.drawing.picture import Picture
from misstep.sampling import Sampler

LOG_LINES = 14
"""How many poses the tracker has measured."""

POSITION_MM, ANGLE_DEG = 2.5, 0.5
"""What rounding and the tracker may do to a position and to an orientation; more than that is a fault."""


@dataclass(frozen=True, eq=False)
class Log:
    """Measured poses of the tool at given joint values.

    q      (m, n) in radians and metres
    poses  (m, 4, 4) in {s}
    """

    q: Array
    poses: Array

    def __str__(self) -> str:
        """Write the log as the tracker prints it: joint values in radians and metres, x, y, z in mm, roll, pitch, yaw in degrees."""
        heads = [*(f"q{i}" for i in range(1, self.q.shape[1] + 1)), "x", "y", "z", "roll", "pitch", "yaw"]
        lines = ["".join(f"{head:>8}" for head in heads)]
        for q, T in zip(self.q, self.poses, strict=True):
            angles = np.degrees(roll_pitch_yaw(T[:3, :3]))
            cells = [f"{x:8.3f}" for x in q] + [f"{x:8.0f}" for x in 1000 * T[:3, 3]] + [f"{x:8.1f}" for x in angles]
            lines.append("".join(cells))
        return "\n".join(lines)

    def distances_mm(self, poses: Array) -> Array:
        """Return how far the tool is from where it was measured, in millimetres, (m,)."""
        gaps: Array = 1000 * np.linalg.norm(poses[:, :3, 3] - self.poses[:, :3, 3], axis=-1)
        return gaps

    def angles_deg(self, poses: Array) -> Array:
        """Return by which angle the tool is rotated against how it was measured, in degrees, (m,)."""
        angles: Array = np.degrees(np.linalg.norm(log(inverse(poses[:, :3, :3]) @ self.poses[:, :3, :3]), axis=-1))
        return angles


class Project:
    """One student's project. Make one with `open_project`."""

    def __init__(self, student: str) -> None:
        self._student, self._machine = student, draw_machine(student)

    @property
    def name(self) -> str:
        """The kind of machine."""
        return self._machine.name

    @property
    def joints(self) -> str:
        """The joints from base to tool, R or P each."""
        return self._machine.table.joints

    @property
    def limits(self) -> Array:
        """The joint limits, (n, 2), in radians and metres."""
        return self._machine.limits

    def drawing(self, description: str) -> Picture:
        """Return the sheet of the drawing for a description: "screws", "table" or "URDF".

        Raises ValueError for another name.
        """
        machine, home = self._machine, self._machine.chain.home
        if description not in ("screws", "table", "URDF"):
            raise ValueError(f"description must be 'screws', 'table' or 'URDF'; got {description!r}.")
        if description == "table":
            return draw_table_frames(machine.table)
        tool_arrows = {f"{letter}T": (home[:3, 3], home[:3, k].round()) for k, letter in ((0, "x"), (2, "z"))}
        if description == "screws":
            marks, arrows = {f"P{i}": p for i, p in enumerate(machine.points, start=1)}, tool_arrows
        else:
            marks = {f"F{i}": seat[:3, 3] for i, seat in enumerate(machine.seats, start=1)}
            seats = enumerate(machine.seats, start=1)
            arrows = {f"x{i}": (seat[:3, 3], seat[:3, 0].round()) for i, seat in seats} | tool_arrows
        axes = [
            DrawnAxis(str(i), frame[:3, 2].round(), frame[:3, 3], letter == "P")
            for i, (frame, letter) in enumerate(zip(machine.frames, self.joints, strict=False), start=1)
        ]
        return draw_dimensions(machine.frames[:, :3, 3], axes, {**marks, "T": home[:3, 3]}, arrows=arrows)

    @cached_property
    def log(self) -> Log:
        """What the tracker has measured: joint values within the limits, and the poses of the tool to a millimetre."""
        sampler = Sampler(self._student, "10.log")
        low, high = self.limits.T
        shares = np.array([[sampler.integer(2, 98) / 100 for _ in low] for _ in range(LOG_LINES)])
        q = np.round(low + shares * (high - low), 3)
        poses = self._machine.chain.fk(q)
        noise = np.array([[(sampler.integer(-40, 40)) / 100 for _ in range(3)] for _ in q])
        xyz = np.round(1000 * poses[:, :3, 3] + noise) / 1000
        rpy = np.degrees([roll_pitch_yaw(T[:3, :3]) for T in poses]).round(1)
        return Log(q, np.array([origin(p, np.radians(angles)) for p, angles in zip(xyz, rpy, strict=True)]))

    @cached_property
    def received(self) -> Array:
        """The body screws (n, 6) by somebody else: one is wrong, by a length or by the sign of its direction."""
        sampler = Sampler(self._student, "10.received")
        joint, chain = sampler.integer(1, self._machine.n), self._machine.chain
        B = chain.body_screws.copy()
        if self.joints[joint - 1] == "P" or sampler.choice((True, False)):
            B[joint - 1] *= -1
        else:
            omega = B[joint - 1, :3]
            across = np.eye(3)[sampler.choice([k for k in range(3) if abs(omega[k]) < 0.5])]
            B[joint - 1, 3:] -= np.cross(omega, sampler.choice((-1, 1)) * sampler.choice((0.02, 0.03, 0.05)) * across)
        return B.round(6) + 0.0

    @cached_property
    def paths(self) -> dict[str, JointPath]:
        """Four joint paths by name, A to D, as the student gets them."""
        return draw_paths(self._machine.chain, self.limits, Sampler(self._student, "10.paths"))

    def verify(self, *, screws: Any = None, table: Any = None, urdf: Any = None, received: Any = None) -> str:
        """Hold descriptions against each other and against the log; return a table of the largest differences as text.

        screws    the space screws (n, 6) and the home pose
        table     a DHTable with base and tool
        urdf      the text of a URDF file
        received  body screws (n, 6) and a home pose

        A description that is None, or contains `...`, is not written yet and left out.

        Raises ValueError if one has another number of joints, or is no description of its kind.
        """
        given = {"screws": screws, "table": table, "URDF": urdf, "body screws": received}
        chains = {name: READERS[name](one) for name, one in given.items() if is_written(one)}
        if not chains:
            return "There is nothing to verify yet: write a description in place of `...`."
        for name, chain in chains.items():
            if chain.n != self._machine.n:
                raise ValueError(f"The {name} must have {self._machine.n} joints, {self.joints}; got {chain.n}.")
        poses = {name: chain.fk(self.log.q) for name, chain in chains.items()}
        rows = ["".join(f"{head:>14}" for head in ("", *poses, "the log"))]
        for name, one in poses.items():
            cells = []
            for others in (*poses.values(), self.log.poses):
                other = Log(self.log.q, others)
                far, turned = other.distances_mm(one).max(), other.angles_deg(one).max()
                is_same = far <= POSITION_MM and turned <= ANGLE_DEG
                cells.append("agrees" if is_same else f"{far:.0f} mm, {turned:.0f}°")
            rows.append(f"{name:<14}" + "".join(f"{cell:>14}" for cell in cells))
        return "\n".join(rows)


READERS: dict[str, Callable[[Any], Chain]] = {
    "screws": lambda given: Chain(*given),
    "table": DHTable.to_chain,
    "URDF": load_urdf,
    "body screws": lambda given: Chain(np.asarray(given[0]) @ adjoint(given[1]).T, given[1]),
}
"""How each description becomes a chain."""


def open_project(student: str) -> Project:
    """Open the project of a student; the same id always gives the same one.

    Raises ValueError for an empty id.
    """
    if not student.strip():
        raise ValueError("student must be your id, such as 'ada'; got an empty text.")
    return Project(student)


def is_written(description: Any) -> bool:
    """Whether a student has written a description, so that it is not None, and neither is nor contains `...`."""
    parts = description if isinstance(description, tuple) else (description,)
    return not any(part is None or part is ... for part in parts)
