"""Kinds of wrong answers that belong to one problem of sheets 01 to 05 alone."""

# fmt: off
from typing import Any

import numpy as np
import sympy as sp

from outside import Kinds, kinds_of, right, shared
from outside.motions import I3, Ad, exp, hat, logarithm, pose, product, rot
from outside.right import inv, moved, radians_of, rodrigues, screw, skew, theta
from outside.shared import DEGREES, ORDER, PLACE, PLACEHOLDER, POINT, SIGN, SIZE, SWAP

LEFT_OUT = shared.LEFT_OUT + "|not rotat|kept"
INVERSE = "inver|transpos|R^T|other way|direction|T_{"
JOINT = "joint|row|axis|point|column|q_|instead|belongs"


@kinds_of("01.1")
def pose_from_a_drawing(g: Any, T: Any) -> Kinds:
    R, p = T[:3, :3], T[:3, 3]
    return {
        "left the height at 0": (pose(R, p * (1, 1, 0)), PLACEHOLDER + "|height|" + PLACE),
        "swapped the x and the y axis": (pose(R[:, [1, 0, 2]], p), ORDER + "|axes|left-handed|" + SIGN),
        "read x for the height": (pose(R, p[[2, 1, 0]]), SWAP + "|sizes"),
        "miscounted the height by one": (pose(R, p + [0, 0, 1]), PLACE + "|height"),
        "took the z axis as pointing down": (pose(R @ np.diag([1, -1, -1]), p), SIGN + "|" + PLACE),
    }


@kinds_of("01.4")
def rod(g: Any, X: Any) -> Kinds:
    R, p = g.T_sc[:3, :3], g.T_sc[:3, 3]
    x, d = np.asarray(g.point_c), np.asarray(g.arrow_c)
    return {
        "translated before rotating": (np.array([R @ (x + p), X[1]]), ORDER + "|first|point|position"),
        "added the origin to the vector": (np.array([X[0], X[1] + p]), "vector|direction|point"),
        "gave both ends": (np.array([X[0], X[0] + X[1]]), "end"),
        "rotated only the point": (np.array([X[0], d]), LEFT_OUT + "|unchanged"),
        "subtracted the origin": (np.array([R @ x - p, X[1]]), SIGN),
    }


@kinds_of("01.9")
def own_or_fixed(g: Any, X: Any) -> Kinds:
    turn, shift = pose(rot(np.asarray(g.axis), g.degrees), [0] * 3), pose(I3, g.shift)
    return {
        "swapped the two sides": (moved(g, swap=True), ORDER + "|left|right"),
        "made both about own axes": (g.T_sb @ turn @ shift, ORDER + "|left|right|last|first"),
        "left the pose as it was": (np.asarray(g.T_sb), "unchanged|given|as it is|left out|T_{sb}"),
        "forgot the first pose": (turn @ shift, LEFT_OUT),
    }


@kinds_of("01.10")
def three_angles(g: Any, X: Any) -> Kinds:
    R_1, R_2 = np.asarray(g.R_1), np.asarray(g.R_2)
    back = [right.rpy_of(R.T) for R in (R_1, R_2)]
    first, last = X.copy(), X.copy()
    first[0, 0] += np.pi
    last[0, 2] += np.pi
    only = X.copy()
    only[0, 1] = np.pi / 2 - X[0, 1]
    angles = "angle|order|sign|turn|transpos|roll|yaw|pitch|0|degree"
    return {
        "gave yaw, pitch, roll": (X[:, ::-1], angles),
        "used the transposes": (np.array(back), angles + "|inver"),
        "negated every angle": (-X, angles),
        "negated the pitch": (X * (1, -1, 1), angles),
        "took the roll half a turn off": (first, angles),
        "took the yaw half a turn off": (last, angles),
        "gave degrees": (np.degrees(X), DEGREES),
        "left the roll at 0": (X * (0, 1, 1), angles),
        "left the yaw at 0": (X * (1, 1, 0), angles),
        "swapped the rows": (X[::-1], SWAP + "|row"),
        "took the cosine of the pitch": (only, angles + "|row|entry"),
        "left all at 0": (0 * X, PLACEHOLDER),
    }


