"""Frames placed by hand: only the joint axes of an arm are drawn, and the reader chooses z, origin and x of each frame.

The candidates for them are taken from all features of the drawing, so they include right and wrong ones and do not reveal the answer.
The page keeps the frames in a trait, so placing them also works without a kernel. Checking them by the rules needs Python.
"""

from collections.abc import Iterator
from dataclasses import asdict
from itertools import pairwise, repeat
from typing import Any

import numpy as np
import traitlets

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.dh.common_normal import CommonNormal, common_normal
from kinlib.dh.rules import Breach, check_frames
from kinlib.dh.table import Convention, DHTable, validate_convention
from kinlib.rigid.lie import inverse, perpendicular
from kinlib.view.drawing.picture import vector_text
from kinlib.view.figures.arm import describe_arm, draw_joints, frame_text
from kinlib.view.figures.frames import ends_on_axis
from kinlib.view.figures.joint_bodies import arm_size, stations
from kinlib.view.viewer.scene import bare_scene
from kinlib.view.viewer.steps import table_cells
from kinlib.view.viewer.viewer import Viewer

TWO_FRAME_RULES = {"x perpendicular to z", "x meets z"}
"""The rules about two consecutive frames; all others are about one frame."""

COINCIDENT_TOL = 1e-9
"""Points nearer to each other than this, in metres, count as equal, and so do unit vectors."""


class ByHand(Viewer):
    """Frames that are placed on the page. Make one with `assign`.

    frames   (n + 1, 4, 4) frames 0 to n in {s} at home; NaN for what is not placed yet. The page and Python can both set it
    asked    how often the reader has asked for a check
    verdict  the result of the last check, for the page
    """

    frames = traitlets.Any().tag(
        sync=True, to_json=lambda frames, _: np.where(np.isnan(frames), np.array(None), frames).tolist()
    )
    asked = traitlets.Int(0).tag(sync=True)
    verdict = traitlets.Dict().tag(sync=True)
    set_by_reader = ("frames",)

    def __init__(self, chain: Chain, convention: Convention, frames: Array) -> None:
        features = frame_candidates(chain)
        ends = np.array([line[end] for line in features["axes"] for end in ("from", "to")])
        scene = bare_scene(chain, ends)
        self.convention, self.chain = convention, chain
        super().__init__(
            {**scene, "offered": ["base", "tool"]},
            lambda _: draw_joints(chain),  # without the frames
            np.zeros(chain.n),
            robot=chain,
            shown=["base", "tool"],
            mode={"kind": "assign", "convention": convention, **features},
            frames=frames,
        )
        self.observe(self._judge, "asked")

    @property
    def breaches(self) -> list[Breach]:
        """The rules that are broken by the frames placed so far; rules about an incomplete frame are not checked yet."""
        whole, other = np.isfinite(self.frames.sum(axis=(1, 2))), -1 if self.convention == "standard" else 1
        filled = np.where(whole[:, None, None], self.frames, np.eye(4))
        found = [breach for breach in check_frames(self.chain, filled, self.convention) if whole[breach.frame]]
        return [breach for breach in found if breach.rule not in TWO_FRAME_RULES or whole[breach.frame + other]]

    @property
    def table(self) -> DHTable | None:
        """The table of the frames, or None until all are placed and no rule is broken. Its joint variables are about the frames' own z."""
        if np.isnan(self.frames).any() or self.breaches:
            return None
        return _table(self.chain, self.frames, self.convention)

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        whole = [frame_text((str(i), T)) for i, T in enumerate(self.frames) if not np.isnan(T).any()]
        return f"{describe_arm(self.chain, self.q)} {' '.join(whole) or 'No frame is placed yet.'}"

    @traitlets.validate("frames")
    def _validate_frames(self, proposal: Any) -> Array:
        frames = np.array(proposal["value"], dtype=float)  # null from the page becomes NaN
        if frames.shape != (self.chain.n + 1, 4, 4):
            raise ValueError(
                f"frames must have shape ({self.chain.n + 1}, 4, 4), frames 0 to {self.chain.n} of {self.chain.name}; "
                f"got {frames.shape}."
            )
        return frames

    def _judge(self, _: Any) -> None:
        table = self.table
        if table is not None:
            z = (self.frames[:-1] if self.convention == "standard" else self.frames[1:])[:, :3, 2]
            table = table.changed(signs=np.where((z * self.chain.lines.axis).sum(axis=1) < 0, -1.0, 1.0))
        self.verdict = {
            "asked": self.asked,
            "breaches": [asdict(breach) for breach in self.breaches],
            "table": [] if table is None else table_cells(table),
            "off": 0.0 if table is None else FrameAssignment(self.chain, table, self.frames, ()).accuracy,
        }


