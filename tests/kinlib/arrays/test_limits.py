"""Limits: which are refused, and which values are within them."""

import numpy as np
import pytest

import kinlib as kl
from kinlib.arrays.limits import look_like_degrees, validate_limits

ONE_JOINT = """<robot name="r"> <link name="a"/> <link name="b"/>
<joint name="j" type="{kind}"> <parent link="a"/> <child link="b"/> <limit lower="{lower}" upper="{upper}"/> </joint> </robot>"""


@pytest.mark.parametrize("limits", [(-180, 180), (-360, 360), (0, 90), (-60, 0), (-np.inf, 720)])
def test_limits_of_a_revolute_joint_that_look_like_degrees_are_refused(limits):
    assert look_like_degrees(*limits)
    with pytest.raises(ValueError, match=r"limits of joint 2 must be in radians; got .*np\.radians"):
        validate_limits([limits, limits], "PR")
    if np.isfinite(limits).all():
        text = ONE_JOINT.format(kind="revolute", lower=limits[0], upper=limits[1])
        with pytest.raises(ValueError, match=r"<limit>.*must be in radians; got .*continuous"):
            kl.load_urdf(text)
        kl.load_urdf(text.replace("revolute", "prismatic"))


@pytest.mark.parametrize(
    "limits", [(-10, 10), (0, 50), (0, 62.83), (-100, 100), (-1e16, 1e16), (0.5, 90), (59, 59), (721, 721)]
)
def test_other_limits_of_a_revolute_joint_are_accepted(limits):
    assert validate_limits([limits], "R").tolist() == [[*limits]]


def test_a_tree_and_its_arm_have_the_same_limits():
    arm = kl.robots.puma560().changed(limits=[[-3, 2], [-1, 1], [0, 4], [-np.inf, 1], [0, np.inf], [-np.inf, np.inf]])
    tree = kl.Tree.from_urdf(kl.to_urdf(arm))
    arm = tree.chain()
    q = tree.random_configurations(20, seed=3)
    np.testing.assert_array_equal(q, arm.random_configurations(20, seed=3))
    assert tree.within_limits(q).all()
    q[::2, 1] = -1.01
    assert tree.within_limits(q).tolist() == arm.within_limits(q).tolist() == [False, True] * 10
    assert tree.within_limits(dict(zip(tree.joint_names, q.T, strict=True))).sum() == 10
