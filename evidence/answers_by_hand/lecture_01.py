"""Answers by hand to sheet 01."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, alike, right, wrong_answers
from evidence.answers_by_hand.common import words as by
from evidence.answers_by_hand.common.motions import I3, I4, exp, negated, negated_one, parts, pose, rot, swapped

inv = np.linalg.inv
Answers = Iterator[WrongAnswer]


@wrong_answers("01.1")
def pose_off_a_drawing(given: Any, T: Any) -> Answers:
    R, p = parts(T)
    yx = p[[1, 0, 2]]
    yield from alike(by.TRANSPOSED, {"axes in rows": pose(R.T, p), "all transposed": T.T})
    yield from alike(by.INVERTED | {"T_{bs}", "seen from {b}"}, {"T_bs": inv(T)})
    yield from alike(by.TRANSPOSED | by.SIGN | {"leads from"}, {"R^T and -p": pose(R.T, -p)})
    yield from alike(by.ORDER, {"x and y axes swapped": pose(swapped(R, 0, 1, 1), p)})
    yield from alike(by.ORDER, {"y and z axes swapped": pose(swapped(R, 1, 2, 1), p)})
    yield from alike(by.ORDER, {"axes in the order y, z, x": pose(R[:, [1, 2, 0]], p)})
    yield from alike(by.SIGN | {"left-handed"}, {"-y": pose(R * (1, -1, 1), p), "-z": pose(R * (1, 1, -1), p)})
    yield from alike(
        by.SIGN | by.SWAPPED, {"-x and -y": pose(R * (-1, -1, 1), p), "one sign of p": pose(R, negated(p, 1))}
    )
    yield from alike(by.SIGN | {"leads from"}, {"-p": pose(R, -p)})
    yield from alike(by.SWAPPED, {"x and y of p swapped": pose(R, yx), "y and z of p swapped": pose(R, p[[0, 2, 1]])})
    yield from alike({"{b}", *by.TRANSPOSED}, {"p as written in {b}": pose(R, R.T @ p)})
    yield from alike({"last row"}, {"p in the last row": T + pose(0 * R, p).T - pose(0 * R, p)})
    yield from alike({"last row"}, {"0 in the corner": T - I4[3] * I4})
    yield from alike(by.OMITTED | {"height"}, {"height left out": pose(R, p * (1, 1, 0))})
    yield from alike(by.TRANSPOSED | by.SWAPPED, {"axes in rows, x and y of p swapped": pose(R.T, yx)})
    yield from alike(by.SIGN | by.SWAPPED | {"left-handed"}, {"-y, x and y of p swapped": pose(R * (1, -1, 1), yx)})
    yield from alike(by.TRANSPOSED | by.SIGN, {"axes in rows, one sign of p": pose(R.T, negated(p, 0))})
    yield from right({"integers": T.astype(int), "list of lists": T.tolist(), "tuple": tuple(map(tuple, T))})


@wrong_answers("01.2")
def rotation_off_a_drawing(given: Any, R: Any) -> Answers:
    k = next(i for i in range(3) if R[i, i] > 1 - 1e-9)
    i, j = (k + 1) % 3, (k + 2) % 3
    t = np.arctan2(R[j, i], R[i, i])
    d, c, s = np.degrees(t), np.cos(t), np.sin(t)

    def plane(ii: float, ij: float, ji: float, jj: float) -> Any:
        A = np.diag(I3[k])
        A[i, i], A[i, j], A[j, i], A[j, j] = ii, ij, ji, jj
        return A

    yield from alike(by.OTHER_WAY | {"R_{ba}"}, {"R_ba": R.T})
    yield from alike(by.SWAPPED, {"sine and cosine swapped": plane(s, -c, c, s)})
    yield from alike(by.SWAPPED | {"90"}, {"90 degrees less the angle": rot(k, np.sign(d) * (90 - abs(d)))})
    yield from alike(by.DEGREES, {"degrees in np.cos": exp(d * I3[k])})
    yield from alike(by.AXIS | {"about"}, {"about the next axis": rot(i, d), "about the axis before": rot(j, d)})
    yield from alike(by.SIGN, {"both sines positive": plane(c, abs(s), abs(s), c)})
    yield from alike(by.SIGN, {"one cosine negative": plane(c, -s, s, -c)})
    yield from alike(by.SIGN, {"both sines negative": plane(c, -abs(s), -abs(s), c), "-R": -R})
    yield from alike(by.OMITTED | by.AXIS | {"single 1"}, {"0 for the 1": R - np.diag(I3[k])})
    yield from alike(by.DOUBLE, {"twice the angle": rot(k, 2 * d)})
    yield from alike(by.HALF, {"half the angle": rot(k, d / 2)})
    yield from alike(by.SIGN | {"180", "half a turn"}, {"180 - angle": rot(k, 180 - d), "180 + angle": rot(k, d + 180)})
    yield from alike(by.OTHER_WAY | by.SWAPPED, {"transposed, sine and cosine swapped": plane(s, c, -c, s)})
    yield from alike(by.OTHER_WAY | by.AXIS, {"transposed, about the next axis": rot(i, -d)})
    yield from alike(by.OTHER_WAY | by.DEGREES, {"transposed, degrees": exp(-d * I3[k])})
    yield from right({"three decimals": R.round(3), "list": R.tolist(), "two steps": rot(k, d / 3) @ rot(k, 2 * d / 3)})


@wrong_answers("01.3")
def homogeneous_matrix(given: Any, answer: Any) -> Answers:
    d, p, first = given.degrees, np.asarray(given.p, dtype=float), given.first == "shift"

    def augmented(R: Any, column: Any) -> Any:
        return np.array([*np.column_stack([R, column]), [0, 0, 1]])

    def mapped(R: Any, p: Any = p, shift_first: bool = first) -> Any:
        return augmented(R, R @ p if shift_first else p)

    R, in_degrees = rot(2, d)[:2, :2], exp([0, 0, d])[:2, :2]
    (c, s), A = R[:, 0], mapped(R)
    column = A[:2, 2]
    yield from alike(by.ORDER, {"the other order": mapped(R, shift_first=not first)})
    yield from alike(
        by.OTHER_WAY | by.SWAPPED, {"rotated the other way": mapped(R.T), "R transposed only": augmented(R.T, column)}
    )
    yield from alike({"last row", *by.TRANSPOSED}, {"all transposed": A.T})
    yield from alike({"last row"}, {"p in the last row": augmented(R, 0 * p) + A.T - augmented(R.T, 0 * p)})
    yield from alike({"last row"}, {"0 in the corner": A - np.diag([0, 0, 1])})
    yield from alike(by.OMITTED, {"no translation": augmented(R, 0 * p), "no rotation": augmented(np.eye(2), p)})
    yield from alike(by.DEGREES, {"degrees in np.cos": mapped(in_degrees)})
    yield from alike(by.DEGREES, {"degrees in R only": augmented(in_degrees, column)})
    yield from alike(by.INVERTED, {"the inverse map": inv(A)})
    yield from alike(by.SIGN, {"-p": mapped(R, -p), "one sign of p": mapped(R, negated(p, 0))})
    yield from alike(by.SIGN, {"no minus": mapped(np.abs(R))})
    yield from alike(by.SWAPPED, {"x and y of p": mapped(R, p[::-1])})
    yield from alike(by.SWAPPED, {"sine, cosine": mapped(np.array([[s, -c], [c, s]]))})
    yield from alike(by.DOUBLE | by.ORDER, {"translated before and after": augmented(R, R @ p + p)})
    yield from alike(by.HALF, {"half the angle": mapped(rot(2, d / 2)[:2, :2])})
    yield from alike(by.OTHER_WAY, {"R^T p": augmented(R, R.T @ p)})
    yield from alike(by.ELEMENTWISE, {"elementwise": augmented(R, np.diag(R) * p)})
    yield from alike(by.ORDER | by.OTHER_WAY, {"the other order and the other way": mapped(R.T, shift_first=not first)})
    yield from alike(by.ORDER | by.DEGREES, {"the other order and degrees": mapped(in_degrees, shift_first=not first)})
    yield from alike(by.OTHER_WAY | {"last row"}, {"the other way and transposed": mapped(R.T).T})
    product = augmented(R, 0 * p) @ augmented(np.eye(2), p) if first else augmented(np.eye(2), p) @ augmented(R, 0 * p)
    yield from right({"three decimals": A.round(3), "list": A.tolist(), "product of two matrices": product})


@wrong_answers("01.4")
def point_and_arrow(given: Any, answer: Any) -> Answers:
    (R, p), x, d = parts(given.T_sc), np.asarray(given.point_c), np.asarray(given.arrow_c)
    X, D = R @ x + p, R @ d
    vector, point = {"vector", "direction", "extra entry"}, {"point", "extra entry"}
    yield from alike(vector, {"vector as a point": [X, D + p]})
    yield from alike(point, {"point as a vector": [R @ x, D]})
    yield from alike(by.SWAPPED, {"1 and 0 swapped": [R @ x, D + p], "rows swapped": [D, X]})
    yield from alike({"other end", *vector}, {"other end of the rod": [X, X + D]})
    yield from alike({"other end", *vector}, {"vector minus the point": [X, R @ (d - x)]})
    yield from alike(by.INVERTED | {"T_{cs}"}, {"T_cs": [R.T @ (x - p), R.T @ d]})
    yield from alike(by.TRANSPOSED | {"T_{cs}"}, {"R^T": [R.T @ x + p, R.T @ d], "R^T for the vector": [X, R.T @ d]})
    yield from alike(by.OMITTED | {"rotat", "multiply by"}, {"not rotated": [x + p, d]})
    yield from alike(by.OMITTED | {"rotat", "multiply by"}, {"vector not rotated": [X, d]})
    yield from alike(by.COPIED, {"as given": [x, d]})
    yield from alike(by.SIGN, {"-p": [R @ x - p, D], "-vector": [X, -D], "one sign": [negated_one(X), D]})
    yield from alike(by.ORDER, {"translated before it is rotated": [R @ (x + p), D]})
    yield from alike(by.ORDER | by.SIGN, {"translated back before it is rotated": [R @ (x - p), D]})
    yield from alike(by.ELEMENTWISE, {"elementwise": [np.diag(R) * x + p, np.diag(R) * d]})
    yield from alike(by.TRANSPOSED | vector, {"R^T and vector as a point": [R.T @ x + p, R.T @ d + p]})
    yield from alike(by.TRANSPOSED | point | {"T_{cs}"}, {"R^T and point as a vector": [R.T @ x, R.T @ d]})
    yield from alike(by.SWAPPED | vector, {"rows swapped and vector as a point": [D + p, X]})
    yield from right({"three decimals": np.round([X, D], 3), "tuple": (X, D), "x @ R.T": [x @ R.T + p, d @ R.T]})


@wrong_answers("01.5")
def look_back(given: Any, answer: Any) -> Answers:
    T = np.asarray(given.T_sg)
    R, p = parts(T)
    q = -R.T @ p
    yield from alike(by.COPIED | by.INVERTED, {"as given": T})
    yield from alike(by.TRANSPOSED, {"all transposed": T.T})
    yield from alike(by.TRANSPOSED, {"p in the last row too": pose(R.T, q) + T.T - pose(R.T, 0 * p)})
    yield from alike({"-p", "minus p", *by.INVERTED}, {"-p": pose(R.T, -p)})
    yield from alike(by.SIGN, {"+R^T p": pose(R.T, -q), "one sign of the position": pose(R.T, negated_one(q))})
    yield from alike(by.SIGN, {"-T": -T})
    yield from alike(by.SIGN, {"-R^T": pose(-R.T, q), "one sign of the rotation": pose(negated_one(R.T), q)})
    yield from alike(by.TRANSPOSED | {"rotat"}, {"-R p": pose(R.T, -R @ p), "R kept": pose(R, q)})
    yield from alike({"kept", *by.COPIED}, {"p kept": pose(R.T, p)})
    yield from alike(by.OMITTED | {"identity"}, {"no position": pose(R.T, 0 * p), "no rotation": pose(I3, q)})
    yield from alike(by.TRANSPOSED | by.SIGN | {"-p"}, {"R kept, -p": pose(R, -p)})
    yield from alike(by.SWAPPED, {"x and y of the position swapped": pose(R.T, swapped(q, 0, 1))})
    yield from alike(by.ELEMENTWISE, {"elementwise": pose(R.T, -np.diag(R) * p)})
    yield from alike(by.TRANSPOSED | by.SIGN, {"R kept, +R^T p": pose(R, -q), "R p": pose(R.T, R @ p)})
    yield from alike(by.TRANSPOSED | {"rotat"}, {"R kept, -R p": pose(R, -R @ p)})
    yield from right({"inv": inv(T), "three decimals": inv(T).round(3), "list": np.linalg.solve(T, I4).tolist()})


@wrong_answers("01.6")
def subscripts_that_cancel(given: Any, answer: Any) -> Answers:
    A, B, C = np.asarray(given.T_sc), np.asarray(given.T_co), np.asarray(given.T_st)
    (R, p), D = parts(C), inv(C)
    T = D @ A @ B
    yield from alike(by.INVERTED | {"T_{ts}"}, {"T_st not inverted": C @ A @ B})
    yield from alike(by.INVERTED | {"T_{ot}"}, {"T_ot": inv(T)})
    yield from alike(by.OMITTED | {"T_{so}"}, {"T_so": A @ B, "T_co left out": D @ A, "T_sc left out": D @ B})
    yield from alike(by.ORDER, {"T_ts behind": A @ B @ D, "T_ts in the middle": A @ D @ B, "reversed": B @ A @ D})
    yield from alike(by.ORDER | by.INVERTED, {"T_st behind": A @ B @ C, "reversed, not inverted": B @ A @ C})
    yield from alike(by.INVERTED, {"T_sc inverted": D @ inv(A) @ B, "T_co inverted": D @ A @ inv(B)})
    yield from alike(by.ORDER, {"T_sc and T_co swapped": D @ B @ A})
    yield from alike(by.ELEMENTWISE, {"elementwise": D * A * B, "elementwise once": D @ (A * B)})
    yield from alike(by.TRANSPOSED, {"T_st transposed": C.T @ A @ B})
    yield from alike({"-p", "inverse"}, {"inverse with -p": pose(R.T, -p) @ A @ B})
    yield from alike(by.SIGN | {"inverse"}, {"inverse with +R^T p": pose(R.T, R.T @ p) @ A @ B})
    yield from alike(by.TRANSPOSED | {"inverse"}, {"inverse with -R p": pose(R.T, -R @ p) @ A @ B})
    yield from alike(by.OMITTED | {"inverse"}, {"inverse without position": pose(R.T, 0 * p) @ A @ B})
    yield from alike({"subtract", "rotat"}, {"positions subtracted": pose(T[:3, :3], (A @ B)[:3, 3] - p)})
    yield from alike(by.ORDER | by.INVERTED, {"T_ts behind and T_sc inverted": inv(A) @ B @ D})
    yield from alike(by.INVERTED | {"T_{so}"}, {"both inverted wrongly": C @ inv(A) @ B})
    yield from alike(by.OMITTED | by.ORDER, {"T_so in the wrong order": B @ A})
    yield from right({"three decimals": T.round(3), "np.linalg.solve": np.linalg.solve(C, A @ B), "list": T.tolist()})


@wrong_answers("01.7")
def own_or_fixed(given: Any, answer: Any) -> Answers:
    T, own_turn = np.asarray(given.T_sb), given.own == "turn"
    d, axis, far = given.degrees, np.asarray(given.axis), np.asarray(given.shift)

    def turned(degrees: float, axis: Any = axis) -> Any:
        return pose(rot(axis, degrees), np.zeros(3))

    turn, shift, radians = turned(d), pose(I3, far), pose(exp(d * axis), np.zeros(3))

    def moved(turn: Any = turn, shift: Any = shift, T: Any = T, own: bool = own_turn) -> Any:
        return shift @ T @ turn if own else turn @ T @ shift

    there = moved()
    R, p = parts(there)
    other_axis = {"another axis", "wrong axis", "instead of", "in place of"}
    yield from alike(by.ORDER, {"sides swapped": moved(own=not own_turn)})
    yield from alike(
        by.ORDER, {"both left, rotation last": turn @ shift @ T, "both left, translation last": shift @ turn @ T}
    )
    yield from alike(by.ORDER, {"both right, rotation first": T @ turn @ shift})
    yield from alike(by.ORDER, {"both right, translation first": T @ shift @ turn})
    yield from alike(
        by.OTHER_WAY, {"rotated the other way": moved(turned(-d)), "R transposed at the end": pose(R.T, p)}
    )
    yield from alike(by.OTHER_WAY, {"translated the other way": moved(turn, inv(shift))})
    yield from alike(by.DEGREES, {"degrees in np.cos": moved(radians)})
    yield from alike(by.OMITTED, {"translation left out": moved(turn, I4), "rotation left out": moved(I4)})
    yield from alike(by.OMITTED, {"T left out": moved(T=I4)})
    yield from alike(by.COPIED | by.OMITTED, {"not moved": T})
    yield from alike(by.INVERTED, {"T_sb inverted": moved(T=inv(T)), "T_bs of the end": inv(there)})
    yield from alike(by.TRANSPOSED, {"T_sb transposed": moved(T=T.T)})
    yield from alike(other_axis, {"about the next axis": moved(turned(d, np.roll(axis, 1)))})
    yield from alike(other_axis, {"along the next axis": moved(turn, pose(I3, np.roll(far, 1)))})
    yield from alike(by.HALF, {"half the angle": moved(turned(d / 2))})
    yield from alike(by.ELEMENTWISE, {"elementwise": shift * T * turn})
    yield from alike(by.ORDER | by.OTHER_WAY, {"sides swapped, the other way": moved(turned(-d), own=not own_turn)})
    yield from alike(by.ORDER | by.DEGREES, {"sides swapped, degrees": moved(radians, own=not own_turn)})
    yield from alike(by.OTHER_WAY, {"rotated and translated the other way": moved(turned(-d), inv(shift))})
    yield from right(
        {"three decimals": there.round(3), "list": there.tolist(), "two steps": moved(turn, I4, moved(I4))}
    )


@wrong_answers("01.8")
def rotations_in_order(given: Any, answer: Any) -> Answers:
    names, room = list(given.turns), list(given.about_the_room)
    ours = [name for name, about in zip(names, room, strict=True) if about]
    own = [name for name in names if name not in ours]
    others = [name for name in answer if name != names[3]]
    yield from alike({"order in which"}, {"in the order of time": names})
    yield from alike({"reverse of the order"}, {"each from the left": names[::-1]})
    yield from alike(by.SWAPPED, {"sides swapped": list(answer)[::-1]})
    yield from alike({"alphabet", "names"}, {"by the alphabet": sorted(names)})
    yield from alike(
        by.ORDER, {"fixed axes in the order of time": ours + own, "own axes reversed": ours[::-1] + own[::-1]}
    )
    yield from alike(by.ORDER, {"own axes first": own + ours, "own axes first, fixed axes reversed": own + ours[::-1]})
    yield from alike(by.ORDER, {"first two swapped": [answer[1], answer[0], *answer[2:]]})
    yield from alike(by.ORDER, {"last two swapped": [*answer[:2], answer[3], answer[2]]})
    yield from alike(
        by.ORDER, {"last rotation on the other side": [*others, names[3]] if room[3] else [names[3], *others]}
    )
    yield from right({"tuple": tuple(answer), "list": list(answer)})


@wrong_answers("01.9")
def rigid_or_not(given: Any, answer: Any) -> Answers:
    said = {
        "a": "not a rigid motion",
        "b": "are unit vectors",
        "c": "are orthogonal",
        "d": "is not left-handed",
        "e": "is 0 0 0 1",
    }
    for letter in set(said) - {answer}:
        yield from alike({said[letter]}, {f"chose {letter}": letter})
    yield from right({"capital": answer.upper(), "with blanks": f" {answer} "})
