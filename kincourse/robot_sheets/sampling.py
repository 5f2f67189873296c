"""Numbers of a student's own for a given robot: its base, its tool and its configuration.

Another base and another tool change every screw axis and every pose, and another zero configuration changes the angles of
a DH table. So each student has different numbers for the same robot.
"""

from dataclasses import replace

import numpy as np

from kincourse.sampling.arms import PLAIN_ANGLES_DEG, ArmSampler, shows_transposes
from kincourse.sampling.configurations import Configuration, configuration_from_typed
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import pose
from kinlib.rigid.lie import adjoint, exp, homogeneous

MIN_ROBOT_SIZE_M = 0.5
"""In metres. A smaller robot is placed in steps that suit this size, so that three printed decimals show the difference."""

MAX_JOINT_ANGLE_DEG = 75
"""In degrees. Revolute joints are drawn within this distance from zero if their limits allow it."""

MAX_DRAWS = 50
"""How many configurations are drawn to find one that differs from its reverse; a single joint has none."""


def step_size(chain: Chain) -> float:
    """The step in metres in which bases, tools and prismatic joints of a robot are drawn.

    It is the largest power of ten that is at most a fifth of the size of the robot at home.
    """
    points = np.concatenate([np.zeros((1, 3)), chain.joint_points, chain.home[None, :3, 3]])
    size = max(float(np.ptp(points, axis=0).max()), MIN_ROBOT_SIZE_M)
    return float(10.0 ** np.floor(np.log10(size / 5 * (1 + 1e-9))))


def random_aligned_base(sampler: ArmSampler, chain: Chain) -> Array:
    """Draw a pose of the base in {s}, (4, 4), with axes parallel to those of {s}, so that the robot's numbers stay simple."""
    return pose(sampler.axes(), (sampler.point(4) * step_size(chain)).round(9))


def random_tilted_base(sampler: ArmSampler, chain: Chain) -> Array:
    """Draw a pose of the base in {s}, (4, 4), rotated about one of its axes by an angle in PLAIN_ANGLES_DEG."""
    return random_aligned_base(sampler, chain) @ _random_rotation(sampler)


def random_tool(sampler: ArmSampler, chain: Chain) -> Array:
    """Draw a pose of the tool {b} in the flange frame, (4, 4): rotated, and translated along all three axes."""
    return homogeneous(np.eye(3), (sampler.point(4) * step_size(chain) / 2).round(9)) @ _random_rotation(sampler)


def rebased(chain: Chain, base: Array, tool: Array) -> Chain:
    """The robot with its base at the pose `base` in {s} and the pose `tool` on its flange: T'(q) = base T(q) tool."""
    points = chain.joint_points @ base[:3, :3].T + base[:3, 3]
    screws = chain.screws @ adjoint(base).T
    return replace(chain, screws=screws, home=base @ chain.home @ tool, points=points)


def random_arm(sampler: ArmSampler, chain: Chain) -> Chain:
    """Draw a base and a tool for a robot, so that the rotation of its home pose is not taken for its transpose."""
    while True:
        arm = rebased(chain, random_aligned_base(sampler, chain), random_tool(sampler, chain))
        if shows_transposes(arm):
            return arm


def with_zero_at(chain: Chain, q: Array) -> Chain:
    """The robot with q (n,) as its zero configuration: T'(x) = T(q + x)."""
    points = chain.link_poses(q)[:, :3, 3]
    limits = None if chain.limits is None else chain.limits - q[:, None]
    return replace(chain, screws=chain.jacobian(q).T, home=chain.fk(q), points=points, limits=limits)


def truncated(chain: Chain, joints: int) -> Chain:
    """The robot with its first joints only, and {b} at the point of the next joint, parallel to {s}."""
    if joints >= chain.n:
        return chain
    return replace(
        chain,
        screws=chain.screws[:joints],
        home=homogeneous(np.eye(3), chain.joint_points[joints]),
        points=chain.joint_points[:joints],
        limits=None if chain.limits is None else chain.limits[:joints],
        joint_names=chain.joint_names[:joints],
    )


def random_configuration(sampler: ArmSampler, chain: Chain, *, quarters: bool = False) -> Configuration:
    """Draw a configuration within the joint limits, in steps of 5 degrees and of half a `step_size` where the limits allow it.

    quarters  whether revolute joints are at quarter turns, so that axes along x, y and z still lie along x, y and z; otherwise
              the values are other ones in the reverse order, if the limits allow that
    """
    values: list[float] = []
    for _ in range(MAX_DRAWS):
        values = [_random_value(sampler, chain, i, quarters) for i in range(chain.n)]
        if quarters or values != values[::-1]:
            break
    return configuration_from_typed(chain, values)


def _random_value(sampler: ArmSampler, chain: Chain, joint: int, quarters: bool) -> float:
    low, high = _range(chain, joint)
    if chain.joint_types[joint] == "P":
        simple = [k * step_size(chain) / 2 for k in range(-8, 9) if k]
    elif quarters:
        simple = [-90.0, 0.0, 90.0, 180.0]
    else:
        simple = [5.0 * k for k in range(-MAX_JOINT_ANGLE_DEG // 5, MAX_JOINT_ANGLE_DEG // 5 + 1) if k]
    near = [value for value in simple if low <= value <= high]
    return float(round(sampler.choice(near), 9)) if near else _random_within(sampler, low, high)


def _range(chain: Chain, joint: int) -> tuple[float, float]:
    """The limits of a joint in degrees or metres."""
    low, high = (-np.inf, np.inf) if chain.limits is None else chain.limits[joint]
    low, high = (low, high) if chain.joint_types[joint] == "P" else (np.degrees(low), np.degrees(high))
    return float(low), float(high)


def _random_within(sampler: ArmSampler, low: float, high: float) -> float:
    """Draw a value between limits that contain no simple one: some tenths of the way, with three digits if that is inside."""
    low, high = max(low, high - 1e3), min(high, low + 1e3)
    value = low + (high - low) * sampler.integer(3, 7) / 10
    plain = float(f"{value:.3g}")
    return plain if low <= plain <= high else value


def _random_rotation(sampler: ArmSampler) -> Array:
    axis = np.eye(3)[sampler.integer(0, 2)]
    return exp(
        np.radians(sampler.choice(PLAIN_ANGLES_DEG) * sampler.choice((-1, 1))) * np.concatenate([axis, np.zeros(3)])
    )
