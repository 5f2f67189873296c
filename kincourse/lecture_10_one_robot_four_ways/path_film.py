"""A joint path of the project as a film: the student's own arm drives it, above or into the table."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kincourse.lecture_10_one_robot_four_ways.paths import STEPS, JointPath
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, LINK_GREY, ORANGE, PALE_GREY
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.film import FRAMES_PER_SECOND, Film, film

TABLE_SHARE = 0.18
"""Half of the side of the table that is drawn, as a share of the size of the arm."""


def watch(path: JointPath, screws: ArrayLike | Any, home: ArrayLike | Any, points: ArrayLike | Any) -> Film | None:
    """Play a joint path of an arm that is given by its screws (n, 6), its home pose and a point (n, 3) on each axis.

    Returns None as long as one of them is `...`, because then there is no arm to draw.

    >>> from kincourse.lecture_10_one_robot_four_ways.project import open_project
    >>> watch(open_project("ada").paths["A"], ..., ..., ...) is None
    True
    """
    if any(given is ... for given in (screws, home, points)):
        return None
    arm = Chain(np.asarray(screws, dtype=float), np.asarray(home, dtype=float), np.asarray(points, dtype=float))
    lines = np.array([[np.zeros(3), *arm.link_poses(q)[:, :3, 3], arm.fk(q)[:3, 3]] for q in path.q])
    tips = lines[:, -1]
    table = _table(tips, path.table_m, TABLE_SHARE * float(np.ptp(lines, axis=(0, 1)).max()))
    around = np.concatenate([lines.reshape(-1, 3), table])
    seconds = STEPS / FRAMES_PER_SECOND

    def draw(t: float) -> Picture:
        k = min(STEPS - 1, round(t / seconds * (STEPS - 1)))
        canvas = Canvas(around)
        canvas.floor(around)
        canvas.body(table, PALE_GREY, level=1.5, edge=GREY)
        canvas.line(lines[k], LINK_GREY, 6)
        for joint in lines[k, 1:-1]:
            canvas.dot(joint, LINK_GREY, 12)
        canvas.line(tips[: k + 1], ORANGE, 2.2, level=4)
        canvas.dot(tips[k], INK, 7)
        above = 1000 * (tips[k, 2] - path.table_m)
        canvas.label(tips[k], f"{above + 0.0:.0f} mm", INK)
        return canvas.picture(f"The pen is {above + 0.0:.0f} mm above the table.")

    return film(draw, [(seconds, "Your arm drives this path. The number at the pen is its height above the table.")])


def _table(tips: Array, height: float, half: float) -> Array:
    """The corners of the piece of table that is drawn, below all places of the pen."""
    low, high = tips.min(axis=0) - half, tips.max(axis=0) + half
    return np.array(
        [(x, y, height) for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))]
    )