def assign(chain: Chain, convention: Convention) -> ByHand:
    """Place DH frames 0 to n on an arm by hand, and check them by the rules of the convention.

    The frames are in `.frames`, the rules that they break in `.breaches`, and their table, once it is right, in `.table`.

    Raises ValueError if the convention is unknown.

    >>> by_hand = assign(kl.robots.rpr(), "standard")
    >>> by_hand.frames = kl.assign_frames(kl.robots.rpr(), convention="standard").frames
    >>> by_hand.breaches
    []
    """
    bare = np.full((chain.n + 1, 4, 4), np.nan)
    bare[:, 3] = 0.0, 0.0, 0.0, 1.0
    return ByHand(chain, validate_convention(convention), bare)


def _table(chain: Chain, frames: Array, convention: Convention) -> DHTable:
    """Compute the table of frames that satisfy the rules. Frame 0 is its base, and what follows frame n its tool."""
    # the inverse of a row of the modified convention is a row of the standard one, with all four numbers negated
    first, second, sign = (frames[:-1], frames[1:], 1) if convention == "standard" else (frames[1:], frames[:-1], -1)
    T = inverse(first) @ second
    a, d = (T[:, :3, 0] * T[:, :3, 3]).sum(axis=1), T[:, 2, 3]
    alpha, theta = np.arctan2(T[:, 2, 1], T[:, 2, 2]), np.arctan2(T[:, 1, 0], T[:, 0, 0])
    rows = sign * np.stack([a, alpha, d, theta], axis=1)
    tool = inverse(frames[-1]) @ chain.home
    return DHTable(rows, convention=convention, joints=chain.joint_types, base=frames[0], tool=tool, name=chain.name)


def frame_candidates(chain: Chain) -> dict[str, Any]:
    """Return what a student can choose, {"axes", "tool", "points", "x"}, as data for the page.

    axes    the joint axes: a point and a direction, and the ends between which each is drawn; a z may be along one or opposite to it
    tool    the same of z of {b}
    points  intersections, feet of common normals, joints, the origins of {s} and {b}: {"at", "text"}
    x       directions of x: along normals, axes, links and the axes of {s} and {b}: {"along", "text"}

    >>> frame_candidates(kl.robots.rpr())["points"][0]["text"]
    'joint 1; joint 2; intersection of axes 1 and 2; foot of normal 2–3 on axis 2'
    """
    reach, points, lines = 0.3 * arm_size(chain), _merge(_origins(chain)), []
    joints = zip(chain.lines.axis, chain.joint_points, repeat([at for at, _ in points]))
    for z, point, places in [*joints, (chain.home[:3, 2], chain.home[:3, 3], [])]:
        start, end = ends_on_axis(z, point, places, reach, reach)
        line = {"point": point, "along": z, "from": start, "to": end}
        lines.append({name: _list(value) for name, value in line.items()})
    x = ((s * x, text) for x, *texts in _lines_for_x(chain) for s, text in zip((1, -1), texts, strict=True))
    return {
        "axes": lines[:-1],
        "tool": lines[-1],
        "points": [{"at": _list(at), "text": text} for at, text in points],
        "x": [{"along": _list(along), "text": f"{vector_text(along)}: {text}"} for along, text in _merge(x)],
    }


