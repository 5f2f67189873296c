"""A whole URDF: the poses of all its links, chains from any link to any other, and mimic joints."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.formatting import aligned_table, html_table
from kinlib.arrays.validation import Array, JointValues, TakesLimitedValues, suggest_name
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import exp, inverse, moved_screw
from kinlib.urdf.links_and_joints import MOVING_TYPES, Coupling, UrdfJoint, followed, read_tree
from kinlib.urdf.xml_elements import Element, read_robot

HEADINGS = ["link", "joint", "type", "value"]

MOVED_BY_POSES = ("planar", "floating")
"""The joints that do not move by a single value."""


@dataclass(frozen=True, eq=False)
class Tree(TakesLimitedValues):
    """All links and joints of a URDF, read once by `from_urdf`.

    name           of the robot
    link_elements  the elements of the links, by name
    parent_joints  for the name of each link but the root, the joint whose child it is, in the order of the file
    folder         where its file is, if it was read from one: `kl.show` looks there for meshes

    q has the values of the n independent joints, in the order of the file, or it is a mapping from their names to their values.
    A mimic joint has no value of its own, because it follows another joint: q_mimic = multiplier q_other + offset. Planar and
    floating joints have no single value: see `poses`.

    >>> tree = Tree.from_urdf('''<robot name="gripper"> <link name="palm"/> <link name="left"/> <link name="right"/>
    ...   <joint name="open" type="continuous"> <parent link="palm"/> <child link="left"/> </joint>
    ...   <joint name="follow" type="continuous"> <parent link="palm"/> <child link="right"/> <mimic joint="open"/> </joint>
    ... </robot>''')
    >>> print(tree)
    gripper, 3 links, 1 independent joint
    link    | joint  | type       | value
    palm    |        |            |
      left  | open   | continuous | q1
      right | follow | continuous | open
    >>> tree.tips, tree.joint_names, tree.couplings["follow"]
    (('left', 'right'), ('open',), Coupling(joint='open', multiplier=1.0, offset=0.0))
    """

    name: str
    link_elements: Mapping[str, Element] = field(default_factory=dict, repr=False)
    parent_joints: Mapping[str, UrdfJoint] = field(default_factory=dict, repr=False)
    folder: Path | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        if not self.link_elements:
            raise ValueError("A tree must have at least one link; got none. Try Tree.from_urdf(file), or its text.")

    @classmethod
    def from_urdf(cls, path_or_text: str | os.PathLike[str]) -> Tree:
        """Read a URDF from the path of a file, or from its text, which begins with <.

        Raises ValueError, with the element and its line, as kl.load_urdf does.
        """
        robot = read_robot(path_or_text)
        is_text = isinstance(path_or_text, str) and path_or_text.lstrip("\ufeff \t\r\n").startswith("<")
        folder = None if is_text else Path(path_or_text).parent
        return cls(robot.text("name"), *read_tree(robot), folder)

    def __repr__(self) -> str:
        types = [self._moving_joints[name].type for name in self.joint_names]
        return f"Tree({self._title}: {', '.join(types)})" if types else f"Tree({self._title})"

    def __str__(self) -> str:
        """Write the links below each other, each with the joint above it and the value of this joint."""
        return "\n".join([self._title, aligned_table([HEADINGS, *self._rows("  ")])])

    def _repr_html_(self) -> str:
        return html_table(self._title, HEADINGS, list(self._rows("\xa0" * 4)))

    @property
    def _title(self) -> str:
        count = len(self.links)
        return f"{self.name}, {count} link{'s'[: count != 1]}, {self.n} independent joint{'s'[: self.n != 1]}"

    def _rows(self, indent: str) -> Iterator[list[str]]:
        values = {name: f"q{i}" for i, name in enumerate(self.joint_names, start=1)}
        for depth, link, _ in self._descendants(self.root):
            if (joint := self.parent_joints.get(link)) is None:
                yield [link, "", "", ""]
            else:
                value = joint.mimic or values.get(joint.name, "a pose" if joint.moves else "")
                yield [indent * depth + link, joint.name, joint.type, str(value)]

    @property
    def root(self) -> str:
        """The link that is not the child of a joint."""
        return next(link for link in self.links if link not in self.parent_joints)

    @property
    def links(self) -> tuple[str, ...]:
        """The names of all links, in the order of the file."""
        return tuple(self.link_elements)

    @cached_property
    def tips(self) -> tuple[str, ...]:
        """The links without a child that move relative to the root, such as the tool of each arm."""
        return tuple(self._tips(self.root))

    @cached_property
    def joint_names(self) -> tuple[str, ...]:
        """The n names of the independent joints, in the order of q: [positions[name] for name in tree.joint_names]."""
        return tuple(name for name, joint in self._moving_joints.items() if joint.mimic is None)

    @property
    def n(self) -> int:
        """The number of independent joints."""
        return len(self.joint_names)

    @cached_property
    def limits(self) -> Array:
        """The lower and the upper limit (n, 2) of each independent joint, infinite where it has none."""
        limits = [self._moving_joints[name].limits for name in self.joint_names]
        return validation.read_only_copy(np.reshape(limits, (-1, 2)))

    @cached_property
    def couplings(self) -> dict[str, Coupling]:
        """For each joint that moves by one value, the independent joint that it follows: itself, if it mimics no other."""
        return {name: followed(joint, self._moving_joints) for name, joint in self._moving_joints.items()}

    @cached_property
    def _moving_joints(self) -> dict[str, UrdfJoint]:
        return {joint.name: joint for joint in self.parent_joints.values() if joint.type in MOVING_TYPES}

    def poses(self, q: JointValues, joint_poses: Mapping[str, ArrayLike] | None = None) -> dict[str, Array]:
        """Compute the pose of every link, each in the link's own frame, as tf in ROS gives them.

        q (..., n) of the independent joints, in radians and metres -> (..., 4, 4) for each link, in the frame of the root:
        T_child = T_parent O e^[A]q, with the origin O and the axis A of the joint between the two links.

        joint_poses  for the name of each planar and each floating joint, its motion (..., 4, 4): the pose of the child link in
                     the frame of the joint

        Raises ValueError for a planar or a floating joint without a pose, and if a mimic joint follows no joint that moves, or itself.
        Source: the URDF specification, "joint"; Modern Robotics, 4.2.

        >>> tree = Tree.from_urdf(kl.to_urdf(kl.robots.youbot()))
        >>> np.allclose(tree.poses(np.zeros((10, 5)))["tool"], kl.robots.youbot().home)
        True
        """
        q = self.in_order(q)
        values = dict(zip(self.joint_names, np.moveaxis(q, -1, 0), strict=True))
        motions = self._validate_joint_poses(joint_poses or {})
        for name, (driver, multiplier, offset) in self.couplings.items():
            motions[name] = exp(self._moving_joints[name].screw * (multiplier * values[driver][..., None] + offset))
        shape = np.broadcast_shapes(q.shape[:-1], *(T.shape[:-2] for T in motions.values()))
        found = {self.root: np.broadcast_to(np.eye(4), (*shape, 4, 4)).copy()}
        for _, link, _ in self._descendants(self.root):
            if joint := self.parent_joints.get(link):
                found[link] = found[joint.parent] @ (joint.origin @ motions.get(joint.name, np.eye(4)))
        return {link: found[link] for link in self.links}

    def chain(self, base: str | None = None, tip: str | None = None) -> Chain:
        """Build a chain from the joints on the path from one link to another: base, tip and errors are those of `kl.load_urdf`.

        >>> Tree.from_urdf(kl.to_urdf(kl.robots.youbot())).chain(base="link_4", tip="link_2").joint_names
        ('joint_4', 'joint_3')
        """
        base = self.root if base is None else base
        tip = self.default_tip(base) if tip is None else tip
        T, screws, points, moving = np.eye(4), [], [], {}
        for joint, sign in self.path(base, tip):
            if joint.type in MOVED_BY_POSES:
                raise joint.element.error(
                    f"a joint between base and tip must have one degree of freedom; this one is {joint.type}. Choose a base beyond it, "
                    f"such as {joint.child}, or use kl.Tree.from_urdf(...).poses(q, joint_poses=...)."
                )
            # The axis is given in the joint frame: the frame after this joint if the path goes down, and before it if it goes up.
            if sign > 0:
                T = T @ joint.origin
            if joint.moves:
                # Only the joints of the path: a faulty mimic joint elsewhere does not affect this chain.
                moving[joint] = _, multiplier, offset = followed(joint, self._moving_joints)
                # Where the independent joints are 0, a mimic joint has the value of its offset.
                T = T @ exp(sign * offset * joint.screw)
                screws.append(sign * multiplier * moved_screw(T, joint.screw))
                points.append(T[:3, 3])
            if sign < 0:
                T = T @ inverse(joint.origin)
        if not moving:
            raise self.link_elements[tip].error(f"a joint must move between {base} and {tip}; none does.")
        drivers = [driver for driver, _, _ in moving.values()]
        for joint, (driver, multiplier, _) in moving.items():
            if joint.mimic and (drivers.count(driver) > 1 or abs(multiplier) != 1):
                raise joint.element.error(
                    f"the joints of a chain must move independently; joint {joint.name} mimics joint {driver}, multiplied by "
                    f"{multiplier:g}. Compute with kl.Tree.from_urdf(...).poses(q), or pass other links as base or tip."
                )
        limits = np.array([self._moving_joints[driver].limits for driver in drivers])
        return Chain(
            *(np.array(screws), T, np.array(points), self.name, f"URDF, from {base} to {tip}"),
            limits=limits if np.isfinite(limits).any() else None,
            joint_names=tuple(drivers),
        )

    def path(self, base: str, tip: str) -> list[tuple[UrdfJoint, int]]:
        """Find the joints from one link to another: up to their nearest common ancestor, and down from it.

        Each joint is given with its direction: +1 from parent to child, -1 from child to parent.

        >>> text = '''<robot name="rig"> <link name="table"/> <link name="post"/> <link name="camera"/>
        ...     <joint name="at_rear" type="fixed"> <parent link="table"/> <child link="post"/> </joint>
        ...     <joint name="on_top" type="fixed"> <parent link="post"/> <child link="camera"/> </joint> </robot>'''
        >>> [(joint.name, sign) for joint, sign in Tree.from_urdf(text).path("camera", "table")]
        [('on_top', -1), ('at_rear', -1)]
        """
        up, down = (self._ancestors(self._checked(link, name)) for link, name in ((base, "base"), (tip, "tip")))
        while up and down and up[-1] is down[-1]:
            up.pop()
            down.pop()
        return [*((joint, -1) for joint in up), *((joint, +1) for joint in reversed(down))]

    def _checked(self, link: str, argument: str) -> str:
        """The link, if it is one; argument: its name, for the message."""
        if link not in self.link_elements:
            hint = suggest_name(link, self.links, "links")
            raise ValueError(f"{argument} must be the name of a link; got {link!r}.{hint}")
        return link

    def _ancestors(self, link: str) -> list[UrdfJoint]:
        """The joints from a link up to the root."""
        joints = []
        while joint := self.parent_joints.get(link):
            joints.append(joint)
            link = joint.parent
        return joints

    @cached_property
    def _below(self) -> dict[str, list[UrdfJoint]]:
        """The joints below each link that has any."""
        found: dict[str, list[UrdfJoint]] = {}
        for joint in self.parent_joints.values():
            found.setdefault(joint.parent, []).append(joint)
        return found

    def _descendants(self, base: str) -> Iterator[tuple[int, str, bool]]:
        """Yield the base and every link below it, depth first: its depth, its name, and whether it moves relative to the base."""
        stack = [(0, base, False)]
        while stack:
            depth, link, moves = stack.pop()
            yield depth, link, moves
            stack += [(depth + 1, joint.child, moves or joint.moves) for joint in reversed(self._below.get(link, []))]

    def _tips(self, base: str) -> list[str]:
        """The links below a base that have no child and move relative to it: the possible ends of an arm on this base."""
        return [link for _, link, moves in self._descendants(base) if moves and link not in self._below]

    def default_tip(self, base: str | None = None) -> str:
        """Find the end of the arm on a base: the fingers of a gripper at its end do not belong to it.

        The way goes on where several joints follow if one of them leads to twice as many independent joints as each other one. It
        ends where fewer joints follow than are behind. Of several links that are fixed there, tool0 is taken, which is the flange
        in ROS, otherwise one with tool in its name, the last one before the fingers, or the first end in the file.

        Raises ValueError with the possible ends if the tree divides in another way.

        >>> joints = [("turn", "base", "arm"), ("open", "arm", "left"), ("follow", "arm", "right")]
        >>> text = "".join(f"<link name='{child}'/><joint name='{name}' type='continuous'><parent link='{parent}'/>"
        ...                f"<child link='{child}'/></joint>" for name, parent, child in [("lift", "bolt", "base"), *joints])
        >>> Tree.from_urdf(f"<robot name='crane'><link name='bolt'/>{text}</robot>").default_tip()
        'arm'
        """
        base = self._checked(self.root if base is None else base, "base")
        tips, link, behind = self._tips(base), base, 0
        if len(tips) == 1:
            return tips[0]
        below = self._below
        # For each link below the base, the joints on the longest way from the joint above it to an end.
        independent, moving = dict[str, int](), dict[str, int]()
        for _, name, _ in reversed([*self._descendants(base)][1:]):
            joint, joints = self.parent_joints[name], below.get(name, [])
            independent[name] = joint.is_independent + max((independent[each.child] for each in joints), default=0)
            moving[name] = joint.moves + max((moving[each.child] for each in joints), default=0)
        while tips:
            body = [name for _, name, moves in self._descendants(link) if not moves]
            ways = [joint for name in body for joint in below.get(name, []) if joint.moves]
            ways.sort(key=lambda joint: independent[joint.child], reverse=True)
            if link != base and (not ways or (len(ways) > 1 and independent[ways[0].child] < behind)):
                ends = [joint.parent for joint in ways] or [name for name in body if name not in below]
                return next((name for name in ["tool0", *ends] if name in body and "tool" in name), ends[0])
            if len(ways) > 1 and independent[ways[0].child] < 2 * max(moving[joint.child] for joint in ways[1:]):
                break
            behind, link = behind + ways[0].is_independent, ways[0].child
        choices = "Choose a base with a moving joint below it." if self.n else "No joint of the file has a value."
        if tips:
            counts = [sum(joint.moves for joint, _ in self.path(base, tip)) for tip in tips]
            named = (f"{tip} ({count} joint{'s'[: count != 1]})" for tip, count in zip(tips, counts, strict=True))
            choices = f"Choose the tip, one of {', '.join(named)}."
        raise self.link_elements[base].error(
            f"exactly one end of the tree must move relative to this base; got {len(tips)}. {choices}"
        )

    def _validate_joint_poses(self, given: Mapping[str, ArrayLike]) -> dict[str, Array]:
        needed = [joint.name for joint in self.parent_joints.values() if joint.type in MOVED_BY_POSES]
        if set(given) != set(needed):
            raise ValueError(
                f"joint_poses must have a pose for each planar and each floating joint of {self.name}: "
                f"{', '.join(needed) or 'it has none'}; got {', '.join(map(str, given)) or 'none'}. "
                "For a joint that is not displaced, pass np.eye(4)."
            )
        return {name: validation.poses(T, f"joint_poses[{name!r}]") for name, T in given.items()}
