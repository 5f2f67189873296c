"""What people look at: drawings with a text alternative, and widgets."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from kinlib.view.drawing.picture import Picture
from kinlib.view.drawing.plot import plot
from kinlib.view.figures.arm import draw_arm, draw_joints
from kinlib.view.figures.frames import draw_frames
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.figures.torus import draw_torus

if TYPE_CHECKING:
    from kinlib.view.viewer.assignment_player import Player, play_assignment
    from kinlib.view.viewer.dh_row_player import RowPlayer, play_row, play_walk
    from kinlib.view.viewer.linkage_driver import Drive, drive
    from kinlib.view.viewer.picture_slider import slide
    from kinlib.view.viewer.place_frames import ByHand, assign
    from kinlib.view.viewer.viewer import Viewer, explore

__all__ = [
    "ByHand",
    "Drive",
    "Picture",
    "Player",
    "RowPlayer",
    "Viewer",
    "assign",
    "draw_arm",
    "draw_frames",
    "draw_joints",
    "draw_linkage",
    "draw_torus",
    "drive",
    "explore",
    "play_assignment",
    "play_row",
    "play_walk",
    "plot",
    "slide",
]

LATE = {
    **dict.fromkeys(("ByHand", "assign"), "viewer.place_frames"),
    **dict.fromkeys(("Drive", "drive"), "viewer.linkage_driver"),
    **dict.fromkeys(("Player", "play_assignment"), "viewer.assignment_player"),
    **dict.fromkeys(("RowPlayer", "play_row", "play_walk"), "viewer.dh_row_player"),
    **dict.fromkeys(("Viewer", "explore"), "viewer.viewer"),
    "slide": "viewer.picture_slider",
}
"""What needs ipywidgets and anywidget, and its module: loaded when somebody wants a slider, for a figure does without."""


def __getattr__(name: str) -> Any:
    """Load what comes late."""
    if name in LATE:
        return getattr(import_module(f"kinlib.view.{LATE[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
