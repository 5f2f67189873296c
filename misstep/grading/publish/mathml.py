"""Formulas of feedback as MathML, which browsers display without further software and screen readers can read.

A verdict consists of the sheet's own sentences, but it may quote what a student typed. So nothing of a formula is put into a
page but known elements and text.
"""

import re
from xml.etree.ElementTree import Element, ParseError

from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import fromstring
from latex2mathml.converter import convert
from markupsafe import Markup, escape

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"

ALLOWED_ELEMENTS = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "msub", "msup", "msubsup", "mfrac", "msqrt", "mroot"),
    *("mover", "munder", "munderover", "mtable", "mtr", "mtd"),
}

MAX_FORMULA_CHARACTERS = 500
"""The longest formula that is converted; a longer one is shown as it was typed."""

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


def render_formula(latex: str) -> Markup:
    r"""A formula as MathML; a formula that cannot be converted is shown as it was typed.

    >>> render_formula(r"\href{javascript:alert(1)}{x}")
    Markup('<math><mrow><mrow><mrow><mi>x</mi></mrow></mrow></mrow></math>')
    """
    as_typed = Markup("<code>{}</code>").format(latex)
    if len(latex) > MAX_FORMULA_CHARACTERS:
        return as_typed
    try:
        tree = fromstring(convert(latex))
    except (ParseError, DefusedXmlException, RecursionError, ValueError, LookupError, TypeError, AttributeError):
        return as_typed
    except Exception as error:  # the errors of latex2mathml have no common base class
        if type(error).__module__.startswith("latex2mathml"):
            return as_typed
        raise
    return _render_element(tree) or as_typed


def _render_element(element: Element) -> Markup | None:
    """The element with its text, upright or italic; None if it contains an element that is not allowed."""
    name = element.tag.removeprefix(NAMESPACE)
    children = [child_html for child in element if (child_html := _render_element(child)) is not None]
    if name not in ALLOWED_ELEMENTS or len(children) < len(element):
        return None
    upright = Markup(' mathvariant="normal"') if element.get("mathvariant") == "normal" else ""
    return Markup("<{0}{1}>{2}{3}</{0}>").format(name, upright, (element.text or "").strip(), Markup().join(children))
