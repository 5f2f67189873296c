"""Drawings of lecture 02; lecture 03 shows the velocity of a point again."""

from kincourse.lecture_02_matrix_exponential.drawings.exponential_series import draw_series
from kincourse.lecture_02_matrix_exponential.drawings.point_velocity import draw_point_velocity
from kincourse.lecture_02_matrix_exponential.drawings.screw_motions import draw_motions
from kincourse.lecture_02_matrix_exponential.drawings.small_steps import draw_small_steps

__all__ = ["draw_motions", "draw_point_velocity", "draw_series", "draw_small_steps"]