@kinds_of("02.8")
def hinge_of_a_door(g: Any, X: Any) -> Kinds:
    T_1, T_2 = np.asarray(g.T_1), np.asarray(g.T_2)
    other = inv(T_1) @ T_2

    def still(T: Any) -> Any:
        return np.linalg.solve(I3[:2, :2] - T[:2, :2], T[:2, 3])

    frame = "frame|order|door|position|inver"
    return {
        "took the motion in the frame of the door": (still(other), frame),
        "multiplied without inverting": (still(T_2 @ T_1), frame),
        "inverted the other one, in the wrong order": (still(inv(T_2) @ T_1), frame),
        "took the middle": ((T_1[:2, 3] + T_2[:2, 3]) / 2, "half|middle"),
        "gave the first position": (T_1[:2, 3], "position|first"),
        "gave the second position": (T_2[:2, 3], "position|second"),
        "gave the step": (T_2[:2, 3] - T_1[:2, 3], "vector|step|between"),
        "gave the translation part": ((T_2 @ inv(T_1))[:2, 3], "translation|position"),
        "mirrored it": (T_1[:2, 3] + T_2[:2, 3] - X, "mirror"),
        "swapped x and y": (X[::-1], SWAP + "|order"),
    }


@kinds_of("03.2")
def at_sight(g: Any, X: Any) -> Kinds:
    w, p = np.asarray(g.axes, dtype=float), np.asarray(g.points, dtype=float)
    sizes = np.linalg.norm(X, axis=1, keepdims=True)
    return {
        "used the left hand": (-X, SIGN + "|minus"),
        "gave the directions only": (X / sizes, "size|length|unit|direction"),
        "gave the axes": (w, "axis|direction"),
        "gave the points": (p, POINT),
        "gave the distance along the axis": (sizes * w, "along|axis"),
        "gave the feet": (p - (p * w).sum(axis=1, keepdims=True) * w, POINT + "|moment"),
        "used the left hand for axis 2": (X * [[1], [-1], [1]], SIGN),
        "took the distance of the mark": (X / sizes * np.linalg.norm(p, axis=1, keepdims=True), SIZE + "|look|entry|row|1 of|2 of"),
        "gave 0": (0 * X, PLACEHOLDER),
    }


@kinds_of("03.7")
def camera(g: Any, X: Any) -> Kinds:
    e, M, k = list(map(exp, g.screws, g.q)), np.asarray(g.camera_home), g.link
    link = "joint|factor|link|" + ORDER + "|" + LEFT_OUT
    return {
        "used all joints": (product(*e, M), link),
        "used one joint fewer": (product(*e[: k - 1], M), link),
        "used the joint of the link alone": (e[k - 1] @ M, link),
        "used the joints behind it": (product(*e[k:], M), link),
        "put M first": (product(M, *e[:k]), link + "|first"),
        "reversed the factors": (product(*e[:k][::-1], M), link),
        "left out M": (product(*e[:k]), link),
        "stayed at home": (M, "home|" + LEFT_OUT),
        "added the twists": (exp(g.q[:k] @ g.screws[:k]) @ M, "sum|exponential"),
        "turned every joint backwards": (product(*(exp(s, -x) for s, x in zip(g.screws[:k], g.q[:k], strict=True)), M), SIGN),
        "took the values of the next joints": (product(*map(exp, g.screws[:k], g.q[1 : k + 1]), M), "q|value|joint"),
    }


@kinds_of("03.13", "06.9")
def screws_of_a_robot(g: Any, S: Any) -> Kinds:
    w = S[:, :3]
    p = np.cross(w, S[:, 3:])
    base = np.asarray(g.base)[:3, 3] if hasattr(g, "base") else np.asarray(g.points)[0]
    before = np.vstack([S[:1], S[:-1]])
    return {
        "measured from the base": (np.hstack([w, np.cross(p - base, w)]), "base|origin|from|" + POINT),
        "left the base on the floor": (np.hstack([w, np.cross(p - base * (0, 0, 1), w)]), "height|stand|" + POINT + "|" + PLACE),
        "took the points as moments": (np.hstack([w, p]), POINT),
        "took each axis one joint late": (before, ORDER + "|joint|row|before"),
        "counted from the tool": (S[::-1], ORDER + "|last"),
        "read one length as another": (S + np.outer(np.arange(len(S)) > 2, (0, 0, 0, 0.1, 0, 0)), PLACE + "|joint|" + POINT),
        "took the third axis the other way": (S * np.where(np.arange(len(S)) == 2, -1, 1)[:, None], SIGN),
        "wrote every axis as z": (np.hstack([0 * w + (0, 0, 1), np.cross(p, (0, 0, 1))]), "axis|direction|omega|" + PLACE),
    }


