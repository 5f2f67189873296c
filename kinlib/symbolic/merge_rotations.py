"""Keep long products of rotations short: merge the rotations about parallel axes before multiplying.

Multiplied out, the forward kinematics of an arm is pages of sines and cosines, and simplifying them takes seconds. Most of this
work can be avoided. For example, two parallel joints give cos(q2) cos(q3) - sin(q2) sin(q3), in which simplify finds
cos(q2 + q3) again. So the angles are added first. This is allowed because the exponents of rotations about one direction are
multiples of one matrix, and multiples of one matrix commute:

    e^[w]a e^[w]b = e^[w](a + b)

If the axes are parallel but not equal, there is a translation between the rotations. Each translation is rotated by all the
rotations before it:

    rotate(a) translate(t) rotate(b) translate(u)  =  e^[w](a + b), translated by e^[w]a t + e^[w](a + b) u

This is how you read a planar arm from its drawing: a_1 c_1 + a_2 c_12. So an arm is written as a sequence of rotations and
translations. Each group of rotations about parallel axes becomes one pose, and the poses are multiplied from the right,
beginning at the end-effector: there a column of the product has few terms, and each joint to the left multiplies it once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import sympy as sp


class AxisRotation(NamedTuple):
    """A factor of a product: the rotation by an angle about a unit vector. The other kind of factor, a translation, is a 3x1."""

    axis: sp.Matrix
    angle: sp.Expr


Factors: TypeAlias = "list[AxisRotation | sp.Matrix]"
"""A product of rotations and translations, from left to right."""


def multiply(factors: Iterable[AxisRotation | sp.Matrix], end: sp.Matrix) -> sp.Matrix:
    """Multiply rotations and translations, from left to right, and a pose at the right end: 4x4."""
    # What is before the first rotation is rotated by 0 about z.
    groups, constant = [_RotationGroup(sp.Matrix([0, 0, 1]))], sp.eye(3)
    for factor in factors:
        if not isinstance(factor, AxisRotation):
            groups[-1].translate(constant * factor)
        elif (2 * factor.angle / sp.pi).is_Integer:
            # A constant rotation by a multiple of pi/2 only permutes the coordinate axes of everything to its right.
            constant = constant * rotation(*factor)
        else:
            axis = constant * factor.axis
            if axis not in (groups[-1].axis, -groups[-1].axis):
                groups.append(_RotationGroup(axis))
            groups[-1].angle += factor.angle if axis == groups[-1].axis else -factor.angle
    T = homogeneous(constant, sp.zeros(3, 1)) * end
    for group in reversed(groups):
        T = group.multiply(T)
    return T


@dataclass
class _RotationGroup:
    """Consecutive rotations about one direction, with the translations between them.

    axis          the unit vector 3x1
    angle         the sum of the angles
    translations  for each angle reached so far, the sum of the translations 3x1 that are rotated by it
    """

    axis: sp.Matrix
    angle: sp.Expr = field(default_factory=lambda: sp.S.Zero)
    translations: dict[sp.Expr, sp.Matrix] = field(default_factory=dict)

    def translate(self, vector: sp.Matrix) -> None:
        """Append a translation, given in the frame after the rotations so far."""
        self.translations[self.angle] = self.translations.get(self.angle, sp.zeros(3, 1)) + vector

    def multiply(self, T: sp.Matrix) -> sp.Matrix:
        """Multiply the pose of this group by a pose T at its right: 4x4."""
        self.translate(T[:3, 3])
        p = sum((rotation(self.axis, angle) * vector for angle, vector in self.translations.items()), sp.zeros(3, 1))
        return homogeneous(rotation(self.axis, self.angle) * T[:3, :3], p)


def rotation(axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    """Write the rotation about a unit vector w: R = I + sin(angle) [w] + (1 - cos(angle)) [w]^2, 3x3.

    Source: Modern Robotics, (3.51), Rodrigues' formula.
    """
    W = axis.hat()
    return sp.eye(3) + sp.sin(angle) * W + (1 - sp.cos(angle)) * W * W


def homogeneous(R: sp.Matrix, p: sp.Matrix) -> sp.Matrix:
    """Write the homogeneous transformation with a rotation and a position, 4x4."""
    return R.row_join(p).col_join(sp.Matrix([[0, 0, 0, 1]]))
