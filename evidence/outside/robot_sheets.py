"""The tasks of the robot sheets, which ask the same of any robot; what a task shares with a sheet of the course stands there."""

# fmt: off
from typing import Any

import numpy as np

from evidence.outside import Kinds, kinds_of
from evidence.outside.motions import exp, pose, product
from evidence.outside.right import poe, radians_of, screws_of_any_joints
from evidence.outside.shared import DEGREES, LEFT_OUT, ORDER, POINT, SIGN, SIZE, SWAP, TRANSPOSE


@kinds_of("robot.home_pose")
def home_pose(g: Any, X: Any) -> Kinds:
    A, B, C = map(np.asarray, (g.T_sr, g.T_rf, g.T_fb))
    return {
        "left the flange in the robot's base": (B, "flange|tool|base|{r}|T_{rf}|given"),
        "put the tool first": (product(C, A, B), ORDER + "|letters"),
        "added the positions": (pose(X[:3, :3], A[:3, 3] + B[:3, 3] + C[:3, 3]), "add|rotat|turn|position"),
        "multiplied entry by entry": (A * B * C, "entry|element|matrix product"),
    }


@kinds_of("robot.point_of_the_tool")
def point_of_the_tool(g: Any, x: Any) -> Kinds:
    S, M, tip = map(np.asarray, (g.screws, g.home, g.tip))
    q = radians_of(g.values, S)
    e = [exp(s, value) for s, value in zip(S, q, strict=True)]
    T = product(*e, M)
    R, p = T[:3, :3], T[:3, 3]

    def of(T: Any) -> Any:
        return (T @ [*tip, 1])[:3]

    return {
        "did not rotate the tip": (p + tip, "turn|rotat|add"),
        "gave the tip as a direction": (R @ tip, "direction|position|0|origin|" + LEFT_OUT),
        "left the tip in {b}": (tip, "{b}|given|tool|pose|unchanged"),
        "rotated with R^T": (R.T @ tip + p, TRANSPOSE),
        "rotated after the shift": (R @ (tip + p), ORDER + "|turn|shift|rotat"),
        "went from {s} to {b}": (R.T @ (tip - p), "inver|back|seen from|other way"),
        "reversed the factors": (of(product(*e[::-1], M)), ORDER + "|revers"),
        "put M first": (of(product(M, *e)), ORDER + "|first|front"),
        "took degrees for radians": (of(poe(g, S, M, g.values)), DEGREES),
        "swapped x and y": (x[[1, 0, 2]], SWAP),
    }


@kinds_of("robot.space_screws")
def space_screws(g: Any, S: Any) -> Kinds:
    w, P, h = np.asarray(g.axes), np.asarray(g.points), np.asarray(g.pitches)
    slide, turns = np.isinf(h)[:, None], ~np.isinf(h)[:, None]
    moment = np.cross(P, w)

    def of(P: Any = P, h: Any = h) -> Any:
        return screws_of_any_joints(w, P, h)

    return {
        "took the points as moments": (np.where(turns, np.hstack([w, P]), S), POINT),
        "left out the climb": (of(h=np.where(np.isinf(h), h, 0)), "pitch|climb|helical"),
        "made the screw left-handed": (of(h=np.where(np.isinf(h), h, -h)), "pitch|left-handed|" + SIGN),
        "took the pitch per turn": (of(h=2 * np.pi * h), "pitch|lead|2\\pi|" + SIZE),
        "took every joint for a revolute one": (of(h=0 * np.ones(len(h))), "slide|prismatic|pitch|translation"),
        "took every joint for a prismatic one": (of(h=np.inf * np.ones(len(h))), "slide|prismatic|turn|omega"),
        "wrote the direction of a slide in omega": (np.where(slide, np.hstack([w, 0 * w]), S), "slide|omega|prismatic|halves"),
        "gave a slide a moment": (np.where(slide, np.hstack([0 * w, moment]), S), "slide|moment|prismatic"),
        "used the point of joint 1 for all": (of(P=0 * P + P[0]), "point|joint 1|row|first"),
        "used the point of the joint before": (of(P=np.roll(P, 1, axis=0)), "point|row|joint"),
        "took points as steps from joint to joint": (of(P=np.diff(P, axis=0, prepend=0 * P[:1])), "point|{s}|origin|step"),
    }
