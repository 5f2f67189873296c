"""Lecture 09: problems, blank steps and questions."""
