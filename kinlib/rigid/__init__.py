"""Rigid motions: exponentials, logarithms, screws and angles (lectures 01 and 02)."""
