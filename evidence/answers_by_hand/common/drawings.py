"""Wrong readings of a dimensioned drawing, from the right answer: the drawing gives no numbers to a program."""

import numpy as np

Cases = dict[str, tuple[object, str]]


def points(answer: object) -> Cases:
    """Wrong points, (k, 3) in metres."""
    p = np.array(answer, dtype=float)
    cases: Cases = {
        "y and z exchanged": (p[:, [0, 2, 1]], "swap, view, order"),
        "in millimetres": (1000 * p, "millimetre"),
        "all negative": (-p, "sign, opposite, child"),
        "twice as far": (2 * p, "twice"),
    }
    if np.abs(p[:, 1]).min() > 1e-3:
        cases["y towards me"] = (p * (1, -1, 1), "sign, y")
    return cases


def screws(answer: object) -> Cases:
    """Wrong screws, (k, 6), of joints that are not all prismatic."""
    S = np.array(answer, dtype=float)
    turns = np.any(S[:, :3], axis=1)[:, None] & (np.arange(6) >= 3)
    return {
        "v first": (np.roll(S, 3, axis=1), "front, half, halves, (v"),
        "every arrow reversed": (-S, "sign, opposite"),
        "omega x p": (np.where(turns, -S, S), "moment, sign, \\times p"),
        "no moments": (np.where(turns, 0, S), "moment"),
        "in millimetres": (np.where(turns, 1000 * S, S), "millimetre"),
    }


def rows(answer: object) -> Cases:
    """Wrong rows of a table, one after the other, in metres and radians."""
    table = np.array(answer, dtype=float).reshape(-1, 4)
    each = {
        "alpha the other way": (table * (1, -1, 1, 1), "sign, alpha"),
        "theta the other way": (table * (1, 1, 1, -1), "sign, theta"),
        "a and d exchanged": (table[:, [2, 1, 0, 3]], "swap, order, left out, a and d"),
        "in millimetres": (table * (1000, 1, 1000, 1), "millimetre"),
        "in degrees": (table * (1, 180 / np.pi, 1, 180 / np.pi), "degree"),
    }
    # A full turn more or less is the same angle.
    gaps = {
        label: np.where((0, 1, 0, 1), 2 * np.sin((value - table) / 2), value - table)
        for label, (value, _) in each.items()
    }
    return {label: (value.ravel(), words) for label, (value, words) in each.items() if np.abs(gaps[label]).max() > 1e-6}
