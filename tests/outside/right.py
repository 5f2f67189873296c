"""The right answers, from the given values and the statement: a second solution of each problem, in plain NumPy and SymPy."""

import re
from collections.abc import Callable
from types import SimpleNamespace as Given
from typing import Any

import numpy as np
import sympy as sp

from outside import choices
from outside.motions import I3, Ad, Array, at, chain, exp, link, logarithm, pose, product, rot, rpy_matrix, turn

inv = np.linalg.inv
theta, a = sp.symbols("theta a")


def radians_of(values: Any, screws: Any) -> Array:
    """The joint values in radians and metres: the angles are given in degrees."""
    return np.array(np.where(np.asarray(screws)[:, :3].any(axis=1), np.radians(values), values))


def skew(w: Any) -> Any:
    """The matrix [w] in SymPy."""
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def rodrigues(w: Any, sine: Any = None, one_minus_cosine: Any = None) -> Any:
    """The rotation about a unit vector, as a formula."""
    sine = sp.sin(theta) if sine is None else sine
    one_minus_cosine = 1 - sp.cos(theta) if one_minus_cosine is None else one_minus_cosine
    return sp.eye(3) + sine * skew(w) + one_minus_cosine * skew(w) ** 2


def plane(g: Any) -> Array:
    """The motion of the plane of 01.3."""
    R, p = rot(I3[2], g.degrees)[:2, :2], np.asarray(g.p, dtype=float)
    column = R @ p if g.first == "shift" else p
    return np.array([*np.column_stack([R, column]), [0, 0, 1]])


def moved(g: Any, swap: bool = False) -> Array:
    """The pose of 01.9; with `swap` the sides of both motions are exchanged."""
    own, fixed = pose(rot(np.asarray(g.axis), g.degrees), [0] * 3), pose(np.eye(3), g.shift)
    if (g.own == "turn") == swap:
        own, fixed = fixed, own
    return product(fixed, g.T_sb, own)


def screw(w: Any, p: Any) -> Array:
    """The screw axis of a revolute joint."""
    return np.array([*w, *np.cross(p, w)])


def tilted(g: Any) -> Array:
    """The direction of 03.2."""
    c, s = np.cos(np.radians(g.degrees)), np.sin(np.radians(g.degrees))
    return np.array(c * np.asarray(g.from_axis) + s * np.asarray(g.towards))


def axes_to_screws(g: Any) -> Array:
    """The screws of axes through points, of revolute joints unless letters say otherwise."""
    letters = getattr(g, "letters", "R" * len(g.axes))
    return np.array(
        [[0, 0, 0, *d] if k == "P" else screw(d, p) for k, d, p in zip(letters, g.axes, g.points, strict=True)]
    )


def series_error(g: Any) -> float:
    """The distance of 02.4 in millimetres."""
    t = g.theta
    return float(1000 * g.radius * np.hypot(np.cos(t) - 1 + t**2 / 2, np.sin(t) - t))


def helix(g: Any) -> Any:
    """The motion of 02.5 as a formula."""
    w, p = sp.Matrix(g.axis), sp.Matrix(g.point)
    R = rodrigues(w)
    column = p - R * p + g.pitch * theta * w
    return sp.Matrix.vstack(R.row_join(column), sp.Matrix([[0, 0, 0, 1]]))


def jacobian(g: Any, q: Any) -> Array:
    """The body Jacobian, (n, 6), one row for each joint."""
    B = np.asarray(g.body_screws)
    e = [exp(b, x) for b, x in zip(B, q, strict=True)]
    return np.array([Ad(inv(product(np.eye(4), *e[i + 1 :]))) @ B[i] for i in range(len(B))])


def moved_columns(rows: Any, step: int) -> Array:
    """The rows of the other convention: a and alpha one row down (1) or up (-1), 0 in the empty row."""
    rows = np.array(rows, dtype=float)
    rows[:, :2] = np.roll(rows[:, :2], step, axis=0)
    rows[0 if step == 1 else -1, :2] = 0
    return rows


def exact(rpy: Any) -> Array:
    """The angles, of which those that are typed as 1.5708 are right angles."""
    return np.array(np.where(np.abs(np.abs(rpy) - 1.5708) < 1e-3, np.sign(rpy) * np.pi / 2, rpy))


