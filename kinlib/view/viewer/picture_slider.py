"""A slider through the pictures of several values, covered until a prediction is committed.

`slide` takes any list of values. It stays covered until the question given as `after` is committed, because students learn
more from an observation if they have predicted it. For the joints of an arm, use the viewer (`explore`).
"""

from collections.abc import Callable, Sequence
from html import escape
from typing import Any, TypeVar

import ipywidgets as widgets

from kinlib.view.drawing.crop import crop, is_croppable
from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.static_page import is_without_kernel
from kinlib.view.viewer.cell_memory import keep_in_cell

PAPER, INK = "var(--jp-layout-color1,#fff)", "var(--jp-content-font-color1,#1f2328)"
"""The colours of JupyterLab's theme, light or dark; a page without them is light."""
NOTE_STYLE = (
    f"border-left:5px solid #0b5cad;background:color-mix(in srgb,#0b5cad 8%,{PAPER});color:{INK};"
    "padding:.6em 1em;margin:.4em 0;max-width:46em"
)
NOT_RECORDED = (
    f'<div role="status" style="{NOTE_STYLE}"><p style="margin:0;font-weight:600;color:color-mix(in srgb,#0b5cad 50%,{INK})">'
    '<span aria-hidden="true">i</span> Shown without a prediction</p>'
    '<p style="margin:.4em 0 0">Nothing was recorded. You can still commit to one above.</p></div>'
)
"""A framed note with an icon, in the colours of the notes in the course's feedback."""

V = TypeVar("V")


def slide(
    draw: Callable[[V], Picture] | Sequence[Picture], label: str, values: Sequence[V], after: Any = None, start: int = 0
) -> widgets.Widget:
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
    >>> type(slide(line, "slope", [1, 2])).__name__
    'VBox'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    if not callable(draw) and len(draw) != len(values):
        raise ValueError(f"values must be {len(draw)} values, one for each picture; got {list(values)!r}.")
    at = (lambda index: draw(values[index])) if callable(draw) else draw.__getitem__
    options = [
        (f"{value:.4g}" if isinstance(value, float) else str(value), index) for index, value in enumerate(values)
    ]
    slider = widgets.SelectionSlider(
        options=options,
        value=start,
        description=label,
        layout=widgets.Layout(width="95%"),
        style={"description_width": "initial"},
    )
    keep_in_cell(slider, ["value"], (label, options))
    drawn = {start: at(start)}
    if is_croppable(drawn[start]) or is_without_kernel():
        pictures = [drawn[start] if index == start else at(index) for index in range(len(values))]
        drawn = dict(enumerate(crop(pictures) if all(map(is_croppable, pictures)) else pictures))

    def show() -> str:
        index = slider.value
        return (drawn[index] if index in drawn else at(index)).html()

    screen = widgets.HTML(show())
    slider.observe(lambda _: setattr(screen, "value", show()), "value")
    inside = _covered(widgets.VBox([screen, slider]), after)
    if not is_without_kernel():
        return inside
    return Slides(inside, [(text, drawn[index].html()) for text, index in options], label, start, after)


class Slides(widgets.VBox):  # type: ignore[misc]  # ipywidgets ships no types
    """A slider that contains all its pictures, for a page on which no Python can draw them."""

    def __init__(
        self, inside: widgets.Widget, pictures: Sequence[tuple[str, str]], label: str, start: int, after: Any
    ) -> None:
        super().__init__([inside])
        self._pictures, self._label, self._start, self._after = pictures, label, start, getattr(after, "name", "")

    def html(self) -> str:
        """Return all pictures as HTML, hidden except for the selected one; the script of the page adds a slider."""
        after = f' data-kinlib-after="{escape(self._after)}"' if self._after else ""
        shown = "".join(
            f'<div data-value="{escape(text)}"{"" if index == self._start else " hidden"}>{picture}</div>'
            for index, (text, picture) in enumerate(self._pictures)
        )
        if self._after:
            shown = f"<details><summary>Commit to your prediction above first, then open the picture.</summary>{shown}</details>"
        return f'<div data-kinlib-slides data-label="{escape(self._label)}" data-start="{self._start}"{after}>{shown}</div>'

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return {**super()._repr_mimebundle_(**options), "text/html": self.html()}


def _covered(inside: widgets.VBox, after: Any) -> widgets.VBox:
    """Cover a widget until a question is committed. A button uncovers it without a prediction, and records nothing."""
    if after is None or after.committed:
        return inside
    # a line without a frame: the question above and its explanation have one each
    note = f'<p role="status" style="margin:0;color:{INK}">Commit to your prediction above first; the picture appears here then.</p>'
    anyway = widgets.Button(description="Show anyway", tooltip="Uncover the picture without a prediction")
    box = widgets.VBox([widgets.HTML(note), anyway])

    anyway.on_click(lambda _: setattr(box, "children", [widgets.HTML(NOT_RECORDED), inside]))
    after.observe(lambda _: setattr(box, "children", [inside]), "committed")
    return box
