"""Common mistakes with space screws and the product of exponentials: each takes the right value and returns a wrong one.

`screw_mistakes` gives the mistakes of a problem whose answer is screw axes. A problem adds those that belong to it alone.
"""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from misstep.mistakes import Mistake, mistake


def negate_moment(S: Array) -> Array:
    """Negate the moment: v = omega x p instead of -omega x p. The term of the pitch, parallel to omega, keeps its sign.

    S (..., 6) -> (..., 6).

    >>> negate_moment(np.array([0, 0, 1, 0, -2, 0.1]))
    array([0. , 0. , 1. , 0. , 2. , 0.1])
    """
    omega, v = S[..., :3], S[..., 3:]
    along = np.sum(omega * v, axis=-1, keepdims=True) * omega
    turns = omega.any(axis=-1, keepdims=True)
    return np.concatenate([omega, np.where(turns, 2 * along - v, v)], axis=-1)


def swap_halves(S: Array) -> Array:
    """Write (v, omega) instead of (omega, v), as some books do. S (..., 6) -> (..., 6).

    >>> swap_halves(np.array([0, 0, 1, 0, -2, 0]))
    array([ 0, -2,  0,  0,  0,  1])
    """
    return np.roll(S, 3, axis=-1)


def remove_moment(S: Array) -> Array:
    """Set v = 0 for revolute and helical joints, which is right only for revolute joints whose axes pass through the origin.

    S (..., 6) -> (..., 6). Prismatic joints keep their v.

    >>> remove_moment(np.array([[0, 0, 1, 0, -2, 0], [0, 0, 0, 1, 0, 0]]))
    array([[0., 0., 1., 0., 0., 0.],
           [0., 0., 0., 1., 0., 0.]])
    """
    turns = S[..., :3].any(axis=-1, keepdims=True)
    return np.where(turns & (np.arange(6) >= 3), 0.0, S)


def product(screws: Array, q: Array, home: Array, order: str = "screws then home") -> Array:
    """Multiply exponentials and home pose in the right order or in a wrong one that is common.

    screws (n, 6), q (n,) in radians and metres, home (4, 4) -> (4, 4)
    order  "screws then home" (space form), "reversed", "home first" or "no home"

    >>> from kinlib.chains.robots import rpr
    >>> product(rpr().screws, np.array([0.0, 2.0, 0.0]), rpr().home, "no home")[:3, 3]
    array([0., 0., 2.])
    """
    T, factors = np.eye(4), [exp(S * value) for S, value in zip(screws, q, strict=True)]
    orders = {
        "screws then home": [*factors, home],
        "reversed": [*factors[::-1], home],
        "home first": [home, *factors],
        "no home": factors,
    }
    for factor in orders[order]:
        T = T @ factor
    return T


def screw_mistakes(S: Array) -> list[Mistake]:
    """The three common mistakes for screw axes S (..., 6) of revolute joints.

    >>> [wrong.name for wrong in screw_mistakes(np.array([0, 0, 1, 0, -2, 0]))]
    ['omega x q', 'halves swapped', 'no moment']
    """
    return [
        mistake(
            "omega x q",
            negate_moment(S),
            "You took $v = \\omega \\times p$. The point of the body that sits at the origin moves with "
            "$v = -\\omega \\times p$: the arrow from the axis to the origin is $-p$.",
        ),
        mistake(
            "halves swapped",
            swap_halves(S),
            "You wrote $(v, \\omega)$. Here a screw axis is $(\\omega, v)$, turn first, as in Modern Robotics; "
            "some books and libraries use the other order.",
        ),
        mistake(
            "no moment",
            remove_moment(S),
            "You left $v = 0$. That holds for a turn about an axis through the origin of {s}; about any other, turning also "
            "moves the point at the origin, by $v = -\\omega \\times p$.",
        ),
    ]