@kinds_of("04.8")
def planar_arm(g: Any, X: Any) -> Kinds:
    a, b, c = g.links
    signed = [g.links @ np.array([1, s, t]) for s in (1, -1) for t in (1, -1)]
    term = "distance|term|sign|left out|entry|link|look|order|order|numbers|1 of|2 of|3 of|size"
    return {
        "left a distance negative": (np.sort(signed), SIGN + "|size|" + term),
        "put the largest first": (X[::-1], ORDER + "|largest"),
        "gave sums of two links": (np.sort([a + b, b + c, a + c, a + b + c]), "two links|sum|" + term),
        "gave differences of two links": (np.sort([abs(a - b), abs(b - c), abs(a - c), a + b + c]), "two links|difference|" + term),
        "measured from joint 2": (np.sort([abs(b - c), b + c] * 2), "joint 2|" + term),
        "gave the stretched arm four times": (np.full(4, a + b + c), "stretched|same|all"),
        "put the folded tip on joint 1": (np.array([0, 0, 0, a + b + c]), "joint 1|0|folded|zero"),
        "left out the last link": (np.sort([a + b, abs(a - b)] * 2), term),
        "squared them": (X**2, "square"),
        "gave the reach of each link": (np.sort([a, b, c, a + b + c]), term + "|recogn"),
        "folded one link twice": (np.sort([a + b - c, a + b - c, a - b + c, a + b + c]), term + "|recogn"),
    }


@kinds_of("02.1")
def given_axis(g: Any, X: Any) -> Kinds:
    w, degrees = np.asarray(g.direction, dtype=float), g.degrees
    u, t = w / np.linalg.norm(w), np.radians(degrees)
    s, c, W = np.sin(t), np.cos(t), hat(u)
    return {
        "used the vector as it is": (I3 + s * hat(w) + (1 - c) * hat(w) @ hat(w), SIZE + "|unit"),
        "used cos for 1 - cos": (I3 + s * W + c * W @ W, "cos"),
        "used 1 + cos": (I3 + s * W + (1 + c) * W @ W, "cos|sign"),
        "left out the square": (I3 + s * W, LEFT_OUT + "|term"),
        "swapped sin and 1 - cos": (I3 + (1 - c) * W + s * W @ W, SWAP + "|sin|cos"),
    }


@kinds_of("02.2")
def rotation_formula(g: Any, X: Any) -> Kinds:
    w = sp.Matrix(g.omega)
    W, c = skew(w), sp.cos(theta)
    return {
        "used cos for 1 - cos": (rodrigues(w, one_minus_cosine=c), "cos"),
        "used 1 + cos": (rodrigues(w, one_minus_cosine=1 + c), "cos|sign"),
        "used theta^2/2 for 1 - cos": (rodrigues(w, one_minus_cosine=theta**2 / 2), "cos|series|term|\\theta"),
        "left out I": (rodrigues(w) - sp.eye(3), LEFT_OUT + "|I$"),
        "left out sin": (sp.eye(3) + W + (1 - c) * W**2, "sin|" + LEFT_OUT),
    }


@kinds_of("02.6")
def origin_goes(g: Any, X: Any) -> Kinds:
    w, p = sp.Matrix(g.omega), sp.Matrix(g.point)
    R, W = rodrigues(w), skew(w)
    v, s, c = -W * p, sp.sin(theta), sp.cos(theta)
    t = theta
    swapped = sp.Matrix([p[1], p[2], p[0]])
    return {
        "used cos for 1 - cos in G": (t * v + c * W * v + (t - s) * W * W * v, "cos"),
        "used sin for theta - sin in G": (t * v + (1 - c) * W * v + s * W * W * v, "sin|theta"),
        "permuted the point": (swapped - R * swapped, POINT + "|" + ORDER),
        "gave R p": (R * p, "R|point"),
        "gave v theta": (v * t, "straight|v|term"),
    }


