"""Letters and orders: the answers that are not numbers. Each wrong one is the choice of something else."""

# fmt: off
import re
from typing import Any

import numpy as np

from outside import Kinds, kinds_of
from outside.motions import at, chain, exp, pose, product, rpy_matrix

ORDER = "order|revers|swap|exchang|wrong place|first|last|front|behind|$M$|alphabet|names|listed|statement"


def rotations(g: Any) -> list[str]:
    """The factors of 01.7: what turns about {s} comes to the left, what turns about an own axis to the right."""
    order: list[str] = []
    for name, in_the_room in zip(g.turns, g.about_the_room, strict=True):
        order = [name, *order] if in_the_room else [*order, name]
    return order


def from_the_floor(g: Any) -> list[str]:
    """The exponentials of 03.6 and the home pose."""
    above = {below: name for name, below in g.rides_on.items()}
    order, link = [], "floor"
    while link in above:
        link = above[link]
        order.append(f"e_{link}")
    return [*order, "M"]


def around_home(g: Any) -> list[str]:
    """The factors of 04.3: the screws that were read in {s} stand to the left of the home pose."""
    e, k = [f"e_{name}" for name in g.from_floor_to_tool], len(g.read_in_s)
    return [*e[:k], "M", *e[k:]]


def rigid_or_not(g: Any) -> tuple[str, float]:
    """The condition of 01.8 that fails, and a number that shows it."""
    T = np.asarray(g.matrix)
    products = T[:3, :3].T @ T[:3, :3]
    fails = {
        "e": not np.allclose(T[3], [0, 0, 0, 1]), "b": not np.allclose(np.diag(products), 1),
        "c": not np.allclose(products, np.diag(np.diag(products))), "d": np.linalg.det(T[:3, :3]) < 0,
    }
    letter = next((letter for letter, fault in fails.items() if fault), "a")
    lengths, dots = np.linalg.norm(T[:3, :3], axis=0), [products[0, 1], products[0, 2], products[1, 2]]
    shows = {"e": float(T[3] @ T[3]), "b": max(lengths, key=lambda x: abs(x - 1)), "c": max(dots, key=abs)}
    return letter, shows.get(letter, T[1, 0] * T[2, 1] - T[2, 0] * T[1, 1])


def row_of(T: Any, convention: str) -> list[float]:
    """The numbers a, alpha, d, theta of a link."""
    R, p = T[:3, :3], T[:3, 3]
    if convention == "standard":
        theta = np.arctan2(R[1, 0], R[0, 0])
        return [p @ [np.cos(theta), np.sin(theta), 0], np.arctan2(R[2, 1], R[2, 2]), p[2], theta]
    alpha = np.arctan2(-R[1, 2], R[2, 2])
    return [p[0], alpha, p @ [0, -np.sin(alpha), np.cos(alpha)], np.arctan2(-R[0, 1], R[0, 0])]


def faulty_entry(g: Any) -> tuple[str, float]:
    """The entry of 05.5 that does not fit the frames, and what it should be."""
    F, convention = np.asarray(g.frames), getattr(g, "convention", "standard")
    links = [product(np.linalg.inv(F[i]), F[i + 1]) for i in range(len(g.rows))]
    off = np.array([row_of(T, convention) for T in links]) - g.rows
    off[:, 1::2] = 2 * np.sin(off[:, 1::2] / 2)
    i, k = np.unravel_index(int(np.argmax(np.abs(off))), off.shape)
    return f"{('a', 'alpha', 'd', 'theta')[k]}{i + 1}", row_of(links[i], convention)[k]


def convention_of(g: Any) -> tuple[str, Any]:
    """The letter of 06.5, and where the two conventions put the tool along x."""
    poses = [chain(at(g.rows, "RR", g.q), name) for name in ("standard", "modified")]
    fits = [np.allclose(T, g.pose, atol=1e-3) for T in poses]
    letter = {(True, False): "a", (False, True): "b", (True, True): "c"}.get((fits[0], fits[1]), "d")
    return letter, np.array([T[0, 3] for T in poses])


