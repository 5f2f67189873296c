"""The frame-assignment player: the steps of `kl.assign_frames`, one at a time, with what each one names lit up.

The page is told every step at once, in both conventions, and moves between them without asking Python.
"""

from collections.abc import Iterable, Iterator
from typing import Any, get_args

import numpy as np
import traitlets

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.explanation import Step
from kinlib.dh.formatting import format_rows
from kinlib.dh.table import Convention, DHTable, convention_of
from kinlib.view.figures.assignment_steps import row_segments, state_after, visible_features
from kinlib.view.figures.frame_assignment import draw_assignment
from kinlib.view.viewer.scene import extent, scene
from kinlib.view.viewer.viewer import Viewer

CONVENTIONS: tuple[Convention, ...] = get_args(Convention)

STEP_TITLES = {
    "axes": "The joint axes",
    "first": "Frame 0",
    "normal": "Axes {i} and {j}",
    "origin": "Origin O_{i}",
    "x": "Axis x_{i}",
    "y": "Axis y_{i}",
    "last": "Frame {i}, the last",
    "row": "Row {i} of the table",
    "accuracy": "The table and the arm",
}
"""The head above each kind of step."""

VIEW_RADIUS_SHARE = 0.84
"""Of the ball around all that is drawn: seen from where the eye begins, no arm fills its ball."""

HIGHLIGHTED_PARTS = {"origin": "O", "x": "x", "y": "y", "first": "Oxyz", "last": "Oxyz"}
"""Which parts of its frame a step names."""


class Player(Viewer):
    """A frame assignment on the page. Make one with `play_assignment`.

    step        the step shown, counted from 0; the page and Python both set it
    convention  which assignment is shown, "standard" or "modified"; the reader may switch
    """

    step = traitlets.Int(0).tag(sync=True)
    convention = traitlets.Enum(list(CONVENTIONS), default_value="standard").tag(sync=True)

    def __init__(self, chain: Chain, **traits: Any) -> None:
        self.assignments = {name: assign_frames(chain, convention=name) for name in CONVENTIONS}
        home = np.zeros(chain.n)
        super().__init__(
            chain,
            scene=bare_scene(chain, _points(self.assignments.values())),
            q=home,
            start=home,
            readout=False,
            mode={
                "kind": "assignment",
                "conventions": {name: _assignment_data(found) for name, found in self.assignments.items()},
            },
            **traits,
        )

    @property
    def assignment(self) -> FrameAssignment:
        """The assignment that is shown."""
        return self.assignments[self.convention]

    @property
    def alt(self) -> str:
        """What the picture shows, in words."""
        return draw_assignment(self.assignment, self.step).alt

    @traitlets.validate("step")
    def _there(self, proposal: Any) -> int:
        step: int = proposal["value"]
        state_after(self.assignment, step)  # refuses a step that there is not, in words
        return step

    def _drawing(self) -> str:
        return draw_assignment(self.assignment, self.step).html()


def play_assignment(chain: Chain, *, convention: Convention, step: int = 0, after: Any = None) -> Player:
    """Walk through the assignment of DH frames to an arm, step by step, forwards and back.

    step   the step to begin with, counted from 0; afterwards the trait `step` follows the page and leads it
    after  a question; the arm stays covered until it is committed

    Raises ValueError for another convention, for a helical joint, and for a step that there is not.

    >>> from kinlib.chains.robots import youbot
    >>> player = play_assignment(youbot(), convention="standard", step=3)
    >>> player.alt[:62]
    'youBot, standard convention, step 4 of 25. O_1 lies on axis 2,'
    """
    made = Player(chain, convention=convention_of(convention))
    made.step = step
    made.wait_for(after)
    return made


def table_cells(table: DHTable) -> list[list[str]]:
    """The rows of a table as a page shows them: a, alpha, d, theta, with q_i for what moves, and true minus signs.

    >>> from kinlib.chains.robots import youbot
    >>> table_cells(assign_frames(youbot(), convention="standard").table)[3]
    ['0', '90°', '0', 'q_4 + 90°']
    """
    return [[cell.replace("-", "−") for cell in row] for row in format_rows(table, variable="q_{}".format)]


def bare_scene(chain: Chain, points: Array) -> dict[str, Any]:
    """The arm at home without sliders, in a room that holds points (m, 3) too and is no larger than that."""
    data = scene(chain, np.zeros(chain.n), joints=[])
    stations = np.concatenate([points, chain.joint_points, chain.home[None, :3, 3], np.zeros((1, 3))])
    low, high = stations.min(axis=0), stations.max(axis=0)
    radius = VIEW_RADIUS_SHARE * float(np.linalg.norm(high - low)) / 2
    return {
        **data,
        "size": max(extent(chain), radius),
        "room": {"centre": ((low + high) / 2).tolist(), "radius": radius, "snug": True},
        "offered": ["dimensions"],
    }


def _points(assignments: Iterable[FrameAssignment]) -> Array:
    """What should be in view of assignments: origins, the ends of axes."""
    return np.concatenate(
        [
            piece
            for found in assignments
            for near, feet in [visible_features(found)]
            for piece in (found.frames[near, :3, 3], np.reshape([*axis_ends(found.chain, feet)], (-1, 3)))
        ]
    )


def _assignment_data(found: FrameAssignment) -> dict[str, Any]:
    """An assignment as data: what does not change from step to step, and what each step shows."""
    near, feet = visible_features(found)
    return {
        "axes": [[end.tolist() for end in ends] for ends in axis_ends(found.chain, feet)],
        "normals": [
            {"from": normal.start.tolist(), "to": normal.end.tolist(), "along": normal.x.tolist()}
            for normal in found.normals
        ],
        "frames": [T.ravel().tolist() if seen else None for T, seen in zip(found.frames + 0.0, near, strict=True)],
        "table": table_cells(found.table),
        "steps": [_step(found, k, step) for k, step in enumerate(found.steps)],
    }


def axis_ends(chain: Chain, feet: Array) -> Iterator[tuple[Array, Array]]:
    """Both ends of each joint axis, long enough to reach the tool and the feet of normals that lie on it."""
    size = extent(chain)
    for z, point in zip(chain.lines.axis, chain.joint_points, strict=True):
        on_it = [foot for foot in (*feet, chain.home[:3, 3]) if np.linalg.norm(np.cross(z, foot - point)) < 1e-9]
        along = [0.0, *((foot - point) @ z for foot in on_it)]
        yield point + (min(along) - 0.24 * size) * z, point + (max(along) + 0.34 * size) * z


def _step(found: FrameAssignment, k: int, step: Step) -> dict[str, Any]:
    current = state_after(found, k)
    i = step.frame
    return {
        "title": STEP_TITLES[step.kind].format(i=i, j=None if i is None else i + 1),
        "text": step.text,
        "others": step.others,
        "axes": list(current.axes),
        "normals": list(current.normals),
        "letters": [current.visible_parts(frame) for frame in range(len(current.frames))],
        "strong": list(current.strong),
        "lit": [HIGHLIGHTED_PARTS.get(step.kind, "") if frame == i else "" for frame in range(len(current.frames))],
        "row": current.row,
        "legs": [
            {"name": name, "from": start.tolist(), "to": end.tolist()}
            for name, start, end in (row_segments(found, current.row) if current.row else [])
        ],
    }
