"""Mistakes that many problems share, each computed from the right answer."""
