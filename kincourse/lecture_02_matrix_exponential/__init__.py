"""Lecture 02: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "The matrix exponential"
QUESTION = "How does a screw axis become a motion?"
