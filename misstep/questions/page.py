"""Questions for a page without a kernel: HTML that is readable by itself, and that a script can make interactive.

The script finds the questions by the attributes data-misstep-question and data-misstep-explain. Without the script, a click
on an option opens its explanation; that of a prediction opens where the lecture compares.
"""

from html import escape

from misstep.display.card import inline
from misstep.display.markdown import markdown_html
from misstep.questions.item import KINDS, Item, Option


def question_html(name: str, item: Item) -> str:
    """Return a question and its options with their explanations; the options of a prediction are without explanations."""
    options = "".join(f"<li>{_option(option, item.kind)}</li>" for option in item.options)
    kind = KINDS[item.kind]
    return (
        f'<div role="group" class="misstep-question" data-misstep-question="{escape(name)}" data-kind="{item.kind}" '
        f'data-right="{item.right}" aria-label="{kind}: a question">'
        f"<p><strong>{kind}.</strong> {inline(item.text)}</p>"
        f'<ol class="misstep-options" type="A">{options}</ol></div>'
    )


def explanation_html(name: str, item: Item, output: str = "") -> str:
    """Return the explanation of a prediction and the reasons of all its options, closed until the reader has made it.

    output  text that a computation has given, shown below the explanation
    """
    shown = f"<pre>{escape(output)}</pre>" if output else ""
    explanations = "".join(f"<li><p>{inline(option.text)}</p>{_why(option)}</li>" for option in item.options)
    return (
        f'<div role="group" class="misstep-explanation" data-misstep-explain="{escape(name)}" aria-label="The explanation of a prediction">'
        f"<details><summary>Compare with your prediction: {inline(item.text)}</summary>"
        f'<ol class="misstep-options" type="A">{explanations}</ol>'
        f'<div class="misstep-lesson">{markdown_html(item.explanation)}{shown}</div></details></div>'
    )


def _option(option: Option, kind: str) -> str:
    if kind == "predict":
        return f'<div class="misstep-option">{inline(option.text)}</div>'
    return f'<details class="misstep-option"><summary>{inline(option.text)}</summary>{_why(option)}</details>'


def _why(option: Option) -> str:
    verdict = "Right." if option.right else "Not it."
    return f'<p class="misstep-why"><strong>{verdict}</strong>{inline(f" {option.why}".rstrip())}</p>'
