"""The visible form of a formula waits in a template until the reader comes near: a lecture has hundreds of formulas.

KaTeX writes each formula twice: as MathML for screen readers, and as the elements that are seen, which are about half
of all elements of a lecture. Until static/formulas.js draws these, a browser shows the MathML.
"""

from lxml.html import HtmlElement
from lxml.html.builder import E

BEGIN, END = "<kinlib-formula><template>", "</template></kinlib-formula>"


def defer(page: HtmlElement, at_once: int) -> None:
    """Put the visible form of each formula into a template, except for the first ones, which are in sight at once.

    >>> from kinsite.html_tree import inner_html, read_html
    >>> page = read_html('<span class="katex-html"><span>x</span></span>.')
    >>> defer(page, at_once=0)
    >>> inner_html(page)
    '<kinlib-formula><template><span class="katex-html"><span>x</span></span></template></kinlib-formula>.'
    """
    for formula in page.find_class("katex-html")[at_once:]:
        template = E.template()
        waiting = E("kinlib-formula", template)
        waiting.tail, formula.tail = formula.tail, None
        formula.getparent().replace(formula, waiting)
        template.append(formula)


def show_all(html: str) -> str:
    """Take the formulas out of their templates, for a document without scripts.

    >>> show_all(f'{BEGIN}<span class="katex-html">x</span>{END}.')
    '<span class="katex-html">x</span>.'
    """
    return html.replace(BEGIN, "").replace(END, "")
