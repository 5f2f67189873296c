"""Lecture 04: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "PoE, body frame"
QUESTION = "What changes if you read the axes from the tool?"
