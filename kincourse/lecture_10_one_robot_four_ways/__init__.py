"""Lecture 10: problems, blank steps and questions."""
