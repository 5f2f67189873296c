"""A frame assignment, drawn: axes, common normals, origins and frames, as far as its steps have come."""

from typing import TYPE_CHECKING

import numpy as np

from kinlib.screw import line
from kinlib.view.canvas import AXIS_COLOURS, INK, ORANGE, VIOLET, Canvas
from kinlib.view.joints import draw_bodies
from kinlib.view.picture import Picture, spoken

if TYPE_CHECKING:
    from kinlib.frames import FrameAssignment

FAR = 4.0
"""What lies farther out than this many sizes of the arm is not kept in view: normals of nearly parallel axes do."""


def draw_assignment(assignment: "FrameAssignment", until: int | None = None, *, caption: str = "") -> Picture:
    """Draw a frame assignment after some of its steps: what the last of them names is strong, what came before is pale.

    until  the index in assignment.steps of the last step drawn; None for the finished assignment

    Axes are violet and dashed, common normals orange: a normal without length is a short dashed line along its direction.
    Frame i has x_i, y_i, z_i at its tips; y is drawn only while its frame is strong. Frames that share an origin get rods
    of different length. While a row is read off, its a is a thick orange line and its d a thick violet one.

    Raises ValueError for a step that there is not.

    >>> from kinlib.frames import assign_frames
    >>> from kinlib.robots import youbot
    >>> print(draw_assignment(assign_frames(youbot(), convention="standard"), 3).alt)    # doctest: +NORMALIZE_WHITESPACE
    youBot, standard convention, step 4 of 25. O_1 lies on axis 2, where the common normal meets it: (0.033, 0, 0.147).
    Drawn so far: frame 0 at (0, 0, 0), x along (1, 0, 0), z along (0, 0, 1).
    """
    steps = assignment.steps
    if until is not None and until not in range(len(steps)):
        raise ValueError(f"until counts the steps of this assignment, 0 to {len(steps) - 1}; got {until!r}.")
    drawing = _Drawing(assignment, len(steps) - 1 if until is None else until, whole=until is None)
    drawing.draw()
    head = f"{assignment.chain.name}, {assignment.table.convention} convention"
    if until is None:
        return drawing.canvas.picture(f"{head}, all {len(steps)} steps. {drawing.in_words()}", caption)
    step = steps[until]
    told = f"Step {until + 1} of {len(steps)}. {step.text}" + (f" Also legal: {step.others}" if step.others else "")
    alt = f"{head}, step {until + 1} of {len(steps)}. {step.text} {drawing.in_words()}"
    return drawing.canvas.picture(alt, caption or told)


