"""Kinds of wrong answers that belong to one problem of sheets 01 to 05 alone."""

# fmt: off
from typing import Any

import numpy as np
import sympy as sp

from evidence.outside import Kinds, kinds_of, shared
from evidence.outside.motions import I3, Ad, at, chain, exp, hat, link, logarithm, pose, product, rot
from evidence.outside.right import (
    inv,
    jacobian,
    moved,
    plane,
    poe,
    radians_of,
    rodrigues,
    screw,
    skew,
    theta,
)
from evidence.outside.shared import DEGREES, ORDER, PLACE, PLACEHOLDER, POINT, SIGN, SIZE, SWAP, TRANSPOSE, UNIT

LEFT_OUT = shared.LEFT_OUT + "|not rotat|kept"
INVERSE = "inver|transpos|R^T|other way|direction|T_{"
JOINT = "joint|row|axis|point|column|q_|instead|belongs"


@kinds_of("01.1")
def pose_from_a_drawing(g: Any, T: Any) -> Kinds:
    R, p = T[:3, :3], T[:3, 3]
    return {
        "left the height at 0": (pose(R, p * (1, 1, 0)), PLACEHOLDER + "|height|" + PLACE),
        "swapped the x and the y axis": (pose(R[:, [1, 0, 2]], p), ORDER + "|axes|left-handed|" + SIGN),
        "read x for the height": (pose(R, p[[2, 1, 0]]), SWAP + "|sizes"),
        "miscounted the height by one": (pose(R, p + [0, 0, 1]), PLACE + "|height"),
        "took the z axis as pointing down": (pose(R @ np.diag([1, -1, -1]), p), SIGN + "|" + PLACE),
        "drew a left-handed frame": (pose(R @ np.diag([1, 1, -1]), p), SIGN),
        "measured from {b} to {s}": (pose(R, -p), SIGN + "|leads"),
    }


@kinds_of("01.2")
def rotation_from_a_drawing(g: Any, R: Any) -> Kinds:
    k = int(np.argmax(np.diag(R) > 1 - 1e-9))
    t = np.arctan2(R[(k + 2) % 3, (k + 1) % 3], R[(k + 1) % 3, (k + 1) % 3])
    d = float(np.degrees(t))
    return {
        "took degrees for radians": (rot(k, float(np.degrees(d))), DEGREES),
        "rotated about the axis before": (rot((k + 2) % 3, d), "axis|" + ORDER),
        "measured from the other axis": (rot(k, 90 - d), "sin|cos|90|complement|other axis|angle"),
        "added a right angle": (rot(k, d + 90), "90|right angle|turn|quarter|sin|angle"),
        "rotated about the next axis": (rot((k + 1) % 3, d), "axis|" + ORDER),
        "misread the angle by ten degrees": (rot(k, d + 10), "angle|axis is right"),
    }


@kinds_of("01.3")
def plane_motion(g: Any, T: Any) -> Kinds:
    p = np.asarray(g.p)
    once = plane(g)
    return {
        "gave the inverse": (inv(once), "inver|other way|transpos|order"),
        "transposed the rotation alone": (np.block([[once[:2, :2].T, once[:2, 2:]], [once[2:]]]), TRANSPOSE + "|" + SIGN + "|clockwise"),
        "made the two motions in the other order": (plane(g, order=-1), ORDER + "|rotat"),
        "put p in the last row": (np.array([[*once[0, :2], 0], [*once[1, :2], 0], [*once[:2, 2], 1]]), "last row|transpos"),
        "translated twice": (once + [[0, 0, p[0]], [0, 0, p[1]], [0, 0, 0]], "twice|" + ORDER + "|position|column"),
        "rotated p back": (np.array([[*once[0, :2], 0], [*once[1, :2], 0], [0, 0, 1]]) + np.outer([1, 1, 0], [0, 0, 1]) * [[0, 0, x] for x in (*(once[:2, :2].T @ p), 0)], TRANSPOSE + "|" + ORDER),
    }


@kinds_of("01.4")
def rod(g: Any, X: Any) -> Kinds:
    R, p = g.T_sc[:3, :3], g.T_sc[:3, 3]
    x, d = np.asarray(g.point_c), np.asarray(g.arrow_c)
    return {
        "translated before rotating": (np.array([R @ (x + p), X[1]]), ORDER + "|first|point|position"),
        "added the origin to the vector": (np.array([X[0], X[1] + p]), "vector|direction|point"),
        "gave both ends": (np.array([X[0], X[0] + X[1]]), "end"),
        "rotated only the point": (np.array([X[0], d]), LEFT_OUT + "|unchanged"),
        "subtracted the origin": (np.array([R @ x - p, X[1]]), SIGN),
    }


@kinds_of("01.5")
def inverse_pose(g: Any, X: Any) -> Kinds:
    R, p = g.T_sg[:3, :3], g.T_sg[:3, 3]
    return {
        "wrote R and -p": (pose(R, -p), "R|transpos|minus|" + SIGN),
        "wrote R^T and R^T p": (pose(R.T, R.T @ p), SIGN),
        "forgot the transpose in the position": (pose(R.T, -R @ p), TRANSPOSE),
        "inverted every entry's sign but the last": (pose(-R, -p), SIGN + "|no rotation|given"),
    }


@kinds_of("01.6")
def cancel(g: Any, X: Any) -> Kinds:
    a, b, c = inv(g.T_st), g.T_sc, g.T_co
    return {
        "multiplied in reverse": (c @ b @ a, ORDER + "|revers"),
        "put the tool last": (b @ c @ a, ORDER + "|last"),
        "transposed T_st": (g.T_st.T @ b @ c, "transpos"),
        "used T_sc twice": (a @ b @ b, "T_{co}|T_{sc}|instead|belongs"),
    }


@kinds_of("01.7")
def own_or_fixed(g: Any, X: Any) -> Kinds:
    turn, shift = pose(rot(np.asarray(g.axis), g.degrees), [0] * 3), pose(I3, g.shift)
    return {
        "swapped the two sides": (moved(g, swap=True), ORDER + "|left|right"),
        "made both about own axes": (g.T_sb @ turn @ shift, ORDER + "|left|right|last|first"),
        "made both about axes of {s}": (shift @ turn @ g.T_sb, ORDER + "|left|right|last|first"),
        "left the pose as it was": (np.asarray(g.T_sb), "unchanged|given|as it is|left out|T_{sb}"),
        "forgot the first pose": (turn @ shift, LEFT_OUT),
    }


