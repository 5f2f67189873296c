"""Sliders of one call: every value has its own picture and its own text."""

import numpy as np

import kinlib as kl
from kincourse.lecture_04_poe_body.drawings import slide_axis, slide_mid_formula
from kincourse.lecture_05_dh_standard.drawings import slide_offset
from kincourse.lecture_08_closed_chains.drawings import slide_linkage
from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE

WIDE = kl.linkages.four_bar(ground=0.5, crank=0.3, coupler=0.3, rocker=0.3)
ARM = kl.robots.mid_formula_arm()
TABLE = kl.assign_frames(kl.robots.youbot(), convention="standard").table


SLIDERS = {
    "axis": lambda: slide_axis(ARM, 3, np.radians([[a, 0, 0, 0] for a in (0, 30, 60)]), "degrees", [0, 30, 60]),
    "mid-formula": lambda: slide_mid_formula(ARM, [0.5, -0.3, 0.8, 0.4]),
    "offset": lambda: slide_offset(TABLE, 4, [0, 45, 90]),
    "linkage": lambda: slide_linkage(WIDE, WIDE.assembly_modes(hold={"A": 0.5}), "mode", [1, 2]),
}


def test_every_picture_of_a_slider_has_its_own_text(monkeypatch):
    monkeypatch.setenv(ENVIRONMENT_VARIABLE, "1")
    for make in SLIDERS.values():
        texts = [said["alt"] for said in make().texts]
        assert len(set(texts)) == len(texts) > 1
    page = SLIDERS["axis"]().html()
    assert "Axis 3 in {s}: (0.5, 0.866, 0, -0.346, 0.2, 0). In {b}: (0, 0, 1, 0, 0, 0)." in page
