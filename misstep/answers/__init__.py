"""Kinds of answers: how each is read from what a student typed, and compared with the right one."""
