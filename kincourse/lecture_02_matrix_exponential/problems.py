"""Sheet 02: hat, Rodrigues' formula, motions in closed form, a truncated series, a non-unit axis, a logarithm."""

from __future__ import annotations

from functools import partial

import numpy as np
import sympy as sp

from kincourse.answers.formulas import PoseExpressionAnswer
from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.expressions.poses import assemble, inverse, point
from kincourse.expressions.poses import pose as given_pose
from kincourse.expressions.rodrigues import angle_symbol, position_exp, rotation_exp, truncated
from kincourse.expressions.screws import direction, moment
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import AXIS_DIRECTIONS
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, arm
from kinlib.chains.robots import pose as frame
from kinlib.rigid.lie import exp, hat, homogeneous
from kinlib.symbolic.formulas import exact
from kinlib.symbolic.merge_rotations import homogeneous as symbolic_pose
from kinlib.symbolic.merge_rotations import rotation as turn
from kinlib.view import draw_joints
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number, vector
from misstep.mutants.expression import Expression, Operation, given
from misstep.mutants.operations import ANGLE, LENGTH, cos, radians, sin, sqrt, square, unit

TITLE = "The matrix exponential"

CHECK_TOLERANCE = 0.01
"""How far the trace, and the vector that a rotation keeps, may be off for a logarithm with three decimals."""

PYTHAGOREAN_QUADRUPLES = ((2, 3, 6, 7), (1, 4, 8, 9), (2, 6, 9, 11), (3, 4, 12, 13))
"""The entries, all different, and the length of vectors for which all are integers, so that they can be computed on paper."""

PYTHAGOREAN_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17))

trace = Operation("trace", np.trace, "\\operatorname{{tr}} {0}".format)
arccos = Operation("arccos", lambda x: np.arccos(np.clip(x, -1, 1)), "\\arccos {0}".format)
axial = Operation(
    "axial vector",
    lambda R: np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]),
    "({0} - {0}^T)^\\vee".format,
)

RODRIGUES = (
    "Rodrigues' formula is $e^{[\\omega]\\theta} = I + \\sin\\theta\\,[\\omega] + (1 - \\cos\\theta)\\,[\\omega]^2$, for a unit "
    "vector $\\omega$."
)
PITCH = "The given number is in metres per radian, so it is the pitch already."
COMPONENTS = "The error has two components: one from the series of the cosine, one from that of the sine."
CLIMB = "The body climbs along the axis, by $h\\,\\theta$."
KEPT = "The axis keeps its place, so the rotation adds $p - R\\,p$."
NOT_DIVIDED = "divide $\\omega$ by its length, but not $v$"
ONE_MOTION = "A twist is scaled as a whole."
SHORTEST = "Longer vectors lead to $R$ as well. The logarithm is the shortest one, with $\\theta \\le \\pi$."


@problem(
    "02.1", "A rotation about a given axis", points=2, lecture="02_matrix_exponential#The key identity", level="Warm-up"
)
def turn_about_a_line(sampler: ArmSampler) -> Problem:
    direction, length = _direction(sampler)
    degrees = sampler.choice([degrees for degrees in range(35, 165, 5) if degrees not in (45, 90, 120)])
    angle = given("\\theta", degrees, ANGLE).mistaken_for(("supplement", "rotate by $180° - \\theta$", 180 - degrees))
    R = rotation_exp(unit(point("d", direction)), radians(angle))
    return Problem(
        statement=f"A body rotates by $\\theta$ = {degrees} degrees about an axis with the direction $d = {vector(direction)}$. "
        "Give its rotation matrix $R$.",
        method=RODRIGUES,
        further="Which points of space stay where they are? What changes if $d$ is negated?",
        given={"direction": direction, "degrees": degrees},
        answer=RotationAnswer(R),
        advice={
            "not a unit vector": f"The axis must be a unit vector: divide by its length, {length}.",
            "sign of an angle": "With the opposite sign of the angle you get $R^T$. Check the signs in $[\\omega]$, too.",
        },
    )


