"""The viewer in Python: the data of an arm, the arguments that are refused, and the HTML for a page without a kernel."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import ROBOTS
from urdf_files import trees

import kinlib as kl
from kinlib.dh.table import table_frames
from kinlib.view import explore
from kinlib.view.drawing.canvas import VIEWS, view_axes
from kinlib.view.figures.branches import branches
from kinlib.view.figures.joint_bodies import stations
from kinlib.view.viewer.scene import HEIGHT_PER_WIDTH

each_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


# --- the data of an arm ---


@each_robot
def test_every_frame_is_fixed_to_a_body_and_dh_frames_are_those_of_the_assignment(robot):
    arm = explore(robot).scene["arms"][0]
    for frames in arm["frames"].values():
        for frame in frames:
            assert 0 <= frame["body"] <= robot.n
            kl.inverse(np.reshape(frame["pose"], (4, 4)))  # raises ValueError if the pose is not rigid
    assert ("standard" in arm["frames"]) == ("H" not in robot.joint_types)
    if "H" in robot.joint_types:
        return
    shown = {f["name"]: f["pose"] for f in arm["frames"]["modified"]}
    for i, T in enumerate(kl.assign_frames(robot, convention="modified").frames):
        np.testing.assert_array_equal(np.reshape(shown[str(i)], (4, 4)), T)


@given(trees(mimic=True), st.integers(0, 2**32 - 1))
def test_every_branch_of_a_tree_ends_at_its_tip_and_every_joint_is_drawn_once(drawn, seed):
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
        np.testing.assert_allclose(stations(branch.chain, branch.values(q))[-1], poses[branch.tip][:3, 3], atol=1e-9)
    arms = explore(tree, start=q).scene["arms"]
    shown = [joint["name"] for arm in arms for joint in arm["joints"] if not joint["hidden"]]
    assert sorted(shown) == sorted({name for branch in found for name in branch.names})


def test_sliders_have_the_limits_of_the_joints_or_default_ranges():
    rpr = kl.robots.rpr()
    limited = kl.Chain(rpr.screws, rpr.home, limits=[(-1, 2), (-np.inf, np.inf), (0, np.inf)])
    ends = [(s["low"], s["high"]) for s in explore(limited).scene["sliders"]]
    assert ends == [(-1, 2), (-1, 1), (0, np.pi)]
    assert explore(limited).scene["limits"] == [[-1, 2], [None, None], [0, None]]


def test_invalid_values_are_refused_and_the_old_ones_stay():
    arm = explore(kl.robots.rpr(), start=[0.1, 0.2, 0.3])
    for trait, values in product(("q", "start"), ([1, 2], [1, 2, np.nan])):
        with pytest.raises(ValueError, match=r"RPR has 3 joint values|NaN"):
            setattr(arm, trait, values)
        assert getattr(arm, trait) == [0.1, 0.2, 0.3]


# --- a page without a kernel ---


def test_a_name_cannot_end_the_script_that_contains_it():
    rpr = kl.robots.rpr()
    arm = explore(kl.Chain(rpr.screws, rpr.home, name="</script><script>alert(1)</script>"))
    assert arm.html().count("</script>") == 1


def test_the_region_in_view_contains_all_frames_that_are_given():
    arm = kl.robots.puma560()
    turned = np.diag([-1.0, -1, 1, 1])
    frames = {
        name: turned @ T for name, T in table_frames(kl.assign_frames(arm, "standard").table, np.zeros(6)).items()
    }
    room = explore(arm, frames=frames).scene["room"]
    for view in VIEWS:
        seen = np.abs((np.array([T[:3, 3] for T in frames.values()]) - room["centre"]) @ view_axes(view)[1].T)
        assert (seen * (HEIGHT_PER_WIDTH, 1) < room["radius"]).all()
