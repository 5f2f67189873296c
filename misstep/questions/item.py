"""Questions of the lectures in TOML: recall at the start, predictions before a slider, checks at the end.

The questions of a lecture are in its `questions.toml` and not in the notebook, because there a reader would see the answer
beside the question. Each question is a table:

    [order]                                     # ask("03/order")
    kind = 'predict'                            # recall, predict or check
    text = 'Which factor moves the tool first?'
    explanation = 'A motion in the space frame multiplies **from the left**, see [01](01_frames.ipynb).'

    [[order.options]]
    text = '$e^{[S_1] q_1}$'
    why = 'It is the leftmost factor, so it acts last.'

    [[order.options]]
    text = '$e^{[S_n] q_n}$'
    right = true

Single quotes keep the backslashes of formulas. Use three single quotes for text with an apostrophe or a second line.

The options are shown in an order of their own, which depends on the question and on the texts of the options, so that the place
of the right one says nothing. An option that speaks of the others, such as "None of them", is marked with `last = true`.

Questions of the kinds recall and check show the reason of the chosen option at once. A prediction is only recorded, because
the figure that follows shows the answer. explain("03/order") compares them afterwards and shows the explanation, Markdown which
only a prediction has, and which is the reason of its right option. It precedes the options, because TOML counts a key after them
as a key of the last option.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import Any

KINDS = {"recall": "Remember", "predict": "Predict", "check": "Check yourself"}
LETTERS = "ABCDEFGH"


@dataclass(frozen=True)
class Option:
    """One possible answer; why it is right or wrong, "" if an explanation says it; and whether it speaks of the others."""

    text: str
    why: str = ""
    right: bool = False
    last: bool = False


@dataclass(frozen=True)
class Item:
    """A question in words, with exactly one right option; the explanation of a prediction is Markdown."""

    name: str
    kind: str
    text: str
    options: Sequence[Option]
    explanation: str = ""

    @property
    def right(self) -> int:
        """The index of the right option."""
        return next(index for index, option in enumerate(self.options) if option.right)

    def shuffled(self, seed: str) -> "Item":
        """Return the question with its options in another order, which depends on the seed and the texts of the options."""
        digests = {option: sha256(f"{seed}\0{option.text}".encode()).digest() for option in self.options}
        return replace(self, options=sorted(self.options, key=lambda option: (option.last, digests[option])))


def read_questions(text: str, file: str) -> dict[str, Item]:
    """Read the questions of one file.

    Raises ValueError for an invalid file; the message names the file, the question and the error.
    """
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{file} is not TOML: {error}") from error
    return {key: _item(key, table, f"{file}, question {key!r}") for key, table in tables.items()}


def _item(key: str, table: Any, place: str) -> Item:
    try:
        options = [Option(**option) for option in table.pop("options")]
        item = Item(key, options=options, **table)
    except (AttributeError, KeyError, TypeError) as error:
        missing = f"{error} is missing." if isinstance(error, KeyError) else error
        raise ValueError(f"{place}: {missing}") from error
    is_prediction = item.kind == "predict"
    has_reasons = all(bool(option.why) != (option.right and is_prediction) for option in options)
    if not 2 <= len(options) <= len(LETTERS) or [option.right for option in options].count(True) != 1:
        raise ValueError(f"{place}: exactly one of 2 to {len(LETTERS)} options must have right = true.")
    if item.kind not in KINDS or bool(item.explanation) != is_prediction or not has_reasons:
        raise ValueError(
            f"{place}: kind must be one of {', '.join(KINDS)}. Each option has why, but the right one of a prediction, which has "
            "an explanation instead."
        )
    return item.shuffled(place)
