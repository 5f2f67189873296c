"""Answers by hand to sheet 07: the relation of two axes, frames, tables of drawn arms, broken rules and equivalent tables."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common.kinematics import ordinary_forms
from evidence.answers_by_hand.common.motions import Array
from evidence.answers_by_hand.common.tables import SIGN, as_text, legal_tables, table_slips
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP
from kinlib.dh.table import DHTable


@wrong_answers("07.1")
def the_case(given: Any, answer: str) -> Iterator[WrongAnswer]:
    cases = {"a": "skew", "b": "intersect", "c": "parallel", "d": "antiparallel", "e": "coincid", "f": "coincid"}
    direction = {"a": "neither", "b": "neither", "c": "same", "d": "opposite", "e": "same", "f": "opposite"}
    compare = {
        letter: f"{name}, "
        + ("direction" if direction[letter] != direction[answer] else "common point, meet, apart, distance")
        for letter, name in cases.items()
    }
    yield from other_letters(compare, answer)


@wrong_answers("07.2")
def frames_by_the_rules(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    F, P = np.array(answer), np.array(given.points)
    n = len(P)

    def of(columns: Any = (0, 1, 2), signs: Any = (1, 1, 1), origins: Any = None, which: Any = range(4)) -> Array:
        """Frames with the axes of these columns and signs, and other origins, in some of the frames."""
        changed = F.copy()
        for i in which:
            changed[i, :3, :3] = F[i][:3, list(columns)] * np.array(signs)
            if origins is not None:
                changed[i, :3, 3] = origins[i]
        return changed

    at_joints = np.vstack([P, F[n, :3, 3]])
    along_link, parallel, rotated = F.copy(), F.copy(), F.copy()
    for i in range(1, n):
        x = P[i] - P[i - 1]
        along_link[i, :3, 0] = x / np.linalg.norm(x)
        along_link[i, :3, 1] = np.cross(F[i, :3, 2], along_link[i, :3, 0])
    parallel[:, :3, :3] = np.eye(3)
    rotated[:, :3, :3] = np.swapaxes(F[:, :3, :3], 1, 2)
    links = np.concatenate([F[:1], np.linalg.inv(F[:-1]) @ F[1:]])
    slid = F[:, :3, 3] + F[:, :3, 2] * np.where(np.arange(n + 1) == 1, 1, 0)[:, None]
    off_axis = F[:, :3, 3] + F[:, :3, 0] * np.where(np.arange(n + 1) == 2, 1, 0)[:, None]
    feet = np.vstack([F[:1, :3, 3], F[:-1, :3, 3]])
    rule = "perpendicular, normal, meet, axis, rule, lie"
    handedness = "left-handed, handed, rotation"
    yield from wrong(
        {
            "z_i on joint i": (F[[0, *range(n)]], f"joint, convention, {rule}"),
            "z_i on joint i+2": (F[[*range(1, n + 1), n]], f"joint, {rule}"),
            "left-handed": (of(signs=(1, -1, 1)), handedness),
            "one left-handed": (of(signs=(1, -1, 1), which=[1]), handedness),
            "x and y swapped": (of((1, 0, 2)), f"{handedness}, {SWAP}"),
            "origins at the joints": (of(origins=at_joints), f"origin, {rule}"),
            "x along the link": (along_link, f"link, {rule}"),
            "x along the link, origins at the joints": (
                np.where(np.arange(4) == 3, of(origins=at_joints), along_link), f"link, origin, {rule}"),
            "x rotated by a right angle": (of((1, 0, 2), (1, -1, 1)), f"{rule}"),
            "y and z swapped": (of((0, 2, 1), (1, 1, -1)), f"joint, {rule}"),
            "x and z swapped": (of((2, 1, 0), (1, -1, 1)), f"{rule}"),
            "all parallel to s": (parallel, f"parallel, {rule}"),
            "axes in rows": (rotated, f"row, column, transpos, {rule}"),
            "each in coordinates of the one before": (links, f"seen from, {{s}}, before, link, {rule}"),
            "s in coordinates of the frames": (np.linalg.inv(F), f"invers, seen from, {rule}"),
            "in millimetres": (of(origins=1000 * F[:, :3, 3]), f"millimet, mm, 1000, unit, {rule}"),
            "origin 1 moved along z": (of(origins=slid), f"origin, {rule}"),
            "origin 2 moved along x": (of(origins=off_axis), f"origin, {rule}"),
            "origins at the feet on the axes before": (of(origins=feet), f"origin, {rule}"),
            "all origins at s": (of(origins=np.zeros((n + 1, 3))), f"origin, {rule}"),
            "frames from the tool to the base": (F[::-1], f"order, reverse, {rule}"),
            "frames 1 and 2 swapped": (F[[0, 2, 1, *range(3, n + 1)]], f"order, belongs, {SWAP}, {rule}"),
            "left-handed, origins at the joints": (of(signs=(1, -1, 1), origins=at_joints), f"{handedness}, origin, {rule}"),
            "x rotated, origin 1 moved along z": (of((1, 0, 2), (1, -1, 1), slid), f"origin, {rule}"),
        }
    )  # fmt: skip
    inner = range(1, n)
    yield from right(
        {
            **ordinary_forms(F),
            "inner x flipped": of(signs=(-1, -1, 1), which=inner),
            "inner z flipped": of(signs=(1, -1, -1), which=inner),
            "inner x and z flipped": of(signs=(-1, 1, -1), which=inner),
        }
    )


@wrong_answers("07.3")
def table_of_an_arm(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    yield from wrong({**table_slips(answer), **_random_signs(answer)})
    yield from right(legal_tables(answer))


def _random_signs(table: DHTable) -> dict[str, tuple[Any, str]]:
    """Random signs on every number, from the size of the table only, so that they are the same on every machine."""
    signs = 1 - 2 * (np.arange(table.rows.size).reshape(table.rows.shape) ** 2 % 5 < 2)
    return {"random signs": (as_text(table.rows * signs, table.joints, table.signs), SIGN + ", alpha, several")}


@wrong_answers("07.4")
def parallel_axes(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    rows = np.array(answer.rows)
    straight = np.where((np.arange(4) == 1) & np.isclose(np.cos(rows[:, 1:2]), -1), 0.0, rows)
    lost, doubled = rows.copy(), rows.copy()
    sideways = [i for i in (1, 2, 3) if abs(rows[i, 2]) > 1e-9]
    lost[sideways, 2] = 0.0
    doubled[sideways, 2] *= -2
    words = "parallel, alpha, \\pi, 180"
    yield from wrong(
        {
            **table_slips(answer),
            **_random_signs(answer),
            "0 for the angle pi between axes 3 and 4": (as_text(straight, answer.joints), words),
            "displacement along the parallel axes left out": (as_text(lost, answer.joints), f"{LEFT_OUT}, every $d$"),
            "displacement along the parallel axes doubled and negated": (as_text(doubled, answer.joints), SIGN + ", look again at d"),
            "0 for the angle pi, displacement left out": (
                as_text(np.where((np.arange(4) == 1) & (rows[:, 1:2] > 3), 0.0, lost), answer.joints), f"{words}, {LEFT_OUT}"),
        }
    )  # fmt: skip
    yield from right(legal_tables(answer))


@wrong_answers("07.5")
def which_rule(given: Any, answer: str) -> Iterator[WrongAnswer]:
    words = {
        "a": "scalar, perpendicular",
        "b": "intersect, along x, axis",
        "c": "z_, direction",
        "d": "origin",
        "e": "legal, rule",
    }
    obeyed = {letter: f"{word}, obeys, legal" for letter, word in words.items()}
    yield from other_letters(obeyed, answer)


@wrong_answers("07.6")
def table_to_mend(given: Any, answer: DHTable) -> Iterator[WrongAnswer]:
    printed, fixed = np.array(given.rows), np.array(answer.rows)
    ((i, k),) = np.argwhere(~np.isclose(printed, fixed))
    error = printed[i, k] - fixed[i, k]

    def add(size: float, row: int, column: int, base: Array = printed) -> Any:
        changed = base.copy()
        changed[row, column] += size
        return as_text(changed, answer.joints)

    place = "row, column, entry, other length, all but one"
    yield from wrong(
        {
            **{label: case for label, case in table_slips(answer).items() if "negated" in label or "swapped" in label},
            **_random_signs(answer),
            "as printed": (as_text(printed, answer.joints), "printed"),
            "changed with the wrong sign": (add(error, i, k), "twice, sign"),
            "changed twice as far": (add(-2 * error, i, k), "too far, twice, value, wrong, all but one"),
            "the other length of the row": (add(-error, i, 2 - k), f"{place}, other length"),
            "the same column, row before": (add(-error, i - 1, k), place),
            "the same column, next row": (add(-error, i + 1, k), place),
            "the entry made 0": (add(-printed[i, k], i, k), "value, too far, all but one"),
            "the entry negated": (add(-2 * printed[i, k], i, k), SIGN + ", all but one, wrong way"),
            "corrected, and another one too": (add(1, 3 - i, 2 - k, fixed), place),
            "printed, every alpha negated": (as_text(printed * (1, -1, 1, 1), answer.joints), f"printed, alpha, {SIGN}"),
            "the other length of the row, a and d swapped": (
                as_text(np.where((np.arange(4) == 2 - k) & (np.arange(4)[:, None] == i), printed - error, printed)[:, [2, 1, 0, 3]],
                        answer.joints), f"{place}, {SWAP}"),
        }
    )  # fmt: skip
    yield from right(legal_tables(answer))


@wrong_answers("07.7")
def prismatic_joint_elsewhere(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    a1, a2, to = given.a_1, given.a_2, given.moved_to
    reach = a1 + a2
    new = np.array([to, reach - to])
    whole = "same, change, does not, keep"
    yield from wrong(
        {
            "unchanged": ([a1, a2], f"unchanged, kept both, {whole}"),
            "only the first": ([to, a2], "a_1, first, joint 3"),
            "only the second": ([a1, reach - to], "a_2, second"),
            "a_2 negated": ([to, to - reach], SIGN),
            "a_2 without its sign": ([to, abs(reach - to)], SIGN),
            "swapped": ([reach - to, to], SWAP),
            "both negated": (-new, SIGN),
            "from joint 3": ([reach - to, -to], f"joint 3, {SWAP}, {SIGN}"),
            "the displacement added to both": ([to, a2 + to - a1], "sum, both, second, " + SIGN),
            "the displacement for a_1": ([to - a1, a2 - to + a1], "displacement, differ, from"),
            "moved_to added": ([a1 + to, a2 - to], "added, moved, from, x ="),
            "moved_to added to both": ([a1 + to, a2 + to], "added, moved, from, x ="),
            "the whole reach second": ([to, reach], "joint 3, from, reach, second"),
            "a_2 to the old place": ([to, a1 + a2 - a1], "a_1, first, joint 3"),
            "a_2 from the old place to the new": ([to, to - a1], "displacement, joint 3, second"),
            "the sum for both": ([reach, reach], "sum"),
            "halved": ([reach / 2, reach / 2], "half, middle"),
            "millimetres": (1000 * new, "millimet, mm, 1000, unit"),
            "joint 2 at 0": ([0, reach], "axis 1, joint 2, x ="),
            "swapped, negated": (-new[::-1], f"{SWAP}, {SIGN}"),
            "unchanged and swapped": ([a2, a1], f"{whole}, {SWAP}"),
        }
    )
    yield from right({**ordinary_forms(new), "a tuple": (to, reach - to)})


@wrong_answers("07.8")
def same_arm(given: Any, answer: str) -> Iterator[WrongAnswer]:
    legal, words = np.array(given.tables[answer]), {}
    for letter, rows in given.tables.items():
        k = np.argwhere(~np.isclose(rows, legal))[:, 1].tolist()
        words[letter] = {0: SIGN, 1: "alpha, reversed", 2: f"d_, {SIGN}, moved"}[k[0] if k else 0]
    yield from other_letters(words, answer)


@wrong_answers("07.9")
def leg(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.points(answer))
