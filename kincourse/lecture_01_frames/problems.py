"""Sheet 01: poses and rotations from drawings, points and directions, inverses, products, fixed and moving axes."""

from functools import partial

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.expressions.poses import (
    assemble,
    columns,
    inverse,
    point,
    pose,
    rotation_about,
    rotation_only,
    to_direction,
    to_point,
    translation,
    with_position,
)
from kincourse.expressions.screws import direction
from kincourse.problem import problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG, ArmSampler, are_distinguishable
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z
from kinlib.chains.robots import pose as frame
from kinlib.rigid.lie import exp, homogeneous
from kinlib.view import draw_frames
from kinlib.view.figures.frames import draw_rotation
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.order import Ordering
from misstep.display.text import matrix, vector
from misstep.mistakes import Mistake, mistake
from misstep.mutants.expression import given
from misstep.mutants.operations import ANGLE, VECTOR, function, radians, stack
from misstep.problem import Problem
from misstep.sheet import Sheet

LETTERS_CANCEL = "In front of $T_{sc}$ the inner letters s of $T_{ts}\\,T_{sc}$ cancel, and so do the letters c of $T_{sc}\\,T_{co}$."

LEFT_OR_RIGHT = (
    "A motion about an axis of {s} multiplies from the left, and one about an own axis multiplies from the right."
)


@problem("01.1", "A pose off a drawing", points=2, lecture="01_frames#Columns and rows")
def pose_off_a_drawing(sampler: ArmSampler) -> Problem:
    place = np.zeros(3)
    while not are_distinguishable([np.zeros(3), place]):
        place = sampler.point(4) * (1, 1, 0) + sampler.integer(1, 4) * Z
    labels = ("x_b", "y_b", "z_b")
    axes = [direction(label, axis) for label, axis in zip(labels, sampler.axes(), strict=True)]
    T_sb = assemble(
        columns(*axes),
        point("p_{sb}", place).mistaken_for(place * (1, 1, 0), "height left out", "leave out the height"),
    )
    return Problem(
        statement="Read $T_{sb}$ off the drawing. Coordinates are whole metres, and each axis of {b} runs along one of {s}. The dotted "
        "line drops to the floor: its foot has the numbers $x$ and $y$, and beside it stands the height.",
        figure=partial(draw_frames, {"s": np.eye(4), "b": T_sb.value}, arrows=False, numbers=True),
        answer=PoseAnswer(T_sb.value),
        solution=T_sb,
        advice={
            "axes in rows": "They are the columns of $R_{sb}$; its rows are the axes of {s} in {b}.",
            "inverted": "That is $T_{bs}$, {s} seen from {b}: write the axes of {b} with the numbers of {s}.",
            "sign of a vector": "The frame is left-handed then: $y = z \\times x$.",
            "take $p_{sb}$ with the opposite sign": "It leads from {s} to {b}, and its coordinates are those of {s}.",
            "coordinates swapped": "At the foot of the dotted line, $x$ comes first; the number beside the line is $z$.",
        },
    )


@problem("01.2", "A rotation off a drawing", points=2, lecture="01_frames#Columns and rows")
def rotation_off_a_drawing(sampler: ArmSampler) -> Problem:
    k, degrees = sampler.integer(0, 2), sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1))
    angle = given(f"{degrees}^\\circ", degrees, ANGLE)
    angle = angle.mistaken_for(180 - degrees, "supplement", f"subtract ${degrees}^\\circ$ from $180^\\circ$")
    angle = angle.mistaken_for(180 + degrees, "half a turn more", f"add $180^\\circ$ to ${degrees}^\\circ$")
    R = rotation_about(k, radians(angle))
    R = R.mistaken_for(R.value - np.diag(np.eye(3)[k]), "no 1 for the axis", "leave out the 1 of the shared axis")
    first, next_axis = "yzx"[k], "zxy"[k]
    return Problem(
        statement="Frames {a} and {b} share their origin and one axis, along which you look: a dot is an arrow's tip, a cross its "
        "feathers. Give $R_{ab}$.",
        figure=partial(draw_rotation, k, degrees),
        answer=RotationAnswer(R.value),
        solution=R,
        advice={
            "sign of an angle": "This is $R_{ba} = R_{ab}^T$. The columns of $R_{ab}$ are the axes of {b}, read along those of {a}. Is "
            f"the share of ${next_axis}_a$ in ${first}_b$ positive or negative?",
            "sine and cosine swapped": "At 0 degrees $R$ is the identity, so the cosines are on the diagonal.",
            "another axis": f"The axis that both frames share is ${'xyz'[k]}$, and its row and column hold a single 1.",
        },
    )


