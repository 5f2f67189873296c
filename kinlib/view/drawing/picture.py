"""Pictures: a drawing together with its text alternative, as an element of HTML and as a file."""

import base64
import html
import io
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_vector
from kinlib.arrays.tolerances import TYPED_PI_ERROR
from kinlib.view.drawing.figure_colours import THEME_CSS, follow_theme

ENVIRONMENT_VARIABLE = "NOTEBOOK_STATIC_PAGE"
"""Set while notebooks are executed for a static page, on which no Python runs afterwards. Then sliders include a picture for each
value. misstep/display/lecture_address.py reads the same variable, because the two packages are installed independently."""

MIN_ALT_CHARACTERS = 20
"""A shorter text alternative can name a figure, but cannot say what it shows."""

CROP_BORDER_PX = 10.0
LARGEST_PX = (640.0, 440.0)
MAX_ENLARGEMENT = 1.3
"""A cropped drawing is enlarged to this size at most, and its letters by this factor at most."""

HEAD = re.compile(r'(<svg [^>]*?)width="([\d.]+)" height="([\d.]+)" viewBox="([^"]+)">\s*<rect [^>]*>')


@dataclass(frozen=True)
class Picture:
    """A finished drawing as SVG, with a text alternative that says what it shows.

    content  the left, upper, right and lower end of what a canvas has drawn, in pixels

    Raises ValueError if the text alternative is shorter than MIN_ALT_CHARACTERS.

    >>> nothing = Picture("<svg></svg>", "A drawing with nothing in it.")
    >>> nothing.labelled_svg()
    '<svg role="img"><title>A drawing with nothing in it.</title><desc>A drawing with nothing in it.</desc></svg>'
    >>> nothing.html()
    '<figure class="kinlib-figure" ...><style>...</style><img alt="A drawing with nothing in it." ...></figure>'
    >>> nothing.save("nothing.jpg") if sorted(nothing.contents()) == ["html", "png", "svg"] else None
    Traceback (most recent call last):
    ValueError: path must end in .svg or .html or .png; got 'nothing.jpg'.
    """

    svg: str
    alt: str
    caption: str = ""
    content: tuple[float, ...] = field(default=(), repr=False, compare=False)

    def __post_init__(self) -> None:
        if len(self.alt) < MIN_ALT_CHARACTERS:
            raise ValueError(
                f"alt must say what the figure shows, in at least {MIN_ALT_CHARACTERS} characters; got {self.alt!r}. "
                "Describe the figure as you would to someone who cannot see it."
            )

    def html(self) -> str:
        """Return the drawing as an HTML image with its text alternative, in the colours of the page's theme."""
        data = base64.b64encode(follow_theme(self.svg).encode()).decode()
        image = f'<img alt="{html.escape(self.alt)}" style="max-width:100%" src="data:image/svg+xml;base64,{data}">'
        caption = f"<figcaption>{html.escape(self.caption)}</figcaption>" if self.caption else ""
        return f'<figure class="kinlib-figure" style="margin:0"><style>{THEME_CSS}</style>{image}{caption}</figure>'

    def labelled_svg(self) -> str:
        """Return the drawing as SVG that contains its text alternative: in <desc>, and its first sentence or the caption in <title>."""
        title = html.escape(self.caption or first_sentence(self.alt))
        label = f' role="img"><title>{title}</title><desc>{html.escape(self.alt)}</desc>'
        return re.sub(r"(<svg[^>]*)>", lambda head: head[1] + label, self.svg, count=1)

    def contents(self) -> dict[str, Callable[[], str | bytes]]:
        """Return for each kind of file a function that makes its contents, with the text alternative."""
        return {
            "svg": self.labelled_svg,
            "html": lambda: page(self.alt, self.html()),
            "png": lambda: png_bytes(self),
        }

    def save(self, path: str | PathLike[str]) -> None:
        """Save the drawing with its text alternative: as an image, .svg or .png, or as a page of its own, .html.

        Raises ValueError for another ending, and for a folder that does not exist.
        """
        save(path, self.contents())

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": self.alt}


