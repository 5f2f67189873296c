"""Kinds of wrong answers that fit every problem, each written once: representation, units, placeholders, guesses, slips of the pen.

Each kind of answer says which of its numbers are lengths, angles, rows and directions; what is done to them is the same.
"""

# fmt: off
from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp

from outside import Kinds
from outside.choices import shared_orders
from outside.motions import I3, negated_one, pose, rot

SIGN = "sign|minus|negat|opposite|backwards|left-handed"
SWAP = "swap|exchang|interchang|order"
UNIT = "millimet|mm|unit|thousand|1000"
CENTI = "centimet|unit|cm|hundred"
DEGREES = "degree|radian"
ROUND = "round|digit|decimal"
TRANSPOSE = "transpos|R^T|rows|inver"
LEFT_OUT = "left out|leave out|forgot|missing|without"
POINT = "point|coordinate|p$|moment"
PLACEHOLDER = "left at|still|placeholder|is 0|are 0|zero|no numbers of your own|identity|left out|nothing"
PLACE = "look|entry|row|component|wrong place|only one|column|all but|the others|omega is right|v is right"
SIZE = "twice|half|factor|times|length|unit vector|doubl|divide|multipl"
ORDER = "order|shift|column|row|swap|component|cycl|wrong place"


def _lengths(kind: str, X: Any) -> Any:
    """Which entries are lengths."""
    mask = np.zeros(np.shape(X), dtype=bool)
    if kind == "pose":
        mask[:3, 3] = True
    elif kind in ("rows", "row"):
        mask[..., [0, 2]] = True
    elif kind in ("length", "vectors"):
        mask[...] = True
    elif kind == "origin":
        mask[0] = True
    elif kind in ("screw", "screws"):
        turns = np.abs(X[..., :3]).max(axis=-1, keepdims=True) > 1e-12
        mask[...] = turns & (np.arange(6) >= 3)
    return mask


def _angles(kind: str, X: Any) -> Any:
    """Which entries are angles."""
    mask = np.zeros(np.shape(X), dtype=bool)
    if kind in ("angles", "entries", "wrists"):
        mask[...] = True
    elif kind in ("rows", "row"):
        mask[..., [1, 3]] = True
    elif kind == "origin":
        mask[1] = True
    return mask


def shared_kinds(kind: str, value: Any) -> Kinds:
    """Return the shared kinds of wrong answers that differ from the right one."""
    if kind == "pose function":
        return _of_function(value)
    if kind == "formula":
        return {label: case for label, case in _of_formula(value).items() if differs(kind, case[0], value)}
    if kind == "order":
        return {label: case for label, case in shared_orders(value).items() if case[0] != value}
    if kind in ("table", "letter", "path"):
        return {}
    made = _of_array(kind, np.asarray(value, dtype=float))
    return {label: case for label, case in made.items() if differs(kind, case[0], value)}


def differs(kind: str, wrong: Any, value: Any) -> bool:
    """Return whether an answer differs from the right one by more than rounding; angles by more than full turns."""
    if kind in ("letter", "order", "path"):
        return kind == "letter" or bool(wrong != value)
    if kind == "formula":
        return any(sp.expand(x) != 0 for x in sp.Matrix(wrong) - sp.Matrix(value))
    if kind == "frames":
        return not np.allclose(wrong, value)
    if kind in ("wrists", "table", "pose function") or np.shape(wrong) != np.shape(value):
        return True
    if np.isnan(np.asarray(wrong, dtype=float)).any():
        return False  # a triangle that does not close
    X, off = np.asarray(value, dtype=float), np.asarray(wrong, dtype=float) - value
    off = np.where(_angles(kind, X), 2 * np.sin(off / 2), off)
    return bool((np.abs(off) > 0.005 * np.maximum(np.abs(X), min(1, np.abs(X).max()))).any())


