"""Nothing that is read before a question or a blank step gives its answer away.

What only the right option says are the words and numbers that neither the other options nor the question have. A passage, that
is a sentence, a line of code or of output, or an alternative text, gives the answer away if it has all of them. The answer to
a blank step is its numbers, in their order.
"""

import re
from pathlib import Path

import numpy as np
import pytest
from kinsite.execute import execute

from kincourse import COURSE, blanks

ROOT = Path(__file__).parents[2]
LECTURES = sorted((ROOT / "notebooks").glob("[0-9]*.ipynb"))
MIN_WORDS = 4
"""Fewer words are often said of something else, but a number of two digits at least is enough."""

WORDS = "a an and are as at be but by do for from has have in is it its of on or so than that the then this to was"
COMMON = set(re.findall(r"\w+", WORDS))
NUMBER = r"(?<![\w.:])[-\N{MINUS SIGN}]?\d+(?:\.\d+)?"
TOKEN = re.compile(rf"{NUMBER}|[a-z_]\w+|[a-z]", re.IGNORECASE)


def tokens(text):
    r"""The words and numbers of a text, each in one spelling: "0.50" is "0.5".

    >>> sorted(tokens("The moment of joint 2 is $-0.50$"))
    ['-0.5', '2', 'joint', 'moment']
    """
    found = (token.replace("\N{MINUS SIGN}", "-").lower() for token in TOKEN.findall(text))
    return {f"{float(token):g}" if re.fullmatch(NUMBER, token) else token for token in found} - COMMON


def numbers(text):
    return [float(token.replace("\N{MINUS SIGN}", "-")) for token in re.findall(NUMBER, text)]


def passages(cell):
    """What is read of a cell: sentences of text, lines of code and output, alternative texts of pictures."""
    if cell.cell_type == "markdown":
        return re.split(r"(?<=[.?!:;])\s+|\n\s*\n|\n(?=\s*[-*#>|])", cell.source)
    lines = cell.source.splitlines()
    for output in cell.get("outputs", ()):
        data = output.get("data", {})
        html = "".join(data.get("text/html", ""))
        if "data-misstep-question" in html or "data-misstep-explain" in html:
            continue  # a question repeats its options; an explanation is covered until it is answered
        lines += re.findall(r'(?:aria-label|alt)="([^"]*)"', html)
        lines += "".join(output.get("text", "") or data.get("text/plain", "")).splitlines()
    return lines


def only_right(item):
    """What only the right option of a question says."""
    others = " ".join(option.text for option in item.options if not option.right)
    return tokens(item.options[item.right].text) - tokens(others) - tokens(item.text)


def gives_away(passage, told):
    is_enough = len(told) >= MIN_WORDS or any(re.fullmatch(r"-?[\d.]{2,}", token) for token in told)
    return is_enough and told <= tokens(passage)


def has_numbers(passage, values):
    """Whether a passage has these numbers one after the other, to the digits that it shows."""
    said = numbers(passage)
    starts = range(len(said) - len(values) + 1)
    return any(np.allclose(said[k : k + len(values)], values, rtol=0, atol=5e-5) for k in starts)


def findings(notebook, questions, answers):
    """Each passage that gives an answer away to which the notebook comes later.

    questions, answers  what only the right option of each question says, and the numbers of each blank step
    """
    above, found = [], []
    for cell in notebook.cells:
        for name in (name for name in questions if f'ask("{name}")' in cell.source):
            found += [f"{name}: {passage}" for passage in above if gives_away(passage, questions[name])]
        for number in (number for number in answers if f'attempt("{number}"' in cell.source):
            found += [f"{number}: {passage}" for passage in above if has_numbers(passage, answers[number])]
        above += passages(cell)
    return found


def answers_of(lecture):
    """The numbers of each blank step of a lecture whose answer has at least three that are not 0 or 1."""
    values = {number: step.variant("anybody").answer.value for number, step in blanks().items()}
    arrays = {
        number: value
        for number, value in values.items()
        if number.startswith(f"{lecture}.") and hasattr(value, "shape")
    }
    flat = {number: np.atleast_1d(np.asarray(value, dtype=float))[:3].ravel() for number, value in arrays.items()}
    return {number: list(value) for number, value in flat.items() if np.sum(~np.isin(np.abs(value), (0, 1))) > 2}


@pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)
def test_nothing_above_a_question_or_a_blank_step_gives_its_answer_away(path):
    lecture = path.stem.partition("_")[0]
    questions = {f"{lecture}/{name}": only_right(item) for name, item in COURSE.questions().get(lecture, {}).items()}
    assert findings(execute(path), questions, answers_of(lecture)) == []
