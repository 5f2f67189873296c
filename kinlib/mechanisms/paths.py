"""Bodies and the joints between them: any path over joints, in either direction, is an open chain.

A joint that is traversed forwards, from its first body to its second, contributes the factor e^[S]q. Traversed backwards it
contributes e^[-S]q: the same joint with its axis negated. If the linkage is drawn open, the drawing of a body must first be
moved by a constant pose G before it meets its neighbour. Constants move to the right end of the product, because
G e^[S]q = e^[Ad(G) S]q G, and become the home pose of the chain.
"""

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.mechanisms.joints import Joint
from kinlib.rigid.lie import adjoint, exp, inverse
from kinlib.rigid.screw import is_prismatic


def joints_of_chain(chain: Chain, prefix: str, end: str, closing_offset: Array) -> list[Joint]:
    """Write the n joints of an open chain one by one, from the ground to a body at its end, without limits.

    prefix          of the numbers of links, and of joints that have no names
    closing_offset  (4, 4)  that of the last joint; the other joints have the identity
    """
    bodies = ["ground", *(f"link {prefix}{i}" for i in range(1, chain.n)), end]
    names = chain.joint_names or [f"joint {prefix}{i}" for i in range(1, chain.n + 1)]
    offsets = [np.eye(4)] * (chain.n - 1) + [closing_offset]
    columns = zip(names, pairwise(bodies), chain.screws, offsets, chain.joint_points, strict=True)
    return [Joint(*arguments) for arguments in columns]


Traversal = tuple[int, bool]
"""The index of a joint, and whether it is traversed forwards, from its first body to its second."""


def spanning_tree(joints: Sequence[Joint], ground: str) -> dict[str, list[Traversal]]:
    """Find the shortest path from the ground to every body that can be reached: breadth-first search over the joints.

    The result has an entry for each body, in the order in which they are reached: the joints of the path to it.
    """
    tree: dict[str, list[Traversal]] = {ground: []}
    queue = deque([ground])
    while queue:
        body = queue.popleft()
        for i, joint in enumerate(joints):
            for forwards, (a, b) in ((True, joint.bodies), (False, joint.bodies[::-1])):
                if a == body and b not in tree:
                    tree[b] = [*tree[a], (i, forwards)]
                    queue.append(b)
    return tree


def fundamental_cycles(joints: Sequence[Joint], tree: dict[str, list[Traversal]]) -> list[list[Traversal]]:
    """Find one loop for each joint outside the spanning tree: out to that joint, over it, and back through the tree."""
    in_tree = {i for path in tree.values() for i, _ in path}
    cycles = []
    for i in sorted(set(range(len(joints))) - in_tree):
        out, back = (tree[body] for body in joints[i].bodies)
        # The part that both paths share would be traversed out and back again, so it is left out.
        shared = next((k for k, (p, q) in enumerate(zip(out, back, strict=False)) if p != q), min(len(out), len(back)))
        way_home = [(k, not forwards) for k, forwards in reversed(back[shared:])]
        cycles.append([*out[shared:], (i, True), *way_home])
    return cycles


@dataclass(frozen=True, eq=False)
class JointPath:
    """A path over joints, written as an open chain.

    chain    its joints are those of the path, each with the sign of its direction
    columns  (k,)  which joint values of the linkage they are: chain.fk(q[..., columns]) is the pose at the end of the path
    """

    chain: Chain
    columns: NDArray[np.intp]

    @cached_property
    def centre(self) -> Array:
        """The point (3,) nearest to all axes of rotation: least squares of the distances, and nearest to the origin.

        Seen from a point far away all axes look alike, and the small singular values of a Jacobian are lost beside the large
        ones. Seen from the centre, the axes differ as much as possible.
        """
        axis, point, _ = (part[~is_prismatic(self.chain.screws)] for part in self.chain.lines)
        # Only the distance across an axis counts, and not that along it: I - a a^T projects onto the plane across a.
        across = np.eye(3) - axis[:, :, None] * axis[:, None, :]
        # Axes that are nearly parallel intersect far away, and a centre there would be of no use.
        nearest = np.linalg.pinv(across.sum(axis=0), rcond=1e-2, hermitian=True) @ point.sum(axis=0)
        return validation.read_only_copy(nearest)

    @cached_property
    def centred(self) -> Chain:
        """The same chain with its centre at the origin."""
        to_centre, back = exp([0, 0, 0, *-self.centre]), exp([0, 0, 0, *self.centre])
        return Chain(self.chain.screws @ adjoint(to_centre).T, to_centre @ self.chain.home @ back)

    @cached_property
    def size(self) -> float:
        """The largest distance, in metres, from the centre to one of its axes, or from its start to its end."""
        return float(np.linalg.norm(np.vstack([self.centred.lines.point, self.centred.home[:3, 3]]), axis=1).max())


def chain_along(joints: Sequence[Joint], path: Iterable[Traversal], name: str) -> JointPath:
    """Write a path over joints as an open chain, with the columns of q that its joints read."""
    first_columns = np.cumsum([0, *(joint.dof for joint in joints)])
    screws, columns, offset = [], [], np.eye(4)
    for i, forwards in path:
        joint, own_columns = joints[i], np.arange(first_columns[i], first_columns[i + 1])
        if forwards:
            screws.append(joint.screws @ adjoint(offset).T)
            columns.append(own_columns)
            offset = offset @ joint.closing_offset
        else:
            offset = offset @ inverse(joint.closing_offset)
            screws.append(-joint.screws[::-1] @ adjoint(offset).T)
            columns.append(own_columns[::-1])
    return JointPath(Chain(np.concatenate(screws), offset, name=name), np.concatenate(columns))
