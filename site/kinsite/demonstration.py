"""Wrong answers to a problem with the cards that the course shows for them, for a page without a kernel.

The cards are made by the sheet itself while the site is built, so they cannot differ from what a student sees.
"""

import re
from html import escape

import numpy as np
from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from kincourse import open_sheet
from misstep.display.markdown import markdown_html
from misstep.sheet import OpenSheet as Sheet

SHEET, PROBLEM, STUDENT = "03_poe_space", 2, "a visitor"
ATTEMPTS = (
    ("np.concatenate([axis, np.cross(axis, point)])", "omega x p"),
    ("np.concatenate([-np.cross(axis, point), axis])", "halves swapped"),
    ("np.concatenate([axis, point])", "point as moment"),
    ("np.concatenate([axis, -np.cross(axis, point)])", ""),
)
"""Answers as a student writes them, each with the name of its mistake; the last one is right."""

LINK = re.compile(r'href="notebooks/(\w+)\.ipynb#([^"]*)" onclick="[^"]*"')
"""A link of a card, and the script with which it opens a notebook in JupyterLab."""


class WrongAnswersDirective(SphinxDirective):
    """The statement of a problem, and answers to choose from; each opens its card."""

    def run(self) -> list[nodes.Node]:
        """Insert the statement and the answers. They fold without a script, and one is open at a time."""
        sheet = open_sheet(SHEET, STUDENT)
        statement = markdown_html(sheet.problem(PROBLEM).statement)
        answers = "".join(answer_html(sheet, code, mistake, first=k == 0) for k, (code, mistake) in enumerate(ATTEMPTS))
        return [nodes.raw("", f'<div class="kinlib-answers">{statement}{answers}</div>', format="html")]


def answer_html(sheet: Sheet, code: str, mistake: str, first: bool) -> str:
    """Check an answer, and write it with its card.

    Raises ValueError if the card names another mistake than the page is meant to show.
    """
    given = sheet.given(PROBLEM)
    tilt = np.radians(given.degrees)
    names = {"np": np, "point": given.point, "axis": np.cos(tilt) * given.from_axis + np.sin(tilt) * given.towards}
    answer = eval(code, names)  # noqa: S307  the code is that of ATTEMPTS
    result = sheet.check(PROBLEM, answer)
    found = [finding.mistake for finding in result.judgement.findings]
    if found != [mistake] * bool(mistake):
        raise ValueError(f"{code} must be the mistake {mistake!r}; the sheet names {found}. Correct ATTEMPTS.")
    card = LINK.sub(lambda link: f'href="lectures/{link[1]}.html#{nodes.make_id(link[2])}"', result.card.html())
    shown = f"<details name='kinlib-answers'{' open' * first}><summary><code>{escape(code)}</code></summary>{card}</details>"
    return shown.replace('role="status" ', "")
