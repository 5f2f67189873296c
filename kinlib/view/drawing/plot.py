"""Plots of curves, with matplotlib: lines differ by dash and marker as well as by colour, and each plot has a text alternative."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.view.drawing.figure_colours import INK
from kinlib.view.drawing.picture import Picture, picture_from_figure

CURVE_STYLES = (
    ("#7d3ac1", "-", "o"),
    ("#b35900", "--", "s"),
    ("#0b5cad", ":", "^"),
    ("#1f2328", "-.", "D"),
    ("#1a7f37", "-", "x"),
)


def plot(
    x: ArrayLike,
    curves: Mapping[str, ArrayLike],
    *,
    xlabel: str,
    ylabel: str,
    alt: str,
    log: str = "",
    mark: float | None = None,
    caption: str = "",
) -> Picture:
    """Plot named curves over common values of x.

    log    the axes with a logarithmic scale: "", "x", "y" or "xy"
    mark   a value of x to mark by a vertical line

    Raises ValueError if a curve does not have as many values as x, if there are more curves than line styles, if log is not
    one of these, or if the text alternative is too short.

    >>> plot([0, 1, 2], {"square": [0, 1, 4]}, xlabel="x", ylabel="y", alt="A parabola through 0, 1 and 4.").alt
    'A parabola through 0, 1 and 4.'
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    x = np.asarray(x, dtype=float)
    if len(curves) > len(CURVE_STYLES):
        raise ValueError(
            f"curves must have at most {len(CURVE_STYLES)} entries, one per line style; got {len(curves)}. Draw two figures."
        )
    if log not in {"", "x", "y", "xy"}:
        raise ValueError(f"log must be '', 'x', 'y' or 'xy'; got {log!r}.")
    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    with rc_context({"axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK}):
        axes = figure.subplots()
    for (name, y), (colour, dash, marker) in zip(curves.items(), CURVE_STYLES, strict=False):
        if np.shape(y) != x.shape:
            raise ValueError(f"curve {name!r} must have the shape of x, {x.shape}; got {np.shape(y)}.")
        looks: dict[str, Any] = {"color": colour, "linestyle": dash, "marker": marker, "markersize": 5, "label": name}
        axes.plot(x, np.asarray(y, dtype=float), markevery=max(1, len(x) // 12), **looks)
    if mark is not None:
        axes.axvline(mark, color="#8c959f", linestyle=(0, (2, 2)), linewidth=1)
    scales = {f"{side}scale": "log" for side in log}
    axes.set(xlabel=xlabel, ylabel=ylabel, **scales)
    axes.grid(alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)
    if len(curves) > 1:
        axes.legend(frameon=False, labelcolor=INK)
    return picture_from_figure(figure, alt, caption)
