"""The colours of figures on white paper. `dark_theme` has those on a dark page.

Violet is for joint axes and for d along them, orange for common normals and for a along them. The colours of the 3-D viewer,
in the light and in the dark theme, are in kinlib/view/js/theme.js.
"""

INK, GREY, PALE_GREY, VIOLET, ORANGE = "#1f2328", "#8c959f", "#d9dee3", "#7d3ac1", "#b35900"

AXIS_COLOURS = ("#c1121f", "#1a7f37", "#0b5cad")
"""The colours of x (red), y (green) and z (blue). Letters at the tips say the same without colour."""

LINK_GREY, GHOST_GREY = "#5b7083", "#b6bec6"
"""Links of the configuration that is drawn, and of a second one that is shown for comparison."""

JOINT_FILL = "#f3d9a4"
