"""What a drawing of a frame assignment shows after each step, and what that step names. Figures and the player use it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.validation import Array
from kinlib.dh.assignment import FrameAssignment

MAX_DISTANCE_IN_ARM_SIZES = 4.0
"""Frames and normals farther from the arm than this are left out, as those of nearly parallel axes can be."""

FINISHED = ("accuracy", None)
"""The kind and frame of the finished assignment, in which nothing is highlighted."""


@dataclass(frozen=True)
class AssignmentState:
    """An assignment after some of its steps: what the current step names is strong, what came before is pale.

    kind     the kind of the current step, as in kinlib.dh.assignment_steps
    axes     (n,) whether the axis of each joint is strong
    normals  (n - 1,) whether each common normal is strong; None if it is not drawn yet
    frames   (n + 1,) which of O, z, x, y of each frame have been assigned
    strong   (n + 1,) whether the current step is about each frame
    row      the row that is read off, counted from 1; None if the step reads no row
    """

    kind: str
    axes: tuple[bool, ...]
    normals: tuple[bool | None, ...]
    frames: tuple[str, ...]
    strong: tuple[bool, ...]
    row: int | None

    def visible_parts(self, i: int) -> str:
        """Return the parts of frame i that are drawn: y only while its frame is strong, because y follows from z and x."""
        return self.frames[i] if self.strong[i] and self.kind != "accuracy" else self.frames[i].replace("y", "")


def state_after(assignment: FrameAssignment, until: int | None = None) -> AssignmentState:
    """Return what is drawn after a step of an assignment, counted from 0, or after all steps if until is None.

    Raises ValueError if until is not the index of a step.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> state_after(assign_frames(youbot(), convention="standard"), 3).frames
    ('Ozxy', 'Oz', '', '', '', '')
    """
    steps, n = assignment.steps, assignment.chain.n
    if until is not None and until not in range(len(steps)):
        raise ValueError(f"until must be the index of a step of this assignment, 0 to {len(steps) - 1}; got {until!r}.")
    last = len(steps) - 1 if until is None else until
    done = {(step.kind, step.frame) for step in steps[: last + 1]}
    kind, frame = current = FINISHED if until is None else (steps[last].kind, steps[last].frame)
    near_by = () if frame is None else (frame - 1, frame)
    return AssignmentState(
        kind,
        axes=tuple(kind in {"axes", "accuracy"} or (kind == "normal" and i in near_by) for i in range(n)),
        normals=tuple(
            current in {("normal", i), ("x", i), FINISHED} if ("normal", i) in done else None for i in range(1, n)
        ),
        frames=tuple(_parts(i, n, done) for i in range(n + 1)),
        strong=tuple(kind == "accuracy" or i == frame or (kind == "row" and i in near_by) for i in range(n + 1)),
        row=frame if kind == "row" else None,
    )


def row_segments(assignment: FrameAssignment, row: int) -> list[tuple[str, Array, Array]]:
    """Return the translations of a row as segments (name, start, end), in the order of its convention.

    row  counted from 1

    The segment of d is along z, that of a along x. A segment of length zero is left out.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> [name for name, *_ in row_segments(assign_frames(youbot(), convention="standard"), 1)]
    ['d_1', 'a_1']
    """
    before, after = assignment.frames[row - 1 : row + 1]
    a, _, d, _ = assignment.table.rows[row - 1]
    standard = assignment.table.convention == "standard"
    corner = before[:3, 3] + (d * before[:3, 2] if standard else a * before[:3, 0])
    names = (f"d_{row}", f"a_{row}") if standard else (f"a_{row - 1}", f"d_{row}")
    segments = zip(names, (before[:3, 3], corner), (corner, after[:3, 3]), strict=True)
    return [(name, start, end) for name, start, end in segments if np.linalg.norm(end - start) > 1e-9]


def visible_features(assignment: FrameAssignment) -> tuple[NDArray[np.bool_], Array]:
    """Return which frames are near enough to the arm to be shown, (n + 1,), and the feet of normals that are, (m, 3)."""
    chain = assignment.chain
    room = np.concatenate([chain.joint_points, chain.home[None, :3, 3]])
    radius = MAX_DISTANCE_IN_ARM_SIZES * max(float(np.ptp(room, axis=0).max()), 0.1)
    middle = room.mean(axis=0)
    feet = np.array([foot for normal in assignment.normals for foot in (normal.start, normal.end)]).reshape(-1, 3)
    near: NDArray[np.bool_] = np.linalg.norm(assignment.frames[:, :3, 3] - middle, axis=-1) < radius
    return near, feet[np.linalg.norm(feet - middle, axis=-1) < radius]


def span_on_axis(z: Array, point: Array, places: ArrayLike) -> tuple[float, float]:
    """Return from where to where an axis must be drawn, measured from its point, to contain those of the places that are on it.

    >>> span_on_axis(np.array([0.0, 0, 1]), np.zeros(3), [(0, 0, 2), (1, 0, 5)])
    (0.0, 2.0)
    """
    off = np.reshape(places, (-1, 3)) - point
    along = [0.0, *(off[np.linalg.norm(np.cross(z, off), axis=-1) < 1e-9] @ z).tolist()]
    return min(along), max(along)


def _parts(i: int, n: int, done: set[tuple[str, int | None]]) -> str:
    """Return which of O, z, x, y of frame i are assigned. The first and the last frame are assigned in one step."""
    if i in (0, n):
        return "Ozxy" if ("first" if i == 0 else "last", i) in done else ""
    return "".join(letters for kind, letters in {"origin": "Oz", "x": "x", "y": "y"}.items() if (kind, i) in done)
