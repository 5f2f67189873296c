"""The steps of a frame assignment in words: the case, the choice, the alternatives and the numbers.

The order is the usual one: locate the axes; for each link the common normal, the origin, x and y; the first and the last
frame; and the four numbers of each row.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from kinlib.arrays.formatting import format_number, format_vector
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.common_normal import CommonNormal
from kinlib.dh.formatting import format_rows
from kinlib.dh.table import DHTable

ACCURACY_SAMPLES = 24
"""Number of configurations at which a table is compared with its chain."""

NEARLY_PARALLEL = (
    "These axes are nearly parallel, {angle:.1e} rad apart, where DH is ill-conditioned: if one of them moves by a millimetre, "
    "their normal moves by {far:.2g} m along them, so the last digits of d are lost. (Hayati's remedy is a fifth parameter: a "
    "small rotation about y instead of the distant normal.)"
)

PRISMATIC_AXIS_RELOCATED = (
    "These axes are nearly parallel, {angle:.1e} rad apart. But a prismatic joint has no line of its own, so its axis is placed "
    "to intersect its neighbour, and their normal stays near."
)

CASES = {
    "skew": "Axes {i} and {j} are skew: there is one common normal, {a} m long.",
    "intersecting": "Axes {i} and {j} intersect: the common normal has length zero, and its direction is perpendicular to both.",
    "parallel": "Axes {i} and {j} are parallel, {a} m apart: there is a common normal at every point, always the same vector.",
    "antiparallel": "Axes {i} and {j} are parallel with opposite directions, {a} m apart: alpha is pi, not 0.",
    "coincident": "Axes {i} and {j} are the same line: the common normal has length zero, and any perpendicular direction is possible.",
    "anti-coincident": (
        "Axes {i} and {j} are the same line with opposite directions: alpha is pi, and any perpendicular direction is possible."
    ),
}

ALTERNATIVES = {
    "skew": "The opposite direction, with -a, -alpha, and pi added to one theta and subtracted from the next.",
    "intersecting": "The opposite direction, with -alpha, and pi added to one theta and subtracted from the next.",
    "parallel": "Any other point along the axes: d decreases in one row by as much as it increases in the next.",
    "antiparallel": "Any other point along the axes: both d change by the same amount, because the axes have opposite directions.",
    "coincident": "Any direction perpendicular to the axis, and any point on it.",
    "anti-coincident": "Any direction perpendicular to the axis, and any point on it.",
}


@dataclass(frozen=True)
class AssignmentStep:
    """One step of a frame assignment.

    kind    "axes", "normal", "origin", "x", "y", "first", "last", "row" or "accuracy"
    frame   the number of the frame or the row; None for the whole arm
    text    what is found and done, in words with numbers
    others  the alternatives; empty where nothing is free
    """

    kind: str
    frame: int | None
    text: str
    others: str = ""

    def __str__(self) -> str:
        return f"{self.text} (Also right: {self.others})" if self.others else self.text


def explain_assignment(
    chain: Chain, table: DHTable, frames: Array, normals: Sequence[CommonNormal], accuracy: float
) -> list[AssignmentStep]:
    """Explain an assignment in the steps in which a person does it."""
    standard = table.convention == "standard"
    steps = [_explain_axes(chain, standard), _explain_first_frame(table, frames)]
    for pair, normal in enumerate(normals):
        steps += _explain_link(chain, frames[pair + 1], pair, normal, standard)
    steps.append(_explain_last_frame(chain, table, frames))
    steps += _explain_rows(table)
    steps.append(_explain_accuracy(accuracy, any(normal.is_nearly_parallel for normal in normals)))
    return steps


def _explain_axes(chain: Chain, standard: bool) -> AssignmentStep:
    prismatic = [i for i, joint_type in enumerate(chain.joint_types, start=1) if joint_type == "P"]
    revolute = [i for i in range(1, chain.n + 1) if i not in prismatic]
    kinds = f"{_joints(revolute)} revolute" if revolute else ""
    if prismatic:
        kinds += f"{'; ' if revolute else ''}{_joints(prismatic)} prismatic"
        kinds += ", with a direction but no position"
    rule = "z_{i-1} lies on the axis of joint i" if standard else "z_i lies on the axis of joint i"
    others = "Each z may have the opposite direction; then the joint variable changes its sign."
    return AssignmentStep("axes", None, f"Locate the joint axes: {kinds}. In this convention {rule}.", others)


def _joints(numbers: Sequence[int]) -> str:
    """Write "joint 2 is", "joints 1, 3 are" or "joints 1 to 6 are"."""
    is_run = len(numbers) > 2 and numbers[-1] - numbers[0] == len(numbers) - 1
    names = f"{numbers[0]} to {numbers[-1]}" if is_run else ", ".join(map(str, numbers))
    return f"joints {names} are" if len(numbers) > 1 else f"joint {names} is"


def _explain_first_frame(table: DHTable, frames: Array) -> AssignmentStep:
    place = f"Its origin is at {format_vector(frames[0, :3, 3])}, its x along {format_vector(frames[0, :3, 0])}."
    if table.convention == "standard":
        text = f"Frame 0 is on axis 1, at the point nearest {{s}}, with x as near the x of {{s}} as the axis allows. {place}"
        others = "Any other origin on the axis and any x perpendicular to it; base, d_1 and theta_1 change accordingly."
    else:
        text = f"Frame 0 coincides with frame 1 at q_1 = 0, so the first row begins with alpha = 0 and a = 0. {place}"
        others = "Any other frame, with other numbers in the base and in the first row."
    return AssignmentStep("first", 0, text, others)


def _explain_link(chain: Chain, T: Array, pair: int, normal: CommonNormal, standard: bool) -> Iterator[AssignmentStep]:
    i, j, frame = pair + 1, pair + 2, pair + 1
    length = format_number(float(np.linalg.norm(normal.end - normal.start)))
    text, others = CASES[normal.case].format(i=i, j=j, a=length), ALTERNATIVES[normal.case]
    has_length = normal.case in {"skew", "parallel", "antiparallel"}
    if normal.is_nearly_parallel and (has_length or "P" not in chain.joint_types[pair : pair + 2]):
        text += " " + NEARLY_PARALLEL.format(angle=normal.sine, far=1e-3 / normal.sine)
        text += f" Here they are taken as {normal.case}" + (", with the distant normal." if normal.is_unique else ".")
        others = others if normal.is_unique else "The distant normal."
    elif normal.is_nearly_parallel:
        text += " " + PRISMATIC_AXIS_RELOCATED.format(angle=normal.sine)
    yield AssignmentStep("normal", frame, text, others)
    reason = "where the common normal meets it"
    if not normal.is_unique:
        reason = f"at joint {j}" if standard else "where d is 0"
        reason += ", because the normal may be at any point of the axes"
    text = f"O_{frame} lies on axis {j if standard else i}, {reason}: {format_vector(T[:3, 3])}."
    yield AssignmentStep("origin", frame, text, "" if normal.is_unique else ALTERNATIVES[normal.case])
    direction = "the same as before"
    if has_length:
        direction = "along the common normal, from axis to axis"
    elif normal.case == "intersecting":
        direction = "perpendicular to both axes, as near the previous x as possible"
    others = "" if normal.case in {"parallel", "antiparallel"} else ALTERNATIVES[normal.case]
    yield AssignmentStep("x", frame, f"x_{frame} is {direction}: {format_vector(normal.x)}.", others)
    text = f"y_{frame} = z_{frame} × x_{frame} completes a right-handed frame: {format_vector(T[:3, 1])}."
    yield AssignmentStep("y", frame, text)


def _explain_last_frame(chain: Chain, table: DHTable, frames: Array) -> AssignmentStep:
    n, T = chain.n, frames[-1]
    place = f"O_{n} is at {format_vector(T[:3, 3])}, x_{n} along {format_vector(T[:3, 0])}."
    if table.convention == "standard":
        text = f"There is no next axis: z_{n} is parallel to z_{n - 1}, and the frame is as near the tool as that allows. {place}"
        others = "Any frame whose x intersects z_{n-1} at a right angle; the tool transform compensates for it."
    else:
        d, theta = ("0", f"q_{n}") if table.joints[-1] == "R" else (f"q_{n}", "0")
        text = (
            f"Frame {n} is placed such that d_{n} = {d} and theta_{n} = {theta}. {place} "
            "The tool transform leads from there to {b}."
        )
        others = "Any other origin on the axis and any x perpendicular to it; d, theta and the tool change accordingly."
    return AssignmentStep("last", n, text, others)


def _explain_rows(table: DHTable) -> Iterator[AssignmentStep]:
    rows = format_rows(table, variable="q_{}".format)
    for row, (a, alpha, d, theta) in enumerate(rows, start=1):
        index = row - 1 if table.convention == "modified" else row
        text = f"Row {row}: a_{index} = {a}, alpha_{index} = {alpha}, d_{row} = {d}, theta_{row} = {theta}."
        yield AssignmentStep("row", row, text)


def _explain_accuracy(accuracy: float, nearly_parallel: bool) -> AssignmentStep:
    is_exact = accuracy < 1e-11
    claim = (
        "This table describes the arm, up to rounding"
        if is_exact
        else "This table describes the arm only approximately"
    )
    text = f"{claim}: at {ACCURACY_SAMPLES} configurations its poses differ by at most {accuracy:.1e}."
    if nearly_parallel and not is_exact:
        text += " The nearly parallel axes limit its accuracy."
    return AssignmentStep("accuracy", None, text)
