"""Pictures: a drawing together with its text alternative."""

import base64
import html
import io
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_vector
from kinlib.arrays.tolerances import TYPED_PI_ERROR
from kinlib.view.drawing.dark_theme import THEME_CSS, follow_theme

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MIN_ALT_CHARACTERS = 20
"""A shorter text alternative can name a figure, but cannot say what it shows."""


@dataclass(frozen=True)
class Picture:
    """A finished drawing as SVG, with a text alternative that says what it shows.

    Raises ValueError if the text alternative is shorter than MIN_ALT_CHARACTERS.

    >>> Picture("<svg></svg>", "A drawing with nothing in it.").html()
    '<figure class="kinlib-figure" ...><style>...</style><img alt="A drawing with nothing in it." ...></figure>'
    """

    svg: str
    alt: str
    caption: str = ""

    def __post_init__(self) -> None:
        if len(self.alt) < MIN_ALT_CHARACTERS:
            raise ValueError(
                f"alt must say what the figure shows, in at least {MIN_ALT_CHARACTERS} characters; got {self.alt!r}. "
                "Describe the figure as you would to someone who cannot see it."
            )

    def html(self) -> str:
        """Return the drawing as an HTML image with its text alternative, in the colours of the page's theme."""
        data = base64.b64encode(follow_theme(self.svg).encode()).decode()
        style = "max-width:100%"
        image = f'<img alt="{html.escape(self.alt)}" style="{style}" src="data:image/svg+xml;base64,{data}">'
        caption = f"<figcaption>{html.escape(self.caption)}</figcaption>" if self.caption else ""
        return f'<figure class="kinlib-figure" style="margin:0"><style>{THEME_CSS}</style>{image}{caption}</figure>'

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": self.alt}


@dataclass(frozen=True)
class Gallery:
    """Several small pictures side by side, in as many rows as the page needs.

    >>> Gallery((Picture("<svg></svg>", "A drawing with nothing in it."),)).html().count("<figure")
    1
    """

    pictures: tuple[Picture, ...]

    def html(self) -> str:
        """Return the pictures as HTML, each with its text alternative."""
        columns = "grid-template-columns:repeat(auto-fill,minmax(max(150px,28%),1fr))"
        pictures = "".join(picture.html() for picture in self.pictures)
        return f'<div style="display:grid;{columns};gap:.8em;align-items:end;max-width:50em">{pictures}</div>'

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": "\n".join(picture.alt for picture in self.pictures)}


def picture_from_figure(figure: "Figure", alt: str, caption: str = "") -> Picture:
    """Convert a matplotlib figure to a picture. Make the figure without pyplot, so that none is left open.

    Raises ValueError if the text alternative is shorter than MIN_ALT_CHARACTERS.

    >>> from matplotlib.figure import Figure
    >>> figure = Figure(figsize=(2, 1))
    >>> picture_from_figure(figure, "An empty figure, two inches wide.").alt
    'An empty figure, two inches wide.'
    """
    from matplotlib import rc_context

    buffer = io.StringIO()
    # With a fixed salt and no date, the same drawing always gives the same SVG text.
    with rc_context({"svg.hashsalt": "kinlib", "svg.fonttype": "path"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None}, facecolor="white")
    return Picture(buffer.getvalue(), alt, caption)


def vector_text(values: ArrayLike) -> str:
    """Write a vector for a text alternative: three significant digits, and 0 for rounding errors.

    >>> vector_text([0.5, -1e-17, 3])
    '(0.5, 0, 3)'
    """
    return format_vector(values, 3, zero=TYPED_PI_ERROR)
