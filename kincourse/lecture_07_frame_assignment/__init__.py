"""Lecture 07: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Frame assignment"
QUESTION = "How do you choose the frames of any robot, and which choices are free?"
