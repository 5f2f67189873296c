"""Drawings as .png and .pdf: the SVG elements that `svg` writes, drawn by matplotlib."""

import io
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PNG_DPI = 200
"""Pixels per inch of a .png; a drawing is laid out for 96 of them, so it becomes about 1,300 pixels wide."""

LAYOUT_DPI, POINTS_PER_INCH = 96, 72

KINDS = ("png", "pdf")


def image_bytes(drawing: "str | Figure", kind: str, title: str, alt: str) -> bytes:
    r"""Return a drawing as the contents of a .png or .pdf file, with its text alternative in the metadata.

    drawing  SVG text from `svg.document`, or a matplotlib figure

    >>> from kinlib.view.drawing import svg
    >>> image_bytes(svg.document([svg.circle(np.array([5, 5]), 3, "black")], 10, 10), "png", "Dot", "A black dot.")[:4]
    b'\x89PNG'
    """
    buffer, figure = io.BytesIO(), figure_from_svg(drawing) if isinstance(drawing, str) else drawing
    metadata = {"Title": title, "Description": alt} if kind == "png" else {"Title": title, "Subject": alt}
    # Without a date, the same drawing always gives the same file.
    dates = {} if kind == "png" else {"CreationDate": None}
    figure.savefig(buffer, format=kind, dpi=PNG_DPI, metadata={**metadata, **dates}, facecolor="white")
    return buffer.getvalue()


def figure_from_svg(text: str) -> "Figure":
    """Draw the rectangles, polylines, polygons, circles and labels of an SVG drawing in a matplotlib figure of the same size.

    >>> from kinlib.view.drawing import svg
    >>> figure_from_svg(svg.document([], 96, 48)).get_size_inches().tolist()
    [1.0, 0.5]
    """
    from matplotlib.figure import Figure

    root = ET.fromstring(text)  # noqa: S314 - drawn by this package
    size = np.array([float(root.get(name, "")) for name in ("width", "height")]) / LAYOUT_DPI
    figure = Figure(figsize=(size[0], size[1]))
    _draw(root, figure, np.array([0.0, 0.0]), size)
    return figure


def _draw(root: ET.Element, figure: "Figure", corner: np.ndarray, size: np.ndarray) -> None:
    """Draw one <svg> into the figure; corner (from the upper left) and size are in inches."""
    left, top, width, height = map(float, root.get("viewBox", "").split())
    whole = figure.get_size_inches()
    place = (corner[0] / whole[0], 1 - (corner[1] + size[1]) / whole[1], *(size / whole))
    axes = figure.add_axes(place, xlim=(left, left + width), ylim=(top + height, top))
    axes.set_axis_off()
    points = POINTS_PER_INCH * size[0] / width  # in a unit of the drawing
    for order, element in enumerate(_elements(root)):
        if element.tag.endswith("}svg"):
            inner = np.array([float(element.get(name, "0")) for name in ("x", "y", "width", "height")])
            _draw(element, figure, corner + inner[:2] * size[0] / width, inner[2:] * size[0] / width)
        else:
            _draw_element(element, axes, order, points)


def _elements(parent: ET.Element) -> Iterator[ET.Element]:
    """Yield what is drawn, in its order; a drawing within the drawing is one element."""
    for element in parent:
        if element.tag.endswith("}g"):
            yield from _elements(element)
        else:
            yield element


def _draw_element(element: ET.Element, axes: "Axes", order: int, points: float) -> None:
    from matplotlib.patches import Circle, PathPatch, Rectangle
    from matplotlib.path import Path

    number = lambda name, default="0": float(element.get(name) or default)  # noqa: E731
    tag = element.tag.rpartition("}")[2]
    style: dict[str, Any] = {
        "facecolor": element.get("fill", "none"),
        "edgecolor": element.get("stroke", "none"),
        "linewidth": points * number("stroke-width", "1"),
        "zorder": order,
        "clip_on": False,
    }
    if tag in {"polyline", "polygon"}:
        corners = np.array(element.get("points", "").replace(",", " ").split(), dtype=float).reshape(-1, 2)
        if dashes := element.get("stroke-dasharray"):
            # matplotlib measures dashes in line widths
            on_off = [float(length) / number("stroke-width", "1") for length in dashes.split()]
            style |= {"linestyle": (0, on_off), "capstyle": "butt"}
        else:
            style["capstyle"] = "round"
        ends = corners[:1] if tag == "polygon" else corners[:0]
        axes.add_patch(PathPatch(Path(np.concatenate([corners, ends])), joinstyle="round", **style))
    elif tag == "circle":
        axes.add_patch(Circle((number("cx"), number("cy")), number("r"), **style))
    elif tag == "rect":
        axes.add_patch(Rectangle((number("x"), number("y")), number("width"), number("height"), **style))
    elif tag == "text":
        _draw_label(element, axes, order, points)


def _draw_label(element: ET.Element, axes: "Axes", order: int, points: float) -> None:
    """Draw a label as outlines, run by run, because its subscripts and its italic letters are in <tspan> of their own."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.patches import PathPatch
    from matplotlib.textpath import TextPath, text_to_path
    from matplotlib.transforms import Affine2D

    size = float(element.get("font-size", ""))
    x, baseline = float(element.get("x", "")), float(element.get("y", ""))
    runs = []
    for run in (element, *element):
        if run is not element:
            baseline += float(run.get("dy", "0"))
        if run.text:
            font = FontProperties(style=run.get("font-style", "normal"), size=size)
            share = 0.75 if run is not element and run.get("font-size") else 1.0
            # glyphs are laid out at a large size, because their positions are rounded
            advance = text_to_path.get_text_width_height_descent(run.text, font, ismath=False)[0]
            runs.append((run.text, font, share, advance * share, baseline))
        if run is not element and run.tail:  # plain text after a subscript
            font = FontProperties(size=size)
            advance = text_to_path.get_text_width_height_descent(run.tail, font, ismath=False)[0]
            runs.append((run.tail, font, 1.0, advance, baseline))
    x -= 0.5 * sum(advance for *_, advance, _ in runs)
    for text, font, share, advance, y in runs:
        path = TextPath((0, 0), text, size=size, prop=font).transformed(Affine2D().scale(share, -share).translate(x, y))
        outline, colour = float(element.get("stroke-width", "0")), element.get("fill", "black")
        common = {"zorder": order, "clip_on": False, "joinstyle": "round"}
        if outline:
            edge = element.get("stroke", "none")
            axes.add_patch(PathPatch(path, facecolor=edge, edgecolor=edge, linewidth=points * outline, **common))
        axes.add_patch(PathPatch(path, facecolor=colour, edgecolor="none", **common))
        x += advance
