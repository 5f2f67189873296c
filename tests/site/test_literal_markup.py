"""No page shows the marks of Markdown or LaTeX themselves, or a word twice."""

import re

import pytest

NOT_PROSE = re.compile(r'<(script|style|pre|code|svg|math|textarea)\b.*?</\1>|<dt class="sig.*?</dt>', re.DOTALL)
INLINE_TAG = re.compile(r"</?(?:a|em|strong|b|span)\b[^>]*>")
ANY_TAG = re.compile(r"<[^>]+>")
LITERAL = re.compile(
    r"(?<![\w*])\*{1,2}\w[^*\n]*\*|`|\$|\\[(\[A-Za-z]|(?<!\w)_\w+_(?!\w)|\]\((?:https?:|[\w./]+\.(?:md|ipynb|html))|\b([a-z]{2,}) \1\b"
)
"""Markdown, LaTeX or a doubled word that a reader would see. Doubled words in quotations are the source's."""


def literal_markup(built):
    for path in sorted(built.rglob("*.html")):
        name = path.relative_to(built).as_posix()
        if name.startswith(("lab/", "_static/", "files/")):
            continue
        _, _, article = path.read_text("utf-8").partition('<article role="main"')
        text = ANY_TAG.sub("\n", INLINE_TAG.sub("", NOT_PROSE.sub("\u2026", article)))
        for line in text.splitlines():
            if (found := LITERAL.search(line)) and not (found[1] and "\u201c" in line):
                yield f"{name}: {found[0]!r} in {line.strip()[:100]!r}"


@pytest.mark.parametrize(
    "text", ["the *fixed* axes", "see `fk`", "$q$", r"\alpha", "an _own_ frame", "[x](y.md)", "to to turn"]
)
def test_literal_markup_and_a_doubled_word_are_named(tmp_path, text):
    (tmp_path / "page.html").write_text(
        f'<article role="main"><p>Before</p><p>Here is <b>{text}</b>.</p></article>', "utf-8"
    )
    (fault,) = literal_markup(tmp_path)
    assert fault.startswith("page.html: ")
    assert text in fault.replace("\\\\", "\\")


def test_code_signatures_and_quotations_are_no_literal_markup(tmp_path):
    prose = '<code>a*b*c</code><dt class="sig py">f(*args, **options)</dt> q_1 and q_2, 3 * 4 * 5 \u201cfor for\u201d'
    (tmp_path / "page.html").write_text(f'<article role="main"><p>{prose}</p></article>', "utf-8")
    assert list(literal_markup(tmp_path)) == []


def test_no_page_shows_literal_markup(site_folder):
    assert list(literal_markup(site_folder)) == []
