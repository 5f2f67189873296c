"""What may come in: arrays of the right shape, finite numbers, unit axes, rotations, poses.

Every public function passes its arguments through here, so that a wrong one is refused at the edge, with what was
expected, what came and the likely cause, and the formulas behind the edge stay as short as in the book.
"""

import reprlib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.batching import Array, Pieces, cross, dot, pieces

__all__ = [
    "Array",
    "array",
    "brief",
    "frozen",
    "motions",
    "poses",
    "real",
    "rigid",
    "rigid_pieces",
    "turn",
    "unit",
    "vectors",
]

UNIT = 1e-9
"""How far the length of an axis may stray from 1. Data printed with nine digits pass; an axis left at (1, 1, 0) does not."""

RIGID = 1e-6
"""How far x . x, y . y and x . y of a rotation's columns may stray from 1, 1 and 0, and z from x x y. Single precision passes;
four printed decimals do not."""

TURN = 1e8
"""The longest turn in radians that still means something: beyond it, rounding alone moves the result by 1e-8."""


def array(x: ArrayLike, name: str) -> Array:
    """Read x as an array of finite real numbers: x itself, if it is one, so write to a copy.

    Raises ValueError for anything else, with the place of the first NaN or infinity.

    >>> array([1, 2, 3], "point")
    array([1., 2., 3.])
    """
    values = real(x, name)
    if not np.isfinite(values).all():
        place = f" at index {np.argwhere(~np.isfinite(values))[0].tolist()}" if values.ndim else ""
        raise ValueError(f"{name} holds NaN or infinity{place}. Was there a division by zero before this step?")
    return values


def real(x: ArrayLike, name: str) -> Array:
    """Read x as an array of real numbers, where infinity may have a meaning: x itself, if it is one.

    Raises ValueError for anything else.

    >>> real(np.inf, "pitch")
    array(inf)
    """
    try:
        values = np.asarray(x)
        if values.dtype.kind not in "biufO":
            raise TypeError(f"{values.dtype} is no real number")
        if values.dtype != float:
            # To astype alone, None is NaN and "1" is 1; added to zero, they are what they are.
            values = np.asarray(values + 0.0).astype(float, copy=False)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(
            f"{name} should be an array of real numbers; got {brief(x)}. "
            "Is None, a symbol, a string or a row of another length among them?"
        ) from error
    return values


def vectors(x: ArrayLike, name: str, size: int) -> Array:
    """Read x as vectors of one size, shape (..., size).

    Raises ValueError for another last dimension; says when the transpose would fit.

    >>> vectors(np.eye(3), "axes", 3).shape
    (3, 3)
    """
    values = array(x, name)
    if values.shape[-1:] != (size,):
        fits = values.ndim > 1 and values.shape[-2] == size
        cause = f"Components stand in the last dimension: try {name}.T" if fits else f"One vector has {size} components"
        raise ValueError(f"{name} should have shape (..., {size}); got {values.shape}. {cause}.")
    return values


def unit(x: ArrayLike, name: str) -> Array:
    """Read x as unit vectors of space, shape (..., 3).

    Raises ValueError for any other length, with the length that came. What strays within the tolerance comes back at
    length 1.

    >>> unit([0, 0, 1], "axis")
    array([0., 0., 1.])
    """
    values = vectors(x, name, 3)
    length = np.linalg.norm(values, axis=-1)
    if (wrong := np.abs(length - 1) > UNIT).any():
        came = length[wrong].flat[0]
        cause = "A direction has no length of its own: divide it by its norm" if came else "Zero points nowhere"
        raise ValueError(f"{name} should be a unit vector; its length is {came:.10g}. {cause}.")
    units: Array = values / length[..., None]
    return units


def turn(angle: Array) -> Array:
    """Pass angles on, in radians.

    Raises ValueError for one so large that rounding has eaten its direction.

    >>> turn(np.array([0.0, 3.14]))
    array([0.  , 3.14])
    """
    if (angle > TURN).any():
        raise ValueError(
            f"A turn of {angle.max():.3g} rad has no direction left in double precision. Did a computation diverge?"
        )
    return angle


