"""DH tables: against the Robotics Toolbox, against the decks' print, and through both conventions without loss."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib import DHTable, dh_transform, robots

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
each_printed = pytest.mark.parametrize(("table", "arm"), PRINTED.values(), ids=PRINTED)


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def values(n, count=50, seed=0):
    return np.random.default_rng(seed).uniform(-3, 3, (count, n))


@st.composite
def tables(draw):
    """Any table of 1 to 7 rows, with joints of both kinds, fixed rows, a base and a tool."""
    m = draw(st.integers(1, 7))
    number = st.floats(-2, 2, allow_subnormal=False)
    joints = "R" + draw(st.text("RPF", min_size=m - 1, max_size=m - 1))
    pose = st.builds(kl.exp, st.lists(number, min_size=6, max_size=6))
    rows = draw(st.lists(st.lists(number, min_size=4, max_size=4), min_size=m, max_size=m))
    convention = draw(st.sampled_from(["standard", "modified"]))
    return DHTable(rows, convention=convention, joints=joints, base=draw(pose), tool=draw(pose))


# --- against what we did not write ---


@each_printed
def test_the_printed_table_is_the_arm_of_its_document(table, arm):
    q = values(arm.n)
    close(table.fk(q), arm.fk(q))
    close(table.to_chain().screws, arm.screws)


@pytest.mark.oracle("roboticstoolbox", dh_transform)
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_row_is_the_robotics_toolbox_s_row(convention):
    rtb = pytest.importorskip("roboticstoolbox")
    link = rtb.RevoluteDH if convention == "standard" else rtb.RevoluteMDH
    for a, alpha, d, theta in np.random.default_rng(1).uniform(-3, 3, (30, 4)):
        expected = link(a=a, alpha=alpha, d=d).A(theta).A
        close(dh_transform(a, alpha, d, theta, convention=convention), expected)


@pytest.mark.oracle("roboticstoolbox", DHTable.fk)
def test_puma_560_by_the_robotics_toolbox():
    rtb = pytest.importorskip("roboticstoolbox")
    table, _ = PRINTED["PUMA 560"]
    links = [rtb.RevoluteMDH(a=a, alpha=alpha, d=d) for a, alpha, d, _ in table.rows]
    q = values(6)
    close(table.fk(q), rtb.DHRobot(links).fkine(q).A)


def test_the_general_matrix_of_each_deck_is_the_product_of_its_four_motions():
    a, alpha, d, theta = 0.3, 0.5, -0.4, 0.7
    turn_x, turn_z = kl.exp([alpha, 0, 0, 0, 0, 0]), kl.exp([0, 0, theta, 0, 0, 0])
    slide_x, slide_z = kl.exp([0, 0, 0, a, 0, 0]), kl.exp([0, 0, 0, 0, 0, d])
    close(dh_transform(a, alpha, d, theta, convention="standard"), turn_z @ slide_z @ slide_x @ turn_x)
    close(dh_transform(a, alpha, d, theta, convention="modified"), turn_x @ slide_x @ turn_z @ slide_z)


@pytest.mark.oracle("printed: deck Example with n = 5", DHTable.link_transforms)
def test_the_link_transforms_of_deck_n_5_come_out_as_printed_and_one_as_it_should_be():
    table, _ = PRINTED["n = 5"]
    q1, q2, q3, q4 = q = np.array([0.4, 0.7, -1.1, 2.0])
    (c1, s1), (c3, s3), (c4, s4) = ((np.cos(x), np.sin(x)) for x in (q1, q3, q4))
    printed = [
        [[c1, -s1, 0, 0], [s1, c1, 0, 0], [0, 0, 1, 0]],
        [[0, 1, 0, 0], [0, 0, 1, q2], [1, 0, 1, 0]],
        [[c3, -s3, 0, 0.5], [0, 0, 1, 0], [-s3, -c3, 0, 0]],
        [[c4, -s4, 0, 0], [0, 0, -1, 0], [s4, c4, 0, 0]],
        [[1, 0, 0, -0.2], [0, 1, 0, 0], [0, 0, 1, 0.3]],
    ]
    wrong = np.argwhere(np.abs(table.link_transforms(q)[:, :3] - printed) > EXACT)
    assert wrong.tolist() == [[1, 2, 2]]  # 1T2, third row: [1 0 0 0], where [1 0 1 0] is printed
    assert abs(table.link_transforms(q)[1, 2, 2]) < EXACT


@pytest.mark.oracle("printed: Lecture 7", dh_transform)
def test_one_of_lecture_7_s_two_general_matrices_has_two_entries_exchanged():
    """The first prints row 2 as (c s_alpha, c c_alpha, ...) and row 3 as (s s_alpha, s c_alpha, ...): no rotation at all."""
    alpha, theta = 0.5, 0.7
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    printed = np.array([[c, -s, 0], [c * sa, c * ca, -sa], [s * sa, s * ca, ca]])
    right = dh_transform(0, alpha, 0, theta, convention="modified")[:3, :3]
    assert np.abs(printed.T @ printed - np.eye(3)).max() > 0.1
    assert np.argwhere(np.abs(printed - right) > EXACT).tolist() == [[1, 0], [2, 1]]


# --- both conventions are one product ---


@given(tables())
def test_a_table_survives_the_other_convention_and_back(table):
    q = values(table.n, 5)
    other = "modified" if table.convention == "standard" else "standard"
    there = table.converted(other)
    assert there.convention == other
    close(there.fk(q), table.fk(q))
    close(there.converted(table.convention).fk(q), table.fk(q))


@given(tables())
def test_a_table_is_its_chain_of_screws(table):
    q = values(table.n, 5)
    close(table.to_chain().fk(q), table.fk(q))
    close(table.to_chain().fk_body(q), table.fk(q))


@given(tables())
def test_fk_is_the_product_of_the_links(table):
    q = values(table.n, 1)[0]
    T = table.base
    for link in table.link_transforms(q):
        T = T @ link
    close(table.fk(q), T @ table.tool)


def test_any_shape_of_joint_values_is_one_computation():
    table, _ = PRINTED["youBot"]
    q = values(5, 6).reshape(2, 3, 5)
    assert table.fk(q).shape == (2, 3, 4, 4)
    close(table.fk(q)[1, 2], table.fk(q[1, 2]))
    assert table.link_transforms(np.zeros((0, 5))).shape == (0, 5, 4, 4)


def test_converting_to_the_convention_it_has_changes_nothing():
    table, _ = PRINTED["youBot"]
    assert table.converted("standard") is table


def test_a_joint_may_turn_the_other_way():
    table = DHTable("a | alpha | d | theta\n 1 | 0 | 0 | pi/2 - q1", convention="standard")
    close(table.fk([np.pi / 2])[:3, 3], [1, 0, 0])
    close(table.converted("modified").fk([0.3]), table.fk([0.3]))
    close(table.to_chain().fk([0.3]), table.fk([0.3]))


# --- as people type them ---


def test_text_dictionaries_and_numbers_are_the_same_table():
    text = DHTable("a | alpha | d | theta\n 0.4 | pi/2 | 0.1 | q1 + 0.2", convention="standard")
    mapped = DHTable([{"theta": "q1 + 0.2", "d": 0.1, "a": 0.4, "alpha": "pi/2"}], convention="standard")
    numbers = DHTable([[0.4, np.pi / 2, 0.1, 0.2]], convention="standard")
    for other in (mapped, numbers):
        close(other.rows, text.rows, 1e-15)
        assert other.joints == text.joints == "R"


@pytest.mark.parametrize(
    ("entry", "number"),
    [
        ("-90°", -np.pi / 2),
        ("90 deg", np.pi / 2),
        ("−π/2", -np.pi / 2),
        ("3*pi/4", 3 * np.pi / 4),
        (r"-\frac{\pi}{2}", -np.pi / 2),
        (r"$\frac{\pi}{4}$", np.pi / 4),
        ("0.5", 0.5),
        ("+1e-3", 1e-3),
    ],
)
def test_an_angle_may_be_typed_in_any_of_these_ways(entry, number):
    close(DHTable(f"a | alpha | d | theta\n 0 | {entry} | 0 | q1", convention="standard").rows[0, 1], number, 1e-15)


@pytest.mark.parametrize(
    ("entry", "constant", "sign"),
    [
        *[
            (entry, 0.0, 1)
            for entry in ("q", "q1", "q_1", "θ1", "θ_1", "theta_1", r"$\theta_{1}$", "+q1", "1*q1", "q1*1", "q1/1")
        ],
        *[(entry, 0.0, -1) for entry in ("-q1", "−θ_1", "-1*q1", "q1*-1", "q1/-1")],
        *[(entry, 0.5, 1) for entry in ("q1 + 0.5", "0.5 + q1", "q1 - -0.5", "-(-q1 - 0.5)", "(2*q1 + 1)/2")],
        *[(entry, 0.5, -1) for entry in ("0.5 - q1", "-q1 + 0.5", "-(q1 - 0.5)")],
        *[(entry, -0.5, 1) for entry in ("q1 - 0.5", "-0.5 + q1", "q1 - 1 + 0.5", "q1 + 0.5 - 1")],
    ],
)
def test_a_joint_variable_is_found_wherever_it_stands_in_an_entry(entry, constant, sign):
    for column, joint in (("theta", "R"), ("d", "P")):
        row = {"a": 0, "alpha": 0, "d": 0, "theta": 0, column: entry}
        table = DHTable([row], convention="standard")
        assert (table.joints, table.rows[0, ("d", "theta").index(column) + 2]) == (joint, constant)
        assert table.signs.tolist() == [sign]


@pytest.mark.parametrize(
    ("entry", "constant", "sign"), [("d_1", 0, 1), ("d1 + 0.5", 0.5, 1), ("-(d_1 - 0.5)", 0.5, -1)]
)
def test_d_with_a_number_is_what_moves_in_its_own_column_and_an_unknown_length_elsewhere(entry, constant, sign):
    table = DHTable([{"a": 0, "alpha": 0, "d": entry, "theta": 0}], convention="standard")
    assert (table.joints, table.rows[0, 2], table.signs[0]) == ("P", constant, sign)
    with pytest.raises(ValueError, match=r"Row 1, theta: .*lengths=\{'d_?1': \.\.\.\}"):
        DHTable([{"a": 0, "alpha": 0, "d": 0, "theta": entry}], convention="standard")


TWO_ROWS = {
    "bars": "a | alpha | d | theta\n0.4 | 0 | 0.1 | q1\n0.3 | pi/2 | q2 | 0.2",
    "bars all round": "|a|alpha|d|theta|\n|---|:-:|--:|---|\n|0.4|0|0.1|q1|\n|0.3|pi/2|q2|0.2|",
    "blanks": "a alpha d theta\n0.4 0 0.1 q1\n0.3 pi/2 q2 0.2",
    "wide blanks": "a  alpha   d    theta\n0.4  0  0.1  q1 + 0\n0.3  pi / 2  q2  0.2",
    "tabs": "a\talpha\td\ttheta\n0.4\t0\t0.1\tq1 + 0\n0.3\tpi / 2\tq2\t0.2",
    "a column of numbers": "i | a | alpha | d | theta\n1 | 0.4 | 0 | 0.1 | q1\n2 | 0.3 | pi/2 | q2 | 0.2",
    "numbers under no head": "a alpha d theta\n1 0.4 0 0.1 q1\n2 0.3 pi/2 q2 0.2",
    "numbers with a dot": "a alpha d theta\n1. 0.4 0 0.1 q1\n2. 0.3 pi/2 q2 0.2",
    "Greek, shuffled, with indices": "θ_i | d_i | α_{i-1} [rad] | a_{i-1}\nq1 | 0.1 | 0 | 0.4\n0.2 | q2 | pi/2 | 0.3",
    "other words": "Link | Angle | Offset | Twist | Length\n1 | q1 | 0.1 | 0 | 0.4\n2 | 0.2 | q2 | pi/2 | 0.3",
    "degrees": "a | psi (deg) | d | theta\n0.4 | 0 | 0.1 | q1\n0.3 | +90 | q2 | 0.2",
}


@pytest.mark.parametrize("text", TWO_ROWS.values(), ids=TWO_ROWS)
def test_a_table_may_be_laid_out_in_any_of_these_ways(text):
    table = DHTable(text, convention="standard")
    close(table.rows, [[0.4, 0, 0.1, 0], [0.3, np.pi / 2, 0, 0.2]], 1e-15)
    assert table.joints == "RP"


def test_degrees_in_the_head_of_a_column_count_for_its_numbers_and_not_for_its_variables():
    table = DHTable("a | alpha [°] | d | theta (deg)\n 0 | 90 | 0 | q1\n 0 | pi/2 | q2 | 45", convention="standard")
    close(table.rows[:, 1], [np.pi / 2, np.pi / 2])
    close(table.rows[:, 3], [0, np.pi / 4])


REFUSED = {
    "degrees": (
        "a|alpha|d|theta\n0|-90|0|q1",
        r"Row 1: alpha = -90 rad is more than two full turns\. Is it in degrees\? Then write -90°, or head the column alpha",
    ),
    "degrees in row 2": ("a|alpha|d|theta\n0|0|0|q1\n0|0|q2|90", "Row 2: theta = 90 rad is more than two full turns"),
    "a row too many numbers": ("a|alpha|d|theta\n0|0|0|q1\n3|0|0|0|q2", "Row 2 has 5 entries under 4 heads: '3"),
    "two variables": ("a|alpha|d|theta\n0|0|q1|q1", "Row 1: the joint variable belongs in theta or in d, once"),
    "a variable in a": ("a|alpha|d|theta\nq1|0|0|0", "Row 1: the joint variable belongs in theta or in d"),
    "a gear": ("a|alpha|d|theta\n0|0|0|2*q1", "should stand alone, as q or -q; its factor is 2"),
    "an unknown length": ("a|alpha|d|theta\n0|0|l7|q1", r"Row 1, d: 'l7'.*lengths=\{'l7': ...\}"),
    "an angle in a length": ("a|alpha|d|theta\n0|0|30°|q1", "d is a length. Are two columns exchanged"),
    "code": ("a|alpha|d|theta\n0|0|0|__import__('os')", "Row 1, theta: .* is no number"),
    "a division by zero": ("a|alpha|d|theta\n0|1/0|0|q1", "Row 1, alpha: '1/0' is no number"),
    "a product of variables": ("a|alpha|d|theta\n0|0|0|q1*q1", "Row 1, theta: .* is no number"),
    "a missing column": ("a|alpha|d\n0|0|0", "The head should name the columns a, alpha, d, theta, each once"),
    "a missing entry": ("a|alpha|d|theta\n0|0|q1", "Row 1 has 3 entries under 4 heads"),
    "no rows": ("a|alpha|d|theta", "needs a head and at least one row"),
    "no joint": ("a|alpha|d|theta\n0|0|0|0", "every row here is fixed"),
    "a row without a column": ([{"a": 0, "d": 0, "theta": "q1"}], "Row 1 has no alpha"),
    "NaN": ([[0, 0, np.nan, 0]], r"rows holds NaN or infinity at index \[0, 2\]"),
    "a transposed table": (np.zeros((4, 6)), r"rows should have shape \(..., 4\); got \(4, 6\).*rows.T"),
    "one row": (np.zeros(4), r"should have shape \(m, 4\)"),
}


@pytest.mark.parametrize(("rows", "words"), REFUSED.values(), ids=REFUSED)
def test_a_table_that_is_none_is_refused_by_row_and_column(rows, words):
    with pytest.raises(ValueError, match=words):
        DHTable(rows, convention="standard")


def test_a_table_means_nothing_without_its_convention():
    with pytest.raises(TypeError, match="convention"):
        DHTable([[0, 0, 0, 0]])
    with pytest.raises(ValueError, match=r"should be 'standard' or 'modified'; got 'craig'. Where does z_i lie"):
        DHTable([[0, 0, 0, 0]], convention="craig")


def test_letters_that_contradict_the_variables_are_refused():
    with pytest.raises(ValueError, match="joints says P, and the variables in the table say R"):
        DHTable("a|alpha|d|theta\n0|0|0|q1", convention="standard", joints="P")
    with pytest.raises(ValueError, match="a letter R, P or F for each of the 1 rows; got 'RR'"):
        DHTable([[0, 0, 0, 0]], convention="standard", joints="RR")


def test_a_base_that_is_no_pose_is_refused():
    with pytest.raises(ValueError, match="base is not rigid"):
        DHTable([[0, 0, 0, 0]], convention="standard", base=np.diag([2, 1, 1, 1]))


def test_too_few_joint_values_are_refused():
    with pytest.raises(ValueError, match=r"q should have shape \(..., 5\); got \(4,\)"):
        PRINTED["youBot"][0].fk(np.zeros(4))


def test_a_table_cannot_be_written_to():
    table = PRINTED["youBot"][0]
    for array in (table.rows, table.signs, table.base, table.tool):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
