"""The common normal of two nearly parallel axes, drawn: it moves away as the angle becomes smaller. And what two tables share."""

import numpy as np

from kinlib.arrays.formatting import format_number
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, JOINT_FILL, LINK_GREY, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture

_, Y, Z = np.eye(3)

DISTANCE_M = 0.5
"""How far axis 2 is to the side of axis 1 at the floor."""

TOP_M = 4.4
"""The height of what is in view."""


def draw_nearly_parallel_axes(degrees: float) -> Picture:
    """Draw a vertical axis 1, and an axis 2 that is inclined to it, seen along their common normal.

    degrees  the angle between the axes, at least 0 and less than 90

    Seen along the common normal the two axes cross, and the normal is the point where they do: DISTANCE_M / tan(angle) above
    the floor. The scale is the same for every angle, so that the point leaves the picture.

    >>> draw_nearly_parallel_axes(5).alt                                # doctest: +NORMALIZE_WHITESPACE
    'Two axes, seen along their common normal. Axis 2 is 0.5 m beside axis 1 at the floor and inclined by 5 degrees. They
    cross, and have their common normal, 5.72 m above the floor, above the picture.'
    """
    tilt = np.radians(degrees)
    height = np.inf if degrees == 0 else DISTANCE_M / np.tan(tilt)
    canvas = Canvas([-1.2 * Y, 3.2 * Y + TOP_M * Z], "side", sizes=np.zeros((2, 3)))
    for metre in range(int(TOP_M) + 1):
        canvas.line([metre * Z - 1.8 * Y, metre * Z + 4.6 * Y], PALE_GREY if metre else INK, 1.2, level=0)
        canvas.label(metre * Z - 1.8 * Y, f"{metre} m", INK, [(14, 9)])
    tilted = np.cos(tilt) * Z - np.sin(tilt) * Y
    reach = min(TOP_M / np.cos(tilt), height + 0.5)
    for foot, axis, end, name in ((0 * Y, Z, TOP_M, "1"), (DISTANCE_M * Y, tilted, reach, "2")):
        canvas.line([foot - 0.3 * axis, foot + end * axis], VIOLET, 2, "--")
        canvas.label(foot - 0.3 * axis, f"axis {name}", VIOLET, size=14)
    arm = np.array([0 * Z, 0.5 * Z, 0.5 * Z + (DISTANCE_M - 0.5 * np.tan(tilt)) * Y])
    canvas.line(arm, LINK_GREY, 7, level=1)
    for joint in arm[1:]:
        canvas.dot(joint, INK, 14)
        canvas.dot(joint, JOINT_FILL, 11)
    normal = f"common normal, {format_number(height, 3)} m"
    above = TOP_M * Z + 2.9 * Y
    if height <= TOP_M:
        canvas.dot(height * Z, ORANGE, 12)
        canvas.label(height * Z, normal, ORANGE, [(118, 0)], 13)
    elif degrees:
        canvas.arrow(above - 0.5 * Z, above, ORANGE, 3)
        canvas.label(above - 0.5 * Z, f"{normal} above", ORANGE, [(0, -14)], 13)
    else:
        canvas.label(above - 0.5 * Z, "parallel: a normal at every height", ORANGE, [(0, -14)], 13)
    return canvas.picture(_describe(degrees, height, height <= TOP_M))


def _describe(degrees: float, height: float, inside: bool) -> str:
    beside = f"Axis 2 is {format_number(DISTANCE_M, 3)} m beside axis 1"
    if np.isinf(height):
        return (
            f"Two axes, seen from the side. {beside} and parallel to it, so there is a common normal at every height."
        )
    place = "inside the picture" if inside else "above the picture"
    return (
        f"Two axes, seen along their common normal. {beside} at the floor and inclined by {format_number(degrees, 3)} degrees. They "
        f"cross, and have their common normal, {format_number(height, 3)} m above the floor, {place}."
    )


def compared(found: FrameAssignment, arm: Chain) -> str:
    """Say what a_1 and a_2 are in a table, and how far its poses are from those of an arm.

    >>> arm = kl.robots.rpr_lecture7(a1=0.4)
    >>> compared(kl.assign_frames(arm, convention="modified"), arm)
    'a_1 = 0.4 m, a_2 = 0.0 m; the poses differ by 0.0 m'
    """
    a_1, a_2 = found.table.columns["a"][1:] + 0.0
    error = np.abs(found.table.fk(np.eye(3)) - arm.fk(np.eye(3))).max().round(9)
    return f"a_1 = {a_1:.1f} m, a_2 = {a_2:.1f} m; the poses differ by {error} m"
