"""Sheet 09: reading URDF files by hand: poses, axes, screws, the home pose, trees, mimic joints and faulty lines."""

from collections.abc import Sequence

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import OriginAnswer, PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.expressions.planar import length, polar
from kincourse.expressions.poses import assemble, point, translation
from kincourse.expressions.screws import direction, revolute
from kincourse.expressions.urdf import rpy_rotation
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.drawn_machines import is_readable, lengths, misread
from kincourse.text.urdf_text import (
    UrdfJoint,
    fence_urdf,
    format_values,
    random_oblique_angles,
    random_right_angles,
    robot_urdf,
    serial_urdf,
)
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z
from misstep.answers.ordering import Ordering
from misstep.answers.prose import Prose
from misstep.display.text import number, vector
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression, Operation, given, product, transpose
from misstep.mutants.operations import ANGLE, LENGTH, concatenate, cos, sin, stack

TITLE = "Robots as URDF files"

PARENT_ADVICE = "`xyz` is in the frame of the parent, so the last column is $p$ itself."
absolute = Operation("absolute values", np.abs, "|{0}|".format)

LINKS = ("base", "boom", "forearm", "hand")
ROUNDING_NOTE = "Take `1.5708` for a right angle."

SYMBOLS_NOTE = "Call the rotation and the `xyz` of the origin of `joint_i` $R_i$ and $p_i$, and its pose $T_i$."


@problem("09.1", "The pose of a joint", points=2, lecture="09_urdf#Roll, pitch and yaw", level="Warm-up")
def pose_of_a_joint(sampler: ArmSampler) -> Problem:
    xyz, rpy = sampler.point(3), random_right_angles(sampler, sampler.choice([2, 3]))
    element = f'<origin xyz="{format_values(xyz)}" rpy="{format_values(rpy)}"/>'
    R, p = rpy_rotation("R", rpy), point("p", xyz)
    rotated_too = "rotate the translation as well: $R\\,p$"
    T = assemble(R, p.mistaken_for(("translation rotated", rotated_too, R @ p, PARENT_ADVICE)))
    return Problem(
        statement=f"A joint of a URDF file has this origin:\n\n{fence_urdf(element)}\n\nGive the pose of the joint frame in the "
        f"frame of the parent link at $q = 0$. {ROUNDING_NOTE}",
        further="Give the `origin` of the parent as the child sees it.",
        shown={"xyz": xyz, "rpy": rpy},
        answer=PoseAnswer(T.value),
        solution=T.mistaken_for(
            ("xyz and rpy swapped", "swap `xyz` and `rpy`", assemble(rpy_rotation("R", xyz), given("rpy", rpy)))
        ).mistaken_for(("rotation left out", "leave out the rotation", assemble(np.eye(3), p)), spoils=True),
    )


def _random_axis(sampler: ArmSampler, sizes: Sequence[float] = (0.0, 0.6, 0.8)) -> Array:
    """Draw a unit vector with components of different sizes, so that it shows how it was rotated."""
    return np.array(sampler.shuffled(sizes)) * [sampler.choice((-1, 1)) for _ in range(3)]


def _three_joints(sampler: ArmSampler) -> list[UrdfJoint]:
    """Draw three joints of an arm, each rotated against the one before, the first of them about two axes.

    With two axes it can be seen whether the axes of `rpy` were taken as fixed or as moving.
    """
    return [
        UrdfJoint(f"joint_{k + 1}", sampler.point(3), random_right_angles(sampler, sampler.choice([1, 2]) if k else 2))
        for k in range(3)
    ]


def _origin(k: int, joint: UrdfJoint) -> tuple[Expression, Expression]:
    """The rotation and the position of a joint in the frame of its parent."""
    return rpy_rotation(f"R_{k}", np.asarray(joint.rpy)), given(f"p_{k}", np.asarray(joint.xyz))


