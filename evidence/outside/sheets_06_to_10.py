"""Kinds of wrong answers that belong to one problem of sheets 06 to 10 alone."""

# fmt: off
from typing import Any

import numpy as np
import sympy as sp

from evidence.outside import Kinds, kinds_of, right_forms_of, shared
from evidence.outside.motions import I3, at, chain, exp, link, logarithm, pose, product, rot, rpy_matrix
from evidence.outside.right import (
    axes_to_screws,
    frames_of,
    in_letters,
    inv,
    joint_origin,
    joints_of,
    mimicked,
    mobility,
    poe,
    screw,
    to_point_C,
)
from evidence.outside.shared import CENTI, DEGREES, ORDER, PLACE, SIGN, SIZE, SWAP, UNIT

LEFT_OUT = shared.LEFT_OUT + "|kept|left at"
JOINT = "joint|row|axis|point|column|q_|instead|belongs"
BARS = "bar|coupler|rocker|crank|swap"
MODE = "mode|other|twice|mirror|same|" + SIGN


@kinds_of("06.1")
def modified_row(g: Any, X: Any) -> Kinds:
    a, al, d, t = g.a, g.alpha, g.d, g.theta
    return {
        "used the standard convention": (link((a, al, d, t), "standard"), "standard|convention|order|revers|last|first"),
        "converted both once more": (link((a, np.radians(al), d, np.radians(t)), "modified"), DEGREES),
        "used degrees": (link((a, np.degrees(al), d, np.degrees(t)), "modified"), DEGREES),
        "wrote (a, 0, d)": (pose(X[:3, :3], [a, 0, d]), "d|z|rotat|position|left out"),
    }


@kinds_of("06.2")
def two_twists(g: Any, X: Any) -> Kinds:
    one, two = X
    return {
        "gave bare unit screws": (np.array([[1, 0, 0, g.a, 0, 0], [0, 0, 1, 0, 0, g.d]]), "unit|angle|theta|1|alpha"),
        "gave unit screws without lengths": (np.array([[1.0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0]]), "unit|angle|theta|left|length"),
        "gave pitches": (np.array([[1, 0, 0, g.a / g.alpha, 0, 0], [0, 0, 1, 0, 0, g.d / g.theta]]), "unit|angle|pitch|divide|theta"),
        "gave degrees": (np.array([[np.degrees(g.alpha), 0, 0, g.a, 0, 0], [0, 0, np.degrees(g.theta), 0, 0, g.d]]), DEGREES),
        "converted once more": (np.array([[np.radians(g.alpha), 0, 0, g.a, 0, 0], [0, 0, np.radians(g.theta), 0, 0, g.d]]), DEGREES),
        "turned both about z": (np.array([[0, 0, g.alpha, g.a, 0, 0], two]), "axis|x|" + ORDER + "|z"),
        "moved along z in both": (np.array([[g.alpha, 0, 0, 0, 0, g.a], two]), "axis|along|x|" + ORDER + "|z"),
        "put all of it in the first row": (np.array([one + two, 0 * two]), "both|row|one|sum|0"),
    }


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
        "moved all columns": (shifted([0, 1, 2, 3]), "row|d|theta"),
        "moved d and theta as well, wrong way": (shifted([2, 3]), "row|d|theta|a"),
        "gave theta in degrees": (X * (1, 1, 1, 180 / np.pi), DEGREES),
        "gave alpha in degrees": (X * (1, 180 / np.pi, 1, 1), DEGREES),
        "dropped the zero of a prismatic joint": (X * np.where(np.arange(4)[None, :] == 2, [[k != "P"] for k in g.joints], 1), "d|offset|q|left"),
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
        "gave millimetres": (np.array([row, column, 1000 * value]), UNIT),
        "gave the difference": (np.array([row, column, value - printed]), "difference"),
        "found the row only": (np.array([row, column % 4 + 1, value]), "column"),
        "found the column only": (np.array([row % len(g.rows) + 1, column, value]), "row"),
        "negated the value": (np.array([row, column, -value]), SIGN),
    }


@kinds_of("06.7")
def wrist_rotation(g: Any, X: Any) -> Kinds:
    def of(angles: Any, twists: Any = (-1, 1, -1), convention: str = "modified") -> Any:
        rows = [(0, k * np.pi / 2, 0, t) for k, t in zip(twists, angles, strict=True)]
        return chain(rows, convention)[:3, :3]

    q = np.radians(g.degrees)
    return {
        "left out the constant rotation": (product(rot(1, g.degrees[0]), rot(2, g.degrees[1]), rot(1, g.degrees[2])), "constant|alpha|R_x|Euler|" + LEFT_OUT),
        "used the standard convention": (of(q, convention="standard"), "standard|convention|order"),
        "forgot the twists": (of(q, (0, 0, 0)), "alpha|" + LEFT_OUT),
        "negated the twists": (of(q, (1, -1, 1)), SIGN + "|alpha"),
        "used the same twist three times": (of(q, (-1, -1, -1)), "alpha|" + SIGN),
        "forgot the first twist": (of(q, (0, 1, -1)), "alpha|" + LEFT_OUT + "|-90"),
        "used theta_4 for theta_6": (of([q[0], q[1], q[0]]), "theta_|\\theta|belongs|joint"),
    }


