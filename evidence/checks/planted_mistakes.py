"""Published DH tables with one or two mistakes planted: the measurement of how well `kl.diagnose` finds them.

Each table is diagnosed twice: against the published one with base, tool, zeros and signs fixed, and by default, where the arm may
choose these four. A table is mended if one of the corrections that are told has the published numbers, base, tool and signs. By
default another repair is as good if it leaves nothing but these choices. The mistakes are written here by hand; no code is shared
with `kinlib.dh`.

Sources: Universal Robots, "DH parameters for calculations of kinematics and dynamics"; Franka Emika, "Robot and interface
specifications"; KUKA, "LBR iiwa 14 R820, Specification"; KUKA, "KR 6-2, KR 16-2, Specification" (dimensions); ABB, "IRB 140 data
sheet", as in Corke's Robotics Toolbox, `IRB140`; Paul, "Modelling, Trajectory Calculation and Servoing of a Computer Controlled
Arm" (Stanford AIM-177), figure 2.3; Adept, "Cobra 600", as in the Robotics Toolbox, `Cobra600`; Corke, the same, `Puma560`;
Craig, "Introduction to Robotics", figure 3.21.
"""

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

import kinlib as kl

RIGHT = np.pi / 2
A, ALPHA, D, THETA = range(4)
EVERYTHING = ("base", "tool", "zeros", "signs")

ON_A_TABLE = {"base": kl.exp([0, 0, RIGHT, 0.4, -0.3, 0.75]), "tool": kl.exp([0, 0, 0, 0.02, 0, 0.13])}


def published(*rows, convention="standard", joints="", **ends):
    """Construct a table from its printed rows: a, alpha in degrees, d, theta in degrees."""
    return kl.DHTable(np.array(rows) * (1, np.pi / 180, 1, np.pi / 180), convention=convention, joints=joints, **ends)


on_a_table = partial(published, **ON_A_TABLE)

SEVEN = {
    "UR5e": on_a_table(
        *((0, 90, 0.1625, 0), (-0.425, 0, 0, 0), (-0.3922, 0, 0, 0)),
        *((0, 90, 0.1333, 0), (0, -90, 0.0997, 0), (0, 0, 0.0996, 0)),
    ),
    "Panda": on_a_table(
        *((0, 0, 0.333, 0), (0, -90, 0, 0), (0, 90, 0.316, 0), (0.0825, 90, 0, 0)),
        *((-0.0825, -90, 0.384, 0), (0, 90, 0, 0), (0.088, 90, 0, 0), (0, 0, 0.107, 0)),
        convention="modified",
        joints="RRRRRRRF",
    ),
    "iiwa": on_a_table(
        *((0, -90, 0.36, 0), (0, 90, 0, 0), (0, 90, 0.42, 0), (0, -90, 0, 0)),
        *((0, -90, 0.4, 0), (0, 90, 0, 0), (0, 0, 0.126, 0)),
    ),
    "KR16": on_a_table(
        *((0.26, 90, 0.675, 0), (0.68, 0, 0, 90), (-0.035, 90, 0, 0)),
        *((0, -90, 0.67, 0), (0, 90, 0, 0), (0, 0, 0.158, 180)),
    ),
    "IRB140": on_a_table(
        *((0.07, -90, 0.352, 0), (0.36, 0, 0, -90), (0, -90, 0, 0)),
        *((0, 90, 0.38, 0), (0, -90, 0, 0), (0, 0, 0.065, 180)),
    ),
    "Stanford": on_a_table(
        *((0, -90, 0.412, 0), (0, 90, 0.154, 0), (0, 0, 0, -90)),
        *((0, -90, 0, 0), (0, 90, 0, 0), (0, 0, 0.263, 0)),
        joints="RRPRRR",
    ),
    "SCARA": on_a_table(
        (0.325, 0, 0.387, 0),
        (0.275, 180, 0, 0),
        (0, 0, 0, 0),
        (0, 0, 0, 0),
        joints="RRPR",
    ),
}
TABLES = SEVEN | {
    "UR5": published(
        *((0, 90, 0.089159, 0), (-0.425, 0, 0, 0), (-0.39225, 0, 0, 0)),
        *((0, 90, 0.10915, 0), (0, -90, 0.09465, 0), (0, 0, 0.0823, 0)),
    ),
    "Puma (Corke)": published(
        *((0, 90, 0.6718, 0), (0.4318, 0, 0, 0), (0.0203, -90, 0.15005, 0)),
        *((0, 90, 0.4318, 0), (0, -90, 0, 0), (0, 0, 0, 0)),
    ),
    "Puma (Craig)": published(
        *((0, 0, 0, 0), (0, -90, 0, 0), (0.4318, 0, 0.15005, 0)),
        *((0.0203, -90, 0.4318, 0), (0, 90, 0, 0), (0, -90, 0, 0)),
        convention="modified",
    ),
}