@kinds_of("02.4")
def series(g: Any, X: Any) -> Kinds:
    t, mm = g.theta, 1000 * g.radius
    two = np.hypot(np.cos(t) - 1, np.sin(t) - t)
    four = np.hypot(np.cos(t) - 1 + t**2 / 2, np.sin(t) - t + t**3 / 6)
    return {
        "stopped after two terms": (two * mm, "two terms|term|three"),
        "stopped after four terms": (four * mm, "four|term"),
        "gave the next term": (t**3 / 6 * mm, "term"),
        "gave only the error of the sine": (abs(np.sin(t) - t) * mm, "sine|cos|component|direction"),
        "gave only the error of the cosine": (abs(np.cos(t) - 1 + t**2 / 2) * mm, "cosine|sin|component|direction"),
    }


@kinds_of("02.7")
def logarithm_near_half_a_turn(g: Any, x: Any) -> Kinds:
    t = np.linalg.norm(x)
    u = x / t
    return {
        "went round once more": (u * (t + 2 * np.pi), "turn|angle|long|direction"),
        "gave the axis alone": (u, "axis|angle|unit|length"),
        "gave degrees": (np.degrees(x), DEGREES),
        "used the arcsine": (u * (np.pi - t), "arcsin|supplement|angle|pi"),
        "went the long way": (-u * (2 * np.pi - t), "long|other|angle|" + SIGN),
    }


@kinds_of("02.5")
def helical_formula(g: Any, X: Any) -> Kinds:
    w, p, h = sp.Matrix(g.axis), sp.Matrix(g.point), g.pitch
    R = rodrigues(w)
    last = sp.Matrix([[0, 0, 0, 1]])

    def made(column: Any, R: Any = R) -> Any:
        return sp.Matrix.vstack(R.row_join(column), last)

    turn = p - R * p
    climb = h * theta * w
    return {
        "climbed on all three axes": (made(turn + h * theta * sp.ones(3, 1)), "climb|pitch|axes|" + PLACE),
        "climbed along the point": (made(turn + h * theta * p), "climb|point"),
        "climbed along the next axis": (made(turn + h * theta * sp.Matrix([w[2], w[0], w[1]])), "climb|axis|another"),
        "did not climb": (made(turn), "climb|pitch"),
        "multiplied the climb by 2 pi": (made(turn + 2 * sp.pi * climb), "2\\pi|climb"),
    }


@kinds_of("03.1")
def plain_arm(g: Any, S: Any) -> Kinds:
    d, p = np.asarray(g.axes), np.asarray(g.points)
    slide = np.array([[k == "P"] for k in g.letters])
    return {
        "moved the slide backwards": (np.where(slide, -S, S), SIGN),
        "took the points as moments": (np.where(slide, S, np.hstack([d, p])), POINT),
        "took a prismatic joint for a revolute one": (np.hstack([d, np.cross(p, d)]), "prismatic|slide|translation"),
        "wrote the direction of the slide in omega": (np.where(slide, np.hstack([d, 0 * d]), S), "omega|translation|prismatic|v"),
        "used the point of the next joint": (np.where(slide, S, np.hstack([d, np.cross(np.roll(p, -1, 0), d)])), JOINT),
    }


@kinds_of("03.3")
def tilted_joint(g: Any, S: Any) -> Kinds:
    u, t, p = map(np.asarray, (g.from_axis, g.towards, g.point))
    c, s = np.cos(np.radians(g.degrees)), np.sin(np.radians(g.degrees))
    return {
        "did not tilt": (screw(u, p), "tilt|lean|angle|0|axis"),
        "negated omega alone": (S * (-1, -1, -1, 1, 1, 1), SIGN),
        "tilted by half the angle": (screw(np.cos(np.radians(g.degrees / 2)) * u + np.sin(np.radians(g.degrees / 2)) * t, p), "half|angle|tilt|axis|" + PLACE),
        "tilted from the other axis": (screw(s * u + c * t, p), SWAP + "|sin"),
        "tilted towards the third axis": (screw(c * u + s * np.cross(u, t), p), "axis|third"),
    }


