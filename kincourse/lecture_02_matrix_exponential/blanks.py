"""The blank steps of lecture 02: a p-column, a rotation, a pose, an axis that is not of unit length, and a logarithm."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.mistakes.space_form import swap_halves
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.chains.robots import angled_arm, hrr, youbot
from kinlib.rigid.lie import exp, hat, homogeneous, inverse, log
from misstep.answers.number import Numbers
from misstep.display.text import vector
from misstep.mistakes import mistake
from misstep.problem import Problem

THIRD_OF_A_TURN_RAD = 2 * np.pi / 3
"""At a quarter turn sin and 1 - cos are both 1, so a student who swaps them would be right by chance."""

SQUARED_ENTRIES = "You squared entry by entry: in NumPy, `W * W` and `W**2` do. The square of a matrix is `W @ W`."


def rodrigues_sum(W: Array, first: float, second: float) -> Array:
    """I + first W + second W^2, which is Rodrigues' formula for first = sin(theta) and second = 1 - cos(theta), (3, 3).

    >>> rodrigues_sum(hat([0, 0, 1]), 0.0, 2.0)
    array([[-1.,  0.,  0.],
           [ 0., -1.,  0.],
           [ 0.,  0.,  1.]])
    """
    turned: Array = np.eye(3) + first * W + second * W @ W
    return turned


def translation_matrix(W: Array, theta: float) -> Array:
    """G(theta) = I theta + (1 - cos theta) W + (theta - sin theta) W^2, (3, 3): the position column is G(theta) v.

    >>> translation_matrix(hat([0, 0, 1]), 0.0) + 0.0
    array([[0., 0., 0.],
           [0., 0., 0.],
           [0., 0., 0.]])
    """
    G: Array = np.eye(3) * theta + (1 - np.cos(theta)) * W + (theta - np.sin(theta)) * W @ W
    return G


@problem("02.a", "The p-column of a turn", points=1, lecture="02_matrix_exponential#From turns to screws")
def p_column(_draw: ArmSampler) -> Problem:
    S, theta = hrr().screws[1], THIRD_OF_A_TURN_RAD
    W, v, s, c = hat(S[:3]), S[3:], np.sin(theta), np.cos(theta)
    return Problem(
        statement=f"Give the p-column of $e^{{[S]q}}$ for $S = {vector(S)}$ and $q = 2\\pi/3$.",
        answer=Numbers(exp(S * theta)[:3, 3], unit="metres"),
        mistakes=[
            mistake(
                "straight on",
                v * theta,
                "You wrote $v\\,\\theta$. That is a slide: it holds for $\\omega = 0$. Here $v$ turns along with the body, "
                "so its way is bent: $G(\\theta)\\,v$.",
            ),
            mistake(
                "coefficients swapped",
                v * theta + (theta - s) * W @ v + (1 - c) * W @ W @ v,
                "You swapped two coefficients. $1 - \\cos\\theta$ stands with $[\\omega]$, "
                "$\\theta - \\sin\\theta$ with $[\\omega]^2$: they are the integrals of $\\sin$ and $1 - \\cos$.",
            ),
            mistake(
                "R v",
                exp(S[:3] * theta) @ v,
                "You wrote $R\\,v$. That is how fast the point moves at the end; where it is, is the integral of it.",
            ),
            mistake(
                "no theta in front",
                translation_matrix(W, theta) @ v + (1 - theta) * v,
                "The first term is $I\\theta$, not $I$: it is the integral of $I$.",
            ),
            mistake("entry by entry", v * theta + (1 - c) * W @ v + (theta - s) * (W * W) @ v, SQUARED_ENTRIES),
            mistake(
                "degrees",
                translation_matrix(W, np.degrees(theta)) @ v,
                "You used degrees. The formula wants radians: $2\\pi/3$.",
            ),
        ],
    )


@problem("02.b", "A rotation about a leaning axis", points=1, lecture="02_matrix_exponential#The key identity")
def leaning_rotation(_draw: ArmSampler) -> Problem:
    omega, theta = angled_arm().screws[1, :3], THIRD_OF_A_TURN_RAD
    W, s, c = hat(omega), np.sin(theta), np.cos(theta)
    return Problem(
        statement="Give $R = e^{[\\omega]q}$ for joint 2 of the angled arm, $q = 2\\pi/3$.",
        answer=Numbers(exp(omega * theta)),
        mistakes=[
            mistake(
                "coefficients swapped",
                rodrigues_sum(W, 1 - c, s),
                "You swapped $\\sin\\theta$ and $1 - \\cos\\theta$. The odd powers of $[\\omega]$ fold into $[\\omega]$, "
                "and odd is the sine.",
            ),
            mistake(
                "turned backwards",
                exp(-omega * theta),
                "This turns by $-\\theta$: a sign of $[\\omega]$ is wrong, or the matrix is transposed. "
                "Its first row is $(0, -\\omega_z, \\omega_y)$.",
            ),
            mistake("entry by entry", np.eye(3) + s * W + (1 - c) * W * W, SQUARED_ENTRIES),
            mistake(
                "cos for 1 - cos",
                rodrigues_sum(W, s, c),
                "You wrote $\\cos\\theta$ where $1 - \\cos\\theta$ belongs. At $\\theta = 0$ nothing may turn; yours does.",
            ),
            mistake(
                "two terms",
                rodrigues_sum(W, theta, 0.0),
                "You stopped after $I + [\\omega]\\theta$. That is the first small step, and no rotation: it stretches.",
            ),
            mistake(
                "degrees", exp(omega * np.degrees(theta)), "You used degrees. The formula wants radians: $2\\pi/3$."
            ),
        ],
    )


@problem("02.c", "The whole pose", points=1, lecture="02_matrix_exponential#From turns to screws")
def leaning_pose(_draw: ArmSampler) -> Problem:
    S, theta = angled_arm().screws[1], THIRD_OF_A_TURN_RAD
    W, v, s, c = hat(S[:3]), S[3:], np.sin(theta), np.cos(theta)
    R = exp(S[:3] * theta)
    return Problem(
        statement="Give $e^{[S]q}$ for joint 2 of the angled arm, $q = 2\\pi/3$.",
        answer=PoseAnswer(exp(S * theta)),
        mistakes=[
            mistake(
                "straight on",
                homogeneous(R, v * theta),
                "You wrote $v\\,\\theta$ in the p-column. That is a slide's; a turn bends the way: $G(\\theta)\\,v$.",
            ),
            mistake("R v", homogeneous(R, R @ v), "You wrote $R\\,v$ in the p-column. It is $G(\\theta)\\,v$."),
            mistake(
                "v itself",
                homogeneous(R, v),
                "You put $v$ in the p-column. $v$ is a velocity, in metres per radian; $G(\\theta)\\,v$ is a place.",
            ),
            mistake(
                "point on the axis",
                homogeneous(R, angled_arm().joint_points[1]),
                "You put the joint's point in the p-column. The column says where the origin of {s} goes, not where the joint is.",
            ),
            mistake(
                "coefficients swapped",
                homogeneous(R, v * theta + (theta - s) * W @ v + (1 - c) * W @ W @ v),
                "You swapped two coefficients of $G$: $1 - \\cos\\theta$ stands with $[\\omega]$, "
                "$\\theta - \\sin\\theta$ with $[\\omega]^2$.",
            ),
        ],
    )


@problem("02.d", "An axis that is not of unit length", points=1, lecture="02_matrix_exponential#Bug hunt")
def long_axis(_draw: ArmSampler) -> Problem:
    omega, v, theta = np.array([0.0, 0.0, 2.0]), np.array([1.0, 0.0, 0.0]), np.pi / 4
    W, right = hat(omega), exp(np.concatenate([omega, v]) * theta)
    printed = rodrigues_sum(W, np.sin(theta), 1 - np.cos(theta))
    return Problem(
        statement="Give $e^{[S]\\theta}$ for $\\omega = (0, 0, 2)$, $v = (1, 0, 0)$, $\\theta = \\pi/4$.",
        answer=PoseAnswer(right),
        mistakes=[
            mistake(
                "as printed",
                homogeneous(printed, translation_matrix(W, theta) @ v),
                "This is (3.88) as printed. It folds the powers with $[\\omega]^3 = -[\\omega]$, which needs $|\\omega| = 1$.",
            ),
            mistake(
                "column as printed",
                homogeneous(right[:3, :3], translation_matrix(W, theta) @ v),
                "The rotation is right, the p-column is still (3.88) as printed. It needs $|\\omega| = 1$ too.",
            ),
            mistake(
                "angle kept",
                exp(np.concatenate([omega / 2, v / 2]) * theta),
                "You divided $S$ by $|\\omega|$ and kept $\\theta$. What you take from the axis goes to the angle: "
                "$S\\,\\theta = (S / 2)\\,(2\\theta)$.",
            ),
            mistake(
                "v not divided",
                exp(np.concatenate([omega / 2, v]) * 2 * theta),
                "You divided $\\omega$ and left $v$. Both halves of $S$ belong to one motion: divide both.",
            ),
            mistake(
                "angle kept, v not divided",
                exp(np.concatenate([omega / 2, v]) * theta),
                "You made $\\omega$ a unit vector and went on. The body now turns half as far: divide all of $S$ by 2, "
                "and multiply $\\theta$ by 2.",
            ),
        ],
    )


@problem("02.e", "The screw from one pose to another", points=1, lecture="02_matrix_exponential#The logarithm")
def screw_between(_draw: ArmSampler) -> Problem:
    arm = youbot()
    home, drawn = arm.home, arm.fk([0, 0, np.pi / 2, -np.pi / 2, -np.pi / 4])
    x = log(drawn @ inverse(home))
    return Problem(
        statement="Give the twist $x$ in {s} with $e^{[x]} T_{sa} = T_{sb}$, from the youBot's home to the posture of the deck.",
        given={"T_sa": home, "T_sb": drawn},
        answer=Numbers(x),
        mistakes=[
            mistake(
                "as the hand reads it",
                log(inverse(home) @ drawn),
                "You took $\\log(T_{sa}^{-1} T_{sb})$. It is the same screw, as the hand reads it: $T_{sa} e^{[x]} = T_{sb}$. "
                "For the base's numbers the inverse goes to the right.",
            ),
            mistake("backwards", -x, "This leads from $T_{sb}$ back to $T_{sa}$."),
            mistake(
                "only the goal",
                log(drawn),
                "You took $\\log T_{sb}$: the screw from {s} to the hand. The question starts at $T_{sa}$.",
            ),
            mistake(
                "logs subtracted",
                log(drawn) - log(home),
                "You subtracted logarithms. $\\log(AB) = \\log A + \\log B$ holds for positive numbers; "
                "for motions that do not commute you cannot rely on it.",
            ),
            mistake(
                "halves swapped",
                swap_halves(x),
                "You wrote $(v, \\omega)$. Here a twist is $(\\omega, v)$, turn first.",
            ),
        ],
    )


BLANKS = [p_column, leaning_rotation, leaning_pose, long_axis, screw_between]
