"""Answers by hand to sheet 03."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from kincourse.census import WrongAnswer, right, wrong, wrong_answers
from kincourse.census.motions import I3, I4, Ad, exp, negated, negated_one, parts, pose, product, series, swapped, twist

inv = np.linalg.inv


def _halves(S: Any) -> Any:
    return np.roll(S, 3, axis=-1)


@wrong_answers("03.1")
def plain_arm(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    d, p, slide = np.asarray(given.axes), np.asarray(given.points), np.array([[kind == "P"] for kind in given.letters])
    zero, moment = 0 * d, np.cross(p, d)

    def rows(w: Any = d, v: Any = moment, sw: Any = zero, sv: Any = d) -> Any:
        """Screws (w, v) of revolute joints, and (sw, sv) of prismatic ones."""
        return np.where(slide, np.hstack([sw, sv]), np.hstack([w, v]))

    S, k = rows(), int(np.argmin(slide))
    yield from wrong(
        {
            "omega x p": (rows(v=-moment), "\\times, sign, minus"),
            "halves swapped": (_halves(S), "swap, halves, (v"),
            "halves swapped in the revolute rows": (rows(moment, d), "swap, halves, (v"),
            "point as moment": (rows(v=p), "point, moment"),
            "-p as moment": (rows(v=-p), "point, moment"),
            "no moment": (rows(v=zero), "moment, left out, missing, origin"),
            "slide as turn": (rows(sw=d, sv=moment), "slide, prismatic"),
            "slide's direction in omega": (rows(sw=d, sv=zero), "slide, prismatic, swap, direction, \\omega"),
            "slide's direction twice": (rows(sw=d, sv=d), "slide, prismatic"),
            "moment of a slide": (rows(sv=moment), "slide, prismatic"),
            "point of a slide": (rows(sv=p), "slide, prismatic, point"),
            "no slide": (rows(sv=zero), "slide, prismatic, zero, left out"),
            "slide backwards": (rows(sv=-d), "slide, sign, opposite"),
            "points of the next joint": (rows(v=np.cross(np.roll(p, -1, axis=0), d)), "point, joint, row"),
            "last joint first": (S[::-1], "order, revers, row"),
            "rows 1 and 2 swapped": (swapped(S, 0, 1), "order, swap, row"),
            "one axis the other way": (S * np.where(np.arange(3) == k, -1, 1)[:, None], "sign, opposite"),
            "one omega the other way, moment kept": (
                S * np.array([[-1] * 3 + [1] * 3 if i == k else [1] * 6 for i in range(3)]),
                "sign, opposite, omega, minus",
            ),
            "one sign of a moment": (negated(S, (k, 3 + int(np.argmax(np.abs(moment[k]))))), "sign"),
            "moment entry by entry": (rows(v=d * p), "entry by entry, elementwise"),
            "middle sign of the cross product": (rows(v=moment * (1, -1, 1)), "sign, cross product"),
            "omega x p, slide as turn": (rows(v=-moment, sw=d, sv=-moment), "\\times, sign, slide"),
            "omega x p, halves swapped": (_halves(rows(v=-moment)), "\\times, sign, swap, halves"),
            "point as moment, slide's direction in omega": (rows(v=p, sw=d, sv=zero), "point, slide, prismatic, swap"),
        }
    )
    yield from right({"integers": S.astype(int), "list": S.tolist(), "-omega x p": rows(v=-np.cross(d, p))})


@wrong_answers("03.2")
def angled_joint(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    u, t, p = np.asarray(given.from_axis), np.asarray(given.towards), np.asarray(given.point)
    angle = np.radians(given.degrees)
    other = np.abs(np.cross(u, t))

    def line(c: float, s: float, u: Any = u, t: Any = t) -> tuple[Any, Any]:
        return c * u + s * t, np.cross(p, c * u + s * t)

    c, s = np.cos(angle), np.sin(angle)
    w, v = line(c, s)
    yield from wrong(
        {
            "sine and cosine swapped": ([*np.ravel(line(s, c))], "swap, sine and cosine"),
            "away": ([*np.ravel(line(c, -s))], "other way, away, sign, opposite"),
            "degrees": ([*np.ravel(line(np.cos(given.degrees), np.sin(given.degrees)))], "degrees, radians"),
            "(1, tan)": ([*np.ravel(line(1, s / c))], "length, unit, norm"),
            "(1, 1)": ([*np.ravel(line(1, 1))], "length, unit, norm, angle"),
            "omega x p": ([*w, *-v], "\\times, sign, minus"),
            "halves swapped": ([*v, *w], "swap, halves, (v"),
            "point as moment": ([*w, *p], "point, moment"),
            "no moment": ([*w, 0, 0, 0], "moment, left out, missing, origin"),
            "not tilted": ([*np.ravel(line(1, 0))], "tilt, angle, lean"),
            "moment of the axis that is not tilted": ([*w, *np.cross(p, u)], "tilt, angle, moment"),
            "as a slide": ([0, 0, 0, *w], "slide, prismatic, \\omega"),
            "-S": ([*-w, *-v], "opposite, sign, other way"),
            "-omega, moment kept": ([*-w, *v], "sign, opposite, \\times, minus"),
            "towards the third axis": ([*np.ravel(line(c, s, u, other))], "axis, towards, lean"),
            "from the third axis": ([*np.ravel(line(c, s, other, t))], "axis, from, lean"),
            "half the angle": ([*np.ravel(line(np.cos(angle / 2), np.sin(angle / 2)))], "half"),
            "twice the angle": ([*np.ravel(line(np.cos(2 * angle), np.sin(2 * angle)))], "double, twice"),
            "one sign of v": ([*w, *negated_one(v)], "sign"),
            "middle sign of the cross product": ([*w, *v * (1, -1, 1)], "sign, cross product"),
            "moment entry by entry": ([*w, *w * p], "entry by entry, elementwise"),
            "swapped and omega x p": (
                [*np.ravel(line(s, c)) * ([1] * 3 + [-1] * 3)],
                "swap, sine and cosine, \\times, sign",
            ),
            "away and omega x p": ([*np.ravel(line(c, -s)) * ([1] * 3 + [-1] * 3)], "away, other way, sign, \\times"),
            "degrees and omega x p": (
                [*np.ravel(line(np.cos(given.degrees), np.sin(given.degrees))) * ([1] * 3 + [-1] * 3)],
                "degrees, \\times, sign",
            ),
        }
    )
    yield from right(
        {
            "list": [*w, *v],
            "three decimals": np.round([*w, *v], 3),
            "another point of the axis": [*w, *np.cross(p + 2 * w, w)],
        }
    )


@wrong_answers("03.3")
def leaning_slide(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    n, p = np.asarray(given.direction, dtype=float), np.asarray(given.point)
    size = np.linalg.norm(n)
    d, zero = n / size, np.zeros(3)
    yield from wrong(
        {
            "direction in omega": ([*d, *zero], "\\omega, turn, swap"),
            "direction in omega, not divided": ([*n, *zero], "\\omega, turn, swap, length, unit"),
            "as a turn": ([*d, *np.cross(p, d)], "turn, revolute"),
            "as a turn, omega x p": ([*d, *np.cross(d, p)], "turn, revolute, sign, \\times"),
            "as a turn, not divided": ([*n, *np.cross(p, n)], "turn, revolute, length, unit"),
            "not divided": ([*zero, *n], "length, unit, norm"),
            "divided by the sum": ([*zero, *n / np.abs(n).sum()], "length, unit, norm, sum"),
            "divided by the square": ([*zero, *n / size**2], "length, unit, norm, root, square"),
            "divided by the largest": ([*zero, *n / np.abs(n).max()], "length, unit, norm, largest"),
            "moment as v": ([*zero, *np.cross(p, d)], "moment, point"),
            "omega x p as v": ([*zero, *np.cross(d, p)], "moment, point"),
            "the point as v": ([*zero, *p], "point"),
            "direction in both": ([*d, *d], "\\omega, turn, both"),
            "point as moment": ([*d, *p], "\\omega, turn, point"),
            "-d": ([*zero, *-d], "sign, opposite"),
            "one sign": ([*zero, *negated_one(d)], "sign"),
            "sizes only": ([*zero, *np.abs(d)], "sign"),
            "components rotated": ([*zero, *np.roll(d, 1)], "order, swap, place"),
            "to the point": ([*zero, *p / np.linalg.norm(p)], "point, direction"),
            "-d in omega": ([*-d, *zero], "\\omega, turn, swap, sign"),
        }
        | ({"zero": (np.zeros(6), "zero, direction")})
    )
    yield from right(
        {"list": [0, 0, 0, *d], "three decimals": np.round([*zero, *d], 3), "array": np.concatenate([zero, n]) / size}
    )


@wrong_answers("03.4")
def helical_joint(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    w, p, lead = np.asarray(given.axis), np.asarray(given.point), given.lead
    m, h = np.cross(p, w), lead / (2 * np.pi)
    zero = 0 * w
    yield from wrong(
        {
            "lead for pitch": ([*w, *m + lead * w], "pitch, lead, 2\\pi"),
            "lead times 2 pi": ([*w, *m + 2 * np.pi * lead * w], "pitch, lead, 2\\pi, multipl"),
            "lead / pi": ([*w, *m + lead / np.pi * w], "pi, lead, pitch"),
            "lead / 360": ([*w, *m + lead / 360 * w], "360, degrees, lead, pitch"),
            "no climb": ([*w, *m], "climb, pitch"),
            "no moment": ([*w, *h * w], "moment, left out, missing"),
            "left-handed": ([*w, *m - h * w], "sign, left-handed, wrong way"),
            "omega x p": ([*w, *-m + h * w], "\\times, sign, minus"),
            "-v": ([*w, *-m - h * w], "\\times, sign, minus"),
            "halves swapped": ([*m + h * w, *w], "swap, halves, (v"),
            "point as moment": ([*w, *p + h * w], "point, moment"),
            "pitch along the point": ([*w, *m + h * p], "pitch, point, axis"),
            "pitch added to each entry": ([*w, *m + h], "pitch, axis, each"),
            "omega times the pitch": ([*h * w, *m], "pitch, \\omega"),
            "as a slide": ([*zero, *w], "slide, prismatic, turn"),
            "as a slide by the pitch": ([*zero, *h * w], "slide, prismatic, turn"),
            "-S": ([*-w, *-m - h * w], "opposite, sign, other way"),
            "axis the other way, climb kept": ([*-w, *-m + h * w], "opposite, sign, other way, left-handed"),
            "one sign of the moment": ([*w, *negated_one(m) + h * w], "sign"),
            "omega x p, lead for pitch": ([*w, *-m + lead * w], "\\times, sign, lead, pitch"),
            "omega x p, no climb": ([*w, *-m], "\\times, sign, climb, pitch"),
            "halves swapped, lead for pitch": ([*m + lead * w, *w], "swap, halves, lead, pitch"),
        }
    )
    yield from right(
        {
            "list": [*w, *m + h * w],
            "three decimals": np.round([*w, *m + h * w], 3),
            "-omega x p + h omega": np.concatenate([w, -np.cross(w, p) + h * w]),
        }
    )


@wrong_answers("03.5")
def from_a_drawing(given: Any, S: Any) -> Iterator[WrongAnswer]:
    w, v = np.array(S[:3]), np.array(S[3:])
    p = np.cross(w, v)
    k = int(np.argmax(np.abs(w)))
    i, j = (k + 1) % 3, (k + 2) % 3
    yield from wrong(
        {
            "-S": (-np.array(S), "opposite, sign, other way"),
            "omega x p": ([*w, *-v], "\\times, sign, minus"),
            "-omega, moment kept": ([*-w, *v], "opposite, sign, \\times, minus"),
            "halves swapped": ([*v, *w], "swap, halves, (v"),
            "point as moment": ([*w, *p], "point, moment"),
            "no moment": ([*w, 0, 0, 0], "moment, left out, missing, origin"),
            "as a slide": ([0, 0, 0, *w], "slide, prismatic, \\omega"),
            "another axis, moment kept": ([*np.roll(w, 1), *v], "axis, omega"),
            "another axis": ([*np.roll(w, 1), *np.cross(p, np.roll(w, 1))], "axis"),
            "two coordinates swapped": ([*w, *np.cross(swapped(p, i, j), w)], "swap"),
            "one sign of the point": ([*w, *np.cross(negated_one(p), w)], "sign"),
            "point one metre off": ([*w, *np.cross(p + I3[i], w)], "coordinate, point, metre, close"),
            "a coordinate read as zero": ([*w, *np.cross(p * (I3[i] + I3[k]), w)], "coordinate, point, zero, left out"),
            "entries of v swapped": ([*w, *swapped(v, i, j)], "swap, order"),
            "moment entry by entry": ([*w, *w * p], "entry by entry, elementwise, moment"),
            "moment along the axis": ([*w, *v + w], "moment, axis, perpendicular"),
            "-S and halves swapped": ([*-v, *-w], "opposite, sign, swap, halves"),
            "omega x p and halves swapped": ([*-v, *w], "\\times, sign, swap, halves"),
            "omega x p, two coordinates swapped": ([*w, *-np.cross(swapped(p, i, j), w)], "\\times, sign, swap"),
        }
    )
    yield from right({"integers": np.round(S).astype(int), "list": [float(x) for x in S], "tuple": tuple(np.round(S))})


@wrong_answers("03.6")
def which_order(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    e, told = list(answer[:4]), [f"e_{name}" for name in given.rides_on]
    yield from wrong(
        {
            label: (order, words)
            for label, order, words in [
                ("reversed", [*e[::-1], "M"], "tool, revers, last"),
                ("home first", ["M", *e], "M"),
                ("all reversed", ["M", *e[::-1]], "revers, right, order, act"),
                ("by the alphabet", [*sorted(e), "M"], "names, alphabet"),
                ("as listed", [*told, "M"], "listed, told, statement"),
                ("as listed, reversed", [*told[::-1], "M"], "listed, told, statement, revers"),
                ("first two swapped", [e[1], e[0], *e[2:], "M"], "swap, e_"),
                ("last two swapped", [*e[:2], e[3], e[2], "M"], "swap, e_"),
                ("middle two swapped", [e[0], e[2], e[1], e[3], "M"], "swap, e_"),
                ("M in the middle", [*e[:2], "M", *e[2:]], "M"),
                ("M before the last joint", [*e[:3], "M", e[3]], "M, swap"),
                ("floor joint last", [*e[1:], e[0], "M"], "floor, base, e_, last"),
                ("tool joint first", [e[3], *e[:3], "M"], "tool, e_, first"),
                ("alphabet, home first", ["M", *sorted(e)], "names, alphabet, M"),
            ]
            if order != answer
        }
    )
    yield from right({"tuple": tuple(answer), "list": list(answer)})


@wrong_answers("03.7")
def where_is_the_tool(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    S, M = np.asarray(given.screws), np.asarray(given.home)
    slide = ~S[:, :3].any(axis=1)
    other_sign = S * np.array([1, 1, 1, -1, -1, -1])
    moments = np.where(slide[:, None], S, other_sign)

    def e(q: Any, S: Any = S) -> Any:
        return [exp(S[i], q[i]) for i in range(3)]

    def all_of(q: Any, S: Any = S, M: Any = M) -> Any:
        return product(*e(q, S), M)

    functions: dict[str, tuple[Any, str]] = {
        "reversed": (lambda q: product(*e(q)[::-1], M), "revers, last, order"),
        "home first": (lambda q: product(M, *e(q)), "M, front, first"),
        "home first, reversed": (lambda q: product(M, *e(q)[::-1]), "M, front, revers, order"),
        "no M": (lambda q: product(*e(q)), "M, left out"),
        "stays at home": (lambda _: M, "home"),
        "entry by entry": (lambda q: e(q)[0] * e(q)[1] * e(q)[2] * M, "entry by entry, elementwise"),
        "sum of the exponentials": (lambda q: sum(e(q)) @ M, "sum, add"),
        "exponential of the sum": (lambda q: exp(q @ S) @ M, "sum, add, one exponential"),
        "-q": (lambda q: all_of(-np.asarray(q)), "sign, other way, opposite"),
        "np.radians": (lambda q: all_of(np.radians(q)), "degrees, radians"),
        "np.degrees": (lambda q: all_of(np.degrees(q)), "degrees, radians"),
        "joint 1 left out": (lambda q: product(*e(q)[1:], M), "left out, joint 1, first"),
        "joint 3 left out": (lambda q: product(*e(q)[:2], M), "left out, joint 3, last"),
        "joints 1 and 2 swapped": (lambda q: product(e(q)[1], e(q)[0], e(q)[2], M), "swap, order"),
        "joints 2 and 3 swapped": (lambda q: product(e(q)[0], e(q)[2], e(q)[1], M), "swap, order"),
        "M inverted": (lambda q: all_of(q, M=inv(M)), "inver"),
        "inverse of T": (lambda q: inv(all_of(q)), "inver"),
        "R^T in M": (lambda q: all_of(q, M=pose(M[:3, :3].T, M[:3, 3])), "transpos"),
        "halves swapped": (lambda q: all_of(q, _halves(S)), "swap, halves"),
        "moments negated": (lambda q: all_of(q, moments), "sign, moment"),
        "I + [S] q": (lambda q: product(*(I4 + twist(S[i]) * q[i] for i in range(3)), M), "series, term, trunc"),
        "three terms": (
            lambda q: product(*(series(twist(S[i]) * q[i], 3) for i in range(3)), M),
            "series, term, trunc",
        ),
        "reversed, no M": (lambda q: product(*e(q)[::-1]), "revers, order, M, left out"),
        "home first, np.radians": (lambda q: product(M, *e(np.radians(q))), "M, degrees, radians"),
        "reversed, -q": (lambda q: product(*e(-np.asarray(q))[::-1], M), "revers, order, sign, opposite, inver"),
    }
    if slide.any():
        functions["slide's direction in omega"] = (
            lambda q: all_of(q, np.where(slide[:, None], _halves(S), S)),
            "slide, prismatic, halves",
        )
        functions["np.degrees but for the slide"] = (
            lambda q: all_of(np.where(slide, q, np.degrees(q))),
            "degrees, radians",
        )
        functions["slide left out"] = (lambda q: all_of(np.where(slide, 0, q)), "slide, prismatic, left out")
    yield from wrong(functions)
    yield from right(
        {
            "function": all_of,
            "list of lists": lambda q: all_of(q).tolist(),
            "body form": lambda q: product(M, *(exp(Ad(inv(M)) @ S[i], q[i]) for i in range(3))),
        }
    )


@wrong_answers("03.8")
def longer_tool(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    S, M, L, q = np.asarray(given.screws), np.asarray(given.home), given.longer, np.asarray(given.q)
    slide = ~S[:, :3].any(axis=1)

    def e(q: Any = q) -> Any:
        return [exp(S[i], q[i]) for i in range(4)]

    def along(x: float, y: float, z: float) -> Any:
        return pose(I3, np.array([x, y, z]) * L)

    X = along(0, 0, 1)
    T = product(*e(), M, X)
    R, p = parts(T)
    degrees = np.where(slide, q, np.radians(q))
    yield from wrong(
        {
            "old tool": (product(*e(), M), "old tool, left out, longer"),
            "extended in {s}, after the motion": (X @ product(*e(), M), "{s}, left, side"),
            "extended in {s}, at home": (product(*e(), X, M), "{s}, left, side, order"),
            "tool shortened": (product(*e(), M, inv(X)), "sign, short, inver"),
            "along x of the tool": (product(*e(), M, along(1, 0, 0)), "axis, x"),
            "along y of the tool": (product(*e(), M, along(0, 1, 0)), "axis, y"),
            "extended twice": (product(*e(), M, X, X), "twice"),
            "length added to p_z": (pose(R, product(*e(), M)[:3, 3] + [0, 0, L]), "{s}, left, added"),
            "screws moved too": (product(*(exp(Ad(X) @ S[i], q[i]) for i in range(4)), M, X), "screw"),
            "reversed": (product(*e()[::-1], M, X), "revers, last, order"),
            "home first": (product(M, X, *e()), "front, M"),
            "reversed, old tool": (product(*e()[::-1], M), "revers, last, order, old"),
            "home first, old tool": (product(M, *e()), "front, M, old"),
            "reversed, extended in {s}": (product(X, *e()[::-1], M), "revers, last, order, {s}"),
            "np.radians": (product(*e(np.radians(q)), M, X), "degrees, radians"),
            "np.radians of the angles": (product(*e(degrees), M, X), "degrees, radians"),
            "np.degrees": (product(*e(np.degrees(q)), M, X), "degrees, radians"),
            "-q": (product(*e(-q), M, X), "sign, other way, opposite"),
            "one q negated": (product(*e(negated(q, 1)), M, X), "sign"),
            "no M": (product(*e(), X), "M, left out"),
            "slide left out": (product(*e(np.where(slide, 0, q)), M, X), "slide, left out, prismatic, joint 3"),
            "entry by entry": (e()[0] * e()[1] * e()[2] * e()[3] * M, "entry by entry, elementwise"),
            "home pose": (M @ X, "home, q"),
            "inverse": (inv(T), "inver"),
            "R transposed": (pose(R.T, p), "transpos"),
        }
    )
    yield from right({"three decimals": T.round(3), "list": T.tolist(), "T M^-1 M'": product(*e(), M, inv(M), M @ X)})
