"""The lectures as one HTML document, which site/pdf.py prints: what they refer to and the answers are in it too.

The document is composed of the pages that have been built, so it has the same text as they have.
"""

import re
from collections.abc import Collection, Sequence
from pathlib import Path
from posixpath import dirname, join, normpath

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
LESSON = re.compile(r'<div class="misstep-lesson">(.*?)</div>', re.DOTALL)
OPTION_LETTERS = "ABCDEFGH"

DOCUMENT = """\
<!doctype html>
<html lang="en" class="no-js"><head><meta charset="utf-8"><title>Forward kinematics</title>
<link rel="stylesheet" href="{folder}/_static/pygments.css"><link rel="stylesheet" href="{folder}/_static/styles/furo.css">
<link rel="stylesheet" href="{folder}/_static/katex/katex.min.css"><link rel="stylesheet" href="{folder}/_static/course.css">
</head><body data-theme="light" class="kinlib-book">
<h1>Forward kinematics</h1><p>Where is the tool? These are the lectures of the course, for printing. On the website you can
move the arms, answer the questions and run every cell: <a href="{address}">{address}</a></p><ul>{contents}</ul>
{articles}
</body></html>
"""


def compose_document(built: Path, folder: str, address: str, pages: Sequence[str] = PAGES) -> str:
    """Compose one HTML document of several pages.

    built    the folder that the pages were built into
    folder   the same folder, relative to the document
    address  the address of the published site; links to pages that are not printed lead there
    """
    texts = {page: found[1] for page in pages if (found := ARTICLE.search((built / page).read_text("utf-8")))}
    titles = {
        page: re.sub(r"<h1>(.*?)</h1>.*", r"\1", SCREEN_ONLY.sub("", text[text.index("<h1") :]), flags=re.DOTALL)
        for page, text in texts.items()
    }
    contents = "".join(f'<li><a href="#{anchor(page)}">{title}</a></li>' for page, title in titles.items())
    articles = "\n".join(
        f'<article id="{anchor(page)}">{adapt(text, page, texts, folder, address)}</article>'
        for page, text in texts.items()
    )
    return DOCUMENT.format(folder=folder, address=address, contents=contents, articles=articles)


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
        return f'href="{address}{target}{fragment}"'

    html = SCREEN_ONLY.sub("", html)
    html = IDS.sub(lambda found: f'{found[1]}="{anchor(page)}--{found[2]}"', LINKS.sub(redirect, html))
    html = html.replace(' loading="lazy"', "")
    # pictures that wait for a prediction, sections and code that may be skipped
    html = re.sub(r'<details(?! class="misstep-option")', "<details open", html)
    return move_answers(html)


def move_answers(html: str) -> str:
    """Move the explanations of predictions to the end of the lecture, with the right answer to every question and its reason."""
    explanations = {found[1]: found[0] for found in EXPLANATION.finditer(html)}
    answers, numbers = [], {}
    for number, found in enumerate(QUESTION.finditer(html), start=1):
        numbers[found[1]] = number
        explanation = explanations.get(found[1], found[0])
        reason = REASON.findall(explanation)[int(found[2])]
        lesson = LESSON.search(explanation)
        letter = OPTION_LETTERS[int(found[2])]
        answers.append(
            f'<div class="kinlib-answer"><p><strong>{number} {letter}.</strong> {reason}</p>{lesson[1] if lesson else ""}</div>'
        )
    html = EXPLANATION.sub(
        lambda found: (
            f"<p>Compare with answer {numbers[found[1]]} at the end of this lecture.</p>" if found[1] in numbers else ""
        ),
        html,
    )
    return f"{html}<h2>Answers</h2>{''.join(answers)}" if answers else html