def _position(origins: Sequence[tuple[Expression, Expression]]) -> Expression:
    """The position of joint 3 in the base frame: p_1 + R_1 p_2 + R_1 R_2 p_3."""
    (R1, p1), (R2, p2), (R3, p3) = origins
    own = p3.mistaken_for(
        ("translation rotated", "rotate the step of `joint_3` by its own `rpy`", R3 @ p3, PARENT_ADVICE)
    )
    p = p1 + R1 @ p2 + R1 @ R2 @ own
    back = "in the frame of `joint_3`"
    return p.mistaken_for(
        ("frame not changed", "use the `xyz` of `joint_3` as it is, which is in the frame of its parent", p3),
        ("joint left out", "leave out `joint_2`", p1 + R1 @ p3),
        ("joint left out", "leave out `joint_1`", p2 + R2 @ p3),
        ("order", "swap `joint_1` and `joint_2`", p2 + R2 @ (p1 + R1 @ p3)),
        ("translation rotated", "rotate each step by its own `rpy` as well", R1 @ (p1 + R2 @ (p2 + R3 @ p3))),
        ("reversed", "go from the tip to the base", p3 + R3 @ p2 + R3 @ R2 @ p1),
        ("rotation left out", "leave out the rotation of the step of `joint_3`", p1 + R1 @ p2 + p3),
        ("rotation transposed", "transpose the rotations", p1 + R1.T @ p2 + (R1 @ R2).T @ p3),
        ("rotation left out", "add the three `xyz` without rotating them", p1 + p2 + p3),
        ("inverse", f"give the origin of the base {back}", -(transpose(R1 @ R2 @ R3) @ p)),
    )


@problem("09.2", "The path through a tree", points=3, lecture="09_urdf#A URDF is a tree", level="Warm-up")
def path_through_a_tree(sampler: ArmSampler) -> Problem:
    a, b, c, d = sampler.shuffled(["pan", "tilt", "swing", "twist", "bend", "yaw"])[:4]
    near, far = sampler.shuffled(["left", "right"])
    joints = [
        (a, "torso", f"{near}_arm", "continuous"),
        (b, f"{near}_arm", f"{near}_wrist", "continuous"),
        (f"{near}_weld", f"{near}_wrist", f"{near}_hand", "fixed"),
        (c, "torso", f"{far}_arm", "continuous"),
        (d, f"{far}_arm", f"{far}_wrist", "continuous"),
        (f"{far}_weld", f"{far}_wrist", f"{far}_hand", "fixed"),
        ("neck", "torso", "head", "continuous"),
    ]
    shown = sampler.shuffled(joints)
    while [name for name, *_ in shown if name in {a, b, c, d}] in ([b, a, c, d], [a, b, c, d]):
        shown = sampler.shuffled(joints)  # otherwise two options would be the same
    links = ["torso", *sorted(child for _, _, child, _ in joints)]
    text = robot_urdf(
        links,
        (
            f'<joint name="{name}" type="{kind}">\n  <parent link="{parent}"/> <child link="{child}"/>\n</joint>'
            for name, parent, child, kind in shown
        ),
    )
    paths = {
        "right": [b, a, c, d],
        "from the root": [a, b, c, d],
        "below the root only": [c, d],
        "welds too": [f"{near}_weld", b, a, c, d, f"{far}_weld"],
        "as in the file": [name for name, *_ in shown if name in {a, b, c, d}],
    }
    why = {
        "from the root": f"You listed the joints of the {near} arm from the root `torso` outwards. The path starts at `{near}_hand`, "
        f"so its first joint that moves is `{b}`.",
        "below the root only": f"You started at the root `torso`. The base is `{near}_hand`, so the joints from there to the torso "
        "move the tip as well.",
        "welds too": "You listed the fixed joints as well. They are on the path, but they have no joint value.",
        "as in the file": "You listed the joints in the order of the file. Joints may be written in any order; only `parent` and `child` "
        "say which joint comes next.",
    }
    return Problem(
        statement=f"Take the chain in this file from the base `{near}_hand` to the tip `{far}_hand`. Which joints have a value in "
        f"$q$, and in which order? Answer with a list of their names, such as `['neck', '{a}']`.\n\n{fence_urdf(text)}",
        method=f"From `{near}_hand` the path goes up to `torso`, over `{near}_weld`, `{b}` and `{a}`, and then down to `{far}_hand`, over "
        f"`{c}`, `{d}` and `{far}_weld`. The two fixed joints have no value.",
        further="Which link do both hands share, and how many joints move both?",
        given={"urdf": text},
        shown={"base": f"{near}_hand", "tip": f"{far}_hand"},
        answer=Ordering(paths["right"], among=[name for name, *_ in joints]),
        mistakes=[Mistake(name, paths[name], why[name]) for name in why],
    )


