r"""Find what gives away the answer to a question or to a blank step before the reader commits to one.

The answer to a question is what only its right option has: words and numbers, or if it has none, their order. They are compared
by what they mean. A word counts without its ending, and a name in code as its words; "twenty", "20" and "20.0" are one number,
as are "180°", `\pi` and `np.pi`; "0.628" is "0.63" with one more digit, and so is `0.1 * 2 * np.pi`.
A passage, that is a sentence, a line of code or of output, or an alternative text, gives the answer away if it has most of what
tells the right option from each other one, and less of what tells that one from the right one. Rare tokens weigh more. In the
section of the question little weight is enough; far above it the passage must weigh more, and speak of the question.
The answer to a blank step is a sequence of numbers; a letter in a place of a matrix may be any number.
"""

import ast
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import inf, log, pi, sqrt

import numpy as np
import snowballstemmer

from misstep.questions.item import LETTERS, Item

ENOUGH = 0.5
"""Which share, by weight, of what only the right option has is a giveaway."""
WEIGHTS = {"own": 1.4, "section": 3.3, "above": 5.0}
"""How much a giveaway weighs at least in the cell of the question or below it, in its section, and above that."""
CLAUSE_WEIGHT = 7.0
"""How much it weighs at least if it has only a clause of the right option."""
ABOUT_WEIGHT = 3.0
"""How much of the question it mentions at least above the section. Weights are logarithms of how rare tokens are."""
FEW_IN_A_MATRIX = 9
"""How many numbers a matrix has at least."""
PAIR = 3
"""How many tokens apart two tokens may be that count as a pair."""


@dataclass(frozen=True)
class Passage:
    """Something that is read as a whole: its kind, such as "code" or "alternative text", its text, and the name of its cell."""

    kind: str
    text: str
    cell: str


# --- tokens ---

SPELLINGS = [
    (r"\\(?:text|mathrm|operatorname|bar|dot|hat|mathbf|pm)\b|\\[,;!: ]|\\q?quad\b|\\(?:big|Big|left|right)\w*", " "),
    (r"(?:\b[a-z]\w*\.)+(?=[a-zA-Z]\b)", ""),
    (r"(?:\w+\.)*exp\(|\\exp\b|(?<![a-zA-Z\\])e\^", " exp "),
    (r"\b10\^\{?(-?\d+)\}?", r"1e\1"),
    (r"\^\{?\\circ\}?|°|\s+degrees\b", "deg"),
    (r"(?:np|sp|math)\.pi\b|\\pi\b|π", " pi "),
    (r"_\{(\w+)\}", r"_\1"),
    (r"(?i)\b([xyz])\W{1,5}(?!\1)([xyz])\W{1,5}(?:and\W{1,3})?(?!\1|\2)[xyz]\b", " axes "),  # a list of all three
    (r"(?i)\b[xyz] along [-(\w]", " axis "),
    (r"\\([a-zA-Z]+)", r" \1"),
    ("[\N{MINUS SIGN}\N{EN DASH}]", "-"),
]
DIGITS = r"\d+(?:\.\d*)?(?:e[-+]?\d+)?"
TOKEN = re.compile(
    rf"(?P<sign>(?<![\w)\]])-\s?)?(?:(?P<pi>(?:(?P<factor>{DIGITS})\s*\*?\s*)?(?<![a-z])pi(?![a-z])(?:\s*/\s*(?P<part>\d+))?)"
    rf"|(?<![\w.])(?P<number>{DIGITS})(?:/(?P<below>\d+))?(?P<degrees>\s?deg)?)|(?P<name>[A-Za-z]\w*)"
)
COUNTED = """zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen
    eighteen nineteen twenty"""
ORDINALS = {"second": 2, "third": 3, "fourth": 4, "fifth": 5, "twice": 2, "both": 2}
NUMBER_WORDS = {word: number for number, word in enumerate(COUNTED.split())} | ORDINALS
STOP_WORDS = frozenset(
    re.findall(
        r"\w+",
        """a an and are as at be been but by can did do does every for from goes had has have if in into is it its let of on once
    or so such than that the their then there these they this those to up us was we were what when where which while will with
    would you your all any also each how just more most much only other same some because about after again before yes np
    kl sp return def import lambda self print array begin end pmatrix r""",
    )
)
NEGATIONS = dict.fromkeys(("no", "not", "never", "neither", "nor", "cannot", "unchanged"), "not")
stem = cache(snowballstemmer.stemmer("english").stemWord)