@problem("02.2", "A rotation as a formula", points=2, lecture="02_matrix_exponential#The key identity", level="Warm-up")
def rotation_as_a_formula(sampler: ArmSampler) -> Problem:
    one, two, length = sampler.choice(PYTHAGOREAN_TRIPLES)
    whole = sp.Matrix(sampler.shuffled([0, sampler.choice((-1, 1)) * one, sampler.choice((-1, 1)) * two]))
    omega = whole / length
    axis = unit(point(vector(list(whole)), np.array(whole, dtype=float).ravel())).named("\\omega")
    return Problem(
        statement=f"Give $R(\\theta) = e^{{[\\omega]\\theta}}$ for $\\omega = \\frac{{1}}{{{length}}}{vector(list(whole))}$ as a "
        "matrix of nine formulas in $\\theta$, with fractions instead of decimals.",
        method=RODRIGUES,
        further="Set $\\theta = \\pi$ in your formula. Why is the matrix now symmetric?",
        given={"omega": omega},
        answer=ClosedForm(turn(omega, _theta())),
        solution=lambda theta: rotation_exp(axis, angle_symbol(theta)),
        advice={"sign of an angle": "With $-\\theta$, every sine changes its sign, and you get $R^T$."},
    )


@problem("02.3", "A motion with constant velocity", points=3, lecture="02_matrix_exponential#From rotations to screws")
def gyroscope(sampler: ArmSampler) -> Problem:
    size, seconds = sampler.choice([2.0, 3.0, 0.5]), sampler.choice([0.4, 0.5, 0.6, 0.7, 0.8])
    omega, v = size * sampler.choice(AXIS_DIRECTIONS), sampler.point(3)
    already = "convert $\\omega$ from degrees to radians, although it is in radians"
    w = direction("\\omega", omega).mistaken_for(("converted to radians", already, np.radians(omega)))
    v_0, t = direction("v", v), given("t", seconds).mistaken_for(("time left out", "leave out the time", 1.0))
    twist, R = np.concatenate([omega, v]), exp(omega * seconds)
    column = position_exp(w, v_0.mistaken_for(("v not divided", NOT_DIVIDED, size * v, ONE_MOTION)), t)
    column = column.mistaken_for(
        ("R v", "write $R\\,v\\,t$", R @ v * seconds),
        ("v itself", "write $v$", v),
        ("v as a point", "take $v$ as a point of the axis, $v - R\\,v$", v - R @ v),
        advice="$v$ is the velocity of the point at the origin.",
    )
    kept = "If you divide the axis by its length, the angle is multiplied by it: $\\theta = |\\omega|\\,t$."
    one, both = np.concatenate([omega / size, v]), twist / size
    there = assemble(rotation_exp(w, t), column).mistaken_for(
        ("angle kept", "divide the twist by $|\\omega|$ without changing the time", exp(both * seconds), kept),
        ("angle kept", "divide $\\omega$ by $|\\omega|$ without changing the time", exp(one * seconds), kept),
        ("halves swapped", "swap $\\omega$ and $v$", exp(np.roll(twist, 3) * seconds), "A twist is $(\\omega, v)$."),
        ("series cut short", "stop the series after two terms", truncated(hat(twist) * seconds, 2)),
        ("series cut short", "stop the series after three terms", truncated(hat(twist) * seconds, 3)),
    )
    return Problem(
        statement=f"A gyroscope measures that a body rotates with $\\omega = {vector(omega)}$ radians per second. The point of the body "
        f"that is at the origin has the velocity $v = {vector(v)}$ metres per second. Both vectors are constant in {{s}}. At time 0 the "
        f"pose of the body is $I$. Give its pose after {number(seconds)} seconds.",
        further="When has the body made exactly one turn, and where is it then?",
        given={"omega": omega, "v": v, "seconds": seconds},
        answer=PoseAnswer(there),
    )


