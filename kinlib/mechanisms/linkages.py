"""The linkages of the course, as data: closed chains whose motion is known, and the documents that they are taken from.

Planar linkages lie in the plane of x and y. Unless a docstring says otherwise, they are drawn with every link stretched along
x, so that all joint values are 0 there. Such a drawing is open, and the joint at which it is open has a closing offset.
Every function raises ValueError for a length that is not positive. The document that a linkage is taken from is its `source`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.mechanisms.joints import Joint, spherical, universal
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import exp, homogeneous
from kinlib.rigid.screw import screw

X, Y, Z = np.eye(3)


def four_bar(ground: float, crank: float, coupler: float, rocker: float) -> Mechanism:
    """A planar four-bar linkage from its link lengths: joints A and D are on the ground, B and C at the coupler's ends.

    A is the angle of the crank and D that of the rocker, both from x; B is the angle of the coupler relative to the crank, and C
    that of the coupler relative to the rocker. If one length is more than the sum of the others, it is built, but closes nowhere.

    >>> four_bar(0.4, 0.1, 0.35, 0.3).names
    ('A', 'B', 'D', 'C')
    """
    _check_lengths(ground=ground, crank=crank, coupler=coupler, rocker=rocker)
    tip = (ground + rocker) * X
    joints = [_pin("A", "ground", "crank", 0 * X), _pin("B", "crank", "coupler", crank * X)]
    joints += [_pin("D", "ground", "rocker", ground * X), _pin("C", "rocker", "coupler", tip, (crank + coupler) * X)]
    return Mechanism(joints, name="four-bar", source="Modern Robotics, example 2.3 and figure 2.4(a)")


def slider_crank(crank: float, rod: float, offset: float = 0.0) -> Mechanism:
    """A slider-crank linkage, whose slider moves along the line y = offset.

    A is the angle of the crank from x, B that of the rod relative to the crank, x the displacement of the slider,
    and C the angle of the rod relative to the slider.

    >>> slider_crank(1, 3).trace([0, 0, 4, 0]).closed
    True
    """
    _check_lengths(crank=crank, rod=rod)
    slide = Joint("x", ("ground", "slider"), screw(X, pitch=np.inf), point=offset * Y)
    joints = [_pin("A", "ground", "crank", 0 * X), _pin("B", "crank", "rod", crank * X), slide]
    joints += [_pin("C", "slider", "rod", offset * Y, (crank + rod) * X)]
    return Mechanism(joints, name="slider-crank", source="Modern Robotics, example 2.3 and figure 2.4(b)")


def five_bar(ground: float, left: tuple[float, float], right: tuple[float, float]) -> Mechanism:
    """A planar five-bar linkage: two arms of two links each, from A and from D, joined at C. Its mobility is 2.

    >>> five_bar(1, (1, 1), (1, 1)).kutzbach()
    2
    """
    arms = _planar_arm(0.0, left, ["A", "B"]), _planar_arm(ground, right, ["D", "E", "C"])
    return Mechanism.from_branches(*arms, name="five-bar", source="Modern Robotics, example 2.4 and figure 2.5(b)")


def ten_links() -> Mechanism:
    """A ring of ten links of one metre, joined to the ground at one of its ten joints, cut at the opposite one.

    q is theta_1 ... theta_5 of the left branch, theta_10 ... theta_6 of the right one, and the angle of the pin where they
    meet. Equation (3.81) of the source leaves the pin out, because it equates two points instead of poses.

    >>> ten_links().kutzbach()
    8
    """
    left_arm = _planar_arm(0.0, [1.0] * 5, [f"theta_{i}" for i in range(1, 6)])
    right_arm = _planar_arm(0.0, [1.0] * 5, [*(f"theta_{i}" for i in range(10, 5, -1)), "pin"])
    source = "Forward kinematics II, (3.81), from LaValle, Planning Algorithms, section 3.4"
    return Mechanism.from_branches(left_arm, right_arm, name="ring of ten links", source=source)


def parallelogram(ground: float = 0.4, crank: float = 0.2) -> Mechanism:
    """A parallelogram with a third crank in its middle: by the Gruebler-Kutzbach count a structure, but it moves.

    It is drawn closed, with all cranks parallel to y: it is closed at q = 0.

    >>> linkage = parallelogram()
    >>> linkage.kutzbach(), linkage.mobility([0, 0, 0, 0, 0, 0]).finite
    (0, 1)
    """
    _check_lengths(ground=ground, crank=crank)
    joints = []
    for i, foot in enumerate((0 * X, ground / 2 * X, ground * X), start=1):
        bar = f"crank {i}"
        joints += [_pin(f"A{i}", "ground", bar, foot), _pin(f"B{i}", bar, "coupler", foot + crank * Y)]
    source = "Modern Robotics, example 2.6 and figure 2.7(a)"
    return Mechanism(joints, name="parallelogram with a third crank", source=source)


def triangle() -> Mechanism:
    """A triangle of three bars of one metre joined by revolute joints, one bar the ground: a structure, which is drawn closed.

    >>> triangle().mobility([0, 0, 0]).finite
    0
    """
    return _two_bars(X / 2 + np.sqrt(3) / 2 * Y, X, "triangle", "Modern Robotics, (2.4), with N = J = 3")


def stretched_arch(left: float = 0.5, right: float = 0.5) -> Mechanism:
    """An arch of two bars that are stretched along the straight line between two fixed pins.

    It is drawn closed, and has an infinitesimal motion there, but no finite one.

    >>> mobility = stretched_arch().mobility([0, 0, 0])
    >>> mobility.infinitesimal, mobility.finite
    (1, 0)
    """
    _check_lengths(left=left, right=right)
    source = "a triangle of height 0, the textbook example of infinitesimal mobility"
    return _two_bars(left * X, (left + right) * X, "stretched arch", source)


def bennett(a: float = 1.0, alpha: float = np.pi / 3, b: float = 0.6) -> Mechanism:
    """Bennett's linkage: four revolute joints with skew axes, which moves although the Gruebler-Kutzbach count is -2.

    Opposite links are equal: lengths a, b, a, b and twists alpha, beta, alpha, beta, with sin(alpha)/a = sin(beta)/b, and no
    offsets. It is a standard DH table whose last frame is its first.

    Raises ValueError if there is no twist beta with this sine.

    >>> bennett().kutzbach()
    -2
    """
    _check_lengths(a=a, b=b)
    if abs(sine := b * np.sin(alpha) / a) > 1:
        raise ValueError(f"b sin(alpha) / a, a sine, must be at most 1; got {sine:.3g}. Try a smaller b.")
    source = "Bennett, A new mechanism, Engineering 76 (1903); McCarthy and Soh, Geometric Design of Linkages"
    return _ring([(a, alpha), (b, np.arcsin(sine))] * 2, "Bennett's linkage", source)


def bricard(a: float = 1.0, alpha: float = np.pi / 2) -> Mechanism:
    """Bricard's threefold symmetric linkage: six revolute joints, links of equal length, alternating twists alpha and -alpha.

    >>> bricard().kutzbach()
    0
    """
    _check_lengths(a=a)
    source = "Chen, You and Tarnai, Threefold-symmetric Bricard linkages for deployable structures (2005)"
    return _ring([(a, alpha), (a, -alpha)] * 3, "Bricard's linkage", source)


def sarrus(side: float = 0.3, rise: float = 0.2) -> Mechanism:
    """Sarrus's linkage: two pairs of hinged plates in perpendicular planes, whose top moves along a straight line.

    It is drawn closed: at q = 0 the top is 2 rise above the ground, with the knees bent outwards. It was the first linkage that
    converts rotation into motion along a straight line.

    >>> linkage = sarrus()
    >>> linkage.kutzbach(), linkage.mobility([0] * 6).finite
    (0, 1)
    """
    _check_lengths(side=side, rise=rise)
    joints = []
    for out, axis, leg in ((X, Y, "x"), (Y, -X, "y")):
        bodies = ("ground", f"lower plate {leg}", f"upper plate {leg}", "top")
        points = (side * out, side * out + rise * (out + Z), side * out + 2 * rise * Z)
        for part, pair, point in zip(("foot", "knee", "head"), pairwise(bodies), points, strict=True):
            joints.append(Joint(f"{part} {leg}", pair, screw(axis, point), point=point))
    return Mechanism(joints, name="Sarrus's linkage", source="Sarrus, Comptes Rendus 36 (1853)")


def stewart_gough(base: float = 0.5, platform: float = 0.3, height: float = 0.6) -> Mechanism:
    """The Stewart-Gough platform, 6-UPS: six legs of variable length under one plate. Its mobility is 6.

    base and platform are the radii on which the feet and the heads of the legs lie. It is drawn closed. Each leg has a
    universal joint at its foot, a prismatic joint along it, and a spherical joint at its head.

    >>> stewart_gough().kutzbach()
    6
    """
    _check_lengths(base=base, platform=platform, height=height)
    # Feet and heads are in pairs, and the pairs of the plate are between those of the ground.
    pairs = [(i + i % 2, i + 1 - i % 2, 0.2 if i % 2 else -0.2) for i in range(6)]
    feet = [base * exp((np.pi / 3 * foot - turn) * Z)[:, 0] for foot, _, turn in pairs]
    heads = [platform * exp((np.pi / 3 * head + turn) * Z)[:, 0] + height * Z for _, head, turn in pairs]
    joints = []
    for leg, (foot, head) in enumerate(zip(feet, heads, strict=True), start=1):
        along = (head - foot) / np.linalg.norm(head - foot)
        across = np.cross(Z, along) / np.linalg.norm(np.cross(Z, along))
        joints += [
            Joint(f"U{leg}", ("ground", f"shin {leg}"), universal(across, np.cross(along, across), foot), point=foot),
            Joint(f"P{leg}", (f"shin {leg}", f"shaft {leg}"), screw(along, pitch=np.inf), point=(foot + head) / 2),
            Joint(f"S{leg}", (f"shaft {leg}", "plate"), spherical(head), point=head),
        ]
    source = "Modern Robotics, example 2.8, figure 1.1(b) and 7.1.2; Gough (1956), Stewart (1965)"
    return Mechanism(joints, name="Stewart-Gough platform", source=source)


def _pin(name: str, first: str, second: str, point: Array, drawn: Array | None = None) -> Joint:
    """A revolute joint of a planar linkage; if the linkage is drawn open there, its second body has this point elsewhere."""
    gap = homogeneous(np.eye(3), 0 * point if drawn is None else point - drawn)
    return Joint(name, (first, second), screw(Z, point), gap, point)


def _two_bars(top: Array, foot: Array, name: str, source: str) -> Mechanism:
    """Two bars from the origin over a pin at the top to a foot."""
    joints = [_pin("A", "ground", "left", 0 * X), _pin("B", "left", "right", top), _pin("C", "ground", "right", foot)]
    return Mechanism(joints, name=name, source=source)


def _planar_arm(foot: float, lengths: Sequence[float], names: Sequence[str]) -> Chain:
    """A planar arm stretched along x, with a revolute joint for each name: with one name more than links, also at its tip."""
    _check_lengths(**{f"length {i}": length for i, length in enumerate(lengths, start=1)})
    x = foot + np.concatenate([[0.0], np.cumsum(lengths)])
    points = x[: len(names), None] * X
    return Chain(screw(Z, points), homogeneous(np.eye(3), x[-1] * X), points, joint_names=tuple(names))


def _ring(links: Sequence[tuple[float, float]], name: str, source: str) -> Mechanism:
    """A closed ring of revolute joints without offsets, from the length and the twist of each link."""
    rows = [{"a": a, "alpha": alpha, "d": 0, "theta": "q"} for a, alpha in links]
    return Mechanism.from_chain(replace(DHTable(rows, "standard", name=name).to_chain(), source=source))


def _check_lengths(**lengths: float) -> None:
    for name, length in lengths.items():
        if validation.real_array(length, name).ndim or not 0 < length < np.inf:
            raise ValueError(f"{name} must be a positive length in metres; got {length!r}. Lengths have no sign.")
