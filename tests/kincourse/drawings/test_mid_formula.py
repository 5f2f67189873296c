"""The drawing of the mid-formula form: each perpendicular is as long as the moment of its screw."""

import numpy as np

from kincourse.lecture_04_poe_body.drawings.mid_formula import axis_perpendiculars
from kinlib import robots

ARMS = [robots.rpr(), robots.rppr(), robots.youbot(), robots.puma560(), robots.mid_formula_arm(), robots.angled_arm()]


def test_a_perpendicular_is_as_long_as_the_moment_of_its_screw():
    """|v| of a revolute joint is the distance of its axis from the origin of the frame in which the screw is given."""
    for chain in ARMS:
        turns = chain.screws[:, :3].any(axis=-1)
        for k in range(chain.n + 1):
            ends = axis_perpendiculars(chain, k)
            across = ends[:, 1] - ends[:, 0]
            read = np.concatenate([chain.screws[:k], chain.body_screws[k:]])
            far = np.linalg.norm(across, axis=-1)
            np.testing.assert_allclose(far[turns], np.linalg.norm(read[turns, 3:], axis=-1), atol=1e-12)
            np.testing.assert_allclose(np.sum(across * chain.screws[:, :3], axis=-1), 0, atol=1e-12)
            assert not far[~turns].any()
