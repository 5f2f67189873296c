"""The joints of a chain as a Markdown table."""

from collections.abc import Iterable

from kinlib.chains.chain import Chain
from misstep.display.text import number, vector


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
        letter = chain.joint_types[i]
        kind = kinds[letter] if letter != "H" else f"helical, ${number(pitch[i])}$ m/rad"
        # The screw of a prismatic joint does not depend on a point, so a point would only mislead.
        point = f"${vector(chain.joint_points[i])}$" if letter != "P" else "any"
        rows.append(f"| {i + 1} | {kind} | ${vector(axis[i])}$ | {point} |")
    return _table(["joint", "kind", "direction", "point on the axis (m)"], rows)


def _table(heads: Iterable[str], rows: Iterable[str]) -> str:
    heads = list(heads)
    return "\n".join(["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads), *rows])
