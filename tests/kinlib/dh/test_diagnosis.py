"""Tables from papers and data sheets: right, or told which mistake, or which two, and mended."""

import numpy as np
import pytest
from planted_mistakes import TABLES

import kinlib as kl
from kinlib import DHTable, assign_frames, diagnose, equivalent
from kinlib.arrays.tolerances import EQUIVALENCE_TOL
from kinlib.dh import diagnosis
from kinlib.dh.mistakes import corrected_rows, corrections_of_joint_types

PUMA = kl.robots.puma560()
YOUBOT = kl.robots.youbot()
STANDARD = assign_frames(PUMA, convention="standard").table
MODIFIED = assign_frames(PUMA, convention="modified").table


def with_entries(table, *entries):
    rows = np.array(table.rows)
    for row, column, value in entries:
        rows[row - 1, ("a", "alpha", "d", "theta").index(column)] = value
    return table.changed(rows=rows)


def told_as(column, number):
    """How a number is written in a sentence: an angle in degrees."""
    return f"{np.degrees(number):.4g} degrees" if column in {"alpha", "theta"} else f"{number:.4g}"


def exchanged(table, row):
    a, _, d, _ = table.rows[row - 1]
    return with_entries(table, (row, "a", d), (row, "d", a))


@pytest.mark.oracle("axiom: a right table is right in every convention", kl.Diagnosis.verdict)
@pytest.mark.parametrize("table", [STANDARD, MODIFIED, STANDARD.converted("modified")])
def test_a_right_table_is_right(table):
    found = diagnose(table, PUMA)
    assert found.verdict == "right"
    assert not [*found.faults]
    assert str(found).startswith("This table describes the arm.")


def test_zeros_signs_base_and_tool_are_told_and_not_held_against_a_table():
    theirs = DHTable("a|alpha|d|theta\n0.4|0|0|-q1\n0.3|0|0|q2 + pi/2", convention="standard")
    ours = DHTable("a|alpha|d|theta\n0.4|0|0|q1\n0.3|0|0|q2", convention="standard", base=kl.exp([0, 0, 0, 1, 2, 3]))
    found = diagnose(theirs, ours)
    assert found.verdict == "right"
    assert str(found).splitlines() == [
        "This table describes the arm, up to these choices:",
        "Joint 1 has the opposite sign.",
        "Joint 2 has another zero, -90 degrees away.",
        "The base frames differ: rotated by 0 degrees, translated by 2.236 m.",
        "The tool frames differ: rotated by 0 degrees, translated by 3 m.",
        'A table that differs in them is wrong if you pass fixed=["base", "tool", "zeros", "signs"].',
    ]


def test_at_the_end_of_an_arm_an_anti_parallel_axis_may_be_turned_round():
    """Axis 1 of this arm has nothing before it, so joint 1 may count the other way, and alpha = 0 is as right as pi."""
    right = DHTable([[0.4, np.pi, 0.1, 0], [0.3, 0.5, 0.2, 0], [0.2, 0.7, 0.3, 0]], convention="standard")
    found = diagnose(with_entries(right, (1, "alpha", 0.0)), right)
    assert found.verdict == "right"
    assert "Joint 1 has the opposite sign." in str(found)


# --- each mistake, at each place where it can be made, word for word ---

ROWS = np.array(
    [[0.31, 0.7, 0.12, 0], [0.23, -1.1, 0.37, 0], [0.17, 0.9, 0, 0.4], [0.29, 0.6, 0.19, 0], [0.11, 0.5, 0.13, 0]]
)
ARM = DHTable(ROWS, convention="standard", joints="RRPRR")
IN_A_ROW = {
    **{f"alpha of row {k}": ("sign of alpha", k, "alpha", "alpha has the wrong sign.") for k in (1, 2, 3, 4)},
    **{
        f"a and d of row {k}": ("a and d swapped", k, "a", "a and d are swapped. a is measured along x, d along z.")
        for k in (1, 2, 3, 4)
    },
    **{f"d of row {k}": ("sign of d", k, "d", "d has the wrong sign.") for k in (2, 4)},
    **{f"a of row {k}": ("sign of a", k, "a", "a has the wrong sign.") for k in (2, 3)},
    **{
        f"slide of row {k}": (
            *("variable in the wrong column", k, "theta"),
            "the joint variable belongs in theta, because this joint is revolute.",
        )
        for k in (1, 2, 4, 5)
    },
    "turn of row 3": (
        "variable in the wrong column",
        3,
        "d",
        "the joint variable belongs in d, because this joint is prismatic.",
    ),
    "angles of row 3": ("theta and alpha swapped", 3, "theta", "theta and alpha are swapped."),
}


