"""Speed and accuracy of frame assignment on thousands of random arms, compared with AutoDH.

    python -m benchmarks frames             1,000 arms of seven joints: time compared with AutoDH, and the number of errors
    python -m benchmarks.library.frames             accuracy, case by case
    python -m benchmarks.library.frames 500         fewer arms

Speed is measured on arms of seven joints, in both conventions; then every table is compared with its arm in 20
configurations. The peer is AutoDH 0.2 (edsterg/autodh), the only automatic frame assignment that we assignment. It takes points
and axes, a base frame and an end-effector frame, so both get the same arms.

Accuracy: an arm has 2 to 9 joints, one in four prismatic, with links of up to half a metre; its neighbouring axes are drawn
from every case in which two lines can be related (tests/support/example_arms.py). The error is the largest entry of
T_table(q) - T_chain(q) over 20 configurations. In the first lines, all pairs of axes of an arm belong to one case; then all
cases are mixed, in 10,000 arms for each convention; then pairs that are parallel up to a small angle are added, in 1,000
arms for each angle. Next to the largest error, the table shows how many arms have an error above 1e-9, and the largest
ratio of the error to the accuracy that the assignment reports.
Every tenth arm is given to the peer. Its rows are counted too, because it adds fixed ones: "rows" is the largest number of
additional rows. An arm that it refuses, or for which it returns NaN, counts as an error.
"""

import sys
import warnings
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np
from example_arms import AXIS_CASES, NEARLY_PARALLEL_ANGLES_RAD, arm, configurations

import kinlib as kl
from benchmarks.measure import Curve, Row, Workload, compare, measure_growth

try:
    import autodh
except ModuleNotFoundError:
    autodh = None

MAX_ERROR = 1e-9
"""A table with a larger error is a failure; metres, or an entry of a rotation matrix."""

MIN_SPEEDUP = 5.0
"""Target: how many times faster than the peer kinlib must be."""

