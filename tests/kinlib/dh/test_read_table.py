"""Tables as people paste them: each form is the same arm, nothing is assumed without a sentence, and what is no table is refused."""

import numpy as np
import pytest

from kinlib import read_table

UR5 = np.array([
    (0, 90, 0.089159, 0), (-0.425, 0, 0, 0), (-0.39225, 0, 0, 0), (0, 90, 0.10915, 0), (0, -90, 0.09465, 0), (0, 0, 0.0823, 0),
]) * (1, np.pi / 180, 1, np.pi / 180)  # fmt: skip
ROWS = UR5.tolist()


def lines(head, row, end=""):
    """A text with a line for each row: a, alpha in radians and degrees, d and i."""
    numbers = [{"a": a, "alpha": alpha, "deg": round(np.degrees(alpha)), "d": d} for a, alpha, d, _ in ROWS]
    return "\n".join([head, *(row.format(i=i, **each) for i, each in enumerate(numbers, start=1)), end])


FORMS = {
    "a web page, with other columns": lines(
        "Kinematics\ttheta [rad]\ta [m]\td [m]\talpha [rad]\tDynamics\tMass [kg]",
        "Joint {i}\t0\t{a}\t{d}\t{alpha}\tLink {i}\t3.7",
    ),
    "a spreadsheet with decimal commas": "Gelenk;theta (deg);d (mm);a (mm);alpha (deg)\n1;0;89,159;0;90\n2;0;0;-425;0\n"
    "3;0;0;-392,25;0\n4;0;109,15;0;90\n5;0;94,65;0;-90\n6;0;82,3;0;0",
    "CSV": lines("joint,theta,d,a,alpha", "{i},0,{d},{a},{alpha}"),
    "Markdown": lines("| Link | a | α (°) | d | θ |\n|---|---|---|---|---|", "| {i} | {a} | {deg} | {d} | θ{i} |"),
    "LaTeX": lines(
        r"\begin{tabular}{cc} \hline $i$ & $\alpha_i$ & $a_i$ & $d_i$ & $\theta_i$ \\ \hline",
        r"{i} & ${deg}^\circ$ & {a} & ${d}$ & $\theta_{{{i}}}$ \\",
        r"\end{tabular}",
    ),
    "printed by a toolbox": lines(
        "DHRobot: UR5, standard DH parameters\n┌──┐\n│ θⱼ │ dⱼ │ aⱼ │ ⍺ⱼ │ q⁻ │ q⁺ │\n├──┤",
        "│ q{i} │ {d} │ {a} │ {deg}.0° │ -360° │ 360° │",
        "└──┘\n\n│ name │ q0 │ q1 │ q2 │ q3 │ q4 │ q5 │\n│ q │ 0° │ 0° │ 0° │ 0° │ 0° │ 0° │",
        ),
    "calls": lines("robot = DHRobot([", "    RevoluteDH(d={d}, a={a}, alpha={alpha}),", "], name='UR5')"),
    "an array with a comment": lines("# a, alpha, d, theta\nDH = np.array([", "[{a},np.radians({deg}),{d},q{i} + 0],", "])"),
    "an array of C": "double dh[6][4] = { // theta, d, a, alpha\n {0, 0.089159, 0, M_PI_2},\n {0, 0, -0.425, 0},\n"
    " {0,0,-0.39225,0},\n {0, 0.10915, 0, M_PI/2},\n {0, 0.09465, 0, -M_PI_2},\n {0, 0.0823, 0, 0} };",
    "lists by column": "\n".join(f"{name} = {[row[k] for row in ROWS]}" for k, name in enumerate(("a", "alpha", "d"))),
    "an array with tabs and spaces": lines("% rows: [a, d, alpha, theta]\ndh = [", "{a}\t{d}   {alpha}   \t0;", "];"),
    "empty cells": "joint\ta\talpha\td\ttheta\n1\t\t90\t0.089159\tq1\n2\t-0.425\t\t\tq2\n3\t-0.39225\t\t\tq3\n"
    "4\t\t90\t0.10915\tq4\n5\t\t-90\t0.09465\tq5\n6\t\t\t0.0823\tq6",
    "a wiki": lines("{{| class='wikitable'\n! i !! θ !! d !! a !! α".replace("{{", "{"),
                    "|-\n| {i} || 0° || {d} || {a} || {deg}°", "|}"),
    "empty cells at the end": "i\ta\talpha\td\n1\t\t90\t0.089159\n2\t-0.425\n3\t-0.39225"
    "\n4\t\t90\t0.10915\n5\t\t-90\t0.09465\n6\t\t\t0.0823",
    "cells below each other": lines("Link\na\nα (deg)\nd\nθ", "{i}\n{a}\n{deg}\n{d}\n0"),
    "variables with a star": lines("# theta d a alpha", "{i} θ{i}* {d} {a} {deg}°"),
    "arrays of C": "\n".join(f"const double DH_{name}[6] = {{{', '.join(str(row[k]) for row in ROWS)}}};"
                             for k, name in enumerate(("A", "ALPHA", "D"))),
    "units of another language": lines("Link d [m] a [m] alpha [grados] theta [grados]", "{i} {d} {a} {deg} 0"),
    "signs": lines("Link length a Link offset d Link twist alpha Joint angle theta", "{a:+} {d:+} {deg:+}° +0°"),
    "formulas of a spreadsheet": lines("a\talpha\td\ttheta", "{a}\t=RADIANS({deg})\t{d}\t=PI()*0"),
    "long dashes": lines("a & alpha & d \\\\", "{a} & {deg}° & {d} \\\\").replace("-", "--"),
    "units in words": lines("Achse  a in m  α in °  d in m", "{i}\t{a}\t{deg}\t{d}"),
    "letters": lines("a | alpha | d | theta", "a_{i} | {alpha} | d_{i} | θ_{i}", "where ") + ", ".join(
        f"a_{i} = {row[0]} m, d_{i} = {row[2]} m" for i, row in enumerate(ROWS, 1)),
    "calls of dict": "p = {" + lines("", "{i}: dict(a={a}, alpha={alpha}, d={d}, theta=0),", "}"),
    "names in lines": lines("", "Joint {i}: a={a} alpha={deg}° d={d} theta=0°"),
    "Mathematica": "(* a, alpha, d, theta *) dh = {" + ", ".join(f"{{{a}, {al / np.pi} Pi, {d}, 0}}" for a, al, d, _ in ROWS) + "};",
}  # fmt: skip


