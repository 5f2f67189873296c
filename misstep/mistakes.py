"""Mistakes: named errors, the wrong answers to which they lead, and the feedback for them."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class Mistake:
    """A named error, the wrong answer to which it leads, and the feedback for a student who gave this answer.

    name      the name, the same in every problem in which the error occurs
    value     the wrong answer
    message   the feedback for it
    in_parts  whether it also explains one part of the answer; otherwise only the whole answer does
    did       what leads to the answer, from the verb on, if it is a slip in the solution; the message is made of it
    advice    a sentence on what is right
    spoils    whether it is a wrong method for the whole answer, so that a part that comes out right earns nothing
    """

    name: str
    value: Any
    message: str
    in_parts: bool = False
    did: str = ""
    advice: str = ""
    spoils: bool = False
