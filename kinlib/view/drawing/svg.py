"""Drawing marks as SVG text: strokes, outlines, dots, words. What a browser draws sharply at every size.

A drawing of an arm is some hundred strokes. Written out by hand it takes two milliseconds and ten kilobytes, so that a
slider can make a new one at every step; a plotting library needs fifty times as long.
"""

import html
import re
from collections.abc import Sequence

from kinlib.arrays.validation import Array

DASHES = {"-": "", "--": "7 4", ":": "1.5 3.5"}

GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "theta": "θ", "phi": "φ", "psi": "ψ", "omega": "ω", "pi": "π"}

FONT = "font-family:Helvetica,Arial,'DejaVu Sans',sans-serif"


def document(marks: Sequence[str], width: float, height: float) -> str:
    """A whole drawing, width by height pixels, on white paper that stays white in a dark theme."""
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" viewBox="0 0 {width:g} {height:g}">'
    paper = f'<rect width="{width:g}" height="{height:g}" fill="white"/>'
    return "\n".join(
        [head, paper, f'<g style="{FONT}" stroke-linecap="round" stroke-linejoin="round">', *marks, "</g></svg>"]
    )


def stroke(points: Array, colour: str, width: float, style: str = "-") -> str:
    """A line through points (m, 2); style is "-", "--" or ":".

    Raises ValueError for another style.
    """
    if style not in DASHES:
        raise ValueError(f"style should be one of {', '.join(DASHES)}; got {style!r}.")
    dash = f' stroke-dasharray="{DASHES[style]}" stroke-linecap="butt"' if DASHES[style] else ""
    return f'<polyline points="{_pairs(points)}" fill="none" stroke="{colour}" stroke-width="{width:g}"{dash}/>'


def outline(points: Array, colour: str, edge: str = "none", width: float = 1.0) -> str:
    """A filled shape with the corners (m, 2)."""
    return f'<polygon points="{_pairs(points)}" fill="{colour}" stroke="{edge}" stroke-width="{width:g}"/>'


def disc(centre: Array, radius: float, colour: str, edge: str = "none") -> str:
    """A round dot."""
    return f'<circle cx="{centre[0]:.1f}" cy="{centre[1]:.1f}" r="{radius:g}" fill="{colour}" stroke="{edge}" stroke-width="1.3"/>'


def words(centre: Sequence[float] | Array, text: str, colour: str, size: float) -> str:
    """Words around a centre, with a white rim that keeps them legible on a line. $S_1$ gets an italic S and a low 1.

    >>> words([5.0, 5.0], "$S_1$", "black", 10)[-84:]
    '<tspan font-style="italic">S</tspan><tspan dy="2.5" font-size="75%">1</tspan></text>'
    """
    place = f'x="{centre[0]:.1f}" y="{centre[1] + 0.35 * size:.1f}" text-anchor="middle" font-size="{size:g}"'
    return f'<text {place} fill="{colour}" stroke="white" stroke-width="2.6" paint-order="stroke">{_runs(text, size)}</text>'


def letters(text: str) -> str:
    r"""The letters of a label without its markup: what counts for its length.

    >>> letters(r"$\theta_{12}$"), letters("{s}")
    ('θ12', '{s}')
    """
    return "".join(part for part, _, _ in _parts(text))


def _runs(text: str, size: float) -> str:
    runs, shift = [], 0.0
    for part, is_math, level in _parts(text):
        wanted = -level * 0.25 * size
        step, shift = wanted - shift, wanted
        style = f' dy="{step:g}"' if step else ""
        style += ' font-size="75%"' if level else ""
        style += ' font-style="italic"' if is_math and part.isalpha() else ""
        runs.append(f"<tspan{style}>{html.escape(part)}</tspan>" if style else html.escape(part))
    return "".join(runs)


def _parts(text: str) -> list[tuple[str, bool, int]]:
    """Cut a label into (letters, is it mathematics, -1 low, 0 or 1 high)."""
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
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
