"""Two numbers that change when anything in a picture or a viewer does: its words, in its text too, and its coordinates."""

import json
import re
import zlib

import numpy as np
import pytest

NUMBER = re.compile(r"(?<![\w#.])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![\w.])")


def fingerprint(shown):
    """Return a checksum of what is no number, and a weighted sum of the numbers, in which each has its own weight."""
    drawn = shown.svg + shown.caption if hasattr(shown, "svg") else json.dumps([shown.scene, shown.mode])
    text = drawn + shown.alt
    numbers = np.array(NUMBER.findall(text), dtype=float)
    return zlib.crc32(NUMBER.sub("#", text).encode()), float(numbers @ np.sin(np.arange(1, len(numbers) + 1)))


def assert_unchanged(pictures, looked_at, tolerance):
    """Each picture has the fingerprint that it had when somebody looked at it, but for a tolerance of its numbers."""
    found = {name: fingerprint(draw()) for name, draw in pictures.items()}
    changed = [
        f'"{name}": ({words}, {numbers:.5f}),'
        for name, (words, numbers) in found.items()
        if looked_at.get(name) != (words, pytest.approx(numbers, abs=tolerance))
    ]
    assert not changed, "\n".join(["look at these pictures; if they are as you mean them, write:", *changed])
