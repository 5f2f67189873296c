"""Sliders of one call: every value has its own picture and its own text, and wrong arguments are refused."""

import html
import re

import numpy as np
import pytest

import kinlib as kl
from kincourse.lecture_04_poe_body.drawings import slide_axis, slide_mid_formula
from kincourse.lecture_05_dh_standard.drawings import slide_offset
from kincourse.lecture_08_closed_chains.drawings import slide_curve, slide_linkage
from kincourse.lecture_08_closed_chains.drawings.torus import draw_torus
from kinlib.rigid.lie import exp, homogeneous
from kinlib.view import slide_frames
from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

WIDE = kl.linkages.four_bar(ground=0.5, crank=0.3, coupler=0.3, rocker=0.3)
ARM = kl.robots.mid_formula_arm()
TABLE = kl.assign_frames(kl.robots.youbot(), convention="standard").table


def alts(make, monkeypatch):
    """Return the text alternative of each picture of a slider."""
    monkeypatch.setenv(ENVIRONMENT_VARIABLE, "1")
    return [said["alt"] for said in make().texts]


def around_the_curve(**settings):
    curve = WIDE.trace(WIDE.assembly_modes(hold={"A": 0.5})[0], points=25).q[
        :-1
    ]  # the last point is the first one again
    left = np.sin(curve[:, 3]) > 0
    return slide_curve(WIDE, curve, ("A", "D"), parts={"one mode": left, "other mode": ~left}, **settings)


SLIDERS = {
    "axis": lambda: slide_axis(ARM, 3, np.radians([[a, 0, 0, 0] for a in (0, 30, 60)]), "degrees", [0, 30, 60]),
    "mid-formula": lambda: slide_mid_formula(ARM, [0.5, -0.3, 0.8, 0.4]),
    "offset": lambda: slide_offset(TABLE, 4, [0, 45, 90]),
    "linkage": lambda: slide_linkage(WIDE, WIDE.assembly_modes(hold={"A": 0.5}), "mode", [1, 2]),
    "curve": around_the_curve,
}


def test_every_picture_of_a_slider_has_its_own_text(monkeypatch):
    for make in SLIDERS.values():
        texts = alts(make, monkeypatch)
        assert len(set(texts)) == len(texts) > 1
    curve = WIDE.trace(WIDE.assembly_modes(hold={"A": 0.5})[0], points=25).q[:-1:2]
    said = [re.search(r"now is at A = (\S+)°, D = (\S+)°", text).groups() for text in texts]  # around the curve
    off = np.exp(1j * np.radians(np.array(said, dtype=float))) - np.exp(1j * curve[:, [0, 2]])
    assert np.abs(off).max() < 0.01
    page = SLIDERS["axis"]().html()
    assert "Axis 3 in {s}: (0.5, 0.866, 0, -0.346, 0.2, 0). In {b}: (0, 0, 1, 0, 0, 0)." in page


# --- frames ---


def turning(x):
    return {"s": np.eye(4), "b": homogeneous(exp(np.array([0, 0, x])), (1, 0, 0))}


def test_frames_at_each_value_are_those_of_the_function_and_are_described():
    shown = slide_frames(turning, "angle", [0.0, 0.5, 1.0], caption=lambda x: f"Rotated by {x} rad.")
    texts = set()
    for index, x in enumerate((0.0, 0.5, 1.0)):
        shown.at = index
        np.testing.assert_allclose(np.reshape(shown.stop["poses"][1], (4, 4)), turning(x)["b"])
        assert shown.alt.startswith(f"Rotated by {x} rad. Frame {{s}} at (0, 0, 0)")
        assert f"x along {'x' if not x else f'({np.cos(x):.3g}, {np.sin(x):.3g}, 0)'}" in shown.alt
        assert shown.alt in html.unescape(shown.html())
        texts.add(shown.alt)
    assert len(texts) == 3
    with pytest.raises(ValueError, match="number of a stop, 0 to 2; got 3"):
        shown.at = 3


def test_wrong_arguments_are_refused():
    for make, says in [
        (lambda: slide_frames(turning, "value", []), "at least one value; got none"),
        (
            lambda: slide_frames(lambda x: {str(x): np.eye(4)}, "x", [0, 1]),
            r"names for all values, \['0'\]; got \['1'\]",
        ),
        (lambda: slide_frames(lambda _: {"s": np.eye(3)}, "value", [0]), "frame s"),
        (lambda: draw_torus(dict.fromkeys("abcd", np.zeros((2, 2))), xlabel="A", ylabel="D"), "at most 3 .* got 4"),
        (lambda: slide_axis(ARM, 1, np.zeros((2, 4)), "q", [0]), r"must be 2 values, one for each picture; got \[0\]"),
    ]:
        with pytest.raises(ValueError, match=says):
            make()
