"""Questions of a lecture: predictions, self-checks, and errors in the file of questions."""

import sys

import pytest
from circuits import write_course

from misstep.catalog import load_course
from misstep.questions.item import read_questions
from misstep.questions.widget import Question

WRITTEN = """
[order]
kind = 'predict'
text = 'Which comes first, for $a < b$?'
[[order.options]]
text = 'the left one'
why = 'It acts last.'
[[order.options]]
text = 'the right one'
right = true
why = 'It stands next to $M$.'
"""
NAME = "01/brightness"


@pytest.fixture
def course(tmp_path):
    yield load_course(write_course(tmp_path))
    for name in [name for name in sys.modules if name.partition(".")[0] == "circuits"]:
        del sys.modules[name]


@pytest.fixture
def question():
    return Question(read_questions(WRITTEN, "03.toml")["order"])


def test_a_prediction_is_recorded_and_not_judged(question):
    face = question._repr_mimebundle_()
    question.commit(0)
    assert (question.committed, question.choice) == (True, 0)
    said = question._widget.children[-1].value
    assert "Recorded" in said
    assert "acts last" not in said
    assert "application/vnd.jupyter.widget-view+json" in face


def test_a_self_check_explains_the_choice_and_names_the_right_one():
    question = Question(read_questions(WRITTEN.replace("predict", "check"), "03.toml")["order"])
    question._repr_mimebundle_()
    question.commit(0)
    said = question._widget.children[-1].value
    assert "A is not it" in said
    assert "It acts last." in said
    assert "Right is B" in said


def test_a_right_choice_is_told_why(question):
    question.commit(1)
    assert question.explanation().title == "B is right"
    assert question.explanation().body == ["It stands next to $M$."]


def test_the_first_commitment_stands(question):
    question.commit(0)
    question.commit(1)
    assert question.choice == 0


def test_pressing_a_letter_commits_and_shuts_the_others(question):
    question._repr_mimebundle_()
    rows = question._widget.children[1:-1]
    rows[1].children[0].click()
    assert question.choice == 1
    assert all(row.children[0].disabled for row in rows)
    assert rows[1].children[0].description == "B ●"


def test_a_choice_that_there_is_not_is_refused(question):
    with pytest.raises(ValueError, match="options 0 to 1; got 2"):
        question.commit(2)


def test_a_terminal_shows_the_question_too(question):
    assert question.text().splitlines() == [
        "Predict: Which comes first, for $a < b$?",
        "A  the left one",
        "B  the right one",
    ]


def test_an_uncommitted_question_says_so(course):
    course.ask(NAME)
    assert course.explain(NAME).card.title == "You have not committed to an answer yet"


def test_explain_compares_with_what_was_asked_on_this_page(course):
    course.ask(NAME).commit(course.find_question(NAME).right)
    assert course.explain(NAME).card.tone == "right"


def test_an_explanation_on_the_page_changes_when_the_reader_commits(course):
    question = course.ask(NAME)
    explanation = course.explain(NAME)
    explanation._repr_mimebundle_()
    assert "You have not committed" in explanation._widget.value
    question.commit(course.find_question(NAME).right)
    assert "is right" in explanation._widget.value


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[order", "03.toml is not TOML"),
        ("[order]\nkind = 'check'\ntext = '?'", "question 'order': options is missing"),
        (WRITTEN.replace("why = 'It acts last.'", ""), "option 1: why is missing"),
        (WRITTEN.replace("why = 'It acts last.'", "why = ''\nbecause = ''"), "'because' is not a key"),
        (WRITTEN.replace("right = true", ""), "one of them with right"),
        (WRITTEN.replace("why = 'It acts last.'", "why = ''\nright = true"), "one of them with right"),
        (WRITTEN.replace("'predict'", "'guess'"), "kind must be one of recall, predict, check; got 'guess'"),
    ],
)
def test_a_slip_in_a_file_is_named(text, words):
    with pytest.raises(ValueError, match=words):
        read_questions(text, "03.toml")


def test_names_that_there_are_not_are_refused(course):
    with pytest.raises(ValueError, match="must be named lecture/question"):
        course.find_question("nothing")
    with pytest.raises(ValueError, match=r"has no question 'nothing'. It has: "):
        course.find_question("01/nothing")
