r"""Descriptions of one arm, held against each other and against measured poses: which one is wrong, and at which joint.

Every description is a product of constants and motions, T(q) = C_0 e^{S_1 q_1} C_1 ... e^{S_n q_n} C_n. To ask whether one joint
explains the difference to a log, the factors before and behind it are moved to the other side at each measured q:

    (factors before)^{-1} T_measured (factors behind)^{-1}

If all other joints are right, this is the factor of the joint in question, as it should be. It has the form of such a factor at
each q, with the same constants, only if the fault is there. The description itself never says where it is wrong.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.dh.table import DHTable, dh_transform
from kinlib.rigid.lie import exp, inverse, log
from kinlib.rigid.rpy import roll_pitch_yaw
from kinlib.urdf.robot_tree import Tree

POSITION_MM, ANGLE_DEG = 2.5, 0.5
"""What rounding and the tracker may do to a position and to an orientation; more than that is a fault."""

DIRECTIONS = np.concatenate([np.eye(3), -np.eye(3)])

Candidates = Callable[[Array, Array], Iterator[Array]]
"""Yields the factors of a place as they explain a log best, from what they must be at each q (m, n), both (m, 4, 4)."""


class Place(NamedTuple):
    """A place that a fault can have: the factors from start to end, and what else they may be."""

    start: int
    end: int
    candidates: Candidates


@dataclass(frozen=True, eq=False)
class Product:
    """A description as a product of constants and motions: factor 2 i is C_i, factor 2 i - 1 the motion of joint i.

    name       "screws", "table", ...
    constants  (n + 1, 4, 4) C_0 to C_n
    screws     (n, 6) S_1 to S_n, each in the frame at its place in the product
    places     what is examined, by name
    """

    name: str
    constants: Array
    screws: Array
    places: Mapping[str, Place]

    @property
    def n(self) -> int:
        """The number of joints."""
        return len(self.screws)

    def fk(self, q: ArrayLike) -> Array:
        """Compute the poses of the tool, (..., n) -> (..., 4, 4)."""
        return self._between(np.asarray(q, dtype=float), 0, 2 * self.n + 1)

    def _between(self, q: Array, start: int, end: int) -> Array:
        factors = [
            exp(self.screws[k // 2] * q[..., k // 2, None]) if k % 2 else self.constants[k // 2]
            for k in range(start, end)
        ]
        return reduce(np.matmul, factors, np.eye(4))

    def error_without(self, place: Place, log_: "Log") -> float:
        """Return the largest error against a log, in tolerances, with the factors of one place as they explain it best."""
        before, behind = self._between(log_.q, 0, place.start), self._between(log_.q, place.end, 2 * self.n + 1)
        wanted = inverse(before) @ log_.poses @ inverse(behind)
        return min(log_.error(before @ factors @ behind) for factors in place.candidates(wanted, log_.q))


@dataclass(frozen=True, eq=False)
class Log:
    """Measured poses of the tool at given joint values.

    q      (m, n) in radians and metres
    poses  (m, 4, 4) in {s}
    """

    q: Array
    poses: Array

    def __str__(self) -> str:
        """Write the log as the tracker prints it: joint values in radians and metres, x, y, z in mm, roll, pitch, yaw in degrees."""
        heads = [*(f"q{i}" for i in range(1, self.q.shape[1] + 1)), "x", "y", "z", "roll", "pitch", "yaw"]
        lines = ["".join(f"{head:>8}" for head in heads)]
        for q, T in zip(self.q, self.poses, strict=True):
            angles = np.degrees(roll_pitch_yaw(T[:3, :3]))
            cells = [f"{x:8.3f}" for x in q] + [f"{x:8.0f}" for x in 1000 * T[:3, 3]] + [f"{x:8.1f}" for x in angles]
            lines.append("".join(cells))
        return "\n".join(lines)

    def distances_mm(self, poses: Array) -> Array:
        """Return how far the tool is from where it was measured, in millimetres, (m,)."""
        gaps: Array = 1000 * np.linalg.norm(poses[:, :3, 3] - self.poses[:, :3, 3], axis=-1)
        return gaps

    def angles_deg(self, poses: Array) -> Array:
        """Return by which angle the tool is rotated against how it was measured, in degrees, (m,)."""
        angles: Array = np.degrees(np.linalg.norm(log(inverse(poses[:, :3, :3]) @ self.poses[:, :3, :3]), axis=-1))
        return angles

    def error(self, poses: Array) -> float:
        """Return the largest error in tolerances: at most 1 if all poses agree with the log."""
        return float(max(self.distances_mm(poses).max() / POSITION_MM, self.angles_deg(poses).max() / ANGLE_DEG))


@dataclass(frozen=True)
class Finding:
    """What was found about one description.

    name      the description
    worst_mm, worst_deg  how far off the tool is at worst, over the log, and by which angle it is rotated
    places    the places of which each alone explains the log; none if it agrees with it, or if no single place explains it
    off_mark  the first place that is not where the drawing has it, or ""
    agrees    whether it agrees with the log
    """

    name: str
    worst_mm: float
    worst_deg: float
    places: Sequence[str]
    off_mark: str
    agrees: bool

    @property
    def place(self) -> str:
        """The place of the fault: what explains the log and, if several do, is not where the drawing has it; "" if there is none."""
        if self.agrees or not self.places:
            return "" if self.agrees else self.off_mark
        return self.off_mark if self.off_mark in self.places else self.places[0]

    def __str__(self) -> str:
        if self.agrees and not self.off_mark:
            return f"{self.name}: agrees with the log (at worst {self.worst_mm:.1f} mm), and with the drawing."
        if self.agrees:
            return (
                f"{self.name}: the tool agrees with the log (at worst {self.worst_mm:.1f} mm), but not all marks are where the "
                "drawing has them. A description that is computed from another one does not know its marks: read them off the drawing."
            )
        head = f"{self.name}: off by {self.worst_mm:.0f} mm and {self.worst_deg:.0f}° at worst. "
        if not self.places:
            begins = f" The first place that differs from the drawing is {self.off_mark}." if self.off_mark else ""
            return f"{head}No single joint explains this: more than one is wrong.{begins}"
        if len(self.places) == 1 or self.place == self.off_mark:
            return f"{head}Look at {self.place}: with other numbers there, and only there, it would agree with the log."
        return f"{head}Look at {' or '.join(self.places)}: each of them alone would explain the log."


@dataclass(frozen=True, eq=False)
class Verification:
    """Several descriptions of one arm, and what was found about each.

    findings     a finding for each description
    differences  (k, k) how far apart the tools of each two are at worst over the log, in millimetres
    """

    findings: Sequence[Finding]
    differences: Array

    @property
    def passed(self) -> bool:
        """Whether there is a description, and every one agrees with the log and has the marks of the drawing."""
        return bool(self.findings) and all(finding.agrees and not finding.off_mark for finding in self.findings)

    def __getitem__(self, name: str) -> Finding:
        return next(finding for finding in self.findings if finding.name == name)

    def __str__(self) -> str:
        if not self.findings:
            return "There is nothing to verify yet: write a description in place of `...`."
        names = [finding.name for finding in self.findings]
        width = max(map(len, names)) + 2
        rows = [" " * width + "".join(f"{name:>{width}}" for name in names)]
        for name, row in zip(names, self.differences, strict=True):
            cells = ("agrees" if gap <= POSITION_MM else f"{gap:.0f} mm" for gap in row)
            rows.append(f"{name:<{width}}" + "".join(f"{cell:>{width}}" for cell in cells))
        return "\n".join([*rows, "", *map(str, self.findings)])


def of_screws(screws: ArrayLike, home: ArrayLike) -> Product:
    """The product of space screws (n, 6) and a home pose: e^{S_1 q_1} ... e^{S_n q_n} M."""
    S = np.asarray(screws, dtype=float)
    constants = np.array([*[np.eye(4)] * len(S), np.asarray(home, dtype=float)])
    return Product("screws", constants, S, _screw_places(len(S)) | {"M": _constant(len(S))})


def of_body_screws(screws: ArrayLike, home: ArrayLike) -> Product:
    """The product of body screws (n, 6) and a home pose: M e^{B_1 q_1} ... e^{B_n q_n}."""
    B = np.asarray(screws, dtype=float)
    constants = np.array([np.asarray(home, dtype=float), *[np.eye(4)] * len(B)])
    return Product("body screws", constants, B, _screw_places(len(B)) | {"M": _constant(0)})


def of_table(table: DHTable) -> Product:
    """The product of a standard table: joint i moves along and about z_{i-1}, before the constants of its row.

    Raises ValueError for a table in the modified convention, or with fixed rows.
    """
    if table.convention != "standard" or "F" in table.joints:
        raise ValueError(
            f"The table must be in the standard convention, with a joint in each row; got the {table.convention} convention and the "
            f"joints {table.joints}. The drawing prescribes standard frames."
        )
    n, along = table.n, np.array([np.eye(6)[2 if letter == "R" else 5] for letter in table.joints])
    links = table.link_transforms(np.zeros(n))
    constants = np.array([table.base, *links[:-1], links[-1] @ table.tool])
    ends = [*[np.eye(4)] * (n - 1), table.tool]
    rows = {
        f"row {i}": Place(2 * i - 1, 2 * i + 1, partial(_other_rows, i, axis, end))
        for i, (axis, end) in enumerate(zip(along, ends, strict=True), start=1)
    }
    places = {"the base": _constant(0), **rows, "the tool": _constant(n)}
    return Product("table", constants, along * table.signs[:, None], places)


def of_urdf(text: str) -> Product:
    """The product of a URDF file: P_1 e^{A_1 q_1} P_2 ... e^{A_n q_n} P_{n+1}, where fixed joints are part of the origins.

    Raises ValueError if the text is not a URDF of an open chain.
    """
    tree = Tree.from_urdf(text)
    constants, screws = [np.eye(4)], []
    for joint, _ in tree.path(tree.root, tree.tips[0]):
        constants[-1] = constants[-1] @ joint.origin
        if joint.moves:
            slides = joint.type == "prismatic"
            screws.append(np.concatenate([0 * joint.axis, joint.axis] if slides else [joint.axis, 0 * joint.axis]))
            constants.append(np.eye(4))
    joints = {
        f"joint {i}": Place(2 * i - 2, 2 * i, partial(_other_origins, i, S)) for i, S in enumerate(screws, start=1)
    }
    return Product("URDF", np.array(constants), np.array(screws), {**joints, "the tool": _constant(len(screws))})


def verify(products: Sequence[Product], log_: Log, off_marks: Mapping[str, str]) -> Verification:
    """Hold descriptions against each other and against a log.

    off_marks  for a description the first place that is not where the drawing has it, if there is one
    """
    poses = [product.fk(log_.q) for product in products]
    gaps = [[np.linalg.norm(one[:, :3, 3] - other[:, :3, 3], axis=-1).max() for other in poses] for one in poses]
    return Verification(
        [_find(product, log_, off_marks.get(product.name, "")) for product in products], 1000 * np.array(gaps)
    )


def _find(product: Product, log_: Log, off_mark: str) -> Finding:
    poses = product.fk(log_.q)
    agrees = log_.error(poses) <= 1
    fits = {} if agrees else {name: product.error_without(place, log_) for name, place in product.places.items()}
    places = [name for name, error in sorted(fits.items(), key=lambda item: item[1]) if error <= 1]
    worst_mm, worst_deg = float(log_.distances_mm(poses).max()), float(log_.angles_deg(poses).max())
    return Finding(product.name, worst_mm, worst_deg, places, off_mark, agrees)


def _screw_places(n: int) -> dict[str, Place]:
    return {f"joint {i}": Place(2 * i - 1, 2 * i, partial(_other_screw, i)) for i in range(1, n + 1)}


def _constant(i: int) -> Place:
    return Place(2 * i, 2 * i + 1, lambda wanted, _: iter([mean_pose(wanted)]))


def _other_screw(i: int, wanted: Array, q: Array) -> Iterator[Array]:
    """The factor of another screw of joint i: if one explains the log, the logarithm of the factor is that screw times q_i."""
    angle, twists = q[:, i - 1], log(wanted)
    usable = np.abs(angle) < np.pi
    S = angle[usable] @ twists[usable] / (angle[usable] @ angle[usable])
    yield exp(S * angle[:, None])


def _other_rows(i: int, along: Array, tool: Array, wanted: Array, q: Array) -> Iterator[Array]:
    """Another row i, before a tool: its motion is along z, of either sign, and its constants are those of a DH row."""
    for sign in (1, -1):
        motion = exp(sign * along * q[:, i - 1, None])
        yield motion @ nearest_row(mean_pose(inverse(motion) @ wanted @ inverse(tool))) @ tool


def _other_origins(i: int, screw: Array, wanted: Array, q: Array) -> Iterator[Array]:
    """Another origin of joint i, with its own axis or another one of the axes x, y and z."""
    half = 0 if screw[:3].any() else 3
    for axis in (screw[half : half + 3], *DIRECTIONS):
        motion = exp(np.roll([*axis, 0, 0, 0], half) * q[:, i - 1, None])
        yield mean_pose(wanted @ inverse(motion)) @ motion


def mean_pose(poses: Array) -> Array:
    """Return the pose that is nearest to several poses (m, 4, 4): the mean position, and the rotation nearest to the mean matrix.

    >>> mean_pose(np.array([np.eye(4), np.eye(4)]))[3].tolist()
    [0.0, 0.0, 0.0, 1.0]
    """
    mean: Array = poses.mean(axis=0)
    U, _, V = np.linalg.svd(mean[:3, :3])
    mean[:3, :3] = U @ np.diag([1, 1, np.linalg.det(U @ V)]) @ V
    return mean


def nearest_row(T: Array) -> Array:
    """Return a pose as a standard DH row makes it, with the four numbers that are read off T.

    A pose that is no DH row changes.
    """
    theta, alpha = np.arctan2(T[1, 0], T[0, 0]), np.arctan2(T[2, 1], T[2, 2])
    a = T[0, 3] * np.cos(theta) + T[1, 3] * np.sin(theta)
    return dh_transform(a, alpha, T[2, 3], theta, convention="standard")
