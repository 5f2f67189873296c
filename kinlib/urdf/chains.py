"""URDF files as chains, and chains as URDF files.

A URDF gives the pose of each joint in the frame of its parent link, and the direction of its axis in its own frame. At q = 0
the frames on the path from base to tip are products of these poses, and give the screws in the base frame:

    T_i = Trans(xyz) Rz(yaw) Ry(pitch) Rx(roll),    J_i = T_1 T_2 ... T_i = (R_i, p_i)
    S_i = screw(R_i axis_i, p_i),    M = J_tip

A fixed joint contributes a T_i and no screw. Meshes, masses and colours do not affect the kinematics and are ignored.
"""

from __future__ import annotations

import os
from collections.abc import Sequence

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

    Revolute, continuous and prismatic joints become screws in the base frame, and fixed joints are merged. The chain keeps
    the names and the limits of the joints, and its points are the joint origins. Axes are normalized. The path may go up the
    tree and down again: the base need not be an ancestor of the tip.

    Raises ValueError, with the element and its line, if the file is not XML, not a URDF or not a tree, if a number is not
    valid, if several links could be the tip, and if a joint on the path has no chain, as `Tree.chain` says. To use several chains
    of a file or the frames of its links, or to show its meshes, read it with `Tree.from_urdf(file)`. No other file is opened.

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
    parts = [f"<robot name={quoteattr(chain.name)}>", *(f"  <link name={link}/>" for link in links)]
    rows = zip(names, chain.joint_types, chain.lines.axis, limits, steps[:-1], strict=True)
    for i, (name, letter, axis, pair, step) in enumerate(rows):
        kind = "prismatic" if letter == "P" else "revolute" if np.isfinite(pair).any() else "continuous"
        inside = [f'    <axis xyz="{_numbers(*axis)}"/>']
        if kind != "continuous":
            lower, upper = np.clip(pair, -MAX_NUMBER, MAX_NUMBER)
            inside += [f'    <limit lower="{_numbers(lower)}" upper="{_numbers(upper)}" effort="1" velocity="1"/>']
        parts += _joint(name, kind, links[i : i + 2], f'xyz="{_numbers(*step)}"', inside)
    rpy = _numbers(*roll_pitch_yaw(chain.home[:3, :3]))
    weld = next(name for name in ('"weld"', *(f'"weld_{i}"' for i in range(chain.n))) if name not in names)
    parts += _joint(weld, "fixed", links[-2:], f'xyz="{_numbers(*steps[-1])}" rpy="{rpy}"', [])
    return "\n".join([*parts, "</robot>\n"])


def _joint(name: str, kind: str, links: Sequence[str], origin: str, inside: Sequence[str]) -> list[str]:
    """Write a joint in lines: between a parent and a child link, names in quotes, with its origin, and what else is inside."""
    return [
        f'  <joint name={name} type="{kind}">',
        f"    <parent link={links[0]}/> <child link={links[1]}/>",
        f"    <origin {origin}/>",
        *inside,
        "  </joint>",
    ]


def _numbers(*values: float) -> str:
    """Numbers with as many digits as are needed to read the same numbers back."""
    return " ".join(repr(float(value) + 0.0).removesuffix(".0") for value in values)
