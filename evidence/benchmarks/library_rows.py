"""What is measured of the library: one call on a batch, as a user would type it, for kinlib and for each of its peers.

Every library is given the same NumPy array, and must give back one array with the result of each element. If it computes one
element in a call, then the loop, and the conversion from and to its own objects, are part of its time.

What counts is the processor time of the thread that calls. That of the process has the idle threads of OpenBLAS in it, too, which
wait in a loop during the first tenth of a second: 10,000 twists, which take 2.5 ms, would seem to take 6.5 ms in a new process.
"""

import subprocess
import sys
from dataclasses import dataclass

SIZES = (1, 2, 5, 15, 100, 10_000, 1_000_000)
"""Elements in a batch; of size 1, kinlib is given a single element, without a batch dimension."""

LOOP_LIMIT, SLOW_LOOP_LIMIT = 10_000, 100
"""The largest batches that are given to a loop: its time for an element does not change any more."""


@dataclass(frozen=True)
class Row:
    """One operation of one library.

    operation  such as "fk"; its first row is that of kinlib
    library    its name, and how it is used
    setup      lines of Python that are not timed; {shape} is the shape of the batch without its last dimension
    call       the expression that is timed
    largest    the largest batch that it is given
    same       an expression in `found`, the value of the call, that kinlib's value must equal
    """

    operation: str
    library: str
    setup: str
    call: str
    largest: int = SIZES[-1]
    same: str = "found"

    @property
    def name(self) -> str:
        """Both, for the ids of tests."""
        return f"{self.operation}-{self.library}"

    def lines(self, size: int) -> str:
        """The set-up for a batch of a size."""
        return self.setup.format(batch="" if size == 1 else f"{size}, ")


TWISTS = """\
import numpy as np, kinlib as kl
x = np.random.default_rng(0).normal(size=({batch}6,))
"""
POSES = """\
import numpy as np, kinlib as kl
T = kl.exp(np.random.default_rng(0).normal(size=({batch}6,)))
"""
ARM = """\
import numpy as np, kinlib as kl
arm, q = kl.robots.puma560(), np.random.default_rng(0).uniform(-2, 2, ({batch}6,))
"""
PINOCCHIO_ARM = (
    ARM
    + """\
import dataclasses, pinocchio as pin
limited = dataclasses.replace(arm, limits=[(-9, 9)] * 6)  # a joint without limits would have two coordinates
model = pin.buildModelFromXML(kl.to_urdf(limited))
data, tool = model.createData(), model.nframes - 1
"""
)
TOOLBOX_ARM = (
    ARM
    + """\
from roboticstoolbox import ET, ETS
from spatialmath import SE3
table = kl.assign_frames(arm, convention="standard").table
steps = [[ET.Rz(theta), ET.Rz(), ET.tz(d), ET.tx(a), ET.Rx(alpha)] for a, alpha, d, theta in table.rows]
base, tip = (ET.SE3(SE3(T, check=False)) for T in (table.base, table.tool))
ets = ETS([base, *(step for row in steps for step in row), tip]).compile()
"""
)
PINOCCHIO_FK = """\
def poses(q):
    T = np.empty((len(q), 4, 4))
    for i, row in enumerate(q):
        pin.forwardKinematics(model, data, row)
        T[i] = pin.updateFramePlacement(model, data, tool).homogeneous
    return T
"""
PINOCCHIO_JACOBIAN = """\
def jacobians(q):
    J = np.empty((len(q), 6, 6))
    for i, row in enumerate(q):
        J[i] = pin.computeJointJacobians(model, data, row)
    return np.roll(J, 3, axis=1)  # Pinocchio has v first
"""
TRANSLATED = "np.concatenate([found[:, 3:], found[:, :3] - np.cross(found[:, 3:], P[:, :, None], axis=1)], axis=1)"
"""The Jacobian of the Robotics Toolbox, (v, omega) of the tool's origin P, as a space Jacobian."""

