"""The workspace of an arm, as the points that its tool reaches in many configurations."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.figure_colours import INK, VIOLET
from kinlib.view.drawing.picture import Picture, picture_from_figure


def draw_workspace(positions: Array) -> Picture:
    """Draw positions (n, 3) from the side: their height over their distance from the z axis.

    >>> draw_workspace(np.array([[3, 4, 1.0], [1, 0, 2]])).alt
    '2 positions of the tool, from the side: 1.00 to 5.00 m from the z axis, and 1.00 to 2.00 m high.'
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    radius, height = np.hypot(positions[:, 0], positions[:, 1]), positions[:, 2]
    figure = Figure(figsize=(4.2, 4.6), layout="constrained")
    with rc_context({"axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK}):
        axes = figure.subplots()
    axes.scatter(radius, height, s=3, color=VIOLET)
    axes.set(xlabel="distance from the z axis (m)", ylabel="height (m)", aspect="equal", xlim=(0, None))
    alt = (
        f"{len(positions)} positions of the tool, from the side: {radius.min():.2f} to {radius.max():.2f} m from the z axis, "
        f"and {height.min():.2f} to {height.max():.2f} m high."
    )
    return picture_from_figure(figure, alt)
