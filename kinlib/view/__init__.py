"""Figures with a text alternative, plots, and widgets that also work on a page without a kernel.

There are three renderers, because no single one does all three of these:

- SVG, written by hand (`drawing.svg`, `drawing.canvas`, all of `figures`), for drawings of robots. It takes milliseconds and is
  sharp in print; no plotting library places labels beside joints, or draws an arm fast enough for a slider.
- matplotlib (`drawing.plot`), for curves over a numeric axis: ticks, logarithmic scales and legends are not worth writing anew.
  It is imported only when a curve is plotted, because that takes one second, and three in the browser.
  SVG and plots are images that contain the colours of a light and of a dark page (`drawing.dark_theme`).
- three.js (`js`, bundled into `static/viewer.js`), for what a reader rotates in three dimensions (`viewer`). It runs in the page,
  so it needs no kernel, and it follows the light and the dark theme. Before it starts, and in print, its SVG drawing is shown.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from kinlib.view.diagrams.adjoint_steps import draw_adjoint_steps
from kinlib.view.diagrams.axis_relations import draw_axis_relation, draw_axis_relations
from kinlib.view.diagrams.last_frame import draw_last_frame, draw_last_frames
from kinlib.view.diagrams.lettered_chain import draw_lettered_chain
from kinlib.view.diagrams.nearly_parallel_axes import draw_nearly_parallel_axes
from kinlib.view.diagrams.parts_of_an_arm import draw_parts
from kinlib.view.diagrams.point_velocity import draw_moment, draw_point_velocity
from kinlib.view.diagrams.rotation_axes import draw_rotation_axes
from kinlib.view.diagrams.three_readings import draw_three_readings
from kinlib.view.diagrams.tool_velocities import draw_tool_velocities
from kinlib.view.diagrams.twist_matrix import draw_cross_product, draw_twist_matrix
from kinlib.view.diagrams.two_arms import draw_two_arms
from kinlib.view.diagrams.urdf_joint import draw_urdf_joint
from kinlib.view.diagrams.urdf_tree import draw_urdf_tree
from kinlib.view.drawing.picture import Gallery, Picture
from kinlib.view.drawing.plot import plot
from kinlib.view.figures.arm import draw_arm, draw_joints
from kinlib.view.figures.exponential_series import plot_series
from kinlib.view.figures.frames import draw_frames
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.figures.torus import draw_torus

if TYPE_CHECKING:
    from kinlib.view.viewer.assignment_player import Player, play_assignment
    from kinlib.view.viewer.browser import show
    from kinlib.view.viewer.dh_row_player import RowPlayer, play_row, play_walk
    from kinlib.view.viewer.lecture_slides import (
        slide_axis,
        slide_curve,
        slide_linkage,
        slide_mid_formula,
        slide_offset,
    )
    from kinlib.view.viewer.linkage_driver import Drive, drive
    from kinlib.view.viewer.moving_frames import FramesViewer, slide_frames
    from kinlib.view.viewer.picture_slider import slide
    from kinlib.view.viewer.place_frames import ByHand, assign
    from kinlib.view.viewer.viewer import Viewer, explore

__all__ = [
    "ByHand",
    "Drive",
    "FramesViewer",
    "Gallery",
    "Picture",
    "Player",
    "RowPlayer",
    "Viewer",
    "assign",
    "draw_adjoint_steps",
    "draw_arm",
    "draw_axis_relation",
    "draw_axis_relations",
    "draw_cross_product",
    "draw_frames",
    "draw_joints",
    "draw_last_frame",
    "draw_last_frames",
    "draw_lettered_chain",
    "draw_linkage",
    "draw_moment",
    "draw_nearly_parallel_axes",
    "draw_parts",
    "draw_point_velocity",
    "draw_rotation_axes",
    "draw_three_readings",
    "draw_tool_velocities",
    "draw_torus",
    "draw_twist_matrix",
    "draw_two_arms",
    "draw_urdf_joint",
    "draw_urdf_tree",
    "drive",
    "explore",
    "play_assignment",
    "play_row",
    "play_walk",
    "plot",
    "plot_series",
    "show",
    "slide",
    "slide_axis",
    "slide_curve",
    "slide_frames",
    "slide_linkage",
    "slide_mid_formula",
    "slide_offset",
]

LAZY_NAMES = {
    **dict.fromkeys(("ByHand", "assign"), "viewer.place_frames"),
    **dict.fromkeys(("Drive", "drive"), "viewer.linkage_driver"),
    **dict.fromkeys(("Player", "play_assignment"), "viewer.assignment_player"),
    **dict.fromkeys(("RowPlayer", "play_row", "play_walk"), "viewer.dh_row_player"),
    **dict.fromkeys(("Viewer", "explore"), "viewer.viewer"),
    "show": "viewer.browser",
    "slide": "viewer.picture_slider",
    **dict.fromkeys((name for name in __all__ if name.startswith("slide_")), "viewer.lecture_slides"),
    **dict.fromkeys(("FramesViewer", "slide_frames"), "viewer.moving_frames"),
}
"""Names that need ipywidgets and anywidget, and their modules, which are imported on first use because figures need neither."""


def __getattr__(name: str) -> Any:
    """Import a widget's module when its name is first used."""
    if name in LAZY_NAMES:
        return getattr(import_module(f"kinlib.view.{LAZY_NAMES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
