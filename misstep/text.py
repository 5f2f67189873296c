"""Numbers and matrices as a statement shows them: LaTeX inside Markdown, without a digit too many."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from kinlib.chains.chain import Chain

NOTHING = 1e-5
"""What is smaller is written as 0. It is a hundredth of what an answer may be off, and in files it is pi / 2 cut short."""


def number(x: float) -> str:
    """Write a number with at most four significant digits, and never as -0.

    >>> number(-0.0), number(0.25), number(np.pi), number(-3.7e-6)
    ('0', '0.25', '3.142', '0')
    """
    return f"{x + 0.0:.4g}" if abs(x) > NOTHING else "0"


def vector(x: ArrayLike) -> str:
    """Write a vector in a row, for use between dollar signs.

    >>> vector([0, -1, 0])
    '(0, -1, 0)'
    """
    return "(" + ", ".join(number(value) for value in np.asarray(x, dtype=float)) + ")"


def matrix(X: ArrayLike) -> str:
    r"""Write a matrix in LaTeX, for use between dollar signs.

    >>> matrix(np.eye(2))
    '\\begin{pmatrix} 1 & 0 \\\\ 0 & 1 \\end{pmatrix}'
    """
    rows = r" \\ ".join(" & ".join(number(value) for value in row) for row in np.asarray(X, dtype=float))
    return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"


def joint_table(chain: Chain, joints: Iterable[int] | None = None) -> str:
    """Write the joints as a Markdown table: kind, direction, a point on the axis, pitch.

    joints  which ones, counted from 0; all by default

    >>> from kinlib.chains.robots import rpr
    >>> print(joint_table(rpr()).splitlines()[2])
    | 1 | revolute | $(0, -1, 0)$ | $(-4, -2, 0)$ |
    """
    axis, _, pitch = chain.lines
    kinds = {"R": "revolute", "P": "prismatic", "H": "helical"}
    rows = []
    for i in range(chain.n) if joints is None else joints:
        letter = chain.letters[i]
        kind = kinds[letter] if letter != "H" else f"helical, ${number(pitch[i])}$ m/rad"
        # A slide has no point, and a number that plays no part would only mislead.
        point = f"${vector(chain.joint_points[i])}$" if letter != "P" else "any"
        rows.append(f"| {i + 1} | {kind} | ${vector(axis[i])}$ | {point} |")
    return _table(["joint", "kind", "direction", "point on the axis (m)"], rows)


def _table(heads: Iterable[str], rows: Iterable[str]) -> str:
    heads = list(heads)
    return "\n".join(["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads), *rows])
