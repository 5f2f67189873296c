"""Sheet 09 computes its answers from the origins of joints, so the URDF reader, which it does not use, must agree."""

import re

import numpy as np
import pytest

import kinlib as kl
from kincourse import open_sheet
from kinlib import dh_transform, load_urdf
from kinlib.rigid.rpy import origin

STUDENTS = [f"student {i}" for i in range(60)]
POSITION_ATOL_M = 1e-4
"""The sheet prints a right angle as 1.5708, with an error of 4e-6 rad, and its arms are about ten metres long."""


@pytest.mark.parametrize("student", STUDENTS)
def test_the_urdf_reader_gives_the_answers_of_the_sheet(student):
    sheet = open_sheet("09_urdf", student)
    answer = {k: sheet.problem(k).answer.value for k in range(1, 9)}
    chain = {k: load_urdf(sheet.given(k).urdf) for k in (3, 4, 5)}
    np.testing.assert_allclose(chain[3].points[2], answer[3], rtol=0, atol=POSITION_ATOL_M)
    np.testing.assert_allclose(chain[4].screws[2], answer[4], rtol=0, atol=POSITION_ATOL_M)
    np.testing.assert_allclose(chain[5].home, answer[5], rtol=0, atol=POSITION_ATOL_M)
    with pytest.raises(ValueError, match=r"^Line \d") as refused:
        load_urdf(sheet.given(6).urdf)
    assert int(re.match(r"Line (\d+)", str(refused.value))[1]) == answer[6]
    given = sheet.given(7)
    names = load_urdf(given.urdf, given.base, given.tip).joint_names
    assert given.options[answer[7]] == list(names)
    row = sheet.given(8)
    expected = dh_transform(row.a, row.alpha, row.d, 0, convention="modified")
    np.testing.assert_allclose(origin(*answer[8]), expected, rtol=0, atol=1e-12)


def test_every_fault_occurs_and_correcting_its_line_makes_the_file_valid():
    """The decoys, such as an axis that is not of unit length, are no faults: the reader accepts the corrected file."""
    seen = set()
    for student in STUDENTS:
        sheet = open_sheet("09_urdf", student)
        text, line = sheet.given(6).urdf, int(sheet.problem(6).answer.value)
        lines = text.splitlines()
        faulty = lines[line - 1]
        seen.add(re.search(r"<(\w+)", faulty)[1])
        links = re.findall(r'<link name="(\w+)"', text)
        held = re.findall(r'child link="(\w+)"', text)
        free = next((link for link in links[1:] if link not in held), "")
        mended = faulty.replace('"0 0 0"', '"0 0 1"').replace('"0 90 0"', '"0 0 0"')
        mended = re.sub(r'lower="(\S+)" upper="(\S+)"', r'lower="\2" upper="\1"', mended)
        mended = re.sub(r'child link="\w+"', f'child link="{free}"', mended)
        assert load_urdf("\n".join([*lines[: line - 1], mended, *lines[line:]]), tip=links[-1]).n == 3
    assert seen == {"child", "limit", "axis", "origin"}


def test_the_axis_of_problem_2_is_that_of_the_chain():
    for student in STUDENTS[:20]:
        problem = open_sheet("09_urdf", student).problem(2)
        element = re.search("```xml\n(.*?)\n```", problem.statement, re.DOTALL)[1]
        joint = f'<joint name="j" type="continuous"><parent link="a"/><child link="b"/>{element}</joint>'
        chain = kl.load_urdf(f'<robot name="r"><link name="a"/><link name="b"/>{joint}</robot>')
        np.testing.assert_allclose(chain.lines.axis[0], problem.answer.value, rtol=0, atol=POSITION_ATOL_M)


def test_every_roll_pitch_and_yaw_of_the_right_rotation_is_right():
    for student in STUDENTS[:20]:
        sheet = open_sheet("09_urdf", student)
        xyz, (alpha, _, _) = sheet.problem(8).answer.value
        for same in ((alpha + np.pi, np.pi, np.pi), (alpha - np.pi, -np.pi, np.pi), (alpha + 2 * np.pi, 0, 0)):
            assert sheet.check(8, [xyz, same]).score == 3
        assert sheet.check(8, [xyz, (0, alpha, 0)]).score == 0
