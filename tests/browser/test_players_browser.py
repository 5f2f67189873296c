"""The players and the placing of frames in a real browser: by mouse, touch and keys. test_jupyterlab.py has them in a lab."""

from contextlib import ExitStack

import numpy as np
import pytest
from browser import (
    TIMEOUT_MS,
    contrast,
    overflowing,
    static_page,
    text_colours,
    wait_until_drawn,
    watched,
)

import kinlib as kl
from kincourse import open_sheet
from kincourse.lecture_01_frames.opening import opening
from kinlib.chains.robots import pose
from kinlib.dh.rules import check_frames
from kinlib.view import assign, explore, play_assignment, play_row

ARM = open_sheet("07_frame_assignment", "ada").problem(2).shown["arm"]
RIGHT = kl.assign_frames(ARM, convention="standard").frames
ROW = [0.8, 0.6, 0.6, 1.4]
DIAL = 0.3
"""The radius of the dial for x, as a share of the size of the arm."""

MODEL = "document.querySelector('.kv').viewer.model"
STAGE = "document.querySelector('.kv').viewer.stage"


@pytest.fixture
def show(chromium, tmp_path):
    """Show a viewer on a page without a kernel."""
    with ExitStack() as opened:

        def open_page(viewer, style="background:white", **settings):
            settings = {"viewport": {"width": 1000, "height": 620}, **settings}
            page = opened.enter_context(watched(chromium, **settings))
            page.goto(static_page(tmp_path, viewer, style=style).as_uri())
            page.locator(".kv").wait_for()
            if page.locator(".kv-canvas").count():
                wait_until_drawn(page)
            return page

        yield open_page


def at(viewer, **traits):
    """Set traits of a viewer, as a reader or Python would."""
    for name, value in traits.items():
        setattr(viewer, name, value)
    return viewer


def get(page, trait):
    return page.evaluate(f"{MODEL}.get('{trait}')")


def wait_for(page, trait, value):
    page.wait_for_function(f"{MODEL}.get('{trait}') === {value}", timeout=TIMEOUT_MS)


def drawn(page):
    """Paint the picture again, and return the labels in it."""
    page.evaluate(f"{STAGE}.paint()")
    return {box["name"] for box in page.evaluate(f"{STAGE}.names")}


def pixel(page, x, y):
    return page.evaluate(
        "([x, y]) => [...document.querySelector('.kv-canvas').getContext('2d').getImageData(x, y, 1, 1).data].slice(0, 3)",
        [round(x), round(y)],
    )


def place_of(page, point):
    """Return where a point of space is on the page, in pixels."""
    return page.evaluate(
        f"""point => {{ const {{ camera, canvas }} = {STAGE}; const {{ left, top }} = canvas.getBoundingClientRect();
            const {{ x, y }} = camera.project(camera.target.clone().set(...point)); return [x + left, y + top]; }}""",
        [float(value) for value in point],
    )


# --- the players of steps ---


def test_buttons_and_keys_go_to_the_next_and_the_previous_stop(show):
    player = play_assignment(kl.robots.youbot(), convention="standard")
    last = len(player.stops) - 1
    page = show(player)
    following, back = page.get_by_role("button", name="Next step"), page.get_by_role("button", name="One step back")
    for expected in (1, 2, 3):
        following.click()
        assert get(page, "at") == expected
    page.keyboard.press("ArrowRight")  # the button has the focus
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowLeft")
    assert get(page, "at") == 4
    back.click()
    assert get(page, "at") == 3
    assert page.locator(".kv-step").inner_text().startswith("Origin O")
    said = page.locator(".kv-step p").nth(1).text_content()
    assert said == player.stops[3]["texts"][0].replace("O_1", "O1")
    assert {"z1"} == {name for name in drawn(page) if name in {"z1", "x1", "y1", "normal 1–2"}}
    box = page.locator(".kv-canvas").bounding_box()
    x, y = place_of(page, (0.033, 0, 0.147))  # O_1, which is highlighted
    red, green, blue = pixel(page, x - box["x"] + 11, y - box["y"] + 3)
    assert blue < min(red, green) - 20, "yellow"
    page.keyboard.press("End")
    assert get(page, "at") == last
    page.keyboard.press("ArrowRight")  # this was the last step
    assert get(page, "at") == last
    assert following.get_attribute("aria-disabled") == "true"
    page.keyboard.press("Home")
    assert get(page, "at") == 0