@pytest.mark.parametrize("text", FORMS.values(), ids=FORMS)
def test_each_form_is_the_same_arm_and_its_unit_and_convention_are_said(text):
    table, assumed = read_table(text, convention="standard")
    np.testing.assert_allclose(table.rows, UR5, atol=1e-6)
    assert table.joints == "RRRRRR"
    asked = {each.argument: each.options[0] for each in assumed if each.options}
    has_unit = any(unit in text for unit in ("[m]", "(mm)", "in m", " m, d_"))
    assert asked.get("length_unit") == (None if has_unit else "mm" if "millimetres" in text or "-425 " in text else "m")


def test_joints_are_those_of_the_variables_the_types_or_the_names_of_the_rows():
    scara = "joint,type,theta,d,a,alpha\n1,revolute,0,387,325,0\n2,revolute,0,0,275,180\n3,prismatic,0,0,0,0\n4,revolute,0,0,0,0"
    assert read_table(scara, convention="standard").table.joints == "RRPR"
    flange = "Joint a (m) d (m) alpha (rad) theta (rad)\nJoint1 0 0.333 0 0\nJoint2 0.088 0 pi/2 0\nFlange 0 0.107 0 0"
    table, assumed = read_table(flange, convention="modified")
    assert (table.joints, table.rows[2, 2]) == ("RRF", 0.107)
    assert any("row 3 is fixed, as its name says" in each.text for each in assumed)
    offsets = read_table(
        "d (mm) a (mm) alpha (deg) offset (deg)\n352 70 -90 0\n0 360 0 -90", convention="standard"
    ).table
    np.testing.assert_allclose(offsets.rows[1], [0.36, 0, 0, -np.pi / 2])
    named = read_table(
        "a alpha d theta\n0 90° l1 q1\nl2 0 0 -q2\nwith l1 = 300 mm, l2 = 0.25", convention="standard"
    ).table
    assert (named.rows[0, 2], named.rows[1, 0], named.signs.tolist()) == (0.3, 0.25, [1, -1])
    ends = "# base = [[1,0,0,0],[0,1,0,0],[0,0,1,0.2],[0,0,0,1]]"
    in_mm = read_table(f"a alpha d [mm] theta\n0 90° l1 q1\nl1 = 300 mm\n{ends}").table
    assert (in_mm.rows[0, 2], in_mm.base[2, 3]) == (0.3, 0.2)


