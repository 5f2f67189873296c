"""Cropping: a drawing is cut to what it shows, and pictures of one slider are cut alike, so that nothing jumps."""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinlib.view.drawing.picture import Picture

BORDER_PX = 10.0
LARGEST_PX = (640.0, 440.0)
MAX_ENLARGEMENT = 1.3
"""A cropped drawing is enlarged to this size at most, and its letters by this factor at most."""

HEAD = re.compile(r'(<svg [^>]*?)width="([\d.]+)" height="([\d.]+)" viewBox="([^"]+)">\s*<rect [^>]*>')


def crop(pictures: Sequence[Picture], largest: tuple[float, float] = LARGEST_PX) -> list[Picture]:
    """Cut drawings to the smallest rectangle that contains what all of them show, and enlarge them a little, to `largest`.

    Pictures of which one is not from a canvas, such as plots, are left as they are.
    """
    if not all(picture.content for picture in pictures):
        return list(pictures)
    boxes = np.array([picture.content for picture in pictures])
    low, high = boxes[:, :2].min(axis=0) - BORDER_PX, boxes[:, 2:].max(axis=0) + BORDER_PX
    scale = min(MAX_ENLARGEMENT, max(1.0, float((largest / (high - low)).min())))
    left, top, width, height = (f"{x:.5g}" for x in (*low, *(high - low)))
    wide, tall = (f"{x:.4g}" for x in scale * (high - low))
    head = f'width="{wide}" height="{tall}" viewBox="{left} {top} {width} {height}">'
    head += f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="white"/>'
    return [replace(picture, svg=HEAD.sub(lambda found: found[1] + head, picture.svg, count=1)) for picture in pictures]
