"""DH tables: against the Robotics Toolbox, and through both conventions without loss."""

import re

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from strategies import chains_with_values

import kinlib as kl
from kinlib import DHTable, robots

EXACT = 1e-12

YOUBOT = r"""
    Link | θ | d | a | ψ
    1 | q_1 | 0.147 | 0.0330 | \frac{\pi}{2}
    2 | q_2 | 0 | 0.1550 | 0
    3 | q_3 | 0 | 0.1350 | 0
    4 | q_4 + \frac{\pi}{2} | 0 | 0 | \frac{\pi}{2}
    5 | q_5 | 0.2175 | 0 | 0
"""
N5 = """
      | α_{i-1} (deg) | a_{i-1} | d_i | θ_i (deg)
    1 | 0 | 0 | 0 | q_1
    2 | -90 | 0 | q_2 | -90
    3 | -90 | l_2 | 0 | q_3
    4 | 90 | 0 | 0 | q_4
    5 | 0 | -l_4 | l_5 | 0
"""
PUMA = """
    i  α_{i-1}  a_{i-1}  d_i  θ_i
    1  0        0        0    θ_1
    2  -90°     0        0    θ_2
    3  0        a_2      d_3  θ_3
    4  -90°     a_3      d_4  θ_4
    5  90°      0        0    θ_5
    6  -90°     0        0    θ_6
"""
LECTURE_7 = """
    i  α_{i-1}  a_{i-1}  d_i  θ_i
    1  0        0        0    θ_1
    2  90°      a_1      d_2  0
    3  -90°     0        0    θ_3
"""
PRINTED = {
    "youBot": (DHTable(YOUBOT, convention="standard"), robots.youbot()),
    "n = 5": (DHTable(N5, convention="modified", lengths={"l_2": 0.5, "l_4": 0.2, "l_5": 0.3}), robots.rprr()),
    "PUMA 560": (
        DHTable(PUMA, convention="modified", lengths={"a_2": 0.4318, "a_3": 0.0203, "d_3": 0.15005, "d_4": 0.4318}),
        robots.puma560(),
    ),
    "Lecture 7": (DHTable(LECTURE_7, convention="modified", lengths={"a_1": 0.4}), robots.rpr_lecture7()),
}
"""Tables as the decks print them, and their arms: test_frame_assignment.py compares them."""


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def values(n, count=50, seed=0):
    return np.random.default_rng(seed).uniform(-3, 3, (count, n))


@st.composite
def tables(draw, kinds="RPF"):
    """Any table of 1 to 7 rows, with joints of both kinds, fixed rows, a base and a tool."""
    m = draw(st.integers(1, 7))
    number = st.floats(-2, 2, allow_subnormal=False)
    joints = "R" + draw(st.text(kinds, min_size=m - 1, max_size=m - 1))
    pose = st.builds(kl.exp, st.lists(number, min_size=6, max_size=6))
    rows = draw(st.lists(st.lists(number, min_size=4, max_size=4), min_size=m, max_size=m))
    convention = draw(st.sampled_from(["standard", "modified"]))
    signs = draw(st.lists(st.sampled_from([1, -1]), min_size=m, max_size=m))
    return DHTable(rows, convention=convention, joints=joints, signs=signs, base=draw(pose), tool=draw(pose))


def sums():
    """Entries as people type them: fractions, pi and a length, added up; every angle within a turn."""
    numbers = st.sampled_from(["0.3", "-1/3", "0", "2.5e-3", "pi/4", "-pi/2", "3*pi/8", "l_2", "-l_2/2", "(1 - l_2)"])
    return st.lists(numbers, min_size=1, max_size=3).map(" + ".join)


def as_rtb(table, convention):
    """The same rows in roboticstoolbox's hands, which knows no fixed ones; base and tool as its SE3."""
    rtb = pytest.importorskip("roboticstoolbox")
    turn, slide = (rtb.RevoluteDH, rtb.PrismaticDH) if convention == "standard" else (rtb.RevoluteMDH, rtb.PrismaticMDH)
    links = [
        turn(a=a, alpha=alpha, d=d, offset=theta) if letter == "R" else slide(a=a, alpha=alpha, theta=theta, offset=d)
        for letter, (a, alpha, d, theta) in zip(table.joints, table.rows, strict=True)
    ]
    from spatialmath import SE3

    return rtb.DHRobot(links, base=SE3(table.base, check=False), tool=SE3(table.tool, check=False))


@given(tables("RP"))
def test_any_table_moves_as_the_robotics_toolbox_s(table):
    q = values(table.n, 3)
    rows = [dict(zip(("a", "alpha", "d", "theta"), map(repr, row), strict=True)) for row in table.rows.tolist()]
    names = map({"R": "theta", "P": "d"}.get, table.joints)
    typed = [row | {name: f"{row[name]} + q"} for row, name in zip(rows, names, strict=True)]
    ours = DHTable(typed, convention=table.convention, base=table.base, tool=table.tool)
    theirs = as_rtb(table, table.convention)
    assert ours.n == theirs.n
    for row, links in zip(q, ours.link_transforms(q), strict=True):
        close(ours.fk(row), theirs.fkine(row).A)
        close(links, [link.A(value).A for link, value in zip(theirs.links, row, strict=True)])


@given(st.tuples(*[sums()] * 4))
def test_an_entry_is_what_sympy_makes_of_it(entries):
    """Any sum of numbers, fractions, pi and a length; the coefficient of q is the joint's sign."""
    text = dict(zip(("a", "alpha", "d", "theta"), entries, strict=True))
    q = sympy.Symbol("q1")
    exact = {name: sympy.sympify(entry).subs("l_2", sympy.Rational(1, 4)) for name, entry in text.items()}
    table = DHTable([text | {"theta": f"{text['theta']} - q1"}], convention="standard", lengths={"l_2": 0.25})
    close(table.rows[0], [float(value.evalf(30)) for value in exact.values()], atol=1e-13)
    assert table.signs == [float(sympy.diff(exact["theta"] - q, q))]


