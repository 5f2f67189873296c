"""A picture and the one slider that answers a question, covered until a prediction is made.

`slide` moves along any list of values. It stays covered while the question given as `after` is not committed: who has not
predicted cannot be surprised. The joints of an arm are turned in the viewer.
"""

from collections.abc import Callable, Sequence
from html import escape
from typing import Any, TypeVar

import ipywidgets as widgets

from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.static_export import is_static_export

NOTE_STYLE = (
    "border-left:5px solid #0b5cad;background:#eef6ff;color:#1f2328;padding:.6em 1em;margin:.4em 0;max-width:46em"
)

V = TypeVar("V")


def slide(
    draw: Callable[[V], Picture], label: str, values: Sequence[V], after: Any = None, start: int = 0
) -> widgets.Widget:
    """Move along values and see what each one draws.

    draw    a function from a value to a Picture
    label   what the values are
    start   the index of the value to begin with

    Raises ValueError for nothing to slide along.

    >>> from kinlib.view import plot
    >>> def line(slope):
    ...     return plot([0, 1], {"line": [0, slope]}, xlabel="x", ylabel="y", alt=f"A line through 0 of slope {slope}.")
    >>> type(slide(line, "slope", [1, 2])).__name__
    'VBox'
    """
    if len(values) == 0:
        raise ValueError("values should hold at least one value to slide to; got none.")
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
    inside = _covered(_live(lambda: draw(values[slider.value]).html(), [slider], []), after)
    if not is_static_export():
        return inside
    pictures = [(text, draw(value).html()) for (text, _), value in zip(options, values, strict=True)]
    return Slides(inside, pictures, label, start, after)


class Slides(widgets.VBox):  # type: ignore[misc]  # ipywidgets ships no types
    """A slider that carries its pictures, for a page on which nobody is left to draw them."""

    def __init__(
        self, inside: widgets.Widget, pictures: Sequence[tuple[str, str]], label: str, start: int, after: Any
    ) -> None:
        super().__init__([inside])
        self._pictures, self._label, self._start, self._after = pictures, label, start, getattr(after, "name", "")

    def html(self) -> str:
        """Every picture, all but the first one hidden; a script may put a slider below them."""
        after = f' data-kinlib-after="{escape(self._after)}"' if self._after else ""
        shown = "".join(
            f'<div data-value="{escape(text)}"{"" if index == self._start else " hidden"}>{picture}</div>'
            for index, (text, picture) in enumerate(self._pictures)
        )
        return f'<div data-kinlib-slides data-label="{escape(self._label)}" data-start="{self._start}"{after}>{shown}</div>'

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return {**super()._repr_mimebundle_(**options), "text/html": self.html()}


def _live(
    draw: Callable[[], str], sliders: Sequence[widgets.Widget], buttons: Sequence[widgets.Widget]
) -> widgets.VBox:
    """A picture above its sliders, drawn anew when one of them moves."""
    screen = widgets.HTML(draw())

    def redraw(_: Any) -> None:
        screen.value = draw()

    for slider in sliders:
        slider.observe(redraw, "value")
    return widgets.VBox([screen, *sliders, *buttons])


def _covered(inside: widgets.VBox, after: Any) -> widgets.VBox:
    """Hide a widget until a question is committed; whoever insists may look, and nothing is recorded for it."""
    if after is None or after.committed:
        return inside
    note = _note("Commit to your prediction above first", "The picture appears here as soon as you have.")
    anyway = widgets.Button(description="Show anyway", tooltip="Uncover the picture without a prediction")
    box = widgets.VBox([widgets.HTML(note), anyway])

    def uncover(_: Any) -> None:
        box.children = [inside]

    def peek(_: widgets.Button) -> None:
        note = _note("Shown without a prediction", "Nothing was recorded. You can still commit to one above.")
        box.children = [widgets.HTML(note), inside]

    anyway.on_click(peek)
    after.observe(uncover, "committed")
    return box


def _note(title: str, text: str) -> str:
    """A framed note in HTML, with an icon, in the colours of the notes that the course's feedback uses."""
    head = f'<p style="margin:0;font-weight:600;color:#0b5cad"><span aria-hidden="true">i</span> {escape(title)}</p>'
    return f'<div role="status" style="{NOTE_STYLE}">{head}<p style="margin:.4em 0 0">{escape(text)}</p></div>'
