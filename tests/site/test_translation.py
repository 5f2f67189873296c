"""Catalogues hold all that is to be translated; translated pages keep formulas, code and links, and mark what is English."""

import re
from html import unescape

import nbformat
import pytest
from babel.messages.catalog import Catalog
from babel.messages.pofile import write_po
from browser import watched
from built_site import ROOT
from kinsite import embeds, translation
from kinsite.sphinx_source import LECTURES
from kinsite.translation import FIXED, FORMULA_TEXT, changed_parts, messages, template, translate_markdown
from translations import main as update_catalogues

from kincourse import COURSE
from misstep.questions.page import question_html

CATALOGUES = sorted(translation.LOCALES.glob("*/LC_MESSAGES/*.po"))
TRANSLATED = [file for file in CATALOGUES if file.stem != translation.WORDS]
LECTURE_00 = ROOT / "notebooks" / "00_start_here.ipynb"


@pytest.fixture
def locales(tmp_path, monkeypatch):
    """A folder of catalogues with one passage translated, of which the original has changed since."""
    for module in ("kinsite.translation", "translations"):
        monkeypatch.setattr(f"{module}.LOCALES", tmp_path)
    messages.cache_clear()
    catalog, words = Catalog(locale="de"), Catalog(locale="de")
    catalog.add("Links and joints", "Glieder und Gelenke")
    catalog.add(
        "This picture shows an arm of the KUKA youBot. It is a **kinematic chain**.", "Das Bild zeigt einen Arm."
    )
    for name, written in (("00_start_here", catalog), ("site", words)):
        path = translation.catalog_file("de", name)
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("wb") as file:
            write_po(file, written)
    yield tmp_path
    messages.cache_clear()


@pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)
def test_every_word_of_a_lecture_is_in_its_catalogue(path):
    """Without its passages, nothing of a cell is left but formulas, code and marks of Markdown."""
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "markdown"]
    for source in cells:
        assert translate_markdown(source, str) == source
        rest = translate_markdown(source, lambda _: "")
        assert not re.search(r"[^\W\d_]{2}", FIXED.sub(" ", rest) + " ".join(FORMULA_TEXT.findall(rest))), rest
    known = {entry.id for entry in template(path)}
    questions = COURSE.questions().get(path.stem[:2], {}).values()
    assert all(option.why in known or "\n\n" in option.why for item in questions for option in item.options)


@pytest.mark.parametrize("file", CATALOGUES, ids=lambda file: f"{file.parts[-3]}-{file.stem}")
def test_no_translation_changes_a_formula_code_a_link_or_a_number(file):
    translated = messages(file.parts[-3], file.stem)
    assert len(translated) > 30
    assert not {text: parts for text, to in translated.items() if (parts := changed_parts(text, to))}


@pytest.mark.parametrize(
    ("faulty", "parts"),
    [
        ("Gelenk 3 dreht um $S_3$, siehe [01](01_frames.ipynb) und `fk`.", ["$S_2$", "$S_3$"]),
        ("Gelenk 4 dreht um $S_2$, siehe [01](01_frames.ipynb) und `fk`.", ["3", "4"]),
        (
            "Gelenk 3 dreht um $S_2$, siehe [01](02_frames.ipynb) und `fk`.",
            ["](01_frames.ipynb)", "](02_frames.ipynb)"],
        ),
        ("Gelenk 3 dreht um $S_2$, siehe [01](01_frames.ipynb) und fk.", ["`fk`"]),
    ],
)
def test_a_changed_part_is_found(faulty, parts):
    assert changed_parts("Joint 3 rotates about $S_2$, see [01](01_frames.ipynb) and `fk`.", faulty) == parts


