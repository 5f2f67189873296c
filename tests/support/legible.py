"""What makes a drawing legible: its labels cover neither each other nor the border, and all is visible on a dark page too."""

import base64
import re
from itertools import combinations, pairwise
from xml.etree import ElementTree as ET

import numpy as np
from browser import contrast

from kinlib.view.drawing.figure_colours import (
    COLOUR,
    DARK_COLOURS,
    GHOST_GREY,
    LIGHT_AND_DARK,
    PALE_GREY,
    SHADES,
    dark_colour,
)

PAPER = DARK_COLOURS["#ffffff"]
QUIET = {"white", "#ffffff", PALE_GREY, *SHADES, *(LIGHT_AND_DARK[name][0] for name in ("edge", "shadow"))}
"""Paper, the grid, and the shades of bodies, of which some are as dark as a dark page: these need no contrast."""


def assert_legible(pictures):
    """The labels of each picture are apart, all of it is on its sheet, and it stays visible in the dark."""
    for name, draw in pictures.items():
        picture = draw()
        assert not overlapping_labels(picture), name
        assert_complete(picture)
        assert_visible_in_the_dark(picture)


def overlapping_labels(picture):
    """Return the pairs of labels that cover each other, and check that every label is on the sheet."""
    drawing = ET.fromstring(picture.svg)
    left, top, *sheet = map(float, drawing.get("viewBox").split())
    low = np.array([left, top])
    boxes = []
    for before, text in [pair for pair in pairwise(drawing.iter()) if pair[1].tag.endswith("}text")]:
        said, size = "".join(text.itertext()), float(text.get("font-size"))
        half = np.array([0.25 * len(said), 0.4]) * size
        centre = np.array([float(text.get("x")), float(text.get("y")) - 0.35 * size])
        assert (centre - half > low).all(), said
        assert (centre + half < low + sheet).all(), said
        boxes.append((centre - half, centre + half, said))
        if before.get("stroke-width") == "0.8":  # a thin line that leads to the label ends at its border
            end = np.array(before.get("points").split()[-1].split(","), dtype=float)
            assert (np.abs(end - centre) > half).any(), said
    return [(a[2], b[2]) for a, b in combinations(boxes, 2) if (a[0] < b[1]).all() and (b[0] < a[1]).all()]


def assert_complete(picture):
    """Every line and every polygon of the drawing is on its sheet."""
    left, top, width, height = map(float, re.search(r'viewBox="([^"]+)"', picture.svg)[1].split())
    pairs = " ".join(re.findall(r' points="([^"]+)"', picture.svg)).split()
    points = np.array([pair.split(",") for pair in pairs], dtype=float)
    assert (points >= (left, top)).all()
    assert (points <= (left + width, top + height)).all()


def assert_visible_in_the_dark(picture):
    """The drawing on a page has a rule for each of its colours, by which lines and letters stay visible."""
    colours = {colour for _, _, colour in COLOUR.findall(picture.svg)}
    written = set(re.findall(r'(?:<text[^>]* fill|stroke)="(#[0-9a-f]{6})"', picture.svg)) - QUIET
    for colour in colours - QUIET:
        assert contrast(dark_colour(colour), PAPER) > 1.8, colour
    for colour in written & set(DARK_COLOURS) - {GHOST_GREY}:  # what is drawn for comparison may be faint
        assert contrast(dark_colour(colour), PAPER) > 3, colour
    shown = base64.b64decode(re.search(r"base64,([^\"]+)", picture.html())[1]).decode()
    style = re.search(r"<style>@media \(prefers-color-scheme:dark\)\{(.*)\}</style>", shown)
    assert shown.replace(style[0], "") == picture.svg
    assert ET.fromstring(shown) is not None
    for kind, mark, colour in COLOUR.findall(picture.svg):
        rule = f'[{kind}="{colour}"]' if mark == '="' else f'[style*="{kind}: {colour}"]'
        assert f"{rule}{{{kind}:{dark_colour(colour)}" in style[1]
