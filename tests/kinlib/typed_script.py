"""A user's script, which `mypy` checks: it knows the type of every result."""

from typing import assert_type

import numpy as np

import kinlib as kl
from kinlib.arrays.validation import Array

arm = kl.Chain(screws=np.array([[0, 0, 1, 0, 0, 0]]), home=np.eye(4), limits=np.array([[-1, 1]]))
convention: kl.Convention = "modified" if arm.n > 2 else "standard"
table = kl.DHTable("a | alpha | d | theta \n 0.4 | 0 | 0 | q1", convention=convention, base=np.eye(4).tolist())
numbers = kl.DHTable([[0.4, 0, 0, 0]], convention="modified", signs=[-1])
joint = kl.Joint("A", ("ground", "crank"), np.array([0, 0, 1, 0, 0, 0]))
tree = kl.Tree.from_urdf(kl.to_urdf(arm))
assert_type(arm.screws, Array)
assert_type(arm.fk([0.3]), Array)
assert_type(arm.within_limits([0.3]), np.typing.NDArray[np.bool_])
assert_type(table.rows, Array)
assert_type(kl.assign_frames(arm, convention=convention).frames, Array)
assert_type(kl.nearest_rotation(np.eye(3)), Array)
assert_type(joint.screws, Array)
assert_type(tree.poses([0.3], base=np.eye(4)), dict[str, Array])
assert_type(tree.chain("base_link", "tool").fk([0.3]), Array)