Mistake = Callable[[kl.DHTable], kl.DHTable]


def single_mistakes(right: kl.DHTable) -> Iterator[tuple[str, Mistake]]:
    """Yield every mistake of one step, with its kind. Some change nothing in a given table."""
    m = len(right.rows)
    for row in range(m):
        for column, name in enumerate(("a", "alpha", "d", "theta")):
            yield f"sign of {name}", entry(row, column, lambda value: -value)
            if column in {ALPHA, THETA}:
                for turn in (RIGHT, -RIGHT):
                    yield "90 degrees", entry(row, column, lambda value, turn=turn: value + turn)
            else:
                yield "one length in mm", entry(row, column, lambda value: 1000 * value)
        yield "a and d swapped", rows_of(lambda rows, row=row: exchanged(rows, (row, A), (row, D)))
        yield "offset dropped", entry(row, THETA, lambda _: 0)
        if right.joints[row] != "F":
            yield (
                "sign of q",
                lambda table, row=row: table.changed(signs=table.signs * np.where(np.arange(m) == row, -1, 1)),
            )
        for column in (A, ALPHA, D, THETA):
            for other in (row - 1, row + 1):
                if 0 <= other < m:
                    yield (
                        "entry one row off, 0 filled in",
                        rows_of(lambda rows, i=row, j=other, k=column: moved(rows, i, j, k)),
                    )
    for order in ((THETA, D, A, ALPHA), (ALPHA, A, THETA, D), (ALPHA, A, D, THETA), (D, THETA, A, ALPHA)):
        yield "column order", rows_of(lambda rows, order=order: rows[:, order])
    yield "offsets dropped", rows_of(lambda rows: rows * (1, 1, 1, 0))
    yield "mm", rows_of(lambda rows: rows * (1000, 1, 1000, 1))
    yield (
        "sign of every theta",
        lambda table: table.changed(
            rows=table.rows * np.where(np.array(list(table.joints)) == "R", -1, 1)[:, None] ** np.array([0, 0, 0, 1]),
            signs=table.signs * np.where(np.array(list(table.joints)) == "R", -1, 1),
        ),
    )
    for shift in (1, -1):
        yield "rows shifted", rows_of(lambda rows, shift=shift: np.roll(rows, shift, axis=0))
        yield "a and alpha shifted, 0 filled in", rows_of(lambda rows, shift=shift: shifted(rows, shift))
    other = {"standard": "modified", "modified": "standard"}[right.convention]
    yield "convention", lambda table: table.changed(convention=other)
    for end in ("base", "tool"):
        yield f"{end} left out", lambda table, end=end: table.changed(**{end: np.eye(4)})
        yield f"{end} inverted", lambda table, end=end: table.changed(**{end: np.linalg.inv(getattr(table, end))})


def entry(row: int, column: int, change: Callable[[float], float]) -> Mistake:
    """Return the mistake that changes one number."""

    def mistake(table: kl.DHTable) -> kl.DHTable:
        rows = table.rows.copy()
        rows[row, column] = change(rows[row, column])
        return table.changed(rows=rows)

    return mistake