@kinds_of("02.1")
def matrix_of_a_screw(g: Any, X: Any) -> Kinds:
    w, v = np.asarray(g.omega), np.asarray(g.v)

    def block(W: Any, v: Any, corner: float = 0) -> Any:
        return np.block([[W, np.reshape(v, (3, 1))], [np.zeros((1, 3)), corner * np.ones((1, 1))]])

    return {
        "wrote a 1 in the corner": (block(hat(w), v, 1), "corner|1|last row"),
        "swapped omega and v": (block(hat(v), w), SWAP + "|halves|in front"),
        "put omega on the diagonal": (block(np.diag(w), v), "diagonal|skew|cross"),
        "forgot all minus signs": (block(np.abs(hat([1, 1, 1])) * hat(w) * np.sign(hat([1, 1, 1])), v), SIGN + "|skew"),
        "wrote the components in the order z, y, x": (block(hat(w[::-1]), v), ORDER + "|x and z"),
        "filled only the upper half": (block(np.triu(hat(w)), v), "skew|half|lower|below|" + PLACE),
        "wrote v in the last row": (np.block([[hat(w), np.zeros((3, 1))], [v, 0]]), "row|transpos"),
        "swapped the signs of the second component": (block(hat(w * (1, -1, 1)), v), SIGN + "|" + PLACE),
        "multiplied omega with itself": (block(np.outer(w, w), v), "skew|outer|symmetric"),
        "divided by the length": (block(hat(w) / np.linalg.norm(w), v), SIZE),
        "squared [omega]": (block(hat(w) @ hat(w), v), "squar|symmetric|twice|skew"),
    }


@kinds_of("02.2")
def given_axis(g: Any, X: Any) -> Kinds:
    w, degrees = np.asarray(g.direction, dtype=float), g.degrees
    u, t = w / np.linalg.norm(w), np.radians(degrees)
    s, c, W = np.sin(t), np.cos(t), hat(u)
    skewed = "skew|symmetric|I$|term"
    return {
        "used the vector as it is": (I3 + s * hat(w) + (1 - c) * hat(w) @ hat(w), SIZE + "|unit"),
        "used cos for 1 - cos": (I3 + s * W + c * W @ W, "cos"),
        "used 1 + cos": (I3 + s * W + (1 + c) * W @ W, "cos|sign"),
        "left out the square": (I3 + s * W, LEFT_OUT + "|term"),
        "left out I": (s * W + (1 - c) * W @ W, LEFT_OUT + "|I$"),
        "swapped sin and 1 - cos": (I3 + (1 - c) * W + s * W @ W, SWAP + "|sin|cos"),
        "used theta for sin theta": (I3 + t * W + (1 - c) * W @ W, "sin|theta"),
        "turned by the supplement": (rot(u, 180 - degrees), "angle|supplement|180"),
        "rounded the angle to tens": (rot(u, round(degrees + 5, -1) + 10), "angle"),
        "took the components as z, y, x": (rot(u[::-1], degrees), ORDER + "|x and z|another axis|angle is right"),
        "rotated about the largest component's axis": (rot(int(np.argmax(np.abs(u))), degrees), "axis|angle is right"),
        "used u u^T for the square": (I3 + s * W + (1 - c) * np.outer(u, u), "outer|square|u"),
        "multiplied entry by entry": (I3 + s * W + (1 - c) * W * W, "entry"),
        "used 1 for 1 - cos": (I3 + s * W + W @ W, "cos|factor"),
        "used 2 theta in the sine": (I3 + np.sin(2 * t) * W + (1 - c) * W @ W, "sin|twice|angle"),
        "mistook [u] for its transpose in the square": (I3 + s * W - (1 - c) * W @ W, SIGN + "|transpos"),
        "turned by a negated component": (rot(u * (-1, 1, 1), degrees), SIGN + "|axis|angle is right"),
        "divided by the sum": (rot(w / np.abs(w).sum(), degrees), "sum|length|angle|divide"),
        "made three terms of the series": (I3 + t * W + t * t / 2 * W @ W, "series|term"),
        "wrote only the symmetric part": (I3 + (1 - c) * W @ W, skewed + "|" + LEFT_OUT),
    }


@kinds_of("02.3")
def rotation_formula(g: Any, X: Any) -> Kinds:
    w = sp.Matrix(g.omega)
    W, s, c = skew(w), sp.sin(theta), sp.cos(theta)
    return {
        "used cos for 1 - cos": (rodrigues(w, one_minus_cosine=c), "cos"),
        "used 1 + cos": (rodrigues(w, one_minus_cosine=1 + c), "cos|sign"),
        "used theta^2/2 for 1 - cos": (rodrigues(w, one_minus_cosine=theta**2 / 2), "cos|series|term|\\theta"),
        "left out I": (rodrigues(w) - sp.eye(3), LEFT_OUT + "|I$"),
        "left out the square": (sp.eye(3) + s * W, LEFT_OUT),
        "left out sin": (sp.eye(3) + W + (1 - c) * W**2, "sin|" + LEFT_OUT),
        "left out the fraction": (rodrigues(sp.ilcm(*[x.q for x in w]) * w), SIZE + "|fraction"),
        "wrote tan for sin": (rodrigues(w, sine=sp.tan(theta)), "tan|sin"),
        "squared sin": (rodrigues(w, sine=s**2), "sin|square"),
        "put c on the whole diagonal": (c * sp.eye(3) + s * W, LEFT_OUT + "|term|outer"),
    }


@kinds_of("02.4")
def origin_goes(g: Any, X: Any) -> Kinds:
    w, p = sp.Matrix(g.omega), sp.Matrix(g.point)
    R, W = rodrigues(w), skew(w)
    v, s, c = -W * p, sp.sin(theta), sp.cos(theta)
    t = theta
    swapped = sp.Matrix([p[1], p[2], p[0]])
    return {
        "used cos for 1 - cos in G": (t * v + c * W * v + (t - s) * W * W * v, "cos"),
        "used sin for theta - sin in G": (t * v + (1 - c) * W * v + s * W * W * v, "sin|theta"),
        "permuted the point": (swapped - R * swapped, POINT + "|" + ORDER),
        "gave R p": (R * p, "R|point"),
        "gave p": (p, POINT),
        "gave v theta": (v * t, "straight|v|term"),
        "took the point as the moment": (t * p + (1 - c) * W * p + (t - s) * W * W * p, POINT),
        "dropped a": (X.subs(g.point[2] if g.point[2].free_symbols else min(X.free_symbols, key=str), 0), LEFT_OUT + "|a"),
        "wrote p + R p": (p + R * p, SIGN),
        "rotated twice": (p - R * R * p, "twice|doubl"),
    }


