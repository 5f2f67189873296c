"""URDF files as chains, and chains as URDF files."""

from __future__ import annotations

import os

import numpy as np

from kinlib.arrays import validation
from kinlib.chains.chain import Chain
from kinlib.rigid.rpy import roll_pitch_yaw
from kinlib.urdf.links_and_joints import MAX_NUMBER
from kinlib.urdf.robot_tree import Tree


def load_urdf(path_or_text: str | os.PathLike[str], base: str | None = None, tip: str | None = None) -> Chain:
    """Read a URDF, and build a chain from the joints on the path from one link to another.

    path_or_text  the path of a file, or its text, which begins with <
    base          the link whose frame is {s}; by default the root of the tree
    tip           the link whose frame is {b}; by default `Tree.default_tip(base)`: the end of the arm, without the fingers of a gripper

    A URDF gives the pose of each joint in the frame of its parent link, and the direction of its axis in its own frame. At q = 0
    the frames on the path are products of these poses, and give the screws in the base frame:

        T_i = Trans(xyz) Rz(yaw) Ry(pitch) Rx(roll),    J_i = T_1 T_2 ... T_i = (R_i, p_i)
        S_i = screw(R_i axis_i, p_i),    M = J_tip

    Axes are normalized, and a fixed joint contributes a T_i and no screw. The path may go up the tree and down again: the base
    need not be an ancestor of the tip. The chain keeps the names and the limits of the joints, and its points are the joint
    origins. A mimic joint that is +-1 times an independent joint, plus an offset, takes the name and the limits of that joint.
    Meshes, masses and colours are ignored, because they do not affect the kinematics.

    Raises ValueError, with the element and its line, if the file is not XML, not a URDF or not a tree, if a number is not
    valid, if several links could be the tip, and if between base and tip no joint moves, a joint is planar or floating, two follow the
    same joint, or one has another multiplier than +-1. To use several chains of a file or the frames of its links, or to show its
    meshes, read it with `Tree.from_urdf(file)`. No other file is opened.

    It also refuses what urdfdom, the parser of ROS, reads: a second parent that closes a loop, lower > upper, an axis of length 0,
    and an rpy in degrees; and it does not need effort and velocity.
    Source: the URDF specification, "link" and "joint"; the meaning of its elements as in urdfdom.

    >>> text = '''<robot name="crane">
    ...   <link name="ground"/> <link name="mast"/> <link name="hook"/>
    ...   <joint name="slew" type="continuous"><parent link="ground"/><child link="mast"/><axis xyz="0 0 1"/></joint>
    ...   <joint name="boom" type="fixed"><parent link="mast"/><child link="hook"/><origin xyz="2 0 3"/></joint>
    ... </robot>'''
    >>> load_urdf(text).fk([np.pi / 2])[:3, 3].round(6) + 0.0
    array([0., 2., 3.])
    """
    return Tree.from_urdf(path_or_text).chain(base, tip)


def to_urdf(chain: Chain) -> str:
    """Write a chain as the text of a URDF; what load_urdf reads back has the same motion of the tool.

    At the home position every frame is parallel to {s}, so an axis has the same components as in the base, and an origin is the
    vector from one joint's point to the next. A fixed joint at the end completes the home pose. Joints without names are called
    joint_1, joint_2, ..., and the links base_link, link_1, ..., tool. The limits of effort and velocity, which URDF requires and
    kinlib does not have, are 1.

    Raises ValueError if a joint is helical, because URDF has no such joint.
    Source: the URDF specification, "joint".

    >>> np.allclose(load_urdf(to_urdf(kl.robots.youbot())).screws, kl.robots.youbot().screws, atol=1e-15)
    True
    """
    from xml.sax.saxutils import quoteattr

    validation.instance(chain, "chain", Chain)
    if "H" in chain.joint_types:
        raise ValueError(
            f"URDF has no helical joint; joint {chain.joint_types.index('H') + 1} of {chain.name} must be revolute or prismatic."
        )
    names = [quoteattr(name) for name in chain.joint_names or (f"joint_{i + 1}" for i in range(chain.n))]
    links = ['"base_link"', *(f'"link_{i + 1}"' for i in range(chain.n)), '"tool"']
    limits = np.full((chain.n, 2), (-np.inf, np.inf)) if chain.limits is None else chain.limits
    steps = np.diff([np.zeros(3), *chain.joint_points, chain.home[:3, 3]], axis=0)
    names.append(next(name for name in ('"weld"', *(f'"weld_{i}"' for i in range(chain.n))) if name not in names))
    origins = [f'xyz="{_numbers(*step)}"' for step in steps]
    origins[-1] += f' rpy="{_numbers(*roll_pitch_yaw(chain.home[:3, :3]))}"'
    kinds = [
        "prismatic" if letter == "P" else "revolute" if np.isfinite(pair).any() else "continuous"
        for letter, pair in zip(chain.joint_types, limits, strict=True)
    ]
    parts = [f"<robot name={quoteattr(chain.name)}>", *(f"  <link name={link}/>" for link in links)]
    for i, kind in enumerate([*kinds, "fixed"]):
        parts += [
            f'  <joint name={names[i]} type="{kind}">',
            f"    <parent link={links[i]}/> <child link={links[i + 1]}/>",
            f"    <origin {origins[i]}/>",
        ]
        if kind != "fixed":
            parts.append(f'    <axis xyz="{_numbers(*chain.lines.axis[i])}"/>')
        if kind in {"revolute", "prismatic"}:
            lower, upper = map(_numbers, np.clip(limits[i], -MAX_NUMBER, MAX_NUMBER))
            parts.append(f'    <limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>')
        parts.append("  </joint>")
    return "\n".join([*parts, "</robot>\n"])


def _numbers(*values: float) -> str:
    """Numbers with as many digits as are needed to read the same numbers back."""
    return " ".join(repr(float(value) + 0.0).removesuffix(".0") for value in values)
