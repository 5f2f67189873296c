"""The visible form of a formula waits in a template until the reader comes near: a lecture has hundreds of formulas.

KaTeX writes each formula twice: as MathML for screen readers, and as the elements that are seen, which are about half
of all elements of a lecture. Until static/formulas.js draws these, a browser shows the MathML.
"""

import re

VISIBLE = re.compile(r'<span class="katex-html"')
SPAN = re.compile(r"<(/?)span\b")
BEGIN, END = "<kinlib-formula><template>", "</template></kinlib-formula>"


def defer(html: str, at_once: int) -> str:
    """Put the visible form of each formula into a template, except for the first ones, which are in sight at once.

    >>> defer('<span class="katex-html"><span>x</span></span>.', at_once=0)
    '<kinlib-formula><template><span class="katex-html"><span>x</span></span></template></kinlib-formula>.'
    """
    parts, position = [], 0
    for found in list(VISIBLE.finditer(html))[at_once:]:
        end = end_of_span(html, found.start())
        parts += [html[position : found.start()], BEGIN, html[found.start() : end], END]
        position = end
    return "".join([*parts, html[position:]])


def end_of_span(html: str, start: int) -> int:
    """Return the position after the span that begins at `start`, with all the spans in it."""
    depth = 0
    for found in SPAN.finditer(html, start):
        depth += -1 if found[1] else 1
        if depth == 0:
            return html.index(">", found.end()) + 1
    raise ValueError(f"a span must be closed; this one is not: {html[start : start + 80]}")


def show_all(html: str) -> str:
    """Take the formulas out of their templates, for a document without scripts.

    >>> show_all(defer('<span class="katex-html">x</span>', at_once=0))
    '<span class="katex-html">x</span>'
    """
    return html.replace(BEGIN, "").replace(END, "")
