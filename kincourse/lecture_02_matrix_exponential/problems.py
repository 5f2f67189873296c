"""Sheet 02: hat, Rodrigues' formula, motions in closed form, a truncated series, a non-unit axis, a logarithm."""

from functools import partial

import numpy as np
import sympy as sp

from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.answers.pose_expression import PoseExpressionAnswer
from kincourse.lecture_02_matrix_exponential.blanks import SQUARED_ENTRIES, rodrigues_sum, translation_matrix
from kincourse.mistakes.space_form import swap_halves
from kincourse.problem import problem
from kincourse.sampling.arms import AXIS_DIRECTIONS, ArmSampler
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, arm
from kinlib.chains.robots import pose as frame
from kinlib.rigid.lie import exp, hat, homogeneous
from kinlib.symbolic.merge_rotations import homogeneous as symbolic_pose
from kinlib.symbolic.merge_rotations import rotation as turn
from kinlib.symbolic.merge_rotations import skew_symmetric
from kinlib.symbolic.numbers import exact
from kinlib.view import draw_joints
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.display.text import matrix, number, vector
from misstep.mistakes import mistake
from misstep.problem import Problem
from misstep.sheet import Sheet

PYTHAGOREAN_QUADRUPLES = ((1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9))
"""The entries and the length of vectors for which all are integers, so that unit vectors can be computed on paper."""

PYTHAGOREAN_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17))

THETA = sp.Symbol("theta", real=True)
A = sp.Symbol("a", positive=True)


@problem("02.1", "The matrix of a screw", points=3, lecture="02_matrix_exponential#The equation behind it")
def matrix_of_a_screw(sampler: ArmSampler) -> Problem:
    omega, v = sampler.point(5), sampler.point(5)
    S = np.concatenate([omega, v])
    right = hat(S)
    velocity = right * (0, 0, 0, 1)
    return Problem(
        statement=f"Write the matrix $[S]$ of the twist $S = (\\omega, v)$ with $\\omega = {vector(omega)}$, $v = {vector(v)}$, by hand.",
        given={"omega": omega, "v": v},
        answer=Numbers(right),
        mistakes=[
            mistake(
                "sign of the cross product",
                2 * velocity - right,
                "Your block is $-[\\omega]$. Test it on a vector: $[\\omega]\\,u = \\omega \\times u$, so the first row is "
                "$(0, -\\omega_z, \\omega_y)$.",
            ),
            mistake(
                "no minus signs",
                np.triu(right) + np.triu(right - velocity).T,
                "Your block equals its transpose. A cross product changes sign when it is mirrored: $[\\omega]^T = -[\\omega]$.",
            ),
            mistake(
                "halves swapped",
                hat(swap_halves(S)),
                "You put $v$ into the block and $\\omega$ into the column. Here a twist is $(\\omega, v)$, turn first.",
            ),
            mistake(
                "like a pose",
                right + np.diag([0, 0, 0, 1]),
                "You wrote a 1 into the corner. That is a pose's; $[S]$ is a velocity of poses, and the last row of a pose never changes.",
            ),
            mistake(
                "in the last row",
                right - velocity + velocity.T,
                "You wrote $v$ into the last row. It is the last column.",
            ),
        ],
    )


