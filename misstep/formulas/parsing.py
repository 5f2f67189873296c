r"""Formulas as people type them, parsed into syntax trees without running anything.

The language has numbers, names, + - * / and powers, functions called by name, brackets, and lists for matrices. Two factors
side by side are multiplied, as on paper: 2 sin(q) c_1. Greek letters, LaTeX's \theta and s_{12}, and superscripts are read
as what they mean.
"""

import ast
import re
import unicodedata
from collections.abc import Iterator

MAX_CHARACTERS = 10_000
"""The most characters of a formula, which SymPy may have written."""

FUNCTIONS = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "exp", "log", "ln", "abs", "Abs", "Matrix")
"""The functions of the language. A matrix is not a function, but it is written like one."""

KEYBOARD_SPELLINGS = {
    **{letter: unicodedata.name(letter).split()[-1].lower() for letter in "αβγδθλμξπρστφψω"},
    **{subscript: str(digit) for digit, subscript in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    **dict.fromkeys("·×⋅", "*"),
    **dict.fromkeys("−–", "-"),
    "²": "**2",
    "³": "**3",
    "^": "**",
    **dict.fromkeys("°º˚", "*pi/180"),
    **{fraction: f"({part})" for fraction, part in zip("½¼¾⅓⅔", ("1/2", "1/4", "3/4", "1/3", "2/3"), strict=True)},
}
"""How to type the signs that are written on paper but are missing on a keyboard."""

TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z]\w*)|(?P<sign>\*\*|[-+*/(),\[\]]))",
    re.ASCII,
)


def parse(text: str) -> ast.expr:
    r"""Read a text as a syntax tree of the language.

    Raises ValueError for a character or a construct that the language does not have, with the place, and for a text that is
    too long.

    >>> ast.unparse(parse(r"2 a_2 cos(θ_1)^2 - 1/2 s_{12}"))
    '2 * a_2 * cos(theta_1) ** 2 - 1 / 2 * s_12'
    """
    if len(text) > MAX_CHARACTERS:
        raise ValueError(f"A formula has at most {MAX_CHARACTERS} characters here, and this has {len(text)}.")
    clean = " ".join(_tokens(_plain(text)))
    try:
        return ast.parse(clean, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        advice = "Write functions with brackets, as in 2*sin(q) or a*cos(q1)/3."
        raise ValueError(f"{_cut(text)!r} is not finished, or a bracket is missing. {advice}") from error


def _plain(text: str) -> str:
    """Replace LaTeX and signs that are not on a keyboard by what a keyboard has."""
    # Python reads \t as a tab in a text without r in front of it.
    text = text.replace("\theta", "theta").strip().strip("$")
    # The braces of an index such as s_{12} are dropped; all other braces are brackets.
    text = re.sub(r"_\{(\w+)\}", r"_\1", text)
    text = re.sub(r"√\s*(\w+)", r"sqrt(\1)", text).replace("√", "sqrt")
    text = re.sub(r"\\(cdot|times)\b", "*", text)
    text = re.sub(r"\\(left|right|,|;|!)", " ", text)
    text = re.sub(r"\b(sp|sympy|np|numpy|math)\.", "", text)
    text = text.replace("{", "(").replace("}", ")").replace("\\", " ")
    return "".join(KEYBOARD_SPELLINGS.get(letter, letter) for letter in text)


def _tokens(text: str) -> Iterator[str]:
    """Cut a text into numbers, names and signs, with a * between two factors side by side."""
    before, kind, place = "", "", 0
    while text[place:].strip():
        found = TOKEN.match(text, place)
        if found is None:
            letter = text[place:].strip()[0]
            raise ValueError(f"{letter!r} is not part of a formula; see {_cut(text[max(0, place - 10) :])!r}.")
        place, word = found.end(), found[found.lastgroup or 0]
        ends = before in (")", "]") or (kind in ("number", "name") and before not in FUNCTIONS)
        begins = word == "(" or found.lastgroup == "name" or (found.lastgroup == "number" and kind != "number")
        if ends and begins:
            yield "*"
        yield word
        before, kind = word, found.lastgroup or ""


def _cut(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."
