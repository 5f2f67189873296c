"""Answers by hand where the screw axis of a revolute joint is read off a drawing, in {s} or in {b}."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from evidence.answers_by_hand import WrongAnswer, alike, right
from evidence.answers_by_hand.common import words as by
from evidence.answers_by_hand.common.motions import I3, halves_swapped, negated_one, swapped


def screw_of_a_drawn_axis(given: Any, answer: Any) -> Iterator[WrongAnswer]:
    S = np.round(answer, 9)
    w, v = S[:3], S[3:]
    p, k = np.cross(w, v), int(np.argmax(np.abs(w)))
    i, j = (k + 1) % 3, (k + 2) % 3

    def line(p: Any = p, w: Any = w) -> Any:
        return np.array([*w, *np.cross(p, w)])

    next_axis = np.roll(w, 1)
    yield from alike(by.SIGN | {"other way"}, {"-S": -S})
    yield from alike(by.MOMENT | {"arrow"}, {"omega x p": line(-p), "-omega, moment kept": [*-w, *v]})
    yield from alike(by.HALVES, {"halves swapped": halves_swapped(S)})
    yield from alike(by.POINT, {"point as moment": [*w, *p], "moment along the axis": [*w, *v + w]})
    yield from alike(by.OMITTED | {"moment", "origin"}, {"no moment": [*w, 0, 0, 0]})
    yield from alike(by.SLIDE, {"as a slide": [0, 0, 0, *w]})
    yield from alike(
        by.AXIS | by.SWAPPED, {"another axis, moment kept": [*next_axis, *v], "another axis": line(w=next_axis)}
    )
    yield from alike(by.SWAPPED, {"two coordinates": line(swapped(p, i, j)), "entries of v": [*w, *swapped(v, i, j)]})
    yield from alike(by.SWAPPED | by.MOMENT, {"omega x p, two coordinates swapped": line(swapped(-p, i, j))})
    yield from alike(by.SIGN, {"one sign of the point": line(negated_one(p)), "one sign of v": [*w, *negated_one(v)]})
    yield from alike(by.POINT, {"one metre off": line(p + I3[i])})
    yield from alike(by.POINT, {"a coordinate read as zero": line(p * (I3[i] + I3[k]))})
    yield from alike(by.SIGN | by.HALVES, {"-S and halves swapped": halves_swapped(-S)})
    yield from alike(by.MOMENT | by.HALVES, {"omega x p and halves swapped": [*-v, *w]})
    yield from alike(by.POINT | by.HALVES, {"point as moment, halves swapped": [*p, *w]})
    yield from right({"integers": S.astype(int), "list": S.tolist(), "another point of the axis": line(p + 2 * w)})
