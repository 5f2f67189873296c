"""Lecture 04: problems, blank steps and questions."""
