"""Sheet 01: poses and rotations from drawings, homogeneous coordinates, inverses, products, fixed and moving axes."""

from collections.abc import Callable
from functools import partial

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import EulerAnglesAnswer, PoseAnswer, RotationAnswer
from kincourse.expressions.poses import (
    assemble,
    columns,
    inverse,
    point,
    pose,
    rotation,
    rotation_about,
    rotation_only,
    to_direction,
    to_point,
    translation,
    with_position,
)
from kincourse.expressions.screws import direction
from kincourse.lecture_01_frames.drawings import draw_rotation
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG, are_distinguishable
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z
from kinlib.chains.robots import pose as frame
from kinlib.rigid.lie import exp, homogeneous
from kinlib.rigid.rpy import origin
from kinlib.view import draw_frames
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.ordering import Ordering
from misstep.answers.prose import Prose
from misstep.display.text import matrix, number, vector
from misstep.mistakes import Mistake
from misstep.mutants.expression import Operation, given
from misstep.mutants.operations import ANGLE, VECTOR, radians, stack

TITLE = "Frames"

SUBSCRIPTS_CANCEL = "Only in $T_{ts}\\,T_{sc}\\,T_{co}$ do all adjacent subscripts cancel: s with s, and c with c."

LEFT_OR_RIGHT = "A motion about or along an axis of {s} multiplies from the left, and one about or along an axis of {b} from the right."


@problem("01.1", "A pose from a drawing", points=2, lecture="01_frames#Columns and rows", level="Warm-up")
def pose_off_a_drawing(sampler: ArmSampler) -> Problem:
    place = np.zeros(3)
    while not are_distinguishable([np.zeros(3), place]):
        place = sampler.point(4) * (1, 1, 0) + sampler.integer(1, 4) * Z
    labels = ("x_b", "y_b", "z_b")
    axes = [direction(label, axis) for label, axis in zip(labels, sampler.axes(), strict=True)]
    T_sb = assemble(
        columns(*axes),
        point("p_{sb}", place).mistaken_for(("height left out", "leave out the height", place * (1, 1, 0))),
    )
    return Problem(
        statement="Read the pose $T_{sb}$ from the drawing. All coordinates are whole metres, and each axis of {b} is parallel to an axis "
        "of {s}. The dotted line is vertical: the two numbers at its foot are the coordinates $x$ and $y$ of the origin of {b}, and the "
        "number beside it is the height $z$.",
        further="What is $T_{bs}$, and which of its numbers can you read off the drawing directly?",
        figure=partial(draw_frames, {"s": np.eye(4), "b": T_sb.value}, numbers=True),
        answer=PoseAnswer(T_sb),
        advice={
            "axes in rows": "The axes of {b}, written in {s}, are the columns of $R_{sb}$; its rows are the axes of {s}, written in {b}.",
            "inverse": "The inverse is $T_{bs}$, the pose of {s} in {b}; in $T_{sb}$ the axes and the origin of {b} are written in {s}.",
            "sign of a vector": "The axes of a frame are right-handed, so that $y = z \\times x$: no axis can change its sign alone.",
            "take $p_{sb}$ with the opposite sign": "The vector $p_{sb}$ leads from the origin of {s} to the origin of {b}.",
            "coordinates swapped": "At the foot of the dotted line, $x$ comes first; the number beside the line is $z$.",
            "position in the other frame": "That is the same vector, written in {b}; the last column of $T_{sb}$ is written in {s}.",
        },
    )


