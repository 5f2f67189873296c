"""Sheet 01: poses and rotations from drawings, points and directions, inverses, products, fixed and moving axes."""

from collections import deque
from functools import partial

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.lecture_01_frames.blanks import with_position
from kincourse.problem import problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG, ArmSampler, are_distinguishable
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.lie import exp, homogeneous, inverse
from kinlib.view import draw_frames
from kinlib.view.figures.frames import draw_rotation
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.order import Ordering
from misstep.display.text import matrix, vector
from misstep.mistakes import Mistake, mistake
from misstep.problem import Problem
from misstep.sheet import Sheet


@problem("01.1", "A pose off a drawing", points=2, lecture="01_frames#Columns and rows")
def pose_off_a_drawing(sampler: ArmSampler) -> Problem:
    place = np.zeros(3)
    while not are_distinguishable([np.zeros(3), place]):
        place = sampler.point(4) * (1, 1, 0) + sampler.integer(1, 4) * Z
    T = pose(sampler.axes(), place)
    R = T[:3, :3]
    return Problem(
        statement="Read $T_{sb}$ off the drawing. Coordinates are whole metres, and each axis of {b} runs along one of {s}. The dotted "
        "line drops to the floor: its foot has the numbers $x$ and $y$, and beside it stands the height.",
        figure=partial(draw_frames, {"s": np.eye(4), "b": T}, arrows=False, numbers=True),
        answer=PoseAnswer(T),
        mistakes=[
            mistake(
                "axes in rows",
                pose(R, place),
                "You wrote the axes of {b} into the rows. They are the columns of $R_{sb}$; its rows are the axes of {s} in {b}.",
            ),
            mistake(
                "seen from {b}",
                inverse(T),
                "This is $T_{bs}$, {s} seen from {b}. The first letter says who looks: write the axes of {b} with the numbers of {s}.",
            ),
            mistake(
                "left-handed",
                T * (1, -1, 1, 1),
                "Your $y$ points the other way, which makes the frame left-handed. $y = z \\times x$.",
            ),
            mistake(
                "coordinates swapped",
                with_position(T, place[[1, 0, 2]]),
                "You swapped $x$ and $y$ of the origin. At the foot of the dotted line, $x$ comes first.",
            ),
            mistake(
                "arrow turned round",
                with_position(T, -place),
                "Your $p$ leads from {b} to {s}. In $T_{sb}$ it is where {s} sees the origin of {b}.",
            ),
        ],
    )


@problem("01.2", "A rotation off a drawing", points=2, lecture="01_frames#Columns and rows")
def rotation_off_a_drawing(sampler: ArmSampler) -> Problem:
    k, degrees = sampler.integer(0, 2), sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1))
    R = _rotation(k, degrees)
    first, next_axis = "yzx"[k], "zxy"[k]
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    sine_and_cosine_swapped = np.where(
        np.isclose(R, c), s, np.where(np.isclose(R, s), c, np.where(np.isclose(R, -s), -c, R))
    )
    return Problem(
        statement="Frames {a} and {b} share their origin and one axis, along which you look: a dot is an arrow's tip, a cross its "
        "feathers. Give $R_{ab}$.",
        figure=partial(draw_rotation, k, degrees),
        answer=RotationAnswer(R),
        mistakes=[
            mistake(
                "turned the other way",
                R.T,
                "This is $R_{ba} = R_{ab}^T$: the signs of the sines are exchanged. The columns of $R_{ab}$ are the axes of {b}, read "
                f"along those of {{a}}. Is the share of ${next_axis}_a$ in ${first}_b$ positive or negative?",
            ),
            mistake(
                "sine and cosine swapped",
                sine_and_cosine_swapped,
                "You swapped sine and cosine. At 0 degrees $R$ is the identity, so the cosines stand on the diagonal.",
            ),
            mistake(
                "degrees",
                exp(degrees * np.eye(3)[k]),
                "You gave degrees to a cosine that reads radians: use np.radians first.",
            ),
            mistake(
                "about the next axis",
                _rotation((k + 1) % 3, degrees),
                f"You turned about ${'yzx'[k]}$. The axis that both frames share is ${'xyz'[k]}$, and its row and column hold a single 1.",
            ),
            mistake(
                "about the axis before",
                _rotation((k + 2) % 3, degrees),
                f"You turned about ${'zxy'[k]}$. The axis that both frames share is ${'xyz'[k]}$, and its row and column hold a single 1.",
            ),
        ],
    )


