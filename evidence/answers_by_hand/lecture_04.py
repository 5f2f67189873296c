"""Answers by hand to sheet 04."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from evidence.answers_by_hand import WrongAnswer, alike, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common import words as by
from evidence.answers_by_hand.common.drawn_axis import screw_of_a_drawn_axis
from evidence.answers_by_hand.common.motions import (
    Ad,
    exp,
    halves_swapped,
    hat,
    negated,
    negated_one,
    parts,
    pose,
    product,
)

inv = np.linalg.inv
Answers = Iterator[WrongAnswer]


wrong_answers("04.1")(screw_of_a_drawn_axis)


def _carried(S: Any, T: Any, copied: str, is_inverted: bool = True) -> Answers:
    """Screws in rows, (n, 6), that ought to be carried with Ad of the inverse of T; feedback calls the given ones `copied`.

    is_inverted  whether people invert T; otherwise its inverse is given
    """
    (R, p), zero, Q = parts(T), np.zeros((3, 3)), inv(T)
    rows, w, v = S @ Ad(Q).T, S[:, :3], S[:, 3:]

    def blocks(R: Any, lower: Any) -> Any:
        return S @ np.block([[R, zero], [lower, R]]).T

    rotated, r_for_rt = by.TRANSPOSED | {"rotat", "turned"}, blocks(R, hat(-R @ p if is_inverted else Q[:3, 3]) @ R)
    product_sum = np.array([(Ad(Q) * row).sum(axis=0) for row in S])
    yield from alike(by.COPIED | {copied}, {"as given": S})
    yield from alike(by.INVERTED | {"Ad"}, {"Ad of T": S @ Ad(T).T})
    yield from alike(by.TRANSPOSED | by.INVERTED, {"Ad without .T": S @ Ad(Q), "Ad of T without .T": S @ Ad(T)})
    yield from alike(rotated, {"R for R^T": r_for_rt, "only rotated": blocks(R.T, zero), "with R": blocks(R, zero)})
    yield from alike({"moved", "rotat", "axes"}, {"only moved": np.hstack([w, v - np.cross(p, w)])})
    yield from alike({"rotat", "moment", copied}, {"only omega rotated": np.hstack([w @ R, v])})
    if is_inverted:
        yield from alike(by.INVERTED | {"-p", "position"}, {"-p for -R^T p": blocks(R.T, hat(-p) @ R.T)})
    yield from alike(by.MOMENT, {"sign of p": blocks(R.T, -Ad(Q)[3:, :3]), "one sign": negated_one(rows)})
    yield from alike(by.OMITTED | {"moment"}, {"no v": np.hstack([w @ R, 0 * v])})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(rows), "before": halves_swapped(S) @ Ad(Q).T})
    yield from alike(by.ORDER | {"last joint to the first"}, {"last joint first": rows[::-1]})
    yield from alike(by.SIGN, {"all the other way": -rows})
    yield from alike(by.ELEMENTWISE | by.TRANSPOSED, {"elementwise": product_sum})
    yield from alike(by.INVERTED | by.HALVES, {"Ad of T, halves swapped": halves_swapped(S @ Ad(T).T)})
    yield from alike(by.TRANSPOSED | by.HALVES, {"no .T, halves swapped": halves_swapped(S @ Ad(Q))})
    yield from alike(by.TRANSPOSED | by.ORDER, {"R for R^T, last joint first": r_for_rt[::-1]})
    yield from right({"three decimals": rows.round(3), "list": rows.tolist(), "solve": np.linalg.solve(Ad(T), S.T).T})


@wrong_answers("04.2")
def by_the_adjoint(given: Any, answer: Any) -> Answers:
    yield from _carried(np.asarray(given.screws), np.asarray(given.home), "space screws")


@wrong_answers("04.3")
def back_to_space(given: Any, answer: Any) -> Answers:
    yield from _carried(np.asarray(given.body_screws), inv(given.home), "body screws", is_inverted=False)


@wrong_answers("04.4")
def where_home_stands(given: Any, answer: Any) -> Answers:
    e, k = [f"e_{name}" for name in given.from_floor_to_tool], len(given.read_in_s)
    left, rest = e[:k], e[k:]
    home, names, late, back = by.ORDER | {"$M$"}, {"alphabet", "names", *by.ORDER}, k + 1, k - 1
    yield from alike(home, {"home last": [*e, "M"], "home first": ["M", *e]})
    yield from alike(home, {"M one joint late": [*e[:late], "M", *e[late:]], "early": [*e[:back], "M", *e[back:]]})
    if k < 3:  # one joint alone has no order
        yield from alike(by.ORDER, {"body part reversed": [*left, "M", *rest[::-1]]})
        yield from alike(by.ORDER, {"last two swapped": [*left, "M", *rest[:-2], rest[-1], rest[-2]]})
    if k > 1:
        yield from alike(by.ORDER, {"space part reversed": [*left[::-1], "M", *rest]})
    yield from alike(by.ORDER, {"joints reversed": [*e[::-1][:k], "M", *e[::-1][k:]], "all": list(answer)[::-1]})
    yield from alike(by.ORDER, {"sides swapped": [*rest, "M", *left]})
    yield from alike(by.ORDER, {"both parts reversed": [*left[::-1], "M", *rest[::-1]]})
    yield from alike(names, {"by the alphabet": [*sorted(left), "M", *sorted(rest)], "M last": [*sorted(e), "M"]})
    yield from alike(home, {"home last, reversed": [*e[::-1], "M"], "home first, reversed": ["M", *e[::-1]]})
    yield from alike(home, {"sides swapped, body part reversed": [*rest[::-1], "M", *left]})
    yield from right({"tuple": tuple(answer), "list": list(answer)})


def _radians(values: Any, screws: Any) -> tuple[Any, Any, Any]:
    """The joint values as typed, and in radians and metres, and which joints are revolute."""
    typed, turns = np.asarray(values, dtype=float), np.asarray(screws)[:, :3].any(axis=1)
    return typed, np.where(turns, np.radians(typed), typed), turns


@wrong_answers("04.5")
def body_form(given: Any, answer: Any) -> Answers:
    B, M = np.asarray(given.body_screws), np.asarray(given.home)
    (typed, q, turns), (R, p) = _radians(given.values, B), parts(M)
    S, radians = B @ Ad(M).T, np.radians(typed)

    def e(q: Any = q, B: Any = B) -> Any:
        return [exp(B[i], q[i]) for i in range(3)]

    def T(q: Any = q, B: Any = B, M: Any = M) -> Any:
        return product(M, *e(q, B))

    a, b, c = e()
    yield from alike(by.DEGREES, {"degrees": T(typed), "first angle in degrees": T([typed[0], *q[1:]])})
    yield from alike(by.OTHER_WAY, {"all q negated": T(-q), "q_1 negated": T(negated(q, 0)), "q_2": T(negated(q, 1))})
    yield from alike(by.HALF, {"half the angles": T(np.where(turns, q / 2, q))})
    yield from alike(by.ORDER | {"values"}, {"q reversed": T(q[::-1])})
    yield from alike({"home"}, {"at home": M})
    yield from alike(by.ORDER, {"M last": product(a, b, c, M), "reversed": product(M, c, b, a)})
    yield from alike(by.ORDER, {"1 and 2 swapped": product(M, b, a, c), "2 and 3 swapped": product(M, a, c, b)})
    yield from alike(by.OMITTED, {"no M": product(a, b, c), "no joint 1": product(M, b, c)})
    yield from alike(by.OMITTED, {"no joint 3": product(M, a, b)})
    yield from alike(by.INVERTED, {"M inverted": T(M=inv(M)), "inverse": inv(T())})
    yield from alike(by.TRANSPOSED, {"R^T in M": T(M=pose(R.T, p))})
    yield from alike(by.ELEMENTWISE, {"entry by entry": M * a * b * c})
    yield from alike({"space screws", "space form"}, {"space screws": T(B=S)})
    yield from alike(by.HALVES, {"halves swapped": T(B=halves_swapped(B))})
    if not turns.all():
        yield from alike(by.SLIDE | by.DEGREES | {"length"}, {"radians on the slide": T(radians)})
        yield from alike(by.SLIDE | by.OMITTED, {"slide left out": T(np.where(turns, q, 0))})
        yield from alike({"metres", "mm"}, {"slide in mm": T(np.where(turns, q, 1000 * q))})
        yield from alike(by.ORDER | by.DEGREES, {"M last, radians on the slide": product(*e(radians), M)})
    yield from alike(by.ORDER | by.DEGREES, {"M last, degrees": product(*e(typed), M)})
    yield from alike(by.ORDER | by.DEGREES, {"reversed, degrees": product(M, *e(typed)[::-1])})
    yield from alike(by.ORDER | by.INVERTED, {"M last, reversed": product(c, b, a, M)})
    yield from right({"three decimals": T().round(3), "list": T().tolist(), "space form": product(*e(B=S), M)})


@wrong_answers("04.6")
def home_in_the_middle(given: Any, answer: Any) -> Answers:
    S, M = np.asarray(given.screws), np.asarray(given.home)
    (typed, q, turns), (R, p) = _radians(given.values, S), parts(M)

    def e(q: Any = q) -> Any:
        return [exp(S[i], q[i]) for i in range(4)]

    def T(q: Any = q, M: Any = M) -> Any:
        return product(*e(q)[:2], M, *e(q)[2:])

    (a, b, c, d), radians = e(), np.radians(typed)
    yield from alike(by.DEGREES, {"degrees": T(typed), "first angle in degrees": T([typed[0], *q[1:]])})
    yield from alike(by.OTHER_WAY, {"all q negated": T(-q), "q_1 negated": T(negated(q, 0)), "q_2": T(negated(q, 1))})
    yield from alike(by.HALF, {"half the angles": T(np.where(turns, q / 2, q))})
    yield from alike({"home"}, {"at home": M})
    yield from alike(by.ORDER, {"M last": product(a, b, c, d, M), "M first": product(M, a, b, c, d)})
    yield from alike(by.ORDER | {"$M$"}, {"M late": product(a, b, c, M, d), "M early": product(a, M, b, c, d)})
    yield from alike(by.ORDER, {"sides swapped": product(c, d, M, a, b), "reversed": product(d, c, M, b, a)})
    yield from alike(by.ORDER, {"body part reversed": product(a, b, M, d, c), "space part": product(b, a, M, c, d)})
    yield from alike(by.ORDER, {"both parts reversed": product(b, a, M, d, c)})
    yield from alike(by.OMITTED, {"no M": product(a, b, c, d), "joint 4 left out": product(a, b, M, c)})
    yield from alike(by.DOUBLE, {"M twice": product(a, b, M, c, d, M)})
    yield from alike(by.INVERTED, {"M inverted": T(M=inv(M)), "inverse": inv(T())})
    yield from alike(by.TRANSPOSED, {"R^T in M": T(M=pose(R.T, p))})
    yield from alike(by.ELEMENTWISE, {"entry by entry": a * b * M * c * d})
    if not turns.all():
        yield from alike(by.SLIDE | by.DEGREES | {"length"}, {"radians on the slide": T(radians)})
        yield from alike(by.SLIDE | by.OMITTED, {"slide left out": T(np.where(turns, q, 0))})
        yield from alike(by.ORDER | by.DEGREES, {"M last, radians on the slide": product(*e(radians), M)})
    yield from alike(by.ORDER | by.DEGREES, {"M last, degrees": product(*e(typed), M)})
    yield from alike(by.ORDER | by.SIGN, {"sides swapped, q_1 negated": product(c, d, M, inv(a), b)})
    yield from alike(by.ORDER | by.DEGREES, {"M first, degrees": product(M, *e(typed))})
    space = [exp(Ad(M) @ S[i], q[i]) for i in (2, 3)]
    yield from right({"three decimals": T().round(3), "list": T().tolist(), "space form": product(a, b, *space, M)})


@wrong_answers("04.7")
def new_tool(given: Any, answer: Any) -> Answers:
    B, H, M = np.asarray(given.body_screws), np.asarray(given.T_bt), np.asarray(given.home)
    S = B @ Ad(M).T
    yield from _carried(B, H, "old")
    yield from alike({"space screws"}, {"space screws": S})
    yield from alike(by.ORDER | {"{s}"}, {"moved in {s}": S @ Ad(inv(H @ M)).T})
    yield from alike({"$M$", "home"}, {"M too": B @ Ad(inv(M @ H)).T, "M instead": B @ Ad(inv(M)).T})
    yield from right({"by the space screws": S @ Ad(inv(M @ H)).T})


@wrong_answers("04.8")
def jacobian_column(given: Any, answer: Any) -> Answers:
    B = np.asarray(given.body_screws)
    typed, q, turns = _radians(given.values, B)

    def e(q: Any = q) -> Any:
        return [exp(B[i], q[i]) for i in range(4)]

    def column(q: Any = q) -> Any:
        return Ad(inv(product(*e(q)[2:]))) @ B[1]

    (a, b, c, d), (_, _, c_typed, d_typed) = e(), e(typed)
    (R, p), J, w, v = parts(c @ d), column(), B[1, :3], B[1, 3:]
    yield from alike(by.DEGREES, {"degrees": column(typed)})
    yield from alike(by.OTHER_WAY, {"q_4 negated": column(negated(q, 3))})
    yield from alike(by.HALF, {"half the angles": column(np.where(turns, q / 2, q))})
    yield from alike(by.ORDER | {"values"}, {"q reversed": column(q[::-1])})
    yield from alike({"home"}, {"at home": B[1]})
    yield from alike(by.INVERTED, {"not inverted": Ad(c @ d) @ B[1]})
    yield from alike(by.ORDER, {"reversed": Ad(inv(d @ c)) @ B[1]})
    yield from alike(by.ORDER | by.OTHER_WAY, {"all q negated, or reversed and not inverted": Ad(d @ c) @ B[1]})
    yield from alike(by.JOINT, {"joint before": Ad(inv(a)) @ B[1], "all joints": Ad(inv(a @ b @ c @ d)) @ B[1]})
    yield from alike(by.JOINT | by.OMITTED, {"only joint 3": Ad(inv(c)) @ B[1], "only joint 4": Ad(inv(d)) @ B[1]})
    yield from alike(by.JOINT | {"column"}, {"column 3": Ad(inv(d)) @ B[2], "column 1": Ad(inv(b @ c @ d)) @ B[0]})
    yield from alike(by.TRANSPOSED, {"Ad transposed": Ad(inv(c @ d)).T @ B[1]})
    yield from alike(by.TRANSPOSED, {"R for R^T": [*R @ w, *R @ (v - np.cross(p, w))]})
    yield from alike({"rotat", "moment"}, {"only rotated": [*R.T @ w, *R.T @ v], "only omega": [*R.T @ w, *v]})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(J)})
    yield from alike(by.SIGN, {"the other way": -J, "one sign": negated_one(J)})
    if not turns[2:].all():
        yield from alike(by.SLIDE | by.DEGREES | {"length"}, {"radians on the slide": column(np.radians(typed))})
        yield from alike(by.SLIDE | by.OMITTED, {"slide left out": column(np.where(turns, q, 0))})
    yield from alike(by.INVERTED | by.DEGREES, {"not inverted, degrees": Ad(c_typed @ d_typed) @ B[1]})
    yield from alike(by.ORDER | by.DEGREES, {"reversed, degrees": Ad(inv(d_typed @ c_typed)) @ B[1]})
    yield from alike(by.JOINT | by.INVERTED, {"joint before, not inverted": Ad(a) @ B[1]})
    own = Ad(inv(b @ c @ d)) @ B[1]  # a screw does not move its own axis
    yield from right({"three decimals": J.round(3), "own joint too": own, "two steps": Ad(inv(d)) @ Ad(inv(c)) @ B[1]})


@wrong_answers("04.9")
def twist_of_the_tool(given: Any, answer: Any) -> Answers:
    B = np.asarray(given.body_screws)
    (typed, q, turns), (rates, dq, _) = _radians(given.values, B), _radians(given.rates, B)

    def J(q: Any = q, invert: Any = inv) -> Any:
        b, c = [exp(B[i], q[i]) for i in (1, 2)]
        return np.column_stack([Ad(invert(b @ c)) @ B[0], Ad(invert(c)) @ B[1], B[2]])

    a, b, c = [exp(B[i], q[i]) for i in range(3)]
    V, columns = J() @ dq, J()
    before = np.column_stack([B[0], Ad(a) @ B[1], Ad(a @ b) @ B[2]])
    swapped = np.column_stack([Ad(inv(c @ b)) @ B[0], *columns.T[1:]])
    yield from alike(by.DEGREES, {"degrees": J(typed) @ rates, "angles": J(typed) @ dq, "rates": J() @ rates})
    yield from alike(by.OTHER_WAY, {"q_3 negated": J(negated(q, 2)) @ dq, "rate 2 negated": J() @ negated(dq, 1)})
    yield from alike(by.OTHER_WAY | {"before"}, {"all q negated": J(-q) @ dq})
    yield from alike({"home"}, {"at home": B.T @ dq})
    yield from alike(by.JOINT, {"joints before": before @ dq})
    yield from alike(by.INVERTED, {"not inverted": J(invert=np.asarray) @ dq})
    yield from alike(by.ORDER, {"order in the first column": swapped @ dq, "rates reversed": J() @ dq[::-1]})
    yield from alike({"rates", "joint values"}, {"joint values for rates": J() @ q})
    for i in range(3):
        yield from alike(by.OMITTED, {f"joint {i + 1} left out": V - columns[:, i] * dq[i]})
        yield from alike(by.OMITTED | {"factor"}, {f"rate {i + 1} left out": V + columns[:, i] * (1 - dq[i])})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(V)})
    yield from alike(by.SIGN, {"the other way": -V, "one sign": negated_one(V)})
    yield from alike(by.JOINT | by.INVERTED, {"first column at home": V + (B[0] - columns[:, 0]) * dq[0]})
    if not turns.all():
        yield from alike(by.SLIDE | by.DEGREES | {"length"}, {"radians on all rates": J() @ np.radians(rates)})
    yield from right({"three decimals": V.round(3), "list": V.tolist()})


@wrong_answers("04.10")
def singular_wrist(given: Any, answer: Any) -> Answers:
    q_2, rate = np.asarray(answer, dtype=float)
    sign = 1 if np.cross([0, 0, 1], given.towards) @ given.axis_2 > 0 else -1
    other = q_2 + (180 if q_2 < 0 else -180)
    yield from alike(by.SIGN, {"both signs": [-q_2, -rate]})
    yield from alike(by.OTHER_WAY | {"add up"}, {"q_2 negated": [-q_2, rate], "rate negated": [q_2, -rate]})
    yield from alike({"perpendicular"}, {"perpendicular": [sign * (90 - given.tilt), rate]})
    yield from alike({"range"}, {"the other one": [other, rate], "with its rate": [other, -rate]})
    yield from alike({"home"}, {"at home": [0, rate]})
    yield from alike({"rest"}, {"joint 1 at rest": [q_2, 0]})
    yield from alike({"tilt"}, {"the tilt": [given.tilt, rate]})
    yield from alike({"home", "angle"}, {"by the angle at home": [q_2, -given.rate_3 * np.cos(np.radians(given.tilt))]})
    yield from alike(by.SWAPPED, {"swapped": [rate, q_2]})
    yield from alike(by.DEGREES, {"radians": np.radians([q_2, rate])})
    yield from right({"tuple": (q_2, rate), "list": [q_2, rate]})


@wrong_answers("04.11")
def body_screws_of_a_whole_arm(given: Any, answer: Any) -> Answers:
    B, n = answer, answer.shape[0]
    letters = [letter for letter in given.L if B.has(letter)]
    slides = [i for i in range(n) if not any(B[i, :3])]
    turns = [i for i in range(n) if i not in slides]

    def rows(change: Any, which: Any = range(n)) -> Any:
        return sp.Matrix([list(change(B[i, :3], B[i, 3:]) if i in which else B[i, :]) for i in range(n)])

    def minus(w: Any, v: Any) -> Any:
        return [*w, *(-v)]

    def halves(w: Any, v: Any) -> Any:
        return [*v, *w]

    yield from alike(by.OMITTED, {f"{letter} left out": B.subs(letter, 0) for letter in letters[-2:]})
    yield from alike(by.SIGN, {f"-{letters[-1]}": B.subs(letters[-1], -letters[-1])})
    yield from alike(by.MOMENT, {"omega x p": rows(minus, turns), "omega x p in one row": rows(minus, turns[1:2])})
    yield from alike(by.HALVES, {"halves swapped": rows(halves), "in one row": rows(halves, turns[:1])})
    yield from alike(by.SIGN, {"-B_2": rows(lambda w, v: [*(-w), *(-v)], [1]), "-B": -B})
    yield from alike(by.OMITTED | {"moment"}, {"no moments": rows(lambda w, _: [*w, 0, 0, 0], turns)})
    yield from alike(
        by.ORDER | {"rows", "last joint"}, {"reversed": B[::-1, :], "rows swapped": B[[1, 0, *range(2, n)], :]}
    )
    yield from alike(by.MOMENT | by.HALVES, {"omega x p, halves swapped": rows(lambda w, v: [*(-v), *w], turns)})
    if slides:
        yield from alike(by.SLIDE | by.HALVES | {"omega"}, {"direction in omega": rows(halves, slides)})
        yield from alike(by.SIGN, {"slide backwards": rows(minus, slides)})
    yield from right({"text": str(B.tolist()), "list": B.tolist(), "expanded": sp.expand(B)})


@wrong_answers("04.12")
def wrist_with_offsets(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.screws(answer))
