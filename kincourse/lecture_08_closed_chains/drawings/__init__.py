"""Drawings of lecture 08 alone."""

from kincourse.lecture_08_closed_chains.drawings.linkage_sliders import slide_curve, slide_linkage

__all__ = ["slide_curve", "slide_linkage"]