@problem("01.3", "An affine map in one matrix", points=2, lecture="01_frames#An affine map in one matrix")
def augmented_matrix(sampler: ArmSampler) -> Problem:
    shift_first = sampler.choice([True, False])
    degrees, p = sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1)), sampler.point(4)[:2]
    R = _rotation(2, degrees)[:2, :2]
    right, other = (R @ p, p) if shift_first else (p, R @ p)
    way = "anticlockwise" if degrees > 0 else "clockwise"
    rotation_text, translation_text = (
        f"turns the plane about the origin by {abs(degrees)} degrees {way}",
        f"shifts it by $p = {vector(p)}$",
    )
    description = (
        f"shifts the plane by $p = {vector(p)}$, and then {rotation_text.replace('the plane', 'it')}"
        if shift_first
        else f"{rotation_text}, and then {translation_text}"
    )
    return Problem(
        statement=f"A map {description}. Write it as one augmented matrix, (3, 3): it takes $(x, y, 1)$ to where the point $(x, y)$ goes.",
        given={"first": "shift" if shift_first else "turn", "degrees": degrees, "p": p},
        answer=Numbers(_augmented_matrix(R, right)),
        mistakes=[
            mistake(
                "the other order",
                _augmented_matrix(R, other),
                "You turned first and shifted after. Here the shift comes first, so the turn takes it along: $R\\,(x + p) = R\\,x + R\\,p$."
                if shift_first
                else "You shifted first and turned after. Here the turn comes first, and nothing turns the shift: $R\\,x + p$.",
            ),
            mistake(
                "translation in the last row",
                _augmented_matrix(R, right).T,
                "You wrote the matrix transposed: the translation stands in the last row. It belongs in the last column, where the extra 1 "
                "picks it up.",
            ),
            mistake(
                "turned the other way",
                _augmented_matrix(R.T, R.T @ p if shift_first else p),
                "You turned the other way. Anticlockwise is positive, and its matrix has $-\\sin$ in the upper right.",
            ),
            mistake(
                "not augmented",
                _augmented_matrix(R, 0 * p),
                "The translation is missing. $R$ alone leaves the origin where it is; the last column says where it goes.",
            ),
            mistake(
                "degrees",
                _augmented_matrix(exp(degrees * Z)[:2, :2], exp(degrees * Z)[:2, :2] @ p if shift_first else p),
                "You gave degrees to a cosine that reads radians: use np.radians first.",
            ),
        ],
    )


@problem("01.4", "A point and an arrow", points=2, lecture="01_frames#An affine map in one matrix")
def point_and_arrow(sampler: ArmSampler) -> Problem:
    T, point, d = _random_pose(sampler), sampler.point(6) / 10, sampler.point(6) / 10
    R, p = T[:3, :3], T[:3, 3]
    right = np.array([R @ point + p, R @ d])
    return Problem(
        statement=f"A camera {{c}} sees one end of a rod at the point ${vector(point)}$ m, and the arrow from there to the other end is "
        f"${vector(d)}$ m. Give both as {{s}} sees them, in two rows: the point, the arrow.\n\n$$T_{{sc}} = {matrix(T)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T}, arrows=False),
        given={"T_sc": T, "point_c": point, "arrow_c": d},
        answer=VectorsAnswer(right, names=["the point", "the arrow"]),
        mistakes=[
            mistake(
                "arrow as a point",
                [right[0], right[1] + p],
                "You gave the arrow a 1. It is a difference of two points, so its extra entry is 0: it turns and does not shift.",
            ),
            mistake(
                "point as an arrow",
                [R @ point, right[1]],
                "You gave the point a 0. A point has a 1, which adds $p$: $R\\,x + p$.",
            ),
            mistake(
                "1 and 0 exchanged",
                [R @ point, right[1] + p],
                "You exchanged the two: points have a 1 and shift, arrows have a 0 and do not.",
            ),
            mistake(
                "the way back",
                [R.T @ (point - p), R.T @ d],
                "You took $T_{cs}$, which goes from {s} to the camera. $T_{sc}$ takes what {c} says to what {s} says.",
            ),
            mistake(
                "rotation transposed",
                [R.T @ point + p, R.T @ d],
                "You turned with $R^T$. That takes arrows from {s} to {c}; here we go the other way. Did you write `x @ R`?",
            ),
            mistake(
                "not turned",
                [point + p, d],
                "You shifted, and did not turn. The camera counts along axes of its own: multiply by $R_{sc}$.",
            ),
        ],
    )