def _of_array(kind: str, X: Any) -> Kinds:
    zeros, lengths, angles = 0 * X, _lengths(kind, X), _angles(kind, X)
    made: Kinds = {
        "left the zeros of np.zeros": (zeros, PLACEHOLDER),
        "wrote every sign the other way": (-X, SIGN + "|transpos|pi minus|inverse|other way|half a turn|other mode"),
    }
    if X.ndim:
        made["left the ones of np.ones"] = (zeros + 1, PLACEHOLDER + "|ones|all 1")
    if kind not in ("count", "counts", "entry", "frames"):
        made["wrote one decimal"] = (np.round(X, 1), ROUND + "|" + PLACE)
        made["wrote whole numbers"] = (np.round(X), ROUND + "|" + PLACE + "|" + PLACEHOLDER)
        made["wrote double of it"] = (2 * X, SIZE)
        made["wrote half of it"] = (X / 2, SIZE)
        if X.ndim and np.abs(X).max() > 1e-9:
            made["lost every minus sign"] = (np.abs(X), SIGN + "|" + PLACE + "|right sizes|no rotation")
            made["wrote one sign wrong"] = (negated_one(X), SIGN + "|" + PLACE)
            made["misread one digit by one"] = (_misread(X), PLACE)
    if lengths.any() and np.abs(X[lengths]).max() > 1e-9:
        made["gave lengths in millimetres"] = (np.where(lengths, 1000 * X, X), UNIT)
        made["gave lengths in centimetres"] = (np.where(lengths, 100 * X, X), CENTI)
    if angles.any() and np.abs(X[angles]).max() > 1e-9:
        made["gave angles in degrees"] = (np.where(angles, np.degrees(X), X), DEGREES)
        made["gave angles in degrees, rounded"] = (np.where(angles, np.round(np.degrees(X)), X), DEGREES)
        made["gave supplements"] = (np.where(angles, np.pi - X, X), "supplement|pi minus|half a turn|" + SIGN + "|" + PLACE)
    if kind == "millimetres":
        made["gave metres"] = (X / 1000, "metre|unit|1000|thousand")
        made["gave centimetres"] = (X / 10, CENTI)
    return {**made, **_arranged(kind, X), **_special(kind, X)}


def _misread(X: Any) -> Any:
    place = np.unravel_index(int(np.argmax(np.abs(X))), X.shape)
    Y = X.copy()
    Y[place] += np.sign(X[place])
    return Y


def _arranged(kind: str, X: Any) -> Kinds:
    """Rows, columns and components in another arrangement."""
    made: Kinds = {}
    if kind in ("matrix", "rotation"):
        made["transposed the matrix"] = (X.T, TRANSPOSE + "|" + SIGN + "|clockwise|other way")
        made["left the identity of np.eye"] = (np.eye(len(X)), PLACEHOLDER)
    if (kind == "vector" and X.size == 3) or kind == "vectors":
        made["wrote y, z, x"] = (X[..., [1, 2, 0]], ORDER)
        made["wrote z, y, x"] = (X[..., ::-1], ORDER)
    if kind in ("screws", "rows", "vectors"):
        made["wrote the last row first"] = (X[::-1], ORDER + "|revers|last joint")
        made["wrote the rows one down"] = (np.roll(X, 1, axis=0), ORDER)
        for gap, filled in {"left 0 above": 0 * X[:1], "repeated the first": X[:1]}.items() if len(X) > 2 else ():
            made[f"moved the rows one down, and {gap}"] = (np.vstack([filled, X[:-1]]), ORDER + "|moved")
        if len(X) > 2:
            made["swapped the first row and the last"] = (X[[len(X) - 1, *range(1, len(X) - 1), 0]], ORDER)
        copied = X.copy()
        copied[-1] = X[-2]
        made["copied the row before into the last"] = (copied, ORDER + "|same|twice|other|copied|joint|" + PLACE)
        empty = X.copy()
        empty[-1] = 0
        made["left the last row at 0"] = (empty, PLACEHOLDER + "|" + PLACE)
        one = X.copy()
        one[0] = -one[0]
        made["negated the first row"] = (one, SIGN)
    return made