@problem("01.3", "An affine map in one matrix", points=2, lecture="01_frames#An affine map in one matrix")
def augmented_matrix(sampler: ArmSampler) -> Problem:
    shift_first = sampler.choice([True, False])
    degrees, shift = sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1)), sampler.point(4)[:2]
    R, p = rotation_about(2, radians(given("\\theta", degrees, ANGLE)))[:2, :2].named("R"), point("p", shift)
    rotated = function("rotated", np.matmul, "{0}\\,{1}")(R, p)
    # Where the translation comes first, R is used twice, and so it can be transposed in one place.
    block = (
        R.mistaken_for(R.T, "transposed", "transpose $R$ in the matrix, and not in the column") if shift_first else R
    )
    column, other, when = (rotated, p, "after") if shift_first else (p, rotated, "before")
    column = (
        column.mistaken_for(other, "order", f"translate {when} rotating")
        .mistaken_for(rotated + p, "order", "translate both before and after rotating")
        .mistaken_for(R.T @ p, "transposed", "multiply $p$ by $R^T$")
        .mistaken_for(R.value.diagonal() * shift, "entry by entry", "multiply $R$ and $p$ entry by entry")
    )
    A = assemble(block, column)
    way = "anticlockwise" if degrees > 0 else "clockwise"
    rotation_text, translation_text = (
        f"turns the plane about the origin by {abs(degrees)} degrees {way}",
        f"shifts it by $p = {vector(shift)}$",
    )
    description = (
        f"shifts the plane by $p = {vector(shift)}$, and then {rotation_text.replace('the plane', 'it')}"
        if shift_first
        else f"{rotation_text}, and then {translation_text}"
    )
    return Problem(
        statement=f"A map {description}. Write it as one augmented matrix, (3, 3): it takes $(x, y, 1)$ to where the point $(x, y)$ goes.",
        given={"first": "shift" if shift_first else "turn", "degrees": degrees, "p": shift},
        answer=Numbers(A.value),
        solution=A,
        advice={
            "order": "The order matters: here the translation comes first, so the rotation acts on it too: $R\\,(x + p) = R\\,x + R\\,p$."
            if shift_first
            else "The order matters: here the rotation comes first, and does not act on the translation: $R\\,x + p$.",
            "sign of an angle": "Anticlockwise is positive, and its matrix has $-\\sin$ in the upper right.",
            "last row": "In the last column the extra 1 picks it up.",
            "position left out": "$R$ alone leaves the origin where it is; the last column says where it goes.",
        },
    )


