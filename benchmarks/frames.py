"""How right a frame assignment is: the worst error of thousands of arms, by case and by angle, beside a peer.

    python -m benchmarks.frames
    python -m benchmarks.frames 500         fewer arms

An arm has 2 to 9 joints, one in four a slide, links up to half a metre; its neighbouring axes are drawn in every case
that two lines can be in (tests/arms.py). The error is the largest entry of T_table(q) - T_chain(q) over 20 postures.
The first lines have one case for all pairs of an arm; then all cases are mixed, in 10,000 arms a convention; then pairs
that are nearly parallel by an angle are mixed in, in 1,000 arms for each angle. Beside the worst error stand how many
arms are off by more than 1e-9, and by how many times the error was larger than the accuracy that the assignment claims.

The peer is AutoDH 0.2 (edsterg/autodh), the one automatic assigner that we found. It is not among our dependencies:
`pip install AutoDH` puts its columns beside ours. It takes anchors and axes, a base and an end-effector frame, so the same
arms go to both, every tenth one to the peer. Its rows are counted too, for it adds fixed ones: "rows" is the largest
surplus over the joints. An arm that it refuses, or answers with NaN, counts as off.
"""

import sys
import warnings
from pathlib import Path

import numpy as np

import kinlib as kl

sys.path.append(str(Path(__file__).parents[1] / "tests"))
from arms import ANGLES, CASES, arm, configurations

try:
    import autodh
except ModuleNotFoundError:  # not among our dependencies
    autodh = None

WANTED = 1e-9


def ours(chain, convention, q):
    """The error of our assignment, its surplus of rows, and the accuracy that it claims."""
    found = kl.assign_frames(chain, convention=convention)
    return float(np.abs(found.table.fk(q) - chain.fk(q)).max()), len(found.table.rows) - chain.n, found.accuracy


def peer(chain, convention, q):
    """The same for AutoDH, which claims nothing."""
    kinds = {"R": autodh.Joint.Type.Revolute, "P": autodh.Joint.Type.Prismatic}
    axes = kl.line(chain.screws).axis
    joints = [autodh.Joint(*joint, kinds[k]) for *joint, k in zip(axes, chain.joint_points, chain.letters, strict=True)]
    wanted = autodh.DHTable.Convention[convention.capitalize()]
    try:
        columns = autodh.get_dh_parameters(joints, np.eye(4), chain.home, wanted)
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
        **{case: ((case,), None, count // 10) for case in CASES},
        "all mixed": (CASES, None, count),
        **{f"off by {angle:.0e}": (CASES, angle, count // 10) for angle in sorted(ANGLES)},
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
