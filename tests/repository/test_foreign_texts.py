"""Each reader of a text from a stranger reads it, or refuses it with a ValueError, and never fails otherwise."""

import contextlib
import json
import re
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlib as kl
from kincourse.robot_sheets.robot_sheet import dumps, loads
from misstep.formulas.parsing import parse
from misstep.storage import from_data, to_data

ARM = kl.robots.rpr()
ODD = [
    *re.findall(r"\S+", "nan 1e400 -Infinity 0x10 1j 1,5 None [ (((( ** q1*q1 __import__('os') ° ½ </link> &x; {}"),
    *('"', "\\frac{", "9" * 400, "\x00", "\u202e", "\ud800", "\N{MINUS SIGN}", "lambda: 0", ""),
]
"""Pieces that take the place of others."""

READERS = {
    "urdf": (kl.load_urdf, kl.to_urdf(ARM)),
    "table": (lambda text: kl.DHTable(text, convention="standard"), "a | alpha | d | theta\n0.4 | -90° | 0 | q1\n0.3 | pi/2 | q2 | 0"),
    "formula": (parse, "2*sin(theta_1 + pi/2) - l1*cos(q2)^2/3"),
    "stored answer": (lambda text: from_data(json.loads(text)), json.dumps(to_data({"rows": [[1.5, 0, 2, 3]], "S": ARM.screws}))),
    "robot of a sheet": (lambda text: loads(text, "robot.json"), dumps(ARM)),
}  # fmt: skip
"""Each reader, and a text that it reads."""


@pytest.mark.parametrize("kind", READERS)
@given(st.integers(0, 2**32), st.integers(0, 4))
@settings(max_examples=40)
def test_a_text_of_a_stranger_is_read_or_refused(kind, seed, changes):
    """Nearly valid texts find most faults, because noise is refused at the first character."""
    read, text = READERS[kind]
    chance = Random(seed)
    pieces = re.findall(r"\w+|\s+|.", text, re.DOTALL)
    for _ in range(changes):
        k, other = chance.randrange(len(pieces)), chance.randrange(len(pieces))
        pieces[k] = chance.choice([pieces[other], pieces[k] * 2, chance.choice(ODD), chance.choice(ODD)])
    changed = "".join(pieces)
    with contextlib.suppress(ValueError, FileNotFoundError):  # what does not begin like XML may be the name of a file
        read(changed)
        return
    assert changed != text, "the text itself is read"
