"""The project of lecture 10: a data sheet, a log, a received description with a fault, and joint paths, for each student.

The student writes three descriptions, each from a drawing of its own with its own marks, so that none of them can be computed
from another one. `verify` holds them against each other, against the log and against the marks.
"""

from collections.abc import Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
from kincourse.lecture_10_one_robot_four_ways.paths import JointPath, draw_paths
from kincourse.lecture_10_one_robot_four_ways.verification import (
    Log,
    Product,
    Verification,
    of_body_screws,
    of_screws,
    of_table,
    of_urdf,
    verify,
)
from kincourse.sampling.drawn_machines import draw_table_frames, table_frames
from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import DHTable
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from kinlib.view.drawing.dimensions import DrawnAxis, draw_dimensions
from kinlib.view.drawing.picture import Picture
from misstep.sampling import Sampler

LOG_LINES = 14
"""How many poses the tracker has measured."""

MARK_M = 2e-3
"""How far a mark may be from where it is in the drawing."""

PRINTED_MM, PRINTED_DEG = 1.0, 0.1
"""To what the tracker rounds positions and angles."""


class Project:
    """One student's project. Make one with `open_project`.

    >>> project = open_project("ada")
    >>> project.log.q.shape, project.log.poses.shape
    ((14, 4), (14, 4, 4))
    >>> project.drawing("table").alt[:40]
    'Top view and front view of a machine, wi'
    """

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
        xyz = np.round((1000 * poses[:, :3, 3] + noise) / PRINTED_MM) * PRINTED_MM / 1000
        rpy = np.round(np.degrees([roll_pitch_yaw(T[:3, :3]) for T in poses]) / PRINTED_DEG) * PRINTED_DEG
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

    def verify(
        self,
        *,
        screws: tuple[ArrayLike, ArrayLike, ArrayLike] | None = None,
        table: DHTable | None = None,
        urdf: str | None = None,
        received: tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Verification:
        """Hold descriptions against each other, against the log and against the marks of the drawings.

        screws    the space screws (n, 6), the home pose, and the points (n, 3) on the axes that are marked in the drawing
        table     a standard table with base and tool
        urdf      the text of a URDF file
        received  body screws (n, 6) and a home pose

        A description that is None, or contains `...`, is not written yet and left out.

        Raises ValueError if one has another number of joints, or is no description of its kind.
        """
        products, off = [], {}
        if is_written(screws):
            S, M, points = (validation.array(value, name) for value, name in zip(screws, ("S", "M", "P"), strict=True))
            products.append(of_screws(S, M))
            off["screws"] = self._off_mark_of_points(points)
        if is_written(table):
            products.append(of_table(table))
            off["table"] = self._off_mark_of_table(table) if table.n == self._machine.n else ""
        if is_written(urdf):
            products.append(of_urdf(urdf))
            off["URDF"] = self._off_mark_of_urdf(products[-1]) if products[-1].n == self._machine.n else ""
        if is_written(received):
            products.append(of_body_screws(*received))
        for product in products:
            if product.n != self._machine.n:
                raise ValueError(
                    f"The {product.name} must have {self._machine.n} joints, {self.joints}; got {product.n}."
                )
        return verify(products, self.log, {name: place for name, place in off.items() if place})

    def _off_mark_of_points(self, points: Array) -> str:
        if points.shape != self._machine.points.shape:
            raise ValueError(
                f"P must have shape {self._machine.points.shape}, one point for each joint; got {points.shape}."
            )
        return _first_off(points, self._machine.points, [f"joint {i}" for i in range(1, len(points) + 1)])

    def _off_mark_of_table(self, table: DHTable) -> str:
        names = ["the base", *(f"row {i}" for i in range(1, table.n + 1))]
        off = _first_off(table_frames(table), self._machine.frames, names)
        return off or ("the tool" if not np.allclose(table.tool, self._machine.table.tool, atol=MARK_M) else "")

    def _off_mark_of_urdf(self, file: Product) -> str:
        *seats, tool = accumulate(file.constants, np.matmul)
        axes = file.screws[:, :3] + file.screws[:, 3:]  # one of the halves is 0
        for i, (own, axis, seat) in enumerate(zip(seats, axes, self._machine.seats, strict=True), start=1):
            if np.abs(own - seat).max() > MARK_M or np.abs(axis - (0, 0, 1)).max() > MARK_M:
                return f"joint {i}"
        return "the tool" if np.abs(tool - self._machine.chain.home).max() > MARK_M else ""


def open_project(student: str) -> Project:
    """Open the project of a student; the same id always gives the same one.

    Raises ValueError for an empty id.
    """
    if not student.strip():
        raise ValueError("student must be your id, such as 'ada'; got an empty text.")
    return Project(student)


def is_written(description: Any) -> TypeGuard[Any]:
    """Whether a student has written a description, so that it is not None, and neither is nor contains `...`."""
    parts = description if isinstance(description, tuple) else (description,)
    return not any(part is None or part is ... for part in parts)


def _first_off(own: Array, drawn: Array, names: Sequence[str]) -> str:
    far = (name for name, one, other in zip(names, own, drawn, strict=True) if np.abs(one - other).max() > MARK_M)
    return next(far, "")