@problem("01.2", "A rotation from a drawing", points=2, lecture="01_frames#Columns and rows", level="Warm-up")
def rotation_off_a_drawing(sampler: ArmSampler) -> Problem:
    k, degrees = sampler.integer(0, 2), sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1))
    angle = given(f"{degrees}^\\circ", degrees, ANGLE)
    angle = angle.mistaken_for(
        ("supplement", f"subtract ${degrees}^\\circ$ from $180^\\circ$", 180 - degrees),
        ("half a turn", f"add $180^\\circ$ to ${degrees}^\\circ$", 180 + degrees),
    )
    R = rotation_about(k, radians(angle))
    first, next_axis = "yzx"[k], "zxy"[k]
    return Problem(
        statement="Frames {a} and {b} share their origin and one axis, and you look along this axis. A dot means that it points towards "
        "you, a cross that it points away from you. Give $R_{ab}$.",
        method=f"{{a}} and {{b}} share the axis ${'xyz'[k]}$: its row and its column have a single 1. The rows and columns of ${first}$ "
        f"and ${next_axis}$, in this order, have the block $\\begin{{pmatrix}} \\cos\\theta & -\\sin\\theta \\\\ \\sin\\theta & "
        f"\\cos\\theta \\end{{pmatrix}}$ with $\\theta = {degrees}^\\circ$.",
        further="Which rotation takes you back from {b} to {a}, and how does its matrix differ from yours?",
        figure=partial(draw_rotation, k, degrees),
        answer=RotationAnswer(R),
        advice={
            "sign of an angle": "The opposite angle belongs to $R_{ba} = R_{ab}^T$. The columns of $R_{ab}$ are the axes of {b}, written "
            f"in {{a}}: is the component of ${first}_b$ along ${next_axis}_a$ positive or negative?",
            "sine and cosine swapped": "At 0 degrees $R$ is the identity, so the cosines are on the diagonal.",
            "another axis": f"The axis that both frames share is ${'xyz'[k]}$, so the row and the column of ${'xyz'[k]}$ have a single 1 "
            "and two zeros.",
        },
    )


@problem("01.3", "A motion of the plane as one matrix", points=2, lecture="01_frames#Homogeneous coordinates")
def homogeneous_matrix(sampler: ArmSampler) -> Problem:
    shift_first = sampler.choice([True, False])
    degrees, shift = sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1)), sampler.point(4)[:2]
    R, p = rotation_about(2, radians(given("\\theta", degrees, ANGLE)))[:2, :2].named("R"), point("p", shift)
    rotated = Operation("rotated", np.matmul, "{0}\\,{1}".format)(R, p)
    # Where the translation comes first, R is used twice, and so it can be transposed in one place.
    block = (
        R.mistaken_for(("transposed", "transpose $R$ in the matrix, and not in the last column", R.T))
        if shift_first
        else R
    )
    column, other, when = (rotated, p, "after") if shift_first else (p, rotated, "before")
    column = column.mistaken_for(
        ("order", f"translate {when} rotating", other),
        ("order", "translate both before and after rotating", rotated + p),
        ("transposed", "multiply $p$ by $R^T$", R.T @ p),
        ("entry by entry", "multiply $R$ and $p$ entry by entry", R.value.diagonal() * shift),
    )
    A = assemble(block, column)
    if shift_first:
        A = A.mistaken_for(("rotation left out", "leave out the rotation", translation(p)))
    sense = "counterclockwise" if degrees > 0 else "clockwise"
    rotation_text = f"rotated about the origin by {abs(degrees)} degrees {sense}"
    translation_text = f"translated by $p = {vector(shift)}$"
    first, second = (translation_text, rotation_text) if shift_first else (rotation_text, translation_text)
    return Problem(
        statement=f"Every point of the plane is first {first}, and then {second}. Write this motion as one homogeneous transformation of "
        "shape (3, 3). It takes the homogeneous coordinates $(x, y, 1)$ of a point to those of the place to which the point moves.",
        method=f"$R$ is the rotation by $\\theta = {degrees}°$.",
        further="Swap the order of the two motions. Which block of the matrix changes, and which stays?",
        given={"first": "shift" if shift_first else "turn", "degrees": degrees, "p": shift},
        answer=Numbers(A),
        advice={
            "order": "The order matters: here the translation comes first, so the rotation acts on it too: $R\\,(x + p) = R\\,x + R\\,p$."
            if shift_first
            else "The order matters: here the rotation comes first, so it does not act on the translation: $R\\,x + p$.",
            "sign of an angle": "Counterclockwise is positive: the first row of the rotation block is $(\\cos\\theta, -\\sin\\theta)$.",
            "position left out": "Without it the origin stays where it is; the last column says where the origin goes.",
            "rotation left out": "The upper left block is the rotation $R$.",
        },
    )


