"""Kinds of wrong answers that belong to one problem of sheets 06 to 10 alone."""

# fmt: off
from typing import Any

import numpy as np

from outside import Kinds, kinds_of, right_forms_of, shared
from outside.motions import I3, at, chain, exp, logarithm, pose, product, rpy_matrix
from outside.right import (
    axes_to_screws,
    frames_of,
    joints_of,
    mimicked,
    poe,
    screw,
    to_point_C,
)
from outside.shared import DEGREES, ORDER, SIGN, SWAP, UNIT

LEFT_OUT = shared.LEFT_OUT + "|kept|left at"
JOINT = "joint|row|axis|point|column|q_|instead|belongs"
MODE = "mode|other|twice|mirror|same|" + SIGN


@kinds_of("06.3", "06.4")
def converted(g: Any, X: Any) -> Kinds:
    rows, down = np.asarray(g.rows, dtype=float), X[0, 0] == 0 and X[0, 1] == 0
    step = 1 if down else -1
    rolled = rows.copy()
    rolled[:, :2] = np.roll(rows[:, :2], step, axis=0)
    empty = 0 if down else -1

    def shifted(columns: list[int]) -> Any:
        Y = rows.copy()
        Y[:, columns] = np.roll(rows[:, columns], step, axis=0)
        Y[empty, columns] = 0
        return Y

    wrong_way = rows.copy()
    wrong_way[:, :2] = np.roll(rows[:, :2], -step, axis=0)
    wrong_way[-1 if down else 0, :2] = 0
    return {
        "copied the rows": (rows, "given|same|copied|unchanged|convention|row"),
        "moved a and alpha the wrong way": (wrong_way, ORDER + "|way|wrong row|shift"),
        "rolled a and alpha round": (rolled, "last|first|empty|0|row"),
        "moved only a": (shifted([0]), "alpha|a"),
        "moved only alpha": (shifted([1]), "a"),
    }


@right_forms_of("06.3", "06.4")
def legal_rows(g: Any, X: Any) -> dict[str, Any]:
    k = 1 if X[0, 0] == 0 and X[0, 1] == 0 else 0
    flip = X.copy()
    flip[k, :2] *= -1
    flip[:2, 3] += (np.pi, -np.pi)
    turned = X + 2 * np.pi * np.outer(np.arange(len(X)) == 1, np.arange(4) == 1)
    return {"x_1 reversed": flip, "an alpha with a turn more": turned}


@kinds_of("06.6")
def faulty_entry(g: Any, X: Any) -> Kinds:
    row, column, value = X
    printed = np.asarray(g.rows)[int(row) - 1, int(column) - 1]
    return {
        "counted from 0": (np.array([row - 1, column - 1, value]), "count|0|from 1"),
        "gave the value first": (np.array([value, row, column]), ORDER + "|first|value"),
        "swapped row and column": (np.array([column, row, value]), SWAP + "|order|first"),
        "gave the printed value": (np.array([row, column, printed]), "printed|table|same|given|as it"),
        "gave degrees": (np.array([row, column, np.degrees(value)]), DEGREES + "|unit"),
    }


@kinds_of("06.8")
def rpr(g: Any, X: Any) -> Kinds:
    one, two, three = g.values
    q = np.array([np.radians(one), two, np.radians(three)])

    def of(q: Any = q, rows: Any = g.rows, convention: str = "modified", joints: str = "RPR") -> Any:
        return chain(at(rows, joints, q), convention)

    return {
        "multiplied the last row first": (chain(at(g.rows, "RPR", q)[::-1], "modified"), ORDER + "|revers|row|last"),
        "used the standard convention": (of(convention="standard"), "standard|convention|order|revers"),
        "took theta_1 for radians": (of([one, two, q[2]]), DEGREES),
        "converted the length too": (of(np.radians(g.values)), DEGREES + "|length"),
        "turned joint 2": (of(joints="RRR"), "prismatic|theta|d|column|rotat"),
    }


@kinds_of("06.9")
def wrist_angles(g: Any, X: Any) -> Kinds:
    (a, b, c), (d, e, f) = X
    return {
        "turned theta_5 into pi - theta_5": (np.array([[a, np.pi - b, c], [d, e, f]]), "theta_5|\\theta_5|pi|supplement|sin|cos"),
        "turned theta_5 into theta_5 + pi": (np.array([[a, b + np.pi, c], [d, e, f]]), "theta_5|\\theta_5|pi|half a turn"),
        "negated theta_5": (np.array([[a, -b, c], [d, e, f]]), "theta_5|\\theta_5|" + SIGN),
        "believed 90 degrees to be singular": (np.array([[a, b, c], [d, np.pi / 2, f]]), "singular|theta_5|\\theta_5|90|middle"),
        "swapped theta_4 and theta_6": (np.array([[c, b, a], [d, e, f]]), SWAP),
    }


