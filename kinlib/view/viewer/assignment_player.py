"""The frame-assignment player: the steps of `kl.assign_frames`, one at a time, with what each one names highlighted.

The page receives all steps at once, in both conventions, so it can move between them without Python.
"""

from collections.abc import Iterable, Iterator
from typing import Any, get_args

import numpy as np
import traitlets

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment, assign_frames
from kinlib.dh.assignment_steps import AssignmentStep
from kinlib.dh.formatting import format_rows
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.assignment_steps import row_segments, span_on_axis, state_after, visible_features
from kinlib.view.figures.frame_assignment import draw_assignment
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.scene import extent, scene, still_room
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
"""The heading of each kind of step."""

VIEW_RADIUS_SHARE = 0.84
"""The radius in view, as a share of the sphere around all that is drawn: in the initial view no arm fills that sphere."""

HIGHLIGHTED_PARTS = {"origin": "O", "x": "x", "y": "y", "first": "Oxyz", "last": "Oxyz"}
"""The parts of its frame that a step highlights: O for the origin, and axes."""


class Player(Viewer):
    """A frame assignment on the page. Make one with `play_assignment`.

    step        the step shown, counted from 0; the page and Python can both set it
    convention  the assignment shown, "standard" or "modified"; the reader can switch it
    """

    step = traitlets.Int(0).tag(sync=True)
    _set_by_reader = ("step",)
    convention = traitlets.Enum(list(CONVENTIONS), default_value="standard").tag(sync=True)

    def __init__(self, chain: Chain, rows: int | None = None, **traits: Any) -> None:
        self.assignments = {name: assign_frames(chain, convention=name) for name in CONVENTIONS}
        steps = {name: _assignment_data(assignment, rows) for name, assignment in self.assignments.items()}
        whole = bare_scene(chain, _points(self.assignments.values()))
        super().__init__(chain, whole, np.zeros(chain.n), mode={"kind": "assignment", "conventions": steps}, **traits)

    @property
    def assignment(self) -> FrameAssignment:
        """The assignment that is shown."""
        return self.assignments[self.convention]

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        return draw_assignment(self.assignment, self.step).alt

    @traitlets.validate("step")
    def _validate_step(self, proposal: Any) -> int:
        step: int = proposal["value"]
        state_after(self.assignment, step)  # raises ValueError if there is no such step
        return step

    def _picture(self) -> Picture:
        return crop([draw_assignment(self.assignment, self.step)])[0]


def play_assignment(chain: Chain, *, convention: Convention, rows: int | None = None, after: Any = None) -> Player:
    """Show the assignment of DH frames to an arm step by step, forwards and back.

    rows   how many rows of the table are read; the reader finds the others. By default all of them
    after  a question; the arm stays covered until a prediction is committed

    Raises ValueError if the convention is unknown, a joint is helical, or rows is not one of 0, ..., n.

    >>> from kinlib.chains.robots import youbot
    >>> player = play_assignment(youbot(), convention="standard")
    >>> player.step = 3
    >>> player.alt[:62]
    'youBot, standard convention, step 4 of 25. O_1 lies on axis 2,'
    """
    validation.instance(chain, "chain", Chain)
    if rows is not None and rows not in range(chain.n + 1):
        raise ValueError(f"rows must be the number of rows to show, 0 to {chain.n}; got {rows!r}.")
    return Player(chain, rows, convention=validate_convention(convention), after=after)


def table_cells(table: DHTable) -> list[list[str]]:
    """Return the rows of a table as the page shows them: a, alpha, d, theta, with q_i for the joint variable.

    >>> from kinlib.chains.robots import youbot
    >>> table_cells(assign_frames(youbot(), convention="standard").table)[3]
    ['0', '90°', '0', 'q_4 + 90°']
    """
    return [[cell.replace("-", "−") for cell in row] for row in format_rows(table, variable="q_{}".format)]


def bare_scene(chain: Chain, points: Array) -> dict[str, Any]:
    """Return the scene of the arm at home without sliders, with a view that also contains points (m, 3)."""
    data = scene(chain, np.zeros(chain.n), joints=[])
    room = still_room(np.concatenate([points, stations(chain)]), VIEW_RADIUS_SHARE)
    return {**data, "size": max(extent(chain), room["radius"]), "room": room, "offered": ["dimensions"]}


def _points(assignments: Iterable[FrameAssignment]) -> Array:
    """Return the points of assignments that must be in view: origins and ends of axes."""
    return np.concatenate(
        [
            piece
            for assignment in assignments
            for near, feet in [visible_features(assignment)]
            for piece in (assignment.frames[near, :3, 3], np.reshape([*axis_ends(assignment.chain, feet)], (-1, 3)))
        ]
    )


def _assignment_data(assignment: FrameAssignment, rows: int | None) -> dict[str, Any]:
    """Return an assignment as data for the page: what is the same in all steps, and what each step shows.

    rows  how many rows of the table are read; by default all of them, and the accuracy of the table follows
    """
    first_row = next(k for k, step in enumerate(assignment.steps) if step.kind == "row")
    steps = assignment.steps if rows is None else assignment.steps[: first_row + rows]
    near, feet = visible_features(assignment)
    return {
        "axes": [[end.tolist() for end in ends] for ends in axis_ends(assignment.chain, feet)],
        "normals": [
            {"from": normal.start.tolist(), "to": normal.end.tolist(), "along": normal.x.tolist()}
            for normal in assignment.normals
        ],
        "frames": [T.ravel().tolist() if seen else None for T, seen in zip(assignment.frames + 0.0, near, strict=True)],
        "table": table_cells(assignment.table)[:rows],
        "steps": [_step(assignment, k, step) for k, step in enumerate(steps)],
    }


def axis_ends(chain: Chain, feet: Array) -> Iterator[tuple[Array, Array]]:
    """Yield both ends of each joint axis, long enough to contain the tool and the feet of normals that are on it."""
    size = extent(chain)
    for z, point in zip(chain.lines.axis, chain.joint_points, strict=True):
        low, high = span_on_axis(z, point, [*feet, chain.home[:3, 3]])
        yield point + (low - 0.24 * size) * z, point + (high + 0.34 * size) * z


def _step(assignment: FrameAssignment, k: int, step: AssignmentStep) -> dict[str, Any]:
    current = state_after(assignment, k)
    i = step.frame
    return {
        "title": STEP_TITLES[step.kind].format(i=i, j=None if i is None else i + 1),
        "text": step.text,
        "others": step.others,
        "axes": list(current.axes),
        "normals": list(current.normals),
        "parts": [current.visible_parts(frame) for frame in range(len(current.frames))],
        "strong": list(current.strong),
        "highlighted": [
            HIGHLIGHTED_PARTS.get(step.kind, "") if frame == i else "" for frame in range(len(current.frames))
        ],
        "row": current.row,
        "segments": [
            {"name": name, "from": start.tolist(), "to": end.tolist()}
            for name, start, end in (row_segments(assignment, current.row) if current.row else [])
        ],
    }