@problem("01.4", "A point and a direction", points=2, lecture="01_frames#Homogeneous coordinates")
def point_and_arrow(sampler: ArmSampler) -> Problem:
    T, x_c, d = _random_pose(sampler), sampler.point(6) / 10, sampler.point(6) / 10
    T_sc, x, arrow = pose("T_{sc}", T), given("x", x_c), given("d", d)
    arrow = arrow.mistaken_for(
        ("point subtracted", "subtract the point from the vector, which is a difference of two points already", d - x_c)
    )
    end = to_point(T_sc, x + arrow)
    there = to_direction(T_sc, arrow).mistaken_for(
        ("other end", "give the other end of the rod instead of the vector that leads there", end)
    )
    swapped = stack(to_direction(T_sc, x), to_point(T_sc, arrow))
    both = stack(to_point(T_sc, x), there).mistaken_for(
        ("frame not changed", "write the coordinates in {c} unchanged", stack(x, arrow)),
        ("1 and 0 swapped", "swap the 1 of a point and the 0 of a direction", swapped),
    )
    return Problem(
        statement=f"One end of a rod is the point $x = {vector(x_c)}$ m, and $d = {vector(d)}$ m is the vector from there to the other "
        "end. Both are written in the frame {c} of a camera. Write both in {s}: the point in the first row, the vector in the second.\n\n"
        f"$$T_{{sc}} = {matrix(T)}$$",
        further="The camera moves by 1 m without rotating. Which of your two rows changes?",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T}),
        given={"T_sc": T, "point_c": x_c, "arrow_c": d},
        answer=VectorsAnswer(both, unit="m", names=["the point", "the vector"]),
        advice={
            "inverse": "$T_{sc}$ takes coordinates in {c} to coordinates in {s}.",
            "rotation transposed": "$R_{sc}^T$ takes components in {s} to components in {c}. In NumPy, `x @ R` is $R^T x$.",
            "rotation left out": "The axes of {c} are not parallel to those of {s}: multiply by $R_{sc}$.",
            "frame not changed": "The numbers in {s} differ, because {s} has another origin and other axes.",
        },
    )


@problem("01.5", "The inverse of a pose", points=2, lecture="01_frames#The inverse")
def look_back(sampler: ArmSampler) -> Problem:
    T = _random_pose(sampler)
    T_gs = inverse(pose("T_{sg}", T))
    negated = homogeneous(-T[:3, :3].T, T_gs.value[:3, 3])
    T_gs = T_gs.mistaken_for(("sign", "write a minus sign in front of the rotation $R^T$ too", negated))
    return Problem(
        statement=f"The pose of a gripper {{g}} in the base frame {{s}} is $T_{{sg}}$. Give $T_{{gs}}$, the pose of the base in the frame "
        f"of the gripper.\n\n$$T_{{sg}} = {matrix(T)}$$",
        method=f"The inverse of $(R, p)$ is $(R^T, -R^T p)$, here with $-R^T p = {vector(T_gs.value[:3, 3])}$.",
        further="For which poses is the inverse the same matrix as the pose itself?",
        figure=partial(draw_frames, {"s": np.eye(4), "g": T}),
        given={"T_sg": T},
        answer=PoseAnswer(T_gs),
        advice={
            "inverse left out": "$T_{sg}$ is the pose of the gripper in {s}; the question is the pose of the base in {g}.",
            "transpose for inverse": "The transpose inverts the rotation, but it also moves the position into the last row.",
            "write $-p$ as the position of the inverse of $T_{sg}$": "The vector $-p$ leads from the gripper to the base, but it is "
            "written in {s}. Written in {g}, it is $-R^T p$.",
        },
    )


@problem("01.6", "Subscripts that cancel", points=2, lecture="01_frames#Chaining along the links")
def subscripts_that_cancel(sampler: ArmSampler) -> Problem:
    T_sc, T_co, T_st = (_random_pose(sampler) for _ in range(3))
    T_to = inverse(pose("T_{st}", T_st)) @ pose("T_{sc}", T_sc) @ pose("T_{co}", T_co)
    subtracted = with_position(T_to.value, (T_sc @ T_co)[:3, 3] - T_st[:3, 3])
    advice = "The difference of the positions is a vector written in {s}: multiply it by $R_{ts}$."
    T_to = T_to.mistaken_for(("positions subtracted", "subtract the positions", subtracted, advice))
    whole = inverse(pose("T_{st}", T_st) @ pose("T_{sc}", T_sc) @ pose("T_{co}", T_co))
    T_to = T_to.mistaken_for(("inverse of the product", "invert the whole product instead of $T_{st}$ alone", whole))
    return Problem(
        statement="A camera {c} on the wall measures the pose $T_{co}$ of an object {o}. The poses of the camera and of the tool {t} in "
        f"the base frame {{s}} are known. Give $T_{{to}}$, the pose of the object in the frame of the tool.\n\n"
        f"$$T_{{sc}} = {matrix(T_sc)}$$\n\n$$T_{{co}} = {matrix(T_co)}$$\n\n$$T_{{st}} = {matrix(T_st)}$$",
        further="Which pose do you get from $T_{oc}\\,T_{cs}\\,T_{st}$, and how is it related to your answer?",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T_sc, "t": T_st}),
        given={"T_sc": T_sc, "T_co": T_co, "T_st": T_st},
        answer=PoseAnswer(T_to),
        advice={
            "inverse left out": "The inverse of $T_{st}$ is $T_{ts}$, whose second subscript cancels with the first of $T_{sc}$.",
            "factor left out": "All three factors are needed: $T_{ts}\\,T_{sc}\\,T_{co}$.",
            **dict.fromkeys(("inverse", "order", "first factor", "last factor", "reversed"), SUBSCRIPTS_CANCEL),
        },
    )