def _special(kind: str, X: Any) -> Kinds:
    """What belongs to poses, rotations, screws and rows of tables."""
    made: Kinds = {}
    if kind == "pose":
        R, p = X[:3, :3], X[:3, 3]
        made |= {
            "left the identity of np.eye": (np.eye(4), PLACEHOLDER + "|R = I"),
            "gave the inverse": (np.linalg.inv(X), "inver|other way|seen from|way back|R^T|-q|opposite|T_{bs}|transpos"),
            "transposed R": (pose(R.T, p), TRANSPOSE + "|" + SIGN + "|clockwise|columns are"),
            "gave the position of the inverse": (pose(R, -R.T @ p), "inver|R^T|back|other frame"),
            "wrote the position in the rotated frame": (pose(R, R.T @ p), "R^T|transpos|other frame|{b}|rotat"),
            "transposed the whole matrix": (X.T, TRANSPOSE + "|last row"),
            "left the position at 0": (pose(R, 0 * p), PLACEHOLDER + "|position"),
            "left the rotation at I": (pose(I3, p), PLACEHOLDER + "|rotation"),
            "wrote the axes in the order y, z, x": (pose(R[:, [1, 2, 0]], p), ORDER + "|axes"),
            "wrote the axes in the order z, y, x": (pose(R[:, ::-1], p), ORDER + "|axes"),
            "swapped x and y of the position": (pose(R, p[[1, 0, 2]]), SWAP + "|order|sizes"),
            "turned the frame by a right angle about its z": (pose(R @ rot(I3[2], 90), p), "turn|90|right angle|quarter|" + ORDER + "|axes|swap"),
            "left out the last 1": (X - np.diag([0, 0, 0, 1.0]), "last row|corner|0 0 0 1"),
            "doubled the position": (pose(R, 2 * p), SIZE),
        }
    if kind == "rotation":
        made |= {
            "wrote the columns in the order y, z, x": (X[:, [1, 2, 0]], ORDER + "|axes"),
            "applied the rotation twice": (X @ X, "twice|doubl|two"),
        }
    if kind in ("screw", "screws"):
        w, v = X[..., :3], X[..., 3:]
        turns = np.abs(w).max(axis=-1, keepdims=True) > 1e-12
        made |= {
            "wrote v before omega": (np.roll(X, 3, axis=-1), "halves|(v,|in front|before|(omega, v)|into $\\omega$|in omega|omega"),
            "took omega x q for the moment": (np.where(turns, np.concatenate([w, -v], -1), X), SIGN + "|\\times"),
            "left the moments at 0": (np.where(turns, np.concatenate([w, 0 * v], -1), X), "moment|left out|left at 0|leave out|through the origin"),
            "wrote the moments as z, x, y": (np.concatenate([w, v[..., [2, 0, 1]]], -1), ORDER + "|moment|v is|sizes"),
            "gave every direction the length 2": (np.concatenate([2 * w, v], -1), SIZE + "|omega is not|direction"),
        }
    if kind == "rows":
        for label, order in (("d, theta, a, alpha", [2, 3, 0, 1]), ("theta, d, a, alpha", [3, 2, 0, 1]),
                             ("alpha, a, theta, d", [1, 0, 3, 2]), ("theta, d, alpha, a", [3, 2, 1, 0])):
            made[f"wrote the columns in the order {label}"] = (X[:, order], ORDER)
        made["left every theta at 0"] = (X * (1, 1, 1, 0), "offset|theta|" + PLACEHOLDER)
        made["left every alpha at 0"] = (X * (1, 0, 1, 1), "alpha|" + PLACEHOLDER)
        made["negated every alpha"] = (X * (1, -1, 1, 1), SIGN)
        made["negated every theta"] = (X * (1, 1, 1, -1), SIGN)
        made["swapped a and d in every row"] = (X[:, [2, 1, 0, 3]], SWAP + "|a and d")
    return made