def test_the_kinds_of_joints_that_code_names_are_read():
    matlab = (
        "L(1) = Link('d', 0.3, 'a', 0, 'alpha', pi/2);\nL(2) = Link('theta', 0, 'a', 0.1, 'alpha', 0, 'offset', 0.2);"
    )
    assert (read_table(matlab).table.joints, read_table(matlab).table.rows[1, 2]) == ("RP", 0.2)


def test_what_only_the_numbers_suggest_is_asked_and_can_be_said():
    text = "0 89.159 0 90\n0 0 -425 0\n0 0 -392.25 0"
    asked = {each.argument for each in read_table(text).assumed if each.options}
    assert asked == {"order", "length_unit", "angle_unit", "convention"}
    said = {"order": "theta d a alpha", "length_unit": "mm", "angle_unit": "deg", "convention": "modified"}
    table, assumed = read_table(text, **said)
    assert not [each for each in assumed if each.options]
    assert (table.convention, table.rows[0, 2]) == ("modified", 0.089159)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "No table was found: no line has four numbers"),
        (
            "a alpha d theta\n0 90° 0.1 q1\n0 0 abc 0 0 1 2",
            r"Line 3, .* cannot be read: it does not have as many cells as the other rows",
        ),
        ("a alpha d theta\n0 90° 0.1 q1*q2\n0 0 0 q2", r"Line 2, .*, theta: an entry must be a number"),
        ("a = [0, 1]\nalpha = [0, 0]\nd = [1]", r"lists of the same length; got a \(2\), alpha \(2\), d \(1\)"),
        ("x" * 200_000, "must have at most 40000 characters; got 200000"),
        ("a =" + "\t" * 30_000, "or as many tabs"),
        ("9" * 30_000, "a word of 500 characters or more"),
        ("All lengths are in inches.\na alpha d theta\n0 90 6 q1", "must be in m, cm or mm; the text has 'inches'"),
        ("i a(in) alpha(deg) d(in) theta\n1 0 -90 26.45 0", r"must be in m, cm or mm; the text has '\(in\)'"),
        ("a alpha d theta\n0 5mm 0.1 q1", "Line 2, .*, alpha: '5mm' is no angle"),
        ("a = [0, 0.4]\nd = [0.3, 0]", r"must have one value for each row, .*; got a [(]2[)], d [(]2[)]"),
        (
            "# rows: alpha, d, theta\n0, 1.57, 0.3, 0\n0.4, 0, 0, 0",
            "Line 3, .* cannot be read: it does not have as many cells",
        ),
        ("theta 0 0 0 0\nd 0.3 0 0 0.1\na 0 0.4 0.2 0\nalpha 90 0 0 0", "No table was found"),
        ("1 90 0.3 0\n2 0 0 0.2", "The first column only counts the rows"),
        ("Link('d', 0,3, 'a', 0)\nLink('d', 0, 'a', 0,4)", "got '0,3'. The decimal sign is a point: write 0.3"),
        ("a alpha d theta\n0 90° l1 q1\n0.4 0 0 q2\nl1 = 0,3", "got 'l1'. If l1 is the joint variable"),
        ("a1, a2 = 0, 0.4\nalpha1, alpha2 = pi/2, 0\nd1, d2 = 0.3, 0", "Row 1, alpha: .*; got 'pi/2, 0'"),
        ("a = [0, 0.4]\na = [0, 0.5]\nalpha = [pi/2, 0]\nd = [0.3, 0]", "and two values for a. Paste all of one arm"),
        ("a1 = 0; alpha1 = 0; d1 = 0.3\na2 = 0; alpha2 = 0", r"got a \(2\), alpha \(2\), d \(1\)"),
        ("RevoluteDH(d=length[0])\nRevoluteDH(a=length[1])", "Row 1, .*, d: an entry must be a number"),
        ("a1 = 0; alpha1 = pi/2; d1 = 0.3 * SCALE\na2 = 1; alpha2 = 0; d2 = 0", "0.3 [*] SCALE"),
        ("L1 = 0.3 * SCALE\na | alpha | d | theta\n0 | 0 | L1 | q1\n1 | 0 | 0 | q2", "If L1 is the joint variable"),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(text, words):
    with pytest.raises(ValueError, match=words):
        read_table(text)


