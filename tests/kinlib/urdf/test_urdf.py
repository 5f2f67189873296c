"""URDF files: random trees against Pinocchio, round trips, what the parts of a file mean, and files with faults."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from strategies import configurations, directions, points, poses
from urdf_files import poses_by_pinocchio

import kinlib as kl
from kinlib import load_urdf, to_urdf
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from kinlib.urdf.xml_elements import MAX_BYTES

CLOSE = 1e-9


@given(points(7))
def test_origin_turns_about_fixed_axes_as_scipy_says(rpy):
    expected = Rotation.from_euler("xyz", rpy).as_matrix()  # lower case: fixed axes
    np.testing.assert_allclose(origin(rpy=rpy)[:3, :3], expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-7, np.pi / 2 - 1e-12])
def test_roll_pitch_yaw_is_right_near_a_pitch_of_90_degrees(pitch):
    R = origin(rpy=(0.3, pitch, -1.2))[:3, :3]
    np.testing.assert_allclose(origin(rpy=roll_pitch_yaw(R))[:3, :3], R, rtol=0, atol=1e-15)


def assert_same(back, chain):
    atol = 1e-13 * (1 + np.abs(chain.joint_points).max() + np.abs(chain.home).max())
    for part in ("screws", "home", "joint_points"):
        np.testing.assert_allclose(getattr(back, part), getattr(chain, part), rtol=0, atol=atol)
    assert back.name == chain.name
    assert back.joint_names == (chain.joint_names or tuple(f"joint_{i + 1}" for i in range(chain.n)))
    if chain.limits is None or np.isinf(chain.limits).all():
        assert back.limits is None
    else:
        np.testing.assert_array_equal(back.limits, chain.limits)


@st.composite
def named_chains(draw):
    # A pitch below a nanometre a radian counts as none, and no file keeps it: so there is none here.
    screws = draw(
        st.lists(st.builds(kl.screw, directions(), points(), st.sampled_from([0.0, np.inf])), min_size=1, max_size=6)
    )
    chain = kl.Chain(np.array(screws), draw(poses()))
    bounds = st.lists(st.floats(-4, 4), min_size=2, max_size=2).map(sorted)
    ends = st.tuples(st.just(-np.inf) | st.none(), st.just(np.inf) | st.none())
    limits = [[end or bound for end, bound in zip(draw(ends), draw(bounds), strict=True)] for _ in range(chain.n)]
    letters = st.characters(exclude_categories=["C", "Z"], exclude_characters="$")
    names = draw(st.lists(st.text(letters, min_size=1), unique=True, min_size=chain.n, max_size=chain.n))
    return kl.Chain(
        chain.screws,
        chain.home,
        name=draw(st.text(letters, min_size=1)),
        limits=np.array(limits),
        joint_names=tuple(names),
    )


@given(named_chains())
def test_any_chain_is_read_back_from_its_file_here_and_by_pinocchio(chain):
    assert_same(load_urdf(to_urdf(chain)), chain)
    q = configurations(chain, 2)
    names = chain.joint_names
    expected = poses_by_pinocchio(to_urdf(chain), "base_link", "tool", names, q)
    np.testing.assert_allclose(chain.fk(q), expected, rtol=0, atol=CLOSE)


def one_joint(parts="", kind="continuous"):
    return f"""<robot name="one">