@dataclass(frozen=True)
class Number:
    """A number, the decimals to which it is written, and whether it may be an angle; an angle counts in degrees, too."""

    value: float
    decimals: float = inf
    angle: bool = False

    def matches(self, other: "Number") -> bool:
        """Whether two numbers are the same to the decimals that both have, if these leave two digits at least."""
        decimals = min(self.decimals, other.decimals)
        is_rounded = decimals < inf and abs(other.value) * 10**decimals >= 10
        allowed = 0.5001 * 10.0**-decimals if is_rounded else 1e-9 * max(1.0, abs(other.value))
        turns = (1, 180 / pi, pi / 180) if self.angle or other.angle else (1,)
        return any(abs(self.value * turn - other.value) <= allowed for turn in turns)


Token = str | Number


@cache
def tokens(text: str) -> tuple[Token, ...]:
    r"""Return the words, names and numbers of a text, code or formula, each in one spelling.

    >>> tokens(r"$\alpha_3 = 1$, jointAngles_left")
    ('alpha_3', Number(value=1.0, decimals=inf, angle=False), 'joint', 'angl', 'left')
    """
    for pattern, replacement in SPELLINGS:
        text = re.sub(pattern, replacement, text)
    return tuple(token for found in TOKEN.finditer(text) for token in _tokens(found))


def _tokens(found: re.Match[str]) -> Iterator[Token]:
    sign = -1.0 if found["sign"] else 1.0
    if found["pi"]:
        yield Number(sign * float(found["factor"] or 1) * pi / float(found["part"] or 1), angle=True)
    elif found["number"]:
        mantissa, _, exponent = found["number"].partition("e")
        decimals = len(mantissa.partition(".")[2])
        exact = found["below"] or exponent or not decimals
        value = sign * float(found["number"]) / float(found["below"] or 1)
        yield Number(value, inf if exact else decimals, angle=bool(found["degrees"]))
    elif re.fullmatch(r"[A-Za-z]\w?|(?:[A-Za-z]|alpha|beta|gamma|theta|omega|phi)_\w{1,3}", found["name"]):
        if found["name"].lower() not in STOP_WORDS:
            yield NEGATIONS.get(found["name"].lower(), found["name"].lower())
    else:
        for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+", found["name"]):
            if re.fullmatch(r"0\d+", word):
                continue  # the number of a lecture
            if word.isdigit() or word.lower() in NUMBER_WORDS:
                yield Number(float(NUMBER_WORDS.get(word.lower(), word)))
            elif word.lower() not in STOP_WORDS:
                yield NEGATIONS.get(word.lower()) or stem(word.lower())


ARITHMETIC = [
    (r"\b(?:np|sp|math)\.(?=pi\b|sqrt\b)|\\[,;! ]|\\(?:big|left|right)\b", ""),
    (r"\\[tdc]?frac\{([^{}]+)\}\{([^{}]+)\}", r"(\1)/(\2)"),
    (r"\\sqrt\s?\{([^{}]+)\}", r"sqrt(\1)"),
    (r"\\(?:cdot|times)\b", "*"),
    (r"\^\{?(-?\d+)\}?", r"**\1"),
    (r"\\?\bpi\b|π", "pi"),
    (r"(?<=\d)\s?pi\b", "*pi"),
]
EXPRESSION = re.compile(r"(?<![\w.])(?:sqrt\(|pi\b|\d[\d.]*(?:e-?\d+)?|[()]|\s?(?:\*\*|[*/])\s?-?|\s[-+]\s)+(?![\w.])")
LONGEST = 60
"""How many characters an expression has at most that is computed."""


@cache
def computed(text: str) -> str:
    r"""Return a text with its arithmetic done.

    >>> computed(r"It climbs $2\pi \cdot 0.1$ m, q = [0, np.sqrt(4) / 2]")
    'It climbs $0.6283185307$ m, q = [0, 1]'
    """
    for pattern, replacement in ARITHMETIC:
        text = re.sub(pattern, replacement, text)
    return EXPRESSION.sub(lambda found: _value(found[0]), text)


