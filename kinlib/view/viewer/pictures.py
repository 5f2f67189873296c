"""The player of pictures: a film, or a slider through the pictures of several values.

Each scene of a film has a key frame, its last one. The key frames are what is printed, what a page without a script shows, and what
Play steps through for readers who prefer reduced motion; their text alternatives together tell the film. It never begins by itself.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import traitlets

from kinlib.view.drawing.figure_colours import follow_theme
from kinlib.view.drawing.picture import Gallery, Picture, crop
from kinlib.view.viewer.widget import Covered

FRAMES_PER_SECOND = 6

ONE_PICTURE_ON_SCREEN = (
    "<style>@media screen and (scripting:enabled){.kinlib-film-frames figure:not(:first-child){display:none}"
    ".kinlib-film-frames>div{display:block!important}}</style>"
)
"""Where a script will show the pictures, the first one keeps the place; everywhere else, all of them are shown."""


class Pictures(Covered):
    """Pictures on the page, of which one is shown. Make them with `film` or `slide`.

    frames   the drawings as SVG, each once
    order    the drawing of each stop
    texts    the caption, the text alternative and the label of each stop
    looks    "label" of the slider, "rate" in stops per second of a film, "ends" of its scenes
    at       the stop that is shown; the page and Python can both set it
    still    the pictures for print, and for a page without a script

    It is made of the still pictures, the picture and the label of each stop, and its looks.
    """

    frames = traitlets.List(traitlets.Unicode()).tag(sync=True)
    order = traitlets.List(traitlets.Int()).tag(sync=True)
    texts = traitlets.List(traitlets.Dict()).tag(sync=True)
    looks = traitlets.Dict().tag(sync=True)
    at = traitlets.Int(0).tag(sync=True)
    set_by_reader = ("at",)

    def __init__(
        self,
        still: Sequence[Picture],
        pictures: Sequence[Picture],
        labels: Sequence[str],
        looks: dict[str, Any],
        **traits: Any,
    ) -> None:
        self.still = tuple(still)
        told = zip(labels, pictures, strict=True)
        texts = [{"label": label, "caption": picture.caption, "alt": picture.alt} for label, picture in told]
        frames = list(dict.fromkeys(picture.svg for picture in pictures))  # where nothing moves, one is shown again
        order = [frames.index(picture.svg) for picture in pictures]
        shown = {"order": order, "frames": list(map(follow_theme, frames))}
        super().__init__((texts, looks), texts=texts, looks=looks, **shown, **traits)

    @property
    def alt(self) -> str:
        """The text alternative of the whole: what the still pictures show, in order."""
        return " ".join(picture.alt for picture in self.still)

    def html(self, whole: bool = True) -> str:
        """Return the pictures for a page without a kernel: as JSON, and the still ones, of which a script makes a player."""
        names = ["frames", "order", "texts", "looks", "at", "covered"]
        still = f'<div class="kinlib-film-frames">{ONE_PICTURE_ON_SCREEN}{Gallery(self.still).html()}</div>'
        return self.on_page("film", self.get_state(names), still)

    def save(self, path: Any) -> None:
        """Save the still pictures with their text alternatives as a page, .html.

        Raises ValueError for another ending.
        """
        Gallery(self.still).save(path)


def value_text(value: Any) -> str:
    """Write the value of a slider."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def slide(
    draw: Callable[[Any], Picture] | Sequence[Picture],
    label: str,
    values: Sequence[Any],
    after: Any = None,
    start: int = 0,
) -> Pictures:
    """Show a slider that draws a picture of the selected value.

    draw    a function from a value to a Picture, or the picture of each value
    label   what the values are
    values  the values of the slider, in order
    after   a question; the picture stays covered until a prediction is committed
    start   the index of the value that is selected first

    Drawings are cropped alike.

    Raises ValueError if there are no values.

    >>> from kinlib.view import plot
    >>> def line(slope):
    ...     return plot([0, 1], {"line": [0, slope]}, xlabel="x", ylabel="y", alt=f"A line through 0 of slope {slope}.")
    >>> slide(line, "slope", [1, 2]).alt
    'A line through 0 of slope 1.'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    pictures = crop([draw(value) for value in values] if callable(draw) else draw)
    labels = list(map(value_text, values))
    return Pictures([pictures[start]], pictures, labels, {"label": label}, at=start, after=after)


def film(draw: Callable[[float], Picture], scenes: Sequence[tuple[float, str]]) -> Pictures:
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
    shown = [replace(keys[int(np.searchsorted(ends, k))], svg=one.svg) for k, one in enumerate(pictures)]
    labels = [f"{k / FRAMES_PER_SECOND:.0f} of {durations.sum():.0f} s" for k in range(len(pictures))]
    looks = {"label": "Time", "rate": FRAMES_PER_SECOND, "ends": ends}
    return Pictures(keys, shown, labels, looks)


def share(t: float, start: float, end: float) -> float:
    """Return how much of a motion from one time to another has been made at t, from 0 to 1, with a gentle start and end."""
    x = min(1.0, max(0.0, (t - start) / (end - start)))
    return x * x * (3 - 2 * x)
