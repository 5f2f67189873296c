"""URDF files: those that other packages ship, with macros expanded, and random trees; and what Pinocchio makes of them."""

import warnings
from contextlib import chdir
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st
from strategies import directions, points

KUKA = "kuka_description"
TROSSEN = ["px100", "px150", "rx150", "rx200", "vx250", "vx300", "vx300s", "wx200", "wx250", "wx250s"]

ARMS = {
    "ABB IRB 140": ("rtb", "abb_irb140_description/urdf/irb140.urdf", None),
    "KUKA KR3 R540": ("rtb", f"{KUKA}/kuka_kr3/urdf/kr3r540.xacro", None),
    "KUKA KR5 arc": ("rtb", f"{KUKA}/kuka_kr5/urdf/kr5_arc.xacro", None),
    "KUKA KR6 R700": ("rtb", f"{KUKA}/kuka_kr6/urdf/kr6r700sixx.xacro", None),
    "KUKA KR6 R900": ("rtb", f"{KUKA}/kuka_kr6/urdf/kr6r900sixx.xacro", None),
    "KUKA KR10 R1100": ("rtb", f"{KUKA}/kuka_kr10/urdf/kr10r1100sixx.xacro", None),
    "KUKA KR16": ("rtb", f"{KUKA}/kuka_kr16/urdf/kr16_2.urdf", None),
    "KUKA KR120 R2500": ("rtb", f"{KUKA}/kuka_kr120/urdf/kr120r2500pro.urdf", None),
    "KUKA KR150": ("rtb", f"{KUKA}/kuka_kr150/urdf/kr150_2.xacro", None),
    "KUKA KR210 L150": ("rtb", f"{KUKA}/kuka_kr210/urdf/kr210l150.urdf", "tool0"),
    "KUKA LBR iiwa 14": ("rtb", f"{KUKA}/kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf", None),
    "Franka Panda": ("rtb", "qut_frankie_description/robots/panda_arm.urdf.xacro", None),
    "Franka Panda with hand": ("rtb", "qut_frankie_description/robots/panda_arm_hand.urdf.xacro", "panda_hand"),
    "Lynxmotion AL5D": ("rtb", "lynxmotion_al5d_description/urdf/al5d_robot.urdf", None),
    "PUMA 560": ("rtb", "unimation_puma560_description/urdf/puma560_robot.urdf", None),
    "UFactory xArm 6": ("rtb", "../armer_xarm/data/xacro/robots/xarm6/xarm6.xacro", None),
    "UR3e": ("airo", "arms/ur3e/ur3e.urdf", None),
    "UR5e": ("airo", "arms/ur5e/ur5e.urdf", None),
    **{
        f"Trossen {name}": ("rtb", f"trossen_descriptions/urdf/{name}.urdf.xacro", "/ee_gripper_link")
        for name in TROSSEN
    },
}
"""Each arm: the package, the file, and the tip, if the file has several."""


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
def urdf_text(name):
    """The URDF of an arm, as text: macros are expanded by xacro, if the package ships the file unexpanded."""
    package, file, _ = ARMS[name]
    if package == "airo":
        return (Path(pytest.importorskip("airo_models").__file__).parent / file).read_text("utf-8")
    xacro = Path(pytest.importorskip("rtbdata").__file__).parent / "xacro"
    path = (xacro / file).resolve()
    if path.suffix == ".urdf":
        return path.read_text("utf-8")
    with chdir(path.parent), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from xacrodoc import XacroDoc, packages

        kuka = {f"{folder.name}_support": folder for folder in (xacro / KUKA).iterdir() if folder.is_dir()}
        found_by_name = {**kuka, "kuka_resources": xacro / KUKA / "kuka_resources"}
        packages.update_package_cache({**found_by_name, "qut_frankie_description": xacro / "qut_frankie_description"})
        return XacroDoc.from_file(path.name, resolve_packages=False).to_urdf_string()


def link_poses_by_pinocchio(text, names, q, base=None, mimic=False):
    """The poses {link: (N, 4, 4)} of all links for values (N, n) of the named joints, by Pinocchio's own reader.

    Other joints stay at 0, mimic joints, too, unless mimic is True. base (4, 4) is the pose of the root, as a floating base.
    """
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    model = pin.buildModelFromXML(text, *([] if base is None else [pin.JointModelFreeFlyer()]), mimic=mimic)
    data = model.createData()
    links = {frame.name: i for i, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY}
    found = {link: [] for link in links}
    for row in q:
        values = pin.neutral(model)
        if base is not None:
            values[:7] = pin.SE3ToXYZQUAT(pin.SE3(base))
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
