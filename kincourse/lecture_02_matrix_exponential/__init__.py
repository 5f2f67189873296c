"""Lecture 02: problems, blank steps and questions."""
