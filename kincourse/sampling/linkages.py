"""Random linkages: four-bars of a given kind, and linkages for which the mobility formula fails."""

from typing import NamedTuple

import numpy as np

from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.mechanisms import linkages
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import wrap_angle


class FourBar(NamedTuple):
    """The lengths of a four-bar linkage, in metres. Pin A is at the origin, and pin D on the x axis at x = ground."""

    ground: float
    crank: float
    coupler: float
    rocker: float

    @property
    def grashof_excess(self) -> float:
        """Shortest plus longest length less the other two: negative if Grashof's condition holds, 0 at a change point."""
        ordered = sorted(self)
        return ordered[0] + ordered[3] - ordered[1] - ordered[2]

    def closed_at(self, A: float) -> Array:
        """The joint values A, B, D, C of `linkages.four_bar`, (4,), with C to the left of the arrow from B to D."""
        B = self.crank * np.exp(1j * A)
        reach = abs(self.ground - B)
        corner = np.arccos((reach**2 + self.coupler**2 - self.rocker**2) / (2 * reach * self.coupler))
        coupler = np.angle(self.ground - B) + corner
        rocker = np.angle(B + self.coupler * np.exp(1j * coupler) - self.ground)
        return wrap_angle(np.array([A, coupler - A, rocker, coupler - rocker]))

    def cos_crank_angle(self, distance: float) -> float:
        """The cosine of the crank angle at which B and D are `distance` metres apart, by the law of cosines."""
        return (self.ground**2 + self.crank**2 - distance**2) / (2 * self.ground * self.crank)


def crank_rocker(sampler: ArmSampler) -> FourBar:
    """Draw a four-bar whose crank makes full turns while its rocker swings, well away from a change point."""
    while True:
        ground, coupler, rocker = (sampler.length(0.3, 0.7) for _ in range(3))
        four_bar = FourBar(ground, sampler.length(0.1, 0.2), coupler, rocker)
        if four_bar.grashof_excess < -0.1 and len({ground, coupler, rocker}) == 3:
            return four_bar


def limited_crank(sampler: ArmSampler) -> FourBar:
    """Draw a four-bar whose crank passes through 0 and is limited by the stretched coupler and rocker."""
    while True:
        four_bar = FourBar(*(sampler.length(0.2, 0.7) for _ in range(4)))
        folded = abs(four_bar.ground - four_bar.crank) > abs(four_bar.coupler - four_bar.rocker) + 0.05
        if folded and abs(four_bar.cos_crank_angle(four_bar.coupler + four_bar.rocker)) < 0.9:
            return four_bar


def four_bar_of_kind(sampler: ArmSampler, kind: str) -> FourBar:
    """Draw a four-bar of a kind by Grashof's condition.

    kind  "a" crank-rocker, "b" double crank, "c" double rocker, "d" no bar makes full turns, "e" change point
    """
    shortest = {"a": "crank", "b": "ground", "c": "coupler"}.get(kind, sampler.choice(["crank", "ground", "coupler"]))
    while True:
        lengths = sorted({sampler.length(0.1, 0.8) for _ in range(4)})
        if len(lengths) < 4 or lengths[3] > sum(lengths[:3]) - 0.1:
            continue
        others = iter(sampler.shuffled(lengths[1:]))
        four_bar = FourBar(*(lengths[0] if name == shortest else next(others) for name in FourBar._fields))
        grashof_excess = round(four_bar.grashof_excess, 9)
        if {"e": grashof_excess == 0, "d": grashof_excess > 0.04}.get(kind, grashof_excess < -0.04):
            return four_bar


class OverconstrainedCase(NamedTuple):
    """A linkage for which the mobility formula fails, with a configuration q (n,), its finite mobility, and an explanation."""

    linkage: Mechanism
    description: str
    q: Array
    finite_mobility: int
    explanation: str


def overconstrained_case(sampler: ArmSampler) -> OverconstrainedCase:
    """Draw one of four linkages, with random lengths, whose mobility is not the number of the Gruebler-Kutzbach formula."""
    one, two = sampler.length(0.3, 0.9), sampler.length(0.2, 0.6)
    moves = (
        "The linkage does move: the redundant equations follow from the others in every configuration, not only in this one. So its "
        "finite mobility is 1."
    )
    stuck = (
        "The infinitesimal motion cannot be continued to a finite one: away from the straight line the two bars are too short. So the "
        "finite mobility is 0."
    )
    kind = sampler.choice(["parallelogram", "Sarrus", "arch", "Bennett"])
    if kind == "parallelogram":
        description = "a parallelogram with a third crank"
        return OverconstrainedCase(linkages.parallelogram(one, two), description, np.zeros(6), 1, moves)
    if kind == "Sarrus":
        description = "the Sarrus linkage, two pairs of hinged plates in perpendicular planes"
        return OverconstrainedCase(linkages.sarrus(one, two), description, np.zeros(6), 1, moves)
    if kind == "arch":
        description = "two bars on one straight line between two fixed pins, joined by a third pin"
        return OverconstrainedCase(linkages.stretched_arch(one, two), description, np.zeros(3), 0, stuck)
    linkage = linkages.bennett(one + two, np.radians(sampler.degrees(35, 70)), one)
    description = "Bennett's linkage, four revolute joints with skew axes in a ring"
    return OverconstrainedCase(linkage, description, linkage.assemble([1, 2, 1, 2]).q, 1, moves)
