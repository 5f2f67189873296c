"""Linkages drawn for a student: lengths of a kind, legs under a platform, and postures that counting misjudges."""

from typing import NamedTuple

import numpy as np

from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.four_bar_geometry import Bars
from kinlib.arrays.validation import Array
from kinlib.mechanisms import linkages
from kinlib.mechanisms.mechanism import Mechanism


def crank_rocker(sampler: ArmSampler) -> Bars:
    """A four-bar whose crank turns right round, with room to spare."""
    while True:
        ground, coupler, rocker = (sampler.length(0.3, 0.7) for _ in range(3))
        bars = Bars(ground, sampler.length(0.1, 0.2), coupler, rocker)
        if bars.surplus < -0.1 and len({ground, coupler, rocker}) == 3:
            return bars


def held_back(sampler: ArmSampler) -> Bars:
    """A four-bar whose crank passes through 0 and is held back by the stretched coupler and rocker."""
    while True:
        bars = Bars(*(sampler.length(0.2, 0.7) for _ in range(4)))
        folded = abs(bars.ground - bars.crank) > abs(bars.coupler - bars.rocker) + 0.05
        if folded and abs(bars.cosine(bars.coupler + bars.rocker)) < 0.9:
            return bars


def of_kind(sampler: ArmSampler, kind: str) -> Bars:
    """Lengths of a kind: the shortest bar is one of its own, and shortest plus longest say which side of the limit."""
    shortest = {"a": "crank", "b": "ground", "c": "coupler"}.get(kind, sampler.choice(["crank", "ground", "coupler"]))
    while True:
        lengths = sorted({sampler.length(0.1, 0.8) for _ in range(4)})
        if len(lengths) < 4 or lengths[3] > sum(lengths[:3]) - 0.1:
            continue
        others = iter(sampler.shuffled(lengths[1:]))
        bars = Bars(*(lengths[0] if name == shortest else next(others) for name in Bars._fields))
        surplus = round(bars.surplus, 9)
        if {"e": surplus == 0, "d": surplus > 0.04}.get(kind, surplus < -0.04):
            return bars


class Leg(NamedTuple):
    """A leg between the ground and a platform: its joints in words, and how many freedoms each has."""

    words: str
    freedoms: tuple[int, ...]


SPATIAL = (
    Leg("a universal joint, a slide and a ball joint", (2, 1, 3)),
    Leg("a ball joint, a slide and a ball joint", (3, 1, 3)),
    Leg("two pins and a ball joint", (1, 1, 3)),
    Leg("a pin and two ball joints", (1, 3, 3)),
    Leg("a universal joint, a slide and a universal joint", (2, 1, 2)),
    Leg("two universal joints", (2, 2)),
    Leg("a slide, a universal joint and a ball joint", (1, 2, 3)),
)
PLANAR = (Leg("three pins", (1, 1, 1)), Leg("two pins", (1, 1)), Leg("a pin, a slide and a pin", (1, 1, 1)))


class Case(NamedTuple):
    """A linkage that counting misjudges, a posture, the freedoms that it has, and what to say to who errs about them."""

    linkage: Mechanism
    words: str
    q: Array
    had: int
    why: str


def over_constrained(sampler: ArmSampler) -> Case:
    """One of four linkages whose count is wrong, with lengths of the student's own."""
    one, two = sampler.length(0.3, 0.9), sampler.length(0.2, 0.6)
    moves = "It does move: the equations that are too many say what the others say, in every posture and not only in this one."
    stuck = "A speed is felt and leads nowhere: off the line the two bars are too short."
    kind = sampler.choice(["parallelogram", "Sarrus", "arch", "Bennett"])
    if kind == "parallelogram":
        words = "a parallelogram with a third crank"
        return Case(linkages.parallelogram(one, two), words, np.zeros(6), 1, moves)
    if kind == "Sarrus":
        words = "Sarrus's linkage, two pairs of hinged plates in planes at right angles"
        return Case(linkages.sarrus(one, two), words, np.zeros(6), 1, moves)
    if kind == "arch":
        words = "two bars pinned end to end on one straight line between two pins"
        return Case(linkages.stretched_arch(one, two), words, np.zeros(3), 0, stuck)
    linkage = linkages.bennett(one + two, np.radians(sampler.degrees(35, 70)), one)
    words = "Bennett's linkage, four skew hinges in a ring"
    return Case(linkage, words, linkage.assemble([1, 2, 1, 2]).q, 1, moves)
