"""The rotations of URDF in solutions: roll, pitch and yaw."""

from itertools import combinations

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.rpy import origin
from misstep.mutants.expression import Expression, Operation, Slip, Slips, given, transpose

NAMES = ("roll", "pitch", "yaw")
AXES_ADVICE = "`rpy` rotates about the fixed axes of the parent, so a later rotation is further left: $R_z R_y R_x$."


def rpy_rotation(label: str, rpy: Array | Expression) -> Expression:
    """The rotation (3, 3) of given angles roll, pitch and yaw in radians, (3,), about the fixed axes x, y and z.

    rpy  an expression if the angles are given in degrees, to be converted
    """
    angles = rpy if isinstance(rpy, Expression) else given(label.replace("R", "\\mathrm{rpy}", 1), rpy)
    return _rpy_rotation(angles).named(label)


def about_own_axes(R: Expression) -> Expression:
    """The rotation by the same angles about the frame's own axes, R_x R_y R_z, which is a mistake."""
    return _moving(*R.arguments)


def _rotation(rpy: Array) -> Array:
    return origin(rpy=rpy)[:3, :3]


def _about_moving_axes(rpy: Array) -> Array:
    roll, pitch, yaw = np.diag(rpy)
    return _rotation(roll) @ _rotation(pitch) @ _rotation(yaw)


def _rpy_slips(node: Expression) -> Slips:
    [rpy], label = node.arguments, node.latex or node.arguments[0].latex
    rotated = [k for k in range(3) if rpy.value[k]]
    if len(rotated) > 1:  # a single rotation has only one order
        place = f", in ${label}$" if "_" in label else ""  # a single rotation needs no name
        text = f"rotate about the frame's own axes, $R_x R_y R_z${place}"
        everywhere = "rotate about the frames' own axes, $R_x R_y R_z$"
        yield Slip("own axes", text, _moving(rpy), everywhere=everywhere, advice=AXES_ADVICE)
    if rotated != [1]:  # the pitch is the second angle in either order
        text, advice = "read the angles as yaw, pitch and roll", "The first of the three is the roll, about $x$."
        yield Slip("yaw first", text, _rpy_rotation(rpy[::-1]), everywhere=text, advice=advice)
    if len(rotated) > 1:
        text = f"take the angles of ${label}$ as one rotation vector"
        advice = "Roll, pitch and yaw are three rotations, one after the other, and not one rotation vector."
        yield Slip("rotation vector", text, _one_rotation(rpy), advice=advice, may_coincide=True)
    text = f"transpose ${label}$, which takes coordinates in the joint's frame to the parent's"
    yield Slip("rotation transposed", text, transpose(node), everywhere="transpose every rotation")
    yield Slip(
        "rotation left out", f"leave out ${label}$", given("I", np.eye(3)), everywhere="leave out every rotation"
    )
    if not rpy.arguments:  # they are given in radians
        text, advice = "read the angles as degrees", "Angles of a URDF file are in radians: 1.5708 is a right angle."
        yield Slip("radians as degrees", text, _rpy_rotation(_scaled(rpy, np.pi / 180)), everywhere=text, advice=advice)
        text, advice = "convert the angles to degrees", "The functions of NumPy and of `kinlib` take radians."
        yield Slip("radians in degrees", text, _rpy_rotation(_scaled(rpy, 180 / np.pi)), everywhere=text, advice=advice)
    for count in (1, 2, 3):
        for chosen in combinations(rotated, count):
            names = "every angle" if count == len(rotated) > 1 else "the " + " and the ".join(NAMES[k] for k in chosen)
            keep = np.array([k not in chosen for k in range(3)], dtype=float)
            text = f"take {names} of ${label}$ with the opposite sign"
            advice = "By the right-hand rule, a roll rotates $y$ to $z$, a pitch $z$ to $x$ and a yaw $x$ to $y$."
            yield Slip("sign of an angle", text, _rpy_rotation(_scaled(rpy, 2 * keep - 1)), advice=advice)
            if count < len(rotated):
                yield Slip("angle left out", f"leave out {names} of ${label}$", _rpy_rotation(_scaled(rpy, keep)))


def _scaled(rpy: Expression, factor: float | Array) -> Expression:
    return Operation("scaled", lambda angles: angles * factor, "{0}".format)(rpy)


_rpy_rotation: Operation = Operation("roll, pitch, yaw", _rotation, "R_z R_y R_x".format, _rpy_slips)
_one_rotation: Operation = Operation("one rotation", exponential, "R({0})".format)
_moving: Operation = Operation("moving axes", _about_moving_axes, "R({0})".format)
