"""Figures with a text alternative, plots, and widgets that also work on a page without a kernel.

There are three renderers, because no single one does all three of these:

- SVG, written by hand (`drawing.svg`, `drawing.canvas`, all of `figures`), for drawings of robots. It takes milliseconds and is
  sharp in print; no plotting library places labels beside joints, or draws an arm fast enough for a slider.
- matplotlib (`drawing.plot`), for curves over a numeric axis: ticks, logarithmic scales and legends are not worth writing anew.
  It is imported only when a curve is plotted, because that takes one second, and three in the browser.
  SVG and plots are images that contain the colours of a light and of a dark page (`drawing.figure_colours`).
- three.js (`js`, bundled into `static/viewer.js`), for what a reader rotates in three dimensions (`viewer`). It runs in the page,
  so it needs no kernel, and it follows the light and the dark theme. Before it starts, and in print, its SVG drawing is shown.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.drawing.plot import plot
from kinlib.view.figures.arm import draw_arm, draw_joints
from kinlib.view.figures.frames import draw_frames
from kinlib.view.figures.linkage import draw_linkage

if TYPE_CHECKING:
    from kinlib.view.viewer.linkage_driver import drive
    from kinlib.view.viewer.pictures import film, slide
    from kinlib.view.viewer.place_frames import assign
    from kinlib.view.viewer.steps import play_assignment, play_row, slide_frames
    from kinlib.view.viewer.viewer import explore, show

__all__ = [
    "Gallery",
    "Picture",
    "assign",
    "draw_arm",
    "draw_frames",
    "draw_joints",
    "draw_linkage",
    "drive",
    "explore",
    "film",
    "play_assignment",
    "play_row",
    "plot",
    "show",
    "slide",
    "slide_frames",
]

LAZY_NAMES = {
    "viewer.linkage_driver": {"drive"},
    "viewer.steps": {"play_assignment", "play_row", "slide_frames"},
    "viewer.pictures": {"film", "slide"},
    "viewer.place_frames": {"assign"},
    "viewer.viewer": {"explore", "show"},
}
"""Modules that need ipywidgets and anywidget, and their names: imported on first use, because figures need neither."""


def __getattr__(name: str) -> Any:
    """Import a widget's module when its name is first used."""
    for module, names in LAZY_NAMES.items():
        if name in names:
            return getattr(import_module(f"kinlib.view.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
