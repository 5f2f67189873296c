"""Static pages: questions include their explanations and sliders their pictures, but only on such pages."""

from html.parser import HTMLParser

import pytest

from kincourse import COURSE, ask, explain
from kincourse import find_question as find
from kinlib.chains.robots import rpr
from kinlib.view import explore, plot, slide
from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

ALL = [f"{lecture}/{key}" for lecture, items in COURSE.questions().items() for key in items]
VOID = {"br", "img", "input"}


class Tags(HTMLParser):
    """A strict HTML parser: every tag must be closed, in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.words, self.attributes = [], "", []
        self.feed(text)
        self.close()
        assert not self.open, f"never closed: {self.open}"

    def handle_starttag(self, tag, attributes):
        self.attributes.append(dict(attributes))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words += data


@pytest.fixture
def page(monkeypatch):
    monkeypatch.setenv(ENVIRONMENT_VARIABLE, "1")


def still(shown):
    bundle = shown._repr_mimebundle_()
    return (bundle[0] if isinstance(bundle, tuple) else bundle).get("text/html", "")


def line(slope):
    return plot([0, 1], {"line": [0, slope]}, xlabel="x", ylabel="y", alt=f"A line through 0 whose slope is {slope}.")


def test_every_question_is_complete_on_a_static_page(page):
    """Without a script the page shows each option and why it is right or wrong, and the HTML is well formed."""
    for name in ALL:
        item = find(name)
        asked = Tags(still(ask(name)))
        explained = Tags(still(explain(name))) if item.kind == "predict" else asked
        plain = [text.replace("`", "") for option in item.options for text in (option.text, option.why)]
        assert [text for text in plain if text not in explained.words] == [], name
        assert all(option.text.replace("`", "") in asked.words for option in item.options), name
        question = next(found for found in asked.attributes if "data-misstep-question" in found)
        assert (question["data-misstep-question"], int(question["data-right"])) == (name, item.right)


def test_a_notebook_in_a_lab_does_not_contain_the_answers(monkeypatch):
    """Students save their notebooks, and the explanations must not be in the file beside the question."""
    monkeypatch.delenv(ENVIRONMENT_VARIABLE, raising=False)
    assert still(ask("03/check-2")) == still(explain("03/order")) == ""


def test_what_is_covered_names_its_question(page):
    question = ask("03/order")
    for waiting in (slide(line, "slope", [1, 2], after=question), explore(rpr(), after=question)):
        assert Tags(still(waiting)).attributes[0]["data-kinlib-after"] == "03/order"
    assert "data-kinlib-after" not in still(explore(rpr()))
