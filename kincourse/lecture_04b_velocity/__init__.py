"""Lecture 04b: its blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Velocity, a first look"
QUESTION = "How fast does the tool move, and in which directions can it not?"
