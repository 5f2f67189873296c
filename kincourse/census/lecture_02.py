"""Answers by hand to sheet 02."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from kincourse.census import WrongAnswer, right, wrong, wrong_answers
from kincourse.census.motions import I3, I4, exp, expm, hat, negated, negated_one, parts, pose, series, swapped, twist

theta = sp.Symbol("theta", real=True)
a = sp.Symbol("a", positive=True)
sin, cos = sp.sin(theta), sp.cos(theta)
E3 = sp.eye(3)


@wrong_answers("02.1")
def matrix_of_a_screw(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w, v = np.asarray(given.omega), np.asarray(given.v)

    def block(A: Any, v: Any = v, last: Any = (0, 0, 0, 0)) -> Any:
        return np.array([*np.column_stack([A, v]), last])

    W = hat(w)
    upper = np.triu(W) + np.triu(W).T
    yield from wrong(
        {
            "-[omega]": (block(-W), "sign, transpos, -["),
            "-[omega]^T in the lower triangle": (block(upper), "sign, symmetric, equals its transpose"),
            "all signs positive": (block(np.abs(W)), "sign, symmetric, minus"),
            "signs of omega_x": (block(negated(W, (1, 2), (2, 1))), "sign, x"),
            "signs of omega_y": (block(negated(W, (0, 2), (2, 0))), "sign, y"),
            "signs of omega_z": (block(negated(W, (0, 1), (1, 0))), "sign, z"),
            "one sign": (block(negated(W, (0, 1))), "sign"),
            "x and z exchanged": (block(hat(w[::-1])), "swap, exchang, place"),
            "x, y, z from left to right": (
                block(hat([w[2], w[1], w[0]] * np.array([1, -1, 1]))),
                "sign, swap, place, order",
            ),
            "omega on the diagonal": (block(W + np.diag(w)), "diagonal"),
            "halves swapped": (twist([*v, *w]), "swap, halves, block"),
            "1 in the corner": (block(W, last=(0, 0, 0, 1)), "corner, 1"),
            "v in the last row": (block(W, 0 * v, [*v, 0]), "last row"),
            "v in both": (block(W, v, [*v, 0]), "last row"),
            "all transposed": (block(W).T, "transpos"),
            "-v": (block(W, -v), "sign, -v"),
            "no v": (block(W, 0 * v), "left out, missing"),
            "v = omega x v": (block(W, W @ v), "v, times, product"),
            "I + [S]": (block(W) + I4, "identity, I, diagonal"),
            "omega normalised": (block(W / np.linalg.norm(w)), "norm, unit, length"),
            "-[omega] and halves swapped": (block(-hat(v), w), "swap, halves, sign"),
            "-[omega] and 1 in the corner": (block(-W, last=(0, 0, 0, 1)), "sign, corner, 1"),
            "-[omega] and v in the last row": (block(-W, 0 * v, [*v, 0]), "sign, last row, transpos"),
        }
    )
    yield from right(
        {"integers": block(W).astype(int), "list": block(W).tolist(), "SymPy": sp.Matrix(block(W).astype(int))}
    )


@wrong_answers("02.2")
def turn_about_a_line(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    n, d = np.asarray(given.direction, dtype=float), given.degrees
    length, t = np.linalg.norm(n), np.radians(given.degrees)
    u, s, c = n / length, np.sin(t), np.cos(t)
    W = hat(u)

    def sum_of(first: float, second: float, W: Any = W, one: Any = I3) -> Any:
        return one + first * W + second * W @ W

    yield from wrong(
        {
            "not a unit vector": (sum_of(s, 1 - c, hat(n)), "unit, length, norm"),
            "length in the angle": (exp(n * t), "length, unit, norm"),
            "divided by the square of the length": (exp(n / length**2 * t), "length, unit, norm, half"),
            "degrees": (exp(u * d), "degrees, radians"),
            "the other way": (exp(-u * t), "transpos, other way, sign, backwards"),
            "sin and 1 - cos swapped": (sum_of(1 - c, s), "swap, coefficient"),
            "cos for 1 - cos": (sum_of(s, c), "1 -, cos"),
            "1 + cos for 1 - cos": (sum_of(s, 1 + c), "1 -, cos, sign"),
            "no I": (sum_of(s, 1 - c, one=0 * I3), "I, identity, left out"),
            "squared entry by entry": (I3 + s * W + (1 - c) * W * W, "entry by entry, elementwise"),
            "u u^T for [u]^2": (I3 + s * W + (1 - c) * np.outer(u, u), "outer, u u, square"),
            "no [u]^2": (sum_of(s, 0), "left out, missing, term, cut"),
            "three terms of the series": (series(W * t, 3), "series, term, trunc, stopped"),
            "four terms of the series": (series(W * t, 4), "series, term, trunc, stopped"),
            "exp entry by entry": (np.exp(W * t), "entry by entry, elementwise"),
            "half the angle": (exp(u * t / 2), "half"),
            "twice the angle": (exp(2 * u * t), "double, twice"),
            "one sign of the direction": (exp(negated(u, 0) * t), "sign"),
            "x and z of the direction swapped": (exp(u[::-1] * t), "swap"),
            "one sign of [u]": (sum_of(s, 1 - c, negated(W, (0, 2), (2, 0))), "sign"),
            "minus the second term": (sum_of(s, c - 1), "sign"),
            "not a unit vector, the other way": (sum_of(s, 1 - c, -hat(n)), "unit, length, norm, sign, other way"),
            "degrees in Rodrigues' formula, not a unit vector": (
                sum_of(np.sin(d), 1 - np.cos(d), hat(n)),
                "degrees, unit, length",
            ),
            "swapped, the other way": (sum_of(1 - c, s, -W), "swap, coefficient, sign, other way"),
        }
    )
    yield from right(
        {
            "three decimals": exp(u * t).round(3),
            "expm": expm(W * t).tolist(),
            "c I + s [u] + (1 - c) u u^T": c * I3 + s * W + (1 - c) * np.outer(u, u),
        }
    )


def _skew(w: Any) -> Any:
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def _rodrigues(W: Any, t: Any = theta) -> Any:
    return E3 + sp.sin(t) * W + (1 - sp.cos(t)) * W * W


@wrong_answers("02.3")
def rotation_as_a_formula(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w = sp.Matrix(given.omega)
    W, size = _skew(w), sp.ilcm(*[sp.fraction(x)[1] for x in w])
    R, one_sign = _rodrigues(W), W.copy()
    k = next(k for k in (1, 0) if W[k, 2] != 0)
    one_sign[k, 2], one_sign[2, k] = -W[k, 2], -W[2, k]
    square = W.multiply_elementwise(W)
    yield from wrong(
        {
            "R(-theta)": (R.T, "transpos, sign, other way, -\\theta"),
            "sin and 1 - cos swapped": (E3 + (1 - cos) * W + sin * W * W, "swap, coefficient"),
            "cos for 1 - cos": (E3 + sin * W + cos * W * W, "cos"),
            "1 + cos for 1 - cos": (E3 + sin * W + (1 + cos) * W * W, "cos, sign"),
            "no I": (R - E3, "I, identity, left out"),
            "three terms": (E3 + theta * W + theta**2 * W * W / 2, "series, term, trunc, stopped"),
            "two terms": (E3 + theta * W, "series, term, trunc, stopped"),
            "squared entry by entry": (E3 + sin * W + (1 - cos) * square, "entry by entry, elementwise"),
            "w w^T for [w]^2": (E3 + sin * W + (1 - cos) * w * w.T, "outer, w w, square"),
            "no [w]^2": (E3 + sin * W, "left out, missing, term"),
            "not divided": (_rodrigues(size * W), "unit, length, norm, fraction, divide"),
            "2 theta": (_rodrigues(W, 2 * theta), "double, twice"),
            "theta / 2": (_rodrigues(W, theta / 2), "half"),
            "sin and cos exchanged": (R.subs(theta, sp.pi / 2 - theta), "swap, sine and cosine"),
            "signs of one component": (_rodrigues(one_sign), "sign"),
            "x and z of omega swapped": (_rodrigues(_skew([w[2], w[1], w[0]])), "swap"),
            "degrees": (_rodrigues(W, sp.pi * theta / 180), "degrees, radians"),
            "[w] not squared": (E3 + sin * W + (1 - cos) * W, "square, [\\omega]^2"),
            "swapped, the other way": (E3 - (1 - cos) * W + sin * W * W, "swap, sign, other way, transpos"),
            "no I, cos for 1 - cos": (sin * W + cos * W * W, "I, identity, cos, left out"),
            "not divided, the other way": (_rodrigues(-size * W), "unit, length, norm, sign, other way"),
        }
    )
    yield from right(
        {
            "text": str(R.tolist()),
            "c I + s [w] + (1 - c) w w^T": cos * E3 + sin * W + (1 - cos) * w * w.T,
            "half angles": E3 + 2 * sp.sin(theta / 2) * sp.cos(theta / 2) * W + 2 * sp.sin(theta / 2) ** 2 * W * W,
        }
    )


@wrong_answers("02.4")
def where_the_origin_goes(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w, p = sp.Matrix(given.omega), sp.Matrix(given.point)
    W = _skew(w)
    R, v = _rodrigues(W), -W * p

    def column(v: Any, W: Any = W) -> Any:
        return v * theta + (1 - cos) * W * v + (theta - sin) * W * W * v

    yield from wrong(
        {
            "v theta": (v * theta, "v\\,\\theta, straight"),
            "v = omega x p": (column(-v), "negative, sign, \\times"),
            "R p": (R * p, "p - R, point"),
            "p": (p, "point"),
            "p + R p": (p + R * p, "sign"),
            "the other way": (p - R.T * p, "transpos, other way, sign, -\\theta"),
            "R v": (R * v, "R\\,v"),
            "v": (v, "v"),
            "G of the wrong order": (v * theta + (theta - sin) * W * v + (1 - cos) * W * W * v, "swap, coefficient"),
            "no third term": (v * theta + (1 - cos) * W * v, "term, left out, missing"),
            "no second term": (v * theta + (theta - sin) * W * W * v, "term, left out, missing"),
            "first term I, not I theta": (v + (1 - cos) * W * v + (theta - sin) * W * W * v, "\\theta, I"),
            "sin + theta": (v * theta + (1 - cos) * W * v + (theta + sin) * W * W * v, "sign, coefficient, -\\theta"),
            "sin - theta": (v * theta + (1 - cos) * W * v + (sin - theta) * W * W * v, "sign, coefficient"),
            "p for v": (column(p), "moment, point"),
            "2 theta": (answer.subs(theta, 2 * theta), "double, twice"),
            "theta / 2": (answer.subs(theta, theta / 2), "half"),
            "degrees": (answer.subs(theta, sp.pi * theta / 180), "degrees, radians"),
            "a left out": (answer.subs(a, 0), "a, length, left out"),
            "-a": (answer.subs(a, -a), "sign"),
            "v = omega x p and v theta": (-v * theta, "sign, \\times, straight"),
            "v = omega x p, the other way": (column(-v, -W), "sign, \\times, negative, other way, -\\theta"),
            "v = omega x p and R v": (-R * v, "sign, \\times, R\\,v"),
        }
    )
    yield from right(
        {
            "text": [str(entry) for entry in answer],
            "by G(theta) v": column(v),
            "expanded list": [sp.expand(entry) for entry in p - R * p],
        }
    )


@wrong_answers("02.5")
def three_terms(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    r, t = given.radius, given.theta
    dx, dy = abs(np.cos(t) - 1 + t**2 / 2), abs(np.sin(t) - t)
    two, four = np.hypot(np.cos(t) - 1, dy), np.hypot(dx, np.sin(t) - t + t**3 / 6)
    yield from wrong(
        {
            label: (value * r * 1000, words)
            for label, value, words in [
                ("two terms", two, "two terms"),
                ("four terms", four, "four terms"),
                ("the first missing term", t**3 / 6, "next term, first term, missing"),
                ("the last term taken", t**2 / 2, "last term, term"),
                ("error of the cosine", dx, "cosine, direction, axis"),
                ("error of the sine", dy, "sine, direction, axis"),
                ("errors added", dx + dy, "add"),
                ("errors squared, no root", dx**2 + dy**2, "root, square"),
                ("in metres", np.hypot(dx, dy) / 1000, "metre"),
                ("in centimetres", np.hypot(dx, dy) / 10, "centimetre, unit, factor, 10"),
                ("radius left out", np.hypot(dx, dy) / r, "radius, distance, left out"),
                ("radius divided", np.hypot(dx, dy) / r**2, "radius, distance, divide"),
                ("series for exp(theta)", np.exp(t) - 1 - t - t**2 / 2, "e^, scalar, exp"),
                ("length of the sum", np.hypot(1 - t**2 / 2, t), "length, sum, differ"),
                ("error of the length", np.hypot(1 - t**2 / 2, t) - 1, "length, distance from the axis"),
                (
                    "theta in degrees",
                    np.hypot(np.cos(np.radians(t)) - 1 + np.radians(t) ** 2 / 2, np.sin(np.radians(t)) - np.radians(t)),
                    "degrees",
                ),
                ("factorial forgotten", np.hypot(np.cos(t) - 1 + t**2, dy), "factorial, 2!, half, /2"),
                ("two terms in metres", two / 1000, "two terms, metre"),
                ("errors added, in metres", (dx + dy) / 1000, "add, metre"),
                ("error of the cosine, two terms", abs(np.cos(t) - 1), "two terms, cosine, direction"),
                ("negative", -np.hypot(dx, dy), "sign, negative"),
            ]
        }
    )
    yield from right(
        {
            "float": float(1000 * r * np.hypot(dx, dy)),
            "two decimals": round(1000 * r * np.hypot(dx, dy), 2),
            "array of no dimension": np.array(answer),
        }
    )


@wrong_answers("02.6")
def gyroscope(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w, v, t = np.asarray(given.omega), np.asarray(given.v), given.seconds
    size, W = np.linalg.norm(w), hat(w)
    there = exp([*w, *v], t)
    R, p = parts(there)

    def printed(t: float, W: Any = W) -> tuple[Any, Any]:
        s, c = np.sin(t), np.cos(t)
        return I3 + s * W + (1 - c) * W @ W, I3 * t + (1 - c) * W + (t - s) * W @ W

    (R1, G1), (R2, G2) = printed(t), printed(size * t, W / size)
    yield from wrong(
        {
            "(3.88) with the seconds as the angle": (pose(R1, G1 @ v), "3.88, unit, \\omega"),
            "column by (3.88)": (pose(R, G1 @ v), "3.88, unit, \\omega"),
            "omega divided, seconds kept": (exp([*w / size, *v / size], t), "second, angle, length"),
            "only omega divided, seconds kept": (exp([*w / size, *v], t), "divide, v, length"),
            "v not divided": (exp([*w, *v * size], t), "divide, v, length"),
            "v t": (pose(R, v * t), "straight, v"),
            "R v t": (pose(R, R @ v * t), "straight, R, v"),
            "v alone": (pose(R, v), "v, time, second"),
            "degrees": (exp([*np.radians(w), *v], t), "degrees, radians"),
            "degrees in the rotation only": (pose(exp(np.radians(w) * t), p), "degrees, radians"),
            "after one second": (exp([*w, *v]), "second, time"),
            "halves swapped": (exp([*v, *w], t), "swap, halves"),
            "turned the other way": (exp([*-w, *v], t), "other way, sign, transpos"),
            "the way back": (exp([*w, *v], -t), "inver, sign, back"),
            "-v": (exp([*w, *-v], t), "sign, v"),
            "no translation": (pose(R, 0 * v), "left out, missing, translation, position"),
            "no rotation": (pose(I3, v * t), "left out, missing, rotation, straight"),
            "exp entry by entry": (np.exp(twist([*w, *v]) * t), "entry by entry, elementwise"),
            "three terms": (series(twist([*w, *v]) * t, 3), "series, term, trunc"),
            "I + [S] t": (series(twist([*w, *v]) * t, 2), "series, term, trunc, straight"),
            "v as a point": (pose(R, v - R @ v), "point, v"),
            "third coefficient not theta - sin": (
                pose(R, (I3 * t + (1 - np.cos(size * t)) / size * W / size) @ v),
                "term, left out, coefficient",
            ),
            "turned the other way, v t": (pose(R.T, v * t), "other way, sign, transpos, straight"),
            "halves swapped, degrees": (exp([*np.radians(v), *w], t), "swap, halves, degrees, radians"),
            "v t and degrees": (pose(exp(np.radians(w) * t), v * t), "degrees, radians, straight"),
        }
    )
    yield from right(
        {
            "three decimals": there.round(3),
            "unit axis, angle |omega| t": pose(R2, G2 @ v / size),
            "list": there.tolist(),
        }
    )


@wrong_answers("02.7")
def near_half_a_turn(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    R = np.asarray(given.R)
    m = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    t = np.arccos((np.trace(R) - 1) / 2)
    u = m / (2 * np.sin(t))
    rounded = R.round(4)
    yield from wrong(
        {
            "arcsine": (u * (np.pi - t), "arcsin, sine"),
            "axis alone": (u, "axis, unit, angle"),
            "degrees": (u * np.degrees(t), "degrees, radians"),
            "of R^T": (-u * t, "R^T, transpos, sign, other way"),
            "the long way": (-u * (2 * np.pi - t), "long, shorter, turn"),
            "a full turn more": (u * (t + 2 * np.pi), "turn, 2\\pi, long, shorter"),
            "not halved": (2 * u * t, "twice, half, halved"),
            "halved once more": (u * t / 2, "half, twice"),
            "(R - R^T) / 2 alone": (m / 2, "sin, angle, divide"),
            "R - R^T alone": (m, "sin, angle, divide"),
            "times the angle, not over the sine": (m / 2 * t, "sin, divide"),
            "angle from the trace alone": (u * np.arccos(np.trace(R) / 2), "trace, 1"),
            "trace + 1": (u * np.arccos(np.clip((np.trace(R) + 1) / 2, -1, 1)), "trace, sign, 1"),
            "one sign": (negated_one(u * t), "sign"),
            "second sign": (negated_one(u * t, 1), "sign"),
            "x and z swapped": (swapped(u * t, 0, 2), "swap"),
            "sizes only": (np.abs(u) * t, "sign"),
            "from the four printed digits, rounded once more": (np.round(u, 1) * t, "digits, rounded, close"),
            "arcsine, of R^T": (-u * (np.pi - t), "arcsin, sine, R^T, transpos"),
            "axis alone, of R^T": (-u, "axis, R^T, transpos, sign"),
            "degrees, of R^T": (-u * np.degrees(t), "degrees, R^T, transpos, sign"),
            "entries of log entry by entry": (
                np.array([rounded[2, 1], rounded[0, 2], rounded[1, 0]]),
                "entry, R - R^T",
            ),
        }
    )
    axis = np.linalg.svd(R - I3)[2][2]
    yield from right(
        {
            "axis from the null space": axis * np.sign(axis @ m) * t,
            "three decimals": (u * t).round(3),
            "list": list(map(float, u * t)),
        }
    )


@wrong_answers("02.8")
def spindle_as_a_formula(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w, p, h = sp.Matrix(given.axis), sp.Matrix(given.point), given.pitch
    W = _skew(w)
    R, v, climb = _rodrigues(W), -W * p, h * theta * w

    def formula(R: Any, column: Any) -> Any:
        return sp.Matrix([R.row_join(column).tolist()[i] for i in range(3)] + [[0, 0, 0, 1]])

    yield from wrong(
        {
            "no climb": (formula(R, p - R * p), "climb, pitch"),
            "climb h": (formula(R, p - R * p + h * w), "climb, \\theta"),
            "climb theta": (formula(R, p - R * p + theta * w), "climb, pitch, h"),
            "v theta": (formula(R, (v + h * w) * theta), "straight, v"),
            "R p": (formula(R, R * p + climb), "R\\,p, p - R"),
            "p": (formula(R, p + climb), "point, p"),
            "R p - p": (formula(R, R * p - p + climb), "sign, \\times, p - R"),
            "climb / 2 pi": (formula(R, p - R * p + climb / (2 * sp.pi)), "2\\pi, lead, pitch"),
            "2 pi climb": (formula(R, p - R * p + climb * 2 * sp.pi), "2\\pi, lead, pitch"),
            "turned the other way": (
                formula(R.T, p - R.T * p + climb),
                "other way, left-handed, transpos, sign, -\\theta",
            ),
            "left-handed": (formula(R, p - R * p - climb), "sign, left-handed, other way"),
            "the way back": (formula(R.T, p - R.T * p - climb), "inver, sign, -\\theta, other way, transpos"),
            "R transposed, column right": (
                formula(R.T, p - R * p + climb),
                "transpos, other way, left-handed, sign, -\\theta",
            ),
            "all transposed": (formula(R, p - R * p + climb).T, "transpos"),
            "no translation": (formula(R, 0 * p), "left out, missing, translation, column"),
            "no rotation": (formula(E3, climb), "rotation, turn, left out"),
            "2 theta": (formula(R, p - R * p + climb).subs(theta, 2 * theta), "double, twice"),
            "last row 0": (formula(R, p - R * p + climb) - sp.diag(0, 0, 0, 1), "last row"),
            "degrees": (formula(R, p - R * p + climb).subs(theta, sp.pi * theta / 180), "degrees, radians"),
            "climb turned along the point": (formula(R, p - R * p + h * theta * p), "climb, axis, point"),
            "R p - p and left-handed": (formula(R, R * p - p - climb), "sign, left-handed, other way, inver"),
            "no climb, turned the other way": (
                formula(R.T, p - R.T * p),
                "climb, other way, transpos, left-handed, sign, -\\theta",
            ),
            "R p and no climb": (formula(R, R * p), "climb, R\\,p, p - R"),
        }
    )
    yield from right(
        {
            "text": str(answer.tolist()),
            "SymPy": formula(R, p - R * p + climb),
            "by G(theta) v": formula(R, v * theta + (1 - cos) * W * v + (theta - sin) * W * W * v + climb),
        }
    )
