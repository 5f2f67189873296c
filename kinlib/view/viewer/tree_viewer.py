"""A robot with several branches in the viewer, from a URDF: one slider for each independent joint, and mimic joints that follow.

Each branch is an arm from the root to one tip. Joints that an earlier branch has too are drawn with that one only.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint
from kinlib.urdf.links_and_joints import UrdfJoint
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import INK
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import JOINT_KINDS, configuration_text, direction_text
from kinlib.view.figures.bodies import Body, Primitive, body_of, solid_data, visual_solids
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import NUMBER_OFFSETS, carried_axes, stations
from kinlib.view.viewer.scene import body_motions, finite_limits, frame_data, joint_data, joint_slider, room, skeleton
from kinlib.view.viewer.viewer import ViewerBase

MAX_NAMED_TIPS = 8
"""A tree with more tips is drawn without their frames, which would hide it."""

LARGE_JOINTS = 12
"""If a tree has more joints than this, they are drawn smaller."""


@dataclass(frozen=True, eq=False)
class Branch:
    """The arm from the root of a tree to one of its tips, where the independent joints are 0 at home.

    tip          the name of the link at its end
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

    def values(self, q: Array) -> Array:
        """Return the values of its own joints for values (n,) of the independent ones."""
        values: Array = self.multipliers * q[self.columns]
        return values

    def stations(self, q: Array) -> Array:
        """Return the points (k + 2, 3) through which its k joints run: the root, every joint, the tip."""
        return stations(self.chain, self.values(q))


def branches(tree: Tree) -> list[Branch]:
    """Return the branches of a tree. Planar and floating joints stay at the identity.

    Raises ValueError if no joint moves by one value.

    >>> from kinlib.chains.robots import youbot
    >>> from kinlib.urdf.chains import to_urdf
    >>> tree = Tree.from_urdf(to_urdf(youbot()))
    >>> [(branch.tip, len(branch.names)) for branch in branches(tree)]
    [('tool', 5)]
    """
    moving = {name: row for row, name in enumerate(tree.moving_joint_names)}
    home = home_poses(tree)
    found: list[Branch] = []
    for tip in tree.tips:
        path: list[UrdfJoint] = [step.joint for step in tree.path(tree.root, tip)]
        joints = [joint for joint in path if joint.name in moving]
        if not joints:
            continue
        frames = np.array([home[joint.child] for joint in joints])
        screws = (adjoint(frames) @ np.array([joint.screw for joint in joints])[..., None])[..., 0]
        chain = Chain(screws, home[tip], frames[:, :3, 3], tree.name)
        coupling = tree.coupling[[moving[joint.name] for joint in joints]]
        names = tuple(joint.name for joint in joints)
        shared = [sum(a == b for a, b in zip(names, other.names, strict=False)) for other in found]
        found.append(
            Branch(tip, chain, np.abs(coupling).argmax(axis=1), coupling.sum(axis=1), names, max(shared, default=0))
        )
    if not found:
        raise ValueError(f"A tree must have a joint that moves by one value to be shown; {tree.name} has none.")
    return found


def home_poses(tree: Tree) -> dict[str, Array]:
    """Return the pose of each link where the independent joints are 0, and planar and floating joints at the identity."""
    free = {joint.name: np.eye(4) for joint in tree.parent_joints.values() if joint.type in {"planar", "floating"}}
    return tree.poses(np.zeros(tree.n), joint_poses=free)


def branch_bodies(tree: Tree, found: list[Branch]) -> list[tuple[tuple[Primitive, ...], ...]]:
    """Return the primitives of each body of each branch, each link once: those of the file, or else some by rule.

    A link is fixed to the body that the moving joints above it move. Where no link of a body shows more than a mesh, it gets the
    body of any arm.
    """
    home, drawn = home_poses(tree), set[str]()
    bodies: list[tuple[tuple[Primitive, ...], ...]] = []
    for branch in found:
        own: list[list[Primitive]] = [[] for _ in range(branch.chain.n + 1)]
        index = 0
        for link, joint in [
            (tree.root, ""),
            *((step.joint.child, step.joint.name) for step in tree.path(tree.root, branch.tip)),
        ]:
            index += joint in branch.names
            if link not in drawn:
                own[index] += visual_solids(tree.link_elements[link], home[link])
                drawn.add(link)
        rule = body_of(branch.chain, hand=len(found) == 1).links
        first = branch.shared or int(bool(bodies))
        bodies.append(tuple(tuple(solids) or (rule[i] if i >= first else ()) for i, solids in enumerate(own)))
    return bodies