@problem("09.3", "A joint deep in the file", points=3, lecture="09_urdf#What a joint says")
def joint_deep_in_the_file(sampler: ArmSampler) -> Problem:
    joints = _three_joints(sampler)
    text = serial_urdf(joints, LINKS)
    p = _position([_origin(k, joint) for k, joint in enumerate(joints, start=1)])
    return Problem(
        statement="Give the position of the origin of `joint_3` in the frame of the base when all joint values are 0. "
        f"{SYMBOLS_NOTE} {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        further="Which `rpy` can you change without moving the origin of `joint_3`?",
        shown={"urdf": text},
        answer=VectorsAnswer(p, unit="m"),
        advice={
            "rotation left out": "Each `xyz` is in the frame of its parent.\nSo $p = p_1 + R_1 p_2 + R_1 R_2\\,p_3$.",
            "order": "From the base outwards, the first joint is on the left: $R_1 R_2$.",
        },
    )


@problem("09.4", "A screw axis from a file", points=4, lecture="09_urdf#From the file to screws")
def screw_from_a_file(sampler: ArmSampler) -> Problem:
    joints = _three_joints(sampler)
    axis = _random_axis(sampler)
    joints[2] = UrdfJoint("joint_3", joints[2].xyz, joints[2].rpy, axis)
    text = serial_urdf(joints, LINKS)
    origins = [_origin(k, joint) for k, joint in enumerate(joints, start=1)]
    (R1, p1), (R2, p2), (R3, _) = origins
    a, z, p = direction("a", axis), given("z", Z), _position(origins)
    omega = R1 @ R2 @ R3 @ a
    omega = omega.mistaken_for(
        ("frame not changed", "use the axis as it is, which is in the joint's own frame", a),
        ("frame not changed", "rotate the axis by its own `rpy` only", R3 @ a),
        ("another axis", "use the $z$ axis of the joint instead of its `axis`", R1 @ R2 @ R3 @ z),
        ("another axis", "use the $x$ axis of the joint instead of its `axis`", R1 @ R2 @ R3 @ X),
        ("rotation transposed", "rotate the axis by $R^T$", transpose(R1 @ R2 @ R3) @ a),
    )
    S = revolute(omega, p.named("p"))
    own = a, 0 * p
    S = S.mistaken_for(
        ("own origin left out", "leave out the `origin` of `joint_3` itself", revolute(R1 @ R2 @ a, p1 + R1 @ p2)),
        ("frame not changed", "give the screw axis in the frame of `joint_3`", revolute(*own)),
        ("another joint", "give the screw axis of `joint_2`", revolute(R1 @ R2 @ z, p1 + R1 @ p2)),
        ("another joint", "give the screw axis of `joint_1`", revolute(R1 @ z, p1)),
    )
    return Problem(
        statement=f"Give the screw axis of `joint_3` in the frame of the base. "
        f"{SYMBOLS_NOTE} {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        further="Which parts of the file could you change without changing this screw axis?",
        shown={"urdf": text},
        answer=ScrewsAnswer(S),
        # With right angles, R_3 R_1 R_2 is often R_1 R_2 R_3; it is not an order in which people multiply.
        invisible={"first factor"},
    )


