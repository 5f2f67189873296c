"""Nothing that can be read before a question or a blank step is answered gives its answer away, in any form of a lecture.

JupyterLab and a plain notebook are read here, the site and the PDF in tests/site/test_site.py.
"""

from dataclasses import replace
from html import escape
from itertools import starmap
from pathlib import Path

import nbformat
import pytest
from gate import LECTURES, QUESTIONS, giveaways, given_away, given_away_by_itself
from giveaways import Passage
from kinsite.execute import execute
from lxml.html import fragment_fromstring
from readings import Mark, notebook_reading, page_reading

from misstep.questions.page import explanation_html, question_html
from misstep.questions.widget import Explanation, Question

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_nothing_above_a_question_gives_its_answer_away(path):
    notebook = execute(path)
    for with_widgets in (True, False):
        assert giveaways(notebook_reading(notebook, QUESTIONS, with_widgets), path.stem.partition("_")[0]) == []


def test_no_question_gives_its_own_answer_away():
    assert {name: said for name in QUESTIONS if (said := given_away_by_itself(name))} == {}


# --- giveaways that were made up before the gate was written, and others that were made up to break it ---

PLANTED = [
    ("09/digits", "alt", "The error rises up to 8 decimals and falls from there."),
    ("09/digits", "text", "Eight decimals are a bad choice for a file."),
    ("09/loop", "own", "joint_c_is_lost = True"),
    ("02/terms", "text", "After twenty terms, nothing changes any more."),
    ("07/place", "output", "the table changes; the screw axes and the poses do not"),
    ("07/hardest", "caption", "The better row is worst at 1e-08 rad."),
    ("08/ring", "output", "closure of rank 2: mobility 8"),
    ("08/twice", "folded", "period = 4 * np.pi  # all bars are back after the second turn"),
    ("04/which-k", "own", "assert np.allclose(T, wrist.fk(q))"),
    ("04b/stretched", "title", "The Jacobian has no motion along x, the direction of the arm"),
    ("03/climb", "next", "height = 0.1 * 2 * np.pi  # 0.628 m"),
    ("01/own-fixed", "text", "The same orientation comes from the fixed axes: y first, then z."),
    ("00/joint-3", "alt", "The youBot after the motion: {b} is straight above joint 3."),
    ("07/opposite", "output", "3 | 0.3 | 180° | \N{MINUS SIGN}0.2 | q3"),
    ("08/bennett", "heading", "A ring that moves all the way round"),
    ("02/rotation", "folded", "# at certain angles the partial sum rotates, by the wrong angle"),
    ("08/dead", "next", "# the crank reverses, and C goes on into the other mode"),
    ("07/bug", "own", "# the cosine hardly changes near parallel"),
    ("03/bug", "next", "M[3] = (0, 0, 0, 1)  # the last row was 0 0 0 0"),
    ("02/recall-3", "own", "x = lambda t: np.exp(a * t) * x_0"),
    ("09/turns", "caption", "z points along the parent's x"),
    ("08/modes", "own", "# answer: C"),
    ("07/free", "caption", "Ten of them are free."),
    ("02/terms", "folded", "show(partial_sums(W, 4 * 5))"),
    ("02/pitch", "output", "1.59 turns"),
    ("03/climb", "text", r"So it climbs $2\pi \cdot 0.1$ m."),
    ("07/hardest", "own", "worst = np.sqrt(1e-16)"),
    ("08/ring", "folded", "dof = 10 - 2"),
    ("04/joint-1", "output", "B_3 does not change"),
    ("08/newton", "own", "digits_double = True  # the correct ones"),
    ("09/bug", "text", "Look at the roll of lean, at the parent of tilt and at its limits."),
    ("01/singular", "title", "the roll and yaw axes coincide at a pitch of 90 degrees"),
    ("06/cuts", "alt", "Frame {1}: standard behind X_1, modified behind Z_1."),
    ("10/stored", "alt", "None of the stored numbers has changed."),
    ("09/loop", "below", "Joint C is lost"),
    ("00.a", "folded", "position = [0.0330 + 0.1550 + 0.1350 + 0.2175, 0, 0.147]"),
    ("05.e", "output", "5 | 0 | 0 | 0.2175 | q5"),
    ("10.b", "caption", "joint 3 at (4, -2, 0) of its parent"),
    ("02.d", "output", "[[ 0.    -1.     0.     0.5 ]\n [ 1.     0.     0.     0.5 ]\n [ 0.     0.     1.     0.  ]]"),
    ("07.b", "text", "So $O_4$ is at $(0.8, 0.35, 0.8)$."),
    ("06.a", "output", r"$\begin{pmatrix} 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & q_2 \\ 1 & 0 & 0 & 0 \end{pmatrix}$"),
    ("02.b", "own", "R = [[0.25, -0.6124, 0.75], [0.6124, -0.5, -0.6124], [0.75, 0.6124, 0.25]]"),
    ("07.a", "folded", "row = dict(a=0.3, alpha=180, d=-0.2, theta=0)"),
]
FIGURE = '<figure><img alt="{alt}" src="a.svg"><figcaption>{caption}</figcaption></figure>'


