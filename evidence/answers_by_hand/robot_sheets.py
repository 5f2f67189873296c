"""Answers by hand to the tasks of the robot sheets."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common.kinematics import frame, ordinary_forms, pose_slips
from evidence.answers_by_hand.common.motions import Ad, Array, exp, parts, product
from evidence.answers_by_hand.common.tables import SIGN, legal_tables, table_slips
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP, other_entries
from evidence.answers_by_hand.lecture_10 import frame_change_slips, product_slips
from kinlib.dh.table import DHTable

inv = np.linalg.inv


Slips = dict[str, tuple[Any, str]]


def visible(cases: Slips, answer: Any, elsewhere: Slips, answer_elsewhere: Any) -> Slips:
    """The cases that are wrong for these numbers or for others; the rest are right for every student of this robot.

    For example, the order of the joints does not matter for a robot whose joints are all prismatic.
    """
    return {
        label: case
        for label, case in cases.items()
        if not (np.allclose(case[0], answer) and np.allclose(elsewhere[label][0], answer_elsewhere))
    }


@wrong_answers("robot.home_pose")
def home_pose(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    A, B, C = np.array(given.T_sr), np.array(given.T_rf), np.array(given.T_fb)
    other_base, other_tool = exp([0.3, 0.5, 0.7, 1, 2, 3]), exp([0.8, -0.4, 0.2, 3, 1, -2])
    M, elsewhere = product(A, B, C), _home_slips(other_base, B, other_tool)
    yield from wrong(visible(_home_slips(A, B, C), M, elsewhere, product(other_base, B, other_tool)))
    yield from right(ordinary_forms(M))


def _home_slips(A: Array, B: Array, C: Array) -> Slips:
    M, order = product(A, B, C), "reverse, order, letters, exchang, swap"
    (Ra, pa), (Rb, pb), (Rc, pc) = parts(A), parts(B), parts(C)
    return {
        **pose_slips(M),
        "no base": (B @ C, "{r}, base, T_{sr}"),
        "no tool": (A @ B, "flange, tool, T_{fb}"),
        "no robot": (A @ C, f"T_{{rf}}, robot, {LEFT_OUT}"),
        "the flange in the robot's base": (B, "flange, tool, base, {r}, T_{rf}"),
        "in reverse": (product(C, B, A), order),
        "base behind": (product(B, A, C), order),
        "tool in front of the flange": (product(A, C, B), order),
        "tool in front": (product(C, A, B), order),
        "base inverted": (product(inv(A), B, C), "invert, invers, T_{sr}"),
        "tool inverted": (product(A, B, inv(C)), "invert, invers, T_{fb}"),
        "flange inverted": (product(A, inv(B), C), "invert, invers, T_{rf}"),
        "base not turned": (product(frame(p=pa), B, C), "turn, rotation, base"),
        "tool not turned": (product(A, B, frame(p=pc)), "turn, rotation, tool"),
        "base not shifted": (product(frame(Ra), B, C), "shift, translation, position, base"),
        "tool not shifted": (product(A, B, frame(Rc)), "shift, translation, position, tool"),
        "positions added": (frame(Ra @ Rb @ Rc, pa + pb + pc), "added, turn"),
        "positions added as seen from r": (frame(Ra @ Rb @ Rc, pa + Ra @ (pb + pc)), "added, turn, tool"),
        "rotation of the base transposed": (product(frame(Ra.T, pa), B, C), "transpos, R^T, base"),
        "entry by entry": (A * B * C, "element, entry, matrix product"),
        "added": (A + B + C, "added, sum, product, last row"),
        "base and tool inverted": (product(inv(A), B, inv(C)), "invert, invers"),
        "in reverse, tool inverted": (product(inv(C), B, A), f"{order}, invert, invers"),
        "no base, tool inverted": (B @ inv(C), "{r}, base, invert, invers"),
    }


def _values(given: Any, S: Array) -> tuple[Array, Array]:
    """The joint values in radians and metres, and as they were typed."""
    typed = np.array(given.values, dtype=float)
    return np.where(S[:, :3].any(axis=1), np.radians(typed), typed), typed


def _elsewhere(S: Array) -> tuple[Array, Array]:
    """Other joint values, in radians and metres, and as a student types them."""
    q = np.sin(1.0 + np.arange(len(S)))
    return q, np.where(S[:, :3].any(axis=1), np.degrees(q), q)


@wrong_answers("robot.where_is_the_tool")
def where_is_the_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _product_of(np.array(given.screws), np.array(given.home), given, "s")


@wrong_answers("robot.body_form")
def body_form(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _product_of(np.array(given.body_screws), np.array(given.home), given, "b")


def _pose(S: Array, M: Array, q: Array, frames: str = "s") -> Array:
    factors = [exp(axis, value) for axis, value in zip(S, q, strict=True)]
    return product(*factors, M) if frames == "s" else product(M, *factors)


def _product_of(S: Array, M: Array, given: Any, frames: str) -> Iterator[WrongAnswer]:
    here, there = _values(given, S), _elsewhere(S)
    T, elsewhere = _pose(S, M, here[0], frames), _pose(S, M, there[0], frames)
    yield from wrong(visible(product_slips(S, M, *here, frames), T, product_slips(S, M, *there, frames), elsewhere))
    yield from right(ordinary_forms(T))


@wrong_answers("robot.which_mistake")
def which_mistake(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from other_letters({letter: f"{text}, would give" for letter, text in given.options.items()}, answer)


@wrong_answers("robot.point_of_the_tool")
def point_of_the_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    S, M, tip = np.array(given.screws), np.array(given.home), np.array(given.tip)
    here, there = _values(given, S), _elsewhere(S)
    R, p = parts(_pose(S, M, here[0]))
    x = R @ tip + p

    def tips(q: Array, typed: Array) -> Slips:
        no_tip = {"whole matrix transposed", "two decimals", "position only", "rotation only"}
        slips = product_slips(S, M, q, typed)
        return {label: (value[:3] @ [*tip, 1], words) for label, (value, words) in slips.items() if label not in no_tip}

    poses = visible(tips(*here), x, tips(*there), _pose(S, M, there[0])[:3] @ [*tip, 1])
    yield from wrong(
        {
            **poses,
            "origin of the tool": (p, f"origin, tip, {LEFT_OUT}"),
            "not turned": (p + tip, "turn, added"),
            "as a direction": (R @ tip, f"direction, position, a 0, {LEFT_OUT}"),
            "the tip as it stands": (tip, "{b}, as it stands, tool, pose"),
            "the tip turned back": (R.T @ tip + p, "transpos, R^T"),
            "turned after the shift": (R @ (tip + p), "order, turn, shift"),
            "subtracted": (p - R @ tip, SIGN),
            "seen from the tool": (R.T @ (tip - p), "invers, way back, seen from"),
            "millimetres": (1000 * x, "millimet, mm, 1000, unit"),
            "the sign of one number": (np.where(np.arange(3) == np.argmax(np.abs(x)), -x, x), SIGN),
            "x and y exchanged": (x[[1, 0, 2]], SWAP),
        }
    )
    yield from right({**ordinary_forms(x), "a tuple": tuple(x)})


@wrong_answers("robot.space_screws")
def space_screws(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    w, P, h = np.array(given.axes), np.array(given.points), np.array(given.pitches)
    slides = np.isinf(h)[:, None]
    along = np.where(np.isinf(h), 0.0, h)[:, None] * w

    def screws(v: Any, w: Array = w) -> Array:
        return np.hstack([np.where(slides, 0.0, w), np.where(slides, w, v)])

    moment = np.cross(P, w)
    S, n = screws(moment + along), len(w)
    cases: dict[str, tuple[Any, str]] = {
        "halves swapped": (np.roll(S, 3, axis=1), f"(v, half, halves, {SWAP}"),
        "negated": (-S, f"{SIGN}, other way"),
    }
    if not slides.all():
        cases |= {
            "omega x p": (screws(along - moment), f"\\times p, omega x p, {SIGN}"),
            "no moment": (screws(along), "moment, v = 0, through the origin"),
            "the point as v": (screws(P), "point, position, moment"),
            "omega negated": (S * np.repeat((-1, 1), 3), SIGN),
            "omega x p, halves swapped": (np.roll(screws(along - moment), 3, axis=1), f"(v, half, \\times p, {SWAP}, {SIGN}"),
            "one sign of the moment": (
                np.where((np.arange(6) > 2) & (np.abs(S) == np.abs(S[:, 3:]).max(axis=1, keepdims=True)), -S, S), SIGN),
            "everything a slide": (np.hstack([0 * w, w]), "prismatic, slide, turn, omega"),
        }  # fmt: skip
    if slides.any():
        cases |= {
            "a slide as a turn": (np.hstack([w, np.where(slides, np.cross(P, w), moment + along)]), "slide, turn, prismatic"),
            "the direction of a slide in omega": (
                np.hstack([w, np.where(slides, 0.0, moment + along)]), f"slide, omega, prismatic, half, {SWAP}"),
            "a moment for a slide": (np.hstack([0 * w + np.where(slides, 0, w), moment + along]), "slide, moment, prismatic"),
            "a slide as a turn, omega x p": (np.hstack([w, along - np.cross(P, w)]), f"slide, turn, prismatic, \\times p, {SIGN}"),
        }  # fmt: skip
    if np.any(along):
        cases["no pitch"] = screws(moment), "pitch, helical"
        cases["pitch negated"] = screws(moment - along), f"pitch, {SIGN}"
        cases["pitch per turn"] = screws(moment + along * 2 * np.pi), "pitch, lead, turn, 2\\pi"
    if n > 1:
        cases |= {
            "rows in reverse": (S[::-1], "reverse, order, row, joint"),
            "all points of the first": (screws(np.cross(P[:1], w) + along), "point, joint 1, row, first"),
            "points one row off": (screws(np.cross(np.roll(P, 1, axis=0), w) + along), "point, row"),
            "points as steps from joint to joint": (
                screws(np.cross(np.diff(P, axis=0, prepend=np.zeros((1, 3))), w) + along), "point, {s}, origin"),
        }  # fmt: skip
    yield from wrong({label: case for label, case in cases.items() if not np.array_equal(case[0] + 0.0, S + 0.0)})
    yield from right(ordinary_forms(S))


def _change(screws: Any, T: Array) -> Iterator[WrongAnswer]:
    S = np.array(screws)
    best = S @ Ad(inv(T)).T
    yield from wrong(
        {label: case for label, case in frame_change_slips(S, T).items() if not np.allclose(case[0], best, atol=1e-12)}
    )
    yield from right(ordinary_forms(best))


@wrong_answers("robot.body_screws")
def body_screws(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _change(given.screws, np.array(given.home))


@wrong_answers("robot.back_to_space")
def back_to_space(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _change(given.body_screws, inv(np.array(given.home)))


@wrong_answers("robot.new_tool")
def new_tool(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    yield from _change(given.body_screws, np.array(given.T_bt))


@wrong_answers("robot.standard_table")
def standard_table(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    """Wrong tables; one that moves this robot as the right one does is right by the statement, and is left out."""
    q = np.sin(np.outer(np.arange(1, 4), np.arange(1, answer.n + 1)))

    def fits(label: str, text: Any) -> bool:
        if label.startswith(("labels", "heading", "an object")):
            return False
        try:
            table = DHTable(text, convention=answer.convention, base=answer.base, tool=answer.tool)
        except ValueError:
            return False
        return table.joints == answer.joints and np.allclose(table.fk(q), answer.fk(q), atol=1e-6)

    yield from wrong({label: case for label, case in table_slips(answer).items() if not fits(label, case[0])})
    yield from right(legal_tables(answer))


wrong_answers("robot.modified_table")(standard_table)


@wrong_answers("robot.faulty_entry")
def faulty_entry(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from other_entries(answer, len(given.rows))
