"""Fuzz DH tables in every form: refused with a sentence, or an arm with rigid poses that can be written and read again."""

import re

import numpy as np
from assertions import assert_explained, assert_rigid
from corruption import LEAVES, PIECE, corrupted_texts, mostly, noise, often, pieces, random_sources
from fuzz_settings import fuzz_settings
from hypothesis import example, given
from hypothesis import strategies as st

import kincourse.answers.dh_table  # noqa: F401  it says how a stored table is read
from kinlib.dh.parsing import COLUMNS, split_table
from kinlib.dh.table import DHTable
from misstep.storage.deserialize import from_data
from misstep.storage.serialize import to_data

LENGTHS = {"l1": 0.4, "l2": 0.3, "a_3": 1.0}

SLIDES = (
    "a | alpha | d | theta\n 0.4 | 0 | 0 | q1\n 0.3 | 0 | 0 | q2",
    "i | alpha_{i-1} (deg) | a_{i-1} | d_i | theta_i\n1 | 0 | 0 | 0 | θ1\n2 | -90 | l1 | q2 | -90\n3 | 90 | 0 | 0 | theta_3",
    "| link | a | α | d | θ |\n|---|---|---|---|---|\n| 1 | l1 | π/2 | 0 | q1 + pi/2 |\n| 2 | l2 | −90° | d_2 | 0 |",
    "theta  d  a  alpha\nq_1    0.6  0  -pi/2\nq_2 - pi/2  0  0.4  0\n-q_3  0.1 0  90°",
    "$a$ | $\\alpha$ | $d$ | $\\theta$\n0 | \\frac{\\pi}{2} | d_1 - 0.5 | \\pi\n1/2 | (l1 - 0.1)*2 | 0 | \\theta_{2}",
    "length\ttwist\toffset\tangle\n0.1\t90deg\t0\tq1\n2e-1\t-1.5e0\t0\tq2",
)

WORDS = r"""
a  alpha  d  theta  q1  q  -q2  θ  theta_1  d3  l1  l2  a_3  pi  π  -pi/2  \frac{1}{2}  |  |  ---  deg  (deg)  °
-90°  90deg  *2  /0  /3  **  ^2  //  (  )  i  link  row  #  1.  Matrix([  lambda: 0  f'{q}'  [0.5]  q1 + q2
q1*0  2*q  θ₁*  ½π  np.pi  rad  3pi/2  0,5  q_2*  810°  \\frac\\pi2  α_i  __import__
+  sin(0)  0.4 # m  0.4\  'a'  if  1if 1else 2  10^-3  1e-3°  5+5  -0.0  °°  0°1
"""

CUTS = (r"[^|\t\n]+", r"[^\n]+\n?", r"\w+", PIECE)
"""Entries, rows, words, and any piece."""

PLAIN = re.compile(
    r"(?>[\s()+\-−*/{}\\$°^½]|deg|rad|np\.|d?frac|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|(?:q|theta|θ|d)_?\{?[\d₁₂]*\}?|pi|π|l1|l2|a_3)*+",
    re.ASCII,
)
"""What a valid entry consists of: no keyword of Python and no digit of another script counts as a number."""

ENTRIES = (*pieces("0  0.4  -90°  pi/2  q1  -q  theta_2 - pi/2  d_3  l1"), *(0, 0.5, -1, np.float32(0.25), np.pi / 2))


def in_rows(chance):
    """A table as dictionaries, as numbers or as a mixture, with a few odd entries."""

    def entry():
        if chance.random() < 0.97:
            return chance.choice(ENTRIES)
        odd = (*LEAVES, np.nan, np.array([1.0]), np.array(2), np.int8(3), 1j, b"1", 1 + 0j, object, np.bool_(1), {1: 2})
        return chance.choice(odd)

    names = ["a", "alpha", "d", "theta"]
    rows = []
    for _ in range(chance.randint(1, 4)):
        row = {name: entry() for name in names if chance.random() < 0.97}
        numbers = [chance.choice([0, 0.4, -1.5, 1e-9, 3]) for _ in names]
        rows.append(
            chance.choices([row, numbers, list(row.values()), entry()], [chance.choice([40, 1]), 4, 0.3, 0.2])[0]
        )
    if chance.random() < 0.3:
        rows = [[chance.choice([0, 0.4, -1.5, 1e-9, 3, 1e200, 12.56]) for _ in names] for _ in rows]
    return chance.choice([rows, rows, rows, tuple(rows), np.array(rows, dtype=object), iter(rows), rows[0]])


def cases():
    """Rows, convention, joints and lengths."""
    texts, rows = corrupted_texts(st.sampled_from(SLIDES), WORDS, CUTS), random_sources().map(in_rows)
    conventions = mostly(["standard", "modified"], ["Standard", "", None, [], {}, "\ud800", "x" * 9999, np.zeros(2)])
    joints = mostly([""], ["RR", "RP", "RPR", "R", "FF", "rr", None, 0, ["R", "R"], "R" * 9999])
    odd = [None, {}, *({"l1": length} for length in ("x", None, np.nan, 10**400, [0.5])), {"pi": 3.0}, {3: 3}, [], 7]
    anything = often(20, texts | rows, noise(), st.sampled_from(LEAVES))
    return st.tuples(anything, conventions, joints, mostly([LENGTHS], odd))


@fuzz_settings(200)
@given(st.deferred(cases))
@example(([{"a": 0, "alpha": 0, "d": "l9", "theta": 0}], "standard", "", LENGTHS))
@example(("a | alpha | d | theta\n0 | \\frac\xa0{\\pi}{2} | 0 | q1", "standard", "", LENGTHS))
def test_a_dh_table_is_refused_with_a_sentence_or_is_the_same_arm_in_every_form(case):
    rows, convention, joints, lengths = case
    try:
        table = DHTable(rows, convention=convention, joints=joints, lengths=lengths)
    except ValueError as error:
        assert_explained(error)
        return
    q = np.linspace(-3, 3, 2 * table.n).reshape(2, table.n)
    poses, near = table.fk(q), {"rtol": 0, "atol": 1e-9 * (1 + np.abs(table.rows).sum() + 3 * table.n)}
    assert_rigid(poses)
    np.testing.assert_allclose(table.to_chain().fk(q), poses, **near)
    other = "modified" if convention == "standard" else "standard"
    np.testing.assert_allclose(table.converted(other).fk(q), poses, **near)
    np.testing.assert_array_equal(DHTable(_typed(table), convention=convention).fk(q), poses)
    np.testing.assert_array_equal(from_data(to_data(table)).fk(q), poses)
    for entry in _texts(rows):
        assert PLAIN.fullmatch(" ".join(entry.split())), f"{entry!r} is read as a number"  # whatever the space is


def _typed(table):
    """The table as text, as on a slide."""
    rows = ["theta | d | alpha | a"]
    for (a, alpha, d, theta), letter, sign in zip(table.rows.tolist(), table.joints, table.signs, strict=True):
        q = f" {'+' if sign > 0 else '-'} q" if letter != "F" else ""
        rows.append(f"{theta!r}{q if letter == 'R' else ''} | {d!r}{q if letter == 'P' else ''} | {alpha!r} | {a!r}")
    return "\n".join(rows)


def _texts(rows):
    """The entries of a table that are text, in any form of the table."""
    rows = split_table(rows, None)[0] if isinstance(rows, str) else [row for row in rows if isinstance(row, dict)]
    return [row[column] for row in rows for column in COLUMNS if isinstance(row[column], str)]
