"""The colours of figures on white paper. `dark_theme` has those on a dark page.

Violet is for joint axes and for d along them, orange for common normals and for a along them. What the figures and the 3-D viewer
show in the same colours, in the light and in the dark theme, is in kinlib/view/colours.json.
"""

import json
from pathlib import Path

LIGHT_AND_DARK: dict[str, tuple[str, str]] = json.loads(
    Path(__file__).parents[1].joinpath("colours.json").read_text("utf-8")
)

INK, VIOLET, ORANGE = (LIGHT_AND_DARK[name][0] for name in ("ink", "axis", "normal"))
GREY, PALE_GREY = "#8c959f", "#d9dee3"

AXIS_COLOURS = tuple(LIGHT_AND_DARK[name][0] for name in "xyz")
"""The colours of x (red), y (green) and z (blue). Letters at the tips say the same without colour."""

LINK_GREY, GHOST_GREY = "#5b7083", "#b6bec6"
"""Links of the configuration that is drawn, and of a second one that is shown for comparison."""

JOINT_FILL = "#f3d9a4"
