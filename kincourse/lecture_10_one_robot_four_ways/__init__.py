"""Lecture 10: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "One robot, four ways"
QUESTION = "Do all descriptions of your robot agree?"
