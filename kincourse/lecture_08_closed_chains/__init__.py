"""Lecture 08: problems, blank steps and questions."""