@problem("09.5", "The home pose from a file", points=3, lecture="09_urdf#From the file to screws")
def home_from_a_file(sampler: ArmSampler) -> Problem:
    joints = _three_joints(sampler)
    weld = UrdfJoint("weld", sampler.point(3), random_right_angles(sampler, 1), kind="fixed")
    drawn = sampler.point(3)
    text = serial_urdf([*joints[:2], weld], LINKS)
    box = f'  <visual>\n    <origin xyz="{format_values(drawn)}"/>\n    <geometry> <box size="1 1 1"/> </geometry>\n  </visual>'
    visual = f'<link name="hand">\n{box}\n</link>'
    text = text.replace('<link name="hand"/>', visual)
    origins = [_origin(k, joint) for k, joint in enumerate([*joints[:2], weld], start=1)]
    T1, T2, T3 = (assemble(R, p).named(f"T_{k}") for k, (R, p) in enumerate(origins, start=1))
    of_box = translation(given("b", drawn))
    instead = "use the `origin` of the `visual` instead of that of the fixed joint"
    M = T1 @ T2 @ T3.mistaken_for(("visual for joint", instead, of_box))
    rotation, added = (R for R, _ in origins), sum((p for _, p in origins[1:]), origins[0][1])
    M = M.mistaken_for(
        ("visual added", "multiply by the `origin` of the `visual`, which moves no frame", M @ of_box),
        ("frame not changed", "give the pose of the fixed joint in the frame of its parent", T3),
        ("rotation transposed", "transpose the rotation of $M$", assemble(M.T[:3, :3], M[:3, 3])),
        ("positions added", "add the positions without rotating them", assemble(product(*rotation), added)),
    )
    return Problem(
        statement=f"Give the home pose $M$ of the link `hand` in the frame of the base. "
        f"{SYMBOLS_NOTE} `weld` is joint 3. {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        further="Where does the file say how the hand is drawn, and does $M$ depend on it?",
        shown={"urdf": text},
        answer=PoseAnswer(M),
        advice={
            "leave out $T_3$": "A fixed joint does not move, but it has a pose.",
            "reversed": "Each origin is in the frame before it, so the joint at the base is leftmost.",
            "order": "Each origin is in the frame before it, so the joint at the base is leftmost.",
        },
    )


@problem("09.6", "From a DH row to a URDF", points=3, lecture="09_urdf#The youBot, from a table and from a file")
def from_a_dh_row(sampler: ArmSampler) -> Problem:
    a, d = sampler.length(0.2, 0.9), sampler.length(0.2, 0.9)
    # Not 45 degrees, whose sine is its cosine, and no right angle, whose sine leaves a length as it is.
    degrees = sampler.choice((-1, 1)) * sampler.choice([20, 25, 30, 35, 55, 60, 65, 70])
    alpha = float(np.radians(degrees))
    return Problem(
        statement=f"A modified DH table has the row $a_{{i-1}} = {number(a)}$ m, $\\alpha_{{i-1}} = {degrees}°$, $d_i = {number(d)}$ m, "
        '$\\theta_i = q_i$. Write it as a joint of a URDF file with `<axis xyz="0 0 1"/>` and the same frames. Give the `xyz` and the '
        "`rpy` of its `origin` in two rows, in metres and radians.",
        further="Why does a row in the standard convention need two origins?",
        given={"a": a, "alpha": alpha, "d": d},
        answer=OriginAnswer(_origin_of_row(a, alpha, d).value),
        solution=_origin_of_row(a, alpha, d).mistaken_for(
            ("a and d swapped", "swap $a$ and $d$", _origin_of_row(d, alpha, a))
        ),
        advice={
            "a and d swapped": "$a$ is along $x$, $d$ along the joint axis.",
            "sine and cosine swapped": "A roll by $\\alpha$ rotates $z$ to $(0, -\\sin\\alpha, \\cos\\alpha)$.",
            "sign": "A roll by $\\alpha$ rotates $z$ to $(0, -\\sin\\alpha, \\cos\\alpha)$.",
        },
    )


