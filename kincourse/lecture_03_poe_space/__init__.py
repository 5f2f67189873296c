"""Lecture 03: problems, blank steps and questions."""