def joints_of(text: str) -> list[Given]:
    """The joints of a URDF text, in order: origin, axis, mimic."""

    def numbers(name: str, of: str, missing: Any) -> Array:
        found = re.search(rf'{name}="([^"]*)"', of)
        return np.array([float(x) for x in found[1].split()] if found else missing)

    joints = []
    for block in re.findall(r"<joint.*?</joint>", text, re.DOTALL):
        elements = (re.search(rf"<{name}[^>]*>", block) for name in ("origin", "axis", "mimic"))
        origin, axis, mimic = (found[0] if found else "" for found in elements)
        joints.append(
            Given(
                xyz=numbers("xyz", origin, [0, 0, 0]),
                rpy=exact(numbers("rpy", origin, [0, 0, 0])),
                axis=numbers("xyz", axis, [1, 0, 0]),
                multiplier=float(numbers("multiplier", mimic, [1])[0]),
                offset=float(numbers("offset", mimic, [0])[0]),
            )
        )
    return joints


def frames_of(g: Any) -> list[Array]:
    """The poses of all joints in the base, at home."""
    poses = [np.eye(4)]
    for joint in joints_of(g.urdf):
        poses.append(poses[-1] @ pose(rpy_matrix(joint.rpy), joint.xyz))
    return poses[1:]


def last_axis(g: Any) -> Array:
    """The screw axis of joint 3 of a file."""
    T = frames_of(g)[2]
    return screw(T[:3, :3] @ joints_of(g.urdf)[2].axis, T[:3, 3])


def mimicked(g: Any, q2: Any = None) -> Array:
    """The place of the tool in 09.7."""
    swing, fold, weld = joints_of(g.urdf)
    q2 = fold.multiplier * g.q + fold.offset if q2 is None else q2
    T = product(
        pose(np.eye(3), swing.xyz), exp([*swing.axis, 0, 0, 0], g.q),
        pose(np.eye(3), fold.xyz), exp([*fold.axis, 0, 0, 0], q2), pose(np.eye(3), weld.xyz),
    )  # fmt: skip
    return np.array(T[:3, 3])


def to_point_C(bars: Any, A: float) -> list[tuple[float, float]]:
    """The angles of coupler and rocker in both modes, as np.arctan2 gives them."""
    g, crank, b, c = bars
    B, D = crank * np.array([np.cos(A), np.sin(A)]), np.array([g, 0])
    d = D - B
    r = float(np.linalg.norm(d))
    x = (r**2 + b**2 - c**2) / (2 * r)
    y = np.sqrt(b**2 - x**2)
    found = []
    for side in (1, -1):
        C = B + x * d / r + side * y * np.array([-d[1], d[0]]) / r
        found.append((float(np.arctan2(*(C - B)[::-1])), float(np.arctan2(*(C - D)[::-1]))))
    return found


def slider_x(g: Any) -> float:
    """The x of the slider in 08.4."""
    A = np.radians(g.degrees)
    return float(g.crank * np.cos(A) + np.sqrt(g.rod**2 - (g.offset - g.crank * np.sin(A)) ** 2))


def last_screw(g: Any) -> Array:
    """The screw axis of joint 3 of a standard table."""
    T = chain(np.asarray(g.rows)[:2], "standard")
    return screw(T[:3, 2], T[:3, 3])


def poe(S: Any, q: Any, M: Any) -> Array:
    """The pose by the product of exponentials."""
    return product(*map(exp, S, q), M)


def joint_origin(g: Any) -> Array:
    """The origin of joint 2 in the frame of joint 1, 10.4."""
    R = rpy_matrix(np.radians(g.rpy_1_in_degrees))
    return np.array(R.T @ (np.asarray(g.place_2) - g.xyz_1))


def rpy_of(R: Any) -> list[float]:
    """Roll, pitch and yaw of a rotation, by turning it back: first the yaw, then the pitch."""
    upright = np.hypot(R[0][0], R[1][0]) < 1e-6
    yaw = float(np.arctan2(-R[0][1], R[1][1]) if upright else np.arctan2(R[1][0], R[0][0]))
    rest = turn("z", -yaw) @ R
    pitch = float(np.arctan2(-rest[2, 0], rest[0, 0]))
    rest = turn("y", -pitch) @ rest
    return [float(np.arctan2(rest[2, 1], rest[1, 1])), pitch, yaw]


def hinge(g: Any) -> Array:
    """The hinge of 02.8: the intersection of two perpendicular bisectors, of the handle and of a point beside it."""
    ends = [[T[:2, 3] + s * T[:2, 1] for T in map(np.asarray, (g.T_1, g.T_2))] for s in (0, 1)]
    steps = np.array([b - a for a, b in ends])
    middles = np.array([(a + b) / 2 for a, b in ends])
    return np.array(np.linalg.solve(steps, (steps * middles).sum(axis=1)))


def screws_of_a_modified_table(g: Any) -> Array:
    """The screws of 06.9: z of frame i is the axis of joint i."""
    frames = [product(g.base, chain(g.rows[: i + 1], "modified")) for i in range(len(g.rows))]
    return np.array([screw(T[:3, 2], T[:3, 3]) for T in frames])


