"""What fuzzing feeds: documents that were right, a few of their pieces dropped, doubled, exchanged or made odd; and noise.

Nearly right is what finds faults: noise is refused at the first letter, and what is behind that letter is never reached.
"""

import re
import traceback
from copy import deepcopy
from pathlib import Path
from random import Random

from hypothesis import strategies as st

import kinlib

NUMBERS = (
    *("0", "-0", "1", "-1", "0.5", "1.", ".5", "1e-320", "1e300", "1e400", "-1e308", "1E5", "+3", "1e", "1e+", "--1"),
    *("nan", "inf", "-Infinity", "NaN", "None", "True", "0x10", "1_000", "007", "1j", "1 2", "1,5", "1.5.2", "1e5e5"),
    *("90", "90°", "3.14159265358979", "9" * 400, "9" * 5000, "1" + "0" * 30, "0." + "0" * 400 + "1"),
)
"""Numbers, and what somebody may take for one."""

LETTERS = (
    *("\x00", "\x1b", "\x7f", "\x85", "\xa0", "\xad", "\u0301", "\u200b", "\u202e", "\u2028", "\ufeff", "\ufffd"),
    *(
        "\ud800",
        "\udcff",
        "\U0010ffff",
        "ß",
        "İ",
        "ﬁ",
        "é",
        "٣",
        "１",
        "²",
        "½",
        "Ⅳ",
        "−",
        "×",
        "ｑ",
        "π",
        "θ",
        "°",
        "🤖",
    ),
    *("\r", "\n", "\t", "\v", " ", '"', "'", "\\", "/", "<", ">", "&", "%", "$", "{", "}", "[", "]", "(", ")"),
    *("|", ",", ";", ":", "=", "#", "*", "**", "^", "_", "-", "+", ".", "..", "!", "?"),
)
"""Letters that computers stumble over: of no width, of another script, halves of pairs, signs of some language."""

PIECE = r"[^\W\d]\w*|\d+\.?\d*|\s+|."
"""Where a text is cut: words, numbers, blanks, signs."""

SENTENCE = re.compile(r"\S.*[.?!)>`'\"]", re.DOTALL)

MOST = 200_000
"""What is repeated ends after so many letters: time may grow with size, and a second is what a case has."""

LONGEST = 1500
"""A message of more letters than that is no message, but what came, handed back."""

KINLIB = Path(kinlib.__file__).parent.as_posix()


def assert_explained(error, *kinds):
    """An error is explained if we raised it ourselves, in words that a screen can show; what came by itself is a fault."""
    message = str(error)
    assert type(error) in (kinds or (ValueError,)), f"{type(error).__name__}: {message[:300]}"
    where = Path(traceback.extract_tb(error.__traceback__)[-1].filename).as_posix()
    assert where.startswith(KINLIB), f"this was raised in {where}: {message[:300]}"
    assert SENTENCE.fullmatch(message), f"this is no sentence: {message[:300]!r}"
    assert len(message) <= LONGEST, f"this message has {len(message)} letters: {message[:300]!r}"
    message.encode()


def pieces(text):
    """What stands in a text with two blanks, or a new line, between each two."""
    return [piece for piece in re.split(r" {2,}|\n", text) if piece]


def chances():
    """Sources of chance, each drawn as one number: fast to draw, and what is drawn in a list can be left out again."""
    return st.integers(0, 2**24 - 1).map(Random)


def noise():
    """Texts of no form at all."""
    return st.lists(st.sampled_from([*NUMBERS, *LETTERS]) | st.text(max_size=5), max_size=8).map("".join)


def mostly(usual, odd):
    """One of the usual values, and once in thirty times an odd one."""
    return chances().map(lambda chance: chance.choice(usual if chance.random() < 29 / 30 else odd))


def often(times, strategy, *others):
    """A strategy as many times as each of the others. Hypothesis's own one_of takes doubles for one."""
    weighed = [strategy] * times + list(others)
    return st.integers(0, len(weighed) - 1).flatmap(weighed.__getitem__)


