"""Lecture 06: its problems, blank steps and questions. The lists of lectures show its title and its question."""

TITLE = "DH, modified"
QUESTION = "Where are the four numbers in the other convention?"