@kinds_of("06.8")
def rpr(g: Any, X: Any) -> Kinds:
    one, two, three = g.values
    q = np.array([np.radians(one), two, np.radians(three)])

    def of(q: Any = q, rows: Any = g.rows, convention: str = "modified", joints: str = "RPR") -> Any:
        return chain(at(rows, joints, q), convention)

    rows = np.asarray(g.rows)
    return {
        "multiplied the last row first": (chain(at(g.rows, "RPR", q)[::-1], "modified"), ORDER + "|revers|row|last"),
        "used the standard convention": (of(convention="standard"), "standard|convention|order|revers"),
        "took theta_1 for radians": (of([one, two, q[2]]), DEGREES),
        "took theta_3 for radians": (of([q[0], two, three]), DEGREES),
        "took both for radians": (of([one, two, three]), DEGREES),
        "converted the length too": (of(np.radians(g.values)), DEGREES + "|length"),
        "turned joint 2": (of(joints="RRR"), "prismatic|theta|d|column|rotat"),
        "added a and d on the position": (pose(X[:3, :3], [rows[1, 0], two, 0]), "rotat|position|left out|theta|\\theta"),
        "negated both angles": (of(q * (-1, 1, -1)), SIGN),
        "forgot the twists": (of(rows=rows * (1, 0, 1, 1)), "alpha|" + LEFT_OUT),
        "left out the a": (of(rows=rows * (0, 1, 1, 1)), LEFT_OUT),
        "swapped a and d of joint 2": (of(rows=np.where(np.eye(3)[1][:, None] * (np.arange(4) == 0), two, rows), q=[q[0], rows[1, 0], q[2]]), SWAP),
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
        "swapped the rows": (X[::-1], SWAP + "|row|R_1"),
        "halved the sum at the singular one wrongly": (np.array([[a, b, c], [f, e, f]]), "sum|singular|theta|twice"),
        "left the sum out at the singular one": (np.array([[a, b, c], [0, 0, 0]]), "sum|singular|0|zero|left"),
        "flipped only theta_4": (np.array([[a + np.pi, b, c], [d, e, f]]), "half a turn|theta_4|\\theta_4|pi|" + SIGN),
        "flipped theta_4 and theta_6, but not theta_5": (np.array([[a + np.pi, b, c + np.pi], [d, e, f]]), "theta_5|\\theta_5|" + SIGN + "|half a turn"),
        "wrote the difference at the singular one": (np.array([[a, b, c], [d, e, -f]]), SIGN + "|sum|difference"),
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
        "left frame 2 at {s}": (one(2, lambda X: np.eye(4)), words),
        "moved origin 1 off its axis": (one(1, lambda X: pose(X[:3, :3], X[:3, 3] + X[:3, 0] + X[:3, 1])), words),
        "moved origin 1 along z": (one(1, lambda X: pose(X[:3, :3], X[:3, 3] + X[:3, 2])), words),
        "turned x_1 off the normal": (one(1, lambda X: pose(X[:3, :3] @ rot(2, 90), X[:3, 3])), words),
        "turned z_2 about x": (one(2, lambda X: pose(X[:3, :3] @ rot(0, 90), X[:3, 3])), words),
        "wrote the axes of frame 1 in rows": (one(1, lambda X: pose(X[:3, :3].T, X[:3, 3])), words + "|R^T"),
        "put z on the joint of the same number": (T[[0, 0, 1, 2]], words),
        "gave relative poses": (np.array([T[0], *(inv(T[i]) @ T[i + 1] for i in range(len(T) - 1))]), words + "|before"),
    }


@right_forms_of("07.2")
def legal_frames(g: Any, T: Any) -> dict[str, Any]:
    def reversed_axes(signs: Any) -> Any:
        Y = np.array(T)
        Y[1:-1, :3, :3] *= signs
        return Y

    return {"inner x reversed": reversed_axes((-1, -1, 1)), "inner z reversed": reversed_axes((1, -1, -1))}