def mangled(texts, own="", cuts=(PIECE,), most=3):
    """Texts with a few changes, or with none.

    texts   a strategy of right ones
    own     pieces that have a meaning in their language, with two blanks or a new line between each two
    cuts    patterns of what is changed as one piece
    """
    return st.builds(change_text, texts, st.lists(chances(), max_size=most), st.just(pieces(own)), st.just(cuts))


def change_text(text, changes, own=(), cuts=(PIECE,)):
    for chance in changes:
        parts = re.split(f"({chance.choice(cuts)})", text, flags=re.DOTALL)
        places = range(1, len(parts), 2)  # between them stands what the pattern does not match
        if not places:
            continue
        at, to = chance.choice(places), chance.choice(places)
        odd = chance.choice(own if own and chance.random() < 0.6 else (*NUMBERS, *LETTERS))
        odd = (odd * chance.choices([1, 2, 30, 3000], [100, 5, 2, 1])[0])[:MOST]
        match chance.randrange(8):
            case 0:
                parts[at] = ""
            case 1:
                parts[at] = (parts[at] * chance.choices([2, 30, 3000], [20, 2, 1])[0])[:MOST]
            case 2:
                parts[at], parts[to] = parts[to], parts[at]
            case 3:
                parts[at] = parts[to]
            case 4:
                parts[at] = odd
            case 5:
                parts[at] += odd
            case 6:
                parts[at] = odd + parts[at]
            case 7:  # with all that are alike, so that a name stays one name
                alike = parts.count(parts[at])
                parts = [odd[: MOST // alike] if part == parts[at] else part for part in parts]
        text = "".join(parts)
    return text


LEAVES = (
    *(None, True, False, 0, -1, 1, 0.5, 10**9, 10**400, -(10**25), 1e308, 5e-324, 1e-7, 3.0),
    *(
        "",
        "x",
        "q_1",
        "standard",
        "RRR",
        "\x00",
        "\ud800",
        "١",
        "x" * 11_000,
        "9" * 5000,
        [],
        {},
        [[]],
        [[[[[[[[]]]]]]]],
    ),
    *([0] * 5000, {"": None}, {"number": 1}, {"text": "x"}, {"list": []}, {"array": [1.0], "shape": [1]}),
)
"""What JSON may hold anywhere."""


def mangled_json(documents, own=(), most=3):
    """Plain data with a few changes: entries dropped, doubled, exchanged, wrapped, or replaced by what is odd."""
    return st.builds(change_json, documents, st.lists(chances(), max_size=most), st.just((*LEAVES, *own)))


def change_json(document, changes, leaves):
    data = {"": deepcopy(document)}
    for chance in changes:
        places = list(_places(data))
        (holder, key), (other, there) = chance.choice(places), chance.choice(places)
        entry = holder[key]
        match chance.randrange(12):
            case 0 if holder is not data:
                del holder[key]
            case 1 if isinstance(holder, list):
                holder.insert(key, deepcopy(entry))
            case 2 if isinstance(holder, dict) and holder is not data:
                holder[chance.choice([leaf for leaf in leaves if isinstance(leaf, str)])] = holder.pop(key)
            case 3:
                holder[key] = deepcopy(other[there])
            case 4:
                holder[key] = chance.choice([[entry], {"list": [entry]}, {"": entry}])
            case 5:
                holder[key] = deepcopy(chance.choice(leaves))
            case _ if isinstance(entry, str):
                holder[key] = change_text(entry, [chance])
            case _ if isinstance(entry, int | float) and abs(entry) < 1e100:
                near = [-entry, entry + 1, entry * 1.0005, entry * 0.99, entry * 57.3, entry + 6.283185307, 0]
                holder[key] = chance.choice([*near, *near, entry * 1e9, str(entry), [entry], None])
    return data[""]


def _places(data):
    """Every entry of the data, as what holds it and where in that."""
    for key, entry in list(data.items() if isinstance(data, dict) else enumerate(data)):
        yield data, key
        if isinstance(entry, dict | list):
            yield from _places(entry)
