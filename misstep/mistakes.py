"""Mistakes: named errors, the wrong answers to which they lead, and the feedback for them."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class Mistake:
    """A named error, the wrong answer to which it leads, and the feedback for a student who gave this answer.

    name     the name, the same in every problem in which the error occurs
    value    the wrong answer
    message  the feedback if the whole answer is this one
    part     the feedback if one part of the answer is that of this one; it speaks of this part alone. If it is empty, the
             mistake explains only whole answers
    did      what leads to the answer, from the verb on, if it is a slip in the solution; the message is made of it
    advice   a sentence on what is right
    spoils   whether it is a wrong method for the whole answer, so that a part that comes out right earns nothing
    """

    name: str
    value: Any
    message: str
    part: str = ""
    did: str = ""
    advice: str = ""
    spoils: bool = False
