"""How two ways of doing the same are compared: in turns, within one run, by medians.

A machine is never quiet, and what slows it for a second slows whoever runs in that second. So nobody is timed nine times in
a row: in each round everybody has a turn, in another order each time. The first round, in which caches fill, does not count.
Of the rest the medians are told. A ratio is that of one round, in which all have the same machine; its quartiles are told too.

    >>> ours, theirs = in_turns([Way(lambda: sum(range(1000))), Way(lambda: sum(range(9000)))], rounds=5)
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


class NotHere(Exception):
    """What a benchmark needs, besides a peer, is not on this machine."""


@dataclass(frozen=True)
class Way:
    """One way to do something: `run` does so many things, which a slow way may do fewer of."""

    run: Callable[[], Any]
    things: int = 1


Make = Callable[[], Way]
"""Makes a way ready and tries it. Raises ModuleNotFoundError where the peer is not installed."""


@dataclass(frozen=True)
class Row:
    """A line of the table: what kinlib takes, what the peer takes, and what was wanted.

    what       what is measured, with its size
    unit       of both numbers: "s", or what is counted
    ours       the median of kinlib
    peer       the other one, and how it is used; empty where a bound stands for it
    theirs     its median; None where it is not installed
    wanted     so many times better than the peer; for a row `at_most`, at most so many times the peer, or the bound itself
    quartiles  of the rounds' ratios: lower, median, upper; None where there are no rounds
    """

    what: str
    unit: str
    ours: float
    wanted: float
    peer: str = ""
    theirs: float | None = None
    at_most: bool = False
    quartiles: tuple[float, float, float] | None = None

    @property
    def figure(self) -> float | None:
        """The number that `wanted` is held against; None without the peer."""
        if not self.peer:
            return self.ours
        if self.theirs is None:
            return None
        return self.quartiles[1] if self.quartiles else ratio(self.ours, self.theirs, self.at_most)

    @property
    def met(self) -> bool | None:
        """Whether it is what was wanted; None without the peer."""
        if self.figure is None:
            return None
        return self.figure <= self.wanted if self.at_most else self.figure >= self.wanted


@dataclass(frozen=True)
class Curve:
    """How the time grows: seconds for each of some sizes.

    what    what is measured
    sizes   of what is counted `of`: joints, configurations, submissions
    """

    what: str
    of: str
    sizes: tuple[float, ...]
    seconds: tuple[float, ...]

    @property
    def exponent(self) -> float:
        """The slope of log(seconds) over log(size), by least squares over the upper half of that axis.

        Below, what is done once for every call hides how the work grows.

        >>> Curve("", "", (1, 10, 100, 1000), (1.0, 1.0, 2.0, 20.0)).exponent
        1.0
        """
        x, y = np.log(self.sizes), np.log(self.seconds)
        upper = x >= (x[0] + x[-1]) / 2
        return float(np.polyfit(x[upper], y[upper], 1)[0].round(12))


def ratio(ours: float, theirs: float, at_most: bool = False) -> float:
    """How many times better: theirs over ours; or, for a row `at_most`, ours over theirs. An error of 0 counts as 1e-17."""
    ours, theirs = max(ours, 1e-17), max(theirs, 1e-17)
    return ours / theirs if at_most else theirs / ours


def in_turns(ways: Sequence[Way], rounds: int = ROUNDS) -> list[list[float]]:
    """Time everybody once a round, each round in another order: for each the seconds a thing, in the order of the rounds."""
    times: list[list[float]] = [[] for _ in ways]
    for number in range(rounds + 1):
        for turn in range(len(ways)):
            who = (turn + number) % len(ways)
            seconds = timed(ways[who])
            if number:
                times[who].append(seconds)
    return times


def timed(way: Way) -> float:
    """The seconds a thing, of one run."""
    start = time.perf_counter()
    way.run()
    return (time.perf_counter() - start) / way.things


def compared(
    what: str, ours: Way, peers: Mapping[str, tuple[Make, float]], rounds: int = ROUNDS, at_most: bool = False
) -> Iterator[Row]:
    """A row for each peer: kinlib and all peers that are installed, in turns.

    peers  by name: what makes it ready, and what is wanted
    """
    ready: dict[str, Way] = {}
    for name, (make, _) in peers.items():
        with suppress(ModuleNotFoundError):
            ready[name] = make()
    own, *others = in_turns([ours, *ready.values()], rounds)
    times = dict(zip(ready, others, strict=True))
    for name, (_, wanted) in peers.items():
        yield row(what, own, name, times.get(name), wanted=wanted, at_most=at_most)


def row(
    what: str, ours: Sequence[float], peer: str, theirs: Sequence[float] | None, *, wanted: float, at_most: bool = False
) -> Row:
    """A row of two that were timed in the same rounds; theirs None: not installed."""
    if theirs is None:
        return Row(what, "s", median(ours), wanted, peer, at_most=at_most)
    ratios = [ratio(*pair, at_most) for pair in zip(ours, theirs, strict=True)]
    lower, middle, upper = np.quantile(ratios, [0.25, 0.5, 0.75]).tolist()
    return Row(what, "s", median(ours), wanted, peer, median(theirs), at_most, (lower, middle, upper))


def grown(what: str, of: str, sizes: Sequence[float], way: Callable[[Any], Way], rounds: int = 5) -> Curve:
    """Time one way at several sizes, which have their turns like peers."""
    times = in_turns([way(size) for size in sizes], rounds)
    return Curve(what, of, tuple(sizes), tuple(map(median, times)))
