"""Questions of a lecture: predictions, self-checks, and errors in the file of questions."""

import pytest

from misstep.catalog import Course
from misstep.display.card import inline
from misstep.questions.item import Item, Option, read_questions
from misstep.questions.page import explanation_html, question_html
from misstep.questions.widget import Explanation, Question

QUESTIONS = """
[order]
kind = 'predict'
text = 'Which comes first, for $a < b$?'
explanation = 'Read **from the left**, as in [02](02_b.ipynb).'
[[order.options]]
text = 'the left factor'
why = 'It acts last.'
[[order.options]]
text = 'the right factor'
right = true
"""
NAME = "02/rotation"


def test_a_self_check_explains_the_choice_and_names_the_right_one():
    check = QUESTIONS.replace("predict", "check").replace("explanation = ", "# ") + "why = 'It stands next to $M$.'"
    question = Question(read_questions(check, "03.toml")["order"])
    question._repr_mimebundle_()
    question.commit(0)
    reply = question._widget.children[-1].value
    assert "You said A, but B is right" in reply
    assert "It acts last." in reply
    assert "The correct answer is B: the right factor. It stands" in reply


def test_a_prediction_is_recorded_and_explained_only_afterwards():
    question = Question(read_questions(QUESTIONS, "03.toml")["order"])
    assert (question.committed, question.choice) == (False, -1)
    lesson = "<strong>from the left</strong>"
    explanation = Explanation(question)
    seen = [*question._repr_mimebundle_().values(), *explanation._repr_mimebundle_().values(), explanation.card.html()]
    assert not any("from the left" in str(one) for one in seen)
    question.commit(0)
    assert (question.committed, question.choice) == (True, 0)
    assert lesson in explanation.card.html()
    assert 'href="02_b.ipynb"' in explanation.card.html()
    reply = question._widget.children[-1].value
    assert "You said A. The answer is below." in reply
    assert "from the left" not in reply, "the reply above the picture does not explain"
    assert "acts last" not in reply


def test_an_error_in_a_file_of_questions_is_named():
    why = "why = 'It acts last.'"
    for text, words in [
        ("[order", "03.toml is not TOML"),
        (QUESTIONS.replace(why, ""), "question 'order': kind must be .* the right one of a prediction"),
        (QUESTIONS.replace(why, "why = ''\nbecause = ''"), "unexpected keyword argument 'because'"),
        (QUESTIONS.replace("right = true", ""), "exactly one of 2 to 8 options must have right"),
        (QUESTIONS.replace("predict", "check"), "which has an explanation instead"),
    ]:
        with pytest.raises(ValueError, match=words):
            read_questions(text, "03.toml")


# --- the order of the options ---

OPTIONS = [Option(str(n), f"because of {n}", right=n == 3) for n in range(5)] + [Option("none of them", "", last=True)]


def test_the_order_of_the_options_does_not_depend_on_that_in_the_file_and_reasons_stay_with_them():
    for seed in ("", "03/order", "03/order ada"):
        orders = [Item("count", "check", "?", order).shuffled(seed) for order in (OPTIONS, OPTIONS[::-1])]
        assert orders[0].options == orders[1].options
        assert set(orders[0].options) == set(OPTIONS)
        assert orders[0].options[-1].text == "none of them"
        assert orders[0].options[orders[0].right].text == "3"


def test_every_form_of_a_question_has_the_same_order():
    course = Course("kincourse")
    item, question = course.find_question(NAME), course.ask(NAME)
    texts = [option.text for option in item.options]
    question._repr_mimebundle_()
    widget = [row.children[1].value for row in question._widget.children[1:-1]]
    page, explained = question_html(NAME, item), explanation_html(NAME, item)
    assert widget == [inline(text) for text in texts]
    assert f'data-right="{item.right}"' in page
    for html in (page, explained):
        places = [html.index(f">{inline(text)}<") for text in texts]
        assert places == sorted(places)
