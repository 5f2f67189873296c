"""URDF files as chains, and chains as URDF files.

A URDF says where each joint stands in the frame of the link before it, and which way its axis points in its own frame.
At q = 0 the frames on the way from base to tip are products, and with them the screws, read in the base:

    T_i = Trans(xyz) Rz(yaw) Ry(pitch) Rx(roll),    J_i = T_1 T_2 ... T_i = (R_i, p_i)
    S_i = screw(R_i axis_i, p_i),    M = J_tip

Fixed joints add a T_i and no screw. Meshes, masses and colours say nothing about motion, and are passed over.
"""

import os

import numpy as np

from kinlib.arrays import validation
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import inverse
from kinlib.rigid.rpy import roll_pitch_yaw
from kinlib.rigid.screw import screw
from kinlib.urdf.tree import ENDLESS, Joint, Tree, read_tree
from kinlib.urdf.xml import read_robot


def load_urdf(path_or_text: str | os.PathLike[str], base: str | None = None, tip: str | None = None) -> Chain:
    """Read a URDF, and make a chain of the joints on the way from one link to another.

    path_or_text  the path of a file, or the text itself, which begins with <
    base          the link whose frame is {s}; the root of the tree by default
    tip           the link whose frame is {b}; by default the only end of the tree that moves against the base

    Revolute, continuous and prismatic joints become screws in the base frame, fixed ones are merged. The chain keeps
    joint names and limits, and its points are the joint origins. An axis is brought to unit length. The way may go up the
    tree and down again: the base need not stand above the tip.

    Raises ValueError, with the element and its line, for a file that is not XML, not a URDF or not a tree, for numbers
    that are none, where the tip has to be chosen, and for joints on the way that a chain cannot hold: planar, floating
    and mimic ones. Nothing is fetched, and no other file is opened.
    Source: the URDF specification, "link" and "joint"; conventions as in urdfdom, the parser of ROS.

    >>> text = '''<robot name="crane">
    ...   <link name="ground"/> <link name="mast"/> <link name="hook"/>
    ...   <joint name="slew" type="continuous"><parent link="ground"/><child link="mast"/><axis xyz="0 0 1"/></joint>
    ...   <joint name="boom" type="fixed"><parent link="mast"/><child link="hook"/><origin xyz="2 0 3"/></joint>
    ... </robot>'''
    >>> load_urdf(text).fk([np.pi / 2])[:3, 3].round(6) + 0.0
    array([0., 2., 3.])
    """
    robot = read_robot(path_or_text)
    tree = read_tree(robot)
    base = tree.root if base is None else tree.known(base, "base")
    tip = _only_tip(tree, base) if tip is None else tree.known(tip, "tip")
    T, screws, points, moving = np.eye(4), [], [], []
    for joint, sign in tree.path(base, tip):
        # The axis stands in the frame of the child link: where the way down arrives, and where the way up sets out.
        before, T = T, T @ (joint.origin if sign > 0 else inverse(joint.origin))
        if joint.moves:
            _refuse_what_no_chain_holds(joint)
            frame = T if sign > 0 else before
            axis, point = sign * frame[:3, :3] @ joint.axis, frame[:3, 3]
            screws.append(screw(axis, point, np.inf if joint.type == "prismatic" else 0.0))
            points.append(point)
            moving.append(joint)
    if not moving:
        raise tree.links[tip].refusal(f"no joint moves between {base} and {tip}. Which links does the arm join?")
    limits = np.array([joint.limits for joint in moving])
    return Chain(
        np.array(screws),
        T,
        points=np.array(points),
        name=robot.word("name"),
        source=f"URDF, from {base} to {tip}",
        limits=limits if np.isfinite(limits).any() else None,
        joint_names=tuple(joint.name for joint in moving),
    )


