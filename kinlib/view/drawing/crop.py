"""Cropping: a drawing is cut to what it shows, and pictures of one slider are cut alike, so that nothing jumps."""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.picture import Picture

BORDER_PX = 10.0
LARGEST_PX = (640.0, 440.0)
MAX_ENLARGEMENT = 1.3
"""A cropped drawing is enlarged to this size at most, and its letters by this factor at most."""

HEAD = re.compile(r'(<svg [^>]*?)width="([\d.]+)" height="([\d.]+)" viewBox="([^"]+)">\s*<rect [^>]*>')
POINTS = re.compile(r' points="([^"]+)"')
CIRCLE = re.compile(r' cx="([-\d.]+)" cy="([-\d.]+)" r="([\d.]+)"')
TEXT = re.compile(r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="middle" font-size="([\d.]+)"[^>]*>(.*?)</text>')
CHARACTER_WIDTH = 0.6
"""The mean width of a character, as a share of the font size."""


def crop(pictures: Sequence[Picture], largest: tuple[float, float] = LARGEST_PX) -> list[Picture]:
    """Cut drawings to the smallest rectangle that contains what all of them show, and enlarge them a little, to `largest`.

    Pictures of which one is not a drawing by svg.document, such as plots, are left as they are.
    """
    if not all(HEAD.match(picture.svg) for picture in pictures):
        return list(pictures)
    boxes = np.array([_content(picture.svg) for picture in pictures])
    low, high = boxes[:, 0].min(axis=0) - BORDER_PX, boxes[:, 1].max(axis=0) + BORDER_PX
    scale = min(MAX_ENLARGEMENT, max(1.0, float((largest / (high - low)).min())))
    left, top, width, height = (f"{x:.5g}" for x in (*low, *(high - low)))
    wide, tall = (f"{x:.4g}" for x in scale * (high - low))
    head = f'width="{wide}" height="{tall}" viewBox="{left} {top} {width} {height}">'
    head += f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="white"/>'
    return [replace(picture, svg=HEAD.sub(lambda found: found[1] + head, picture.svg, count=1)) for picture in pictures]


def _content(svg: str) -> Array:
    """Return the upper left and the lower right corner of what a drawing shows, (2, 2), in the pixels of the drawing."""
    corners = [np.array(pairs.replace(",", " ").split(), dtype=float).reshape(-1, 2) for pairs in POINTS.findall(svg)]
    for x, y, radius in np.array(CIRCLE.findall(svg), dtype=float).reshape(-1, 3):
        corners.append(np.array([[x - radius, y - radius], [x + radius, y + radius]]))
    for x, y, size, inside in TEXT.findall(svg):
        height = float(size)
        half = 0.5 * CHARACTER_WIDTH * height * len(re.sub(r"<[^>]*>|&\w+;", "", inside))
        corners.append(np.array([[float(x) - half, float(y) - height], [float(x) + half, float(y) + 0.4 * height]]))
    points = np.concatenate(corners)
    return np.array([points.min(axis=0), points.max(axis=0)])
