"""Drawings that follow the theme of the page: each SVG contains a second set of colours for a dark page.

A browser draws an image for the color-scheme of the element that shows it, so a rule on the page switches every drawing,
as an image and without a script; in print, drawings are light. A browser that does not pass the color-scheme on to images
uses the theme of the system. The drawing stays legible, because it paints its own paper.
"""

import colorsys
import re

from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK
from kinlib.view.drawing.shades import SHADES

DARK_COLOURS = {**SHADES, "#000000": LIGHT_AND_DARK["ink"][1], **dict(LIGHT_AND_DARK.values())}
"""The colour on a dark page for each colour on white paper; for other colours it is computed."""

COLOUR = re.compile(r'(fill|stroke)(="|: )(#[0-9a-fA-F]{6}|white|black)')

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
