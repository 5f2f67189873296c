"""Lines and frames as data: what a stop of a player shows. The page draws them in three dimensions, and this module as SVG.

A part names its colour as colours.json does. What the current stop is not about is pale.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import LIGHT_AND_DARK
from kinlib.view.drawing.picture import Picture

Part = dict[str, Any]

WIDTHS_PX = (0.0, 1.3, 1.9, 3.2, 4.5)
"""The width of a line in a drawing, by its number; js/scene/solids.js has the radii."""

PALE_SHARE = 0.55
"""How much of its colour is left of a part that is pale."""


def line_part(
    start: ArrayLike,
    end: ArrayLike,
    colour: str,
    *,
    name: str = "",
    width: int = 2,
    dashed: bool = False,
    tip: bool = False,
    strong: bool = True,
) -> Part:
    """Return a line from one point to another, as an arrow if it has a tip; its name is at the tip, or else in the middle."""
    ends = (np.asarray([start, end], dtype=float).round(6) + 0.0).tolist()
    looks = {"name": name, "width": width, "dashed": dashed, "tip": tip, "strong": strong}
    return {"kind": "line", "from": ends[0], "to": ends[1], "colour": colour, **looks}


def frame_part(
    T: Array, letters: str, *, sub: str = "", name: str = "", length: float = 0.2, rank: int = 0, strong: bool = True
) -> Part:
    """Return those axes of a frame that letters contains, and its origin if it contains O.

    sub, name  the index of its letters, and its name, in braces at its origin
    length     of its axes, as a share of the size of the scene
    rank       how many frames with the same origin were drawn before: each has longer axes than the last, so that none is hidden
    """
    pose = (np.asarray(T).round(6) + 0.0).ravel().tolist()
    looks = {"sub": sub, "name": name, "length": length + 0.07 * rank, "strong": strong}
    return {"kind": "frame", "pose": pose, "letters": letters, **looks}


def ranks(origins: ArrayLike) -> list[int]:
    """Return for each of the origins (m, 3) of frames how many before it are at the same place."""
    points = np.reshape(np.asarray(origins, dtype=float), (-1, 3))
    return [int((np.linalg.norm(points[:i] - point, axis=1) < 1e-6).sum()) for i, point in enumerate(points)]


def draw_parts(canvas: Canvas, parts: Iterable[Part], size: float) -> None:
    """Draw parts; size is that of the scene, in metres."""
    for part in parts:
        if part["kind"] == "line":
            _draw_line(canvas, part)
        elif part["kind"] == "frame":
            _draw_frame(canvas, part, size)


def draw_parts_about(points: Array, parts: Iterable[Part], size: float, alt: str, caption: str = "") -> Picture:
    """Return the drawing of parts over a floor, with points (m, 3) in view."""
    canvas = Canvas(points)
    canvas.floor(points)
    draw_parts(canvas, parts, size)
    return canvas.picture(alt, caption, cropped=True)


def tips(poses: Array, length: float) -> Array:
    """Return the ends of the axes of frames (..., 4, 4), of a length in metres, (m, 3)."""
    return np.asarray((poses[..., :3, 3, None] + length * poses[..., :3, :3]).swapaxes(-1, -2).reshape(-1, 3))


def _draw_line(canvas: Canvas, part: Part) -> None:
    start, end, strong = np.array(part["from"]), np.array(part["to"]), part["strong"]
    colour, style = _ink(part["colour"], strong), "--" if part["dashed"] else "-"
    level = {2: 2.0, 3: 3.2, 4: 3.4}.get(part["width"], 1.5) + 0.3 * strong
    if part["tip"]:
        canvas.arrow(start, end, colour, WIDTHS_PX[part["width"]], style=style, level=level)
    elif np.linalg.norm(end - start) > 1e-9:
        canvas.line([start, end], colour, WIDTHS_PX[part["width"]], style, level=level)
    if part["name"] and (strong or part["tip"]):
        head, _, low = part["name"].partition("_")
        name = f"${head}_{{{low}}}$" if low else head
        canvas.label(end if part["tip"] else (start + end) / 2, name, _ink(part["colour"], strong=True))


def _draw_frame(canvas: Canvas, part: Part, size: float) -> None:
    T, strong = np.reshape(part["pose"], (4, 4)), part["strong"]
    for k, letter in enumerate("xyz"):
        if letter not in part["letters"]:
            continue
        colour, tip = _ink(letter, strong), T[:3, 3] + part["length"] * size * T[:3, k]
        canvas.arrow(T[:3, 3], tip, colour, 2.3 if strong else 1.6, level=4 + strong + 0.01 * k)
        if part["sub"] or strong:
            right, up = 11 * canvas.along(T[:3, 3], tip)
            nudges = ((0, 0), *((dx, dy) for far in (9, 14, 22) for dx in (0, far, -far) for dy in (far, -far, 0)))
            places = [(right + dx, up + dy) for dx, dy in nudges]
            text = f"${letter}_{{{part['sub']}}}$" if part["sub"] else letter
            canvas.label(tip, text, _ink(letter, strong=True), places, 10)  # pale letters cannot be read
    if "O" in part["letters"]:
        canvas.dot(T[:3, 3], _ink("ink", strong), 6 if strong else 4, level=6)
    if part["name"]:
        canvas.label(T[:3, 3], f"{{{part['name']}}}")


def _ink(name: str, strong: bool) -> str:
    """Return a colour on white paper, or mixed with white if it is pale."""
    colour, share = LIGHT_AND_DARK[name][0], 1.0 if strong else PALE_SHARE
    return "#" + "".join(f"{round(255 - share * (255 - int(colour[k : k + 2], 16))):02x}" for k in (1, 3, 5))
