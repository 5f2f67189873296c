"""Films: a short motion as drawings that a reader plays, stops and leafs through, in a notebook and on a page without a kernel.

A film is a function from the time to a Picture, and scenes with a caption each. Each scene has a key frame, its last one. The key
frames are what is printed, what a page without a script shows, and what Play steps through for readers who prefer reduced
motion; their text alternatives together tell the film. It never begins by itself.
"""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import traitlets

from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.dark_theme import follow_theme
from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.viewer.cell_memory import keep_in_cell
from kinlib.view.viewer.viewer import PageWidget, as_script

FRAMES_PER_SECOND = 6

MAX_SECONDS = 60
"""A longer film is a lecture."""

ONE_FRAME_ON_SCREEN = (
    "<style>@media screen and (scripting:enabled){.kinlib-film-frames figure:not(:first-child){display:none}"
    ".kinlib-film-frames>div{display:block!important}}</style>"
)
"""Where a script will play the film, its first key frame keeps the place; everywhere else, all of them are shown."""


class Film(PageWidget):
    """A film on the page. Make one with `film`.

    frames  the drawings as SVG, each once
    order   the drawing that is shown at each tick, and `rate` the ticks per second
    scenes  for each scene its last tick, its caption and its text alternative
    at      the tick that is shown; the page and Python can both set it

    >>> from tempfile import TemporaryDirectory
    >>> from kinlib.view.drawing.canvas import Canvas
    >>> canvas = Canvas([(0, 0, 0), (2, 0, 0)], view="front")
    >>> canvas.dot((1, 0, 0))
    >>> still = film(lambda t: canvas.picture("A point at x = 1 m on a line."), [(1.0, "Nothing moves.")])
    >>> "A point at x = 1 m" in still.html()
    True
    >>> with TemporaryDirectory() as folder:
    ...     still.save(Path(folder) / "film.html")
    ...     [path.name for path in Path(folder).iterdir()]
    ['film.html']
    """

    frames = traitlets.List(traitlets.Unicode()).tag(sync=True)
    order = traitlets.List(traitlets.Int()).tag(sync=True)
    scenes = traitlets.List(traitlets.Dict()).tag(sync=True)
    rate = traitlets.Float().tag(sync=True)
    at = traitlets.Int(0).tag(sync=True)

    def __init__(self, key_frames: Sequence[Picture], **traits: Any) -> None:
        self.key_frames = tuple(key_frames)
        super().__init__(**traits)
        keep_in_cell(self, ["at"], (self.scenes, self.order))

    @traitlets.validate("at")
    def _validate_at(self, proposal: Any) -> int:
        index: int = proposal["value"]
        if index not in range(len(self.order)):
            raise ValueError(f"at must be the number of a frame, 0 to {len(self.order) - 1}; got {index!r}.")
        return index

    @property
    def alt(self) -> str:
        """The text alternative of the whole film: what its key frames show, in order."""
        return " ".join(picture.alt for picture in self.key_frames)

    def html(self) -> str:
        """Return the film for a page without a kernel: its frames as JSON, and its key frames, of which a script makes a player."""
        state = {"frames": self.frames, "order": self.order, "scenes": self.scenes, "rate": self.rate, "at": 0}
        return (
            f'<div data-kinlib-film>{as_script(state)}<div class="kinlib-film-frames" data-kinlib-drawing>'
            f"{ONE_FRAME_ON_SCREEN}{Gallery(self.key_frames).html()}</div></div>"
        )

    def save(self, path: str | Path) -> None:
        """Save the key frames with their text alternatives as a page, .html.

        Raises ValueError for another ending.
        """
        Gallery(self.key_frames).save(path)


def film(draw: Callable[[float], Picture], scenes: Sequence[tuple[float, str]]) -> Film:
    """Make a film of drawings.

    draw    a function from the time in seconds to a Picture, all of the same canvas
    scenes  (duration in seconds, caption) of each scene, in order

    The text alternative of a scene is its caption and the alt of the picture at its end.

    Raises ValueError if there is no scene, if a scene takes no time, or if all of them take more than a minute.

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
    if not len(durations) or durations.min() <= 0 or durations.sum() > MAX_SECONDS:
        raise ValueError(
            f"scenes must take more than 0 and at most {MAX_SECONDS} seconds in all, each more than 0; got {durations.tolist()}."
        )
    ends = np.round(np.cumsum(durations) * FRAMES_PER_SECOND).astype(int)
    pictures = crop([draw(k / FRAMES_PER_SECOND) for k in range(ends[-1] + 1)])
    captions = [caption for _, caption in scenes]
    keys = [
        Picture(pictures[end].svg, f"{caption} {pictures[end].alt}", caption)
        for end, caption in zip(ends, captions, strict=True)
    ]
    # Where nothing moves, the same drawing is shown again.
    drawn = list(dict.fromkeys(picture.svg for picture in pictures))
    return Film(
        keys,
        frames=list(map(follow_theme, drawn)),
        order=[drawn.index(picture.svg) for picture in pictures],
        scenes=[
            {"end": int(end), "caption": picture.caption, "alt": picture.alt}
            for end, picture in zip(ends, keys, strict=True)
        ],
        rate=float(FRAMES_PER_SECOND),
    )


def share(t: float, start: float, end: float) -> float:
    """Return how much of a motion from one time to another has been made at t, from 0 to 1, with a gentle start and end.

    >>> share(0, 1, 2), share(1.5, 1, 2), share(9, 1, 2)
    (0.0, 0.5, 1.0)
    """
    x = min(1.0, max(0.0, (t - start) / (end - start)))
    return x * x * (3 - 2 * x)