@kinds_of("02.5")
def series(g: Any, X: Any) -> Kinds:
    t, mm = g.theta, 1000 * g.radius
    two = np.hypot(np.cos(t) - 1, np.sin(t) - t)
    four = np.hypot(np.cos(t) - 1 + t**2 / 2, np.sin(t) - t + t**3 / 6)
    return {
        "stopped after two terms": (two * mm, "two terms|term|three"),
        "stopped after four terms": (four * mm, "four|term"),
        "gave the next term": (t**3 / 6 * mm, "term"),
        "gave only the error of the sine": (abs(np.sin(t) - t) * mm, "sine|cos|component|direction"),
        "gave only the error of the cosine": (abs(np.cos(t) - 1 + t**2 / 2) * mm, "cosine|sin|component|direction"),
        "added both errors": ((abs(np.sin(t) - t) + abs(np.cos(t) - 1 + t**2 / 2)) * mm, "add|sum"),
        "left out the radius": (X / g.radius, "radius|distance|" + LEFT_OUT),
        "divided by the radius": (X / g.radius**2, "divide|radius"),
        "left out the factor 1/2": (np.hypot(np.cos(t) - 1 + t**2, np.sin(t) - t) * mm, "half|2|factor"),
        "did not take the root": (((np.cos(t) - 1 + t**2 / 2) ** 2 + (np.sin(t) - t) ** 2) * mm, "root|square"),
        "gave the error of the length": ((np.hypot(1 - t**2 / 2, t) - 1) * mm, "length|radius"),
        "gave the chord": (2 * np.sin(t / 2) * mm, "chord|moved|far"),
        "gave the arc": (t * mm, "arc|term|moved"),
        "gave the distance from the axis": (np.hypot(1 - t**2 / 2, t) * mm, "length|axis|difference|distance"),
        "forgot a thousand and gave micrometres": (1000 * X, UNIT + "|micro"),
        "gave a percentage": (X / mm * 100, "percent|radius|" + SIZE),
    }


@kinds_of("02.6")
def gyroscope(g: Any, X: Any) -> Kinds:
    w, v, t = np.asarray(g.omega), np.asarray(g.v), g.seconds
    R = X[:3, :3]
    size = np.linalg.norm(w)
    return {
        "moved straight": (pose(R, v * t), "straight|v"),
        "moved straight, then turned": (pose(R, R @ v * t), "straight|R|v"),
        "forgot the seconds": (exp([*w, *v]), "second|time|one"),
        "normed omega only": (exp([*w / size, *v], t), SIZE),
        "normed the whole screw": (exp(np.array([*w, *v]) / size, t), SIZE + "|second|speed"),
        "took degrees per second": (exp([*np.radians(w), *v], t), DEGREES),
        "swapped omega and v": (exp([*v, *w], t), SWAP + "|halves"),
        "stopped after the first order": (np.eye(4) + t * np.block([[hat(w), v.reshape(3, 1)], [np.zeros((1, 4))]]), "series|term"),
        "used half the time": (exp([*w, *v], t / 2), "half|time|angle"),
    }


@kinds_of("02.7")
def logarithm_near_half_a_turn(g: Any, x: Any) -> Kinds:
    t = np.linalg.norm(x)
    u = x / t
    R = np.asarray(g.R)
    m = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return {
        "went round once more": (u * (t + 2 * np.pi), "turn|angle|long|direction"),
        "gave the axis alone": (u, "axis|angle|unit|length"),
        "gave degrees": (np.degrees(x), DEGREES),
        "used the arcsine": (u * (np.pi - t), "arcsin|supplement|angle|pi"),
        "went the long way": (-u * (2 * np.pi - t), "long|other|angle|" + SIGN),
        "read the diagonal": (np.diag(R), "diagonal"),
        "gave R - R^T": (m, "sin|R - R^T|angle"),
        "gave half of R - R^T": (m / 2, "sin|angle|length|direction"),
        "used pi for the angle": (u * np.pi, "angle|direction is right|pi"),
        "used the trace alone": (u * np.arccos(np.clip(np.trace(R) / 2, -1, 1)), "trace|angle|direction"),
        "normed by the largest": (x / np.abs(x).max(), "length|direction|" + SIZE),
        "left one component out": (x * (1, 1, 0), PLACE),
    }


@kinds_of("02.8")
def helical_formula(g: Any, X: Any) -> Kinds:
    w, p, h = sp.Matrix(g.axis), sp.Matrix(g.point), g.pitch
    R = rodrigues(w)
    last = sp.Matrix([[0, 0, 0, 1]])

    def made(column: Any, R: Any = R) -> Any:
        return sp.Matrix.vstack(R.row_join(column), last)

    turn = p - R * p
    climb = h * theta * w
    return {
        "climbed on all three axes": (made(turn + h * theta * sp.ones(3, 1)), "climb|pitch|axes|" + PLACE),
        "climbed along the point": (made(turn + h * theta * p), "climb|point"),
        "climbed along the next axis": (made(turn + h * theta * sp.Matrix([w[2], w[0], w[1]])), "climb|axis|another"),
        "did not climb": (made(turn), "climb|pitch"),
        "climbed without theta": (made(turn + h * w), "climb|theta"),
        "multiplied the climb by 2 pi": (made(turn + 2 * sp.pi * climb), "2\\pi|climb"),
        "divided the climb by 2 pi": (made(turn + climb / 2 / sp.pi), "2\\pi|climb"),
        "climbed down": (made(turn - climb), SIGN + "|climb"),
        "forgot the point": (made(climb), LEFT_OUT + "|point|origin"),
        "wrote R p for p - R p": (made(R * p + climb), "R|point"),
        "turned the wrong way": (made(p - R.T * p + climb, R.T), SIGN + "|transpos"),
        "used cos for 1 - cos": (made(turn + climb, rodrigues(w, one_minus_cosine=sp.cos(theta))), "cos"),
    }