def _origin_of_row(a_m: float, alpha_rad: float, d_m: float) -> Expression:
    """The `xyz` and `rpy` of a modified DH row with the joint value 0, in two rows."""
    a, alpha, d = given("a", a_m, LENGTH), given("\\alpha", alpha_rad, ANGLE), given("d", d_m, LENGTH)
    alpha = alpha.mistaken_for(
        ("degrees", "convert $\\alpha$ to degrees", np.degrees(alpha_rad), "Sine, cosine and `rpy` take radians."),
        ("converted twice", "convert $\\alpha$ to radians twice", np.radians(alpha_rad)),
    )
    xyz, rpy = stack(a, -(d * sin(alpha)), d * cos(alpha)), stack(alpha, 0, 0)
    in_degrees = np.degrees(alpha_rad)
    along = "In the modified convention $d_i$ is measured along the new $z$, which $\\alpha$ has rotated."
    for other, name, text in (
        (stack(a, 0, d), "d along the old z", "translate by $d$ along the $z$ axis of the frame before"),
        (stack(a + d, 0, 0), "d along x", "translate by $d$ along $x$"),
        (stack(a * cos(alpha), a * sin(alpha), d), "the other convention", "rotate $a$ as well"),
        (stack(0, -(d * sin(alpha)), d * cos(alpha)), "a left out", "leave out $a$"),
        (stack(a, 0, 0), "d left out", "leave out $d$"),
        (
            stack(a, -(d * np.sin(in_degrees)), d * np.cos(in_degrees)),
            "sine of degrees",
            "use the degrees of $\\alpha$ as radians in `xyz`",
        ),
        (1000 * xyz, "millimetres", "write millimetres instead of metres"),
    ):
        xyz = xyz.mistaken_for((name, text, other, along if name.startswith("d") else ""))
    for other, name, text in (
        (stack(0, alpha, 0), "alpha as pitch", "write $\\alpha$ as the pitch"),
        (stack(0, 0, alpha), "alpha as yaw", "write $\\alpha$ as the yaw"),
        (stack(-alpha, 0, 0), "sign of an angle", "take $\\alpha$ with the opposite sign in `rpy`"),
        (stack(0, 0, 0), "alpha left out", "leave out $\\alpha$ in `rpy`"),
        (stack(in_degrees, 0, 0), "degrees", "write degrees into `rpy`"),
        (stack(np.copysign(np.pi, alpha_rad), 0, 0), "half a turn", "write a rotation by 180° into `rpy`"),
    ):
        rpy = rpy.mistaken_for((name, text, other, "" if name != "degrees" else "`rpy` is in radians."))
    return stack(xyz.named("\\mathrm{xyz}"), rpy.named("\\mathrm{rpy}"))


MIMIC_ADVICE = "A mimic joint has the value multiplier times the value of the other joint, plus offset."


@problem("09.7", "A joint that follows another", points=4, lecture="09_urdf#Mimic joints")
def mimic_joint(sampler: ArmSampler) -> Problem:
    boom, forearm, height = (sampler.length(0.2, 0.9) for _ in range(3))
    factor = sampler.choice((-1, 1)) * sampler.choice([0.5, 1.5, 2.0, 2.5])
    shift_rad = sampler.choice((-1, 1)) * sampler.choice([0.2, 0.3, 0.4, 0.6])
    q_rad = sampler.choice([0.5, 0.7, 0.8, 0.9, 1.1])
    limit = '<limit lower="-6.2832" upper="6.2832" effort="10" velocity="1"/>'
    mimic = f'<mimic joint="swing" multiplier="{number(factor)}" offset="{number(shift_rad)}"/>'
    joints = [
        UrdfJoint("swing", (0, 0, height), kind="revolute", further=(limit,)),
        UrdfJoint("fold", (boom, 0, 0), kind="revolute", further=(limit, mimic)),
        UrdfJoint("weld", (forearm, 0, 0), kind="fixed"),
    ]
    text = serial_urdf(joints, ("base", "boom", "forearm", "tool"))
    q = given("q_1", q_rad, ANGLE)
    for wrong, what in (
        (np.radians(q_rad), "convert $q_1$ to radians, although it is in radians"),
        (np.degrees(q_rad), "convert $q_1$ to degrees"),
    ):
        q = q.mistaken_for(("converted", what, wrong, "URDF files and NumPy have angles in radians."))
    q_2 = _mimic_value(q, given("\\mathrm{multiplier}", factor), given("\\mathrm{offset}", shift_rad))
    from_base = (q + q_2).mistaken_for(
        ("frame not changed", "take the value of `fold` from the $x$ axis of the base instead of that of `boom`", q_2)
    )
    first, second = polar(length("boom", boom), q), polar(length("forearm", forearm), from_base)
    in_plane = first.named("p_{\\mathrm{boom}}") + second.named("p_{\\mathrm{forearm}}")
    unturned = np.array([boom, 0.0]) + polar(forearm, q_2)
    in_plane = in_plane.mistaken_for(
        ("lengths swapped", "swap the lengths of `boom` and `forearm`", polar(forearm, q) + polar(boom, from_base)),
        ("swing left out", "leave `swing` at 0, and move `fold` alone", unturned),
        ("rotation left out", "add the lengths without rotating", np.array([boom + forearm, 0.0])),
    ).named("(x, y)")
    x = concatenate(in_plane, given("z", height).mistaken_for(("coordinate left out", "take the height as 0", 0.0)))
    return Problem(
        statement=f"The joint `swing` of this file has the value $q_1 = {number(q_rad)}$ rad; call that of `fold` $q_2$. Give the "
        f"position of the origin of the link `tool` in the frame of the base.\n\n{fence_urdf(text)}",
        further="Which multiplier keeps the direction of the forearm fixed in the base?",
        given={"q": q_rad},
        shown={"urdf": text},
        answer=VectorsAnswer(x, unit="m"),
        advice={
            f"leave out {what}": MIMIC_ADVICE
            for what in ("the factor $\\mathrm{multiplier}$", "$\\mathrm{offset}$", f"${q_2.latex}$")
        },
    )


