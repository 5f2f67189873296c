"""The player of steps: a list of stops that the reader goes through, forwards and back, in three dimensions.

A stop is {"text", "alt", "parts", ...}: what it says, and what is drawn there (figures.parts). Where stops have joint values "q",
the page interpolates between them; where they have a "pose" and a "motion", a frame moves by it about and along its own x or z to
the next stop. All stops are sent at once, so the page needs no Python.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate, pairwise
from typing import Any, NamedTuple

import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.table import Convention, DHTable, format_rows, validate_convention
from kinlib.rigid.lie import exp
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text, pose_text
from kinlib.view.figures.frames import assignment_stop, axis_ends, draw_assignment, ends_on_axis, visible_features
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.figures.parts import draw_parts_about, frame_part, line_part, tips
from kinlib.view.viewer.pictures import value_text
from kinlib.view.viewer.scene import bare_scene, room, scene_of_parts
from kinlib.view.viewer.viewer import Viewer

AXIS_SHARE, SMALLEST_M = 0.3, 0.3
"""The length of the axes as a share of the extent of the origins, and the least extent, if the frames share an origin."""

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


class Steps(Viewer):
    """Stops on the page. Make one with `play_row`, `play_assignment`, `slide_frames` or `drive`.

    at       the stop that is shown, from 0; a fraction is the share of the way to the next one
    variant  which of several lists of stops is shown, such as a convention
    q        the joint values of that stop, if it has some

    The mode has "variants", {name: {"stops": [stop, ...], ...}}, with as many stops each, and what all stops share: "kind",
    "name" of a stop, "pace" in milliseconds from one to the next, and further data of its player. `draw` makes the picture of the
    stop that is shown; it also has the text alternative of a stop that has none.
    """

    at = traitlets.Float(0.0).tag(sync=True)
    variant = traitlets.Unicode("").tag(sync=True)
    set_by_reader = ("at", "variant")

    def __init__(
        self,
        scene: dict[str, Any],
        mode: Mapping[str, Any],
        draw: Callable[["Steps"], Picture],
        *,
        variant: str = "",
        **settings: Any,
    ) -> None:
        mode = {"kind": "steps", "pace": 0, **mode}
        self._variants: dict[str, Any] = mode["variants"]
        variant = variant or next(iter(self._variants))
        start = self._variants[variant]["stops"][0].get("q", [0.0])
        super().__init__(scene, draw, settings.pop("start", start), mode=mode, variant=variant, **settings)
        self.observe(self._follow, ["at", "variant"])
        self._follow(None)

    def _follow(self, _: Any) -> None:
        self.q = self.stop.get("q", self.q)

    @property
    def stops(self) -> list[dict[str, Any]]:
        """The stops of the variant that is shown."""
        stops: list[dict[str, Any]] = self._variants[self.variant]["stops"]
        return stops

    @property
    def stop(self) -> dict[str, Any]:
        """The stop that is shown, or the last one that was passed."""
        return self.stops[max(0, min(int(self.at + 1e-9), len(self.stops) - 1))]

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        passed = self.at > int(self.at + 1e-9) + 1e-9
        said: str = self.stop["alt"] if "alt" in self.stop else self.picture().alt
        return f"{'On the way to the next stop. ' if passed else ''}{said}"


def slide_frames(
    frames_at: Callable[[Any], Mapping[str, ArrayLike]],
    label: str,
    values: Sequence[Any],
    *,
    caption: Callable[[Any], str] = lambda _: "",
    arrows: bool = False,
    after: Any = None,
) -> Steps:
    """Show frames in three dimensions, with one slider that moves them.

    frames_at  a function from a value to {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame; always the same names
    label      what the values are
    values     the values of the slider, in order
    caption    a function from a value to the caption
    arrows     whether an arrow leads from the origin of each frame to that of the next
    after      a question; the picture stays covered until a prediction is committed

    Raises ValueError if there are no values, or if a frame is not a pose.

    >>> from kinlib.rigid.lie import homogeneous
    >>> shown = slide_frames(lambda x: {"s": np.eye(4), "b": homogeneous(np.eye(3), (x, 0, 0))}, "x (m)", [0.0, 0.5, 1.0])
    >>> shown.at = 1
    >>> shown.alt[-58:]
    'Frame {b} at (0.5, 0, 0), x along x, y along y, z along z.'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    frames = [frames_at(value) for value in values]
    names = list(frames[0])
    poses = np.array([[validation.poses(T, f"frame {name}") for name, T in one.items()] for one in frames]) + 0.0
    origins = poses[..., :3, 3].reshape(-1, 3)
    length = AXIS_SHARE * max(float(np.ptp(origins, axis=0).max()), SMALLEST_M)
    points = np.concatenate([origins, tips(poses, length)])
    size = room(points, 0.0)["radius"]
    stops = []
    for value, shown in zip(values, poses, strict=True):
        said, ends = caption(value), pairwise(shown[:, :3, 3] if arrows else [])
        lines = [line_part(a, b, "quiet", tip=True) for a, b in ends if np.linalg.norm(b - a) > 1e-6 * size]
        told, named = [said], zip(names, shown, strict=True)
        for name, T in named:
            lines.append(frame_part(T, "Oxyz", sub=name if len(name) < 3 else "", name=name, length=length / size))
            told.append(frame_text((name, T)))
        stops.append({"title": value_text(value), "text": said, "alt": " ".join(told).strip(), "parts": lines})

    def draw(player: Steps) -> Picture:
        return draw_parts_about(points, player.stop["parts"], size, player.alt, player.stop["text"])

    mode = {"variants": {"": {"stops": stops}}, "label": label}
    return Steps(scene_of_parts("frames", points, size), mode, draw, after=after)


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
    values = validation.single(validation.vectors(row, "row", 4), "row")
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
        still = []
        for axis, first, last in track.spans:
            z, start, end = poses[first, :3, 2], poses[first, :3, 3], poses[last, :3, 3]
            ends = ends_on_axis(z, start, end, 0.3 * size, 0.6 * size)
            still.append(line_part(*ends, "axis", name=axis, dashed=True, tip=True))
            points.append(np.round(ends, 6))
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


def _stop(name: str, track: Track, poses: Array, k: int) -> dict[str, Any]:
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
