"""Lectures in other languages: catalogues of what a reader reads, in gettext's format, and notebooks translated by them.

A message is a passage of Markdown: a heading, a paragraph, an item of a list or a row of a table. Each lecture has a catalogue of
its own, `locales/de/LC_MESSAGES/00_start_here.po`, and so have the words of the site itself, `site.po`. What has no translation
is shown in English.
"""

import gettext
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import nbformat
import sphinx
from babel import Locale
from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_file
from babel.messages.pofile import read_po
from nbformat import NotebookNode

from kincourse import COURSE
from kinsite.execute import ROOT
from misstep.questions import page
from misstep.questions.item import KINDS, Item

SITE = ROOT / "site"
LOCALES = SITE / "locales"
WORDS = "site"
"""The catalogue of the words of the site itself."""
OTHER_WORDS = ("Skip to content", "On this page", "Back to top", "Side track:", "question", "formula", "figure")
"""Words of the theme, and words that the text of a page or a script contains in another form."""

PASSAGE = re.compile(r"^(#{1,6} |- )?(\S.*?)(?=\n\n|\n- |\n\||\s*\Z)", re.DOTALL | re.MULTILINE)
FORMULA = r"\$\$.+?\$\$|\$[^$\n]+\$"
FIXED = re.compile(rf"{FORMULA}|%(?:\(\w+\))?s|`[^`\n]+`|\]\([^)\s]+\)|\{{\w\}}|\d+(?:\.\d+)*", re.DOTALL)
"""What a translation must not change: formulas, code, the targets of links, names of frames, numbers, and the %s of a word."""
FORMULA_TEXT = re.compile(r"\\text\{([^}]*)\}")
QUESTION = re.compile(r'data-misstep-(question|explain)="([^"]+)"')
LOCAL_LINK = re.compile(r'(\]\(|href=")(?![a-z]+:|#)(?=[^")]+\.(?:ipynb|md|html))')

Translate = Callable[[str], str]


def has_words(passage: str) -> bool:
    r"""Say whether there is something to translate outside formulas and code, or in the words of a formula.

    >>> has_words("| --- |"), has_words(r"$$x = 1$$"), has_words(r"$$x \text{ is } 1$$")
    (False, False, True)
    """
    return bool(re.search(r"[^\W\d_]{2}", FIXED.sub(" ", passage) + " ".join(FORMULA_TEXT.findall(passage))))


def translate_markdown(text: str, translate: Translate) -> str:
    r"""Translate each passage of a text. The marks of headings and list items stay.

    >>> translate_markdown("## Links\n\n- a link\n- a joint", str.upper)
    '## LINKS\n\n- A LINK\n- A JOINT'
    """
    return PASSAGE.sub(
        lambda found: (found[1] or "") + (translate(found[2]) if has_words(found[2]) else found[2]), text
    )


def translate_item(item: Item, translate: Translate) -> Item:
    """Translate a question."""
    text = translate_markdown(item.text, translate)
    options = [
        replace(option, text=translate_markdown(option.text, translate), why=translate_markdown(option.why, translate))
        for option in item.options
    ]
    explanation = translate_markdown(item.explanation, translate)
    return replace(item, text=text, options=options, explanation=explanation)


def changed_parts(original: str, translation: str) -> list[str]:
    """List the formulas, code, links and numbers that a translation changes, adds or leaves out.

    >>> changed_parts("The pose $T$ has 4 rows.", "Die Pose $t$ hat 4 Zeilen.")
    ['$T$', '$t$']
    """
    before, after = (Counter(FIXED.findall(FORMULA_TEXT.sub(r"\\text{}", text))) for text in (original, translation))
    return sorted(((before - after) + (after - before)).elements())


# --- catalogues ---


def template(path: Path) -> Catalog:
    """Collect what is to be translated of a lecture: its Markdown cells and its questions."""
    catalog = Catalog(domain=path.stem)

    def collect(place: str) -> Translate:
        return lambda passage: str(catalog.add(passage, locations=[(place, None)]).id)  # type: ignore[list-item]

    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == "markdown":
            translate_markdown(cell.source, collect(f"{path.name}#{cell.id}"))
    for key, item in COURSE.questions().get(path.stem[:2], {}).items():
        translate_item(item, collect(f"questions.toml#{key}"))
    return catalog


def words_template() -> Catalog:
    """Collect the words of the site itself: of its template and script, and of every question."""
    catalog = Catalog(domain=WORDS)
    for method, path, keyword in (
        ("jinja2", SITE / "templates" / "page.html", "_"),
        *(("javascript", SITE / "static" / name, "_") for name in ("course.js", "live.js")),
        ("python", Path(page.__file__), "translate"),
        ("python", Path(__file__), "words"),
        ("python", SITE / "kinsite" / "embeds.py", "words"),
    ):
        for _, message, _, _ in extract_from_file(method, path, keywords={keyword: None}):
            catalog.add(message, locations=[(path.name, None)])  # type: ignore[list-item]
    for word in (*KINDS.values(), *OTHER_WORDS):
        catalog.add(word)
    return catalog


