"""Common mistakes with space screws and the product of exponentials: each takes the right value and returns a wrong one.

`screw_mistakes` gives the mistakes of a problem whose answer is screw axes, `product_mistakes` those of a problem whose
answer is a pose by the space form. A problem adds those that belong to it alone.
"""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
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


def prismatic_as_revolute(arm: Chain) -> Array:
    """The screws of an arm with each prismatic joint treated as revolute: (d, -d x p) instead of (0, d), shape (n, 6).

    >>> from kinlib.chains.robots import rpr
    >>> prismatic_as_revolute(rpr())[1] + 0.0
    array([ 0.,  0.,  1., -2.,  4.,  0.])
    """
    d = arm.screws[:, 3:]
    slides = ~arm.screws[:, :3].any(axis=-1, keepdims=True)
    return np.where(slides, np.concatenate([d, np.cross(arm.joint_points, d)], axis=-1), arm.screws)


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


def product_mistakes(arm: Chain, q: Array) -> list[Mistake]:
    """The mistakes for a pose by the space form, T(q) = exp([S_1] q_1) ... exp([S_n] q_n) M, with q (n,).

    >>> from kinlib.chains.robots import rpr
    >>> [wrong.name for wrong in product_mistakes(rpr(), np.ones(3))]
    ['reversed', 'home first', 'no home', 'one exponential', 'degrees']
    """
    screws, home = arm.screws, arm.home
    return [
        mistake(
            "reversed",
            product(screws, q, home, "reversed"),
            "You multiplied from the last joint to the first. The factor of joint 1 stands leftmost: it moves all that follows.",
        ),
        mistake(
            "home first",
            product(screws, q, home, "home first"),
            "You put $M$ in front. With space screws it stands last, on the right; in front it belongs with body screws only.",
        ),
        mistake(
            "no home",
            product(screws, q, home, "no home"),
            "You left out $M$. The exponentials say how the tool has moved since home; $M$ says where home is.",
        ),
        mistake(
            "one exponential",
            exp(q @ screws) @ home,
            "You added the twists and took one exponential. You can rely on $e^A e^B = e^{A+B}$ only where $AB = BA$, and the "
            "joints of an arm seldom commute.",
        ),
        mistake(
            "degrees",
            product(screws, np.where(screws[:, :3].any(axis=-1), np.degrees(q), q), home),
            "You used degrees as radians. The exponential wants radians; slides stay in metres.",
        ),
    ]
