"""Addresses of questions and figures, and for each question, viewer and slider a small page that other sites can show in a frame.

The page is embed/<page>/<id>.html. It contains the HTML that the lecture has, so both always show the same.
"""

import shutil
from html import escape
from pathlib import Path

from docutils import nodes
from docutils.nodes import make_id
from lxml.html import HtmlElement

from kinsite.html_tree import append_html, inner_html

QUESTION = ".//*[@data-misstep-question]"
FIGURE = ".//div[@data-kinlib-viewer or @data-kinlib-slides] | .//figure[@class='kinlib-figure']"
ANSWERED_WITH = ".//@data-misstep-question | .//@data-misstep-explain | .//@data-kinlib-after"
"""The name of a question: at the question itself, at its explanation, and at a picture that waits for its answer."""

PERMALINK = "¶"
"""What a link to copy shows; it is not a word of the text around it."""

PAGE = """\
<!doctype html>
<html lang="en" class="no-js" data-content_root="{up}"><head><meta charset="utf-8"><base href="{base}" target="_blank">
<meta name="viewport" content="width=device-width,initial-scale=1"><meta name="color-scheme" content="light dark">
<meta name="robots" content="noindex"><title>{kind}: {title}</title>
<link rel="icon" href="{up}_static/favicon.svg">
<link rel="stylesheet" href="{up}_static/styles/furo.css"><link rel="stylesheet" href="{up}_static/katex/katex.min.css">
<link rel="stylesheet" href="{up}_static/course.css">
<script defer src="{up}_static/course.js"></script><script defer src="{up}_static/loader.js"></script>
</head><body class="kinlib-embed" data-theme="auto"><main><article><h1 class="visually-hidden">{kind}: {title}</h1>
{html}
<p class="kinlib-about">From <a href="{page}.html#{anchor}">{title}</a>, a page of the course
<a href="{up}index.html">Forward kinematics</a>. Licence: CC BY 4.0.</p></article></main></body></html>
"""
"""Its links are relative to the page of the lecture, and open outside of the frame."""


def permalink(anchor: str, thing: str) -> str:
    """Write the link to copy of a single thing.

    >>> permalink("figure-row", "figure")
    '<a class="kinlib-permalink" href="#figure-row" title="Link to this figure" aria-label="Link to this figure">¶</a>'
    """
    title = f"Link to this {thing}"
    return f'<a class="kinlib-permalink" href="#{anchor}" title="{title}" aria-label="{title}">{PERMALINK}</a>'


def add_address(html: HtmlElement, cell: str, page: str, taken: set[str]) -> str:
    """Give an output its id, and below or in it the links to copy. Returns the id, or nothing if it has no address.

    The id of a figure is the name of its cell, which stays when figures are added before it.

    >>> from kinsite.html_tree import read_html
    >>> figure = read_html('<figure class="kinlib-figure"></figure>')
    >>> add_address(figure, "row", "lectures/05", {"figure-row"})
    'figure-row-2'
    """
    questions, figures = html.xpath(QUESTION), html.xpath(FIGURE)
    if not questions and not figures:
        return ""
    name = questions[0].get("data-misstep-question") if questions else ""
    wanted = make_id(f"question {name}" if questions else f"figure {cell}")
    anchor = next(name for k in range(1, 100) if (name := f"{wanted}-{k}" if k > 1 else wanted) not in taken)
    taken.add(anchor)
    (questions or figures)[0].set("id", anchor)
    link = permalink(anchor, "question" if questions else "figure")
    embed = f' <a class="kinlib-embed-link" href="{"../" * page.count("/")}embed/{page}/{anchor}.html">Embed</a>'
    if questions:
        append_html(html.find(".//p"), f" {link}{embed}")
    elif figures[0].tag == "figure":
        caption = figures[0].find("figcaption")
        append_html(figures[0] if caption is None else caption, f" {link}")
    else:
        append_html(html, f'<p class="kinlib-buttons">{link}{embed}</p>')
    return anchor


def write_pages(built: Path, page: str, title: str, outputs: list[tuple[HtmlElement, str]]) -> None:
    """Write the pages for frames of one page of the site, and remove those of an earlier build.

    outputs  each output, and its id or nothing
    """
    folder = built / "embed" / page
    shutil.rmtree(folder, ignore_errors=True)
    names = [next(iter(html.xpath(ANSWERED_WITH)), "") for html, _ in outputs]
    for (html, anchor), name in zip(outputs, names, strict=True):
        is_question = anchor.startswith("question-")
        if not html.find_class("kinlib-embed-link"):
            continue
        # a prediction is explained elsewhere on its page, and a picture may wait for it
        shown = (
            [other for (other, _), its in zip(outputs, names, strict=True) if its == name] if is_question else [html]
        )
        folder.mkdir(parents=True, exist_ok=True)
        text = PAGE.format(
            up="../" * page.count("/"), base="../" * (page.count("/") + 2) + f"{page}.html", page=page.rpartition("/")[2],
            kind="Question" if is_question else "Figure", title=escape(title), anchor=anchor,
            html="\n".join(map(inner_html, shown)),
        )  # fmt: skip
        (folder / f"{anchor}.html").write_text(text, "utf-8")


def cell_of(node: nodes.Node) -> str:
    """Return the name of the notebook's cell that a node is an output of; nothing on other pages."""
    while node is not None and "cell_metadata" not in getattr(node, "attributes", {}):
        node = node.parent
    return str(node["cell_metadata"].get("kinlib-cell", "")) if isinstance(node, nodes.Element) else ""
