"""Drawings of a frame assignment after each of its steps: joint axes, common normals, origins and frames."""

import numpy as np

from kinlib.dh.assignment import FrameAssignment
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import describe_arm, pose_text
from kinlib.view.figures.assignment_steps import (
    MAX_DISTANCE_IN_ARM_SIZES,
    row_segments,
    span_on_axis,
    state_after,
    visible_features,
)
from kinlib.view.figures.joint_bodies import draw_joint_bodies


def draw_assignment(assignment: FrameAssignment, until: int | None = None, *, caption: str = "") -> Picture:
    """Draw a frame assignment after some of its steps: what the last step names is strong, what came before is pale.

    until  the index in assignment.steps of the last step drawn; None for the finished assignment

    Joint axes are violet and dashed, common normals orange; a normal of length zero is a short dashed line along its direction.
    Frame i has x_i, y_i, z_i at its tips; y is drawn only while its frame is strong. Frames with the same origin have arrows
    of different length. While a row is read off, its a is a thick orange line and its d a thick violet one.

    Raises ValueError if until is not the index of a step.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> print(draw_assignment(assign_frames(youbot(), convention="standard"), 3).alt)    # doctest: +NORMALIZE_WHITESPACE
    youBot, standard convention, step 4 of 25. O_1 lies on axis 2, where the common normal meets it: (0.033, 0, 0.147).
    Drawn so far: frame 0 at (0, 0, 0), x along (1, 0, 0), z along (0, 0, 1).
    """
    steps = assignment.steps
    drawing = _Drawing(assignment, until)
    drawing.draw()
    head = f"{assignment.chain.name}, {assignment.table.convention} convention"
    if until is None:
        return drawing.canvas.picture(f"{head}, all {len(steps)} steps. {drawing.describe()}", caption, cropped=True)
    step = steps[until]
    step_caption = f"Step {until + 1} of {len(steps)}. {step.text}" + (
        f" Also valid: {step.others}" if step.others else ""
    )
    axes = f" {describe_arm(assignment.chain, np.zeros(assignment.chain.n))}" if step.kind == "axes" else ""
    alt = f"{head}, step {until + 1} of {len(steps)}. {step.text}{axes} {drawing.describe()}"
    return drawing.canvas.picture(alt, caption or step_caption)


class _Drawing:
    """One picture of an assignment."""

    def __init__(self, assignment: FrameAssignment, until: int | None) -> None:
        self.assignment, self.state = assignment, state_after(assignment, until)
        self.chain = assignment.chain
        room = np.concatenate([self.chain.joint_points, self.chain.home[None, :3, 3]])
        self.near, self.feet = visible_features(assignment)
        seen = np.concatenate([room, assignment.frames[self.near, :3, 3], self.feet])
        self.middle = room.mean(axis=0)
        self.canvas = Canvas(seen)
        self.canvas.floor(seen)

    def draw(self) -> None:
        self._lines()
        draw_joint_bodies(self.canvas, self.chain, self.chain.link_poses(np.zeros(self.chain.n)))
        for pair, strong in enumerate(self.state.normals):
            if strong is not None:
                self._normal(pair, strong)
        if self.state.row is not None:
            self._row(self.state.row)
        for i in np.flatnonzero(self.near):
            self._frame(int(i))
        if self.state.kind == "accuracy":
            for name, T, there in (
                ("s", np.eye(4), self.assignment.frames[0]),
                ("b", self.chain.home, self.assignment.frames[-1]),
            ):
                if np.linalg.norm(
                    T[:3, 3] - self.middle
                ) < MAX_DISTANCE_IN_ARM_SIZES * self.canvas.size and not np.allclose(T, there):
                    self.canvas.triad(T, name, 0.12 * self.canvas.size)

    def describe(self) -> str:
        whole = [
            f"frame {i} {pose_text(T)}" for i, T in enumerate(self.assignment.frames) if "y" in self.state.frames[i]
        ]
        return f"Drawn so far: {'; '.join(whole) or 'the joints and their axes'}."

    def _lines(self) -> None:
        """Draw the joint axes, long enough to reach the feet of the normals on them."""
        for i, (z, point) in enumerate(zip(self.chain.lines.axis, self.chain.joint_points, strict=True)):
            low, high = span_on_axis(z, point, self.feet)
            ends = point + (low - 0.18 * self.canvas.size) * z, point + (high + 0.3 * self.canvas.size) * z
            strong = self.state.axes[i]
            colour, width = (VIOLET, 1.8) if strong else (_faded(VIOLET), 1.2)
            self.canvas.arrow(*ends, colour, width, style="--", level=1.5 + strong)

    def _normal(self, pair: int, strong: bool) -> None:
        normal = self.assignment.normals[pair]
        colour, width = (ORANGE, 3.2) if strong else (_faded(ORANGE), 2.2)
        ends = np.array([normal.start, normal.end])
        if np.linalg.norm(ends[1] - ends[0]) > 1e-9:
            self.canvas.line(ends, colour, width, level=3.2)
            return
        half = 0.22 * self.canvas.size * normal.x
        self.canvas.line([ends[0] - half, ends[0] + half], colour, width, "--", level=3.2)

    def _row(self, row: int) -> None:
        """Draw a row's translations from frame to frame: d along the joint axis, a along the common normal."""
        for name, start, end in row_segments(self.assignment, row):
            if np.linalg.norm(end - start) < MAX_DISTANCE_IN_ARM_SIZES * self.canvas.size:
                colour = VIOLET if name[0] == "d" else ORANGE
                self.canvas.line([start, end], colour, 4.5, level=3.4)
                self.canvas.label((start + end) / 2, f"${name}$", colour, size=12)

    def _frame(self, i: int) -> None:
        parts, T, strong = self.state.visible_parts(i), self.assignment.frames[i], self.state.strong[i]
        if not parts:
            return
        length = (0.17 + 0.08 * self._rank(i)) * self.canvas.size
        for letter in sorted(set(parts) - {"O"}):
            k = "xyz".index(letter)
            colour = AXIS_COLOURS[k] if strong else _faded(AXIS_COLOURS[k])
            tip = T[:3, 3] + length * T[:3, k]
            self.canvas.arrow(T[:3, 3], tip, colour, 2.4 if strong else 1.6, level=4 + strong + 0.01 * k)
            x, y = 11 * self.canvas.along(T[:3, 3], tip)
            places = [(x, y), *((x + dx, y + dy) for dx, dy in _LABEL_NUDGES)]
            self.canvas.label(tip, f"${letter}_{i}$", colour, places, 10)
        self.canvas.dot(T[:3, 3], INK if strong else _faded(INK), 6 if strong else 4, level=6)
        if self.state.kind == "origin" and strong:
            self.canvas.label(T[:3, 3], f"$O_{i}$", INK)

    def _rank(self, i: int) -> int:
        """Count the frames that are drawn before this one and have the same origin."""
        frames = self.assignment.frames
        return sum(
            bool(self.state.frames[j] and np.linalg.norm(frames[j, :3, 3] - frames[i, :3, 3]) < 1e-6) for j in range(i)
        )


_LABEL_NUDGES = (
    *((9, 0), (-9, 0), (0, 10), (0, -10), (14, 10), (-14, 10), (14, -10), (-14, -10)),
    *((22, 0), (-22, 0), (0, 20), (0, -20)),
)


FADED_SHARE = 0.55
"""How much of its colour is left of what the current step does not name."""


def _faded(colour: str) -> str:
    """Mix a colour with white, for what the current step does not name.

    >>> _faded("#000000")
    '#737373'
    """
    values = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(255 - FADED_SHARE * (255 - value)):02x}" for value in values)