LEFT_FOR_FIXED_AXES = (
    "A rotation about an axis of {s} goes to the left of all earlier ones, one about an axis of the frame to the right."
)


@problem("01.7", "Rotations in order", points=2, lecture="01_frames#Fixed axes and moving axes")
def rotations_in_order(sampler: ArmSampler) -> Problem:
    names = [f"R_{letter}" for letter in sampler.shuffled("abcd")]
    fixed = sampler.shuffled([True, True, False, False])
    about_fixed = [name for name, is_fixed in zip(names, fixed, strict=True) if is_fixed]
    own = [name for name in names if name not in about_fixed]
    right = [*about_fixed[::-1], *own]
    products = ["\\,".join(name for name in right if name in names[:count]) for count in (1, 2, 3, 4)]
    listed = "\n".join(
        f"{i}. ${name}$, about {'an axis of {s}' if is_fixed else 'one of its own axes'}"
        for i, (name, is_fixed) in enumerate(zip(names, fixed, strict=True), start=1)
    )
    if_all = "It would be right if all were about axes of"
    sides = "The sides are swapped: the rotations about axes of the frame are to the left of those about axes of {s}."
    wrong = [
        ("in the order of time", names, f"This is the order in which the rotations happen. {if_all} the frame."),
        ("each from the left", names[::-1], f"This is the reverse of the order in which the rotations happen. {if_all} {{s}}."),
        ("by the alphabet", sorted(names), "These are the names in the order of the alphabet."),
        ("order about fixed axes", [*about_fixed, *own], "The two rotations about axes of {s} are swapped."),
        ("order about own axes", [*about_fixed[::-1], *own[::-1]], "The two rotations about axes of the frame are swapped."),
        *(("sides swapped", [*one, *two], sides) for one in (own[::-1], own) for two in (about_fixed, about_fixed[::-1])),
    ]  # fmt: skip
    return Problem(
        statement="At first, a frame {b} is parallel to the fixed frame {s}. Then it makes four rotations, one after the other:\n\n"
        f"{listed}\n\nIts orientation $R_{{sb}}$ is a product of the four matrices. Give the factors in order, from left to right, as a "
        "list of the names `'R_a'`, `'R_b'`, `'R_c'`, `'R_d'`.",
        method=f"{LEFT_FOR_FIXED_AXES}\nIn time, the product becomes {', then '.join(f'${one}$' for one in products)}.",
        further="Which two rotations, one right after the other in time, could change places without changing $R_{sb}$?",
        given={"turns": names, "about_the_room": fixed},
        answer=Ordering(right),
        mistakes=[Mistake(name, order, f"{text} {LEFT_FOR_FIXED_AXES}") for name, order, text in wrong],
    )


FLAWS = {
    "a": "no condition: it is a rigid motion",
    "b": "the columns of R are unit vectors",
    "c": "the columns of R are orthogonal to each other",
    "d": "R is right-handed, that is, no reflection",
    "e": "the last row is 0 0 0 1",
}

FLAWS_REFUTED = {
    "a": "This matrix is not a rigid motion, because one of the conditions fails. Test them one by one.",
    "b": "The columns of $R$ are unit vectors: in each of them the sum of the squares is 1.",
    "c": "The columns of $R$ are orthogonal to each other: the dot product of any two of them is 0.",
    "d": "$R$ is not left-handed: its determinant is positive.",
    "e": "The last row is 0 0 0 1, as it should be.",
}
"""Why each answer is wrong where it is wrong, without the right answer."""


