r"""Find what gives away the answer to a question or to a blank step before the reader commits to one.

The answer to a question is what only its right option has: words, numbers, or the order in which they stand. They are compared
by what they mean. A word counts without its ending, and a name in code as its words; "twenty", "20" and "20.0" are one number,
as are "180°", `\pi` and `np.pi`; "0.628" is "0.63" with one more digit; $T^{-1}$ is `kl.inverse(T)`.
A passage, that is a sentence, a line of code or of output, or an alternative text, gives the answer away if it has most of
these tokens by weight, more of them than of those of any wrong option, and speaks of the question. Rare tokens weigh more.
The answer to a blank step is a sequence of numbers; a letter in a place of a matrix may be any number.
"""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import inf, log, pi

import numpy as np
import snowballstemmer

from misstep.questions.item import LETTERS, Item

ENOUGH = 0.5
"""Which share, by weight, of what only the right option has is a giveaway."""
EVIDENCE = 7.0
"""How much the tokens of a giveaway weigh at least, in units of the logarithm of how rare they are."""
ABOUT = 4.0
"""How much of it may be tokens of the question."""
LITTLE = 2.0
"""How much of the question a passage far above it mentions at least."""
FEW_IN_A_MATRIX = 9
"""How many numbers a matrix has at least."""
NEARBY = 3.5
"""What it weighs that a passage stands beside the question."""
NEAR = 3
"""How many tokens apart two tokens may be that count as a pair."""


@dataclass(frozen=True)
class Passage:
    """Something that is read as a whole: its kind, such as "code" or "alternative text", its text, and the name of its cell."""

    kind: str
    text: str
    cell: str


# --- tokens ---

