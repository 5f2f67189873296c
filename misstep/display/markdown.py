"""The subset of Markdown for explanations: paragraphs, lists, emphasis, code, links and formulas.

A library for Markdown would be one more dependency of misstep, and would not keep formulas for MathJax or KaTeX.
"""

import re
from html import escape, unescape
from itertools import groupby

from misstep.display.lecture_address import is_page

LITERAL = re.compile(r"(?<!`)`([^`]+)`(?!`)|\$\$(.+?)\$\$|\$([^$]+)\$", re.DOTALL)
"""Code and formulas, in which no other mark counts."""
KEPT = "\0{}\0"
"""What replaces code and formulas until all other marks are read."""
ITEM = re.compile(r"^([-*]|\d{1,2}\.)\s+")
CONTINUED = re.compile(r"[ \t]*\n[ \t]*(?![ \t\n]|$|[-*]\s|\d{1,2}\.\s)")

LINK_STYLE = "color:inherit;text-decoration:underline"
"""The colour of a theme's links may be hard to read on the background of a card."""
FOLLOW = """if (event.isTrusted) {
  const own = this.closest('.jp-NotebookPanel'), id = decodeURIComponent(this.hash.slice(1)), end = Date.now() + 60000;
  const others = () => [...document.querySelectorAll('.jp-NotebookPanel:not(.lm-mod-hidden)')].filter((one) => one !== own);
  const drawn = () => others().some((one) => [...one.querySelectorAll('h1,h2,h3')].some((h) => h.dataset.jupyterId === id));
  const wait = own && setInterval(() => {
    if (drawn()) this.click();
    if (drawn() || Date.now() > end) clearInterval(wait);
  }, 200);
}"""
"""JupyterLab scrolls to a section only if its notebook has been drawn. So click again when the section is there."""

CODE_STYLE = "background:transparent;color:inherit"


def markdown_html(text: str) -> str:
    r"""Return Markdown as HTML; formulas are left for MathJax or KaTeX, each on one line.

    A blank line separates paragraphs. A line that begins with "- " or "1. " is an item of a list. Within a line there are
    *emphasis*, **strong emphasis**, `code`, [links](address), and formulas between $ or $$.

    >>> markdown_html("Two *kinds*:\n- $a < b$\n- `c`, see [02](02_exp.ipynb).")[:52]
    '<p>Two <em>kinds</em>:</p><ul><li>$a &lt; b$</li><li'
    """
    kept: list[str] = []

    def keep(found: re.Match[str]) -> str:
        code, display, formula = found.groups()
        text = escape(" ".join((code or display or formula).split()))
        mark = "$$" if display else "$"
        kept.append(f'<code style="{CODE_STYLE}">{text}</code>' if code else f"{mark}{text}{mark}")
        return KEPT.format(len(kept) - 1)

    # A line that begins neither an item nor a paragraph continues the line above.
    lines = CONTINUED.sub(" ", LITERAL.sub(keep, text)).splitlines()
    html = ""
    for element, block in groupby(filter(str.strip, lines), _element):
        parts = [_marked_up(ITEM.sub("", line).strip()) for line in block]
        items = "".join(f"<li>{part}</li>" for part in parts)
        html += f"<{element}>{items}</{element}>" if element != "p" else "".join(f"<p>{part}</p>" for part in parts)
    return re.sub(KEPT.format(r"(\d+)"), lambda found: kept[int(found[1])], html)


def _element(line: str) -> str:
    item = ITEM.match(line)
    return "p" if item is None else "ul" if item[1] in "-*" else "ol"


def _marked_up(text: str) -> str:
    html = escape(text, quote=False)
    html = re.sub(r"\[([^\]]+)\]\(([^)\s]+)\)", lambda found: link_html(unescape(found[2]), found[1]), html)
    html = re.sub(r"\*\*(\S(?:.*?\S)?)\*\*", r"<strong>\1</strong>", html)
    return re.sub(r"\*(\S(?:.*?\S)?)\*", r"<em>\1</em>", html)


def link_html(address: str, html: str) -> str:
    """Return a link that has the colour of the text around it, and that leads to the section of a notebook in JupyterLab too."""
    follow = f' onclick="{escape(FOLLOW)}"' if ".ipynb#" in address and not is_page() else ""
    return f'<a href="{escape(address)}"{follow} style="{LINK_STYLE}">{html}</a>'
