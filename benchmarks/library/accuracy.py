"""Accuracy of exp and log, compared with five other libraries: the largest error at each angle, by mpmath at 40 digits.

    python -m benchmarks.library.accuracy

SO(3) is measured with rotation vectors and SE(3) with twists with |v| = 1, each in 50 directions. The error of exp is the
largest entry of exp(x) - X, where X is exp(x) with 40 digits. log is given X rounded to double precision; its error is the
largest entry of exp(log(X)) - X, where this exp has 40 digits too. Therefore a library that returns the opposite axis near
pi has only the error that results from it.
"-" means that the library has no such function; "fails", that it raised an exception or returned NaN.
"""

import warnings

import modern_robotics as mr
import mpmath_oracle
import numpy as np
import pytransform3d.rotations as pr
import pytransform3d.transformations as pt
import spatialmath.base as sm
from scipy.spatial.transform import Rotation

import kinlib as kl

try:
    import pinocchio as pin
except ModuleNotFoundError:  # no wheel for Windows
    pin = None

DIRECTIONS = 50
ANGLES = {
    "0": 0.0,
    **{f"1e-{k}": 10.0**-k for k in (12, 9, 7, 5, 3, 1)},
    "1": 1.0,
    "3": 3.0,
    **{f"pi - 1e-{k}": np.pi - 10.0**-k for k in (3, 5, 7, 9, 12, 15)},
    "pi": np.pi,
}

# Each library: exp and log of SO(3) from and to omega, exp and log of SE(3) from and to (omega, v).
LIBRARIES = {
    "kinlib": (kl.exp, kl.log, kl.exp, kl.log),
    "SciPy": (lambda w: Rotation.from_rotvec(w).as_matrix(), lambda R: Rotation.from_matrix(R).as_rotvec(), None, None),
    "modern_robotics": (
        lambda w: mr.MatrixExp3(mr.VecToso3(w)),
        lambda R: mr.so3ToVec(mr.MatrixLog3(R)),
        lambda x: mr.MatrixExp6(mr.VecTose3(x)),
        lambda T: mr.se3ToVec(mr.MatrixLog6(T)),
    ),
    "pytransform3d": (
        pr.matrix_from_compact_axis_angle,
        pr.compact_axis_angle_from_matrix,
        pt.transform_from_exponential_coordinates,
        pt.exponential_coordinates_from_transform,
    ),
    "spatialmath": (
        sm.trexp,
        lambda R: sm.trlog(R, twist=True),
        lambda x: sm.trexp(np.roll(x, 3)),
        lambda T: np.roll(sm.trlog(T, twist=True), 3),
    ),
}
if pin:
    LIBRARIES["pinocchio"] = (
        pin.exp3,
        pin.log3,
        lambda x: pin.exp6(np.roll(x, 3)).homogeneous,
        lambda T: np.roll(pin.log6(T).vector, 3),
    )


def max_error(function, arguments, motions):
    """Format the largest error over all arguments, as a cell of the table."""
    if function is None:
        return "-"
    try:
        values = [np.asarray(function(argument), dtype=float) for argument in arguments]
    except (ValueError, TypeError, ArithmeticError, AttributeError):
        return "fails"
    if not np.isfinite(values).all():
        return "fails"
    results = [value if value.ndim == 2 else mpmath_oracle.exp(value) for value in values]
    return f"{np.abs(results - motions).max():.0e}"


def rows():
    """Yield the label of an angle, the name of a library, and its four cells."""
    rng = np.random.default_rng(3)
    units = rng.normal(size=(2, DIRECTIONS, 3))
    units[0, :6] = [*np.eye(3), *-np.eye(3)]
    units /= np.linalg.norm(units, axis=-1, keepdims=True)
    for label, angle in ANGLES.items():
        x = np.concatenate([angle * units[0], units[1]], axis=-1)
        T = np.array([mpmath_oracle.exp(row) for row in x])
        omega, R = x[:, :3], T[:, :3, :3]

        for name, (exp3, log3, exp6, log6) in LIBRARIES.items():
            yield (
                label,
                name,
                (max_error(exp3, omega, R), max_error(log3, R, R), max_error(exp6, x, T), max_error(log6, T, T)),
            )


def main():
    """Print the table, one block for each function."""
    warnings.simplefilter("ignore")  # some peers divide by zero
    table = {(label, name): cells for label, name, cells in rows()}
    for column, title in enumerate(["exp, SO(3)", "log, SO(3)", "exp, SE(3)", "log, SE(3)"]):
        print(f"{title:<12}" + "".join(f"{name:>17}" for name in LIBRARIES))
        for label in ANGLES:
            print(f"{label:<12}" + "".join(f"{table[label, name][column]:>17}" for name in LIBRARIES))
        print()


if __name__ == "__main__":
    main()