def _value(expression: str) -> str:
    """Compute an expression of numbers, pi and square roots; what is none stays as it is."""
    inner = expression.rstrip()
    while inner.endswith(")") and inner.count(")") > inner.count("("):
        inner = inner[:-1].rstrip()
    try:
        ast.parse(inner.strip(), mode="eval")
        if len(inner) < LONGEST and not re.search(r"\*\* ?-?\d{3}", inner):
            return f"{float(eval(inner, {'pi': pi, 'sqrt': sqrt})):.10g}{expression[len(inner) :]}"
    except (SyntaxError, ArithmeticError, ValueError, TypeError):
        pass
    return expression


def contains(among: Sequence[object], token: object) -> bool:
    """Whether a token, or a pair of them, is among others; numbers match by value."""
    if isinstance(token, tuple):
        return any(isinstance(one, tuple) and all(map(_same, one, token)) for one in among)
    return any(_same(one, token) for one in among if not isinstance(one, tuple))


def _same(one: object, other: object) -> bool:
    if isinstance(one, Number) and isinstance(other, Number):
        return one.matches(other)
    return one == other


def passages_of(text: str) -> list[str]:
    """Divide a text into what is read as a whole: sentences, lines and tables.

    >>> passages_of("It is 0.5 m. Then it\\nmoves.\\n\\n- a")
    ['It is 0.5 m.', 'Then it\\nmoves.', '- a']
    """
    return [
        part.strip()
        for part in re.split(r"(?<=;)\s+|(?<=[.?!:])\s+(?=[A-Z$*({])|\n\s*\n|\n(?=\s*[-*#>\d])", text)
        if part.strip()
    ]


# --- questions ---


class Rarity:
    """How rare tokens are among the passages of a course: the logarithm of one over their share."""

    def __init__(self, passages: Iterable[str]) -> None:
        found = [{self._key(token) for token in tokens(passage)} for passage in passages]
        self._count = Counter(key for keys in found for key in keys)
        self._all = len(found)

    def __call__(self, token: object) -> float:
        """Return the weight of a token; that of a pair is half of the sum, as its tokens may be those of every option."""
        if isinstance(token, tuple):
            return sum(map(self, token)) / 2 + 1
        return log((self._all + 1) / (self._count[self._key(token)] + 1))

    def of(self, found: Iterable[object]) -> float:
        """Return the weight of several tokens."""
        return sum(map(self, found))

    @staticmethod
    def _key(token: object) -> object:
        return f"{token.value:.4g}" if isinstance(token, Number) else token


def _unique(found: Iterable[object]) -> list[object]:
    kept: list[object] = []
    for token in found:
        if not contains(kept, token):
            kept.append(token)
    return kept


@cache
def features(text: str) -> list[object]:
    """Return the tokens of a text, and the pairs of tokens that follow each other at a small distance."""
    single = tokens(text)
    return [*single, *((one, other) for k, one in enumerate(single) for other in single[k + 1 : k + 1 + PAIR])]


def lead(text: str, other: str) -> list[object]:
    """Return what a text has and another has not: tokens, or if there are none, pairs of neighbours, or a token that is all of it."""
    mine, theirs = tokens(text), tokens(other)
    if single := _unique(token for token in mine if not contains(theirs, token)):
        return single
    mine, theirs = (
        [token for token in found if token != "first"] for found in (mine, theirs)
    )  # "y first" is "first y"
    return _unique(pair for pair in pairwise(mine) if not contains([*pairwise(theirs)], pair)) or [
        token for token in mine if isinstance(token, Number) and len(mine) == 1
    ]