ROWS = (
    Row("exp", "kinlib", TWISTS, "kl.exp(x)"),
    Row(
        "exp",
        "pytransform3d",
        TWISTS + "import pytransform3d.trajectories as pt\n",
        "pt.transforms_from_exponential_coordinates(x)",
    ),
    Row(
        "exp",
        "Pinocchio, a loop",
        TWISTS + "import pinocchio as pin\nx = np.atleast_2d(x)\n",
        "np.array([pin.exp6(pin.Motion(row[3:], row[:3])).homogeneous for row in x])",
        LOOP_LIMIT,
    ),
    Row(
        "exp",
        "modern_robotics, a loop",
        TWISTS + "import modern_robotics as mr\nx = np.atleast_2d(x)\n",
        "np.array([mr.MatrixExp6(mr.VecTose3(row)) for row in x])",
        SLOW_LOOP_LIMIT,
    ),
    Row(
        "exp",
        "Robotics Toolbox (spatialmath), a loop",
        TWISTS + "from spatialmath import base\nx = np.atleast_2d(x)\n",
        "np.array([base.trexp(np.roll(row, 3)) for row in x])",
        SLOW_LOOP_LIMIT,
    ),
    Row("log", "kinlib", POSES, "kl.log(T)"),
    Row(
        "log",
        "pytransform3d",
        POSES + "import pytransform3d.trajectories as pt\n",
        "pt.exponential_coordinates_from_transforms(T)",
    ),
    Row(
        "log",
        "Pinocchio, a loop",
        POSES + "import pinocchio as pin\nT = T.reshape(-1, 4, 4)\n",
        "np.roll([pin.log6(pose).vector for pose in T], 3, axis=1)",
        LOOP_LIMIT,
    ),
    Row(
        "log",
        "modern_robotics, a loop",
        POSES + "import modern_robotics as mr\nT = T.reshape(-1, 4, 4)\n",
        "np.array([mr.se3ToVec(mr.MatrixLog6(pose)) for pose in T])",
        SLOW_LOOP_LIMIT,
    ),
    Row(
        "log",
        "Robotics Toolbox (spatialmath), a loop",
        POSES + "from spatialmath import base\nT = T.reshape(-1, 4, 4)\n",
        "np.roll([base.trlog(pose, twist=True) for pose in T], 3, axis=1)",
        SLOW_LOOP_LIMIT,
    ),
    Row("fk", "kinlib", ARM, "arm.fk(q)"),
    Row("fk", "Robotics Toolbox, compiled", TOOLBOX_ARM, "ets.eval(q)"),
    Row(
        "fk",
        "Pinocchio, a loop",
        PINOCCHIO_ARM + "q = np.atleast_2d(q)\n" + PINOCCHIO_FK,
        "poses(q)",
        LOOP_LIMIT,
    ),
    Row(
        "fk",
        "modern_robotics, a loop",
        ARM + "import modern_robotics as mr\nq, screws = np.atleast_2d(q), arm.screws.T\n",
        "np.array([mr.FKinSpace(arm.home, screws, row) for row in q])",
        SLOW_LOOP_LIMIT,
    ),
    Row("jacobian", "kinlib", ARM, "arm.jacobian(q)"),
    Row(
        "jacobian",
        "Pinocchio, a loop",
        PINOCCHIO_ARM + "q = np.atleast_2d(q)\n" + PINOCCHIO_JACOBIAN,
        "jacobians(q)",
        LOOP_LIMIT,
    ),
    Row(
        "jacobian",
        "Robotics Toolbox, compiled, a loop",
        TOOLBOX_ARM + "q = np.atleast_2d(q)\nP = arm.fk(q)[:, :3, 3]\n",
        "np.array([ets.jacob0(row) for row in q])",
        LOOP_LIMIT,
        TRANSLATED,
    ),
    Row(
        "jacobian",
        "modern_robotics, a loop",
        ARM + "import modern_robotics as mr\nq, screws = np.atleast_2d(q), arm.screws.T\n",
        "np.array([mr.JacobianSpace(screws, row) for row in q])",
        SLOW_LOOP_LIMIT,
    ),
)
"""Robotics Toolbox and pytransform3d compute batches themselves where they are not called a loop."""

CHECK = Row(
    "check",
    "a wrong answer, whose mistake is named",
    """\
import numpy as np
from kincourse import open_sheet
sheet = open_sheet("03_poe_space", "ada")
screws = np.roll(sheet.problem(1).answer.value, 3, axis=1)
""",
    "sheet.check(1, screws)._repr_mimebundle_()",
    1,
)

FIVE_CALLS = """
import time
seconds = []
for _ in range(5):
    begun = time.thread_time()
    {call}
    seconds.append(time.thread_time() - begun)
print(sorted(seconds)[2])
"""


def in_new_process(row: Row, size: int) -> float:
    """Run the lines of a row in a new process, and return the median of five calls."""
    lines = row.lines(size) + FIVE_CALLS.format(call=row.call)
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", lines], capture_output=True, text=True, check=True)
    return float(done.stdout)
