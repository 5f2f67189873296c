"""Drawings as .png, with their text alternative in the metadata."""

import io
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PNG_DPI, LAYOUT_DPI = 200, 96
"""Pixels per inch of a .png; a drawing is laid out for 96 of them, so it becomes about 1,300 pixels wide."""


def png_bytes(drawing: "str | Figure", title: str, alt: str) -> bytes:
    r"""Return a drawing, SVG text from `svg.document` or a matplotlib figure, as a .png.

    Raises ValueError where resvg is not installed, as in a browser.

    >>> from kinlib.view.drawing import svg
    >>> png_bytes(svg.document([], 10, 10), "Nothing", "White paper.")[:4]
    b'\x89PNG'
    """
    from matplotlib import get_data_path
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    written = io.BytesIO()
    if not isinstance(drawing, str):
        drawing.savefig(
            written, dpi=PNG_DPI, metadata={"Title": title, "Description": alt}, facecolor="white", format="png"
        )
        return written.getvalue()
    try:
        resvg = import_module("resvg_py")
    except ImportError:
        raise ValueError(
            "A drawing needs the package resvg-py to be saved as .png, which a browser does not have. Save it as .svg."
        ) from None
    fonts = str(Path(get_data_path(), "fonts", "ttf"))  # the same letters on every system
    pixels = resvg.svg_to_bytes(
        svg_string=drawing, zoom=2, skip_system_fonts=True, font_dirs=[fonts], font_family="DejaVu Sans"
    )
    about = PngInfo()
    about.add_text("Title", title)
    about.add_itxt("Description", alt)
    Image.open(io.BytesIO(bytes(pixels))).save(written, "png", pnginfo=about)
    return written.getvalue()
