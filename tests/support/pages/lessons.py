"""What the tests look for on a page to see whether the explanation of a prediction is open."""

import re

from kincourse import find_question


def words_of(name: str) -> str:
    """Return the longest stretch of an explanation that has neither marks nor formulas, at most 60 characters of it."""
    return plain_words(find_question(name).explanation)


def plain_words(text: str) -> str:
    return max(re.split(r"[$*`\[\]()\n\"']", text), key=len).strip()[:60].strip()