@problem("01.8", "Is it a rigid motion?", points=2, lecture="01_frames#Columns and rows")
def rigid_or_not(sampler: ArmSampler) -> Problem:
    right = sampler.choice(list(FLAWS))
    T = np.eye(4)
    while not 0.1 < abs(T[0, 2]) < 0.9:  # the first entry of the cross product is to be computed, not guessed
        T = frame(sampler.axes(), (0, 0, 0))
        for axis in sampler.shuffled([X, Y, Z])[:2]:  # with sides 3, 4 and 5 an entry has two decimals
            c, s = np.array(sampler.shuffled([0.6, 0.8])) * (1, sampler.choice((-1, 1)))
            T = homogeneous(exp(np.arctan2(s, c) * axis), np.zeros(3)) @ T
    T[:3, :3], T[:3, 3] = T[:3, :3].round(2), sampler.point(5)
    j, k = sampler.shuffled([0, 1, 2])[:2]
    if right == "b":
        T[:3, j] *= sampler.choice([0.5, 1.5, 2])
    elif right == "c":
        T[:3, j] = 0.6 * T[:3, j] + sampler.choice((-1, 1)) * 0.8 * T[:3, k]
    elif right == "d":
        T[:3, j] *= -1
    elif right == "e":
        T[3, :3], T[:3, 3] = T[:3, 3], 0
    listed = "\n".join(f"- `'{letter}'`: {flaw}" for letter, flaw in FLAWS.items())
    R = T[:3, :3]
    first = np.cross(R[:, 0], R[:, 1])[0]
    other = ", and all other conditions hold."
    shows, shown = {
        "b": (np.linalg.norm(R[:, j]), f"Column {j + 1} is no unit vector{other} Its length is"),
        "c": (R[:, j] @ R[:, k], f"Columns {j + 1} and {k + 1} are not orthogonal{other} Their dot product is"),
        "d": (first, "Column 3 is the negative of the cross product of columns 1 and 2, whose first entry is"),
        "e": (T[3] @ T[3], f"The last row is ${vector(T[3])}${other} The sum of its squares is"),
        "a": (first, "All conditions hold: column 3 is the cross product of columns 1 and 2, whose first entry is"),
    }[right]
    problem = Problem(
        statement="Is this matrix a rigid motion? If not, which condition fails? $R$ is its upper left block, of shape (3, 3).\n\n"
        f"$${matrix(T)}$$\n\n{listed}\n\nAnswer with a letter and a number that shows it, such as `('b', 1.7)`: for `'b'` the length of "
        "the column that is no unit vector, for `'c'` the dot product of the two columns that are not orthogonal, for `'e'` the sum of the "
        "squares of the last row, and for `'a'` and `'d'` the first entry of the cross product of columns 1 and 2.",
        method=f"{shown} ${number(float(shows))}$.",
        further="Change as few entries as possible to make this matrix a rigid motion. Is there only one way?",
        given={"matrix": T},
        answer=Choice(right, FLAWS),
        mistakes=[Mistake(f"flaw {wrong}", wrong, FLAWS_REFUTED[wrong]) for wrong in FLAWS if wrong != right],
    )
    return problem.with_reason(Numbers(np.array(float(shows))), "the number")


MAX_COSINE = 0.95
"""Of an own axis and the fixed axis of the same name, so that a motion about one differs from that about the other."""


