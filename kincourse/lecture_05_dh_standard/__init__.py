"""Lecture 05: problems, blank steps and questions."""
