"""The planar arm of lecture 00: what the reader drags, presses and answers, and whether picture and words tell the truth."""

import re

import numpy as np
import pytest
from browser import watched
from built_site import ROOT
from playwright.sync_api import expect

import kinlib as kl
from kincourse.lecture_00_start_here.planar_arm import HERE, SCENES, PlanarArm, joints


@pytest.fixture
def show(chromium_without_webgl, tmp_path):
    """Show the arms of some scenes on a page without a kernel."""

    def page_with(*scenes):
        parts = [f"<style>{PlanarArm._css}</style>", *(PlanarArm(scene).html() for scene in scenes)]
        files = (ROOT / "site" / "static" / "course.js", HERE / "planar_arm.js")
        scripts = "".join(f"<script>{file.read_text('utf-8')}</script>" for file in files)
        path = tmp_path / "page.html"
        head = '<!doctype html><html lang="en"><meta charset="utf-8"><title>Arm</title><link rel="icon" href="data:,">'
        path.write_text(f"{head}<body data-theme='dark'>{''.join(parts)}{scripts}</body></html>", "utf-8")
        page.goto(path.as_uri())
        return page

    with watched(chromium_without_webgl, viewport={"width": 390, "height": 844}, reduced_motion="reduce") as page:
        yield page_with


def words(page, text):
    """Wait until the picture in words contains a text, and return all of it."""
    shown = page.locator(".planar-arm details p").filter(has_text=text)
    shown.wait_for(state="attached")
    return shown.text_content()


def values(text):
    return [float(value.replace("−", "-")) for value in re.findall(r"q\d = (−?\d+)°", text)]


def test_the_tool_follows_the_hand_and_the_angles_follow_the_tool(show):
    page = show("drag")
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    tool = page.get_by_role("slider", name="Tool, moves in the plane")
    tool.focus()
    for _ in range(12):
        page.keyboard.press("Shift+ArrowRight")  # one metre
    text = words(page, "q2 = 0°")  # the arm is 5 m long, and cannot go farther
    tool_at = [float(x) for x in re.search(r"tool is at \(([^,]*), ([^)]*)\)", text).groups()]
    assert np.hypot(*tool_at) == pytest.approx(5, abs=0.01)
    np.testing.assert_allclose(joints(values(text), [3, 2])[-1], tool_at, atol=0.1)
    assert re.search(r"Joints after the first: \([^,]*, [^,]*\)\. ", text)


def test_what_the_reader_expected_is_shown_over_the_arm(show):
    page = show("drag")
    for name in ("Hide the arm", "Show the arm"):
        page.get_by_role("button", name=name).click()
    names = page.locator(".planar-arm svg text").all_text_contents()
    assert names.index("your cross") > names.index("tool"), "what is painted later covers the rest"


def test_a_link_turns_those_after_it_and_the_wrong_reference_is_drawn(show):
    page = show("reference")
    page.get_by_role("button", name="from the x axis").click()
    link = page.get_by_role("slider", name="Link 1, rotates about joint 1")
    link.focus()
    page.keyboard.press("Shift+ArrowUp")
    text = words(page, "q1 = 70°")
    lengths, q = SCENES["reference"][0], values(text)
    wrong = np.array(lengths) @ np.c_[np.cos(np.radians(q)), np.sin(np.radians(q))]  # each angle from the x axis
    places = [[float(x) for x in pair.replace("−", "-").split(", ")] for pair in re.findall(r"\(([^)]*)\)", text)]
    np.testing.assert_allclose(places[-1], wrong, atol=0.006)
    np.testing.assert_allclose(places[-2], joints(q, lengths)[-1], atol=0.006)
    page.get_by_role("button", name="from link 1").click()
    page.get_by_text("Right. Each joint rotates all links after it").wait_for()


@pytest.mark.parametrize("scene", ["pins", "space"])
def test_only_the_order_from_tool_to_base_leaves_the_arm_whole(show, scene):
    page = show(scene)
    q = np.radians(SCENES[scene][2])
    if scene == "pins":
        axes = [kl.screw((0, 0, 1), point=(x, 0, 0)) for x in (0, 3, 5)]
        home = [6, 0, 0, 1]
    else:
        axes = [kl.screw((0, 0, 1)), *(kl.screw((0, 1, 0), point=(x, 0, 1.8)) for x in (0, 2.4))]
        home = [4.2, 0, 1.8, 1]
    E = kl.exp(np.array(axes) * q[:, None])
    goal = (E[0] @ E[1] @ E[2] @ home)[:3]
    name = "pin" if scene == "pins" else "axis"

    def rotate(*order):
        page.get_by_role("button", name="Home").click()
        for i in order:
            page.get_by_role("button", name=f"{name} {i}:").click()

    rotate(3, 2, 1)
    shown = ", ".join(f"{x:.2f}".replace("-", "−") for x in (goal[:2] if scene == "pins" else goal))
    page.get_by_text(f"the tool is at its goal, ({shown}).").wait_for()
    rotate(3, 1, 2)
    links = "no longer meet" if scene == "pins" else "meet, but an axis had moved before the rotation about it"
    page.get_by_text(f"the links {links}, and the tool misses").wait_for()
    expect(page.locator(".tasks .done")).to_have_count(1 + (scene == "pins"))
    rotate(1, 2, 3)
    miss = np.linalg.norm((E[2] @ E[1] @ E[0] @ home)[:3] - goal)
    page.get_by_text(f"the tool misses its goal by {miss:.2f}.").wait_for()
    assert "The arm is broken after link" in words(page, "Rotated in the order 1, 2, 3")


def test_the_pen_writes_only_perpendicular_to_the_wall_and_what_was_done_is_kept(show):
    page = show("wall")
    heights = {"A": 3, "B": 1}
    for mark, y in heights.items():
        q2 = -np.degrees(np.arccos((9 + y * y - 13) / 12))  # two links of 3 and 2 to (3, y), elbow up
        q1 = np.degrees(np.arctan2(y, 3)) - np.degrees(
            np.arctan2(2 * np.sin(np.radians(q2)), 3 + 2 * np.cos(np.radians(q2)))
        )
        for slider, value in zip(page.locator("input[type=range]").all(), (q1, q2, 30 - q1 - q2), strict=True):
            slider.fill(str(round(value)))
        third = page.locator("input[type=range]").nth(2)
        third.fill(str(round(-q1 - q2)))
        page.get_by_text(f"Mark {mark} is touched.").wait_for()
        third.dispatch_event("change")  # the hand lets the slider go
    for _ in range(20):  # a browser may hand over what was stored only after the page has been left
        page.reload()
        page.locator(".tasks li").first.wait_for()
        if done := page.locator(".tasks .done").all_text_contents():
            break
    assert done == list(heights)
