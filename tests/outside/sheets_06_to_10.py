"""Kinds of wrong answers that belong to one problem of sheets 06 to 10 alone."""

# fmt: off
from typing import Any

import numpy as np

from outside import Kinds, kinds_of, right_forms_of, shared
from outside.motions import I3, at, chain, exp, logarithm, pose, product, rpy_matrix
from outside.right import frames_of, joints_of, mimicked, moved_columns, screw, to_point_C
from outside.shared import DEGREES, ORDER, PLACE, SIGN, SIZE, SWAP, UNIT

LEFT_OUT = shared.LEFT_OUT + "|kept|left at"
MODE = "mode|other|twice|mirror|same|" + SIGN


@kinds_of("08.3")
def gap_of_points(g: Any, X: Any) -> Kinds:
    ground, crank, coupler, rocker = g.bars
    A, B, D = (np.radians(g.degrees[name]) for name in "ABD")

    def arrow(r: float, t: float) -> Any:
        return r * np.array([np.cos(t), np.sin(t)])

    first, second = arrow(crank, A) + arrow(coupler, A + B), [ground, 0] + arrow(rocker, D)
    branch = "branch|end|" + LEFT_OUT + "|term"
    return {
        "subtracted the other way": (-X, SIGN),
        "took B from the x axis": (arrow(crank, A) + arrow(coupler, B) - second, "angle|relative|x$ axis"),
        "subtracted B": (arrow(crank, A) + arrow(coupler, A - B) - second, "angle|sign"),
        "left out the ground": (first - arrow(rocker, D), branch + "|ground|at A"),
        "gave the first end": (first, branch),
        "gave the second end": (second, branch),
        "added the ends": (first + second, "add|sum|sign"),
        "left out the coupler": (arrow(crank, A) - second, branch + "|coupler"),
        "left out the crank": (arrow(coupler, A + B) - second, branch + "|crank"),
        "measured D from the other side": (first - [ground, 0] - arrow(rocker, np.pi - D), "angle|supplement|sign|cos|look"),
        "swapped sine and cosine": (X[::-1], SWAP + "|order"),
        "swapped the bars": (arrow(coupler, A) + arrow(crank, A + B) - second, "length|swap|bar|recogn"),
    }


@kinds_of("08.8")
def wiper(g: Any, X: Any) -> Kinds:
    far, near = X[1] + X[0], X[1] - X[0]
    swing = np.radians(abs(g.degrees[1] - g.degrees[0]))
    inner = [np.sqrt(g.ground**2 + g.rocker**2 - 2 * g.ground * g.rocker * np.cos(np.radians(x))) for x in g.degrees]
    bar = "half|halv|distance|coupler|crank|swap|length|order|2|factor"
    return {
        "gave the coupler first": (X[::-1], SWAP + "|first|order"),
        "did not halve": (2 * X, SIZE + "|half|halv"),
        "gave both distances": (np.array([far, near]), bar),
        "took the inner angle at D": (np.array([abs(inner[0] - inner[1]), sum(inner)]) / 2, "angle|corner|sign"),
        "took half of the chord": (np.array([g.rocker * np.sin(swing / 2), X[1]]), "chord|" + PLACE),
        "took half of the arc": (np.array([g.rocker * swing / 2, X[1]]), "arc|" + PLACE),
        "made the coupler as long as the ground": (np.array([X[0], g.ground]), "ground|" + PLACE),
        "gave the longer distance": (np.array([X[0], far]), "longer|" + PLACE),
        "gave the shorter distance": (np.array([X[0], near]), "shorter|" + PLACE),
        "subtracted the other way": (X * (-1, 1), SIGN),
        "left out the roots": (np.array([far**2 - near**2, far**2 + near**2]) / 2, "root|square"),
        "gave half of the coupler": (X * (1, 0.5), PLACE + "|half|twice"),
    }


@kinds_of("10.11")
def offset_of_a_joint(g: Any, X: Any) -> Kinds:
    k, x = X
    made: Kinds = {f"chose joint {j}": ((j, x), f"joint {j}") for j in "1234" if j != k}
    other = str(int(k) % 4 + 1)
    for label, (wrong, words) in {
        "took the other sign": (-x, SIGN), "gave degrees": (float(np.degrees(x)), DEGREES), "gave nothing": (0.0, "0|placeholder"),
        "gave double of it": (2 * x, SIZE), "gave half of it": (x / 2, SIZE), "gave half a turn more": (x + np.pi, "-"),
        "gave a thousandth": (x / 1000, "-"), "gave one": (1.0, "-"),
    }.items():
        made[label] = ((k, wrong), words)
        if words != "-":
            made[f"{label}, of another joint"] = ((other, wrong), f"joint {other}|{words}")
    return made


@kinds_of("06.3")
def converted(g: Any, X: Any) -> Kinds:
    rows = np.asarray(g.rows, dtype=float)
    return {
        "copied the rows": (rows, "given|same|copied|unchanged|convention|row"),
        "moved a and alpha the wrong way": (moved_columns(rows, -1), ORDER + "|way|wrong row|shift"),
        "rolled a and alpha round": (np.hstack([np.roll(rows[:, :2], 1, axis=0), rows[:, 2:]]), "last|first|empty|0|row"),
        "moved only a": (np.column_stack([X[:, 0], rows[:, 1:]]), "alpha|a"),
        "moved only alpha": (np.column_stack([rows[:, 0], X[:, 1], rows[:, 2:]]), "a"),
    }


@right_forms_of("06.3")
def legal_rows(g: Any, X: Any) -> dict[str, Any]:
    flip = X.copy()
    flip[1, :2] *= -1
    flip[:2, 3] += (np.pi, -np.pi)
    turned = X + 2 * np.pi * np.outer(np.arange(len(X)) == 1, np.arange(4) == 1)
    return {"x_1 reversed": flip, "an alpha with a turn more": turned}


@kinds_of("06.2")
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


@kinds_of("06.6")
def wrist_angles(g: Any, X: Any) -> Kinds:
    (a, b, c), (d, e, f) = X
    return {
        "turned theta_5 into pi - theta_5": (np.array([[a, np.pi - b, c], [d, e, f]]), "theta_5|\\theta_5|pi|supplement|sin|cos"),
        "turned theta_5 into theta_5 + pi": (np.array([[a, b + np.pi, c], [d, e, f]]), "theta_5|\\theta_5|pi|half a turn"),
        "negated theta_5": (np.array([[a, -b, c], [d, e, f]]), "theta_5|\\theta_5|" + SIGN),
        "believed 90 degrees to be singular": (np.array([[a, b, c], [d, np.pi / 2, f]]), "singular|theta_5|\\theta_5|90|middle"),
        "swapped theta_4 and theta_6": (np.array([[c, b, a], [d, e, f]]), SWAP),
    }


@right_forms_of("06.6")
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


@kinds_of("08.4")
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


@kinds_of("08.5")
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


@kinds_of("08.1")
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


@kinds_of("09.6")
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


@right_forms_of("09.6")
def legal_origins(g: Any, X: Any) -> dict[str, Any]:
    xyz, (roll, _, _) = X
    return {"a turn more": [xyz, [roll + 2 * np.pi, 0, 0]], "other angles of the same rotation": [xyz, [roll + np.pi, np.pi, np.pi]]}


@kinds_of("09.7")
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