@kinds_of("03.5", "04.1")
def screw_from_a_drawing(g: Any, S: Any) -> Kinds:
    w, v = S[:3], S[3:]
    p, k = np.cross(w, v), int(np.argmax(np.abs(w)))
    i, j = (k + 1) % 3, (k + 2) % 3
    swapped = p.copy()
    swapped[[i, j]] = p[[j, i]]
    return {
        "took another axis as the direction": (screw(np.roll(w, 1), p), "axis|direction|" + ORDER + "|omega"),
        "misread one coordinate by one": (screw(w, p + I3[i]), "metre|point|coordinate|parallel|" + PLACE),
        "misread the other coordinate by one": (screw(w, p - I3[j]), "point|coordinate|parallel|" + PLACE),
        "read one coordinate as 0": (screw(w, p * (I3[i] + I3[k])), "point|coordinate|0|parallel|" + PLACE),
        "swapped two coordinates": (screw(w, swapped), SWAP + "|point|parallel|sizes"),
    }


@kinds_of("03.10")
def screw_formulas(g: Any, S: Any) -> Kinds:
    L, n = g.L, S.shape[0]
    turns = [i for i in range(n) if any(S[i, :3])]
    slides = [i for i in range(n) if i not in turns]

    def rows(change: Any, which: Any) -> Any:
        return sp.Matrix([list(change(S[i, :3], S[i, 3:]) if i in which else S[i, :]) for i in range(n)])

    def point(w: Any, v: Any) -> Any:
        return list(w.cross(v))

    made: Kinds = {
        "took omega x q in every row": (rows(lambda w, v: [*w, *-v], turns), SIGN + "|\\times"),
        "took the points as moments": (rows(lambda w, v: [*w, *point(w, v)], turns), POINT),
        "negated one axis": (rows(lambda w, v: [*-w, *-v], turns[:1]), SIGN),
        "left out the first link": (S.subs(L[0], 0), LEFT_OUT + "|L_"),
        "swapped two rows": (S[[1, 0, *range(2, n)], :], ORDER),
    }
    if slides:
        made["wrote a slide in omega"] = (rows(lambda w, v: [*v, 0, 0, 0], slides), "omega|v|translation|prismatic|halves")
        made["took a slide for a turn"] = (rows(lambda w, v: [*v, *w], slides), "omega|v|translation|prismatic|halves")
        made["moved the slide backwards"] = (rows(lambda w, v: [*w, *-v], slides), SIGN)
    return made


@kinds_of("03.11")
def whole_arm(g: Any, f: Any) -> Kinds:
    def parts_of(L: Any) -> Any:
        n = len(L) - 1
        M = np.asarray(f(np.zeros(n), L))
        return [logarithm(f(row, L) @ inv(M)) for row in np.eye(n)], M

    def of(change: Any) -> Any:
        def fk(q: Any, L: Any) -> Any:
            S, M = parts_of(L)
            return change([np.array(s) for s in S], M, q, L)

        return fk

    def usual(S: Any, M: Any, q: Any) -> Any:
        return product(*(exp(s, x) for s, x in zip(S, q, strict=True)), M)

    def without_last_link(S: Any, M: Any, q: Any, L: Any) -> Any:
        _, short = parts_of([*L[:-1], 0.0])
        return usual(S, short, q)
    chained = "M|home|S_|link|before|row"
    return {
        "missed the last link in M": (of(without_last_link), chained + "|" + LEFT_OUT),
        "left R of M at I": (of(lambda S, M, q, L: usual(S, pose(I3, M[:3, 3]), q)), chained + "|identity|rotat"),
        "took R^T in M": (of(lambda S, M, q, L: usual(S, pose(M[:3, :3].T, M[:3, 3]), q)), chained + "|transpos"),
        "negated the position in M": (of(lambda S, M, q, L: usual(S, pose(M[:3, :3], -M[:3, 3]), q)), chained + "|" + SIGN),
        "misread one link": (lambda q, L: f(q, [L[0], L[0], *L[2:]]), "L_|link"),
    }