def gap(g: Any) -> Array:
    """The vector of 08.3, by complex numbers."""
    ground, crank, coupler, rocker = g.bars
    a, b, d = (np.exp(1j * np.radians(g.degrees[name])) for name in "ABD")
    z = crank * a + coupler * a * b - ground - rocker * d
    return np.array([z.real, z.imag])


def crank_and_coupler(g: Any) -> Array:
    """The lengths of 08.8 from the two extreme places of C."""
    far, near = (abs(g.ground + g.rocker * np.exp(1j * np.radians(x))) for x in sorted(g.degrees))
    return np.array([far - near, far + near]) / 2


def offset(g: Any) -> tuple[str, float]:
    """The joint of 10.11 and its offset: the one for which the offset of the first pose explains all others."""
    S, M = np.asarray(g.screws), g.home
    for k in range(len(S)):
        found = []
        for q, T in zip(g.q, g.poses, strict=True):
            e = list(map(exp, S, q))
            E = product(inv(product(np.eye(4), *e[: k + 1])), T, inv(product(np.eye(4), *e[k + 1 :], M)))
            found.append(logarithm(E) @ S[k] / (S[k] @ S[k]))
        off = found[0] * np.eye(len(S))[k]
        if all(np.allclose(poe(S, q + off, M), T, atol=1e-6) for q, T in zip(g.q, g.poses, strict=True)):
            return str(k + 1), float(found[0])
    raise AssertionError


