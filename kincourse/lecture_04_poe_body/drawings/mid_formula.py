"""The mid-formula form, drawn: an arm at home, and the distance of each screw axis from the frame, {s} or {b}, in which it is given."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.screw import is_prismatic
from kinlib.view import slide
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.pictures import Pictures

LANE_PX = 6.0
"""Perpendiculars that would lie on each other are drawn side by side, so many pixels apart."""

LENGTH_OFFSETS = [(-20, 0), (0, 12), (20, 0), (0, -12), (-26, 10), (26, 10), (26, -10), (-26, -10)]


def slide_mid_formula(chain: Chain, q: ArrayLike, *, after: Any = None, start: int = 0) -> Pictures:
    """Show the mid-formula form with M after joint 0, 1, ..., n: e^[S1]q1 ... e^[Sk]qk M e^[Bk+1]qk+1 ... e^[Bn]qn.

    q  (n,) the joint values at which the position of the end-effector is written in the caption

    The caption gives the form, the position of the end-effector, which is the same for every k, and how many of the entries of
    the screws are not 0.

    >>> type(slide_mid_formula(kl.robots.mid_formula_arm(), [0.5, -0.3, 0.8, 0.4])).__name__
    'Pictures'
    """

    def draw(k: int) -> Picture:
        factors = [f"e^[{'S' if i <= k else 'B'}{i}]q{i}" for i in range(1, chain.n + 1)]
        form = " ".join([*factors[:k], "M", *factors[k:]])
        tool = vector_text(chain.fk_mid(q, k)[:3, 3])
        entries = np.count_nonzero(np.vstack([chain.screws[:k], chain.body_screws[k:]]).round(9))
        return draw_mid_formula(
            chain, k, f"T = {form}. End-effector at {tool} m. Entries of the screws that are not 0: {entries}."
        )

    return slide(draw, "joints before M: k", range(chain.n + 1), after, start)


def draw_mid_formula(chain: Chain, k: int, caption: str = "") -> Picture:
    """Draw an arm at home, with its first k screw axes given in {s} and the others in {b}, as in the mid-formula form.

    A dotted line runs from the origin of that frame perpendicularly to the axis of each revolute or helical joint. Its length,
    written beside it, is the distance of the axis from the origin; if the pitch is 0, it is the length of v. A prismatic joint
    has no such line, because its screw has a direction but no position.

    >>> draw_mid_formula(kl.robots.mid_formula_arm(), 2).alt
    'mid-formula arm at home. Read from {s}: S_1 at 0 m, S_2 at 0.4 m. Read from {b}: B_3 at 0 m, B_4 at 0.2 m.'
    """
    feet = axis_perpendiculars(chain, k)
    path = stations(chain)
    canvas = Canvas(np.concatenate([path, feet.reshape(-1, 3)]))
    canvas.floor(path)
    canvas.line(path, PALE_GREY, 6.0, level=1)
    lanes = _lanes(feet)
    for i, (point, axis) in enumerate(zip(chain.joint_points, chain.lines.axis, strict=True)):
        start, tip = np.array([[-0.16], [0.3]]) * canvas.size * axis + point
        canvas.axis(start, tip, f"${_name(i, k)}$", width=1.3)
        canvas.dot(point, INK, 4)
        thread = _beside(canvas, feet[i], LANE_PX * lanes[i])
        canvas.line(thread, ORANGE, 2.6, ":", level=4.5)
        if np.ptp(feet[i], axis=0).any():  # the perpendicular can meet the axis far from the joint
            canvas.line([point, feet[i, 1]], VIOLET, 1.0, "--", level=1.5)
            far = np.linalg.norm(feet[i, 1] - feet[i, 0])
            canvas.label(thread.mean(axis=0), f"${_name(i, k)}$: {far:.3g} m", ORANGE, LENGTH_OFFSETS, 9)
    canvas.triad(np.eye(4), "s", 0.18 * canvas.size)
    canvas.triad(chain.home, "b", 0.18 * canvas.size)
    return canvas.picture(_describe(chain, k, feet), caption)


def axis_perpendiculars(chain: Chain, k: int) -> Array:
    """Return the perpendicular from the origin of {s} or {b} to the axis of each joint at home, (n, 2, 3).

    The first k joints are given in {s}, the others in {b}. The end points are the origin and the point of the axis nearest to
    it; for a prismatic joint both are the origin.

    >>> ends = axis_perpendiculars(kl.robots.puma560(), 3)                       # the wrist, given in the tool frame
    >>> np.linalg.norm(ends[3:, 1] - ends[3:, 0], axis=-1).round(6)
    array([0., 0., 0.])
    """
    axis = chain.lines.axis
    origin = np.where(np.arange(chain.n)[:, None] < k, 0.0, chain.home[:3, 3])
    across = chain.joint_points - origin
    across = across - np.sum(across * axis, axis=-1, keepdims=True) * axis
    across[is_prismatic(chain.screws)] = 0.0
    return np.stack([origin, origin + across], axis=1)


def _lanes(feet: Array) -> list[int]:
    """Return for each perpendicular how many earlier ones it would cover: those from the same origin in the same direction."""
    across = feet[:, 1] - feet[:, 0]
    lengths = np.linalg.norm(across, axis=-1, keepdims=True)
    directions = np.divide(across, lengths, out=np.zeros_like(across), where=lengths > 0)
    same = (directions @ directions.T > 1 - 1e-9) & (np.abs(feet[:, None, 0] - feet[None, :, 0]).max(axis=-1) < 1e-9)
    return [int(same[i, :i].sum()) for i in range(len(feet))]


def _name(i: int, k: int) -> str:
    return f"{'S' if i < k else 'B'}_{i + 1}"


def _describe(chain: Chain, k: int, feet: Array) -> str:
    prismatic = is_prismatic(chain.screws)
    far = np.linalg.norm(feet[:, 1] - feet[:, 0], axis=-1)
    axes = [f"{_name(i, k)} {'prismatic' if prismatic[i] else f'at {far[i]:.3g} m'}" for i in range(chain.n)]
    sides = [("s", axes[:k]), ("b", axes[k:])]
    return " ".join(
        [f"{chain.name} at home.", *(f"Read from {{{frame}}}: {', '.join(names)}." for frame, names in sides if names)]
    )


def _beside(canvas: Canvas, line: Array, pixels: float) -> Array:
    """Move a line (m, 3) sideways on the sheet, so that lines that cover each other can be drawn side by side."""
    right, up = canvas.along(line[0], line[-1])
    return np.asarray(line + (pixels / canvas.pixels_per_metre) * (np.array([-up, right]) @ canvas.sheet_axes))
