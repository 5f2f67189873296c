"""Pictures of lecture 09 that a prediction precedes. They are here because their code and their captions tell the answer."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.assignment import FrameAssignment
from kinlib.rigid.lie import exp
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.drawing.plot import plot
from kinlib.view.viewer.moving_frames import slide_frames
from kinlib.view.viewer.pictures import slide

BOOM, WRIST = (-4, -2, 0), (4, -2, 0)
"""The origins of the joints of the RPR arm, as its file gives them."""


def slide_the_boom(after: Any) -> Any:
    """Rotate joint 1 of the RPR arm, and show where the frame of its wrist is, once a prediction is committed.

    >>> slide_the_boom(None).alt[:56]
    'origin in the file: (4, -2, 0); wrist in {s}: (0, -4, 0)'
    """

    def links(degrees: float) -> dict[str, Array]:
        boom = origin(BOOM) @ exp([0, -np.radians(degrees), 0, 0, 0, 0])
        return {"s": np.eye(4), "boom": boom, "forearm": boom @ origin(WRIST)}

    def caption(degrees: float) -> str:
        return f"origin in the file: {WRIST}; wrist in {{s}}: {vector_text(links(degrees)['forearm'][:3, 3].round(2))}"

    return slide_frames(links, "joint 1 (degrees)", [0, 30, 60, 90], caption=caption, arrows=True, after=after)


def slide_decimals(curves: Mapping[str, Sequence[float]], tables: Mapping[int, FrameAssignment], after: Any) -> Any:
    """Show the errors of a file and of its table against the decimals to which the file gives pi.

    curves  errors in metres, a value for each number of decimals
    tables  for each number of decimals, the frames that were assigned to the arm of the file
    """
    decimals = list(tables)
    worst = max(decimals, key=lambda k: tables[k].accuracy)

    def at(k: int) -> Picture:
        largest = np.abs(tables[k].table.columns["d"]).max()
        caption = f"{k} decimals: the largest d of the table is {largest:.3g} m, its error {tables[k].accuracy:.0e}."
        alt = (
            "With more decimals the file comes closer to the arm that was meant. The error of the table against the file rises up to "
            f"{worst} decimals and falls from there. {caption}"
        )
        words = {"xlabel": "decimals of pi in the file", "ylabel": "largest error of a pose"}
        return plot(decimals, curves, **words, log="y", alt=alt, mark=k, caption=caption)

    return slide(at, "decimals", decimals, after=after)