SAME_ARM = {
    "symbols": "s = {alpha1: pi/2, a1: 0, d1: 0.3,\n alpha2: 0, a2: 0.4, d2: 0, q2: q2 + pi/2,\n alpha3: 0, a3: 0.2, d3: 0}",
    "numbers in another order": "a2=0.4 alpha2=0 d2=0 theta2=pi/2\na1=0 alpha1=pi/2 d1=0.3 theta1=0\na3=0.2 alpha3=0 d3=0 theta3=0",
    "fields by number": "L(1).a = 0; L(1).alpha = pi/2; L(1).d = 0.3; L(1).offset = 0;\n"
    "L(2).a = 0.4; L(2).alpha = 0; L(2).d = 0; L(2).offset = pi/2;\nL(3).a = 0.2; L(3).alpha = 0; L(3).d = 0; L(3).offset = 0;",
    "ranges behind the rows": "Joint i θi di ai αi Range\n1 0 0.3 0 π/2 −170 ~ +170\n2 π/2 0 0.4 0 −100° ~ +130°\n3 0 0 0.2 0 −90 ~ 90",
    "names in cells": "a | alpha | d | theta\n0 | pi/2 | d1=0.3 | q1\na2 = 0.4 | 0 | 0 | q2 + pi/2\n0.2 | 0 | 0 | q3",
    "words": "$d_{bs} = 300$ mm, L = 0.4 m\na & alpha & d & theta \\\\\n0 & 90° & $d_{bs}$ & q1 \\\\\nL & 0 & 0 & q2 + 90° \\\\\n"
    "0.2 & 0 & 0 & q3",
    "names with more words": "arm_alpha_vals = [(math.pi/2), 0, 0]\narm_a_vals = [0, 0.4, 0.2]\narm_d_vals = [0.3, 0, 0]\n"
    "arm_theta_offsets = [0, math.pi/2, 0]",
    "JSON with a comment": '{"dh_params": [[0.0, 1.5707963267948966, 0.3, 0.0], [0.4, 0.0, 0.0, 1.5707963267948966], [0.2, 0, 0, 0]]}'
    "  # [a, alpha, d, theta]",
    "columns beside the rows": '{"columns": ["a", "alpha", "d", "theta"], "rows": [[0, 1.5707963267948966, 0.3, 0], '
    "[0.4, 0, 0, 1.5707963267948966], [0.2, 0, 0, 0]]}",
    "columns behind the rows": "pd.DataFrame([[0, pi/2, 0.3, 0], [0.4, 0, 0, pi/2], [0.2, 0, 0, 0]], columns=['a', 'alpha', 'd', 'theta'])",
    "comments beside the rows": "dh = [\n  [0, pi/2, 0.3, 0],  # shoulder: a, alpha, d, theta\n"
    "  [0.4, 0, 0, pi/2],  # elbow\n  [0.2, 0, 0, 0],\n]",
    "a sentence above the heading": "Of a, alpha, d and theta there are 3.\n"
    "i theta d a alpha\n1 q1 0.3 0 pi/2\n2 q2+pi/2 0 0.4 0\n3 q3 0 0.2 0",
    "a heading beside the first row": "links = [\n  (0.0, 0.3, 0.0, pi/2),   # theta, d, a, alpha\n  (pi/2, 0.0, 0.4, 0.0),\n"
    "  (0.0, 0.0, 0.2, 0.0),\n]",
    "one space between two cells": "i  a   alpha  d    theta\n1  0   90     0.3  q1*\n2  0.4 0      0 q2+90\n3  0.2   0      0  q3*",
    "a frame as pandas prints it": "     a  alpha    d theta\nJ1   0 pi/2 0.3 q1\nJ2  0.4 0.0 0.0 q2 + pi/2\nJ3 0.2  -0.0  0.0 q3",
    "Link with a type and an offset": "L1 = Link([0 0.3 0 pi/2]);\nL2 = Link([0 0 0.4 0 0 pi/2]);\nL3 = Link([0 0 0.2 0]);\n"
    "arm = SerialLink([L1 L2 L3], 'name', 'arm');",
    "computed values": "deg = pi/180;\nL2 = 0.1 + 0.3  # m\nDH(d=0.3, alpha=90*deg), DH(a=L2, offset=90.0*deg), DH(a=0.2)",
    "a column below the rows": "r.DH=[0,0.3,0,pi/2;\n pi/2,0,0.4,0;\n 0,0,0.2,0];%theta,d,a,alpha\nr.base=[0;0;0.329];%origin",
    "one space in a heading, two between cells": "Kinematics theta [rad] d [m]  a [m]  alpha [rad]\n"
    "Joint 1    0           0.3    0      pi/2\nJoint 2    pi/2        0      0.4    0\nJoint 3    0           0      0.2    0",
    "types beside the columns of a comment": "# theta d a alpha type\nq1 0.3 0 90deg R\nq2+pi/2 0 0.4 0 R\nq3 0 0.2 0 R",
    "a figure inside a name": "T2_offset = pi/2\nd | a | alpha | offset\n0.3|0|pi/2|0\n0|0.4|0|T2_offset\n0|0.2|0|0",
    "prose in a comment": "% dh = [a(i), alpha(i), d(i), theta(i)]\n% The rows correspond to link 1, 2, 3, 4.\n"
    "dh = [0, pi/2, 0.3, 0;   % first\n 0.4, 0, 0, pi/2;\n 0.2, 0, 0, 0];",
}


