"""Lecture 07: problems, blank steps and questions."""
