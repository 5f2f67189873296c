"""Answers by hand to sheet 09: reading URDF files."""

import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, other_letters, right, wrong, wrong_answers
from evidence.answers_by_hand.common import drawings
from evidence.answers_by_hand.common.kinematics import frame, ordinary_forms, pose_slips, turn
from evidence.answers_by_hand.common.motions import Array, product
from evidence.answers_by_hand.common.tables import SIGN
from evidence.answers_by_hand.lecture_05 import LEFT_OUT, SWAP

OWN_AXES = "own axes, moving, order, R_x R_y R_z, fixed, intrinsic"
RPY_ORDER = "yaw, pitch, roll, order"


def rotation(rpy: Any, order: str = "zyx") -> Array:
    """The rotation by roll, pitch and yaw, with the factors in this order from the left."""
    angles = dict(zip("xyz", rpy, strict=True))
    return product(*(turn(axis, angles[axis]) for axis in order))


def screw(direction: Any, point: Any) -> Array:
    """The screw axis (omega, v) of a revolute joint."""
    return np.concatenate([direction, np.cross(point, direction)])


def rpy_slips(rpy: Any) -> dict[str, tuple[Array, str]]:
    """Wrong rotations from roll, pitch and yaw."""
    roll, pitch, yaw = rpy
    return {
        "about its own axes": (rotation(rpy, "xyz"), OWN_AXES),
        "yaw first": (rotation((yaw, pitch, roll)), RPY_ORDER),
        "yaw first, about its own axes": (rotation((yaw, pitch, roll), "xyz"), f"{RPY_ORDER}, {OWN_AXES}, transpos"),
        "transposed": (rotation(rpy).T, "transpos, R^T, parent to joint, invers"),
        "read as degrees": (rotation(np.radians(rpy)), "degree, radian"),
        "turned into degrees": (rotation(np.degrees(rpy)), "degree, radian"),
        "every angle negated": (rotation(-np.array(rpy)), f"{SIGN}, left hand, right hand, transpos"),
        "roll negated": (rotation((-roll, pitch, yaw)), f"{SIGN}, roll, right hand"),
        "pitch negated": (rotation((roll, -pitch, yaw)), f"{SIGN}, pitch, right hand"),
        "yaw negated": (rotation((roll, pitch, -yaw)), f"{SIGN}, yaw, right hand"),
        "not turned": (np.eye(3), f"turn, as it stands, rpy, {LEFT_OUT}, parent"),
    }


def _no_angle(rpy: Any) -> set[str]:
    """The slips that change nothing for these angles, whichever numbers a student has: the sign of an angle that is 0."""
    return {f"{name} negated" for name, angle in zip(("roll", "pitch", "yaw"), rpy, strict=True) if angle == 0}