def with_a_mistake(name, row):
    a, alpha, d, theta = ROWS[row - 1]
    match name:
        case "sign of alpha":
            return with_entries(ARM, (row, "alpha", -alpha))
        case "sign of d":
            return with_entries(ARM, (row, "d", -d))
        case "sign of a":
            return with_entries(ARM, (row, "a", -a))
        case "a and d swapped":
            return exchanged(ARM, row)
        case "theta and alpha swapped":
            return with_entries(ARM, (row, "alpha", theta), (row, "theta", alpha))
    joints = list(ARM.joints)
    joints[row - 1] = {"R": "P", "P": "R"}[joints[row - 1]]
    return ARM.changed(joints="".join(joints))


@pytest.mark.parametrize(("name", "row", "column", "text"), IN_A_ROW.values(), ids=IN_A_ROW)
def test_a_mistake_in_a_row_is_told_with_its_place(name, row, column, text):
    found = diagnose(with_a_mistake(name, row), ARM)
    told = [(fault.name, fault.row, fault.column, fault.text) for fault in found.faults]
    assert told == [(name, row, column, f"Row {row}: {text}")]
    assert equivalent(found.corrected, ARM)


SIGNED = DHTable(
    [[0.31, -0.7, 0.12, 0], [-0.23, -1.1, 0.37, 0], [-0.17, 0.9, -0.22, 0], [0.29, 0.6, 0.19, 0]], convention="standard"
)


@pytest.mark.parametrize("column", ["a", "alpha", "d"])
@pytest.mark.parametrize("turned_round", [[], [1, 3], [2]])
def test_a_wrong_number_is_found_whichever_way_the_axes_are_drawn(column, turned_round):
    screws = np.array(SIGNED.to_chain().screws)
    screws[turned_round] *= -1
    arm = kl.Chain(screws, SIGNED.to_chain().home)
    right = SIGNED.rows[1, ("a", "alpha", "d").index(column)]
    (fault,) = diagnose(with_entries(SIGNED, (2, column, 0.777)), arm, in_pairs=False).faults
    told = f"Row 2: {column} should be {told_as(column, right)}; the table has {told_as(column, 0.777)}."
    assert (fault.name, fault.row, fault.column, fault.text) == ("wrong number", 2, column, told)


def alone(wrong, right, **options):
    """The one mistake that is found, which mends the table."""
    found = diagnose(wrong, right, in_pairs=False, **options)
    assert equivalent(found.corrected, right, **options)
    (fault,) = found.faults
    return fault.name, fault.row, fault.column, fault.text


def exchanged_angles(table, row):
    _, alpha, _, theta = table.rows[row - 1]
    return with_entries(table, (row, "alpha", theta), (row, "theta", alpha))


FIXED = DHTable(
    [[0.31, 0.7, 0.12, 0], [0.23, 1.3, 0.37, 0.4], [0.17, 0.9, 0.22, 0], [0.29, 0.6, 0.19, 0]],
    convention="standard",
    joints="RFRR",
)
"""An arm with a bracket: row 2 has no joint, and each of its numbers counts."""


@pytest.mark.parametrize(
    ("column", "number"),
    [
        ("a", 0),
        ("d", 0),
        *((column, angle) for column in ("alpha", "theta") for angle in (0, np.pi / 2, -np.pi / 2, np.pi)),
    ],
)
def test_in_a_row_without_a_joint_the_usual_numbers_are_tried(column, number):
    """They stand nowhere in the arm's own table, where a bracket is part of the rows beside it."""
    right = with_entries(FIXED, (2, column, number))
    told = f"Row 2: {column} should be {told_as(column, number)}; the table has {told_as(column, 0.777)}."
    told = ("wrong number", 2, column, told)
    assert alone(with_entries(right, (2, column, 0.777)), right) == told


