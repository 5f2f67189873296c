"""The opening film: an arm is built from the lines of a file, one joint after the other."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GHOST_GREY, INK, LINK_GREY
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.viewer.pictures import Pictures, film, share

LINES = (
    ("column", (0.0, 0.0, 0.5), (0.0, 0.0, 0.5)),
    ("boom", (0.2, 0.0, 0.3), (1.5708, 0.0, 0.0)),
    ("rod", (0.6, 0.1, 0.0), (0.0, 0.0, -0.8)),
    ("hand", (0.4, 0.0, 0.0), (0.0, 1.5708, 0.0)),
)
"""The name, xyz and rpy of each joint."""

EACH_S = 1.5
AROUND = np.array([(-0.2, -0.5, 0), (1.3, 0.9, 1.3)])


def opening() -> Pictures:
    """Play how an arm grows from the lines of a file, and how it changes with one number."""
    grown = EACH_S * len(LINES)

    def draw(t: float) -> Picture:
        parts = [share(t, k * EACH_S, k * EACH_S + 1) for k in range(min(len(LINES), int(t / EACH_S) + 1))]
        return _draw(parts, share(t, grown + 1.5, grown + 3.5))

    return film(
        draw,
        [
            (grown, "A file has one line for each joint: six numbers, which place its frame in the frame before."),
            (1.5, "All lines are read, and the arm is complete."),
            (3.0, "Now a single number in the file is changed, and no program complains. Which line was it?"),
        ],
    )


def draw_changed() -> Picture:
    """Draw the last picture of the film: the arm of the changed file and, in grey, the arm as it was."""
    return _draw([1.0] * len(LINES), 1.0)


def _draw(parts: list[float], changed: float) -> Picture:
    """Draw the first joints of the arm, each to a share of its length, after a share of the change."""
    right, bent, shown = _frames(0.0), _frames(changed), len(parts)
    canvas = Canvas(AROUND)
    canvas.floor(AROUND)
    if changed:
        canvas.line(right[:, :3, 3], GHOST_GREY, 5, level=1)
    for k, part in enumerate(parts):
        start, end = bent[k, :3, 3], bent[k + 1, :3, 3]
        canvas.line([start, start + part * (end - start)], LINK_GREY, 6)
        if part == 1:
            canvas.triad(bent[k + 1], "", 0.15)
            canvas.label(end, LINES[k][0], INK)
    canvas.triad(np.eye(4), "base", 0.15)
    tip = bent[shown, :3, 3]
    grey = " In grey, the arm as it was." if changed else ""
    return canvas.picture(
        f"{shown} of {len(LINES)} joints; the last frame is at {vector_text(tip)} from the base.{grey}"
    )


def _frames(changed: float) -> Array:
    """The frames of the joints in the base, the base first; the share of a fault in one line."""
    frames = [np.eye(4)]
    for k, (_, xyz, rpy) in enumerate(LINES):
        angles = np.array(rpy) + (np.array([0.0, 0.0, 1.6 * changed]) if k == 2 else 0.0)
        frames.append(frames[-1] @ origin(xyz, angles))
    return np.array(frames)
