"""The questions of the lectures: every file can be read, and every option has an explanation."""

import pytest

from kincourse import COURSE, find_question
from misstep.questions.item import KINDS

QUESTIONS = [(lecture, key) for lecture, items in COURSE.questions().items() for key in items]


def test_every_file_of_questions_is_read():
    assert len(list(COURSE.folder.glob("lecture_*/questions.toml"))) == len(COURSE.questions()) >= 5


@pytest.mark.parametrize(("lecture", "key"), QUESTIONS)
def test_every_option_of_every_question_has_an_explanation(lecture, key):
    item = find_question(f"{lecture}/{key}")
    assert item.kind in KINDS
    assert all(len(option.why) > 20 for option in item.options)
    assert len({option.text for option in item.options}) == len(item.options)
