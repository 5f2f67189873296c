"""How the logarithm of a motion changes when the motion goes on: what Newton's method needs to close a loop.

A motion E is a little further along: exp(V) E, with a small twist V. Its logarithm moves by almost V, and would move by V
itself if motions commuted. How far they do not is told by the bracket of twists, and the correction is a series in it.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import hat

SERIES = 0.5
"""Turns below this, in radians, take the power series: the closed form divides differences by theta^4."""

BERNOULLI = np.array([1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160, 691 / 1307674368000, 1 / 74724249600])
"""1 - (theta/2) cot(theta/2) = sum of BERNOULLI[k-1] theta^(2k), with |B_2k| / (2k)!; below SERIES the rest is 1e-15."""

_K = np.arange(1, len(BERNOULLI) + 1)
_SECOND = np.flip((2 - _K) * BERNOULLI)
_FOURTH = np.flip(((1 - _K) * BERNOULLI)[1:])


def ad(x: ArrayLike) -> Array:
    """Write the bracket with a twist as a matrix: how x carries other twists along, per unit of time.

    (..., 6) -> (..., 6, 6), [[hat(omega), 0], [hat(v), hat(omega)]], so that hat(ad(x) y) = hat(x) hat(y) - hat(y) hat(x).

    Raises ValueError for anything that is not a twist.
    Source: Modern Robotics, definition 8.1.

    >>> ad([0, 0, 1, 0, 0, 0]) @ [0, 0, 0, 1, 0, 0]        # turning about z carries a slide along x towards y
    array([0., 0., 0., 0., 1., 0.])
    """
    x = validation.vectors(x, "x", 6)
    matrix = np.zeros((*x.shape[:-1], 6, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = hat(x[..., :3])
    matrix[..., 3:, :3] = hat(x[..., 3:])
    return matrix


def log_jacobian(x: ArrayLike) -> Array:
    """Tell how log(E) changes as E = exp(x) moves on: the inverse of the left Jacobian of SE(3).

    (..., 6) -> (..., 6, 6), with log(exp(V) E) = x + log_jacobian(x) V + O(V^2):  I - A/2 + c2 A^2 + c4 A^4,  A = ad(x).
    With theta = |omega| and f = 1 - (theta/2) cot(theta/2):  c2 theta^2 = 2f - theta f'/2,  c4 theta^4 = f - theta f'/2.

    Raises ValueError for anything that is not a twist. The turn should lie below 2 pi, where f is infinite; log keeps it
    at or below pi.
    Source: the Bernoulli series sum B_k ad^k / k!, folded by ad^5 = -2 theta^2 ad^3 - theta^4 ad.

    >>> log_jacobian([0, 0, 0, 1, 2, 3]) @ [0, 0, 0, 4, 5, 6]      # slides commute: the logarithm moves by V itself
    array([0., 0., 0., 4., 5., 6.])
    """
    A = ad(x)
    theta = np.linalg.norm(np.asarray(x, dtype=float)[..., :3], axis=-1)[..., None, None]
    square = theta * theta
    # Where the series is taken, the closed form is asked for a turn of 1 instead: it would divide by zero.
    far = np.where(theta < SERIES, 1.0, theta)
    half = far / 2
    cot = 1 / np.tan(half)
    f = 1 - half * cot
    bend = (half / np.sin(half) ** 2 - cot) * far / 4
    c2 = np.where(theta < SERIES, np.polyval(_SECOND, square), (2 * f - bend) / far**2)
    c4 = np.where(theta < SERIES, np.polyval(_FOURTH, square), (f - bend) / far**4)
    A2 = A @ A
    rate: Array = np.eye(6) - A / 2 + c2 * A2 + c4 * (A2 @ A2)
    return rate
