"""What lecture 10 shows: two arms that hold one object, and four descriptions of which one is wrong."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import puma560
from kinlib.dh.assignment import assign_frames
from kinlib.dh.diagnosis import diagnose
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import adjoint
from kinlib.urdf.chains import load_urdf, to_urdf
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK, LINK_GREY, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import carried_axes, draw_joint_body

TRAY_DEPTH = 0.5
"""The depth of the tray, as a share of its width."""


def draw_two_arms(
    left: Chain, right: Chain, q_left: ArrayLike, q_right: ArrayLike, *, width: float, base: Array
) -> Picture:
    """Draw two arms whose tool frames are the frame {t} in the middle of one tray.

    q_left, q_right  (n,) the joint values of each arm
    width            the width of the tray along x of {t}, in metres: the left arm holds its end at -x, the right arm that at x
    base             (4, 4) the pose of the base of the right arm

    >>> from kinlib.chains.robots import pose, rppr, X, Y, Z
    >>> draw_two_arms(rppr(), rppr(), np.zeros(4), np.zeros(4), width=0.4, base=np.eye(4)).alt[:46]
    'Two arms hold one tray at (2, 0, 0), 0.4 m wid'
    """
    tray = left.fk(q_left)
    ends = [tray[:3, 3] + side * width / 2 * tray[:3, 0] for side in (-1, 1)]
    arms = [(left, left.link_poses(q_left), np.zeros(3)), (right, right.link_poses(q_right), base[:3, 3])]
    paths = [
        np.concatenate([start[None], frames[:, :3, 3], end[None]])
        for (_, frames, start), end in zip(arms, ends, strict=True)
    ]
    canvas = Canvas(np.concatenate(paths), view="facing")
    canvas.floor(np.concatenate(paths))
    for (chain, frames, _), path, name, colour in zip(
        arms, paths, ("arm 1", "arm 2"), (LINK_GREY, VIOLET), strict=True
    ):
        canvas.line(path, colour, 6.0)
        axes = carried_axes(chain, frames)
        for letter, z, place in zip(chain.joint_types, axes, frames[:, :3, 3], strict=True):
            draw_joint_body(canvas, letter, z, place)
        canvas.label(path[0], name, colour, [(0, -26), (-40, -14), (40, -14)], size=13)
    across = 0.5 * TRAY_DEPTH * width * tray[:3, 1]
    corners = [ends[0] - across, ends[1] - across, ends[1] + across, ends[0] + across]
    canvas.body(np.array(corners), PALE_GREY, level=2.5, edge=ORANGE)
    for T, name in ((np.eye(4), "s"), (tray, "t")):
        canvas.triad(T, name, 0.12 * canvas.size)
    canvas.label(ends[0], "tray", INK)
    return canvas.picture(
        f"Two arms hold one tray at {vector_text(tray[:3, 3])}, {width:.3g} m wide. The bases are "
        f"at (0, 0, 0) and {vector_text(base[:3, 3])}; the ends of the tray are at {vector_text(ends[0])} and {vector_text(ends[1])}.",
        cropped=True,
    )


def received_descriptions() -> dict[str, Chain | DHTable]:
    """Return four descriptions of the PUMA 560, one of which is wrong.

    >>> sorted(received_descriptions())
    ['URDF', 'body', 'space', 'table']
    """
    puma = puma560()
    table = assign_frames(puma, convention="standard").table
    by_body = Chain(puma.body_screws @ adjoint(puma.home).T, puma.home, puma.joint_points, puma.name)
    return {
        "space": puma,
        "body": by_body,
        "table": table.changed(convention="modified"),
        "URDF": load_urdf(to_urdf(puma)),
    }


def what_is_wrong(received: dict[str, Chain | DHTable]) -> str:
    """Diagnose the one description that agrees with none of the others; the code of the lecture does not say which one it is.

    >>> what_is_wrong(received_descriptions())
    'The table is in the standard convention, but was read as modified.'
    """
    return next(str(diagnose(table, puma560())) for table in received.values() if isinstance(table, DHTable))
