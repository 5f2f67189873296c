"""URDF files: one that another package ships, and random trees; and what Pinocchio makes of them."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st
from strategies import directions, points

TWO_FINGERS = """<robot name="gripper">
  <link name="floor"/> <link name="palm"/> <link name="left"/> <link name="right"/> <link name="pad"/> <link name="lamp"/>
  <joint name="turn" type="revolute"> <parent link="floor"/> <child link="palm"/> <origin xyz="0 0 0.2"/> <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/> </joint>
  <joint name="open" type="prismatic"> <parent link="palm"/> <child link="left"/> <origin xyz="0 0.05 0.1"/> <axis xyz="0 1 0"/>
    <limit lower="0" upper="0.05" effort="1" velocity="1"/> </joint>
  <joint name="follow" type="prismatic"> <parent link="palm"/> <child link="right"/> <origin xyz="0 -0.05 0.1"/> <axis xyz="0 1 0"/>
    <limit lower="-0.1" upper="0" effort="1" velocity="1"/> <mimic joint="open" multiplier="-2" offset="-0.01"/> </joint>
  <joint name="glue" type="fixed"> <parent link="right"/> <child link="pad"/> <origin xyz="0 0 0.05"/> </joint>
  <joint name="arm" type="fixed"> <parent link="palm"/> <child link="lamp"/> <origin xyz="0.2 0 0.1"/> </joint>
</robot>"""
"""A gripper on a turning palm: two fingers, one of which mimics the other at twice the speed, and a lamp beside them."""


@cache
def ur5e_urdf():
    """The URDF of the UR5e, which a package ships as it is."""
    return (Path(pytest.importorskip("airo_models").__file__).parent / "arms" / "ur5e" / "ur5e.urdf").read_text("utf-8")


def link_poses_by_pinocchio(text, names, q):
    """The poses {link: (N, 4, 4)} of all links for values (N, n) of the named joints, by Pinocchio's own reader.

    Other joints stay at 0, mimic joints, too.
    """
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    model = pin.buildModelFromXML(text)
    data = model.createData()
    links = {frame.name: i for i, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY}
    found = {link: [] for link in links}
    for row in q:
        values = pin.neutral(model)
        for name, value in zip(names, row, strict=True):
            joint = model.joints[model.getJointId(name)]
            # A continuous joint of Pinocchio is a point of the circle.
            values[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if joint.nq == 2 else [value]
        pin.framesForwardKinematics(model, data, values)
        for link, i in links.items():
            found[link].append(data.oMf[i].homogeneous)
    return {link: np.array(poses) for link, poses in found.items()}


def poses_by_pinocchio(text, base, tip, names, q):
    """The poses of tip in base for values (N, n) of the named joints, by Pinocchio's own reader; other joints stay at 0."""
    poses = link_poses_by_pinocchio(text, names, q)
    return np.linalg.solve(poses[base], poses[tip])


# --- random trees ---


@st.composite
def trees(draw, mimic=False):
    """A URDF of two to eight links, in any order, with mimic joints if wanted, and two of its links to join."""
    n = draw(st.integers(2, 8))
    names = draw(st.permutations([f"link {i}" for i in range(n)]))
    elements = [f'<link name="{name}"/>' for name in names]
    moving = []
    for i in range(1, n):
        kind = draw(st.sampled_from(["revolute", "continuous", "prismatic", "fixed"]))
        lower, upper = sorted(draw(st.tuples(st.floats(-3, 3), st.floats(-3, 3))))
        size = draw(st.floats(0.1, 10))
        parts = [
            f'<parent link="{names[draw(st.integers(0, i - 1))]}"/>',
            f'<child link="{names[i]}"/>',
            f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>',
            *([f'<axis xyz="{spaced(size * draw(directions()))}"/>'] if draw(st.booleans()) else []),
            *([f"<origin {draw(origins())}/>"] if draw(st.booleans()) else []),
        ]
        if mimic and moving and draw(st.booleans()):
            numbers = {"multiplier": st.sampled_from([-1.0, 1.0, 0.5]), "offset": st.floats(-2, 2)}
            given = [f'{name}="{draw(values)!r}"' for name, values in numbers.items() if draw(st.booleans())]
            parts.append(f'<mimic joint="{draw(st.sampled_from(moving))}" {" ".join(given)}/>')
        moving += [f"joint {i}"] if kind != "fixed" else []
        joint = f'<joint name="joint {i}" type="{kind}">{"".join(draw(st.permutations(parts)))}</joint>'
        elements.insert(draw(st.integers(0, len(elements))), joint)
    text = "\n".join(['<robot name="tree">', *elements, "</robot>"])
    return text, draw(st.sampled_from(names)), draw(st.sampled_from(names))


@st.composite
def origins(draw):
    xyz, rpy = draw(points()), draw(points(6))
    parts = [f'xyz="{spaced(xyz)}"', f'rpy="{spaced(rpy)}"']
    return " ".join(draw(st.lists(st.sampled_from(parts), unique=True)))


def spaced(values):
    return " ".join(repr(float(value)) for value in values)
