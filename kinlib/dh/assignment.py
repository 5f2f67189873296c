"""DH frame assignment: from joint axes to frames and a table, in both conventions, with every step and its reason.

The axes determine most of the assignment. Where they leave a choice, it is made as is usual, and each step lists the
alternatives: for parallel axes the origin is at joint i+1 (standard) or such that d_i = 0 (modified), for intersecting axes x is
chosen close to the previous x, the last z of the standard convention is parallel to the one before it, and {0} coincides with
{1} in the modified convention.

For nearly parallel axes DH itself is ill-conditioned: the feet of their normal move away like 1 / angle, and the last digits of d
are lost. There the assignment compares the exact row with one that treats the axes as parallel, and keeps the more accurate one;
`accuracy` reports how accurate the table is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_number, format_vector
from kinlib.arrays.tolerances import INTERSECTION_TOL_M, PARALLEL_TOL_RAD, TYPED_PI_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.common_normal import CommonNormal, common_normal, frame_axes
from kinlib.dh.parsing import MAX_LENGTH_M
from kinlib.dh.table import Convention, DHTable, format_rows, snapped, validate_convention
from kinlib.rigid.lie import cross, homogeneous, nearest_rotation


@dataclass(frozen=True, eq=False)
class FrameAssignment:
    """The DH frames of an arm, its table, and the steps of the assignment.

    table    with exactly one row per joint, and with base and tool
    frames   (n + 1, 4, 4), frames 0 to n in {s} at home
    normals  the common normal of each pair of neighbouring axes
    """

    chain: Chain
    table: DHTable
    frames: Array = field(repr=False)
    normals: tuple[CommonNormal, ...] = field(repr=False)

    def _repr_html_(self) -> str:
        return self.table._repr_html_()

    @cached_property
    def accuracy(self) -> float:
        """The largest difference in an entry between the table's poses and the chain's, at many configurations."""
        q = random_configurations(self.chain.n, 24)
        return largest_difference(self.table.fk(q), self.chain.fk(q))

    @cached_property
    def steps(self) -> list[AssignmentStep]:
        """The assignment as a person does it, in the usual order; each step prints as one line.

        Each step has a `text`, its case, choice and numbers, and `others`, what would also be right.

        >>> step = assign_frames(kl.robots.rpr(), convention="modified").steps[5]
        >>> step.kind, step.frame, step.text, step.others
        ('y', 1, 'y_1 = z_1 × x_1 completes a right-handed frame: (0, 0, 1).', '')
        """
        return [*_steps(self)]


def assign_frames(chain: Chain, convention: Convention, *, snap: bool = False) -> FrameAssignment:
    """Assign DH frames to an arm, and derive its table.

    The product of the table equals chain.fk to about 1e-12; for nearly parallel axes, `accuracy` says how closely.

    snap  whether axes that are parallel or perpendicular up to the digits of a typed pi / 2 are taken as exactly that, and
          numbers as the short ones that they are near, so that the table is clean; `accuracy` is the pose error that this costs

    Raises ValueError for a helical joint, which a DH row cannot describe.
    Source: EduFill manipulation module, steps I to IX; Chapter 4 review, seven steps (standard); DH example with
    n = 5, eight steps (modified).

    >>> assign_frames(kl.robots.youbot(), convention="standard").table.columns["d"].round(4) + 0.0
    array([0.147 , 0.    , 0.    , 0.    , 0.2175])
    """
    validation.instance(chain, "chain", Chain)
    convention = validate_convention(convention)
    if "H" in chain.joint_types:
        joint = chain.joint_types.index("H") + 1
        raise ValueError(
            f"The joints must be revolute or prismatic, but joint {joint} of {chain.name} is helical. Use its screw axis instead."
        )
    results = [_assign(chain, convention, PARALLEL_TOL_RAD)]
    if results[0] is None or any(normal.is_nearly_parallel for normal in results[0].normals):
        # One bound for the whole arm: an axis that is treated as parallel passes its small error on to the next comparison.
        results += [_assign(chain, convention, bound) for bound in 10.0 ** np.arange(-11.5, -4.5, 0.5)]
    found = [_snapped(each) if snap else each for each in results if each]
    # Of clean tables, the one with the fewest digits is the cleanest.
    return min(found, key=lambda each: (sum(map(str.isdigit, str(each.table))) * snap, each.accuracy))


def _snapped(found: FrameAssignment) -> FrameAssignment:
    """Replace the numbers of a table by the short ones that they are near; base and tool keep the ends where they are."""
    table, chain = found.table, found.chain
    degrees, rows = np.degrees(table.rows[:, [1, 3]]), _short(table.rows)
    rows[:, [1, 3]] = np.radians(snapped(degrees, 1, np.degrees(TYPED_PI_ERROR)).round(4)) + 0.0
    ends = np.array([table.base, table.tool])
    base, tool = homogeneous(nearest_rotation(snapped(ends[:, :3, :3], 1e-4, TYPED_PI_ERROR)), _short(ends[:, :3, 3]))
    clean = table.changed(rows=rows, base=base, tool=tool)
    return FrameAssignment(chain, clean, clean.frames(np.zeros(chain.n)), found.normals)


def _short(lengths: Array) -> Array:
    """Round lengths to five decimals, but not those that have only a few more, such as 0.089159."""
    return np.where(np.abs(lengths - lengths.round(7)) < 1e-10, lengths.round(7), lengths.round(5)) + 0.0


def _assign(chain: Chain, convention: Convention, parallel_below: float) -> FrameAssignment | None:
    """Assign frames, treating axes at a smaller angle than the bound as parallel; None if a normal is too far away for a table."""
    standard = convention == "standard"
    axes, points = chain.lines.axis, _points_on_axes(chain)
    z, x = axes[0], _first_not_along(axes[0], np.eye(3))  # as close to {s} as the axis allows
    origin = points[0] - z * (z @ points[0])
    frames, normals = [homogeneous(frame_axes(x, z), origin)], list[CommonNormal]()
    for axis, point in zip(axes[1:], points[1:], strict=True):
        normal = common_normal((z, origin), (axis, point), x, at_other_point=standard, parallel_below=parallel_below)
        normals.append(normal)
        next_z = axis if normal.is_unique else -z if normal.case.startswith("anti") else z
        at, place = (next_z, normal.end) if standard else (z, normal.start)
        frames.append(homogeneous(frame_axes(normal.x, at), place))
        x, z, origin = normal.x, next_z, normal.end
    if standard:
        # The last z stays parallel, and the frame is as near the tool as that allows.
        across = chain.home[:3, 3] - origin
        across = across - z * (z @ across)
        is_beside = np.linalg.norm(across) > INTERSECTION_TOL_M
        x, origin = across if is_beside else _first_not_along(z, chain.home[:3, :3].T), chain.home[:3, 3]
    frames.append(homogeneous(frame_axes(x, z), origin))
    if not standard:
        frames[0] = frames[1]  # {0} coincides with {1} at q_1 = 0
    rows = _rows_between(np.array(frames), standard)
    if np.abs(rows[:, [0, 2]]).max() > MAX_LENGTH_M:
        return None
    table = DHTable(rows, convention=convention, joints=chain.joint_types, base=frames[0], name=chain.name)
    tool = _relative_poses(table.fk(np.zeros(chain.n)), chain.home)
    return FrameAssignment(chain, table.changed(tool=tool), np.array(frames), tuple(normals))


def _rows_between(frames: Array, standard: bool) -> Array:
    """Read the numbers (n, 4) of each row from the frames before and after it: a modified row is the inverse of a standard one."""
    T = _relative_poses(frames[:-1], frames[1:]) if standard else _relative_poses(frames[1:], frames[:-1])
    a, alpha = np.sum(T[:, :2, 3] * T[:, :2, 0], axis=1), np.arctan2(T[:, 2, 1], T[:, 2, 2])
    d, theta = T[:, 2, 3], np.arctan2(T[:, 1, 0], T[:, 0, 0])
    rows = np.column_stack([a, alpha, d, theta]) * (1 if standard else -1)
    rows[np.abs(rows) <= PARALLEL_TOL_RAD] = 0.0  # in metres, too
    return np.where(np.abs(np.abs(rows) - np.pi) <= PARALLEL_TOL_RAD, np.pi, rows)


def _relative_poses(frames: Array, T: Array) -> Array:
    """Express poses in frames. The frames may be far away, so the difference of the positions is taken first."""
    Rt = np.swapaxes(frames[..., :3, :3], -1, -2)
    return homogeneous(Rt @ T[..., :3, :3], (Rt @ (T - frames)[..., :3, 3:])[..., 0])


def _points_on_axes(chain: Chain) -> Array:
    """Choose a point on each axis. A prismatic axis may be anywhere, so it is put where its normal to a neighbour stays near."""
    points = np.array(chain.joint_points)
    axes = chain.lines.axis
    for i in [i for i, joint_type in enumerate(chain.joint_types) if joint_type == "P"]:
        for neighbour in range(max(i - 1, 0), min(i + 2, chain.n)):
            if PARALLEL_TOL_RAD < np.linalg.norm(cross(axes[i], axes[neighbour])) < 1e-3:
                points[i] = points[neighbour]
    return points


def _first_not_along(z: Array, candidates: Array) -> Array:
    """Return the first of three orthogonal directions that is not along z, as at least two are not."""
    return next(x for x in candidates if np.linalg.norm(cross(x, z)) > 0.1)


CASES = {
    "skew": "Axes {i} and {j} are skew: there is one common normal, {a} m long.",
    "intersecting": "Axes {i} and {j} intersect: the common normal has length zero, and its direction is perpendicular to both.",
    "parallel": "Axes {i} and {j} are parallel, {a} m apart: there is a common normal at every point, always the same vector.",
    "antiparallel": "Axes {i} and {j} are parallel with opposite directions, {a} m apart: alpha is pi, not 0.",
    "coincident": "Axes {i} and {j} are the same line: the common normal has length zero, and any perpendicular direction is possible.",
    "anti-coincident": "Axes {i} and {j} are the same line with opposite directions: alpha is pi, and any perpendicular x is possible.",
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


def _steps(found: FrameAssignment) -> Iterator[AssignmentStep]:
    """Explain an assignment in the steps in which a person does it."""
    chain, table, frames, normals = found.chain, found.table, found.frames, found.normals
    standard = table.convention == "standard"
    kinds = []
    for letter, kind in (("R", "revolute"), ("P", "prismatic")):
        numbers = [i for i, joint_type in enumerate(chain.joint_types, start=1) if joint_type == letter]
        kinds += [f"{_joints(numbers)} {kind}"] if numbers else []
    text = f"Locate the joint axes: {'; '.join(kinds)}{', with a direction but no position' * ('P' in chain.joint_types)}. "
    text += f"In this convention {'z_{i-1} lies' if standard else 'z_i lies'} on the axis of joint i."
    others = "Each z may have the opposite direction; then the joint variable changes its sign."
    yield AssignmentStep("axes", None, text, others)
    place = f"Its origin is at {format_vector(frames[0, :3, 3])}, its x along {format_vector(frames[0, :3, 0])}."
    text = f"Frame 0 is on axis 1, at the point nearest {{s}}, with x as near that of {{s}} as the axis allows. {place}"
    others = "Any other origin on the axis and any x perpendicular to it; base, d_1 and theta_1 change accordingly."
    if not standard:
        text = f"Frame 0 coincides with frame 1 at q_1 = 0, so the first row begins with alpha = 0 and a = 0. {place}"
        others = "Any other frame, with other numbers in the base and in the first row."
    yield AssignmentStep("first", 0, text, others)
    for pair, normal in enumerate(normals):
        yield from _explain_link(frames[pair : pair + 2], pair, normal, standard)
    n, T = chain.n, frames[-1]
    place = f"O_{n} is at {format_vector(T[:3, 3])}, x_{n} along {format_vector(T[:3, 0])}."
    text = f"There is no next axis: z_{n} is parallel to z_{n - 1}, and the frame is as near the tool as that allows. {place}"
    others = "Any frame whose x intersects z_{n-1} at a right angle; the tool transform compensates for it."
    if not standard:
        d, theta = ("0", f"q_{n}") if table.joints[-1] == "R" else (f"q_{n}", "0")
        text = f"Frame {n} is placed such that d_{n} = {d} and theta_{n} = {theta}. {place} The tool transform leads from there to {{b}}."
        others = "Any other origin on the axis and any x perpendicular to it; d, theta and the tool change accordingly."
    yield AssignmentStep("last", n, text, others)
    length = partial(format_number, digits=6)  # the numbers of the table, and not their beginnings
    for i, (a, alpha, d, theta) in enumerate(format_rows(table, length=length, variable="q_{}".format), start=1):
        k = i if standard else i - 1
        yield AssignmentStep("row", i, f"Row {i}: a_{k} = {a}, alpha_{k} = {alpha}, d_{i} = {d}, theta_{i} = {theta}.")
    is_exact = found.accuracy < 1e-11
    text = f"This table describes the arm{', up to rounding' if is_exact else ' only approximately'}: at 24 "
    text += f"configurations its poses differ by at most {found.accuracy:.1e}."
    if any(normal.is_nearly_parallel for normal in normals) and not is_exact:
        text += " The nearly parallel axes limit its accuracy."
    yield AssignmentStep("accuracy", None, text)


def _joints(numbers: Sequence[int]) -> str:
    """Write "joint 2 is", "joints 1, 3 are" or "joints 1 to 6 are"."""
    is_run = len(numbers) > 2 and numbers[-1] - numbers[0] == len(numbers) - 1
    names = f"{numbers[0]} to {numbers[-1]}" if is_run else ", ".join(map(str, numbers))
    return f"joints {names} are" if len(numbers) > 1 else f"joint {names} is"


def _explain_link(frames: Array, pair: int, normal: CommonNormal, standard: bool) -> Iterator[AssignmentStep]:
    previous, T = frames
    i, j, frame = pair + 1, pair + 2, pair + 1
    length = format_number(float(np.linalg.norm(normal.end - normal.start)))
    text, others = CASES[normal.case].format(i=i, j=j, a=length), ALTERNATIVES[normal.case]
    if normal.is_nearly_parallel:
        text += f" These axes are nearly parallel, {normal.sine:.1e} rad apart, where DH is ill-conditioned: their normal may be "
        text += f"so far away that the last digits of d are lost. Here they are taken as {normal.case}."
    yield AssignmentStep("normal", frame, text, others)
    reason = "where the common normal meets it"
    if not normal.is_unique:
        reason = f"at joint {j}" if standard else "where d is 0"
        reason += ", because the normal may be at any point of the axes"
    text = f"O_{frame} lies on axis {j if standard else i}, {reason}: {format_vector(T[:3, 3])}."
    yield AssignmentStep("origin", frame, text, "" if normal.is_unique else ALTERNATIVES[normal.case])
    direction = "the same as before"
    if normal.case in {"skew", "parallel", "antiparallel"}:
        direction = "along the common normal, from axis to axis"
    elif normal.case == "intersecting":
        is_tie = abs(normal.x @ previous[:3, 0]) <= PARALLEL_TOL_RAD
        which = f"of the two directions that of axis {i} × axis {j}" if is_tie else "as near the previous x as possible"
        direction = f"perpendicular to both axes, {which}"
    others = "" if normal.case in {"parallel", "antiparallel"} else ALTERNATIVES[normal.case]
    yield AssignmentStep("x", frame, f"x_{frame} is {direction}: {format_vector(normal.x)}.", others)
    text = f"y_{frame} = z_{frame} × x_{frame} completes a right-handed frame: {format_vector(T[:3, 1])}."
    yield AssignmentStep("y", frame, text)