def catalog_file(language: str, domain: str) -> Path:
    """Name the file of a catalogue."""
    return LOCALES / language / "LC_MESSAGES" / f"{domain}.po"


def languages(domain: str) -> list[str]:
    """List the languages into which a lecture is translated."""
    return sorted(file.parts[-3] for file in LOCALES.glob(f"*/LC_MESSAGES/{domain}.po"))


@cache
def messages(language: str, domain: str) -> dict[str, str]:
    """Read the translations of a catalogue. A translation whose original has changed since is marked fuzzy, and left out."""
    with catalog_file(language, domain).open("rb") as file:
        catalog = read_po(file, locale=language, domain=domain)
    return {str(entry.id): str(entry.string) for entry in catalog if entry.id and entry.string and not entry.fuzzy}


def words_of(language: str) -> Translate:
    """Return the function that translates the words of the site; Sphinx has translated its own."""
    sphinx_words = gettext.translation("sphinx", Path(sphinx.__file__).parent / "locale", [language], fallback=True)
    own = messages(language, WORDS)
    return lambda text: own.get(text) or sphinx_words.gettext(text)


def words_on(page: str) -> Translate:
    """Return the function that translates the words of the site on a page.

    >>> words_on("lectures/00_start_here")("figure"), words_on("lectures/de/00_start_here")("figure")
    ('figure', 'Abbildung')
    """
    language = original_page(page)[1]
    return words_of(language) if language else str


def in_all_languages(word: str) -> tuple[str, ...]:
    """Return a word of the site in English and in every other language."""
    return word, *(words_of(language)(word) for language in languages(WORDS))


# --- pages ---


def original_page(name: str) -> tuple[str, str]:
    """Return the name of a page in English, and the language of the page if it is not English.

    >>> original_page("lectures/de/00_start_here"), original_page("lectures/00_start_here")
    (('lectures/00_start_here', 'de'), ('lectures/00_start_here', ''))
    """
    found = re.fullmatch(r"lectures/(\w+)/(\w+)", name)
    return (f"lectures/{found[2]}", found[1]) if found else (name, "")


def versions(name: str) -> list[tuple[str, str, str]]:
    """List the language, the page and the language's own name for each version of a lecture, if there are several."""
    folder, _, last = name.partition("/")
    others = languages(last) if folder == "lectures" else []
    pages = [("en", name), *((language, f"{folder}/{language}/{last}") for language in others)] if others else []
    return [(language, path, str(Locale(language).language_name).capitalize()) for language, path in pages]


def translate_notebook(notebook: NotebookNode, domain: str, language: str) -> NotebookNode:
    """Translate the text and the questions of an executed lecture, in place; mark what remains English."""
    own, words = messages(language, domain), words_of(language)
    passages: list[str] = []

    def translate(passage: str) -> str:
        passages.append(passage)
        return own.get(passage, passage)

    def translate_or_mark(passage: str) -> str:
        is_row = passage.startswith(("|", "$$"))  # HTML around it would end the table or the formula
        return translate(passage) if passage in own or is_row else f'<span lang="en">{translate(passage)}</span>'

    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = translate_markdown(cell.source, translate_or_mark)
        for output in cell.get("outputs", []):
            if html := output.get("data", {}).get("text/html"):
                output["data"]["text/html"] = translate_output(html, translate, words)
    missing = sum(passage not in own for passage in passages)
    note = words(
        "This is a translation. Code, what it prints, pictures, and the feedback on answers that you type are in English."
    )
    if missing:
        rest = words("%(missing)s of %(all)s passages are not translated yet, and are shown in English.")
        note += " " + rest % {"missing": missing, "all": len(passages)}
    title, _, text = notebook.cells[0].source.partition("\n")
    notebook.cells[0].source = f"{title}\n\n{note}\n{text}"
    notebook.metadata["orphan"] = True  # the table of contents is that of the English pages
    return notebook


def translate_output(html: str, translate: Translate, words: Translate) -> str:
    """Write a question in another language; mark any other output as English."""
    if not (found := QUESTION.search(html)):
        return f'<div lang="en">{html}</div>'
    lecture, key = found[2].split("/")
    item = translate_item(COURSE.questions()[lecture][key], translate)
    write = page.question_html if found[1] == "question" else page.explanation_html
    return write(found[2], item, words)


def lower_links(notebook: NotebookNode) -> NotebookNode:
    """Make the links of a page of the site lead to the same pages from one folder below, in place."""
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = LOCAL_LINK.sub(r"\1../", cell.source)
        for data in (output.get("data", {}) for output in cell.get("outputs", [])):
            if "text/html" in data:
                data["text/html"] = LOCAL_LINK.sub(r"\1../", data["text/html"])
    return notebook


def translated_lectures(path: Path, executed: NotebookNode) -> Iterator[tuple[str, NotebookNode]]:
    """Yield each translation of a lecture, with its language."""
    for language in languages(path.stem):
        yield language, translate_notebook(nbformat.from_dict(executed), path.stem, language)