@problem("01.4", "A point and an arrow", points=2, lecture="01_frames#An affine map in one matrix")
def point_and_arrow(sampler: ArmSampler) -> Problem:
    T, x_c, d = _random_pose(sampler), sampler.point(6) / 10, sampler.point(6) / 10
    T_sc, x, arrow = pose("T_{sc}", T), given("x", x_c), given("d", d)
    arrow = arrow.mistaken_for(
        d - x_c, "point subtracted", "subtract the point from the arrow, which is a difference already"
    )
    end = to_point(T_sc, x + arrow)
    there = to_direction(T_sc, arrow).mistaken_for(
        end, "other end", "give the other end of the rod instead of the arrow"
    )
    swapped = stack(to_direction(T_sc, x), to_point(T_sc, arrow))
    both = (
        stack(to_point(T_sc, x), there)
        .mistaken_for(stack(x, arrow), "frame not changed", "write the coordinates in {c} unchanged")
        .mistaken_for(swapped, "1 and 0 swapped", "swap the 1 of a point and the 0 of a direction")
    )
    return Problem(
        statement=f"A camera {{c}} sees one end of a rod at the point ${vector(x_c)}$ m, and the arrow from there to the other end is "
        f"${vector(d)}$ m. Give both as {{s}} sees them, in two rows: the point, the arrow.\n\n$$T_{{sc}} = {matrix(T)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T}, arrows=False),
        given={"T_sc": T, "point_c": x_c, "arrow_c": d},
        answer=VectorsAnswer(both.value, unit="m", names=["the point", "the arrow"]),
        solution=both,
        advice={
            "inverted": "$T_{sc}$ takes coordinates in {c} to coordinates in {s}.",
            "rotation transposed": "$R^T$ takes components in {s} to components in {c}. Did you write `x @ R`?",
            "not rotated": "The camera counts along axes of its own: multiply by $R_{sc}$.",
        },
    )


@problem("01.5", "Look back", points=2, lecture="01_frames#The inverse")
def look_back(sampler: ArmSampler) -> Problem:
    T = _random_pose(sampler)
    T_gs = inverse(pose("T_{sg}", T))
    negated = homogeneous(-T[:3, :3].T, T_gs.value[:3, 3])
    T_gs = T_gs.mistaken_for(negated, "sign", "write a minus sign in front of the rotation $R^T$ too")
    return Problem(
        statement=f"A gripper {{g}} stands at $T_{{sg}}$. Give $T_{{gs}}$: how the gripper sees the base.\n\n$$T_{{sg}} = {matrix(T)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "g": T}, arrows=False),
        given={"T_sg": T},
        answer=PoseAnswer(T_gs.value),
        solution=T_gs,
        advice={
            "inverse left out": "It says how the base sees the gripper, and the question is how the gripper sees the base.",
            "transpose for inverse": "$R^T$ inverts the rotation, but the translation goes into the last row, where none belongs.",
            "write $-p$ as the position of the inverse of $T_{sg}$": "The vector $-p$ leads back to the base, but it is written in {s}: "
            "the gripper writes it as $-R^T p$.",
        },
    )


@problem("01.6", "Letters that cancel", points=2, lecture="01_frames#Chaining along the links")
def letters_that_cancel(sampler: ArmSampler) -> Problem:
    T_sc, T_co, T_st = (_random_pose(sampler) for _ in range(3))
    T_to = inverse(pose("T_{st}", T_st)) @ pose("T_{sc}", T_sc) @ pose("T_{co}", T_co)
    subtracted = with_position(T_to.value, (T_sc @ T_co)[:3, 3] - T_st[:3, 3])
    advice = "Their difference is written in {s}: rotate it with $R_{ts}$."
    T_to = T_to.mistaken_for(subtracted, "positions subtracted", "subtract the positions", advice)
    return Problem(
        statement="A camera {c} on the wall sees an object {o}. The base {s} knows where the camera and the tool {t} are. How does the "
        f"tool see the object? Give $T_{{to}}$.\n\n$$T_{{sc}} = {matrix(T_sc)}$$\n\n$$T_{{co}} = {matrix(T_co)}$$\n\n"
        f"$$T_{{st}} = {matrix(T_st)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T_sc, "t": T_st}, arrows=False),
        given={"T_sc": T_sc, "T_co": T_co, "T_st": T_st},
        answer=PoseAnswer(T_to.value),
        solution=T_to,
        advice={
            "inverse left out": "The inner letters t and s differ, so nothing cancels: $T_{ts}$ belongs in front.",
            "inverted": "In $T_{ts}\\,T_{sc}\\,T_{co}$ the inner letters cancel.",
            "factor left out": "All three are needed: $T_{ts}\\,T_{sc}\\,T_{co}$.",
            **dict.fromkeys(("order", "first factor", "last factor", "reversed"), LETTERS_CANCEL),
        },
    )


