"""The row player: the motions of a DH row, which move a frame one after the other from {i-1} to {i}.

The page treats a row as an arm whose joints are the motions, each about or along an axis that the motions before have moved.
Therefore the scene graph that moves a robot also plays a row, in the order of its convention.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention, validate_convention
from kinlib.rigid.lie import adjoint
from kinlib.view.drawing.canvas import view_axes
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.dh_row_motions import (
    MOTION_ORDER,
    ROTATE_X,
    ROTATE_Z,
    TRANSLATE_X,
    TRANSLATE_Z,
    draw_row_motions,
    draw_zx_factors,
    poses_along_arm,
    poses_along_row,
)
from kinlib.view.figures.dh_table import draw_row
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

VIEW_RADIUS_SHARE = {1: 0.94, 2: 0.79}
"""The radius in view, as a share of the sphere around all that is drawn, for one track and for two side by side."""


class RowPlayer(ViewerBase):
    """Motions on the page. Make one with `play_row` or `play_walk`.

    done  the number of motions carried out; a fraction is the part of the next motion
    """

    done = traitlets.Float(0.0).tag(sync=True)
    _set_by_reader = ("done",)

    def __init__(self, tracks: Sequence[dict[str, Any]], draw: Callable[[int], Picture]) -> None:
        self.draw, self.motions = draw, len(tracks[0]["motions"])
        rest = np.zeros(len(tracks) * self.motions)
        mode = {"kind": "row", "tracks": list(tracks)}
        super().__init__(scene=_scene(tracks), q=rest, start=rest, shown=[], readout=False, mode=mode)

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
        return crop([self.draw(round(self.done))])[0]


def play_row(row: ArrayLike, *, convention: Convention | None = None, after: Any = None) -> RowPlayer:
    """Play the four motions of a DH row in the order of one convention, or of both side by side.

    row         (4,) a, alpha, d, theta, in metres and radians
    convention  None shows both conventions, with the same four numbers
    after       a question; the picture stays covered until a prediction is committed

    Raises ValueError if row does not have shape (4,), or the convention is unknown.

    >>> player = play_row([0.8, 0.6, 0.6, 1.4], convention="standard")
    >>> player.done = 2
    >>> player.alt
    'One row of a table, after theta about z, d along z. The frame is at (0, 0, 0.6), its x along (0.17, 0.985, 0), its z along z.'
    """
    values = validation.vectors(row, "row", 4)
    if values.ndim != 1:
        raise ValueError(f"row must be one row, of shape (4,); got {values.shape}. For several rows, use play_walk.")
    shown: list[Convention] = list(MOTION_ORDER) if convention is None else [validate_convention(convention)]
    size = max(
        float(np.ptp([poses_along_row(values, name)[:, :3, 3] for name in MOTION_ORDER], axis=(0, 1)).max()), 0.2
    )
    apart = 1.9 * size * view_axes("default")[1][0]
    tracks = [_row_track(values, name, k * apart, size) for k, name in enumerate(shown)]

    def draw(count: int) -> Picture:
        return draw_row(values, count) if shown == ["standard"] else draw_row_motions(values, count, conventions=shown)

    player = RowPlayer(tracks, draw)
    player.wait_for(after)
    return player


def play_walk(rows: ArrayLike, *, after: Any = None) -> RowPlayer:
    """Play the product Z_1 X_1 Z_2 X_2 ... along an arm, with the frames of both conventions.

    rows   (m, 4) standard rows a, alpha, d, theta; each is two factors, and each factor is one screw motion
    after  a question; the picture stays covered until a prediction is committed

    Raises ValueError if rows does not have shape (m, 4).

    >>> player = play_walk([[0.4, 0, 0.1, 0]])
    >>> player.done = 2
    >>> player.alt
    'The path Z1 X1. {0} at (0, 0, 0); {1 mod} at (0, 0, 0.1); {1 std} at (0.4, 0, 0.1).'
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
    track = _track("", factors, stops, size, axes=axes, flags=flags)
    player = RowPlayer([track], lambda count: draw_zx_factors(values, count))
    player.wait_for(after)
    return player


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
        "sliders": [],
        "limits": [],
        "room": still_room(points, VIEW_RADIUS_SHARE[len(tracks)]),
        "floor": float(points[:, 2].min()) - 0.1 * tracks[0]["size"],
        "offered": [],
    }