@kinds_of("04.2", "04.6")
def carried(g: Any, X: Any) -> Kinds:
    """Screws that must be carried by Ad of the inverse of T."""
    S, T = map(np.asarray, (g.screws, g.home) if hasattr(g, "screws") else (g.body_screws, g.T_bt))
    R, p, w, v = T[:3, :3], T[:3, 3], S[:, :3], S[:, 3:]
    rotated = "rotat|transpos|R^T|turned|position|left out|p$|moved"
    return {
        "moved and did not rotate": (np.hstack([w, v - np.cross(p, w)]), rotated + "|axes|" + PLACE),
        "carried the wrong way": (S @ Ad(T).T, INVERSE + "|Ad"),
        "forgot .T after the rows": (S @ Ad(inv(T)), "transpos|.T|rows"),
        "position left out": (np.hstack([w @ R, v @ R]), rotated),
        "used -p for the way back": (S @ Ad(pose(R.T, -p)).T, "p|position|" + rotated),
    }


@kinds_of("04.4", "04.5")
def with_home(g: Any, X: Any) -> Kinds:
    """Wrong poses where k screws are read in {s}, and stand to the left of the home pose."""
    S, k = (g.screws, 2) if hasattr(g, "screws") else (g.body_screws, 0)
    e, M = list(map(exp, S, radians_of(g.values, S))), np.asarray(g.home)

    def of(k: int) -> Any:
        return product(*e[:k], M, *e[k:])

    return {
        "swapped the sides of M": (product(*e[k:], M, *e[:k]), ORDER + "|sides|first|last"),
        "put M last": (of(k=len(S)), ORDER + "|last"),
        "put M first": (of(k=0), ORDER + "|first|front"),
        "put M one joint later": (of(k=k + 1), ORDER + "|M|place"),
        "put M on both sides": (product(M, *e, M) if k == 0 else product(M, of(k)), "twice|two|both|M"),
    }


@kinds_of("05.1")
def row_from_a_drawing(g: Any, X: Any) -> Kinds:
    a, alpha, d, t = X
    return {
        "left out d": (np.array([a, alpha, 0, t]), LEFT_OUT + "|0|d"),
        "left out a": (np.array([0, alpha, d, t]), LEFT_OUT + "|0|a"),
        "measured theta half a turn off": (np.array([a, alpha, d, t + np.pi]), "theta|half|turn|pi|" + SIGN + "|" + PLACE),
        "gave theta, d, a, alpha": (X[[3, 2, 0, 1]], ORDER),
        "negated alpha": (X * (1, -1, 1, 1), SIGN),
    }


@kinds_of("05.4")
def offsets(g: Any, X: Any) -> Kinds:
    h = np.radians(g.headings_degrees)
    return {
        "gave the headings": (h, "absolute|heading|x_0|relative|x_{"),
        "added the headings": (np.cumsum(h), "add|sum|sign|difference|absolute"),
        "subtracted the other way": (np.array([h[0], -X[1], -X[2]]), SIGN + "|order"),
        "added neighbours": (np.array([h[0], h[0] + h[1], h[1] + h[2]]), SIGN + "|add|sum"),
        "subtracted the first": (np.array([h[0], h[1] - h[0], h[2] - h[0]]), "first|link 1|x_0|before|previous|heading|x_1"),
    }


@kinds_of("05.7")
def parallel_axes(g: Any, X: Any) -> Kinds:
    first, second = np.diff(np.asarray(g.points), axis=0)[:, :2]
    phi = np.arctan2(first[1], first[0]), np.arctan2(second[1], second[0])
    angle = "theta|angle|phi|sign|half a turn|quadrant"
    return {
        "measured theta from x of {s}": (np.array([*X[:4], phi[1]]), angle),
        "gave the direction of x_1 as theta": (np.array([*X[:4], phi[0]]), angle),
        "measured theta from x_2 to x_1": (X * (1, 1, 1, 1, -1), SIGN),
        "measured theta to the reversed x_2": (X + np.array([0, 0, 0, 0, np.pi]), angle),
        "measured d_2 from joint 1": (X + np.array([0, 0, 0, X[1], 0]), "joint 1|" + PLACE),
    }
