"""Robots for the tests of robot sheets: common ones, and unusual ones for which some tasks make no sense."""

from dataclasses import replace

import numpy as np
from example_arms import arm as random_arm

import kinlib as kl
from kincourse.robot_sheets.robot_sheet import robot_sheet
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose


def chain_of(joints, home, name, limits=None):
    chain = arm(joints, home, name, "made for a test")
    return replace(chain, name=name, limits=limits)


ENDS_OF_SCARA = [[-2.5, 2.5], [-2.6, 2.6], [0, 0.2], [-np.inf, np.inf]]

ODD_ROBOTS = {
    "PUMA": kl.robots.puma560(),
    "eight": random_arm(np.random.default_rng(10), 8)[0],
    "SCARA": replace(kl.robots.scara(), limits=ENDS_OF_SCARA),
    "one turn": chain_of([(Z, (0, 0, 0))], np.eye(4), "wheel"),
    "one slide": chain_of([(Z, (0, 0, 0), SLIDE)], np.eye(4), "lift", [[0, 0.04]]),
    "turn and slide on one axis": chain_of([(Z, (0, 0, 0)), (Z, (0, 0, 0), SLIDE)], np.eye(4), "drill"),
    "all on one axis": chain_of([(Z, (0, 0, h)) for h in range(3)], pose((X, Y, Z), (0, 0, 4)), "pole"),
    "gantry": chain_of([(axis, (0, 0, 0), SLIDE) for axis in (X, Y, Z)], np.eye(4), "gantry"),
    "helical": kl.robots.hrr(),
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


def generated_sheet():
    """The sheet of a common robot that was read from a URDF. It must pass the same tests as the course's sheets."""
    puma = kl.load_urdf(kl.to_urdf(ODD_ROBOTS["PUMA"]))
    return robot_sheet("puma", puma)
