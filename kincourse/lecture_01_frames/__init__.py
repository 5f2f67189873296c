"""Lecture 01: problems, blank steps and questions."""