class Answer:
    """What gives the right option of a question away: the option as a whole, or a clause of it that weighs more."""

    def __init__(self, item: Item, rarity: Rarity) -> None:
        texts = [option.text for option in item.options]
        right = texts.pop(item.right)
        self.item, self.rarity, self.asked, self.right = item, rarity, _unique(tokens(item.text)), tokens(right)
        self.whole, *self.clauses = (
            [(lead(part, text), [one for one in lead(text, part) if not contains(self.asked, one)]) for text in texts]
            for part in (right, *re.split(r"[.,;:]\s", right))
        )

    def is_in(self, passage: str, place: str) -> bool:
        """Whether a passage at one of the places in WEIGHTS gives it away."""
        said = features(passage)
        told = self.told(self.whole, said) >= WEIGHTS[place]
        if place == "above":
            return told and self.rarity.of(token for token in self.asked if contains(said, token)) >= ABOUT_WEIGHT
        return told or max(self.told(leads, said) for leads in self.clauses) >= CLAUSE_WEIGHT

    def told(self, leads: list[tuple[list[object], list[object]]], said: list[object]) -> float:
        """Return the weight of what a passage says of an option; 0 if it does not tell it from each of the others."""
        for mine, theirs in leads:
            share = self._share(mine, said)
            if share < ENOUGH or self._share(theirs, said) >= share:
                return 0.0
        found = _unique(token for mine, _ in leads for token in mine if contains(said, token))
        beside = (pair for pair in pairwise(self.right) if contains(said, pair) and any(one in found for one in pair))
        return self.rarity.of(found) + self.rarity.of(beside)

    def letter_is_in(self, passage: str) -> bool:
        """Whether a passage names the letter of the right option."""
        named = re.findall(r"(?i:\b(?:answer|option|solution|right|correct)\b)(?:\s+is)?\W{0,3}\b([A-H])\b", passage)
        return LETTERS[self.item.right] in named

    def _share(self, key: list[object], said: list[object]) -> float:
        return self.rarity.of(token for token in key if contains(said, token)) / (self.rarity.of(key) or 1)


# --- blanks ---


def numbers_are_in(values: Sequence[float], text: str, in_degrees: bool = True) -> bool:
    """Whether a text contains these numbers, one after the other. In a matrix, a quarter of them may be letters, but not 0 and 1.

    in_degrees  whether angles in degrees are the same numbers

    >>> numbers_are_in([0, 90, 0.5], "a = 0, alpha = np.pi / 2, d = 0.50")
    True
    """
    wanted = [Number(float(value), angle=in_degrees) for value in values]
    if np.count_nonzero(values) < 2:  # such a row is found across the rows of any matrix
        return any(_is_row(wanted, tokens(row), "|" in row) for row in re.split(r"[][()\n]", text))
    letters = len(wanted) // 4 if len(wanted) >= FEW_IN_A_MATRIX else 0
    said = [one for one in tokens(text) if isinstance(one, Number) or (letters and re.fullmatch(r"\w(_\w+)?", one))]
    for start in range(len(said) - len(wanted) + 1):
        here = [*zip(said[start : start + len(wanted)], wanted, strict=True)]
        free = [other.value for one, other in here if isinstance(one, str)]
        known = [(one, other) for one, other in here if isinstance(one, Number)]
        if (
            len(free) <= letters
            and not {0.0, 1.0} & set(map(abs, free))
            and all(one.matches(other) for one, other in known)
        ):
            return True
    return False


def _is_row(wanted: Sequence[Number], said: Sequence[Token], in_table: bool) -> bool:
    """Whether a row has these numbers; in a printed table also beside others, and with the joint variable in place of one."""
    row = [one for one in said if isinstance(one, Number) or (in_table and re.fullmatch(r"q_?\w?", one))]
    starts = range(len(row) - len(wanted) + 1) if in_table else [0] if len(row) == len(wanted) else []
    return any(
        all(isinstance(one, str) or one.matches(other) for one, other in zip(row[start:], wanted, strict=False))
        for start in starts
    )


class BlankAnswer:
    """What gives the answer to a blank step away: its numbers, in their order."""

    def __init__(self, value: object, statement: str, in_degrees: bool = True) -> None:
        numbers = np.asarray(value, dtype=float)
        self.values = [*(numbers[:3] if numbers.shape == (4, 4) else numbers).ravel()]
        self.statement, self.in_degrees = tokens(statement), in_degrees

    def is_in(self, passage: str, place: str) -> bool:
        """Whether a passage gives it away: one number among zeros in its section only, a single one beside words of the statement."""
        if len(self.values) > 1:
            is_clear = place != "above" or np.count_nonzero(self.values) > 1
            return is_clear and numbers_are_in(self.values, passage, self.in_degrees)
        said, number = tokens(passage), Number(self.values[0])
        speaks = any(isinstance(token, str) and token in self.statement for token in said)
        is_said = contains(said, number) and not contains(self.statement, number)
        return is_said and (place == "own" or (place == "section" and speaks))