def _ends(chain: Chain) -> list[tuple[int, str, Array]]:
    """Return the first and the last axis, counted from 0, with the frame beyond it and that frame's origin."""
    return [(0, "{s}", np.zeros(3)), (chain.n - 1, "{b}", chain.home[:3, 3])]


def _origins(chain: Chain) -> Iterator[tuple[Array, str]]:
    for i, at in enumerate(chain.joint_points, start=1):
        yield at, f"joint {i}"
    for i, normal in _normals(chain):
        if normal.case == "intersecting":
            yield normal.start, f"intersection of axes {i} and {i + 1}"
        elif normal.case in {"skew", "parallel", "antiparallel"}:
            yield normal.start, f"foot of normal {i}–{i + 1} on axis {i}"
            yield normal.end, f"foot of normal {i}–{i + 1} on axis {i + 1}"
    for _, name, there in _ends(chain):
        yield there, f"origin of {name}"
    for i, name, there in _ends(chain):
        z, point = chain.lines.axis[i], chain.joint_points[i]
        yield point + z * (z @ (there - point)), f"point of axis {i + 1} nearest to {name}"


def _lines_for_x(chain: Chain) -> Iterator[tuple[Array, str, str]]:
    """Yield the unit vectors of normals, frames, axes and links, each with its description and that of the opposite one."""
    for i, normal in _normals(chain):
        if normal.case == "intersecting":
            text = f"perpendicular to axes {i} and {i + 1}"
            yield normal.x, text, f"{text}, opposite"
        elif normal.case in {"skew", "parallel", "antiparallel"}:
            pair = f"normal {i}–{i + 1}, to axis"
            yield normal.x, f"{pair} {i + 1}", f"{pair} {i}"
    for name, R in (("{s}", np.eye(3)), ("{b}", chain.home[:3, :3])):
        for letter, along in zip("xyz", R.T, strict=True):
            yield along, f"{letter} of {name}", f"−{letter} of {name}"
    for i, axis in enumerate(chain.lines.axis, start=1):
        yield axis, f"along axis {i}", f"opposite to axis {i}"
    ways = []
    for i, name, there in _ends(chain):
        z, off = chain.lines.axis[i], there - chain.joint_points[i]
        ways.append((off - z * (z @ off), f"axis {i + 1}", "perpendicularly to", name))
    names = [*(f"joint {i + 1}" for i in range(chain.n)), "{b}"]
    for (start, end), link in zip(pairwise(names), np.diff(stations(chain)[1:], axis=0), strict=True):
        ways.append((link, start, "to", end))
    for way, start, to, end in ways:
        if (length := float(np.linalg.norm(way))) > COINCIDENT_TOL:
            yield way / length, f"from {start} {to} {end}", f"from {end} {to} {start}"


def _normals(chain: Chain) -> Iterator[tuple[int, CommonNormal]]:
    """Yield the common normals of axes i and i + 1, with i. If the axes are parallel, the normals at both joints are candidates."""
    for i, (first, second) in enumerate(pairwise(zip(chain.lines.axis, chain.joint_points, strict=True)), start=1):
        across = perpendicular(first[0])
        at_next = common_normal(first, second, across, at_other_point=True)
        yield i, at_next
        if not at_next.is_unique:
            yield i, common_normal(first, second, across, at_other_point=False)


def _merge(candidates: Iterator[tuple[Array, str]]) -> list[tuple[Array, str]]:
    """Merge equal points or directions, and join their descriptions."""
    places: list[tuple[Array, list[str]]] = []
    for at, text in candidates:
        names = next((names for other, names in places if np.linalg.norm(other - at) < COINCIDENT_TOL), None)
        if names is None:
            places.append((at, [text]))
        elif text not in names:
            names.append(text)
    return [(at, "; ".join(names)) for at, names in places]


def _list(values: Array) -> Any:
    return (np.asarray(values) + 0.0).tolist()
