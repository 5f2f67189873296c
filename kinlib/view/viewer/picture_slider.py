"""A slider through the pictures of several values, covered until a prediction is committed.

Students learn more from an observation if they have predicted it. For the joints of an arm, use the viewer (`explore`).
"""

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from kinlib.view.drawing.crop import crop, is_croppable
from kinlib.view.drawing.dark_theme import follow_theme
from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.static_page import is_without_kernel
from kinlib.view.viewer.pictures import Pictures

V = TypeVar("V")


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
    labels = [f"{value:.4g}" if isinstance(value, float) else str(value) for value in values]
    return Pictures(
        [drawn[start]],
        at,
        [
            {"label": text, "caption": drawn[k].caption, "alt": drawn[k].alt} if k in drawn else {"label": text}
            for k, text in enumerate(labels)
        ],
        frames=[follow_theme(drawn[k].svg) if k in drawn else "" for k in range(len(values))],
        order=list(range(len(values))),
        looks={"label": label},
        at=start,
        after=after,
    )
