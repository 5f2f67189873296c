"""Drawings of DH tables: one row with its four numbers, and a whole table with its frames."""

import pytest

from kincourse.lecture_05_dh_standard.blanks import BENT_CONFIGURATION, YOUBOT
from kinlib.view.figures.dh_row_motions import draw_row_motions, draw_zx_factors, poses_along_row
from kinlib.view.figures.dh_table import draw_row, draw_table

ROW = [0.8, 0.6, 0.5, 1.4]


def test_the_text_alternative_of_a_row_says_where_the_frame_is():
    for done, place in enumerate(
        ["(0, 0, 0)", "(0, 0, 0)", "(0, 0, 0.5)", "(0.136, 0.788, 0.5)", "(0.136, 0.788, 0.5)"]
    ):
        alt = draw_row(ROW, done).alt
        assert f"The frame is at {place}" in alt
        assert ("before the first motion" in alt) == (done == 0)


def test_another_number_of_motions_and_a_row_of_another_size_are_refused():
    for done in (-1, 5, None):
        with pytest.raises(ValueError, match="done must be the number of motions carried out, 0 to 4"):
            draw_row(ROW, done)
    with pytest.raises(ValueError, match=r"row must have shape \(..., 4\)"):
        draw_row([1, 2, 3])


def test_the_text_alternative_of_a_table_says_where_each_frame_is():
    alt = draw_table(YOUBOT, BENT_CONFIGURATION).alt
    hand = YOUBOT.fk(BENT_CONFIGURATION)[:3, 3]
    assert alt.count("Frame") == 6
    assert f"Frame 5 at ({hand[0]:.3g}, 0, {hand[2]:.3g})" in alt


def test_frame_s_is_not_drawn_twice_if_frame_0_is_equal_to_it():
    assert "{s}" not in draw_table(YOUBOT).svg


def test_another_number_of_factors_and_an_unknown_convention_are_refused():
    for wrong in (-1, 5, 1.5, None):
        with pytest.raises(ValueError, match="done must be the number of motions carried out, 0 to 4"):
            draw_row_motions(ROW, wrong)
        with pytest.raises(ValueError, match="factors must be the number of factors"):
            draw_zx_factors([ROW, ROW], wrong)
    with pytest.raises(ValueError, match="convention must be"):
        poses_along_row(ROW, "craig")