def _mimic_value(q: Expression, multiplier: Expression, offset: Expression) -> Expression:
    """The value of a joint that mimics a joint of value q."""
    q_2 = multiplier * q + offset
    q_2 = q_2.mistaken_for(
        ("mimic as a copy", "give `fold` the value of `swing`", q),
        ("offset multiplied", "multiply the offset by the multiplier as well", multiplier * (q + offset)),
        ("multiplier and offset swapped", "swap the multiplier and the offset", offset * q + multiplier),
        ("mimic inverted", "take `swing` as the joint that mimics `fold`", (q - offset) / multiplier),
        ("radians as degrees", "read the offset as degrees", multiplier * q + np.radians(offset.value)),
        advice=MIMIC_ADVICE,
    )
    return q_2.named("q_2")


WRONG_FRAME_ADVICE = (
    "`axis` has the components in the joint's own frame: $R^T\\omega$, where $R$ is the rotation of this frame."
)


@problem(
    "09.8", "An axis in the wrong frame", points=4, lecture="09_urdf#An error that every reader accepts", level="Hard"
)
def axis_in_the_wrong_frame(sampler: ArmSampler) -> Problem:
    joints, omega = _three_joints(sampler), _random_axis(sampler, (0.48, 0.6, 0.64))
    joints[2] = UrdfJoint("joint_3", joints[2].xyz, random_oblique_angles(sampler), omega)
    text = serial_urdf(joints, LINKS)
    R1, R2, R3 = (rpy_rotation(f"R_{k}", np.asarray(joint.rpy)) for k, joint in enumerate(joints, start=1))
    w = direction("\\omega", omega)
    axis = transpose(R1 @ R2 @ R3) @ w
    axis = axis.mistaken_for(
        ("frame not changed", "leave the axis as it is, with its components in the frame of the base", w),
        ("frame not changed", "use the `rpy` of `joint_3` only", R3.T @ w),
        ("rotation transposed", "use the `rpy` of `joint_3` only, without the transpose", R3 @ w),
        ("frame not changed", "use the `rpy` of `joint_1` only", R1.T @ w),
        ("signs left out", "leave out the signs", absolute(transpose(R1 @ R2 @ R3) @ w)),
        ("another axis", "give the $z$ axis of the joint's frame", R1 @ R2 @ R3 @ given("z", Z)),
        advice=WRONG_FRAME_ADVICE,
    )
    return Problem(
        statement="When all joint values are 0, the axis of `joint_3` must have the direction "
        f"$\\omega = {vector(omega)}$ in the frame of the base. The author of this file wrote these three numbers into "
        f"the file. Which three numbers must `axis` of `joint_3` have instead? {SYMBOLS_NOTE} {ROUNDING_NOTE}\n\n{fence_urdf(text)}",
        further="Which axis would hide this error?",
        given={"urdf": text, "omega": omega},
        answer=VectorsAnswer(axis),
        advice={"transpose left out": WRONG_FRAME_ADVICE},
        # With right angles, R_3 R_1 R_2 is often R_1 R_2 R_3; it is not an order in which people multiply.
    )