JOINTS = (2, 4, 8, 16, 32, 64)
CONVENTIONS = ("standard", "modified")


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of speed in both conventions, then the number of failures."""
    rng = np.random.default_rng(1)
    arms = [arm(rng, 7)[0] for _ in range(5 if quick else 1_000)]
    rounds = 1 if quick else 5
    for convention in CONVENTIONS:
        peers = {"AutoDH": (partial(peer_workload, arms, convention), MIN_SPEEDUP)}
        workload = kinlib_workload(arms, convention, rounds)
        yield from compare(f"frame assignment, arm of 7 joints, {convention}", workload, peers, rounds)
    failures = sum(
        kinlib_result(chain, c, configurations(rng, chain, 20))[0] > MAX_ERROR for chain in arms for c in CONVENTIONS
    )
    yield Row("of these 2,000 tables, with error above 1e-9", "tables", failures, 0, at_most=True)


def curves(quick: bool = False) -> Iterator[Curve]:
    """Measure how the time grows with the number of joints."""
    rng, rounds = np.random.default_rng(1), 1 if quick else 5

    def assigned(joints: float) -> Workload:
        return kinlib_workload([arm(rng, int(joints))[0] for _ in range(2 if quick else 50)], "standard", rounds)

    yield measure_growth("frame assignment", "joints", JOINTS, assigned, rounds)


def kinlib_workload(arms: list[kl.Chain], convention: str, rounds: int) -> Workload:
    """Prepare the assignment of frames to all arms. An arm caches its results, so each round, the first included, gets new arms."""
    arms_of_rounds = iter([[replace(chain) for chain in arms] for _ in range(rounds + 1)])
    return Workload(
        lambda: [kl.assign_frames(chain, convention=convention) for chain in next(arms_of_rounds)], len(arms)
    )


def peer_workload(arms: list[kl.Chain], convention: str) -> Workload:
    """Prepare the same for AutoDH."""
    if autodh is None:
        raise ModuleNotFoundError("AutoDH")
    arguments_of_arms = [(autodh_joints(chain), np.eye(4), chain.home) for chain in arms]
    peer_convention = autodh.DHTable.Convention[convention.capitalize()]

    def run() -> None:
        with np.errstate(all="ignore"):  # it divides by zero
            for arguments in arguments_of_arms:
                autodh.get_dh_parameters(*arguments, peer_convention)

    return Workload(run, len(arms))


def autodh_joints(chain: kl.Chain) -> list:
    """Return the joints of an arm in the form that AutoDH takes."""
    kinds = {"R": autodh.Joint.Type.Revolute, "P": autodh.Joint.Type.Prismatic}
    axes, points = chain.lines.axis, chain.joint_points
    return [autodh.Joint(*joint, kinds[k]) for *joint, k in zip(axes, points, chain.joint_types, strict=True)]


def kinlib_result(chain, convention, q):
    """Return the error of an assignment by kinlib, its number of additional rows, and the accuracy that it reports."""
    assignment = kl.assign_frames(chain, convention=convention)
    return (
        float(np.abs(assignment.table.fk(q) - chain.fk(q)).max()),
        len(assignment.table.rows) - chain.n,
        assignment.accuracy,
    )


def peer_result(chain, convention, q):
    """Return the same for AutoDH, which reports no accuracy."""
    peer_convention = autodh.DHTable.Convention[convention.capitalize()]
    try:
        columns = autodh.get_dh_parameters(autodh_joints(chain), np.eye(4), chain.home, peer_convention)
        poses = np.array([autodh.DHTable(*columns, peer_convention).forward(row) for row in q])
    except (AssertionError, ValueError, np.linalg.LinAlgError):
        return np.inf, 0, np.inf
    error = float(np.abs(poses - chain.fk(q)).max())
    return (error if np.isfinite(error) else np.inf), len(columns[0]) - chain.n, np.inf


def print_line(label, convention, assigners, arms):
    """Print one line: for each function the largest error, the share of failures, the ratio of error to accuracy, and the rows."""
    results = {name: [] for name in assigners}
    for number, (chain, q) in enumerate(arms):
        for name, assign in assigners.items():
            if name == "kinlib" or number % 10 == 0:  # the peer computes one pose at a time
                results[name].append(assign(chain, convention, q))
    cells = []
    for name, rows in results.items():
        errors, additional, accuracies = np.array(rows).T
        share = f"{100 * (errors > MAX_ERROR).mean():.1f} %"
        accuracy_ratio = f"{(errors / np.maximum(accuracies, 1e-12)).max():>7.1f}" if name == "kinlib" else ""
        largest = f"{errors.max():.0e}" if np.isfinite(errors.max()) else "fails"
        cells.append(f"{largest:>9}{share:>9}{accuracy_ratio}{int(additional.max()):>6}")
    print(f"{label:<24}{convention:<10}" + "  ".join(cells), flush=True)


def main():
    """Print the table of accuracy."""
    warnings.simplefilter("ignore")  # the peer divides by zero
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    assigners = {"kinlib": kinlib_result, **({"AutoDH": peer_result} if autodh else {})}
    heading = f"{'kinlib':>9}{'> 1e-9':>9}{'ratio':>7}{'rows':>6}"
    print(f"{'largest error':<34}" + heading + (f"  {'AutoDH':>9}{'> 1e-9':>9}{'rows':>6}" if autodh else ""))
    blocks = {
        **{case: ((case,), None, count // 10) for case in AXIS_CASES},
        "all mixed": (AXIS_CASES, None, count),
        **{
            f"nearly parallel {angle:.0e}": (AXIS_CASES, angle, count // 10)
            for angle in sorted(NEARLY_PARALLEL_ANGLES_RAD)
        },
    }
    for label, (cases, angle, arms) in blocks.items():
        for convention in ("standard", "modified"):
            print_line(label, convention, assigners, draw_arms(arms, cases, angle))


def draw_arms(count, cases, angle):
    """Yield arms and configurations, the same ones for each convention."""
    rng = np.random.default_rng(1)
    for _ in range(count):
        chain, _ = arm(rng, int(rng.integers(2, 10)), cases, angle)
        yield chain, configurations(rng, chain, 20)


if __name__ == "__main__":
    main()
