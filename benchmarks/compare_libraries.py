"""Print how fast kinlib and other libraries compute poses, Jacobians, exponentials and logarithms: python benchmarks/compare_libraries.py

Every library is given the same NumPy array and must give back one array, whose values are compared first. If it computes one
element in a call, then the loop, and the conversion from and to its own objects, are part of its time. The time is that of the
calling thread, because idle threads of OpenBLAS would count in the time of the process: the median of some calls.
"""

import dataclasses
import time
from collections.abc import Callable, Iterator

import modern_robotics as mr
import numpy as np
import pinocchio as pin
import pytransform3d.trajectories as pt
from roboticstoolbox import ET, ETS
from spatialmath import SE3

import kinlib as kl

SECONDS = 0.5
"""How long each row is repeated."""

Array = np.ndarray
Rows = Iterator[tuple[str, Callable[[Array], Array], int]]
"""The name of a library, its function of a batch, and the largest batch that it is given."""

ARM = kl.robots.puma560()
SIZES = (1, 10_000)


def pinocchio_model() -> tuple[pin.Model, pin.Data, int]:
    """Make the arm in Pinocchio, where a joint without limits would have two coordinates."""
    limited = dataclasses.replace(ARM, limits=[(-9, 9)] * len(ARM.screws))
    model = pin.buildModelFromXML(kl.to_urdf(limited))
    return model, model.createData(), model.nframes - 1


def toolbox_arm() -> ETS:
    """Make the arm in the Robotics Toolbox, in its compiled form."""
    table = kl.assign_frames(ARM, convention="standard").table
    steps = [[ET.Rz(theta), ET.Rz(), ET.tz(d), ET.tx(a), ET.Rx(alpha)] for a, alpha, d, theta in table.rows]
    base, tip = (ET.SE3(SE3(T, check=False)) for T in (table.base, table.tool))
    return ETS([base, *(step for row in steps for step in row), tip]).compile()


MODEL, DATA, TOOL = pinocchio_model()
TOOLBOX = toolbox_arm()


def fk() -> Rows:
    """Poses of the tool of a PUMA 560."""

    def pinocchio(q: Array) -> Array:
        T = np.empty((len(q), 4, 4))
        for i, row in enumerate(q):
            pin.forwardKinematics(MODEL, DATA, row)
            T[i] = pin.updateFramePlacement(MODEL, DATA, TOOL).homogeneous
        return T

    yield "kinlib", ARM.fk, SIZES[-1]
    yield "Pinocchio, a loop", pinocchio, SIZES[-1]
    yield "Robotics Toolbox, compiled", lambda q: np.reshape(TOOLBOX.eval(q), (-1, 4, 4)), SIZES[-1]
    yield "modern_robotics, a loop", lambda q: np.array([mr.FKinSpace(ARM.home, ARM.screws.T, row) for row in q]), 1


def jacobian() -> Rows:
    """Space Jacobians of a PUMA 560."""

    def pinocchio(q: Array) -> Array:
        J = np.empty((len(q), 6, 6))
        for i, row in enumerate(q):
            J[i] = pin.computeJointJacobians(MODEL, DATA, row)
        return np.roll(J, 3, axis=1)  # Pinocchio has v first

    yield "kinlib", ARM.jacobian, SIZES[-1]
    yield "Pinocchio, a loop", pinocchio, SIZES[-1]
    yield "modern_robotics, a loop", lambda q: np.array([mr.JacobianSpace(ARM.screws.T, row) for row in q]), 1


def exp() -> Rows:
    """Exponentials of twists."""
    yield "kinlib", kl.exp, SIZES[-1]
    yield "pytransform3d", pt.transforms_from_exponential_coordinates, SIZES[-1]
    yield (
        "Pinocchio, a loop",
        lambda x: np.array([pin.exp6(pin.Motion(r[3:], r[:3])).homogeneous for r in x]),
        SIZES[-1],
    )
    yield "modern_robotics, a loop", lambda x: np.array([mr.MatrixExp6(mr.VecTose3(row)) for row in x]), 1


def log() -> Rows:
    """Logarithms of poses."""
    yield "kinlib", kl.log, SIZES[-1]
    yield "pytransform3d", pt.exponential_coordinates_from_transforms, SIZES[-1]
    yield "Pinocchio, a loop", lambda T: np.roll([pin.log6(pose).vector for pose in T], 3, axis=1), SIZES[-1]
    yield "modern_robotics, a loop", lambda T: np.array([mr.se3ToVec(mr.MatrixLog6(pose)) for pose in T]), 1


def seconds(call: Callable[[Array], Array], data: Array) -> float:
    """Return the median of the calling thread's time, over calls that together take SECONDS."""
    call(data)
    times: list[float] = []
    while sum(times) < SECONDS:
        start = time.thread_time()
        call(data)
        times.append(time.thread_time() - start)
    return float(np.median(times))


def main() -> None:
    """Compare the values of all libraries, then print their times."""
    generator = np.random.default_rng(0)
    print(f"NumPy {np.__version__}\n{'':10} {'':28} {'size':>7} {'time':>12}")
    for operation in (fk, jacobian, exp, log):
        for size in SIZES:
            twists = generator.normal(size=(size, 6))
            data = {fk: twists, jacobian: twists, exp: twists, log: kl.exp(twists)}[operation]
            right = None
            for library, call, largest in operation():
                if size > largest:
                    continue
                right = call(data) if right is None else right
                np.testing.assert_allclose(
                    call(data), right, rtol=0, atol=1e-9, err_msg=f"{operation.__name__} of {library}"
                )
                print(
                    f"{operation.__name__:10} {library:28} {size:7,} {seconds(call, data) * 1e6:9,.1f} µs", flush=True
                )


if __name__ == "__main__":
    main()