@problem("01.7", "Its own axis, or one of the room", points=3, lecture="01_frames#Left or right")
def own_or_fixed(sampler: ArmSampler) -> Problem:
    T, k, degrees = (
        _random_pose(sampler),
        sampler.integer(0, 2),
        sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1)),
    )
    along, far = sampler.integer(0, 2), sampler.length(0.2, 0.9)
    turns_first, turn_is_own = sampler.choice([True, False]), sampler.choice([True, False])
    angle = radians(given("\\theta", degrees, ANGLE))
    turn = rotation_only(rotation_about(k, angle)).named(f"\\mathrm{{Rot}}({'xyz'[k]}, \\theta)")
    shift_by = given("d", far * np.eye(3)[along], VECTOR)
    for other in {0, 1, 2} - {along}:
        text = f"translate along the ${'xyz'[other]}$ axis instead of the ${'xyz'[along]}$ axis"
        shift_by = shift_by.mistaken_for(far * np.eye(3)[other], "another axis", text)
    shift = translation(shift_by).named("\\mathrm{Trans}(d)")
    own, fixed = (turn, shift) if turn_is_own else (shift, turn)
    moved = fixed @ pose("T_{sb}", T) @ own
    whose = {True: "its own", False: "the"}
    rotation_text = (
        f"turns by {degrees} degrees about {whose[turn_is_own]} ${'xyz'[k]}$ axis{'' if turn_is_own else ' of {s}'}"
    )
    translation_text = (
        f"shifts by {far:.4g} m along {whose[not turn_is_own]} ${'xyz'[along]}$ axis{' of {s}' if turn_is_own else ''}"
    )
    description = (
        f"It {rotation_text}, then it {translation_text}."
        if turns_first
        else f"It {translation_text}, then it {rotation_text}."
    )
    return Problem(
        statement=f"A frame {{b}} stands at $T_{{sb}}$. {description} Where does it stand now, seen from {{s}}?\n\n"
        f"$$T_{{sb}} = {matrix(T)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "b": T}, arrows=False),
        given={
            "T_sb": T,
            "axis": np.eye(3)[k],
            "degrees": degrees,
            "shift": far * np.eye(3)[along],
            "own": "turn" if turn_is_own else "shift",
        },
        answer=PoseAnswer(moved.value),
        solution=moved,
        advice=dict.fromkeys(("order", "first factor", "last factor", "reversed"), LEFT_OR_RIGHT)
        | {
            "sign of an angle": "With the thumb of the right hand along the axis, the fingers curl with a positive angle."
        },
    )


EACH_AT_ITS_SIDE = (
    "About an axis of the room, each turn comes to the left of those before it; about an own axis, to the right."
)