SHORT = DHTable([[0.4, 0.6, 0.1, 0], [0.3, -0.9, 0.25, 0], [0, 0, 0, 0]], convention="standard")


def test_a_tolerance_holds_for_the_table_and_for_the_mended_one():
    printed = with_entries(SHORT, (1, "a", 0.400001))
    wrong = with_entries(printed, (1, "alpha", -0.6))
    assert diagnose(printed, SHORT, tolerance=1e-5).verdict == "right"
    assert diagnose(printed, SHORT, tolerance=1e-7, in_pairs=False).verdict == "wrong"
    found = diagnose(wrong, SHORT, tolerance=1e-5)
    assert [fault.name for fault in found.faults] == ["sign of alpha"]
    assert 1e-7 < equivalent(found.corrected, SHORT, tolerance=1e-5).difference < 1e-5
    assert [fault.name for fault in diagnose(wrong, SHORT, tolerance=1e-7).faults] == ["wrong number"]


@pytest.mark.parametrize(("right", "wrong"), [(np.pi, 0.0), (0.0, np.pi)])
def test_parallel_axes_that_point_the_other_way_are_told_the_angle(right, wrong):
    directions = "opposite directions" if right else "the same direction"
    arm = with_entries(SIGNED, (2, "alpha", right))
    explanations = diagnose(with_entries(arm, (2, "alpha", wrong)), arm).explanations
    # The sign of d in row 2 or in row 3 explains it as well.
    (fault,) = [each.faults[0] for each in explanations if each.faults[0].name == "antiparallel"]
    assert (len(explanations), fault.row, fault.column) == (3, 2, "alpha")
    assert fault.text == (
        f"Row 2: the axes are parallel with {directions}: alpha should be {np.degrees(right):.4g} degrees."
    )


def test_a_table_of_a_helical_arm_is_told_that_no_table_has_its_joints():
    helical = kl.Chain([kl.screw((0, 0, 1), (0, 0, 0), 0.1), kl.screw((0, 1, 0), (1, 0, 0))], np.eye(4))
    found = diagnose(DHTable([[1, 0.5, 0, 0], [0.3, 0.2, 0.1, 0]], convention="standard"), helical)
    assert found.difference == "The joint types differ: RR in the table, HR in the arm."
    assert str(found).endswith("explains this table. The joint types differ: RR in the table, HR in the arm.")


def test_two_mistakes_together_are_both_named():
    right = DHTable(
        [[0.4, 0.6, 0.1, 0], [0.3, -0.9, 0.25, 0], [0.2, 1.2, 0.15, 0], [0, 0, 0, 0]], convention="standard"
    )
    wrong = exchanged(with_entries(right, (2, "alpha", 0.9)), 3)
    found = diagnose(wrong, right)
    assert sorted(fault.name for fault in found.faults) == ["a and d swapped", "sign of alpha"]
    assert str(found).splitlines()[0] == "Either: " + " ".join(fault.text for fault in found.faults)
    assert [fault.row for fault in found.faults if fault.name == "a and d swapped"] == [3]
    assert equivalent(found.corrected, right)


def test_what_nothing_explains_is_said_with_the_first_difference():
    right = DHTable(np.random.default_rng(0).uniform(0.2, 1, (4, 4)), convention="standard")
    wrong = DHTable(np.random.default_rng(1).uniform(0.2, 1, (4, 4)), convention="standard")
    found = diagnose(wrong, right)
    assert found.verdict == "wrong"
    assert not [*found.faults]
    assert found.corrected is None
    assert "No known mistake, and no pair of them," in str(found)
    assert "Axes 1 and 2 make an angle of" in str(found)


def test_another_number_of_joints_is_refused():
    with pytest.raises(
        ValueError, match=r"The table must have as many joints as the arm, 5 \(RRRRR\); it has 6 \(RRRRRR\)"
    ):
        diagnose(STANDARD, YOUBOT)


# --- what is fixed ---

CHOICES = ("base", "tool", "zeros", "signs")
UR5 = TABLES["UR5"]


