"""Every URDF file that three packages ship, against Pinocchio: the poses of all links, chains, and what is written again.

The files of airo-models and rtb-data are tested in every run, and those of example-robot-data by `nox -s urdf`.
"""

import re

import numpy as np
import pytest
from urdf_files import ARMS, EXAMPLE_ROBOT_DATA, link_poses_by_pinocchio, shipped_files, urdf_text

from kinlib import Tree, to_urdf

FILES = shipped_files()
REFUSED = {
    "rtbdata/data/test.urdf": "Line 1: the file must be XML",  # its content is "hello"
    "example_robot_data/ur_description/urdf/ur3.urdf": "<robot>: it must have the attribute name",
}
"""What is no URDF. Pinocchio refuses these files too."""

WITHOUT_DRIVER = "example_robot_data/alex_description/urdf/alex_psyonic_hands.urdf"
"""The fingers of both hands mimic joints such as index_q1, but the names of these joints begin with Left_ or Right_."""


def check(text):
    """Compare all links, and the chains between the root and the tips, with Pinocchio, also after the file is written again."""
    tree = Tree.from_urdf(text)
    q = np.random.default_rng(0).uniform(-2, 2, (3, tree.n))
    theirs = link_poses_by_pinocchio(text, tree.moving_joint_names, tree.joint_values(q))
    for ours in (tree.poses(q), Tree.from_urdf(to_urdf(tree)).poses(q)):
        assert set(ours) == set(theirs)
        for link, T in ours.items():
            np.testing.assert_allclose(T, theirs[link], rtol=0, atol=1e-12, err_msg=link)
    compared = 0
    for base, tip in [*((tree.root, tip) for tip in tree.tips), *zip(tree.tips, tree.tips[1:], strict=False)]:
        expected = np.linalg.solve(theirs[base], theirs[tip])
        np.testing.assert_allclose(tree.pose(base, tip, q), expected, rtol=0, atol=1e-12)
        try:
            chain = tree.chain(base, tip)
        except ValueError as error:
            if "a joint must move between base and tip" in str(error):
                np.testing.assert_allclose(tree.pose(base, tip), expected[0], rtol=0, atol=1e-12)
            elif "the joints of a chain must move independently" not in str(error):
                raise
            continue
        columns = [tree.joint_names.index(name) for name in chain.joint_names]
        np.testing.assert_allclose(chain.fk(q[:, columns]), expected, rtol=0, atol=1e-12)
        compared += 1
    return compared


@pytest.mark.parametrize("name", FILES)
def test_all_links_of_a_shipped_file_are_where_pinocchio_says(name):
    text = FILES[name].read_text("utf-8")
    if name in REFUSED:
        with pytest.raises(ValueError, match=REFUSED[name]):
            Tree.from_urdf(FILES[name])
    elif name == WITHOUT_DRIVER:
        with pytest.raises(ValueError, match=r'Line \d+, <mimic> in <joint name="Left_index_q2">: .* got \'index_q1\''):
            check(text)
        check(re.sub(r'(?<=<mimic joint = ")(?=\w+_q1")', "Left_", text))
    else:
        check(text)


@pytest.mark.parametrize("name", [name for name, (_, file, _) in ARMS.items() if not file.endswith(".urdf")])
def test_all_links_of_a_file_with_macros_are_where_pinocchio_says(name):
    assert check(urdf_text(name))


def test_the_files_of_three_packages_are_found():
    packages = [name.partition("/")[0] for name in FILES]
    assert packages.count("airo_models") >= 16
    assert packages.count("rtbdata") >= 9
    assert packages.count("example_robot_data") >= 69 or not EXAMPLE_ROBOT_DATA.exists()
