"""Answers by hand to sheet 01."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from kincourse.census import WrongAnswer, right, wrong, wrong_answers
from kincourse.census.motions import I3, exp, negated, negated_one, parts, pose, product, rot, swapped

inv = np.linalg.inv


@wrong_answers("01.1")
def pose_off_a_drawing(given: Any, T: Any) -> Iterator[WrongAnswer]:
    R, p = parts(T)
    yield from wrong(
        {
            "axes in rows": (pose(R.T, p), "row, transpos"),
            "T_bs": (inv(T), "T_{bs}, inverse"),
            "R^T and -p": (pose(R.T, -p), "row, transpos, sign, negat, arrow"),
            "all transposed": (T.T, "transpos, last row"),
            "x and y columns swapped": (pose(swapped(R, 0, 1, 1), p), "swap, column, left-handed"),
            "y and z columns swapped": (pose(swapped(R, 1, 2, 1), p), "swap, column, left-handed"),
            "columns in the order y, z, x": (pose(R[:, [1, 2, 0]], p), "column, order"),
            "y the other way": (pose(R * (1, -1, 1), p), "left-handed, sign, opposite"),
            "z the other way": (pose(R * (1, 1, -1), p), "left-handed, sign, opposite"),
            "x and y the other way": (pose(R * (-1, -1, 1), p), "sign, opposite, negat"),
            "x and y of p swapped": (pose(R, p[[1, 0, 2]]), "swap"),
            "y and z of p swapped": (pose(R, p[[0, 2, 1]]), "swap"),
            "-p": (pose(R, -p), "sign, negat, opposite, leads from"),
            "one sign of p": (pose(R, negated(p, 1)), "sign"),
            "p as {b} sees it": (pose(R, R.T @ p), "R^T, {b}, transpos"),
            "p in the last row": (
                pose(R, p).T @ np.diag([0, 0, 0, 1]) + pose(R, 0 * p) @ np.diag([1, 1, 1, 0]),
                "last row",
            ),
            "height left out": (pose(R, p * (1, 1, 0)), "height, left out, missing"),
            "no 1 in the corner": (T * np.array([[1], [1], [1], [0]]), "last row, 1"),
            "axes in rows, x and y of p swapped": (pose(R.T, p[[1, 0, 2]]), "row, transpos, swap"),
            "y the other way, x and y of p swapped": (pose(R * (1, -1, 1), p[[1, 0, 2]]), "left-handed, sign, swap"),
            "axes in rows, one sign of p": (pose(R.T, negated(p, 0)), "row, transpos, sign"),
        }
    )
    yield from right(
        {"integers": T.round().astype(int), "list of lists": T.tolist(), "tuple": tuple(map(tuple, T.round()))}
    )


@wrong_answers("01.2")
def rotation_off_a_drawing(given: Any, R: Any) -> Iterator[WrongAnswer]:
    k = next(i for i in range(3) if R[i, i] > 1 - 1e-9)
    i, j = (k + 1) % 3, (k + 2) % 3
    t = np.arctan2(R[j, i], R[i, i])
    d = np.degrees(t)

    def plane(a: float, b: float, c: float, e: float, one: float = 1.0) -> Any:
        A = np.zeros((3, 3))
        A[k, k], A[i, i], A[i, j], A[j, i], A[j, j] = one, a, b, c, e
        return A

    c, s = np.cos(t), np.sin(t)
    yield from wrong(
        {
            "R_ba": (R.T, "transpos, R_{ba}, other way, sign"),
            "sine and cosine swapped": (plane(s, -c, c, s), "swap, sine and cosine"),
            "sizes of sine and cosine swapped": (rot(k, np.sign(d) * (90 - abs(d))), "swap, sine and cosine"),
            "degrees in np.cos": (exp(d * I3[k]), "degrees, radians"),
            "about the next axis": (rot(i, d), "about, axis"),
            "about the axis before": (rot(j, d), "about, axis"),
            "both sines positive": (plane(c, abs(s), abs(s), c), "sign, minus"),
            "both sines negative": (plane(c, -abs(s), -abs(s), c), "sign, minus"),
            "one cosine negative": (plane(c, -s, s, -c), "sign, minus"),
            "0 for the 1": (plane(c, -s, s, c, 0.0), "1, axis"),
            "twice the angle": (rot(k, 2 * d), "double, twice"),
            "half the angle": (rot(k, d / 2), "half"),
            "supplement of the angle": (rot(k, 180 - d), "180, angle, sign"),
            "180 degrees more": (rot(k, d + 180), "180, sign, angle"),
            "minus R": (-R, "sign, negat"),
            "plane in the upper left corner": (rot(2, d) if k != 2 else rot(0, d), "about, axis"),
            "transposed, sine and cosine swapped": (plane(s, c, -c, s), "transpos, swap, sign, other way"),
            "transposed, about the next axis": (rot(i, -d), "transpos, about, other way"),
            "transposed, degrees": (exp(-d * I3[k]), "transpos, degrees, radians, other way"),
        }
    )
    yield from right(
        {
            "three decimals": R.round(3),
            "list": R.tolist(),
            "by a quarter of the turn": np.linalg.matrix_power(rot(k, d / 4), 4),
        }
    )


@wrong_answers("01.3")
def augmented_matrix(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    d, p, first = given.degrees, np.asarray(given.p, dtype=float), given.first == "shift"

    def map_of(R: Any, p: Any = p, shift_first: bool = first) -> Any:
        return np.array([*np.column_stack([R, R @ p if shift_first else p]), [0, 0, 1]])

    def plane(degrees: float) -> Any:
        return rot(2, degrees)[:2, :2]

    R, A = plane(d), map_of(plane(d))
    column = A[:2, 2]
    yield from wrong(
        {
            "the other order": (map_of(R, shift_first=not first), "order, first, after"),
            "turned the other way": (map_of(R.T), "other way, transpos, clockwise, sign"),
            "R transposed, column right": (map_of(R.T, column, False), "transpos, other way, clockwise, sign"),
            "all transposed": (A.T, "transpos, last row"),
            "translation in the last row": (np.array([[*R[0], 0], [*R[1], 0], [*column, 1]]), "last row"),
            "no translation": (map_of(R, 0 * p), "missing, left out"),
            "degrees in np.cos": (map_of(exp([0, 0, d])[:2, :2]), "degrees, radians"),
            "the inverse map": (inv(A), "inver, back"),
            "-p": (map_of(R, -p), "sign, negat"),
            "one sign of p": (map_of(R, negated(p, 0)), "sign"),
            "x and y of p swapped": (map_of(R, p[::-1]), "swap"),
            "sine and cosine swapped": (
                map_of(np.array([[R[1, 0], -R[0, 0]], [R[0, 0], R[1, 0]]])),
                "swap, sine and cosine",
            ),
            "both sines positive": (map_of(np.abs(R)), "sign, minus"),
            "0 in the corner": (A - np.diag([0, 0, 1]), "last row, 1"),
            "shifted twice": (map_of(R, R @ p + p, False), "twice, order, first"),
            "half the angle": (map_of(plane(d / 2)), "half"),
            "R^T p": (map_of(R, R.T @ p, False), "transpos, other way, inver"),
            "elementwise": (map_of(R, np.diag(R) * p, False), "elementwise, entry by entry, *"),
            "the other order and the other way": (
                map_of(R.T, shift_first=not first),
                "order, first, after, other way, transpos",
            ),
            "the other order and degrees": (
                map_of(exp([0, 0, d])[:2, :2], shift_first=not first),
                "order, degrees, radians",
            ),
            "turned the other way and transposed": (map_of(R.T).T, "other way, transpos, last row"),
        }
    )
    yield from right(
        {
            "three decimals": A.round(3),
            "list": A.tolist(),
            "product of two matrices": map_of(R, p, False) if not first else map_of(R, 0 * p) @ map_of(np.eye(2), p),
        }
    )


@wrong_answers("01.4")
def point_and_arrow(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    (R, p), x, d = parts(given.T_sc), np.asarray(given.point_c), np.asarray(given.arrow_c)
    X, D = R @ x + p, R @ d
    yield from wrong(
        {
            "arrow as a point": ([X, D + p], "arrow"),
            "point as an arrow": ([R @ x, D], "point"),
            "1 and 0 exchanged": ([R @ x, D + p], "exchang, swap"),
            "other end of the rod": ([X, X + D], "end, added"),
            "T_cs": ([R.T @ (x - p), R.T @ d], "T_{cs}, inver, back"),
            "R transposed": ([R.T @ x + p, R.T @ d], "transpos, R^T"),
            "R transposed for the arrow only": ([X, R.T @ d], "transpos, R^T"),
            "not turned": ([x + p, d], "not rotate, R, did not turn"),
            "arrow left as it is": ([X, d], "not rotate, did not turn, R"),
            "as given": ([x, d], "given, camera, {c}"),
            "-p": ([R @ x - p, D], "sign, -p"),
            "shifted before it is turned": ([R @ (x + p), D], "order, first, before"),
            "shifted back before it is turned": ([R @ (x - p), D], "order, first, before, sign"),
            "rows swapped": ([D, X], "swap, exchang"),
            "arrow the other way": ([X, -D], "sign, opposite, from"),
            "arrow minus the point": ([X, R @ (d - x)], "differ, arrow"),
            "one sign of the point": ([negated(X, 0), D], "sign"),
            "elementwise": ([np.diag(R) * x + p, np.diag(R) * d], "elementwise, entry by entry, *"),
            "R transposed and arrow as a point": ([R.T @ x + p, R.T @ d + p], "transpos, R^T, arrow"),
            "R transposed and point as an arrow": ([R.T @ x, R.T @ d], "transpos, R^T, point"),
            "rows swapped and arrow as a point": ([D + p, X], "swap, exchang, arrow"),
        }
    )
    yield from right(
        {
            "three decimals": np.round([X, D], 3),
            "tuple of arrays": (X, D),
            "rows of x @ R.T": np.array([x, d]) @ R.T + [p, 0 * p],
        }
    )


@wrong_answers("01.5")
def look_back(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    T = np.asarray(given.T_sg)
    R, p = parts(T)
    yield from wrong(
        {
            "as given": (T, "T_{sg}, given, not inverted, undone"),
            "all transposed": (T.T, "transposed the whole, transpose"),
            "-p": (pose(R.T, -p), "-p"),
            "+R^T p": (pose(R.T, R.T @ p), "sign"),
            "-R p": (pose(R.T, -R @ p), "with $R$, -R, wrong way, transpos, R for"),
            "p kept": (pose(R.T, p), "kept, p"),
            "no position": (pose(R.T, 0 * p), "left out, missing, position"),
            "R kept, -p": (pose(R, -p), "R, not transposed"),
            "R kept, -R^T p": (pose(R, -R.T @ p), "R, transpos"),
            "R kept, -R p": (pose(R, -R @ p), "R, transpos"),
            "R kept, R^T p": (pose(R, R.T @ p), "R, transpos, sign"),
            "R^T and R p": (pose(R.T, R @ p), "sign, R, transpos"),
            "-R^T": (pose(-R.T, -R.T @ p), "sign, negat"),
            "-T": (-T, "sign, negat"),
            "one sign of the position": (pose(R.T, negated_one(-R.T @ p)), "sign"),
            "one sign of the rotation": (pose(negated_one(R.T), -R.T @ p), "sign"),
            "p in the last row too": (T.T + pose(0 * R, -R.T @ p) - np.diag([0, 0, 0, 1]), "last row, transpos"),
            "elementwise": (pose(R.T, -(R.T * p).diagonal()), "elementwise, entry by entry, *"),
            "x and y of the position swapped": (pose(R.T, swapped(-R.T @ p, 0, 1)), "swap"),
        }
    )
    yield from right(
        {
            "np.linalg.inv": inv(T),
            "three decimals": inv(T).round(3),
            "np.linalg.solve": np.linalg.solve(T, np.eye(4)).tolist(),
        }
    )


@wrong_answers("01.6")
def letters_that_cancel(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    A, B, C = np.asarray(given.T_sc), np.asarray(given.T_co), np.asarray(given.T_st)
    (R, p), D = parts(C), inv(C)
    minus_p, with_plus, only_R = pose(R.T, -p), pose(R.T, R.T @ p), pose(R.T, 0 * p)
    yield from wrong(
        {
            "T_st not inverted": (C @ A @ B, "not inverted, inverse, T_{ts}, T_{st}"),
            "T_ot": (inv(D @ A @ B), "T_{ot}, object, inver"),
            "T_so": (A @ B, "T_{so}, base, left out"),
            "T_ts left out of T_to, T_tc": (D @ A, "left out, T_{tc}, T_{co}"),
            "T_sc left out": (D @ B, "left out, T_{sc}"),
            "T_ts behind": (A @ B @ D, "behind, side, last, order, right"),
            "T_st behind": (A @ B @ C, "inver, behind, side, last"),
            "T_sc inverted": (D @ inv(A) @ B, "T_{sc}, inver"),
            "T_co inverted": (D @ A @ inv(B), "T_{co}, inver"),
            "reversed": (B @ A @ D, "order, revers"),
            "reversed, not inverted": (B @ A @ C, "order, revers, inver"),
            "T_sc and T_co swapped": (D @ B @ A, "swap, order"),
            "T_ts in the middle": (A @ D @ B, "swap, order, place, middle"),
            "elementwise": (D * A * B, "elementwise, entry by entry, *"),
            "T_st transposed": (C.T @ A @ B, "transpos"),
            "inverse with -p": (minus_p @ A @ B, "-p, minus, inverse"),
            "inverse with +R^T p": (with_plus @ A @ B, "sign, inverse"),
            "inverse without position": (only_R @ A @ B, "position, inverse, left out"),
            "inverse with -R p": (pose(R.T, -R @ p) @ A @ B, "inverse, transpos, R"),
            "positions subtracted": (pose((D @ A @ B)[:3, :3], (A @ B)[:3, 3] - p), "subtract, differ, rotate, p"),
            "T_ts behind and T_sc inverted": (inv(A) @ B @ D, "behind, inver, order, side"),
            "T_so by a wrong order": (B @ A, "order, swap, left out"),
        }
    )
    yield from right(
        {
            "three decimals": (D @ A @ B).round(3),
            "np.linalg.solve": np.linalg.solve(C, A @ B),
            "list": product(D, A, B).tolist(),
        }
    )


@wrong_answers("01.7")
def own_or_fixed(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    T, own_turn = np.asarray(given.T_sb), given.own == "turn"

    def placed(turn: Any, shift: Any, T: Any = T) -> Any:
        return shift @ T @ turn if own_turn else turn @ T @ shift

    def turned(degrees: float, axis: Any = given.axis) -> Any:
        return pose(rot(axis, degrees), np.zeros(3))

    d, axis, far = given.degrees, np.asarray(given.axis), np.asarray(given.shift)
    turn, shift = turned(d), pose(I3, far)
    radians, there = pose(exp(d * axis), np.zeros(3)), placed(turn, shift)
    R, p = parts(there)
    yield from wrong(
        {
            "sides exchanged": (turn @ T @ shift if own_turn else shift @ T @ turn, "side, left, right"),
            "both left, turn last": (turn @ shift @ T, "left"),
            "both left, shift last": (shift @ turn @ T, "left"),
            "both right, turn first": (T @ turn @ shift, "right"),
            "both right, shift first": (T @ shift @ turn, "right"),
            "turned the other way": (placed(turned(-d), shift), "other way, sign, negat, opposite"),
            "shifted the other way": (placed(turn, inv(shift)), "shift, sign, opposite, invert"),
            "degrees in np.cos": (placed(radians, shift), "degrees, radians"),
            "shift left out": (placed(turn, np.eye(4)), "left out, shift, missing"),
            "turn left out": (placed(np.eye(4), shift), "left out, turn, rotation, missing"),
            "not moved": (T, "given, T_{sb}, moved"),
            "T_sb left out": (placed(turn, shift, np.eye(4)), "left out, T_{sb}"),
            "T_sb inverted": (placed(turn, shift, inv(T)), "inver"),
            "T_sb transposed": (placed(turn, shift, T.T), "transpos"),
            "T_bs of the end": (inv(there), "inver, T_{bs}"),
            "about the next axis": (placed(turned(d, np.roll(axis, 1)), shift), "axis, about"),
            "along the next axis": (placed(turn, pose(I3, np.roll(far, 1))), "axis, along"),
            "half the angle": (placed(turned(d / 2), shift), "half"),
            "elementwise": (shift * T * turn, "elementwise, entry by entry, *"),
            "R transposed at the end": (pose(R.T, p), "transpos"),
            "sides exchanged, turned the other way": (
                turned(-d) @ T @ shift if own_turn else shift @ T @ turned(-d),
                "side, other way, sign, opposite",
            ),
            "sides exchanged, degrees": (
                radians @ T @ shift if own_turn else shift @ T @ radians,
                "side, degrees, radians",
            ),
            "turned and shifted the other way": (placed(turned(-d), inv(shift)), "other way, sign, opposite, inver"),
        }
    )
    yield from right(
        {
            "three decimals": there.round(3),
            "list": there.tolist(),
            "in another order of the products": placed(turn, np.eye(4), placed(np.eye(4), shift)),
        }
    )


@wrong_answers("01.8")
def turns_in_order(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    names, room = list(given.turns), list(given.about_the_room)
    ours = [name for name, about in zip(names, room, strict=True) if about]
    own = [name for name in names if name not in ours]
    swap: Sequence[str] = [answer[1], answer[0], *answer[2:]]
    yield from wrong(
        {
            "as told": (names, "order in which, happen"),
            "each from the left": (names[::-1], "left"),
            "sides exchanged": (list(answer)[::-1], "side, exchang, revers"),
            "by the alphabet": (sorted(names), "names, alphabet"),
            "room in the order told": ([*ours, *own], "room, order"),
            "own axes reversed": ([*ours[::-1], *own[::-1]], "own, order, revers"),
            "own axes first": ([*own, *ours], "side, own, room"),
            "own axes first, room reversed": ([*own, *ours[::-1]], "side, own, room"),
            "first two swapped": (swap, "swap, order"),
            "last two swapped": ([*answer[:2], answer[3], answer[2]], "swap, order"),
            "last turn on the other side": (
                [name for name in answer if name != names[3]] + [names[3]]
                if room[3]
                else [names[3]] + [name for name in answer if name != names[3]],
                "last, side",
            ),
        }
    )
    yield from right({"tuple": tuple(answer), "list": list(answer)})


@wrong_answers("01.9")
def rigid_or_not(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    words = {
        "a": "rigid",
        "b": "unit, flaw b",
        "c": "perpendicular, orthogonal, flaw c",
        "d": "left-handed, reflection, flaw d",
        "e": "last row, flaw e",
    }
    yield from wrong(
        {
            f"chose {letter}": (letter, f"{words[letter]}, in order, nothing wrong, no rigid")
            for letter in words
            if letter != answer
        }
    )
    yield from right({"capital": answer.upper(), "with blanks": f" {answer} "})
