"""Questions as widgets: buttons for the options, and the explanation of the chosen one."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from traitlets import Bool, HasTraits, Int

from misstep.display.card import Card, inline
from misstep.display.lecture_address import is_page
from misstep.questions.item import KINDS, LETTERS, Item
from misstep.questions.page import explanation_html, question_html

if TYPE_CHECKING:
    import ipywidgets as widgets


ROW = "misstep-option-row"
STYLE = (
    f"<style>.{ROW} {{ position: relative; overflow: visible; border-radius: 4px }} "
    f".{ROW}:has(button:enabled):hover {{ background: color-mix(in srgb, currentColor 8%, transparent) }} "
    f".{ROW} button {{ position: static; overflow: visible }} "
    f".{ROW} button::after {{ content: ''; position: absolute; inset: 0; z-index: 1; cursor: pointer }} "
    f".{ROW} button:disabled::after {{ content: none }}</style>"
)
"""An option is pressed anywhere in its row: its button covers the row."""


class Question(HasTraits):
    """A question of a lecture, which displays itself.

    committed  whether the reader has committed to an option
    choice     the index of this option, or -1

    >>> from misstep.questions.item import Option
    >>> question = Question(Item("sum", "check", "2 + 2?", [Option("3", "One more."), Option("4", "Yes.", right=True)]))
    >>> question.commit(1)
    >>> question.explanation().title
    'You said B, and B is right'
    """

    committed = Bool(False)
    choice = Int(-1)

    def __init__(self, item: Item, name: str = "") -> None:
        super().__init__()
        self.item = item
        self.name = name

    def commit(self, choice: int) -> None:
        """Commit to an option, by its index. Only the first commitment counts."""
        if not self.committed:
            self.choice = choice
            self.committed = True

    def explanation(self, anyway: bool = False, output: str = "") -> Card:
        """Return a card that compares the chosen option with the right one, and explains a prediction.

        anyway  whether the explanation is shown to a reader who has not committed to an option
        output  text that a computation has given, shown below the explanation
        """
        item = self.item
        right = item.options[item.right]
        correction = f"The correct answer is {LETTERS[item.right]}: {right.text.rstrip('.')}. {right.why}".strip()
        lesson = [("markdown", item.explanation)] * bool(item.explanation) + [("pre", output)] * bool(output)
        if not self.committed and anyway:
            return Card("note", "Shown without a prediction", [correction, *lesson])
        if not self.committed:
            return Card("blank", "You have not committed to an answer yet", [f"The question was: {item.text}"])
        chosen = item.options[self.choice]
        if chosen.right:
            title = f"You said {LETTERS[self.choice]}, and {LETTERS[self.choice]} is right"
            return Card("right", title, [*filter(None, [chosen.why]), *lesson])
        title = f"You said {LETTERS[self.choice]}, but {LETTERS[item.right]} is right"
        return Card("wrong", title, [chosen.why, correction, *lesson])

    @cached_property
    def _widget(self) -> "widgets.Widget":
        """Return the question with its options: for each option a button with its letter, and its text, which may contain formulas."""
        import ipywidgets as widgets

        item = self.item
        reply = widgets.HTMLMath()
        buttons, rows = [], []
        for index, option in enumerate(item.options):
            letter = LETTERS[index]
            narrow = widgets.Layout(width="4em", flex="0 0 auto")
            button = widgets.Button(description=letter, tooltip=f"Commit to {letter}: {option.text}", layout=narrow)
            button.on_click(lambda _, index=index: self.commit(index))
            buttons.append(button)
            text = widgets.HTMLMath(inline(option.text), layout=widgets.Layout(flex="1 1 auto"))
            row = widgets.HBox([button, text], layout=widgets.Layout(align_items="baseline"))
            rows.append(row.add_class(ROW))

        def show_choice(_: Any = None) -> None:
            if not self.committed:
                return
            for button in buttons:
                button.disabled = True
            buttons[self.choice].description = f"{LETTERS[self.choice]} ●"
            buttons[self.choice].button_style = "info"
            if item.kind == "predict":
                reply.value = Card("note", f"You said {LETTERS[self.choice]}. The answer is below.").html()
            else:
                reply.value = self.explanation().html()

        self.observe(show_choice, "committed")
        show_choice()
        head = widgets.HTMLMath(f"{STYLE}<b>{KINDS[item.kind]}.</b> {inline(item.text)}")
        return widgets.VBox([head, *rows, reply])

    def _repr_mimebundle_(self, **options: Any) -> Any:
        html = question_html(self.name, self.item)
        return _bundle(self._widget, html, f"{KINDS[self.item.kind]}: {self.item.text}", options)


class Explanation:
    """The explanation of a prediction, as a card that opens when the reader commits to an option, or asks to see it anyway."""

    def __init__(self, question: Question, output: str = "") -> None:
        self.question, self.output = question, output

    @cached_property
    def _widget(self) -> "widgets.Widget":
        """Return the card, and until it is opened a button below it. JupyterLab follows the links of an output, not of a widget."""
        import ipywidgets as widgets  # questions are not shown where sheets are graded, so it need not be installed there

        question, card = self.question, widgets.Output()
        anyway = widgets.Button(description="Show anyway", tooltip="Show the explanation without a prediction")
        box = widgets.VBox()

        def show(shown: Card, is_open: bool = True) -> None:
            card.outputs = ({"output_type": "display_data", "data": {"text/html": shown.html()}, "metadata": {}},)
            box.children = [card] if is_open else [card, anyway]

        anyway.on_click(lambda _: show(question.explanation(anyway=True, output=self.output)))
        question.observe(lambda _: show(self.card), "committed")
        show(self.card, question.committed)
        return box

    @property
    def card(self) -> Card:
        """The current explanation."""
        return self.question.explanation(output=self.output)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        html = explanation_html(self.question.name, self.question.item, self.output)
        return _bundle(self._widget, html, self.card.text(), options)


def _bundle(widget: "widgets.Widget", html: str, text: str, options: Any) -> dict[str, Any]:
    return {**widget._repr_mimebundle_(**options), **({"text/html": html} if is_page() else {}), "text/plain": text}
