"""Questions: they record, explain and keep quiet until asked; and a slip in their file is named."""

from importlib.resources import files

import pytest

from kincourse import COURSE, ask, explain
from kincourse import find_question as find
from misstep.questions.item import KINDS, read
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
ALL = [(lecture, key) for lecture, items in COURSE.questions().items() for key in items]


@pytest.fixture
def question():
    return Question(read(WRITTEN, "03.toml")["order"])


def test_a_prediction_is_recorded_and_not_judged(question):
    face = question._repr_mimebundle_()
    question.commit(0)
    assert (question.committed, question.choice) == (True, 0)
    said = question._face.children[-1].value
    assert "Recorded" in said
    assert "acts last" not in said
    assert "application/vnd.jupyter.widget-view+json" in face


def test_a_self_check_explains_the_choice_and_names_the_right_one():
    question = Question(read(WRITTEN.replace("predict", "check"), "03.toml")["order"])
    question._repr_mimebundle_()
    question.commit(0)
    said = question._face.children[-1].value
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
    rows = question._face.children[1:-1]
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


def test_an_uncommitted_question_says_so():
    lecture, key = ALL[0]
    ask(f"{lecture}/{key}")
    assert explain(f"{lecture}/{key}").card.title == "You have not committed to an answer yet"


def test_explain_compares_with_what_was_asked_on_this_page():
    lecture, key = ALL[0]
    ask(f"{lecture}/{key}").commit(find(f"{lecture}/{key}").right)
    assert explain(f"{lecture}/{key}").card.tone == "right"


def test_an_explanation_on_the_page_changes_when_the_reader_commits():
    lecture, key = ALL[0]
    question = ask(f"{lecture}/{key}")
    explanation = explain(f"{lecture}/{key}")
    explanation._repr_mimebundle_()
    assert "You have not committed" in explanation._face.value
    question.commit(find(f"{lecture}/{key}").right)
    assert "is right" in explanation._face.value


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[order", "03.toml is not TOML"),
        ("[order]\nkind = 'check'\ntext = '?'", "question 'order': options is missing"),
        (WRITTEN.replace("why = 'It acts last.'", ""), "option 1: why is missing"),
        (WRITTEN.replace("why = 'It acts last.'", "why = ''\nbecause = ''"), "'because' is no key"),
        (WRITTEN.replace("right = true", ""), "one of them right"),
        (WRITTEN.replace("why = 'It acts last.'", "why = ''\nright = true"), "one of them right"),
        (WRITTEN.replace("'predict'", "'guess'"), "kind should be one of recall, predict, check; got 'guess'"),
    ],
)
def test_a_slip_in_a_file_is_named(text, words):
    with pytest.raises(ValueError, match=words):
        read(text, "03.toml")


def test_names_that_there_are_not_are_refused():
    with pytest.raises(ValueError, match="named lecture/question"):
        find("nothing")
    with pytest.raises(ValueError, match=r"has no question 'nothing'. It has: "):
        find(f"{ALL[0][0]}/nothing")


def test_every_file_of_questions_is_read():
    folder = files("kincourse") / "questions"
    assert len([file for file in folder.iterdir() if file.name.endswith(".toml")]) == len(COURSE.questions()) >= 5


@pytest.mark.parametrize(("lecture", "key"), ALL)
def test_every_option_of_every_question_is_explained(lecture, key):
    item = find(f"{lecture}/{key}")
    assert item.kind in KINDS
    assert all(len(option.why) > 20 for option in item.options)
    assert len({option.text for option in item.options}) == len(item.options)
