"""SVG elements as text: polylines, polygons, circles and labels, which a browser draws sharply at every size.

A drawing of an arm has about a hundred polylines. Writing them directly takes two milliseconds and ten kilobytes, so a
slider can draw a new one at every step; a plotting library takes fifty times as long.
"""

import html
import re
from collections.abc import Sequence
from zlib import crc32

from kinlib.arrays.validation import Array

DASHES = {"-": "", "--": "7 4", ":": "1.5 3.5"}

GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "theta": "θ", "phi": "φ", "psi": "ψ", "omega": "ω", "pi": "π"}

FONT = "font-family:Helvetica,Arial,'DejaVu Sans',sans-serif"


def document(marks: Sequence[str], width: float, height: float) -> str:
    """Return a complete drawing of width by height pixels, on white paper; `figure_colours` has those of a dark page."""
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" viewBox="0 0 {width:g} {height:g}">'
    paper = f'<rect width="{width:g}" height="{height:g}" fill="white"/>'
    return "\n".join(
        [head, paper, f'<g style="{FONT}" stroke-linecap="round" stroke-linejoin="round">', *marks, "</g></svg>"]
    )


def polyline(points: Array, colour: str, width: float, style: str = "-") -> str:
    """Return a line through points (m, 2); style is "-", "--" or ":"."""
    dash = f' stroke-dasharray="{DASHES[style]}" stroke-linecap="butt"' if DASHES[style] else ""
    return f'<polyline points="{_pairs(points)}" fill="none" stroke="{colour}" stroke-width="{width:g}"{dash}/>'


def polygon(points: Array, colour: str, edge: str = "none", width: float = 1.0) -> str:
    """Return a filled polygon with the corners (m, 2)."""
    stroke = "" if edge == "none" else f' stroke="{edge}" stroke-width="{width:g}"'
    return f'<polygon points="{_pairs(points)}" fill="{colour}"{stroke}/>'


def circle(centre: Array, radius: float, colour: str, edge: str = "none") -> str:
    """Return a filled circle."""
    return f'<circle cx="{centre[0]:.1f}" cy="{centre[1]:.1f}" r="{radius:g}" fill="{colour}" stroke="{edge}" stroke-width="1.3"/>'


def gradient(start: Array, end: Array, colours: Sequence[str]) -> tuple[str, str]:
    """Return a gradient from one place to another, and its name, which is the same only for the same gradient."""
    (x1, y1), (x2, y2) = start, end
    place = f'gradientUnits="userSpaceOnUse" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"'
    last = len(colours) - 1
    stops = "".join(f'<stop offset="{k / last:.2g}" stop-color="{colour}"/>' for k, colour in enumerate(colours))
    name = f"g{crc32((place + stops).encode()):x}"
    return name, f'<linearGradient id="{name}" {place}>{stops}</linearGradient>'


def text(centre: Sequence[float] | Array, label: str, colour: str, size: float) -> str:
    """Return text around a centre, with a white outline that keeps it legible on a line. $S_1$ gets a subscript.

    >>> text([5.0, 5.0], "$S_1$", "black", 10)[-84:]
    '<tspan font-style="italic">S</tspan><tspan dy="2.5" font-size="75%">1</tspan></text>'
    """
    place = f'x="{centre[0]:.1f}" y="{centre[1] + 0.35 * size:.1f}" text-anchor="middle" font-size="{size:g}"'
    runs, shift = [], 0.0
    for part, is_math, level in _parts(label):
        baseline = -level * 0.25 * size
        step, shift = baseline - shift, baseline
        style = f' dy="{step:g}"' if step else ""
        style += ' font-size="75%"' if level else ""
        style += ' font-style="italic"' if is_math and part.isalpha() else ""
        runs.append(f"<tspan{style}>{html.escape(part)}</tspan>" if style else html.escape(part))
    looks = f'fill="{colour}" stroke="white" stroke-width="2.6" paint-order="stroke"'
    return f"<text {place} {looks}>{''.join(runs)}</text>"


def plain_text(text: str) -> str:
    """Return the characters of a label without its markup, for example to estimate its width."""
    return "".join(part for part, _, _ in _parts(text))


def _parts(text: str) -> list[tuple[str, bool, int]]:
    """Cut a label into (characters, whether they are mathematics, -1 for a subscript, 0, or 1 for a superscript)."""
    parts: list[tuple[str, bool, int]] = []
    for index, piece in enumerate(text.split("$")):
        if index % 2 == 0:
            parts += [(piece, False, 0)] if piece else []
            continue
        plain = re.sub(r"\\([a-zA-Z]+) ?", lambda found: GREEK.get(found[1], found[1]), piece)
        for mark, braced, single, rest in re.findall(r"([_^])(?:\{([^}]*)\}|(.))|([^_^]+)", plain):
            level = {"_": -1, "^": 1, "": 0}[mark]
            parts.append((braced or single or rest, True, level))
    return parts


def _pairs(points: Array) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points.tolist())  # plain numbers are written faster
