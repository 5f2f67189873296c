"""A slider through the configurations of an arm, with the screw axis of one joint as {s} and as {b} read it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view import draw_arm, slide
from kinlib.view.drawing.picture import vector_text
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.pictures import Pictures


def slide_axis(
    chain: Chain,
    joint: int,
    configurations: ArrayLike,
    label: str,
    values: Sequence[Any],
    *,
    ghost: ArrayLike | None = None,
    after: Any = None,
) -> Pictures:
    """Show an arm in several configurations, and the screw axis of one joint in each, as {s} and as {b} read it.

    joint           the joint whose axis is written in the caption, counted from 1
    configurations  (m, n) joint values, one configuration for each of the values
    ghost           (n,) another configuration, drawn in grey

    The screw in {s} is column `joint` of chain.jacobian(q), that in {b} the same column of chain.body_jacobian(q).

    >>> q = np.radians([[degrees, 0, 0, 0] for degrees in (0, 45, 90)])
    >>> type(slide_axis(kl.robots.mid_formula_arm(), 3, q, "joint 1 (degrees)", [0, 45, 90])).__name__
    'Pictures'
    """
    q = np.asarray(configurations, dtype=float)
    points = np.concatenate([stations(chain, now) for now in q])
    pictures = [draw_arm(chain, now, ghost=ghost, around=points, caption=axis_caption(chain, joint, now)) for now in q]
    return slide(pictures, label, values, after)


def axis_caption(chain: Chain, joint: int, q: Array) -> str:
    """Write the screw axis of a joint at q as {s} and as {b} read it.

    >>> axis_caption(kl.robots.rpr(), 1, np.zeros(3))
    'Axis 1 in {s}: (0, -1, 0, 0, 0, 4). In {b}: (0, 0, -1, 4, -1, 0).'
    """
    space, body = (jacobian(q)[:, joint - 1] for jacobian in (chain.jacobian, chain.body_jacobian))
    return f"Axis {joint} in {{s}}: {vector_text(space)}. In {{b}}: {vector_text(body)}."
