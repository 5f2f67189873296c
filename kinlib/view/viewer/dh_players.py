"""Players of Denavit-Hartenberg: the motions of a row or of other factors, and the steps of an assignment, as stops.

A motion is a screw about or along an axis that the motions before have moved, so the page moves the frame by its exponential.
"""

from collections.abc import Mapping, Sequence
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.table import Convention, DHTable, format_rows, validate_convention
from kinlib.rigid.lie import exp
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import pose_text
from kinlib.view.figures.frames import assignment_stop, axis_ends, draw_assignment, visible_features
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.figures.parts import Part, draw_parts_about, frame_part, line_part, tips
from kinlib.view.viewer.scene import bare_scene, scene_of_parts
from kinlib.view.viewer.steps import Steps, Stop

MOTIONS: dict[Convention, tuple[tuple[str, str, str], ...]] = {
    "standard": (
        ("theta", "R_z(theta)", "Rotate about z by theta, {}: x becomes parallel to the common normal."),
        ("d", "T_z(d)", "Translate along z by d, {}: the origin moves to the foot of the normal."),
        ("a", "T_x(a)", "Translate along x by a, {}: along the common normal, to the next axis."),
        ("alpha", "R_x(alpha)", "Rotate about x by alpha, {}: z becomes parallel to axis i+1. This is frame i."),
    ),
    "modified": (
        ("alpha", "R_x(alpha)", "Rotate about x by alpha, {}: z becomes parallel to axis i."),
        ("a", "T_x(a)", "Translate along x by a, {}: along the common normal, to axis i."),
        ("theta", "R_z(theta)", "Rotate about z by theta, {}: the rotation of joint i about its own axis."),
        ("d", "T_z(d)", "Translate along z by d, {}: to the foot of the next normal. This is frame i."),
    ),
}
"""The motions of a row in the order of each convention: the name, the factor and the text, in which the value is still missing."""

AXIS_SPANS: dict[Convention, tuple[tuple[str, int, int], ...]] = {
    "standard": (("axis i", 0, 2), ("axis i+1", 4, 4)),
    "modified": (("axis i−1", 0, 0), ("axis i", 2, 4)),
}
"""The axes on which the z of frame i-1 and of frame i lie, and between which motions the frame moves along them."""

FRAME_LENGTH = 0.34
"""The length of the axes of a frame, as a share of the size of the motions."""


class Motion(NamedTuple):
    """A motion of a frame about and along its own x or z, by an angle in radians and a distance in metres."""

    axis: str
    angle: float
    distance: float
    symbol: str
    name: str
    text: str

    @property
    def twist(self) -> Array:
        """The motion as a twist (6,) in the moving frame."""
        return np.kron([self.angle, self.distance], np.eye(3)["x z".index(self.axis)])


class Track(NamedTuple):
    """Motions one after the other, from the identity.

    spans  the axes that are drawn: the name, and the numbers of motions done before and after which the frame is on it
    names  for each number of motions done, the index and the name of the frame that is then reached
    """

    motions: Sequence[Motion]
    spans: Sequence[tuple[str, int, int]]
    names: dict[int, tuple[str, str]]


def play_row(row: ArrayLike, *, convention: Convention | None = None, after: Any = None) -> Steps:
    """Play the four motions of a DH row in the order of a convention.

    row         (4,) a, alpha, d, theta, in metres and radians
    convention  None lets the reader choose between both, with the same four numbers
    after       a question; the picture stays covered until a prediction is committed

    Raises ValueError if row does not have shape (4,), or the convention is unknown.

    >>> player = play_row([0.8, 0.6, 0.6, 1.4], convention="standard")
    >>> player.at = 2
    >>> player.alt
    'Motions that move a frame: 2 of 4 done. The moving frame, standard convention, is at (0, 0, 0.6), x along (0.17, 0.985, 0), ...'
    """
    values = validation.vectors(row, "row", 4)
    if values.ndim != 1:
        raise ValueError(f"row must be one row, of shape (4,); got {values.shape}.")
    shown: list[Convention] = list(MOTIONS) if convention is None else [validate_convention(convention)]
    names = {0: ("i−1", ""), 4: ("i", "")}
    return play_tracks({name: Track(_row_motions(values, name), AXIS_SPANS[name], names) for name in shown}, after)


def _row_motions(row: Array, convention: Convention) -> list[Motion]:
    values, motions = dict(zip(("a", "alpha", "d", "theta"), row.tolist(), strict=True)), []
    for name, symbol, text in MOTIONS[convention]:
        value, rotates = values[name], symbol[0] == "R"
        shown = f"{np.degrees(value):.4g}°" if rotates else f"{value:.4g} m"
        told = text.format(shown.replace("-", "−"))
        motions.append(Motion(symbol[2], value * rotates, value * (not rotates), symbol, name, told))
    return motions


