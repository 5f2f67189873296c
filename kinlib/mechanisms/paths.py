"""Bodies and the joints between them: any path over joints, in either direction, is an open chain.

A joint that is traversed forwards, from its first body to its second, contributes the factor e^[S]q. Traversed backwards it
contributes e^[-S]q: the same joint with its axis negated. If the linkage is drawn open, the drawing of a body must first be
moved by a constant pose G before it meets its neighbour. Constants move to the right end of the product, because
G e^[S]q = e^[Ad(G) S]q G, and become the home pose of the chain.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.mechanisms.joints import Joint
from kinlib.rigid.lie import adjoint, exp, inverse
from kinlib.rigid.screw import is_prismatic


def joints_of_chain(chain: Chain, prefix: str, end: str, closing_offset: Array) -> list[Joint]:
    """Write the joints of an open chain one by one, from the ground to a body at its end, without limits.

    prefix  of the numbers of links, and of joints that have no names
    closing_offset  (4, 4)  that of the last joint; the other joints have the identity
    """
    bodies = ["ground", *(f"link {prefix}{i}" for i in range(1, chain.n)), end]
    names = chain.joint_names or [f"joint {prefix}{i}" for i in range(1, chain.n + 1)]
    offsets = [np.eye(4)] * (chain.n - 1) + [closing_offset]
    columns = zip(names, pairwise(bodies), chain.screws, offsets, chain.joint_points, strict=True)
    return [Joint(*arguments) for arguments in columns]


@dataclass(frozen=True, eq=False)
class JointPath:
    """A path over joints, written as an open chain.

    joints  all joints of the linkage
    steps   the joints of the path: the index of each, and whether it is traversed forwards, from its first body to its second
    """

    joints: Sequence[Joint]
    steps: Sequence[tuple[int, bool]]

    @cached_property
    def columns(self) -> NDArray[np.intp]:
        """The joint values of the linkage that the chain takes, (k,): chain.fk(q[..., columns]) is the pose at the end of the path."""
        first = np.cumsum([0, *(joint.dof for joint in self.joints)])
        return np.concatenate(
            [np.arange(first[i], first[i + 1])[:: 1 if forwards else -1] for i, forwards in self.steps]
        )

    @cached_property
    def chain(self) -> Chain:
        """The open chain, whose joints are those of the path, each with the sign of its direction."""
        screws, offset = [], np.eye(4)
        for i, forwards in self.steps:
            S, G = self.joints[i].screws, self.joints[i].closing_offset
            if not forwards:  # (e^[S1]q1 ... e^[Sk]qk G)^-1, with G^-1 moved to the right end
                G = inverse(G)
                S = -S[::-1] @ adjoint(G).T
            screws.append(S @ adjoint(offset).T)
            offset = offset @ G
        return Chain(np.concatenate(screws), offset, name="path")

    @cached_property
    def centred(self) -> Chain:
        """The same chain with the origin at its centre: the point nearest to all axes of rotation, by least squares.

        Seen from a point far away all axes look alike, and the small singular values of a Jacobian are lost beside the large
        ones. Seen from the centre, the axes differ as much as possible.
        """
        axis, point, _ = (part[~is_prismatic(self.chain.screws)] for part in self.chain.lines)
        # Only the distance across an axis counts, and not that along it: I - a a^T projects onto the plane across a.
        across = np.eye(3) - axis[:, :, None] * axis[:, None, :]
        # Axes that are nearly parallel intersect far away, and a centre there would be of no use.
        centre = np.linalg.pinv(across.sum(axis=0), rcond=1e-2, hermitian=True) @ point.sum(axis=0)
        to_centre, back = exp([0, 0, 0, *-centre]), exp([0, 0, 0, *centre])
        return Chain(self.chain.screws @ adjoint(to_centre).T, to_centre @ self.chain.home @ back)


def spanning_tree(joints: Sequence[Joint], ground: str) -> dict[str, JointPath]:
    """Find the shortest path from the ground to every body that can be reached, in this order: breadth-first search over the joints."""
    tree, bodies = {ground: JointPath(joints, [])}, [ground]
    for body in bodies:
        for i, joint in enumerate(joints):
            for forwards, (a, b) in ((True, joint.bodies), (False, joint.bodies[::-1])):
                if a == body and b not in tree:
                    tree[b] = JointPath(joints, [*tree[a].steps, (i, forwards)])
                    bodies.append(b)
    return tree


def fundamental_cycles(joints: Sequence[Joint], tree: dict[str, JointPath]) -> Iterator[JointPath]:
    """Find one loop for each joint outside the spanning tree: out to that joint, over it, and back through the tree."""
    in_tree = {i for path in tree.values() for i, _ in path.steps}
    for i in sorted({*range(len(joints))} - in_tree):
        out, back = (tree[body].steps for body in joints[i].bodies)
        # The part that both paths share would be traversed out and back again, so it is left out.
        way_home = [(k, not forwards) for k, forwards in reversed(back) if (k, forwards) not in out]
        yield JointPath(joints, [*(step for step in out if step not in back), (i, True), *way_home])


def reach(chain: Chain) -> float:
    """Compute the largest distance, in metres, of a chain from the origin: of one of its axes, or of its end."""
    return float(np.linalg.norm([*chain.lines.point, chain.home[:3, 3]], axis=1).max())