@kinds_of("07.7")
def drawn_elsewhere(g: Any, X: Any) -> Kinds:
    shift = g.moved_to - g.a_1
    return {
        "added the new place to a_1": (np.array([g.a_1 + g.moved_to, g.a_2 - g.moved_to]), "add|moved|from|x =|sum"),
        "gave the shift as a_1": (np.array([shift, X[1]]), "shift|displace|moved|difference|by how|x ="),
        "gave the shift as a_1, and the rest": (np.array([shift, g.a_1 + g.a_2 - shift]), "shift|displace|moved|difference|by how"),
        "left a_2": (np.array([X[0], g.a_2]), "a_2|sum|kept|unchanged|left"),
        "left a_1": (np.array([g.a_1, X[1]]), "a_1|kept|unchanged"),
        "added the shift to both": (np.array([X[0], g.a_2 + shift]), SIGN + "|sum|add"),
        "swapped the two": (X[::-1], SWAP),
        "left both": (np.array([g.a_1, g.a_2]), "given|unchanged|old|kept"),
        "forgot to subtract": (np.array([X[0], g.a_1 + g.a_2]), "sum|subtract|a_2|left"),
        "gave the sum": (np.array([g.moved_to, g.moved_to + g.a_2]), "sum|add|a_2|subtract"),
        "negated a_2": (X * (1, -1), SIGN),
    }


@kinds_of("08.1")
def residual(g: Any, X: Any) -> Kinds:
    q = {k: np.radians(v) for k, v in g.degrees.items()}

    def of(q: Any = q, *, back: bool = True, G: Any = g.G, order: str = "DC", way: str = "BA", sign: int = -1) -> Any:
        there = [exp(g.S[k], q[k]) for k in order]
        return product(*there, G, *([exp(g.S[k], sign * q[k]) for k in way] if back else []))

    absolute = q | {"B": q["B"] + q["A"]}
    absolute_c = q | {"C": q["C"] + q["D"]}
    from_rocker = q | {"C": q["C"] - q["D"]}
    T = of()
    return {
        "put G first": (logarithm(product(g.G, of(G=np.eye(4)))), ORDER + "|G|front|first"),
        "left B out": (logarithm(of(way="A")), LEFT_OUT + "|B"),
        "left out the way back": (logarithm(of(back=False)), "back|" + LEFT_OUT),
        "went back with the signs of the way there": (logarithm(of(sign=1)), SIGN + "|inver|back"),
        "went back over A first": (logarithm(of(way="AB")), ORDER + "|revers"),
        "swapped D and C": (logarithm(of(order="CD")), ORDER),
        "took the absolute angle of the coupler": (logarithm(of(absolute)), "absolute|B|angle|relative|x axis"),
        "took the absolute angle of C": (logarithm(of(absolute_c)), "absolute|C|angle|relative|x axis"),
        "took C from the x axis": (logarithm(of(from_rocker)), "absolute|C|angle|relative|x axis"),
        "took degrees for radians": (logarithm(of(dict(g.degrees))), DEGREES),
        "gave the position and no logarithm": (np.array([0, 0, X[2], T[0, 3], T[1, 3], 0]), "log|position|column"),
        "left A out": (logarithm(of(way="B")), LEFT_OUT + "|A"),
        "left C out": (logarithm(of(order="D")), LEFT_OUT + "|C"),
        "used A for D": (logarithm(of(q | {"D": q["A"]})), "A|D|belongs|angle"),
        "closed the wrong loop: the way back first": (logarithm(product(exp(g.S["A"], -q["A"]), exp(g.S["B"], -q["B"]), exp(g.S["D"], q["D"]), exp(g.S["C"], q["C"]), g.G)), ORDER),
    }


@kinds_of("08.2")
def both_modes(g: Any, X: Any) -> Kinds:
    A = np.radians(g.degrees)
    gr, a, b, c = g.bars
    (k1, D1), (k2, D2) = to_point_C(g.bars, A)
    B = a * np.array([np.cos(A), np.sin(A)])
    phi = float(np.arctan2(*(B - [gr, 0])[::-1]))

    def maybe(bars: Any) -> Any:
        try:
            with np.errstate(invalid="raise"):
                return np.array([D for _, D in to_point_C(bars, A)])
        except FloatingPointError:
            return X + 0.3

    words = BARS + "|" + ORDER
    return {
        "gave the coupler's angles": (np.array([k1, k2]), "coupler"),
        "gave one mode twice": (np.array([D1, D1]), MODE),
        "gave one mode and its negative": (np.array([D1, -D1]), MODE + "|line DB"),
        "gave the angles from DB": (X - phi, "DB|line|from|x axis"),
        "gave the inner angles at D": (np.pi - np.abs(X), "inner|supplement|pi"),
        "gave the inner angles in degrees": (180 - np.abs(np.degrees(X)), DEGREES),
        "gave the angles of the crank": (np.array([A, -A]), "crank|given|A"),
        "swapped coupler and rocker": (maybe((gr, a, c, b)), words),
        "swapped ground and crank": (maybe((a, gr, b, c)), words + "|ground"),
        "turned one angle into degrees": (np.array([np.degrees(D1), D2]), DEGREES),
        "measured from y": (np.pi / 2 - X, "y axis|pi/2|other axis|arc"),
    }