def _of_function(f: Callable[..., Any]) -> Kinds:
    def after(change: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *x: change(np.asarray(f(*x)))

    return {
        "returned the identity of np.eye": (lambda *x: np.eye(4), PLACEHOLDER),
        "returned the inverse": (after(np.linalg.inv), "inver|" + SIGN),
        "returned the transpose": (after(np.transpose), "transpos"),
        "returned millimetres": (after(lambda T: pose(T[:3, :3], 1000 * T[:3, 3])), UNIT),
        "returned only the rotation": (after(lambda T: pose(T[:3, :3], [0] * 3)), "position|" + PLACEHOLDER),
        "returned one decimal": (after(lambda T: np.round(T, 1)), ROUND),
        "took q for degrees": (lambda q, *x: f(np.radians(q), *x), DEGREES),
        "turned the first joint the other way": (lambda q, *x: f([-q[0], *q[1:]], *x), SIGN),
        "turned all joints the other way": (lambda q, *x: f(-np.asarray(q), *x), SIGN + "|inver"),
        "left joint 2 at 0": (lambda q, *x: f([q[0], 0, *q[2:]], *x), "left out|leave out|joint 2|q_2"),
        "used q_1 for joint 2": (lambda q, *x: f([q[0], q[0], *q[2:]], *x), "q_1|q_2|joint"),
    }


def _of_formula(X: Any) -> Kinds:
    X = sp.Matrix(X)
    made: Kinds = {
        "left the zeros of sp.zeros": (0 * X, PLACEHOLDER),
        "wrote every sign the other way": (-X, SIGN + "|transpos|other way"),
        "wrote double of it": (2 * X, SIZE),
    }
    if X.shape[0] == X.shape[1]:
        made["transposed the matrix"] = (X.T, TRANSPOSE + "|" + SIGN)
        made["left the identity of sp.eye"] = (sp.eye(X.shape[0]), PLACEHOLDER)
    letters = sorted(X.free_symbols, key=str)
    if letters and letters[-1].name == "theta":
        t = letters[-1]
        made["swapped sine and cosine"] = (X.subs(t, sp.pi / 2 - t), SWAP + "|sin|cos")
        made["took -theta"] = (X.subs(t, -t), SIGN + "|transpos|other way|inver")
        made["put theta for sin theta"] = (X.subs(sp.sin(t), t), "theta|\\theta|sin|small|series|straight")
    elif len(letters) > 2:
        one, two = letters[:2]
        made["misread the first letter as the second"] = (X.subs(one, two), "where|instead|L_|read")
        made["left out the last letter"] = (X.subs(letters[-1], 0), "left out|leave out|missing|L_")
    if X.shape == (4, 4):
        R, p = X[:3, :3], X[:3, 3]
        last = sp.Matrix([[0, 0, 0, 1]])
        made["wrote R^T and p"] = (sp.Matrix.vstack(R.T.row_join(p), last), TRANSPOSE + "|" + SIGN + "|other way|columns|axes")
        made["left the position at 0"] = (sp.Matrix.vstack(R.row_join(0 * p), last), PLACEHOLDER + "|position")
        made["wrote the axes in the order y, z, x"] = (sp.Matrix.vstack(R[:, [1, 2, 0]].row_join(p), last), ORDER + "|axes")
    if X.shape[1] == 6:
        w, v = X[:, :3], X[:, 3:]
        made["wrote v before omega"] = (v.row_join(w), "halves|(v,|in front|before|(omega, v)|into $\\omega$|in omega|omega")
        made["left the moments at 0"] = (sp.Matrix([[*w[i, :], *(v[i, :] if not any(w[i, :]) else [0, 0, 0])] for i in range(X.shape[0])]), "moment|left out|leave out|left at 0")
        made["wrote the last row first"] = (X[::-1, :], ORDER + "|revers|last joint")
        made["wrote the rows one down"] = (X[[X.shape[0] - 1, *range(X.shape[0] - 1)], :], ORDER)
    return made


def legal_forms(kind: str, value: Any) -> dict[str, Any]:
    """Return the right answer in other forms, by what was done."""
    if kind == "pose function":
        return {"a function that returns lists": lambda *x: np.asarray(value(*x)).tolist()}
    if kind == "formula":
        X = sp.Matrix(value)
        lists = X.tolist() if X.shape[1] > 1 else list(X)
        return {"as text": str(lists), "expanded": sp.expand(X), "as lists": lists}
    if kind == "letter":
        letter, reason = value
        return {"as a list": [letter, reason], "with spaces": (f" {letter} ", reason)}
    if kind in ("table", "order", "path"):
        return {"as a tuple": tuple(value), "as a list": list(value)} if kind != "table" else {}
    X = np.asarray(value, dtype=float)
    forms: dict[str, Any] = {"as a list": X.tolist(), "as an array of objects": X.astype(object), "four decimals": np.round(X, 4)}
    if kind == "rows":
        forms["as rows one after the other"] = X.ravel().tolist()
    if kind in ("vector", "screw"):
        forms["as a tuple"] = tuple(X)
        forms["as a column"] = X.reshape(-1, 1)
    if kind == "angles":
        forms["a turn more"] = X + 2 * np.pi
        forms["from 0 to a turn"] = X % (2 * np.pi)
    return forms