@problem("02.4", "Three terms of the series", points=3, lecture="02_matrix_exponential#The series, term by term")
def three_terms(sampler: ArmSampler) -> Problem:
    angle, radius = sampler.choice([1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8]), sampler.length(0.3, 2.5)

    already = "convert $\\theta$ from degrees to radians, although it is in radians"
    theta = given("\\theta", angle).mistaken_for(
        ("converted to radians", already, np.radians(angle)),
        ("degrees", "convert $\\theta$ to degrees", np.degrees(angle), "The series, sine and cosine take radians."),
    )
    r = given("r", radius)
    along = cos(theta) - 1 + square(theta) / 2
    cubed = np.sin(angle) - angle + angle**3 / 6
    across = (sin(theta) - theta).mistaken_for(
        ("four terms", "stop the series after four terms, with $\\theta^3/3!$", cubed, "The sum has three terms.")
    )
    distance = sqrt(square(along) + square(across))
    sum_size = np.hypot(1 - angle**2 / 2, angle)
    distance = distance.mistaken_for(
        ("next term", "give the length of the first term that is missing; the terms after it count too", angle**3 / 6),
        ("last term", "give the length of the last term of the sum", angle**2 / 2),
        ("chord", "give the distance by which the point moves", 2 * np.sin(angle / 2)),
        ("arc", "give the length of the arc on which the point moves", angle),
        ("length of the sum", "give the length of the sum, and not of its difference from $R$", sum_size),
    )
    error = given("1000", 1000.0).mistaken_for(("centimetres", "give the number in centimetres", 100.0)) * r * distance
    error = error.mistaken_for(("root left out", "give the square of the distance", 1000 * square(r * distance)))
    return Problem(
        statement="You stop the series of $e^{[\\omega]\\theta}$ after three terms, $I + [\\omega]\\theta + [\\omega]^2\\theta^2/2$, "
        f"with $|\\omega| = 1$ and $\\theta = {number(angle)}$ rad. Then you apply the sum to a point that "
        f"is {number(radius)} m from the axis. How far is the result from the right position, in millimetres?",
        further="How much smaller is the error with half of the angle? Which power of $\\theta$ is this?",
        given={"radius": radius, "theta": angle},
        answer=Numbers(error, unit="mm"),
        advice={
            "leave out $\\theta^2 / 2$": "The identity is a term too, so the first three terms are $I$, $[\\omega]\\theta$ and "
            "$[\\omega]^2\\theta^2/2$.",
            "forget to divide by $2$": "The third term has the factorial $2! = 2$ in its denominator.",
            "leave out the factor $1000$": "One metre is 1000 millimetres, and the question asks for millimetres.",
            "divide by $r$ instead of multiplying by it": "The error is proportional to the distance from the axis.",
            **dict.fromkeys((f"leave out ${square(one).latex}$" for one in (across, along)), COMPONENTS),
        },
    )