@problem("02.2", "A turn about a line in space", points=3, lecture="02_matrix_exponential#The key identity")
def turn_about_a_line(sampler: ArmSampler) -> Problem:
    direction, length = _direction(sampler)
    degrees = sampler.choice([degrees for degrees in range(35, 165, 5) if degrees not in (45, 90)])
    angle, u = np.radians(degrees), direction / length
    W, s, c = hat(u), np.sin(angle), np.cos(angle)
    return Problem(
        statement=f"A body turns by {degrees} degrees about the direction ${vector(direction)}$. Give $R$.",
        given={"direction": direction, "degrees": degrees},
        answer=RotationAnswer(exp(u * angle)),
        mistakes=[
            mistake(
                "not a unit vector",
                rodrigues_sum(hat(direction), s, 1 - c),
                f"You used the direction as it is given. Rodrigues' formula wants $|\\omega| = 1$, and its length is {length}: divide.",
            ),
            mistake(
                "length in the angle",
                exp(direction * angle),
                f"You turned {length} times as far: `kl.exp` takes the length of its vector as the angle. Divide by {length} first.",
            ),
            mistake(
                "degrees", exp(u * degrees), "You used degrees as radians. A sine reads radians: use np.radians first."
            ),
            mistake(
                "turned backwards",
                exp(-u * angle),
                "This is the transpose: it turns by the same angle the other way. Is a sign of $[\\omega]$ wrong?",
            ),
            mistake(
                "coefficients swapped",
                rodrigues_sum(W, 1 - c, s),
                "You swapped $\\sin\\theta$ and $1 - \\cos\\theta$. The odd powers of $[\\omega]$ fold into $[\\omega]$: "
                "odd is the sine.",
            ),
            mistake(
                "cos for 1 - cos",
                rodrigues_sum(W, s, c),
                "You wrote $\\cos\\theta$ where $1 - \\cos\\theta$ belongs. At $\\theta = 0$ nothing may turn; yours does.",
            ),
            mistake(
                "no identity",
                rodrigues_sum(W, s, 1 - c) - np.eye(3),
                "You left out $I$, the first term of the series. At $\\theta = 0$ yours is zero: everything has gone to the origin.",
            ),
            mistake("entry by entry", np.eye(3) + s * W + (1 - c) * W * W, SQUARED_ENTRIES),
        ],
    )


@problem("02.3", "A rotation as a formula", points=3, lecture="02_matrix_exponential#The key identity")
def rotation_as_a_formula(sampler: ArmSampler) -> Problem:
    one, two, length = sampler.choice(PYTHAGOREAN_TRIPLES)
    whole = sp.Matrix(sampler.shuffled([0, sampler.choice((-1, 1)) * one, sampler.choice((-1, 1)) * two]))
    omega = whole / length
    W, s, c = skew_symmetric(omega), sp.sin(THETA), sp.cos(THETA)
    R = turn(omega, THETA)
    return Problem(
        statement=f"Give $R(\\theta) = e^{{[\\omega]\\theta}}$ for $\\omega = \\tfrac{{1}}{{{length}}}{vector(list(whole))}$ as a "
        "formula in $\\theta$: nine entries, without a decimal.",
        given={"omega": omega},
        answer=ClosedForm(R),
        mistakes=[
            mistake(
                "turned backwards",
                R.T,
                "This is $R(-\\theta)$: the signs of the sines are exchanged. "
                "The first row of $[\\omega]$ is $(0, -\\omega_z, \\omega_y)$.",
            ),
            mistake(
                "coefficients swapped",
                sp.eye(3) + (1 - c) * W + s * W * W,
                "You swapped $\\sin\\theta$ and $1 - \\cos\\theta$. For small $\\theta$ a rotation is $I + [\\omega]\\theta$, and "
                "$\\sin\\theta$ is what begins like $\\theta$.",
            ),
            mistake(
                "cos for 1 - cos",
                sp.eye(3) + s * W + c * W * W,
                "You wrote $\\cos\\theta$ where $1 - \\cos\\theta$ belongs. Put $\\theta = 0$: yours is not $I$.",
            ),
            mistake(
                "no identity",
                R - sp.eye(3),
                "You left out $I$, the first term of the series. Put $\\theta = 0$: yours is zero.",
            ),
            mistake(
                "cut short",
                sp.eye(3) + THETA * W + THETA**2 * W * W / 2,
                "You stopped after three terms of the series. It goes on; folded, its sums are $\\sin\\theta$ and $1 - \\cos\\theta$.",
            ),
            mistake(
                "entry by entry",
                sp.eye(3) + s * W + (1 - c) * W.multiply_elementwise(W),
                "You squared entry by entry. The square of a matrix is a matrix product: in SymPy `W * W`, in NumPy `W @ W`.",
            ),
        ],
    )