@problem("01.9", "Fixed axes or moving axes", points=3, lecture="01_frames#Left or right", level="Hard")
def own_or_fixed(sampler: ArmSampler) -> Problem:
    degrees, far = sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1)), sampler.length(0.2, 0.9)
    T = _random_pose(sampler)
    while np.abs(np.diag(T)[:3]).min() > MAX_COSINE:  # an own axis that is parallel to the fixed one hides the mistake
        T = _random_pose(sampler)
    oblique = np.flatnonzero(np.abs(np.diag(T)[:3]) <= MAX_COSINE).tolist()
    k, along = sampler.choice(oblique), sampler.choice(oblique)
    turns_first, turn_is_own = sampler.choice([True, False]), sampler.choice([True, False])
    angle = radians(given("\\theta", degrees, ANGLE))
    turn = rotation_only(rotation_about(k, angle)).named(f"\\mathrm{{Rot}}({'xyz'[k]}, \\theta)")
    shift_by = given("d", far * np.eye(3)[along], VECTOR)
    for other in {0, 1, 2} - {along}:
        text = f"translate along the ${'xyz'[other]}$ axis instead of the ${'xyz'[along]}$ axis"
        shift_by = shift_by.mistaken_for(("another axis", text, far * np.eye(3)[other]))
    shift = translation(shift_by).named("\\mathrm{Trans}(d)")
    own, fixed = (turn, shift) if turn_is_own else (shift, turn)
    moved = fixed @ pose("T_{sb}", T) @ own
    moving, still = "its own ${}$ axis", "the ${}$ axis of {{s}}"
    about, alongside = (moving, still) if turn_is_own else (still, moving)
    motions = [
        f"rotates by {degrees} degrees about {about.format('xyz'[k])}",
        f"translates by {far:.4g} m along {alongside.format('xyz'[along])}",
    ]
    first, second = motions if turns_first else motions[::-1]
    return Problem(
        statement=f"A frame {{b}} has the pose $T_{{sb}}$ in {{s}}. It {first}, and then it {second}. Give its new pose in {{s}}.\n\n"
        f"$$T_{{sb}} = {matrix(T)}$$",
        further="Exchange *own* and *fixed* in both motions. When is the result the same?",
        figure=partial(draw_frames, {"s": np.eye(4), "b": T}),
        given={"T_sb": T, "axis": np.eye(3)[k], "degrees": degrees, "shift": far * np.eye(3)[along]},
        shown={"own": "turn" if turn_is_own else "shift"},
        answer=PoseAnswer(moved),
        advice=dict.fromkeys(("order", "first factor", "last factor", "reversed"), LEFT_OR_RIGHT)
        | {
            "sign of an angle": "By the right-hand rule, the fingers curl in the positive sense if the thumb points along the axis."
        },
    )


SINGULAR = 1e-9
"""The cosine of the pitch up to which roll and yaw count as rotations about one line."""

ROW_ADVICE = "Give them in the order roll, pitch, yaw: $R = R_z(\\text{yaw})\\,R_y(\\text{pitch})\\,R_x(\\text{roll})$."


def _rpy_of(R: Array) -> Array:
    """Roll, pitch and yaw of a rotation; a roll of 0 where only the difference is determined."""
    cosine = np.hypot(R[0, 0], R[1, 0])
    if cosine < SINGULAR:
        return np.array([0.0, np.arctan2(-R[2, 0], cosine), np.arctan2(-R[0, 1], R[1, 1])])
    return np.array([np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], cosine), np.arctan2(R[1, 0], R[0, 0])])


# fmt: off
_RPY_SLIPS: tuple[tuple[str, str, Callable[[Array], Array], str], ...] = (
    ("reversed", "give yaw, pitch, roll in this order", lambda R: _rpy_of(R)[::-1], ROW_ADVICE),
    ("all signs", "take all angles with the opposite sign", lambda R: -_rpy_of(R), ""),
    ("sign of the pitch", "take the pitch with the opposite sign", lambda R: _rpy_of(R) * (1, -1, 1), "$R_{31} = -\\sin(\\text{pitch})$."),
    ("half a turn", "give a roll that is off by 180°", lambda R: np.add(_rpy_of(R), (np.pi, 0, 0)), "`np.arctan2` finds the quadrant."),
    ("half a turn", "give a yaw that is off by 180°", lambda R: np.add(_rpy_of(R), (0, 0, np.pi)), "`np.arctan2` finds the quadrant."),
    ("roll left out", "leave the roll at 0", lambda R: _rpy_of(R) * (0, 1, 1), ""),
    ("yaw left out", "leave the yaw at 0", lambda R: _rpy_of(R) * (1, 1, 0), ""),
    ("rotation transposed", "use the transpose of $R$", lambda R: _rpy_of(R.T), ""),
    ("moving axes", "take the angles about moving axes, $R_x\\,R_y\\,R_z$", lambda R: -_rpy_of(R.T), ROW_ADVICE),
    ("angle twice", "give the same angle to roll and yaw", lambda R: _rpy_of(R)[[2, 1, 2]],
     "Where roll and yaw rotate about one line, $R$ gives one number for both."),
    ("sign of the roll", "take the roll with the opposite sign", lambda R: _rpy_of(R) * (-1, 1, 1), ""),
    ("complement", "subtract the pitch from 90°", lambda R: np.array([0, np.pi / 2, 0]) + _rpy_of(R) * (1, -1, 1), ""),
    ("sign of the yaw", "take the yaw with the opposite sign", lambda R: _rpy_of(R) * (1, 1, -1), ""),
)
# fmt: on
_rpy: Operation = Operation("roll, pitch, yaw", _rpy_of, "\\mathrm{{rpy}}({0})".format)