@pytest.mark.parametrize("name", ["UR5", "UR10", "Puma560"])
def test_with_everything_fixed_a_table_is_right_where_the_robotics_toolbox_has_the_same_poses(name):
    rtb = pytest.importorskip("roboticstoolbox")

    def poses(rows):
        robot = rtb.DHRobot([rtb.RevoluteDH(a=a, alpha=alpha, d=d, offset=theta) for a, alpha, d, theta in rows])
        return robot.fkine(np.random.default_rng(0).uniform(-3, 3, (5, len(rows)))).A

    rows = np.array([[link.a, link.alpha, link.d, 0] for link in getattr(rtb.models.DH, name)().links])
    right = DHTable(rows, convention="standard")
    verdicts = set()
    for row, column in np.ndindex(len(rows), 3):
        wrong = rows.copy()
        wrong[row, column] *= -1
        is_right = bool(np.abs(np.array(poses(wrong)) - poses(rows)).max() < 1e-9)
        verdict = diagnose(right.changed(rows=wrong), right, CHOICES, in_pairs=False).verdict
        assert verdict == ("right" if is_right else "wrong")
        verdicts.add(is_right)
    assert verdicts == {True, False}


def test_a_wrong_sign_at_the_end_is_a_choice_of_the_tool_unless_the_tool_is_fixed():
    wrong = with_entries(UR5, (6, "d", -0.0823))
    assert str(diagnose(wrong, UR5)).splitlines() == [
        "This table describes the arm, up to these choices:",
        "The tool frames differ: rotated by 0 degrees, translated by 0.1646 m.",
        'A table that differs in them is wrong if you pass fixed=["tool"].',
    ]
    for fixed in (["tool"], CHOICES):
        found = diagnose(wrong, UR5, fixed)
        assert found.verdict == "wrong"
        assert [fault.text for fault in found.faults] == ["Row 6: d has the wrong sign."]


def test_what_only_the_fixed_choices_exclude_is_said():
    moved = UR5.changed(base=kl.exp([0, 0, 0, 0, 0, 0.3]))
    found = diagnose(UR5, moved, CHOICES, in_pairs=False)
    base, number = found.explanations
    assert base.faults[0].text == "The base T_s0 is missing: it should be rotated by 0 degrees, translated by 0.3 m."
    assert number.faults[0].text == "Row 1: d should be 0.3892; the table has 0.08916."
    np.testing.assert_allclose(base.corrected.base, moved.base, atol=1e-9)
    right, wrong = (with_entries(UR5, *((row, "theta", x * row) for row in (2, 3, 4))) for x in (0.15, 0.05))
    found = diagnose(wrong, right, ["zeros"], in_pairs=False)
    assert not found.explanations
    assert found.difference.startswith(
        "The table describes the arm only up to choices that are fixed here. Joint 2 has"
    )
    assert found.difference.count("another zero") == 3
    assert str(found).startswith(
        f"No known mistake was found that explains this table. {found.difference} The rounding of"
    )


def test_with_fixed_zeros_a_forgotten_offset_is_found():
    right = with_entries(UR5, (2, "theta", -np.pi / 2), (4, "theta", 0.3))
    found = diagnose(with_entries(right, (4, "theta", 0)), right, CHOICES)
    assert [fault.text for fault in found.faults] == ["Row 4: the offset of theta is missing."]
    assert found.corrected.rows[3, 3] == 0.3
    found = diagnose(with_entries(right, (4, "theta", -0.3)), right, CHOICES)
    assert [fault.text for fault in found.faults] == ["Row 4: theta has the wrong sign."]


def test_the_arguments_in_the_wrong_order_are_refused():
    for arguments in [(PUMA, STANDARD), (PUMA, PUMA), (STANDARD, STANDARD.rows)]:
        with pytest.raises(
            ValueError, match=r"takes a DHTable and the arm that it should describe, diagnose\(table, arm\)"
        ):
            diagnose(*arguments)
    with pytest.raises(ValueError, match=r"got Chain and DHTable\. They seem to be swapped"):
        diagnose(PUMA, STANDARD)


# --- the smallest explanation, and ties ---


def faults_of(found):
    return [[(fault.name, fault.row, fault.column) for fault in each.faults] for each in found.explanations]


def test_one_entry_is_preferred_to_a_whole_column():
    """One wrong sign of d: to negate every alpha mends the Puma as well, and that edits four entries."""
    corke = TABLES["Puma (Corke)"]
    for row, column in ((3, "d"), (3, "a"), (3, "alpha")):
        value = corke.columns[column][row - 1]
        found = diagnose(with_entries(corke, (row, column, -value)), corke)
        assert [(f"sign of {column}", row, column)] in faults_of(found)
        assert "Every" not in str(found)


