"""The lectures as one PDF: links between printed pages work within the document."""

import shutil
from pathlib import Path

import furo
import pytest
from browser import CHROMIUM, NO_CHROMIUM
from kinsite.pdf_document import compose_document, squeeze, thin_out
from lxml.html import fromstring
from pdf import page_numbers, write_pdf
from pypdf import PdfReader

import kinlib
from misstep.questions.item import Item, Option
from misstep.questions.page import explanation_html, question_html

SITE = Path(__file__).parents[2] / "site"

PAGE = """<html><body><nav>elsewhere</nav><article role="main" id="furo-main-content">
<h1>{title}<a class="headerlink" href="#top">#</a></h1><p class="kinlib-bar"><a href="x">Download</a></p>{text}</article></body></html>"""
ONE = """<p id="here"><a href="#here">here</a> <a href="two.html#there">there</a> <a href="../robots/arm.html#x">arm</a>
<a href="https://example.org/">out</a><img loading="lazy" src="../_images/a.svg"></p>
<details class="kinlib-side"><summary><h2>Side track: more</h2></summary>skipped</details>
<div data-kinlib-drawing><details><summary>Commit first</summary><figure></figure></details></div>
{questions}"""
WAITING = """<div data-kinlib-slides data-kinlib-after="01/b"><details open=""><summary>Commit first</summary>\
<div data-value="0"><figure>the answer</figure></div></details></div>"""
OPTIONS = [Option("one", "It is too small."), Option("two", "It is twice one.", right=True)]
QUESTIONS = [Item("a", "check", "Twice one?", OPTIONS), Item("b", "predict", "And now?", OPTIONS, "It *grows*.")]
QUESTIONS_HTML = "".join(question_html(f"01/{item.name}", item) for item in QUESTIONS) + WAITING.replace(' open=""', "")
QUESTIONS_HTML += explanation_html("01/b", QUESTIONS[1])


LONG = "Two: a title that is broken, because it is longer than a line of the page"
WORDS = f"""<p>All</p><p>the words.</p><dl>{"<dt>A word</dt><dd><p>Its meaning.</p></dd>" * 30}</dl>"""
CODE = f"""<div class="highlight"><pre>{("x" * 58 + " " + "y" * 59 + chr(10)) * 50}</pre></div>"""


@pytest.fixture
def built(tmp_path):
    folder = tmp_path / "html"
    (folder / "lectures").mkdir(parents=True)
    shutil.copytree(SITE / "static", folder / "_static")
    (folder / "lectures/one.html").write_text(PAGE.format(title="One", text=ONE.format(questions=QUESTIONS_HTML)))
    (folder / "lectures/two.html").write_text(PAGE.format(title=LONG, text='<p id="there">Two.</p>'))
    (folder / "words.html").write_text(PAGE.format(title="Words", text=WORDS))
    (folder / "code.html").write_text(PAGE.format(title="Code", text=CODE))
    return folder


PAGES = ["lectures/one.html", "lectures/two.html", "words.html", "code.html"]


def document(built, address="https://course.example/"):
    return compose_document(built, "html", address, PAGES, {squeeze(LONG): 7})


PRINTED_PARTS = (
    'id="lectures-one--here"><a href="#lectures-one--here">here',
    'href="#lectures-two--there"',
    'run every cell: <a href="https://course.example/">https://course.example/</a></p>',
    'href="https://course.example/robots/arm.html#x"',
    'href="https://example.org/"',
    'src="html/_images/a.svg"',
    '<li><a href="#lectures-two">' + LONG + "</a> <span>7</span></li>",
    f'@page head1 {{ @top-right {{ content: "{LONG}";',
    "#lectures-two { page: head1; }",
    f"The kinlib authors. Version {kinlib.__version__}, printed on 20",
    "Lectures: Creative Commons Attribution 4.0. Code: MIT licence.",
    '<details class="kinlib-side" open="">',
    '<div data-kinlib-drawing><details open="">',
    '<details class="misstep-option"><summary>two',
    "<p>Compare with answer 2 and its pictures at the end of this lecture.</p><h2>Answers</h2>",
    "<p><strong>1 B.</strong> It is twice one.</p></div>",
    "<p><strong>2 B.</strong> It is twice one.</p><p>It <em>grows</em>.</p>" + WAITING + "</div></article>",
)


def test_links_are_redirected_answers_are_at_the_end_and_parts_for_the_screen_are_left_out(built):
    printed = document(built)
    assert [part for part in PRINTED_PARTS if part not in printed] == []
    screen = ["elsewhere", "Download", "headerlink", "lazy", "data-misstep-explain"]
    assert [part for part in screen if part in printed] == []


def test_without_an_address_no_link_leads_to_a_page_that_is_not_printed(built):
    printed = document(built, address="")
    assert "<a>arm</a>" in printed
    assert "run every cell.</p>" in printed


def test_few_pictures_of_a_slider_are_printed_from_the_first_to_the_last():
    for count, kept in ((37, (0, 7, 14, 22, 29, 36)), (3, range(3))):
        slides = fromstring(f"<div>{''.join(f'<div data-value={k}></div>' for k in range(count))}</div>")
        thin_out(slides)
        assert [int(picture.get("data-value")) for picture in slides] == list(kept)


@pytest.mark.skipif(CHROMIUM is None, reason=NO_CHROMIUM)
def test_chromium_prints_the_document_with_an_outline(built, tmp_path):
    (tmp_path / "course.html").write_text(document(built), "utf-8")
    # the theme's own rules for printing leave the rest of the page empty before a long list
    shutil.copytree(Path(furo.__file__).parent / "theme/furo/static/styles", built / "_static/styles")
    write_pdf(tmp_path / "course.html", tmp_path / "course.pdf")
    printed = PdfReader(tmp_path / "course.pdf")
    assert printed.metadata.author == "The kinlib authors"
    assert page_numbers(tmp_path / "course.pdf") == {
        "Forwardkinematics": 1,
        "One": 3,
        squeeze(LONG): 4,
        "Words": 5,
        "Code": 7,
    }
    assert len(printed.pages) == 7, "a line of 118 characters is not broken"


def test_without_chromium_the_error_says_what_to_do(monkeypatch, tmp_path):
    import pdf

    monkeypatch.setattr(pdf.shutil, "which", lambda _: None)
    monkeypatch.delenv("KINLIB_CHROMIUM", raising=False)
    with pytest.raises(SystemExit, match="KINLIB_CHROMIUM"):
        pdf.write_pdf(tmp_path / "course.html", tmp_path / "course.pdf")
