"""The colours of figures on white paper. Those of figures and of the 3-D viewer, light and dark, are in kinlib/view/colours.json.

Violet is for joint axes and for d along them, orange for common normals and for a along them.
"""

import json
from pathlib import Path

LIGHT_AND_DARK: dict[str, tuple[str, str]] = json.loads(
    Path(__file__).parents[1].joinpath("colours.json").read_text("utf-8")
)
"""Each colour by its name, on a light and on a dark page."""

INK, VIOLET, ORANGE, GREY, PALE_GREY = (LIGHT_AND_DARK[name][0] for name in ("ink", "axis", "normal", "grey", "pale"))

AXIS_COLOURS = tuple(LIGHT_AND_DARK[name][0] for name in "xyz")
"""The colours of x (red), y (green) and z (blue). Letters at the tips say the same without colour."""

LINK_GREY, GHOST_GREY = LIGHT_AND_DARK["link_line"][0], LIGHT_AND_DARK["ghost"][0]
"""Links of the configuration that is drawn, and of a second one that is shown for comparison."""

JOINT_FILL = LIGHT_AND_DARK["joint_fill"][0]