@dataclass(frozen=True)
class Gallery:
    """Several small pictures side by side, in as many rows as the page needs.

    >>> Gallery((Picture("<svg></svg>", "A drawing with nothing in it."),)).save("nothing.svg")
    Traceback (most recent call last):
    ValueError: path must end in .html; got 'nothing.svg'.
    >>> Gallery((Picture("<svg></svg>", "A drawing with nothing in it."),)).html().count("<figure")
    1
    """

    pictures: tuple[Picture, ...]

    def html(self) -> str:
        """Return the pictures as HTML, each with its text alternative."""
        columns = "grid-template-columns:repeat(auto-fill,minmax(max(150px,28%),1fr))"
        pictures = "".join(picture.html() for picture in self.pictures)
        return f'<div style="display:grid;{columns};gap:.8em;align-items:end;max-width:50em">{pictures}</div>'

    def save(self, path: str | PathLike[str]) -> None:
        """Save the pictures with their text alternatives as a page, .html; one of its `pictures` can be saved as an image."""
        alt = " ".join(picture.alt for picture in self.pictures)
        save(path, {"html": lambda: page(alt, self.html())})

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": "\n".join(picture.alt for picture in self.pictures)}


def crop(pictures: Sequence[Picture], largest: tuple[float, float] = LARGEST_PX) -> list[Picture]:
    """Cut drawings to the smallest rectangle that contains what all of them show, and enlarge them a little, to `largest`.

    Pictures of one slider are cut alike, so that nothing jumps. Those of which one is not from a canvas are left as they are.
    """
    if not all(picture.content for picture in pictures):
        return list(pictures)
    boxes = np.array([picture.content for picture in pictures])
    low, high = boxes[:, :2].min(axis=0) - CROP_BORDER_PX, boxes[:, 2:].max(axis=0) + CROP_BORDER_PX
    scale = min(MAX_ENLARGEMENT, max(1.0, float((largest / (high - low)).min())))
    left, top, width, height = (f"{x:.5g}" for x in (*low, *(high - low)))
    wide, tall = (f"{x:.4g}" for x in scale * (high - low))
    head = f'width="{wide}" height="{tall}" viewBox="{left} {top} {width} {height}">'
    head += f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="white"/>'
    return [replace(picture, svg=HEAD.sub(lambda found: found[1] + head, picture.svg, count=1)) for picture in pictures]


def is_without_kernel() -> bool:
    """Whether outputs must work without a kernel."""
    return os.environ.get(ENVIRONMENT_VARIABLE, "") not in ("", "live")


def vector_text(values: ArrayLike) -> str:
    """Write a vector for a text alternative: three significant digits, and 0 for rounding errors.

    >>> vector_text([0.5, -1e-17, 3])
    '(0.5, 0, 3)'
    """
    return format_vector(values, 3, zero=TYPED_PI_ERROR)


def save(path: str | PathLike[str], contents: Mapping[str, Callable[[], str | bytes]]) -> None:
    """Write a file of the kind that its ending names; contents gives the text or the bytes of each kind.

    Raises ValueError for any other ending, and for a folder that does not exist.
    """
    kind = Path(path).suffix.lower().removeprefix(".")
    if kind not in contents:
        raise ValueError(f"path must end in {' or '.join(f'.{name}' for name in contents)}; got {str(path)!r}.")
    if not Path(path).parent.is_dir():
        raise ValueError(f"path must be in a folder that exists; got {str(path)!r}. Make the folder first.")
    content = contents[kind]()
    Path(path).write_bytes(content.encode() if isinstance(content, str) else content)


def page(alt: str, body: str) -> str:
    """Return a stand-alone HTML page, whose title is the first sentence of a text alternative."""
    title = f"<title>{html.escape(first_sentence(alt))}</title>"
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width">{title}'
    style = "<style>body{font-family:system-ui,sans-serif;max-width:60em;margin:1em auto;padding:0 1em}</style>"
    return f'<!DOCTYPE html><html lang="en"><head>{head}{style}</head><body>{body}</body></html>'


def first_sentence(text: str) -> str:
    """Return the first sentence of a text alternative."""
    return re.split(r"(?<=\.)\s", text, maxsplit=1)[0]


def png_bytes(picture: Picture) -> bytes:
    """Return a picture as a .png of about 1,300 pixels, with its text alternative in the metadata.

    Raises ValueError where resvg is not installed, as in a browser.
    """
    from matplotlib import get_data_path
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    try:
        resvg = import_module("resvg_py")
    except ImportError:
        raise ValueError(
            "A picture needs the package resvg-py to be saved as .png, which a browser does not have. Save it as .svg."
        ) from None
    fonts = str(Path(get_data_path(), "fonts", "ttf"))  # the same letters on every system
    pixels = resvg.svg_to_bytes(
        svg_string=picture.svg, zoom=2, skip_system_fonts=True, font_dirs=[fonts], font_family="DejaVu Sans"
    )
    info, written = PngInfo(), io.BytesIO()
    info.add_text("Title", picture.caption or first_sentence(picture.alt))
    info.add_itxt("Description", picture.alt)
    Image.open(io.BytesIO(bytes(pixels))).save(written, "png", pnginfo=info)
    return written.getvalue()
