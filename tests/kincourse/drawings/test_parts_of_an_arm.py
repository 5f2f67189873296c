"""The names of the parts of an arm: each part is named, and the text alternative says where the joints are."""

import numpy as np

from kincourse.lecture_00_start_here.drawings import draw_parts
from kinlib.chains.robots import rpr, youbot


def test_every_part_is_named_in_the_text_alternative():
    alt = draw_parts(youbot()).alt
    assert [f"joint {i} (revolute)" in alt for i in range(1, 6)] == [True] * 5
    assert [f"link {i}" in alt for i in range(1, 5)] == [True] * 4
    assert alt.index("base") < alt.index("joint 1") < alt.index("link 1") < alt.index("end-effector")


def test_the_text_alternative_is_that_of_the_configuration():
    q = np.array([0.0, 0.5, 0.3])
    assert draw_parts(rpr()).alt != draw_parts(rpr(), q).alt
    x, y, z = rpr().fk(q)[:3, 3]
    assert f"end-effector at ({x:.3g}, {y:.3g}, {z:.3g}) m" in draw_parts(rpr(), q).alt


def test_links_without_length_have_no_label():
    svg = draw_parts(youbot()).svg
    assert all(f"link {i}" in svg for i in (1, 2, 3))
    assert "link 4" not in svg
