"""A slider through configurations of a linkage, such as its assembly modes, or steps in which its loops are not closed yet."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.mechanisms.mechanism import Mechanism
from kinlib.view import draw_linkage, slide
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

    >>> linkage = kl.linkages.four_bar(0.5, 0.3, 0.3, 0.3)
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
