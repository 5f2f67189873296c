"""Plots of curves, with matplotlib: lines differ by dash and marker as well as by colour, and each plot has a text alternative."""

import io
from collections.abc import Mapping
from itertools import cycle
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.view.drawing.figure_colours import INK
from kinlib.view.drawing.picture import Picture

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
    caption: str = "",
) -> Picture:
    """Plot named curves over common values of x.

    log  the axes with a logarithmic scale: "", "x", "y" or "xy"

    Raises ValueError if a curve does not have as many values as x, or if the text alternative is too short.

    >>> plot([0, 1, 2], {"square": [0, 1, 4]}, xlabel="x", ylabel="y", alt="A parabola through 0, 1 and 4.").alt
    'A parabola through 0, 1 and 4.'
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    with rc_context({"axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK}):
        axes = figure.subplots()
    for (name, y), (colour, dash, marker) in zip(curves.items(), cycle(CURVE_STYLES), strict=False):
        looks: dict[str, Any] = {"color": colour, "linestyle": dash, "marker": marker, "markersize": 5, "label": name}
        axes.plot(np.asarray(x), np.asarray(y), markevery=max(1, np.size(x) // 12), **looks)
    scales = {f"{side}scale": "log" for side in log}
    axes.set(xlabel=xlabel, ylabel=ylabel, **scales)
    axes.grid(alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)
    if len(curves) > 1:
        axes.legend(frameon=False, labelcolor=INK)
    return picture_from_figure(figure, alt, caption)


def picture_from_figure(figure: Any, alt: str, caption: str = "") -> Picture:
    """Convert a matplotlib figure to a picture. Make the figure without pyplot, so that none is left open."""
    from matplotlib import rc_context

    buffer = io.StringIO()
    # With a fixed salt and no date, the same drawing always gives the same SVG text.
    with rc_context({"svg.hashsalt": "kinlib", "svg.fonttype": "path"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None}, facecolor="white")
    return Picture(buffer.getvalue(), alt, caption)