def draw_tree(tree: Tree, q: JointValues | None = None) -> Picture:
    """Draw a tree in a configuration: links, joints with the number of their value in q, axes, and the frames of root and tips.

    q  (n,) of the independent joints, or a mapping from their names to values; home by default

    Raises ValueError if q has another size, and if no joint moves by one value.

    >>> from kinlib.chains.robots import rpr
    >>> from kinlib.urdf.chains import to_urdf
    >>> draw_tree(Tree.from_urdf(to_urdf(rpr()))).alt[:45]
    'RPR, 3 independent joints, 1 branch, at home.'
    """
    values = np.zeros(tree.n) if q is None else tree.in_order(q)
    found = branches(tree)
    paths = [branch.stations(values) for branch in found]
    seen = np.concatenate(paths)
    bodies = branch_bodies(tree, found)
    body = Body(tuple(link for links in bodies for link in links), values, "")
    motions = [body_motions(branch.chain, branch.values(values)) for branch in found]
    moved = np.concatenate(motions)
    seen = np.concatenate([seen, body.extent(moved)])
    canvas = Canvas(seen, sizes=np.concatenate([branch.stations(np.zeros(tree.n)) for branch in found]))
    canvas.floor(seen, height=body.lowest)
    canvas.size *= _share(found)
    draw_body(canvas, body, moved)
    for branch in found:
        frames = branch.chain.link_poses(branch.values(values))
        axes = carried_axes(branch.chain, frames)
        for i in range(branch.shared, branch.chain.n):
            axis, point = axes[i], frames[i, :3, 3]
            canvas.axis(point - 0.1 * canvas.size * axis, point + 0.2 * canvas.size * axis)
            canvas.label(point, str(branch.columns[i] + 1), INK, NUMBER_OFFSETS, 11)
        if len(found) <= MAX_NAMED_TIPS:
            canvas.triad(branch.chain.fk(branch.values(values)), branch.tip, 0.1 * canvas.size)
    canvas.triad(np.eye(4), "s", 0.15 * canvas.size)
    return canvas.picture(describe_tree(tree, values), cropped=True)


def describe_tree(tree: Tree, q: ArrayLike) -> str:
    """Return the text alternative of a drawing of a tree: each joint with its axis, and the end of each branch, at q.

    q  (n,) of the independent joints

    js/scene/describe.js says the same of the tree in the viewer.

    >>> from kinlib.chains.robots import rpr
    >>> from kinlib.urdf.chains import to_urdf
    >>> print(describe_tree(Tree.from_urdf(to_urdf(rpr())), [0, 0, 0]))   # doctest: +NORMALIZE_WHITESPACE +ELLIPSIS
    RPR, 3 independent joints, 1 branch, at home. To tool: joint 1 joint_1 revolute along -y at (-4, -2, 0);
    joint 2 joint_2 prismatic along z at ...; its end is at (0, 0, 1) m.
    """
    q, found = np.asarray(q, dtype=float), branches(tree)
    count = f"{len(found)} branch{'es'[: 2 * (len(found) != 1)]}"
    sentences = [f"{tree.name}, {tree.n} independent joint{'s'[: tree.n != 1]}, {count}, {configuration_text(q)}."]
    for branch in found:
        frames = branch.chain.link_poses(branch.values(q))
        axes = carried_axes(branch.chain, frames)
        parts = [
            f"joint {branch.columns[i] + 1} {branch.names[i]} {JOINT_KINDS[branch.chain.joint_types[i]]} along "
            f"{direction_text(axes[i])} at {vector_text(frames[i, :3, 3])}"
            for i in range(branch.shared, branch.chain.n)
        ]
        end = vector_text(branch.chain.fk(branch.values(q))[:3, 3])
        sentences.append(f"To {branch.tip}: {'; '.join([*parts, f'its end is at {end} m'])}.")
    return " ".join(sentences)


