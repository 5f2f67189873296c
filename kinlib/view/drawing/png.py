"""Drawings as .png: the SVG elements that `svg` writes, drawn by matplotlib."""

import io
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PNG_DPI, LAYOUT_DPI, POINTS_PER_INCH = 200, 96, 72
"""Pixels per inch of a .png; a drawing is laid out for 96 of them, so it becomes about 1,300 pixels wide."""


def png_bytes(drawing: "str | Figure", title: str, alt: str) -> bytes:
    r"""Return a drawing, SVG text from `svg.document` or a matplotlib figure, as a .png with its text alternative in the metadata.

    >>> from kinlib.view.drawing import svg
    >>> png_bytes(svg.document([svg.circle(np.array([5, 5]), 3, "black")], 10, 10), "Dot", "A black dot.")[:4]
    b'\x89PNG'
    """
    from matplotlib.figure import Figure

    buffer, figure = io.BytesIO(), drawing
    if isinstance(figure, str):
        root = ET.fromstring(figure)  # noqa: S314 - drawn by this package
        size = np.array([float(root.get(name, "")) for name in ("width", "height")]) / LAYOUT_DPI
        figure = Figure(figsize=(size[0], size[1]))
        _draw(root, figure, np.zeros(2), size)
    figure.savefig(buffer, format="png", dpi=PNG_DPI, metadata={"Title": title, "Description": alt}, facecolor="white")
    return buffer.getvalue()


def _draw(root: ET.Element, figure: "Figure", corner: np.ndarray, size: np.ndarray) -> None:
    """Draw one <svg> into the figure; corner (from the upper left) and size are in inches."""
    left, top, width, height = map(float, root.get("viewBox", "").split())
    whole = figure.get_size_inches()
    place = (corner[0] / whole[0], 1 - (corner[1] + size[1]) / whole[1], *(size / whole))
    axes = figure.add_axes(place, xlim=(left, left + width), ylim=(top + height, top))
    axes.set_axis_off()
    scale = size[0] / width
    for order, element in enumerate(_elements(root)):
        if element.tag.endswith("}svg"):
            inner = np.array([float(element.get(name, "0")) for name in ("x", "y", "width", "height")]) * scale
            _draw(element, figure, corner + inner[:2], inner[2:])
        else:
            _draw_element(element, axes, order, POINTS_PER_INCH * scale)


def _elements(parent: ET.Element) -> Iterator[ET.Element]:
    """Yield what is drawn, in its order; a drawing within the drawing is one element."""
    for element in parent:
        yield from _elements(element) if element.tag.endswith("}g") else [element]


def _draw_element(element: ET.Element, axes: "Axes", order: int, points: float) -> None:
    from matplotlib.patches import Circle, Polygon
    from matplotlib.patheffects import withStroke

    def number(name: str) -> float:
        return float(element.get(name) or "0")

    fill, stroke, width = element.get("fill", "none"), element.get("stroke", "none"), number("stroke-width")
    style: dict[str, Any] = {
        "facecolor": fill,
        "edgecolor": stroke,
        "linewidth": points * width,
        "zorder": order,
        "clip_on": False,
    }
    tag = element.tag.rpartition("}")[2]
    if tag in {"polyline", "polygon"}:
        corners = np.array(element.get("points", "").replace(",", " ").split(), dtype=float).reshape(-1, 2)
        if dashes := element.get("stroke-dasharray"):  # matplotlib measures dashes in line widths
            style["linestyle"] = (0, [float(length) / width for length in dashes.split()])
        ends = {"joinstyle": "round", "capstyle": "butt" if dashes else "round"}
        axes.add_patch(Polygon(corners, closed=tag == "polygon", **style, **ends))
    elif tag == "circle":
        axes.add_patch(Circle((number("cx"), number("cy")), number("r"), **style))
    elif tag == "text":
        halo = [withStroke(linewidth=points * width, foreground=stroke)] if width else []
        place: dict[str, Any] = {
            "ha": "center",
            "va": "baseline",
            "size": points * number("font-size"),
            "zorder": order,
            "color": fill,
        }
        axes.text(number("x"), number("y"), _mathtext(element), path_effects=halo, parse_math=True, **place)


def _mathtext(element: ET.Element) -> str:
    """Return a label with its subscripts and italic letters, which are in <tspan> of their own, as matplotlib writes them."""
    runs = [element.text or ""]
    for run in element:
        text = re.sub(r"([{}_^$%#&])", r"\\\1", run.text or "")
        script = "" if not run.get("font-size") else "_" if float(run.get("dy", "0")) > 0 else "^"
        font = r"\mathit" if run.get("font-style") else r"\mathrm"
        runs += [f"${script}{font}{{{text}}}$", run.tail or ""]
    return "".join(runs).replace("$$", "")
