"""Answers by hand to sheet 10: one robot, four ways."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common.kinematics import chain, frame, logarithm, ordinary_forms, pose_slips, turn
from evidence.answers_by_hand.common.motions import Ad, Array, exp, parts, product
from evidence.answers_by_hand.common.tables import SIGN
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP
from evidence.answers_by_hand.lecture_09 import OWN_AXES, rotation, screw


@wrong_answers("10.1")
def from_a_table(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    rows = np.array(given.rows)

    def axis_of(k: int, rows: Any = rows, convention: str = "standard") -> Array:
        """The z axis after k rows as a screw."""
        T = chain([(0, 0, 0, 0), *rows[:k]], convention)
        return screw(T[:3, 2], T[:3, 3])

    T = chain(rows[:2], "standard")
    (R, p), z = parts(T), T[:3, 2]
    S, M = axis_of(2), chain(rows, "standard")
    index, moment = "z_3, frame 3, z_{i-1}, z_2, joint 2, frame", "moment, v, through the origin"
    yield from wrong(
        {
            "z_3": (axis_of(3), index),
            "z_1": (axis_of(1), f"{index}, z_1"),
            "z_0": (axis_of(0), f"{index}, z_0, joint 1"),
            "the modified convention": (axis_of(3, convention="modified"), "convention"),
            "modified products, frame 2": (axis_of(2, convention="modified"), "convention"),
            "omega x p": (np.concatenate([z, np.cross(z, p)]), f"\\times p, omega x p, {SIGN}"),
            "no moment": (screw(z, 0 * p), moment),
            "the point as v": (np.concatenate([z, p]), f"point, position, {moment}"),
            "halves swapped": (np.roll(S, 3), f"(v, half, halves, {SWAP}"),
            "negated": (-S, f"{SIGN}, other way"),
            "omega negated": (S * np.repeat((-1, 1), 3), SIGN),
            "x_2 for z_2": (screw(R[:, 0], p), "x axis, z axis, x_2, column"),
            "a row for a column": (screw(R[2], p), "row, column, transpos"),
            "point of frame 3": (screw(z, M[:3, 3]), "point, frame 3, O_3, origin"),
            "point of frame 1": (screw(z, chain(rows[:1], "standard")[:3, 3]), "point, frame 1, O_1, origin"),
            "the body screw": (Ad(np.linalg.inv(M)) @ S, "body, tool, {b}, B_3"),
            "as joint 3 has it": (np.array([0, 0, 1, 0, 0, 0]), f"own frame, {moment}, {{s}}, frame 2, joint 1"),
            "rows in reverse": (axis_of(2, rows[1::-1]), "order, reverse, row"),
            "alpha negated": (axis_of(2, rows * (1, -1, 1, 1)), f"alpha, {SIGN}"),
            "a and d swapped": (axis_of(2, rows[:, [2, 1, 0, 3]]), SWAP),
            "no offset": (axis_of(2, rows * (1, 1, 1, 0)), "offset, theta"),
            "angles in degrees": (axis_of(2, rows * (1, 180 / np.pi, 1, 180 / np.pi)), "degree, radian"),
            "a prismatic joint": (np.concatenate([0 * z, z]), "prismatic, slide, omega"),
            "z_3, omega x p": (np.concatenate([M[:3, 2], np.cross(M[:3, 2], M[:3, 3])]), f"{index}, \\times p, {SIGN}"),
            "modified, halves swapped": (
                np.roll(axis_of(3, convention="modified"), 3),
                f"convention, (v, half, {SWAP}",
            ),
            "alpha negated, no offset": (axis_of(2, rows * (1, -1, 1, 0)), f"alpha, offset, theta, {SIGN}, {SWAP}"),
        }
    )
    yield from right(ordinary_forms(S))


def frame_change_slips(B: Array, T: Array) -> dict[str, tuple[Any, str]]:
    """Wrong screws, in rows, in a frame that stands at the pose T (4, 4) in the frame of the screws B (n, 6)."""
    (R, p), inv, n = parts(T), np.linalg.inv, len(B)
    best = B @ Ad(inv(T)).T
    w, v = B[:, :3], B[:, 3:]
    first, other = np.arange(n)[:, None] == 0, "Ad, adjoint, inverse, other way, {b} to {s}, {c} to {b}, R^T"
    several = {
        "rows in reverse": (best[::-1], "reverse, order, row, joint"),
        "the first row only": (
            np.where(first, best, B),
            "row, old, as {b}, as it is given, read in, space screws, body screws, second",
        ),
    }
    turns = w.any()
    about = {
        "p with the wrong sign": (np.hstack([w @ R, (v + np.cross(p, w)) @ R]), f"{SIGN}, shift, origin"),
        "shift after the turn": (np.hstack([w @ R, v @ R - np.cross(p, w @ R)]), "order, shift, turn, block, position of the inverse"),
        "only turned": (np.hstack([w @ R, v @ R]), "turned, shift, moment, origin"),
        "only turned, halves swapped": (np.roll(np.hstack([w @ R, v @ R]), 3, axis=1), f"turned, shift, (v, half, origin, {SWAP}"),
        "only shifted": (B @ Ad(inv(frame(p=p))).T, "shift, turn, axes"),
        "only shifted, the other way": (B @ Ad(frame(p=p)).T, f"shift, turn, inverse, axes, {SIGN}"),
        "only omega turned": (np.hstack([w @ R, v]), "omega, half, turn, moment"),
        "only v changed": (np.hstack([w, best[:, 3:]]), "omega, half, turn"),
        "no moments": (np.hstack([w @ R, 0 * v]), f"moment, v = 0, {LEFT_OUT}"),
    }  # fmt: skip
    return {
        "not changed": (B, "old, as {b}, same, read in, read by, space screws, body screws"),
        "Ad of the inverse pose": (B @ Ad(T).T, other),
        "Ad without transpose": (B @ Ad(inv(T)), "transpos, .T, row, column"),
        "Ad of the inverse pose without transpose": (B @ Ad(T), f"transpos, .T, row, column, {other}"),
        "Ad transposed for its inverse": (B @ inv(Ad(T)), "transpos, inverse, .T, row"),
        "only turned, the other way": (np.hstack([w @ R.T, v @ R.T]), "turned, shift, moment, R^T, inverse, origin"),
        "R for R^T": (np.hstack([w @ R.T, (v - np.cross(p, w)) @ R.T]), "R^T, transpos, R for"),
        "halves swapped": (np.roll(best, 3, axis=1), f"(v, half, halves, {SWAP}"),
        "halves swapped before": (np.roll(B, 3, axis=1) @ Ad(inv(T)).T, f"(v, half, halves, {SWAP}, block"),
        "negated": (-best, SIGN),
        "Ad of the inverse pose, halves swapped": (np.roll(B @ Ad(T).T, 3, axis=1), f"{other}, (v, half, {SWAP}"),
        **(about if turns else {}),
        **(several if n > 1 else {}),
    }  # fmt: skip


@wrong_answers("10.2")
def another_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    B, T = np.array(given.body_screws), np.array(given.T_bc)
    yield from wrong(frame_change_slips(B, T))
    yield from right(ordinary_forms(B @ Ad(np.linalg.inv(T)).T))


@wrong_answers("10.3")
def one_of_four(given: Any, answer: str) -> Iterator[WrongAnswer]:
    names = {"a": "space screws, T_{sb}", "b": "body screws, inverse", "c": "table, rpy, yaw", "d": "file, exponential"}
    yield from other_letters(names, answer)


@wrong_answers("10.4")
def joint_origin(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    here, rpy, there = np.array(given.xyz_1), np.radians(given.rpy_1_in_degrees), np.array(given.place_2)
    R, own = rotation(rpy), rotation(rpy, "xyz")
    step = there - here
    x = R.T @ step
    back = "vector from joint 2 to joint 1, parent, sign, negat"
    turned = "R^T, turned, transpos, other way, invers"
    yield from wrong(
        {
            "from the base": (there, "in {s}, base, as it stands"),
            "not turned": (step, "turn, axes"),
            "turned the other way": (R @ step, turned),
            "way back": (-x, back),
            "way back, not turned": (-step, f"{back}, turn"),
            "way back, the other way": (-R @ step, f"{back}, {turned}"),
            "turned, not shifted": (R.T @ there, f"forgot, shift, does not stand, {LEFT_OUT}"),
            "turned the other way, not shifted": (R @ there, f"shift, multipl, {turned}, forgot"),
            "only joint 2 turned": (R.T @ there - here, "turn, shift, rotat"),
            "sum": (R.T @ (there + here), f"added, sum, {SIGN}, differ"),
            "sum, not turned": (there + here, f"added, sum, {SIGN}, turn"),
            "joint 1's own place": (here, "joint 1, parent"),
            "placed as if by joint 1": (here + R @ there, f"{turned}, forward, as if, added"),
            "about its own axes": (own.T @ step, OWN_AXES),
            "yaw first": (rotation(rpy[::-1]).T @ step, "yaw, roll, order"),
            **({"yaw only": (turn("z", rpy[2]).T @ step, f"yaw, roll, {LEFT_OUT}")} if rpy[0] else {}),
            **({"roll only": (turn("x", rpy[0]).T @ step, f"yaw, roll, {LEFT_OUT}")} if rpy[0] else {}),
            "degrees": (rotation(given.rpy_1_in_degrees).T @ step, "degree, radian"),
            "x and y exchanged": (x[[1, 0, 2]], SWAP),
            "the sign of one number": (np.where(np.abs(x) == np.abs(x).max(), -x, x), SIGN),
            "millimetres": (1000 * x, "millimet, mm, 1000, unit"),
            "about its own axes, way back": (-own.T @ step, f"{OWN_AXES}, {back}"),
        }
    )
    yield from right({**ordinary_forms(x), "a tuple": tuple(x)})


@wrong_answers("10.5")
def in_letters(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    a, b, lift = given.a, given.b, given.lift
    plus, minus = ("+", "-") if lift > 0 else ("-", "+")

    def text(radius: str, height: str, c: str = "cos(q1)", s: str = "sin(q1)") -> list[str]:
        return [f"({radius})*{c}", f"({radius})*{s}", height]

    if given.slides:
        radius, height = f"{a} + q2", f"{lift * b}"
        own = {
            "height negated": (text(radius, f"{-lift * b}"), f"height, {SIGN}, mirror"),
            "slide backwards": (text(f"{a} - q2", height), f"{SIGN}, slide, q_2, entries"),
            "q_2 without its offset": (text("q2", height), f"offset, {LEFT_OUT}, entries"),
            "slide left out": (text(f"{a}", height), f"slide, q_2, {LEFT_OUT}"),
            "slide along z": (text(f"{a}", f"{height} + q2"), "along, slide, boom"),
            "slide turned as an angle": (
                text(f"{a}*cos(q2)", f"{height} + {a}*sin(q2)"),
                "slide, turn, prismatic, rotat",
            ),
            "a and b exchanged": (text(f"{b} + q2", f"{lift * a}"), SWAP),
            "boom times slide": (text(f"{a}*q2", height), "times, sum, slide, multipl"),
            "height left out": (text(radius, "0"), f"height, {LEFT_OUT}"),
        }
    else:
        radius, height = f"{b}*cos(q2)", f"{a} {plus} {b}*sin(q2)"
        own = {
            "height negated": (text(radius, f"{a} {minus} {b}*sin(q2)"), f"height, {SIGN}, mirror"),
            "sine and cosine of q_2 swapped": (text(f"{b}*sin(q2)", f"{a} {plus} {b}*cos(q2)"), f"sin, cos, {SWAP}"),
            "boom not turned": (text(f"{b}", f"{a}"), f"q_2, joint 2, {LEFT_OUT}"),
            "height of joint 2 left out": (text(radius, f"{plus}{b}*sin(q2)".lstrip("+")), f"height, {LEFT_OUT}"),
            "a and b exchanged": (text(f"{a}*cos(q2)", f"{b} {plus} {a}*sin(q2)"), SWAP),
            "boom in the height left out": (text(radius, f"{a}"), f"height, {LEFT_OUT}"),
            "angles added": (text(f"{b}", height, "cos(q1 + q2)", "sin(q1 + q2)"), "added, sum, plane, axis"),
            "joint 2 turns half": (text(f"{b}*cos(q2/2)", f"{a} {plus} {b}*sin(q2/2)"), "half, q_2"),
            "joint 2 slides": (text(f"{b} + q2", f"{a}"), "slide, turn, prismatic, revolute, translat"),
        }
    yield from wrong(
        {
            **own,
            "sine and cosine swapped": (text(radius, height, "sin(q1)", "cos(q1)"), f"sin, cos, {SWAP}"),
            "clockwise": (text(radius, height, s="(-sin(q1))"), f"clockwise, {SIGN}, other sense, sense"),
            "joint 1 left out": ([radius, "0", height], f"joint 1, {LEFT_OUT}"),
            "x negated": (text(radius, height, c="(-cos(q1))"), SIGN),
            "q_1 and q_2 exchanged": (
                [entry.replace("q1", "q3").replace("q2", "q1").replace("q3", "q2") for entry in text(radius, height)],
                f"{SWAP}, q_1, q_2"),
            "height not in z": ([*text(radius, height)[:2], f"{a}" if given.slides else "0"], f"height, {LEFT_OUT}, boom"),
            "y and z exchanged": ([text(radius, height)[i] for i in (0, 2, 1)], f"{SWAP}, order, entries"),
            "degrees": (text(radius, height, "cos(pi/180*q1)", "sin(pi/180*q1)"), "degree, radian"),
            "tangent": (text(radius, height, s="tan(q1)"), "sin, tan, entries"),
            "sine and cosine swapped, height negated": (
                [*text(radius, height, "sin(q1)", "cos(q1)")[:2], own["height negated"][0][2]], f"sin, cos, {SWAP}, height, {SIGN}"),
            "clockwise, height negated": (
                [*text(radius, height, s="(-sin(q1))")[:2], own["height negated"][0][2]], f"clockwise, sense, height, {SIGN}"),
            "at a number": ([entry.replace("q1", "0.5").replace("q2", "0.3") for entry in text(radius, height)], "letters, numbers"),
        }
    )  # fmt: skip
    entries = [sp.sympify(entry) for entry in text(radius, height)]
    spread = [str(sp.expand(entry)) for entry in entries]
    yield from right({"text": text(radius, height), "a SymPy matrix": sp.Matrix(entries), "multiplied out": spread})


@wrong_answers("10.6")
def three_arms(given: Any, answer: float) -> Iterator[WrongAnswer]:
    n = int(sum(given.joints))
    m = n - int(answer)  # two loops of d equations: 6 in the plane, 12 in space
    d, planar = m // 2, m == 6
    yield from wrong(
        {
            "no loop": (n, "loop, added"),
            "one loop": (n - d, "one loop, two loops, equations, branches"),
            "three loops": (n - 3 * d, "two loops, three, that is two, carries"),
            "in space" if planar else "in the plane": (n - 2 * (9 - d), "plane, space, six equations, three"),
            "three loops, the other d": (n - 3 * (9 - d), "plane, space, loop, equations"),
            "the object counted": (n - 2 * d + d, "object, loop, body, one loop, equations, branches"),
            "one degree of freedom for the object": (n - 2 * d + 1, "object, degree"),
            "the degrees of freedom of the object": (d, "object, arms, degrees"),
            "degrees of freedom of one arm": (int(given.joints[0]), "one arm, joints"),
            "the arms left over": (int(sum(max(0, j - d) for j in given.joints)), "redundan, each arm, object, three"),
            "fixed": (0, "move, degree"),
            "negative": (2 * d - n or -1, SIGN),
            "equations": (2 * d, "equations, degree, joint"),
            "n - 1 bodies": (n - 2 * d - 1, "loop, one more"),
            "one arm forgotten": (int(sum(given.joints[:2])) - d, "arm, third, two arms"),
        }
        | ({} if planar else {"one loop, in the plane": (n - 3, "plane, space, loop, equations")})
    )  # fmt: skip
    yield from right({"an integer": n - 2 * d, "a float": float(n - 2 * d)})


def product_slips(S: Array, M: Array, q: Array, typed: Array, frames: str = "s") -> dict[str, tuple[Any, str]]:
    """Wrong poses by the product of exponentials, with space screws ("s") or body screws ("b"), values in radians and as typed."""
    e, n = [exp(screw_axis, value) for screw_axis, value in zip(S, q, strict=True)], len(q)

    def of(factors: Any) -> Array:
        return product(*factors, M) if frames == "s" else product(M, *factors)

    other_end = product(M, *e) if frames == "s" else product(*e, M)
    typed_in = [exp(screw_axis, value) for screw_axis, value in zip(S, typed, strict=True)]
    backwards = [exp(screw_axis, -value) for screw_axis, value in zip(S, q, strict=True)]
    turns = np.any(S[:, :3], axis=1)
    too_radian = [exp(screw_axis, np.radians(value)) for screw_axis, value in zip(S, typed, strict=True)]
    reverse, end = "last joint, reverse, order", "front, behind, end, right, space screws, body screws"
    cases: dict[str, tuple[Any, str]] = {
        **pose_slips(of(e)),
        "M at the other end": (other_end, end),
        "M left out": (product(*e), LEFT_OUT),
        "at home": (M, "home, moved"),
        "M inverted": (product(*e, np.linalg.inv(M)) if frames == "s" else product(np.linalg.inv(M), *e), "invers, invert"),
        "one exponential": (of([exp(q @ S)]), "one exponential, added"),
        "degrees as radians": (of(typed_in), "degree, radian"),
        "every joint backwards": (of(backwards), f"other way, {SIGN}, backward"),
        "the first joint left out": (of(e[1:] or [np.eye(4)]), f"{LEFT_OUT}, first, joint 1"),
        "the last joint left out": (of(e[:-1] or [np.eye(4)]), f"{LEFT_OUT}, last, joint"),
        "halves of the screws swapped": (
            of([exp(np.roll(axis, 3), value) for axis, value in zip(S, q, strict=True)]), f"(v, half, halves, {SWAP}, omega"),
        "moments negated": (
            of([exp(axis * np.repeat((1, -1), 3) if turn else axis, value) for axis, value, turn in zip(S, q, turns, strict=True)]),
            f"moment, {SIGN}, \\times p"),
        "the other kind of screws": (
            of([exp((Ad(np.linalg.inv(M)) if frames == "s" else Ad(M)) @ axis, value) for axis, value in zip(S, q, strict=True)]),
            "body screws, space screws, Ad, read, tool"),
        "M at the other end, degrees": (product(M, *typed_in) if frames == "s" else product(*typed_in, M), f"{end}, degree, radian"),
    }  # fmt: skip
    if n > 1:
        cases |= {
            "last joint first": (of(e[::-1]), reverse),
            "values in reverse": (
                of([exp(axis, value) for axis, value in zip(S, q[::-1], strict=True)]),
                f"order, values, {SWAP}",
            ),
            "joints 1 and 2 exchanged": (of([e[1], e[0], *e[2:]]), f"order, {SWAP}, {reverse}"),
            "joint 1 backwards": (of([backwards[0], *e[1:]]), f"{SIGN}, other way, joint 1"),
            "last joint first, M at the other end": (
                product(M, *e[::-1]) if frames == "s" else product(*e[::-1], M),
                f"{reverse}, {end}",
            ),
            "one exponential, M left out": (exp(q @ S), f"one exponential, added, {LEFT_OUT}"),
        }
    if not turns.all() and turns.any():
        cases["the slide in radians too"] = (of(too_radian), "degree, radian, slide")
    return cases


@wrong_answers("10.7")
def where_is_the_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    axes, points, M, q = np.array(given.axes), np.array(given.points), np.array(given.home), np.array(given.q)
    turns = np.array([letter == "R" for letter in given.letters])
    S = np.array([screw(w, p) if t else [0, 0, 0, *w] for w, p, t in zip(axes, points, turns, strict=True)])
    B = S @ Ad(np.linalg.inv(M)).T
    factors, inner = (
        [exp(s, value) for s, value in zip(S, q, strict=True)],
        [exp(b, value) for b, value in zip(B, q, strict=True)],
    )
    T, slips = product(*factors, M), product_slips(S, M, q, np.where(turns, np.degrees(q), q))
    as_turn = [exp(screw(w, p), value) for w, p, value in zip(axes, points, q, strict=True)]
    no_moment = [exp([*w, 0, 0, 0] if t else [0, 0, 0, *w], value) for w, t, value in zip(axes, turns, q, strict=True)]
    yield from wrong(
        slips
        | {
            "body screws, M on the right": (product(*inner, M), "body screws, front, behind"),
            "body screws, last joint first": (product(M, *inner[::-1]), "last joint, reverse, order"),
            "body screws by Ad of M": (
                product(M, *(exp(Ad(M) @ s, value) for s, value in zip(S, q, strict=True))), "Ad, M^{-1}, body screws"),
            "the slide as a turn": (product(*as_turn, M), "slide, prismatic, revolute, turn"),
            "no moments": (product(*no_moment, M), "moment, v = 0, through the origin"),
            "logarithm of the pose added": (exp(logarithm(M) + q @ S), "added, one exponential"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(T))


@wrong_answers("10.8")
def marks_of_the_axes(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.points(answer))


@wrong_answers("10.9")
def screws_of_the_project(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.screws(answer))


@wrong_answers("10.10")
def table_of_the_project(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.rows(answer))


@wrong_answers("10.11")
def origins_of_the_file(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    T = np.array(answer)
    in_base = np.array([np.linalg.multi_dot([np.eye(4), *T[: k + 1]]) for k in range(len(T))])
    straight = T.copy()
    straight[:, :3, :3] = np.eye(3)
    yield from wrong(
        {
            "seen from the child": (np.linalg.inv(T), "invers"),
            "all in the base": (in_base, "base, parent"),
            "no rpy": (straight, "rpy, rotation"),
        }
    )
    yield from right({"as nested lists": T.tolist()})


@wrong_answers("10.12")
def wrong_joint(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from wrong({f"joint {i}": (i, "joint") for i in "1234" if i != answer})


@wrong_answers("10.13")
def how_far_off(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    said = np.array(
        [product(given.home, *(exp(B, q) for B, q in zip(given.body_screws, row, strict=True))) for row in given.q]
    )
    steps = said[:, :3, 3] - np.array(given.poses)[:, :3, 3]
    gaps = 1000 * np.linalg.norm(steps, axis=1)
    yield from wrong(
        {
            "in metres": (gaps.max() / 1000, "metre"),
            "the mean": (gaps.mean(), "mean"),
        }
    )
    if (longest := 1000 * np.abs(steps).max()) < 0.98 * gaps.max():
        yield from wrong({"along one axis": (longest, "component, along, length")})
    yield from right({"computed here": gaps.max()})


@wrong_answers("10.14")
def which_path_writes(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from wrong({f"path {name}": (name, "pen, limits, table") for name in "ABCD" if name != answer})
