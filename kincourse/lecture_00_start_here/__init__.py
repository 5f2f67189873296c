"""Lecture 00: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Start here"
QUESTION = "Where is the tool, if you know only the joint angles?"