@given(tables())
def test_a_table_survives_the_other_convention_and_back(table):
    q = values(table.n, 5)
    other = "modified" if table.convention == "standard" else "standard"
    there = table.converted(other)
    assert there.convention == other
    close(there.fk(q), table.fk(q))
    close(table.to_chain().fk(q), table.fk(q))
    close(there.converted(table.convention).fk(q), table.fk(q))


def test_a_right_angle_may_be_typed_in_any_of_these_ways():
    entries = ["90 deg", "90º", "90^\\circ", "π/2", "np.pi/2", "−3π/2 + 2*pi", r"$\frac{\pi}{2}$", "\frac{\\pi}{2}"]
    rows = [{"a": 0, "alpha": entry, "d": 0, "theta": "q"} for entry in entries]
    close(DHTable(rows, convention="standard").columns["alpha"], np.pi / 2, 1e-15)


@pytest.mark.parametrize(
    ("constant", "sign", "entries"),
    [
        (0.0, 1, ["q", "q1", "θ_1", "theta_1", r"$\theta_{1}$", "+q1", "q1/1", "\theta_1", "θ₁"]),
        (0.0, -1, ["-q1", "−θ_1", "-1*q1", "q1*-1"]),
        (0.5, 1, ["0.5 + q1", "q1 - -0.5", "-(-q1 - 0.5)", "(2*q1 + 1)/2"]),
        (0.5, -1, ["0.5 - q1", "-q1 + 0.5", "-(q1 - 0.5)"]),
    ],
)
@pytest.mark.parametrize(("column", "joint"), [("theta", "R"), ("d", "P")])
def test_a_joint_variable_is_found_anywhere_in_an_entry(constant, sign, entries, column, joint):
    for entry in entries:
        row = {"a": 0, "alpha": 0, "d": 0, "theta": 0, column: entry}
        table = DHTable([row], convention="standard")
        assert (table.joints, table.columns[column][0], table.signs[0]) == (joint, constant, sign), entry


HEAD = "a|alpha|d|theta\n"
REFUSED = {
    "degrees": (HEAD + "0|-90|0|q1", r"^Row 1, alpha: an angle must be .*; got -90 rad\. If the number is in"),
    "a missing column": ("a|alpha|d\n0|0|0", "takes only what its rows say.*: There is no column theta"),
    "a gear": (
        HEAD + "0|0|0|2*q1",
        "must have one joint variable, q or -q without a factor, .*; got q1 in theta, with the factor 2",
    ),
    "an angle in a length": (HEAD + "0|0|30°|q1", "is no length. Are two columns swapped"),
    "rows in another order": (
        "i|a|alpha|d|theta\n2|1|0|0|q\n1|1|0|0|q",
        "assumes: The rows have the numbers 2, 1: they were read",
    ),
    "a transposed table": (np.zeros((4, 6)), r"rows must have shape \(..., 4\); got \(4, 6\).*rows.T"),
    **{
        entry: (
            f"{HEAD}{entry}|0|0|q1",
            f"^Line 2, .*, a: an entry must be a number, or .*; got {re.escape(repr(entry))}",
        )
        for entry in ("__import__('os')", "1/0", "True")
    },
}


@pytest.mark.parametrize(("rows", "words"), REFUSED.values(), ids=REFUSED)
def test_a_table_that_is_none_is_refused_by_row_and_column(rows, words):
    with pytest.raises(ValueError, match=words):
        DHTable(rows, convention="standard")


@pytest.mark.parametrize("names", [("$a_{i−1}$", "$\\alpha_{i−1}$"), ("aᵢ₋₁", "αᵢ₋₁"), ("a[i-1] (m)", "α_{i-1} [deg]")])
@pytest.mark.parametrize("place", [0, 1])
def test_a_heading_of_the_other_convention_is_refused(names, place):
    own, foreign = names[place], names[place].translate(str.maketrans("", "", "-−₋1₁ "))
    for head, convention, other in ((own, "standard", "modified"), (foreign, "modified", "standard")):
        text = f"{head} | {('alpha', 'a')[place]} | d_i | theta_i\n0 | 0 | 0 | q1"
        words = f"The text is that of a {other} table, but convention is '{convention}'. These two are often confused"
        with pytest.raises(ValueError, match=words):
            DHTable(text, convention=convention)
        assert DHTable(text, convention=other).joints == "R"


def test_a_table_means_nothing_without_its_convention():
    with pytest.raises(TypeError, match="convention"):
        DHTable([[0, 0, 0, 0]])
    with pytest.raises(ValueError, match=r"must be 'standard' or 'modified'; got 'craig'. Is z_i on"):
        DHTable([[0, 0, 0, 0]], convention="craig")


@pytest.mark.parametrize("convention", ["standard", "modified"])
@given(chains_with_values())
def test_a_printed_table_is_read_back(convention, drawn):
    chain, _ = drawn
    if "H" in chain.joint_types:
        return
    table = kl.assign_frames(chain, convention=convention).table
    again = DHTable(str(table), convention=convention)
    np.testing.assert_allclose(again.rows, table.rows, rtol=1e-11, atol=1e-9)
    assert again.joints == table.joints
    assert np.array_equal(again.signs, table.signs)
    for end in ("base", "tool"):
        np.testing.assert_allclose(getattr(again, end), getattr(table, end), rtol=1e-11, atol=1e-9)
    assert again.fk({f"q{i + 1}": 0 for i in range(table.n)}).shape == (4, 4)
