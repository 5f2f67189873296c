"""The branches of a robot, from the root to each tip, and the body of all of them.

An arm has one branch. In a tree, joints that an earlier branch has too are drawn with that one only.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, inverse
from kinlib.urdf.robot_tree import Tree
from kinlib.urdf.xml_elements import Element
from kinlib.view.figures.bodies import Body, body_of, visual_solids

LARGE_JOINTS = 12
"""If a robot has more joints than this, they are drawn smaller."""


@dataclass(frozen=True, eq=False)
class Branch:
    """The arm from the root of a robot to one of its tips, where the independent joints are 0 at home.

    tip          the name of the link at its end; "" for an arm
    chain        its joints: chain.fk(multipliers * q[columns]) is the pose of the tip
    columns      for each joint the number of the independent joint that moves it, from 0
    multipliers  how far it moves with that: 1, or the multiplier of a mimic joint
    names        of its joints
    shared       how many of its joints, from the root on, an earlier branch has too
    links        of a file, those of each of its k + 1 bodies that no earlier branch has, with their poses in {s} at home
    """

    tip: str
    chain: Chain
    columns: NDArray[np.intp]
    multipliers: Array
    names: tuple[str, ...]
    shared: int
    links: list[list[tuple[Element, Array]]]

    def values(self, q: ArrayLike) -> Array:
        """Return the values of its own joints for values (n,) of the independent ones."""
        return np.asarray(self.multipliers * np.asarray(q, dtype=float)[self.columns])


def branches(robot: Chain | Tree, visuals: tuple[Tree, str] | None = None) -> list[Branch]:
    """Return the branches of a robot. Planar and floating joints stay at the identity.

    visuals  the file of which an arm is a part, as a tree, and the name of the link whose frame is {s}

    Raises ValueError if no joint moves by one value.
    """
    if isinstance(robot, Chain):
        names = robot.joint_names or ("",) * robot.n
        arm = [Branch("", robot, np.arange(robot.n), np.ones(robot.n), names, 0, [[] for _ in range(robot.n + 1)])]
        return _with_links(arm, *visuals) if visuals else arm
    home = _home_poses(robot)
    found: list[Branch] = []
    for tip in robot.tips:
        joints = [joint for joint, _ in robot.path(robot.root, tip) if joint.name in robot.couplings]
        if not joints:
            continue
        frames = np.array([home[joint.child] for joint in joints])
        screws = (adjoint(frames) @ np.array([joint.screw for joint in joints])[..., None])[..., 0]
        couplings = [robot.couplings[joint.name] for joint in joints]
        drivers = np.array([robot.joint_names.index(one.joint) for one in couplings])
        factors = np.array([one.multiplier for one in couplings])
        names = tuple(joint.name for joint in joints)
        shared = max((sum(a == b for a, b in zip(names, one.names, strict=False)) for one in found), default=0)
        chain = Chain(screws, home[tip], frames[:, :3, 3], robot.name)
        found.append(Branch(tip, chain, drivers, factors, names, shared, [[] for _ in range(len(joints) + 1)]))
    if not found:
        raise ValueError(f"A tree must have a joint that moves by one value to be shown; {robot.name} has none.")
    return _with_links(found, robot, robot.root)


def _home_poses(tree: Tree) -> dict[str, Array]:
    """Return the pose of each link where the independent joints are 0, and planar and floating joints at the identity."""
    free = {joint.name: np.eye(4) for joint in tree.parent_joints.values() if joint.type in {"planar", "floating"}}
    return tree.poses(np.zeros(tree.n), joint_poses=free)


def _with_links(found: list[Branch], tree: Tree, base: str) -> list[Branch]:
    """Add to each body the links that are fixed to it, with their poses in the frame of the base.

    What hangs below a joint of no branch, which is at 0, is fixed to the body above that joint.
    """
    moved = {name: one.links[i] for one in found for i, name in enumerate(one.names, start=1) if i > one.shared}
    home, bodies = _home_poses(tree), {base: found[0].links[0]}
    above = tree.parent_joints.items()
    while below := [(link, joint) for link, joint in above if link not in bodies and joint.parent in bodies]:
        bodies |= {link: moved.get(joint.name, bodies[joint.parent]) for link, joint in below}
    for link, body in bodies.items():
        body.append((tree.link_elements[link], inverse(home[base]) @ home[link]))
    return found


def robot_body(found: Sequence[Branch]) -> tuple[Body, list[list[bool]]]:
    """Return the body of a robot, with the links of all its branches in a row, and of each branch which are by rule.

    A link shows what the file shows; where no link of a body shows more than a mesh, it gets the body of any arm.
    """
    links, by_rule = [], []
    for k, branch in enumerate(found):
        own = [[solid for link, T in one for solid in visual_solids(link, T)] for one in branch.links]
        rule = body_of(branch.chain, hand=len(found) == 1).links
        first = branch.shared or int(k > 0)
        links += [tuple(solids) or (rule[i] if i >= first else ()) for i, solids in enumerate(own)]
        by_rule.append([not solids for solids in own])
    return Body(tuple(links)), by_rule


def joint_share(found: Sequence[Branch]) -> float:
    """Return how large joints are drawn, as a share of their usual size."""
    return min(1.0, LARGE_JOINTS / sum(branch.chain.n - branch.shared for branch in found))