@wrong_answers("09.1")
def pose_of_a_joint(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    xyz, rpy = np.array(given.xyz), np.array(given.rpy)
    R = rotation(rpy)
    cases: dict[str, tuple[Any, str]] = {
        label: (frame(changed, xyz), words)
        for label, (changed, words) in rpy_slips(rpy).items()
        if label not in _no_angle(rpy)
    }
    yield from wrong(
        {
            **pose_slips(frame(R, xyz)),
            **cases,
            "the shift turned too": (frame(R, R @ xyz), "shift, turned, xyz, before"),
            "the shift turned back": (frame(R, R.T @ xyz), "shift, turned, xyz, transpos, R^T p"),
            "x and y of the shift swapped": (frame(R, xyz[[1, 0, 2]]), SWAP),
            "xyz and rpy swapped": (frame(rotation(xyz), rpy), SWAP),
            "about its own axes, transposed": (frame(rotation(rpy, "xyz").T, xyz), f"{OWN_AXES}, transpos, {RPY_ORDER}, {SIGN}"),
            "about its own axes, the shift turned too": (
                frame(rotation(rpy, "xyz"), rotation(rpy, "xyz") @ xyz), f"{OWN_AXES}, shift, turned, xyz"),
            "yaw first, the shift negated": (frame(rotation(rpy[::-1]), -xyz), f"{RPY_ORDER}, {SIGN}"),
        }
    )  # fmt: skip
    yield from right(ordinary_forms(frame(R, xyz).round(6)))


@wrong_answers("09.2")
def direction_of_an_axis(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    rpy, axis = np.array(given.rpy), np.array(given.axis)
    R = rotation(rpy)
    yield from wrong(
        {
            **{
                label: (changed @ axis, words + ", parent, stands")
                for label, (changed, words) in rpy_slips(rpy).items()
                if label not in _no_angle(rpy)
            },
            "opposite": (-R @ axis, f"{SIGN}, other way, right hand"),
            "the z axis of the joint": (R[:, 2], "z axis, axis, z of"),
            "the x axis of the joint": (R[:, 0], "x axis, axis, x of"),
            "transposed, opposite": (-R.T @ axis, f"transpos, R^T, {SIGN}, invers, own axes"),
            "the sign of one number": (R @ axis * np.where(np.arange(3) == np.argmax(np.abs(R @ axis)), -1, 1), SIGN),
            "no signs": (np.abs(R @ axis), SIGN),
            "the first two numbers swapped": ((R @ axis)[[1, 0, 2]], f"{SWAP}, yaw"),
            "the origin added": (R @ axis + (0, 0, 1), "origin, direction, shift, xyz"),
            "turned twice": (R @ R @ axis, "twice"),
            "only the roll": (turn("x", rpy[0]) @ axis, f"roll, {LEFT_OUT}"),
            "only the yaw": (turn("z", rpy[2]) @ axis, f"yaw, {LEFT_OUT}"),
            "about its own axes, opposite": (-rotation(rpy, "xyz") @ axis, f"{OWN_AXES}, {SIGN}"),
            "as it stands, opposite": (-axis, f"as it stands, parent, {SIGN}"),
        }
    )
    yield from right({**ordinary_forms((R @ axis).round(6)), "a tuple": tuple(R @ axis)})


def joints_of(urdf: str) -> list[tuple[Array, Array, Array]]:
    """Of each joint in the order of the file: xyz, rpy and axis, (3,) each, with right angles in place of 1.5708."""

    def numbers(joint: str, element: str, attribute: str, default: str) -> Array:
        found = re.search(rf'<{element}\b[^>]*\b{attribute}="([^"]*)"', joint)
        return np.array([float(x) for x in (found.group(1) if found else default).split()])

    joints = re.findall(r"<joint.*?</joint>", urdf, re.DOTALL)
    exact = [np.round(numbers(joint, "origin", "rpy", "0 0 0") / 1.5708) * np.pi / 2 for joint in joints]
    return [
        (numbers(joint, "origin", "xyz", "0 0 0"), rpy, numbers(joint, "axis", "xyz", "1 0 0"))
        for joint, rpy in zip(joints, exact, strict=True)
    ]


@wrong_answers("09.3")
def joint_deep_in_the_file(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    (p1, r1, _), (p2, r2, _), (p3, r3, _) = joints_of(given.urdf)
    R1, R2, R3 = rotation(r1), rotation(r2), rotation(r3)
    own1, own2 = rotation(r1, "xyz"), rotation(r2, "xyz")
    place, turned = p1 + R1 @ p2 + R1 @ R2 @ p3, "turn, rpy, order, parent, R_1, R_2, rotat"
    yield from wrong(
        {
            "as it stands": (p3, "as it stands, base, parent"),
            "the origins added": (p1 + p2 + p3, "added, turn, rotati"),
            "turned by its own rpy too": (p1 + R1 @ p2 + R1 @ R2 @ R3 @ p3, "turned, rpy"),
            "each turned by its own rpy": (R1 @ p1 + R2 @ p2 + R3 @ p3, f"own, {turned}"),
            "each turned by its parent's rpy only": (p1 + R1 @ p2 + R2 @ p3, "pile up, parent"),
            "R_2 R_1": (p1 + R1 @ p2 + R2 @ R1 @ p3, "order, wrong way round, left"),
            "all turned back": (p1 + R1.T @ p2 + (R1 @ R2).T @ p3, "transpos, invers, R^T"),
            "R_1^T R_2^T": (p1 + R1.T @ p2 + R1.T @ R2.T @ p3, "transpos, invers, R^T"),
            "joint 1 left out": (p2 + R2 @ p3, f"joint 1, first, {LEFT_OUT}"),
            "joint 2 left out": (p1 + R1 @ p3, f"joint 2, second, {LEFT_OUT}"),
            "joint 1's shift left out": (R1 @ p2 + R1 @ R2 @ p3, f"joint 1, first, shift, {LEFT_OUT}"),
            "stopped at joint 2": (p1 + R1 @ p2, "joint_2, joint 2, stopped, parent, origin of"),
            "the last step not turned": (p1 + R1 @ p2 + p3, f"{turned}, {LEFT_OUT}"),
            "the last step turned by R_1 only": (p1 + R1 @ (p2 + p3), f"R_2, {turned}, {LEFT_OUT}"),
            "joint 2's step not turned": (p1 + p2 + R1 @ R2 @ p3, f"joint 2, {turned}"),
            "from tip to base": (p3 + R3 @ p2 + R3 @ R2 @ p1, "order, reverse, tip, wrong way"),
            "seen from joint 3": ((R1 @ R2 @ R3).T @ place, "seen from, joint 3, joint_3, transpos"),
            "the way back": (-(R1 @ R2 @ R3).T @ place, "way back, invers, transpos, origin of the base"),
            "negated": (-place, SIGN),
            "about its own axes": (p1 + own1 @ p2 + own1 @ own2 @ p3, OWN_AXES),
            "read as degrees": (p1 + rotation(r1 * np.pi / 180) @ p2 + rotation(r1 * np.pi / 180) @ rotation(r2 * np.pi / 180) @ p3,
                                "degree, radian"),
            "the sign of one number": (
                place * np.where(np.arange(3) == np.argmax(np.abs(place)), -1, 1), f"{SIGN}, directions of, origin of the base"),
            "R_2 R_1, joint 1's shift left out": (R1 @ p2 + R2 @ R1 @ p3, f"order, wrong way round, first, {LEFT_OUT}"),
            "turned back, by its own rpy too": (p1 + R1.T @ p2 + (R1 @ R2 @ R3).T @ p3, "transpos, invers, own"),
        }
    )  # fmt: skip
    yield from right({**ordinary_forms(place), "a tuple": tuple(place)})


@wrong_answers("09.4")
def screw_from_a_file(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    (p1, r1, _), (p2, r2, a2), (p3, r3, axis) = joints_of(given.urdf)
    R1, R2, R3 = rotation(r1), rotation(r2), rotation(r3)
    R = R1 @ R2 @ R3
    p = p1 + R1 @ p2 + R1 @ R2 @ p3
    own = rotation(r1, "xyz") @ rotation(r2, "xyz") @ rotation(r3, "xyz")
    w = R @ axis
    S = screw(w, p)
    base, moment = "base, as it stands, parent", "moment, v = 0, v, through the origin"
    yield from wrong(
        {
            "omega x p": (np.concatenate([w, np.cross(w, p)]), f"omega x p, \\times p, {SIGN}"),
            "halves swapped": (np.roll(S, 3), f"(v, half, halves, {SWAP}"),
            "no moment": (screw(w, 0 * p), moment),
            "the point as v": (np.concatenate([w, p]), "point, position, moment"),
            "axis as it stands": (screw(axis, p), f"axis, {base}, rpy"),
            "its own rpy left out": (screw(R1 @ R2 @ axis, p), "rpy, parent, R_3"),
            "only its own rpy": (screw(R3 @ axis, p), "rpy, parent, base, joints before"),
            "point as it stands": (screw(w, p3), f"point, {base}"),
            "point and axis as they stand": (screw(axis, p3), base),
            "point added without turning": (screw(w, p1 + p2 + p3), "added, turn, point"),
            "axis turned back": (screw(R.T @ axis, p), "transpos, R^T, invers"),
            "axis negated": (-S, f"{SIGN}, other way, revers"),
            "omega negated": (S * np.repeat((-1, 1), 3), SIGN),
            **({} if axis[2] == 1 else {"the z axis": (screw(R[:, 2], p), "axis, <axis")}),
            **({} if axis[0] == 1 else {"the x axis, the default": (screw(R[:, 0], p), "axis, default")}),
            "joint 2": (screw(R1 @ R2 @ a2, p1 + R1 @ p2), "joint 2, joint_2, before"),
            "the body screw": (screw(axis, 0 * p), f"body, own frame, joint's, {base}, {moment}"),
            "R_3 R_2 R_1": (screw(R3 @ R2 @ R1 @ axis, p), "order, reverse"),
            "about its own axes": (screw(own @ axis, p), OWN_AXES),
            "a prismatic joint": (np.concatenate([0 * w, w]), "prismatic, slide, omega"),
            "the sign of one number of v": (S * np.where(np.arange(6) == 3 + np.argmax(np.abs(S[3:])), -1, 1), SIGN),
            "point of joint 2": (screw(w, p1 + R1 @ p2), "joint 2, joint_2, point, parent"),
            "omega x p, halves swapped": (np.concatenate([np.cross(w, p), w]), f"(v, half, \\times p, {SIGN}, {SWAP}"),
            "axis as it stands, omega x p": (
                np.concatenate([axis, np.cross(axis, p)]),
                f"axis, {base}, \\times p, {SIGN}",
            ),
            "axis negated, halves swapped": (-np.roll(S, 3), f"(v, half, {SIGN}, {SWAP}"),
        }
    )
    yield from right({**ordinary_forms(S), "a tuple": tuple(S)})


@wrong_answers("09.5")
def home_from_a_file(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    read = joints_of(given.urdf)
    T1, T2, weld = (frame(rotation(rpy), xyz) for xyz, rpy, _ in read)
    own = [frame(rotation(rpy, "xyz"), xyz) for xyz, rpy, _ in read]
    (box,) = re.findall(r'<visual>\s*<origin xyz="([^"]*)"', given.urdf)
    drawn = frame(p=[float(x) for x in box.split()])
    M, added = product(T1, T2, weld), sum(xyz for xyz, _, _ in read)
    left = "left, order, front"
    yield from wrong(
        {
            **pose_slips(M),
            "weld left out": (T1 @ T2, "weld, fixed, last joint"),
            "weld on the left": (product(weld, T1, T2), f"weld, {left}"),
            "from tip to base": (product(weld, T2, T1), f"reverse, tip, {left}"),
            "joints 1 and 2 swapped": (product(T2, T1, weld), f"order, {SWAP}"),
            "where the box is drawn": (product(M, drawn), "visual, drawn, box"),
            "box for weld": (product(T1, T2, drawn), "visual, drawn, box"),
            "joint 1 left out": (T2 @ weld, f"first, joint 1, {LEFT_OUT}"),
            "joint 2 left out": (T1 @ weld, f"joint 2, {LEFT_OUT}"),
            "weld inverted": (product(T1, T2, np.linalg.inv(weld)), "weld, invers, invert"),
            "weld not turned": (product(T1, T2, frame(p=weld[:3, 3])), "weld, rpy, turn, rotation"),
            "weld only turned": (product(T1, T2, frame(weld[:3, :3])), "weld, xyz, shift, translation, position"),
            "the shifts added": (frame(M[:3, :3], added), "added, turn"),
            "about its own axes": (product(*own), OWN_AXES),
            "read as degrees": (
                product(*(frame(rotation(np.radians(rpy)), xyz) for xyz, rpy, _ in read)),
                "degree, radian",
            ),
            "the weld alone": (weld, "base, as it stands, parent, weld"),
            "entry by entry": (T1 * T2 * weld, "element, entry, matrix product"),
            "from tip to base, box too": (product(drawn, weld, T2, T1), f"reverse, tip, visual, {left}"),
            "weld left out, box too": (product(T1, T2, drawn @ drawn), "weld, visual, drawn, box"),
            "weld left out, from tip to base": (T2 @ T1, f"weld, fixed, reverse, invers, {left}"),
        }
    )
    yield from right(ordinary_forms(M))


@wrong_answers("09.6")
def which_line(given: Any, answer: float) -> Iterator[WrongAnswer]:
    lines, fault = given.urdf.splitlines(), int(answer)
    start = max(i for i in range(fault) if "<joint" in lines[i])
    end = next(i for i in range(fault, len(lines)) if "</joint" in lines[i])
    element = lines[fault - 1].split()[0]
    kinds = {
        "<origin": "origin, pose, degree",
        "<axis": "axis",
        "<limit": "limit",
        "<parent": "parent",
        "<child": "child, link",
    }
    cases: dict[str, tuple[Any, str]] = {
        "counted from 0": (fault - 1, "line above, from 0, count"),
        "the line below": (fault + 1, "line below, count, next, correct, ends, element"),
        "two lines above": (fault - 2, "joint, count, correct"),
        "its joint": (start + 1, "joint, element"),
        "the end of its joint": (end + 1, "joint, ends, element"),
        "the first line": (1, "first line, robot, correct"),
        "the last line": (len(lines), "last line, end, correct"),
        "line 0": (0, "count, from 1, lines 1 to"),
    }
    joint, seen = 0, {case[0] for case in cases.values()}
    for i, line in enumerate(lines, start=1):
        name = line.split()[0]
        joint += name == "<joint"
        if name in kinds and i != fault and i not in seen:
            words = kinds[name] + ", this " + ("joint, element" if start < i <= end else "correct, no fault, other")
            cases[f"{name[1:]} of joint {joint} for {element[1:]}"] = (i, words)
    yield from wrong(cases)
    yield from right({"an integer": fault, "a float": float(fault)})


@wrong_answers("09.7")
def path_through_a_tree(given: Any, answer: str) -> Iterator[WrongAnswer]:
    options, best = given.options, given.options[answer]
    words = {}
    for letter, way in options.items():
        if set(way) == set(best):
            words[letter] = "from the root, torso, outwards" if way[:2] == best[1::-1] else "order, file"
            words[letter] += ", file" if way[2:] != best[2:] or way[:2] != best[1::-1] else ", order"
        else:
            words[letter] = "fixed, weld" if len(way) > len(best) else "root, torso, both arms"
    yield from other_letters(words, answer)


@wrong_answers("09.8")
def from_a_dh_row(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    a, alpha, d = given.a, given.alpha, given.d
    s, c, deg = np.sin(alpha), np.cos(alpha), np.degrees(alpha)
    xyz, rpy = [a, -d * s, d * c], [alpha, 0, 0]
    along = "along"
    yield from wrong(
        {
            "d along the old z": ([[a, 0, d], rpy], along),
            "new z leans the other way": ([[a, d * s, d * c], rpy], f"{SIGN}, lean, other way"),
            "sine and cosine swapped": ([[a, -d * c, d * s], rpy], "sin, cos"),
            "d along x too": ([[a + d, 0, 0], rpy], along),
            "d left out": ([[a, 0, 0], rpy], LEFT_OUT),
            "a left out": ([[0, -d * s, d * c], rpy], LEFT_OUT),
            "degrees": ([xyz, [deg, 0, 0]], "degree, radian"),
            "alpha as yaw": ([xyz, [0, 0, alpha]], "yaw, roll, about x"),
            "alpha as pitch": ([xyz, [0, alpha, 0]], "pitch, roll, about x"),
            "alpha negated": ([[a, d * s, d * c], [-alpha, 0, 0]], f"alpha, {SIGN}"),
            "only the roll negated": ([xyz, [-alpha, 0, 0]], f"alpha, roll, {SIGN}"),
            "a and d swapped": ([[d, -a * s, a * c], rpy], SWAP),
            "no roll": ([xyz, [0, 0, 0]], f"roll, alpha, {LEFT_OUT}"),
            "xyz and rpy swapped": ([rpy, xyz], f"{SWAP}, order"),
            "standard row": ([[a, 0, d], rpy], "convention, standard, along"),
            "a turned as well": ([[a * c, a * s, d], rpy], "turn, along, rotate"),
            "d downwards": ([[a, d * s, -d * c], rpy], SIGN),
            "x negated": ([[-a, -d * s, d * c], rpy], SIGN),
            "millimetres": ([[1000 * v for v in xyz], rpy], "millimet, mm, 1000, unit"),
            "half a turn for alpha": ([xyz, [np.sign(alpha) * np.pi, 0, 0]], "alpha, roll, half a turn, 180"),
            "d along the old z, degrees": ([[a, 0, d], [deg, 0, 0]], f"{along}, degree, radian"),
            "alpha as yaw, a and d swapped": ([[d, -a * s, a * c], [0, 0, alpha]], f"yaw, {SWAP}"),
            "d along the old z, alpha negated": ([[a, 0, d], [-alpha, 0, 0]], f"{along}, {SIGN}"),
        }
    )
    value = np.array([xyz, rpy])
    other = [xyz, [alpha + np.pi, np.pi, np.pi]]
    full = {"roll plus a turn": [xyz, [alpha + 2 * np.pi, 0, 0]], "the other angles of the same rotation": other}
    yield from right({**ordinary_forms(value), **full})


@wrong_answers("09.9")
def mimic_joint(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    (_, _, h), (a, _, _), (b, _, _) = (xyz for xyz, _, _ in joints_of(given.urdf))
    m, c = (float(re.findall(rf'{name}="([^"]*)"', given.urdf)[0]) for name in ("multiplier", "offset"))
    q = given.q

    def tool(folded: float, swung: float = q, boom: float = a, forearm: float = b) -> Array:
        """The position of the tool when `fold` has this value."""
        angle = swung + folded
        x, y = boom * np.cos(swung) + forearm * np.cos(angle), boom * np.sin(swung) + forearm * np.sin(angle)
        return np.array([x, y, h])

    right_q, mimic = m * q + c, "mimic, value of fold, fold"
    point = tool(right_q)
    yield from wrong(
        {
            "fold left at 0": (tool(0), f"{mimic}, {LEFT_OUT}"),
            "offset left out": (tool(m * q), f"offset, {LEFT_OUT}"),
            "multiplier left out": (tool(q + c), f"multiplier, {LEFT_OUT}"),
            "a copy": (tool(q), f"{mimic}, swing, multiplier, offset"),
            "only the offset": (tool(c), f"multiplier, q_1, {LEFT_OUT}"),
            "multiplier sign": (tool(-m * q + c), f"multiplier, {SIGN}"),
            "offset sign": (tool(m * q - c), f"offset, {SIGN}"),
            "both signs": (tool(-right_q), f"{mimic}, {SIGN}"),
            "offset multiplied": (tool(m * (q + c)), "offset, multipl"),
            "multiplier for offset": (tool(c * q + m), SWAP),
            "divided": (tool(q / m + c), "divid, multiplier, inver"),
            "the other joint follows": (tool((q - c) / m), "mimic, swing, inver"),
            "offset in degrees": (tool(m * q + np.radians(c)), "degree, radian"),
            "q in degrees": (tool(m * np.radians(q) + c, np.radians(q)), "degree, radian, q_1"),
            "fold measured from the base": (tool(right_q - q), "base, x$ axis, parent, q_1"),
            "no forearm": (tool(right_q, forearm=0), f"forearm, {LEFT_OUT}, weld"),
            "no boom": (tool(right_q, boom=0), f"boom, {LEFT_OUT}"),
            "links swapped": (tool(right_q, boom=b, forearm=a), f"{SWAP}, boom, forearm"),
            "swing negated": (tool(right_q, -q), f"q_1, swing, {SIGN}"),
            "stretched": (np.array([a + b, 0, h]), f"q = 0, home, stretched, {LEFT_OUT}, q_1"),
            "height left out": (point * (1, 1, 0), f"z, height, {LEFT_OUT}"),
            "x and y swapped": (point[[1, 0, 2]], f"{SWAP}, sine, order"),
            "millimetres": (1000 * point, "millimet, mm"),
            "y negated": (point * (1, -1, 1), SIGN),
            "fold at 0, offset added to swing": (tool(0, q + c), "offset, mimic, fold, swing"),
            "offset left out, measured from the base": (tool(m * q - q), f"offset, {LEFT_OUT}, base, x$ axis"),
            "multiplier left out, offset negated": (tool(q - c), f"multiplier, offset, {SIGN}, {LEFT_OUT}"),
        }
    )
    yield from right({**ordinary_forms(point), "a tuple": tuple(point)})


@wrong_answers("09.10")
def axis_in_the_wrong_frame(given: Any, answer: Array) -> Iterator[WrongAnswer]:
    R1, R2, R3 = (rotation(rpy) for _, rpy, _ in joints_of(given.urdf))
    own = product(*(rotation(rpy, "xyz") for _, rpy, _ in joints_of(given.urdf)))
    w = np.array(given.omega)
    R = R1 @ R2 @ R3
    axis, turned = R.T @ w, "rpy, rotat, frame, parent"
    yield from wrong(
        {
            "as it is": (w, "as it is, as they are, base, frame"),
            "R for its transpose": (R @ w, "transpos, R^T, invers"),
            "only its own rpy": (R3.T @ w, f"joint_3, {turned}"),
            "only its own rpy, forwards": (R3 @ w, f"joint_3, transpos, {turned}"),
            "its own rpy left out": ((R1 @ R2).T @ w, f"R_3, joint_3, {LEFT_OUT}"),
            "joint 1 left out": ((R2 @ R3).T @ w, f"R_1, joint_1, {LEFT_OUT}"),
            "joint 2 left out": ((R1 @ R3).T @ w, f"R_2, joint_2, {LEFT_OUT}"),
            "only joint 1": (R1.T @ w, f"R_2, R_3, {LEFT_OUT}"),
            "order of the transposes kept": (R1.T @ R2.T @ R3.T @ w, "order, reverse"),
            "R_2 R_1 R_3": ((R2 @ R1 @ R3).T @ w, "order, swap"),
            "R_1 R_3 R_2": ((R1 @ R3 @ R2).T @ w, "order, swap"),
            "about its own axes": (own.T @ w, OWN_AXES),
            "about its own axes, forwards": (own @ w, f"{OWN_AXES}, transpos"),
            "opposite": (-axis, f"{SIGN}, revers, opposite"),
            "no signs": (np.abs(axis), SIGN),
            "one sign": (axis * np.where(np.arange(3) == np.argmax(np.abs(axis)), -1, 1), SIGN),
            "first two swapped": (axis[[1, 0, 2]], f"{SWAP}, order"),
            "last two swapped": (axis[[0, 2, 1]], f"{SWAP}, order"),
            "the z axis": (np.array([0, 0, 1]), "z axis, axis"),
            "not rotated by joint 3, forwards": (R1 @ R2 @ w, f"transpos, R_3, {LEFT_OUT}"),
            "as it is, opposite": (-w, f"{SIGN}, as it is, base"),
        }
    )
    yield from right({**ordinary_forms(axis), "a tuple": tuple(axis)})


@wrong_answers("09.11")
def origin_or_axis(given: Any, answer: float) -> Iterator[WrongAnswer]:
    lines, fault = given.urdf.splitlines(), int(answer)
    start = max(i for i in range(fault) if "<joint" in lines[i])
    is_origin = "<origin" in lines[fault - 1]
    joint, cases, label = 0, dict[str, tuple[Any, str]](), "origin" if is_origin else "axis"
    for i, line in enumerate(lines, start=1):
        element = line.split()[0]
        joint += element == "<joint"
        if i == fault:
            continue
        here = start < i <= start + 4
        if element in {"<origin", "<axis", "<parent", "<joint"}:
            words = "not because, this joint, other elements" if here else "correct, agrees, earlier, first joint"
            cases[f"{element[1:]} of joint {joint} for {label}"] = (i, words)
    cases["the line of the robot"] = (1, "correct, robot")
    cases["line 0"] = (0, "lines 1 to, count")
    cases["past the end"] = (len(lines) + 1, "lines 1 to, count")
    yield from wrong(cases)
    yield from right({"an integer": fault, "a float": float(fault)})


@wrong_answers("09.12")
def gantry(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    yield from wrong(drawings.points(answer))
