"""Players of Denavit-Hartenberg: the motions of a row, the factors along an arm, and the steps of an assignment, as stops.

The page treats motions as an arm whose joints they are, each about or along an axis that the motions before have moved. Therefore
the scene graph that moves a robot also plays a row, in the order of its convention.
"""

from collections.abc import Sequence
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.table import Convention, DHTable, format_rows, validate_convention
from kinlib.rigid.lie import adjoint, exp, homogeneous
from kinlib.view.drawing.canvas import Canvas, view_axes
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.frame_assignment import assignment_stop, axis_ends, draw_assignment, visible_features
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.figures.parts import Part, draw_parts, frame_part, line_part, turn_part
from kinlib.view.viewer.scene import bare_scene, room
from kinlib.view.viewer.steps import Steps, Stop, frame_arm

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

    @property
    def value(self) -> float:
        """The value of the joint that makes this motion: its angle, or else its distance."""
        return self.angle if abs(self.angle) > tolerances.UNIT_LENGTH_TOL else self.distance


class Track(NamedTuple):
    """Motions one after the other.

    spans  the axes that are drawn: the name, and the numbers of motions done before and after which the frame is on it
    names  for each number of motions done, the index and the name of the frame that is then reached
    """

    title: str
    motions: Sequence[Motion]
    spans: Sequence[tuple[str, int, int]]
    names: dict[int, tuple[str, str]]

    def poses(self, start: Array) -> Array:
        """Return the pose of the frame after 0, 1, ..., m motions from a start, (m + 1, 4, 4)."""
        return np.array([*accumulate((exp(motion.twist) for motion in self.motions), np.matmul, initial=start)])


def play_row(row: ArrayLike, *, convention: Convention | None = None, after: Any = None) -> Steps:
    """Play the four motions of a DH row in the order of one convention, or of both side by side.

    row         (4,) a, alpha, d, theta, in metres and radians
    convention  None shows both conventions, with the same four numbers
    after       a question; the picture stays covered until a prediction is committed

    Raises ValueError if row does not have shape (4,), or the convention is unknown.

    >>> player = play_row([0.8, 0.6, 0.6, 1.4], convention="standard")
    >>> player.at = 2
    >>> player.alt
    'Motions that move a frame: 2 of 4 done. The moving frame, standard convention, is at (0, 0, 0.6), x along (0.17, 0.985, 0), ...'
    """
    values = validation.vectors(row, "row", 4)
    if values.ndim != 1:
        raise ValueError(f"row must be one row, of shape (4,); got {values.shape}. For several rows, use play_walk.")
    shown: list[Convention] = list(MOTIONS) if convention is None else [validate_convention(convention)]
    names = {0: ("i−1", ""), 4: ("i", "")}
    return _player([Track(name, _row_motions(values, name), AXIS_SPANS[name], names) for name in shown], after)


def _row_motions(row: Array, convention: Convention) -> list[Motion]:
    values, motions = dict(zip(("a", "alpha", "d", "theta"), row.tolist(), strict=True)), []
    for name, symbol, text in MOTIONS[convention]:
        value, rotates = values[name], symbol[0] == "R"
        shown = f"{np.degrees(value):.4g}°" if rotates else f"{value:.4g} m"
        told = text.format(shown.replace("-", "−"))
        motions.append(Motion(symbol[2], value * rotates, value * (not rotates), symbol, name, told))
    return motions


def play_walk(rows: ArrayLike, *, after: Any = None) -> Steps:
    """Play the product Z_1 X_1 Z_2 X_2 ... along an arm, with the frames of both conventions.

    rows   (m, 4) standard rows a, alpha, d, theta; each is two factors, and each factor is one screw motion
    after  a question; the picture stays covered until a prediction is committed

    The pose after Z_i is frame i of the modified convention, the pose after X_i is frame i of the standard one.

    Raises ValueError if rows does not have shape (m, 4).

    >>> player = play_walk([[0.4, 0, 0.1, 0]])
    >>> player.at = 2
    >>> player.alt
    'Motions that move a frame: 2 of 2 done. The moving frame is at (0.4, 0, 0.1), x along x, y along y, z along z. Reached: {0} at ...'
    """
    motions, spans, names = [], [], {0: ("0", "0")}
    for i, (a, alpha, d, theta) in enumerate(np.atleast_2d(validation.vectors(rows, "rows", 4)), start=1):
        along, across = f"Z_{i}: along and about the axis of joint {i}.", f"X_{i}: along and about the common normal."
        motions += [
            Motion("z", theta, d, f"Z_{i}", f"Z{i}", f"{along} Frame {i} of the modified convention is here."),
            Motion("x", alpha, a, f"X_{i}", f"X{i}", f"{across} Frame {i} of the standard convention is here."),
        ]
        spans.append((f"axis {i}", 2 * i - 2, 2 * i - 1))
        names |= {2 * i - 1: (f"{i}", f"{i} mod"), 2 * i: (f"{i}", f"{i} std")}
    return _player([Track("", motions, spans, names)], after)


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
        return crop([draw_assignment(assignments[player.variant], int(player.at))])[0]

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


