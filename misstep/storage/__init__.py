"""Answers as data: written as plain JSON where a submission runs, read back where it is judged."""
