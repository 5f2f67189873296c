"""The arms of the project: four machines that the course uses nowhere else, with lengths of their own for each student.

A machine is written here as a standard table with a base, because a table whose frames are all prescribed has exactly the
numbers that are needed. Students see none of this: they get drawings with dimensions, and write each description from them.
"""

from dataclasses import dataclass
from itertools import count

import numpy as np

from kincourse.sampling.drawn_machines import table_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.dh.table import DHTable
from misstep.sampling import Sampler

STEP_M = 0.005
"""Lengths are multiples of this one, and no two of them are equal."""

MIN_GAP_M, SAME_M = 0.025, 1e-6
"""Marks differ in a coordinate by at least this much, or not at all, so that a drawing can be read."""

MIN_HEIGHT_M = 0.1
"""The height of the lowest mark above the floor at least."""

RAISED_M = {"pillar arm": 0.0, "bridge arm": 0.5, "ceiling arm": 1.2, "wall arm": 0.6}
"""How much higher than the others the base of a machine is mounted."""

KINDS = (
    ("pillar arm", "RRRR", (X, Y, Z), ((0, 1, 1, 0), (2, 0, 3, 1), (4, 1, 5, -1), (8, 0, 6, 0)), (X, Y, Z)),
    ("bridge arm", "PRRR", (Z, -Y, X), ((0, -1, 1, 0), (2, 0, 3, -1), (4, -1, 5, -1), (7, 0, 6, 0)), (Y, Z, X)),
    ("ceiling arm", "RPRR", (X, -Y, -Z), ((0, 0, 1, 0), (2, 1, 3, 1), (4, -1, 5, 1), (7, 0, 6, 0)), (Y, Z, X)),
    ("wall arm", "RRPR", (X, -Z, Y), ((0, -1, 1, -1), (2, 1, 3, -1), (4, 0, 5, 0), (7, 0, 6, 1)), (Y, -X, Z)),
)
"""Each kind of machine: its name, its joints, the axes of frame 0 in {s}, its rows, and the axes of {b} in the last frame.

An entry of a row is the number of one of eight lengths, the ninth of which is 0, or an angle in right angles.
"""


@dataclass(frozen=True, eq=False)
class Machine:
    """One student's machine.

    name    what it is called
    table   the standard table with the prescribed frames, base and tool
    limits  (n, 2) the limits of its joints, in radians and metres
    points  (n, 3) a point on each axis, marked in the drawing for the screws
    seats   (n, 4, 4) the prescribed joint frames of the file, in {s}: z along the joint axis
    """

    name: str
    table: DHTable
    limits: Array
    points: Array
    seats: Array

    @property
    def n(self) -> int:
        """The number of joints."""
        return self.table.n

    @property
    def chain(self) -> Chain:
        """The machine as screws with its limits: what its tool really does."""
        chain = self.table.to_chain()
        return Chain(chain.screws, chain.home, self.points, self.name, limits=self.limits)

    @property
    def frames(self) -> Array:
        """The prescribed frames 0 to n of the table in {s}, at home: (n + 1, 4, 4)."""
        return table_frames(self.table)

    @property
    def file_frames(self) -> Array:
        """The frames of its file in {s}, at home: the base, the joints and the tool, (n + 2, 4, 4)."""
        return np.array([np.eye(4), *self.seats, self.chain.home])


def draw_machine(student: str) -> Machine:
    """Draw the machine of a student; the same id always gives the same machine."""
    drawn = (_draw(Sampler(student, "10.project", attempt)) for attempt in count())
    return next(filter(_is_readable, drawn))


def _is_readable(machine: Machine) -> bool:
    """Whether marks are clearly apart or in line in each view, and none is below the floor."""
    tool = machine.chain.home[:3, 3]
    for places in (machine.points, machine.frames[:, :3, 3], machine.seats[:, :3, 3]):
        marks = np.array([np.zeros(3), *places, tool])
        gaps = np.diff(np.sort(marks, axis=0), axis=0)
        if ((gaps > SAME_M) & (gaps < MIN_GAP_M)).any() or marks[1:, 2].min() < MIN_HEIGHT_M:
            return False
    return True


def _draw(sampler: Sampler) -> Machine:
    name, joints, base, pattern, tool = KINDS[sampler.integer(0, len(KINDS) - 1)]
    lengths = STEP_M * np.array([*sampler.shuffled(range(22, 66))[:8], 0])
    place = [STEP_M * step for step in sampler.shuffled(range(24, 80))[:3]]
    place[2] += RAISED_M[name]
    rows = [(lengths[a], np.pi / 2 * alpha, lengths[d], np.pi / 2 * theta) for a, alpha, d, theta in pattern]
    table = DHTable(rows, "standard", joints=joints, base=pose(base, place), tool=pose(tool, (0, 0, 0)), name=name)
    frames = table_frames(table)
    shifts = [STEP_M * step for step in sampler.shuffled(range(8, 21))[: 2 * table.n]]
    points, seats = [], []
    for i, frame in enumerate(frames[:-1]):
        z, origin = frame[:3, 2], frame[:3, 3]
        points.append(origin - shifts[i] * z)
        x = sampler.choice([axis for axis in (X, Y, Z) if abs(axis @ z) + abs(axis @ frame[:3, 0]) < 0.5])
        seats.append(pose((x, np.cross(z, x), z), origin + shifts[table.n + i] * z))
    limits = [
        (-0.05 * sampler.integer(2, 4), 0.05 * sampler.integer(4, 7))
        if letter == "P"
        else (-np.radians(5 * sampler.integer(16, 30)), np.radians(5 * sampler.integer(16, 30)))
        for letter in table.joints
    ]
    return Machine(name, table, np.array(limits), np.array(points), np.array(seats))
