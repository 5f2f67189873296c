"""What of a frame assignment is there after each of its steps, and what the step names: for drawings on paper and page."""

from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.assignment import FrameAssignment

MAX_DISTANCE_IN_ARM_SIZES = 4.0
"""What lies farther out than this many sizes of the arm is not kept in view: normals of nearly parallel axes do."""

FINISHED = ("accuracy", None)
"""The step at which everything stands side by side, and nothing in particular is the point."""


@dataclass(frozen=True)
class AssignmentState:
    """An assignment after some of its steps: what is named now is strong, what came before is pale.

    kind     of the step of the moment, as in kinlib.dh.explanation
    axes     (n,) whether the axis of each joint is strong
    normals  (n - 1,) whether each common normal is strong; None where it is not there yet
    frames   (n + 1,) which of O, z, x, y of each frame are there
    strong   (n + 1,) whether each frame belongs to the step of the moment
    row      the row that is read off, counted from 1; None while none is
    """

    kind: str
    axes: tuple[bool, ...]
    normals: tuple[bool | None, ...]
    frames: tuple[str, ...]
    strong: tuple[bool, ...]
    row: int | None

    def letters(self, i: int) -> str:
        """Which parts of frame i are drawn: y only while its frame is strong, for y always follows from z and x."""
        return self.frames[i] if self.strong[i] and self.kind != "accuracy" else self.frames[i].replace("y", "")


def state_after(assignment: FrameAssignment, until: int | None = None) -> AssignmentState:
    """Say what is there after a step of an assignment, counted from 0, or when it is finished.

    Raises ValueError for a step that there is not.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> state_after(assign_frames(youbot(), convention="standard"), 3).frames
    ('Ozxy', 'Oz', '', '', '', '')
    """
    steps, n = assignment.steps, assignment.chain.n
    if until is not None and until not in range(len(steps)):
        raise ValueError(f"until counts the steps of this assignment, 0 to {len(steps) - 1}; got {until!r}.")
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
    """The way of a row from frame to frame, in the order of its convention: ("d", from, to) along z, ("a", ...) along x.

    row  counted from 1; a leg of no length is left out

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
    ways = zip(names, (before[:3, 3], corner), (corner, after[:3, 3]), strict=True)
    return [(name, start, end) for name, start, end in ways if np.linalg.norm(end - start) > 1e-9]


def visible_features(assignment: FrameAssignment) -> tuple[Array, Array]:
    """Which frames are near enough to the arm to be shown, (n + 1,), and the feet of normals that are, (m, 3)."""
    chain = assignment.chain
    room = np.concatenate([chain.joint_points, chain.home[None, :3, 3]])
    reach = MAX_DISTANCE_IN_ARM_SIZES * max(float(np.ptp(room, axis=0).max()), 0.1)
    middle = room.mean(axis=0)
    feet = np.array([foot for normal in assignment.normals for foot in (normal.start, normal.end)]).reshape(-1, 3)
    near: Array = np.linalg.norm(assignment.frames[:, :3, 3] - middle, axis=-1) < reach
    return near, feet[np.linalg.norm(feet - middle, axis=-1) < reach]


def _parts(i: int, n: int, done: set[tuple[str, int | None]]) -> str:
    """Which of O, z, x, y of frame i are there by now: the first and the last frame come whole."""
    if i in (0, n):
        return "Ozxy" if ("first" if i == 0 else "last", i) in done else ""
    return "".join(letters for kind, letters in {"origin": "Oz", "x": "x", "y": "y"}.items() if (kind, i) in done)
