"""Drawings of DH rows as motions: the four motions of a row in both conventions, and the product Z_1 X_1 Z_2 X_2 ... that both share."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention, dh_transform
from kinlib.view.drawing.canvas import Canvas, view_axes
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

TRANSLATE_X, ROTATE_X, TRANSLATE_Z, ROTATE_Z = range(4)
"""The columns of a row, a, alpha, d, theta, named by their motions."""

MOTION_ORDER: dict[Convention, tuple[int, ...]] = {
    "standard": (ROTATE_Z, TRANSLATE_Z, TRANSLATE_X, ROTATE_X),
    "modified": (ROTATE_X, TRANSLATE_X, ROTATE_Z, TRANSLATE_Z),
}
"""The four motions in the order of each convention, each about or along an axis of the moving frame."""

MOTION_NAMES = ("along x by a", "about x by alpha", "along z by d", "about z by theta")


def poses_along_row(row: ArrayLike, convention: Convention) -> Array:
    """Return the pose of a frame after 0, 1, ..., 4 motions of a DH row, (5, 4, 4).

    row  (4,) a, alpha, d, theta, in metres and radians

    Raises ValueError if row does not have shape (4,) or the convention is unknown.

    >>> poses_along_row([0.4, 0, 0, np.pi / 2], "standard")[3, :3, 3].round(3) + 0.0
    array([0. , 0.4, 0. ])
    """
    values = validation.vectors(row, "row", 4)
    dh_transform(*values, convention=convention)  # raises ValueError if the convention is unknown
    stops = [np.eye(4)]
    for motion in MOTION_ORDER[convention]:
        stops.append(stops[-1] @ dh_transform(*np.where(np.arange(4) == motion, values, 0.0), convention=convention))
    return np.array(stops)


def draw_row_motions(row: ArrayLike, done: int, *, conventions: Sequence[Convention] = tuple(MOTION_ORDER)) -> Picture:
    """Draw a frame that is moved by the motions of one DH row, standard on the left and modified on the right.

    row          (4,) a, alpha, d, theta
    done         how many of the four motions are carried out
    conventions  the conventions that are drawn

    Both start from a frame {i-1} and use the same numbers. Motions still to be carried out are grey. The translation along x
    is orange and labelled a, the one along z is violet and labelled d. The dashed line is the axis of joint i, which is at the
    start of the row in the standard convention and at its end in the modified one.

    Raises ValueError if done is not one of 0, 1, ..., 4.

    >>> draw_row_motions([0.5, 1.0, 0.4, 0.5], 1).alt          # doctest: +NORMALIZE_WHITESPACE
    'One DH row, two conventions, motion 1 of 4. Standard: about z by theta; the frame is at (0, 0, 0), its z along
    (0, 0, 1). Modified: about x by alpha; the frame is at (0, 0, 0), its z along (0, -0.841, 0.54).'
    """
    if done not in range(5):
        raise ValueError(f"done must be the number of motions carried out, 0 to 4; got {done!r}.")
    tracks = {convention: poses_along_row(row, convention) for convention in conventions}
    size = max(float(np.ptp(np.concatenate(list(tracks.values()))[:, :3, 3], axis=0).max()), 0.2)
    apart = 2.2 * size * view_axes("default")[1][0]
    for poses, side in zip(tracks.values(), (0, 1), strict=False):
        poses[:, :3, 3] += side * apart
    seen = np.concatenate([poses[:, :3, 3] for poses in tracks.values()])
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    # No axis or frame extends far beyond the origins, so a smaller margin is enough.
    canvas = Canvas(middle + 0.72 * (seen - middle))
    sentences = []
    for (convention, poses), side in zip(tracks.items(), (0, 1), strict=False):
        for k, motion in enumerate(MOTION_ORDER[convention]):
            ends = poses[k : k + 2, :3, 3]
            colour, mark = {TRANSLATE_X: (ORANGE, "a"), TRANSLATE_Z: (VIOLET, "d")}.get(motion, (INK, ""))
            if mark and np.ptp(ends, axis=0).any():
                canvas.line(ends, colour if k < done else PALE_GREY, 3.0, "-" if k < done else ":", level=3)
                canvas.label(ends.mean(axis=0), mark, colour if k < done else GREY)
        joint = poses[0] if convention == "standard" else poses[4]
        ends = joint[:3, 3] + np.outer((-0.55 * size, 0.7 * size), joint[:3, 2])
        canvas.line(ends, VIOLET, 1.2, "--", level=2)
        canvas.label(ends[1], "axis i", VIOLET, size=9)
        canvas.triad(poses[4], "", 0.3 * size, (PALE_GREY, PALE_GREY, PALE_GREY), level=1)
        canvas.triad(poses[0], "i-1", 0.3 * size)
        if done:
            canvas.triad(poses[done], "i" if done == 4 else "", 0.4 * size)
        canvas.label(poses[0, :3, 3], convention, INK, [(36, -44), (36, -54)], 11)
        last_motion = MOTION_NAMES[MOTION_ORDER[convention][done - 1]] if done else "no motion yet"
        place, z = poses[done, :3, 3] - side * apart, poses[done, :3, 2]
        sentences.append(
            f"{convention.capitalize()}: {last_motion}; the frame is at {vector_text(place)}, its z along {vector_text(z)}."
        )
    head = "One DH row, two conventions" if len(tracks) > 1 else "One DH row"
    return canvas.picture(f"{head}, motion {done} of 4. {' '.join(sentences)}")


def poses_along_arm(rows: ArrayLike) -> Array:
    """Return the poses after each factor of Z_1 X_1 Z_2 X_2 ..., for an arm given by standard rows, (2 m + 1, 4, 4).

    The pose after Z_i is frame i of the modified convention, the pose after X_i is frame i of the standard one.

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


