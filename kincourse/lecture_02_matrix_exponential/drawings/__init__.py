"""Drawings of lecture 02 alone."""

from kincourse.lecture_02_matrix_exponential.drawings.exponential_series import draw_series
from kincourse.lecture_02_matrix_exponential.drawings.screw_motions import draw_motions
from kincourse.lecture_02_matrix_exponential.drawings.twist_matrix import draw_cross_product, draw_twist_matrix

__all__ = ["draw_cross_product", "draw_motions", "draw_series", "draw_twist_matrix"]
