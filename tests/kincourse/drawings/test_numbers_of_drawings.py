"""The drawings of the lectures: their numbers are those of the library, of SciPy and mpmath, and of finite differences."""

from itertools import product

import mpmath
import mpmath_oracle
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from strategies import points, screws

from kincourse.lecture_01_frames.drawings import draw_rotation
from kincourse.lecture_02_matrix_exponential.drawings import draw_series
from kincourse.lecture_02_matrix_exponential.drawings.exponential_series import partial_sums
from kincourse.lecture_04_poe_body.drawings import draw_adjoint_steps
from kincourse.lecture_04_poe_body.drawings.mid_formula import axis_perpendiculars
from kincourse.lecture_04b_velocity.drawings import tool_velocities
from kincourse.lecture_06b_puma.drawings import rotation_axes
from kincourse.lecture_07_frame_assignment.drawings import draw_nearly_parallel_axes
from kincourse.lecture_09_urdf.drawings import draw_urdf_joint
from kincourse.sampling.linkages import FourBar
from kinlib import robots
from kinlib.dh.common_normal import common_normal
from kinlib.mechanisms import linkages
from kinlib.rigid.lie import adjoint, exp, homogeneous, inverse
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.canvas import view_axes
from kinlib.view.drawing.figure_colours import ORANGE
from kinlib.view.drawing.picture import vector_text

X, Y, Z = np.eye(3)


def test_01_the_text_gives_the_rotation_that_scipy_computes_and_where_the_axis_points():
    """The sign of the sine says whether the first axis rotates towards the second or away from it."""
    for (axis, view), degrees in product(enumerate(("side", "front", "top")), (35, -70)):
        words = draw_rotation(axis, degrees).alt
        first, second = "xyz"[(axis + 1) % 3], "xyz"[(axis + 2) % 3]
        turned = Rotation.from_rotvec(np.radians(degrees) * np.eye(3)[axis]).as_matrix()
        sign = "" if turned["xyz".index(second), "xyz".index(first)] > 0 else "-"
        assert f"{first}_b is {first}_a rotated by {abs(degrees)} degrees towards {sign}{second}_a" in words
        assert f"points {'at' if view_axes(view)[0][axis] > 0 else 'away from'} you" in words


def test_02_four_terms_are_on_the_circle_at_the_root_of_three_and_not_at_the_goal():
    """|1 + i t - t^2/2 - i t^3/6| = 1 at t = sqrt(3), so the sum is a rotation, but the wrong one."""
    picture = draw_series((0, 0, 1, 0, 0, 0), np.sqrt(3), (1, 0, 0), 4)
    assert picture.caption == "4 terms: the sum is 0.36 m from its goal, less than 1e-12 m off the circle"


@given(screws(), st.floats(-3, 3), points())
def test_02_each_sum_is_a_sum_of_powers_with_40_digits(S, q, point):
    with mpmath.workdps(mpmath_oracle.DIGITS):
        step = mpmath_oracle.hat(mpmath_oracle.numbers(S)) * mpmath.mpf(q)
        start = mpmath.matrix([*mpmath_oracle.numbers(point), 1])
        sums, total = [], mpmath.zeros(4)
        for k in range(6):
            total += step**k / mpmath.factorial(k)
            sums.append(mpmath_oracle.doubles((total * start).T)[0, :3])
    np.testing.assert_allclose(partial_sums(S, q, point, 6), sums, rtol=0, atol=1e-12)


def test_04_the_last_step_ends_at_the_adjoint():
    S = np.array([0, 0, 0.5, 0.9, 0.3, 0])
    for twist, angle in ((S, 0.5), (2 * S, 0.5), (S, -0.5)):
        T = homogeneous(exp([0, 0, angle]), (2, 0.6, 0))
        picture = draw_adjoint_steps(twist, T)
        assert picture.alt.endswith(f"axes of {{b}} are {vector_text((adjoint(inverse(T)) @ twist)[3:])}.")
        assert f"v = {vector_text(twist[3:])}" in picture.alt
        assert all(title in picture.svg for title in ("given in {s}", "(a), (b): at p", "(c): along {b}"))


def test_04_a_perpendicular_is_as_long_as_the_moment_of_its_screw():
    """|v| of a revolute joint is the distance of its axis from the origin of the frame in which the screw is given."""
    for chain in (robots.rppr(), robots.puma560(), robots.mid_formula_arm()):
        turns = chain.screws[:, :3].any(axis=-1)
        for k in range(chain.n + 1):
            ends = axis_perpendiculars(chain, k)
            across = ends[:, 1] - ends[:, 0]
            read = np.concatenate([chain.screws[:k], chain.body_screws[k:]])
            far = np.linalg.norm(across, axis=-1)
            np.testing.assert_allclose(far[turns], np.linalg.norm(read[turns, 3:], axis=-1), atol=1e-12)
            np.testing.assert_allclose(np.sum(across * chain.screws[:, :3], axis=-1), 0, atol=1e-12)
            assert not far[~turns].any()


def test_04b_the_velocities_are_those_of_the_moving_tool():
    for chain in (robots.youbot(), robots.rpr()):
        q, step = np.random.default_rng(1).uniform(-1, 1, chain.n), 1e-6
        moved = [(chain.fk(q + step * e)[:3, 3] - chain.fk(q - step * e)[:3, 3]) / (2 * step) for e in np.eye(chain.n)]
        assert np.allclose(tool_velocities(chain, q), moved, atol=1e-8)


def test_06b_a_change_of_one_angle_rotates_about_its_axis():
    angles, step = np.array([0.4, -0.7, 1.1]), 1e-6

    def rotation(order, angles):
        units = np.eye(3)[["xyz".index(letter) for letter in order]]
        return np.linalg.multi_dot([exp(angle * unit) for unit, angle in zip(units, angles, strict=True)])

    for order in ("zyz", "zyx"):
        for k, axis in enumerate(rotation_axes(order, angles)):
            moved = rotation(order, angles + step * np.eye(3)[k])
            assert np.allclose(moved, exp(step * axis) @ rotation(order, angles), atol=1e-10)


def test_07_the_height_of_the_normal_is_that_of_the_common_normal():
    for degrees in (30, 9, 2, 0.1):
        angle = np.radians(degrees)
        tilted = Z * np.cos(angle) - Y * np.sin(angle)
        normal = common_normal((Z, 0 * Z), (tilted, 0.5 * Y + 0.2 * X), X, at_other_point=True)
        picture = draw_nearly_parallel_axes(degrees)
        assert f"{normal.start[2]:.3g} m above the floor" in picture.alt
        assert ("inside the picture" in picture.alt) == (f'r="6" fill="{ORANGE}"' in picture.svg)
    assert "at every height" in draw_nearly_parallel_axes(0).alt


def test_08_a_four_bar_closes_in_the_mode_with_C_to_the_left():
    four_bar = FourBar(0.4, 0.1, 0.35, 0.3)
    q = four_bar.closed_at(0.7)
    assert np.allclose(linkages.four_bar(*four_bar).residual(q), 0, atol=1e-12)
    assert np.sin(q[3]) < 0


def test_09_the_text_alternative_gives_the_axis_in_both_frames():
    lean = origin((0.3, 0.2, 0.4), (-np.pi / 2, 0, 0))
    for q in (0.6, 0.7):
        alt = draw_urdf_joint(lean, (0, 0, 1), q, ("post", "rod")).alt
        assert "The axis (0, 0, 1) of the joint frame has the direction (0, 1, 0) in {post}" in alt
        assert f"its x along {vector_text([np.cos(q), 0, -np.sin(q)])}." in alt
