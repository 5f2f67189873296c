"""Pages of feedback and the report: HTML that needs no other file, readable on a phone, in a dark theme and on paper.

Jinja escapes everything that a template fills in, and the page forbids scripts and requests to other hosts. So even if something
of a submission reached the page unescaped, it would have no effect.
"""

import re
from collections import Counter
from collections.abc import Sequence
from functools import cache, lru_cache
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from latex2mathml.converter import convert
from markupsafe import Markup, escape

from misstep.display.text import points
from misstep.grading.escape import printable
from misstep.grading.result import ABSENT, GRADED, Result
from misstep.storage import from_data

STATES = {
    "right": ("✓", "right"),
    "partly": ("◐", "partly right"),
    "wrong": ("✗", "not yet right"),
    "open": ("✎", "to be marked by your instructor"),
    "marked": ("✎", "marked by your instructor"),
    "blank": ("…", "no answer yet"),
    "unreadable": ("?", "unreadable"),
    "missing": ("–", "no answer stored"),
}
"""For each state of a problem its sign and its words, so that no meaning depends on colour alone."""

FORMULA_OR_CODE = re.compile(r"\$\$?(?P<formula>[^$\n]+)\$\$?|`(?P<code>[^`\n]+)`")

ATTRIBUTES = {"xmlns", "display", "stretchy", "fence", "form", "separator", "mathvariant", "columnalign", "rowspacing"}
ATTRIBUTES |= {"columnspacing", "columnlines", "rowlines", "width", "height", "linethickness", "minsize", "maxsize"}
"""The attributes of MathML that lead nowhere. A formula with any other one, such as href, is shown as it was typed."""

MAX_ANSWER = 2000
"""The longest answer that is shown, and the longest formula that is converted, in characters."""


@lru_cache(maxsize=4096)  # the same formulas are on the pages of all students
def formula(latex: str) -> Markup:
    r"""Return a formula as MathML, which browsers and screen readers know; as it was typed if it cannot be converted.

    >>> formula(r"\href{javascript:alert(1)}{x}")
    Markup('<code>\\href{javascript:alert(1)}{x}</code>')
    """
    as_typed = Markup("<code>{}</code>").format(latex)
    if len(latex) > MAX_ANSWER:
        return as_typed
    try:
        html = convert(latex)
    except Exception:  # the errors of latex2mathml have no common base class
        return as_typed
    return Markup(html) if set(re.findall(r'([\w:-]+)="', html)) <= ATTRIBUTES else as_typed  # noqa: S704 - as above


def sentence(text: str) -> Markup:
    """Return a line of feedback as HTML: $formulas$ as MathML, `code` as code, everything else escaped.

    >>> print(sentence("`a < b` & c"))
    <code>a &lt; b</code> &amp; c
    """
    html, end = Markup(), 0
    for part in FORMULA_OR_CODE.finditer(text := printable(text)):
        html += escape(text[end : part.start()])
        html += formula(part["formula"]) if part["formula"] else Markup("<code>{}</code>").format(part["code"])
        end = part.end()
    return html + escape(text[end:])


def answer_text(data: Any) -> str:
    """Return a stored answer as Python shows it, which was read before."""
    text = str(from_data(data))
    return text if len(text) <= MAX_ANSWER else f"{text[:MAX_ANSWER]} ..."


def feedback_page(result: Result, sheet: str) -> str:
    """Return the page of one student. It has no data of other students, and no right answers, so that one can try again."""
    return _environment().get_template("feedback.html").render(result=result, sheet=sheet)


def report_page(results: Sequence[Result], sheet: str, attention: Sequence[str]) -> str:
    """Return the report of the class. Those who handed in nothing are counted, but not as points."""
    present = [result for result in results if result.status != ABSENT] or results
    count, problems = len(present), []
    for alike in zip(*(result.problems for result in present), strict=True):
        states = Counter(one.state for one in alike)
        counted = [(state, states[state]) for state in STATES if states[state]]
        mistakes = Counter(name for one in alike for name in sorted(set(one.mistakes))).most_common()
        mean = None if states["open"] else sum(one.points for one in alike) / count
        problems.append((alike[0], mean, counted, mistakes, sum(one.unnamed is not None for one in alike)))
    totals = sorted(Counter(int(result.points) for result in present).items())
    figures: dict[str, Any] = {"count": count, "absent": len(results) - count, "max": present[0].max, "totals": totals}
    figures |= {"mean": sum(result.points for result in present) / count, "sheet": sheet, "attention": attention}
    figures["ungraded"] = sum(result.status != GRADED for result in present)
    return _environment().get_template("report.html").render(figures, problems=problems)


@cache
def _environment() -> Environment:
    def safe(value: Any) -> Any:
        return value if isinstance(value, Markup) else "\n".join(map(printable, str(value).split("\n")))

    environment = Environment(
        loader=PackageLoader("misstep.grading"),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=safe,
        trim_blocks=True,
    )
    environment.filters.update(points=points, sentence=sentence, answer=answer_text)
    environment.globals.update(STATES=STATES)
    return environment
