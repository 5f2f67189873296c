r"""The angles of a wrist in solutions: from a rotation R to theta_4, theta_5, theta_6, with R = R_y R_z R_y R_x(-90°)."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from misstep.mutants.expression import ALL_AT_ONCE, Expression, Operation, given, table, transpose

X, Y, Z = np.eye(3)
QUARTER_TURN = exp(np.pi / 2 * X)
"""R_x(90°), which undoes the constant of the wrist."""

SINGULAR_SINE = 1e-9
"""The sine of theta_5 up to which axes 4 and 6 count as collinear."""

CONSTANT_ADVICE = "The constant $R_x(-90°)$ is the last factor of $R$, so $R\\,R_x(90°) = R_y\\,R_z\\,R_y$."
ORDER_ADVICE = "Give $\\theta_4, \\theta_5, \\theta_6$ in this order."
QUADRANT_ADVICE = "`np.arctan2(y, x)` finds the quadrant, and `np.arctan(y / x)` does not."
PAIR_ADVICE = "The second solution is $(\\theta_4 + \\pi, -\\theta_5, \\theta_6 + \\pi)$: all three angles change."


def wrist_rotation(angles: Array) -> Array:
    """The rotation R_y(theta_4) R_z(theta_5) R_y(theta_6) R_x(-90°) of a wrist, (3,) -> (3, 3)."""
    t4, t5, t6 = angles
    R: Array = exp(t4 * Y) @ exp(t5 * Z) @ exp(t6 * Y) @ QUARTER_TURN.T
    return R


def wrist_angles(label: str, R: Array) -> Expression:
    """The angles theta_4, theta_5, theta_6 of a wrist with the rotation R, (3,) in radians.

    theta_5 is in [0, pi]; if axes 4 and 6 are collinear, theta_4 is 0.
    """
    return _yzy(_without_constant(given(label, R, _ROTATION)))


def _angles(E: Array) -> Array:
    """The angles of E = R_y(a) R_z(b) R_y(c), with b in [0, pi]."""
    sine = np.hypot(E[1, 0], E[1, 2])
    if sine < SINGULAR_SINE:
        return np.array([0.0, np.pi * (E[1, 1] < 0), np.arctan2(E[0, 2], E[2, 2])])
    return np.array([np.arctan2(E[2, 1], -E[0, 1]), np.arctan2(sine, E[1, 1]), np.arctan2(E[1, 2], E[1, 0])])


def _sum_twice(E: Array) -> Array:
    angles = _angles(E)
    return angles if np.hypot(E[1, 0], E[1, 2]) > SINGULAR_SINE else angles[[2, 1, 2]]


# fmt: off
_ALL = ALL_AT_ONCE
_ANGLES = table(
    ("degrees", "give the angles in degrees |", lambda E: np.degrees(_angles(E)), "Give them in radians.", _ALL),
    ("reversed", "give $\\theta_6, \\theta_5, \\theta_4$ in this order |", lambda E: _angles(E)[::-1], ORDER_ADVICE, _ALL),
    ("sign of theta_5", "take $\\theta_5$ alone with the opposite sign |", lambda E: _angles(E) * (1, -1, 1), PAIR_ADVICE, _ALL),
    ("all signs", "take all angles with the opposite sign |", lambda E: -_angles(E), "", _ALL),
    ("half a turn", "give $\\theta_4$ and $\\theta_6$ off by 180° |",
     lambda E: np.add(_angles(E), (np.pi, 0, np.pi)), QUADRANT_ADVICE, _ALL),
    ("theta_4 left out", "leave $\\theta_4$ at 0 |", lambda E: _angles(E) * (0, 1, 1), "", _ALL),
    ("theta_6 left out", "leave $\\theta_6$ at 0 |", lambda E: _angles(E) * (1, 1, 0), "", _ALL),
    ("sum twice", "give the sum of $\\theta_4$ and $\\theta_6$ for each of them, where axes 4 and 6 are collinear |",
     _sum_twice, "", _ALL),
    of_values=True,
)
_CONSTANT = table(
    ("constant left in", "leave the constant $R_x(-90°)$ in $R$ |", lambda R: R, CONSTANT_ADVICE, _ALL),
    ("sign of the constant", "multiply $R$ by $R_x(-90°)$ instead of $R_x(90°)$ |", lambda R: R @ QUARTER_TURN.T, CONSTANT_ADVICE, _ALL),
    ("constant on the left", "multiply $R$ by $R_x(90°)$ from the left |", lambda R: QUARTER_TURN @ R, CONSTANT_ADVICE, _ALL),
    of_values=True,
)
_ROTATION: Operation = Operation("given rotation", lambda: None, str, table(
    ("rotation transposed", "use the transpose of $R$ |", lambda R: transpose(R), "$R$ is $R_{36}$ as it is.", _ALL),
))
_without_constant: Operation = Operation("rotation without the constant", lambda R: R @ QUARTER_TURN, "{0}\\,R_x(90°)".format, _CONSTANT)
_yzy: Operation = Operation("Y-Z-Y angles", _angles, "\\mathrm{{YZY}}({0})".format, _ANGLES)
# fmt: on