def draw_zx_factors(rows: ArrayLike, factors: int) -> Picture:
    """Draw the first factors of Z_1 X_1 Z_2 X_2 ... as a path along an arm, with the frames of both conventions.

    rows     (m, 4) standard rows a, alpha, d, theta
    factors  how many of the 2 m factors are drawn

    A factor Z runs along a joint axis, in violet; a factor X along a common normal, in orange. The frame {i mod} is where row i
    of the modified convention ends, after Z_i; the frame {i std} is where that of the standard one ends, after X_i.

    Raises ValueError if factors is not one of 0, 1, ..., 2 m.

    >>> draw_zx_factors([[0.4, 0, 0.1, 0]], 2).alt
    'The path Z1 X1. {0} at (0, 0, 0); {1 mod} at (0, 0, 0.1); {1 std} at (0.4, 0, 0.1).'
    """
    stops = poses_along_arm(rows)
    if factors not in range(len(stops)):
        raise ValueError(
            f"factors must be the number of factors Z_1, X_1, Z_2, ..., 0 to {len(stops) - 1}; got {factors!r}."
        )
    names = ["0", *(f"{i // 2 + 1} {'std' if i % 2 else 'mod'}" for i in range(len(stops) - 1))]
    origins = stops[:, :3, 3]
    canvas = Canvas(origins)
    canvas.floor(origins)
    canvas.line(origins, PALE_GREY, 4.0, level=1)
    _axes(canvas, stops)
    for k in range(factors):
        if np.ptp(origins[k : k + 2], axis=0).any():
            canvas.line(origins[k : k + 2], ORANGE if k % 2 else VIOLET, 4.0, level=3)
            canvas.label(origins[k : k + 2].mean(axis=0), f"${'XZ'[k % 2 == 0]}_{k // 2 + 1}$", INK)
    for k in range(factors + 1):
        canvas.triad(stops[k], names[k], (0.2 if k % 2 else 0.15) * canvas.size)
    places = "; ".join(f"{{{names[k]}}} at {vector_text(origins[k])}" for k in range(factors + 1))
    return canvas.picture(f"The path{_factor_names(factors)}. {places}.")


def _axes(canvas: Canvas, stops: Array) -> None:
    """Draw the joint axes as dashed lines, each through the origins before and after Z_i."""
    for i, T in enumerate(stops[1::2], start=1):
        low, high = -0.45 * canvas.size, 0.3 * canvas.size
        ends: Sequence[Array] = [T[:3, 3] + far * T[:3, 2] for far in (low, high)]
        canvas.line(ends, VIOLET, 1.2, "--", level=2)
        canvas.label(ends[0], f"axis {i}", VIOLET, size=9)


def _factor_names(count: int) -> str:
    return "".join(f" {'X' if k % 2 else 'Z'}{k // 2 + 1}" for k in range(count)) or " before its first factor"
