"""Answers by hand to sheet 03."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from evidence.answers_by_hand import WrongAnswer, alike, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common import words as by
from evidence.answers_by_hand.common.drawn_axis import screw_of_a_drawn_axis
from evidence.answers_by_hand.common.kinematics import logarithm
from evidence.answers_by_hand.common.motions import (
    I3,
    Ad,
    exp,
    halves_swapped,
    negated,
    negated_one,
    parts,
    pose,
    product,
    series,
    swapped,
    twist,
)

inv = np.linalg.inv
Answers = Iterator[WrongAnswer]
MOMENT_SIGN = np.array([1, 1, 1, -1, -1, -1])


@wrong_answers("03.1")
def plain_arm(given: Any, answer: Any) -> Answers:
    d, p, slide = np.asarray(given.axes), np.asarray(given.points), np.array([[kind == "P"] for kind in given.letters])
    zero, m = 0 * d, np.cross(p, d)

    def rows(w: Any = d, v: Any = m, sw: Any = zero, sv: Any = d) -> Any:
        """Screws (w, v) of revolute joints, and (sw, sv) of prismatic ones."""
        return np.where(slide, np.hstack([sw, sv]), np.hstack([w, v]))

    S, first = rows(), (np.arange(3) == np.argmin(slide))[:, None]
    other_points = np.cross(np.roll(p, -1, axis=0), d)
    yield from alike(by.MOMENT, {"omega x p": rows(v=-m), "middle sign of the product": rows(v=m * (1, -1, 1))})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(S), "but for the slide": rows(m, d)})
    yield from alike(by.POINT | {"-p$ as the moment"}, {"point as moment": rows(v=p), "-p": rows(v=-p)})
    yield from alike(by.OMITTED | {"moment", "origin"}, {"no moment": rows(v=zero)})
    yield from alike(by.SLIDE, {"slide as turn": rows(sw=d, sv=m), "moment of a slide": rows(sv=m)})
    yield from alike(by.SLIDE | by.HALVES, {"slide in omega": rows(sw=d, sv=zero), "twice": rows(sw=d)})
    yield from alike(by.SLIDE, {"point of a slide": rows(sv=p), "no slide": rows(sv=zero)})
    yield from alike(by.SLIDE | by.SIGN, {"slide backwards": rows(sv=-d)})
    yield from alike(by.JOINT | by.POINT, {"points of the next joint": rows(v=other_points)})
    yield from alike(by.ORDER, {"last joint first": S[::-1], "rows 1 and 2 swapped": swapped(S, 0, 1)})
    yield from alike(by.SIGN, {"one axis the other way": np.where(first, -S, S)})
    yield from alike(by.MOMENT, {"one omega negated": np.where(first, -S * MOMENT_SIGN, S)})
    yield from alike(by.MOMENT, {"omega x p in one row": np.where(first, S * MOMENT_SIGN, S)})
    yield from alike(by.ELEMENTWISE | by.MOMENT, {"moment entry by entry": rows(v=d * p)})
    yield from alike(by.MOMENT | by.SLIDE, {"omega x p, slide as turn": rows(v=-m, sw=d, sv=-m)})
    yield from alike(by.MOMENT | by.HALVES, {"omega x p, halves swapped": halves_swapped(rows(v=-m))})
    yield from alike(by.POINT | by.SLIDE | by.HALVES, {"point as moment, slide in omega": rows(v=p, sw=d, sv=zero)})
    yield from right({"integers": S.astype(int), "list": S.tolist(), "-omega x p": rows(v=-np.cross(d, p))})


@wrong_answers("03.2")
def angled_joint(given: Any, answer: Any) -> Answers:
    u, t, p = np.asarray(given.from_axis), np.asarray(given.towards), np.asarray(given.point)
    d, other = given.degrees, np.abs(np.cross(u, t))

    def line(c: float, s: float, u: Any = u, t: Any = t) -> Any:
        return np.array([*(c * u + s * t), *np.cross(p, c * u + s * t)])

    def at(angle: float) -> Any:
        return line(np.cos(angle), np.sin(angle))

    c, s = np.cos(np.radians(d)), np.sin(np.radians(d))
    S = line(c, s)
    w, v = S[:3], S[3:]
    lean = {"lean", "angle", "towards", "degrees", *by.AXIS}
    yield from alike(by.SWAPPED, {"sine and cosine swapped": line(s, c)})
    yield from alike(by.SIGN | {"away", "other way"}, {"away": line(c, -s), "-cosine": line(-c, s)})
    yield from alike(by.DEGREES, {"degrees": at(d)})
    yield from alike(by.LENGTH, {"(1, tan)": line(1, s / c), "(1, 1)": line(1, 1)})
    yield from alike(by.MOMENT, {"omega x p": S * MOMENT_SIGN, "-omega, moment kept": -S * MOMENT_SIGN})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(S)})
    yield from alike(by.POINT, {"point as moment": [*w, *p]})
    yield from alike(by.OMITTED | {"moment", "origin"}, {"no moment": [*w, 0, 0, 0]})
    yield from alike(lean, {"not tilted": line(1, 0), "moment of the upright axis": [*w, *np.cross(p, u)]})
    yield from alike(lean, {"towards the third axis": line(c, s, u, other), "from the third": line(c, s, other, t)})
    yield from alike(by.SLIDE | {"omega$ and the moment at zero"}, {"as a slide": [0, 0, 0, *w]})
    yield from alike(by.SIGN, {"-S": -S, "one sign of v": [*w, *negated_one(v)]})
    yield from alike(by.HALF, {"half the angle": at(np.radians(d / 2))})
    yield from alike(by.DOUBLE, {"twice the angle": at(np.radians(2 * d))})
    yield from alike(by.MOMENT, {"middle sign of the cross product": [*w, *v * (1, -1, 1)]})
    yield from alike(by.ELEMENTWISE | by.MOMENT, {"moment entry by entry": [*w, *w * p]})
    yield from alike(by.SWAPPED | by.MOMENT, {"swapped and omega x p": line(s, c) * MOMENT_SIGN})
    yield from alike({"away"} | by.MOMENT, {"away and omega x p": line(c, -s) * MOMENT_SIGN})
    yield from alike(by.DEGREES | by.MOMENT, {"degrees and omega x p": at(d) * MOMENT_SIGN})
    other_point = [*w, *np.cross(p + 2 * w, w)]
    yield from right({"list": S.tolist(), "three decimals": S.round(3), "another point of the axis": other_point})


@wrong_answers("03.3")
def leaning_slide(given: Any, answer: Any) -> Answers:
    n, p, zero = np.asarray(given.direction, dtype=float), np.asarray(given.point), np.zeros(3)
    size = np.linalg.norm(n)
    d = n / size
    turn = {"\\omega", "rotation", "turn", "revolute"}
    yield from alike(turn | by.HALVES, {"direction in omega": [*d, *zero], "in both": [*d, *d]})
    yield from alike(turn, {"as a turn": [*d, *np.cross(p, d)], "as a turn, point as moment": [*d, *p]})
    yield from alike(turn | by.MOMENT, {"as a turn, omega x p": [*d, *np.cross(d, p)]})
    yield from alike(turn | by.LENGTH, {"as a turn, not divided": [*n, *np.cross(p, n)]})
    yield from alike(by.LENGTH, {"not divided": [*zero, *n], "by the sum": [*zero, *n / np.abs(n).sum()]})
    yield from alike(by.LENGTH, {"by the square": [*zero, *n / size**2]})
    yield from alike(by.LENGTH, {"by the largest": [*zero, *n / np.abs(n).max()]})
    yield from alike(
        by.POINT | {"moment"}, {"moment as v": [*zero, *np.cross(p, d)], "omega x p as v": [*zero, *np.cross(d, p)]}
    )
    yield from alike(by.POINT, {"the point as v": [*zero, *p], "to the point": [*zero, *p / np.linalg.norm(p)]})
    yield from alike(by.SIGN, {"-d": [*zero, *-d], "one sign": [*zero, *negated_one(d)], "sizes": [*zero, *np.abs(d)]})
    yield from alike(by.ORDER, {"components rotated": [*zero, *np.roll(d, 1)]})
    yield from alike(turn | by.LENGTH, {"direction in omega, not divided": [*n, *zero]})
    yield from alike(turn | by.SIGN, {"-d in omega": [*-d, *zero]})
    yield from alike(by.SIGN | by.LENGTH, {"-d, not divided": [*zero, *-n]})
    yield from right(
        {"list": [0, 0, 0, *d], "three decimals": [0, 0, 0, *d.round(3)], "of n": np.array([*zero, *n]) / size}
    )


@wrong_answers("03.4")
def helical_joint(given: Any, answer: Any) -> Answers:
    w, p, lead = np.asarray(given.axis), np.asarray(given.point), given.lead
    m, h = np.cross(p, w), lead / (2 * np.pi)

    def spindle(m: Any = m, h: float = h, w: Any = w) -> Any:
        return np.array([*w, *m + h * w])

    S, other_way = spindle(), by.SIGN | {"left-handed", "wrong way", "other way"}
    yield from alike(by.PITCH, {"lead for pitch": spindle(h=lead), "lead times 2 pi": spindle(h=2 * np.pi * lead)})
    yield from alike(by.PITCH | {"h\\,\\omega"}, {"lead / pi": spindle(h=lead / np.pi), "no climb": spindle(h=0)})
    yield from alike(by.PITCH | by.DEGREES, {"lead / 360": spindle(h=lead / 360)})
    yield from alike(by.OMITTED | {"moment"}, {"no moment": spindle(0 * m)})
    yield from alike(other_way, {"left-handed": spindle(h=-h), "axis negated, climb kept": spindle(-m, -h, -w)})
    yield from alike(by.MOMENT, {"omega x p": spindle(-m), "-v": spindle(-m, -h), "one sign": spindle(negated_one(m))})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(S)})
    yield from alike(by.POINT, {"point as moment": spindle(p)})
    yield from alike(by.PITCH | {"axis"}, {"pitch along the point": spindle(m + h * (p - w))})
    yield from alike(by.PITCH | {"axis"}, {"pitch everywhere": [*w, *m + h]})
    yield from alike(by.PITCH | {"\\omega"}, {"omega times the pitch": [*h * w, *m]})
    yield from alike(
        by.SLIDE | {"omega$ and the moment at zero"},
        {"as a slide": [0, 0, 0, *w], "as a slide by the pitch": [0, 0, 0, *h * w]},
    )
    yield from alike(by.SIGN, {"-S": -S})
    yield from alike(by.MOMENT | by.PITCH, {"omega x p, lead": spindle(-m, lead)})
    yield from alike(by.MOMENT | by.PITCH, {"omega x p, no climb": spindle(-m, 0)})
    yield from alike(by.HALVES | by.PITCH, {"halves swapped, lead for pitch": halves_swapped(spindle(h=lead))})
    yield from right({"list": S.tolist(), "three decimals": S.round(3), "-omega x p": spindle(-np.cross(w, p))})


wrong_answers("03.5")(screw_of_a_drawn_axis)


@wrong_answers("03.6")
def which_order(given: Any, answer: Any) -> Answers:
    e, listed = list(answer[:4]), [f"e_{name}" for name in given.rides_on]
    home = by.ORDER | {"$M$"}
    yield from alike(by.ORDER, {"reversed": [*e[::-1], "M"], "all reversed": ["M", *e[::-1]]})
    yield from alike(home, {"home first": ["M", *e], "M in the middle": [*e[:2], "M", *e[2:]]})
    yield from alike(home, {"M before the last joint": [*e[:3], "M", e[3]]})
    yield from alike({"alphabet", "names"}, {"by the alphabet": [*sorted(e), "M"], "and home first": ["M", *sorted(e)]})
    if listed != e:  # the statement lists the joints in an order of its own, by chance from the floor to the tool
        yield from alike(by.ORDER | {"listed", "statement"}, {"as listed": [*listed, "M"]})
    if listed[::-1] != e:
        yield from alike(by.ORDER | {"listed", "statement"}, {"as listed, reversed": [*listed[::-1], "M"]})
    for k, which in enumerate(["first", "middle", "last"]):
        yield from alike(by.ORDER, {f"{which} two swapped": [*e[:k], e[k + 1], e[k], *e[k + 2 :], "M"]})
    yield from alike(by.ORDER, {"floor last": [*e[1:], e[0], "M"], "tool first": [e[3], *e[:3], "M"]})
    yield from right({"tuple": tuple(answer), "list": list(answer)})


@wrong_answers("03.7")
def where_is_the_tool(given: Any, answer: Any) -> Answers:
    S, M = np.asarray(given.screws), np.asarray(given.home)
    slide = np.abs(S[:, :3]).sum(axis=1) == 0
    R, p = parts(M)

    def e(q: Any, S: Any = S) -> Any:
        return [exp(S[i], q[i]) for i in range(3)]

    def T(q: Any, S: Any = S, M: Any = M) -> Any:
        return product(*e(q, S), M)

    def picked(order: list[int]) -> Any:
        return lambda q: product(*(e(q)[i] for i in order), M)

    def truncated(terms: int) -> Any:
        return lambda q: product(*(series(twist(S[i]) * q[i], terms) for i in range(3)), M)

    moments = np.where(slide[:, None], S, S * MOMENT_SIGN)
    yield from alike(by.ORDER, {"reversed": picked([2, 1, 0]), "home first": lambda q: product(M, *e(q))})
    yield from alike(by.ORDER, {"home first, reversed": lambda q: product(M, *e(q)[::-1])})
    yield from alike(by.ORDER, {"joints 1 and 2 swapped": picked([1, 0, 2]), "2 and 3": picked([0, 2, 1])})
    yield from alike(by.OMITTED, {"joint 1 left out": picked([1, 2]), "joint 3 left out": picked([0, 1])})
    yield from alike(by.OMITTED | {"$M$"}, {"no M": lambda q: product(*e(q))})
    yield from alike({"home"}, {"stays at home": lambda _: M})
    yield from alike(by.ELEMENTWISE, {"entry by entry": lambda q: e(q)[0] * e(q)[1] * e(q)[2] * M})
    yield from alike({"sum", "add"}, {"sum of e": lambda q: sum(e(q)) @ M, "e of the sum": lambda q: exp(q @ S) @ M})
    yield from alike(by.OTHER_WAY, {"-q": lambda q: T(-np.asarray(q)), "-q_1": lambda q: T(negated(q, 0))})
    yield from alike(by.DEGREES, {"np.radians": lambda q: T(np.radians(q)), "np.degrees": lambda q: T(np.degrees(q))})
    yield from alike(by.INVERTED, {"M inverted": lambda q: T(q, M=inv(M)), "T inverted": lambda q: inv(T(q))})
    yield from alike(by.TRANSPOSED, {"R^T in M": lambda q: T(q, M=pose(R.T, p))})
    yield from alike(by.HALVES, {"halves swapped": lambda q: T(q, halves_swapped(S))})
    yield from alike(by.MOMENT, {"moments negated": lambda q: T(q, moments)})
    yield from alike(by.SERIES, {"I + [S] q": truncated(2), "three terms": truncated(3)})
    yield from alike(by.OMITTED | by.ORDER, {"reversed, no M": lambda q: product(*e(q)[::-1])})
    yield from alike(by.ORDER | by.DEGREES, {"home first, np.radians": lambda q: product(M, *e(np.radians(q)))})
    yield from alike(by.ORDER | by.OTHER_WAY, {"reversed, -q": lambda q: product(*map(inv, e(q)[::-1]), M)})
    if slide.any():
        turned = np.where(slide[:, None], halves_swapped(S), S)
        yield from alike(by.SLIDE | by.HALVES, {"slide in omega": lambda q: T(q, turned)})
        yield from alike(by.DEGREES, {"np.degrees, not of the slide": lambda q: T(np.where(slide, q, np.degrees(q)))})
        yield from alike(by.SLIDE | by.OMITTED, {"slide left out": lambda q: T(np.where(slide, 0, q))})
    body = [Ad(inv(M)) @ row for row in S]
    yield from right({"function": T, "list": lambda q: T(q).tolist(), "body form": lambda q: product(M, *e(q, body))})


@wrong_answers("03.8")
def longer_tool(given: Any, answer: Any) -> Answers:
    S, M, L, q = np.asarray(given.screws), np.asarray(given.home), given.longer, np.asarray(given.q)
    slide, X, Y, Z = np.abs(S[:, :3]).sum(axis=1) == 0, *(pose(I3, L * axis) for axis in I3)

    def e(q: Any = q, S: Any = S) -> Any:
        return [exp(S[i], q[i]) for i in range(4)]

    def T(q: Any = q, S: Any = S, M: Any = M @ Z) -> Any:
        return product(*e(q, S), M)

    R, p = parts(T())
    left = by.ORDER | {"{s}"}
    old = {"old tool", *by.OMITTED}
    yield from alike(old, {"old tool": T(M=M)})
    yield from alike(left, {"extended in {s}, after the motion": Z @ T(M=M), "extended in {s}, at home": T(M=Z @ M)})
    yield from alike(by.SIGN | by.INVERTED | {"short"}, {"tool shortened": T(M=M @ inv(Z))})
    yield from alike(
        by.AXIS | {"along its $x$", "along its $y$"},
        {"along x of the tool": T(M=M @ X), "along y of the tool": T(M=M @ Y)},
    )
    yield from alike(by.DOUBLE, {"extended twice": T(M=M @ Z @ Z)})
    yield from alike({"screws"}, {"screws moved too": T(S=S @ Ad(Z).T)})
    yield from alike(by.ORDER, {"reversed": product(*e()[::-1], M, Z), "home first": product(M, Z, *e())})
    yield from alike(by.ORDER | old, {"reversed, old tool": product(*e()[::-1], M)})
    yield from alike(by.ORDER | old, {"home first, old": product(M, *e())})
    yield from alike(left, {"reversed, extended in {s}": product(Z, *e()[::-1], M)})
    yield from alike(by.DEGREES, {"np.radians": T(np.radians(q)), "np.degrees": T(np.degrees(q))})
    yield from alike(by.DEGREES, {"np.radians, not of the slide": T(np.where(slide, q, np.radians(q)))})
    yield from alike(by.OTHER_WAY, {"-q": T(-q), "one q negated": T(negated(q, 1))})
    yield from alike(by.OMITTED, {"no M": T(M=Z), "slide left out": T(np.where(slide, 0, q))})
    yield from alike(by.ELEMENTWISE, {"entry by entry": e()[0] * e()[1] * e()[2] * e()[3] * M})
    yield from alike({"home"}, {"home pose": M @ Z})
    yield from alike(by.INVERTED, {"inverse": inv(T())})
    yield from alike(by.TRANSPOSED, {"R transposed": pose(R.T, p)})
    yield from right({"three decimals": T().round(3), "list": T().tolist(), "old T, extended": T(M=M) @ Z})


def _misread(given: Any, value: Any) -> Answers:
    """Formulas with one length of the drawing misread."""
    L = given.L
    yield from alike(by.OMITTED, {f"{L[k]} left out": value.subs(L[k], 0) for k in (0, 1)})
    yield from alike(by.SIGN, {f"-{L[k]}": value.subs(L[k], -L[k]) for k in (0, 2)})
    yield from alike({"where", "instead", "L_"}, {"L_2 for L_1": value.subs(L[0], L[1])})


@wrong_answers("03.9")
def home_of_a_whole_arm(given: Any, answer: Any) -> Answers:
    R, p, L = answer[:3, :3], answer[:3, 3], given.L

    def home(R: Any = R, p: Any = p, last: Any = (0, 0, 0, 1)) -> Any:
        return sp.Matrix.vstack(sp.Matrix.hstack(sp.Matrix(R), sp.Matrix(p)), sp.Matrix([list(last)]))

    yield from _misread(given, answer)
    yield from alike(by.OMITTED, {"without the last link": answer.subs(L[-1], 0)})
    yield from alike(by.TRANSPOSED | by.AXIS, {"R^T": home(R.T), "R^T and -p": home(R.T, -p)})
    yield from alike(by.INVERTED | {"R^T p"}, {"inverse": home(R.T, -R.T * p), "position in {b}": home(p=R.T * p)})
    yield from alike(by.SIGN, {"-p": home(p=-p), "sign of two axes": home(R * sp.diag(-1, 1, -1))})
    yield from alike(by.SWAPPED | by.ORDER | by.AXIS, {"columns 1 and 2 swapped": home(R[:, [1, 0, 2]])})
    yield from alike(by.ORDER | by.AXIS, {"z first": home(R[:, [2, 0, 1]])})
    yield from alike(by.OMITTED | {"identity"}, {"R = I": home(sp.eye(3)), "p = 0": home(p=0 * p)})
    yield from alike({"last row", "corner", "1"}, {"0 in the corner": home(last=(0, 0, 0, 0))})
    yield from alike({"last row", *by.TRANSPOSED}, {"transposed": answer.T})
    yield from alike(by.OMITTED | by.TRANSPOSED, {"R^T, the last link left out": home(R.T, p.subs(L[-1], 0))})
    yield from right({"text": str(answer.tolist()), "expanded": sp.expand(answer), "list": answer.tolist()})


@wrong_answers("03.10")
def screws_of_a_whole_arm(given: Any, answer: Any) -> Answers:
    S, L, n = answer, given.L, answer.shape[0]
    slides = [i for i in range(n) if not any(S[i, :3])]
    turns = [i for i in range(n) if i not in slides]

    def rows(change: Any, which: Any = range(n)) -> Any:
        return sp.Matrix([list(change(S[i, :3], S[i, 3:]) if i in which else S[i, :]) for i in range(n)])

    def minus(w: Any, v: Any) -> Any:
        return [*w, *(-v)]

    def halves(w: Any, v: Any) -> Any:
        return [*v, *w]

    yield from _misread(given, S)
    yield from alike(by.MOMENT, {"omega x p": rows(minus, turns), "omega x p in one row": rows(minus, turns[1:2])})
    yield from alike(by.HALVES, {"halves swapped": rows(halves), "in one row": rows(halves, turns[:1])})
    yield from alike(by.SIGN, {"-S_2": rows(lambda w, v: [*(-w), *(-v)], [1]), "-S": -S})
    yield from alike(by.OMITTED | {"moment"}, {"no moments": rows(lambda w, _: [*w, 0, 0, 0], turns)})
    yield from alike(
        by.ORDER | {"rows", "last joint"}, {"reversed": S[::-1, :], "rows swapped": S[[1, 0, *range(2, n)], :]}
    )
    yield from alike(by.MOMENT | by.OMITTED, {"omega x p, L_1 left out": rows(minus, turns).subs(L[0], 0)})
    yield from alike(by.MOMENT | by.HALVES, {"omega x p, halves swapped": rows(lambda w, v: [*(-v), *w], turns)})
    if slides:
        yield from alike(by.SLIDE | by.HALVES | {"omega"}, {"direction in omega": rows(halves, slides)})
        yield from alike(by.SIGN, {"slide backwards": rows(minus, slides)})
    yield from right({"text": str(S.tolist()), "list": S.tolist(), "expanded": sp.expand(S)})


@wrong_answers("03.11")
def kinematics_of_a_whole_arm(given: Any, answer: Any) -> Answers:
    def read(L: Any) -> Any:
        n = len(L) - 1
        M = answer(np.zeros(n), L)
        return [logarithm(answer(row, L) @ inv(M)) for row in np.eye(n)], M

    def chained(
        order: Any = lambda e, M: [*e, M], factor: float = 1, change: Any = lambda screws, M: (screws, M)
    ) -> Any:
        def fk(q: Any, L: Any) -> Any:
            S, M = change(*read(L))
            return product(*order([exp(row, value) for row, value in zip(S, factor * np.array(q), strict=True)], M))

        return fk

    def moments_negated(S: Any, M: Any) -> Any:
        return [row * MOMENT_SIGN if np.abs(row[:3]).max() > 1e-9 else row for row in S], M

    def r_transposed(S: Any, M: Any) -> Any:
        R, p = parts(M)
        return S, pose(R.T, p)

    yield from alike(
        by.ORDER, {"reversed": chained(lambda e, M: [*e[::-1], M]), "home first": chained(lambda e, M: [M, *e])}
    )
    yield from alike(by.ORDER, {"joints 1 and 2 swapped": chained(lambda e, M: [e[1], e[0], *e[2:], M])})
    yield from alike(
        by.OMITTED, {"no M": chained(lambda e, _: e), "joint 1 left out": chained(lambda e, M: [*e[1:], M])}
    )
    yield from alike({"home"}, {"stays at home": lambda q, L: answer(0 * np.array(q), L)})
    yield from alike(by.DEGREES, {"np.radians": chained(factor=np.pi / 180)})
    yield from alike(by.OTHER_WAY, {"-q": chained(factor=-1)})
    yield from alike(by.INVERTED, {"inverse": lambda q, L: inv(answer(q, L))})
    yield from alike(by.INVERTED, {"M inverted": chained(change=lambda S, M: (S, inv(M)))})
    yield from alike(by.TRANSPOSED, {"R^T in M": chained(change=r_transposed)})
    yield from alike(by.MOMENT, {"moments negated": chained(change=moments_negated)})
    yield from alike(by.HALVES, {"halves swapped": chained(change=lambda S, M: (halves_swapped(S), M))})
    yield from alike(
        {"sum", "add"}, {"e of the sum": lambda q, L: exp(np.array(q) @ np.array(read(L)[0])) @ read(L)[1]}
    )
    yield from alike(by.ORDER | by.OMITTED, {"reversed, no M": chained(lambda e, _: e[::-1])})
    yield from right({"function": chained(), "list": lambda q, L: answer(q, L).tolist()})


@wrong_answers("03.12")
def palletizer(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.screws(answer))
