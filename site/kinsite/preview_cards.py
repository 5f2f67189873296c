"""The picture that other sites show of a linked page: its title beside its first figure, 1200 by 630 pixels.

The drawings of kinlib consist of lines, polygons, circles and labels (`kinlib.view.drawing.svg`), so Matplotlib can draw them
again as pixels, without a browser.
"""

import base64
import hashlib
import re
import textwrap
from html import unescape
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyBboxPatch, Polygon
from matplotlib.patheffects import withStroke
from sphinx.application import Sphinx

from kinlib.arrays.validation import Array

SIZE = (1200, 630)
"""Width and height in pixels, as other sites show them without cropping."""
PICTURED = ("lectures/", "robots/")
"""The folders of the pages that have a picture of their own."""
PANEL = (0.466, 0.063, 0.501, 0.874)
"""The place of the figure: left, bottom, width and height, as shares of the picture."""
MAX_ALT = 300
"""Characters of the text alternative; other sites cut longer ones."""
DPI, POINTS_PER_INCH = 100, 72
PAPER, INK = "#2b1748", "#e8dcff"

DRAWING = re.compile(r'<img alt="([^"]*)"[^>]*src="data:image/svg\+xml;base64,([^"]+)"')
LABEL_SPECIAL = re.compile(r"([{}_^$%#&\\])")


def first_drawing(html: str) -> tuple[str, str] | None:
    """Find the first drawing of a page. Returns it as SVG with its text alternative; None for one of Matplotlib."""
    for alt, data in DRAWING.findall(html):
        svg = base64.b64decode(data).decode()
        if "<path" not in svg:
            return svg, unescape(alt)
    return None


def preview(app: Sphinx, page: str, html: str) -> dict[str, str]:
    """Draw the picture of a page with the HTML of its outputs, unless it is drawn already. Returns its metadata.

    There is none for a page without a drawing: then conf.py's picture of the whole course is shown.
    """
    if not page.startswith(PICTURED) or (found := first_drawing(html)) is None:
        return {}
    svg, alt = found
    title = app.env.titles[page].astext()
    name = f"_images/preview-{hashlib.sha256(f'{title} {svg}'.encode()).hexdigest()[:20]}.png"
    if not (Path(app.outdir) / name).exists():
        write_card(Path(app.outdir) / name, title, svg)
    size = {f"og:image:{side}": str(length) for side, length in zip(("width", "height"), SIZE, strict=True)}
    return {
        "og:image": app.config.html_baseurl + name,
        "og:image:alt": textwrap.shorten(f"{title}: {alt}", MAX_ALT),
        **size,
    }


def write_card(path: Path, title: str, svg: str) -> None:
    """Draw the picture of a page and write it as a PNG file."""
    width, height = SIZE
    card = Figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor=PAPER)
    lines = textwrap.wrap(title, 17, break_long_words=False)
    card.text(
        0.05,
        0.55,
        "\n".join(lines),
        color="white",
        weight="bold",
        size=34 if len(lines) < 5 else 28,
        va="center",
        parse_math=False,
    )
    card.text(
        0.05,
        0.12,
        "Robot forward kinematics:\na free course that runs in the browser",
        color=INK,
        size=17,
        linespacing=1.4,
    )
    left, bottom, wide, high = PANEL
    frame = FancyBboxPatch(
        (left, bottom),
        wide,
        high,
        "round,pad=0,rounding_size=0.015",
        color="white",
        transform=card.transFigure,
        zorder=-1,
    )
    card.add_artist(frame)
    draw_svg(card, svg)
    path.parent.mkdir(parents=True, exist_ok=True)
    card.savefig(path, dpi=DPI, facecolor=PAPER, metadata={"Software": None})


def draw_svg(card: Figure, svg: str) -> None:
    """Draw the elements of a drawing into the panel of a card, as large as fits."""
    root = ET.fromstring(svg)  # noqa: S314  the drawing is our own
    x, y, w, h = map(float, root.get("viewBox", f"0 0 {root.get('width')} {root.get('height')}").split())
    panel = np.array(PANEL[2:]) * SIZE
    scale = 0.94 * min(panel / (w, h))
    points = scale * POINTS_PER_INCH / DPI
    axes = card.add_axes(PANEL, frameon=False)
    across, down = panel / scale / 2
    axes.set(
        xlim=(x + w / 2 - across, x + w / 2 + across), ylim=(y + h / 2 + down, y + h / 2 - down), xticks=[], yticks=[]
    )
    for order, element in enumerate(root.iter()):
        look = {"zorder": order, "linewidth": float(element.get("stroke-width", 1)) * points}
        fill, stroke = element.get("fill", "none"), element.get("stroke", "none")
        match element.tag.rpartition("}")[2]:
            case "polyline":
                dashes = [float(part) for part in element.get("stroke-dasharray", "").split()]
                look |= {"linestyle": (0, [part * points / look["linewidth"] for part in dashes])} if dashes else {}
                axes.plot(*corners(element).T, color=stroke, solid_capstyle="round", solid_joinstyle="round", **look)
            case "polygon":
                axes.add_patch(Polygon(corners(element), facecolor=fill, edgecolor=stroke, **look))
            case "circle":
                centre = float(element.get("cx", 0)), float(element.get("cy", 0))
                axes.add_patch(Circle(centre, float(element.get("r", 0)), facecolor=fill, edgecolor=stroke, **look))
            case "text":
                place = float(element.get("x", 0)), float(element.get("y", 0))
                outline = [withStroke(linewidth=look["linewidth"], foreground=stroke)] if stroke != "none" else []
                size = float(element.get("font-size", 10)) * points
                axes.text(
                    *place, label(element), color=fill, size=size, ha="center", zorder=order, path_effects=outline
                )


def corners(element: ET.Element) -> Array:
    """Read the points (m, 2) of a line or a polygon."""
    return np.array([pair.split(",") for pair in element.get("points", "").split()], dtype=float)


def label(text: ET.Element) -> str:
    r"""Write a label with its subscripts, as Matplotlib reads it.

    >>> label(ET.fromstring('<text><tspan font-style="italic">S</tspan><tspan dy="2.5">1</tspan></text>'))
    '$\\mathit{S}_{\\mathrm{1}}$'
    """
    pieces, shift = [], 0.0
    for part in text.iter():
        shift += float(part.get("dy", 0))
        style = "it" if part.get("font-style") else "rm"
        place = {0: "", 1: "_", -1: "^"}[int(np.sign(round(shift, 3)))]
        for words, where in ((part.text, place), (part.tail if part is not text else None, "")):
            if words:
                letters = LABEL_SPECIAL.sub(r"\\\1", words).replace(" ", r"\ ")
                inside = f"\\math{style}{{{letters}}}"
                pieces.append(f"{where}{{{inside}}}" if where else inside)
    return f"${''.join(pieces)}$"
