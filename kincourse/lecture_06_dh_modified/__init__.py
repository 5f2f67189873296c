"""Lecture 06: problems, blank steps and questions."""
