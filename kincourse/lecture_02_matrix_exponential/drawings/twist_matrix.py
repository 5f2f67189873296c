"""The cross product as a matrix, and the 4x4 matrix of a screw axis: where each component of omega and v has its place."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.view.drawing import svg
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

HAT = (("", "-z", "+y"), ("+z", "", "-x"), ("-y", "+x", ""))
"""The sign and the component of omega in each entry of [omega]; "" for a zero."""

CELL_PX, TEXT_PX = np.array([60.0, 38.0]), 17.0


def draw_cross_product() -> Picture:
    """Draw omega x p, component by component, beside the product of [omega] and p.

    >>> draw_cross_product().alt[:98]
    'The cross product of omega and p as a matrix. x: omega_y p_z - omega_z p_y. Row 1 of [omega]: 0, -'
    """
    marks, sentences = [], ["The cross product of omega and p as a matrix."]
    left, top = 150.0, 42.0
    for i, row in enumerate(HAT):
        y = top + (i + 0.5) * CELL_PX[1]
        plus, minus = sorted((term for term in zip(row, "xyz", strict=True) if term[0]), key=lambda term: term[0][0])
        terms = [f"$\\omega_{entry[1]}$ $p_{other}$" for entry, other in (plus, minus)]
        marks += [
            svg.text((75, y), f"{terms[0]} − {terms[1]}", INK, TEXT_PX),
            svg.text((left - 3, y), "=", INK, TEXT_PX),
            svg.text((left + 3.75 * CELL_PX[0], y), f"$p_{'xyz'[i]}$", INK, TEXT_PX),
        ]
        words = [f"{'-' * (entry[:1] == '-')}omega_{entry[1]}" if entry else "0" for entry in row]
        plain = " - ".join(term.replace("\\", "").replace("$", "") for term in terms)
        sentences.append(f"{'xyz'[i]}: {plain}. Row {i + 1} of [omega]: {', '.join(words)}.")
    marks += _cells(HAT, (left + 0.2 * CELL_PX[0], top))
    x = left + 0.2 * CELL_PX[0]
    bottom = top + 3 * CELL_PX[1]
    marks += _brackets(x, x + 3 * CELL_PX[0], top, bottom)
    marks += _brackets(left + 3.45 * CELL_PX[0], left + 4.05 * CELL_PX[0], top, bottom)
    for place, name in (
        ((75, 20), "$\\omega$ × $p$"),
        ((x + 1.5 * CELL_PX[0], 20), "[$\\omega$]"),
        ((left + 3.75 * CELL_PX[0], 20), "$p$"),
    ):
        marks.append(svg.text(place, name, INK, TEXT_PX))
    return Picture(svg.document(marks, left + 4.05 * CELL_PX[0] + 10, bottom + 14), " ".join(sentences))


def draw_twist_matrix(S: ArrayLike) -> Picture:
    """Draw the 4x4 matrix [S] of a twist: in letters, with frames around [omega] and v, and with its numbers.

    S  (6,) the twist (omega, v)

    >>> draw_twist_matrix([1, 2, 3, 4, 5, 6]).alt[:86]
    'The matrix [S] of S = (1, 2, 3, 4, 5, 6). Row 1: -omega_z = -3 in column 2, omega_y = '
    """
    S = np.asarray(S, dtype=float)
    letters = [[*row, f"v{name}"] for row, name in zip(HAT, "xyz", strict=True)] + [[""] * 4]
    values = dict(zip(("x", "y", "z", "vx", "vy", "vz"), S.tolist(), strict=True))
    numbers, sentences = [], [f"The matrix [S] of S = {vector_text(S)}."]
    for i, row in enumerate(letters, start=1):
        shown = [_value(entry, values) for entry in row]
        numbers.append([format_number(number, 4) for number in shown])
        named = [
            f"{_name(entry)} = {text} in column {j}"
            for j, (entry, text) in enumerate(zip(row, numbers[-1], strict=True), start=1)
            if entry
        ]
        sentences.append(f"Row {i}: {', '.join(named)}, zero elsewhere." if named else f"Row {i} is zero.")
    top, width = 44.0, 4 * CELL_PX[0]
    marks = [svg.text((14 + width / 2, 20), "[$S$] in letters", INK, TEXT_PX - 2)]
    marks.append(svg.text((60 + 1.5 * width, 20), f"for $S$ = {vector_text(S)}", INK, TEXT_PX - 2))
    for left, shown_as in ((14.0, ()), (60.0 + width, numbers)):
        marks += _cells(letters, (left, top), shown_as)
        marks += _brackets(left, left + width, top, top + 4 * CELL_PX[1])
        for low, high, colour in ((0, 3, VIOLET), (3, 4, ORANGE)):
            corners = [(low, 0), (high, 0), (high, 3), (low, 3), (low, 0)]
            box = (
                np.array([left, top])
                + np.array(corners) * CELL_PX
                + 3 * np.sign(np.array([0.5 * (low + high), 1.5]) - corners)
            )
            marks.append(svg.polyline(box, colour, 1.6, "--" if colour == ORANGE else "-"))
        names = (("[$\\omega$]", left + 1.5 * CELL_PX[0], VIOLET), ("$v$", left + 3.5 * CELL_PX[0], ORANGE))
        marks += [svg.text((x, top + 4 * CELL_PX[1] + 16), name, colour, TEXT_PX - 2) for name, x, colour in names]
    return Picture(svg.document(marks, 74 + 2 * width, top + 4 * CELL_PX[1] + 32), " ".join(sentences))


def _name(entry: str) -> str:
    return f"v_{entry[1]}" if entry[0] == "v" else f"{'-' * (entry[0] == '-')}omega_{entry[1]}"


def _value(entry: str, values: dict[str, float]) -> float:
    if not entry:
        return 0.0
    return values[entry] if entry[0] == "v" else {"+": 1, "-": -1}[entry[0]] * values[entry[1]]


def _cells(
    letters: Sequence[Sequence[str]], corner: tuple[float, float], numbers: Sequence[Sequence[str]] = ()
) -> list[str]:
    """The entries in letters, or as numbers in the same places, each in the colour of its component."""
    marks = []
    for i, row in enumerate(letters):
        for j, entry in enumerate(row):
            letter = "v" if entry[:1] == "v" else "\\omega"
            name = f"{'-' * (entry[:1] == '-')}${letter}_{entry[1]}$" if entry else "0"
            label = (numbers[i][j] if numbers else name).replace("-", "−")
            marks.append(svg.text(np.array(corner) + CELL_PX * (j + 0.5, i + 0.5), label, _colour(entry), TEXT_PX))
    return marks


def _colour(entry: str) -> str:
    return AXIS_COLOURS["xyz".index(entry[1])] if entry else GREY


def _brackets(left: float, right: float, top: float, bottom: float) -> list[str]:
    return [
        svg.polyline(np.array([(x + inward, top), (x, top), (x, bottom), (x + inward, bottom)]), INK, 1.6)
        for x, inward in ((left - 4, 7), (right + 4, -7))
    ]