SPELLINGS = [
    (r"\\(?:[tdc]?frac)\{([^{}]+)\}\{([^{}]+)\}", r"\1/\2"),
    (r"\\(?:text|mathrm|operatorname|bar|dot|hat|mathbf)\b|\\[,;!: ]|\\q?quad\b|\\(?:big|Big|left|right)\w*", " "),
    (r"(?:\b[a-z]\w*\.)+(?=[a-zA-Z]\b)", ""),
    (r"(?:\w+\.)*inv(?:erse)?\(([^()]*)\)", r"\1 ^-1"),
    (r"(?:\w+\.)*exp\(|\\exp\b|(?<![a-zA-Z\\])e\^", " exp "),
    (r"(\d[\d.]*)\s*(?:\\cdot|\*)\s*10\^\{?(-?\d+)\}?", r"\1e\2"),
    (r"\b10\^\{?(-?\d+)\}?", r"1e\1"),
    (r"(?<=\d)\{,\}(?=\d)", ""),
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
LARGE = {"hundred": 100, "thousand": 1000, "million": 10**6}
ORDINALS = {"second": 2, "third": 3, "fourth": 4, "fifth": 5, "twice": 2, "both": 2}
NUMBER_WORDS = {word: number for number, word in enumerate(COUNTED.split())} | ORDINALS | LARGE
STOP_WORDS = frozenset(
    re.findall(
        r"\w+",
        """a an and are as at be been but by can did do does every for from goes had has have if in into is it its let of on once
    or so such than that the their then there these they this those to up us was we were what when where which while will with
    would you your all any also each how just more most much only other same some because about after again before yes no not
    neither nor never np kl sp return def import lambda self print array begin end pmatrix r""",
    )
)
stem = cache(snowballstemmer.stemmer("english").stemWord)


@dataclass(frozen=True)
class Number:
    """A number, the decimals to which it is written, and whether it may be an angle; an angle counts in degrees, too."""

    value: float
    decimals: float = inf
    angle: bool = False

    def matches(self, other: "Number") -> bool:
        """Whether two numbers are the same to the decimals that both have; two decimals at least are needed to be rounded."""
        decimals = min(self.decimals, other.decimals)
        allowed = 0.5001 * 10.0**-decimals if 2 <= decimals < inf else 1e-9 * max(1.0, abs(other.value))
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
            yield found["name"].lower()
    else:
        for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+", found["name"]):
            if word.isdigit() or word.lower() in NUMBER_WORDS:
                yield Number(float(NUMBER_WORDS.get(word.lower(), word)))
            elif word.lower() not in STOP_WORDS:
                yield stem(word.lower())


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
    """Divide a text into what is read as a whole: sentences, lines and rows.

    >>> passages_of("It is 0.5 m. Then it\\nmoves.\\n\\n- a")
    ['It is 0.5 m.', 'Then it\\nmoves.', '- a']
    """
    return [
        part.strip()
        for part in re.split(r"(?<=;)\s+|(?<=[.?!:])\s+(?=[A-Z$*({])|\n\s*\n|\n(?=\s*[-*|#>\d])", text)
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
def features(text: str) -> tuple[list[object], list[object]]:
    """Return the tokens of a text, and the pairs of tokens that follow each other at a small distance."""
    single = tokens(text)
    near = [(one, other) for k, one in enumerate(single) for other in single[k + 1 : k + 1 + NEAR]]
    return list(single), list(near)


def lead(text: str, other: str) -> list[object]:
    """Return what a text has and another has not: tokens, or if there are none, pairs of neighbours."""
    mine, theirs = tokens(text), tokens(other)
    if single := _unique(token for token in mine if not contains(theirs, token)):
        return single
    mine, theirs = (
        [token for token in found if token != "first"] for found in (mine, theirs)
    )  # "y first" is "first y"
    return _unique(pair for pair in pairwise(mine) if not contains([*pairwise(theirs)], pair))


class Answer:
    """What gives the right option of a question away."""

    def __init__(self, item: Item, rarity: Rarity) -> None:
        texts = [option.text for option in item.options]
        right = texts.pop(item.right)
        self.item, self.rarity, self.asked = item, rarity, _unique(tokens(item.text))
        self.right = tokens(right)
        clauses = {right, *re.split(r"[.,;:]\s", right)}
        self.leads = [
            (clause == right, [(lead(clause, text), self._unasked(lead(text, clause))) for text in texts])
            for clause in sorted(clauses)
        ]

    def is_in(self, passage: str, near: bool = False) -> bool:
        """Whether a passage gives it away: it tells the right option, or a clause of it, from each of the others.

        near  whether it stands in the question's own cell or below it, where it is taken for a hint
        """
        said = [feature for kind in features(passage) for feature in kind]
        about = self.rarity.of(token for token in self.asked if contains(said, token))
        for is_whole, leads in self.leads:
            told = self.told(leads, said)
            if near and told + NEARBY + min(ABOUT, about) >= EVIDENCE and told:
                return True
            if told + is_whole * min(ABOUT, about) >= EVIDENCE and about >= (LITTLE if is_whole else ABOUT):
                return True
        return False

    def told(self, leads: list[tuple[list[object], list[object]]], said: list[object]) -> float:
        """Return the weight of what a passage says of an option; 0 if it does not tell it from each of the others."""
        for mine, theirs in leads:
            share = self._share(mine, said)
            if share < ENOUGH or self._share(theirs, said) >= share:
                return 0.0
        found = _unique(token for mine, _ in leads for token in mine if contains(said, token))
        told = self.rarity.of(found)
        if (
            told < ABOUT and len(self.right) > 1
        ):  # a frequent word, such as x: only beside the same word as in the option
            beside = [pair for pair in pairwise(self.right) if any(contains(pair, token) for token in found)]
            return (
                told
                if any(contains(said, pair) for pair in beside) or any(isinstance(one, tuple) for one in found)
                else 0.0
            )
        return told

    def _unasked(self, found: list[object]) -> list[object]:
        return [one for one in found if not contains(self.asked, one)]

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
        groups = [[one for one in tokens(group) if isinstance(one, Number)] for group in re.split(r"[][()|\n]", text)]
        return any(len(group) == len(wanted) and all(map(Number.matches, group, wanted)) for group in groups)
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


class BlankAnswer:
    """What gives the answer to a blank step away: its numbers, in their order."""

    def __init__(self, value: object, statement: str, in_degrees: bool = True) -> None:
        numbers = np.asarray(value, dtype=float)
        self.values = [*(numbers[:3] if numbers.shape == (4, 4) else numbers).ravel()]
        self.statement, self.in_degrees = tokens(statement), in_degrees

    def is_in(self, passage: str, near: bool = False) -> bool:
        """Whether a passage gives it away: one number among zeros only if it is near, a single one behind a word of the statement."""
        if len(self.values) > 1:
            return (near or np.count_nonzero(self.values) > 1) and numbers_are_in(self.values, passage, self.in_degrees)
        known = [*pairwise(self.statement)]
        return any(
            isinstance(number, Number) and number.matches(Number(self.values[0])) and contains(self.statement, word)
            for word, number in pairwise(tokens(passage))
            if not contains(known, (word, number))
        )
