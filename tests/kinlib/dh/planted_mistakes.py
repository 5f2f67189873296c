"""Published DH tables with one mistake planted: the measurement of how well `kl.diagnose` finds it.

    PYTHONPATH=tests/support:tests/kinlib/dh python -m planted_mistakes

Each table is diagnosed twice. First the arm has another base, tool, zeros and signs, and everything is free: the mistakes that
remain visible should be mended to the published table. Then the arm is that of the published table, and everything is fixed: a
table whose poses differ must not be called right. The mistakes are written here by hand; no code is shared with `kinlib.dh`.

Sources: Universal Robots, "DH parameters for calculations of kinematics and dynamics"; Corke, Robotics toolbox, `Puma560`;
Craig, Introduction to Robotics, figure 3.21; Franka Emika, "Robot and interface specifications"; KUKA, LBR iiwa 14 R820.
"""

import time
from collections import Counter, defaultdict

import numpy as np
from example_arms import with_other_choices

import kinlib as kl

RIGHT = np.pi / 2
A, ALPHA, D, THETA = range(4)

STANDARD = {
    "UR5": (
        [0, -0.425, -0.39225, 0, 0, 0],
        [RIGHT, 0, 0, RIGHT, -RIGHT, 0],
        [0.089159, 0, 0, 0.10915, 0.09465, 0.0823],
    ),
    "UR10": (
        [0, -0.612, -0.5723, 0, 0, 0],
        [RIGHT, 0, 0, RIGHT, -RIGHT, 0],
        [0.1273, 0, 0, 0.163941, 0.1157, 0.0922],
    ),
    "Puma (Corke)": (
        [0, 0.4318, 0.0203, 0, 0, 0],
        [RIGHT, 0, -RIGHT, RIGHT, -RIGHT, 0],
        [0.6718, 0, 0.15005, 0.4318, 0, 0],
    ),
    "iiwa": (
        [0] * 7,
        [-RIGHT, RIGHT, RIGHT, -RIGHT, -RIGHT, RIGHT, 0],
        [0.36, 0, 0.42, 0, 0.4, 0, 0.126],
    ),
}
MODIFIED = {
    "Puma (Craig)": (
        [0, 0, 0.4318, 0.0203, 0, 0],
        [0, -RIGHT, 0, -RIGHT, RIGHT, -RIGHT],
        [0, 0, 0.15005, 0.4318, 0, 0],
    ),
    "Panda": (
        [0, 0, 0, 0.0825, -0.0825, 0, 0.088],
        [0, -RIGHT, RIGHT, RIGHT, -RIGHT, RIGHT, RIGHT],
        [0.333, 0, 0.316, 0, 0.384, 0, 0],
    ),
}
TABLES = {
    name: kl.DHTable(np.transpose([a, alpha, d, np.zeros(len(a))]), convention=convention, name=name)
    for convention, tables in (("standard", STANDARD), ("modified", MODIFIED))
    for name, (a, alpha, d) in tables.items()
}


def planted(table, offsets):
    """Yield every mistake of one step: its kind and the wrong rows.

    offsets  the zeros of the table, (m,); where some are not 0, forgetting them is a mistake
    """
    rows = np.array(table.rows)
    rows[:, THETA] = offsets
    for row, column in np.ndindex(rows.shape):
        for kind, value in in_an_entry(column, rows[row, column]):
            wrong = rows.copy()
            wrong[row, column] = value
            yield kind, wrong
    for row in range(len(rows)):
        for kind, one, two in (("a and d swapped", A, D), ("theta and alpha swapped", ALPHA, THETA)):
            wrong = rows.copy()
            wrong[row, [one, two]] = rows[row, [two, one]]
            yield kind, wrong
        for other in range(row + 1, len(rows)):
            wrong = rows.copy()
            wrong[[row, other]] = rows[[other, row]]
            yield "rows swapped", wrong
        for column in (A, ALPHA, D) if row + 1 < len(rows) else ():
            wrong = rows.copy()
            wrong[[row, row + 1], column] = rows[[row + 1, row], column]
            yield "entry one row off", wrong
    yield "millimetres", rows * (1000, 1, 1000, 1)
    for shift in (1, -1):
        yield "a and alpha one row off", np.hstack([np.roll(rows[:, :2], shift, axis=0), rows[:, 2:]])


def in_an_entry(column, value):
    """Return the wrong values of one entry, each with the kind of the mistake."""
    if column == ALPHA:
        return [("sign of alpha", -value), ("0 for alpha", 0)] if value else [("pi for 0", np.pi)]
    if column == THETA:
        return [("offset forgotten", 0)]
    name = "ad"[column == D]
    return [(f"sign of {name}", -value), ("length forgotten", 0), ("wrong number", 1.1 * value)]


def restored(table, right):
    """Whether a corrected table has the published rows, in the published convention; what leads to the ends may be elsewhere."""
    rows, published = table.converted(right.convention).rows, right.rows
    return np.abs(rows - published).max() < 1e-9


def measure(seed=0, names=tuple(TABLES), every=1):
    """Plant the mistakes, or every k-th one, and count what becomes of them: {kind: Counter}, and the longest time."""
    rng = np.random.default_rng(seed)
    tally, slowest, misses = defaultdict(Counter), 0.0, []
    for name in names:
        published = TABLES[name]
        offsets = rng.choice([0, 0, RIGHT, -RIGHT, np.pi], len(published.rows))
        for number, (kind, rows) in enumerate(planted(published, offsets)):
            if number % every != seed % every:
                continue
            right = published.changed(rows=np.column_stack([published.rows[:, :3], offsets]))
            if (rows == right.rows).all():
                continue
            wrong = right.changed(rows=rows)
            arm = with_other_choices(rng, right.to_chain())
            start = time.process_time()
            found = kl.diagnose(wrong, arm)
            slowest = max(slowest, time.process_time() - start)
            tally[kind]["planted"] += 1
            if not found.right:
                tally[kind]["visible"] += 1
                tally[kind]["explained"] += bool(found.explanations)
                is_restored = [restored(explanation.corrected, right) for explanation in found.explanations]
                tally[kind]["mended"] += any(is_restored)
                tally[kind]["first"] += any(is_restored[:1])
                tally[kind]["alone"] += any(is_restored) and not str(found).startswith("Either")
                if not any(is_restored):
                    misses.append((name, kind, rows, str(found)))
            start = time.process_time()
            strict = kl.diagnose(wrong, right, ("base", "tool", "zeros", "signs"))
            slowest = max(slowest, time.process_time() - start)
            q = rng.uniform(-3, 3, (5, right.n))
            is_right = np.abs(wrong.fk(q) - right.fk(q)).max() < 1e-7
            tally[kind]["strictly visible"] += not is_right
            tally[kind]["strictly mended"] += not is_right and any(
                restored(e.corrected, right) for e in strict.explanations
            )
            tally[kind]["wrong called right"] += strict.right and not is_right
    return tally, slowest, misses


COUNTS = (
    "planted",
    "visible",
    "explained",
    "mended",
    "first",
    "alone",
    "strictly visible",
    "strictly mended",
    "wrong called right",
)


def main():
    """Print the counts for all tables."""
    tally, slowest, _ = measure()
    print(f"{'':26}" + "".join(f"{name:>20}" for name in COUNTS))
    for kind, counts in [*tally.items(), ("all", sum(tally.values(), Counter()))]:
        print(f"{kind:26}" + "".join(f"{counts[name]:>20}" for name in COUNTS))
    print(f"slowest: {slowest:.2f} s of processor time")


if __name__ == "__main__":
    main()
