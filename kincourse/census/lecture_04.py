"""Answers by hand to sheet 04."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from kincourse.census import WrongAnswer, right, wrong, wrong_answers
from kincourse.census.motions import I3, Ad, exp, hat, negated, negated_one, parts, pose, product, swapped

inv = np.linalg.inv


def _halves(S: Any) -> Any:
    return np.roll(S, 3, axis=-1)


def _only_rotated(R: Any, S: Any) -> Any:
    return np.hstack([S[:, :3] @ R.T, S[:, 3:] @ R.T])


@wrong_answers("04.1")
def body_screw_off_a_drawing(given: Any, B: Any) -> Iterator[WrongAnswer]:
    w, v = np.array(B[:3]).round(9), np.array(B[3:]).round(9)
    p = np.cross(w, v)
    k = int(np.argmax(np.abs(w)))
    i, j = (k + 1) % 3, (k + 2) % 3
    yield from wrong(
        {
            "-B": ([*-w, *-v], "opposite, sign, other way"),
            "omega x p": ([*w, *-v], "\\times, sign, minus, from {b}, arrow"),
            "-omega, moment kept": ([*-w, *v], "opposite, sign, \\times, minus"),
            "halves swapped": ([*v, *w], "swap, halves, (v"),
            "point as moment": ([*w, *p], "point, moment"),
            "no moment": ([*w, 0, 0, 0], "moment, left out, missing, origin"),
            "as a slide": ([0, 0, 0, *w], "slide, prismatic, \\omega"),
            "another axis, moment kept": ([*np.roll(w, 1), *v], "axis, omega"),
            "another axis": ([*np.roll(w, 1), *np.cross(p, np.roll(w, 1))], "axis"),
            "two coordinates swapped": ([*w, *np.cross(swapped(p, i, j), w)], "swap"),
            "one sign of the point": ([*w, *np.cross(negated_one(p), w)], "sign"),
            "point one metre off": ([*w, *np.cross(p + I3[i], w)], "coordinate, point, metre"),
            "entries of v swapped": ([*w, *swapped(v, i, j)], "swap, order"),
            "moment along the axis": ([*w, *v + w], "moment, axis, perpendicular"),
            "-B and halves swapped": ([*-v, *-w], "opposite, sign, swap, halves"),
            "omega x p and halves swapped": ([*-v, *w], "\\times, sign, swap, halves"),
            "point as moment, halves swapped": ([*p, *w], "point, swap, halves"),
        }
    )
    yield from right({"integers": np.round(B).astype(int), "list": [float(x) for x in B], "tuple": tuple(np.round(B))})


def _carried(S: Any, T: Any, given_name: str, other: str) -> dict[str, tuple[Any, str]]:
    """Ways to take screws in rows through Ad of the inverse of T (4, 4), all of them wrong.

    given_name, other  names of the screws that are given, and of T, in feedback
    """
    R, p = parts(T)
    zero = np.zeros((3, 3))
    upper = np.block([[R.T, hat(-R.T @ p) @ R.T], [zero, R.T]])
    r_for_rt = np.block([[R, zero], [hat(-R @ p) @ R, R]])
    flawed_p = np.block([[R.T, zero], [hat(-p) @ R.T, R.T]])
    r_before_p = np.block([[R.T, zero], [R.T @ hat(p), R.T]])
    return {
        f"as given: {given_name}": (S, f"given, {given_name}, old"),
        "Ad of T": (S @ Ad(T).T, f"inver, other way, {other}, Ad"),
        "Ad without .T": (S @ Ad(inv(T)), "transpos, .T, row"),
        "Ad of T without .T": (S @ Ad(T), "transpos, .T, inver, row"),
        "Ad of the transpose": (S @ Ad(T.T).T, "transpos, inver, rotat, turned"),
        "R for R^T": (S @ r_for_rt.T, "transpos, R"),
        "only rotated": (_only_rotated(R.T, S), "rotat, turned, moment, position, p"),
        "only rotated, with R": (_only_rotated(R, S), "rotat, turned, moment, transpos, R"),
        "only moved": (np.hstack([S[:, :3], S[:, 3:] - np.cross(p, S[:, :3])]), "rotat, axes, moved, R"),
        "only omega rotated": (np.hstack([S[:, :3] @ R, S[:, 3:]]), f"only, omega, moment, {given_name}, read in"),
        "-p for -R^T p": (S @ flawed_p.T, "-p, position, inver, p"),
        "sign of the moment": (S @ r_before_p.T, "sign, p"),
        "block on the wrong side": (S @ upper.T, "block, [p], halves, corner"),
        "no [p] in Ad, v left out": (np.hstack([S[:, :3] @ R, 0 * S[:, 3:]]), "left out, moment, v, missing"),
        "halves swapped": (_halves(S @ Ad(inv(T)).T), "swap, halves, (v"),
        "halves swapped before": (_halves(S) @ Ad(inv(T)).T, "swap, halves, (v"),
        "one sign": (negated_one(S @ Ad(inv(T)).T), "sign"),
        "last joint first": ((S @ Ad(inv(T)).T)[::-1], "order, revers, row"),
        "all the other way": (-S @ Ad(inv(T)).T, "sign, opposite"),
        "elementwise": (
            np.array([(Ad(inv(T)) * row).sum(axis=0) for row in S]),
            "elementwise, entry by entry, transpos, .T, row",
        ),
        "Ad of T, halves swapped": (_halves(S @ Ad(T).T), "inver, other way, swap, halves"),
        "Ad without .T, halves swapped": (_halves(S @ Ad(inv(T))), "transpos, .T, swap, halves, row"),
        "R for R^T, last joint first": ((S @ r_for_rt.T)[::-1], "transpos, R, order, revers"),
    }


def _carried_right(S: Any, T: Any) -> dict[str, Any]:
    rows = S @ Ad(inv(T)).T
    return {"three decimals": rows.round(3), "list": rows.tolist(), "solve": np.linalg.solve(Ad(T), S.T).T}


@wrong_answers("04.2")
def by_the_adjoint(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    S, M = np.asarray(given.screws), np.asarray(given.home)
    yield from wrong(_carried(S, M, "space screws", "M"))
    yield from right(_carried_right(S, M))


@wrong_answers("04.3")
def back_to_space(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    B, M = np.asarray(given.body_screws), np.asarray(given.home)
    yield from wrong(_carried(B, inv(M), "body screws", "M"))
    yield from right(_carried_right(B, inv(M)))


@wrong_answers("04.4")
def where_home_stands(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    names, k = [f"e_{name}" for name in given.from_floor_to_tool], len(given.read_in_s)
    left, other = names[:k], names[k:]
    orders = {
        "home last": ([*names, "M"], "M"),
        "home first": (["M", *names], "M"),
        "body part reversed": ([*left, "M", *other[::-1]], "revers, turned, behind M, body part"),
        "space part reversed": ([*left[::-1], "M", *other], "revers, swap, order"),
        "all joints reversed": ([*names[::-1][:k], "M", *names[::-1][k:]], "tool, revers"),
        "all reversed": (list(answer)[::-1], "tool, revers, side"),
        "sides exchanged": ([*other, "M", *left], "side, exchang"),
        "M one joint late": ([*names[: k + 1], "M", *names[k + 1 :]], "M, late, joint"),
        "M one joint early": ([*names[: k - 1], "M", *names[k - 1 :]], "M, early, joint, front"),
        "both parts reversed": ([*left[::-1], "M", *other[::-1]], "revers"),
        "by the alphabet": ([*sorted(left), "M", *sorted(other)], "alphabet, names"),
        "by the alphabet, home last": ([*sorted(names), "M"], "alphabet, names, M"),
        "last two swapped": ([*left, "M", *other[:-2], other[-1], other[-2]], "swap, revers, turned"),
        "home last, reversed": ([*names[::-1], "M"], "M, revers, tool"),
        "home first, reversed": (["M", *names[::-1]], "M, revers, tool"),
        "sides exchanged, body part reversed": ([*other[::-1], "M", *left], "side, exchang, revers"),
    }
    # With one joint in {s} there is nothing to reverse in its part, so this is no mistake.
    yield from wrong({label: order for label, order in orders.items() if k > 1 or label != "space part reversed"})
    yield from right({"tuple": tuple(answer), "list": list(answer)})


def _joint_values(values: Any, screws: Any) -> tuple[Any, dict[str, tuple[Any, str]]]:
    """The joint values in radians and metres, and wrong conversions of the typed ones."""
    typed, turns = np.asarray(values, dtype=float), np.asarray(screws)[:, :3].any(axis=1)
    q = np.where(turns, np.radians(typed), typed)
    slips = {
        "degrees": (typed, "degrees, radians"),
        "all q negated": (-q, "sign, opposite, other way"),
        "q_1 negated": (negated(q, 0), "sign, opposite"),
        "q_2 negated": (negated(q, 1), "sign, opposite"),
        "first angle in degrees": (np.where(np.arange(len(q)) == 0, typed, q), "degrees, radians"),
        "half the angles": (np.where(turns, q / 2, q), "half"),
        "twice the angles": (np.where(turns, 2 * q, q), "double, twice"),
        "q reversed": (q[::-1], "order, revers, values"),
        "at home": (0 * q, "home, q"),
    }
    if not turns.all():
        slips["radians on the slide"] = (np.radians(typed), "length, slide, metre, radians")
        slips["slide left out"] = (np.where(turns, q, 0), "slide, left out, prismatic, joint")
        slips["slide in millimetres"] = (np.where(turns, q, 1000 * q), "millimetre, metre")
    return q, slips


@wrong_answers("04.5")
def body_form(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    B, M = np.asarray(given.body_screws), np.asarray(given.home)
    q, slips = _joint_values(given.values, B)

    def e(q: Any = q, B: Any = B) -> Any:
        return [exp(B[i], q[i]) for i in range(3)]

    T, (R, p), typed = product(M, *e()), parts(M), np.asarray(given.values)
    S = B @ Ad(M).T
    yield from wrong({label: (product(M, *e(wrong_q)), words) for label, (wrong_q, words) in slips.items()})
    yield from wrong(
        {
            "M last": (product(*e(), M), "M, end, last, space form"),
            "reversed": (product(M, *e()[::-1]), "revers, last, order"),
            "M last, reversed": (product(*e()[::-1], M), "M, revers, order, inver"),
            "no M": (product(*e()), "M, left out"),
            "M inverted": (product(inv(M), *e()), "inver"),
            "R^T in M": (product(pose(R.T, p), *e()), "transpos"),
            "joints 1 and 2 swapped": (product(M, e()[1], e()[0], e()[2]), "swap, order"),
            "joints 2 and 3 swapped": (product(M, e()[0], e()[2], e()[1]), "swap, order"),
            "joint 1 left out": (product(M, *e()[1:]), "left out, joint 1"),
            "joint 3 left out": (product(M, *e()[:2]), "left out, joint 3"),
            "entry by entry": (M * e()[0] * e()[1] * e()[2], "entry by entry, elementwise"),
            "space screws": (product(M, *e(B=S)), "space screws, S"),
            "halves swapped": (product(M, *e(B=_halves(B))), "swap, halves"),
            "inverse": (inv(T), "inver"),
            "M last, degrees": (product(*e(typed), M), "M, degrees, radians"),
            "M last, radians on all": (product(*e(np.radians(typed)), M), "M, length, slide, radians"),
            "reversed, degrees": (product(M, *e(typed)[::-1]), "revers, order, degrees, radians"),
        }
    )
    yield from right({"three decimals": T.round(3), "list": T.tolist(), "space form": product(*e(B=S), M)})


@wrong_answers("04.6")
def home_in_the_middle(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    S, M = np.asarray(given.screws), np.asarray(given.home)
    q, slips = _joint_values(given.values, S)

    def e(q: Any = q) -> Any:
        return [exp(S[i], q[i]) for i in range(4)]

    def middle(q: Any = q, M: Any = M) -> Any:
        return product(*e(q)[:2], M, *e(q)[2:])

    (a, b, c, d), (R, p), typed = e(), parts(M), np.asarray(given.values)
    yield from wrong({label: (middle(wrong_q), words) for label, (wrong_q, words) in slips.items()})
    yield from wrong(
        {
            "M last": (product(a, b, c, d, M), "M, end, last"),
            "M first": (product(M, a, b, c, d), "M, front, first"),
            "M one joint late": (product(a, b, c, M, d), "M, joint 3"),
            "M one joint early": (product(a, M, b, c, d), "M, joint 1, early"),
            "sides exchanged": (product(c, d, M, a, b), "side, exchang"),
            "body part reversed": (product(a, b, M, d, c), "revers, behind $M$, swap, order"),
            "space part reversed": (product(b, a, M, c, d), "revers, swap, order"),
            "all reversed": (product(d, c, M, b, a), "revers, order, side"),
            "both parts reversed": (product(b, a, M, d, c), "revers, swap, order"),
            "no M": (product(a, b, c, d), "M, left out"),
            "M twice": (product(a, b, M, c, d, M), "M, twice"),
            "M inverted": (middle(M=inv(M)), "inver"),
            "R^T in M": (middle(M=pose(R.T, p)), "transpos"),
            "joint 4 left out": (product(a, b, M, c), "left out, joint 4"),
            "entry by entry": (a * b * M * c * d, "entry by entry, elementwise"),
            "inverse": (inv(middle()), "inver"),
            "M last, degrees": (product(*e(typed), M), "M, degrees, radians"),
            "sides exchanged, q_1 negated": (product(c, d, M, inv(a), b), "side, exchang, sign"),
            "M one joint late, radians on all": (
                product(*e(np.radians(typed))[:3], M, e(np.radians(typed))[3]),
                "M, length, slide, radians",
            ),
        }
    )
    yield from right(
        {
            "three decimals": middle().round(3),
            "list": middle().tolist(),
            "screws of {s} only": product(a, b, *(exp(Ad(M) @ S[i], q[i]) for i in (2, 3)), M),
        }
    )


@wrong_answers("04.7")
def new_tool(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    B, H, M = np.asarray(given.body_screws), np.asarray(given.T_bt), np.asarray(given.home)
    S = B @ Ad(M).T
    yield from wrong(
        _carried(B, H, "old", "T_{bt}")
        | {
            "space screws": (S, "space screws"),
            "moved in {s}": (S @ Ad(inv(H @ M)).T, "{s}, order, M"),
            "Ad of M too": (B @ Ad(inv(M @ H)).T, "M, home, twice"),
            "Ad of the inverse of M": (B @ Ad(inv(M)).T, "M, home"),
        }
    )
    yield from right(_carried_right(B, H) | {"by the space screws": S @ Ad(inv(M @ H)).T})


@wrong_answers("04.8")
def jacobian_column(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    B = np.asarray(given.body_screws)
    q, slips = _joint_values(given.values, B)

    def column(q: Any = q) -> Any:
        return Ad(inv(product(exp(B[2], q[2]), exp(B[3], q[3])))) @ B[1]

    a, b, c, d = (exp(B[i], q[i]) for i in range(4))
    (R, p), J, typed = parts(c @ d), column(), np.asarray(given.values)
    # The column does not depend on the first two joints.
    no_effect = {"q_1 negated", "q_2 negated", "first angle in degrees"}
    no_effect |= set() if not B[2:, :3].any(axis=1).all() else {label for label in slips if "slide" in label}
    yield from wrong(
        {label: (column(wrong_q), words) for label, (wrong_q, words) in slips.items() if label not in no_effect}
    )
    yield from wrong(
        {
            "at home": (B[1], "home"),
            "not inverted": (Ad(c @ d) @ B[1], "inver"),
            "reversed": (Ad(inv(d @ c)) @ B[1], "order, revers"),
            "reversed, not inverted": (Ad(d @ c) @ B[1], "order, revers, inver"),
            "joint before": (Ad(inv(a)) @ B[1], "joint 1, before"),
            "all joints": (Ad(inv(a @ b @ c @ d)) @ B[1], "joint 1, all, before"),
            "only joint 3": (Ad(inv(c)) @ B[1], "joint 4, left out"),
            "only joint 4": (Ad(inv(d)) @ B[1], "joint 3, left out"),
            "column 3": (Ad(inv(d)) @ B[2], "column, joint"),
            "column 1": (Ad(inv(b @ c @ d)) @ B[0], "column, joint"),
            "Ad transposed": (Ad(inv(c @ d)).T @ B[1], "transpos, .T"),
            "Ad of the transpose": (Ad((c @ d).T) @ B[1], "transpos, inver"),
            "only rotated": (np.concatenate([R.T @ B[1, :3], R.T @ B[1, 3:]]), "rotat, turned, moment, position"),
            "R for R^T": (np.block([[R, np.zeros((3, 3))], [hat(-R @ p) @ R, R]]) @ B[1], "transpos, R"),
            "halves swapped": (_halves(J), "swap, halves"),
            "the other way": (-J, "sign, opposite"),
            "one sign": (negated_one(J), "sign"),
            "not inverted, degrees": (Ad(exp(B[2], typed[2]) @ exp(B[3], typed[3])) @ B[1], "inver, degrees, radians"),
            "reversed, degrees": (
                Ad(inv(exp(B[3], typed[3]) @ exp(B[2], typed[2]))) @ B[1],
                "order, revers, degrees, radians",
            ),
            "joint before, not inverted": (Ad(a) @ B[1], "joint 1, before, inver"),
        }
    )
    yield from right({"three decimals": J.round(3), "list": J.tolist(), "own joint too": Ad(inv(b @ c @ d)) @ B[1]})