@right_forms_of("06.9")
def legal_wrists(g: Any, X: Any) -> dict[str, Any]:
    (a, b, c), (d, _, f) = X
    return {
        "the second solution": np.array([[a + np.pi, -b, c + np.pi], [d + 0.4, 0, f - 0.4]]),
        "a turn more": X + 2 * np.pi,
    }


@kinds_of("07.2")
def frames(g: Any, T: Any) -> Kinds:
    def one(i: int, change: Any) -> Any:
        Y = np.array(T)
        Y[i] = change(Y[i])
        return Y

    words = "axis|z_|x_|origin|frame|normal|rotat"
    return {
        "drew left-handed frames": (T * np.where(np.arange(4) == 1, -1, 1), words + "|handed"),
        "left every frame parallel to {s}": (np.array([pose(I3, X[:3, 3]) for X in T]), words + "|parallel"),
        "gave origins in millimetres": (np.array([pose(X[:3, :3], 1000 * X[:3, 3]) for X in T]), words + "|" + UNIT),
        **({} if abs(g.screws[1][2]) > 0.5 else {"left frame 1 with the axes of {s}": (one(1, lambda X: pose(I3, X[:3, 3])), words)}),
        "left frame 0 at {s}": (one(0, lambda X: np.eye(4)), words),
    }


@right_forms_of("07.2")
def legal_frames(g: Any, T: Any) -> dict[str, Any]:
    def reversed_axes(signs: Any) -> Any:
        Y = np.array(T)
        Y[1:-1, :3, :3] *= signs
        return Y

    return {"inner x reversed": reversed_axes((-1, -1, 1)), "inner z reversed": reversed_axes((1, -1, -1))}


@kinds_of("08.1")
def residual(g: Any, X: Any) -> Kinds:
    q = {k: np.radians(v) for k, v in g.degrees.items()}

    def of(q: Any = q, *, back: bool = True, G: Any = g.G, order: str = "DC", way: str = "BA", sign: int = -1) -> Any:
        there = [exp(g.S[k], q[k]) for k in order]
        return product(*there, G, *([exp(g.S[k], sign * q[k]) for k in way] if back else []))

    absolute = q | {"B": q["B"] + q["A"]}
    return {
        "put G first": (logarithm(product(g.G, of(G=np.eye(4)))), ORDER + "|G|front|first"),
        "left B out": (logarithm(of(way="A")), LEFT_OUT + "|B"),
        "left out the way back": (logarithm(of(back=False)), "back|" + LEFT_OUT),
        "went back with the signs of the way there": (logarithm(of(sign=1)), SIGN + "|inver|back"),
        "took the absolute angle of the coupler": (logarithm(of(absolute)), "absolute|B|angle|relative|x axis"),
    }


@kinds_of("08.2")
def both_modes(g: Any, X: Any) -> Kinds:
    A = np.radians(g.degrees)
    gr, a, _b, _c = g.bars
    (k1, D1), (k2, _D2) = to_point_C(g.bars, A)
    B = a * np.array([np.cos(A), np.sin(A)])
    phi = float(np.arctan2(*(B - [gr, 0])[::-1]))
    return {
        "gave the coupler's angles": (np.array([k1, k2]), "coupler"),
        "gave one mode twice": (np.array([D1, D1]), MODE),
        "gave one mode and its negative": (np.array([D1, -D1]), MODE + "|line DB"),
        "gave the angles from DB": (X - phi, "DB|line|from|x axis"),
        "gave the inner angles at D": (np.pi - np.abs(X), "inner|supplement|pi"),
    }


@kinds_of("08.3")
def coupler_points(g: Any, X: Any) -> Kinds:
    A = np.radians(g.degrees)
    a = g.bars[1]
    B = a * np.array([np.cos(A), np.sin(A)])
    (k1, _D1), (k2, _) = to_point_C(g.bars, A)

    def carried(angle: float, x: float = g.along, y: float = g.left, start: Any = B) -> Any:
        c, s = np.cos(angle), np.sin(angle)
        return np.asarray(start) + [c * x - s * y, s * x + c * y]

    return {
        "took the other mode": (carried(k2), MODE),
        "did not turn": (B + [g.along, g.left], "rotat|turn|coupler|angle"),
        "started at A": (carried(k1, start=[0, 0]), "A|B|" + LEFT_OUT),
        "started at D": (carried(k1, start=[g.bars[0], 0]), "D|B"),
        "measured from C": (carried(k1, g.bars[2] - g.along), "C"),
    }


@kinds_of("08.4")
def slider_crank(g: Any, X: Any) -> Kinds:
    a, rod, e, A = g.crank, g.rod, g.offset, np.radians(g.degrees)

    def of(e: float = e, A: float = A, side: int = 1, a: float = a, rod: float = rod) -> float:
        return float(a * np.cos(A) + side * np.sqrt(max(rod**2 - (e - a * np.sin(A)) ** 2, 0)))

    return {
        "took the other mode": (of(side=-1), MODE + "|left of B"),
        "measured the crank from y": (of(A=np.pi / 2 - A), "sin|cos|y axis|crank|angle"),
        "forgot the crank": (of() - a * np.cos(A), "crank|" + LEFT_OUT + "|from B"),
        "subtracted the crank": (of() - 2 * a * np.cos(A), SIGN + "|crank"),
        "added the lengths": (a + rod, "stretched|length|crank|rod|along|add"),
    }


