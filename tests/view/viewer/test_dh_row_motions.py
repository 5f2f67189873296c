"""Drawings of DH rows as motions: both conventions end at their matrices, and share the product Z_1 X_1 Z_2 X_2 ..."""

import numpy as np
import pytest

import kinlib as kl
from kinlib.view.figures.dh_row_motions import draw_row_motions, draw_zx_factors, poses_along_arm, poses_along_row

ROWS = np.random.default_rng(6).uniform(-1, 1, (3, 4))


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_each_motion_is_about_or_along_the_frame_s_own_x_or_z(convention):
    stops = poses_along_row(ROWS[0], convention)
    steps = kl.inverse(stops[:-1]) @ stops[1:]
    used = [np.flatnonzero(np.abs(kl.log(step)) > 1e-12).tolist() for step in steps]
    turn_x, turn_z, slide_x, slide_z = [0], [2], [3], [5]
    standard = [turn_z, slide_z, slide_x, turn_x]
    assert used == (standard if convention == "standard" else [turn_x, slide_x, turn_z, slide_z])


def test_the_start_is_drawn_before_any_motion():
    assert "no motion yet" in draw_row_motions(ROWS[0], 0).alt
    assert "before its first factor" in draw_zx_factors(ROWS, 0).alt


def test_another_number_of_motions_and_an_unknown_convention_are_refused():
    for wrong in (-1, 5, 1.5, None):
        with pytest.raises(ValueError, match="done must be the number of motions carried out, 0 to 4"):
            draw_row_motions(ROWS[0], wrong)
        with pytest.raises(ValueError, match="factors must be the number of factors"):
            draw_zx_factors(ROWS[:2], wrong)
    with pytest.raises(ValueError, match="convention must be"):
        poses_along_row(ROWS[0], "craig")


@pytest.mark.oracle("spatialmath", poses_along_row, poses_along_arm)
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_each_pose_is_the_product_of_spatialmath_s_rotations_and_translations(convention):
    SE3 = pytest.importorskip("spatialmath").SE3
    for a, alpha, d, theta in ROWS:
        about_x, about_z = [SE3.Rx(alpha), SE3.Tx(a)], [SE3.Rz(theta), SE3.Tz(d)]
        steps = [*about_z, *about_x[::-1]] if convention == "standard" else [*about_x, *about_z]
        stops = [np.eye(4)]
        for step in steps:
            stops.append(stops[-1] @ step.A)
        np.testing.assert_allclose(poses_along_row([a, alpha, d, theta], convention), stops, atol=1e-14)
    stops = [np.eye(4)]
    for a, alpha, d, theta in ROWS:
        stops += [stops[-1] @ (SE3.Rz(theta) * SE3.Tz(d)).A]
        stops += [stops[-1] @ (SE3.Tx(a) * SE3.Rx(alpha)).A]
    np.testing.assert_allclose(poses_along_arm(ROWS), stops, atol=1e-14)
