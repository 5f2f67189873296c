"""Lecture 00: problems, blank steps and questions."""