RIGHT: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "01.3": ("matrix", plane),
    "01.4": ("vectors", lambda g: np.array([(g.T_sc @ [*g.point_c, 1])[:3], g.T_sc[:3, :3] @ g.arrow_c])),
    "01.5": ("pose", lambda g: inv(g.T_sg)),
    "01.6": ("pose", lambda g: inv(g.T_st) @ g.T_sc @ g.T_co),
    "01.9": ("pose", moved),
    "01.10": ("wrists", lambda g: np.array([rpy_of(np.asarray(R)) for R in (g.R_1, g.R_2)])),
    "02.8": ("vector", hinge),
    "03.2": ("vectors", lambda g: axes_to_screws(g)[:, 3:]),
    "03.7": ("pose", lambda g: product(*map(exp, g.screws[: g.link], g.q[: g.link]), g.camera_home)),
    "03.13": ("screws", axes_to_screws),
    "04.8": ("vector", lambda g: np.sort(np.abs([g.links @ np.array([1, s, t]) for s in (1, -1) for t in (1, -1)]))),
    "06.9": ("screws", screws_of_a_modified_table),
    "08.3": ("vector", gap),
    "08.8": ("vector", crank_and_coupler),
    "10.11": ("letter", offset),
    "02.1": ("rotation", lambda g: rot(np.array(g.direction) / np.linalg.norm(g.direction), g.degrees)),
    "02.2": ("formula", lambda g: rodrigues(g.omega)),
    "02.6": ("formula", lambda g: sp.Matrix(g.point) - rodrigues(g.omega) * sp.Matrix(g.point)),
    "02.4": ("millimetres", series_error),
    "02.3": ("pose", lambda g: exp([*g.omega, *g.v], g.seconds)),
    "02.7": ("vector", lambda g: logarithm(pose(g.R, [0, 0, 0]))[:3]),
    "02.5": ("formula", helix),
    "03.1": ("screws", axes_to_screws),
    "03.3": ("screw", lambda g: screw(tilted(g), g.point)),
    "03.4": ("screw", lambda g: screw(g.axis, g.point) + np.array([0, 0, 0, *g.lead / 2 / np.pi * np.array(g.axis)])),
    "03.8": ("pose", lambda g: poe(g.screws, g.q, g.home @ pose(I3, [0, 0, g.longer]))),
    "04.2": ("screws", lambda g: np.asarray(g.screws) @ Ad(inv(g.home)).T),
    "04.4": ("pose", lambda g: product(g.home, *map(exp, g.body_screws, radians_of(g.values, g.body_screws)))),
    "04.5": (
        "pose",
        lambda g: product(*(e := list(map(exp, g.screws, radians_of(g.values, g.screws))))[:2], g.home, *e[2:]),
    ),
    "04.6": ("screws", lambda g: np.asarray(g.body_screws) @ Ad(inv(g.T_bt)).T),
    "04.7": ("screw", lambda g: np.radians(g.rates) @ jacobian(g, np.radians(g.values))),
    "05.2": ("pose", lambda g: link((g.a, np.radians(g.alpha_degrees), g.d, np.radians(g.theta_degrees)), "standard")),
    "05.4": ("entries", lambda g: np.radians(np.diff([0, *g.headings_degrees]))),
    "05.7": (
        "vector",
        lambda g: np.array([
            *(x for i in (0, 1) for x in (np.hypot(*(np.diff(g.points, axis=0)[i, :2])), np.diff(g.points, axis=0)[i, 2])),
            np.angle(np.dot(np.diff(g.points, axis=0)[1], (1, 1j, 0)) / np.dot(np.diff(g.points, axis=0)[0], (1, 1j, 0))),
        ]),
    ),
    "05.6": ("pose", lambda g: product(g.base, chain(at(g.rows, "RR", g.q), "standard"), g.tool)),
    "06.1": ("pose", lambda g: link((g.a, g.alpha, g.d, g.theta), "modified")),
    "06.3": ("rows", lambda g: moved_columns(g.rows, 1)),
    "06.4": (
        "rotation",
        lambda g: chain(
            [(0, k * np.pi / 2, 0, np.radians(t)) for k, t in zip((-1, 1, -1), g.degrees, strict=True)], "modified"
        )[:3, :3],
    ),
    "06.2": ("pose", lambda g: chain(at(g.rows, "RPR", g.values * np.radians([1, 180 / np.pi, 1])), "modified")),
    "07.1": ("vector", lambda g: np.array([g.moved_to, g.a_1 + g.a_2 - g.moved_to])),
    "08.4": (
        "screw",
        lambda g: logarithm(
            product(
                exp(g.S["D"], np.radians(g.degrees["D"])), exp(g.S["C"], np.radians(g.degrees["C"])), g.G,
                exp(g.S["B"], -np.radians(g.degrees["B"])), exp(g.S["A"], -np.radians(g.degrees["A"])),
            )
        ),
    ),
    "08.5": ("angles", lambda g: np.array([D for _, D in to_point_C(g.bars, np.radians(g.degrees))])),
    "08.1": ("length", slider_x),
    "08.6": (
        "angles",
        lambda g: float(
            np.arccos((g.bars[0] ** 2 + g.bars[1] ** 2 - (g.bars[2] + g.bars[3]) ** 2) / (2 * g.bars[0] * g.bars[1]))
        ),
    ),
    "09.1": ("pose", lambda g: pose(rpy_matrix(exact(g.rpy)), g.xyz)),
    "09.3": ("vector", lambda g: frames_of(g)[2][:3, 3]),
    "09.4": ("screw", last_axis),
    "09.5": ("pose", lambda g: frames_of(g)[-1]),
    "09.7": ("vector", mimicked),
    "09.8": ("vector", lambda g: frames_of(g)[2][:3, :3].T @ g.omega),
    "10.1": ("screw", last_screw),
    "10.2": ("vector", joint_origin),
    "01.7": ("order", choices.rotations),
    "01.8": ("letter", choices.rigid_or_not),
    "03.6": ("order", choices.from_the_floor),
    "04.3": ("order", choices.around_home),
    "05.5": ("letter", choices.faulty_entry),
    "06.5": ("letter", choices.convention_of),
    "07.5": ("letter", choices.broken_rule),
    "07.7": ("letter", choices.same_arm),
    "08.2": ("letter", choices.grashof),
    "09.2": ("path", choices.path_through_a_tree),
    "09.6": ("origin", lambda g: np.array([[g.a, -g.d * np.sin(g.alpha), g.d * np.cos(g.alpha)], [g.alpha, 0, 0]])),
    "10.3": ("letter", choices.one_of_four),
}  # fmt: skip
"""For each problem the kind of its answer, and the function from its given values to the right answer."""

IN_A_DRAWING = {
    "pose": ["01.1"],
    "rotation": ["01.2"],
    "screw": ["03.5", "04.1"],
    "formula": ["03.9", "03.10"],
    "pose function": ["03.11"],
    "row": ["05.1"],
    "table": ["05.3", "06.7", "07.3", "07.4", "07.6"],
    "wrists": ["06.6"],
    "frames": ["07.2", "10.7"],
    "counts": ["08.7"],
    "screws": ["03.12", "04.9", "10.5"],
    "rows": ["05.8", "06.8", "10.6"],
    "vectors": ["07.8", "09.9", "10.4"],
    "letter": ["10.8", "10.10"],
    "millimetres": ["10.9"],
}
"""For each kind of answer the problems whose right answer is in a drawing, or is one of several, and so in no given value."""

read_from_a_drawing = {number for numbers in IN_A_DRAWING.values() for number in numbers}

RIGHT |= {number: (kind, lambda _: None) for kind, numbers in IN_A_DRAWING.items() for number in numbers}