@kinds_of("08.3")
def coupler_points(g: Any, X: Any) -> Kinds:
    A = np.radians(g.degrees)
    a = g.bars[1]
    B = a * np.array([np.cos(A), np.sin(A)])
    (k1, D1), (k2, _) = to_point_C(g.bars, A)

    def carried(angle: float, x: float = g.along, y: float = g.left, start: Any = B) -> Any:
        c, s = np.cos(angle), np.sin(angle)
        return np.asarray(start) + [c * x - s * y, s * x + c * y]

    return {
        "took the other mode": (carried(k2), MODE),
        "did not turn": (B + [g.along, g.left], "rotat|turn|coupler|angle"),
        "started at A": (carried(k1, start=[0, 0]), "A|B|" + LEFT_OUT),
        "started at D": (carried(k1, start=[g.bars[0], 0]), "D|B"),
        "measured from C": (carried(k1, g.bars[2] - g.along), "C"),
        "turned by the crank's angle": (carried(A), "crank|coupler"),
        "turned by the rocker's angle": (carried(D1), "rocker|coupler"),
        "turned by the angle from the crank": (carried(k1 - A), "relative|crank|coupler|B"),
        "took degrees": (carried(k1, start=a * np.array([np.cos(g.degrees), np.sin(g.degrees)])), DEGREES),
        "gave B": (B, "B|" + LEFT_OUT),
        "gave C": (carried(k1, g.bars[2], 0), "C|B"),
        "gave centimetres": (100 * X, CENTI),
        "swapped x and y": (X[::-1], SWAP),
        "mirrored it": (X * (1, -1), SIGN + "|mirror"),
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
        "added under the root": (float(a * np.cos(A) + np.hypot(rod, e - a * np.sin(A))), SIGN + "|Pythag|root"),
        "forgot the root": (float(a * np.cos(A) + rod**2 - (e - a * np.sin(A)) ** 2), "root"),
        "gave the height": (e, "offset|height"),
        "forgot the height of B": (float(a * np.cos(A) + np.sqrt(rod**2 - e**2)), "height|" + LEFT_OUT),
        "gave B": (a * np.cos(A), "B|rod|crank|" + LEFT_OUT),
        "gave the distance from A": (float(np.hypot(X, e)), "distance|length"),
    }


@kinds_of("08.7")
def range_of_a_crank(g: Any, A: Any) -> Kinds:
    gr, a, b, c = g.bars

    def angle(one: float, two: float, opposite: float) -> float:
        x = (one**2 + two**2 - opposite**2) / (2 * one * two)
        return float(np.arccos(x)) if abs(x) <= 1 else np.nan

    square = (gr**2 + a**2 - b**2 - c**2) / (2 * gr * a)
    return {
        "gave the angle at D": (angle(gr, b + c, a), "at D|opposite|triangle|side"),
        "gave the angle at D as pi minus": (np.pi - angle(gr, b + c, a), "at D|opposite|triangle|supplement|side"),
        "gave the angle at B": (angle(a, b + c, gr), "at B|opposite|triangle|side"),
        "added the squares and not the sum": (float(np.arccos(square)) if abs(square) <= 1 else np.nan, "square|sum"),
        "took the folded chain": (angle(gr, a, abs(b - c)), "fold|difference|" + SIGN),
        "took the coupler alone": (angle(gr, a, b), BARS),
        "took the rocker alone": (angle(gr, a, c), BARS),
        "gave degrees of the supplement": (180 - np.degrees(A), DEGREES + "|supplement"),
        "gave the cosine": (np.cos(A), "cos"),
        "forgot the 2": (float(np.arccos(np.clip(2 * np.cos(A), -1, 1))) if abs(np.cos(A)) < 0.5 else A / 2, "2|factor|half|law|square"),
        "gave pi": (np.pi, "full|pi|turn"),
        "swapped crank and ground in the sum": (angle(gr, c, a + b), BARS),
        "took the crank stretched with the coupler": (angle(gr, a + b, c), BARS),
    }


