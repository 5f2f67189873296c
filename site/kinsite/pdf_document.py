"""The lectures as one HTML document, which site/pdf.py prints: what they refer to and the answers are in it too.

The document is composed of the pages that have been built, so it has the same text as they have.
"""

import re
from collections.abc import Collection, Mapping, Sequence
from datetime import UTC, datetime
from html import unescape
from pathlib import Path
from posixpath import dirname, join, normpath
from types import MappingProxyType

import kinlib
from kinsite.late_formulas import show_all
from kinsite.sphinx_source import LECTURES

PAGES = (*(f"lectures/{path.stem}.html" for path in LECTURES), "notation.html", "glossary.html")
"""The pages to print. Sheets are left out because each student has other numbers, and robots because they are interactive."""

ARTICLE = re.compile(r'<article role="main"[^>]*>(.*?)</article>', re.DOTALL)
SCREEN_ONLY = re.compile(
    r'<p class="kinlib-bar">.*?</p>|<div class="kinlib-done".*?</div>|<a class="headerlink".*?</a>'
    r"|<script.*?</script>",
    re.DOTALL,
)
IDS = re.compile(r'\b(id|for|aria-labelledby|aria-describedby)="([^"]+)"')
LINKS = re.compile(r'\b(href|src)="(?![a-z]+:|//)([^"#]*)(#[^"]*)?"')
QUESTION = re.compile(r'data-misstep-question="([^"]+)"[^>]*data-right="(\d)".*?</ol></div>', re.DOTALL)
EXPLANATION = re.compile(r'<div [^>]*data-misstep-explain="([^"]+)".*?</details></div>', re.DOTALL)
REASON = re.compile(r'<p class="misstep-why"><strong>[^<]*</strong>\s*(.*?)</p>', re.DOTALL)
SLIDES = re.compile(r"<div data-kinlib-slides.*?</figure></div>(?!<div data-value)", re.DOTALL)
WAITING = re.compile(r'<div data-kinlib-slides[^>]*data-kinlib-after="([^"]+)".*?</details></div>', re.DOTALL)
SLIDE = re.compile(r"<div data-value=.*?</figure></div>", re.DOTALL)
LESSON = re.compile(r'<div class="misstep-lesson">(.*?)</div>', re.DOTALL)
OPTION_LETTERS = "ABCDEFGH"
OUTLINE_ENTRY = (rb"/Title (\(.*?(?<!\\)\)|<[^>]+>)", rb"/Dest \[(\d+) 0 R", rb"/Parent (\d+) 0 R")
"""The title of an entry of a PDF's outline, the page that it leads to, and the entry above it."""
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
    built_pages = {page: show_all((built / page).read_text("utf-8")) for page in pages}
    texts = {page: found[1] for page, html in built_pages.items() if (found := ARTICLE.search(html))}
    titles = {
        page: re.sub(r"<h1>(.*?)</h1>.*", r"\1", SCREEN_ONLY.sub("", text[text.index("<h1") :]), flags=re.DOTALL)
        for page, text in texts.items()
    }
    contents = "".join(
        f'<li><a href="#{anchor(page)}">{label(page, title)}</a> <span>{numbers.get(squeeze(plain(title)), "")}</span></li>'
        for page, title in titles.items()
    )
    heads = "\n".join(
        RUNNING_HEAD.format(name=f"head{k}", anchor=anchor(page), title=plain(label(page, title)).replace('"', ""))
        for k, (page, title) in enumerate(titles.items())
    )
    articles = "\n".join(
        f'<article id="{anchor(page)}">{adapt(text, page, texts, folder, address)}</article>'
        for page, text in texts.items()
    )
    website = f': <a href="{address}">{address}</a>' if address else "."
    today = datetime.now(UTC).date().isoformat()
    return DOCUMENT.format(
        folder=folder, website=website, contents=contents, articles=articles, heads=heads, fit=FIT,
        author="The kinlib authors", version=kinlib.__version__, date=today,
    )  # fmt: skip


def plain(title: str) -> str:
    """Return a title without the elements of HTML.

    >>> plain("<em>DH</em> &amp; more")
    'DH & more'
    """
    return unescape(re.sub(r"<[^>]+>", "", title)).strip()


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