def test_equally_simple_explanations_are_all_told():
    """The direction of x is free: with it, a and alpha change their signs together."""
    found = diagnose(with_entries(SIGNED, (2, "alpha", 1.1)), SIGNED)
    assert faults_of(found) == [[("sign of a", 2, "a")], [("sign of alpha", 2, "alpha")]]
    assert str(found).splitlines() == [
        "Either: Row 2: a has the wrong sign.",
        "or: Row 2: alpha has the wrong sign.",
        "The rounding of its numbers (lengths to 0.01 m, angles to 0.1 rad) explains a difference of at most 0.82.",
    ]
    assert all(equivalent(each.corrected, SIGNED) for each in found.explanations)


def test_of_many_explanations_three_are_told():
    panda = TABLES["Panda"]
    wrong = with_entries(panda, (4, "alpha", -np.pi / 2))
    found = diagnose(wrong, panda)
    assert len(found.explanations) > 3
    assert str(found).splitlines()[3] == f"({len(found.explanations) - 3} more are as simple.)"


# --- mistakes that move entries, and units ---

TILTED = DHTable(
    [[0.31, -0.7, 0.12, 0], [0.23, -1.1, 0.37, 0.2], [0.17, 0.9, 0.22, 0], [0.29, 0.6, 0.19, 0.4]],
    convention="standard",
)


def rolled(column):
    rows = np.array(TILTED.rows)
    rows[:, column] = np.roll(rows[:, column], -1)
    return TILTED.changed(rows=rows)


MOVED = {
    "The table is in the standard convention, but was read as modified.": TILTED.changed(convention="modified"),
    "The columns a and alpha are one row too high: a_{i-1} and a_i were confused.": TILTED.changed(
        rows=np.hstack([np.roll(TILTED.rows[:, :2], -1, axis=0), TILTED.rows[:, 2:]])
    ),
    "The columns a and d are swapped: a is measured along x, d along z.": TILTED.changed(
        rows=TILTED.rows[:, [2, 1, 0, 3]]
    ),
    "Rows 2 and 3 are swapped.": TILTED.changed(rows=TILTED.rows[[0, 2, 1, 3]]),
    "Rows 2 and 3: the entries of d are swapped.": with_entries(TILTED, (2, "d", 0.22), (3, "d", 0.37)),
    "The column a is one row too high.": rolled(0),
    "The column d is one row too high.": rolled(2),
    "The rows are one row too high.": TILTED.changed(rows=np.roll(TILTED.rows, -1, axis=0)),
    "The lengths are in millimetres, but were read as metres.": TILTED.changed(rows=TILTED.rows * (1000, 1, 1000, 1)),
    "The lengths are in centimetres, but were read as metres.": TILTED.changed(rows=TILTED.rows * (100, 1, 100, 1)),
    "The lengths are a thousandth of those of the arm. Is the arm in millimetres?": TILTED.changed(
        rows=TILTED.rows * (0.001, 1, 0.001, 1)
    ),
    "Row 3: a is in millimetres, but was read as metres.": with_entries(TILTED, (3, "a", 170)),
    "Row 2: alpha is in degrees, but was read as radians.": with_entries(
        with_entries(TILTED, (2, "alpha", 0.05)), (2, "alpha", np.degrees(0.05))
    ),
    "Every alpha has the wrong sign: it is the angle from z_{i-1} to z_i about x_i, by the right-hand rule.": TILTED.changed(
        rows=TILTED.rows * (1, -1, 1, 1)
    ),
    "The columns theta and alpha are swapped: theta about z, alpha about x.": TILTED.changed(
        rows=TILTED.rows[:, [0, 3, 2, 1]]
    ),
    "Row 2: theta and alpha are swapped.": exchanged_angles(TILTED, 2),
}


