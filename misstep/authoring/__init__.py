"""Commands for authors: add a problem, check a course, look at a problem with its mistakes."""