@kinds_of("03.1")
def plain_arm(g: Any, S: Any) -> Kinds:
    d, p = np.asarray(g.axes), np.asarray(g.points)
    slide = np.array([[k == "P"] for k in g.letters])
    return {
        "moved the slide backwards": (np.where(slide, -S, S), SIGN),
        "took the points as moments": (np.where(slide, S, np.hstack([d, p])), POINT),
        "took a prismatic joint for a revolute one": (np.hstack([d, np.cross(p, d)]), "prismatic|slide|translation"),
        "wrote the direction of the slide in omega": (np.where(slide, np.hstack([d, 0 * d]), S), "omega|translation|prismatic|v"),
        "used the point of the next joint": (np.where(slide, S, np.hstack([d, np.cross(np.roll(p, -1, 0), d)])), JOINT),
        "used the point of the joint before": (np.where(slide, S, np.hstack([d, np.cross(np.roll(p, 1, 0), d)])), JOINT + "|one place"),
        "left the slide at 0": (np.where(slide, 0, S), "0|prismatic|left out|slide"),
        "gave the slide a moment": (np.where(slide, np.hstack([0 * d, np.cross(p, d)]), S), "prismatic|translation|v|moment|direction"),
        "negated the middle of each cross product": (np.where(slide, S, S * (1, 1, 1, 1, -1, 1)), SIGN + "|" + PLACE),
        "multiplied entry by entry": (np.where(slide, S, np.hstack([d, d * p])), "entry|cross"),
        "did one row with omega x q": (S * np.where((np.arange(3) == np.argmin(slide))[:, None], [1, 1, 1, -1, -1, -1], 1), SIGN + "|\\times"),
    }


@kinds_of("03.2")
def tilted_joint(g: Any, S: Any) -> Kinds:
    u, t, p = map(np.asarray, (g.from_axis, g.towards, g.point))
    c, s = np.cos(np.radians(g.degrees)), np.sin(np.radians(g.degrees))
    w = S[:3]
    return {
        "did not tilt": (screw(u, p), "tilt|lean|angle|0|axis"),
        "negated omega alone": (S * (-1, -1, -1, 1, 1, 1), SIGN),
        "tilted by half the angle": (screw(np.cos(np.radians(g.degrees / 2)) * u + np.sin(np.radians(g.degrees / 2)) * t, p), "half|angle|tilt|axis|" + PLACE),
        "tilted from the other axis": (screw(s * u + c * t, p), SWAP + "|sin"),
        "tilted fully": (screw(t, p), "tilt|angle|axis|direction"),
        "tilted towards the third axis": (screw(c * u + s * np.cross(u, t), p), "axis|third"),
        "used the point as the moment": (np.array([*w, *p]), POINT),
        "took the moment of the upright axis": (np.array([*w, *np.cross(p, u)]), "axis|moment|tilt|upright"),
        "added without sines": (screw(u + t, p), SIZE + "|unit|sin"),
        "used the tangent": (screw(u + s / c * t, p), SIZE + "|tan|unit"),
        "treated it as prismatic": (np.array([0, 0, 0, *w]), "prismatic"),
        "swapped the coordinates of the point": (screw(w, p[[1, 0, 2]]), "point|moment|" + SWAP + "|parallel"),
        "left out one coordinate of the point": (screw(w, p * (1, 1, 0)), "point|moment|parallel|" + PLACE),
        "misread a coordinate": (screw(w, p + [0, 1, 0]), "point|moment|parallel|" + PLACE),
    }


@kinds_of("03.3")
def tilted_slide(g: Any, S: Any) -> Kinds:
    n, p = np.asarray(g.direction, dtype=float), np.asarray(g.point)
    d = S[3:]
    return {
        "did not norm": (np.array([0, 0, 0, *n]), SIZE + "|unit"),
        "treated it as revolute": (screw(d, p), "revolute|omega|rotat|turn"),
        "gave a moment": (np.array([0, 0, 0, *np.cross(p, d)]), "moment|point|\\times"),
        "gave the point": (np.array([0, 0, 0, *p]), "point"),
        "divided by the sum": (np.array([0, 0, 0, *n / n.sum()]) if n.sum() else S * 3, "sum|unit|length|" + SIZE),
        "wrote the direction twice": (np.array([*d, *d]), "omega|both|twice"),
    }


@kinds_of("03.4")
def helical(g: Any, S: Any) -> Kinds:
    w, m = np.asarray(g.axis), np.cross(g.point, g.axis)
    h = g.lead / 2 / np.pi
    return {
        "multiplied the lead by 2 pi": (np.array([*w, *m + 2 * np.pi * g.lead * w]), "lead|pitch|2\\pi|climb"),
        "used the lead as the pitch": (np.array([*w, *m + g.lead * w]), "lead|pitch|2\\pi"),
        "added the pitch everywhere": (np.array([*w, *m + h]), "pitch|climb|everywhere|all"),
        "used 360 for a turn": (np.array([*w, *m + g.lead / 360 * w]), "2\\pi|degree|pitch|360"),
        "used pi for a turn": (np.array([*w, *m + g.lead / np.pi * w]), "2\\pi|pitch|twice|half|double"),
        "took it for a slide": (np.array([0, 0, 0, *w]), "prismatic|omega"),
        "scaled omega by the pitch": (np.array([*h * w, *m]), "omega|pitch|unit"),
    }


@kinds_of("03.5", "04.1")
def screw_from_a_drawing(g: Any, S: Any) -> Kinds:
    w, v = S[:3], S[3:]
    p, k = np.cross(w, v), int(np.argmax(np.abs(w)))
    i, j = (k + 1) % 3, (k + 2) % 3
    swapped = p.copy()
    swapped[[i, j]] = p[[j, i]]
    return {
        "took another axis as the direction": (screw(np.roll(w, 1), p), "axis|direction|" + ORDER + "|omega"),
        "misread one coordinate by one": (screw(w, p + I3[i]), "metre|point|coordinate|parallel|" + PLACE),
        "misread the other coordinate by one": (screw(w, p - I3[j]), "point|coordinate|parallel|" + PLACE),
        "read one coordinate as 0": (screw(w, p * (I3[i] + I3[k])), "point|coordinate|0|parallel|" + PLACE),
        "swapped two coordinates": (screw(w, swapped), SWAP + "|point|parallel|sizes"),
        "took the point as the moment": (np.array([*w, *p]), POINT),
        "treated it as prismatic": (np.array([0, 0, 0, *w]), "prismatic"),
    }


