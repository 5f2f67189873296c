"""Formulas of feedback as MathML, which every browser sets by itself, and a screen reader reads.

A verdict is made of our own sentences, but it may quote what a student typed. So nothing of a formula goes into a page but
elements and letters of mathematics.
"""

import re
from xml.etree.ElementTree import Element, ParseError

from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import fromstring
from latex2mathml.converter import convert
from markupsafe import Markup, escape

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"

ELEMENTS = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "msub", "msup", "msubsup", "mfrac", "msqrt", "mroot"),
    *("mover", "munder", "munderover", "mtable", "mtr", "mtd"),
}

LONGEST = 500
"""No formula of a sentence is longer."""

PIECES = re.compile(r"\$(?P<formula>[^$\n]+)\$|`(?P<code>[^`\n]+)`")


def sentence(text: str) -> Markup:
    """A line of feedback as HTML: $formulas$ set, `code` marked, all else escaped.

    >>> print(sentence("`a < b` & $x$"))
    <code>a &lt; b</code> &amp; <math><mrow><mi>x</mi></mrow></math>
    """
    done, end = Markup(), 0
    for piece in PIECES.finditer(text):
        done += escape(text[end : piece.start()])
        done += formula(piece["formula"]) if piece["formula"] else Markup("<code>{}</code>").format(piece["code"])
        end = piece.end()
    return done + escape(text[end:])


def formula(latex: str) -> Markup:
    r"""A formula as MathML; what cannot be set stands as it was typed.

    >>> formula(r"\href{javascript:alert(1)}{x}")
    Markup('<math><mrow><mrow><mrow><mi>x</mi></mrow></mrow></mrow></math>')
    """
    as_typed = Markup("<code>{}</code>").format(latex)
    if len(latex) > LONGEST:
        return as_typed
    try:
        tree = fromstring(convert(latex))
    except (ParseError, DefusedXmlException, RecursionError, ValueError, LookupError, TypeError, AttributeError):
        return as_typed
    except Exception as error:  # the package's own errors have no name in common
        if type(error).__module__.startswith("latex2mathml"):
            return as_typed
        raise
    return _written(tree) or as_typed


def _written(element: Element) -> Markup | None:
    """The element with its letters, and whether they stand upright; None where anything is not of mathematics."""
    name = element.tag.removeprefix(NAMESPACE)
    inside = [made for child in element if (made := _written(child)) is not None]
    if name not in ELEMENTS or len(inside) < len(element):
        return None
    upright = Markup(' mathvariant="normal"') if element.get("mathvariant") == "normal" else ""
    return Markup("<{0}{1}>{2}{3}</{0}>").format(name, upright, (element.text or "").strip(), Markup().join(inside))
