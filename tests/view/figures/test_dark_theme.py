"""Colours of the dark theme, and cropping: drawings on a page, and the pictures of a slider."""

import re

import numpy as np
import pytest

import kinlib as kl
from kinlib.view import Picture, draw_arm, draw_linkage, plot
from kinlib.view.drawing.crop import crop


def test_a_plot_has_no_colour_that_follows_no_rule():
    """matplotlib leaves out the colour of black text; then it would be black on a dark page."""
    alt = "Two lines that go up, and a mark."
    svg = plot([1, 2], {"a": [1, 2], "b": [2, 3]}, xlabel="x", ylabel="y", alt=alt, mark=1).svg
    assert "#000000" not in svg
    glyphs = [group for group in re.findall(r"<g[^>]*>", svg) if "scale(" in group and "translate" in group]
    assert glyphs
    assert all("fill: #1f2328" in group for group in glyphs)


def test_a_cropped_drawing_contains_everything_and_little_else():
    arm = draw_arm(kl.robots.puma560(), np.full(6, 0.3), ghost=np.zeros(6), show=["axes", "base", "tool", "links"])
    linkage = draw_linkage(kl.linkages.slider_crank(1, 3), [0, 0, 4, 0], ghost=[0.5, 0, 3, 0])
    for svg in (arm.svg, linkage.svg):
        left, top, width, height = map(float, re.search(r'viewBox="([^"]+)"', svg)[1].split())
        points = np.array(
            [pair.split(",") for pairs in re.findall(r' points="([^"]+)"', svg) for pair in pairs.split()], dtype=float
        )
        assert (points >= (left, top)).all()
        assert (points <= (left + width, top + height)).all()
        assert (np.ptp(points, axis=0) > 0.75 * np.array([width, height])).all()


def test_an_image_from_elsewhere_is_not_cropped():
    with pytest.raises(ValueError, match="crop takes drawings made by kinlib"):
        crop([Picture("<svg></svg>", "A drawing with nothing in it.")])