def _player(tracks: Sequence[Track], after: Any) -> Steps:
    """Return the player of tracks side by side: the moving frame of each, the ways it has made, and the frames it has reached."""
    count = len(tracks[0].motions)
    around = np.concatenate([track.poses(np.eye(4))[:, :3, 3] for track in tracks])
    size = max(float(np.ptp(around, axis=0).max()), 0.2)
    right = view_axes("default")[1][0]
    starts = [homogeneous(np.eye(3), 1.9 * k * size * right) for k in range(len(tracks))]
    poses = np.array([track.poses(start) for track, start in zip(tracks, starts, strict=True)])
    still: list[Part] = []
    for track, own in zip(tracks, poses, strict=True):
        still += [_axis(own[first], own[last], name, size) for name, first, last in track.spans]
        still.append(frame_part(own[-1], "Oxyz", length=0.9 * FRAME_LENGTH, strong=False))
        if len(tracks) > 1:
            still.append({"kind": "name", "at": (own[0, :3, 3] - (0, 0, 0.5 * size)).tolist(), "text": track.title})
    stops = []
    for k in range(count + 1):
        merged = [_track_stop(*one, k) for one in zip(tracks, poses, strict=True)]
        stop: Stop = {key: [x for one in merged for x in one[key]] for key in merged[0] if key != "alt"}
        stop["alt"] = f"Motions that move a frame: {k} of {count} done. {' '.join(one['alt'] for one in merged)}"
        stop["q"] = [motion.value * (i < k) for track in tracks for i, motion in enumerate(track.motions)]
        stops.append(stop | {"reached": k in tracks[0].names})
    arms = [
        frame_arm(start, [adjoint(start) @ motion.twist / (motion.value or 1) for motion in track.motions], k * count)
        for k, (track, start) in enumerate(zip(tracks, starts, strict=True))
    ]
    tips = (poses[..., :3, 3, None] + FRAME_LENGTH * size * poses[..., :3, :3]).swapaxes(-1, -2).reshape(-1, 3)
    points = np.array([*(part[end] for part in still if part["kind"] == "line" for end in ("from", "to")), *tips])
    scene = {
        "name": "a row of a DH table",
        "size": size,
        "arms": arms,
        "room": room(points, 0.1 * size) | {"constant": True},
        "floor": float(points[:, 2].min()) - 0.1 * size,
        "offered": [],
    }
    product = [
        {
            "title": f"{track.title} convention" * bool(track.title),
            "symbols": [motion.symbol for motion in track.motions],
        }
        for track in tracks
    ]
    mode = {
        "variants": {"": {"stops": stops}},
        "name": "motion",
        "pace": 1100,
        "movers": [""] * len(tracks),
        "length": FRAME_LENGTH,
        "still": still,
        "product": product,
    }

    def draw(player: Steps) -> Picture:
        canvas = Canvas(points)
        stop, k = player.stop, player.stops.index(player.stop)
        done = [part for passed in player.stops[:k] for part in (*passed["ways"], *passed["turns"])]
        moving = [] if stop["reached"] else [frame_part(own[k], "Oxyz", length=FRAME_LENGTH) for own in poses]
        draw_parts(canvas, [*still, *done, *stop["parts"], *moving], size)
        return canvas.picture(player.alt, cropped=True)

    return Steps(scene, mode, draw, after=after)


def _track_stop(track: Track, poses: Array, k: int) -> Stop:
    """Return what a track shows after k motions; its ways and turns are those of the motion that follows."""
    start, here = poses[0, :3, 3], poses[k]
    parts, places = [], []
    for reached, (sub, name) in track.names.items():
        if reached <= k:
            T, length = poses[reached], FRAME_LENGTH * (1 if reached else 0.9)
            shown = name if " " in name else ""
            parts.append(frame_part(T, "Oxz", sub=sub, name=shown, length=length, strong=reached == k))
            places.append(f"{{{name or sub}}} at {vector_text(T[:3, 3] - start)}")
    ways, turns = [], []
    for motion in track.motions[k : k + 1]:
        if motion.distance:
            colour, name = ("axis", "d") if motion.axis == "z" else ("normal", "a")
            name = name if motion.name in "da" else motion.name
            ways.append(line_part(here[:3, 3], poses[k + 1, :3, 3], colour, name=name, width=4))
        if abs(motion.angle) > 0.01:
            turns.append(
                turn_part(here, motion.axis, motion.angle, motion.distance, "" if motion.distance else motion.name)
            )
    of = f", {track.title} convention," if track.title else ""
    moving = frame_text(("", homogeneous(here[:3, :3], here[:3, 3] - start)))
    return {
        "texts": [track.motions[k - 1].text if k else "No motion is complete yet: the frame is at its start."],
        "parts": parts,
        "ways": ways,
        "turns": turns,
        "alt": f"{moving.replace('Frame {}', f'The moving frame{of} is')} Reached: {'; '.join(places)}.",
    }
