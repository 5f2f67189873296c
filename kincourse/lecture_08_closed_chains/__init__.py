"""Lecture 08: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Closed chains"
QUESTION = "What if the links form loops?"
