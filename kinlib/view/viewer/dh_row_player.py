"""The row player: the motions of a DH row, which move a frame one after the other from {i-1} to {i}.

The page treats a row as an arm whose joints are the motions, each about or along an axis that the motions before have moved.
Therefore the scene graph that moves a robot also plays a row, in the order of its convention.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention, dh_transform, validate_convention
from kinlib.rigid.lie import adjoint, homogeneous
from kinlib.view.drawing.canvas import Canvas, view_axes
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.dh_table import (
    MOTION_ORDER,
    ROTATE_X,
    ROTATE_Z,
    TRANSLATE_X,
    TRANSLATE_Z,
    poses_along_row,
)
from kinlib.view.viewer.scene import still_room
from kinlib.view.viewer.viewer import ViewerBase

SYMBOLS = {ROTATE_Z: "R_z(theta)", TRANSLATE_Z: "T_z(d)", TRANSLATE_X: "T_x(a)", ROTATE_X: "R_x(alpha)"}

MOTION_TEXTS: dict[Convention, dict[int, str]] = {
    "standard": {
        ROTATE_Z: "Rotate about z by theta, {value}: x becomes parallel to the common normal.",
        TRANSLATE_Z: "Translate along z by d, {value}: the origin moves to the foot of the normal.",
        TRANSLATE_X: "Translate along x by a, {value}: along the common normal, to the next axis.",
        ROTATE_X: "Rotate about x by alpha, {value}: z becomes parallel to axis i+1. This is frame i.",
    },
    "modified": {
        ROTATE_X: "Rotate about x by alpha, {value}: z becomes parallel to axis i.",
        TRANSLATE_X: "Translate along x by a, {value}: along the common normal, to axis i.",
        ROTATE_Z: "Rotate about z by theta, {value}: the rotation of joint i about its own axis.",
        TRANSLATE_Z: "Translate along z by d, {value}: to the foot of the next normal. This is frame i.",
    },
}
"""The text of each motion of a row, in each convention."""

AXIS_NAMES: dict[Convention, tuple[str, str]] = {"standard": ("axis i", "axis i+1"), "modified": ("axis i−1", "axis i")}
"""The axes on which the z of frame i-1 and of frame i lie."""

FRAME_SHARE = 0.3
"""The length of the axes of a frame in a still picture, as a share of the size of the motions."""

VIEW_RADIUS_SHARE = {1: 0.94, 2: 0.79}
"""The radius in view, as a share of the sphere around all that is drawn, for one track and for two side by side."""


class RowPlayer(ViewerBase):
    """Motions on the page. Make one with `play_row` or `play_walk`.

    done  the number of motions carried out; a fraction is the part of the next motion
    """

    done = traitlets.Float(0.0).tag(sync=True)
    _set_by_reader = ("done",)

    def __init__(self, tracks: Sequence[dict[str, Any]], after: Any) -> None:
        self.motions = len(tracks[0]["motions"])
        rest = np.zeros(len(tracks) * self.motions)
        super().__init__(_scene(tracks), rest, mode={"kind": "row", "tracks": list(tracks)}, after=after)

    @traitlets.validate("done")
    def _validate_done(self, proposal: Any) -> float:
        done: float = proposal["value"]
        if not 0 <= done <= self.motions:
            raise ValueError(f"done must be the number of motions carried out, 0 to {self.motions}; got {done!r}.")
        return done

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        return self._picture().alt

    def _picture(self) -> Picture:
        return draw_tracks(self.mode["tracks"], round(self.done))


def play_row(row: ArrayLike, *, convention: Convention | None = None, after: Any = None) -> RowPlayer:
    """Play the four motions of a DH row in the order of one convention, or of both side by side.

    row         (4,) a, alpha, d, theta, in metres and radians
    convention  None shows both conventions, with the same four numbers
    after       a question; the picture stays covered until a prediction is committed

    Raises ValueError if row does not have shape (4,), or the convention is unknown.

    >>> player = play_row([0.8, 0.6, 0.6, 1.4], convention="standard")
    >>> player.done = 2
    >>> player.alt
    'Motions that move a frame: 2 of 4 done. The moving frame, standard convention, is at (0, 0, 0.6), x along (0.17, 0.985, 0), ...'
    """
    values = validation.vectors(row, "row", 4)
    if values.ndim != 1:
        raise ValueError(f"row must be one row, of shape (4,); got {values.shape}. For several rows, use play_walk.")
    shown: list[Convention] = list(MOTION_ORDER) if convention is None else [validate_convention(convention)]
    size = max(
        float(np.ptp([poses_along_row(values, name)[:, :3, 3] for name in MOTION_ORDER], axis=(0, 1)).max()), 0.2
    )
    apart = 1.9 * size * view_axes("default")[1][0]
    return RowPlayer([_row_track(values, name, k * apart, size) for k, name in enumerate(shown)], after)


def play_walk(rows: ArrayLike, *, after: Any = None) -> RowPlayer:
    """Play the product Z_1 X_1 Z_2 X_2 ... along an arm, with the frames of both conventions.

    rows   (m, 4) standard rows a, alpha, d, theta; each is two factors, and each factor is one screw motion
    after  a question; the picture stays covered until a prediction is committed

    Raises ValueError if rows does not have shape (m, 4).

    >>> player = play_walk([[0.4, 0, 0.1, 0]])
    >>> player.done = 2
    >>> player.alt
    'Motions that move a frame: 2 of 2 done. The moving frame is at (0.4, 0, 0.1), x along x, y along y, z along z. Reached: {0} at ...'
    """
    values = np.atleast_2d(validation.vectors(rows, "rows", 4))
    stops = poses_along_arm(values)
    size = max(float(np.ptp(stops[:, :3, 3], axis=0).max()), 0.2)
    factors, axes, flags, start = [], [], [_flag(0, "0", stops[0])], np.eye(4)
    for i, (a, alpha, d, theta) in enumerate(values, start=1):
        along, across = f"Z_{i}: along and about the axis of joint {i}.", f"X_{i}: along and about the common normal."
        factors += [
            _motion(start, "z", (theta, d), f"Z_{i}", f"{along} Frame {i} of the modified convention is here."),
            _motion(start, "x", (alpha, a), f"X_{i}", f"{across} Frame {i} of the standard convention is here."),
        ]
        flags += [_flag(2 * i - 1, f"{i} mod", stops[2 * i - 1]), _flag(2 * i, f"{i} std", stops[2 * i])]
        axes.append(_axis(stops[2 * i - 2], stops[2 * i - 1], f"axis {i}", size))
    return RowPlayer([_track("", factors, stops, size, axes=axes, flags=flags)], after)


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


def draw_tracks(tracks: Sequence[dict[str, Any]], done: int) -> Picture:
    """Draw tracks after some of their motions: axes, the frames that have been reached, and the way of the moving frame.

    done  how many of the motions of each track are carried out

    A translation along x is orange, one along z violet; those still to be carried out are grey. js/modes/dh-row.js draws the
    same, and describes it in the same words.
    """
    stops = np.array([track["stops"] for track in tracks]).reshape(len(tracks), -1, 4, 4)
    origins = stops[..., :3, 3].reshape(-1, 3)
    middle = (origins.min(axis=0) + origins.max(axis=0)) / 2
    canvas = Canvas(middle + 0.72 * (origins - middle))  # no frame extends far beyond the origins
    size, sentences = tracks[0]["size"], []
    for track, poses in zip(tracks, stops, strict=True):
        for line in track["axes"]:
            canvas.line([line["from"], line["to"]], VIOLET, 1.2, "--", level=2)
            canvas.label(line["to"], line["name"], VIOLET, size=9)
        for k, motion in enumerate(track["motions"]):
            ends = poses[k : k + 2, :3, 3]
            if np.ptp(ends, axis=0).any():
                colour = VIOLET if motion["axis"] == "z" else ORANGE
                canvas.line(ends, colour if k < done else PALE_GREY, 3.0, "-" if k < done else ":", level=3)
                name = motion["symbol"].removeprefix(f"T_{motion['axis']}").strip("()")
                canvas.label(ends.mean(axis=0), f"${name}$", colour if k < done else GREY)
        start = poses[0, :3, 3]
        reached = {flag["name"]: poses[flag["after"]] for flag in track["flags"] if flag["after"] <= done}
        for name, T in reached.items():
            canvas.triad(T, name, FRAME_SHARE * size)
        canvas.triad(poses[-1], "", FRAME_SHARE * size, (PALE_GREY,) * 3, level=1)
        if done not in {flag["after"] for flag in track["flags"]}:
            canvas.triad(poses[done], "", 1.3 * FRAME_SHARE * size)
        if track["title"]:
            canvas.label(start, track["title"], INK, [(36, -44), (36, -54)])
        of = f", {track['title']} convention," if track["title"] else ""
        moving = frame_text(("", homogeneous(poses[done, :3, :3], poses[done, :3, 3] - start)))
        places = "; ".join(f"{{{name}}} at {vector_text(T[:3, 3] - start)}" for name, T in reached.items())
        sentences.append(f"{moving.replace('Frame {}', f'The moving frame{of} is')} Reached: {places}.")
    count = len(tracks[0]["motions"])
    return canvas.picture(f"Motions that move a frame: {done} of {count} done. {' '.join(sentences)}", cropped=True)


def _row_track(row: Array, convention: Convention, place: Array, size: float) -> dict[str, Any]:
    start = np.eye(4)
    start[:3, 3] = place
    stops = start @ poses_along_row(row, convention)
    motions = []
    for kind in MOTION_ORDER[convention]:
        value, axis = float(row[kind]), "x" if kind in (TRANSLATE_X, ROTATE_X) else "z"
        way = (value, 0.0) if kind in (ROTATE_X, ROTATE_Z) else (0.0, value)
        shown = f"{np.degrees(value):.4g}°" if kind in (ROTATE_X, ROTATE_Z) else f"{value:.4g} m"
        text = MOTION_TEXTS[convention][kind].format(value=shown.replace("-", "−"))
        motions.append(_motion(start, axis, way, SYMBOLS[kind], text))
    # The d of a standard row runs along the axis where it starts, that of a modified one where it ends.
    joint = [_axis(stops[0], stops[2], "", size), _axis(stops[4], stops[4], "", size)]
    if convention == "modified":
        joint = [_axis(stops[0], stops[0], "", size), _axis(stops[2], stops[4], "", size)]
    axes = [
        {**line, "name": name, "joint": name == "axis i"}
        for line, name in zip(joint, AXIS_NAMES[convention], strict=True)
    ]
    flags = [_flag(0, "i-1", stops[0]), _flag(4, "i", stops[4])]
    return _track(convention, motions, stops, size, axes=axes, flags=flags)


def _track(title: str, motions: list[dict[str, Any]], stops: Array, size: float, **drawn: Any) -> dict[str, Any]:
    """Return a track as data; drawn are its axes and the flags at its poses."""
    poses = [(T + 0.0).ravel().tolist() for T in stops]
    return {"title": title, "size": size, "stops": poses, "motions": motions, **drawn}


def _motion(start: Array, axis: str, way: tuple[float, float], symbol: str, text: str) -> dict[str, Any]:
    """Return a motion about and along x or z of the moving frame as a joint: its screw in the start pose, and its joint value."""
    unit, (angle, distance) = np.eye(3)["xz".index(axis) * 2], way
    value = angle if abs(angle) > tolerances.UNIT_LENGTH_TOL else distance
    screw = np.concatenate([angle * unit, distance * unit]) / value if value else np.concatenate([0 * unit, unit])
    return {
        "screw": (adjoint(start) @ screw).tolist(),
        "value": value,
        "axis": axis,
        "angle": angle,
        "travel": distance / value if value else 0.0,
        "symbol": symbol,
        "text": text,
    }


def _axis(one: Array, other: Array, name: str, size: float) -> dict[str, Any]:
    """Return the line along the z of a frame, long enough to contain two origins."""
    z, distance = one[:3, 2], float((other - one)[:3, 3] @ one[:3, 2])
    ends = [one[:3, 3] + along * z for along in (min(0.0, distance) - 0.3 * size, max(0.0, distance) + 0.6 * size)]
    return {"from": ends[0].tolist(), "to": ends[1].tolist(), "name": name, "joint": True}


def _flag(after: int, name: str, pose: Array) -> dict[str, Any]:
    return {"after": after, "name": name, "pose": (pose + 0.0).ravel().tolist()}


def _scene(tracks: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the scene of the motions as arms, with a view that contains all poses and axes."""
    ends = [end for track in tracks for line in track["axes"] for end in (line["from"], line["to"])]
    stops = [np.reshape(stop, (4, 4))[:3, 3] for track in tracks for stop in track["stops"]]
    points = np.array([*ends, *stops])
    count = len(tracks[0]["motions"])
    return {
        "name": "a row of a DH table",
        "size": tracks[0]["size"],
        "arms": [
            {
                "columns": list(range(k * count, (k + 1) * count)),
                "joints": [{"screw": motion["screw"], "point": [0.0, 0.0, 0.0]} for motion in track["motions"]],
                "home": track["stops"][0],
            }
            for k, track in enumerate(tracks)
        ],
        "room": still_room(points, VIEW_RADIUS_SHARE[len(tracks)]),
        "floor": float(points[:, 2].min()) - 0.1 * tracks[0]["size"],
        "offered": [],
    }