@kinds_of("08.8")
def counted(g: Any, X: Any) -> Kinds:
    f = [x for leg in g.legs for x in leg]
    bodies = sum(len(leg) - 1 for leg in g.legs)
    d = g.d
    words = "bod|ground|platform|loop|joint|count|leg"
    made: Kinds = {
        "forgot the ground": (mobility(d, bodies + 1, f), words),
        "did not count the inner bodies": (mobility(d, 2, f), words),
        "counted one body for each joint": (mobility(d, len(f), f), words),
        "counted a body for each joint and the ground": (mobility(d, len(f) + 1, f), words),
        "counted N for N - 1": (mobility(d, bodies + 3, f), words),
        "took the other d": (mobility(9 - d, bodies + 2, f), "d =|plane|space"),
        "gave each joint one degree of freedom": (mobility(d, bodies + 2, np.ones(len(f))), "one|joint|universal|spherical"),
        "added all joints": (float(sum(f)), "loop|add|bod|sum|constraint"),
        "subtracted what the joints leave free": (float(d * (bodies + 1) - sum(f)), "constraint|freedom|" + SIGN),
        "counted one leg": (mobility(d, len(g.legs[0]) + 1, list(g.legs[0])), "leg|loop"),
        "added the mobility of each leg": (float(sum(sum(leg) for leg in g.legs) - d * len(g.legs)), "leg|loop|platform"),
        "counted one loop less": (float(sum(f) - d * (len(g.legs) - 2)), "loop|bod|leg"),
        "was off by one": (X + 1, "-"),
        "gave d": (float(d), "d|platform|free|loop"),
        "left out a leg": (float(sum(sum(leg) for leg in g.legs[:-1]) - d * (len(g.legs) - 2)), "leg"),
    }
    return {label: case for label, case in made.items() if case[0] != X}


@kinds_of("08.9")
def mobilities(g: Any, X: Any) -> Kinds:
    k, i, f = X
    rank = float(np.count_nonzero(np.asarray(g.singular_values) > 0))
    n = g.joint_values
    made: Kinds = {
        "gave the formula three times": (np.array([k, k, k]), "count|formula|same|kutzbach|finite|infinitesimal"),
        "gave the rank": (np.array([k, rank, f]), "rank"),
        "clipped at 0": (np.array([max(k, 0), i, f]), "negative|0|below"),
        "swapped the last two": (np.array([k, f, i]), SWAP),
        "gave the number of joints": (np.array([n, i, f]), "loop|joint|count"),
        "took the other d": (np.array([k + 3 * g.loops * (1 if n - 6 * g.loops == k else -1), i, f]), "d =|plane|space"),
        "believed the infinitesimal mobility": (np.array([k, i, i]), "infinitesimal|finite|move"),
        "counted the singular values": (np.array([k, n, f]), "singular|rank|joint"),
        "gave rows minus rank": (np.array([k, 6 * g.loops - rank, f]), "row|column|rank|equation"),
        "negated the first": (np.array([-k, i, f]), SIGN),
    }
    return {label: case for label, case in made.items() if np.abs(case[0] - X).max() > 0.1}


def _rpy_kinds(rpy: Any, then: Any) -> Kinds:
    r, _, y = rpy
    order = "yaw|pitch|roll|order|own axes|R_x|moving|fixed|revers"
    return {
        "rotated about its own axes": (then(rpy_matrix(rpy, "xyz")), order),
        "transposed R": (then(rpy_matrix(rpy).T), "transpos|R^T|inver|parent|" + SIGN),
        "rotated by the roll alone": (then(rpy_matrix([r, 0, 0])), order + "|" + LEFT_OUT + "|factor"),
        "rotated by the yaw alone": (then(rpy_matrix([0, 0, y])), order + "|" + LEFT_OUT + "|factor"),
        "multiplied R_y last": (then(rpy_matrix(rpy, "yxz")), order),
    }


@kinds_of("09.1")
def joint_pose(g: Any, X: Any) -> Kinds:
    return {
        **_rpy_kinds(g.rpy, lambda R: pose(R, g.xyz)),
        "rotated the position too": (pose(X[:3, :3], X[:3, :3] @ g.xyz), "rotat|position|xyz|first|order"),
        "swapped xyz and rpy": (pose(rpy_matrix(g.xyz), g.rpy), SWAP),
    }


