"""Which rows of a wrong DH table can stay as they are, although the table of an arm is not unique.

Which rows count as right is decided in `dh_table`; rows as an answer, number by number, are in `dh_row`; what share of the points
right parts earn is in `misstep.judge`.
"""

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from kincourse.sampling.drawn_machines import table_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import inverse
from misstep.answers.base import TOLERANCE

POSE_TOLERANCE_FACTOR = 3
"""How many times the tolerance of one entry a pose may be off: the rounding errors of the rows add up along the arm."""

TURNS = (np.eye(4), np.diag([-1.0, -1, 1, 1]), np.diag([1.0, -1, -1, 1]), np.diag([-1.0, 1, -1, 1]))
"""A frame on an axis may have x, z or both reversed."""


@lru_cache(maxsize=16)
def wrong_rows(given: DHTable, right: DHTable) -> tuple[int, ...]:
    """The rows, counted from 0, that must be changed, as few as possible, to give a table the poses of the right one.

    The rows are walked from frame to frame. A row can stay if its joint moves about the axis of the arm, and if it leads to a
    frame on the next axis. After a row that cannot, the walk goes on from our frame there. In the modified convention a row
    ends on the axis of its joint, so these are walked from the tool to the base.
    """
    arm, frames, is_standard = right.to_chain(), table_frames(right), right.convention == "standard"
    order = range(right.n) if is_standard else range(right.n)[::-1]
    links = given.link_transforms(np.zeros(right.n))
    start, goal = given.base, frames[-1] @ right.tool @ inverse(given.tool)
    if not is_standard:
        start, goal, links = goal, start, inverse(links)
    reached: list[tuple[Array, tuple[int, ...]]] = [(start, ())]
    for i, following in zip(order, [*order[1:], None], strict=True):
        steps = [(T, T @ links[i], wrong) for T, wrong in reached]
        kept = [
            (end, wrong)
            for T, end, wrong in steps
            if given.signs[i] * T[:3, 2] @ arm.lines.axis[i] > 1 - TOLERANCE
            and (_is_same(end, goal) if following is None else _is_on_axis(end, arm, following))
        ]
        T, end, fewest = min(steps, key=lambda step: len(step[2]))
        ours = [goal] if following is None else _legal_frames(frames[i + is_standard], T, end)
        reached = kept + [(frame, (*fewest, i)) for frame in ours]
    return min((wrong for _, wrong in reached), key=len)


def _legal_frames(ours: Array, start: Array, end: Array) -> Iterator[Array]:
    """Our frame on an axis, with x and z in either direction; on a parallel axis its origin may also be where the student's is."""
    moved = ours.copy()
    if np.linalg.norm(np.cross(start[:3, 2], ours[:3, 2])) <= TOLERANCE:
        moved[:3, 3] += ours[:3, 2] * (ours[:3, 2] @ (end - ours)[:3, 3])
    return (T @ turn for T in (ours, moved) for turn in TURNS)


def _is_on_axis(T: Array, arm: Chain, joint: int) -> bool:
    axis, off = arm.lines.axis[joint], T[:3, 3] - arm.joint_points[joint]
    distance = 0.0 if arm.joint_types[joint] == "P" else np.linalg.norm(np.cross(off, axis))
    bound = POSE_TOLERANCE_FACTOR * TOLERANCE
    return bool(np.linalg.norm(np.cross(T[:3, 2], axis)) <= bound and distance <= bound)


def _is_same(T: Array, other: Array) -> bool:
    return bool(np.abs(T - other).max() <= POSE_TOLERANCE_FACTOR * TOLERANCE)