@problem("01.5", "Look back", points=2, lecture="01_frames#The inverse")
def look_back(sampler: ArmSampler) -> Problem:
    T = _random_pose(sampler)
    R, p, back = T[:3, :3], T[:3, 3], inverse(T)
    return Problem(
        statement=f"A gripper {{g}} stands at $T_{{sg}}$. Give $T_{{gs}}$: how the gripper sees the base.\n\n$$T_{{sg}} = {matrix(T)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "g": T}, arrows=False),
        given={"T_sg": T},
        answer=PoseAnswer(back),
        mistakes=[
            mistake(
                "minus p",
                with_position(back, -p),
                "You wrote $R^T$ and $-p$. The arrow $-p$ leads back to the base, but it is written in {s}: the gripper writes it as "
                "$-R^T p$.",
            ),
            mistake(
                "plus",
                with_position(back, R.T @ p),
                "The sign of the position is wrong. The gripper looks back to the base: $-R^T p$.",
            ),
            mistake(
                "turned the wrong way",
                with_position(back, -R @ p),
                "You turned $-p$ with $R$. That takes {g} to {s}; you need the other way, $R^T$.",
            ),
            mistake(
                "position kept",
                with_position(back, p),
                "You transposed $R$ and kept $p$. The position changes too: $-R^T p$.",
            ),
            mistake(
                "all transposed",
                T.T,
                "You transposed the whole matrix. $R^T$ undoes the turn, but the translation went into the last row, where none belongs.",
            ),
        ],
    )


@problem("01.6", "Letters that cancel", points=2, lecture="01_frames#Chaining along the links")
def letters_that_cancel(sampler: ArmSampler) -> Problem:
    T_sc, T_co, T_st = (_random_pose(sampler) for _ in range(3))
    T_so = T_sc @ T_co
    right = inverse(T_st) @ T_so
    wrong_inverse = homogeneous(T_st[:3, :3].T, -T_st[:3, 3])
    return Problem(
        statement="A camera {c} on the wall sees an object {o}. The base {s} knows where the camera and the tool {t} are. How does the "
        f"tool see the object? Give $T_{{to}}$.\n\n$$T_{{sc}} = {matrix(T_sc)}$$\n\n$$T_{{co}} = {matrix(T_co)}$$\n\n"
        f"$$T_{{st}} = {matrix(T_st)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "c": T_sc, "t": T_st}, arrows=False),
        given={"T_sc": T_sc, "T_co": T_co, "T_st": T_st},
        answer=PoseAnswer(right),
        mistakes=[
            mistake(
                "not inverted",
                T_st @ T_so,
                "You multiplied $T_{st} T_{sc} T_{co}$. The inner letters t and s differ, so nothing cancels: you need $T_{ts}$ in front.",
            ),
            mistake(
                "seen from the object",
                inverse(right),
                "This is $T_{ot}$, the tool seen from the object. The first letter says who looks.",
            ),
            mistake(
                "seen from the base",
                T_so,
                "This is $T_{so}$, the object seen from the base. The tool looks from elsewhere: put $T_{ts}$ in front.",
            ),
            mistake(
                "wrong side",
                T_so @ inverse(T_st),
                "You put $T_{ts}$ behind. There o meets t, and nothing cancels: in front, s meets s.",
            ),
            mistake(
                "camera turned round",
                inverse(T_st) @ inverse(T_sc) @ T_co,
                "You inverted $T_{sc}$ too. $T_{ts}\\,T_{sc}\\,T_{co}$: the letters cancel as they stand.",
            ),
            mistake(
                "inverse with minus p",
                wrong_inverse @ T_so,
                "The product is right, the inverse is not: its position is $-R^T p$, and you took $-p$.",
            ),
        ],
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
    turn, shift = homogeneous(_rotation(k, degrees), np.zeros(3)), homogeneous(np.eye(3), far * np.eye(3)[along])
    own, fixed = (turn, shift) if turn_is_own else (shift, turn)
    first, second = (turn, shift) if turns_first else (shift, turn)
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
    turn_in_degrees = homogeneous(exp(degrees * np.eye(3)[k]), np.zeros(3))
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
        answer=PoseAnswer(fixed @ T @ own),
        mistakes=[
            mistake(
                "sides exchanged",
                own @ T @ fixed,
                "You exchanged the sides. What is said of axes of {s} acts from the left, what is said of its own axes from the right.",
            ),
            mistake(
                "both from the left",
                second @ first @ T,
                "You multiplied both from the left. What is said about the frame's own axis acts in coordinates of {b}: from the right.",
            ),
            mistake(
                "both from the right",
                T @ first @ second,
                "You multiplied both from the right. What is said about an axis of {s} acts in coordinates of {s}: from the left.",
            ),
            mistake(
                "turned backwards",
                (inverse(turn) if fixed is turn else fixed) @ T @ (inverse(turn) if own is turn else own),
                "You turned the other way. By the right-hand rule, with the thumb along the axis, the fingers curl with a positive angle.",
            ),
            mistake(
                "degrees",
                (turn_in_degrees if fixed is turn else fixed) @ T @ (turn_in_degrees if own is turn else own),
                "You gave degrees to a cosine that reads radians: use np.radians first.",
            ),
        ],
    )


