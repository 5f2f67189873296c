"""What people look at: drawings with a text alternative, widgets, and cards with feedback."""

from typing import TYPE_CHECKING, Any

from kinlib.view.arm import draw_arm, draw_joints
from kinlib.view.card import Card
from kinlib.view.frames import draw_frames
from kinlib.view.picture import Picture
from kinlib.view.plot import plot

if TYPE_CHECKING:
    from kinlib.view.widgets import explore, slide

__all__ = ["Card", "Picture", "draw_arm", "draw_frames", "draw_joints", "explore", "plot", "slide"]


def __getattr__(name: str) -> Any:
    """Load ipywidgets when somebody wants a slider, and not before: a figure does without."""
    if name in {"explore", "slide"}:
        from kinlib.view import widgets

        return getattr(widgets, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
