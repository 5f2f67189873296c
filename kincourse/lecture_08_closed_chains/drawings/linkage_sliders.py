"""Sliders through the configurations of a linkage: assembly modes and gaps, and a curve of configurations beside its torus.

Each call computes the text alternative, the caption and the scale, so that a cell of the lecture contains only the mathematics. The
linkage itself is drawn by `kinlib.view.figures.linkage`.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kincourse.lecture_08_closed_chains.drawings.torus import draw_torus, side_by_side
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.angles import wrap_angle
from kinlib.view import draw_linkage, slide
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.linkage import linkage_geometry
from kinlib.view.viewer.pictures import Pictures


def slide_linkage(
    mechanism: Mechanism,
    configurations: ArrayLike,
    label: str,
    values: Sequence[Any],
    *,
    captions: Sequence[str] = (),
    ghosts: ArrayLike | None = None,
    names: bool = True,
    after: Any = None,
    start: int = 0,
) -> Pictures:
    """Show a linkage in several configurations, in which its loops need not be closed, all at the same scale.

    configurations  (m, n) joint values, one configuration for each of the values
    captions        a caption for each of the values
    ghosts          (m, n) or (n,) configurations drawn in grey, such as another assembly mode
    names           whether joints are labelled

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage = four_bar(0.5, 0.3, 0.3, 0.3)
    >>> modes = linkage.assembly_modes(hold={"A": 1.0})
    >>> type(slide_linkage(linkage, modes, "assembly mode", [1, 2], ghosts=modes[::-1])).__name__
    'Pictures'
    """
    q = np.asarray(configurations, dtype=float)
    drawn = () if ghosts is None else np.broadcast_to(np.asarray(ghosts, dtype=float), q.shape)
    points = np.concatenate([linkage_geometry(mechanism, now).all for now in (*q, *drawn)])
    grey, texts = drawn if len(drawn) else [None] * len(q), captions or [""] * len(q)
    pictures = [
        draw_linkage(mechanism, now, ghost=ghost, around=points, names=names, caption=text)
        for now, ghost, text in zip(q, grey, texts, strict=True)
    ]
    return slide(pictures, label, values, after, start)


def slide_curve(
    mechanism: Mechanism,
    configurations: ArrayLike,
    pair: tuple[str, str],
    *,
    parts: Mapping[str, ArrayLike] | None = None,
    after: Any = None,
) -> Pictures:
    """Move a linkage along a curve, beside the square of two of its angles, on which the same curve is drawn.

    configurations  (m, n) joint values along the curve, as mechanism.trace(...).q
    pair            the names of the two angles, such as ("A", "D")
    parts           {"one mode": mask, "other mode": mask} names of parts of the curve, (m,) true where each is; by default all

    The text alternative of each picture says both angles in degrees, and so does the caption.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage = four_bar(0.4, 0.1, 0.35, 0.3)
    >>> q = linkage.trace(linkage.assembly_modes(hold={"A": 1.0})[0], points=13).q
    >>> type(slide_curve(linkage, q, ("A", "D"))).__name__
    'Pictures'
    """
    q = np.asarray(configurations, dtype=float)
    angles = q[:, [mechanism.names.index(name) for name in pair]]
    masks = {name: np.asarray(mask, dtype=bool) for name, mask in (parts or {"curve": np.ones(len(q))}).items()}
    points = np.concatenate([linkage_geometry(mechanism, now).all for now in q])

    shown = range(0, len(q), 2)  # every second configuration is near enough to the last one
    pictures = crop([draw_linkage(mechanism, q[k], around=points, size=(520, 380)) for k in shown])
    bars = dict(zip(shown, pictures, strict=True))

    def draw(k: int) -> Picture:
        here = ", ".join(f"{name} = {x:.3g}°" for name, x in zip(pair, np.degrees(wrap_angle(angles[k])), strict=True))
        curves = {name: angles[mask] for name, mask in masks.items()}
        torus = draw_torus(curves, {"now": angles[k]}, xlabel=pair[0], ylabel=pair[1])
        return side_by_side(bars[k], torus, here)

    return slide(draw, "along the curve", shown, after)
