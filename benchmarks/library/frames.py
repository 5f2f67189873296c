"""How fast a frame assignment is, and how right: the worst error of thousands of arms, by case and by angle, beside a peer.

    python -m benchmarks frames             1,000 arms of seven joints: seconds beside the peer's, and how many are off
    python -m benchmarks.library.frames             how right, case by case
    python -m benchmarks.library.frames 500         fewer arms

Speed is measured on arms of seven joints, in both conventions; then every table is held against its arm in 20 postures.
The peer is AutoDH 0.2 (edsterg/autodh), the one automatic assigner that we found. It takes anchors and axes, a base and an
end-effector frame, so the same arms go to both.

How right: an arm has 2 to 9 joints, one in four a slide, links up to half a metre; its neighbouring axes are drawn in every
case that two lines can be in (tests/support/example_arms.py). The error is the largest entry of T_table(q) - T_chain(q) over 20 postures.
The first lines have one case for all pairs of an arm; then all cases are mixed, in 10,000 arms a convention; then pairs
that are nearly parallel by an angle are mixed in, in 1,000 arms for each angle. Beside the worst error stand how many
arms are off by more than 1e-9, and by how many times the error was larger than the accuracy that the assignment claims.
Every tenth arm goes to the peer. Its rows are counted too, for it adds fixed ones: "rows" is the largest surplus over the
joints. An arm that it refuses, or answers with NaN, counts as off.
"""

import sys
import warnings
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np
from example_arms import AXIS_CASES, NEARLY_PARALLEL_ANGLES_RAD, arm, configurations

import kinlib as kl
from benchmarks.measure import Curve, Row, Way, compared, grown

try:
    import autodh
except ModuleNotFoundError:
    autodh = None

WANTED = 1e-9
"""A table that is off by more is a failure, in metres or as the entry of a rotation."""

FASTER = 5.0
"""So many times faster than the peer is wanted."""

JOINTS = (2, 4, 8, 16, 32, 64)
CONVENTIONS = ("standard", "modified")


def rows(quick: bool = False) -> Iterator[Row]:
    """Speed in both conventions, then the arms that are off."""
    rng = np.random.default_rng(1)
    arms = [arm(rng, 7)[0] for _ in range(5 if quick else 1_000)]
    rounds = 1 if quick else 5
    for convention in CONVENTIONS:
        peers = {"AutoDH": (partial(peer_assigning, arms, convention), FASTER)}
        way = assigning(arms, convention, rounds)
        yield from compared(f"frames of an arm of 7 joints, {convention}", way, peers, rounds)
    off = sum(ours(chain, c, configurations(rng, chain, 20))[0] > WANTED for chain in arms for c in CONVENTIONS)
    yield Row("of these 2,000 tables, off by more than 1e-9", "tables", off, 0, at_most=True)


def curves(quick: bool = False) -> Iterator[Curve]:
    """How the time grows with the joints."""
    rng, rounds = np.random.default_rng(1), 1 if quick else 5

    def assigned(joints: float) -> Way:
        return assigning([arm(rng, int(joints))[0] for _ in range(2 if quick else 50)], "standard", rounds)

    yield grown("frames of an arm", "joints", JOINTS, assigned, rounds)


def assigning(arms: list[kl.Chain], convention: str, rounds: int) -> Way:
    """Assign frames to all arms. An arm remembers what was asked of it, so each round has new ones, and one is for none."""
    stock = iter([[replace(chain) for chain in arms] for _ in range(rounds + 1)])
    return Way(lambda: [kl.assign_frames(chain, convention=convention) for chain in next(stock)], len(arms))


def peer_assigning(arms: list[kl.Chain], convention: str) -> Way:
    """The same for AutoDH."""
    if autodh is None:
        raise ModuleNotFoundError("AutoDH")
    ready = [(autodh_joints(chain), np.eye(4), chain.home) for chain in arms]
    wanted = autodh.DHTable.Convention[convention.capitalize()]

    def run() -> None:
        with np.errstate(all="ignore"):  # it divides by zero on its way
            for arguments in ready:
                autodh.get_dh_parameters(*arguments, wanted)

    return Way(run, len(arms))


