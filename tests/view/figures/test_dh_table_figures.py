"""Drawings of DH tables: one row with its four numbers, and a whole table with its frames."""

import pytest

from kincourse.lecture_05_dh_standard.blanks import YOUBOT
from kinlib.view.figures.dh_row_motions import draw_row_motions, draw_zx_factors, poses_along_row
from kinlib.view.figures.dh_table import draw_row, draw_table

ROW = [0.8, 0.6, 0.5, 1.4]


def test_another_number_of_motions_and_a_row_of_another_size_are_refused():
    for done in (-1, 5, None):
        with pytest.raises(ValueError, match="done must be the number of motions carried out, 0 to 4"):
            draw_row(ROW, done)
    with pytest.raises(ValueError, match=r"row must have shape \(..., 4\)"):
        draw_row([1, 2, 3])


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
