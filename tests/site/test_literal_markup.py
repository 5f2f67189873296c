"""No page shows the marks of Markdown or LaTeX themselves, or a word twice."""

import re

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


def test_no_page_shows_literal_markup(site_folder):
    assert list(literal_markup(site_folder)) == []
