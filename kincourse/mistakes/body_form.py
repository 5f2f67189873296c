"""Common mistakes with body screws B_i = Ad(M^-1) S_i and with the body form T(q) = M exp([B_1] q_1) ... exp([B_n] q_n).

`body_screw_mistakes` gives the mistakes of a problem whose answer is body screws, one or all; `space_screw_mistakes`
those of a problem that asks for space screws from body screws; and `body_product_mistakes` those of a problem whose
answer is a pose by the body form.
"""

import numpy as np

from kincourse.mistakes.space_form import negate_moment, product, swap_halves
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, exp, homogeneous, inverse
from misstep.mistakes import Mistake, mistake


def transform_screws(T: Array, S: Array) -> Array:
    """Change the frame of screws S (..., 6) by a pose T (4, 4): Ad_T S.

    >>> transform_screws(np.eye(4), np.array([[0, 0, 1, 0, -2, 0]]))
    array([[ 0.,  0.,  1.,  0., -2.,  0.]])
    """
    read: Array = S @ adjoint(T).T
    return read


def rotate_only(T: Array, S: Array) -> Array:
    """Rotate both halves of screws S (..., 6) and leave out the change of origin: only the rotation of Ad_T.

    >>> rotate_only(exp([0, 0, 0, 2, 0, 0]), np.array([0, 0, 1, 0, 0, 0]))
    array([0., 0., 1., 0., 0., 0.])
    """
    R = T[:3, :3]
    return np.concatenate([S[..., :3] @ R.T, S[..., 3:] @ R.T], axis=-1)


def translate_only(T: Array, S: Array) -> Array:
    """Change the origin of screws S (..., 6) and leave out the rotation: the moments about the new origin, in the old axes.

    >>> translate_only(exp([0, 0, 0, 2, 0, 0]), np.array([0, 0, 1, 0, 0, 0])) + 0.0
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    return transform_screws(homogeneous(np.eye(3), T[:3, :3].T @ T[:3, 3]), S)


def body_screw_mistakes(S: Array, home: Array) -> list[Mistake]:
    """The mistakes for B = Ad(M^-1) S, with all space screws of an arm, S (n, 6), or one, S (6,); home is M, (4, 4).

    >>> [wrong.name for wrong in body_screw_mistakes(np.array([0, 0, 1, 0, -2, 0]), np.eye(4))][:3]
    ['Ad_M', 'only rotated', 'moved, not turned']
    """
    to_body = inverse(home)
    B = transform_screws(to_body, S)
    return [
        mistake(
            "Ad_M",
            transform_screws(home, S),
            "You carried the screws with $\\mathrm{Ad}_M$. That takes what {b} reads to what {s} reads; here we go the other way, with "
            "$\\mathrm{Ad}_{M^{-1}}$.",
        ),
        mistake(
            "only rotated",
            rotate_only(to_body, S),
            "You turned $\\omega$ and $v$, but the origin moved too: $v$ is the velocity at the new origin $p$, "
            "$R^T (v + \\omega \\times p)$.",
        ),
        mistake(
            "moved, not turned",
            translate_only(to_body, S),
            "You moved the origin, and kept the axes of {s}. {b} reads along axes of its own: both halves take on $R^T$.",
        ),
        mistake("space screws", S, "This is read in {s}. The tool stands elsewhere, and reads other numbers."),
        *_reversed_order_mistake(
            B,
            "These are the right screws in reverse. The tool does not count joints from its own end: joint 1 stays the first.",
        ),
        mistake(
            "halves swapped",
            swap_halves(B),
            "You wrote $(v, \\omega)$. Here a screw axis is $(\\omega, v)$, in {b} as in {s}.",
        ),
        mistake(
            "omega x q",
            negate_moment(B),
            "Your moments have the wrong sign. In {b} as in {s} it is $v = -\\omega \\times p$, with $p$ from the origin of the reader to "
            "the axis.",
        ),
    ]


def space_screw_mistakes(B: Array, home: Array) -> list[Mistake]:
    """The mistakes for S = Ad(M) B, with all body screws of an arm, B (n, 6), or one, B (6,); home is M, (4, 4).

    >>> len(space_screw_mistakes(np.eye(2, 6), np.eye(4)))
    6
    """
    S = transform_screws(home, B)
    return [
        mistake(
            "Ad_M^-1",
            transform_screws(inverse(home), B),
            "You carried the screws with $\\mathrm{Ad}_{M^{-1}}$. That takes what {s} reads to what {b} reads; here we go back.",
        ),
        mistake(
            "only rotated",
            rotate_only(home, B),
            "You turned $\\omega$ and $v$, but the origin moved too: $[\\mathrm{Ad}_M]$ has $[p] R$ in its lower left.",
        ),
        mistake(
            "moved, not turned",
            translate_only(home, B),
            "You moved the origin, and kept the axes of {b}. {s} reads along its own: both halves take on $R$.",
        ),
        mistake("body screws", B, "These are the body screws, as the tool reads them."),
        *_reversed_order_mistake(
            S, "These are the right screws in reverse. Whoever reads them, joint 1 is the one next to the base."
        ),
        mistake("halves swapped", swap_halves(S), "You wrote $(v, \\omega)$. Here a screw axis is $(\\omega, v)$."),
    ]


def body_product_mistakes(arm: Chain, q: Array) -> list[Mistake]:
    """The mistakes for a pose by the body form, T(q) = M exp([B_1] q_1) ... exp([B_n] q_n), with q (n,).

    >>> from kinlib.chains.robots import rpr
    >>> [wrong.name for wrong in body_product_mistakes(rpr(), np.ones(3))]
    ['home last', 'reversed', 'space screws', 'no home', 'one exponential', 'degrees']
    """
    B, home = arm.body_screws, arm.home
    typed = np.where(B[:, :3].any(axis=-1), np.degrees(q), q)
    return [
        mistake(
            "home last",
            product(B, q, home),
            "You put $M$ at the end. There it belongs with space screws; body screws stand to the right of $M$.",
        ),
        mistake(
            "reversed",
            home @ product(B, q, np.eye(4), "reversed"),
            "You multiplied the exponentials from the last joint to the first. In the body form too, joint 1 stands leftmost.",
        ),
        mistake(
            "space screws",
            product(arm.screws, q, home, "home first"),
            "You kept the space screws. To the right of $M$ stand the screws that the tool reads: $B_i$.",
        ),
        mistake(
            "no home",
            product(B, q, home, "no home"),
            "You left out $M$. The exponentials say how the tool has moved since home; $M$ says where home is.",
        ),
        mistake(
            "one exponential",
            home @ exp(q @ B),
            "You added the twists and took one exponential. You can rely on $e^A e^B = e^{A+B}$ only where $AB = BA$.",
        ),
        mistake(
            "degrees",
            product(B, typed, home, "home first"),
            "You used degrees as radians. The exponential wants radians; slides stay in metres.",
        ),
    ]


def _reversed_order_mistake(right: Array, message: str) -> list[Mistake]:
    return [mistake("reversed", right[::-1], message)] if right.ndim > 1 and len(right) > 1 else []