@kinds_of("03.7")
def kinematics(g: Any, f: Any) -> Kinds:
    S, M = np.asarray(g.screws), np.asarray(g.home)

    def of(order: str) -> Any:
        def fk(q: Any) -> Any:
            e = {str(i): exp(S[i], q[i]) for i in range(3)} | {"M": M}
            return product(*(e[k] for k in order))

        return fk

    names = {"reversed the factors": "210M", "put M first": "M012", "put M first and reversed": "M210", "put M in the middle": "01M2",
             "swapped joints 1 and 2": "102M", "left out M": "012", "left out joint 2": "02M", "used joint 1 twice": "001M"}
    return {
        **{label: (of(order), ORDER + "|" + LEFT_OUT + "|first|last|revers|joint|belongs") for label, order in names.items()},
        "was off by one in q": (lambda q: poe(g, S, M, [q[1], q[2], q[0]]), "q|joint|" + ORDER),
        "used q_1 for all": (lambda q: poe(g, S, M, [q[0]] * 3), "q_1|joint"),
        "added the exponents": (lambda q: exp(np.asarray(q) @ S) @ M, "sum|add|exponent"),
        "stayed at home": (lambda q: M, "home|left out|leave out"),
        "inverted M": (lambda q: poe(g, S, inv(M), q), "inver"),
        "read the screws as (v, omega)": (lambda q: poe(g, np.roll(S, 3, axis=1), M, q), "halves|(v|order"),
        "turned joint 3 the other way": (lambda q: poe(g, S, M, [q[0], q[1], -q[2]]), SIGN + "|inver"),
        "turned two joints the other way": (lambda q: poe(g, S, M, [-q[0], -q[1], q[2]]), SIGN + "|inver"),
        "converted to radians": (lambda q: poe(g, S, M, np.radians(q)), DEGREES),
        "left out the moment of joint 1": (lambda q: poe(g, np.vstack([[*S[0, :3], 0, 0, 0], S[1:]]), M, q), "moment|joint 1|S_1|origin"),
    }


@kinds_of("03.8")
def longer_tool(g: Any, X: Any) -> Kinds:
    S, M, L = np.asarray(g.screws), np.asarray(g.home), g.longer
    Z = pose(I3, [0, 0, L])
    return {
        "lengthened along y": (poe(g, S, M @ pose(I3, [0, L, 0])), "y|axis"),
        "lengthened along z of {s}": (poe(g, S, Z @ M), "{s}|" + ORDER + "|left"),
        "lengthened after all": (Z @ poe(g, S, M), "{s}|" + ORDER + "|first|left"),
        "lengthened along x": (poe(g, S, M @ pose(I3, [L, 0, 0])), "x|axis"),
        "lengthened twice": (poe(g, S, M @ Z @ Z), "twice|double"),
        "reversed the factors": (product(*[exp(s, x) for s, x in zip(S, g.q, strict=True)][::-1], M, Z), "revers|" + ORDER),
        "put M first": (product(M, Z, *[exp(s, x) for s, x in zip(S, g.q, strict=True)]), "first|" + ORDER),
        "was off by one in q": (poe(g, S, M @ Z, np.roll(g.q, 1)), "q|" + ORDER),
        "used q_3 for q_4": (poe(g, S, M @ Z, [*g.q[:3], g.q[2]]), "q|joint|belongs"),
        "added the length to x, y and z": (poe(g, S, M @ pose(I3, [L, L, L])), "axis|axes|along|entry"),
    }


@kinds_of("03.9")
def home_formula(g: Any, X: Any) -> Kinds:
    R, p, L = X[:3, :3], X[:3, 3], g.L
    last = sp.Matrix([[0, 0, 0, 1]])

    def made(R: Any = R, p: Any = p) -> Any:
        return sp.Matrix.vstack(sp.Matrix(R).row_join(sp.Matrix(p)), last)

    return {
        "left the rotation at I": (made(sp.eye(3)), "identity|rotat|left"),
        "negated one link": (made(p=p.subs(L[1], -L[1])), SIGN),
        "swapped two coordinates": (made(p=sp.Matrix([p[1], p[0], p[2]])), SWAP + "|" + ORDER + "|sizes"),
        "gave the inverse": (made(R.T, -R.T * p), "inver|R^T"),
        "wrote p in {b}": (made(p=R.T * p), "R^T|{b}|frame|transpos"),
        "drew a left-handed frame": (made(R * sp.diag(1, 1, -1)), SIGN + "|left-handed|" + PLACE),
        "swapped two axes": (made(R[:, [1, 0, 2]]), ORDER + "|axes"),
    }


@kinds_of("03.10", "04.11")
def screw_formulas(g: Any, S: Any) -> Kinds:
    L, n = g.L, S.shape[0]
    turns = [i for i in range(n) if any(S[i, :3])]
    slides = [i for i in range(n) if i not in turns]

    def rows(change: Any, which: Any) -> Any:
        return sp.Matrix([list(change(S[i, :3], S[i, 3:]) if i in which else S[i, :]) for i in range(n)])

    def point(w: Any, v: Any) -> Any:
        return list(w.cross(v))

    made: Kinds = {
        "took omega x q in every row": (rows(lambda w, v: [*w, *-v], turns), SIGN + "|\\times"),
        "took omega x q in one row": (rows(lambda w, v: [*w, *-v], turns[-1:]), SIGN + "|\\times"),
        "took the points as moments": (rows(lambda w, v: [*w, *point(w, v)], turns), POINT),
        "negated one axis": (rows(lambda w, v: [*-w, *-v], turns[:1]), SIGN),
        "negated one omega": (rows(lambda w, v: [*-w, *v], turns[-1:]), SIGN),
        "left out the first link": (S.subs(L[0], 0), LEFT_OUT + "|L_"),
        "negated one link": (S.subs(L[1], -L[1]), SIGN + "|L_"),
        "swapped two rows": (S[[1, 0, *range(2, n)], :], ORDER),
    }
    if slides:
        made["wrote a slide in omega"] = (rows(lambda w, v: [*v, 0, 0, 0], slides), "omega|v|translation|prismatic|halves")
        made["took a slide for a turn"] = (rows(lambda w, v: [*v, *w], slides), "omega|v|translation|prismatic|halves")
        made["moved the slide backwards"] = (rows(lambda w, v: [*w, *-v], slides), SIGN)
    return made