@kinds_of("09.2")
def axis_direction(g: Any, X: Any) -> Kinds:
    return {
        **_rpy_kinds(g.rpy, lambda R: R @ g.axis),
        "gave the z axis of the frame": (rpy_matrix(g.rpy)[:, 2], "z|axis|column"),
        "gave no unit vector": (5 * X, SIZE + "|unit"),
        "added the origin": (X + [0, 0, 1], "point|origin|direction|position|xyz"),
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
        "forgot joint 1": (b.xyz + B @ c.xyz, LEFT_OUT + "|T_"),
        "rotated only by joint 1": (a.xyz + A @ (b.xyz + c.xyz), LEFT_OUT + "|rotat|R_"),
        "rotated only by joint 2": (a.xyz + b.xyz + B @ c.xyz, LEFT_OUT + "|rotat|R_"),
        "transposed both": (a.xyz + A.T @ (b.xyz + B.T @ c.xyz), "transpos|R^T|inver|" + SIGN),
        "multiplied in reverse": ((pose(rpy_matrix(c.rpy), c.xyz) @ pose(B, b.xyz) @ pose(A, a.xyz))[:3, 3], "revers|" + ORDER),
        "gave the position in the parent": (c.xyz, "parent|given|file|as it|xyz|left out"),
        "swapped joints 1 and 2": (b.xyz + B @ (a.xyz + A @ c.xyz), ORDER),
        "went back": (-(A @ B).T @ X, "inver|" + SIGN + "|back"),
        "used rpy of joint 3": (a.xyz + A @ (b.xyz + rpy_matrix(c.rpy) @ c.xyz), "rpy|joint|R_|belongs"),
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
        "used the origin in the parent": (screw(w, joints_of(g.urdf)[2].xyz), "point|origin|parent|parallel|xyz"),
        "used the point as the moment": (np.array([*w, *p]), "point|moment"),
        "transposed the rotation": (screw(T[2][:3, :3].T @ axis, p), "transpos|R^T"),
        "multiplied by 5": (5 * X, SIZE + "|unit"),
        "rotated about own axes": (screw(frames_of(g, "xyz")[2][:3, :3] @ axis, frames_of(g, "xyz")[2][:3, 3]), "order|own|roll|yaw|fixed|revers"),
        "added the positions": (screw(w, sum(j.xyz for j in joints_of(g.urdf))), "point|add|rotat|parallel|T_"),
    }


@kinds_of("09.5")
def home_of_a_file(g: Any, X: Any) -> Kinds:
    joints = joints_of(g.urdf)
    T = [pose(rpy_matrix(j.rpy), j.xyz) for j in joints]
    visual = g.urdf.split("<visual>")[1].split('xyz="')[1].split('"')[0]
    return {
        "put the weld first": (T[2] @ T[0] @ T[1], ORDER + "|weld|first|left"),
        "inverted the weld": (T[0] @ T[1] @ inv(T[2]), "inver|weld"),
        "forgot the weld": (T[0] @ T[1], LEFT_OUT + "|weld|fixed"),
        "added the visual": (X @ pose(I3, np.array(visual.split(), dtype=float)), "visual|drawing|mesh"),
        "multiplied in reverse": (product(*T[::-1]), "revers|" + ORDER),
        "rotated about own axes": (frames_of(g, "xyz")[-1], "order|own|roll|yaw|fixed|revers"),
        "left out joint 1": (T[1] @ T[2], LEFT_OUT),
        "left out joint 2": (T[0] @ T[2], LEFT_OUT),
        "added the positions": (pose(X[:3, :3], sum(j.xyz for j in joints)), "add|rotat|position"),
        "swapped joints 1 and 2": (T[1] @ T[0] @ T[2], ORDER),
        "used the weld twice": (product(*T, T[2]), "twice|weld"),
    }


@kinds_of("09.8")
def from_a_row(g: Any, X: Any) -> Kinds:
    (a, y, z), rpy = X
    d, along, degrees = g.d, "along|lean|turn|z", np.degrees(rpy)
    made = {
        "moved d along the old z": ([[a, 0, d], rpy], along + "|convention"),
        "moved d along x too": ([[a + d, 0, 0], rpy], along),
        "leaned the new z the other way": ([[a, -y, z], rpy], SIGN + "|lean|other way"),
        "swapped sine and cosine": ([[a, -z, -y], rpy], "sin|cos|" + SWAP),
        "swapped xyz and rpy": ([rpy, [a, y, z]], SWAP + "|order"),
        "gave alpha as the yaw": ([[a, y, z], rpy[::-1]], "yaw|roll|about x"),
        "gave alpha as the pitch": ([[a, y, z], rpy[[1, 0, 2]]], "pitch|roll|about x"),
        "negated the roll alone": ([[a, y, z], -rpy], "alpha|roll|" + SIGN),
        "left out the roll": ([[a, y, z], 0 * rpy], "roll|alpha|" + LEFT_OUT),
        "rotated a as well": ([[a * np.cos(g.alpha), a * np.sin(g.alpha), d], rpy], along + "|rotat"),
        "moved d along the old z, in degrees": ([[a, 0, d], degrees], along + "|" + DEGREES),
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
        "used the offset alone": (mimicked(g, o), "multiplier|offset|" + LEFT_OUT),
        "copied q_1": (mimicked(g, g.q), "multiplier|offset|same|copy|" + LEFT_OUT),
        "multiplied the sum": (mimicked(g, m * (g.q + o)), "multiplier|offset|bracket|order|first|sum"),
        "negated the multiplier": (mimicked(g, -m * g.q + o), SIGN),
        "subtracted the offset": (mimicked(g, m * g.q - o), SIGN),
        "divided by the multiplier": (mimicked(g, g.q / m + o), "divide|multipl"),
        "added the lengths": (sum(j.xyz for j in joints_of(g.urdf)), "add|rotat|q"),
        "forgot the height": (X * (1, 1, 0), "height|z|" + LEFT_OUT),
        "turned fold alone": (mimicked(type(g)(**{**vars(g), "q": 0.0}), m * g.q + o), "swing|q_1|first|" + LEFT_OUT + "|R_|rotat"),
    }