def test_the_command_marks_a_translation_whose_original_has_changed(locales, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("translations.LECTURES", [LECTURE_00])
    monkeypatch.setattr("translations.ROOT", tmp_path)
    before = len(template(LECTURE_00))
    assert not update_catalogues()
    assert f"de 00_start_here: {before} passages, {before - 2} not translated, 1 fuzzy" in capsys.readouterr().out
    assert (tmp_path / "build/locales/00_start_here.pot").exists()
    assert messages("de", "00_start_here") == {"Links and joints": "Glieder und Gelenke"}
    assert not update_catalogues("fr", "00_start_here")
    assert f"fr 00_start_here: {before} passages, {before} not translated, 0 fuzzy" in capsys.readouterr().out


def test_what_has_no_translation_is_english_and_the_page_counts_it(locales):
    notebook = nbformat.read(LECTURE_00, as_version=4)
    question = question_html("00/joint-3", COURSE.questions()["00"]["joint-3"])
    outputs = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"][:2]
    for output, html in zip(outputs, (question, "<p>a card</p>"), strict=True):
        output.append(nbformat.v4.new_output("display_data", {"text/html": html}))
    translated = translation.translate_notebook(notebook, "00_start_here", "de")
    text = "\n".join(cell.source for cell in translated.cells if cell.cell_type == "markdown")
    assert "## Glieder und Gelenke" in text
    assert '<span lang="en">The picture shows the arm' in text
    missing, total = map(int, re.search(r"(\d+) of (\d+) passages are not translated", text).groups())
    assert missing == total - 1
    assert text.count('<span lang="en">') > 50
    assert outputs[0][0].data["text/html"] == question
    assert outputs[1][0].data["text/html"] == '<div lang="en"><p>a card</p></div>'


def test_the_links_below_a_picture_are_in_the_language_of_the_page():
    html, _ = embeds.with_address("<div data-kinlib-viewer></div>", "row", "lectures/de/00_start_here", set())
    assert 'lang="de" title="Link zu dieser Abbildung" aria-label="Link zu dieser Abbildung">' in html
    assert ">Einbetten</a>" in html


@pytest.mark.parametrize("file", TRANSLATED, ids=lambda file: f"{file.parts[-3]}-{file.stem}")
def test_a_translated_page_has_the_formulas_and_questions_of_the_english_page(site_folder, file):
    language, name = file.parts[-3], file.stem
    pages = {"en": f"lectures/{name}.html", language: f"lectures/{language}/{name}.html"}
    html = {code: (site_folder / path).read_text("utf-8") for code, path in pages.items()}
    parts = (
        r'<annotation encoding="application/x-tex">(.*?)</annotation>',
        r'data-misstep-question="[^"]+" data-kind="\w+" data-right="\d"',
        r'<div class="highlight-python notranslate">.*?</pre>',
    )
    for part in parts:
        found = [
            sorted(FORMULA_TEXT.sub("", unescape(match)) for match in re.findall(part, text, re.DOTALL))
            for text in html.values()
        ]
        assert found[0] == found[1]
        assert len(found[0]) > 4
    for text in html.values():
        links = dict(
            re.findall(r'<link rel="alternate" hreflang="(\w+)" href="https?://[^"]+?/(lectures/[^"]+)"', text)
        )
        assert links == pages


def test_a_reader_changes_the_language_and_the_answers_are_the_same(chromium, site_address):
    with watched(chromium) as page:
        page.goto(f"{site_address}/lectures/00_start_here.html")
        page.get_by_role("link", name="Deutsch").click()
        page.wait_for_url("**/lectures/de/00_start_here.html")
        assert page.locator("html").get_attribute("lang") == "de"
        check = page.locator('[data-misstep-question="00/same-pose"]')
        check.locator(".kinlib-choice").nth(1).click()
        assert "B ist nicht richtig" in check.inner_text()
        assert "Die richtige Antwort ist A:" in check.inner_text()
        track = page.locator("section:has(> details.kinlib-side)")
        assert track.locator("summary").first.inner_text().startswith("Exkurs")
        page.get_by_role("button", name="Diese Vorlesung als gelesen markieren").click()
        page.get_by_role("link", name="English").click()
        page.wait_for_url("**/lectures/00_start_here.html")
        assert "B is not correct" in page.locator('[data-misstep-question="00/same-pose"]').inner_text()
        assert page.get_by_text("You have read this lecture").count() == 1


def test_the_search_has_no_translated_page(site_folder):
    assert '"url":"lectures/de/' not in (site_folder / "_static" / "search-data.js").read_text("utf-8")
