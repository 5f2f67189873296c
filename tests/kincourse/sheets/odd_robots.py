"""Robots for the tests of robot sheets: common ones, and unusual ones for which some tasks make no sense."""

from dataclasses import replace

import numpy as np
from example_arms import arm as random_arm

import kinlib as kl
from kincourse.robot_sheets.robot_sheet import PROBLEMS_PER_SHEET, TASK_ORDER, robot_sheet
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose


def chain_of(joints, home, name, limits=None):
    chain = arm(joints, home, name, "made for a test")
    return replace(chain, name=name, limits=limits)


def seven_joints():
    """A robot like the KUKA iiwa: seven joints, neighbouring axes perpendicular, a spherical shoulder and a spherical wrist."""
    heights = (0.15, 0.34, 0.54, 0.74, 0.94, 1.14, 1.14)
    axes = (Z, Y, Z, -Y, Z, Y, Z)
    joints = [(axis, (0, 0, height)) for axis, height in zip(axes, heights, strict=True)]
    ends = np.radians([170, 120, 170, 120, 170, 120, 175])
    return chain_of(joints, pose((X, Y, Z), (0, 0, 1.266)), "seven", np.stack([-ends, ends], axis=1))


def scara():
    joints = [(Z, (0, 0, 0.4)), (Z, (0.3, 0, 0.4)), (Z, (0.55, 0, 0.4)), (-Z, (0.55, 0, 0.4), SLIDE)]
    limits = [[-2.5, 2.5], [-2.6, 2.6], [-np.inf, np.inf], [0, 0.2]]
    return chain_of(joints, pose((X, -Y, -Z), (0.55, 0, 0.35)), "SCARA", limits)


ODD_ROBOTS = {
    "PUMA": kl.robots.puma560(),
    "youBot": kl.robots.youbot(),
    "seven": seven_joints(),
    "ten": random_arm(np.random.default_rng(10), 10)[0],
    "SCARA": scara(),
    "one turn": chain_of([(Z, (0, 0, 0))], np.eye(4), "wheel"),
    "one turn, far": chain_of([(X, (0.2, 0.1, 0.4))], pose((Y, Z, X), (0.5, 0, 0.4)), "gate"),
    "one slide": chain_of([(Z, (0, 0, 0), SLIDE)], np.eye(4), "lift", [[0, 0.04]]),
    "two on one axis": chain_of([(Z, (0, 0, 0)), (Z, (0, 0, 0.3))], pose((X, Y, Z), (0, 0, 0.5)), "tower"),
    "turn and slide on one axis": chain_of([(Z, (0, 0, 0)), (Z, (0, 0, 0), SLIDE)], np.eye(4), "drill"),
    "all on one axis": chain_of([(Z, (0, 0, h)) for h in range(4)], pose((X, Y, Z), (0, 0, 4)), "pole"),
    "gantry": chain_of([(axis, (0, 0, 0), SLIDE) for axis in (X, Y, Z)], np.eye(4), "gantry"),
    "helical": kl.robots.hrr(),
    "planar": chain_of([(Z, (x, 0, 0)) for x in (0, 1, 2)], pose((X, Y, Z), (3, 0, 0)), "planar arm"),
    "tiny": chain_of([(Z, (0, 0, 0)), (Y, (0.01, 0, 0)), (X, (0.02, 0, 0))], pose((X, Y, Z), (0.03, 0, 0)), "tweezers"),
    "in millimetres": chain_of(
        [(Z, (0, 0, 400)), (Y, (0, 0, 700)), (Y, (0, 0, 1200))], pose((X, Y, Z), (500, 0, 1200)), "mm"
    ),
    "narrow": chain_of(
        [(Z, (0, 0, 0)), (Y, (0, 0, 0.3)), (X, (0.4, 0, 0.3), SLIDE)],
        pose((X, Y, Z), (0.6, 0, 0.3)),
        "narrow",
        [[-3.07, -2.9], [0.01, 0.02], [0.3, 0.3]],
    ),
}
"""The robots by what is unusual about them."""


def generated_sheets():
    """The sheets of two common robots, one of them read from a URDF. They must pass the same tests as the course's sheets."""
    puma = kl.load_urdf(kl.to_urdf(ODD_ROBOTS["PUMA"]))
    return [
        robot_sheet(name, robot, TASK_ORDER[:PROBLEMS_PER_SHEET])
        for name, robot in {"puma": puma, "seven": ODD_ROBOTS["seven"]}.items()
    ]
