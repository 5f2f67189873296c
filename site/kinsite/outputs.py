"""What cells have shown, made fit for a page: formulas set, pictures as files of their own, no state of widgets.

In a lab, formulas in HTML are set by the lab. Here they are set while the page is built, as those of the text are.
"""

import base64
import hashlib
import re
from functools import cache
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinxcontrib import katex

katex.KATEX_DEFAULT_OPTIONS.update(throwOnError=True, strict="error")  # a formula that does not set fails the build

PICTURE = re.compile(r'<img ([^>]*?)src="data:image/(svg\+xml|png);base64,([^"]+)"')
APART = re.compile(r"(<(script|style|pre|code|textarea|svg)\b.*?</\2>|<[^>]+>)", re.DOTALL)
"""What of HTML is no running text."""
PUNCTUATION = re.compile(r"[.,;:?!)\]’”]+")
SHORT = 24
"""So many letters of LaTeX fit on the line of any phone: what is longer may break within."""
FORMULA = re.compile(r"\$\$(.+?)\$\$|(?<!\\)\$([^$\n]+?)\$")


def setup(app: Sphinx) -> dict[str, Any]:
    """Tell Sphinx what to call, and when."""
    katex.render_latex = cache_of(katex.render_latex)
    app.connect("doctree-resolved", mend)
    app.connect("html-page-context", without_widget_state, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": False}


def mend(app: Sphinx, doctree: nodes.document, page: str) -> None:
    """Set the formulas in each piece of HTML of a page, take the pictures out of it, and hold what stands together."""
    for formula in list(doctree.findall(nodes.math)):
        hold(formula)
    up = "../" * page.count("/")
    folder = Path(app.outdir) / "_images"
    for node in doctree.findall(nodes.raw):
        if node.get("format") == "html":
            text = pictured(formulas(node.astext()), folder, f"{up}_images")
            node.children = [nodes.Text(text)]
            node.rawsource = text


def hold(formula: nodes.math) -> None:
    """Keep a short formula and what punctuates it in one line: a browser may break a line behind any formula."""
    follows = formula.next_node(descend=False, siblings=True)
    mark = PUNCTUATION.match(follows.astext()) if isinstance(follows, nodes.Text) else None
    if mark is None or len(formula.astext()) > SHORT:
        return
    rest = nodes.Text(follows.astext()[mark.end() :])
    follows.parent.replace(follows, rest)
    formula.parent.replace(formula, together := nodes.inline(classes=["together"]))
    together += [formula, nodes.Text(mark[0])]


def formulas(html: str) -> str:
    """HTML with its formulas set: $...$ within the line, $$...$$ on a line of their own.

    >>> formulas('<pre>$5</pre><code>$a$</code>')
    '<pre>$5</pre><code>$a$</code>'
    """
    pieces = APART.split(html)
    # split gives text, what is apart, the name of its element, text, ...
    return "".join(
        FORMULA.sub(typeset, piece) if index % 3 == 0 else piece for index, piece in enumerate(pieces) if index % 3 != 2
    )


def typeset(found: re.Match[str]) -> str:
    """One formula, as KaTeX sets it."""
    from html import unescape

    latex = unescape(found[1] or found[2])
    options = {"displayMode": True} if found[1] else None
    return f'<span class="math">{katex.render_latex(latex, options)}</span>'


def pictured(html: str, folder: Path, where: str) -> str:
    """HTML whose pictures stand in files, which a browser fetches when they come into view."""

    def taken_out(found: re.Match[str]) -> str:
        data = base64.b64decode(found[3])
        name = f"{hashlib.sha256(data).hexdigest()[:20]}.{'svg' if found[2] != 'png' else 'png'}"
        folder.mkdir(parents=True, exist_ok=True)
        if not (folder / name).exists():
            (folder / name).write_bytes(data)
        return f'<img loading="lazy" {found[1]}{size(data)}src="{where}/{name}"'

    return PICTURE.sub(taken_out, html)


def size(svg: bytes) -> str:
    """The width and height of a drawing, so that the page does not jump when it arrives."""
    head = svg[: svg.find(b">", svg.find(b"<svg"))] if b"<svg" in svg else b""
    found = {side: re.search(rb'\b%s="([\d.]+)(?:pt|px)?"' % side, head) for side in (b"width", b"height")}
    if not all(found.values()):
        return ""
    return "".join(f'{side.decode()}="{round(float(value[1]))}" ' for side, value in found.items() if value)


def without_widget_state(_: Sphinx, *about: Any) -> None:
    """Leave the state of widgets out of a page: without a kernel, nobody asks for it."""
    files = about[2].get("script_files", [])
    files[:] = [file for file in files if "widget-state" not in str(getattr(file, "attributes", {}).get("type", ""))]


def cache_of(render: Any) -> Any:
    """Remember what has been set: the same formula stands in many places."""

    @cache
    def once(latex: str, options: tuple[tuple[str, Any], ...]) -> str:
        return str(render(latex, dict(options) or None))

    return lambda latex, options=None: once(latex, tuple(sorted((options or {}).items())))