@problem("01.10", "Orientations as three angles", points=3, lecture="01_frames#Three angles", level="Hard")
def three_angles(sampler: ArmSampler) -> Problem:
    def angle() -> int:
        return int(sampler.choice((-1, 1)) * sampler.choice((20, 25, 35, 40, 50, 55, 110, 125, 140, 155)))

    pitch = sampler.choice((-1, 1)) * sampler.choice((15, 20, 35, 40, 50, 55))
    general = origin(rpy=np.radians([angle(), pitch, angle()]))[:3, :3]
    singular = origin(rpy=np.radians([0, 90 * sampler.choice((-1, 1)), angle()]))[:3, :3]
    found = []
    for name, R in (("R_1", general), ("R_2", singular)):
        slips = [(slip, text, of(R), *why) for slip, text, of, *why in _RPY_SLIPS]
        found.append(_rpy(rotation(name, R)).mistaken_for(*slips, may_coincide=True))
    angles = stack(*found)
    return Problem(
        statement="Give roll, pitch and yaw of both orientations in radians, a row for each. Several answers are right.\n\n"
        f"$$R_1 = {matrix(general)}$$\n\n$$R_2 = {matrix(singular)}$$",
        method="From $R = R_z(\\text{yaw})\\,R_y(\\text{pitch})\\,R_x(\\text{roll})$: the pitch is $\\operatorname{atan2}(-R_{31}, "
        "\\sqrt{R_{11}^2 + R_{21}^2})$, the roll $\\operatorname{atan2}(R_{32}, R_{33})$ and the yaw "
        "$\\operatorname{atan2}(R_{21}, R_{11})$.\n"
        "In $R_2$ the arguments of the last two are 0: roll and yaw rotate about one line. With a roll of 0 the yaw is "
        "$\\operatorname{atan2}(-R_{12}, R_{22})$.",
        further="Which of your two answers changes most if one entry of $R$ is off by a hundredth?",
        given={"R_1": general, "R_2": singular},
        answer=EulerAnglesAnswer(angles),
    )


def _rotation(k: int, degrees: float) -> Array:
    """The rotation (3, 3) about x, y or z for k = 0, 1 or 2."""
    R: Array = exp(np.radians(degrees) * np.eye(3)[k])
    return R


def _random_pose(sampler: ArmSampler) -> Array:
    """Draw a general pose: a product of two rotations, and a position with three coordinates of different size."""
    R, place = (
        _rotation(sampler.integer(0, 2), sampler.choice(PLAIN_ANGLES_DEG)) @ frame(sampler.axes(), (0, 0, 0))[:3, :3],
        np.zeros(3),
    )
    while not are_distinguishable([np.zeros(3), 3 * place]):
        place = sampler.point(9) / 10
    return homogeneous(R, place)


@problem("01.11", "What one point does not test", points=3, lecture="01_frames#Columns and rows", level="Open")
def missed_by_a_test(sampler: ArmSampler) -> Problem:
    x = sampler.point(4)
    return Problem(
        statement=f"A colleague tests a computed pose $T$ by one point: does it take $x = {vector(x)}$ to the right place? Give a wrong "
        "pose that passes this test, and say how you found it. Then give a wrong pose that passes the test with two points of "
        "your choice. How many points does a test need, and how must they lie, so that no wrong pose passes? Say why.",
        answer=Prose(
            "A rotation about any line through $T x$, multiplied from the left, keeps $T x$ where it is, so $R'T$ with such an $R'$ "
            "is wrong and passes. Two points are kept by the rotations about the line that joins them. Three points that are not on "
            "one line are enough: a rigid motion that keeps them keeps their plane, and the normal of the plane as well, because it "
            "is right-handed.",
            {
                "a wrong pose for one point, with the reason that it passes": 1,
                "a wrong pose for two points: a rotation about their line": 1,
                "three points that are not on one line, with a reason": 1,
            },
        ),
    )
