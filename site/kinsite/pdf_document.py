"""The lectures as one HTML document, which site/pdf.py prints: what they refer to and the answers are in it too.

The document is composed of the pages that have been built, so it has the same text as they have.
"""

import re
from collections.abc import Collection, Mapping, Sequence
from copy import deepcopy
from datetime import UTC, datetime
from pathlib import Path
from posixpath import dirname, join, normpath
from types import MappingProxyType

from lxml.html import HtmlElement, document_fromstring, tostring
from lxml.html.builder import P

import kinlib
from kinsite.html_tree import inner_html
from kinsite.late_formulas import show_all
from kinsite.sphinx_source import LECTURES

PAGES = (*(f"lectures/{path.stem}.html" for path in LECTURES), "notation.html", "glossary.html")
"""The pages to print. Sheets are left out because each student has other numbers, and robots because they are interactive."""

SCREEN_ONLY = ("kinlib-bar", "kinlib-done", "headerlink")
"""The classes of what is not printed."""
REFERENCES = {"id", "for", "aria-labelledby", "aria-describedby"}
"""The attributes that contain ids."""
OPTION_LETTERS = "ABCDEFGH"
EMPTY: Mapping[str, int] = MappingProxyType({})

DOCUMENT = """\
<!doctype html>
<html lang="en" class="no-js"><head><meta charset="utf-8"><title>Forward kinematics</title>
<link rel="stylesheet" href="{folder}/_static/pygments.css"><link rel="stylesheet" href="{folder}/_static/styles/furo.css">
<link rel="stylesheet" href="{folder}/_static/katex/katex.min.css"><link rel="stylesheet" href="{folder}/_static/course.css">
<style>{heads}</style></head><body data-theme="light" class="kinlib-book">
<section class="kinlib-cover"><h1>Forward kinematics</h1><p>Where is the tool? The lectures of the course, for printing.</p>
<img src="{folder}/_static/opengraph.png" alt="An arm with its screw axes, and the words: where is the tool?">
<p>{author}. Version {version}, printed on {date}.</p><p>Lectures: Creative Commons Attribution 4.0. Code: MIT licence.</p>
<p>On the website you can move the arms, answer the questions and run every cell{website}</p></section>
<nav class="kinlib-contents"><h2>Contents</h2><ul>{contents}</ul>
<p>The exercise sheets, the robots, the mistakes and the reference of the library are on the website.</p></nav>
{articles}
<script>{fit}</script></body></html>
"""

FIT = """
const formulas = [...document.querySelectorAll('.katex-display > .katex')];
const show = (display) => formulas.forEach((formula) => { formula.style.display = display; });
show('inline-block');
const shrink = formulas.map((formula) => 720 / formula.getBoundingClientRect().width);
show('');
formulas.forEach((formula, i) => { if (shrink[i] < 1) formula.parentElement.style.fontSize = `${shrink[i]}em`; });
for (const pre of document.querySelectorAll('pre')) {
  const widths = pre.textContent.split('\\n').map((line) => line.length).filter((width) => width <= 120);
  pre.style.fontSize = `min(7.5pt, ${262 / Math.max(...widths)}mm)`;
}
for (const formula of document.querySelectorAll('.math > .katex')) {
  const text = formula.parentElement.nextSibling;
  const mark = text?.nodeType === 3 && /^[.,;:?!)]+/.exec(text.data)?.[0];
  if (mark) {
    [...formula.querySelectorAll('.base')].at(-1).append(mark);
    text.deleteData(0, mark.length);
  }
}
"""
"""Shrinks the formulas that are wider than a page: 720 pixels of the screen are 45 em, and a line of a page has 47.

It shrinks code and its output, too, so that lines of up to 120 characters are not broken: a character is 0.6 em wide, and
the narrowest block of code has 158 mm for its text. And it puts a punctuation mark into the formula before it, because
Chromium may begin a line between the two.
"""

MAX_SLIDES = 6
"""How many pictures of a slider are printed, from its first position to its last."""

RUNNING_HEAD = """\
@page {name} {{ @top-right {{ content: "{title}"; font: 8.5pt sans-serif; color: #57606a; }} }}
#{anchor} {{ page: {name}; }}
"""
"""The title of a lecture at the top of each of its pages."""


def compose_document(
    built: Path, folder: str, address: str, pages: Sequence[str] = PAGES, numbers: Mapping[str, int] = EMPTY
) -> str:
    """Compose one HTML document of several pages.

    built    the folder that the pages were built into
    folder   the same folder, relative to the document
    address  the address of the published site; links to pages that are not printed lead there, or nowhere if it is empty
    numbers  for the squeezed title of each page the number of the sheet of paper on which it begins, once that is known
    """
    articles = {page: read_article(built / page) for page in pages}
    titles = {page: article.find(".//h1") for page, article in articles.items()}
    contents = "".join(
        f'<li><a href="#{anchor(page)}">{label(page, inner_html(title))}</a> '
        f"<span>{numbers.get(squeeze(title.text_content()), '')}</span></li>"
        for page, title in titles.items()
    )
    heads = "\n".join(
        RUNNING_HEAD.format(
            name=f"head{k}", anchor=anchor(page), title=label(page, title.text_content().strip()).replace('"', "")
        )
        for k, (page, title) in enumerate(titles.items())
    )
    printed = "\n".join(
        f'<article id="{anchor(page)}">{adapt(article, page, articles, folder, address)}</article>'
        for page, article in articles.items()
    )
    website = f': <a href="{address}">{address}</a>' if address else "."
    today = datetime.now(UTC).date().isoformat()
    return DOCUMENT.format(
        folder=folder, website=website, contents=contents, articles=printed, heads=heads, fit=FIT,
        author="The kinlib authors", version=kinlib.__version__, date=today,
    )  # fmt: skip


