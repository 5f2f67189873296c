"""Lecture 03: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Product of exponentials (PoE), space frame"
QUESTION = "Where is the tool, seen from the base?"
