"""What people look at: drawings with a text alternative, widgets, and cards with feedback."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from kinlib.view.arm import draw_arm, draw_joints
from kinlib.view.card import Card
from kinlib.view.frames import draw_frames
from kinlib.view.linkage import draw_linkage
from kinlib.view.picture import Picture
from kinlib.view.plot import plot
from kinlib.view.torus import draw_torus

if TYPE_CHECKING:
    from kinlib.view.by_hand import ByHand, assign
    from kinlib.view.driver import Drive, drive
    from kinlib.view.player import Player, play_assignment
    from kinlib.view.row_player import RowPlayer, play_row, play_walk
    from kinlib.view.viewer import Viewer, explore
    from kinlib.view.widgets import slide

__all__ = [
    "ByHand",
    "Card",
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
    **dict.fromkeys(("ByHand", "assign"), "by_hand"),
    **dict.fromkeys(("Drive", "drive"), "driver"),
    **dict.fromkeys(("Player", "play_assignment"), "player"),
    **dict.fromkeys(("RowPlayer", "play_row", "play_walk"), "row_player"),
    **dict.fromkeys(("Viewer", "explore"), "viewer"),
    "slide": "widgets",
}
"""What needs ipywidgets and anywidget, and its module: loaded when somebody wants a slider, for a figure does without."""


def __getattr__(name: str) -> Any:
    """Load what comes late."""
    if name in LATE:
        return getattr(import_module(f"kinlib.view.{LATE[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