@problem("09.9", "The file of a gantry", points=4, lecture="09_urdf#From the file to screws", level="Hard")
def gantry(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        bridge = np.array([a, b, 0.8 + c])
        trolley = bridge + np.array([d, -e, f])
        ram = trolley + np.array([-g, h, -c])
        tool = ram + np.array([e, -a, -0.2 - g])
        points = np.array([bridge, trolley, ram, tool])
        if is_readable(points) and tool[2] > 0.1:
            break
    steps = np.diff(np.array([np.zeros(3), *points]), axis=0)
    axes = [sampler.choice((-1, 1)) * axis for axis in (X, Y, Z)]
    drawn = [DrawnAxis(str(i), w, p, slides=True) for i, w, p in zip((1, 2, 3), axes, points, strict=False)]
    wrong = [
        ("in the base", points, "Every xyz is in the frame of the base. In a file it is in the frame of the parent."),
        ("opposite direction", -steps, "Every xyz leads from the child to the parent."),
        ("steps shifted", np.roll(steps, -1, axis=0), "Each row has the step of the next joint."),
        *(
            (name, np.diff(np.array([np.zeros(3), *value]), axis=0), text)
            for name, value, text in misread(points)
            if name in {"views swapped", "depth reversed"}
        ),
    ]
    return Problem(
        statement="The drawing shows a gantry at home, in millimetres: three prismatic joints, with their frames at F1, F2 and F3, "
        "and the tool at T. All frames are parallel to {s}, which is the root of the file. Give the `xyz` of the origins of joints 1 to 3 "
        "and of the fixed joint to the tool, as rows, in metres.",
        method="All frames are parallel, so each `xyz` is the step from one mark to the next: "
        + ", ".join(f"{name} is at ${vector(p)}$" for name, p in zip(("F1", "F2", "F3", "T"), points, strict=True))
        + ".",
        further="Which of the four steps would change if the third axis were reversed?",
        figure=lambda: draw_dimensions(
            [bridge * (1, 1, 0), *points], drawn, dict(zip(("F1", "F2", "F3", "T"), points, strict=True))
        ),
        answer=VectorsAnswer(steps, unit="m", names=["joint 1", "joint 2", "joint 3", "the tool"]),
        mistakes=[Mistake(name, value, text, spoils=name == "in the base") for name, value, text in wrong],
    ).without_duplicates()


@problem(
    "09.10",
    "A fault that every reader accepts",
    points=3,
    lecture="09_urdf#An error that every reader accepts",
    level="Open",
)
def accepted_and_wrong(_: ArmSampler) -> Problem:
    return Problem(
        statement="Change one number of the file of Problem 7, so that every reader accepts the file, the home pose of the tool is right, "
        "and the robot moves wrongly. Say which line it is, what it does, and with which test a colleague who knows only the "
        "machine would find it. Which line would he suspect first, and why is it innocent?",
        answer=Prose(
            "Negate the axis of `swing`, or change the multiplier of the mimic joint: at home `swing` is 0, so its axis is not seen "
            "there, and neither is the multiplier of this 0; each remains a valid number. A colleague moves one joint by a known angle "
            "and measures one point: the sign of the motion shows the axis, its size the multiplier. He would suspect the origin of the "
            "next joint, because the tool is off by a length there; but at home that length is right.",
            {
                "a line with a fault that is valid and does not change the home pose": 1,
                "a test that finds it, with what is measured": 1,
                "a suspicion that is natural, and the reason against it": 1,
            },
        ),
    )