@problem("02.5", "A helical joint as a formula", points=3, lecture="02_matrix_exponential#Helices")
def spindle_as_a_formula(sampler: ArmSampler) -> Problem:
    d, place = sampler.choice(AXIS_DIRECTIONS), sampler.point(4)
    h = sp.Rational(sampler.integer(1, 9), 20)
    w, p = exact(d), exact(place)
    R = turn(w, _theta())

    def solution(theta: float) -> Expression:
        omega, q, through = direction("\\omega", d), angle_symbol(theta), given("p", place)
        pitch = given("h", float(h)).mistaken_for(
            ("lead for pitch", "divide the climb by $2\\pi$", float(h) / (2 * np.pi), PITCH),
            ("lead for pitch", "multiply the climb by $2\\pi$", float(h) * 2 * np.pi, PITCH),
        )
        rotation, climb = rotation_exp(omega, q), pitch * q * omega
        R_p = rotation @ through
        turned = position_exp(omega, moment(omega, through), q)
        column = position_exp(omega, moment(omega, through) + pitch * omega, q)
        along_another = turned + pitch * q * omega[[1, 2, 0]], turned + pitch * q * omega[[2, 0, 1]]
        column = column.mistaken_for(
            ("climb of a radian", "take $h$ as the climb for every angle", through - R_p + pitch * omega, CLIMB),
            ("R p alone", "write $R\\,p$ and the climb", R_p + climb, KEPT),
            ("p itself", "write $p$ and the climb", through + climb, KEPT),
            ("climb along p", "add a climb along the point $p$", turned + pitch * q * through, CLIMB),
            *(
                ("climb along another axis", "let the body climb along another axis", wrong, CLIMB)
                for wrong in along_another
            ),
        )
        backwards = rotation_exp(omega, -q)
        left_handed = assemble(backwards, through - backwards @ through + climb)
        text = "use $-\\theta$ in the rotation and $+\\theta$ in the climb"
        return assemble(rotation, column).mistaken_for(
            ("left-handed", text, left_handed, "That is a left-handed screw joint.")
        )

    robot = arm([(d, place, float(h))], frame((X, Y, Z), place + d), "your joint", "drawn for you")
    return Problem(
        statement=f"A helical joint has the direction ${vector(d)}$, passes through ${vector(place)}$ and climbs "
        f"{number(float(h))} m per radian. "
        "Give $e^{[S]\\theta}$ as a matrix of sixteen formulas in $\\theta$, with fractions instead of decimals.",
        further="Set the pitch to 0. Which entries of your matrix change?",
        figure=partial(draw_joints, robot),
        given={"axis": w, "point": p, "pitch": h},
        answer=PoseExpressionAnswer(symbolic_pose(R, p - R * p + h * _theta() * w)),
        solution=solution,
        advice={
            "leave out $h\\,\\omega$": "The term $h\\,\\omega$ is the climb: the body translates by $h\\,\\theta$ along the axis.",
            "leave out the factor $h$": "The factor $h$ is the pitch: the body translates by $h\\,\\theta$ along the axis.",
        },
    )


@problem("02.6", "Where the origin goes", points=3, lecture="02_matrix_exponential#From rotations to screws")
def where_the_origin_goes(sampler: ArmSampler) -> Problem:
    d, e = sampler.choice([(d, e) for d in AXIS_DIRECTIONS for e in (X, Y, Z) if not d @ e])
    k = sampler.choice((-1, 1)) * sampler.integer(1, 5)
    w = exact(d)
    beside = k * np.abs(np.cross(d, e))
    place = sp.Symbol("a", positive=True) * exact(e) + exact(beside)

    def column(theta: float, a: float) -> Expression:
        omega, q = direction("\\omega", d), angle_symbol(theta)
        p = (given("a", a, LENGTH) * given(vector(e), e) + given(vector(beside), beside)).named("p")
        R_p = rotation_exp(omega, q) @ p
        return position_exp(omega, moment(omega, p), q).mistaken_for(
            ("R p alone", "write $R\\,p$", R_p, "The point $p$ stays where it is, so the column is $p - R\\,p$."),
            (
                "sign",
                "take $R\\,p$ with the opposite sign",
                p + R_p,
                "The point $p$ stays where it is, so $p$ is $R\\,p$ plus the column.",
            ),
            ("p itself", "write the point of the joint", p, "The column is where the origin of {s} moves."),
        )

    told = ", ".join(str(entry) for entry in place)
    return Problem(
        statement=f"A revolute joint has the direction ${vector(d)}$ and passes through the point $({told})$. The length $a$ is not "
        "yet known. Give the translation part of $e^{[S]\\theta}$, the place to which the origin moves, as three formulas in $a$ and "
        "$\\theta$.",
        further="At which $\\theta$ is the origin farthest from where it began?",
        given={"omega": w, "point": place},
        answer=ClosedForm(place - turn(w, _theta()) * place),
        solution=column,
    )


