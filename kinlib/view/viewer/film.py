"""Films: a short motion as drawings that a reader plays, stops and leafs through, in a notebook and on a page without a kernel.

Each scene has a key frame, its last one. The key frames are what is printed, what a page without a script shows, and what Play steps
through for readers who prefer reduced motion; their text alternatives together tell the film. It never begins by itself.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture
from kinlib.view.viewer.pictures import Pictures

FRAMES_PER_SECOND = 6

Film = Pictures


def film(draw: Callable[[float], Picture], scenes: Sequence[tuple[float, str]]) -> Film:
    """Make a film of drawings.

    draw    a function from the time in seconds to a Picture, all of the same canvas
    scenes  (duration in seconds, caption) of each scene, in order; its text alternative is this caption and that of its last picture

    >>> from kinlib.view.drawing.canvas import Canvas
    >>> def draw(t):
    ...     canvas = Canvas([(0, 0, 0), (2, 0, 0)], view="front")
    ...     canvas.dot((t, 0, 0))
    ...     return canvas.picture(f"A point at x = {t:.2f} m on a line.")
    >>> moving = film(draw, [(1.0, "A point moves to the right."), (1.0, "Where does it stop?")])
    >>> len(moving.order), moving.alt[:66]
    (13, 'A point moves to the right. A point at x = 1.00 m on a line. Where')
    """
    durations = np.array([duration for duration, _ in scenes], dtype=float)
    ends = np.round(np.cumsum(durations) * FRAMES_PER_SECOND).astype(int).tolist()
    pictures = crop([draw(k / FRAMES_PER_SECOND) for k in range(ends[-1] + 1)])
    keys = [
        replace(pictures[end], alt=f"{caption} {pictures[end].alt}", caption=caption)
        for end, (_, caption) in zip(ends, scenes, strict=True)
    ]
    # the text of a picture is that of its scene
    told = [keys[int(np.searchsorted(ends, k))] for k in range(len(pictures))]
    shown = [replace(one, alt=key.alt, caption=key.caption) for one, key in zip(pictures, told, strict=True)]
    labels = [f"{k / FRAMES_PER_SECOND:.0f} of {durations.sum():.0f} s" for k in range(len(pictures))]
    looks = {"label": "Time", "rate": FRAMES_PER_SECOND, "ends": ends}
    return Film(keys, shown, labels, looks)


def share(t: float, start: float, end: float) -> float:
    """Return how much of a motion from one time to another has been made at t, from 0 to 1, with a gentle start and end."""
    x = min(1.0, max(0.0, (t - start) / (end - start)))
    return x * x * (3 - 2 * x)