@kinds_of("09.10")
def axis_in_its_frame(g: Any, X: Any) -> Kinds:
    T = frames_of(g)
    R = [rpy_matrix(j.rpy) for j in joints_of(g.urdf)]
    w = np.asarray(g.omega)
    return {
        "left out joint 2": ((R[0] @ R[2]).T @ w, LEFT_OUT + "|joint|R_"),
        "rotated the other way": (T[2][:3, :3] @ w, "transpos|inver|direction|other way"),
        "left the numbers": (w, "given|unchanged|same|author|base|as they"),
        "used joint 3 alone": (R[2].T @ w, "joint|R_|left out"),
        "used joint 1 alone": (R[0].T @ w, "joint|R_|left out"),
        "used joints 1 and 2": (T[1][:3, :3].T @ w, "joint|R_|left out"),
        "multiplied in reverse": ((R[2] @ R[1] @ R[0]).T @ w, "revers|" + ORDER),
        "rotated about own axes": (frames_of(g, "xyz")[2][:3, :3].T @ w, "order|own|roll|yaw|fixed|revers"),
        "gave no unit vector": (5 * X, SIZE + "|unit"),
        "multiplied entry by entry": (np.prod(R, axis=0).T @ w, "entry"),
        "moved the vector as a point": (inv(T[2])[:3, :3] @ w + inv(T[2])[:3, 3], "point|direction|position|T"),
    }


@kinds_of("10.1")
def table_to_screw(g: Any, X: Any) -> Kinds:
    rows = np.asarray(g.rows)
    T2, T3, T1 = (chain(rows[:k], "standard") for k in (2, 3, 1))
    w, p = X[:3], T2[:3, 3]
    return {
        "swapped a and d": (screw(chain(rows[:2, [2, 1, 0, 3]], "standard")[:3, 2], chain(rows[:2, [2, 1, 0, 3]], "standard")[:3, 3]), SWAP),
        "used frame 3": (screw(T3[:3, 2], T3[:3, 3]), "frame|row|z_|A_|left out|T_"),
        "used frame 1": (screw(T1[:3, 2], T1[:3, 3]), "frame|row|z_|A_|left out|T_"),
        "used x for the axis": (screw(T2[:3, 0], p), "axis|x|z|column"),
        "used y for the axis": (screw(T2[:3, 1], p), "axis|y|z|column"),
        "used the point as the moment": (np.array([*w, *p]), "point|moment"),
        "used the modified convention": (screw(chain(rows[:2], "modified")[:3, 2], chain(rows[:2], "modified")[:3, 3]), "modified|convention|order"),
        "forgot the offsets": (screw(chain(rows[:2] * (1, 1, 1, 0), "standard")[:3, 2], chain(rows[:2] * (1, 1, 1, 0), "standard")[:3, 3]), "offset|theta|\\theta|left out"),
        "used the third row of R": (screw(T2[2, :3], p), "row|column|transpos|R^T"),
        "negated alpha": (screw(chain(rows[:2] * (1, -1, 1, 1), "standard")[:3, 2], chain(rows[:2] * (1, -1, 1, 1), "standard")[:3, 3]), SIGN),
        "used z of frame 2 with the origin of frame 1": (screw(w, T1[:3, 3]), "origin|point|frame|parallel|p_|T_"),
        "used z of frame 2 with the origin of frame 0": (np.array([*w, 0, 0, 0]), "moment|origin|left"),
        "gave the body screw": (np.array([0, 0, 1.0, 0, 0, 0]), "frame|body|own|{s}|base"),
    }


@kinds_of("10.4")
def origin_of_a_joint(g: Any, X: Any) -> Kinds:
    R = rpy_matrix(np.radians(g.rpy_1_in_degrees))
    a, b = np.asarray(g.xyz_1), np.asarray(g.place_2)
    return {
        "went from joint 2 to joint 1, not rotated": (a - b, SIGN + "|joint 2|parent|rotat|turn|" + LEFT_OUT),
        "swapped x and y": (X[[1, 0, 2]], SWAP + "|order"),
        "rotated the other way": (R @ (b - a), "transpos|inver|R^T|R_"),
        "rotated about own axes": (joint_origin(g, "xyz"), "order|own|roll|yaw|fixed|revers"),
        "subtracted after rotating": (R.T @ b - a, ORDER + "|rotat|first|bracket"),
        "left the place": (b, "given|{s}|unchanged|left out|same"),
    }