def autodh_joints(chain: kl.Chain) -> list:
    """The arm as AutoDH takes it."""
    kinds = {"R": autodh.Joint.Type.Revolute, "P": autodh.Joint.Type.Prismatic}
    axes, points = chain.lines.axis, chain.joint_points
    return [autodh.Joint(*joint, kinds[k]) for *joint, k in zip(axes, points, chain.joint_types, strict=True)]


def ours(chain, convention, q):
    """The error of our assignment, its surplus of rows, and the accuracy that it claims."""
    found = kl.assign_frames(chain, convention=convention)
    return float(np.abs(found.table.fk(q) - chain.fk(q)).max()), len(found.table.rows) - chain.n, found.accuracy


def peer(chain, convention, q):
    """The same for AutoDH, which claims nothing."""
    wanted = autodh.DHTable.Convention[convention.capitalize()]
    try:
        columns = autodh.get_dh_parameters(autodh_joints(chain), np.eye(4), chain.home, wanted)
        reached = np.array([autodh.DHTable(*columns, wanted).forward(row) for row in q])
    except (AssertionError, ValueError, np.linalg.LinAlgError):
        return np.inf, 0, np.inf
    error = float(np.abs(reached - chain.fk(q)).max())
    return (error if np.isfinite(error) else np.inf), len(columns[0]) - chain.n, np.inf


def line(label, convention, assigners, arms):
    """Print one line: for each assigner the worst error, the share of arms off, the claim, the surplus of rows."""
    results = {name: [] for name in assigners}
    for number, (chain, q) in enumerate(arms):
        for name, assign in assigners.items():
            if name == "kinlib" or number % 10 == 0:  # the peer computes one pose at a time
                results[name].append(assign(chain, convention, q))
    cells = []
    for name, rows in results.items():
        errors, surplus, claimed = np.array(rows).T
        share = f"{100 * (errors > WANTED).mean():.1f} %"
        claim = f"{(errors / np.maximum(claimed, 1e-12)).max():>7.1f}" if name == "kinlib" else ""
        worst = f"{errors.max():.0e}" if np.isfinite(errors.max()) else "fails"
        cells.append(f"{worst:>9}{share:>9}{claim}{int(surplus.max()):>6}")
    print(f"{label:<18}{convention:<10}" + "  ".join(cells), flush=True)


def main():
    """Print both blocks."""
    warnings.simplefilter("ignore")  # the peer divides by zero on its way
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    assigners = {"kinlib": ours, **({"AutoDH": peer} if autodh else {})}
    ours_head = f"{'kinlib':>9}{'> 1e-9':>9}{'claim':>7}{'rows':>6}"
    print(f"{'worst error':<28}" + ours_head + (f"  {'AutoDH':>9}{'> 1e-9':>9}{'rows':>6}" if autodh else ""))
    blocks = {
        **{case: ((case,), None, count // 10) for case in AXIS_CASES},
        "all mixed": (AXIS_CASES, None, count),
        **{f"off by {angle:.0e}": (AXIS_CASES, angle, count // 10) for angle in sorted(NEARLY_PARALLEL_ANGLES_RAD)},
    }
    for label, (cases, angle, arms) in blocks.items():
        for convention in ("standard", "modified"):
            line(label, convention, assigners, drawn(arms, cases, angle))


def drawn(count, cases, angle):
    """Yield arms and postures, the same ones for each convention."""
    rng = np.random.default_rng(1)
    for _ in range(count):
        chain, _ = arm(rng, int(rng.integers(2, 10)), cases, angle)
        yield chain, configurations(rng, chain, 20)


if __name__ == "__main__":
    main()
