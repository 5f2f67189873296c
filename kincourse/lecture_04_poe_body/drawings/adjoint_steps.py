"""The three steps that take a twist from {s} to {b}: the velocity at another point, the same omega, components along other axes."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.rigid.lie import homogeneous
from kinlib.view.drawing.canvas import MARGIN_SHARE, Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

TITLES = ("given in {s}", "(a), (b): at p", "(c): along {b}")

AXIS_SHARE = 0.3
"""The length of the axes of a frame, as a share of the width of a panel."""

RIGHT, BELOW = [(26, 4), (-28, 0)], [(8, -16), (-8, 16)]
"""Where the labels of velocities may be placed: offsets in pixels to the right and up."""

VELOCITY_SHARE = 0.42
"""The length of the longest velocity, as a share of the width of a panel."""


def draw_adjoint_steps(S: ArrayLike, M: ArrayLike) -> Picture:
    """Draw how a twist in the x-y plane is taken from {s} to {b}, in three panels side by side.

    S  (6,) the twist (omega, v) in {s}, with omega along z and v in the x-y plane
    M  (4, 4) the pose of {b} in {s}, a rotation about z and a translation in the x-y plane

    On the left, v: the velocity of the point of the body that is at the origin of {s}. In the middle, the velocity
    v + omega x p of the point at the origin of {b}. On the right, the components of this velocity along the axes of {b}.

    >>> M = np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    >>> print(draw_adjoint_steps([0, 0, 1, 1, 0, 0], M).alt)                         # doctest: +NORMALIZE_WHITESPACE
    In {s}: omega = 1 about z, and v = (1, 0, 0) at the origin of {s}. Steps (a) and (b): at the origin of {b}, p = (2, 1, 0),
    omega x p = (-1, 2, 0), and the velocity is (0, 2, 0). Step (c): its components along the axes of {b} are (2, 0, 0).
    """
    S, M = np.asarray(S, dtype=float), np.asarray(M, dtype=float)
    omega, v, R, p = S[:3], S[3:], M[:3, :3], M[:3, 3]
    added = np.cross(omega, p)
    at_p = v + added
    width = 1.9 * max(float(np.abs(p).max()), 1e-3)
    scale = VELOCITY_SHARE * width / max(float(np.linalg.norm([v, added, at_p], axis=1).max()), 1e-9)
    reach = np.array([[1.42 * width / (1 + 1.2 * MARGIN_SHARE), 0, 0]])
    middle = np.array([1.5 * width, p[1] / 2, 0])
    ends = np.concatenate([middle - reach, middle + reach])
    canvas = Canvas(ends, "top", size=(720, 460), sizes=np.zeros((2, 3)))
    panels = [np.array([k * width, 0.0, 0.0]) for k in range(3)]
    for title, shift in zip(TITLES, panels, strict=True):
        canvas.triad(homogeneous(np.eye(3), shift), "s", AXIS_SHARE * width, letters="xy")
        canvas.triad(homogeneous(R, p + shift), "b", AXIS_SHARE * width, letters="xy")
        canvas.label(np.add(shift, (0.28 * width, min(0, p[1]) - 0.22 * width, 0)), title, INK, [(0, 0)], 13)
    first, second, third = panels
    canvas.arrow(first, first + p, GREY, 1.4, style="--")
    canvas.label(first + p / 2, "$p$", GREY)
    canvas.arrow(first, first + scale * v, VIOLET, 2.6)
    canvas.label(first + scale * v, "$v$", VIOLET)
    start = second + p
    canvas.arrow(start, start + scale * v, VIOLET, 2.0)
    canvas.label(start + scale * v / 2, "$v$", VIOLET)
    canvas.arrow(start + scale * v, start + scale * at_p, GREY, 2.0, style="--")
    canvas.label(start + scale * (v + at_p) / 2, "$ω × p$", GREY, RIGHT)
    canvas.arrow(start, start + scale * at_p, ORANGE, 2.6)
    canvas.label(start + scale * at_p, "$v + ω × p$", ORANGE, BELOW)
    start, parts = third + p, R.T @ at_p
    canvas.arrow(start, start + scale * at_p, ORANGE, 2.6)
    for k in range(2):
        along = start + scale * parts[k] * R[:, k]
        canvas.line([start + scale * at_p, along], GREY, 1.2, ":")
        canvas.dot(along, AXIS_COLOURS[k], 7)
        canvas.label(along, f"{parts[k] + 0.0:.3g}", AXIS_COLOURS[k])
    return canvas.picture(
        f"In {{s}}: omega = {omega[2]:.3g} about z, and v = {vector_text(v)} at the origin of {{s}}. Steps (a) and (b): at the "
        f"origin of {{b}}, p = {vector_text(p)}, omega x p = {vector_text(added)}, and the velocity is {vector_text(at_p)}. "
        f"Step (c): its components along the axes of {{b}} are {vector_text(parts)}.",
        cropped=True,
    )