def test_the_convention_can_be_switched_and_the_table_is_filled(show):
    player = play_assignment(kl.robots.youbot(), convention="standard")
    page = show(player)
    rows = page.locator(".kv-dh tr")
    first = next(k for k, stop in enumerate(player.stops) if stop["row"])
    page.evaluate(f"{MODEL}.set('at', {first})")
    assert rows.nth(1).inner_text().split() == ["1", "0.033", "90°", "0.147", "q1"]
    assert rows.nth(2).inner_text().split() == ["2", "·", "·", "·", "·"]
    page.get_by_label("Convention", exact=True).select_option("modified")
    assert get(page, "variant") == "modified"
    assert rows.nth(1).inner_text().split() == ["1", "0", "0", "0", "q1"]


def carried(page, track):
    """Return the pose of the moving frame of a track."""
    elements = page.evaluate(f"{STAGE}.tree.arms[{track}].tool.matrixWorld.elements")
    return np.reshape(elements, (4, 4)).T


def test_the_motions_move_the_frame_to_the_row_s_matrix_in_both_conventions(show):
    player = play_row(ROW)
    page = show(player, reduced_motion="reduce")
    starts = [np.reshape(arm["home"], (4, 4)) for arm in player.scene["arms"]]
    following = page.get_by_role("button", name="Next motion")
    for _ in range(4):
        following.click()
    assert get(page, "at") == 4
    for k, convention in enumerate(["standard", "modified"]):
        expected = starts[k] @ kl.dh_transform(*ROW, convention=convention)
        np.testing.assert_allclose(carried(page, k), expected, atol=1e-12)
    page.get_by_role("button", name="One motion back").click()
    expected = starts[0] @ kl.dh_transform(0.8, 0, 0.6, 1.4, convention="standard")
    np.testing.assert_allclose(carried(page, 0), expected, atol=1e-12)
    assert "along the common normal" in page.locator(".kv-motion-text").first.inner_text()


def test_a_motion_is_animated_unless_reduced_motion_is_preferred(show):
    page = show(at(play_row(ROW, convention="standard"), at=3))
    seen = f"window.seen = new Set(); {MODEL}.on('change:at', () => window.seen.add({MODEL}.get('at')))"
    page.evaluate(seen)
    page.get_by_role("button", name="Play").click()
    wait_for(page, "at", 4)
    assert page.evaluate("window.seen.size") > 2
    calm = show(at(play_row(ROW, convention="standard"), at=3), reduced_motion="reduce")
    calm.evaluate(seen)
    calm.get_by_role("button", name="Next motion").click()
    assert calm.evaluate("[...window.seen]") == [4]


# --- films ---


def test_a_film_is_played_paused_and_leafed_through_and_its_text_follows(show):
    shown = opening()
    page = show(shown)
    play, picture = page.get_by_role("button", name="Play"), page.locator(".kv-film-picture")
    assert get(page, "at") == 0
    play.click()
    page.wait_for_function(f"{MODEL}.get('at') > 1", timeout=TIMEOUT_MS)
    page.get_by_role("button", name="Pause").click()
    stopped = get(page, "at")
    page.wait_for_timeout(500)
    assert get(page, "at") == stopped
    page.get_by_label("Time").press("End")
    assert picture.get_attribute("aria-label") == shown.texts[-1]["alt"]
    assert picture.locator("img:visible").count() == 1


# --- frames by hand ---


def frames_of(page):
    return np.array(get(page, "frames"), dtype=float)


def handle(hand, T, axis):
    """Return the handle with which a frame gets its z: an end of an axis."""
    fits = [z for z in hand.mode["z"] if np.allclose(z["along"], T[:3, 2])]
    return next((z["at"] for z in fits if z["axis"] == axis), fits[0]["at"])


def click(page, point, off=(0, 0)):
    x, y = place_of(page, point)
    page.mouse.click(x + off[0], y + off[1])