<link name="a"/>
<link name="b"/>
<joint name="j" type="{kind}"><parent link="a"/><child link="b"/>
{parts}
</joint></robot>"""


@pytest.mark.parametrize(("said", "limits"), [('upper="2"', [0, 2]), ('lower="1" upper="1"', [1, 1])])
def test_a_limit_that_is_not_given_is_0_and_a_joint_may_be_locked(said, limits):
    assert load_urdf(one_joint(f"<limit {said}/>", "revolute")).limits.tolist() == [limits]


def linked(links, *joints):
    """A URDF with one letter a link, and joints written "ab": a on top, b below it."""
    lines = [f'<link name="{name}"/>' for name in links]
    for i, (parent, child) in enumerate(joints):
        lines.append(f'<joint name="j{i}" type="continuous"><parent link="{parent}"/><child link="{child}"/></joint>')
    return "\n".join(['<robot name="r">', *lines, "</robot>"])


def test_the_tip_must_exist_and_a_joint_must_move_between_base_and_tip():
    text = linked(["base", "upper arm", "hand"], ["base", "upper arm"], ["upper arm", "hand"])
    with pytest.raises(ValueError, match=r"tip must be the name of a link; got 'uper arm'. Did you mean upper arm"):
        load_urdf(text, tip="uper arm")
    with pytest.raises(ValueError, match=r"Line 4, .*must move between hand and hand; none does"):
        load_urdf(text, "hand", "hand")


def test_of_several_fixed_ends_the_tip_is_that_which_is_called_a_tool():
    ends = (f'<link name="{end}"/><joint name="{end}" type="fixed"><parent link="b"/><child link="{end}"/></joint>'
            for end in ("camera_link", "tool_frame"))  # fmt: skip
    text = linked("ab", "ab").replace("</robot>", "".join([*ends, "</robot>"]))
    assert kl.Tree.from_urdf(text).default_tip() == "tool_frame"
    follows = text.replace("</joint>", '<mimic joint="another"/></joint>', 1)  # so no joint has a value of its own
    assert kl.Tree.from_urdf(follows).default_tip() == "tool_frame"


BOMB = "<!DOCTYPE r [<!ENTITY a 'ha'>" + "".join(f"<!ENTITY {chr(ord(a) + 1)} '{f'&{a};' * 10}'>" for a in "abcdefghi")


REFUSED = [
    (one_joint('<axis xyz="0 0 0"/>'), 'Line 5, <axis> in <joint name="j">: xyz must be a direction; got zero'),
    (one_joint('<axis xyz="0, 0, 1"/>'), 'got "0,".*Separate numbers by spaces'),
    (one_joint('<origin rpy="0 0 90"/>'), r"rpy must be .*; got 90 rad\. Is it in degrees\?"),
    (one_joint('<origin xyz="${length} 0 0"/>'), 'xyz="[$]{length} 0 0" must be evaluated by xacro first. Expand'),
    (one_joint(kind="revolute"), 'Line 4, <joint name="j">: a revolute joint must have a <limit .*continuous'),
    (one_joint('<limit lower="2" upper="1"/>', "revolute"), "Line 5, <limit> .*got 2 and 1. Are they"),
    (linked("abb", "ab"), 'Line 4, <link name="b">: the names of links must be different; line 3 has'),
    (linked("ab", "aβ"), 'Line 4, <child> in <joint name="j0">: joint j0 must join links; there is'),
    (linked("abcd", "ab", "bc", "cd", "db"), "Line 9, <child> in <joint .*link b is already the child of j0"),
    (linked("a"), r"got 0\. No joint of the file has a value"),
    (linked("abc", "ab", "ac"), r'Line 2, <link name="a">: exactly one end .*; got 2\. Choose the tip, one of b'),
    ('<robot name="r">\n<xacro:macro name="arm"/></robot>', 'Line 2, <xacro:macro name="arm">: a macro must be'),
    ("", "must begin with <robot name=...>; got an empty text"),
    ("\n" + BOMB + "]>\n<robot name='&j;'/>", "Line 2, <!DOCTYPE>: a URDF must have no document type"),
    ("<robot>" + " " * MAX_BYTES, "A URDF must have at most 4 MB; this one has more"),
    ("robot.urdf", "There is no file 'robot.urdf' to be read: .*. Pass the path of a URDF, or its text"),
]


@pytest.mark.parametrize("case", range(len(REFUSED)))  # some texts are too long for a name
def test_a_faulty_file_is_refused_with_the_line_of_its_fault(case):
    text, said = REFUSED[case]
    with pytest.raises(ValueError, match=said):
        load_urdf(text)
