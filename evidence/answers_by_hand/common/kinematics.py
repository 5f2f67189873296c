"""Rows and chains of link transforms, and the slips that any pose invites, written by hand."""

from typing import Any

import numpy as np

from evidence.answers_by_hand.common.motions import I3, Array, exp, parts, pose, product


def turn(axis: str, angle: float) -> Array:
    """The rotation (3, 3) about "x", "y" or "z" by an angle in radians."""
    return exp(I3["xyz".index(axis)], angle)


def frame(R: Any = I3, p: Any = (0, 0, 0)) -> Array:
    """The pose (4, 4) with rotation R and position p; without them the identity."""
    return pose(R, p)


def logarithm(T: Array) -> Array:
    """The twist (6,) of a pose (4, 4), the inverse of `exp` for angles below pi.

    >>> logarithm(exp([0, 0, 1, 0, -2, 0])).round(9) + 0.0
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    R, p = parts(T)
    axial = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    sine = float(np.linalg.norm(axial))
    angle = float(np.arctan2(sine, (np.trace(R) - 1) / 2))
    w = axial * (angle / sine if sine > 1e-12 else 1.0)
    columns = np.column_stack([exp([*w, *v])[:3, 3] for v in I3])
    return np.concatenate([w, np.linalg.solve(columns, p)])


def link(row: Any, convention: str) -> Array:
    """The pose (4, 4) of one DH row a, alpha, d, theta, as a product of a motion along x and one along z.

    >>> link((1, 0, 0, np.pi / 2), "standard").round(6)[:3, 3]
    array([0., 1., 0.])
    """
    a, alpha, d, theta = row
    along_x, along_z = frame(turn("x", alpha), (a, 0, 0)), frame(turn("z", theta), (0, 0, d))
    return along_z @ along_x if convention == "standard" else along_x @ along_z


def chain(rows: Any, convention: str) -> Array:
    """The pose (4, 4) of the last frame of a table (m, 4) in frame 0."""
    return product(*(link(row, convention) for row in rows))


def at(rows: Any, joints: str, q: Any) -> Array:
    """The rows (m, 4) with joint values q (m,) added to theta where the letter is R, and to d where it is P.

    >>> at([[1, 0, 0, 0]], "P", [0.5])
    array([[1. , 0. , 0.5, 0. ]])
    """
    moved = np.array(rows, dtype=float)
    for i, letter in enumerate(joints):
        moved[i, 3 if letter == "R" else 2] += q[i]
    return moved


def one_entry(value: Any, index: Any, new: float) -> Array:
    """A copy of an array with one entry replaced."""
    changed = np.array(value, dtype=float)
    changed[index] = new
    return changed


def pose_slips(T: Array) -> dict[str, tuple[Any, str]]:
    """Slips of somebody who has computed the right pose T (4, 4), or is about to write it down."""
    R, p = parts(T)
    return {
        "R transposed": (frame(R.T, p), "transpos, R^T, inverse of the rotation, sine and the cosine"),
        "inverse": (np.linalg.inv(T), "inverse, seen from, other way, way back, R^T, transpos"),
        "whole matrix transposed": (T.T, "transpos, last row"),
        "position negated": (frame(R, -p), "sign, negat, opposite, minus"),
        "rotation only": (frame(R), "position, translation, shift, origin, left out, p = 0, no length"),
        "position only": (frame(p=p), "rotation, turn, left out, R = I, identity"),
        **(
            {}
            if np.allclose(T, np.round(T, 2), atol=2e-3)
            else {"two decimals": (np.round(T, 2), "round, digit, decimal")}
        ),
    }


def ordinary_forms(value: Any) -> dict[str, Any]:
    """An array as a list, and with the three decimals that a sheet prints."""
    array = np.asarray(value, dtype=float)
    return {"as a list": array.tolist(), "three decimals": array.round(3)}
