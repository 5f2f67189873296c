"""The velocity of a point of a rotating body: the text alternative has the numbers of what is drawn."""

import re

import numpy as np
import pytest

from kinlib.view import draw_moment, draw_point_velocity

CASES = [((0, 0, 1), (2, 0, 1)), ((0, -1, 0), (-4, -2, 0)), ((0.6, 0, 0.8), (1, 2, 3))]


def vectors(alt, name):
    found = re.search(rf"{re.escape(name)} = \(([^)]*)\)", alt)
    return [float(entry) for entry in found[1].split(", ")]


@pytest.mark.parametrize(("omega", "p"), CASES)
def test_the_velocity_of_a_point_and_of_the_origin_is_the_cross_product(omega, p):
    point, origin = draw_point_velocity(omega, p).alt, draw_moment(omega, p).alt
    np.testing.assert_allclose(vectors(point, "omega x p"), np.cross(omega, p), rtol=5e-3, atol=1e-12)
    np.testing.assert_allclose(vectors(point, "omega"), omega)
    np.testing.assert_allclose(vectors(origin, "v = -omega x p"), np.cross(p, omega), rtol=5e-3, atol=1e-12)
    for alt in (point, origin):
        radius = float(re.search(r"radius ([\d.]+)", alt)[1])
        np.testing.assert_allclose(radius, np.linalg.norm(np.cross(omega, p)), rtol=5e-3)


def test_an_axis_through_the_point_is_refused():
    with pytest.raises(ValueError, match="must have a radius"):
        draw_moment((0, 0, 1), (0, 0, 3))
    with pytest.raises(ValueError, match="must have a radius"):
        draw_point_velocity((0, 0, 1), (0, 0, 3))