def test_frames_are_placed_by_mouse_and_snap_to_candidates(show):
    """Every click is some pixels away from its candidate, but the frames are exact."""
    hand = assign(ARM, "standard")
    page = show(hand)
    dial = DIAL * hand.scene["size"]
    for i, T in enumerate(RIGHT):
        click(page, handle(hand, T, i), off=(3, -2))
        click(page, T[:3, 3], off=(-2, 2))
        click(page, T[:3, 3] + dial * T[:3, 0], off=(3, 3))
    np.testing.assert_allclose(frames_of(page), RIGHT, rtol=0, atol=1e-12)
    assert page.get_by_role("button", name="Frame 3, placed").is_visible()


def test_frames_are_placed_by_touch(show):
    hand = assign(ARM, "standard")
    page = show(hand, has_touch=True, viewport={"width": 400, "height": 800})
    for point in (handle(hand, RIGHT[0], 0), RIGHT[0, :3, 3]):
        x, y = place_of(page, point)
        page.touchscreen.tap(x + 1, y + 1)  # in this small picture other candidates are near
    np.testing.assert_allclose(frames_of(page)[0][:3, 2:], RIGHT[0, :3, 2:], atol=1e-12)


def test_an_origin_is_dragged_along_its_axis_and_x_around_its_dial(show):
    frames = np.array(assign(ARM, "standard").frames)
    frames[1] = RIGHT[1]
    hand = at(assign(ARM, "standard"), frames=frames)
    page = show(hand)
    page.get_by_role("button", name="Frame 1, placed").click()
    page.get_by_role("button", name="Place O 1 in the picture").click()
    camera = f"{STAGE}.camera.azimuth"
    before = page.evaluate(camera)
    z, origin, dial = RIGHT[1, :3, 2], RIGHT[1, :3, 3], DIAL * hand.scene["size"]

    def drag(start, end):
        page.mouse.move(*place_of(page, start))
        page.mouse.down()
        page.mouse.move(*place_of(page, end), steps=3)
        page.mouse.up()

    drag(origin, origin + 0.9 * z)
    moved = frames_of(page)[1]
    along = (moved[:3, 3] - origin) @ z
    assert 0.5 < along < 1.3
    np.testing.assert_allclose(moved[:3, 3], origin + along * z, atol=1e-12)  # on its axis, except for rounding errors
    page.get_by_role("button", name="Place x 1 in the picture").click()
    x, y = moved[:3, 0], moved[:3, 1]
    drag(moved[:3, 3] + dial * x, moved[:3, 3] + dial * (0.08 * x + 0.99 * y))
    np.testing.assert_allclose(frames_of(page)[1][:3, 0], y, atol=1e-12)  # it has snapped to y
    turned = frames_of(page)[1][:3, :3]
    np.testing.assert_allclose(turned.T @ turned, np.eye(3), atol=1e-12)
    assert page.evaluate(camera) == before, "the camera must not move during a drag"
    page.get_by_role("button", name="Undo the last change").click()
    np.testing.assert_allclose(frames_of(page)[1], moved)


def choose(page, label, wanted):
    """Choose from a list with the arrow keys only."""
    select = page.get_by_label(label, exact=True)
    select.focus()
    for _ in range(60):
        options = select.locator("option").evaluate_all("all => all.map((option) => JSON.parse(option.value))")
        there = next(k for k, value in enumerate(options) if value and np.allclose(value, wanted))
        here = select.evaluate("node => node.selectedIndex")
        if here == there:
            return
        page.keyboard.press("ArrowDown" if there > here else "ArrowUp")
    raise AssertionError(f"{label} does not reach {wanted}")


def test_frames_are_placed_with_keys_only(show):
    page = show(assign(ARM, "standard"))
    page.get_by_role("button", name="Frame 0, not started").focus()
    for i, T in enumerate(RIGHT):
        choose(page, f"Direction of z {i}", T[:3, 2])
        choose(page, f"Origin of frame {i}", T[:3, 3])
        choose(page, f"Direction of x {i}", T[:3, 0])
        page.get_by_role("button", name=f"Frame {i}, placed").focus()
        if i < len(RIGHT) - 1:
            page.keyboard.press("ArrowRight")
    np.testing.assert_allclose(frames_of(page), RIGHT, rtol=0, atol=1e-12)
    for button in ("Move the origin by 0", "Rotate x by 15 degrees about z"):
        page.get_by_role("button", name=button).first.press("Enter")
    changed = frames_of(page)[3]
    np.testing.assert_allclose(changed[:3, 0] @ RIGHT[3, :3, 0], np.cos(np.radians(15)), atol=1e-12)
    np.testing.assert_allclose(np.cross(changed[:3, 3] - RIGHT[3, :3, 3], RIGHT[3, :3, 2]), 0, atol=1e-12)


