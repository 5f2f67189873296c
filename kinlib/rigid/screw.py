"""Screw axes: the line that a joint turns about, and how far it travels along it for each radian.

A screw axis is a twist (omega, v) of unit size. Three numbers out of its six tell the direction; the other three hide a
point of the line and the pitch. `screw` packs them, `line` unpacks them.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.batching import cross
from kinlib.arrays.validation import Array


class Line(NamedTuple):
    """A screw axis as geometry: unit direction (..., 3), the point (..., 3) nearest the origin, pitch (...) in m/rad."""

    axis: Array
    point: Array
    pitch: Array


def screw(axis: ArrayLike, point: ArrayLike = (0.0, 0.0, 0.0), pitch: ArrayLike = 0.0) -> Array:
    """Write the screw axis of a joint from a direction, a point on its axis and a pitch.

    axis (..., 3) of unit length, point (..., 3) in metres, pitch (...) in metres per radian -> (..., 6):
    pitch 0, revolute:     (axis, -axis x point);
    pitch h, helical:      (axis, -axis x point + h axis);
    pitch inf, prismatic:  (0, axis), and the point plays no part: a slide has a direction, not a line.

    Raises ValueError for an axis that is not of unit length, wrong shapes, and NaN.
    Source: Modern Robotics, 3.3.2.2 and definition 3.24; the UIUC deck writes v = -w x q.

    >>> screw((0, -1, 0), point=(-4, -2, 0)) + 0.0        # joint 1 of the UIUC deck's first example
    array([ 0., -1.,  0.,  0.,  0.,  4.])
    >>> screw((0, 0, 1), pitch=np.inf)                    # its joint 2
    array([0., 0., 0., 0., 0., 1.])
    """
    axis = validation.unit(axis, "axis")
    point = validation.vectors(point, "point", 3)
    pitch = validation.real(pitch, "pitch")[..., None]
    if (wrong := np.isnan(pitch) | (pitch == -np.inf)).any():
        raise ValueError(
            f"pitch should be a finite number, or inf for a prismatic joint; got {pitch[wrong][0]}. "
            "To slide the other way, turn the axis round."
        )
    slides = np.isinf(pitch)
    omega = np.where(slides, 0.0, axis)
    v = np.where(slides, axis, np.cross(point, axis) + np.where(slides, 0.0, pitch) * axis)
    return np.concatenate(np.broadcast_arrays(omega, v), axis=-1)


def line(S: ArrayLike) -> Line:
    """Read the direction, the point nearest the origin and the pitch from a screw axis: the inverse of screw.

    (..., 6) -> axis (..., 3), point (..., 3), pitch (...). With |omega| = 1: pitch = omega . v, point = omega x v.
    A prismatic axis has no line: its point is the origin, its pitch inf.

    Raises ValueError for a twist that is no screw axis: |omega| = 1, or omega = 0 and |v| = 1.
    Source: Modern Robotics, 3.3.2.2.

    >>> line(screw((0, 0, 1), point=(1, 2, 9), pitch=0.1)).point + 0.0
    array([1., 2., 0.])
    """
    S = axes(S, "S")
    omega, v = S[..., :3], S[..., 3:]
    slides = is_prismatic(S)
    axis = np.where(slides[..., None], v, omega)
    point = np.where(slides[..., None], 0.0, cross(omega.T, v.T).T)
    pitch = np.where(slides, np.inf, np.sum(omega * v, axis=-1))
    return Line(axis, point, pitch)


def is_prismatic(S: Array) -> NDArray[np.bool_]:
    """Tell which of the screw axes (..., 6) slide without turning.

    >>> is_prismatic(np.array([[0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 1]]))
    array([False,  True])
    """
    still: NDArray[np.bool_] = (S[..., :3] == 0).all(axis=-1)
    return still


def axes(S: ArrayLike, name: str) -> Array:
    """Read S as screw axes, shape (..., 6).

    Raises ValueError for a twist of another size, with its row and its length; says when the transpose would fit.
    What strays within the tolerance comes back at unit size, so that every formula sees the same axis.

    >>> axes([[0, 0, 1, 0, -2, 0]], "screws").shape
    (1, 6)
    """
    S = validation.vectors(S, name, 6)
    size = _size(S)
    if (np.abs(size - 1) > validation.UNIT).any():
        fits = S.ndim == 2 and S.shape == (6, 6) and (np.abs(_size(S.T) - 1) <= validation.UNIT).all()
        index = np.argwhere(np.abs(size - 1) > validation.UNIT)[0].tolist()
        part = "omega" if S[tuple(index)][:3].any() else "v (omega is zero: a prismatic joint)"
        length = size[tuple(index)]
        if fits:
            cause = f"Screws stand in rows, and yours stand in columns: try {name}.T"
        elif length == 0:
            cause = "A slide needs a direction, and a turn needs an axis"
        elif length < validation.RIGID:
            cause = "Is it a prismatic joint with a rounding error in omega? Then set omega to zero"
        else:
            cause = "Divide the direction by its norm"
        raise ValueError(
            f"{name} should hold screw axes: |omega| = 1, or omega = 0 and |v| = 1. "
            f"In {name}{index or ''} the length of {part} is {length:.10g}. {cause}."
        )
    return S / size[..., None]


def _size(S: Array) -> Array:
    """The length that makes a twist a screw axis: |omega|, or |v| where there is no omega."""
    size: Array = np.linalg.norm(np.where(is_prismatic(S)[..., None], S[..., 3:], S[..., :3]), axis=-1)
    return size
