"""Statements and sentences of feedback as HTML, with formulas as MathML: browsers display it without further software, and
screen readers can read it.

A verdict consists of the sheet's own sentences, but it may quote what a student typed. So nothing of a formula is put into a
page but known elements and text.
"""

import re
from functools import cache, lru_cache
from xml.etree.ElementTree import Element

import mistune
from defusedxml.ElementTree import fromstring
from latex2mathml.converter import convert
from markupsafe import Markup, escape

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"

ALLOWED_ELEMENTS = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "msub", "msup", "msubsup", "mfrac", "msqrt", "mroot"),
    *("mover", "munder", "munderover", "mtable", "mtr", "mtd"),
}

TALL_ELEMENTS = {"mtable", "mfrac", "mover", "munder", "munderover", "msqrt", "mroot"}
"""What is so high that the brackets around it must be higher than usual."""

MAX_FORMULA_CHARACTERS = 1000
"""The longest formula that is converted; a longer one is shown as it was typed."""

STATEMENT_FORMULA = r"\$\$(?P<displayed_latex>[^$]+)\$\$|\$(?P<latex>[^$]+)\$"

SMALL_FRACTION = re.compile(r"\\[td]frac(?![a-zA-Z])")
"""Fractions of another size, which latex2mathml does not know."""

FORMULA_OR_CODE = re.compile(r"\$(?P<formula>[^$\n]+)\$|`(?P<code>[^`\n]+)`")


def render_sentence(text: str) -> Markup:
    """A line of feedback as HTML: $formulas$ as MathML, `code` as code, everything else escaped.

    >>> print(render_sentence("`a < b` & $x$"))
    <code>a &lt; b</code> &amp; <math><mrow><mi>x</mi></mrow></math>
    """
    html, end = Markup(), 0
    for part in FORMULA_OR_CODE.finditer(text):
        html += escape(text[end : part.start()])
        html += render_formula(part["formula"]) if part["formula"] else Markup("<code>{}</code>").format(part["code"])
        end = part.end()
    return html + escape(text[end:])


@lru_cache(maxsize=256)  # the same statements are on a student's page and in the notebook for nbgrader
def render_markdown(text: str) -> Markup:
    r"""Markdown as HTML: $formulas$ and $$displayed formulas$$ as MathML, tables and code; HTML in it is escaped.

    >>> print(render_markdown("Is $$x$$ **zero**? <b>"))
    <p>Is <math display="block"><mrow><mi>x</mi></mrow></math> <strong>zero</strong>? &lt;b&gt;</p>
    """
    return Markup(str(_markdown()(text)).strip())  # noqa: S704 - mistune escapes text, and render_formula returns Markup


@cache
def _markdown() -> mistune.Markdown:
    markdown = mistune.create_markdown(escape=True, plugins=["table"])
    _set_formulas(markdown)
    return markdown


def _set_formulas(markdown: mistune.Markdown) -> None:
    """Let mistune read formulas before emphasis, so that their underscores stay."""

    def read(_: mistune.InlineParser, found: re.Match[str], state: mistune.InlineState) -> int:
        formula, is_display = found["displayed_latex"] or found["latex"], bool(found["displayed_latex"])
        state.append_token({"type": "formula", "raw": formula, "attrs": {"is_display": is_display}})
        return found.end()

    markdown.inline.register("formula", STATEMENT_FORMULA, read, before="link")
    if markdown.renderer:
        markdown.renderer.register("formula", lambda _, latex, is_display: str(render_formula(latex, is_display)))


@lru_cache(maxsize=4096)  # the same formulas are on the pages of all students
def render_formula(latex: str, is_display: bool = False) -> Markup:
    r"""A formula as MathML, on a line of its own if it is displayed; one that cannot be converted is shown as it was typed.

    >>> render_formula(r"\href{javascript:alert(1)}{x}")
    Markup('<math><mrow><mrow><mrow><mi>x</mi></mrow></mrow></mrow></math>')
    """
    as_typed = Markup("<code>{}</code>").format(latex)
    if len(latex) > MAX_FORMULA_CHARACTERS:
        return as_typed
    try:
        tree = fromstring(convert(SMALL_FRACTION.sub(r"\\frac", latex)))
    except Exception:  # the errors of latex2mathml have no common base class
        return as_typed
    html = _render_element(tree, ' display="block"' if is_display else "")
    return as_typed if html is None else Markup(html)  # noqa: S704 - known elements, and text that is escaped


def _render_element(element: Element, attributes: str) -> str | None:
    """The element with its text, upright or italic; None if it contains an element that is not allowed."""
    name, rendered = _name(element), list[str]()
    is_tall = any(_name(part) in TALL_ELEMENTS for part in element.iter())
    for before, child in zip([None, *element], element, strict=False):
        html = _render_element(child, _operator_attributes(before, child, is_tall))
        if html is None:
            return None
        rendered.append(html)
    if name not in ALLOWED_ELEMENTS:
        return None
    upright = ' mathvariant="normal"' if element.get("mathvariant") == "normal" else ""
    text = escape((element.text or "").strip())
    return f"<{name}{upright}{attributes}>{text}{''.join(rendered)}</{name}>"


def _name(element: Element) -> str:
    return element.tag.removeprefix(NAMESPACE)


def _operator_attributes(before: Element | None, element: Element, is_tall: bool) -> str:
    """What a browser does not know of an operator: the minus of (-2, 3) is a sign, and the brackets of T(q) do not grow.

    is_tall  whether there is something beside it around which brackets grow
    """
    text = (element.text or "").strip()
    if _name(element) != "mo":
        return ""
    if text in {"(", ")", "[", "]", "{", "}", "|"} and not is_tall:
        return ' stretchy="false"'
    is_after_operator = before is not None and _name(before) == "mo" and (before.text or "") not in {")", "]", "}"}
    return ' form="prefix"' if text in {"−", "-", "+"} and is_after_operator else ""