def page_numbers(pdf: bytes) -> dict[str, int]:
    """Read from the outline of a PDF by Chromium on which sheet of paper each heading of the first level begins.

    Returns the numbers by the squeezed headings.
    """
    objects = dict(re.findall(rb"^(\d+) 0 obj\n(.*?)\nendobj", pdf, re.DOTALL | re.MULTILINE))
    order = [number for number, text in objects.items() if b"/Type /Page\n" in text]
    numbers = {}
    for text in objects.values():
        title, target, parent = (re.search(pattern, text, re.DOTALL) for pattern in OUTLINE_ENTRY)
        if title and target and parent and b"/Title" not in objects[parent[1]]:
            numbers[squeeze(outline_text(title[1]))] = order.index(target[1]) + 1
    return numbers


def outline_text(text: bytes) -> str:
    r"""Decode a string of a PDF.

    >>> outline_text(rb"(a \(b\))"), outline_text(b"<FEFF00E9>")
    ('a (b)', 'é')
    """
    data = bytes.fromhex(text[1:-1].decode()) if text.startswith(b"<") else re.sub(rb"\\(.)", rb"\1", text[1:-1])
    return data[2:].decode("utf-16-be") if data.startswith(b"\xfe\xff") else data.decode("latin-1")


def anchor(page: str) -> str:
    """Name the id of a page within the document.

    >>> anchor("lectures/04_poe_body.html")
    'lectures-04_poe_body'
    """
    return page.removesuffix(".html").replace("/", "-")


def adapt(html: str, page: str, printed: Collection[str], folder: str, address: str) -> str:
    """Adapt a page's text to the document: make its ids unique, redirect its links, append the answers."""

    def redirect(found: re.Match[str]) -> str:
        attribute, path, fragment = found[1], found[2], found[3] or ""
        target = normpath(join(dirname(page), path)) if path else page
        if attribute == "src":
            return f'src="{folder}/{target}"'
        if target in printed:
            return f'href="#{anchor(target)}{"--" + fragment[1:] if fragment else ""}"'
        return f'href="{address}{target}{fragment}"' if address else ""

    html = SCREEN_ONLY.sub("", html)
    html = IDS.sub(lambda found: f'{found[1]}="{anchor(page)}--{found[2]}"', LINKS.sub(redirect, html))
    html = html.replace(' loading="lazy"', "")
    # pictures that wait for a prediction, sections and code that may be skipped
    html = re.sub(r'<details(?! class="misstep-option")', "<details open", html)
    return move_answers(SLIDES.sub(lambda found: thin_out(found[0]), html))


def thin_out(slides: str) -> str:
    """Keep at most MAX_SLIDES pictures of a slider, evenly from the first to the last."""
    pictures = SLIDE.findall(slides)
    gaps = max(1, min(MAX_SLIDES, len(pictures)) - 1)
    kept = {round(k * (len(pictures) - 1) / gaps) for k in range(gaps + 1)}
    numbers = iter(range(len(pictures)))
    return SLIDE.sub(lambda found: found[0] if next(numbers) in kept else "", slides)


def move_answers(html: str) -> str:
    """Move the explanations of predictions to the end of the lecture, with the right answer to every question and its reason.

    The pictures of a slider that waits for a prediction show the answer, so they are moved there as well.
    """
    pictures: dict[str, str] = {}
    for found in WAITING.finditer(html):
        pictures[found[1]] = pictures.get(found[1], "") + found[0]
    html = WAITING.sub("", html)
    explanations = {found[1]: found[0] for found in EXPLANATION.finditer(html)}
    answers, numbers = [], {}
    for number, found in enumerate(QUESTION.finditer(html), start=1):
        numbers[found[1]] = number
        explanation = explanations.get(found[1], found[0])
        reason = REASON.findall(explanation)[int(found[2])]
        lesson = LESSON.search(explanation)
        letter = OPTION_LETTERS[int(found[2])]
        answers.append(
            f'<div class="kinlib-answer"><p><strong>{number} {letter}.</strong> {reason}</p>'
            f"{lesson[1] if lesson else ''}{pictures.get(found[1], '')}</div>"
        )
    html = EXPLANATION.sub(
        lambda found: (
            f"<p>Compare with answer {numbers[found[1]]}{' and its pictures' * (found[1] in pictures)} at the end of this lecture.</p>"
            if found[1] in numbers
            else ""
        ),
        html,
    )
    return f"{html}<h2>Answers</h2>{''.join(answers)}" if answers else html
