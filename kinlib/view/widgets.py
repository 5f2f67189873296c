"""Widgets: a picture and the one slider that answers a question, covered until a prediction is made.

`explore` turns the joints of an arm, `slide` moves along any list of values. Both stay covered while the question given
as `after` is not committed: who has not predicted cannot be surprised.
"""

from collections.abc import Callable, Collection, Sequence
from typing import Any, TypeVar

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from kinlib.chain import Chain
from kinlib.check import Array
from kinlib.view.arm import draw_arm, reach
from kinlib.view.card import Card
from kinlib.view.picture import Picture

V = TypeVar("V")

TURN, SLIDE = np.pi, 1.0
"""How far a slider goes to either side: half a turn in radians, one metre."""

DEGREE, CENTIMETRE = np.pi / 180, 0.01
"""What one press of an arrow key moves a joint by."""


def explore(
    chain: Chain,
    joints: Sequence[int] | None = None,
    *,
    show: Collection[str] = ("axes", "base", "tool"),
    after: Any = None,
    start: ArrayLike | None = None,
    span: tuple[float, float] | None = None,
    ghost: ArrayLike | None = None,
    readout: bool = True,
) -> widgets.Widget:
    """Move joints of an arm and read where its tool is.

    joints   which ones get a slider, counted from 1; all by default, but name the one that matters
    show     what is drawn, as in draw_arm
    after    a question; the arm stays covered until it is committed
    start    (n,) joint values to begin with, home by default
    span     from where to where the sliders go, in radians or metres
    ghost    (n,) another configuration, in grey
    readout  whether the tool's pose stands below

    Raises ValueError for a joint that the arm does not have, a start of another size, a span that does not hold it.

    >>> from kinlib.robots import rpr
    >>> type(explore(rpr(), joints=[2])).__name__
    'VBox'
    """
    joints = list(range(1, chain.n + 1)) if joints is None else list(joints)
    if wrong := [joint for joint in joints if joint not in range(1, chain.n + 1)]:
        raise ValueError(f"{chain.name} has joints 1 to {chain.n}; got {wrong[0]!r}.")
    home = np.zeros(chain.n) if start is None else np.array(start, dtype=float)
    chain.fk(home)  # refuses a start of another size, in words
    sliders = {joint: _joint_slider(chain, joint, home[joint - 1], span) for joint in joints}
    low, high = home.copy(), home.copy()
    for joint, slider in sliders.items():
        low[joint - 1], high[joint - 1] = slider.min, slider.max
    around = reach(chain, low, high)

    def values() -> Array:
        q = home.copy()
        for joint, slider in sliders.items():
            q[joint - 1] = slider.value
        return q

    def draw() -> str:
        q = values()
        picture = draw_arm(chain, q, show=show, around=around, ghost=ghost).html()
        return picture + _readout(chain, q, joints) if readout else picture

    def reset(_: widgets.Button) -> None:
        for joint, slider in sliders.items():
            slider.value = home[joint - 1]

    back = widgets.Button(description="Back to start", tooltip="Put every slider back to where it began")
    back.on_click(reset)
    return _covered(_live(draw, list(sliders.values()), [back]), after)


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
    return _covered(_live(lambda: draw(values[slider.value]).html(), [slider], []), after)


def _joint_slider(chain: Chain, joint: int, value: float, span: tuple[float, float] | None) -> widgets.FloatSlider:
    slides = chain.letters[joint - 1] == "P"
    far, step = (SLIDE, CENTIMETRE) if slides else (TURN, DEGREE)
    low, high = span or (value - far, value + far)
    if not low <= value <= high:
        raise ValueError(
            f"span should hold the start of joint {joint}, {value:.3g}; got {low:.3g} to {high:.3g}. Is one in degrees?"
        )
    # The page rounds a slider to whole steps from its lower end: the start has to be one, or the arm would twitch.
    low, high = (value + step * np.round((end - value) / step) for end in (low, high))
    return widgets.FloatSlider(
        value=value,
        min=low,
        max=high,
        step=step,
        description=f"joint {joint} ({'m' if slides else 'rad'})",
        readout_format=".2f",
        tooltip=f"Value of joint {joint}: arrow keys move it by {'a centimetre' if slides else 'a degree'}",
        style={"description_width": "initial"},
        layout=widgets.Layout(width="95%"),
    )


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
    note = Card("note", "Commit to your prediction above first", ["The picture appears here as soon as you have."])
    anyway = widgets.Button(description="Show anyway", tooltip="Uncover the picture without a prediction")
    box = widgets.VBox([widgets.HTML(note.html()), anyway])

    def uncover(_: Any) -> None:
        box.children = [inside]

    def peek(_: widgets.Button) -> None:
        told = Card("note", "Shown without a prediction", ["Nothing was recorded. You can still commit to one above."])
        box.children = [widgets.HTML(told.html()), inside]

    anyway.on_click(peek)
    after.observe(uncover, "committed")
    return box


def _readout(chain: Chain, q: Array, joints: Sequence[int]) -> str:
    """The joint values, in degrees too where they turn, and the tool's pose."""
    said = []
    for joint in joints:
        value = q[joint - 1].round(6) + 0.0
        unit = f"{value:.2f} m" if chain.letters[joint - 1] == "P" else f"{value:.2f} rad = {np.degrees(value):.0f}°"
        said.append(f"q{joint} = {unit}")
    T = "\n".join("  ".join(f"{x + 0.0:7.3f}" for x in row) for row in chain.fk(q).round(3) + 0.0)
    return Card("note", "Tool pose T(q), {b} seen from {s}", [", ".join(said), ("pre", T)]).html()
