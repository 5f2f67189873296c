"""Robots with several branches in the viewer: every joint once, every tip where Tree.poses has it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from urdf_files import TWO_FINGERS, trees

import kinlib as kl
from kinlib.view.viewer.tree_viewer import (
    Branch,
    branches,
    describe_tree,
    draw_tree,
    explore_tree,
)


@pytest.mark.oracle(
    "axiom: a branch ends where Tree.poses, which pinocchio confirms, has its tip",
    branches,
    Branch.values,
    Branch.stations,
)
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
    arms = explore_tree(tree, q).scene["arms"]
    shown = [joint["name"] for arm in arms for joint in arm["joints"] if not joint["hidden"]]
    assert sorted(shown) == sorted({name for branch in found for name in branch.names})


def test_a_gripper_is_described_and_drawn_with_its_mimic_joint():
    tree = kl.Tree.from_urdf(TWO_FINGERS)
    text = describe_tree(tree, [0, 0.02])
    assert text == (
        "gripper, 2 independent joints, 3 branches, at q = (0, 0.02). To left: joint 1 turn revolute along z at (0, 0, 0.2); "
        "joint 2 open prismatic along y at (0, 0.07, 0.3); its end is at (0, 0.07, 0.3) m. To pad: joint 2 follow prismatic along y "
        "at (0, -0.1, 0.3); its end is at (0, -0.1, 0.35) m. To lamp: its end is at (0.2, 0, 0.3) m."
    )
    assert explore_tree(tree, [0, 0.02]).alt == text
    assert draw_tree(tree, {"open": 0.02, "turn": 0}).alt == text
    assert [slider["title"] for slider in explore_tree(tree).scene["sliders"]] == ["turn", "open"]
