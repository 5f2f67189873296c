"""The colours of drawings on white paper, of bodies in their shades, and how a drawing follows the theme of the page.

All colours of figures and of the 3-D viewer are in kinlib/view/colours.json, for a light and for a dark page. Violet is for joint
axes and for d along them, orange for common normals and for a along them.

Each SVG contains a second set of colours for a dark page. A browser draws an image for the color-scheme of the element that shows
it, so a rule on the page switches every drawing without a script; in print, drawings are light. A browser that does not pass the
color-scheme on to images uses the theme of the system. The drawing stays legible, because it paints its own paper.
"""

import colorsys
import json
import re
from functools import cache
from pathlib import Path

import numpy as np

from kinlib.arrays.validation import Array

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

LIGHT = np.array([-0.42, 0.78, 0.52]) / np.linalg.norm([-0.42, 0.78, 0.52])
"""The direction to the light in the axes of the picture: right, up, towards the viewer. js/render/stage.js has the same."""

LEVELS = 9
"""The number of shades of a colour."""

BODY_COLOURS = ("body", "metal", "grip", "dark", "blue", "white", "slate", "cream", "steel", "orange", "black", "joint")


@cache
def shade(colour: str, level: int, page: int) -> str:
    """Return a colour, or that of any body if it has no name, in one of LEVELS shades, on a light (0) or a dark page (1)."""
    pair = LIGHT_AND_DARK.get(colour, LIGHT_AND_DARK["body"])
    base = np.array([int(pair[page][k : k + 2], 16) / 255 for k in (1, 3, 5)])
    cool = base * ([0.5, 0.56, 0.66], [0.34, 0.38, 0.46])[page]
    k = level / (LEVELS - 1)
    lit = np.clip((k - 0.15) / 0.6, 0, 1)
    mixed = cool + (base - cool) * lit * lit * (3 - 2 * lit)
    high = np.clip((k - 0.85) / 0.15, 0, 1)
    return "#" + "".join(f"{round(255 * x):02x}" for x in np.clip(mixed + (1 - mixed) * 0.45 * high, 0, 1))


SHADES = {shade(name, level, 0): shade(name, level, 1) for name in BODY_COLOURS for level in range(LEVELS)}
"""The colour on a dark page for each shade on white paper."""


def lit(colour: str, n: Array) -> str:
    """Return the shade of a surface with the normal n, in the axes of the picture."""
    k = (float(n @ LIGHT) / max(float(np.linalg.norm(n)), 1e-9)) / 2 + 0.5
    return shade(colour, round(k * (LEVELS - 1)), 0)


DARK_COLOURS = {**SHADES, "#000000": LIGHT_AND_DARK["ink"][1], **dict(LIGHT_AND_DARK.values())}
"""The colour on a dark page for each colour on white paper; for other colours it is computed."""

COLOUR = re.compile(r'(fill|stroke|stop-color)(="|: )(#[0-9a-fA-F]{6}|white|black)')

THEME_CSS = (
    ".kinlib-figure img{color-scheme:light}"
    ':is([data-jp-theme-light="false"],[data-theme="dark"],.vscode-dark) .kinlib-figure img{color-scheme:dark}'
    '@media (prefers-color-scheme:dark){[data-theme="auto"] .kinlib-figure img{color-scheme:dark}}'
    "@media print{.kinlib-figure img{color-scheme:light!important}}"
)
"""Chooses the colours of figures by the theme that JupyterLab, the site or VS Code declares; other pages are light."""


def follow_theme(svg: str) -> str:
    """Add to a drawing the colours that it has on a dark page.

    >>> follow_theme('<svg><rect fill="white"/></svg>')
    '<svg><style>@media (prefers-color-scheme:dark){:root{fill:#e6edf3}[fill="white"]{fill:#171b21}}</style><rect ...'
    """
    rules = [
        f"[{name}={colour!r}]{{{name}:{dark_colour(colour)}}}".replace("'", '"')
        if mark == '="'
        else f'[style*="{name}: {colour}"]{{{name}:{dark_colour(colour)}!important}}'
        for name, mark, colour in sorted(set(COLOUR.findall(svg)))
    ]
    style = (
        f"<style>@media (prefers-color-scheme:dark){{:root{{fill:{DARK_COLOURS['#1f2328']}}}{''.join(rules)}}}</style>"
    )
    return re.sub(r"<svg[^>]*>", lambda head: head[0] + style, svg, count=1)


def dark_colour(colour: str) -> str:
    """Return the colour on a dark page that corresponds to one on white paper: of the same hue, and as far from the paper.

    >>> dark_colour("white"), dark_colour("#7d3ac1"), dark_colour("#ff8080")
    ('#171b21', '#c39bff', '#cc0000')
    """
    colour = {"white": "#ffffff", "black": "#000000"}.get(colour, colour.lower())
    if colour in DARK_COLOURS:
        return DARK_COLOURS[colour]
    hue, light, saturation = colorsys.rgb_to_hls(*(int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)))
    return "#" + "".join(f"{round(255 * x):02x}" for x in colorsys.hls_to_rgb(hue, 0.94 - 0.72 * light, saturation))
