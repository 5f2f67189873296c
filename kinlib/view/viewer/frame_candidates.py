"""Candidates for frames placed by hand: directions for z and x, and points for the origin, each with a description.

They are taken from all features of the drawing, so they include right and wrong ones and do not reveal the answer.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.common_normal import CommonNormal, common_normal
from kinlib.rigid.lie import perpendicular
from kinlib.view.drawing.picture import vector_text
from kinlib.view.figures.frame_assignment import span_on_axis
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.figures.tree import branches
from kinlib.view.viewer.scene import extent

COINCIDENT_TOL = 1e-9
"""Points nearer to each other than this, in metres, count as equal, and so do unit vectors."""


def frame_candidates(chain: Chain) -> dict[str, Any]:
    """Return what a student can choose, {"axes", "z", "points", "x"}, as data for the page.

    axes    the joint axes: a point and a direction, and the ends between which each is drawn
    z       directions of z, both directions along each axis and along z of {b}, each with the position of its handle
    points  intersections, feet of common normals, joints, the origins of {s} and {b}: {"at", "text"}
    x       directions of x: along normals, axes, links and the axes of {s} and {b}: {"along", "text"}

    >>> from kinlib.chains.robots import rpr
    >>> frame_candidates(rpr())["points"][0]["text"]
    'joint 1; joint 2; intersection of axes 1 and 2; foot of normal 2–3 on axis 2'
    """
    size, points = extent(*branches(chain)), _origins(chain)
    lines = []
    for z, point in zip(chain.lines.axis, chain.joint_points, strict=True):
        low, high = span_on_axis(z, point, [at for at, _ in points])
        ends = point + (low - 0.3 * size) * z, point + (high + 0.3 * size) * z
        lines.append({"point": _list(point), "along": _list(z), "from": _list(ends[0]), "to": _list(ends[1])})
    return {
        "axes": lines,
        "z": [*_z_directions(chain, lines, size)],
        "points": [{"at": _list(at), "text": text} for at, text in points],
        "x": [{"along": _list(along), "text": text} for along, text in _x_directions(chain)],
    }


def _z_directions(chain: Chain, lines: list[dict[str, Any]], size: float) -> Iterator[dict[str, Any]]:
    tool, z = chain.home[:3, 3], chain.home[:3, 2]
    ends = {"to": _list(tool + 0.3 * size * z), "from": _list(tool - 0.3 * size * z), "along": _list(z)}
    for axis, line in [*enumerate(lines), (None, ends)]:
        name = "z of {b}" if axis is None else f"axis {axis + 1}"
        for sign, end, word in ((1, "to", "along"), (-1, "from", "opposite to")):
            along = _list(sign * np.array(line["along"]))
            yield {"axis": axis, "at": line[end], "along": along, "text": f"{word} {name}"}


def _origins(chain: Chain) -> list[tuple[Array, str]]:
    candidates: list[tuple[Array, str]] = [(at, f"joint {i + 1}") for i, at in enumerate(chain.joint_points)]
    for i, normal in _normals(chain):
        pair = f"{i + 1}–{i + 2}"
        if normal.case == "intersecting":
            candidates.append((normal.start, f"intersection of axes {i + 1} and {i + 2}"))
        elif normal.case in {"skew", "parallel", "antiparallel"}:
            candidates.append((normal.start, f"foot of normal {pair} on axis {i + 1}"))
            candidates.append((normal.end, f"foot of normal {pair} on axis {i + 2}"))
    tool = chain.home[:3, 3]
    candidates += [(np.zeros(3), "origin of {s}"), (tool, "origin of {b}")]
    for i, name in ((0, "{s}"), (chain.n - 1, "{b}")):
        z, point = chain.lines.axis[i], chain.joint_points[i]
        there = np.zeros(3) if name == "{s}" else tool
        candidates.append((point + z * (z @ (there - point)), f"point of axis {i + 1} nearest to {name}"))
    return _merge(candidates)


def _x_directions(chain: Chain) -> list[tuple[Array, str]]:
    both = [one for along, to, fro in _lines_for_x(chain) for one in ((along, to), (-along, fro))]
    return [(along, f"{vector_text(along)}: {text}") for along, text in _merge(both)]


def _lines_for_x(chain: Chain) -> Iterator[tuple[Array, str, str]]:
    """Yield the unit vectors of normals, frames, axes and links, each with its description and that of the opposite one."""
    for i, normal in _normals(chain):
        one, other = i + 1, i + 2
        if normal.case == "intersecting":
            text = f"perpendicular to axes {one} and {other}"
            yield normal.x, text, f"{text}, opposite"
        elif normal.case in {"skew", "parallel", "antiparallel"}:
            yield normal.x, f"normal {one}–{other}, to axis {other}", f"normal {one}–{other}, to axis {one}"
    for name, R in (("{s}", np.eye(3)), ("{b}", chain.home[:3, :3])):
        for letter, along in zip("xyz", R.T, strict=True):
            yield along, f"{letter} of {name}", f"−{letter} of {name}"
    for i, axis in enumerate(chain.lines.axis, start=1):
        yield axis, f"along axis {i}", f"opposite to axis {i}"
    for i, name, there in ((0, "{s}", np.zeros(3)), (chain.n - 1, "{b}", chain.home[:3, 3])):
        z, off = chain.lines.axis[i], there - chain.joint_points[i]
        across = off - z * (z @ off)
        if (length := float(np.linalg.norm(across))) > COINCIDENT_TOL:
            yield (
                across / length,
                f"from axis {i + 1} perpendicularly to {name}",
                f"from {name} perpendicularly to axis {i + 1}",
            )
    names = [*(f"joint {i + 1}" for i in range(chain.n)), "{b}"]
    for (start, end), link in zip(pairwise(names), np.diff(stations(chain)[1:], axis=0), strict=True):
        if (length := float(np.linalg.norm(link))) > COINCIDENT_TOL:
            yield link / length, f"from {start} to {end}", f"from {end} to {start}"


def _normals(chain: Chain) -> Iterator[tuple[int, CommonNormal]]:
    """Yield the common normals of consecutive axes. If the axes are parallel, the normals at both joints are candidates."""
    axes = [*zip(chain.lines.axis, chain.joint_points, strict=True)]
    for i in range(chain.n - 1):
        across = perpendicular(axes[i][0])
        at_next = common_normal(axes[i], axes[i + 1], across, at_other_point=True)
        yield i, at_next
        if not at_next.is_unique:
            yield i, common_normal(axes[i], axes[i + 1], across, at_other_point=False)


def _merge(candidates: list[tuple[Array, str]]) -> list[tuple[Array, str]]:
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
