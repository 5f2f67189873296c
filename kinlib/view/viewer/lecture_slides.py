"""Sliders through pictures of one kind, each in one call: axes of an arm, linkages, the mid-formula form, a DH offset.

Each call computes the text alternative, the caption and the scale, so that a cell of a lecture contains only the mathematics.
`slide` in picture_slider.py takes any function from a value to a picture.
"""

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.angles import wrap_angle
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import direction_text, draw_arm
from kinlib.view.figures.dh_table import draw_table
from kinlib.view.figures.linkage import draw_linkage, linkage_geometry
from kinlib.view.figures.mid_formula import draw_mid_formula
from kinlib.view.figures.torus import draw_torus, side_by_side
from kinlib.view.viewer.picture_slider import slide

V = TypeVar("V")


def slide_axis(
    chain: Chain,
    joint: int,
    configurations: ArrayLike,
    label: str,
    values: Sequence[V],
    *,
    ghost: ArrayLike | None = None,
    after: Any = None,
    start: int = 0,
) -> widgets.Widget:
    """Show an arm in several configurations, and the screw axis of one joint in each, as {s} and as {b} read it.

    joint           the joint whose axis is written in the caption, counted from 1
    configurations  (m, n) joint values, one configuration for each of the values
    ghost           (n,) another configuration, drawn in grey

    The screw in {s} is column `joint` of chain.jacobian(q), that in {b} the same column of chain.body_jacobian(q).

    Raises ValueError if there are not as many configurations as values, or the arm does not have the joint.

    >>> from kinlib.chains.robots import mid_formula_arm
    >>> q = np.radians([[degrees, 0, 0, 0] for degrees in (0, 45, 90)])
    >>> type(slide_axis(mid_formula_arm(), 3, q, "joint 1 (degrees)", [0, 45, 90])).__name__
    'VBox'
    """
    if joint not in range(1, chain.n + 1):
        raise ValueError(f"{chain.name} has joints 1 to {chain.n}; got {joint!r}.")
    q = validation.vectors(configurations, "configurations", chain.n)
    by_value = _by_value(q, values)
    points = np.concatenate([np.zeros((1, 3)), chain.fk(q)[:, :3, 3], chain.link_poses(q)[..., :3, 3].reshape(-1, 3)])

    def draw(value: V) -> Picture:
        now = by_value[value]
        return draw_arm(chain, now, ghost=ghost, around=points, caption=axis_caption(chain, joint, now))

    return slide(draw, label, values, after, start)


def axis_caption(chain: Chain, joint: int, q: Array) -> str:
    """Write the screw axis of a joint at q as {s} and as {b} read it.

    >>> from kinlib.chains.robots import rpr
    >>> axis_caption(rpr(), 1, np.zeros(3))
    'Axis 1 in {s}: (0, -1, 0, 0, 0, 4). In {b}: (0, 0, -1, 4, -1, 0).'
    """
    space, body = (jacobian(q)[:, joint - 1] for jacobian in (chain.jacobian, chain.body_jacobian))
    return f"Axis {joint} in {{s}}: {vector_text(space)}. In {{b}}: {vector_text(body)}."


def slide_mid_formula(chain: Chain, q: ArrayLike, *, after: Any = None, start: int = 0) -> widgets.Widget:
    """Show the mid-formula form with M after joint 0, 1, ..., n: e^[S1]q1 ... e^[Sk]qk M e^[Bk+1]qk+1 ... e^[Bn]qn.

    q  (n,) the joint values at which the position of the end-effector is written in the caption

    The caption gives the form, the position of the end-effector, which is the same for every k, and how many of the entries of
    the screws are not 0.

    >>> from kinlib.chains.robots import mid_formula_arm
    >>> type(slide_mid_formula(mid_formula_arm(), [0.5, -0.3, 0.8, 0.4])).__name__
    'VBox'
    """
    values = validation.vectors(q, "q", chain.n)

    def draw(k: int) -> Picture:
        factors = [f"e^[{'S' if i <= k else 'B'}{i}]q{i}" for i in range(1, chain.n + 1)]
        form = " ".join([*factors[:k], "M", *factors[k:]])
        tool = vector_text(chain.fk_mid(values, k)[:3, 3])
        entries = np.count_nonzero(np.vstack([chain.screws[:k], chain.body_screws[k:]]).round(9))
        return draw_mid_formula(
            chain, k, f"T = {form}. End-effector at {tool} m. Entries of the screws that are not 0: {entries}."
        )

    return slide(draw, "joints before M: k", range(chain.n + 1), after, start)


def slide_offset(
    table: DHTable, row: int, degrees: Sequence[float], *, after: Any = None, start: int = 0
) -> widgets.Widget:
    """Show the arm of a DH table at q = 0 with several offsets in theta of one row.

    row      the row whose theta is replaced, counted from 1
    degrees  the offsets, in degrees

    The caption says along which direction z of the last frame points.

    Raises ValueError if the table does not have the row.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> table = assign_frames(youbot(), convention="standard").table
    >>> type(slide_offset(table, 4, range(0, 181, 90))).__name__
    'VBox'
    """
    if row not in range(1, table.n + 1):
        raise ValueError(f"{table.name} has rows 1 to {table.n}; got {row!r}.")

    def with_offset(angle: float) -> DHTable:
        rows = table.rows.copy()
        rows[row - 1, 3] = np.radians(angle)
        return table.changed(rows=rows, name=f"{table.name} with the offset {angle:g} degrees in row {row}")

    q = np.zeros(table.n)
    tables = {angle: with_offset(angle) for angle in degrees}
    chains = [other.to_chain() for other in tables.values()]
    points = np.concatenate([[np.zeros(3), arm.fk(q)[:3, 3], *arm.link_poses(q)[:, :3, 3]] for arm in chains])

    def draw(angle: float) -> Picture:
        z = direction_text(tables[angle].fk(q)[:3, 2])
        return draw_table(
            tables[angle], around=points, caption=f"q = 0. The z axis of the end-effector points along {z}."
        )

    return slide(draw, f"offset in row {row} (degrees)", degrees, after, start)