@pytest.mark.parametrize("form", SAME_ARM)
def test_code_is_read_in_whatever_way_it_names_its_numbers(form):
    table, _ = read_table(SAME_ARM[form], convention="standard")
    assert table.joints == "RRR"
    assert table.rows == pytest.approx(
        np.array([(0, np.pi / 2, 0.3, 0), (0.4, 0, 0, np.pi / 2), (0.2, 0, 0, 0)]), abs=1e-12
    )


@pytest.mark.parametrize(
    "sentence",
    [
        "All lengths are in millimetres and all angles in degrees.",
        "Table 1. Kinematics (lengths in mm; angles in deg)",
        "The twist angles are given in degrees, and the dimensions in mm.",
    ],
)
def test_units_are_those_that_a_sentence_says(sentence):
    table, assumed = read_table(f"{sentence}\ntheta d a alpha\nq1 1.5 0 3\nq2 0 4 0", convention="standard")
    np.testing.assert_allclose(table.rows, [[0, np.radians(3), 0.0015, 0], [0.004, 0, 0, 0]])
    assert not [each.text for each in assumed if each.options]


def test_a_sentence_that_the_numbers_contradict_is_asked():
    text = "The joint angles are in degrees, lengths in m.\ntheta d a alpha\nq1 89.2 0 1.5708\nq2 0 -425 0"
    asked = {each.argument: each for each in read_table(text, convention="standard").assumed if each.options}
    assert set(asked) == {"length_unit", "angle_unit"}
    assert asked["angle_unit"].text.endswith("are in deg, and this was taken, although the largest is 1.5708.")
    assert asked["angle_unit"].options == ("deg", "rad")


