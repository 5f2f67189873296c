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
from dataclasses import dataclass, field
from statistics import median
from typing import Any, TypeVar

import numpy as np

ROUNDS = 9
"""Default number of rounds that count."""

BATCH_SIZES = tuple(10**k for k in range(7))
"""The sizes of `measure_batches`."""

MIN_ELEMENTS = 2_000
"""A round of `measure_batches` computes at least so many elements of each size: a small batch is computed many times."""

MIN_ERROR = 1e-17
"""Smaller errors, and 0, count as this one, so that every ratio is finite."""


class MissingRequirementError(Exception):
    """A benchmark needs something, other than a peer, that this machine does not have."""


@dataclass(frozen=True)
class Workload:
    """Work to be timed: `run` computes `count` results, of which a slow implementation may compute fewer, or a part of one."""

    run: Callable[[], Any]
    count: float = 1


T = TypeVar("T")

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
    peers      the times of other implementations for the same sizes, by name
    """

    name: str
    size_name: str
    sizes: tuple[float, ...]
    seconds: tuple[float, ...]
    peers: Mapping[str, tuple[float, ...]] = field(default_factory=dict)

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

    def crossings(self, peer: str) -> list[float]:
        """The sizes at which kinlib and a peer take the same time, by interpolation between the measured sizes.

        >>> Curve("", "", (1, 10, 100), (2.0, 2.0, 2.0), {"a loop": (0.2, 2.0, 20.0)}).crossings("a loop")
        [10.0]
        """
        x, y = np.log(self.sizes), np.log(self.peers[peer]) - np.log(self.seconds)
        changes = np.flatnonzero((y[:-1] > 0) != (y[1:] > 0))
        return np.exp([x[i] - y[i] * (x[i + 1] - x[i]) / (y[i + 1] - y[i]) for i in changes]).round(9).tolist()


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


def installed(peers: Mapping[str, Callable[[], T]]) -> dict[str, T]:
    """Prepare the peers, by name, without those that are not installed."""
    prepared = {}
    for peer, prepare in peers.items():
        with suppress(ModuleNotFoundError):
            prepared[peer] = prepare()
    return prepared


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
    prepared = installed({peer: prepare for peer, (prepare, _) in peers.items()})
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


def measure_batches(
    name: str,
    size_name: str,
    functions: Mapping[str, Callable[[np.ndarray], Any]],
    loops: Mapping[str, Workload],
    elements: np.ndarray,
    *,
    rounds: int = 5,
) -> Curve:
    """Time functions of a batch for each of BATCH_SIZES that `elements` has, and peers that compute one element after the other.

    functions  kinlib's, then those of peers; called with a single element for the size 1
    loops      peers whose time for each element does not depend on the size of the batch, so it is measured once in each round
    """
    sizes = [size for size in BATCH_SIZES if size <= len(elements)]

    def batches(function: Callable[[np.ndarray], Any], size: int) -> Workload:
        count = max(1, min(MIN_ELEMENTS, len(elements)) // size)
        parts = elements[:count] if size == 1 else elements[: count * size].reshape(count, size, *elements.shape[1:])
        return Workload(lambda: [function(part) for part in parts], count)

    timed = [batches(function, size) for function in functions.values() for size in sizes]
    seconds = list(map(median, time_interleaved([*timed, *loops.values()], rounds)))
    at_once = np.reshape(seconds[: len(timed)], (len(functions), len(sizes)))
    one_by_one = np.outer(seconds[len(timed) :], sizes)
    own, *others = (tuple(row.tolist()) for row in (*at_once, *one_by_one))
    return Curve(name, size_name, tuple(sizes), own, dict(zip([*list(functions)[1:], *loops], others, strict=True)))