@kinds_of("03.11")
def whole_arm(g: Any, f: Any) -> Kinds:
    def parts_of(L: Any) -> Any:
        n = len(L) - 1
        M = np.asarray(f(np.zeros(n), L))
        return [logarithm(f(row, L) @ inv(M)) for row in np.eye(n)], M

    def of(change: Any) -> Any:
        def fk(q: Any, L: Any) -> Any:
            S, M = parts_of(L)
            return change([np.array(s) for s in S], M, q, L)

        return fk

    def usual(S: Any, M: Any, q: Any) -> Any:
        return product(*(exp(s, x) for s, x in zip(S, q, strict=True)), M)

    def without_last_link(S: Any, M: Any, q: Any, L: Any) -> Any:
        _, short = parts_of([*L[:-1], 0.0])
        return usual(S, short, q)

    def one_row(change: Any) -> Any:
        def changed(S: Any, M: Any, q: Any, L: Any) -> Any:
            k = next(i for i in range(1, len(S)) if np.abs(S[i][:3]).max() > 0.5 and np.abs(S[i][3:]).max() > 0.5)
            S[k] = change(S[k])
            return usual(S, M, q)

        return of(changed)

    def without(k: int) -> Any:
        return of(lambda S, M, q, L: usual([*S[:k], *S[k + 1 :]], M, [*q[:k], *q[k + 1 :]]))

    chained = "M|home|S_|link|before|row"
    return {
        "missed the last link in M": (of(without_last_link), chained + "|" + LEFT_OUT),
        "left R of M at I": (of(lambda S, M, q, L: usual(S, pose(I3, M[:3, 3]), q)), chained + "|identity|rotat"),
        "took R^T in M": (of(lambda S, M, q, L: usual(S, pose(M[:3, :3].T, M[:3, 3]), q)), chained + "|transpos"),
        "negated the position in M": (of(lambda S, M, q, L: usual(S, pose(M[:3, :3], -M[:3, 3]), q)), chained + "|" + SIGN),
        "took omega x q in one row": (one_row(lambda s: s * (1, 1, 1, -1, -1, -1)), chained + "|" + SIGN),
        "negated one axis": (one_row(lambda s: -s), chained + "|" + SIGN),
        "took a point as the moment": (one_row(lambda s: np.array([*s[:3], *np.cross(s[:3], s[3:])])), chained + "|" + POINT),
        "left one moment at 0": (one_row(lambda s: s * (1, 1, 1, 0, 0, 0)), chained + "|moment"),
        "misread one link": (lambda q, L: f(q, [L[0], L[0], *L[2:]]), "L_|link"),
        "negated one link": (lambda q, L: f(q, [L[0], -L[1], *L[2:]]), SIGN + "|L_|link"),
        "left out one link": (lambda q, L: f(q, [0.0, *L[1:]]), LEFT_OUT + "|L_|link"),
        "doubled all links": (lambda q, L: f(q, 2 * np.asarray(L)), SIZE + "|L"),
        "reversed the factors": (of(lambda S, M, q, L: product(*[exp(s, x) for s, x in zip(S, q, strict=True)][::-1], M)), "revers|" + ORDER),
        "put M first": (of(lambda S, M, q, L: product(M, *[exp(s, x) for s, x in zip(S, q, strict=True)])), "first|" + ORDER + "|front"),
        "left out M": (of(lambda S, M, q, L: usual(S, np.eye(4), q)), LEFT_OUT),
        "left out joint 1": (without(0), LEFT_OUT),
        "left out the last joint": (of(lambda S, M, q, L: usual(S[:-1], M, q[:-1])), LEFT_OUT),
        "read (v, omega)": (of(lambda S, M, q, L: usual([np.roll(s, 3) for s in S], M, q)), "halves|(v|" + ORDER),
        "used the body form with space screws": (of(lambda S, M, q, L: product(M, *(exp(s, x) for s, x in zip(S, q, strict=True)))), "first|" + ORDER + "|M"),
    }


def _carried(S: Any, T: Any) -> Kinds:
    """Screws that must be carried by Ad of the inverse of T."""
    (R, p), zero, Q = (T[:3, :3], T[:3, 3]), np.zeros((3, 3)), inv(T)
    w, v = S[:, :3], S[:, 3:]

    def by(A: Any) -> Any:
        return S @ A.T

    rotated = "rotat|transpos|R^T|turned|position|left out|p$|moved"
    return {
        "moved and did not rotate": (np.hstack([w, v - np.cross(p, w)]), rotated + "|axes|" + PLACE),
        "carried the wrong way": (by(Ad(T)), INVERSE + "|Ad"),
        "forgot .T after the rows": (S @ Ad(Q), "transpos|.T|rows"),
        "only rotated": (np.hstack([w @ R, v @ R]), rotated),
        "rotated with R": (by(np.block([[R, zero], [zero, R]])), rotated),
        "used R for R^T": (by(np.block([[R, zero], [hat(Q[:3, 3]) @ R, R]])), rotated),
        "used -p for the way back": (by(np.block([[R.T, zero], [hat(-p) @ R.T, R.T]])), "p|position|" + rotated),
        "put the block at the top": (by(np.block([[R.T, hat(Q[:3, 3]) @ R.T], [zero, R.T]])), "halves|block|(v|corner|order|transpos"),
        "took p without brackets": (np.hstack([w @ R, v @ R + np.cross(w, p)]), "moment|p|\\times|omega|rotat"),
        "handed in what is given": (S, "given|unchanged|old|screws|S_|B_"),
        "rotated omega only": (np.hstack([w @ R, v]), rotated + "|v|moment"),
        "negated the block": (by(np.block([[R.T, zero], [-hat(Q[:3, 3]) @ R.T, R.T]])), SIGN + "|p|\\times"),
        "left the moments at 0": (np.hstack([w @ R, 0 * v]), "moment|left|0"),
    }


@kinds_of("04.2", "robot.body_screws")
def to_body(g: Any, X: Any) -> Kinds:
    return _carried(np.asarray(g.screws), np.asarray(g.home))


@kinds_of("04.3", "robot.back_to_space")
def to_space(g: Any, X: Any) -> Kinds:
    return _carried(np.asarray(g.body_screws), inv(g.home))


@kinds_of("04.7", "robot.new_tool")
def to_tool(g: Any, X: Any) -> Kinds:
    return _carried(np.asarray(g.body_screws), np.asarray(g.T_bt))


@kinds_of("10.2")
def to_gripper(g: Any, X: Any) -> Kinds:
    return _carried(np.asarray(g.body_screws), np.asarray(g.T_bc))


