"""What a URDF says of motion: links, joints between them, and the tree that they make.

Every joint is read and checked, also where nobody will look: a file with a fault is a faulty file. Each refusal names
the element and its line.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.rpy import origin
from kinlib.urdf.xml import Element

MOVING = ("revolute", "continuous", "prismatic")
TYPES = (*MOVING, "fixed", "planar", "floating")

SHORTEST = 1e-6
"""An axis shorter than this is zero with rounding errors, not a direction."""

FARTHEST = 1e6
"""The farthest origin, in metres: beyond it a pose keeps no tenth of a nanometre, and a file has slipped its units."""

STEEPEST = 4 * np.pi
"""The largest angle of an origin, in radians, as for DH tables: 90 is a right angle in degrees, and not in radians."""

ENDLESS = float(np.finfo(float).max)
"""URDF has no word for a slide without an end: its largest number stands for it."""


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint of the file: what moves, between which links, where and how far.

    origin   (4, 4)  its frame in the frame of the parent link; the child link rides on it, and stands there at q = 0
    axis     (3,)    in its own frame, of unit length; zero where the type has none
    limits           least and greatest value
    element          where the file says so
    """

    element: Element
    name: str
    type: str
    parent: str
    child: str
    origin: Array
    axis: Array
    limits: tuple[float, float]

    @property
    def moves(self) -> bool:
        """Whether it is more than a weld."""
        return self.type != "fixed"


class Step(NamedTuple):
    """A joint of a path: sign 1 from parent to child, -1 from child to parent."""

    joint: Joint
    sign: int


@dataclass(frozen=True, eq=False)
class Tree:
    """The links by name, and for each link but the root the joint above it. As text it is the tree, drawn.

    >>> from kinlib.urdf.xml import read_robot
    >>> text = '''<robot name="crane"><link name="ground"/><link name="mast"/>
    ...   <joint name="slew" type="continuous"><parent link="ground"/><child link="mast"/></joint></robot>'''
    >>> print(read_tree(read_robot(text)))
    ground
      slew (continuous): mast
    """

    links: Mapping[str, Element]
    above: Mapping[str, Joint]

    @property
    def root(self) -> str:
        """The link that hangs on no joint."""
        return next(link for link in self.links if link not in self.above)

    def path(self, base: str, tip: str) -> Sequence[Step]:
        """The joints from one link to another: up to where their ways meet, and down."""
        up, down = self._ancestors(base), self._ancestors(tip)
        shared = {joint.name for joint in up} & {joint.name for joint in down}
        return [
            *(Step(joint, -1) for joint in up if joint.name not in shared),
            *(Step(joint, +1) for joint in reversed(down) if joint.name not in shared),
        ]

    def tips(self, base: str) -> Sequence[str]:
        """The ends of the tree that a joint moves against the base: what an arm that stands on it can end in."""
        parents = {joint.parent for joint in self.above.values()}
        return [link for _, link, moved in self._walk(base) if moved and link not in parents]

    def known(self, link: str, asked_for: str) -> str:
        """Pass on the name of a link. Raises ValueError for any other, with the nearest one."""
        if link not in self.links:
            raise ValueError(f"{asked_for} should be a link; there is none called {link!r}.{meant(link, self.links)}")
        return link

    def _ancestors(self, link: str) -> Sequence[Joint]:
        """The joints from a link up to the root."""
        way = []
        while link in self.above:
            way.append(self.above[link])
            link = self.above[link].parent
        return way

    def _walk(self, base: str) -> Iterator[tuple[int, str, bool]]:
        """Every link from one on down: how deep it hangs, its name, and whether a joint moves it against the first."""
        below: dict[str, list[Joint]] = {}
        for joint in self.above.values():
            below.setdefault(joint.parent, []).append(joint)
        waiting = [(0, base, False)]
        while waiting:
            depth, link, moved = waiting.pop()
            yield depth, link, moved
            waiting += [(depth + 1, joint.child, moved or joint.moves) for joint in reversed(below.get(link, []))]

    def __str__(self) -> str:
        lines = [self.root]
        for depth, link, _ in self._walk(self.root):
            if depth:
                joint = self.above[link]
                lines.append(f"{'  ' * depth}{joint.name} ({joint.type}): {link}")
        return "\n".join(lines)


