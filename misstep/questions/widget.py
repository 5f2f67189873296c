"""Questions as widgets: what a reader chose, and the explanation that follows."""

from typing import TYPE_CHECKING, Any

from traitlets import Bool, HasTraits, Int

from misstep.card import Card, inline
from misstep.questions.item import KINDS, LETTERS, Item
from misstep.questions.page import explanation_html, question_html
from misstep.static_output import is_static_export

if TYPE_CHECKING:
    import ipywidgets as widgets


class Question(HasTraits):
    """A question on the page: what was chosen, and whether the reader has committed to it.

    >>> from misstep.questions.item import Option
    >>> question = Question(Item("sum", "check", "2 + 2?", [Option("3", "One more."), Option("4", "Yes.", right=True)]))
    >>> print(question.text().splitlines()[2])
    B  4
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
        still = {"text/html": question_html(self.name, self.item)} if is_static_export() else {}
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
        still = {"text/html": explanation_html(question.name, question.item)} if is_static_export() else {}
        return {**self._face._repr_mimebundle_(**options), **still, "text/plain": self.card.text()}

    def _renew(self, _: Any) -> None:
        if self._face is not None:
            self._face.value = self.card.html()


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