@problem("01.8", "Turns in order", points=2, lecture="01_frames#Fixed axes and moving axes")
def turns_in_order(sampler: ArmSampler) -> Problem:
    names = [f"R_{letter}" for letter in sampler.shuffled("abcd")]
    fixed = [sampler.choice([True, False]) for _ in names]
    right, sides_swapped = deque[str](), deque[str]()
    for name, room in zip(names, fixed, strict=True):
        (right.appendleft if room else right.append)(name)
        (sides_swapped.append if room else sides_swapped.appendleft)(name)
    listed = "\n".join(
        f"{i}. ${name}$, about {'an axis of the room' if room else 'an axis of its own'}"
        for i, (name, room) in enumerate(zip(names, fixed, strict=True), start=1)
    )
    return Problem(
        statement="A frame starts parallel to the room {s}, and makes four turns, one after the other:\n\n"
        f"{listed}\n\nIts attitude $R_{{sb}}$ is a product of the four. Put them in order, from left to right: a list of the names "
        "`'R_a'`, `'R_b'`, `'R_c'`, `'R_d'`.",
        given={"turns": names, "about_the_room": fixed},
        answer=Ordering(list(right)),
        mistakes=[
            mistake(
                "as told",
                names,
                "You wrote them in the order in which they happen. So it is for turns about own axes only: those about the room come from "
                "the left.",
            ),
            mistake(
                "each from the left",
                names[::-1],
                "You multiplied each from the left. So it is for turns about the room only: those about own axes come from the right.",
            ),
            mistake(
                "sides exchanged",
                list(sides_swapped),
                "You exchanged the sides. About an axis of the room: from the left. About an own axis: from the right.",
            ),
            mistake(
                "by the alphabet",
                sorted(names),
                "You followed the names. Follow the turns in time, and put each at the left or at the right of what is there.",
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
    "a": "Go through it once more: three unit columns, square to each other, the third the cross product of the first two, the last row.",
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
    T[:3, :3], T[:3, 3] = (T[:3, :3] @ pose(sampler.axes(), (0, 0, 0))[:3, :3]).round(2), sampler.point(5)
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
    there = "There is nothing wrong with it" if right == "a" else "That is in order, and something else is not"
    return mistake(f"flaw {wrong}", wrong, f"{there}. {FLAW_EXPLANATIONS[right]}")


def _rotation(k: int, degrees: float) -> Array:
    """The rotation (3, 3) about x, y or z for k = 0, 1 or 2."""
    R: Array = exp(np.radians(degrees) * np.eye(3)[k])
    return R


def _random_pose(sampler: ArmSampler) -> Array:
    """Draw a general pose: a product of two rotations, and a position with three coordinates of different size."""
    R, place = (
        _rotation(sampler.integer(0, 2), sampler.choice(PLAIN_ANGLES_DEG)) @ pose(sampler.axes(), (0, 0, 0))[:3, :3],
        np.zeros(3),
    )
    while not are_distinguishable([np.zeros(3), 3 * place]):
        place = sampler.point(9) / 10
    return homogeneous(R, place)


def _augmented_matrix(R: Array, p: Array) -> Array:
    """The affine map x -> R x + p of the plane in homogeneous coordinates, (3, 3)."""
    A = np.eye(3)
    A[:2, :2], A[:2, 2] = R, p
    return A


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
