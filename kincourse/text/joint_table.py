"""The joints of a chain as a Markdown table, the frames between which its DH table is read, and how it is read off them."""

from collections.abc import Iterable, Sequence

import numpy as np

from kincourse.sampling.drawn_machines import table_frames
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import inverse
from misstep.display.text import matrix, number, vector


def joint_table(chain: Chain, joints: Iterable[int] | None = None, points: Sequence[str] = ()) -> str:
    """Write the joints as a Markdown table: kind, direction, a point on the axis, pitch.

    joints  which ones, counted from 0; all by default
    points  a point on each axis in LaTeX; by default the joint's own point, in metres
    """
    axis, _, pitch = chain.lines
    kinds = {"R": "revolute", "P": "prismatic", "H": "helical"}
    rows = ["| joint | kind | direction | point on the axis (m) |", "| --- | --- | --- | --- |"]
    for i in range(chain.n) if joints is None else joints:
        letter = chain.joint_types[i]
        kind = kinds[letter] if letter != "H" else f"helical, ${number(pitch[i])}$ m/rad"
        # The screw of a prismatic joint does not depend on a point, so a point would only mislead.
        place = points[i] if points else vector(chain.joint_points[i])
        point = f"${place}$" if letter != "P" else "any"
        rows.append(f"| {i + 1} | {kind} | ${vector(axis[i])}$ | {point} |")
    return "\n".join(rows)


def rows_from_frames(table: DHTable) -> str:
    """Say how the rows of a table follow from its frames at q = 0, with the numbers of these frames in {s} in lines of their own."""
    x, z = ("$x_i$", "$z_{i-1}$") if table.convention == "standard" else ("$x_{i-1}$", "$z_i$")
    frames = table_frames(table)
    listed = (
        f"$O_{i} = {vector(T[:3, 3])}$, $x_{i} = {vector(T[:3, 0])}$, $z_{i} = {vector(T[:3, 2])}$"
        for i, T in enumerate(frames)
    )
    how = (
        "Row $i$ leads from frame $i-1$ to frame $i$: $a$ is the step from $z_{i-1}$ to $z_i$ along "
        f"{x}, and $\\alpha$ the angle between them about it; $d$ is the step from $x_{{i-1}}$ to $x_i$ along {z}, and $\\theta$ "
        "the angle about it. Angles are in radians, and each row is that of $q = 0$, without its variable. The frames:"
    )
    return "\n".join([how, *listed])


def given_frames(table: DHTable) -> str:
    """Write the first and the last frame of a table at q = 0, as {s} sees them, and where students find all their digits."""
    (first, base), (last, end) = end_frames(table).items()
    return (
        f"$$T_{{s0}} = {matrix(base)}$$\n\n$$T_{{s{len(table.rows)}}}(0) = {matrix(end)}$$\n\n"
        f"They are printed with four digits; `given.{first}` and `given.{last}` have all. `given.home` is the end-effector of "
        f"`kl.Chain(given.screws, given.home, given.points)`, and need not be frame {len(table.rows)}."
    )


def end_frames(table: DHTable) -> dict[str, Array]:
    """Return the first and the last frame of a table at q = 0, as {s} sees them, by the names of given values."""
    return {"T_s0": table.base, f"T_s{len(table.rows)}": table.fk(np.zeros(table.n)) @ inverse(table.tool)}