def to_urdf(chain: Chain) -> str:
    """Write a chain as a URDF that loads back into the same chain.

    At home every frame is parallel to {s}, so that an axis reads as in the base, and an origin is the step from one
    joint's point to the next. A fixed joint carries what is left to the home pose. Joints without names are joint_1 and
    so on. Effort and velocity, which URDF asks for and kinematics does not know, are 1.

    Raises ValueError for a helical joint, which no URDF holds, and for names that none can tell apart or print.
    Source: the URDF specification, "joint".

    >>> from kinlib.chains.robots import youbot
    >>> np.allclose(load_urdf(to_urdf(youbot())).screws, youbot().screws, atol=1e-15)
    True
    """
    if "H" in chain.joint_types:
        raise ValueError(
            f"Joint {chain.joint_types.index('H') + 1} of {chain.name} is helical: it turns and climbs at once. URDF has "
            "joints that turn and joints that slide, and none that couples the two."
        )
    names = chain.joint_names or tuple(f"joint_{i + 1}" for i in range(chain.n))
    if len(set(names)) < chain.n:
        raise ValueError(f"A URDF tells joints apart by their names; got {', '.join(names)}.")
    weld = next(name for name in ("weld", *(f"weld_{i}" for i in range(chain.n))) if name not in names)
    links = ["base_link", *(f"link_{i + 1}" for i in range(chain.n)), "tool"]
    limits = np.full((chain.n, 2), (-np.inf, np.inf)) if chain.limits is None else chain.limits
    steps = np.diff([np.zeros(3), *chain.joint_points, chain.home[:3, 3]], axis=0)
    parts = [f"<robot name={_quoted(chain.name)}>", *(f'  <link name="{link}"/>' for link in links)]
    for i, axis in enumerate(chain.lines.axis):
        endless = chain.joint_types[i] == "R" and np.isinf(limits[i]).all()
        kind = "continuous" if endless else "revolute" if chain.joint_types[i] == "R" else "prismatic"
        lower, upper = np.clip(limits[i], -ENDLESS, ENDLESS)
        parts += [
            f'  <joint name={_quoted(names[i])} type="{kind}">',
            f'    <parent link="{links[i]}"/> <child link="{links[i + 1]}"/>',
            f'    <origin xyz="{_numbers(*steps[i])}"/>',
            f'    <axis xyz="{_numbers(*axis)}"/>',
        ]
        if not endless:
            parts += [f'    <limit lower="{_numbers(lower)}" upper="{_numbers(upper)}" effort="1" velocity="1"/>']
        parts += ["  </joint>"]
    parts += [
        f'  <joint name="{weld}" type="fixed">',
        f'    <parent link="{links[-2]}"/> <child link="{links[-1]}"/>',
        f'    <origin xyz="{_numbers(*steps[-1])}" rpy="{_numbers(*roll_pitch_yaw(chain.home[:3, :3]))}"/>',
        "  </joint>",
        "</robot>\n",
    ]
    return "\n".join(parts)


def _only_tip(tree: Tree, base: str) -> str:
    tips = tree.tips(base)
    if len(tips) != 1:
        choices = f"It may be {', '.join(tips)}." if tips else "Below the base nothing moves."
        raise tree.links[base].refusal(f"which link is the tip of the arm that stands here? Say tip=... {choices}")
    return tips[0]


def _refuse_what_no_chain_holds(joint: Joint) -> None:
    freedoms = {"planar": 3, "floating": 6}
    if joint.type in freedoms:
        raise joint.element.refusal(
            f"a {joint.type} joint moves in {freedoms[joint.type]} ways at once, and a joint of a chain in one. Take a "
            f"base behind it, such as {joint.child}."
        )
    if (mimic := joint.element.only("mimic")) is not None:
        raise mimic.refusal(
            f"joint {joint.name} copies another joint, and the joints of a chain move on their own. Take a tip before it, "
            f"such as {joint.parent}."
        )


def _numbers(*values: float) -> str:
    """Numbers with all the digits that they need to come back the same, and no more."""
    return " ".join(repr(float(value) + 0.0).removesuffix(".0") for value in values)


def _quoted(name: str) -> str:
    from xml.sax.saxutils import quoteattr

    if not name.isprintable() or not name:
        raise ValueError(f"A name in a URDF should be letters that print; got {validation.describe(name)}.")
    return quoteattr(name)
