"""The course as one document to print: the lectures one after the other, with what they refer to and with their answers.

It is put together from pages that are built, so it says what they say.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from posixpath import dirname, join, normpath

from kinsite.sources import LECTURES

PAGES = (*(f"lectures/{path.stem}.html" for path in LECTURES), "notation.html", "glossary.html")
"""What is printed. Sheets have numbers of each student's own, and robots are to be turned."""

ARTICLE = re.compile(r'<article role="main"[^>]*>(.*?)</article>', re.DOTALL)
FOR_SCREENS = re.compile(
    r'<p class="kinlib-bar">.*?</p>|<div class="kinlib-done".*?</div>|<a class="headerlink".*?</a>'
    r"|<script.*?</script>",
    re.DOTALL,
)
IDS = re.compile(r'\b(id|for|aria-labelledby|aria-describedby)="([^"]+)"')
LINKS = re.compile(r'\b(href|src)="(?![a-z]+:|//)([^"#]*)(#[^"]*)?"')
ASKED = re.compile(r'data-misstep-question="[^"]+"[^>]*data-right="(\d)"')
LETTERS = "ABCDEFGH"

BOOK = """\
<!doctype html>
<html lang="en" class="no-js"><head><meta charset="utf-8"><title>Forward kinematics</title>
<link rel="stylesheet" href="{folder}/_static/pygments.css"><link rel="stylesheet" href="{folder}/_static/styles/furo.css">
<link rel="stylesheet" href="{folder}/_static/katex/katex.min.css"><link rel="stylesheet" href="{folder}/_static/course.css">
</head><body data-theme="light" class="kinlib-book">
<h1>Forward kinematics</h1><p>Where is the tool? The lectures of the course, to print. On the pages arms turn, questions take
an answer, and every cell runs: <a href="{address}">{address}</a></p><ul>{contents}</ul>
{articles}
</body></html>
"""


def book(built: Path, folder: str, address: str, pages: Sequence[str] = PAGES) -> str:
    """One HTML document of several pages.

    built    where the pages are
    folder   the same, as seen from where the document will be
    address  where the site is read; what is not printed is linked there
    """
    texts = {page: found[1] for page in pages if (found := ARTICLE.search((built / page).read_text("utf-8")))}
    titles = {
        page: re.sub(r"<h1>(.*?)</h1>.*", r"\1", FOR_SCREENS.sub("", text[text.index("<h1") :]), flags=re.DOTALL)
        for page, text in texts.items()
    }
    contents = "".join(f'<li><a href="#{name(page)}">{title}</a></li>' for page, title in titles.items())
    articles = "\n".join(
        f'<article id="{name(page)}">{bound(text, page, texts, folder, address)}</article>'
        for page, text in texts.items()
    )
    return BOOK.format(folder=folder, address=address, contents=contents, articles=articles)


def name(page: str) -> str:
    """What a page is called within the document.

    >>> name("lectures/04_poe_body.html")
    'lectures-04_poe_body'
    """
    return page.removesuffix(".html").replace("/", "-")


def bound(html: str, page: str, among: Sequence[str] | dict[str, str], folder: str, address: str) -> str:
    """The text of a page within the document: names that are its own, links that lead there, answers at its end."""

    def led(found: re.Match[str]) -> str:
        kind, path, part = found[1], found[2], found[3] or ""
        target = normpath(join(dirname(page), path)) if path else page
        if kind == "src":
            return f'src="{folder}/{target}"'
        if target in among:
            return f'href="#{name(target)}{"--" + part[1:] if part else ""}"'
        return f'href="{address}{target}{part}"'

    html = FOR_SCREENS.sub("", html)
    html = IDS.sub(lambda found: f'{found[1]}="{name(page)}--{found[2]}"', LINKS.sub(led, html))
    html = re.sub(r"(<[^>]*data-(?:kinlib-drawing|misstep-explain)[^>]*>)<details>", r"\1<details open>", html)
    html = html.replace(' loading="lazy"', "")
    right = [LETTERS[int(index)] for index in ASKED.findall(html)]
    if not right:
        return html
    told = ", ".join(f"{number} {letter}" for number, letter in enumerate(right, start=1))
    return f"{html}<h2>Answers</h2><p>To the questions of this lecture, in their order: {told}. The pages say why.</p>"