@kinds_of("04.5", "robot.body_form")
def behind_home(g: Any, X: Any) -> Kinds:
    return _with_home(g, np.asarray(g.body_screws), 0)


@kinds_of("04.6")
def around_home(g: Any, X: Any) -> Kinds:
    return _with_home(g, np.asarray(g.screws), 2)


@kinds_of("robot.where_is_the_tool")
def before_home(g: Any, X: Any) -> Kinds:
    return _with_home(g, np.asarray(g.screws), len(g.screws))


def _with_home(g: Any, S: Any, k: int) -> Kinds:
    """Wrong poses where k screws are read in {s}, and stand to the left of the home pose."""
    q, M = radians_of(g.values, S), np.asarray(g.home)

    def of(q: Any = q, M: Any = M, k: int = k, S: Any = S) -> Any:
        e = [exp(s, x) for s, x in zip(S, q, strict=True)]
        return product(*e[:k], M, *e[k:])

    e = [exp(s, x) for s, x in zip(S, q, strict=True)]
    return {
        "swapped the sides of M": (product(*e[k:], M, *e[:k]), ORDER + "|sides|first|last"),
        "put M last": (of(k=len(S)), ORDER + "|last"),
        "put M first": (of(k=0), ORDER + "|first|front"),
        "put M one joint later": (of(k=k + 1), ORDER + "|M|place"),
        "put M on both sides": (product(M, *e, M) if k == 0 else product(M, of()), "twice|two|both|M"),
        "conjugated with M": (product(M, *e, inv(M)), "M|inver|twice|both"),
        "took degrees for radians": (of(q=np.asarray(g.values, dtype=float)), DEGREES),
        "turned the slide into radians too": (of(q=np.radians(g.values)), DEGREES + "|length"),
        "used q_2 for q_1": (of(q=[q[min(1, len(q) - 1)], *q[1:]]), "q_|joint|belongs"),
        "was off by one in q": (of(q=np.roll(q, 1)), "q|" + ORDER + "|values"),
        "reversed the factors": (product(*e[:k], M, *e[k:][::-1]), "revers|" + ORDER),
        "reversed all factors": (product(*e[::-1][:k], M, *e[::-1][k:]), "revers|" + ORDER),
        "added the exponents": (product(exp(q[:k] @ S[:k]), M, exp(q[k:] @ S[k:])), "sum|add|exponent"),
        "read (v, omega)": (of(S=np.roll(S, 3, axis=1)), "halves|(v|" + ORDER),
        "used the screws in the other frame": (product(*[exp(Ad(M) @ s, x) for s, x in zip(S, q, strict=True)][:k], M, *[exp(Ad(M) @ s, x) for s, x in zip(S, q, strict=True)][k:]), "space|screws|frame|Ad"),
    }


@kinds_of("04.8")
def column(g: Any, X: Any) -> Kinds:
    B = np.asarray(g.body_screws)
    q = radians_of(g.values, B)
    e = [exp(b, x) for b, x in zip(B, q, strict=True)]
    return {
        "did not invert": (Ad(e[2] @ e[3]) @ B[1], "inver|" + SIGN),
        "took all joints": (Ad(inv(product(*e))) @ B[1], JOINT),
        "took the joints before": (Ad(e[0]) @ B[1], JOINT),
        "gave column 1": (jacobian(g, q)[0], JOINT),
        "gave column 3": (jacobian(g, q)[2], JOINT),
        "reversed the factors": (Ad(inv(e[3] @ e[2])) @ B[1], "revers|" + ORDER),
        "took degrees for radians": (jacobian(g, np.asarray(g.values, dtype=float))[1], DEGREES),
        "used Ad transposed": (Ad(inv(e[2] @ e[3])).T @ B[1], "transpos"),
        "only rotated": (np.concatenate([(e[2] @ e[3])[:3, :3].T @ B[1][:3], (e[2] @ e[3])[:3, :3].T @ B[1][3:]]), "rotat|position|p|moved|left out"),
    }


@kinds_of("04.9")
def twist_of_the_tool(g: Any, X: Any) -> Kinds:
    q, rates, B = np.radians(g.values), np.radians(g.rates), np.asarray(g.body_screws)
    J = jacobian(g, q)
    e = [exp(b, x) for b, x in zip(B, q, strict=True)]
    M = np.array([Ad(product(np.eye(4), *e[:i])) @ B[i] for i in range(3)])
    return {
        "left both in degrees": (np.asarray(g.rates) @ jacobian(g, np.asarray(g.values, dtype=float)), DEGREES),
        "used the space Jacobian": (rates @ M, "space|before|joints|inver|direction"),
        "swapped rates and angles": (q @ jacobian(g, rates), SWAP + "|rates|values"),
        "used the same rate for all": (rates[0] * J.sum(axis=0), "rate|joint|for all"),
        "was off by one in the rates": (np.roll(rates, 1) @ J, ORDER + "|rate"),
        "added the columns": (J.sum(axis=0), "rate|sum|column"),
        "gave the column of joint 1": (J[0], "rate|column|joint"),
        "did not invert": (rates @ np.array([Ad(product(np.eye(4), *e[i + 1 :])) @ B[i] for i in range(3)]), "inver|" + SIGN),
        "took the angles for the rates": (q @ J, "rates|angles|values"),
        "multiplied entry by entry": ((rates[:, None] * J)[:, :].max(axis=0), "-"),
    }


@kinds_of("04.10")
def singular_wrist(g: Any, X: Any) -> Kinds:
    q, rate = X
    return {
        "gave the tilt": (np.array([g.tilt, rate]), "tilt|angle|90|\\delta|limit"),
        "gave radians": (np.radians(X), DEGREES),
        "gave q_2 in radians": (np.array([np.radians(q), rate]), DEGREES),
        "gave q_2 = 0": (np.array([0, rate]), "0|home|singular"),
        "gave the complement": (np.array([90 - q, rate]), "90|complement|axis"),
        "gave the supplement": (np.array([180 - q, rate]), "180|supplement|half a turn|limit|between"),
        "gave 90 degrees": (np.array([90.0, rate]), "90|right angle|perpendicular"),
        "doubled the rate": (np.array([q, 2 * rate]), SIZE),
        "swapped the two numbers": (X[::-1], SWAP),
        "took the cosine of the rate": (np.array([q, rate * np.cos(np.radians(q))]), "cos|rate|component"),
    }


