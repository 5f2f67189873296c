"""The branches of a robot, from the root to each tip, and drawings of a robot that has several of them.

An arm has one branch. In a tree, joints that an earlier branch has too are drawn with that one only.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.validation import Array, JointValues
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, inverse
from kinlib.urdf.links_and_joints import UrdfJoint
from kinlib.urdf.robot_tree import Tree
from kinlib.urdf.xml_elements import Element
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import body_motions, configuration_text, joint_texts
from kinlib.view.figures.bodies import Body, Primitive, body_of, visual_solids
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import NUMBER_OFFSETS, carried_axes, stations

MAX_NAMED_TIPS = 8
"""A tree with more tips is drawn without their frames, which would hide it."""

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
    """

    tip: str
    chain: Chain
    columns: NDArray[np.intp]
    multipliers: Array
    names: tuple[str, ...]
    shared: int

    def values(self, q: ArrayLike) -> Array:
        """Return the values of its own joints for values (n,) of the independent ones."""
        return np.asarray(self.multipliers * np.asarray(q, dtype=float)[self.columns])

    def stations(self, q: ArrayLike) -> Array:
        """Return the points (k + 2, 3) through which its k joints run: the root, every joint, the tip."""
        return stations(self.chain, self.values(q))

    def motions(self, q: ArrayLike) -> Array:
        """Return the motion of each body from home to q, (k + 1, 4, 4): body 0 is the base, body i is what joint i moves."""
        return body_motions(self.chain, self.values(q))


def branches(robot: Chain | Tree) -> list[Branch]:
    """Return the branches of a robot. Planar and floating joints stay at the identity.

    Raises ValueError if no joint moves by one value.
    """
    if isinstance(robot, Chain):
        return [Branch("", robot, np.arange(robot.n), np.ones(robot.n), robot.joint_names or ("",) * robot.n, 0)]
    home = home_poses(robot)
    found: list[Branch] = []
    for tip in robot.tips:
        path: list[UrdfJoint] = [step.joint for step in robot.path(robot.root, tip)]
        joints = [joint for joint in path if joint.name in robot.couplings]
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
        found.append(Branch(tip, chain, drivers, factors, names, shared))
    if not found:
        raise ValueError(f"A tree must have a joint that moves by one value to be shown; {robot.name} has none.")
    return found


def home_poses(tree: Tree) -> dict[str, Array]:
    """Return the pose of each link where the independent joints are 0, and planar and floating joints at the identity."""
    free = {joint.name: np.eye(4) for joint in tree.parent_joints.values() if joint.type in {"planar", "floating"}}
    return tree.poses(np.zeros(tree.n), joint_poses=free)


def links_of_bodies(tree: Tree, found: list[Branch]) -> list[list[list[Element]]]:
    """Return the links of each body of each branch, each once: a link is fixed to what the moving joints above it move."""
    drawn, bodies = set[str](), []
    for branch in found:
        own: list[list[Element]] = [[] for _ in range(branch.chain.n + 1)]
        index = 0
        steps = [(step.joint.child, step.joint.name) for step in tree.path(tree.root, branch.tip)]
        for link, joint in [(tree.root, ""), *steps]:
            index += joint in branch.names
            if link not in drawn:
                own[index].append(tree.link_elements[link])
                drawn.add(link)
        bodies.append(own)
    return bodies


BranchBody = tuple[tuple[tuple[Primitive, ...], ...], tuple[bool, ...]]
"""The solids of each body of a branch, and whether they are by rule because the file shows none."""


def links_of_arm(tree: Tree, base: str, names: Sequence[str]) -> tuple[list[list[Element]], dict[str, Array]]:
    """Return the links of each body of an arm that is a part of a tree, and the pose of each link in the frame of the base.

    base   the link whose frame is {s}
    names  of the joints of the arm; all others are at 0, so what hangs below them is fixed to a body
    """
    poses = home_poses(tree)
    home = {link: inverse(poses[base]) @ T for link, T in poses.items()}
    bodies: list[list[Element]] = [[] for _ in range(len(names) + 1)]
    index, above = {base: 0}, tree.parent_joints.items()
    while found := [(link, one) for link, one in above if link not in index and one.parent in index]:
        index |= {link: index[joint.parent] + (joint.name in names) for link, joint in found}
    for link, body in index.items():
        bodies[body].append(tree.link_elements[link])
    return bodies, home


