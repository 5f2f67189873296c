"""The gate against giveaways: it lists what gives an answer away in the reading of a lecture, in whatever form it is read."""

from pathlib import Path

import nbformat
from giveaways import Answer, BlankAnswer, Passage, Rarity, computed, passages_of
from readings import Mark, Reading, window

from kincourse import COURSE, blanks

LECTURES = sorted((Path(__file__).parents[3] / "notebooks").glob("[0-9]*.ipynb"))
QUESTIONS = {f"{lecture}/{name}": item for lecture, items in COURSE.questions().items() for name, item in items.items()}
SOURCES = [cell.source for path in LECTURES for cell in nbformat.read(path, as_version=4).cells]
RARITY = Rarity(passage for source in SOURCES for passage in passages_of(source))


def giveaways(reading: Reading, number: str) -> list[str]:
    """List what gives an answer away in the reading of the lecture with this number. Raises ValueError if a question is not asked."""
    marks = [one for one in reading if isinstance(one, Mark) and one.kind in ("asked", "blank")]
    unasked = {name for name in QUESTIONS if name.startswith(f"{number}/")} - {mark.name for mark in marks}
    if unasked:
        raise ValueError(
            f"every question must be asked in its lecture; these are not, or are not found: {sorted(unasked)}."
        )
    return [
        f"{mark.name}: {one.kind} of {one.cell}: {one.text[:300]}"
        for mark in marks
        for one in given_away(reading, mark)
    ]


def given_away(reading: Reading, mark: Mark) -> list[Passage]:
    """List the passages that give away the answer to a question or to a blank step."""
    answer = answer_to(mark.name)
    if answer is None:
        return []
    whole = mark.kind == "blank" or QUESTIONS[mark.name].kind != "check"
    return [one for one, place in window(reading, mark, whole) if _tells(answer, one, place)]


def given_away_by_itself(name: str) -> list[str]:
    """List the sentences of a question that give its own answer away, and not one of its facts."""
    answer = answer_to(name)
    return [sentence for sentence in passages_of(QUESTIONS[name].text) if answer.is_in(sentence, "section")]


def answer_to(name: str) -> Answer | BlankAnswer | None:
    """Return what gives an answer away; None for a blank step whose answer is no array of numbers, such as a DH table."""
    if name in QUESTIONS:
        return Answer(QUESTIONS[name], RARITY)
    problem = blanks()[name].variant("anybody")
    if not hasattr(problem.answer.value, "shape") and not isinstance(problem.answer.value, (int, float)):
        return None
    return BlankAnswer(problem.answer.value, problem.statement, getattr(problem.answer, "unit", "") != "radians")


def _tells(answer: Answer | BlankAnswer, passage: Passage, place: str) -> bool:
    """Whether a passage tells the answer. A question reads code and output by line, a matrix may fill a whole cell."""
    texts = {passage.text, computed(passage.text)}
    if isinstance(answer, BlankAnswer):
        return any(answer.is_in(text, place) for text in texts)
    if "\n" in passage.text.strip() and passage.kind in ("code", "output"):
        return False
    proves = place == "own" and passage.kind == "code" and passage.text.strip().startswith("assert ")
    return proves or any(answer.is_in(text, place) for text in texts) or answer.letter_is_in(passage.text)
