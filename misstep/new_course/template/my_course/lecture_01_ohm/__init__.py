"""Lecture 01: Ohm's law."""