def slide_linkage(
    mechanism: Mechanism,
    configurations: ArrayLike,
    label: str,
    values: Sequence[V],
    *,
    captions: Sequence[str] = (),
    ghosts: ArrayLike | None = None,
    names: bool = True,
    after: Any = None,
    start: int = 0,
) -> widgets.Widget:
    """Show a linkage in several configurations, in which its loops need not be closed, all at the same scale.

    configurations  (m, n) joint values, one configuration for each of the values
    captions        a caption for each of the values
    ghosts          (m, n) or (n,) configurations drawn in grey, such as another assembly mode
    names           whether joints are labelled

    Raises ValueError if there are not as many configurations, captions or ghosts as values.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage = four_bar(0.5, 0.3, 0.3, 0.3)
    >>> modes = linkage.assembly_modes(hold={"A": 1.0})
    >>> type(slide_linkage(linkage, modes, "assembly mode", [1, 2], ghosts=modes[::-1])).__name__
    'VBox'
    """
    q = validation.vectors(configurations, "configurations", mechanism.n)
    by_value = _by_value(q, values)
    grey = None if ghosts is None else np.broadcast_to(validation.vectors(ghosts, "ghosts", mechanism.n), q.shape)
    ghost_of = {} if grey is None else _by_value(grey, values)
    caption_of = _by_value(list(captions), values) if captions else {}
    points = np.concatenate([linkage_geometry(mechanism, now).all for now in (*q, *(() if grey is None else grey))])

    def draw(value: V) -> Picture:
        return draw_linkage(
            mechanism,
            by_value[value],
            ghost=ghost_of.get(value),
            around=points,
            names=names,
            caption=caption_of.get(value, ""),
        )

    return slide(draw, label, values, after, start)


def slide_curve(
    mechanism: Mechanism,
    configurations: ArrayLike,
    pair: tuple[str, str],
    *,
    parts: Mapping[str, ArrayLike] | None = None,
    captions: Sequence[str] = (),
    step: int = 2,
    after: Any = None,
    start: int = 0,
) -> widgets.Widget:
    """Move a linkage along a curve, beside the square of two of its angles, on which the same curve is drawn.

    configurations  (m, n) joint values along the curve, as mechanism.trace(...).q
    pair            the names of the two angles, such as ("A", "D")
    parts           {"one mode": mask, "other mode": mask} names of parts of the curve, (m,) true where each is; by default all
    captions        a caption for each configuration
    step            the slider shows every step-th configuration

    The text alternative of each picture says both angles in degrees, and so does the caption if none is given.

    Raises ValueError if the linkage has no joint value of a given name, or a part or the captions do not have m entries.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage = four_bar(0.4, 0.1, 0.35, 0.3)
    >>> q = linkage.trace(linkage.assembly_modes(hold={"A": 1.0})[0], points=13).q
    >>> type(slide_curve(linkage, q, ("A", "D"))).__name__
    'VBox'
    """
    q = validation.vectors(configurations, "configurations", mechanism.n)
    if unknown := [name for name in pair if name not in mechanism.names]:
        raise ValueError(f"{mechanism.name} has joint values {', '.join(mechanism.names)}; got {unknown[0]!r}.")
    angles = q[:, [mechanism.names.index(name) for name in pair]]
    masks = {name: np.asarray(mask, dtype=bool) for name, mask in (parts or {"curve": np.ones(len(q))}).items()}
    if wrong := [name for name, mask in masks.items() if mask.shape != (len(q),)]:
        raise ValueError(f"part {wrong[0]!r} must have shape ({len(q)},); got {masks[wrong[0]].shape}.")
    if captions and len(captions) != len(q):
        raise ValueError(f"captions must have one entry per configuration, {len(q)}; got {len(captions)}.")
    points = np.concatenate([linkage_geometry(mechanism, now).all for now in q])

    shown = range(0, len(q), step)
    bars = _by_value(crop([draw_linkage(mechanism, q[k], around=points, size=(520, 380)) for k in shown]), shown)

    def draw(k: int) -> Picture:
        here = ", ".join(f"{name} = {x:.3g}°" for name, x in zip(pair, np.degrees(wrap_angle(angles[k])), strict=True))
        curves = {name: angles[mask] for name, mask in masks.items()}
        torus = draw_torus(curves, {"now": angles[k]}, xlabel=pair[0], ylabel=pair[1])
        return side_by_side(bars[k], torus, captions[k] if captions else here)

    return slide(draw, "along the curve", shown, after, start)


def _by_value(things: Sequence[Any] | Array, values: Sequence[V]) -> dict[V, Any]:
    """Return {value: thing}. Raises ValueError if there are not as many things as values, or two values are equal."""
    if len(things) != len(values) or len(set(values)) != len(values):
        raise ValueError(f"values must be {len(things)} different values, one for each picture; got {list(values)!r}.")
    return dict(zip(values, things, strict=True))
