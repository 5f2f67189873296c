"""The linkages of the course, as data: closed chains with a known answer, and the document that it comes from.

Planar ones lie in the plane of x and y and are drawn with every link stretched along x, so that all values are 0 there;
such a drawing is open, and the joint that it leaves open knows its gap.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import DHTable
from kinlib.mechanisms.joints import Joint, spherical, universal
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.rigid.lie import exp, pose
from kinlib.rigid.screw import screw

X, Y, Z = np.eye(3)
SLIDE = np.inf


def four_bar(ground: float, crank: float, coupler: float, rocker: float) -> Mechanism:
    """A planar four-bar linkage, from its link lengths: A and D stand on the ground, B and C at the coupler's ends.

    A is the crank's angle and D the rocker's, both from x; B is the coupler's to the crank, C the coupler's to the rocker.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, example 2.3 and figure 2.4(a); Grashof's condition sorts its kinds.

    >>> four_bar(0.4, 0.1, 0.35, 0.3).names
    ('A', 'B', 'D', 'C')
    """
    _positive(ground=ground, crank=crank, coupler=coupler, rocker=rocker)
    a, b, d, c = 0 * X, crank * X, ground * X, (ground + rocker) * X
    return Mechanism(
        [
            Joint("A", ("ground", "crank"), screw(Z, a)),
            Joint("B", ("crank", "coupler"), screw(Z, b)),
            Joint("D", ("ground", "rocker"), screw(Z, d)),
            Joint("C", ("rocker", "coupler"), screw(Z, c), gap=_shift(c - b - coupler * X), point=c),
        ],
        name="four-bar",
        source="Modern Robotics, figure 2.4(a)",
    )


def slider_crank(crank: float, rod: float, offset: float = 0.0) -> Mechanism:
    """A slider-crank: the crank's angle A and the rod's B to it, the slider's way along x, and the rod's angle C to it.

    The slide runs along the line y = offset.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, example 2.3 and figure 2.4(b).

    >>> slider_crank(1, 3).trace([0, 0, 4, 0]).closed
    True
    """
    _positive(crank=crank, rod=rod)
    pin = offset * Y
    return Mechanism(
        [
            Joint("A", ("ground", "crank"), screw(Z)),
            Joint("B", ("crank", "rod"), screw(Z, crank * X)),
            Joint("slide", ("ground", "slider"), screw(X, pitch=SLIDE), point=pin),
            Joint("C", ("slider", "rod"), screw(Z, pin), gap=_shift(pin - (crank + rod) * X), point=pin),
        ],
        name="slider-crank",
        source="Modern Robotics, figure 2.4(b)",
    )


def five_bar(ground: float, left: tuple[float, float], right: tuple[float, float]) -> Mechanism:
    """A planar five-bar: two arms of two links each, from A and from D, pinned together at C. It has two freedoms.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, example 2.4 and figure 2.5(b).

    >>> five_bar(1, (1, 1), (1, 1)).kutzbach()
    2
    """
    left_arm = _planar_arm(0.0, left, ("A", "B"))
    right_arm = _planar_arm(ground, right, ("D", "E", "C"))
    return Mechanism.from_branches(left_arm, right_arm, name="five-bar", source="Modern Robotics, figure 2.5(b)")


def ten_links(left: Sequence[float] = (1.0,) * 5, right: Sequence[float] = (1.0,) * 5) -> Mechanism:
    """The ring of ten links of the UIUC deck, hinged to the ground at one of its ten joints, cut open at the opposite one.

    q holds theta_1 ... theta_5 of the left branch, theta_10 ... theta_6 of the right one, and the pin where they meet. The
    deck's (3.81) leaves the pin out: it equates two points, and the pin is what turns two points into two poses.

    Raises ValueError for a length that is not positive.
    Source: the UIUC deck's (3.81), from LaValle, Planning Algorithms, section 3.4.

    >>> ten_links().kutzbach()
    8
    """
    left_arm = _planar_arm(0.0, left, [f"theta_{i}" for i in range(1, 6)])
    right_arm = _planar_arm(0.0, right, [*(f"theta_{i}" for i in range(10, 5, -1)), "pin"])
    return Mechanism.from_branches(left_arm, right_arm, name="ring of ten links", source="UIUC deck, (3.81)")


def parallelogram(ground: float = 0.4, crank: float = 0.2) -> Mechanism:
    """A parallelogram with a third crank in its middle: counting calls it a structure, and it moves all the same.

    It is drawn closed, with all cranks upright: q = 0 is a posture.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, example 2.6 and figure 2.7(a).

    >>> linkage = parallelogram()
    >>> linkage.kutzbach(), linkage.mobility([0, 0, 0, 0, 0, 0]).finite
    (0, 1)
    """
    _positive(ground=ground, crank=crank)
    joints = []
    for i, foot in enumerate((0 * X, ground / 2 * X, ground * X), start=1):
        joints += [
            Joint(f"A{i}", ("ground", f"crank {i}"), screw(Z, foot), point=foot),
            Joint(f"B{i}", (f"crank {i}", "coupler"), screw(Z, foot + crank * Y), point=foot + crank * Y),
        ]
    return Mechanism(joints, name="parallelogram with a third crank", source="Modern Robotics, example 2.6")


def triangle(side: float = 1.0) -> Mechanism:
    """Three bars pinned into a triangle, one of them the ground: a structure.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, (2.4), with N = J = 3.

    >>> triangle().mobility([0, 0, 0]).finite
    0
    """
    _positive(side=side)
    top = side * (X / 2 + np.sqrt(3) / 2 * Y)
    return Mechanism(
        [
            Joint("A", ("ground", "left"), screw(Z)),
            Joint("B", ("left", "right"), screw(Z, top)),
            Joint("C", ("ground", "right"), screw(Z, side * X)),
        ],
        name="triangle",
        source="Modern Robotics, (2.4)",
    )


def stretched_arch(left: float = 0.5, right: float = 0.5) -> Mechanism:
    """Two bars pinned end to end on one straight line between two pins: the middle gives a little, and goes nowhere.

    Raises ValueError for a length that is not positive.
    Source: the textbook case of infinitesimal mobility; a triangle whose height is 0.

    >>> mobility = stretched_arch().mobility([0, 0, 0])
    >>> mobility.instantaneous, mobility.finite
    (1, 0)
    """
    _positive(left=left, right=right)
    return Mechanism(
        [
            Joint("A", ("ground", "left"), screw(Z)),
            Joint("B", ("left", "right"), screw(Z, left * X)),
            Joint("C", ("ground", "right"), screw(Z, (left + right) * X)),
        ],
        name="stretched arch",
        source="a triangle of height 0",
    )


def three_rrr(base: float = 0.5, platform: float = 0.2, upper: float = 0.3, lower: float = 0.3) -> Mechanism:
    """The planar 3-RRR robot: a triangular platform carried by three arms of two links, with three freedoms.

    base, platform: the distance of their corners from their middle. Every arm is drawn stretched, from its foot inwards.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, 7.1.1.

    >>> three_rrr().kutzbach()
    3
    """
    _positive(base=base, platform=platform, upper=upper, lower=lower)
    branches = []
    for i in range(3):
        out = _turned(X, 2 * np.pi / 3 * i)
        reach = (base, base - upper, base - upper - lower)
        joints = [r * out for r in reach]
        # The middle of the platform, as this arm's drawing has it: a platform's radius beyond the arm's end.
        middle = _shift((reach[-1] - platform) * out)
        labels = tuple(f"{letter}{i + 1}" for letter in "ABC")
        branches.append(Chain(np.array([screw(Z, p) for p in joints]), middle, np.array(joints), joint_names=labels))
    return Mechanism.from_branches(*branches, name="3-RRR", source="Modern Robotics, 7.1")


def bennett(a: float = 1.0, alpha: float = np.pi / 3, b: float = 0.6) -> Mechanism:
    """Bennett's linkage: four skew hinges that move, against all counting.

    Opposite links are alike: lengths a, b, a, b and twists alpha, beta, alpha, beta, with sin(alpha)/a = sin(beta)/b, and no
    offsets: a standard DH table whose last frame is its first.

    Raises ValueError for a length that is not positive, and where no twist beta fits.
    Source: Bennett, A new mechanism, Engineering 76 (1903); McCarthy and Soh, Geometric Design of Linkages.

    >>> bennett().kutzbach()
    -2
    """
    _positive(a=a, b=b)
    if abs(sine := b * np.sin(alpha) / a) > 1:
        raise ValueError(f"No twist has the sine {sine:.3g} = b sin(alpha) / a. Is b too long?")
    beta = np.arcsin(sine)
    return _ring([(a, alpha), (b, beta)] * 2, "Bennett's linkage", "Bennett (1903)")


def bricard(a: float = 1.0, alpha: float = np.pi / 2) -> Mechanism:
    """Bricard's threefold symmetric linkage: six hinges, links of one length, twists alpha and -alpha in turn.

    Raises ValueError for a length that is not positive.
    Source: Chen, You and Tarnai, Threefold-symmetric Bricard linkages for deployable structures, Int. J. of Solids and
    Structures 42 (2005).

    >>> bricard().kutzbach()
    0
    """
    _positive(a=a)
    return _ring([(a, alpha), (a, -alpha)] * 3, "Bricard's linkage", "Chen, You and Tarnai (2005)")


def sarrus(side: float = 0.3, rise: float = 0.2) -> Mechanism:
    """Sarrus's linkage: two pairs of hinged plates in planes at right angles, whose top moves along a straight line.

    It is drawn closed: at q = 0 the top stands 2 rise above the ground, with the knees bent outwards.

    Raises ValueError for a length that is not positive.
    Source: Sarrus, Comptes Rendus 36 (1853): the first linkage to turn circles into a straight line.

    >>> linkage = sarrus()
    >>> linkage.kutzbach(), linkage.mobility([0] * 6).finite
    (0, 1)
    """
    _positive(side=side, rise=rise)
    joints = []
    for out, axis, leg in ((X, Y, "x"), (Y, -X, "y")):
        bodies = ("ground", f"lower plate {leg}", f"upper plate {leg}", "top")
        heights = (side * out, side * out + rise * (out + Z), side * out + 2 * rise * Z)
        joints += [
            Joint(f"{part} {leg}", (bodies[k], bodies[k + 1]), screw(axis, heights[k]), point=heights[k])
            for k, part in enumerate(("foot", "knee", "head"))
        ]
    return Mechanism(joints, name="Sarrus's linkage", source="Sarrus (1853)")


def stewart_gough(base: float = 0.5, platform: float = 0.3, height: float = 0.6) -> Mechanism:
    """The Stewart-Gough platform, 6-UPS: six legs of variable length under one plate, which has all six freedoms.

    It is drawn closed. Each leg is a universal joint at its foot, a slide along it, a spherical joint at its head.

    Raises ValueError for a length that is not positive.
    Source: Modern Robotics, example 2.8, figure 1.1(b) and 7.1.2; Gough (1956), Stewart (1965).

    >>> stewart_gough().kutzbach()
    6
    """
    _positive(base=base, platform=platform, height=height)
    joints = []
    for i in range(6):
        # Feet and heads stand in pairs, the pairs of the plate between those of the ground.
        foot = base * _turned(X, np.pi / 3 * (i + i % 2) - (0.2 if i % 2 else -0.2))
        head = platform * _turned(X, np.pi / 3 * (i + 1 - i % 2) + (0.2 if i % 2 else -0.2)) + height * Z
        along = (head - foot) / np.linalg.norm(head - foot)
        across = np.cross(Z, along) / np.linalg.norm(np.cross(Z, along))
        leg = f"{i + 1}"
        joints += [
            Joint(f"U{leg}", ("ground", f"shin {leg}"), universal(across, np.cross(along, across), foot), point=foot),
            Joint(f"P{leg}", (f"shin {leg}", f"shaft {leg}"), screw(along, pitch=SLIDE), point=(foot + head) / 2),
            Joint(f"S{leg}", (f"shaft {leg}", "plate"), spherical(head), point=head),
        ]
    return Mechanism(joints, name="Stewart-Gough platform", source="Modern Robotics, example 2.8")


def _planar_arm(foot: float, lengths: Sequence[float], names: Sequence[str]) -> Chain:
    """A planar arm stretched out along x, one turning joint a link; a name more than links is a pin at its tip."""
    _positive(**{f"length {i}": length for i, length in enumerate(lengths, start=1)})
    stations = foot + np.concatenate([[0.0], np.cumsum(lengths)])
    points = stations[: len(names), None] * X
    tip = _shift(stations[-1] * X)
    return Chain(np.array([screw(Z, p) for p in points]), tip, points, joint_names=tuple(names))


def _ring(links: Sequence[tuple[float, float]], name: str, source: str) -> Mechanism:
    """A closed ring of hinges without offsets, from the length and the twist of each link."""
    rows = [{"a": a, "alpha": alpha, "d": 0, "theta": "q"} for a, alpha in links]
    chain = DHTable(rows, convention="standard", name=name).to_chain()
    return Mechanism.from_chain(replace(chain, source=source))


def _shift(way: Array) -> Array:
    return pose(np.eye(3), way)


def _turned(direction: Array, angle: float) -> Array:
    """A direction, turned about z."""
    turned: Array = exp(angle * Z) @ direction
    return turned


def _positive(**lengths: float) -> None:
    for name, length in lengths.items():
        if not (np.isfinite(length) and length > 0):
            raise ValueError(
                f"{name} should be a length in metres, above 0; got {length!r}. Lengths have no direction."
            )