def rigid(x: ArrayLike, name: str) -> Array:
    """Read x as rotations (..., 3, 3) or poses (..., 4, 4).

    Raises ValueError for another shape, NaN or infinity, a block that is not orthonormal, a reflection, a last row that is
    not 0 0 0 1.

    >>> rigid(np.eye(4), "home").shape
    (4, 4)
    """
    values = motions(x, name)
    for _ in rigid_pieces(values, values.shape[-2:], name):
        pass
    return values


def motions(x: ArrayLike, name: str) -> Array:
    """Read x as matrices of the shape of rotations, (..., 3, 3), or of poses, (..., 4, 4): what `rigid_pieces` looks into.

    Raises ValueError for another shape.

    >>> motions(np.zeros((4, 4)), "home").shape
    (4, 4)
    """
    values = real(x, name)
    if values.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"{name} should be a rotation (..., 3, 3) or a pose (..., 4, 4); got shape {values.shape}.")
    return values


def rigid_pieces(values: Array, takes: tuple[int, ...], name: str = "X") -> Pieces:
    """Cut rotations or poses as `pieces` does, and look at each piece while it is at hand: a second round would cost more.

    Raises ValueError for the first matrix that is no rotation or no pose, with its index.

    >>> [columns.shape for _, columns in rigid_pieces(np.eye(4)[None], (4, 4), "home")]
    [(4, 4, 1)]
    """
    for piece, X in pieces(values, takes):
        if not _are_rigid(X):
            first = next(i for i in range(X.shape[-1]) if not _are_rigid(X[..., i : i + 1]))
            raise ValueError(_fault(values, piece.start + first, name))
        yield piece, X


def poses(x: ArrayLike, name: str) -> Array:
    """Read x as poses, shape (..., 4, 4).

    Raises ValueError for anything that is not an element of SE(3).

    >>> poses(np.eye(4), "home").shape
    (4, 4)
    """
    values = rigid(x, name)
    if values.shape[-1] != 4:
        raise ValueError(
            f"{name} should be a pose (..., 4, 4); got a rotation of shape {values.shape}. Where is its origin?"
        )
    return values


def frozen(values: ArrayLike) -> Array:
    """Copy values so that nobody can write to them: a frozen object over a changing array would be frozen in name only.

    >>> frozen([1.0, 2.0]).flags.writeable
    False
    """
    copy = np.array(values, dtype=float)
    copy.flags.writeable = False
    return copy


def brief(x: Any) -> str:
    """Say in a few words what came, for an error message.

    >>> brief([1, 2, 3])
    'list [1, 2, 3]'
    """
    return f"{type(x).__name__} {reprlib.repr(x)}"


def _are_rigid(X: Array) -> bool:
    """Whether all of (3, 3, m) are rotations, or all of (4, 4, m) are poses."""
    x, y, z = X[:3, :3]
    # What overflows is far from rigid; and so is NaN, for it is never less than a tolerance.
    with np.errstate(over="ignore", invalid="ignore"):
        strays = [dot(x, x) - 1, dot(y, y) - 1, dot(x, y), cross(x, y) - z]
        if len(X) == 4:
            strays += X[:3, 3], X[3, 3] - 1, 0 * X[3, :3]  # 0 times infinity is NaN
        return all(np.abs(stray).max() <= RIGID for stray in strays)


def _fault(values: Array, count: int, name: str) -> str:
    """What is wrong with one of these matrices, which is no rotation or no pose."""
    index = np.unravel_index(count, values.shape[:-2])
    X, place = values[index], f" at index {[int(i) for i in index]}" if index else ""
    array(values, name)
    if len(X) == 4 and (np.abs(X[3] - [0, 0, 0, 1]) > RIGID).any():
        return (
            f"{name} is not a pose{place}: its last row should be 0 0 0 1; got {X[3]}. "
            "Is the translation in the last row instead of the last column? Try the transpose."
        )
    R = np.clip(X[:3, :3], -1e150, 1e150)  # the square of a huge number would overflow
    defect = np.abs(R.T @ R - np.eye(3)).max()
    if defect <= RIGID:
        return f"{name} is a reflection{place} (det R = -1), not a rotation. Are two axes swapped? Is y = z x x?"
    return (
        f"{name} is not rigid{place}: R^T R differs from the identity by {defect:.2g}. "
        "Were its entries rounded, or is an axis not of unit length?"
    )
