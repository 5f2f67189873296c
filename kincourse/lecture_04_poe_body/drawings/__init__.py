"""Drawings of lecture 04 alone."""

from kincourse.lecture_04_poe_body.drawings.adjoint_steps import draw_adjoint_steps
from kincourse.lecture_04_poe_body.drawings.mid_formula import slide_mid_formula
from kincourse.lecture_04_poe_body.drawings.moving_axis import slide_axis

__all__ = ["draw_adjoint_steps", "slide_axis", "slide_mid_formula"]
