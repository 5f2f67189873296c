"""Figures in the dark theme: every colour of every figure is replaced, and lines and letters stay visible."""

import base64
import re
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from browser import contrast

import kinlib as kl
from kincourse.lecture_02_matrix_exponential.drawings import draw_series
from kincourse.lecture_04_poe_body.drawings.mid_formula import draw_mid_formula
from kincourse.lecture_08_closed_chains.drawings.torus import draw_torus
from kinlib.view import Picture, draw_arm, draw_frames, draw_linkage, plot
from kinlib.view.drawing.crop import crop
from kinlib.view.drawing.dark_theme import COLOUR, DARK_COLOURS, dark_colour, follow_theme
from kinlib.view.drawing.figure_colours import PALE_GREY
from kinlib.view.figures.dh_table import draw_row
from kinlib.view.figures.frame_assignment import draw_assignment

ARM = kl.robots.puma560()
FIGURES = {
    "arm": lambda: draw_arm(
        ARM, np.full(6, 0.3), ghost=np.zeros(6), show=["axes", "home axes", "base", "tool", "links"]
    ),
    "frames": lambda: draw_frames({"s": np.eye(4), "b": kl.exp([0, 0, 0, 1, 0, 2])}, numbers=True),
    "linkage": lambda: draw_linkage(kl.linkages.slider_crank(1, 3), [0, 0, 4, 0], ghost=[0.5, 0, 3, 0]),
    "assignment": lambda: draw_assignment(kl.assign_frames(ARM, convention="standard"), 9),
    "row": lambda: draw_row([0.8, 1.0, 0.6, 0.9]),
    "series": lambda: draw_series(kl.robots.rpr().screws[0], 1.0, (0, 0, 1), 5),
    "mid-formula": lambda: draw_mid_formula(kl.robots.mid_formula_arm(), 2),
    "torus": lambda: draw_torus({"a": np.zeros((2, 2)), "b": np.ones((2, 2))}, {"now": (0, 1)}, xlabel="A", ylabel="D"),
    "plot": lambda: plot(
        [1, 2], {"a": [1, 2], "b": [2, 3]}, xlabel="x", ylabel="y", alt="Two lines that go up.", mark=1
    ),
}
PAPER = DARK_COLOURS["#ffffff"]
QUIET = {"white", "#ffffff", PALE_GREY}
"""Paper, and the grid: these need no contrast."""


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_has_a_rule_for_each_of_its_colours_all_of_which_stay_visible(name):
    picture = FIGURES[name]()
    colours = {colour for _, _, colour in COLOUR.findall(picture.svg)}
    assert {"#1f2328"} <= colours
    written = set(re.findall(r'(?:<text[^>]* fill|stroke)="(#[0-9a-f]{6})"', picture.svg)) - QUIET
    for colour in colours - QUIET:
        assert contrast(dark_colour(colour), PAPER) > 1.8, colour
    for colour in written & set(DARK_COLOURS) - {"#b6bec6"}:  # what is drawn in grey for comparison may be faint
        assert contrast(dark_colour(colour), PAPER) > 3, colour
    shown = base64.b64decode(re.search(r"base64,([^\"]+)", picture.html())[1]).decode()
    style = re.search(r"<style>@media \(prefers-color-scheme:dark\)\{(.*)\}</style>", shown)
    assert shown.replace(style[0], "") == picture.svg
    assert ET.fromstring(shown) is not None
    for kind, mark, colour in COLOUR.findall(picture.svg):
        rule = f'[{kind}="{colour}"]' if mark == '="' else f'[style*="{kind}: {colour}"]'
        assert f"{rule}{{{kind}:{dark_colour(colour)}" in style[1]


def test_a_plot_has_no_colour_that_follows_no_rule():
    """matplotlib leaves out the colour of black text; then it would be black on a dark page."""
    svg = FIGURES["plot"]().svg
    assert "#000000" not in svg
    glyphs = [group for group in re.findall(r"<g[^>]*>", svg) if "scale(" in group and "translate" in group]
    assert glyphs
    assert all("fill: #1f2328" in group for group in glyphs)


def test_dark_colours_keep_their_hue():
    assert len(set(re.findall("..", dark_colour("#cccccc")[1:]))) == 1
    red = dark_colour("#802020")
    assert int(red[1:3], 16) > 1.5 * int(red[3:5], 16) == 1.5 * int(red[5:7], 16)
    assert follow_theme('<svg><a fill="#cccccc"/></svg>').count("<style>") == 1


# --- cropping ---


def test_a_cropped_drawing_contains_everything_and_little_else():
    for name in ("arm", "linkage"):
        svg = FIGURES[name]().svg
        left, top, width, height = map(float, re.search(r'viewBox="([^"]+)"', svg)[1].split())
        points = np.array(
            [pair.split(",") for pairs in re.findall(r' points="([^"]+)"', svg) for pair in pairs.split()], dtype=float
        )
        assert (points >= (left, top)).all()
        assert (points <= (left + width, top + height)).all()
        assert (np.ptp(points, axis=0) > 0.75 * np.array([width, height])).all()


def test_pictures_of_one_slider_are_cropped_alike():
    around = [(-0.9, -0.9, 0), (0.9, 0.9, 1)]
    pictures = [draw_arm(ARM, np.full(6, x), around=around) for x in (0, 0.5)]
    heads = {picture.svg.partition("<g")[0] for picture in crop(pictures)}
    assert len(heads) == 1
    assert heads != {pictures[0].svg.partition("<g")[0]}


def test_an_image_from_elsewhere_is_not_cropped():
    with pytest.raises(ValueError, match="crop takes drawings made by kinlib"):
        crop([Picture("<svg></svg>", "A drawing with nothing in it.")])
