"""The kinematic part of a URDF: links, the joints between them, and the tree that they form.

Every joint of the file is read and checked, also those that are not between base and tip. Each error message gives the
element and its line.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array, suggest_name
from kinlib.rigid.rpy import origin
from kinlib.rigid.screw import screw
from kinlib.urdf.xml_elements import Element

MOVING_TYPES = ("revolute", "continuous", "prismatic")
JOINT_TYPES = (*MOVING_TYPES, "fixed", "planar", "floating")

MAX_NUMBER = float(np.finfo(float).max)
"""URDF has no prismatic joint without limits, so this largest number is written for an infinite limit, and read as one."""


class Coupling(NamedTuple):
    """How the value of a joint follows from the value of another one: multiplier times its value, plus offset."""

    joint: str
    multiplier: float
    offset: float

    def __str__(self) -> str:
        factor = {1.0: "", -1.0: "-"}.get(self.multiplier, f"{format_number(self.multiplier)} ")
        offset = f" {'-' if self.offset < 0 else '+'} {format_number(abs(self.offset))}" if self.offset else ""
        return f"{factor}{self.joint}{offset}"


@dataclass(frozen=True, eq=False)
class UrdfJoint:
    """A joint of the file.

    element        of the file that describes it
    name, type     as in the file
    parent, child  the names of the links that it joins
    origin (4, 4)  its frame relative to the frame of the parent link, and the frame of the child link at q = 0
    axis   (3,)    in its own frame, of unit length; zero if a joint of this type has no axis
    limits         the lower and the upper limit, infinite if the type has none
    mimic          how it follows another joint; None for an independent joint
    """

    element: Element
    name: str
    type: str
    parent: str
    child: str
    origin: Array
    axis: Array
    limits: tuple[float, float]
    mimic: Coupling | None

    @property
    def moves(self) -> bool:
        """Whether it is of any other type than fixed."""
        return self.type != "fixed"

    @property
    def is_independent(self) -> bool:
        """Whether it moves, and follows no other joint."""
        return self.moves and self.mimic is None

    @property
    def screw(self) -> Array:
        """The screw axis (6,) in its own frame of a revolute, continuous or prismatic joint."""
        return screw(self.axis, pitch=np.inf if self.type == "prismatic" else 0.0)


def read_tree(robot: Element) -> tuple[dict[str, Element], dict[str, UrdfJoint]]:
    """Read the links and the joints of a <robot>, and check that they form one tree.

    Returns the elements of the links by name, and for the name of each link but the root the joint whose child it is.

    Raises ValueError, with element and line, if a name occurs twice, if a link is missing, has two parents or is not connected,
    if links form a cycle, and if an attribute of a joint is not valid.
    Source: the URDF specification, "link" and "joint".
    """
    if not (links := _by_name(robot, "link")):
        raise robot.error("it must have at least one <link>; it has none.")
    parent_joints: dict[str, UrdfJoint] = {}
    for element in _by_name(robot, "joint").values():
        joint = _joint(element, links)
        if (other := parent_joints.get(joint.child)) is not None:
            child = element.child("child") or element
            raise child.error(
                f"link {joint.child} is already the child of {other.name} in line {other.element.line}; a URDF must have no loops."
            )
        parent_joints[joint.child] = joint
    roots = [link for link in links if link not in parent_joints]
    connected, found = set[str](), set(roots[:1])
    while found:
        connected |= found
        found = {child for child, joint in parent_joints.items() if joint.parent in found} - connected
    if missing := [link for link in links if link not in connected]:
        raise links[missing[0]].error(
            "the links must form one tree, from one root that is not the child of a joint; from "
            f"{roots[0] if roots else 'no link'} no joint leads to {', '.join(missing[:12])}. Which joint is missing, or in a circle?"
        )
    return links, parent_joints


def _by_name(robot: Element, tag: str) -> dict[str, Element]:
    """The elements with a tag, by their names, which must be different."""
    found: dict[str, Element] = {}
    for element in (child for child in robot.children if child.tag == tag):
        if (name := element.text("name")) in found:
            raise element.error(f"the names of {tag}s must be different; line {found[name].line} has the same name.")
        found[name] = element
    return found


def followed(joint: UrdfJoint, joints: Mapping[str, UrdfJoint]) -> Coupling:
    """Find the independent joint that a joint follows, over any number of mimic joints: itself if it mimics no other.

    Raises ValueError, with element and line, if a mimic joint follows no joint that moves, or itself.
    """
    slope, shift = 1.0, 0.0
    for _ in range(len(joints)):
        if joint.mimic is None:
            return Coupling(joint.name, slope, shift)
        other, multiplier, offset = joint.mimic
        if other not in joints:
            hint = suggest_name(other, tuple(joints), "joints that move")
            raise joint.element.error(f"it must mimic a joint that moves; got {other!r}.{hint}")
        slope, shift, joint = slope * multiplier, shift + slope * offset, joints[other]
    raise joint.element.error("joints must not mimic each other in a circle.")


def _joint(element: Element, links: Mapping[str, Element]) -> UrdfJoint:
    name, kind = element.text("name"), element.text("type")
    if kind not in JOINT_TYPES:
        raise element.error(f'type must be one of {", ".join(JOINT_TYPES)}; got "{kind}".')
    parent, child = (_end(element, tag, links) for tag in ("parent", "child"))
    axis = _axis(element) if kind in (*MOVING_TYPES, "planar") else np.zeros(3)
    limits = _limits(element, kind) if kind in {"revolute", "prismatic"} else (-np.inf, np.inf)
    origin, axis = map(validation.read_only_copy, (origin_of(element), axis))
    return UrdfJoint(element, name, kind, parent, child, origin, axis, limits, _mimic(element, kind))


def _end(joint: Element, tag: str, links: Mapping[str, Element]) -> str:
    if (end := joint.child(tag)) is None:
        raise joint.error(f"it must have a <{tag} link=...>, because a joint joins two links; it has none.")
    if (link := end.text("link")) not in links:
        hint = suggest_name(link, tuple(links), "links")
        raise end.error(f'joint {joint.attributes["name"]} must join links; there is no link "{link}".{hint}')
    return link


def origin_of(parent: Element) -> Array:
    """Return the pose (4, 4) in the <origin> of a joint or a visual. Raises ValueError, with element and line, if it is not valid."""
    if (element := parent.child("origin")) is None:
        return np.eye(4)
    xyz, rpy = (element.numbers(name, 3, default=[0.0] * 3) for name in ("xyz", "rpy"))
    if abs(largest := max(rpy, key=abs)) > 4 * np.pi:
        raise element.error(f"rpy must be between -4 pi and 4 pi rad; got {largest:g} rad. Is it in degrees?")
    return origin(xyz, rpy)


def _axis(joint: Element) -> Array:
    if (element := joint.child("axis")) is None:
        # This is the default in the specification, although users who leave the axis out often expect z.
        return np.array([1.0, 0.0, 0.0])
    axis = np.array(element.numbers("xyz", 3))
    if np.abs(axis).max() < 1e-6:  # zero up to rounding errors
        raise element.error("xyz must be a direction; got zero. A joint that does not move has the type fixed.")
    return np.asarray(axis / np.linalg.norm(axis))


def _limits(joint: Element, kind: str) -> tuple[float, float]:
    if (element := joint.child("limit")) is None:
        raise joint.error(f"a {kind} joint must have a <limit lower=... upper=...>; it has none. Is it continuous?")
    lower, upper = (element.numbers(name, 1, default=[0.0])[0] for name in ("lower", "upper"))
    if lower > upper:
        raise element.error(f"lower must be at most upper; got {lower:g} and {upper:g}. Are they interchanged?")
    return (lower if lower > -MAX_NUMBER else -np.inf), (upper if upper < MAX_NUMBER else np.inf)


def _mimic(joint: Element, kind: str) -> Coupling | None:
    # A fixed joint has no value that could follow another one. urdfdom and Pinocchio ignore its <mimic>, too.
    if kind not in MOVING_TYPES or (element := joint.child("mimic")) is None:
        return None
    multiplier, offset = element.numbers("multiplier", 1, default=[1.0]), element.numbers("offset", 1, default=[0.0])
    return Coupling(element.text("joint"), *multiplier, *offset)