def planted_cells(name, place, text):
    """Return the cells of a notebook with a giveaway: (source, outputs as HTML or text), with None for the cell of the question."""
    figure = FIGURE.format(
        alt=text if place == "alt" else "An arm.", caption=text if place == "caption" else "An arm at home."
    )
    title = f'<svg aria-label="{escape(text)}"></svg>' if place == "title" else ""
    return [
        (
            "markdown",
            f"# A lecture\n\n## {text if place == 'heading' else 'A section'}\n\n{text if place == 'text' else 'A text.'}",
            "",
        ),
        ("folded", f"x = 1\n{text}" if place == "folded" else "x = 1", ""),
        ("code", "draw()", figure + title),
        ("code", "show()", f"<pre>{escape(text)}</pre>" if place == "output" else ""),
        ("question", text if place == "own" else "", name),
        (
            "explanation" if "/" in name and QUESTIONS[name].kind == "predict" else "code",
            text if place == "next" else "y = 2",
            name,
        ),
        ("markdown", f"# The end\n\n## {text if place == 'below' else 'Summary'}\n\nA text.", ""),
    ]


def as_notebook(cells, with_widgets):
    made = []
    for kind, source, output in cells:
        if kind == "markdown":
            made.append(nbformat.v4.new_markdown_cell(source))
            continue
        cell = nbformat.v4.new_code_cell(source)
        if kind == "question" and "/" in output:
            cell.source += f'\nask("{output}")'
            cell.outputs = [
                nbformat.v4.new_output("execute_result", {"text/plain": Question(QUESTIONS[output]).text()})
            ]
        elif kind == "explanation":
            text = Explanation(Question(QUESTIONS[output])).card.text()
            cell.outputs = [nbformat.v4.new_output("execute_result", {"text/plain": text})]
        elif kind == "question":
            cell.source += f'\nattempt("{output}", ...)'
        elif "<" in output:
            cell.outputs = [nbformat.v4.new_output("display_data", {"text/html": output})]
        made.append(cell)
    return notebook_reading(nbformat.v4.new_notebook(cells=made), QUESTIONS, with_widgets)


def as_page(cells):
    return "".join(starmap(cell_of_page, cells)) + "</section></section>"


def cell_of_page(kind, source, output):
    if kind == "markdown":
        title, section, text = (escape(line.lstrip("# ")) for line in source.split("\n\n"))
        return f"<section><h1>{title}</h1><section><h2>{section}</h2><p>{text}</p>"
    call = ""
    if kind == "question":
        call = f'\nask("{output}")' if "/" in output else f'\nattempt("{output}", ...)'
    makes = {"question": question_html, "explanation": explanation_html}
    shown = makes[kind](output, QUESTIONS[output]) if kind in makes and "/" in output else output * ("<" in output)
    code = f'<div class="cell_input"><div class="highlight"><pre>{escape(source + call)}</pre></div></div>'
    folded = f"<details><summary>Show code</summary>{code}</details>" if kind == "folded" else code
    return f'<div class="cell docutils">{folded}<div class="cell_output">{shown}</div></div>'


def in_pdf(page):
    from kinsite.pdf_document import adapt

    return adapt(fragment_fromstring(page, create_parent="article"), "lectures/one.html", (), "html", "")


def test_a_question_that_gives_its_own_answer_away_is_found(monkeypatch):
    item = QUESTIONS["09/loop"]
    monkeypatch.setitem(QUESTIONS, "09/loop", replace(item, text=f"Joint C is lost without a message. {item.text}"))
    assert given_away_by_itself("09/loop") == ["Joint C is lost without a message."]


@pytest.mark.parametrize("form", ["lab", "plain notebook", "site", "pdf"])
def test_planted_giveaways_are_found(form):
    """And nothing is found without them."""

    def found(name, place, text):
        cells = planted_cells(name, place, text)
        page = as_page(cells)
        reading = {
            "lab": lambda: as_notebook(cells, with_widgets=True),
            "plain notebook": lambda: as_notebook(cells, with_widgets=False),
            "site": lambda: page_reading(page),
            "pdf": lambda: page_reading(in_pdf(page)),
        }[form]()
        return given_away(reading, Mark("asked" if "/" in name else "blank", name))

    assert [plant for plant in PLANTED if not found(*plant)] == []
    assert [(name, found(name, "nowhere", "")) for name, _, _ in PLANTED if found(name, "nowhere", "")] == []


def test_what_is_covered_until_the_answer_is_not_read():
    item = QUESTIONS["08/ring"]
    covered = '<div data-kinlib-slides data-kinlib-after="08/ring"><details><img alt="The ring has mobility 8."></details></div>'
    page = question_html("08/ring", item) + covered + explanation_html("08/ring", item)
    assert [one for one in page_reading(page) if isinstance(one, Passage)] == []
