"""HTML as a tree: what Sphinx, myst-nb, KaTeX and the packages have written is read, changed and written again."""

from html import escape

from lxml.html import HtmlElement, fragment_fromstring, tostring


def read_html(html: str) -> HtmlElement:
    """Read a part of a page. Returns an element that contains it."""
    return fragment_fromstring(f"<div>{html}</div>")


def inner_html(element: HtmlElement) -> str:
    """Write the content of an element as HTML.

    >>> inner_html(read_html("a &amp; <b>c</b>"))
    'a &amp; <b>c</b>'
    """
    text = escape(element.text or "", quote=False)
    return text + "".join(tostring(child, encoding="unicode") for child in element)
