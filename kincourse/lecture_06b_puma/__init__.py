"""Lecture 06b: its blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "PUMA 560"
QUESTION = "What is the pose of a whole robot, as formulas?"
