"""Questions of the lectures: recall at the start, predictions before a slider, self-checks at the end.

Their words stand in questions/NN_name.toml, one file a lecture, so that a reader of the notebook does not see the answer
beside the question. Each question is a table:

    [order]                                     # ask("03/order")
    kind = 'predict'                            # recall, predict or check
    text = 'Which factor moves the tool first?'

    [[order.options]]
    text = '$e^{[S_1] q_1}$'
    why = 'It stands leftmost, so it acts last.'

    [[order.options]]
    text = '$e^{[S_n] q_n}$'
    right = true
    why = 'It stands next to $M$, so it acts first.'

Single quotes keep the backslashes of formulas; three of them hold an apostrophe or a second line.

recall and check explain at once. predict only records: the picture that follows shall do the talking, and
explain("03/order") compares afterwards.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from traitlets import Bool, HasTraits, Int

from kinlib.view.drawing.static_export import for_a_page
from misstep.card import Card, inline
from misstep.questions.page import KINDS, LETTERS, explanation_html, question_html

if TYPE_CHECKING:
    import ipywidgets as widgets


@dataclass(frozen=True)
class Option:
    """One possible answer, and why it is right or wrong."""

    text: str
    why: str
    right: bool = False


@dataclass(frozen=True)
class Item:
    """A question in words, with exactly one right option."""

    name: str
    kind: str
    text: str
    options: Sequence[Option]

    @property
    def right(self) -> int:
        """The index of the right option."""
        return next(index for index, option in enumerate(self.options) if option.right)


class Question(HasTraits):
    """A question on the page: what was chosen, and whether the reader has committed to it.

    >>> question = ask("03/order")
    >>> print(question.text().splitlines()[2])
    B  The axis as you read it at home
    >>> question.commit(1)
    >>> question.explanation().title
    'B is right'
    """

    committed = Bool(False)
    choice = Int(-1)

    def __init__(self, item: Item, name: str = "") -> None:
        super().__init__()
        self.item = item
        self.name = name
        self._face: widgets.Widget | None = None

    def commit(self, choice: int) -> None:
        """Commit to an option, counted from 0. The first commitment stands.

        Raises ValueError for an option that there is not.
        """
        if choice not in range(len(self.item.options)):
            raise ValueError(f"{self.item.name} has options 0 to {len(self.item.options) - 1}; got {choice!r}.")
        if not self.committed:
            self.choice = choice
            self.committed = True

    def explanation(self) -> Card:
        """What there is to say of the choice: why it is right, or why it is not and what is."""
        item = self.item
        right = item.options[item.right]
        if not self.committed:
            return Card("blank", "You have not committed to an answer yet", [f"The question was: {item.text}"])
        chosen = item.options[self.choice]
        if chosen.right:
            return Card("right", f"{LETTERS[self.choice]} is right", [chosen.why])
        told = f"Right is {LETTERS[item.right]}: {right.text.rstrip('.')}. {right.why}"
        return Card("wrong", f"{LETTERS[self.choice]} is not it", [chosen.why, told])

    def _repr_mimebundle_(self, **options: Any) -> Any:
        if self._face is None:
            self._face = _face(self)
        still = {"text/html": question_html(self.name, self.item)} if for_a_page() else {}
        return {**self._face._repr_mimebundle_(**options), **still, "text/plain": self.text()}

    def text(self) -> str:
        """The question for a terminal."""
        lines = [f"{letter}  {option.text}" for letter, option in zip(LETTERS, self.item.options, strict=False)]
        return "\n".join([f"{KINDS[self.item.kind]}: {self.item.text}", *lines])


class Explanation:
    """What there is to say of a prediction: on the page, a card that changes by itself when the reader commits."""

    def __init__(self, question: Question) -> None:
        self.question = question
        self._face: widgets.Widget | None = None

    @property
    def card(self) -> Card:
        """The explanation as it stands now."""
        return self.question.explanation()

    def _repr_mimebundle_(self, **options: Any) -> Any:
        import ipywidgets as widgets  # where sheets are graded, nobody looks at questions

        if self._face is None:
            self._face = widgets.HTMLMath(self.card.html())
            self.question.observe(self._renew, "committed")
        question = self.question
        still = {"text/html": explanation_html(question.name, question.item)} if for_a_page() else {}
        return {**self._face._repr_mimebundle_(**options), **still, "text/plain": self.card.text()}

    def _renew(self, _: Any) -> None:
        if self._face is not None:
            self._face.value = self.card.html()


_asked: dict[str, Question] = {}


def ask(name: str) -> Question:
    """Put a question of a lecture on the page; name is "lecture/question", such as "03/order".

    Use what it returns as `after=` of a widget, which stays covered until the reader has committed.

    Raises ValueError for a name that there is not.

    >>> ask("03/nothing")
    Traceback (most recent call last):
    ValueError: Lecture 03 has no question 'nothing'. It has: ...
    """
    _asked[name] = Question(find(name), name)
    return _asked[name]


def explain(name: str) -> Explanation:
    """Compare the prediction made at ask(name) with the truth, as soon as it is made.

    Raises ValueError for a name that there is not.

    >>> ask("03/order").commit(0)
    >>> explain("03/order").card.title
    'A is not it'
    """
    return Explanation(_asked.get(name) or Question(find(name), name))


def find(name: str) -> Item:
    """The words of a question.

    Raises ValueError for a name that there is not, and for a file that is not as it should be, naming file and key.

    >>> find("03/order").kind
    'predict'
    """
    lecture, _, key = name.partition("/")
    items = _lectures().get(lecture)
    if items is None:
        raise ValueError(
            f"Questions are named lecture/question, such as 03/order; there is no lecture {lecture!r} in {name!r}."
        )
    if key not in items:
        raise ValueError(f"Lecture {lecture} has no question {key!r}. It has: {', '.join(items)}.")
    return items[key]


def read(text: str, file: str) -> dict[str, Item]:
    r"""Read the questions of one file.

    Raises ValueError that names the file, the question and what is wrong with it.

    >>> order = "[order]\nkind = 'check'\ntext = '?'"
    >>> options = [f"[[order.options]]\ntext = '{n}'\nwhy = '!'\nright = {n}" for n in ("true", "false")]
    >>> read("\n".join([order, *options]), "03_poe_space.toml")["order"].right
    0
    """
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{file} is not TOML: {error}") from error
    return {key: _item(key, table, f"{file}, question {key!r}") for key, table in tables.items()}


def _item(key: str, table: Any, place: str) -> Item:
    _keys(table, place, required={"kind", "text", "options"}, allowed=set())
    if table["kind"] not in KINDS:
        raise ValueError(f"{place}: kind should be one of {', '.join(KINDS)}; got {table['kind']!r}.")
    options = []
    for number, option in enumerate(table["options"], start=1):
        _keys(option, f"{place}, option {number}", required={"text", "why"}, allowed={"right"})
        options.append(Option(**option))
    if sum(option.right for option in options) != 1 or not 2 <= len(options) <= len(LETTERS):
        raise ValueError(f"{place}: there should be 2 to {len(LETTERS)} options, one of them right = true.")
    return Item(key, table["kind"], table["text"], options)


def _keys(table: Any, place: str, required: set[str], allowed: set[str]) -> None:
    keys = set(table) if isinstance(table, dict) else set()
    if missing := sorted(required - keys):
        raise ValueError(f"{place}: {missing[0]} is missing.")
    if unknown := sorted(keys - required - allowed):
        raise ValueError(f"{place}: {unknown[0]!r} is no key of a question. Is it misspelt?")


@cache
def _lectures() -> dict[str, dict[str, Item]]:
    folder = files("kincourse") / "questions"
    found = sorted((file for file in folder.iterdir() if file.name.endswith(".toml")), key=lambda file: file.name)
    return {file.name[:2]: read(file.read_text(encoding="utf-8"), file.name) for file in found}


def _face(question: Question) -> "widgets.Widget":
    """The question with its options, each a button with its letter beside its text, which may hold formulas."""
    import ipywidgets as widgets

    item = question.item
    reply = widgets.HTMLMath()
    buttons, rows = [], []
    for index, option in enumerate(item.options):
        letter = LETTERS[index]
        narrow = widgets.Layout(width="4em", flex="0 0 auto")
        button = widgets.Button(description=letter, tooltip=f"Commit to {letter}: {option.text}", layout=narrow)
        button.on_click(lambda _, index=index: question.commit(index))
        buttons.append(button)
        rows.append(
            widgets.HBox([button, widgets.HTMLMath(inline(option.text), layout=widgets.Layout(flex="1 1 auto"))])
        )

    def settle(_: Any = None) -> None:
        if not question.committed:
            return
        for button in buttons:
            button.disabled = True
        buttons[question.choice].description = f"{LETTERS[question.choice]} ●"
        buttons[question.choice].button_style = "info"
        if item.kind == "predict":
            note = f"You said {LETTERS[question.choice]}. Now look, and then compare."
            reply.value = Card("note", "Recorded", [note]).html()
        else:
            reply.value = question.explanation().html()

    question.observe(settle, "committed")
    settle()
    head = widgets.HTMLMath(f"<b>{KINDS[item.kind]}.</b> {inline(item.text)}")
    return widgets.VBox([head, *rows, reply])