def test_without_python_the_frames_can_be_copied_and_a_message_says_how_to_check_them(show):
    page = show(at(assign(ARM, "standard"), frames=RIGHT), permissions=["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Check the rules").click()
    assert "Checking needs Python, and this page has none." in page.locator(".kv-verdict").inner_text()
    page.get_by_role("button", name="Copy the frames as Python").click()
    page.get_by_text("Copied").wait_for()
    copied = eval(page.evaluate("navigator.clipboard.readText()"), {"pose": pose})
    np.testing.assert_allclose(copied, RIGHT, rtol=0, atol=1e-11)
    assert check_frames(ARM, copied, "standard") == []


def test_a_broken_rule_disappears_when_its_frame_changes_and_is_restored_with_it(show):
    page = show(broken())
    wrong = page.get_by_role("button", name="Frame 1, breaks a rule")
    wrong.click()
    page.get_by_role("button", name="Clear this frame").click()
    assert get(page, "frames")[1] == [[None] * 4, [None] * 4, [None] * 4, [0, 0, 0, 1]]
    assert not wrong.is_visible()
    assert "Check again." in page.locator(".kv-verdict").inner_text()
    page.get_by_role("button", name="Undo the last change").click()
    assert wrong.is_visible()
    page.evaluate(f"frames => {MODEL}.set('frames', frames)", RIGHT.tolist())  # as if Python had set them
    assert not wrong.is_visible()


def test_an_x_that_is_not_perpendicular_to_a_new_z_is_removed(show):
    page = show(at(assign(ARM, "standard"), frames=RIGHT))
    page.get_by_role("button", name="Frame 3, placed").click()
    z = next(axis for axis in ARM.lines.axis if abs(axis @ RIGHT[3, :3, 0]) > 0.5)
    choose(page, "Direction of z 3", z)
    assert np.isnan(frames_of(page)[3][:3, :2]).all()
    np.testing.assert_array_equal(frames_of(page)[3][:3, 2], z)


# --- accessibility ---


def broken():
    """Return an arm with frames, one of which breaks a rule."""
    frames = RIGHT.copy()
    frames[1, :3, 3] += RIGHT[1, :3, 0]
    hand = at(assign(ARM, "standard"), frames=frames)
    hand.asked = 1
    return hand


ALL = {
    "arm": lambda: explore(kl.robots.puma560(), start=np.full(6, 0.5)),
    "assignment": lambda: at(play_assignment(kl.robots.puma560(), convention="modified"), at=24),
    "row": lambda: at(play_row(ROW), at=2),
    "by hand": broken,
}


@pytest.mark.parametrize(
    ("kind", "style"),
    [*((kind, "background:#111418") for kind in ALL), ("arm", "background:white"), ("by hand", "background:white")],
)
def test_contrast_narrow_pages_and_a_name_and_keys_for_each_control(show, kind, style):
    page = show(ALL[kind](), style=style, viewport={"width": 400, "height": 900})
    faint = {text: contrast(ink, paper) for text, ink, paper in text_colours(page) if contrast(ink, paper) < 4.5}
    # WCAG 1.4.3 allows a low contrast for buttons that are disabled
    off = page.locator(".kv :is([aria-disabled=true], :disabled)").all_inner_texts()
    assert not set(faint) - set(off)
    assert not overflowing(page)
    controls = page.locator(".kv :is(button, input, select, canvas)")
    controls = controls.evaluate_all(
        """all => all.map((node) => [node.getAttribute('data-lm-suppress-shortcuts'),
            (node.getAttribute('aria-label') || node.textContent).trim().length > 1, node.outerHTML])"""
    )
    assert not [html for keys, named, html in controls if keys != "true" or not named]
