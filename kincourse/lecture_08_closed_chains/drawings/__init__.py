"""Drawings of lecture 08 alone."""

from kincourse.lecture_08_closed_chains.drawings.four_angles import draw_angles
from kincourse.lecture_08_closed_chains.drawings.hinged_plates import draw_hinged_plates
from kincourse.lecture_08_closed_chains.drawings.linkage_sliders import slide_linkage

__all__ = ["draw_angles", "draw_hinged_plates", "slide_linkage"]