def robot_body(robot: Chain | Tree, found: list[Branch]) -> tuple[Body, list[BranchBody]]:
    """Return the body of a robot, with the links of all its branches in a row, and of each branch its solids and which are by rule.

    A link of a tree shows what the file shows; where no link of a body shows more than a mesh, it gets the body of any arm.
    """
    if isinstance(robot, Chain):
        return body_of(robot), [(body_of(robot).links, ())]
    home = home_poses(robot)
    bodies: list[BranchBody] = []
    for branch, links in zip(found, links_of_bodies(robot, found), strict=True):
        own = [[solid for link in one for solid in visual_solids(link, home[link.text("name")])] for one in links]
        rule = body_of(branch.chain, hand=len(found) == 1).links
        first = branch.shared or int(bool(bodies))
        drawn = tuple(tuple(solids) or (rule[i] if i >= first else ()) for i, solids in enumerate(own))
        bodies.append((drawn, tuple(not solids for solids in own)))
    return Body(tuple(link for drawn, _ in bodies for link in drawn), np.zeros(robot.n), "The file."), bodies


def joint_share(found: list[Branch]) -> float:
    """Return how large joints are drawn, as a share of their usual size."""
    return min(1.0, LARGE_JOINTS / sum(branch.chain.n - branch.shared for branch in found))


def draw_tree(tree: Tree, q: JointValues | None = None) -> Picture:
    """Draw a tree at q (n,): links, joints with the number of their value in q, axes, and the frames of root and tips.

    Raises ValueError if q has another size, and if no joint moves by one value.
    """
    values = np.zeros(tree.n) if q is None else tree.in_order(q)
    found = branches(tree)
    body, _ = robot_body(tree, found)
    moved = np.concatenate([branch.motions(values) for branch in found])
    seen = np.concatenate([*(branch.stations(values) for branch in found), body.extent(moved)])
    canvas = Canvas(seen, sizes=np.concatenate([stations(branch.chain) for branch in found]))
    canvas.floor(seen, height=body.lowest)
    canvas.size *= joint_share(found)
    draw_body(canvas, body, moved)
    for branch in found:
        frames = branch.chain.link_poses(branch.values(values))
        shown = zip(branch.columns, carried_axes(branch.chain, frames), frames[:, :3, 3], strict=True)
        for column, axis, point in list(shown)[branch.shared :]:
            canvas.axis(point - 0.1 * canvas.size * axis, point + 0.2 * canvas.size * axis)
            canvas.label(point, str(column + 1), INK, NUMBER_OFFSETS, 11)
        if len(found) <= MAX_NAMED_TIPS:
            canvas.triad(branch.chain.fk(branch.values(values)), branch.tip, 0.1 * canvas.size)
    canvas.triad(np.eye(4), "s", 0.15 * canvas.size)
    return canvas.picture(describe_tree(tree, values), cropped=True)


def describe_tree(tree: Tree, q: ArrayLike) -> str:
    """Return the text alternative of a drawing of a tree: each joint with its axis, and the end of each branch, at q (n,).

    js/scene/describe.js says the same of the tree in the viewer.
    """
    found = branches(tree)
    count = f"{len(found)} branch{'es'[: 2 * (len(found) != 1)]}"
    sentences = [f"{tree.name}, {tree.n} independent joint{'s'[: tree.n != 1]}, {count}, {configuration_text(q)}."]
    for branch in found:
        told = zip(branch.columns, branch.names, joint_texts(branch.chain, branch.values(q)), strict=True)
        parts = [f"joint {column + 1} {name} {text}" for column, name, text in told][branch.shared :]
        end = vector_text(branch.chain.fk(branch.values(q))[:3, 3])
        sentences.append(f"To {branch.tip}: {'; '.join([*parts, f'its end is at {end} m'])}.")
    return " ".join(sentences)
