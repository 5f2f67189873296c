"""Kinds of wrong readings of a dimensioned drawing: points, screws, rows and poses that no program can compute."""

# fmt: off
from typing import Any

import numpy as np

from outside import Kinds, kinds_of
from outside.motions import I3
from outside.shared import ORDER, PLACE, SIGN, SWAP

READ = "point|coordinate|view|measured|axis|" + PLACE


@kinds_of("07.8", "09.9", "10.4")
def points(g: Any, X: Any) -> Kinds:
    return {
        "took the height for the depth": (X[:, [0, 2, 1]], SWAP + "|view|" + READ),
        "took y as pointing towards me": (X * (1, -1, 1), SIGN + "|y|" + READ),
        "took z as pointing down": (X * (1, 1, -1), SIGN + "|z|" + READ),
        "gave the steps from point to point": (np.diff(X, axis=0, prepend=0 * X[:1]), "step|before|parent|origin|{s}|from|" + READ),
        "misread one coordinate": (X + 0.1 * np.outer(np.arange(len(X)) == 1, I3[0]), READ),
    }


@kinds_of("03.12", "04.9", "10.5")
def screws(g: Any, X: Any) -> Kinds:
    turns = np.any(X[:, :3], axis=1)[:, None]
    w, v = X[:, :3], X[:, 3:]
    p = np.cross(w, v)
    one = np.arange(len(X))[:, None] == np.argmax(turns)

    def through(p: Any, which: Any = turns, w: Any = w) -> Any:
        return np.where(turns & which, np.hstack([w, np.cross(p, w)]), X)

    return {
        "took the points as moments": (np.where(turns, np.hstack([w, p]), X), "point|moment|" + PLACE),
        "misread one coordinate": (through(p + np.roll(w, 1, axis=1) * 0.1, one), "parallel|moment|" + READ),
        "swapped height and depth of the points": (through(p[:, [0, 2, 1]]), "parallel|moment|" + SWAP + "|" + READ),
        "used the point of the joint before": (through(np.roll(p, 1, axis=0)), "joint|row|parallel|moment|" + READ),
        "took another direction for one axis": (through(p, one, np.roll(w, 1, axis=1)), ORDER + "|direction|omega|" + READ),
    }


@kinds_of("05.8", "06.8", "10.6")
def rows(g: Any, table: Any) -> Kinds:
    reach = table * (0, 1, 0, 1)
    reach[:, 0] = np.hypot(table[:, 0], table[:, 2])
    return {
        "negated every d": (table * (1, 1, -1, 1), SIGN + "|d"),
        "left every d at 0": (table * (1, 1, 0, 1), "left out|left at|0|d"),
        "moved a and alpha one row down": (np.column_stack([np.roll(table[:, :2], 1, axis=0), table[:, 2:]]), "row|convention|shift|" + ORDER),
        "measured a from joint to joint": (reach, "normal|distance|joint to joint|left|d|a"),
    }