def broken_rule(g: Any) -> tuple[str, float]:
    """The letter of 07.5, and a number that shows it."""
    i, F = g.frame, np.asarray(g.frames)
    before, x, z, origin = F[i - 1][:3, 2], F[i][:3, 0], F[i][:3, 2], F[i][:3, 3]
    axis, step = np.asarray(g.screws)[i][:3], origin - F[i - 1][:3, 3]
    broken = {
        "a": abs(x @ before) > 1e-9, "c": np.abs(np.cross(z, axis)).max() > 1e-9,
        "d": np.abs(np.cross(origin - g.points[i], axis)).max() > 1e-9, "b": abs(step @ np.cross(x, before)) > 1e-9,
    }
    letter = next((letter for letter, is_broken in broken.items() if is_broken), "e")
    off = origin - g.points[i]
    shows = {
        "a": x @ before, "b": abs(step @ np.cross(x, before)), "c": z @ axis, "d": np.sqrt(max(0, off @ off - (off @ axis) ** 2)),
    }
    return letter, shows.get(letter, step @ before)


def same_arm(g: Any) -> tuple[str, str]:
    """The letter of 07.7, the table that moves as the given one does, and the entry of another one without a partner."""
    q = np.linspace(0.3, 1.7, len(g.table))
    T = chain(at(g.table, "R" * len(q), q), "standard")
    poses = {letter: chain(at(rows, "R" * len(q), q), "standard") for letter, rows in g.tables.items()}
    right = next(letter for letter, X in poses.items() if np.allclose(X, T, atol=1e-6))
    rows = np.array(g.tables[g.spoiled])
    for i, k in np.argwhere(rows[:, :3]):
        mended = rows.copy()
        mended[i, k] *= -1
        if np.allclose(chain(at(mended, "R" * len(q), q), "standard"), T, atol=1e-6):
            return str(right), f"{('a', 'alpha', 'd')[k]}{i + 1}"
    raise AssertionError


def grashof(g: Any) -> tuple[str, float]:
    """The letter of 08.2, and the sum of the shortest and the longest bar."""
    short, p, q, long = sorted(g.bars)
    if abs(short + long - p - q) < 1e-9:
        return "e", short + long
    return "d" if short + long > p + q else "bacx"[list(g.bars).index(short)], short + long


def path_through_a_tree(g: Any) -> list[str]:
    """The joints of 09.2: up from the base to a common link, and down to the tip."""
    found = re.findall(r'<joint name="(\w+)" type="(\w+)">\s*<parent link="(\w+)"/> <child link="(\w+)"/>', g.urdf)
    above = {child: (parent, [name] * (kind != "fixed")) for name, kind, parent, child in found}

    def to_the_root(link: str) -> dict[str, list[str]]:
        """Each link on the way up, with the joints that move between it and the one below."""
        way: dict[str, list[str]] = {link: []}
        while link in above:
            link, joint = above[link]
            way[link] = joint
        return way

    up, down = to_the_root(g.base), to_the_root(g.tip)
    while len(up) > 1 and len(down) > 1 and list(up)[-2] == list(down)[-2]:
        up.popitem(), down.popitem()
    return [joint for way in (*up.values(), *reversed(down.values())) for joint in way]


def one_of_four(g: Any) -> tuple[str, float]:
    """The letter of 10.3, the report that agrees with no other, and how far away it puts the tool."""
    reports = {"a": g.T_sb, "b": np.linalg.inv(g.T_bs), "c": pose(rpy_matrix(g.rpy), g.xyz), "d": exp(g.twist)}
    k = max(reports, key=lambda k: float(np.median([np.abs(reports[k] - T).max() for T in reports.values()])))
    right = reports["b" if k == "a" else "a"]
    return k, float(np.linalg.norm((reports[k] - right)[:3, 3]))


def shared_orders(X: list[str]) -> Kinds:
    """Return the wrong orders that fit every problem."""
    made: Kinds = {
        "reversed the list": (X[::-1], ORDER), "sorted by the alphabet": (sorted(X), ORDER),
        "put the first one last": ([*X[1:], X[0]], ORDER), "put the last one first": ([X[-1], *X[:-1]], ORDER),
    }
    return made | {f"swapped factors {k + 1} and {k + 2}": ([*X[:k], X[k + 1], X[k], *X[k + 2:]], ORDER) for k in range(len(X) - 1)}


