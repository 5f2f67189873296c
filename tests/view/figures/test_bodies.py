"""Bodies of arms: known robots have theirs, any arm gets one that stands on the floor, and what is nearer is drawn later."""

import re

import numpy as np
import pytest
from hypothesis import example, given
from strategies import ROBOTS, chains

import kinlib as kl
from kinlib.view import draw_arm, explore
from kinlib.view.drawing.figure_colours import SHADES
from kinlib.view.figures.bodies import body_of, rim_points, solid_data

X, Y, Z = np.eye(3)
SLIDE = np.inf
WRIST = (0, 0.15, 0.7)
STANFORD = [(Z, (0, 0, 0)), (Y, (0, 0, 0.4)), (Z, (0, 0.15, 0.4), SLIDE), (Z, WRIST), (Y, WRIST), (Z, WRIST)]
IIWA = [
    *((Z, (0, 0, 0)), (Y, (0, 0, 0.34)), (Z, (0, 0, 0.34)), (-Y, (0, 0, 0.74)), (Z, (0, 0, 0.74))),
    *((Y, (0, 0, 1.14)), (Z, (0, 0, 1.14))),
]
KNOWN = {
    "KUKA youBot": kl.robots.youbot(),
    "Corke": kl.robots.puma560(),
    "Universal Robots": kl.robots.ur5e(),
    "Franka Emika": kl.robots.panda(),
    "Adept Cobra 600": kl.robots.scara(),
    "Paul": kl.robots.arm(STANFORD, kl.robots.pose((X, Y, Z), (0, 0.15, 0.9))),
    "KUKA, LBR iiwa": kl.robots.arm(IIWA, kl.robots.pose((X, Y, Z), (0, 0, 1.266))),
}


@pytest.mark.parametrize("maker", KNOWN)
def test_a_known_robot_has_its_body_and_says_whose_the_sizes_are(maker):
    chain = KNOWN[maker]
    body = body_of(chain)
    assert maker in body.source
    assert "ours" in body.source
    assert explore(chain).scene["arms"][0]["body"] == solid_data(body.links)  # the page draws the same
    # the same arm from a file, and another one whose second axis is a centimetre farther away
    assert body_of(kl.load_urdf(kl.to_urdf(chain))).source == body.source
    longer = chain.screws.copy()
    longer[1, 3:] += 0.01 * np.cross(longer[1, :3], X if abs(longer[1, 0]) < 0.5 else Z)
    assert body_of(kl.Chain(longer, chain.home)).source.startswith("By rule")


ARMS = {robot.name: robot for robot in ROBOTS} | {name: KNOWN[name] for name in ("Paul", "KUKA, LBR iiwa")}


@pytest.mark.parametrize("chain", ARMS.values(), ids=ARMS)
def test_both_links_of_a_joint_are_at_its_axis_and_the_base_stands_on_the_floor(chain):
    body = body_of(chain)
    assert len(body.links) == chain.n + 1
    points = [np.concatenate([rim_points(solid, Y) for solid in link]) for link in body.links]
    reach = np.linalg.norm(np.diff([*chain.joint_points, chain.home[:3, 3]], axis=0), axis=1).sum()
    for i, (axis, point) in enumerate(zip(chain.lines.axis, chain.joint_points, strict=True)):
        for link in (points[i], points[i + 1]):
            assert np.linalg.norm(np.cross(axis, link - point), axis=-1).min() < 0.2 * reach
    assert body.lowest == pytest.approx(points[0][:, 2].min())
    by_rule = body.source.startswith("By rule")  # a known robot is bolted to a table, and may reach below it
    assert not by_rule or body.lowest <= min(link[:, 2].min() for link in points)
    assert chain.limits is None or bool(chain.within_limits(body.pose).all())


@given(chains())
@example(kl.Chain([[1, 0, 0, 1, 1e-19, 0]], np.eye(4)))  # its axis all but meets the tool
def test_any_arm_is_drawn_as_a_machine(chain):
    body = body_of(chain)
    assert all(body.links)
    svg = draw_arm(chain, body.pose).svg
    assert "nan" not in svg
    assert set(re.findall(r'(?:fill|stop-color)="(#[0-9a-f]{6})"', svg)) & set(SHADES)


SHOWN = """<robot name="crane">
  <link name="base"><visual><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.2" length="0.2"/></geometry></visual></link>
  <link name="boom"><visual><origin xyz="0.5 0 0"/><geometry><box size="1 0.1 0.2"/></geometry></visual>
    <visual><geometry><mesh filename="file:///etc/passwd"/></geometry></visual></link>
  <link name="post"><visual><geometry><box size="0.1 0.1 1"/></geometry><material><color rgba="1 0 0 1"/></material></visual></link>
  <joint name="bolt" type="fixed"><parent link="base"/><child link="post"/></joint>
  <link name="hook"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="boom"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="hang" type="fixed"><parent link="boom"/><child link="hook"/><origin xyz="1 0 0"/></joint>
</robot>"""


def test_a_tree_shows_the_boxes_cylinders_and_spheres_of_its_file_and_opens_no_other():
    tree = kl.Tree.from_urdf(SHOWN)
    (arm,) = explore(tree).scene["arms"]
    base, boom = arm["body"]
    assert [(solid["kind"], solid["colour"]) for solid in base] == [("drum", "body"), ("box", "#ff0000")]
    assert [solid["kind"] for solid in boom] == ["box", "tube"]  # the hook is fixed to the boom
    assert boom[0]["points"] == [[0.5, 0, 0.3]]
    assert boom[0]["sizes"] == [0.5, 0.05, 0.1]
    np.testing.assert_allclose(boom[1]["points"][0], [1, 0, 0.3], atol=1e-4)
    assert "nan" not in explore(tree, start=[0.5]).picture().svg
