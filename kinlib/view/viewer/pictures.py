"""The player of pictures: a film (see film.py), or a slider through the pictures of several values, made by `slide`."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import traitlets

from kinlib.view.drawing.crop import crop, is_croppable
from kinlib.view.drawing.figure_colours import follow_theme
from kinlib.view.drawing.picture import Gallery, Picture, is_without_kernel
from kinlib.view.viewer.widget import Covered

ONE_PICTURE_ON_SCREEN = (
    "<style>@media screen and (scripting:enabled){.kinlib-film-frames figure:not(:first-child){display:none}"
    ".kinlib-film-frames>div{display:block!important}}</style>"
)
"""Where a script will show the pictures, the first one keeps the place; everywhere else, all of them are shown."""


class Pictures(Covered):
    """Pictures on the page, of which one is shown. Make them with `film` or `slide`.

    frames   the drawings as SVG, each once; empty for one that is made when it is selected
    order    the drawing of each stop
    texts    the caption, the text alternative and the label of each stop
    looks    "label" of the slider, "rate" in stops per second of a film, "ends" of its scenes
    at       the stop that is shown; the page and Python can both set it
    still    the pictures for print, and for a page without a script

    It is made of these, a function that draws a stop, what has been drawn already, the label of each stop, and its looks.
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
        draw: Callable[[int], Picture],
        drawn: Mapping[int, Picture],
        labels: Sequence[str],
        looks: dict[str, Any],
        **traits: Any,
    ) -> None:
        self.still, self._draw = tuple(still), draw
        texts = [{"label": label} | (_said(drawn[k]) if k in drawn else {}) for k, label in enumerate(labels)]
        # Where nothing moves, the same drawing is shown again; what has not been drawn yet gets a place of its own.
        kinds = list(dict.fromkeys(drawn[k].svg if k in drawn else k for k in range(len(labels))))
        order = [kinds.index(drawn[k].svg if k in drawn else k) for k in range(len(labels))]
        frames = [follow_theme(kind) if isinstance(kind, str) else "" for kind in kinds]
        super().__init__((texts, looks), texts=texts, looks=looks, order=order, frames=frames, **traits)
        self._fill(None)
        self.observe(self._fill, "at")

    @traitlets.validate("at")
    def _validate_at(self, proposal: Any) -> int:
        index: int = proposal["value"]
        if index not in range(len(self.order)):
            raise ValueError(f"at must be the number of a picture, 0 to {len(self.order) - 1}; got {index!r}.")
        return index

    def _fill(self, _: Any) -> None:
        """Draw the selected picture if it has not been drawn yet."""
        k = self.order[self.at]
        if not self.frames[k]:
            picture = self._draw(self.at)
            self.frames = [*self.frames[:k], follow_theme(picture.svg), *self.frames[k + 1 :]]
            self.texts = [one | (_said(picture) if i == self.at else {}) for i, one in enumerate(self.texts)]

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


def _said(picture: Picture) -> dict[str, str]:
    return {"caption": picture.caption, "alt": picture.alt}


V = TypeVar("V")


def value_text(value: Any) -> str:
    """Write the value of a slider."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def slide(
    draw: Callable[[V], Picture] | Sequence[Picture], label: str, values: Sequence[V], after: Any = None, start: int = 0
) -> Pictures:
    """Show a slider that draws a picture of the selected value.

    draw    a function from a value to a Picture, or the picture of each value
    label   what the values are
    values  the values of the slider, in order
    after   a question; the picture stays covered until a prediction is committed
    start   the index of the value that is selected first

    Drawings are made at once and cropped alike; a plot, which takes longer, is made when its value is selected.

    Raises ValueError if there are no values, or not as many pictures as values.

    >>> from kinlib.view import plot
    >>> def line(slope):
    ...     return plot([0, 1], {"line": [0, slope]}, xlabel="x", ylabel="y", alt=f"A line through 0 of slope {slope}.")
    >>> slide(line, "slope", [1, 2]).alt
    'A line through 0 of slope 1.'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    if not callable(draw) and len(draw) != len(values):
        raise ValueError(f"values must be {len(draw)} values, one for each picture; got {list(values)!r}.")
    at = (lambda index: draw(values[index])) if callable(draw) else draw.__getitem__
    drawn: dict[int, Picture] = {start: at(start)}
    if is_croppable(drawn[start]) or is_without_kernel():
        pictures = [drawn[start] if index == start else at(index) for index in range(len(values))]
        drawn = dict(enumerate(crop(pictures) if all(map(is_croppable, pictures)) else pictures))
    return Pictures([drawn[start]], at, drawn, list(map(value_text, values)), {"label": label}, at=start, after=after)