@kinds_of("05.1")
def row_from_a_drawing(g: Any, X: Any) -> Kinds:
    a, alpha, d, t = X
    return {
        "left out d": (np.array([a, alpha, 0, t]), LEFT_OUT + "|0|d"),
        "left out a": (np.array([0, alpha, d, t]), LEFT_OUT + "|0|a"),
        "measured theta half a turn off": (np.array([a, alpha, d, t + np.pi]), "theta|half|turn|pi|" + SIGN + "|" + PLACE),
        "gave theta, d, a, alpha": (X[[3, 2, 0, 1]], ORDER),
        "gave d, theta, a, alpha": (X[[2, 3, 0, 1]], ORDER),
        "swapped a and d": (X[[2, 1, 0, 3]], ORDER + "|a and d"),
        "swapped alpha and theta": (X[[0, 3, 2, 1]], ORDER + "|alpha and theta"),
        "negated alpha": (X * (1, -1, 1, 1), SIGN),
        "negated theta": (X * (1, 1, 1, -1), SIGN),
        "left alpha at 0": (X * (1, 0, 1, 1), "0|left out"),
        "measured a from origin to origin": (np.array([np.hypot(a, d), alpha, 0, t]), "origin|normal|joint to joint|0|left|distance"),
    }


@kinds_of("05.2")
def row_as_a_matrix(g: Any, X: Any) -> Kinds:
    a, al, d, t = g.a, np.radians(g.alpha_degrees), g.d, np.radians(g.theta_degrees)
    return {
        "left out alpha": (link((a, 0, d, t), "standard"), LEFT_OUT + "|alpha"),
        "used the modified convention": (link((a, al, d, t), "modified"), "modified|convention|order|revers|last|first"),
        "took degrees for radians": (link((a, g.alpha_degrees, d, g.theta_degrees), "standard"), DEGREES),
        "wrote (a, 0, d)": (pose(X[:3, :3], [a, 0, d]), "theta|rotat|x|position|not rotated|left out"),
        "turned a twice": (pose(X[:3, :3], [a * np.cos(2 * t), a * np.sin(2 * t), d]), "twice|theta"),
    }


@kinds_of("05.4")
def offsets(g: Any, X: Any) -> Kinds:
    h = np.radians(g.headings_degrees)
    return {
        "gave the headings": (h, "absolute|heading|x_0|relative|x_{"),
        "added the headings": (np.cumsum(h), "add|sum|sign|difference|absolute"),
        "subtracted the other way": (np.array([h[0], -X[1], -X[2]]), SIGN + "|order"),
        "added neighbours": (np.array([h[0], h[0] + h[1], h[1] + h[2]]), SIGN + "|add|sum"),
        "subtracted the first": (np.array([h[0], h[1] - h[0], h[2] - h[0]]), "first|link 1|x_0|before|previous|heading|x_1"),
        "left the first at 0": (np.array([0, X[1], X[2]]), "0|left out"),
        "used the heading of the next link": (np.roll(X, -1), ORDER + "|next|link"),
    }


@kinds_of("05.5")
def chain_of_rows(g: Any, X: Any) -> Kinds:
    from types import SimpleNamespace

    from evidence.outside.right import table_at

    def at(q: Any, convention: str = "standard", text: str = g.text) -> Any:
        return table_at(SimpleNamespace(text=text), q, convention)

    q, lines = np.asarray(g.q), g.text.strip().splitlines()
    return {
        "multiplied the last row first": (at(q, text="\n".join([lines[0], *lines[:0:-1]])), ORDER + "|revers|row"),
        "used the modified convention": (at(q, "modified"), "modified|convention|order"),
        "forgot the offsets": (at(q, text=g.text.replace(" - 90°", "").replace(" + 90°", "")), "offset|" + LEFT_OUT),
        "multiplied in reverse": (np.linalg.inv(at(q)), "inver|revers|" + ORDER),
        "used q_1 for q_2": (at([q[0], q[0], *q[2:]]), "q_|joint|belongs"),
    }


@kinds_of("05.7")
def parallel_axes(g: Any, X: Any) -> Kinds:
    P = np.asarray(g.points)
    step = np.diff(P, axis=0)
    length = np.linalg.norm(step, axis=1)
    return {
        "negated the first d": (X * (1, -1, 1, 1), SIGN + "|" + PLACE),
        "measured a in space": (np.array([length[0], X[1], length[1], X[3]]), "normal|distance|height|d|z|plane"),
        "gave heights for d": (np.array([X[0], P[0, 2], X[2], P[1, 2]]), "height|z|difference|absolute"),
        "negated d": (X * (1, -1, 1, -1), SIGN),
        "swapped a and d": (X[[1, 0, 3, 2]], ORDER + "|a and d"),
        "left d at 0": (X * (1, 0, 1, 0), "0|left out"),
        "measured from axis 1": (np.array([X[0], X[1], np.hypot(*P[2, :2]), P[2, 2] - P[0, 2]]), "axis 1|before|from|first|joint"),
        "added x and y": (np.array([abs(step[0, 0]) + abs(step[0, 1]), X[1], abs(step[1, 0]) + abs(step[1, 1]), X[3]]), "sum|add|Pythag|root|hypot"),
        "gave squares": (np.array([X[0] ** 2, X[1], X[2] ** 2, X[3]]), "root|square"),
        "swapped the two joints": (X[[2, 3, 0, 1]], ORDER + "|joint|row"),
        "gave heights of the upper ends": (np.array([X[0], P[1, 2], X[2], P[2, 2]]), "height|z|difference|absolute"),
    }


@kinds_of("05.8")
def base_and_tool(g: Any, X: Any) -> Kinds:
    A = chain(at(g.rows, "RR", g.q), "standard")
    b, t = np.asarray(g.base), np.asarray(g.tool)
    return {
        "put the base behind the arm": (A @ b @ t, ORDER + "|base"),
        "forgot both": (A, LEFT_OUT),
        "used the modified convention": (b @ chain(at(g.rows, "RR", g.q), "modified") @ t, "modified|convention"),
        "put the tool before the arm": (b @ t @ A, ORDER),
        "used the base twice": (b @ A @ b, "tool|base|twice|instead|belongs|T_"),
        "negated alpha": (b @ chain(at(np.asarray(g.rows) * (1, -1, 1, 1), "RR", g.q), "standard") @ t, SIGN),
    }
