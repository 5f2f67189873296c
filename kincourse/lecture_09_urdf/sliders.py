"""Pictures of lecture 09 that a prediction precedes. They are here because their code and their captions tell the answer."""

from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from kinlib.rigid.rpy import origin
from kinlib.view import slide_frames
from kinlib.view.drawing.picture import vector_text

BOOM, WRIST = (-4, -2, 0), (4, -2, 0)
"""The origins of the joints of the RPR arm, as its file gives them."""


def slide_the_boom(after: Any) -> Any:
    """Rotate joint 1 of the RPR arm, and show where the frame of its wrist is, once a prediction is committed."""

    def links(degrees: float) -> dict[str, Array]:
        boom = origin(BOOM) @ exp([0, -np.radians(degrees), 0, 0, 0, 0])
        return {"s": np.eye(4), "boom": boom, "forearm": boom @ origin(WRIST)}

    def caption(degrees: float) -> str:
        return f"origin in the file: {WRIST}; wrist in {{s}}: {vector_text(links(degrees)['forearm'][:3, 3].round(2))}."

    return slide_frames(links, "joint 1 (degrees)", [0, 30, 60, 90], caption=caption, arrows=True, after=after)
