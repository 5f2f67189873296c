"""Lecture 01: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Frames"
QUESTION = "Which frame is which, and how are poses composed?"