class _Drawing:
    """One picture of an assignment: which of its parts are there, and which are strong."""

    def __init__(self, assignment: "FrameAssignment", last: int, whole: bool) -> None:
        self.assignment = assignment
        self.chain, self.table = assignment.chain, assignment.table
        self.standard = self.table.convention == "standard"
        self.done = {(step.kind, step.frame) for step in assignment.steps[: last + 1]}
        self.now = ("accuracy", None) if whole else (assignment.steps[last].kind, assignment.steps[last].frame)
        self.axes = line(self.chain.screws).axis
        room = np.concatenate([self.chain.joint_points, self.chain.home[None, :3, 3]])
        reach = FAR * max(float(np.ptp(room, axis=0).max()), 0.1)
        self.middle = room.mean(axis=0)
        origins = assignment.frames[:, :3, 3]
        self.near = np.linalg.norm(origins - self.middle, axis=-1) < reach
        feet = [foot for normal in assignment.normals for foot in (normal.start, normal.end)]
        self.feet = np.array([foot for foot in feet if np.linalg.norm(foot - self.middle) < reach]).reshape(-1, 3)
        seen = np.concatenate([room, origins[self.near], self.feet])
        self.canvas = Canvas(seen)
        self.canvas.floor(seen)

    def draw(self) -> None:
        self._lines()
        draw_bodies(self.canvas, self.chain, self.chain.link_poses(np.zeros(self.chain.n)))
        for pair in range(self.chain.n - 1):
            if ("normal", pair + 1) in self.done:
                self._normal(pair)
        if self.now[0] == "row" and self.now[1] is not None:
            self._row(self.now[1])
        for i in range(self.chain.n + 1):
            if self.near[i]:
                self._frame(i)
        if self.now[0] == "accuracy":
            for name, T, there in (
                ("s", np.eye(4), self.assignment.frames[0]),
                ("b", self.chain.home, self.assignment.frames[-1]),
            ):
                if np.linalg.norm(T[:3, 3] - self.middle) < FAR * self.canvas.size and not np.allclose(T, there):
                    self.canvas.triad(T, name, 0.12 * self.canvas.size)

    def in_words(self) -> str:
        whole = [
            f"frame {i} at {spoken(T[:3, 3])}, x along {spoken(T[:3, 0])}, z along {spoken(T[:3, 2])}"
            for i, T in enumerate(self.assignment.frames)
            if "y" in self._parts(i)
        ]
        return f"Drawn so far: {'; '.join(whole) or 'the joints and their axes'}."

    def _strong(self, i: int) -> bool:
        """Whether frame i belongs to the step of the moment."""
        kind, frame = self.now
        if kind == "row":
            return frame is not None and i in (frame - 1, frame)
        return kind == "accuracy" or i == frame

    def _parts(self, i: int) -> str:
        """Which of O, z, x, y of frame i are there by now."""
        if i in (0, self.chain.n):
            return "Ozxy" if ("first" if i == 0 else "last", i) in self.done else ""
        return "".join(
            letters for kind, letters in {"origin": "Oz", "x": "x", "y": "y"}.items() if (kind, i) in self.done
        )

    def _lines(self) -> None:
        """The joint axes, long enough to reach the feet of the normals on them."""
        kind, frame = self.now
        for i, (z, point) in enumerate(zip(self.axes, self.chain.joint_points, strict=True)):
            on_it = [foot for foot in self.feet if np.linalg.norm(np.cross(z, foot - point)) < 1e-9]
            along = [0.0, *((foot - point) @ z for foot in on_it)]
            low, high = min(along) - 0.18 * self.canvas.size, max(along) + 0.3 * self.canvas.size
            strong = kind in {"axes", "accuracy"} or (
                kind == "normal" and frame is not None and i in (frame - 1, frame)
            )
            colour = VIOLET if strong else _faded(VIOLET)
            self.canvas.arrow(
                point + low * z, point + high * z, colour, 1.8 if strong else 1.2, style="--", level=1.5 + strong
            )

    def _normal(self, pair: int) -> None:
        normal = self.assignment.normals[pair]
        strong = self.now in {("normal", pair + 1), ("accuracy", None), ("x", pair + 1)}
        colour, width = (ORANGE, 3.2) if strong else (_faded(ORANGE), 2.2)
        ends = np.array([normal.start, normal.end])
        if np.linalg.norm(ends[1] - ends[0]) > 1e-9:
            self.canvas.line(ends, colour, width, level=3.2)
            return
        half = 0.22 * self.canvas.size * normal.x
        self.canvas.line([ends[0] - half, ends[0] + half], colour, width, "--", level=3.2)

    def _row(self, row: int) -> None:
        """The way of one row from frame to frame: d along the joint's axis, a along the common normal."""
        before, after = self.assignment.frames[row - 1 : row + 1]
        a, _, d, _ = self.table.rows[row - 1]
        corner = before[:3, 3] + (d * before[:3, 2] if self.standard else a * before[:3, 0])
        legs = [(before[:3, 3], corner), (corner, after[:3, 3])]
        names = [("d", VIOLET, d, row), ("a", ORANGE, a, row if self.standard else row - 1)]
        for (start, end), (name, colour, length, index) in zip(
            legs, names if self.standard else names[::-1], strict=True
        ):
            if 1e-9 < abs(length) < FAR * self.canvas.size:
                self.canvas.line([start, end], colour, 4.5, level=3.4)
                self.canvas.label((start + end) / 2, f"${name}_{index}$", colour, size=12)

    def _frame(self, i: int) -> None:
        parts, T, strong = self._parts(i), self.assignment.frames[i], self._strong(i)
        if not parts:
            return
        length = (0.17 + 0.08 * self._rank(i)) * self.canvas.size
        for letter in "xyz":
            if letter in parts and (letter != "y" or (strong and self.now[0] != "accuracy")):
                k = "xyz".index(letter)
                colour = AXIS_COLOURS[k] if strong else _faded(AXIS_COLOURS[k])
                tip = T[:3, 3] + length * T[:3, k]
                self.canvas.arrow(T[:3, 3], tip, colour, 2.4 if strong else 1.6, level=4 + strong + 0.01 * k)
                away = self.canvas.flat(tip) - self.canvas.flat(T[:3, 3])
                away = 11 * away / max(float(np.linalg.norm(away)), 1e-9)
                places = [(away[0], away[1]), *((away[0] + dx, away[1] + dy) for dx, dy in _NUDGES)]
                self.canvas.label(tip, f"${letter}_{i}$", colour, places, 10)
        self.canvas.dot(T[:3, 3], INK if strong else _faded(INK), 6 if strong else 4, level=6)
        if self.now == ("origin", i):
            self.canvas.label(T[:3, 3], f"$O_{i}$", INK)

    def _rank(self, i: int) -> int:
        """How many frames drawn before this one stand at the same place."""
        frames = self.assignment.frames
        return sum(
            bool(self._parts(j) and np.linalg.norm(frames[j, :3, 3] - frames[i, :3, 3]) < 1e-6) for j in range(i)
        )


_NUDGES = ((9, 0), (-9, 0), (0, 10), (0, -10), (14, 10), (-14, 10), (14, -10), (-14, -10))


def _faded(colour: str, share: float = 0.55) -> str:
    """A colour mixed with white, for what is there and not the point of the moment.

    >>> _faded("#000000", 0.2)
    '#cccccc'
    """
    values = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(255 - share * (255 - value)):02x}" for value in values)
