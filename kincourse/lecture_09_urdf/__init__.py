"""Lecture 09: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "URDF"
QUESTION = "How does a file describe a robot, and what can it not describe?"