@problem("02.4", "Where the origin goes", points=3, lecture="02_matrix_exponential#From turns to screws")
def where_the_origin_goes(sampler: ArmSampler) -> Problem:
    d, e = sampler.choice([(d, e) for d in AXIS_DIRECTIONS for e in (X, Y, Z) if not d @ e])
    k = sampler.choice((-1, 1)) * sampler.integer(1, 5)
    w = exact(d)
    point = A * exact(e) + k * exact(np.abs(np.cross(d, e)))
    v = point.cross(w)
    W, R, s, c = skew_symmetric(w), turn(w, THETA), sp.sin(THETA), sp.cos(THETA)
    told = ", ".join(str(entry) for entry in point)
    return Problem(
        statement=f"A joint turns about ${vector(d)}$ through the point $({told})$, with a length $a$ that nobody has measured yet. "
        "Give the p-column of $e^{[S]\\theta}$ as three formulas in $a$ and $\\theta$.",
        given={"omega": w, "point": point},
        answer=ClosedForm(point - R * point),
        mistakes=[
            mistake(
                "straight on",
                v * THETA,
                "You wrote $v\\,\\theta$. That is a slide's way: it holds for $\\omega = 0$. Here $v$ is carried round with the body.",
            ),
            mistake(
                "omega x p",
                R * point - point,
                "You have the negative. $v = -\\omega \\times p$; or think: the point $p$ stays, so $p = R\\,p + {}$column.",
            ),
            mistake(
                "R p alone",
                R * point,
                "You turned the joint's point about the origin. The column is what must be added so that it stays: $p - R\\,p$.",
            ),
            mistake(
                "p itself",
                point,
                "You put the joint's point into the column. The column says where the origin of {s} goes.",
            ),
            mistake(
                "turned backwards",
                point - R.T * point,
                "You turned by $-\\theta$. Right-handed: the thumb along $\\omega$, the fingers show the turn.",
            ),
            mistake(
                "R v",
                R * v,
                "You wrote $R\\,v$: how fast the origin's point moves at the end. Where it is, is the integral of that.",
            ),
            mistake(
                "coefficients swapped",
                v * THETA + (THETA - s) * W * v + (1 - c) * W * W * v,
                "You swapped two coefficients. $1 - \\cos\\theta$ stands with $[\\omega]$, $\\theta - \\sin\\theta$ with $[\\omega]^2$.",
            ),
        ],
    )


@problem("02.5", "Three terms of the series", points=3, lecture="02_matrix_exponential#The series, term by term")
def three_terms(sampler: ArmSampler) -> Problem:
    angle, radius = sampler.choice([1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8]), sampler.length(0.3, 2.5)

    def error(terms: int) -> float:
        """The error of the truncated series, in millimetres. In the plane perpendicular to the axis, [w] acts as i does."""
        series = sum((1j * angle) ** k / float(sp.factorial(k)) for k in range(terms))
        return 1000 * radius * float(abs(np.exp(1j * angle) - series))

    return Problem(
        statement=f"You stop the series of $e^{{[\\omega]\\theta}}$ after three terms, $I + [\\omega]\\theta + [\\omega]^2\\theta^2/2$. "
        f"A point stands {number(radius)} m from the axis, which has $|\\omega| = 1$, and $\\theta = {number(angle)}$ rad. "
        "How far from its right place does the sum put it, in millimetres?",
        given={"radius": radius, "theta": angle},
        answer=Numbers(np.array(error(3)), unit="mm"),
        mistakes=[
            mistake(
                "two terms",
                error(2),
                "This is the error after two terms. The identity is a term too: three end with $\\theta^2/2$.",
            ),
            mistake(
                "four terms", error(4), "This is the error after four terms: you took $[\\omega]^3\\theta^3/3!$ along."
            ),
            mistake(
                "the next term",
                1000 * radius * angle**3 / 6,
                "This is the length of the first term that is missing: a good guess for small angles. Here the terms after it count too.",
            ),
            mistake(
                "along one axis only",
                1000 * radius * abs(np.cos(angle) - 1 + angle**2 / 2),
                "This is the error along one direction, of the cosine. The sine is cut as well: add both at right angles.",
            ),
            mistake(
                "errors added",
                1000 * radius * (abs(np.cos(angle) - 1 + angle**2 / 2) + abs(np.sin(angle) - angle)),
                "You added the errors of sine and cosine. They stand at right angles: Pythagoras.",
            ),
            mistake("in metres", error(3) / 1000, "The number is right in metres. The question asks for millimetres."),
        ],
    )


