"""Screw axes: the line about which a joint rotates, and its pitch, the translation along the line for each radian.

A screw axis is a normalized twist (omega, v). Its six numbers encode a direction, a point on the line and a pitch: `screw`
computes the six numbers from these, and `line` recovers them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import cross


class Line(NamedTuple):
    """A screw axis as geometry: unit direction (..., 3), the point (..., 3) nearest the origin, pitch (...) in m/rad."""

    axis: Array
    point: Array
    pitch: Array


def screw(axis: ArrayLike, point: ArrayLike = (0.0, 0.0, 0.0), pitch: ArrayLike = 0.0) -> Array:
    """Compute the screw axis of a joint from a direction, a point on the axis and a pitch.

    axis (..., 3) of unit length, point (..., 3) in metres, pitch (...) in metres per radian -> (..., 6):
    pitch 0, revolute:     (axis, -axis x point);
    pitch h, helical:      (axis, -axis x point + h axis);
    pitch inf, prismatic:  (0, axis); the point has no effect, because a prismatic joint has a direction but no line.

    Raises ValueError for an axis that is not of unit length.
    Source: Modern Robotics, 3.3.2.2 and definition 3.24; Forward kinematics II writes v = -w x q.

    >>> screw((0, -1, 0), point=(-4, -2, 0)) + 0.0        # joint 1 of the first example of Forward kinematics II
    array([ 0., -1.,  0.,  0.,  0.,  4.])
    """
    axis = validation.unit_vectors(axis, "axis")
    point = validation.vectors(point, "point", 3)
    pitch = validation.real_array(pitch, "pitch")[..., None]
    if (wrong := np.isnan(pitch) | (pitch == -np.inf)).any():
        raise ValueError(
            f"pitch must be finite, or inf for a prismatic joint; got {pitch[wrong][0]}. To translate the other way, negate the axis."
        )
    prismatic = np.isinf(pitch)
    omega = np.where(prismatic, 0.0, axis)
    v = np.where(prismatic, axis, cross(point, axis) + np.where(prismatic, 0.0, pitch) * axis)
    return np.concatenate(np.broadcast_arrays(omega, v), axis=-1)


def line(S: ArrayLike) -> Line:
    """Recover the direction, the point nearest the origin and the pitch of a screw axis: the inverse of screw.

    (..., 6) -> axis (..., 3), point (..., 3), pitch (...). With |omega| = 1: pitch = omega . v, point = omega x v.
    A prismatic axis has no line: its point is the origin, and its pitch is inf.

    Raises ValueError for a twist that is not a screw axis, that is, neither |omega| = 1, nor omega = 0 and |v| = 1.
    Source: Modern Robotics, 3.3.2.2.

    >>> line(screw((0, 0, 1), point=(1, 2, 9), pitch=0.1)).point + 0.0
    array([1., 2., 0.])
    """
    S = axes(S, "S")
    omega, v = S[..., :3], S[..., 3:]
    prismatic = is_prismatic(S)
    axis = np.where(prismatic[..., None], v, omega)
    point = np.where(prismatic[..., None], 0.0, cross(omega, v))
    pitch = np.where(prismatic, np.inf, np.sum(omega * v, axis=-1))
    return Line(axis, point, pitch)


def is_prismatic(S: Array) -> NDArray[np.bool_]:
    """Return which of the screw axes (..., 6) translate without rotating.

    >>> is_prismatic(np.array([[0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 1]]))
    array([False,  True])
    """
    without_rotation: NDArray[np.bool_] = (S[..., :3] == 0).all(axis=-1)
    return without_rotation


def axes(S: ArrayLike, name: str) -> Array:
    """Read S as screw axes (..., 6), normalized within the tolerance; ValueError for a twist that is not, with its index and length.

    >>> axes([[0, 0, 1, 0, -2, 0]], "screws").shape
    (1, 6)
    """
    S = validation.vectors(S, name, 6)
    size = _size(S)
    if (wrong := np.abs(size - 1) > tolerances.UNIT_LENGTH_TOL).any():
        index = np.argwhere(wrong)[0].tolist()
        length = size[tuple(index)]
        part = "omega" if S[tuple(index)][:3].any() else "v (omega is zero: a prismatic joint)"
        advice = "A twist is a screw axis times an angle or a length: divide all six numbers by this one"
        if S.shape == (6, 6) and (np.abs(_size(S.T) - 1) <= tolerances.UNIT_LENGTH_TOL).all():
            advice = f"Screw axes go in rows, but yours are in columns: try {name}.T"
        elif length < tolerances.ORTHONORMALITY_TOL:
            advice = f"A revolute joint needs an axis, and a prismatic joint needs a direction{', and an omega of 0' * bool(length)}"
        raise ValueError(
            f"{name} must contain screw axes: |omega| = 1, or omega = 0 and |v| = 1. "
            f"In {name}{index or ''} the length of {part} is {length:.10g}. {advice}."
        )
    return validation.divide_by_length(S, size)


def _size(S: Array) -> Array:
    """The length that must be 1 for a screw axis: |omega|, or |v| where omega is zero."""
    size: Array = np.linalg.norm(np.where(is_prismatic(S)[..., None], S[..., 3:], S[..., :3]), axis=-1)
    return size
