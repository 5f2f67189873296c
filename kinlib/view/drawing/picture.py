"""Pictures: a drawing with its text alternative, never one without the other."""

import base64
import html
import io
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from kinlib.arrays.formatting import SHORT_PI, format_vector

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MIN_ALT_CHARACTERS = 20
"""Fewer characters than this name a figure and do not say what it shows."""


@dataclass(frozen=True)
class Picture:
    """A finished drawing as SVG, with what it shows in words.

    Raises ValueError for a text alternative that says too little.

    >>> Picture("<svg></svg>", "A drawing with nothing in it.").html()
    '<figure style="margin:0"><img alt="A drawing with nothing in it." ...></figure>'
    """

    svg: str
    alt: str
    caption: str = ""

    def __post_init__(self) -> None:
        if len(self.alt) < MIN_ALT_CHARACTERS:
            raise ValueError(
                f"alt should say what the figure shows, in at least {MIN_ALT_CHARACTERS} characters; got {self.alt!r}. "
                "What would you say of it on the telephone?"
            )

    def html(self) -> str:
        """The drawing as an image that carries its alternative."""
        data = base64.b64encode(self.svg.encode()).decode()
        style = "max-width:100%;background:white"
        image = f'<img alt="{html.escape(self.alt)}" style="{style}" src="data:image/svg+xml;base64,{data}">'
        caption = f"<figcaption>{html.escape(self.caption)}</figcaption>" if self.caption else ""
        return f'<figure style="margin:0">{image}{caption}</figure>'

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": self.alt}


def picture_from_figure(figure: "Figure", alt: str, caption: str = "") -> Picture:
    """Finish a matplotlib figure, made without pyplot so that nothing is left open.

    Raises ValueError for a text alternative that says too little.

    >>> from matplotlib.figure import Figure
    >>> figure = Figure(figsize=(2, 1))
    >>> picture_from_figure(figure, "An empty figure, two inches wide.").alt
    'An empty figure, two inches wide.'
    """
    from matplotlib import rc_context

    buffer = io.StringIO()
    # A fixed salt and no date: the same drawing is the same text, today and tomorrow.
    with rc_context({"svg.hashsalt": "kinlib", "svg.fonttype": "path"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None}, facecolor="white")
    return Picture(buffer.getvalue(), alt, caption)


def vector_text(values: ArrayLike) -> str:
    """Say a vector in a text alternative: three digits, and 0 for what rounding left over.

    >>> vector_text([0.5, -1e-17, 3])
    '(0.5, 0, 3)'
    """
    return format_vector(values, 3, zero=SHORT_PI)