@problem("02.6", "What a gyroscope measures", points=3, lecture="02_matrix_exponential#Bug hunt")
def gyroscope(sampler: ArmSampler) -> Problem:
    size, seconds = sampler.choice([2.0, 3.0, 0.5]), sampler.choice([0.4, 0.5, 0.6, 0.7, 0.8])
    omega, v = size * sampler.choice(AXIS_DIRECTIONS), sampler.point(3)
    S, W = np.concatenate([omega, v]), hat(omega)
    right = exp(S * seconds)
    printed = rodrigues_sum(W, np.sin(seconds), 1 - np.cos(seconds))
    unit = np.concatenate([omega / size, v])
    return Problem(
        statement=f"A body turns with $\\omega = {vector(omega)}$ radians in a second, while its point at the origin moves with "
        f"$v = {vector(v)}$ metres in a second. Both stay as they are in {{s}}. "
        f"Give its pose after {number(seconds)} seconds, if it was $I$.",
        given={"omega": omega, "v": v, "seconds": seconds},
        answer=PoseAnswer(right),
        mistakes=[
            mistake(
                "as printed",
                homogeneous(printed, translation_matrix(W, seconds) @ v),
                "This is (3.88) with $\\theta$ = the seconds. It folds the powers with "
                "$[\\omega]^3 = -[\\omega]$, which needs $|\\omega| = 1$.",
            ),
            mistake(
                "column as printed",
                homogeneous(right[:3, :3], translation_matrix(W, seconds) @ v),
                "The rotation is right, the column is (3.88) as it stands. It needs $|\\omega| = 1$ as well.",
            ),
            mistake(
                "angle kept",
                exp(S / size * seconds),
                "You divided the twist by $|\\omega|$ and kept the seconds. What you take from the axis goes to the angle: "
                "$\\theta = |\\omega|\\,t$.",
            ),
            mistake(
                "v not divided",
                exp(unit * size * seconds),
                "You divided $\\omega$ by its length, and not $v$. Both halves belong to one motion.",
            ),
            mistake(
                "straight on",
                homogeneous(right[:3, :3], v * seconds),
                "You moved the origin straight on, by $v\\,t$. While the body turns, $v$ is the velocity of whichever point is there.",
            ),
            mistake(
                "degrees",
                exp(np.concatenate([np.radians(omega), v]) * seconds),
                "You took the radians for degrees and converted them. They are what the exponential wants.",
            ),
        ],
    )


@problem(
    "02.7", "The way back, near half a turn", points=3, lecture="02_matrix_exponential#Small angles and half turns"
)
def near_half_a_turn(sampler: ArmSampler) -> Problem:
    direction, length = _direction(sampler)
    degrees = sampler.integer(162, 176)
    angle, u = np.radians(degrees), direction / length
    R = exp(u * angle)
    return Problem(
        statement="Give the logarithm of this rotation: the rotation vector, axis times angle, of its shortest turn.\n\n"
        f"$$R = {matrix(R)}$$\n\nHere it is printed with four digits, and near half a turn they are too few. `given.R` has them all.",
        given={"R": R},
        answer=Numbers(u * angle, unit="radians"),
        mistakes=[
            mistake(
                "arcsine",
                u * (np.pi - angle),
                "You found the angle by an arcsine. A sine cannot tell $\\theta$ from $\\pi - \\theta$; the trace can: "
                "$\\operatorname{tr} R = 1 + 2\\cos\\theta$ is near $-1$ here.",
            ),
            mistake(
                "axis alone",
                u,
                "This is the axis, a unit vector. The logarithm holds the angle too: axis times angle, in radians.",
            ),
            mistake("degrees", u * degrees, "The axis is right, the angle is in degrees. The logarithm is in radians."),
            mistake(
                "backwards",
                -u * angle,
                "This is the logarithm of $R^T$. From $R - R^T$, the first component is half of $r_{32} - r_{23}$, over the sine.",
            ),
            mistake(
                "the long way",
                -u * (2 * np.pi - angle),
                "This vector leads to $R$ as well, by the longer way round. The logarithm is the shorter one, $\\theta \\le \\pi$.",
            ),
            mistake(
                "not halved",
                2 * u * angle,
                "Your vector is twice as long as it should be. $R - R^T$ holds $2 \\sin\\theta\\,[\\omega]$: divide by two sines.",
            ),
        ],
    )


