"""Write numbers, vectors and angles as text for people: few digits, and 0 for rounding errors."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.tolerances import ROUNDING_ERROR

SHOWN_DIGITS = 4
"""How many significant digits numbers have where nothing else is said, such as the screw axes of a chain that is printed."""


def format_number(value: float, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a number with at most this many significant digits, and never as -0; below a million it has no exponent.

    zero  a number up to this size is written as 0

    >>> format_number(1123.4, 3), format_number(1.5e9)
    ('1120', '1.5e+09')
    """
    text = f"{float(value):.{digits}g}" if abs(value) > zero else "0"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < 1e6 else text


def format_vector(values: ArrayLike, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a vector as its components in parentheses."""
    components = np.asarray(values, dtype=float).tolist()
    return "(" + ", ".join(format_number(value, digits, zero=zero) for value in components) + ")"


def format_matrix(values: ArrayLike, digits: int = SHOWN_DIGITS) -> str:
    """Write a matrix as its rows, which can be typed as they are."""
    rows = np.asarray(values, dtype=float).tolist()
    return "[" + ", ".join("[" + ", ".join(format_number(value, digits) for value in row) + "]" for row in rows) + "]"


def format_degrees(angle: float, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write an angle, given in radians, in degrees; zero is written without a degree sign."""
    text = format_number(float(np.degrees(angle)), digits, zero=zero)
    return text if text == "0" else f"{text}°"


def aligned_table(rows: Sequence[Sequence[str]]) -> str:
    """Write rows of entries as text, with the columns below each other."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (" | ".join(entry.ljust(width) for entry, width in zip(row, widths, strict=True)) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def html_table(caption: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Write a table as HTML, for a notebook; a heading such as alpha_i has a Greek letter and an index."""
    import re  # only a notebook needs these
    from html import escape

    head = "".join(f"<th>{escape(entry)}</th>" for entry in heads)
    for name, letter in {"alpha": "α", "theta": "θ", "omega": "ω"}.items():
        head = head.replace(name, letter)
    head = re.sub(r"_\{?([\w-]+)\}?", r"<sub>\1</sub>", head)
    body = "".join(f"<tr>{''.join(f'<td>{escape(entry)}</td>' for entry in row)}</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def format_different(one: float, other: float) -> tuple[str, str]:
    """Write two numbers with SHOWN_DIGITS, or with as many more as show by how much they differ."""
    one, other = (0.0 if abs(number) < ROUNDING_ERROR * abs(one - other) else number for number in (one, other))
    for digits in range(SHOWN_DIGITS, 18):
        texts = f"{one:.{digits}g}", f"{other:.{digits}g}"
        if max(abs(float(texts[0]) - one), abs(float(texts[1]) - other)) <= abs(one - other) / 20:
            break
    return texts
