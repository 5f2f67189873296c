"""How far a number in an answer may be off."""

TOLERANCE = 1e-3
"""The accepted error of a number, relative to its size if that is above 1: three printed decimals are enough."""
