"""Lecture 05: its problems, blank steps, questions and drawings. The lists of lectures show its title and its question."""

TITLE = "Denavit-Hartenberg (DH), standard"
QUESTION = "How do four numbers for each link describe the same arm?"
