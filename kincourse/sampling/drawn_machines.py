"""Machines in dimensioned drawings: random lengths that can be read off, and the mistakes that people make when they read them."""

from collections.abc import Iterable, Iterator

import numpy as np

from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.dh.slips import OTHER_CONVENTION
from kinlib.dh.table import DHTable
from kinlib.view.drawing.picture import Picture
from misstep.mistakes import Mistake

STEP_M = 0.01
"""Lengths in drawings are multiples of this one."""

MIN_GAP_M = 0.03
"""Two marks differ in a coordinate by at least this much, or not at all."""


def lengths(sampler: ArmSampler, count: int, low: float = 0.1, high: float = 0.6) -> Array:
    """Draw different lengths in metres, no two of which are equal or half of each other."""
    while True:
        drawn = STEP_M * np.array(sampler.shuffled(range(round(low / STEP_M), round(high / STEP_M)))[:count])
        doubled = np.abs(drawn[:, None] - 2 * drawn)
        if doubled.min() > STEP_M / 2:
            return drawn.round(3)


def is_readable(points: Iterable[Array]) -> bool:
    """Whether points are clearly apart or in line along each axis, so that their dimensions can be read."""
    gaps = np.diff(np.sort(np.array([np.zeros(3), *points]), axis=0), axis=0)
    return not ((gaps > 1e-6) & (gaps < MIN_GAP_M)).any()


def misread(points: Array) -> Iterator[tuple[str, Array, str]]:
    """Yield how people misread points (k, 3) in a drawing: the name, the wrong points, and what is true of them."""
    yield ("views swapped", points[:, [0, 2, 1]], "y and z are swapped. Only the front view shows z.")
    yield "depth reversed", points * (1, -1, 1), "Every y has the wrong sign. In the top view, y is up."
    yield "another origin", points - points[0], "Your points are measured from the first of them, and not from {s}."
    steps = np.array([_last_steps(points[:, k]) for k in range(3)]).T
    yield "steps not added", steps, "Each coordinate is the last step of its chain. Add all steps from {s} to the mark."


def _last_steps(values: Array) -> Array:
    """The distance of each value to its neighbour towards 0, with its sign."""
    levels = np.unique(np.append(values, 0.0).round(6))
    steps = []
    for value in values.round(6):
        nearer = [level for level in levels if abs(level) < abs(value) and level * value >= 0]
        steps.append(value - max(nearer, key=abs) if nearer else value)
    return np.array(steps)


def table_frames(table: DHTable) -> Array:
    """The frames 0 to n of a table in {s}, at home: (n + 1, 4, 4)."""
    return table.frames(np.zeros(table.n))


def draw_table_frames(table: DHTable) -> Picture:
    """Draw the frames of a table with right angles as a dimensioned drawing: marks D0, D1, ..., their x axes and the joint axes."""
    frames = table_frames(table)
    first = 0 if table.convention == "standard" else 1
    axes = [
        DrawnAxis(str(i + 1), frames[i + first, :3, 2].round(), frames[i + first, :3, 3], letter == "P")
        for i, letter in enumerate(table.joints)
    ]
    marks = {f"D{i}": frame[:3, 3] for i, frame in enumerate(frames)}
    arrows = {f"x{i}": (frame[:3, 3], frame[:3, 0].round()) for i, frame in enumerate(frames)}
    return draw_dimensions(frames[:, :3, 3], axes, marks, arrows=arrows)


def drawn_table_mistakes(table: DHTable) -> list[Mistake]:
    """The mistakes that people make in the rows of a drawn table, and that are no slips in any table."""
    other = OTHER_CONVENTION[table.convention]
    from_floor = table.rows.copy()
    from_floor[:, 2] = table_frames(table)[1:, 2, 3]
    floor = "Every d is a height above the floor. It is the step along z from one x to the next."
    converted = table.converted(other).rows
    return [
        Mistake("the other convention", converted, f"These are the rows of the {other} convention.", spoils=True),
        Mistake("d from the floor", from_floor, floor, spoils=True),
    ]