@kinds_of("10.5")
def position_in_letters(g: Any, X: Any) -> Kinds:
    (x, y, z), (q1, q2, t) = X, sp.symbols("q1 q2 t")
    radius = sp.cancel(x / sp.cos(q1))
    exchanged = in_letters(type(g)(**{**vars(g), "a": g.b, "b": g.a}))
    other = in_letters(type(g)(**{**vars(g), "slides": not g.slides}))
    words = "entry|entries|height|boom|q_2|joint 2|slide|" + PLACE
    return {
        "swapped sine and cosine of q_1": (sp.Matrix([y, x, z]), "sin|cos|" + SWAP),
        "turned clockwise": (sp.Matrix([x, -y, z]), SIGN + "|clockwise|sense"),
        "negated x": (sp.Matrix([-x, y, z]), SIGN),
        "left out joint 1": (X.subs(q1, 0), "joint 1|q_1|" + LEFT_OUT),
        "left out joint 2": (X.subs(q2, 0), words + "|" + LEFT_OUT),
        "moved joint 2 the other way": (X.subs(q2, -q2), SIGN + "|" + words),
        "swapped q_1 and q_2": (X.subs(q1, t).subs(q2, q1).subs(t, q2), SWAP + "|q_1|q_2"),
        "negated the height": (sp.Matrix([x, y, -z]) if g.slides else in_letters(g, -1), SIGN + "|height|mirror"),
        "left out the height": (sp.Matrix([x, y, 0]), words + "|" + LEFT_OUT),
        "swapped y and z": (sp.Matrix([x, z, y]), SWAP + "|" + ORDER),
        "swapped a and b": (exchanged, SWAP + "|a|b"),
        "took the other kind of joint": (other, "slide|turn|prismatic|revolute|rotat|translat"),
        "took degrees": (X.subs(q1, sp.pi * q1 / 180), DEGREES),
        "left out the radius": (sp.Matrix([sp.cos(q1), sp.sin(q1), z]), words + "|" + LEFT_OUT),
        "added the angles": (sp.Matrix([radius * sp.cos(q1 + q2), radius * sp.sin(q1 + q2), z]), "add|sum|plane|axis"),
    }


@kinds_of("10.6")
def crate(g: Any, X: Any) -> Kinds:
    n = np.asarray(g.joints)
    J, L = int(n.sum()), len(n)
    words = "loop|grasp|arm|crate|constraint|count|bod|d ="
    return {
        "added all joints": (float(J), words),
        "closed one loop": (float(J - 6), words),
        "closed a loop for each arm": (float(J - 6 * L), words),
        "counted the plane": (float(J - 3 * (L - 1)), words + "|plane"),
        "gave 6": (6.0, words + "|free"),
        "subtracted the crate": (X - 6, words),
        "added the crate": (X + 6, words),
        "counted only one arm": (float(n[0]), words),
        "gave the redundancy of each arm": (float((n - 6).sum()), words + "|6"),
        "was off by one": (X + 1, "-"),
    }


@kinds_of("10.7")
def pose_of_the_tool(g: Any, X: Any) -> Kinds:
    S, M, q = axes_to_screws(g), np.asarray(g.home), np.asarray(g.q)
    e = [exp(s, x) for s, x in zip(S, q, strict=True)]
    slide = np.abs(S[:, :3]).sum(axis=1) == 0
    flipped = np.where(slide[:, None], S, S * (1, 1, 1, -1, -1, -1))
    points = np.where(slide[:, None], S, np.hstack([g.axes, g.points]))
    return {
        "took the slide for a turn": (poe(g, S=np.array([screw(w, p) for w, p in zip(g.axes, g.points, strict=True)])), "slide|prismatic|revolute|turn"),
        "read (v, omega)": (poe(g, S=np.roll(S, 3, axis=1)), "halves|(v|" + ORDER),
        "converted the angles once more": (poe(g, q=np.where(slide, q, np.radians(q))), DEGREES),
        "took degrees for radians": (poe(g, q=np.where(slide, q, np.degrees(q))), DEGREES),
        "put M first": (product(M, *e), "first|" + ORDER + "|body"),
        "reversed the factors": (product(*e[::-1], M), "revers|" + ORDER),
        "took omega x q": (poe(g, S=flipped), SIGN + "|\\times"),
        "took the points as moments": (poe(g, S=points), "point|moment"),
        "left all moments at 0": (poe(g, S=np.where(slide[:, None], S, S * (1, 1, 1, 0, 0, 0))), "moment|point|origin|left out"),
        "used the point of the next joint": (poe(g, S=np.where(slide[:, None], S, np.hstack([g.axes, np.cross(np.roll(g.points, -1, 0), g.axes)]))), JOINT),
    }