def rows_of(change: Callable[[np.ndarray], np.ndarray]) -> Mistake:
    """Return the mistake that changes the rows."""
    return lambda table: table.changed(rows=change(table.rows.copy()))


def exchanged(rows, one, two):
    """Exchange two numbers."""
    rows[one], rows[two] = rows[two], rows[one]
    return rows


def moved(rows, row, other, column):
    """Write a number into another row, and 0 where it was."""
    rows[other, column], rows[row, column] = rows[row, column], 0
    return rows


def shifted(rows, shift):
    """Write a and alpha one row off, and 0 into the row that becomes empty."""
    rows[:, :2] = np.roll(rows[:, :2], shift, axis=0)
    rows[0 if shift == 1 else -1, :2] = 0
    return rows


def made(mistake: Mistake, table: kl.DHTable) -> kl.DHTable | None:
    """Return the table with the mistake; None if it is refused at once, such as 425 millimetres for an angle."""
    try:
        return mistake(table)
    except ValueError:
        return None


def differ(one: kl.DHTable, two: kl.DHTable) -> bool:
    """Whether two tables have other poses."""
    q = np.random.default_rng(1).uniform(-3, 3, (5, one.n))
    return bool(np.abs(one.fk(q) - two.fk(q)).max() > 1e-6)


def wrong_tables(right: kl.DHTable, pairs: int, seed: int) -> Iterator[tuple[str, kl.DHTable]]:
    """Yield the tables with one mistake, and that many with two of different kinds, each of which changes the poses."""
    tables, seen, singles = [], [], []
    for kind, mistake in single_mistakes(right):
        if (wrong := made(mistake, right)) is None:
            continue
        if differ(wrong, right) and wrong not in seen:
            seen.append(wrong)
            singles.append((kind, mistake, wrong))
            tables.append((kind, wrong))
    yield from tables
    rng, by_kind, count = np.random.default_rng(seed), defaultdict(list), 0
    for kind, mistake, wrong in singles:
        by_kind[kind].append((mistake, wrong))
    while count < pairs:
        kinds = rng.choice(sorted(by_kind), 2, replace=False)
        (one, first), (two, second) = (by_kind[kind][rng.integers(len(by_kind[kind]))] for kind in kinds)
        wrong = made(two, first)
        is_order_free = wrong is not None and wrong == made(one, second)
        if is_order_free and all(differ(wrong, other) for other in (right, first, second)):
            count += 1
            yield " + ".join(kinds), wrong


def restored(found: kl.Diagnosis, right: kl.DHTable) -> bool:
    """Whether a correction that is told has the published numbers, and the poses of the arm."""
    return any(
        np.abs(one.corrected.converted(right.convention).rows - right.rows).max() < 1e-9
        and not differ(one.corrected, right)
        for one in found.explanations
    )


def judged(wrong: kl.DHTable, right: kl.DHTable) -> Counter[str]:
    """Diagnose one table both ways, and count what is said of it."""
    strict = kl.diagnose(wrong, right, EVERYTHING)
    free = kl.diagnose(wrong, right)
    same_poses = bool(strict.explanations) and not differ(strict.explanations[0].corrected, right)
    return Counter(
        {
            "planted": 1,
            "mended": restored(strict, right),
            "same poses": same_poses,
            "called right": strict.verdict in {"right", "rounded"},
            # By default base, tool, zeros and signs are free: what differs in them must be said.
            "unsaid": free.verdict == "right" and "up to these choices" not in str(free),
        }
    )


def measure(names=tuple(SEVEN), *, pairs=30, seed=0, every=1):
    """Plant the mistakes, or every k-th one, and count what becomes of them: {number of mistakes: Counter}."""
    tallies = {1: Counter(), 2: Counter()}
    for name in names:
        right = TABLES[name]
        for number, (kind, wrong) in enumerate(wrong_tables(right, pairs, seed)):
            if number % every == seed % every:
                tallies[1 + (" + " in kind)] += judged(wrong, right)
    return tallies
