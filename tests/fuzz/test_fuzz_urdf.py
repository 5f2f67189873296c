"""Fuzz the URDF reader: a corrupted file is refused with a sentence, or read as the arm that Pinocchio reads from it."""

import atexit
import shutil
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from assertions import assert_explained, assert_rigid
from corruption import LETTERS, PIECE, corrupted_texts, mostly, noise, often, pieces, random_sources
from fuzz_settings import fuzz_settings
from hypothesis import given
from hypothesis import strategies as st
from strategies import ROBOT_FUNCTIONS, configurations
from urdf_files import poses_by_pinocchio

from kinlib import Tree, load_urdf, to_urdf

CRANE = """<?xml version="1.0" encoding="UTF-8"?>
<!-- a crane on a truck -->
<robot name="crane" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <material name="blue"><color rgba="0 0 0.8 1"/></material>
  <link name="truck"/> <link name="mast"/> <link name="boom"><visual><origin xyz="1 2 3"/></visual></link>
  <link name="trolley"/> <link name="hook"/> <link name="lamp"/>
  <joint name="slew" type="continuous">
    <parent link="truck"/> <child link="mast"/> <origin xyz="0.5 0 2" rpy="0 0 1.5708"/> <axis xyz="0 0 1"/>
  </joint>
  <joint name="luff" type="revolute">
    <parent link="mast"/> <child link="boom"/> <axis xyz="0 -1 0"/> <limit lower="-0.2" upper="1.4" effort="1" velocity="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="boom"/> <child link="trolley"/> <origin xyz="1 0 0"/> <axis xyz="1 0 0"/>
    <limit lower="0" upper="8" effort="1" velocity="1"/> <dynamics damping="0.7"/>
  </joint>
  <joint name="weld" type="fixed"><parent link="trolley"/><child link="hook"/><origin rpy="0 -3.14159 0"/></joint>
  <joint name="bulb" type="floating"><parent link="boom"/><child link="lamp"/></joint>
  <transmission name="t"><joint name="slew"/></transmission>
</robot>
"""
MIMIC = """<robot name="hand"><link name="palm"/><link name="finger"/><link name="thumb"/>
<joint name="close" type="prismatic"><parent link="palm"/><child link="finger"/><limit upper="1e-2"/></joint>
<joint name="copy" type="prismatic"><parent link="palm"/><child link="thumb"/><limit lower="-1" upper="1"/>
<mimic joint="close" multiplier="-1"/></joint></robot>"""

WORDS = r"""
<robot>  </robot>  <link name="truck"/>  <link name="x"/>  <!--  -->  <![CDATA[  ]]>  <?xml?>
<!DOCTYPE r [<!ENTITY a "aaaa">]>  <!ENTITY x SYSTEM "file:///etc/passwd">  &a;  &amp;  &#0;  &#x41;  <a>  </a>
<axis/>  <origin/>  <limit/>  <mimic/>  <joint>  fixed  planar  revolute  spherical  continuous  prismatic
truck  hook  encoding="utf-16"  encoding="rot13"  encoding="idna"  xacro:if  ${a}  $(find x)  xyz="1 0 0"
rpy="1.5708 0 0"  name="slew"  180  5e5  1e-7
"""
CUTS = (r'(?<==")[^"]*(?=")', r'(?<=["\s])-?[\d.]+(?=["\s])', r"<[^>]*>", r'\w+="[^"]*"', PIECE)
"""Values, numbers, elements, attributes, and anything."""

CODINGS = ("utf-8", "utf-16", "utf-16-le", "utf-32", "latin-1", "cp1252", "utf-7", "ebcdic-cp-us")


NUMBERS_OF_AN_ARM = (
    *pieces(
        "0  -0  1  -1  0.5  1.  .5  1e-320  1E1  +3  -2.25  1.5708  3.14159265358979  -1.570796  1e-7  1e-5  -1e-6"
    ),
    *("999999", "1e6", "12.566", "9" * 400, "0." + "0" * 400 + "1"),
)


def arm(chance):
    """An arm with an odd number wherever a number is allowed."""

    def three():
        return " ".join(chance.choice([*NUMBERS_OF_AN_ARM, repr(chance.uniform(-9, 9))]) for _ in range(3))

    parts = ['<robot name="arm">', '<link name="l0"/>']
    for i in range(chance.randint(1, 5)):
        kind = chance.choice(["revolute", "continuous", "prismatic", "fixed"])
        parts.append(
            f'<link name="l{i + 1}"/><joint name="j{i}" type="{kind}"><origin xyz="{three()}" rpy="{three()}"/>'
            f'<parent link="l{chance.choice([0, i, i])}"/><child link="l{i + 1}"/><axis xyz="{three()}"/>'
            f'<limit lower="-{i}" upper="{chance.choice(NUMBERS_OF_AN_ARM)}" effort="1" velocity="1"/></joint>'
        )
    return "\n".join([*parts, "</robot>"])


def cases():
    """The text, the encoding of its file (None for text that is passed directly), base and tip."""
    ours = [to_urdf(family()) for family in ROBOT_FUNCTIONS if "H" not in family().joint_types]
    documents = st.sampled_from([CRANE, CRANE, MIMIC, *ours]) | random_sources().map(arm)
    texts = often(20, corrupted_texts(documents, WORDS, CUTS), noise().map("<{}".format), noise())
    tips = mostly([*[None] * 8, "hook", "trolley", "tool", "l1", "l3", "finger"], ["lamp", "thumb", "", *LETTERS])
    bases = mostly([None], ["truck", "boom", "hook", "l2", "", *LETTERS])
    return st.tuples(texts, mostly([None], CODINGS), bases, tips)


@fuzz_settings(150)
@given(st.deferred(cases))
def test_urdf_text_is_refused_with_a_sentence_or_read_as_pinocchio_reads_it(case):
    text, coding, base, tip = case
    try:
        chain = load_urdf(*_given(text, coding), base, tip)
    except ValueError as error:
        assert_explained(error)
        return
    q = configurations(chain, 3)
    poses, reach = chain.fk(q), 1 + np.abs(chain.screws).max() + np.abs(chain.home).max()
    assert_rigid(poses)
    try:
        again = load_urdf(to_urdf(chain))
    except ValueError as error:
        assert_explained(error)
    else:
        np.testing.assert_allclose(again.fk(q), poses, rtol=0, atol=1e-9 * reach)
        assert (again.name, again.joint_names) == (chain.name, chain.joint_names)
    witness = _as_pinocchio(text, chain, q) if coding is None else None
    if witness is not None:
        np.testing.assert_allclose(poses, witness, rtol=0, atol=1e-9 * reach)


def _given(text, coding):
    if coding is None:
        return [text]
    path = _folder() / "robot.urdf"
    path.write_bytes(text.encode(coding if coding != "ebcdic-cp-us" else "cp037", errors="ignore"))
    return [path]


@cache
def _folder():
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    return folder


def _as_pinocchio(text, chain, q):
    """The poses by Pinocchio's own reader; None if it refuses the file."""
    base, tip = chain.source.removeprefix("URDF, from ").split(" to ")
    try:
        tree = Tree.from_urdf(text)
        independent = np.zeros((len(q), tree.n))
        independent[:, [tree.joint_names.index(name) for name in chain.joint_names]] = q
        return poses_by_pinocchio(text, base, tip, tree.moving_joint_names, tree.joint_values(independent))
    except (ValueError, RuntimeError, IndexError):
        return None