def read_article(page: Path) -> HtmlElement:
    """Read the article of a page, without what is for the screen only."""
    (article,) = document_fromstring(show_all(page.read_text("utf-8"))).xpath('//article[@role="main"]')
    for element in [*article.iter("script"), *(one for name in SCREEN_ONLY for one in article.find_class(name))]:
        element.drop_tree()
    return article


def squeeze(title: str) -> str:
    """Remove the spaces from a title: in its outline, Chromium leaves out the space at which a heading was broken.

    >>> squeeze("Closed chains")
    'Closedchains'
    """
    return "".join(title.split())


def label(page: str, title: str) -> str:
    """Return the title of a page with the number of the lecture, if it has one.

    >>> label("lectures/04_poe_body.html", "PoE in the body frame")
    '04 PoE in the body frame'
    >>> label("lectures/04b_velocity.html", "Velocity"), label("lectures/errata.html", "Errata")
    ('04b Velocity', 'Errata')
    """
    number = re.match(r"lectures/(\d\d[a-z]?)_", page)
    return f"{number[1]} {title}" if number and not title.startswith(number[1]) else title


def anchor(page: str) -> str:
    """Name the id of a page within the document.

    >>> anchor("lectures/04_poe_body.html")
    'lectures-04_poe_body'
    """
    return page.removesuffix(".html").replace("/", "-")


def adapt(article: HtmlElement, page: str, printed: Collection[str], folder: str, address: str) -> str:
    """Adapt a page's text to the document: make its ids unique, redirect its links, append the answers."""

    def redirect(attribute: str, link: str) -> str:
        path, _, fragment = link.partition("#")
        target = normpath(join(dirname(page), path)) if path else page
        if attribute == "src":
            return f"{folder}/{target}"
        if target in printed:
            return f"#{anchor(target)}{'--' + fragment if fragment else ''}"
        return f"{address}{target}{'#' + fragment if fragment else ''}" if address else ""

    for element in article.iter("*"):
        attributes = element.attrib
        for name in REFERENCES.intersection(attributes):
            attributes[name] = " ".join(f"{anchor(page)}--{one}" for one in attributes[name].split())
        for name in {"href", "src"}.intersection(attributes):
            if not re.match(r"[a-z]+:|//", attributes[name]):
                attributes[name] = redirect(name, attributes[name])
                if not attributes[name]:
                    del attributes[name]
        attributes.pop("loading", None)
    for fold in article.iter("details"):
        if fold.get("class") != "misstep-option":  # pictures that wait, sections and code that may be skipped
            fold.set("open", "")
    for slides in article.xpath(".//div[@data-kinlib-slides]"):
        thin_out(slides)
    return move_answers(article)


def thin_out(slides: HtmlElement) -> None:
    """Keep at most MAX_SLIDES pictures of a slider, evenly from the first to the last."""
    pictures = slides.xpath(".//div[@data-value]")
    gaps = max(1, min(MAX_SLIDES, len(pictures)) - 1)
    kept = {round(k * (len(pictures) - 1) / gaps) for k in range(gaps + 1)}
    for number, picture in enumerate(pictures):
        if number not in kept:
            picture.drop_tree()


def move_answers(article: HtmlElement) -> str:
    """Move the explanations of predictions to the end of the lecture, with the right answer to every question and its reason.

    The pictures of a slider that waits for a prediction show the answer, so they are moved there as well.

    Returns the HTML of the lecture.
    """
    pictures: dict[str, str] = {}
    for slides in article.xpath(".//div[@data-kinlib-slides][@data-kinlib-after]"):
        name = slides.get("data-kinlib-after")
        pictures[name] = pictures.get(name, "") + tostring(slides, encoding="unicode", with_tail=False)
        slides.drop_tree()
    explanations = {one.get("data-misstep-explain"): one for one in article.xpath(".//*[@data-misstep-explain]")}
    questions = article.xpath(".//*[@data-misstep-question]")
    answers = []
    for number, question in enumerate(questions, start=1):
        name, right = question.get("data-misstep-question"), int(question.get("data-right"))
        explanation = explanations.get(name, question)
        reason = deepcopy(explanation.find_class("misstep-why")[right])
        reason[0].drop_tree()  # the verdict
        lesson = "".join(inner_html(one) for one in explanation.find_class("misstep-lesson"))
        answers.append(
            f'<div class="kinlib-answer"><p><strong>{number} {OPTION_LETTERS[right]}.</strong> {inner_html(reason).strip()}</p>'
            f"{lesson}{pictures.get(name, '')}</div>"
        )
    numbers = {question.get("data-misstep-question"): number for number, question in enumerate(questions, start=1)}
    for name, explanation in explanations.items():
        if name in numbers:
            where = f"answer {numbers[name]}{' and its pictures' * (name in pictures)}"
            explanation.addprevious(P(f"Compare with {where} at the end of this lecture."))
        explanation.drop_tree()
    return inner_html(article) + (f"<h2>Answers</h2>{''.join(answers)}" if answers else "")
