"""URDF files that other packages ship: every arm of rtb-data and airo-models, with macros expanded."""

import warnings
from contextlib import chdir
from functools import cache
from pathlib import Path

import numpy as np
import pytest

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


def poses_by_pinocchio(text, base, tip, names, q):
    """The poses of tip in base for values (N, n) of the named joints, by Pinocchio's own reader; other joints stay at 0."""
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    model = pin.buildModelFromXML(text)
    data = model.createData()
    base, tip = (model.getFrameId(link, pin.FrameType.BODY) for link in (base, tip))
    found = []
    for row in q:
        values = pin.neutral(model)
        for name, value in zip(names, row, strict=True):
            joint = model.joints[model.getJointId(name)]
            # A continuous joint of Pinocchio is a point of the circle.
            values[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if joint.nq == 2 else [value]
        pin.framesForwardKinematics(model, data, values)
        found.append((data.oMf[base].inverse() * data.oMf[tip]).homogeneous)
    return np.array(found)