@kinds_of("09.3")
def deep_joint(g: Any, X: Any) -> Kinds:
    a, b, c = joints_of(g.urdf)
    A, B = rpy_matrix(a.rpy), rpy_matrix(b.rpy)

    def with_order(order: str) -> Any:
        return a.xyz + rpy_matrix(a.rpy, order) @ (b.xyz + rpy_matrix(b.rpy, order) @ c.xyz)

    return {
        "left out joint 2": (a.xyz + A @ c.xyz, LEFT_OUT + "|joint 2|T_|rotat"),
        "added the positions": (a.xyz + b.xyz + c.xyz, "rotat|add|" + LEFT_OUT),
        "rotated about own axes": (with_order("xyz"), "order|own|fixed|roll|yaw|revers"),
        "stopped at joint 2": (a.xyz + A @ b.xyz, LEFT_OUT + "|joint 2|T_"),
        "transposed both": (a.xyz + A.T @ (b.xyz + B.T @ c.xyz), "transpos|R^T|inver|" + SIGN),
    }


@kinds_of("09.4")
def screw_of_a_file(g: Any, X: Any) -> Kinds:
    T = frames_of(g)
    axis = joints_of(g.urdf)[2].axis
    w, p = X[:3], T[2][:3, 3]
    return {
        "negated omega alone": (np.array([*-w, *X[3:]]), SIGN),
        "wrote the axis of the file": (screw(axis, p), "rotat|file|frame|axis|omega"),
        "rotated by the parent only": (screw(T[1][:3, :3] @ axis, p), "rotat|joint|R_|left out|T_"),
        "used z as the axis": (screw(T[2][:3, 2], p), "axis|z"),
        "used the origin of joint 2": (screw(w, T[1][:3, 3]), "point|origin|joint|parallel|T_"),
    }


@kinds_of("09.8")
def from_a_row(g: Any, X: Any) -> Kinds:
    (a, y, z), rpy = X
    d, along, _degrees = g.d, "along|lean|turn|z", np.degrees(rpy)
    made = {
        "moved d along the old z": ([[a, 0, d], rpy], along + "|convention"),
        "moved d along x too": ([[a + d, 0, 0], rpy], along),
        "leaned the new z the other way": ([[a, -y, z], rpy], SIGN + "|lean|other way"),
        "swapped sine and cosine": ([[a, -z, -y], rpy], "sin|cos|" + SWAP),
        "swapped xyz and rpy": ([rpy, [a, y, z]], SWAP + "|order"),
    }
    return {label: (np.array(case), words) for label, (case, words) in made.items()}


@right_forms_of("09.8")
def legal_origins(g: Any, X: Any) -> dict[str, Any]:
    xyz, (roll, _, _) = X
    return {"a turn more": [xyz, [roll + 2 * np.pi, 0, 0]], "other angles of the same rotation": [xyz, [roll + np.pi, np.pi, np.pi]]}


@kinds_of("09.9")
def mimic(g: Any, X: Any) -> Kinds:
    _, fold, _ = joints_of(g.urdf)
    m, o = fold.multiplier, fold.offset
    return {
        "measured fold from the base": (mimicked(g, m * g.q + o - g.q), "base|x$ axis|parent|q_1|fold|mimic"),
        "forgot the offset": (mimicked(g, m * g.q), "offset|" + LEFT_OUT),
        "forgot the multiplier": (mimicked(g, g.q + o), "multiplier|" + LEFT_OUT + "|factor"),
        "left fold at 0": (mimicked(g, 0.0), "0|mimic|fold|left out"),
        "negated the multiplier": (mimicked(g, -m * g.q + o), SIGN),
    }


@kinds_of("10.7")
def pose_of_the_tool(g: Any, X: Any) -> Kinds:
    S, M, q = axes_to_screws(g), np.asarray(g.home), np.asarray(g.q)
    e = [exp(s, x) for s, x in zip(S, q, strict=True)]
    slide = np.abs(S[:, :3]).sum(axis=1) == 0
    np.where(slide[:, None], S, np.hstack([g.axes, g.points]))
    return {
        "took the slide for a turn": (poe(g, S=np.array([screw(w, p) for w, p in zip(g.axes, g.points, strict=True)])), "slide|prismatic|revolute|turn"),
        "read (v, omega)": (poe(g, S=np.roll(S, 3, axis=1)), "halves|(v|" + ORDER),
        "converted the angles once more": (poe(g, q=np.where(slide, q, np.radians(q))), DEGREES),
        "put M first": (product(M, *e), "first|" + ORDER + "|body"),
        "reversed the factors": (product(*e[::-1], M), "revers|" + ORDER),
    }