@problem("02.7", "A logarithm near half a turn", points=3, lecture="02_matrix_exponential#The logarithm", level="Hard")
def near_half_a_turn(sampler: ArmSampler) -> Problem:
    direction, length = _direction(sampler)
    degrees = sampler.integer(172, 177)  # four digits of a sine are too few
    angle, u = np.radians(degrees), direction / length
    R = exp(u * angle)
    R_given = given("R", R)
    theta, trace_R = arccos((trace(R_given) - 1) / 2).named("\\theta"), np.trace(R)
    once = theta
    once = once.mistaken_for(
        ("arcsine", "take the angle from an arcsine", np.pi - angle),
        ("degrees", "give the angle in degrees", degrees, "The logarithm is in radians."),
        ("a full turn more", "add a full turn to the angle", angle + 2 * np.pi, SHORTEST),
        ("the long way", "rotate in the opposite direction, by the longer angle", angle - 2 * np.pi, SHORTEST),
        ("term left out", "leave out the 1 of $\\operatorname{tr} R - 1$ in the angle", np.arccos(trace_R / 2)),
        ("halved", "take half of the angle", angle / 2),
    )
    half = axial(R_given) / 2
    x = once * (half / sin(theta))
    x = x.mistaken_for(
        ("R - R^T alone", "give the components of $R - R^T$", axial(R_given).value),
        ("R - R^T alone", "give the components of $(R - R^T) / 2$", half.value),
        ("diagonal of R", "give the diagonal of $R$", np.diag(R)),
        ("signs left out", "leave out the signs of the axis", np.abs(u) * angle),
        ("sign of a vector", "take the differences of $R - R^T$ the other way round", -u * angle),
        advice="The logarithm is $\\theta$ times the components of $(R - R^T) / (2 \\sin\\theta)$.",
    )

    def keeps_its_axis(x: Array) -> str:
        size, off = float(np.linalg.norm(x)), float(np.linalg.norm(R @ x - x))
        if off > CHECK_TOLERANCE * max(1.0, size):
            return f"The axis stays where it is, $R x = x$; with your vector, $R x$ and $x$ are {off:.3g} apart."
        trace = 1 + 2 * np.cos(size)
        text = f"The trace of $R$ is $1 + 2 \\cos\\theta$; the length of your vector makes it {trace:.4g}."
        return text if abs(trace - np.trace(R)) > CHECK_TOLERANCE else ""

    return Problem(
        statement="Give the logarithm of this rotation: the vector $\\omega\\,\\theta$, unit axis times angle, with $0 \\le "
        "\\theta \\le \\pi$.\n\n"
        f"$$R = {matrix(R)}$$\n\nIt is printed with four digits. Near half a turn these are too few, so use `given.R`, which "
        f"has all of them.",
        method="$R - R^T = 2 \\sin\\theta\\,[\\omega]$, so $\\omega\\,\\theta = \\frac{\\theta}{2 \\sin\\theta}\\,(R - R^T)^\\vee$, where "
        "$[x]^\\vee = x$ takes the vector out of its skew-symmetric matrix.",
        further="The symmetric part of $R$ gives the axis, too. Why is it more accurate near half a turn?",
        given={"R": R},
        answer=Numbers(x, unit="rad", test=keeps_its_axis),
        advice={
            "arcsine": "A sine cannot tell $\\theta$ from $\\pi - \\theta$; the trace can.",
            "leave out the factor $\\theta$": "The unit vector is the axis alone. The logarithm is axis times angle.",
            "forget to divide by $2$": "$R - R^T = 2 \\sin\\theta\\,[\\omega]$, so you need half of it.",
            "divisor left out": "Divide by the sine, because $R - R^T = 2 \\sin\\theta\\,[\\omega]$.",
        },
    )


def _theta() -> sp.Symbol:
    return sp.Symbol("theta", real=True)


def _direction(sampler: ArmSampler) -> tuple[Array, int]:
    """Draw a vector (3,) with integer entries, none of them zero, and its length, an integer too."""
    *sizes, length = sampler.choice(PYTHAGOREAN_QUADRUPLES)
    return np.array([sampler.choice((-1, 1)) * size for size in sampler.shuffled(sizes)], dtype=float), length


still_point = Operation(
    "the point that stays", lambda T: np.linalg.solve(np.eye(2) - T[:2, :2], T[:2, 3]), "(I - R)^{{-1}}\\,p".format
)


