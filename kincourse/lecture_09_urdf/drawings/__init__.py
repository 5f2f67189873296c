"""Drawings of lecture 09 alone."""

from kincourse.lecture_09_urdf.drawings.urdf_joint import draw_urdf_joint
from kincourse.lecture_09_urdf.drawings.urdf_tree import draw_urdf_tree

__all__ = ["draw_urdf_joint", "draw_urdf_tree"]
