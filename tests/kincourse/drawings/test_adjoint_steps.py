"""The picture of the three steps of the adjoint: its numbers are those of the adjoint, and it refuses what leaves the plane."""

import numpy as np
import pytest

from kincourse.lecture_04_poe_body.drawings import draw_adjoint_steps
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.rigid.lie import adjoint, exp, homogeneous, inverse
from kinlib.view.drawing.picture import vector_text

M = homogeneous(exp([0, 0, 0.5]), (2, 0.6, 0))
S = np.array([0, 0, 0.5, 0.9, 0.3, 0])


def test_the_last_step_ends_at_the_adjoint():
    other = homogeneous(exp([0, 0, -0.5]), (2, 0.6, 0))
    for twist, T in ((S, M), (2 * S, M), (S, other)):
        picture = draw_adjoint_steps(twist, T)
        assert picture.alt.endswith(f"axes of {{b}} are {vector_text((adjoint(inverse(T)) @ twist)[3:])}.")
        assert f"v = {vector_text(twist[3:])}" in picture.alt
        assert all(title in picture.svg for title in ("given in {s}", "(a), (b): at p", "(c): along {b}"))


def test_what_leaves_the_plane_is_refused():
    for twist, T in [
        ([0, 1, 0, 0, 0, 0], M),
        ([0, 0, 1, 0, 0, 2], M),
        (S, pose((X, Z, -Y), (1, 0, 0))),
        (S, pose((X, Y, Z), (0, 0, 1))),
    ]:
        with pytest.raises(ValueError, match="x-y plane"):
            draw_adjoint_steps(twist, T)