@problem("01.8", "Turns in order", points=2, lecture="01_frames#Fixed axes and moving axes")
def turns_in_order(sampler: ArmSampler) -> Problem:
    names = [f"R_{letter}" for letter in sampler.shuffled("abcd")]
    fixed = sampler.shuffled([True, True, False, False])
    room = [name for name, is_fixed in zip(names, fixed, strict=True) if is_fixed]
    own = [name for name in names if name not in room]
    right = [*room[::-1], *own]
    listed = "\n".join(
        f"{i}. ${name}$, about {'an axis of the room' if room else 'an axis of its own'}"
        for i, (name, room) in enumerate(zip(names, fixed, strict=True), start=1)
    )
    return Problem(
        statement="A frame starts parallel to the room {s}, and makes four turns, one after the other:\n\n"
        f"{listed}\n\nIts attitude $R_{{sb}}$ is a product of the four. Put them in order, from left to right: a list of the names "
        "`'R_a'`, `'R_b'`, `'R_c'`, `'R_d'`.",
        given={"turns": names, "about_the_room": fixed},
        answer=Ordering(right),
        mistakes=[
            mistake(
                "as told",
                names,
                "You wrote them in the order in which they happen. That is right for turns about own axes only: those about the room come "
                "from the left.",
            ),
            mistake(
                "each from the left",
                names[::-1],
                "You multiplied each from the left. That is right for turns about the room only: those about own axes come from the right.",
            ),
            mistake(
                "by the alphabet",
                sorted(names),
                f"These are the names in the order of the alphabet. {EACH_AT_ITS_SIDE}",
            ),
            mistake(
                "order about the room", [*room, *own], f"The two turns about the room are swapped. {EACH_AT_ITS_SIDE}"
            ),
            mistake(
                "order about own axes",
                [*room[::-1], *own[::-1]],
                f"The two turns about own axes are swapped. {EACH_AT_ITS_SIDE}",
            ),
            *(
                mistake("sides exchanged", order, f"You multiplied on the wrong sides. {EACH_AT_ITS_SIDE}")
                for order in ([*own[::-1], *room], [*own, *room], [*own, *room[::-1]], [*own[::-1], *room[::-1]])
            ),
        ],
    )


FLAWS = {
    "a": "none: it is a rigid motion",
    "b": "a column of its rotation is no unit vector",
    "c": "two columns of its rotation are not square to each other",
    "d": "its rotation is left-handed: a reflection",
    "e": "its last row is not 0 0 0 1",
}

FLAW_EXPLANATIONS = {
    "a": "Go through it once more: three perpendicular unit columns, the third the cross product of the first two, and the last row.",
    "b": "Take the sum of squares of each column of the upper left block: one of them is not 1.",
    "c": "Take the scalar product of each two columns of the upper left block: one of them is not 0.",
    "d": "Compare the third column with the cross product of the first two: it is its opposite. The determinant is $-1$.",
    "e": "Look at the last row: in a pose it is 0 0 0 1, and the translation stands in the last column.",
}


@problem("01.9", "Rigid or not?", points=2, lecture="01_frames#Bug hunt")
def rigid_or_not(sampler: ArmSampler) -> Problem:
    right = sampler.choice(list(FLAWS))
    T = np.eye(4)
    for _ in range(2):  # with sides 3, 4 and 5 every entry has two decimals, so it can be squared on paper
        axis, (c, s) = sampler.choice((X, Y, Z)), np.array(sampler.shuffled([0.6, 0.8])) * (1, sampler.choice((-1, 1)))
        T = T @ homogeneous(exp(np.arctan2(s, c) * axis), np.zeros(3))
    T[:3, :3], T[:3, 3] = (T[:3, :3] @ frame(sampler.axes(), (0, 0, 0))[:3, :3]).round(2), sampler.point(5)
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
    return Problem(
        statement=f"Is this matrix a rigid motion? If not, what is wrong with it?\n\n$${matrix(T)}$$\n\n{listed}",
        given={"matrix": T},
        answer=Choice(right, FLAWS),
        mistakes=[_flaw_mistake(wrong, right) for wrong in FLAWS if wrong != right],
    )


def _flaw_mistake(wrong: str, right: str) -> Mistake:
    if wrong == "a":
        return mistake("called rigid", wrong, f"It is no rigid motion. {FLAW_EXPLANATIONS[right]}")
    there = "There is nothing wrong with it" if right == "a" else "This property holds, but another one does not"
    return mistake(f"flaw {wrong}", wrong, f"{there}. {FLAW_EXPLANATIONS[right]}")


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


SHEET = Sheet(
    "01_frames",
    "Frames",
    [
        pose_off_a_drawing,
        rotation_off_a_drawing,
        augmented_matrix,
        point_and_arrow,
        look_back,
        letters_that_cancel,
        own_or_fixed,
        turns_in_order,
        rigid_or_not,
    ],
)