@pytest.mark.parametrize(
    "comment",
    [
        "# each row is (a, alpha, d, theta)",
        "# UR5 standard DH: [a, alpha, d, theta]",
        "# DH: [a, alpha, d, theta]",
        "// rows hold a, then alpha, then d and theta",
        "/* a [m], alpha [rad], d [m], theta [rad] */",
        "% columns = [a alpha d theta] of the arm",
        '"""Return the table, with the columns (a, alpha, d, theta)."""',
        "# link length, link twist, link offset, joint angle",
        "# a and d in metres, alpha and theta in radians\n# (a, alpha, d, theta), a row for each joint",
        "# a, alpha, d, theta\n# d and a in metres, theta and alpha in radians",
        "# DH: a (m), alpha (rad), d (m), theta (rad)",
    ],
)
def test_a_comment_names_the_columns_in_prose(comment):
    rows = "dh = [[0, pi/2, 0.3, 0],\n[0.4, 0, 0, pi/2],\n[0.2, 0, 0, 0]]"
    table, assumed = read_table(f"{comment}\n{rows}", convention="standard")
    assert table.rows.tolist() == [[0, np.pi / 2, 0.3, 0], [0.4, 0, 0, np.pi / 2], [0.2, 0, 0, 0]]
    assert not [each.text for each in assumed if "column" in each.text]


def test_an_index_only_suggests_the_standard_convention():
    asked = read_table("a_i alpha_i d_i theta_i\n0 pi/2 0.3 q1\n0.4 0 0 q2").assumed[-1]
    assert asked == (
        "The convention is standard, as the index i of a and alpha suggests.",
        "convention",
        ("standard", "modified"),
    )


def test_a_list_that_no_column_has_is_told():
    text = "a = [0, 0.4]\nalpha = [pi/2, 0]\nd = [0.3, 0]\njoint_direction = [1, -1]"
    assert "The list joint_direction was not read." in [each.text for each in read_table(text).assumed]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("L(1)=Link([0 0.3 0 pi/2]);\nL(2)=Link([0 0 0.4 0]);\nL(2).offset=pi/2;", "'L(2).offset=pi/2;' was not read."),
        ("a alpha d theta\n0 90° 0.3 q1\n0.4 0 0 q2\ntool = 0 0 0.1", "The tool was not read: 'tool = 0 0 0.1'."),
        ("a alpha d theta\n0 90° 0.3 q1\n# 0.4 0 0 q2\n0.2 0 0 q3", "A comment was not read: '# 0.4 0 0 q2'."),
        (
            "dh = [[0.4, 0, 0, 0],\n# [0.2, pi/2, 0.3, 0],\n[0, 0, 0.1, 0]]",
            "A comment was not read: '# [0.2, pi/2, 0.3, 0],'.",
        ),
        ("L(1)=Link([0 0.3 0 pi/2]);\n% L(2)=Link([0 0 1 0]);", "A comment was not read: '% L(2)=Link([0 0 1 0]);'."),
        ("a alpha d theta\n0 90° 0.3 0\n\n0.4 0 0 0", "The rows below an empty line were read, too."),
        ("j α d θ r\n1 0 0 0 0.1\n2 90° 0.2 0 0", "The column r was read as a; some papers call d so."),
        ("a [mm] | alpha | d [mm] | theta\n1,250 | 90° | 0 | q1", "The comma of 1,250 was read as a decimal sign."),
    ],
)
def test_what_is_not_read_is_told(text, words):
    assert words in [each.text for each in read_table(text).assumed]


def test_an_offset_is_that_of_the_variable():
    printed = "| j | theta | d | a | alpha | offset |\n| 1 | q1 | 0 | 0 | 90° | 0.1 |\n| 2 | 0 | q2 | 0 | 0 | 0.2 |"
    np.testing.assert_allclose(read_table(printed, angle_unit="rad").table.rows[:, 2:], [[0, 0.1], [0.2, 0]])


def test_a_flipped_joint_counts_the_other_way_also_beside_another_call():
    text = "[RevoluteDH(d=0.1, flip=True), RevoluteDH(a=0.2), PrismaticDH(alpha=0, offset=0.1, flip=True)]"
    table, _ = read_table(text, convention="standard")
    assert (table.joints, table.signs.tolist()) == ("RRP", [-1, 1, -1])
    assert table.rows[2] == pytest.approx([0, 0, 0.1, 0])


def test_a_sentence_with_numbers_above_the_rows_is_no_row():
    text = "Robot: UR5, 6 joints, 850 mm reach, 18.4 kg, 5 kg payload\n0 0.089159 0 pi/2\n0 0 -0.425 0\n0 0 -0.39225 0"
    table, _ = read_table(text, convention="standard")
    assert table.rows[:, 0] == pytest.approx([0, -0.425, -0.39225])
