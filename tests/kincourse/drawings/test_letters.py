"""The letters of the sheets' drawings: large enough, apart from each other, and each nearest to its own link."""

import re
from itertools import pairwise

import numpy as np
import pytest
from legible import overlapping_labels

from kincourse import find_sheet, sheets
from kincourse.lecture_03_poe_space.drawings import draw_lettered_joints
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.lettered_arms import draw_lettered_arm

LETTER = re.compile(r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="middle" font-size="([\d.]+)"[^>]*>(.*?)</text>')
LINKS = re.compile(r'<polyline points="([^"]+)" fill="none" stroke="[^"]+" stroke-width="5"')

SIGNS = (("", 1), ("-", -1))


def distance(point, start, end):
    along = end - start
    share = np.clip((point - start) @ along / max(along @ along, 1e-9), 0, 1)
    return np.linalg.norm(point - start - share * along)


def test_letters_are_large_apart_and_nearest_to_their_own_link():
    drawn = {one.number: one.variant("ada").figure for name in sheets() for one in find_sheet(name).problems}
    pictures = {number: figure() for number, figure in drawn.items() if figure}
    assert len(pictures) > 50
    for number, picture in pictures.items():
        assert overlapping_labels(picture) == [], number
        width, box = re.search(r'<svg [^>]*width="([\d.]+)"[^>]*viewBox="([^"]+)"', picture.svg).groups()
        for x, y, size, inside in LETTER.findall(picture.svg):
            assert float(size) * float(width) / float(box.split()[2]) >= 12.9, number
            if match := re.fullmatch(r"L_?(\d)", re.sub(r"<[^>]*>|&\w+;", "", inside)):
                points = np.array([pair.split(",") for pair in LINKS.search(picture.svg)[1].split()], dtype=float)
                centre = np.array([float(x), float(y) - 0.35 * float(size)])
                nearest = np.argmin([distance(centre, *ends) for ends in pairwise(points)])
                assert nearest == int(match[1]) - 1, (number, inside)


@pytest.mark.parametrize("student", ["ada", "bob"])
def test_an_arm_with_letters_can_be_rebuilt_from_its_text_alone(student):
    robot = draw_lettered_arm(ArmSampler(student, "03.9"))
    alt = draw_lettered_joints(robot.chain, robot.letters).alt
    units = {
        sign + letter: factor * unit for letter, unit in zip("xyz", np.eye(3), strict=True) for sign, factor in SIGNS
    }
    for before, true in ((r"L_\d along ", robot.links), ("axis along ", robot.axes)):
        np.testing.assert_array_equal([units[found] for found in re.findall(before + "(-?[xyz])", alt)], true)
    tool = [np.fromstring(found, sep=",") for found in re.findall(r"[xyz] = \(([^)]*)\)", alt)]
    np.testing.assert_array_equal(tool, robot.tool)
    assert f"({robot.joint_types})" in alt
