"""Candidates for frames placed by hand: directions for z and x, and points for the origin, each with a description.

They are taken from all features of the drawing, so they include right and wrong ones and do not reveal the answer.
"""

from collections.abc import Iterator
from itertools import pairwise, repeat
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.common_normal import CommonNormal, common_normal
from kinlib.rigid.lie import perpendicular
from kinlib.view.drawing.picture import vector_text
from kinlib.view.figures.frames import span_on_axis
from kinlib.view.figures.joint_bodies import arm_size, stations

COINCIDENT_TOL = 1e-9
"""Points nearer to each other than this, in metres, count as equal, and so do unit vectors."""


def frame_candidates(chain: Chain) -> dict[str, Any]:
    """Return what a student can choose, {"axes", "z", "points", "x"}, as data for the page.

    axes    the joint axes: a point and a direction, and the ends between which each is drawn
    z       directions of z, both directions along each axis and along z of {b}, each with the position of its handle
    points  intersections, feet of common normals, joints, the origins of {s} and {b}: {"at", "text"}
    x       directions of x: along normals, axes, links and the axes of {s} and {b}: {"along", "text"}

    >>> frame_candidates(kl.robots.rpr())["points"][0]["text"]
    'joint 1; joint 2; intersection of axes 1 and 2; foot of normal 2–3 on axis 2'
    """
    reach, points, lines = 0.3 * arm_size(chain), _merge(_origins(chain)), []
    joints = zip(chain.lines.axis, chain.joint_points, repeat([at for at, _ in points]))
    for z, point, places in [*joints, (chain.home[:3, 2], chain.home[:3, 3], [])]:
        low, high = span_on_axis(z, point, places)
        lines.append((point, z, point + (low - reach) * z, point + (high + reach) * z))
    names = [*(f"axis {i}" for i in range(1, chain.n + 1)), "z of {b}"]
    x = ((s * x, text) for x, *texts in _lines_for_x(chain) for s, text in zip((1, -1), texts, strict=True))
    return {
        "axes": [
            {"point": _list(point), "along": _list(z), "from": _list(low), "to": _list(high)}
            for point, z, low, high in lines[:-1]
        ],
        "z": [
            {
                "axis": i if i < chain.n else None,
                "at": _list(end),
                "along": _list(sign * z),
                "text": f"{word} {names[i]}",
            }
            for i, (_, z, low, high) in enumerate(lines)
            for sign, end, word in ((1, high, "along"), (-1, low, "opposite to"))
        ],
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