@problem("02.8", "A spindle as a formula", points=3, lecture="02_matrix_exponential#Helices")
def spindle_as_a_formula(sampler: ArmSampler) -> Problem:
    d, point = sampler.choice(AXIS_DIRECTIONS), sampler.point(4)
    h = sp.Rational(sampler.integer(1, 9), 20)
    w, p = exact(d), exact(point)
    R, v, climb = turn(w, THETA), exact(point).cross(exact(d)) + h * w, h * THETA * w
    robot = arm([(d, point, float(h))], frame((X, Y, Z), point + d), "your spindle", "drawn for you")
    return Problem(
        statement=f"A spindle along ${vector(d)}$ passes through ${vector(point)}$ and climbs {number(float(h))} m for each radian. Give "
        "$e^{[S]\\theta}$ as a formula in $\\theta$: sixteen entries, without a decimal.",
        figure=partial(draw_joints, robot),
        given={"axis": w, "point": p, "pitch": h},
        answer=PoseExpressionAnswer(symbolic_pose(R, p - R * p + climb)),
        mistakes=[
            mistake(
                "no climb",
                symbolic_pose(R, p - R * p),
                "Your body turns and does not climb. Along the axis it moves by $h\\,\\theta$.",
            ),
            mistake(
                "climb of a radian",
                symbolic_pose(R, p - R * p + h * w),
                "Your body climbs at once, and then never more. The climb grows with the angle: $h\\,\\theta$.",
            ),
            mistake(
                "straight on",
                symbolic_pose(R, v * THETA),
                "You wrote $v\\,\\theta$ in the column. Only the part of $v$ along the axis goes straight; the other is carried round.",
            ),
            mistake(
                "one-sided",
                symbolic_pose(R, R * p + climb),
                "You turned the point of the axis about the origin, $R\\,p$. It should stay on its axis: the column is $p - R\\,p$ "
                "and the climb.",
            ),
            mistake(
                "lead taken as pitch",
                symbolic_pose(R, p - R * p + climb / (2 * sp.pi)),
                "You divided by $2\\pi$. The climb is given for each radian: it is the pitch already.",
            ),
            mistake(
                "turned backwards",
                symbolic_pose(R.T, p - R.T * p + climb),
                "Your spindle turns by $-\\theta$ and climbs by $+\\theta$: it is left-handed.",
            ),
        ],
    )


def _direction(sampler: ArmSampler) -> tuple[Array, int]:
    """Draw a vector (3,) with integer entries, none of them zero, and its length, an integer too."""
    *sizes, length = sampler.choice(PYTHAGOREAN_QUADRUPLES)
    return np.array([sampler.choice((-1, 1)) * size for size in sampler.shuffled(sizes)], dtype=float), length


SHEET = Sheet(
    "02_matrix_exponential",
    "The matrix exponential",
    [
        matrix_of_a_screw,
        turn_about_a_line,
        rotation_as_a_formula,
        where_the_origin_goes,
        three_terms,
        gyroscope,
        near_half_a_turn,
        spindle_as_a_formula,
    ],
)
