"""The player of pictures: a film (see film.py), or a slider through the pictures of several values, made by `slide`."""

from collections.abc import Callable, Sequence
from typing import Any

import traitlets

from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.figure_colours import follow_theme
from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.viewer.widget import Covered

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

    @traitlets.validate("at")
    def _validate_at(self, proposal: Any) -> int:
        index: int = proposal["value"]
        if index not in range(len(self.order)):
            raise ValueError(f"at must be the number of a picture, 0 to {len(self.order) - 1}; got {index!r}.")
        return index

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
