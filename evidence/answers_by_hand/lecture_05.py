"""Answers by hand to sheet 05: DH tables in the standard convention."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common.kinematics import (
    at,
    chain,
    frame,
    link,
    one_entry,
    ordinary_forms,
    pose_slips,
    turn,
)
from evidence.answers_by_hand.common.motions import Array, product
from evidence.answers_by_hand.common.tables import NORMAL, SIGN, legal_tables, table_slips
from kinlib.dh.table import DHTable

SWAP = "swap, exchang, interchang"
STEPS = "Pythag, sum of the steps, add the steps, added the steps"
LEFT_OUT = "left out, forgot, missing, without, alone, = 0"


@wrong_answers("05.1")
def four_numbers(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    a, alpha, d, theta = answer
    yield from wrong(
        {
            "a and d swapped": ([d, alpha, a, theta], SWAP),
            "alpha and theta swapped": ([a, theta, d, alpha], SWAP),
            "in the order theta, d, a, alpha": ([theta, d, a, alpha], "order, column, " + SWAP),
            "in Craig's order alpha, a, d, theta": ([alpha, a, d, theta], "order, column, " + SWAP),
            "alpha negated": ([a, -alpha, d, theta], "alpha"),
            "theta negated": ([a, alpha, d, -theta], "theta, " + SIGN),
            "d negated": ([a, alpha, -d, theta], SIGN),
            "a negated": ([-a, alpha, d, theta], SIGN),
            "from frame 1 to frame 0": (
                [-a, -alpha, -d, -theta],
                SIGN + ", from frame 1, from the second frame, inverse",
            ),
            "no signs": (np.abs(answer), SIGN),
            "x_1 taken in the opposite direction": ([-a, -alpha, d, theta + np.pi], "x_1, " + SIGN),
            "theta half a turn off": ([a, alpha, d, theta + np.pi], f"theta, half, turn, \\pi, 180, {SIGN}"),
            "alpha half a turn off": ([a, alpha + np.pi, d, theta], f"alpha, half, turn, \\pi, 180, {SIGN}"),
            "d left out": ([a, alpha, 0, theta], LEFT_OUT),
            "a left out": ([0, alpha, d, theta], LEFT_OUT),
            "theta 0, for joint at zero": ([a, alpha, d, 0], "theta, offset, " + LEFT_OUT),
            "alpha 0 for a right angle": ([a, 0, d, theta], "alpha, " + LEFT_OUT),
            "a between the origins": ([np.hypot(a, d), alpha, d, theta], NORMAL + ", origin"),
            "a along x_0": ([a * np.cos(theta), alpha, d, theta], "x_0, x_{i-1}, along, old x, left out, " + SIGN),
            "degrees": ([a, np.degrees(alpha), d, np.degrees(theta)], "degree, radian"),
            "only alpha in degrees": ([a, np.degrees(alpha), d, theta], "degree, radian"),
            "millimetres": ([1000 * a, alpha, 1000 * d, theta], "millimet, mm, 1000, unit"),
            "a and d swapped, alpha negated": ([d, -alpha, a, theta], f"{SWAP}, alpha, {SIGN}"),
            "both pairs swapped": ([d, theta, a, alpha], SWAP),
            "degrees, theta negated": ([a, np.degrees(alpha), d, -np.degrees(theta)], f"degree, radian, {SIGN}"),
        }
    )
    turned = answer + np.array((0, 2 * np.pi, 0, -2 * np.pi))
    yield from right({**ordinary_forms(answer), "angles plus and less a turn": turned, "a tuple": tuple(answer)})


def row_slips(row: Any, convention: str) -> Iterator[WrongAnswer]:
    """Wrong poses of one row a, alpha, d, theta in a convention."""
    a, alpha, d, theta = row
    T, other = link(row, convention), "modified" if convention == "standard" else "standard"
    Rz, Rx, Tz, Tx = turn("z", theta), turn("x", alpha), frame(p=(0, 0, d)), frame(p=(a, 0, 0))
    flip = "convention" if convention == "standard" else "convention, reverse, order"

    def of(*changed: float) -> Array:
        return link(changed, convention)

    no_turn_of_lengths = frame(T[:3, :3], (a, 0, d))
    yield from wrong(
        {
            **pose_slips(T),
            "the other convention": (link(row, other), flip + ", order, reverse"),
            "alpha negated": (of(a, -alpha, d, theta), "alpha"),
            "theta negated": (of(a, alpha, d, -theta), "theta, " + SIGN),
            "both angles negated": (of(a, -alpha, d, -theta), SIGN),
            "d negated": (of(a, alpha, -d, theta), SIGN),
            "a and d swapped": (of(d, alpha, a, theta), SWAP),
            "alpha and theta swapped": (of(a, theta, d, alpha), SWAP),
            "degrees": (of(a, np.degrees(alpha), d, np.degrees(theta)), "degree, radian"),
            "only theta in degrees": (of(a, alpha, d, np.degrees(theta)), "degree, radian"),
            "lengths not turned": (no_turn_of_lengths, "along, walk, turn, normal, x_{i-1}, z_{i-1}, z_i"),
            "a left out": (of(0, alpha, d, theta), LEFT_OUT),
            "d left out": (of(a, alpha, 0, theta), LEFT_OUT),
            "alpha left out": (of(a, 0, d, theta), LEFT_OUT + ", alpha"),
            "only the motion along z": (of(0, 0, d, theta), LEFT_OUT),
            "only the motion along x": (of(a, alpha, 0, 0), LEFT_OUT),
            "all turns first, then all shifts": (product(frame(Rz @ Rx), Tz, Tx), "order, rotat, along"),
            "alpha about y": (product(frame(Rz), Tz, Tx, frame(turn("y", alpha))), "about x, about y, axis"),
            "sine and cosine of theta swapped": (of(a, alpha, d, np.pi / 2 - theta), "sin, cos, theta, " + SWAP),
            **{
                f"sign of entry ({i + 1}, {k + 1})": (one_entry(T, (i, k), -T[i, k]), SIGN + ", entry, alpha, theta")
                for i, k in ((0, 1), (1, 2), (2, 1))
                if abs(T[i, k]) > 1e-9  # an entry that is always 0 has no sign
            },
            "entries (2, 1) and (1, 2) swapped": (
                one_entry(one_entry(T, (0, 1), T[1, 0]), (1, 0), T[0, 1]), SWAP + ", transpos, entries, column"),
            "other convention, degrees": (
                link((a, np.degrees(alpha), d, np.degrees(theta)), other), "degree, radian, convention"),
            "a and d swapped, alpha negated": (of(d, -alpha, a, theta), SWAP + ", alpha"),
            "other convention, alpha negated": (link((a, -alpha, d, theta), other), "convention, alpha"),
            "inverse, a and d swapped": (np.linalg.inv(of(d, alpha, a, theta)), "inverse, transpos, " + SWAP),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(T))


@wrong_answers("05.2")
def one_row(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from row_slips(
        (given.a, np.radians(given.alpha_degrees), given.d, np.radians(given.theta_degrees)), "standard"
    )


@wrong_answers("05.3")
def whole_table(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    yield from wrong(table_slips(answer))
    yield from right(legal_tables(answer))


@wrong_answers("05.4")
def offsets(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    h = np.radians(given.headings_degrees)
    c = np.diff(h, prepend=0)
    back = "sign, negat, opposite, minus, other way, backward"
    yield from wrong(
        {
            "measured from x_0": (h, "x_0, base, from link"),
            "no offsets": (np.zeros(3), "offset, = q, left out"),
            "negated": (-c, back),
            "added up twice": (np.cumsum(h), "added, sum"),
            "degrees": (np.degrees(c), "degree, radian"),
            "from x_0, in degrees": (np.degrees(h), "degree, radian, x_0, base"),
            "last joint first": (c[::-1], "order, reverse, last"),
            "differences the wrong way": (h - np.append(h[1:], 0), f"{back}, next, differ"),
            "the first one 0": ([0, c[1], c[2]], "first, offset, = q, left out"),
            "sum with the neighbour": (h + np.append(0, h[:2]), f"sum, added, {back}"),
            "the second one negated": (c * (1, -1, 1), back),
            "the third one negated": (c * (1, 1, -1), back),
            "only the third from x_0": ([c[0], c[1], h[2]], "x_0, base, from link"),
            "no signs": (np.abs(c), back),
            "inner angles": (np.pi - c, "inner, between the links, supplement, \\pi"),
            "x_i across the link": (c + np.array((np.pi / 2, 0, 0)), "across, perpendicular, pi/2, \\pi"),
            "degrees, negated": (-np.degrees(c), f"degree, radian, {back}"),
            "from x_0, negated": (-h, f"x_0, base, {back}"),
            "from x_0 and last first": (h[::-1], "x_0, base, order, reverse"),
        }
    )
    yield from right({**ordinary_forms(c), "one with a full turn": c + np.array((0, 2 * np.pi, 0))})


@wrong_answers("05.5")
def chain_of_matrices(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    table = DHTable(given.text, convention="standard")
    rows, joints, q = np.array(table.rows), table.joints, np.array(given.q)
    turns = np.array([letter == "R" for letter in joints])
    moved, n = at(rows, joints, q), len(rows)
    A = [link(row, "standard") for row in moved]
    T = product(*A)
    no_offset = at(np.where(np.outer(turns, np.arange(4) == 3), 0.0, rows), joints, q)
    alphas = np.column_stack([moved[:, 0], np.append(0, moved[:-1, 1]), moved[:, 2:]])

    def of(changed: Any) -> Array:
        return chain(changed, "standard")

    yield from wrong(
        {
            **pose_slips(T),
            "last row first": (product(*A[::-1]), "order, reverse, last"),
            "rows 1 and 2 swapped": (product(A[1], A[0], A[2]), "order, row, exchang, swap"),
            "the other convention": (chain(moved, "modified"), "convention"),
            "no offsets": (of(no_offset), "offset"),
            "offsets negated": (of(at(rows * np.where(np.outer(turns, np.arange(4) == 3), -1, 1), joints, q)), f"offset, {SIGN}"),
            "q in theta for the prismatic joint": (of(at(rows, "RRR", q)), "prismatic, slide, theta, column"),
            "q in d everywhere": (of(at(rows, "PPP", q)), "revolute, column, $d$, theta"),
            "alpha one row off": (of(alphas), "alpha, row, convention"),
            "alpha negated": (of(moved * (1, -1, 1, 1)), "alpha"),
            "alpha of row 1 negated": (of(moved * np.where(np.arange(12).reshape(3, 4) == 1, -1, 1)), "alpha"),
            "a and d swapped": (of(moved[:, [2, 1, 0, 3]]), SWAP),
            "alpha and theta swapped": (of(moved[:, [0, 3, 2, 1]]), SWAP),
            "q turned into degrees": (of(at(rows, joints, np.where(turns, np.degrees(q), q))), "degree, radian"),
            "all of q turned into degrees": (of(at(rows, joints, np.degrees(q))), "degree, radian"),
            "all of q turned into radians": (of(at(rows, joints, np.radians(q))), "degree, radian"),
            "alpha in degrees": (of(moved * (1, 180 / np.pi, 1, 1)), "degree, radian"),
            "every joint moved backwards": (of(at(rows, joints, -q)), f"{SIGN}, backward"),
            "at q = 0": (of(rows), "zero, home, q = 0, joint values, left out, not moved"),
            "the last row left out": (product(*A[: n - 1]), "left out, last, row, stopped"),
            "the first row left out": (product(*A[1:]), "left out, first, row"),
            "entry by entry": (A[0] * A[1] * A[2], "element, entry, matrix product, @"),
            "joint values of 1 and 3 swapped": (of(at(rows, joints, q[::-1])), f"order, {SWAP}"),
            "last row first, no offsets": (of(no_offset[::-1]), "order, reverse, last, offset"),
            "other convention, alpha negated": (chain(moved * (1, -1, 1, 1), "modified"), "convention, alpha"),
            "no offsets, a and d swapped": (of(no_offset[:, [2, 1, 0, 3]]), f"offset, {SWAP}"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(T))


def other_entries(answer: str, n: int) -> Iterator[WrongAnswer]:
    """Every other entry of a table with n rows as the faulty one."""
    column, row = answer.rstrip("0123456789"), int(answer.lstrip("adlphtei"))
    about = {"a": "x", "alpha": "x", "d": "z", "theta": "z"}
    for one, axis in about.items():
        for i in range(1, n + 1):
            words = {"row"} if i == row or one == column else {"right", "fits", "correct", "drawing"}
            words |= {"axis"} if i == row and axis == about[column] else set()
            if (one, i) != (column, row):
                same = f"{'the' if i == row else 'another'} row, {'the' if one == column else 'another'} column"
                yield WrongAnswer(f"{one}{i}, in {same}", f"{one}{i}", frozenset(words))
    yield from right({"capitals": answer.upper(), "with a space behind": answer + " "})


@wrong_answers("05.6")
def faulty_entry(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from other_entries(answer, len(given.rows))


@wrong_answers("05.7")
def parallel_axes(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    P = np.array(given.points)
    step = np.diff(P, axis=0)
    (dx1, dy1, d1), (dx2, dy2, d2) = step
    a1, a2 = np.hypot(dx1, dy1), np.hypot(dx2, dy2)
    low = SIGN + ", down, upward"
    yield from wrong(
        {
            "from joint to joint, d = 0": ([np.hypot(a1, d1), 0, np.hypot(a2, d2), 0], NORMAL),
            "from joint to joint, d kept": ([np.hypot(a1, d1), d1, np.hypot(a2, d2), d2], NORMAL),
            "a and d swapped": ([d1, a1, d2, a2], SWAP),
            "in the order a_1, a_2, d_1, d_2": ([a1, a2, d1, d2], "order, " + SWAP),
            "height above the floor": ([a1, P[1, 2], a2, P[2, 2]], "height, floor"),
            "height of the joint before": ([a1, P[0, 2], a2, P[1, 2]], "height, floor"),
            "origins on one level": ([a1, 0, a2, 0], "level, d = 0, d left out"),
            "d downwards": ([a1, -d1, a2, -d2], low),
            "first d downwards": ([a1, -d1, a2, d2], low),
            "d without its sign": ([a1, abs(d1), a2, abs(d2)], low),
            "the steps added": ([abs(dx1) + abs(dy1), d1, abs(dx2) + abs(dy2), d2], STEPS),
            "only the step along x": ([dx1, d1, dx2, d2], "along $x$, Pythag, straight"),
            "only the step along y": ([dy1, d1, dy2, d2], "along $y$, Pythag, straight"),
            "all from axis 1": ([a1, d1, np.hypot(*(P[2] - P[0])[:2]), P[2, 2] - P[0, 2]], "axis 1, joint 1, from the first, before"),
            "only d_2 from joint 1": ([a1, d1, a2, d1 + d2], "joint 1, from the first, before, height, differ"),
            "rows swapped": ([a2, d2, a1, d1], f"row, order, {SWAP}"),
            "d_1 from the floor": ([a1, P[1, 2], a2, d2], "height, floor, origin"),
            "no square root": ([a1**2, d1, a2**2, d2], "root, square"),
            "millimetres": (1000 * np.array([a1, d1, a2, d2]), "millimet, mm, 1000, unit"),
            "swapped and downwards": ([-d1, a1, -d2, a2], f"{SWAP}, {low}"),
            "the steps added and downwards": (
                [abs(dx1) + abs(dy1), -d1, abs(dx2) + abs(dy2), -d2], f"{STEPS}, {low}"),
            "the steps added, height above the floor": (
                [abs(dx1) + abs(dy1), P[1, 2], abs(dx2) + abs(dy2), P[2, 2]], f"{STEPS}, height, floor"),
        }
    )  # fmt: skip
    yield from right({**ordinary_forms([a1, d1, a2, d2]), "a tuple": (a1, d1, a2, d2)})


@wrong_answers("05.8")
def base_and_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    rows, base, tool, q = np.array(given.rows), np.array(given.base), np.array(given.tool), np.array(given.q)
    joints, turned = "R" * len(rows), at(rows, "R" * len(rows), q)
    T, A = chain(turned, "standard"), [link(row, "standard") for row in turned]
    full, inv = product(base, T, tool), np.linalg.inv
    shifted_base, shifted_tool = frame(p=base[:3, 3]), frame(p=tool[:3, 3])
    in_first = chain(turned + np.outer(np.arange(len(rows)) == 0, [base[0, 3], 0, base[2, 3], 0]), "standard")
    in_last = chain(
        turned + np.outer(np.arange(len(rows)) == len(rows) - 1, [tool[0, 3], 0, tool[2, 3], 0]), "standard"
    )

    def of(changed: Any, convention: str = "standard") -> Array:
        return product(base, chain(changed, convention), tool)

    yield from wrong(
        {
            **pose_slips(full),
            "no base": (T @ tool, "base, frame 0"),
            "no tool": (base @ T, "tool, frame 2"),
            "neither": (T, "base, tool, frame 0, neither"),
            "base and tool swapped": (product(tool, T, base), SWAP + ", reverse, order"),
            "base behind the rows": (product(T, base, tool), "behind, order, base"),
            "tool in front of the rows": (product(base, tool, T), "behind, order, tool, front"),
            "base inverted": (product(inv(base), T, tool), "invers, invert, base"),
            "tool inverted": (product(base, T, inv(tool)), "invers, invert, tool"),
            "base not turned": (product(shifted_base, T, tool), "base, turn, rotation"),
            "tool not turned": (product(base, T, shifted_tool), "tool, turn, rotation"),
            "base added to the position": (
                frame(T[:3, :3], T[:3, 3] + base[:3, 3]) @ tool,
                "base, turn, added, rotation",
            ),
            "base in the first row": (in_first @ tool, "base, row"),
            "tool in the last row": (base @ in_last, "tool, row"),
            "last row first": (product(base, *A[::-1], tool), "order, reverse, last"),
            "the other convention": (of(turned, "modified"), "convention"),
            "alpha negated": (of(turned * (1, -1, 1, 1)), "alpha"),
            "degrees": (of(at(rows, joints, np.degrees(q))), "degree, radian"),
            "q taken for degrees": (of(at(rows, joints, np.radians(q))), "degree, radian"),
            "at q = 0": (of(rows), "zero, home, q = 0, joint values, left out, not moved"),
            "joints backwards": (of(at(rows, joints, -q)), f"{SIGN}, backward"),
            "q_1 and q_2 swapped": (of(at(rows, joints, q[::-1])), SWAP + ", order"),
            "no base, alpha negated": (chain(turned * (1, -1, 1, 1), "standard") @ tool, "base, alpha"),
            "base and tool inverted": (product(inv(base), T, inv(tool)), "invers, invert"),
            "no tool, the other convention": (base @ chain(turned, "modified"), "tool, convention"),
        }
    )
    yield from right(ordinary_forms(full))


@wrong_answers("05.9")
def scara_from_a_drawing(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.rows(answer))
