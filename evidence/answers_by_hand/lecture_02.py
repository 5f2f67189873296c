"""Answers by hand to sheet 02."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from evidence.answers_by_hand import WrongAnswer, alike, right, wrong_answers
from evidence.answers_by_hand.common import words as by
from evidence.answers_by_hand.common.motions import (
    I3,
    I4,
    exp,
    expm,
    hat,
    negated,
    negated_one,
    pose,
    series,
    swapped,
    twist,
)

theta = sp.Symbol("theta", real=True)
a = sp.Symbol("a", positive=True)
sin, cos, E3 = sp.sin(theta), sp.cos(theta), sp.eye(3)
Answers = Iterator[WrongAnswer]


@wrong_answers("02.1")
def matrix_of_a_screw(given: Any, answer: Any) -> Answers:
    w, v = np.asarray(given.omega), np.asarray(given.v)
    W, last = hat(w), {"last row"}

    def block(A: Any, v: Any = v, last: Any = (0, 0, 0, 0)) -> Any:
        return np.array([*np.column_stack([A, v]), last])

    symmetric = block(np.triu(W) + np.triu(W).T)
    yield from alike(by.OTHER_WAY, {"-[omega]": block(-W), "all transposed": block(W).T})
    yield from alike(by.SIGN | {"equals its transpose", "skew-symmetric"}, {"upper signs in both": symmetric})
    yield from alike(by.SIGN | {"equals its transpose"}, {"no minus": block(np.abs(W))})
    for i, j in [(0, 1), (0, 2), (1, 2)]:
        yield from alike(by.SIGN | by.SWAPPED, {f"both signs of {'zyx'[i + j - 1]}": block(negated(W, (i, j), (j, i)))})
    yield from alike(by.SIGN, {"one sign": block(negated(W, (0, 1))), "-v": block(W, -v)})
    yield from alike(by.SWAPPED | by.ORDER, {"x and z exchanged": block(hat(w[::-1]))})
    yield from alike(by.SWAPPED | by.ORDER, {"y and z": block(hat(w[[0, 2, 1]]))})
    yield from alike({"diagonal", "zero"}, {"omega on the diagonal": block(W + np.diag(w)), "I + [S]": block(W) + I4})
    yield from alike(by.HALVES | {"block"}, {"halves swapped": twist([*v, *w])})
    yield from alike({"corner", "like a pose", "last row"}, {"1 in the corner": block(W, last=(0, 0, 0, 1))})
    yield from alike(last, {"v in the last row": block(W, 0 * v, [*v, 0]), "v in both": block(W, v, [*v, 0])})
    yield from alike(by.OMITTED, {"no v": block(W, 0 * v), "no [omega]": block(0 * W)})
    yield from alike({"product", "\\times"}, {"omega x v for v": block(W, W @ v)})
    yield from alike(by.LENGTH, {"omega normalised": block(W / np.linalg.norm(w))})
    yield from alike(by.HALVES | by.SIGN, {"-[omega] and halves swapped": block(-hat(v), w)})
    yield from alike(by.SIGN | {"corner"}, {"-[omega] and 1 in the corner": block(-W, last=(0, 0, 0, 1))})
    yield from right({"integers": answer.astype(int), "list": answer.tolist(), "SymPy": sp.Matrix(answer.astype(int))})


@wrong_answers("02.2")
def turn_about_a_line(given: Any, answer: Any) -> Answers:
    n, d = np.asarray(given.direction, dtype=float), given.degrees
    length, t = np.linalg.norm(n), np.radians(given.degrees)
    u, s, c = n / length, np.sin(t), np.cos(t)
    W = hat(u)

    def formula(first: float, second: float, W: Any = W, one: Any = I3) -> Any:
        return one + first * W + second * W @ W

    one_minus = {"1 - \\cos", "\\cos"}
    yield from alike(by.LENGTH, {"not a unit vector": formula(s, 1 - c, hat(n)), "length in the angle": exp(n * t)})
    yield from alike(by.LENGTH, {"divided by the square of the length": exp(n / length**2 * t)})
    yield from alike(by.DEGREES, {"degrees": exp(u * d)})
    yield from alike(by.OTHER_WAY, {"the other way": exp(-u * t)})
    yield from alike(by.SWAPPED, {"sin and 1 - cos swapped": formula(1 - c, s), "x and z swapped": exp(u[::-1] * t)})
    yield from alike(one_minus, {"cos for 1 - cos": formula(s, c), "1 + cos": formula(s, 1 + c)})
    yield from alike(by.OMITTED | {"$I$"}, {"no I": formula(s, 1 - c, one=0 * I3), "no [u]^2": formula(s, 0)})
    yield from alike(by.ELEMENTWISE, {"square": I3 + s * W + (1 - c) * W * W, "exponential": np.exp(W * t)})
    yield from alike({"outer", "u u", "square"}, {"u u^T for [u]^2": I3 + s * W + (1 - c) * np.outer(u, u)})
    yield from alike(by.SERIES, {"three terms": series(W * t, 3), "four terms": series(W * t, 4)})
    yield from alike(by.HALF, {"half the angle": exp(u * t / 2)})
    yield from alike(by.DOUBLE, {"twice the angle": exp(2 * u * t)})
    yield from alike(by.SIGN, {"one sign of u": exp(negated(u, 0) * t)})
    yield from alike(by.SIGN, {"one sign of [u]": formula(s, 1 - c, negated(W, (0, 2)))})
    yield from alike(by.SIGN, {"second term subtracted": formula(s, c - 1)})
    yield from alike(by.LENGTH | by.OTHER_WAY, {"not a unit vector, the other way": formula(s, 1 - c, -hat(n))})
    yield from alike(by.DEGREES | by.LENGTH, {"degrees, not a unit vector": formula(np.sin(d), 1 - np.cos(d), hat(n))})
    yield from alike(by.SWAPPED | by.OTHER_WAY, {"sin and 1 - cos swapped, the other way": formula(1 - c, s, -W)})
    outer = c * I3 + s * W + (1 - c) * np.outer(u, u)
    yield from right({"three decimals": answer.round(3), "expm": expm(W * t).tolist(), "outer product": outer})


def _skew(w: Any) -> Any:
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def _rodrigues(W: Any, t: Any = theta) -> Any:
    return E3 + sp.sin(t) * W + (1 - sp.cos(t)) * W * W


@wrong_answers("02.3")
def rotation_as_a_formula(given: Any, answer: Any) -> Answers:
    w = sp.Matrix(given.omega)
    W, size = _skew(w), sp.ilcm(*[x.q for x in w])
    R, square, outer = _rodrigues(W), W.multiply_elementwise(W), w * w.T
    flipped = _skew([-x if abs(x) == max(map(abs, w)) else x for x in w])
    yield from alike(by.OTHER_WAY, {"R(-theta)": R.T})
    yield from alike(by.SWAPPED, {"sin and 1 - cos swapped": E3 + (1 - cos) * W + sin * W * W})
    yield from alike(by.SWAPPED, {"x and z swapped": _rodrigues(_skew([w[2], w[1], w[0]]))})
    yield from alike(by.SWAPPED, {"sin and cos exchanged": R.subs(theta, sp.pi / 2 - theta)})
    yield from alike({"\\cos"}, {"cos": E3 + sin * W + cos * W * W, "1 + cos": E3 + sin * W + (1 + cos) * W * W})
    yield from alike(by.OMITTED | {"$I$"}, {"no I": R - E3, "no [w]^2": E3 + sin * W})
    yield from alike(by.SERIES, {"three terms": E3 + theta * W + theta**2 * W * W / 2, "two terms": E3 + theta * W})
    yield from alike(by.ELEMENTWISE, {"squared entry by entry": E3 + sin * W + (1 - cos) * square})
    yield from alike({"square", "^2"}, {"w w^T": E3 + sin * W + (1 - cos) * outer, "[w]": E3 + sin * W + (1 - cos) * W})
    yield from alike(by.LENGTH | {"fraction"}, {"not divided": _rodrigues(size * W)})
    yield from alike(by.DOUBLE, {"2 theta": _rodrigues(W, 2 * theta)})
    yield from alike(by.HALF, {"theta / 2": _rodrigues(W, theta / 2)})
    yield from alike(by.SIGN, {"sign of one component": _rodrigues(flipped)})
    yield from alike(by.SIGN, {"second term subtracted": R - 2 * (1 - cos) * W * W})
    yield from alike(by.DEGREES, {"degrees": _rodrigues(W, sp.pi * theta / 180)})
    yield from alike(by.SWAPPED | by.OTHER_WAY, {"swapped, the other way": E3 - (1 - cos) * W + sin * W * W})
    yield from alike(by.OMITTED | {"$I$", "\\cos"}, {"no I, cos for 1 - cos": sin * W + cos * W * W})
    yield from alike(by.LENGTH | by.OTHER_WAY, {"not divided, the other way": _rodrigues(-size * W)})
    half = E3 + 2 * sp.sin(theta / 2) * sp.cos(theta / 2) * W + 2 * sp.sin(theta / 2) ** 2 * W * W
    yield from right({"text": str(R.tolist()), "outer": cos * E3 + sin * W + (1 - cos) * outer, "half angles": half})


@wrong_answers("02.4")
def where_the_origin_goes(given: Any, answer: Any) -> Answers:
    w, p = sp.Matrix(given.omega), sp.Matrix(given.point)
    W = _skew(w)
    R, v = _rodrigues(W), -W * p

    def column(v: Any = v, W: Any = W, first: Any = theta, second: Any = 1 - cos, third: Any = theta - sin) -> Any:
        return first * v + second * W * v + third * W * W * v

    straight = {"straight", "v\\,\\theta"}
    yield from alike(straight, {"v theta": v * theta})
    yield from alike(by.MOMENT, {"v = omega x p": column(-v), "p + R p": p + R * p})
    yield from alike(by.MOMENT | by.OTHER_WAY, {"sin - theta": column(third=sin - theta)})
    yield from alike({"R\\,p", "point"}, {"R p": R * p, "p": p})
    yield from alike(by.MOMENT | by.OTHER_WAY, {"the other way": p - R.T * p})
    yield from alike({"R\\,v", "velocity", "v\\,"}, {"R v": R * v, "v": v})
    yield from alike(by.SWAPPED, {"coefficients swapped": column(second=theta - sin, third=1 - cos)})
    yield from alike(by.OMITTED | by.SERIES, {"no third term": column(third=0), "no second term": column(second=0)})
    yield from alike({"first term", "I\\,\\theta", "I\\theta"}, {"I for I theta": column(first=1)})
    yield from alike(by.POINT, {"p for v": column(p)})
    yield from alike(by.DOUBLE, {"2 theta": answer.subs(theta, 2 * theta)})
    yield from alike(by.HALF, {"theta / 2": answer.subs(theta, theta / 2)})
    yield from alike(by.DEGREES, {"degrees": answer.subs(theta, sp.pi * theta / 180)})
    yield from alike(by.OMITTED, {"a left out": answer.subs(a, 0)})
    yield from alike(by.SIGN, {"-a": answer.subs(a, -a)})
    yield from alike(by.MOMENT | straight, {"v = omega x p and v theta": -v * theta})
    yield from alike(by.MOMENT | {"R\\,v"}, {"v = omega x p and R v": -R * v})
    yield from right({"text": list(map(str, answer)), "G(theta) v": column(), "list": list(sp.expand(p - R * p))})


@wrong_answers("02.5")
def three_terms(given: Any, answer: Any) -> Answers:
    t, mm = given.theta, 1000 * given.radius
    dx, dy = abs(np.cos(t) - 1 + t**2 / 2), abs(np.sin(t) - t)
    off, two, four = np.hypot(dx, dy), np.hypot(np.cos(t) - 1, dy), np.hypot(dx, np.sin(t) - t + t**3 / 6)
    r = np.radians(t)
    yield from alike({"two terms", "three terms"}, {"two terms": two * mm})
    yield from alike({"four terms"}, {"four terms": four * mm})
    yield from alike({"first term", "next term", "last term"}, {"next term": t**3 / 6 * mm, "last term": t**2 / 2 * mm})
    yield from alike({"cosine", "sine"}, {"error of the cosine": dx * mm})
    yield from alike({"cosine", "sine"}, {"error of the sine": dy * mm})
    yield from alike({"add"}, {"errors added": (dx + dy) * mm})
    yield from alike({"root", "square"}, {"no root": (dx**2 + dy**2) * mm})
    yield from alike({"metres", "unit"}, {"in metres": off * mm / 1000, "in centimetres": off * mm / 10})
    yield from alike({"radius", "distance", *by.OMITTED}, {"radius left out": off * 1000})
    yield from alike({"radius", "distance", *by.OMITTED}, {"divided by it": off * 1e6 / mm})
    yield from alike({"scalar", "e^"}, {"series of exp(theta)": (np.exp(t) - 1 - t - t**2 / 2) * mm})
    yield from alike({"length"}, {"error of the length": (np.hypot(1 - t**2 / 2, t) - 1) * mm})
    yield from alike({"length", "difference"}, {"length of the sum": np.hypot(1 - t**2 / 2, t) * mm})
    yield from alike(by.DEGREES, {"theta in degrees": np.hypot(np.cos(r) - 1 + r**2 / 2, np.sin(r) - r) * mm})
    yield from alike({"2!", "half", "factorial"}, {"no factorial": np.hypot(np.cos(t) - 1 + t**2, dy) * mm})
    yield from alike(by.SIGN, {"negative": -off * mm})
    yield from alike({"two terms", "three terms", "metres"}, {"two terms in metres": two * mm / 1000})
    yield from alike({"add", "metres"}, {"errors added, in metres": (dx + dy) * mm / 1000})
    yield from alike({"two terms", "three terms", "cosine"}, {"cosine, two terms": (1 - np.cos(t)) * mm})
    yield from right({"float": float(off * mm), "two decimals": round(off * mm, 2), "array": np.array(answer)})


@wrong_answers("02.6")
def gyroscope(given: Any, answer: Any) -> Answers:
    w, v, t = np.asarray(given.omega), np.asarray(given.v), given.seconds
    size, S = np.linalg.norm(w), np.array([*w, *v])

    def printed(t: float, W: Any) -> tuple[Any, Any]:
        s, c = np.sin(t), np.cos(t)
        return I3 + s * W + (1 - c) * W @ W, I3 * t + (1 - c) * W + (t - s) * W @ W

    (R1, G1), (R, G) = printed(t, hat(w)), printed(size * t, hat(w / size))
    p = G @ v / size
    straight, second = {"straight", "v\\,t"}, {"second", "\\theta =", "time", *by.LENGTH}
    yield from alike({"3.88", *by.LENGTH}, {"(3.88), seconds as angle": pose(R1, G1 @ v)})
    yield from alike({"3.88", *by.LENGTH}, {"its column only": pose(R, G1 @ v)})
    yield from alike(second, {"S divided, seconds kept": exp(S / size * t), "after one second": exp(S)})
    yield from alike(by.LENGTH, {"v not divided": pose(R, G @ v), "only omega divided": exp([*w / size, *v], t)})
    yield from alike(straight, {"v t": pose(R, v * t), "R v t": pose(R, R @ v * t)})
    yield from alike(second | {"velocity"}, {"v alone": pose(R, v)})
    yield from alike(by.DEGREES, {"degrees": exp([*np.radians(w), *v], t)})
    yield from alike(by.DEGREES, {"degrees in R": pose(exp(np.radians(w) * t), p)})
    yield from alike(by.HALVES, {"halves swapped": exp([*v, *w], t)})
    yield from alike(by.OTHER_WAY, {"turned the other way": exp([*-w, *v], t), "the way back": exp(-S, t)})
    yield from alike(by.SIGN, {"-v": exp([*w, *-v], t)})
    yield from alike(by.OMITTED, {"no translation": pose(R, 0 * v)})
    yield from alike(by.OMITTED | straight, {"no rotation": pose(I3, v * t), "no rotation, column right": pose(I3, p)})
    yield from alike(by.ELEMENTWISE, {"exp entry by entry": np.exp(twist(S) * t)})
    yield from alike(by.SERIES | straight, {"three terms": series(twist(S) * t, 3)})
    yield from alike(by.SERIES | straight, {"I + [S] t": series(twist(S) * t, 2)})
    yield from alike(by.POINT, {"v as a point": pose(R, v - R @ v)})
    yield from alike(by.OTHER_WAY | straight, {"turned the other way, v t": pose(R.T, v * t)})
    yield from alike(by.HALVES | by.DEGREES, {"halves swapped, degrees": exp([*np.radians(v), *w], t)})
    yield from alike(by.DEGREES | straight, {"v t and degrees": pose(exp(np.radians(w) * t), v * t)})
    yield from right({"three decimals": answer.round(3), "unit axis": pose(R, p), "list": exp(S, t).tolist()})


@wrong_answers("02.7")
def near_half_a_turn(given: Any, answer: Any) -> Answers:
    R = np.asarray(given.R)
    m = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    t, u = np.arccos((np.trace(R) - 1) / 2), m / np.linalg.norm(m)
    x = u * t
    yield from alike({"arcsin"}, {"arcsine": u * (np.pi - t)})
    yield from alike({"the axis", "unit vector"}, {"axis alone": u})
    yield from alike(by.DEGREES, {"degrees": np.degrees(x)})
    yield from alike(by.OTHER_WAY, {"log of R^T": -x})
    yield from alike({"long", "shorter"}, {"the long way": -u * (2 * np.pi - t)})
    yield from alike({"long", "shorter"}, {"a full turn more": u * (t + 2 * np.pi)})
    yield from alike(by.HALF | by.DOUBLE, {"not halved": 2 * x, "halved once more": x / 2})
    yield from alike({"sine", "\\sin"}, {"(R - R^T) / 2": m / 2, "R - R^T": m})
    yield from alike({"sine", "\\sin"}, {"times the angle, not over the sine": m / 2 * t})
    yield from alike({"trace", "tr}"}, {"angle from tr R / 2": u * np.arccos(np.trace(R) / 2)})
    yield from alike({"trace", "tr}"}, {"angle from (tr R + 1) / 2": u * np.arccos((np.trace(R) + 1) / 2)})
    yield from alike(by.SIGN, {"one sign": negated_one(x), "second sign": negated_one(x, 1), "sizes only": np.abs(x)})
    yield from alike(by.SWAPPED, {"x and z swapped": swapped(x, 0, 2), "x and y swapped": swapped(x, 0, 1)})
    yield from alike({"entries", "R - R^T"}, {"entries of R": np.array([R[2, 1], R[0, 2], R[1, 0]])})
    yield from alike({"arcsin", *by.OTHER_WAY}, {"arcsine, of R^T": -u * (np.pi - t)})
    yield from alike({"the axis", *by.OTHER_WAY}, {"axis alone, of R^T": -u})
    yield from alike(by.DEGREES | by.OTHER_WAY, {"degrees, of R^T": -np.degrees(x)})
    axis = np.linalg.svd(R - I3)[2][2]
    yield from right({"from R u = u": axis * np.sign(axis @ m) * t, "three decimals": x.round(3), "list": x.tolist()})


@wrong_answers("02.8")
def spindle_as_a_formula(given: Any, answer: Any) -> Answers:
    w, p, h = sp.Matrix(given.axis), sp.Matrix(given.point), given.pitch
    W = _skew(w)
    R, v, climb = _rodrigues(W), -W * p, h * theta * w

    def formula(column: Any, R: Any = R) -> Any:
        return sp.Matrix([*R.row_join(column).tolist(), [0, 0, 0, 1]])

    turn = p - R * p
    T, back = formula(turn + climb), p - R.T * p
    yield from alike(by.PITCH, {"no climb": formula(turn), "climb h": formula(turn + h * w)})
    yield from alike(by.PITCH, {"theta": formula(turn + theta * w)})
    yield from alike(by.PITCH, {"h / 2 pi": formula(turn + climb / (2 * sp.pi))})
    yield from alike(by.PITCH, {"2 pi h": formula(turn + 2 * sp.pi * climb)})
    yield from alike({"straight"}, {"v theta": formula((v + h * w) * theta)})
    yield from alike({"R\\,p", "point"}, {"R p": formula(R * p + climb), "p": formula(p + climb)})
    yield from alike(by.MOMENT, {"R p - p": formula(climb - turn)})
    yield from alike(by.OTHER_WAY | {"left-handed"}, {"turned the other way": formula(back + climb, R.T)})
    yield from alike(by.OTHER_WAY | {"left-handed"}, {"left-handed": formula(turn - climb)})
    yield from alike(by.OTHER_WAY | {"left-handed"}, {"R^T": formula(turn + climb, R.T)})
    yield from alike(by.OTHER_WAY, {"the way back": formula(back - climb, R.T), "all transposed": T.T})
    yield from alike(by.OMITTED, {"no translation": formula(0 * p), "no rotation": formula(climb, E3)})
    yield from alike(by.DOUBLE, {"2 theta": T.subs(theta, 2 * theta)})
    yield from alike({"last row"}, {"last row 0": T - sp.diag(0, 0, 0, 1)})
    yield from alike(by.DEGREES, {"degrees": T.subs(theta, sp.pi * theta / 180)})
    yield from alike(by.PITCH | {"axis"}, {"climb along the point": formula(turn + h * theta * p)})
    yield from alike(by.MOMENT | {"left-handed"}, {"R p - p and left-handed": formula(-turn - climb)})
    yield from alike(by.PITCH | by.OTHER_WAY, {"no climb, turned the other way": formula(back, R.T)})
    yield from alike(by.PITCH | {"R\\,p"}, {"R p and no climb": formula(R * p)})
    column = theta * v + (1 - cos) * W * v + (theta - sin) * W * W * v + climb
    yield from right({"text": str(answer.tolist()), "SymPy": T, "by G(theta) v": formula(column)})