@pytest.mark.oracle("axiom: a planted mistake is undone", diagnose, kl.Diagnosis.faults, kl.Diagnosis.corrected)
@pytest.mark.parametrize(("text", "wrong"), MOVED.items(), ids=MOVED)
@pytest.mark.parametrize("fixed", [(), CHOICES], ids=["free", "fixed"])
def test_what_changed_places_or_units_is_told(text, wrong, fixed):
    right = with_entries(TILTED, (2, "alpha", 0.05)) if "degrees" in text else TILTED
    found = diagnose(wrong, right, fixed)
    assert text in [fault.text for each in found.explanations for fault in each.faults]
    assert found.faults == found.explanations[0].faults
    (mended,) = [each.corrected for each in found.explanations if each.faults[0].text == text]
    np.testing.assert_allclose(mended.rows, right.rows, atol=1e-12)
    q = np.random.default_rng(0).uniform(-2, 2, (5, 4))
    proof = equivalent(found.corrected, right, fixed=fixed)
    mapped = proof.base @ found.corrected.fk(proof.signs * q + proof.offsets) @ proof.tool
    np.testing.assert_allclose(mapped, right.fk(q), rtol=0, atol=1e-9)


def test_an_entry_in_the_row_of_another_one_is_told_with_its_place():
    right = with_entries(TILTED, (3, "d", 0))
    wrong = with_entries(right, (2, "d", 0), (3, "d", 0.37))
    found = diagnose(wrong, right)
    assert [fault.text for fault in found.faults] == ["Row 3: the entry of d belongs in row 2."]


def test_swapped_rows_of_different_joints_are_found_as_well_as_two_variables_in_the_wrong_column():
    wrong = ARM.changed(rows=ARM.rows[[0, 2, 1, 3, 4]], joints="RPRRR")
    ways = corrections_of_joint_types(wrong, ARM.joints)
    assert [[correction.fault.text for correction in way] for way in ways] == [
        [
            "Row 2: the joint variable belongs in theta, because this joint is revolute.",
            "Row 3: the joint variable belongs in d, because this joint is prismatic.",
        ],
        ["Rows 2 and 3 are swapped."],
    ]
    np.testing.assert_allclose(corrected_rows(wrong.rows, ways[1]), ARM.rows, rtol=0, atol=1e-12)
    assert diagnose(wrong, ARM).faults[0].text == "Rows 2 and 3 are swapped."


def test_a_wrong_number_and_another_mistake_are_found_together():
    wrong = with_entries(TILTED, (2, "a", 0.5), (3, "d", -0.22))
    found = diagnose(wrong, TILTED)
    assert [("sign of d", 3, "d"), ("wrong number", 2, "a")] in [sorted(faults) for faults in faults_of(found)]
    assert diagnose(wrong, TILTED, in_pairs=False).corrected is None


@pytest.mark.parametrize("n", [7, 10])
@pytest.mark.parametrize("joints", ["R", "RPR"])
@pytest.mark.parametrize("fixed", [(), CHOICES])
def test_few_corrections_of_a_table_with_three_wrong_numbers_are_compared_joint_by_joint(n, joints, fixed, monkeypatch):
    """Each comparison takes some 50 ms. All other corrections, thousands of pairs, are ruled out together.

    Single corrections are searched for once more with the tolerance that the rounding of the numbers gives.
    """
    compared, through_rounding = [], []

    def counted(table, arm, *, tolerance, **options):
        (compared if tolerance == EQUIVALENCE_TOL else through_rounding).append(table)
        return equivalent(table, arm, tolerance=tolerance, **options)

    monkeypatch.setattr(diagnosis, "equivalent", counted)
    joints = (joints * n)[:n]
    rows = np.array([[0.1 * (k % 3 == 1), (-1) ** k * np.pi / 2, 0.1 * (k % 2) * (k + 1), 0] for k in range(n)])
    right = DHTable(rows, convention="standard", joints=joints)
    wrong = with_entries(right, (2, "a", 0.12), (4, "d", 0.433), (5, "a", 0.5))
    assert diagnose(wrong, right, fixed).verdict == "wrong"
    assert len(compared) <= 6 * diagnosis.MAX_COMPARED + 2
    assert len(through_rounding) <= 3 * diagnosis.MAX_COMPARED


def test_angles_in_degrees_are_told():
    right = TILTED.changed(rows=TILTED.rows * (1, 0.1, 1, 0.1))
    wrong = right.changed(rows=right.rows * (1, np.degrees(1), 1, np.degrees(1)))
    assert diagnose(wrong, right).faults[0].text == "The angles are in degrees, but were read as radians."
