"""How a long product of turns stays short: parallel axes are merged before anything is multiplied.

Multiplied out, the forward kinematics of an arm is pages of sines and cosines, and simplifying them takes seconds. Most of
that work undoes what need not be done: two parallel joints give cos(q2) cos(q3) - sin(q2) sin(q3), and simplify finds
cos(q2 + q3) in it again. So the angles are added first. That is allowed, because the exponents of turns about one direction
are multiples of one matrix, and multiples of one matrix commute:

    e^[w]a e^[w]b = e^[w](a + b)

If the axes are parallel and apart, a shift stands between the turns. Each shift is turned by all that stands before it:

    turn(a) shift(t) turn(b) shift(u)  =  e^[w](a + b), shifted by e^[w]a t + e^[w](a + b) u

You read a planar arm off its drawing in the same way: a_1 c_1 + a_2 c_12. So an arm is a word of turns and shifts. Each run
of parallel turns becomes one pose, and the poses are multiplied from the right, beginning at the tool: there a column of the
product is a few letters long, and each joint to the left multiplies it once.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import NamedTuple

import sympy as sp


class Turn(NamedTuple):
    """One letter of a word: a turn about a unit vector. The other letter, a shift, is a column of three lengths."""

    axis: sp.Matrix
    angle: sp.Expr


Word = list[Turn | sp.Matrix]


def product(word: Iterable[Turn | sp.Matrix], end: sp.Matrix) -> sp.Matrix:
    """Multiply a word of turns and shifts, from left to right, and a pose behind it: 4x4.

    >>> x, z, (a, b, c) = sp.Matrix([1, 0, 0]), sp.Matrix([0, 0, 1]), sp.symbols("a b c")
    >>> product([Turn(z, a), x, Turn(z, b), c * x], sp.eye(4))[:2, 3].T
    Matrix([[c*cos(a + b) + cos(a), c*sin(a + b) + sin(a)]])
    """
    runs, renamed = [Run()], sp.eye(3)
    for letter in word:
        if not isinstance(letter, Turn):
            runs[-1].shift(renamed * letter)
        elif (2 * letter.angle / sp.pi).is_Integer:
            # A quarter turn that never changes moves nothing: it renames the axes of all that follows.
            renamed = renamed * rotation(*letter)
        else:
            turn = Turn(renamed * letter.axis, letter.angle)
            if not runs[-1].takes(turn):
                runs.append(Run())
            runs[-1].turn(turn)
    T = pose(renamed, sp.zeros(3, 1)) * end
    for run in reversed(runs):
        T = run.carry(T)
    return T.applyfunc(signs_gathered)


@dataclass
class Run:
    """Turns about one direction and the shifts between them, each of which is kept by the angle that turns it."""

    axis: sp.Matrix | None = None
    angle: sp.Expr = sp.S.Zero
    shifts: dict[sp.Expr, sp.Matrix] = field(default_factory=dict)

    def takes(self, turn: Turn) -> bool:
        """Whether the turn is about this direction, or about its opposite."""
        return self.axis is None or turn.axis in (self.axis, -self.axis)

    def turn(self, turn: Turn) -> None:
        """Go on turning: about the opposite direction, by minus the angle."""
        if self.axis is None:
            self.axis = turn.axis
        self.angle += turn.angle if turn.axis == self.axis else -turn.angle

    def shift(self, by: sp.Matrix) -> None:
        """Shift by a vector, in the frame that the turns so far have turned."""
        self.shifts[self.angle] = self.shifts.get(self.angle, sp.zeros(3, 1)) + by

    def carry(self, T: sp.Matrix) -> sp.Matrix:
        """Multiply a pose from the left by this run."""
        none = sp.zeros(3, 1)
        if self.axis is None:
            return pose(sp.eye(3), self.shifts.get(self.angle, none)) * T
        shifts = {**self.shifts, self.angle: self.shifts.get(self.angle, none) + T[:3, 3]}
        p = sum((rotation(self.axis, angle) * shift for angle, shift in shifts.items()), none)
        return pose(rotation(self.axis, self.angle) * T[:3, :3], p)


def rotation(axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    """Turn about a unit vector: R = I + sin(angle) [w] + (1 - cos(angle)) [w]^2, 3x3.

    Source: Modern Robotics, (3.51), Rodrigues' formula.

    >>> rotation(sp.Matrix([0, 0, 1]), sp.Symbol("q"))[0, :]
    Matrix([[cos(q), -sin(q), 0]])
    """
    W = skew(axis)
    return sp.eye(3) + sp.sin(angle) * W + (1 - sp.cos(angle)) * W * W


def skew(w: sp.Matrix) -> sp.Matrix:
    """Write the cross product with w as a matrix, 3x3.

    >>> (skew(sp.Matrix([0, 0, 1])) * sp.Matrix([1, 0, 0])).T
    Matrix([[0, 1, 0]])
    """
    a, b, c = w
    return sp.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


def pose(R: sp.Matrix, p: sp.Matrix) -> sp.Matrix:
    """Write a pose from its rotation and its position, 4x4.

    >>> pose(sp.eye(3), sp.Matrix([1, 2, 3]))[:, 3].T
    Matrix([[1, 2, 3, 1]])
    """
    return R.row_join(p).col_join(sp.Matrix([[0, 0, 0, 1]]))


def signs_gathered(expression: sp.Expr) -> sp.Expr:
    """Move minus signs through brackets, so that a sum inside a product never begins with a minus that could stand outside.

    >>> x, y, z = sp.symbols("x y z")
    >>> signs_gathered(-(x - y) * z), signs_gathered((-x - y) * z)
    (z*(-x + y), -z*(x + y))
    """

    def gathered(product: sp.Expr) -> sp.Expr:
        number, factors = product.as_coeff_mul()
        for i, factor in enumerate(factors):
            if factor.is_Add:
                negative = [bool(term.as_coeff_Mul()[0].is_negative) for term in factor.args]
                if all(negative) or (any(negative) and number.is_negative):
                    number, factors = -number, (*factors[:i], -factor, *factors[i + 1 :])
        return sp.Mul(number, *factors)

    return expression.replace(lambda part: part.is_Mul, gathered)
