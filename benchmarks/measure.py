"""Compare two or more implementations: time them alternately in one run, and report medians.

A computer is never idle, and what slows it for a second slows whatever runs in that second. Therefore no implementation is
timed several times in a row: each round times every implementation once, in a different order each time. The first round,
in which caches fill, is dropped. The reported times are medians over the other rounds. Ratios are taken within a round,
where all implementations share the same conditions; their median and quartiles are reported.

    >>> ours, theirs = time_interleaved([Workload(lambda: sum(range(9)))] * 2, rounds=5)
    >>> len(ours), len(theirs)
    (5, 5)
"""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from statistics import median
from typing import Any

import numpy as np

ROUNDS = 9
"""Default number of rounds that count."""

MIN_ERROR = 1e-17
"""Smaller errors, and 0, count as this one, so that every ratio is finite."""


class MissingRequirementError(Exception):
    """A benchmark needs something, other than a peer, that this machine does not have."""


@dataclass(frozen=True)
class Workload:
    """Work to be timed: `run` computes `count` results, of which a slow implementation may compute fewer."""

    run: Callable[[], Any]
    count: int = 1


WorkloadFactory = Callable[[], Workload]
"""Prepares a workload and tries it. Raises ModuleNotFoundError if the peer is not installed."""


@dataclass(frozen=True)
class Row:
    """A line of the table: the value of kinlib, the value of a peer, and the target.

    name        what is measured, with its size
    unit        of both values: "s", or what is counted
    value       the median of kinlib
    target      how many times better than the peer kinlib must be; for a row `at_most`, the largest ratio to the peer, or
                the largest value if there is no peer
    peer        the other implementation, and how it is used; empty if there is none
    peer_value  its median; None if it is not installed
    at_most     whether the target is an upper bound
    quartiles   of the ratios of all rounds: lower, median, upper; None if there are no rounds
    """

    name: str
    unit: str
    value: float
    target: float
    peer: str = ""
    peer_value: float | None = None
    at_most: bool = False
    quartiles: tuple[float, float, float] | None = None

    @property
    def ratio_or_value(self) -> float | None:
        """The number that is compared with the target: the ratio to the peer, or the value; None if the peer is missing."""
        if not self.peer:
            return self.value
        if self.peer_value is None:
            return None
        return self.quartiles[1] if self.quartiles else ratio(self.value, self.peer_value, self.at_most)

    @property
    def meets_target(self) -> bool | None:
        """Whether the target is met; None if the peer is missing."""
        if self.ratio_or_value is None:
            return None
        return self.ratio_or_value <= self.target if self.at_most else self.ratio_or_value >= self.target


@dataclass(frozen=True)
class Curve:
    """How the time grows with the size of a task.

    name       what is measured
    size_name  what the size counts: joints, configurations, submissions
    sizes      the measured sizes
    seconds    the time for each size
    """

    name: str
    size_name: str
    sizes: tuple[float, ...]
    seconds: tuple[float, ...]

    @property
    def exponent(self) -> float:
        """The slope of log(seconds) over log(size), by least squares over the upper half of that axis.

        At smaller sizes, the constant cost of each call dominates.

        >>> Curve("", "", (1, 10, 100, 1000), (1.0, 1.0, 2.0, 20.0)).exponent
        1.0
        """
        x, y = np.log(self.sizes), np.log(self.seconds)
        upper = x >= (x[0] + x[-1]) / 2
        return float(np.polyfit(x[upper], y[upper], 1)[0].round(12))


def ratio(value: float, peer_value: float, at_most: bool = False) -> float:
    """Return how many times better kinlib is: the peer's value over ours, or the inverse for a row `at_most`."""
    value, peer_value = max(value, MIN_ERROR), max(peer_value, MIN_ERROR)
    return value / peer_value if at_most else peer_value / value


def time_interleaved(workloads: Sequence[Workload], rounds: int = ROUNDS) -> list[list[float]]:
    """Time each workload once per round, in a different order each round.

    Returns for each workload the seconds per result, in the order of the rounds.
    """
    seconds: list[list[float]] = [[] for _ in workloads]
    for number in range(rounds + 1):
        for turn in range(len(workloads)):
            index = (turn + number) % len(workloads)
            measured = time_once(workloads[index])
            if number:
                seconds[index].append(measured)
    return seconds


def time_once(workload: Workload) -> float:
    """Run a workload once and return the seconds per result."""
    start = time.perf_counter()
    workload.run()
    return (time.perf_counter() - start) / workload.count


def compare(
    name: str,
    workload: Workload,
    peers: Mapping[str, tuple[WorkloadFactory, float]],
    rounds: int = ROUNDS,
    at_most: bool = False,
) -> Iterator[Row]:
    """Time kinlib and all installed peers in the same rounds, and yield a row for each peer.

    peers  by name: the function that prepares its workload, and the target
    """
    prepared: dict[str, Workload] = {}
    for peer, (prepare, _) in peers.items():
        with suppress(ModuleNotFoundError):
            prepared[peer] = prepare()
    own, *others = time_interleaved([workload, *prepared.values()], rounds)
    seconds = dict(zip(prepared, others, strict=True))
    for peer, (_, target) in peers.items():
        yield timed_row(name, own, peer, seconds.get(peer), target=target, at_most=at_most)


def timed_row(
    name: str,
    seconds: Sequence[float],
    peer: str,
    peer_seconds: Sequence[float] | None,
    *,
    target: float,
    at_most: bool = False,
) -> Row:
    """Make a row from the times of kinlib and of a peer in the same rounds; None if the peer is not installed."""
    if peer_seconds is None:
        return Row(name, "s", median(seconds), target, peer, at_most=at_most)
    ratios = [ratio(*pair, at_most) for pair in zip(seconds, peer_seconds, strict=True)]
    lower, middle, upper = np.quantile(ratios, [0.25, 0.5, 0.75]).tolist()
    return Row(name, "s", median(seconds), target, peer, median(peer_seconds), at_most, (lower, middle, upper))


def measure_growth(
    name: str, size_name: str, sizes: Sequence[float], workload: Callable[[Any], Workload], rounds: int = 5
) -> Curve:
    """Time a workload of several sizes, all of them in each round."""
    seconds = time_interleaved([workload(size) for size in sizes], rounds)
    return Curve(name, size_name, tuple(sizes), tuple(map(median, seconds)))
