"""Robots with several branches in the viewer: every joint once, every tip where Tree.poses has it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from urdf_files import trees

import kinlib as kl
from kinlib.view import explore
from kinlib.view.figures.tree import branches


@given(trees(mimic=True), st.integers(0, 2**32 - 1))
def test_every_branch_ends_at_its_tip_and_every_joint_is_drawn_once(drawn, seed):
    tree = kl.Tree.from_urdf(drawn[0])
    q = np.random.default_rng(seed).uniform(-1, 1, tree.n)
    if not tree.tips:
        with pytest.raises(ValueError, match="must have a joint that moves"):
            branches(tree)
        return
    found, poses = branches(tree), tree.poses(q)
    assert [branch.tip for branch in found] == list(tree.tips)
    for branch in found:
        np.testing.assert_allclose(branch.chain.fk(branch.values(q)), poses[branch.tip], atol=1e-9)
        np.testing.assert_allclose(branch.stations(q)[-1], poses[branch.tip][:3, 3], atol=1e-9)
    arms = explore(tree, start=q).scene["arms"]
    shown = [joint["name"] for arm in arms for joint in arm["joints"] if not joint["hidden"]]
    assert sorted(shown) == sorted({name for branch in found for name in branch.names})
