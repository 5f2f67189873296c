"""Answers by hand to sheet 08: loop closure, assembly modes, Grashof's condition, dead points and degrees of freedom."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common.kinematics import logarithm, ordinary_forms, turn
from evidence.answers_by_hand.common.motions import Array, exp, product
from evidence.answers_by_hand.common.tables import SIGN
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP

MODE = "mode, other side, right of, left of, mirror"
BARS = "coupler, rocker, bar, length, " + SWAP


@wrong_answers("08.1")
def residual(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    S, G, degrees, inv = given.S, np.array(given.G), given.degrees, np.linalg.inv
    q = {name: np.radians(angle) for name, angle in degrees.items()}

    def of(order: str, q: dict[str, float] = q) -> Array:
        """The logarithm of a product: a capital is a joint, a small letter its inverse, G the offset."""
        factors = {"G": G, "g": inv(G)} | {name: exp(S[name], angle) for name, angle in q.items()}
        return logarithm(product(*(factors[n] if n in factors else inv(factors[n.upper()]) for n in order)))

    r = of("DCGba")
    T = product(*(exp(S[n], q[n]) for n in "DC"), G, inv(exp(S["B"], q["B"])), inv(exp(S["A"], q["A"])))
    added = q["D"] * S["D"] + q["C"] * S["C"] - q["B"] * S["B"] - q["A"] * S["A"]
    other_way = "negative of the residual, other branch, T_2^, order, revers, sign, invers"
    yield from wrong(
        {
            "second branch not inverted": (of("DCGAB"), "invert, invers, back"),
            "second branch not inverted, B first": (of("DCGBA"), "invert, invers, back"),
            "inverted, not reversed": (of("DCGab"), f"order, revers, {SWAP}"),
            "G left out": (of("DCba"), LEFT_OUT),
            "G inverted": (of("DCgba"), "invers, invert"),
            "G in front": (of("GDCba"), "order, front, place"),
            "G between D and C": (of("DGCba"), f"order, place, between, {SWAP}"),
            "C before D": (of("CDGba"), f"order, {SWAP}"),
            "T_2^-1 T_1": (of("gcdAB"), f"T_2, {other_way}"),
            "T_1^-1 T_2": (of("baDCG"), f"T_1, {other_way}, behind, front"),
            "the negative of the residual": (-r, other_way),
            "the way back, G left out": (of("ABcd"), f"{LEFT_OUT}, {other_way}"),
            "degrees": (of("DCGba", dict(degrees)), "degree, radian"),
            "halves swapped": (np.roll(r, 3), "(v, half, halves, omega, " + SWAP),
            "translation for v": (np.concatenate([r[:3], T[:3, 3]]), "log, translation, position"),
            "skew part of T - I": (
                np.concatenate([[T[2, 1], T[0, 2], T[1, 0]], T[:3, 3]]), "log, first order, small, T - I, entries"),
            "twists added": (added, "added, sum, one exponential, commut"),
            "the angle in degrees": (r * np.repeat((180 / np.pi, 1), 3), "degree, radian"),
            "B forgotten": (of("DCGa"), LEFT_OUT),
            "A forgotten": (of("DCGb"), LEFT_OUT),
            "C with the opposite sign": (of("DcGba"), f"{SIGN}, invert, invers"),
            "v negated": (r * np.repeat((1, -1), 3), SIGN),
            "not inverted, G left out": (of("DCAB"), f"invert, invers, {LEFT_OUT}"),
            "halves swapped, negative of the residual": (-np.roll(r, 3), f"(v, half, {other_way}, {SWAP}"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(r))


def _modes(bars: Any, A: float) -> list[tuple[float, float]]:
    """The angles of coupler and rocker from the x axis, (coupler, rocker), with C to the left and to the right of BD."""
    g, a, b, c = bars
    x, y = g - a * np.cos(A), -a * np.sin(A)
    distance, direction = np.hypot(x, y), np.arctan2(y, x)
    at_B = np.arccos((distance**2 + b**2 - c**2) / (2 * distance * b))
    at_D = np.arccos((distance**2 + c**2 - b**2) / (2 * distance * c))
    return [(direction + s * at_B, np.pi + direction - s * at_D) for s in (1, -1)]


@wrong_answers("08.2")
def both_modes(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    g, a, b, c = given.bars
    A = np.radians(given.degrees)
    (k1, D1), (k2, D2) = _modes((g, a, b, c), A)
    D = np.array([D1, D2])

    def rockers(bars: Any = given.bars, angle: float = A) -> Array:
        return np.array([rocker for _, rocker in _modes(bars, angle)])

    def maybe(make: Any, instead: Array) -> Array:
        """The angles of a loop that may not close with wrong lengths."""
        with np.errstate(invalid="ignore"):
            values: Array = make()
        return values if np.isfinite(values).all() else instead

    base = np.array([k1, k2]) - A
    yield from wrong(
        {
            "mirrored in the ground": ([D1, -D1], "mirror, ground line"),
            "the other one mirrored in the ground": ([-D2, D2], "mirror, ground line"),
            "both negated": (-D, f"{SIGN}, mirror"),
            "inner angles": (np.pi - D, "inner, supplement, \\pi, opposite sign"),
            "pi off": (D + np.pi, "half a turn, from D, opposite, C to D, \\pi, direction"),
            "crank from y": (rockers(angle=np.pi / 2 - A), "crank, y axis, sin, cos"),
            "crank below": (rockers(angle=-A), f"crank, {SIGN}, mirror"),
            "coupler and rocker swapped": (rockers((g, a, c, b)), BARS),
            "ground and crank swapped": (maybe(lambda: rockers((a, g, b, c)), D + 0.3), "ground, crank, " + BARS),
            "the coupler's angles": ([k1, k2], "coupler"),
            "B, the coupler from the crank": (base, "coupler"),
            "C, the coupler from the rocker": (np.array([k1 - D1, k2 - D2]), "coupler"),
            "degrees": (np.degrees(D), "degree, radian"),
            "crank's degrees as radians": (
                maybe(lambda: rockers(angle=float(given.degrees)), D + 0.5),
                "degree, radian",
            ),
            "one mode twice": ([D1, D1], f"twice, both, {MODE}"),
            "the other mode twice": ([D2, D2], f"twice, both, {MODE}"),
            "the second pi off": ([D1, D1 + np.pi], f"half a turn, \\pi, {MODE}"),
            "arcsine's other branch": ([D1, np.pi - D1], f"arcsin, arccos, supplement, \\pi, mirror, {MODE}"),
            "plus and minus the angle at D": ((D2 - D1) / 2 * np.array([1, -1]), "from the line DB"),
            "plus and minus the angle at B": ((k1 - k2) / 2 * np.array([1, -1]), "coupler"),
            "from the line BD": (D - np.arctan2(-a * np.sin(A), g - a * np.cos(A)), "BD, B to D, x axis"),
            "inner angles in degrees": (180 - np.degrees(D), "inner, degree, radian, supplement"),
            "coupler and rocker swapped, negated": (-rockers((g, a, c, b)), f"{BARS}, {SIGN}, mirror"),
            "the coupler's angles in degrees": (np.degrees([k1, k2]), "coupler, degree, radian"),
        }
    )
    yield from right({**ordinary_forms(D), "the other order": D[::-1], "between 0 and a turn": D % (2 * np.pi)})


@wrong_answers("08.3")
def coupler_point(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    g, a, b, c = given.bars
    A, p = np.radians(given.degrees), np.array([given.along, given.left])
    (angle, rocker), (other, _) = _modes((g, a, b, c), A)
    (swapped, _), _ = _modes((g, a, c, b), A)
    B = a * np.array([np.cos(A), np.sin(A)])

    def carried(angle: float, point: Any = p, start: Any = B) -> Array:
        return np.array(start + turn("z", angle)[:2, :2] @ point)

    P, along_y = carried(angle), np.array([p[0], -p[1]])
    yield from wrong(
        {
            "the other mode": (carried(other), MODE),
            "rotated by B alone": (carried(angle - A), "crank, relative, A + B"),
            "rotated by A": (carried(A), "crank, coupler"),
            "rotated by A twice": (carried(angle + A), "crank, coupler, twice"),
            "rotated by the rocker's angle": (carried(rocker), "rocker, coupler"),
            "not rotated": (B + p, "without rotating, rotat, coupler, along x"),
            "to the right": (carried(angle, along_y), f"left, right, {SIGN}"),
            "rotated in the opposite direction": (carried(-angle), f"opposite direction, {SIGN}, transpos, invers"),
            "from C": (carried(angle, (b - p[0], p[1])), "from C, measured"),
            "beyond C": (carried(angle, (b + p[0], p[1])), "from C, beyond"),
            "along and left swapped": (carried(angle, p[::-1]), f"{SWAP}, along, left"),
            "from A": (carried(angle, start=0 * B), f"from A, from B, origin, {LEFT_OUT}"),
            "from D": (carried(angle, start=(g, 0)), "from D, from B, position of D"),
            "seen from D": (P - (g, 0), "from D, from A, origin"),
            "only along the coupler": (carried(angle, (p[0], 0)), f"{LEFT_OUT}, only"),
            "only B": (B, LEFT_OUT),
            "x and y swapped": (P[::-1], f"{SWAP}, sin, cos"),
            "below": (P * (1, -1), f"{SIGN}, mirror, below"),
            "sine and cosine of the crank swapped": (carried(angle, start=B[::-1]), "sin, cos, y axis, crank"),
            "coupler and rocker swapped": (carried(swapped), BARS),
            "degrees": (carried(np.degrees(angle), start=a * np.array([np.cos(given.degrees), np.sin(given.degrees)])), "degree, radian"),
            "millimetres": (1000 * P, "millimet, mm, 1000, unit"),
            "other mode, to the right": (carried(other, along_y), f"{MODE}, left, right"),
            "rotated by B alone, to the right": (carried(angle - A, along_y), f"crank, relative, {SIGN}, right"),
            "other mode, not rotated": (carried(other - A), f"{MODE}, crank, relative, rotat"),
        }
    )  # fmt: skip
    yield from right({**ordinary_forms(P), "a tuple": tuple(P)})


@wrong_answers("08.4")
def slider(given: Any, answer: float) -> Iterator[WrongAnswer]:
    a, rod, e, A = given.crank, given.rod, given.offset, np.radians(given.degrees)

    def of(offset: float = e, angle: float = A, side: int = 1, crank: float = a, rod: float = rod) -> float:
        return float(crank * np.cos(angle) + side * np.sqrt(rod**2 - (offset - crank * np.sin(angle)) ** 2))

    x, flat = of(), np.sqrt(rod**2 - (e - a * np.sin(A)) ** 2)
    yield from wrong(
        {
            "slider left of B": (of(side=-1), MODE),
            "no offset": (of(0), "offset, through A"),
            "offset negated": (of(-e), f"offset, side, {SIGN}"),
            "rod along x": (a * np.cos(A) + rod, "rod, along x, height"),
            "rod and crank along x": (a + rod, "along x, stretched, dead"),
            "crank from y": (of(angle=np.pi / 2 - A), "y axis, sin, cos"),
            "degrees": (of(angle=given.degrees), "degree, radian"),
            "crank's half left out": (flat, f"from B, crank, {LEFT_OUT}"),
            "crank's half subtracted": (flat - a * np.cos(A), f"{SIGN}, crank"),
            "height of B left out": (a * np.cos(A) + np.sqrt(rod**2 - e**2), f"height, {LEFT_OUT}"),
            "offset subtracted at the end": (of(0) - e, "offset, end"),
            "Pythagoras with a plus": (a * np.cos(A) + np.hypot(rod, e - a * np.sin(A)), f"Pythag, root, {SIGN}"),
            "no square root": (a * np.cos(A) + rod**2 - (e - a * np.sin(A)) ** 2, "root, square"),
            "root not taken of the rod": (
                a * np.cos(A) + rod - abs(e - a * np.sin(A)),
                "root, square, Pythag, subtracted the difference of the heights",
            ),
            **(
                {"crank and rod swapped": (of(crank=rod, rod=a), f"{SWAP}, rod")}
                if a > abs(e - rod * np.sin(A))
                else {}
            ),
            "the slider's height": (e, "height, offset, along x"),
            "distance from A": (np.hypot(x, e), "distance, along x"),
            "negated": (-x, SIGN),
            "millimetres": (1000 * x, "millimet, mm, 1000, unit"),
            "slider left of B, no offset": (of(0, side=-1), f"{MODE}, offset"),
            "offset negated, crank from y": (of(-e, np.pi / 2 - A), f"offset, {SIGN}, y axis, sin, cos"),
            "slider left of B, offset negated": (of(-e, side=-1), f"{MODE}, offset, {SIGN}"),
        }
    )
    yield from right({"a float": x, "three decimals": round(x, 3), "an array": np.array(x)})


@wrong_answers("08.5")
def which_mode(given: Any, answer: str) -> Iterator[WrongAnswer]:
    right_D, right_C = given.options[answer]
    words = {}
    for letter, (D, C) in given.options.items():
        one = abs(D - right_D) < 0.2
        words[letter] = f"{SIGN}" if one else "inner" if abs(C - right_C) < 0.2 else MODE
    yield from other_letters(words, answer)


@wrong_answers("08.6")
def which_kind(given: Any, answer: str) -> Iterator[WrongAnswer]:
    yield from other_letters(dict.fromkeys("abcde", "shortest, longest, limit, sums"), answer)


@wrong_answers("08.7")
def dead_point(given: Any, answer: float) -> Iterator[WrongAnswer]:
    g, a, b, c = given.bars

    def arccos(cosine: float) -> float:
        """The angle, or NaN for a triangle that does not close."""
        return float(np.arccos(cosine)) if abs(cosine) <= 1 else np.nan

    def angle(one: float, two: float, opposite: float) -> float:
        return arccos((one**2 + two**2 - opposite**2) / (2 * one * two))

    A, place = angle(g, a, b + c), "angle at, triangle, opposite"
    bar = "bar, stretched, coupler, rocker, one line"
    answers = {
            "supplement": (np.pi - A, "supplement, \\pi, opposite sign"),
            "complement": (np.pi / 2 - A, "complement, sin, cos, right angle"),
            "angle at B": (angle(a, b + c, g), place),
            "angle at D": (angle(g, b + c, a), place),
            "coupler alone": (angle(g, a, b), bar),
            "rocker alone": (angle(g, a, c), bar),
            "folded": (angle(g, a, abs(b - c)), "folded, fold, difference"),
            "crank and coupler stretched": (angle(g, a + b, c), f"crank, {bar}"),
            "crank and rocker's lengths swapped": (angle(g, c, a + b), f"crank, {bar}, {SWAP}"),
            "negated": (-A, SIGN + ", mirror"),
            "half": (A / 2, "half"),
            "degrees": (np.degrees(A), "degree, radian"),
            "cosine": (np.cos(A), "cos, arccos, angle"),
            "arcsine": (np.arcsin(np.cos(A)), "sin, cos"),
            "no factor 2": (arccos(2 * np.cos(A)), "factor, law of cosines"),
            "right triangle": (arccos(g / (b + c)), "right angle, right-angled, Pythag, law of cosines"),
            "crank makes full turns": (np.pi, "full turn, \\pi"),
            "supplement in degrees": (180 - np.degrees(A), "supplement, degree, radian"),
            "angle at D in degrees": (np.degrees(angle(g, b + c, a)), f"{place}, degree, radian"),
            "supplement, folded": (np.pi - angle(g, a, abs(b - c)), "folded, fold, supplement"),
        }  # fmt: skip
    yield from wrong({name: case for name, case in answers.items() if np.isfinite(case[0])})
    yield from right({"a float": A, "three decimals": round(A, 3), "less a turn": A - 2 * np.pi})


@wrong_answers("08.8")
def counting(given: Any, answer: float) -> Iterator[WrongAnswer]:
    d, f = given.d, [f_i for leg in given.legs for f_i in leg]
    L, J, N = len(given.legs), len(f), 2 + sum(len(leg) - 1 for leg in given.legs)

    def of(d: int = d, N: int = N, J: int = J, total: int = sum(f)) -> int:
        return d * (N - 1 - J) + total

    count = "ground, platform, loop, count"
    wrong_ways = {
        "ground not counted": (of(N=N - 1), count),
        "N for N - 1": (of(N=N + 1), count + ", does not move"),
        "neither ground nor platform": (of(N=N - 2), count),
        "a loop for each leg": (sum(f) - d * L, count),
        "one loop only": (sum(f) - d, count),
        "the other d": (of(9 - d), f"d =, d = {9 - d}, plane, space"),
        "no loops": (sum(f), "loop, added"),
        "one degree of freedom for each joint": (of(total=J), "one degree of freedom, universal, spherical, freedom"),
        "one joint not counted": (of(J=J - 1, total=sum(f) - f[-1]), "joint, count"),
        "joints counted as bodies": (of(N=J), count),
        "constraints for degrees of freedom": (d * (N - 1) - sum(f), "constraint, freedom"),
        "one leg forgotten": (
            d * (N - len(given.legs[-1])) - d * (J - len(given.legs[-1])) + sum(f) - sum(given.legs[-1]),
            "leg",
        ),
        "negated": (-of(), SIGN),
        "never below zero": (max(of(), 0), "negative, below, sign, zero"),
        "platform's own d": (d, "platform, free"),
        "bodies only": (d * (N - 1), "joint, constraint"),
        "ground not counted, other d": (of(9 - d, N=N - 1), f"{count}, d =, plane, space"),
        "other d, one degree of freedom each": (of(9 - d, total=J), "d =, plane, space, universal, spherical"),
        "one too many": (of() + 1, "off by one, one too"),
    }
    identities = {
        "one degree of freedom for each joint",
        "one loop only",
        "never below zero",
        "negated",
    }  # right for some platforms
    yield from wrong({name: case for name, case in wrong_ways.items() if name not in identities or case[0] != of()})
    yield from right({"an integer": of(), "a float": float(of())})


@wrong_answers("08.9")
def three_mobilities(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    n, loops = given.joint_values, given.loops
    count, infinitesimal, finite = (int(x) for x in answer)
    rank = int(np.count_nonzero(np.array(given.singular_values) > 0))
    large = int(np.count_nonzero(np.array(given.singular_values) > 1))
    d = (n - count) // loops
    move = "finite, continued, does move"
    wrong_counts: dict[str, tuple[list[int], str]] = {
            "the count for all three": ([count] * 3, "count"),
            "the infinitesimal mobility for all three": ([infinitesimal] * 3, f"count, {move}"),
            "the finite mobility for all three": ([finite] * 3, f"infinitesimal, count, {move}"),
            "the rank for the infinitesimal mobility": ([count, rank, finite], "rank"),
            "other d": ([n - (9 - d) * loops, infinitesimal, finite], "d =, plane, space"),
            "no loops": ([n, infinitesimal, finite], "loop, count"),
            "one loop too many": ([n - d * (loops + 1), infinitesimal, finite], "loop, count"),
            "the other finite mobility": ([count, infinitesimal, 1 - finite], move),
            "the count for the finite mobility": ([count, infinitesimal, count], f"{move}, count"),
            "infinitesimal and finite swapped": ([count, finite, infinitesimal], f"{move}, infinitesimal, {SWAP}"),
            "in reverse": ([finite, infinitesimal, count], f"order, count, {SWAP}"),
            "count negated": ([-count, infinitesimal, finite], f"{SIGN}, count"),
            "count at least 0": ([max(count, 0), infinitesimal, finite], "negative, below, count"),
            "singular values below 1 as zero": ([count, n - large, finite], "singular, infinitesimal, rank"),
            "infinitesimal mobility one too many": ([count, infinitesimal + 1, finite], "infinitesimal, singular, rank"),
            "equations minus joints": ([d * loops - n, infinitesimal, finite], f"{SIGN}, count, equation"),
            "equations minus rank": ([count, d * loops - rank, finite], "infinitesimal, equation, rank, columns"),
            "other d, and the rank": ([n - (9 - d) * loops, rank, finite], "d =, plane, space, rank"),
            "the rank, and the other finite mobility": ([count, rank, 1 - finite], f"rank, {move}"),
            "no loops, and the other finite mobility": ([n, infinitesimal, 1 - finite], f"loop, count, {move}"),
        }  # fmt: skip
    yield from wrong({name: case for name, case in wrong_counts.items() if case[0] != [count, infinitesimal, finite]})
    right_counts = [count, infinitesimal, finite]
    yield from right({"a list of integers": right_counts, "a tuple": tuple(right_counts)})
