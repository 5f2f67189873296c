"""The common normal of two nearly parallel axes, drawn: it moves away as the angle becomes smaller. And what two tables share."""

import numpy as np

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import INK, JOINT_FILL, LINK_GREY, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture

WIDTH_PX, HEIGHT_PX, PX_PER_M = 560.0, 440.0, 88.0
FLOOR = np.array([200.0, HEIGHT_PX - 40.0])
"""The place in pixels where axis 1 meets the floor."""


DISTANCE_M = 0.5
"""How far axis 2 is to the side of axis 1 at the floor."""


def draw_nearly_parallel_axes(degrees: float) -> Picture:
    """Draw a vertical axis 1, and an axis 2 that is inclined to it, seen along their common normal.

    degrees  the angle between the axes, at least 0 and less than 90

    Seen along the common normal the two axes cross, and the normal is the point where they do: DISTANCE_M / tan(angle) above
    the floor. The scale is the same for every angle, so that the point leaves the picture.

    >>> draw_nearly_parallel_axes(5).alt                                # doctest: +NORMALIZE_WHITESPACE
    'Two axes, seen along their common normal. Axis 2 is 0.5 m beside axis 1 at the floor and inclined by 5 degrees. They
    cross, and have their common normal, 5.72 m above the floor, above the picture.'
    """
    height = np.inf if degrees == 0 else DISTANCE_M / np.tan(np.radians(degrees))
    top = (FLOOR[1] - 14) / PX_PER_M
    drawn = [svg.polyline(np.array([(20, FLOOR[1]), (WIDTH_PX - 20, FLOOR[1])]), INK, 1.6)]
    for metre in range(1, int(top) + 1):
        y = FLOOR[1] - metre * PX_PER_M
        drawn += [
            svg.polyline(np.array([(40, y), (WIDTH_PX - 20, y)]), PALE_GREY, 1),
            svg.text([22, y], f"{metre} m", INK, 12),
        ]
    direction = np.array([-np.sin(np.radians(degrees)), np.cos(np.radians(degrees))])
    low, high = (
        _pixels(DISTANCE_M * np.eye(2)[0] + s * direction) for s in (-0.3, min(top / direction[1], height + 0.5))
    )
    drawn.append(svg.polyline(np.array([_pixels(np.array([0, -0.3])), _pixels(np.array([0, top]))]), VIOLET, 2, "--"))
    drawn.append(svg.polyline(np.array([low, high]), VIOLET, 2, "--"))
    arm = np.array([(0, 0), (0, 0.5), (DISTANCE_M - 0.5 * np.tan(np.radians(degrees)), 0.5)])
    drawn.append(svg.polyline(np.array([_pixels(p) for p in arm]), LINK_GREY, 7))
    drawn += [svg.circle(_pixels(p), 8, JOINT_FILL, INK) for p in arm[1:]]
    drawn += [
        svg.text(_pixels(np.array([-0.15, 0.2])), "$z_1$", VIOLET, 14),
        svg.text([low[0] + 18, low[1] - 6], "$z_2$", VIOLET, 14),
    ]
    drawn += _normal(height, top)
    return Picture(svg.document(drawn, WIDTH_PX, HEIGHT_PX), _describe(degrees, height, height <= top))


def _normal(height: float, top: float) -> list[str]:
    """Draw the common normal as a point, or an arrow towards it if it is above the picture."""
    if height <= top:
        foot = _pixels(np.array([0, height]))
        return [
            svg.circle(foot, 6, ORANGE),
            svg.text([foot[0] + 96, foot[1]], f"common normal, {format_number(height, 3)} m", ORANGE, 13),
        ]
    x, y = WIDTH_PX - 190.0, 20.0
    if np.isinf(height):
        return [svg.text([x, y + 56], "parallel: a normal at every height", ORANGE, 13)]
    return [
        svg.polyline(np.array([(x, y + 40), (x, y + 8)]), ORANGE, 3),
        svg.polygon(np.array([(x, y), (x - 7, y + 12), (x + 7, y + 12)]), ORANGE),
        svg.text([x + 20, y + 56], f"common normal, {format_number(height, 3)} m above", ORANGE, 13),
    ]


def _pixels(point: Array) -> Array:
    """Convert metres, to the right of axis 1 and above the floor, to pixels."""
    pixels: Array = FLOOR + PX_PER_M * np.asarray(point) * (1, -1)
    return pixels


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

    >>> from kinlib.chains.robots import rpr_lecture7
    >>> from kinlib.dh.assignment import assign_frames
    >>> arm = rpr_lecture7(a1=0.4)
    >>> compared(assign_frames(arm, convention="modified"), arm)
    'a_1 = 0.4 m, a_2 = 0.0 m; the poses differ by 0.0 m'
    """
    a_1, a_2 = found.table.columns["a"][1:] + 0.0
    error = np.abs(found.table.fk(np.eye(3)) - arm.fk(np.eye(3))).max().round(9)
    return f"a_1 = {a_1:.1f} m, a_2 = {a_2:.1f} m; the poses differ by {error} m"