@kinds_of("01.7")
def wrong_rotations(g: Any, X: list[str]) -> Kinds:
    names = list(g.turns)
    ours = [name for name, about in zip(names, g.about_the_room, strict=True) if about]
    own = [name for name in names if name not in ours]
    orders = {
        "wrote them in the order of time": names, "multiplied each from the left": names[::-1], "put own axes first": own + ours,
        "put fixed axes first, in the order of time": ours + own, "reversed both groups": own[::-1] + ours,
        "reversed own axes": ours[::-1] + own[::-1], "put own axes first, fixed axes reversed": own + ours[::-1],
    }
    return {label: (order, ORDER) for label, order in orders.items()}


@kinds_of("03.6", "04.3")
def wrong_factors(g: Any, X: list[str]) -> Kinds:
    e = [name for name in X if name != "M"]
    listed = [f"e_{name}" for name in (g.rides_on if hasattr(g, "rides_on") else g.from_floor_to_tool)]
    k = X.index("M")
    orders = {
        "put M first": ["M", *e], "put M last": [*e, "M"], "put M in the middle": [*e[:2], "M", *e[2:]],
        "put M first and reversed": ["M", *e[::-1]], "put M last and reversed": [*e[::-1], "M"],
        "wrote them as listed": [*listed, "M"], "wrote them as listed, reversed": [*listed[::-1], "M"],
        "sorted the joints": [*sorted(e[:k]), "M", *sorted(e[k:])], "swapped the sides of M": [*e[k:], "M", *e[:k]],
        "reversed both sides of M": [*e[:k][::-1], "M", *e[k:][::-1]], "reversed the right side": [*e[:k], "M", *e[k:][::-1]],
        "put M one joint late": [*e[:k + 1], "M", *e[k + 1:]], "put M one joint early": [*e[:k - 1], "M", *e[k - 1:]],
    }
    return {label: (order, ORDER) for label, order in orders.items()}


LETTERS = {
    "01.8": {"a": "not a rigid motion", "b": "unit vectors", "c": "orthogonal", "d": "left-handed", "e": "0 0 0 1"},
    "06.5": {"a": "standard", "b": "modified", "c": "both|same pose", "d": "neither|at least one"},
    "07.5": dict.fromkeys("abcd", "obeys") | {"e": "breaks a rule"},
    "07.7": dict.fromkeys("abcd", "sign|reversed|moved"),
    "08.2": dict.fromkeys("abcde", "shortest|longest"),
    "10.3": {"a": "space screws", "b": "body screws", "c": "table", "d": "file"},
    "10.8": {k: f"joint {k}" for k in "1234"},
    "10.10": {k: f"You answered {k}" for k in "ABCD"},
}
"""For a problem each letter that may be chosen, and the words by which feedback may speak of it."""


def _letters(number: str) -> Any:
    def wrong(g: Any, X: Any) -> Kinds:
        made: Kinds = {f"chose {letter}": ((letter, X[1]), words) for letter, words in LETTERS[number].items() if letter != X[0]}
        if not isinstance(X[1], str) and np.any(X[1]):
            made["chose it without a reason"] = ((X[0], 0 * np.asarray(X[1])), "is 0|placeholder")
        return made

    return wrong


for problem in LETTERS:
    kinds_of(problem)(_letters(problem))


@kinds_of("05.5")
def other_entries(g: Any, X: Any) -> Kinds:
    rows = range(1, len(g.rows) + 1)
    return {f"chose {k}{i}": ((f"{k}{i}", X[1]), "row|column|agrees|fits") for k in ("a", "alpha", "d", "theta") for i in rows if f"{k}{i}" != X[0]} | {
        "gave the printed value": ((X[0], g.rows[int(X[0][-1]) - 1][("a", "alpha", "d", "theta").index(X[0][:-1])]), "-")
    }


@kinds_of("09.2")
def other_paths(g: Any, X: list[str]) -> Kinds:
    inwards, outwards = X[:2], X[2:]
    paths = {"from the root to both hands": [*inwards[::-1], *outwards], "only from the root to the tip": outwards,
             "the way back": X[::-1], "only to the base": inwards}
    return {f"listed {label}": (path, "root|file|reversed|torso|base|missing") for label, path in paths.items()}