@problem("02.8", "The hinge of a door", points=3, lecture="02_matrix_exponential#The logarithm", level="Hard")
def hinge(sampler: ArmSampler) -> Problem:
    first, opening = sampler.degrees(-170, 170), sampler.choice((-1, 1)) * sampler.degrees(35, 110)
    place, handle = sampler.point(9)[:2] / 2, sampler.length(0.6, 0.9)
    height = sampler.length(0.9, 1.1)

    def pose_at(angle: float) -> Array:
        turned = exp(np.radians(angle) * Z)
        return homogeneous(turned, np.array([*place, height]) + handle * turned[:, 0])

    T_1, T_2 = (given_pose(f"T_{i}", pose_at(angle)) for i, angle in ((1, first), (2, first + opening)))
    motion = (
        (T_2 @ inverse(T_1))
        .named("T")
        .mistaken_for(
            ("another frame", "take the motion in the frame of the door, $T_1^{-1}\\,T_2$", inverse(T_1) @ T_2),
            ("another frame", "take the motion in the frame of the door, $T_2^{-1}\\,T_1$", inverse(T_2) @ T_1),
        )
    )
    point_of = still_point(motion)
    ends = T_1.value[:2, 3], T_2.value[:2, 3]
    step = T_2.value[:2, 3] - T_1.value[:2, 3]
    point_of = point_of.mistaken_for(
        ("position itself", "give the translation part of the motion", motion.value[:2, 3]),
        ("middle", "give the point half-way between the two positions", (ends[0] + ends[1]) / 2),
        ("step", "give the vector between the two positions", step),
        ("first position", "give the position of the handle in the first pose", ends[0]),
        ("second position", "give the position of the handle in the second pose", ends[1]),
        ("mirror image", "give the mirror image of the hinge in the line of the two positions", ends[0] + ends[1] - np.array(place)),
        advice="Only the points of the hinge stay where they are.",
    )  # fmt: skip
    return Problem(
        statement="A frame is mounted on the handle of a door, whose hinge is vertical. Its pose in {s} was measured twice, before "
        f"and after the door was moved. Where is the hinge? Give its $x$ and $y$ in {{s}}, in metres.\n\n$$T_1 = {matrix(T_1.value)}$$\n\n"
        f"$$T_2 = {matrix(T_2.value)}$$",
        method="$T = T_2\\,T_1^{-1}$ is the motion of the door in {s}. Its first two rows say that a point $x$ moves to $R\\,x + p$; the "
        "hinge does not move, $R\\,x + p = x$.",
        further="The two poses are measured to a centimetre. For which opening angles is the hinge found most accurately?",
        given={"T_1": T_1.value, "T_2": T_2.value},
        answer=Numbers(point_of, unit="m"),
    )


@problem(
    "02.9", "Two ways to one pose", points=3, lecture="02_matrix_exponential#From rotations to screws", level="Open"
)
def two_ways_to_a_pose(_: ArmSampler) -> Problem:
    return Problem(
        statement="A robot carries a full glass from one pose to another. It may follow the screw motion $e^{[S]\\theta t}\\,T_1$ for $t$ "
        "from 0 to 1, or move the glass along a straight line while it rotates about its own centre. Describe both paths of the "
        "centre of the glass. Which one depends on where the frame of the glass was placed? Which one do you choose, and for "
        "what would you choose the other?",
        answer=Prose(
            "On the screw motion the centre follows a helix, or an arc if the pitch is 0. On the other path it follows a straight "
            "line. The screw motion is the same for every frame that is fixed to the glass, because $T_2 T_1^{-1}$ does not depend "
            "on it; on the other path only the chosen centre moves straight. For a glass in free space the straight path is short "
            "and easy to foresee; the screw is right for a door, a lid or a thread, where the body itself moves like this.",
            {
                "helix or arc for one path, straight line for the other": 1,
                "the straight path depends on the chosen centre, and the screw motion does not, with a reason": 1,
                "a choice with a reason that fits the task, and a task for the other": 1,
            },
        ),
    )
