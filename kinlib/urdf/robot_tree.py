"""A whole URDF: the poses of all its links, chains from any link to any other, and mimic joints.

A mimic joint has no value of its own, because it follows another joint: q_mimic = multiplier q_other + offset. So q has only the
values of the independent joints, and those of all moving joints follow from it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.formatting import aligned_table, format_number, html_table
from kinlib.arrays.validation import Array, JointValues, TakesLimitedValues, suggest_name
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import exp, inverse, moved_screw
from kinlib.urdf.links_and_joints import MOVING_TYPES, Coupling, UrdfJoint, followed, read_tree
from kinlib.urdf.xml_elements import Element, read_robot

HEADINGS = ["link", "joint", "type", "value"]

MOVED_BY_POSES = ("planar", "floating")
"""The joints that do not move by a single value."""


class PathStep(NamedTuple):
    """A joint of a path, and its direction: sign +1 from parent to child, -1 from child to parent."""

    joint: UrdfJoint
    sign: int


@dataclass(frozen=True, eq=False)
class Tree(TakesLimitedValues):
    """All links and joints of a URDF, read once by `from_urdf`.

    name           of the robot
    link_elements  the elements of the links, by name
    parent_joints  for the name of each link but the root, the joint whose child it is, in the order of the file
    folder         where its file is, if it was read from one: `kl.show` looks there for meshes

    n joints are independent: they move, and they do not mimic another joint. They are in the order of the file. Planar and floating
    joints have no single value: see `poses`. Wherever q is an argument, it may also be a mapping from the name of each independent
    joint to its value.

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
        Source: the URDF specification, "link" and "joint".
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
        counts = ((len(self.links), "link"), (self.n, "independent joint"))
        return ", ".join([self.name, *(f"{count} {word}{'s'[: count != 1]}" for count, word in counts)])

    def _rows(self, indent: str) -> Iterator[list[str]]:
        for depth, link, _ in self._descendants(self.root):
            if (joint := self.parent_joints.get(link)) is None:
                yield [link, "", "", ""]
            else:
                yield [indent * depth + link, joint.name, joint.type, self._value(joint)]

    def _value(self, joint: UrdfJoint) -> str:
        """The value of a joint as the file has it: a number of q, or a formula in another joint."""
        if joint.name in self._numbers:
            return f"q{self._numbers[joint.name] + 1}"
        if joint.mimic is None:
            return "a pose" if joint.moves else ""
        other, multiplier, offset = joint.mimic
        factor = {1.0: "", -1.0: "-"}.get(multiplier, f"{format_number(multiplier)} ")
        return f"{factor}{other}" + (f" {'-' if offset < 0 else '+'} {format_number(abs(offset))}" if offset else "")

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

    @cached_property
    def _numbers(self) -> dict[str, int]:
        return {name: i for i, name in enumerate(self.joint_names)}

    def poses(
        self, q: JointValues, base: ArrayLike | None = None, joint_poses: Mapping[str, ArrayLike] | None = None
    ) -> dict[str, Array]:
        """Compute the pose of every link, each in the link's own frame, as tf in ROS gives them.

        q (..., n) of the independent joints, in radians and metres -> (..., 4, 4) for each link, in the frame of the root:
        T_child = T_parent O e^[A]q, with the origin O and the axis A of the joint between the two links.

        base         (..., 4, 4), the pose of the root in the world, for a floating base; by default the identity. With six
                     coordinates xi of the base in front of q it is kl.exp(xi)
        joint_poses  for the name of each planar and each floating joint, its motion (..., 4, 4): the pose of the child link in
                     the frame of the joint

        Raises ValueError for a planar or a floating joint without a pose, and if a mimic joint follows no joint that moves, or itself.
        Source: the URDF specification, "joint"; Modern Robotics, 4.2.

        >>> tree = Tree.from_urdf(kl.to_urdf(kl.robots.youbot()))
        >>> lifted = tree.poses(np.zeros((10, 5)), base=exp([0, 0, 0, 0, 0, 0.5]))     # the arm on a platform
        >>> lifted["base_link"].shape, bool(np.allclose(lifted["tool"], exp([0, 0, 0, 0, 0, 0.5]) @ kl.robots.youbot().home))
        ((10, 4, 4), True)
        """
        q = self.in_order(q)
        steps = {}
        for name, (driver, multiplier, offset) in self.couplings.items():
            moving, value = self._moving_joints[name], multiplier * q[..., self._numbers[driver], None] + offset
            steps[name] = moving.origin @ exp(moving.screw * value)
        root = np.eye(4) if base is None else validation.poses(base, "base")
        free = self._validate_joint_poses(joint_poses or {})
        shape = np.broadcast_shapes(q.shape[:-1], root.shape[:-2], *(T.shape[:-2] for T in free.values()))
        found = {self.root: np.broadcast_to(root, (*shape, 4, 4)).copy()}
        for _, link, _ in self._descendants(self.root):
            if joint := self.parent_joints.get(link):
                step = joint.origin @ free[joint.name] if joint.name in free else steps.get(joint.name, joint.origin)
                found[link] = found[joint.parent] @ step
        return {link: found[link] for link in self.links}

    def chain(self, base: str | None = None, tip: str | None = None) -> Chain:
        """Build a chain from the joints on the path from one link to another: up the tree, and down again.

        base  the link whose frame is {s}; by default the root
        tip   the link whose frame is {b}; by default `default_tip(base)`

        A mimic joint that is +-1 times an independent joint, plus an offset, takes the name and the limits of that joint.

        Raises ValueError for a name that is no link, if several links could be the tip, if no joint moves between base and tip, if
        a joint between them is planar or floating, and if two of them follow the same joint, or one has another multiplier.
        Source: the URDF specification, "link" and "joint".

        >>> Tree.from_urdf(kl.to_urdf(kl.robots.youbot())).chain(base="link_4", tip="link_2").joint_names
        ('joint_4', 'joint_3')
        """
        base = self.root if base is None else base
        tip = self.default_tip(base) if tip is None else tip
        T, screws, points, moving = np.eye(4), [], [], []
        for joint, sign in self.path(base, tip):
            if joint.type in MOVED_BY_POSES:
                raise joint.element.error(
                    f"a joint between base and tip must have one degree of freedom; this one is {joint.type}. Choose a base beyond it, "
                    f"such as {joint.child}, or use kl.Tree.from_urdf(...).poses(q, joint_poses=...)."
                )
            # The axis is given in the joint frame: the frame after this joint if the path goes down, and before it if it goes up.
            before, T = T, T @ (joint.origin if sign > 0 else inverse(joint.origin))
            if joint.moves:
                frame = T if sign > 0 else before
                screws.append(sign * moved_screw(frame, joint.screw))
                points.append(frame[:3, 3])
                moving.append(joint)
        if not moving:
            raise self.link_elements[tip].error(f"a joint must move between {base} and {tip}; none does.")
        # A faulty mimic joint elsewhere does not affect this chain.
        couplings = [followed(joint, self._moving_joints) for joint in moving]
        drivers = [driver for driver, _, _ in couplings]
        for joint, (driver, multiplier, _) in zip(moving, couplings, strict=True):
            if joint.mimic and (drivers.count(driver) > 1 or abs(multiplier) != 1):
                raise joint.element.error(
                    f"the joints of a chain must move independently; joint {joint.name} mimics joint {driver}, multiplied by "
                    f"{multiplier:g}. Compute with kl.Tree.from_urdf(...).poses(q), or pass other links as base or tip."
                )
        limits = self.limits[[self._numbers[driver] for driver in drivers]]
        chain = Chain(
            *(np.array(screws), T, np.array(points), self.name, f"URDF, from {base} to {tip}"),
            limits=limits if np.isfinite(limits).any() else None,
            joint_names=tuple(drivers),
        )
        if not any(joint.mimic for joint in moving):
            return chain
        # Where the independent joints are 0, the mimic joints have the values of their offsets: the chain is at home there.
        signs, shifts = np.array([[multiplier, offset] for _, multiplier, offset in couplings]).T
        moved, at = signs[:, None] * chain.jacobian(shifts).T, chain.link_poses(shifts)[:, :3, 3]
        return chain.changed(screws=moved, home=chain.fk(shifts), points=at)

    def path(self, base: str, tip: str) -> list[PathStep]:
        """Find the joints from one link to another: up to their nearest common ancestor, and down from it.

        >>> text = '''<robot name="rig"> <link name="table"/> <link name="post"/> <link name="camera"/>
        ...     <joint name="at_rear" type="fixed"> <parent link="table"/> <child link="post"/> </joint>
        ...     <joint name="on_top" type="fixed"> <parent link="post"/> <child link="camera"/> </joint> </robot>'''
        >>> [(step.joint.name, step.sign) for step in Tree.from_urdf(text).path("camera", "table")]
        [('on_top', -1), ('at_rear', -1)]
        """
        up, down = (self._ancestors(self._checked(link, name)) for link, name in ((base, "base"), (tip, "tip")))
        shared = {joint.name for joint in up} & {joint.name for joint in down}
        return [
            *(PathStep(joint, -1) for joint in up if joint.name not in shared),
            *(PathStep(joint, +1) for joint in reversed(down) if joint.name not in shared),
        ]

    def _checked(self, link: str, argument: str) -> str:
        """The link, if it is one; argument: its name, for the message."""
        if link not in self.link_elements:
            hint = suggest_name(link, self.links, "links")
            raise ValueError(f"{argument} must be the name of a link; got {link!r}.{hint}")
        return link

    def _ancestors(self, link: str) -> list[UrdfJoint]:
        """The joints from a link up to the root."""
        joints = []
        while link in self.parent_joints:
            joints.append(self.parent_joints[link])
            link = self.parent_joints[link].parent
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
        independent, moving = dict[str, int](), dict[str, int]()  # joints that follow a link, on the longest way
        for _, name, _ in reversed([*self._descendants(base)]):
            joints = below.get(name, [])
            moving[name] = max((moving[each.child] + each.moves for each in joints), default=0)
            independent[name] = max((independent[each.child] + each.is_independent for each in joints), default=0)
        while tips:
            body = [name for _, name, moves in self._descendants(link) if not moves]
            ways = [joint for name in body for joint in below.get(name, []) if joint.moves]
            ways.sort(key=lambda joint: independent[joint.child] + joint.is_independent, reverse=True)
            follow = [independent[joint.child] + joint.is_independent for joint in ways]
            if behind and (not ways or (len(ways) > 1 and follow[0] < behind)):
                ends = [joint.parent for joint in ways] or [name for name in body if name not in below]
                return next((name for name in ["tool0", *ends] if name in body and "tool" in name), ends[0])
            if len(ways) > 1 and follow[0] < 2 * max(moving[joint.child] + 1 for joint in ways[1:]):
                break
            behind, link = behind + ways[0].is_independent, ways[0].child
        raise self.link_elements[base].error(self._several_ends(base, tips))

    def _several_ends(self, base: str, tips: list[str]) -> str:
        """Say which links could be the end of an arm on a base."""
        choices = "Choose a base with a moving joint below it." if self.n else "No joint of the file has a value."
        if tips:
            counts = [sum(joint.moves for joint, _ in self.path(base, tip)) for tip in tips]
            named = (f"{tip} ({count} joint{'s'[: count != 1]})" for tip, count in zip(tips, counts, strict=True))
            choices = f"Choose the tip, one of {', '.join(named)}."
        return f"exactly one end of the tree must move relative to this base; got {len(tips)}. {choices}"

    def _validate_joint_poses(self, given: Mapping[str, ArrayLike]) -> dict[str, Array]:
        needed = [joint.name for joint in self.parent_joints.values() if joint.type in MOVED_BY_POSES]
        if set(given) != set(needed):
            raise ValueError(
                f"joint_poses must have a pose for each planar and each floating joint of {self.name}: "
                f"{', '.join(needed) or 'it has none'}; got {', '.join(map(str, given)) or 'none'}. "
                "For a joint that is not displaced, pass np.eye(4)."
            )
        return {name: validation.poses(T, f"joint_poses[{name!r}]") for name, T in given.items()}