def read_tree(robot: Element) -> Tree:
    """Read the links and the joints of a <robot>, and check that they make one tree.

    Raises ValueError, with element and line: a name twice, a link that is missing, with two parents or without a joint,
    links in a circle, and whatever a joint says that cannot be.
    Source: the URDF specification, "link" and "joint".
    """
    links: dict[str, Element] = {}
    for element in robot.children:
        if element.tag == "link":
            if (name := element.word("name")) in links:
                raise element.refusal(f"the link in line {links[name].line} has this name already.")
            links[name] = element
    if not links:
        raise robot.refusal("it has no <link>: a robot is links, held together by joints.")
    lines: dict[str, int] = {}
    above: dict[str, Joint] = {}
    for element in robot.children:
        if element.tag == "joint":
            joint = _joint(element, links)
            if joint.name in lines:
                raise element.refusal(f"the joint in line {lines[joint.name]} has this name already.")
            if (other := above.get(joint.child)) is not None:
                raise next(end for end in element.children if end.tag == "child").refusal(
                    f"link {joint.child} hangs on joint {other.name} of line {other.element.line} already. A URDF is a "
                    "tree: a link with two parents closes a loop, and no URDF holds one."
                )
            lines[joint.name], above[joint.child] = element.line, joint
    _check_one_tree(links, above)
    return Tree(links, above)


def meant(name: str, links: Mapping[str, Element]) -> str:
    """Say which link a wrong name may stand for.

    >>> meant("bsae", {"base": Element("link", 1, {}), "tool": Element("link", 2, {})})
    ' Did you mean base?'
    """
    from difflib import get_close_matches

    if close := get_close_matches(name, links, n=1):
        return f" Did you mean {close[0]}?"
    return f" The links are {', '.join(list(links)[:12])}{', ...' if len(links) > 12 else '.'}"


def _joint(element: Element, links: Mapping[str, Element]) -> Joint:
    name, kind = element.word("name"), element.word("type")
    if kind not in TYPES:
        raise element.refusal(f'type="{kind}" is none of {", ".join(TYPES)}.')
    parent, child = (_end(element, tag, links) for tag in ("parent", "child"))
    axis = _axis(element) if kind in MOVING else np.zeros(3)
    limits = _limits(element, kind) if kind in {"revolute", "prismatic"} else (-np.inf, np.inf)
    return Joint(element, name, kind, parent, child, _origin(element), axis, limits)


def _end(joint: Element, tag: str, links: Mapping[str, Element]) -> str:
    if (end := joint.only(tag)) is None:
        raise joint.refusal(f"it has no <{tag} link=...>: a joint joins two links.")
    if (link := end.word("link")) not in links:
        name = joint.attributes["name"]
        raise end.refusal(f'joint {name} names link "{link}", and there is none.{meant(link, links)}')
    return link


def _origin(joint: Element) -> Array:
    if (element := joint.only("origin")) is None:
        return np.eye(4)
    bounds = {"xyz": (FARTHEST, "m", "metres"), "rpy": (STEEPEST, "rad", "radians, not degrees")}
    values = {name: element.numbers(name, 3) for name in bounds if name in element.attributes}
    for name, numbers in values.items():
        most, unit, units = bounds[name]
        if (worst := max(numbers, key=abs)) and abs(worst) > most:
            raise element.refusal(f"{name} holds {worst:g} {unit}. URDF writes {units}.")
    return origin(**values)


def _axis(joint: Element) -> Array:
    if (element := joint.only("axis")) is None:
        # So says the specification; who leaves the axis out often expects z.
        return np.array([1.0, 0.0, 0.0])
    axis = np.array(element.numbers("xyz", 3))
    if (largest := np.abs(axis).max()) < SHORTEST:
        raise element.refusal("xyz is zero, and zero points nowhere. A joint that does not move is of type fixed.")
    axis /= largest
    unit: Array = axis / np.linalg.norm(axis)
    return unit


def _limits(joint: Element, kind: str) -> tuple[float, float]:
    if (element := joint.only("limit")) is None:
        remedy = "One that turns without end is continuous." if kind == "revolute" else "How far does it slide?"
        raise joint.refusal(f"a {kind} joint needs its <limit lower=... upper=...>. {remedy}")
    lower, upper = (element.numbers(name, 1)[0] if name in element.attributes else 0.0 for name in ("lower", "upper"))
    if lower > upper:
        raise element.refusal(f"lower is {lower:g} and upper is {upper:g}. Are they exchanged?")
    return (lower if lower > -ENDLESS else -np.inf), (upper if upper < ENDLESS else np.inf)


def _check_one_tree(links: Mapping[str, Element], above: Mapping[str, Joint]) -> None:
    roots = [link for link in links if link not in above]
    if len(roots) > 1:
        others = ", ".join([roots[0], *roots[2:12]])
        raise links[roots[1]].refusal(
            f"no joint holds it, and none holds {others}. A tree has one root: which joint is missing?"
        )
    # A link is held if the way up from it ends at the root, and not in a circle.
    held = set(roots)
    for start in links:
        link, way = start, dict[str, None]()
        while link not in held and link not in way:
            way[link] = None
            link = above[link].parent
        if link in way:
            circle = list(way)[list(way).index(link) :]
            raise above[link].element.refusal(
                f"from child to parent the links go round in a circle: {', '.join(circle[:12])}."
            )
        held.update(way)
