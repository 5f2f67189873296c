"""Wrong answers to a problem with the cards that the course shows for them, for a page without a kernel.

The cards are made by the sheet itself while the site is built, so they cannot differ from what a student sees. Beside each
is a drawing of where the tool goes: as the joint moves it, and as the answer says.
"""

from html import escape

import numpy as np
from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from kincourse import open_sheet
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from kinlib.view.drawing.canvas import Canvas, moved
from kinlib.view.drawing.figure_colours import GHOST_GREY, GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinsite.html_tree import inner_html, read_html
from misstep.display.markdown import markdown_html
from misstep.sheet import OpenSheet as Sheet

SHEET, PROBLEM, STUDENT = "03_poe_space", 3, "a visitor"
ATTEMPTS = (
    ("np.concatenate([axis, np.cross(axis, point)])", "omega x p"),
    ("np.concatenate([-np.cross(axis, point), axis])", "halves swapped"),
    ("np.concatenate([axis, point])", "point as moment"),
    ("np.concatenate([axis, -np.cross(axis, point)])", ""),
)
"""Answers as a student writes them, each with the name of its mistake; the last one is right."""


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
    picture = draw_motions(given.point, np.array(sheet.problem(PROBLEM).answer.value), answer)
    card = read_html(result.card.html())
    for link in card.iter("a"):  # on a page it opens the lecture, and no notebook
        lecture, section = link.get("href").rpartition("notebooks/")[2].split(".ipynb#")
        link.set("href", f"lectures/{lecture}.html#{nodes.make_id(section)}")
        del link.attrib["onclick"]
    for message in card.xpath(".//*[@role='status']"):
        del message.attrib["role"]
    head = f"<details name='kinlib-answers'{' open' * first}><summary><code>{escape(code)}</code></summary>"
    return f"{head}{picture.html()}{inner_html(card)}</details>"


def draw_motions(point: Array, right: Array, typed: Array) -> Picture:
    """Draw a link on a joint as the joint turns it by 90 degrees, and dashed where the typed screw axis would take it."""
    across = np.cross(right[:3], (0.0, 0.0, 1.0))
    link = np.array([point, point + 2.0 * across / np.linalg.norm(across)])  # 2 m from the axis to the tool
    angles = np.linspace(0.0, np.pi / 2, 25)
    true, said = (np.array([moved(T, link) for T in exp(S * angles[:, None])]) for S in (right, typed))
    axis = point + np.outer((-1.5, 2.0), right[:3])
    canvas = Canvas(np.concatenate([true.reshape(-1, 3), said.reshape(-1, 3), axis]), size=(780, 460))
    canvas.line(axis, ORANGE, 2.0)
    canvas.label(axis[1], "joint", ORANGE)
    canvas.line(true[0], GREY, 4.0)
    canvas.line(true[:, 1], VIOLET, 1.2)
    canvas.line(true[-1], INK, 6.0, level=3)
    canvas.label(true[-1, 1], "as it is", INK)
    ends = f"from {vector_text(link[1])} to {vector_text(true[-1, 1])} m"
    alt, caption = "The screw axis that was typed says the same.", "The tool goes where the answer says."
    if not np.allclose(right, typed):
        canvas.line(said[:, 1], GHOST_GREY, 1.2, "--")
        canvas.line(said[-1], GHOST_GREY, 6.0, "--", level=2.5)
        canvas.label(said[-1, 1], "as typed", GREY)
        off = float(np.linalg.norm(said[-1, 1] - true[-1, 1]))
        alt = f"The screw axis that was typed takes the tool to {vector_text(said[-1, 1])} m, {off:.1f} m away."
        caption = f"Dashed: where this answer would take the link, {off:.1f} m off."
    head = f"The joint turns its link by 90 degrees. Its tool moves {ends}."
    return canvas.picture(f"{head} {alt}", caption, cropped=True)
