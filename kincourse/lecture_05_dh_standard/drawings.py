"""The last frame of the standard convention, whose z_n is taken parallel to z_{n-1}, and the effect of an offset in theta."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from kinlib.arrays.formatting import format_number
from kinlib.dh.table import DHTable, dh_transform
from kinlib.view import slide
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Gallery, Picture, vector_text
from kinlib.view.figures.arm import JOINT_KINDS, direction_text
from kinlib.view.figures.frames import draw_table
from kinlib.view.figures.joint_bodies import draw_joint_body, stations
from kinlib.view.viewer.pictures import Pictures

X, Y, Z = np.eye(3)


def draw_last_frames() -> Gallery:
    """Draw the last frame behind a revolute joint and behind a prismatic one, and one beside the axis of a revolute joint.

    >>> [picture.caption[:9] for picture in draw_last_frames().pictures]
    ['revolute,', 'prismatic', 'revolute,']
    """
    return Gallery((draw_last_frame("R", d=0.8), draw_last_frame("P", d=0.8), draw_last_frame("R", d=0.5, a=0.6)))


def draw_last_frame(joint: str, d: float, a: float = 0.0) -> Picture:
    """Draw joint n of an arm, its axis z_{n-1}, and frame n behind it, with z_n parallel to z_{n-1} and theta_n = 0.

    joint  "R" or "P"
    d, a   the entries of row n in metres; alpha_n is 0

    >>> draw_last_frame("R", d=0.8).alt
    'Joint n, revolute, along z. Frame n is at (0, 0, 0.8), its z along z, its x along x. Row n: a = 0, alpha = 0, d = 0.8 m.'
    """
    T = dh_transform(a, 0.0, d, 0.0, convention="standard")
    end, foot, length = T[:3, 3], d * Z, 0.42
    canvas = Canvas([-0.2 * Z, (max(d, 0) + 0.5) * Z, end + 0.3 * X, 0.3 * X, 0 * Z], size=(250, 270))
    canvas.arrow(-0.35 * Z, (max(d, 0) + 0.75) * Z, VIOLET, 1.4, style="--", level=2)
    canvas.label((max(d, 0) + 0.75) * Z, "$z_{n-1}$", VIOLET, [(-22, 0), (22, 4)], 12)
    draw_joint_body(canvas, joint, Z, 0 * Z)
    canvas.line([0 * Z, foot], VIOLET, 3.4, level=3.2)
    if a:
        canvas.line([foot, end], ORANGE, 3.4, level=3.2)
        canvas.label((foot + end) / 2, "$a_n$", ORANGE, [(0, -13), (0, 13)], 12)
    canvas.label(foot / 2, "$d_n$", VIOLET, [(-18, 0), (18, 0)], 12)
    for start, direction, name, colour in (
        (0 * Z, X, "$x_{n-1}$", AXIS_COLOURS[0]),
        (end, T[:3, 0], "$x_n$", AXIS_COLOURS[0]),
        (end, T[:3, 2], "$z_n$", AXIS_COLOURS[2]),
    ):
        canvas.arrow(start, start + length * direction, colour, 2.2, level=5)
        canvas.label(start + length * direction, name, colour, [(14, -4), (14, 8), (-16, 6)], 12)
    for side in (-0.12, 0.12):  # the fingers of a gripper
        canvas.line([end - 0.15 * Z, end - 0.15 * Z + side * Y, end + 0.18 * Z + side * Y], LINK_GREY, 2.4, level=2.5)
    canvas.dot(0 * Z, GREY)
    canvas.dot(end, INK)
    numbers = f"a = {format_number(a, 3)}{' m' if a else ''}, alpha = 0, d = {format_number(d, 3)} m"
    motion = "θ_n = q_n" if joint == "R" else "d_n = q_n"
    return canvas.picture(
        f"Joint n, {JOINT_KINDS[joint]}, along z. Frame n is at {vector_text(end)}, its z along {direction_text(T[:3, 2])}, its x along "
        f"{direction_text(T[:3, 0])}. Row n: {numbers}.",
        f"{JOINT_KINDS[joint]}, {motion}; " + ("frame n beside the axis" if a else "frame n on the axis"),
    )


def slide_offset(table: DHTable, row: int, degrees: Sequence[float], *, after: Any = None, start: int = 0) -> Pictures:
    """Show the arm of a DH table at q = 0 with several offsets in theta of one row.

    row      the row whose theta is replaced, counted from 1
    degrees  the offsets, in degrees

    The caption says along which direction z of the last frame points.

    >>> table = kl.assign_frames(kl.robots.youbot(), convention="standard").table
    >>> type(slide_offset(table, 4, range(0, 181, 90))).__name__
    'Pictures'
    """

    def with_offset(angle: float) -> DHTable:
        rows = table.rows.copy()
        rows[row - 1, 3] = np.radians(angle)
        return table.changed(rows=rows, name=f"{table.name} with the offset {angle:g} degrees in row {row}")

    q = np.zeros(table.n)
    tables = [with_offset(angle) for angle in degrees]
    points = np.concatenate([stations(other.to_chain(), q) for other in tables])
    directions = [direction_text(other.fk(q)[:3, 2]) for other in tables]
    pictures = [
        draw_table(other, around=points, caption=f"q = 0. The z axis of the end-effector points along {z}.")
        for other, z in zip(tables, directions, strict=True)
    ]
    return slide(pictures, f"offset in row {row} (degrees)", degrees, after, start)
