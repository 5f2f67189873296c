"""Strategies for fuzzing: valid documents with a few pieces dropped, repeated, swapped or replaced; and noise.

Nearly valid documents find most faults, because pure noise is refused at the first character and never reaches later code.
"""

import re
from copy import deepcopy
from random import Random

from hypothesis import strategies as st

NUMBERS = (
    *("0", "-0", "1", "-1", "0.5", "1.", ".5", "1e-320", "1e300", "1e400", "-1e308", "1E5", "+3", "1e", "1e+", "--1"),
    *("nan", "inf", "-Infinity", "NaN", "None", "True", "0x10", "1_000", "007", "1j", "1 2", "1,5", "1.5.2", "1e5e5"),
    *("90", "90°", "3.14159265358979", "9" * 400, "9" * 5000, "1" + "0" * 30, "0." + "0" * 400 + "1"),
)
"""Numbers, and text that looks like a number."""

LETTERS = (
    *"\x00\x1b\x7f\x85\xa0\xad\u0301\u200b\u202e\u2028\ufeff\ufffd\ud800\udcff\U0010ffffßİﬁé٣１²½Ⅳ−×ｑπθ°🤖",
    *("**", "..", *"\r\n\t\v \"'\\/<>&%${}[]()|,;:=#*^_-+.!?"),
)
"""Difficult characters: control and zero-width ones, other scripts, lone surrogates, operators of some language."""

PIECE = r"[^\W\d]\w*|\d+\.?\d*|\s+|."
"""How a text is split: words, numbers, white space, single characters."""

MAX_LENGTH = 200_000
"""Maximum number of characters of a repeated piece, because a case must be read within seconds."""


def pieces(text):
    """Split a text at two or more spaces, and at line ends."""
    return [piece for piece in re.split(r" {2,}|\n", text) if piece]


def random_sources():
    """Random generators, each drawn as one number: this is fast, and Hypothesis can drop single changes when it shrinks."""
    return st.integers(0, 2**24 - 1).map(Random)


def noise():
    """Texts without any structure."""
    return st.lists(st.sampled_from([*NUMBERS, *LETTERS]) | st.text(max_size=5), max_size=8).map("".join)


def mostly(usual, odd):
    """One of the usual values, and an odd one in 1 of 30 cases."""
    return random_sources().map(lambda chance: chance.choice(usual if chance.random() < 29 / 30 else odd))


def often(times, strategy, *others):
    """A strategy `times` times as often as each of the others; Hypothesis's one_of ignores duplicates."""
    weighed = [strategy] * times + list(others)
    return st.integers(0, len(weighed) - 1).flatmap(weighed.__getitem__)


def corrupted_texts(texts, own="", cuts=(PIECE,), most=3):
    """Texts with at most `most` changes.

    texts   a strategy of valid texts
    own     pieces that have a meaning in their language, separated by two spaces or a line end
    cuts    regular expressions of what is changed as one piece
    """
    return st.builds(change_text, texts, st.lists(random_sources(), max_size=most), st.just(pieces(own)), st.just(cuts))


def change_text(text, changes, own=(), cuts=(PIECE,)):
    for chance in changes:
        parts = re.split(f"({chance.choice(cuts)})", text, flags=re.DOTALL)
        places = range(1, len(parts), 2)  # the even ones are what the pattern does not match
        if not places:
            continue
        at, other = chance.choice(places), parts[chance.choice(places)]
        odd = chance.choice(own if own and chance.random() < 0.6 else (*NUMBERS, *LETTERS))
        times = chance.choices([1, 2, 30, 3000], [100, 5, 2, 1])[0]
        old = parts[at]
        new = chance.choice(["", old * (times + 1), other, odd * times, old + odd, odd + old])
        text = "".join([*parts[:at], new[:MAX_LENGTH], *parts[at + 1 :]])
    return text


LEAVES = (
    *(None, True, False, 0, -1, 1, 0.5, 10**9, 10**400, -(10**25), 1e308, 5e-324, 1e-7, 3.0),
    *([], {}, [[]], [[[[[[]]]]]]),
    *("", "x", "q_1", "standard", "RRR", "\x00", "\ud800", "١", "x" * 11_000, "9" * 5000),
    *([0] * 5000, {"": None}, {"number": 1}, {"text": "x"}, {"list": []}, {"array": [1.0], "shape": [1]}),
)
"""Values that JSON may contain anywhere."""


def corrupted_json(documents, own=(), most=3):
    """JSON data with a few changes: entries dropped, wrapped, or replaced by others and by odd ones."""
    return st.builds(change_json, documents, st.lists(random_sources(), max_size=most), st.just((*LEAVES, *own)))


def change_json(document, changes, leaves):
    data = {"": deepcopy(document)}
    for chance in changes:
        places = list(_places(data))
        (holder, key), (other, there) = chance.choice(places), chance.choice(places)
        entry = holder[key]
        if holder is not data and chance.random() < 0.1:
            del holder[key]
            continue
        entries = [deepcopy(other[there]), [entry], {"list": [entry]}, deepcopy(chance.choice(leaves))]
        if isinstance(entry, str):
            entries += [change_text(entry, [chance])] * 4
        elif isinstance(entry, int | float) and abs(entry) < 1e100:
            near = [-entry, entry + 1, entry * 1.0005, entry * 0.99, entry * 57.3, entry + 6.283185307, 0]
            entries += chance.choices([*near, entry * 1e9, str(entry)], k=4)
        holder[key] = chance.choice(entries)
    return data[""]


def _places(data):
    """Yield every entry of the data, as its container and its key or index."""
    for key, entry in list(data.items() if isinstance(data, dict) else enumerate(data)):
        yield data, key
        if isinstance(entry, dict | list):
            yield from _places(entry)
