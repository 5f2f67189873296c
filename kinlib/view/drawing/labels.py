"""Places for labels in a drawing: beside what they name, not over each other, and off the lines if there is room."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing import svg

Offset = tuple[float, float]

LABEL_OFFSETS: tuple[Offset, ...] = (
    *((11, 9), (-11, 9), (11, -11), (-11, -11), (0, 16), (0, -18), (19, 0), (-19, 0)),
    *((24, 19), (-24, 19), (24, -21), (-24, -21), (0, 30), (0, -32), (36, 0), (-36, 0)),
    *((34, 32), (-34, 32), (34, -34), (-34, -34), (0, 44), (0, -46), (50, 0), (-50, 0)),
)
"""Where a label may be placed: offsets in pixels to the right of what it names and above it, nearer ones first."""

OVERLAP_COST, OFF_SHEET_COST, BODY_COST, LINE_CROSSING_COST = 100.0, 100.0, 25.0, 8.0
"""What a place costs, beside its number in the list; crossing a line costs as much as eight places down the list."""


class Label(NamedTuple):
    """A label that is still to be placed, at one of several offsets from its anchor, in pixels."""

    anchor: Array
    text: str
    colour: str
    offsets: Sequence[Offset]
    size: float


def place_labels(
    labels: Sequence[Label], strokes: Array, bodies: Array, sheet: Array
) -> Iterator[tuple[Label, Array, Array]]:
    """Find for each label, in their order, the centre where it costs least, and half of its size; all in pixels.

    strokes (m, 2, 2) from point to point; bodies (k, 2, 2) upper left and lower right corners; sheet (2,).
    A label with the same text at the same point as an earlier one is left out.
    """
    taken = np.zeros((0, 2, 2))
    kept: list[Label] = []
    for label in labels:
        if any(label.text == other.text and np.abs(label.anchor - other.anchor).max() < 4 for other in kept):
            continue
        kept.append(label)
        half = np.array([0.29 * len(svg.plain_text(label.text)) + 0.1, 0.5]) * label.size
        centres = label.anchor + np.array(label.offsets, dtype=float) * (1, -1)
        boxes = np.stack([centres - half, centres + half], axis=1)
        is_off = ((boxes[:, 0] < 2) | (boxes[:, 1] > sheet - 2)).any(axis=-1)
        cost = np.arange(len(boxes)) + OFF_SHEET_COST * is_off + OVERLAP_COST * _overlaps(boxes, taken)
        cost += BODY_COST * np.minimum(_overlaps(boxes, bodies), 2) + LINE_CROSSING_COST * _crossings(boxes, strokes)
        best = int(np.argmin(cost))
        taken = np.concatenate([taken, boxes[best : best + 1]])
        yield label, centres[best], half


def _overlaps(boxes: Array, others: Array) -> Array:
    """Count how many of the other boxes each box overlaps."""
    apart = (boxes[:, None, 0] >= others[None, :, 1]) | (others[None, :, 0] >= boxes[:, None, 1])
    return np.asarray((~(apart[..., 0] | apart[..., 1])).sum(axis=-1).astype(float))


def _crossings(boxes: Array, strokes: Array) -> Array:
    """Count the strokes that pass through each box: those whose part between the box's four borders is not empty."""
    start, along = strokes[None, :, 0], strokes[None, :, 1] - strokes[None, :, 0]
    along = np.where(np.abs(along) < 1e-9, 1e-9, along)
    one, other = (boxes[:, None, 0] - start) / along, (boxes[:, None, 1] - start) / along
    first, last = np.minimum(one, other), np.maximum(one, other)  # where it passes the borders of x and those of y
    enters = np.maximum(first[..., 0], first[..., 1]).clip(min=0.0)
    leaves = np.minimum(last[..., 0], last[..., 1]).clip(max=1.0)
    return np.asarray((enters < leaves).sum(axis=-1).astype(float))
