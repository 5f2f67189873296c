"""The picture of the three steps of the adjoint: its numbers are those of the adjoint."""

import numpy as np

from kincourse.lecture_04_poe_body.drawings import draw_adjoint_steps
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
