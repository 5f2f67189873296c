"""DH rows as motions, drawn: one row carried out step by step in both conventions, and one walk that both cut in pieces."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention, dh_transform
from kinlib.view.drawing.canvas import Canvas, view_axes
from kinlib.view.drawing.colours import GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

TRANSLATE_X, ROTATE_X, TRANSLATE_Z, ROTATE_Z = range(4)
"""The columns of a row, a, alpha, d, theta, as the motions that they are."""

MOTION_ORDER: dict[Convention, tuple[int, ...]] = {
    "standard": (ROTATE_Z, TRANSLATE_Z, TRANSLATE_X, ROTATE_X),
    "modified": (ROTATE_X, TRANSLATE_X, ROTATE_Z, TRANSLATE_Z),
}
"""The four motions in the order in which the frame makes them, each about or along an axis of its own."""

MOTION_NAMES = ("along x by a", "about x by alpha", "along z by d", "about z by theta")


def poses_along_row(row: ArrayLike, convention: Convention) -> Array:
    """Where a frame stands after none, one, ... and all four motions of a DH row, (5, 4, 4).

    row  (4,) a, alpha, d, theta, in metres and radians

    Raises ValueError for another size, and for another convention.

    >>> poses_along_row([0.4, 0, 0, np.pi / 2], "standard")[3, :3, 3].round(3) + 0.0
    array([0. , 0.4, 0. ])
    """
    values = validation.vectors(row, "row", 4)
    dh_transform(*values, convention=convention)  # refuses what is no convention, in words
    stops = [np.eye(4)]
    for motion in MOTION_ORDER[convention]:
        stops.append(stops[-1] @ dh_transform(*np.where(np.arange(4) == motion, values, 0.0), convention=convention))
    return np.array(stops)


def draw_row_motions(
    row: ArrayLike, done: int, caption: str = "", *, conventions: Sequence[Convention] = tuple(MOTION_ORDER)
) -> Picture:
    """Draw a frame carried by the motions of one DH row, standard on the left and modified on the right.

    row          (4,) a, alpha, d, theta
    done         how many of the four motions are carried out
    conventions  which ones are drawn

    Both start from a frame {i-1} and use the same numbers. What is still to come is grey; the stretch along x is orange
    and marked a, the one along z is violet and marked d. The dashed line is the axis of joint i: the standard convention
    has it at the start of the row, the modified one at its end.

    Raises ValueError for another number of motions than 0 to 4.

    >>> draw_row_motions([0.5, 1.0, 0.4, 0.5], 1).alt          # doctest: +NORMALIZE_WHITESPACE
    'One DH row, two conventions, motion 1 of 4. Standard: about z by theta; the frame is at (0, 0, 0), its z along
    (0, 0, 1). Modified: about x by alpha; the frame is at (0, 0, 0), its z along (0, -0.841, 0.54).'
    """
    if done not in range(5):
        raise ValueError(f"done counts the motions of a row, 0 to 4; got {done!r}.")
    walks = {convention: poses_along_row(row, convention) for convention in conventions}
    size = max(float(np.ptp(np.concatenate(list(walks.values()))[:, :3, 3], axis=0).max()), 0.2)
    apart = 2.2 * size * view_axes("default")[1][0]
    for poses_along_arm, side in zip(walks.values(), (0, 1), strict=False):
        poses_along_arm[:, :3, 3] += side * apart
    seen = np.concatenate([poses_along_arm[:, :3, 3] for poses_along_arm in walks.values()])
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    canvas = Canvas(middle + 0.72 * (seen - middle))  # nothing reaches far out here: most of the margin may go
    said = []
    for (convention, poses_along_arm), side in zip(walks.items(), (0, 1), strict=False):
        for k, motion in enumerate(MOTION_ORDER[convention]):
            ends = poses_along_arm[k : k + 2, :3, 3]
            colour, mark = {TRANSLATE_X: (ORANGE, "a"), TRANSLATE_Z: (VIOLET, "d")}.get(motion, (INK, ""))
            if mark and np.ptp(ends, axis=0).any():
                canvas.line(ends, colour if k < done else PALE_GREY, 3.0, "-" if k < done else ":", level=3)
                canvas.label(ends.mean(axis=0), mark, colour if k < done else GREY)
        joint = poses_along_arm[0] if convention == "standard" else poses_along_arm[4]
        ends = joint[:3, 3] + np.outer((-0.55 * size, 0.7 * size), joint[:3, 2])
        canvas.line(ends, VIOLET, 1.2, "--", level=2)
        canvas.label(ends[1], "axis i", VIOLET, size=9)
        canvas.triad(poses_along_arm[4], "", 0.3 * size, (PALE_GREY, PALE_GREY, PALE_GREY), level=1)
        canvas.triad(poses_along_arm[0], "i-1", 0.3 * size)
        if done:
            canvas.triad(poses_along_arm[done], "i" if done == 4 else "", 0.4 * size)
        canvas.label(poses_along_arm[0, :3, 3], convention, INK, [(36, -44), (36, -54)], 11)
        last = MOTION_NAMES[MOTION_ORDER[convention][done - 1]] if done else "nothing yet"
        place, z = poses_along_arm[done, :3, 3] - side * apart, poses_along_arm[done, :3, 2]
        said.append(
            f"{convention.capitalize()}: {last}; the frame is at {vector_text(place)}, its z along {vector_text(z)}."
        )
    head = "One DH row, two conventions" if len(walks) > 1 else "One DH row"
    return canvas.picture(f"{head}, motion {done} of 4. {' '.join(said)}", caption)


def poses_along_arm(rows: ArrayLike) -> Array:
    """The stops of Z_1 X_1 Z_2 X_2 ... along an arm given by standard rows, (2 m + 1, 4, 4).

    After Z_i stands the modified convention's frame i, after X_i the standard one's.

    >>> poses_along_arm([[0.4, 0, 0.1, 0]])[:, :3, 3]
    array([[0. , 0. , 0. ],
           [0. , 0. , 0.1],
           [0.4, 0. , 0.1]])
    """
    stops = [np.eye(4)]
    for a, alpha, d, theta in validation.vectors(rows, "rows", 4):
        stops.append(stops[-1] @ dh_transform(0, 0, d, theta, convention="standard"))
        stops.append(stops[-1] @ dh_transform(a, alpha, 0, 0, convention="standard"))
    return np.array(stops)


def draw_zx_factors(rows: ArrayLike, pieces: int, caption: str = "") -> Picture:
    """Draw the walk Z_1 X_1 Z_2 X_2 ... along an arm up to a piece, with the frames at which each convention stops.

    rows    (m, 4) standard rows a, alpha, d, theta
    pieces  how many of the 2 m pieces are walked

    A piece Z runs along a joint axis, violet; a piece X along a common normal, orange. A frame {i mod} stands where the
    modified convention ends its row i, after Z_i; a frame {i std} where the standard one does, after X_i.

    Raises ValueError for more pieces than there are, and for less than none.

    >>> draw_zx_factors([[0.4, 0, 0.1, 0]], 2).alt
    'The walk Z1 X1. {0} at (0, 0, 0); {1 mod} at (0, 0, 0.1); {1 std} at (0.4, 0, 0.1).'
    """
    stops = poses_along_arm(rows)
    if pieces not in range(len(stops)):
        raise ValueError(f"pieces counts Z_1, X_1, Z_2, ..., 0 to {len(stops) - 1}; got {pieces!r}.")
    names = ["0", *(f"{i // 2 + 1} {'std' if i % 2 else 'mod'}" for i in range(len(stops) - 1))]
    origins = stops[:, :3, 3]
    canvas = Canvas(origins)
    canvas.floor(origins)
    canvas.line(origins, PALE_GREY, 4.0, level=1)
    _axes(canvas, stops)
    for k in range(pieces):
        if np.ptp(origins[k : k + 2], axis=0).any():
            canvas.line(origins[k : k + 2], ORANGE if k % 2 else VIOLET, 4.0, level=3)
            canvas.label(origins[k : k + 2].mean(axis=0), f"${'XZ'[k % 2 == 0]}_{k // 2 + 1}$", INK)
    for k in range(pieces + 1):
        canvas.triad(stops[k], names[k], (0.2 if k % 2 else 0.15) * canvas.size)
    said = "; ".join(f"{{{names[k]}}} at {vector_text(origins[k])}" for k in range(pieces + 1))
    return canvas.picture(f"The walk{_pieces(pieces)}. {said}.", caption)


def _axes(canvas: Canvas, stops: Array) -> None:
    """The joint axes as dashed lines: each runs through the stop before Z_i and the one after it."""
    for i, T in enumerate(stops[1::2], start=1):
        low, high = -0.45 * canvas.size, 0.3 * canvas.size
        ends: Sequence[Array] = [T[:3, 3] + far * T[:3, 2] for far in (low, high)]
        canvas.line(ends, VIOLET, 1.2, "--", level=2)
        canvas.label(ends[0], f"axis {i}", VIOLET, size=9)


def _pieces(count: int) -> str:
    return "".join(f" {'X' if k % 2 else 'Z'}{k // 2 + 1}" for k in range(count)) or " before its first piece"
