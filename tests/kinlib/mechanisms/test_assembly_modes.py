"""Assembly modes of equations whose solutions are known: when the search ends, and which motions are no freedom of the bodies."""

import numpy as np
import pytest

from kinlib.mechanisms.closure import Closure


def test_a_motion_that_moves_no_body_is_no_degree_of_freedom():
    """As at a spherical joint two of whose axes coincide: only the sum of two angles matters."""
    ball = Closure(
        *(lambda x: (x.sum(1, keepdims=True) - 0.5, np.ones((len(x), 1, 2))), np.zeros(2), np.arange(2)),
        *(np.zeros(2, bool), np.ones(2), 1e-13),
    )
    assert len(ball.search_modes(poses=lambda q: q.sum(1, keepdims=True))) == 1
    with pytest.raises(ValueError, match=r"no degree of freedom may be left; 1 left"):
        ball.search_modes(poses=lambda q: q)
