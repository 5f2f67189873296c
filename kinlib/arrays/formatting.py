"""Write numbers, vectors and angles as text for people: few digits, and 0 for rounding errors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.tolerances import ROUNDING_ERROR

SHOWN_DIGITS = 4
"""How many significant digits numbers have where nothing else is said, such as the screw axes of a chain that is printed."""


def format_number(value: float, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a number with at most this many significant digits, and never as -0.

    zero  a number up to this size is written as 0

    >>> format_number(-0.0), format_number(0.25), format_number(np.pi), format_number(-1e-17), format_number(3e-8)
    ('0', '0.25', '3.142', '0', '3e-08')
    """
    return f"{float(value):.{digits}g}" if abs(value) > zero else "0"


def format_vector(values: ArrayLike, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a vector as its components in parentheses.

    >>> format_vector([0.5, -1e-17, 3])
    '(0.5, 0, 3)'
    """
    components = np.asarray(values, dtype=float).tolist()
    return "(" + ", ".join(format_number(value, digits, zero=zero) for value in components) + ")"


def format_matrix(values: ArrayLike, digits: int = SHOWN_DIGITS) -> str:
    """Write a matrix as its rows, which can be typed as they are.

    >>> format_matrix([[1, 0], [-1e-17, 0.25]])
    '[[1, 0], [0, 0.25]]'
    """
    rows = np.asarray(values, dtype=float).tolist()
    return "[" + ", ".join("[" + ", ".join(format_number(value, digits) for value in row) + "]" for row in rows) + "]"


def format_degrees(angle: float, digits: int = SHOWN_DIGITS, *, zero: float = ROUNDING_ERROR) -> str:
    """Write an angle, given in radians, in degrees; zero is written without a degree sign.

    >>> format_degrees(np.pi / 2), format_degrees(-1e-17)
    ('90°', '0')
    """
    text = format_number(float(np.degrees(angle)), digits, zero=zero)
    return text if text == "0" else f"{text}°"


def aligned_table(rows: Sequence[Sequence[str]]) -> str:
    """Write rows of entries as text, with the columns below each other.

    >>> print(aligned_table([["i", "a"], ["1", "0.25"]]))
    i | a
    1 | 0.25
    """
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (" | ".join(entry.ljust(width) for entry, width in zip(row, widths, strict=True)) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def html_table(caption: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Write a table as HTML, for a notebook.

    >>> html_table("An arm", ["i"], [["1"]])
    '<table><caption>An arm</caption><thead><tr><th>i</th></tr></thead><tbody><tr><td>1</td></tr></tbody></table>'
    """
    from html import escape  # only a notebook needs it

    head = "".join(f"<th>{escape(entry)}</th>" for entry in heads)
    body = "".join(f"<tr>{''.join(f'<td>{escape(entry)}</td>' for entry in row)}</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def format_different(one: float, other: float) -> tuple[str, str]:
    """Write two numbers with SHOWN_DIGITS, or with as many more as show by how much they differ.

    >>> format_different(0.4318, 0.5), format_different(0.36442, 0.36435)
    (('0.4318', '0.5'), ('0.36442', '0.36435'))
    """
    one, other = (0.0 if abs(number) < ROUNDING_ERROR * abs(one - other) else number for number in (one, other))
    for digits in range(SHOWN_DIGITS, 18):
        texts = f"{one:.{digits}g}", f"{other:.{digits}g}"
        if max(abs(float(texts[0]) - one), abs(float(texts[1]) - other)) <= abs(one - other) / 20:
            break
    return texts