class TreeViewer(ViewerBase):
    """A tree on the page. Make one with `explore_tree`."""

    def __init__(self, tree: Tree, scene: dict[str, Any], start: Array, **traits: Any) -> None:
        self.tree = tree
        super().__init__(scene, start, **traits)

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        return describe_tree(self.tree, self.q)

    def check(self, values: list[float]) -> None:
        """Raise ValueError if the tree has another number of independent joints."""
        self.tree.joint_values(values)

    def picture(self) -> Picture:
        """Draw the tree at q."""
        return draw_tree(self.tree, self.q)


def explore_tree(tree: Tree, start: JointValues | None = None) -> TreeViewer:
    """Show a robot with several branches in three dimensions, with a slider for each independent joint.

    start  (n,) the first values of the independent joints, or a mapping from their names to values; home by default

    Raises ValueError if start has another size, and if no joint moves by one value.

    >>> from kinlib.chains.robots import rpr
    >>> from kinlib.urdf.chains import to_urdf
    >>> viewer = explore_tree(Tree.from_urdf(to_urdf(rpr())), {"joint_1": 0.5, "joint_2": 0, "joint_3": 0})
    >>> viewer.q
    [0.5, 0.0, 0.0]
    """
    q = np.zeros(tree.n) if start is None else validation.single(tree.in_order(start), "q")
    found = branches(tree)
    places = np.concatenate([branch.stations(q) for branch in found])
    size = max(float(np.ptp(places, axis=0).max()), 1e-3)
    tips = [branch.chain.fk(branch.values(q)) for branch in found]
    arrows = [T[:3, 3] + 0.2 * size * T[:3, :3].T for T in (np.eye(4), *tips)]
    bodies = branch_bodies(tree, found)
    body = Body(tuple(link for links in bodies for link in links), q, "")
    motions = [body_motions(branch.chain, branch.values(q)) for branch in found]
    view = room(np.concatenate([places, body.extent(np.concatenate(motions))]), np.concatenate(arrows), size)
    types = {branch.columns[i]: branch.chain.joint_types[i] == "P" for branch in found for i in range(branch.chain.n)}
    scene = {
        "name": tree.name,
        "size": size * _share(found),
        "arms": [
            _arm(branch, is_first=branch is found[0]) | {"body": solid_data(links)}
            for branch, links in zip(found, bodies, strict=True)
        ],
        "sliders": [
            joint_slider(
                int(column), types[column], tree.limits[column], float(q[column]), title=tree.joint_names[column]
            )
            for column in sorted(types)
        ],
        "limits": finite_limits(tree.limits),
        "offered": ["axes", "dimensions"],
        "room": view,
        "floor": body.lowest,
        "foot": [0.0, 0.0, 0.0],
    }
    shown = ["axes", "base", *(["tool"] if len(found) <= MAX_NAMED_TIPS else [])]
    return TreeViewer(tree, scene, q, shown=shown)


def _share(found: list[Branch]) -> float:
    """Return how large joints are drawn, as a share of their usual size."""
    return min(1.0, LARGE_JOINTS / len({name for branch in found for name in branch.names}))


def _arm(branch: Branch, is_first: bool) -> dict[str, Any]:
    """Return a branch as data; what an earlier branch shows too moves with it, but is hidden."""
    joints = joint_data(branch.chain)
    for i, joint in enumerate(joints):
        joint["screw"] = (branch.multipliers[i] * branch.chain.screws[i]).tolist()
        joint["travel"] *= float(branch.multipliers[i])
        joint |= {"number": int(branch.columns[i]) + 1, "name": branch.names[i], "hidden": i < branch.shared}
    paths = skeleton(branch.chain)
    base = [frame_data("s", 0, np.eye(4))] if is_first else []
    return {
        "tip": branch.tip,
        "columns": branch.columns.tolist(),
        "joints": joints,
        "links": [[] if i < branch.shared else path for i, path in enumerate(paths)],
        "home": branch.chain.home.ravel().tolist(),
        "frames": {"base": base, "tool": [frame_data(branch.tip, branch.chain.n, branch.chain.home)]},
        "normals": [],
    }
