"""Cards: feedback in a frame, with an icon and a title, so that no information depends on colour alone."""

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from misstep.display.markdown import CODE_STYLE, link_html, markdown_html

TONES = {
    "right": ("✓", "#1a7f37", "Right"),
    "partly": ("◐", "#8a5a00", "Partly right"),
    "wrong": ("✗", "#b42318", "Not yet"),
    "open": ("✎", "#0b5cad", "To be marked by your instructor"),
    "blank": ("…", "#57606a", "Nothing here yet"),
    "unreadable": ("?", "#6e40c9", "This cannot be read as an answer"),
    "note": ("i", "#0b5cad", ""),
}
"""For each tone the icon, the colour of the edge, and the title of the card of an answer in this state."""

PAPER = "var(--jp-layout-color1,#fff)"
INK = "var(--jp-content-font-color1,#1f2328)"
"""The colours of JupyterLab's theme, light or dark; a page without them is light."""

TITLE_SHARE, PAPER_SHARE = 50, 8
"""How much of its tone the title and the background of a card have, in percent."""

FRAME = (
    f"border-left:5px solid {{tone}};background:color-mix(in srgb,{{tone}} {PAPER_SHARE}%,{PAPER});color:{INK};"
    "padding:.6em 1em;margin:.4em 0;max-width:46em"
)
TITLE = f"margin:0;font-weight:600;color:color-mix(in srgb,{{tone}} {TITLE_SHARE}%,{INK})"


@dataclass(frozen=True)
class Link:
    """A paragraph that leads to an address; without an address it is plain text.

    address  with https or http, or relative to the notebook
    """

    text: str
    address: str = ""


@dataclass(frozen=True)
class Card:
    """A short message with a title: the feedback after a check.

    Paragraphs may contain `code` and $mathematics$. The text of a pair ("pre", text) is shown unchanged, in a fixed-width font;
    that of a pair ("markdown", text) is Markdown, and only an author of the course may have written it. Otherwise a Link is the
    only paragraph that can be followed: nothing in a text becomes a link.

    >>> card = Card("right", "Well done", ["All < 1."])
    >>> print(card.text())
    ✓ Well done
      All < 1.
    >>> "All &lt; 1." in card.html()
    True
    """

    tone: str
    title: str
    body: Sequence[str | tuple[str, str] | Link] = ()

    def html(self) -> str:
        """Return the card as HTML, with special characters of messages escaped."""
        icon, tone, _ = TONES[self.tone]
        title = f'<p style="{TITLE.format(tone=tone)}"><span aria-hidden="true">{icon}</span> {inline(self.title)}</p>'
        body = "".join(_paragraph(part) for part in self.body)
        return f'<div role="status" style="{FRAME.format(tone=tone)}">{title}{body}</div>'

    def text(self) -> str:
        """Return the card as plain text, for a terminal."""
        texts = (one if isinstance(one, str) else one.text if isinstance(one, Link) else one[1] for one in self.body)
        indented = ("  " + line for text in texts for line in text.splitlines())
        return "\n".join([f"{TONES[self.tone][0]} {self.title}", *indented])

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html(), "text/plain": self.text()}


def _paragraph(part: str | tuple[str, str] | Link) -> str:
    if isinstance(part, Link) and part.address:
        return f'<p style="margin:.4em 0 0">{link_html(part.address, inline(part.text))}</p>'
    if not isinstance(part, tuple):
        return f'<p style="margin:.4em 0 0">{inline(part if isinstance(part, str) else part.text)}</p>'
    if part[0] == "markdown":
        return f'<div style="margin:.8em 0 0">{markdown_html(part[1])}</div>'
    style = "margin:.4em 0 0;background:transparent;color:inherit;white-space:pre;overflow-x:auto"
    return f'<pre style="{style}">{html.escape(part[1])}</pre>'


def inline(text: str) -> str:
    """Return a line of text as HTML: special characters escaped, `code` marked up, formulas left for MathJax or KaTeX."""
    return re.sub(r"`([^`]+)`", rf'<code style="{CODE_STYLE}">\1</code>', html.escape(text))
