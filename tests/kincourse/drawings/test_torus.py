"""The square of two angles: no curve is lost where it leaves the square, and a mark is where its angles are."""

import numpy as np
import pytest

from kincourse.lecture_08_closed_chains.drawings.torus import (
    draw_torus,
    side_by_side,
)
from kinlib import linkages
from kinlib.view import draw_linkage

LABELS = {"xlabel": "A", "ylabel": "D"}


def test_more_curves_than_line_styles_are_refused():
    with pytest.raises(ValueError, match="at most 3 entries, one per line style; got 4"):
        draw_torus({name: np.zeros((2, 2)) for name in "abcd"}, **LABELS)


def test_two_pictures_side_by_side_have_both_text_alternatives():
    one = draw_torus({"a": np.zeros((2, 2))}, **LABELS)
    two = side_by_side(one, draw_linkage(linkages.triangle(), [0, 0, 0]), "caption")
    assert one.alt in two.alt
    assert "triangle with the bodies" in two.alt
    assert two.svg.count("<svg ") == 3
    assert two.caption == "caption"