def play_assignment(chain: Chain, *, convention: Convention, rows: int | None = None, after: Any = None) -> Steps:
    """Show the assignment of DH frames to an arm step by step, forwards and back.

    rows   how many rows of the table are read; the reader finds the others. By default all of them
    after  a question; the arm stays covered until a prediction is committed

    Raises ValueError if the convention is unknown, or a joint is helical.

    >>> player = play_assignment(kl.robots.youbot(), convention="standard")
    >>> player.at = 3
    >>> player.alt[:62]
    'youBot, standard convention, step 4 of 25. O_1 lies on axis 2,'
    """
    validation.instance(chain, "chain", Chain)
    validate_convention(convention)
    assignments = {str(name): assign_frames(chain, convention=name) for name in MOTIONS}
    points, variants = [stations(chain)], {}
    for name, one in assignments.items():
        near, feet = visible_features(one)
        points += [one.frames[near, :3, 3], np.reshape(axis_ends(chain, feet), (-1, 3))]
        count = len(one.steps)
        if rows is not None:  # then the accuracy of the table is left out too
            count = next(k for k, step in enumerate(one.steps) if step.kind == "row") + rows
        table = {"convention": name, "rows": table_cells(one.table)[:rows]}
        variants[name] = {"stops": [assignment_stop(one, k, count) for k in range(count)], "table": table}

    def draw(player: Steps) -> Picture:
        return draw_assignment(assignments[player.variant], int(player.at))

    scene = bare_scene(chain, np.concatenate(points))
    mode = {"variants": variants, "name": "step", "choice": "convention"}
    return Steps(scene, mode, draw, variant=convention, after=after, start=np.zeros(chain.n))


def table_cells(table: DHTable) -> list[list[str]]:
    """Return the rows of a table as the page shows them: a, alpha, d, theta, with q_i for the joint variable."""
    return [[cell.replace("-", "−") for cell in row] for row in format_rows(table, variable="q_{}".format)]


def _axis(one: Array, other: Array, name: str, size: float) -> Part:
    """Return the line along the z of a frame, long enough to contain two origins."""
    z, distance = one[:3, 2], float((other - one)[:3, 3] @ one[:3, 2])
    low, high = (one[:3, 3] + along * z for along in (min(0.0, distance) - 0.3 * size, max(0.0, distance) + 0.6 * size))
    return line_part(low, high, "axis", name=name, dashed=True, tip=True)


def play_tracks(tracks: Mapping[str, Track], after: Any = None) -> Steps:
    """Play motions: the moving frame, the ways it has made, and the frames it has reached.

    tracks  by name; one of them is shown, and the reader chooses which
    after   a question; the picture stays covered until a prediction is committed
    """
    twists = np.array([[motion.twist for motion in track.motions] for track in tracks.values()])
    every = np.array([[*accumulate(exp(own), np.matmul, initial=np.eye(4))] for own in twists])
    size = max(float(np.ptp(every[..., :3, 3], axis=(0, 1)).max()), 0.2)
    variants: dict[str, dict[str, Any]] = {}
    points = [tips(every, FRAME_LENGTH * size)]
    for (name, track), poses in zip(tracks.items(), every, strict=True):
        still = [_axis(poses[first], poses[last], axis, size) for axis, first, last in track.spans]
        points += [np.array([part["from"], part["to"]]) for part in still]
        variants[name] = {
            "stops": [_stop(name, track, poses, k) for k in range(len(poses))],
            "still": [*still, frame_part(poses[-1], "Oxyz", length=0.9 * FRAME_LENGTH, strong=False)],
        }
    shown = np.concatenate(points)

    def draw(player: Steps) -> Picture:
        stop, k = player.stop, player.stops.index(player.stop)
        done = [part for passed in player.stops[:k] for part in passed["ways"]]
        moving = [] if stop["reached"] else [frame_part(np.reshape(stop["pose"], (4, 4)), "Oxyz", length=FRAME_LENGTH)]
        parts = [*variants[player.variant]["still"], *done, *stop["parts"], *moving]
        return draw_parts_about(shown, parts, size, player.alt)

    mode = {"variants": variants, "name": "motion", "choice": "convention", "pace": 1100, "length": FRAME_LENGTH}
    return Steps(scene_of_parts("a row of a DH table", shown, size), mode, draw, after=after)


def _stop(name: str, track: Track, poses: Array, k: int) -> Stop:
    """Return what a track shows after k motions; its way is that of the motion that follows."""
    here, parts = poses[k], []
    for reached, (sub, frame) in track.names.items():
        if reached <= k:
            T, length = poses[reached], FRAME_LENGTH * (1 if reached else 0.9)
            shown = frame if " " in frame else ""
            parts.append(frame_part(T, "Oxz", sub=sub, name=shown, length=length, strong=reached == k))
    ways, following = [], {}
    for motion in track.motions[k : k + 1]:
        following = {name: getattr(motion, name) for name in ("axis", "angle", "distance", "symbol", "name")}
        if motion.distance:
            colour = "axis" if motion.axis == "z" else "normal"
            ways.append(line_part(here[:3, 3], poses[k + 1, :3, 3], colour, name=motion.name, width=4))
    moving = f"The moving frame{f', {name} convention,' if name else ''} is"
    head = f"Motions that move a frame: {k} of {len(track.motions)} done."
    return {
        "text": track.motions[k - 1].text if k else "No motion is complete yet: the frame is at its start.",
        "pose": here.ravel().tolist(),
        "motion": following,
        "reached": k in track.names,
        "parts": parts,
        "ways": ways,
        "alt": f"{head} {moving} {pose_text(here)}.",
    }
