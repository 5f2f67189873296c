"""The steps of a frame assignment in words: the case met, the choice taken, what else was legal, and the numbers.

The order is that of the decks: locate the axes, then for each link the common normal, the origin, x and y, then the first
and the last frame, then the four numbers of each row.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from kinlib.arrays.formatting import format_number, format_vector
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.common_normal import Normal
from kinlib.dh.formatting import format_rows
from kinlib.dh.table import DHTable

PROBES = 24
"""In how many postures a table is compared with its chain."""

SINGULAR = (
    "These axes are nearly parallel, {angle:.1e} rad apart, and DH is singular here: a millimetre between them moves their "
    "normal by {far:.2g} m along them, so the last digits of d are lost. (Hayati's remedy is a fifth parameter: a small turn "
    "about y instead of the far normal.)"
)

SPARED = (
    "These axes are nearly parallel, {angle:.1e} rad apart; but a slide has no line of its own, so it is laid across its "
    "neighbour, and their normal cannot run away."
)

CASES = {
    "skew": "Axes {i} and {j} are skew: there is one common normal, {a} m long.",
    "intersecting": "Axes {i} and {j} meet: the common normal has no length, and its direction is square to both.",
    "parallel": "Axes {i} and {j} are parallel, {a} m apart: every place along them has a common normal, all alike.",
    "anti-parallel": "Axes {i} and {j} are parallel and point opposite ways, {a} m apart: alpha is pi, not 0.",
    "coincident": "Axes {i} and {j} are one line: the common normal has no length, and any direction will do.",
    "anti-coincident": "Axes {i} and {j} are one line and point opposite ways: alpha is pi, and any direction will do.",
}

ELSE = {
    "skew": "The opposite direction, with -a, -alpha, and half a turn more in one theta and less in the next.",
    "intersecting": "The opposite direction, with -alpha, and half a turn more in one theta and less in the next.",
    "parallel": "Any other place along the axes: what d loses in one row, it gains in the next.",
    "anti-parallel": "Any other place along the axes: both d change alike, for the axes point opposite ways.",
    "coincident": "Any direction square to the axis, and any place on it.",
    "anti-coincident": "Any direction square to the axis, and any place on it.",
}


@dataclass(frozen=True)
class Step:
    """One step of an assignment.

    kind    "axes", "normal", "origin", "x", "y", "first", "last", "row" or "accuracy"
    frame   the frame or the row that it is about; None for the whole arm
    text    what is found and done, in words with numbers
    others  what else would have been legal; empty where nothing was free
    """

    kind: str
    frame: int | None
    text: str
    others: str = ""


def told(chain: Chain, table: DHTable, frames: Array, normals: Sequence[Normal], accuracy: float) -> list[Step]:
    """Tell an assignment as a person would make it.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> [step.kind for step in assign_frames(youbot(), convention="standard").steps][:5]
    ['axes', 'first', 'normal', 'origin', 'x']
    """
    standard = table.convention == "standard"
    steps = [_axes(chain, standard), _first(table, frames)]
    for pair, normal in enumerate(normals):
        frame = pair + 1
        steps += _link(chain, frames[frame], pair, normal, standard)
    steps.append(_last(chain, table, frames))
    steps += _rows(table)
    singular = any(normal.nearly_parallel for normal in normals)
    exact = "This table is the arm, to rounding" if accuracy < 1e-11 else "This table is the arm only so far"
    note = " Nearly parallel axes cost it the digits." if singular and accuracy >= 1e-11 else ""
    steps.append(
        Step("accuracy", None, f"{exact}: in {PROBES} postures its poses differ by {accuracy:.1e} at most.{note}")
    )
    return steps


def _axes(chain: Chain, standard: bool) -> Step:
    found = []
    for i, (letter, axis, point) in enumerate(
        zip(chain.joint_types, chain.lines.axis, chain.joint_points, strict=True)
    ):
        where = "anywhere (a slide has a direction, not a line)" if letter == "P" else f"through {format_vector(point)}"
        found.append(f"joint {i + 1}, {'sliding' if letter == 'P' else 'turning'}, along {format_vector(axis)} {where}")
    rule = "z_{i-1} lies on the axis of joint i" if standard else "z_i lies on the axis of joint i"
    turned = "Each z may point the other way; then that joint counts the other way."
    return Step("axes", None, f"Locate the joint axes: {'; '.join(found)}. In this convention {rule}.", turned)


def _first(table: DHTable, frames: Array) -> Step:
    place = f"Its origin is at {format_vector(frames[0, :3, 3])}, its x along {format_vector(frames[0, :3, 0])}."
    if table.convention == "standard":
        text = f"Frame 0 stands on axis 1, at the point nearest {{s}}, with x as near the x of {{s}} as the axis allows. {place}"
        return Step(
            "first", 0, text, "Any other origin on the axis and any x square to it; base, d_1 and theta_1 follow."
        )
    text = f"Frame 0 matches frame 1 when q_1 = 0, so the first row begins with alpha = 0 and a = 0. {place}"
    return Step("first", 0, text, "Any frame at all, with other numbers in the base and in the first row.")


def _link(chain: Chain, T: Array, pair: int, normal: Normal, standard: bool) -> Iterator[Step]:
    i, j, frame = pair + 1, pair + 2, pair + 1
    length = format_number(float(np.linalg.norm(normal.end - normal.start)))
    text = CASES[normal.case].format(i=i, j=j, a=length)
    has_length = normal.case in {"skew", "parallel", "anti-parallel"}
    singular = normal.nearly_parallel and (has_length or "P" not in chain.joint_types[pair : pair + 2])
    if singular:
        text += " " + SINGULAR.format(angle=normal.sine, far=1e-3 / normal.sine)
        text += " Here they are taken as parallel." if normal.free else " Here the far normal is kept."
    elif normal.nearly_parallel:
        text += " " + SPARED.format(angle=normal.sine)
    others = "The far normal." if singular and normal.free else ELSE[normal.case]
    yield Step("normal", frame, text, others)
    on = f"axis {j}" if standard else f"axis {i}"
    why = "where the common normal meets it"
    if normal.free:
        why = f"at joint {j}, for the normal may slide" if standard else "where d stays 0, for the normal may slide"
    yield Step(
        "origin",
        frame,
        f"O_{frame} lies on {on}, {why}: {format_vector(T[:3, 3])}.",
        ELSE[normal.case] if normal.free else "",
    )
    direction = (
        "along the common normal, from joint to joint"
        if has_length
        else (
            "square to both axes, as near the x before as that allows"
            if normal.case == "intersecting"
            else "kept as it was"
        )
    )
    yield Step(
        "x",
        frame,
        f"x_{frame} is {direction}: {format_vector(normal.x)}.",
        "" if normal.case in {"parallel", "anti-parallel"} else ELSE[normal.case],
    )
    yield Step(
        "y", frame, f"y_{frame} = z_{frame} x x_{frame} completes a right-handed frame: {format_vector(T[:3, 1])}."
    )


def _last(chain: Chain, table: DHTable, frames: Array) -> Step:
    n, T = chain.n, frames[-1]
    place = f"O_{n} is at {format_vector(T[:3, 3])}, x_{n} along {format_vector(T[:3, 0])}."
    if table.convention == "standard":
        text = f"There is no next axis: z_{n} is parallel to z_{n - 1}, and the frame as near the tool as that allows. {place}"
        return Step(
            "last", n, text, "Any frame whose x meets z_{n-1} at a right angle; the tool transform takes up the rest."
        )
    d, theta = ("0", f"q_{n}") if table.joints[-1] == "R" else (f"q_{n}", "0")
    text = (
        f"Frame {n} stands where d_{n} = {d} and theta_{n} = {theta}. {place} "
        "What is left to {b} is the tool transform."
    )
    return Step("last", n, text, "Any other origin on the axis and any x square to it; d, theta and the tool follow.")


def _rows(table: DHTable) -> Iterator[Step]:
    for row, (a, alpha, d, theta) in enumerate(
        format_rows(table, angle=format_number, variable="q_{}".format), start=1
    ):
        before = row - 1 if table.convention == "modified" else row
        text = f"Row {row}: a_{before} = {a}, alpha_{before} = {alpha}, d_{row} = {d}, theta_{row} = {theta}."
        yield Step("row", row, text)
