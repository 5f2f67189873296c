"""The viewer in a real browser, on a page without a kernel: moved by mouse and keys, read aloud, light and dark.

test_jupyterlab.py has the viewer in a lab.
"""

from contextlib import ExitStack
from io import BytesIO
from itertools import combinations

import numpy as np
import pytest
from answered import Answered
from browser import (
    TIMEOUT_MS,
    contrast,
    drawn_count,
    pose,
    static_page,
    until_spoken,
    wait_until_drawn,
    watched,
)
from mesh_files import crane, dae, glb, obj, stl, visual, write
from PIL import Image
from urdf_files import TWO_FINGERS

import kinlib as kl
from kinlib.mechanisms.linkages import four_bar
from kinlib.view import assign, draw_arm, drive, explore, play_row, play_walk, slide_frames

DEGREE = np.pi / 180
YOUBOT, RPR = kl.robots.youbot(), kl.robots.rpr()
TREE = kl.Tree.from_urdf(TWO_FINGERS)
LINKAGE = four_bar(0.4, 0.1, 0.35, 0.3)
Q = [0.5, -0.6, 0.7, -0.8, 0.9, -1.0]


@pytest.fixture
def show(chromium, tmp_path):
    """Show viewers on a static page, and wait until they are drawn."""
    with ExitStack() as opened:

        def open_page(*viewers, count=None, browser=chromium, **settings):
            page = opened.enter_context(watched(browser, **settings))
            page.goto(static_page(tmp_path, *viewers).as_uri())
            wait_until_drawn(page, len(viewers) if count is None else count)
            return page

        yield open_page


@pytest.fixture(scope="module")
def shared(chromium, tmp_path_factory):
    """A page with a youBot, on which many tests change one thing each."""
    with watched(chromium) as page:
        page.goto(static_page(tmp_path_factory.mktemp("shared"), explore(YOUBOT)).as_uri())
        wait_until_drawn(page)
        yield page


@pytest.fixture
def youbot(shared):
    """The shared page with its arm at home, in its first view and with its first layers."""
    shared.emulate_media(reduced_motion="reduce")  # the camera flies back at once
    shared.evaluate(
        """async () => { const { model, stage } = document.querySelector('.kv').viewer;
            document.body.style.background = 'white';
            model.set('q', [0, 0, 0, 0, 0]);
            model.set('shown', ['axes', 'base', 'tool']);
            stage.camera.flyTo('3-D');
            document.activeElement.blur();
            await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))); }"""
    )
    shared.emulate_media(reduced_motion="no-preference")
    return shared


def sliders(page):
    return page.locator(".kv input[type=range]")


def settled(page, change):
    """Do something, and wait for the next picture."""
    before = drawn_count(page)
    change()
    page.wait_for_function(
        f"Number(document.querySelector('.kv-canvas').dataset.pictures) > {before}", timeout=TIMEOUT_MS
    )


def set_q(page, q):
    page.evaluate("q => document.querySelector('.kv').viewer.model.set('q', q)", list(q))


def q_of(page):
    return page.evaluate("document.querySelector('.kv').viewer.model.get('q')")


def shown_pixels(page):
    """Return the pixels of the picture, to compare them with another one."""
    return page.evaluate("document.querySelector('.kv-canvas').toDataURL()")


# --- the kinematics of the page ---


def test_the_page_computes_poses_as_chain_fk_does_and_all_share_one_webgl_context(show):
    """Compare the scene graph in JavaScript with Chain.fk in 100 configurations: at most 1e-12 apart."""
    page = show(*map(explore, robots := [RPR, kl.robots.hrr(), kl.robots.panda()]), count=1)
    worst = {}
    for which, robot in enumerate(robots):
        page.locator("[data-kinlib-viewer]").nth(which).scroll_into_view_if_needed()
        page.locator(".kv").nth(which).wait_for()  # a viewer starts when it is scrolled near
        q = np.random.default_rng(7).uniform(-np.pi, np.pi, (100, robot.n))
        found = page.evaluate(
            """([which, configurations]) => {
                const { model, stage } = document.querySelectorAll('.kv')[which].viewer;
                return configurations.map((q) => { model.set('q', q); return stage.tree.pose(); });
            }""",
            [which, q.tolist()],
        )
        worst[robot.name] = np.abs(np.array(found) - robot.fk(q)).max()
        wait_until_drawn(page, which + 1)
    assert max(worst.values()) < 1e-12, worst
    assert page.evaluate("globalThis[Symbol.for('kinlib.renderers')].length") == 1
    colours = page.evaluate(
        """[...document.querySelectorAll('.kv-canvas')].map((canvas) => {
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            return new Set(new Uint32Array(data.buffer)).size; })"""
    )
    assert min(colours) > 100  # no picture is blank


def test_the_readout_shows_the_pose_and_copy_gives_python_code_with_all_digits(show):
    page = show(explore(kl.robots.puma560(), start=Q), permissions=["clipboard-read", "clipboard-write"])
    cells = [float(text) for text in page.locator(".kv-pose td").all_inner_texts()]
    np.testing.assert_allclose(np.reshape(cells, (4, 4)), kl.robots.puma560().fk(Q), atol=5.1e-5)
    page.get_by_role("button", name="Copy").click()
    page.get_by_text("copied").wait_for()
    copied = {}
    exec(page.evaluate("navigator.clipboard.readText()"), {"np": np}, copied)
    assert copied["q"].tolist() == Q
    np.testing.assert_allclose(copied["T"], kl.robots.puma560().fk(Q), rtol=0, atol=1e-14)


# --- mouse and keys ---


def test_without_webgl_the_drawing_is_shown_and_a_message_says_that_it_does_not_move(chromium_without_webgl, tmp_path):
    with watched(chromium_without_webgl) as page:
        page.goto(static_page(tmp_path, explore(YOUBOT)).as_uri())
        page.get_by_text("WebGL is not available in this browser, so a flat drawing of the start is shown").wait_for()
        assert page.locator(".kv-still img").is_visible()
        sliders(page).first.press("ArrowRight")
        np.testing.assert_allclose(pose(page), YOUBOT.fk(q_of(page)), atol=1e-12)


def test_a_link_is_dragged_and_its_joint_follows_the_pointer(youbot):
    x, y = youbot.evaluate(
        """() => { const { stage } = document.querySelector('.kv').viewer;
            const { left, top } = stage.canvas.getBoundingClientRect();
            for (let x = stage.width; x > 0; x -= 3)
              for (let y = 3; y < stage.height; y += 3) {
                window.held = stage.pick(x, y);
                if (held?.link === 3) return [x + left, y + top]; } }"""
    )
    youbot.mouse.move(x, y)
    youbot.mouse.down()
    youbot.mouse.move(x, y - 30, steps=10)
    youbot.mouse.up()
    q = q_of(youbot)
    assert abs(q[2]) > 0.1
    assert q[:2] + q[3:] == [0, 0, 0, 0]
    height = youbot.evaluate(
        """() => { const { stage } = document.querySelector('.kv').viewer;
            stage.tree.root.updateMatrixWorld(true);
            const place = stage.camera.project(held.body.localToWorld(held.point.clone()));
            return place.y + stage.canvas.getBoundingClientRect().top; }"""
    )
    assert height == pytest.approx(y - 30, abs=8)


def test_keys_move_a_joint_by_a_degree_or_a_centimetre_and_to_its_ends(show):
    page = show(explore(RPR, start=[0.1, 0.2, 0.3]))
    for joint, key, value in [
        (0, "ArrowRight", 0.1 + DEGREE),
        (0, "PageDown", 0.1 - 9 * DEGREE),
        (1, "ArrowLeft", 0.19),
        (1, "End", 1.0),
        (2, "Home", -np.pi),
    ]:
        sliders(page).nth(joint).focus()
        page.keyboard.press(key)
        assert q_of(page)[joint] == pytest.approx(value, abs=1e-12)


def test_numbers_and_angles_are_typed_and_ninety_in_a_field_of_radians_asks_for_degrees(youbot):
    field = youbot.get_by_label("Joint 2, radians, as a number")
    for typed in ("1.5707963267948966", "90°", "0,5 pi", "\N{MINUS SIGN}270 deg"):
        field.fill(typed)
        field.press("Enter")
        assert np.sin(q_of(youbot)[1]) == pytest.approx(1), typed
    before = q_of(youbot)
    for typed in ("", "90"):
        field.fill(typed)
        field.press("Enter")
        assert q_of(youbot) == before
    youbot.get_by_role("button", name="90°?").click()
    assert q_of(youbot)[1] == pytest.approx(np.pi / 2)


def test_play_moves_one_joint_after_the_other_and_reset_goes_back_to_the_start(youbot):
    page = youbot
    set_q(page, [0, 0.5, 0, 0, 0])
    play = page.get_by_role("button", name="Play")
    settled(page, play.click)
    page.wait_for_function("document.querySelector('.kv').viewer.model.get('q')[0] > 0.1", timeout=TIMEOUT_MS)
    page.get_by_role("button", name="Pause").click()
    stopped = q_of(page)
    assert stopped[1:] == [0.5, 0, 0, 0]
    page.wait_for_timeout(150)
    assert q_of(page) == stopped
    page.get_by_role("button", name="Reset").click()
    assert q_of(page) == [0, 0, 0, 0, 0]


def test_every_control_of_the_picture_changes_it(youbot):
    """The view by mouse and by keys, layers, the trail, and the link that a slider moves while the pointer is on it."""
    page, canvas = youbot, youbot.locator(".kv-canvas")
    page.evaluate("document.querySelector('.kv').viewer.model.set('shown', ['axes', 'normals', 'dimensions'])")
    box = canvas.bounding_box()

    def drag():
        page.mouse.move(box["x"] + 200, box["y"] + 150)
        page.mouse.down()
        page.mouse.move(box["x"] + 260, box["y"] + 180, steps=3)
        page.mouse.up()

    def shifted():
        page.keyboard.down("Shift")
        drag()
        page.keyboard.up("Shift")

    def trail():
        page.get_by_role("button", name="trail").click()
        for angle in (0.1, 0.4, 0.7, 0):
            set_q(page, [angle, 0, 0, 0, 0])

    changes = [drag, shifted, lambda: page.mouse.wheel(0, -300), trail, sliders(page).nth(2).hover]
    changes += [lambda key=key: canvas.press(key) for key in ("ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "+")]
    layers = ("screw axes", "common normals", "lengths")
    changes += [page.get_by_role("button", name=layer).click for layer in layers]
    seen = {shown_pixels(page)}
    for change in changes:
        settled(page, change)
        page.wait_for_timeout(60)
        now = shown_pixels(page)
        assert now not in seen
        seen.add(now)
    for layer in layers:
        assert page.get_by_role("button", name=layer).get_attribute("aria-pressed") == "false"


def test_frames_are_chosen_from_a_list_and_named(youbot):
    page = youbot
    choose = page.get_by_label("Frames")
    names = "[...document.querySelector('.kv').viewer.stage.names].map((box) => box.name)"
    settled(page, lambda: choose.select_option(label="standard DH"))
    assert {"x0", "z1", "x5"} <= set(page.evaluate(names))
    settled(page, page.get_by_label("Show {1}").uncheck)  # some of them
    seen = set(page.evaluate(names))
    assert "x0" in seen
    assert "z1" not in seen
    settled(page, lambda: choose.select_option(label="no frames"))
    assert set(page.evaluate(names)) == {f"S{i}" for i in range(1, 6)}


CONFIGURATIONS = [np.zeros(6), Q, [0, -0.5, 0.5, 0, 1.2, 0], [2, -1, 2.5, 1, -1, 2]]


def test_no_label_covers_another_or_leaves_the_picture(show):
    """The wrist of the PUMA 560 has three frames at one point, each with three letters, and there are six axes and five normals."""
    page = show(explore(kl.robots.puma560()))
    for q, frames, width in zip(CONFIGURATIONS, ("standard", "modified") * 2, (400, 400, 900, 900), strict=True):
        page.set_viewport_size({"width": width, "height": 700})
        page.evaluate(f"document.querySelector('.kv').viewer.model.set('shown', ['axes', 'normals', '{frames}'])")
        settled(page, lambda q=q: set_q(page, q))
        boxes, size = page.evaluate(
            "(() => { const { stage } = document.querySelector('.kv').viewer; return [stage.names, [stage.width, stage.height]]; })()"
        )
        assert {f"{letter}{i}" for letter in "xz" for i in range(7)} <= {box["name"] for box in boxes}
        corners = np.array([[(box["left"], box["top"]), (box["right"], box["bottom"])] for box in boxes])
        assert (corners >= 0).all()
        assert (corners <= size).all()
        for one, other in combinations(corners, 2):
            assert (one[0] >= other[1]).any() or (other[0] >= one[1]).any()


# --- text alternatives ---


def four_bar_viewer():
    return drive(LINKAGE, LINKAGE.assembly_modes(hold={"A": 1.0})[0], across=("A", "D"))


def frames_at(degrees):
    return {"s": np.eye(4), "b": kl.exp(np.array([0, 0, np.radians(degrees), 0.4, 0, 0.1]))}


SAID = {
    "arm": (lambda: explore(kl.robots.hrr()), {"q": [0.4, -1.2, 1.7]}),
    "tree": (lambda: explore(TREE), {"q": [0.4, 0.02]}),
    "linkage": (four_bar_viewer, {"at": 80}),
    "frames on links": (lambda: explore(RPR, frames={"2": RPR.home}), {"q": [1, 0, 2], "shown": ["axes", "frame 2"]}),
    "moving frames": (lambda: slide_frames(frames_at, "angle", [0, 30, 60]), {"at": 2}),
    "row": (lambda: play_row([0.8, 0.6, 0.6, 1.4]), {"at": 3}),
    "walk": (lambda: play_walk([[0.6, -0.9, 0.4, 0.3]]), {"at": 1}),
    "frames by hand": (
        lambda: assign(RPR, "standard"),
        {"frames": kl.assign_frames(RPR, convention="standard").frames.tolist()},
    ),
}


@pytest.mark.parametrize("kind", SAID)
def test_the_page_says_what_python_says_of_what_is_drawn(show, kind):
    """At first, and after the reader or Python has changed something."""
    make, changes = SAID[kind]
    viewer = make()
    page = show(viewer)
    until_spoken(page, before := viewer.alt)
    for trait, value in changes.items():
        setattr(viewer, trait, value)
        page.evaluate(
            "([trait, value]) => document.querySelector('.kv').viewer.model.set(trait, value)", [trait, value]
        )
    assert viewer.alt != before
    until_spoken(page, viewer.alt)


def test_meshes_take_the_place_of_bodies_by_rule_and_what_cannot_be_read_is_said(show, tmp_path):
    files = {
        "a.stl": stl(),
        "b.obj": obj(),
        "c.dae": dae(),
        "d.glb": glb(),
        "e.stl": b"not a mesh",
        "f.glb": glb("https://example.org/a"),
    }
    names = [*files, "missing.stl"]
    write(tmp_path, {"crane.urdf": crane(*map(visual, names)), **files})
    tree = kl.Tree.from_urdf(tmp_path / "crane.urdf")
    page = show(explore(tree))
    page.wait_for_function("document.querySelector('.kv').viewer.meshes?.then(() => true)", timeout=TIMEOUT_MS)
    read = page.evaluate(
        """document.querySelector('.kv').viewer.stage.meshes.map(({ body, pieces }) => {
            const low = (k) => Math.min(...pieces[0].position.filter((_, i) => i % 3 === k));
            const high = (k) => Math.max(...pieces[0].position.filter((_, i) => i % 3 === k));
            return [body, pieces[0].index.length, pieces[0].colour, [0, 1, 2].map((k) => high(k) - low(k)), low(2)]; })"""
    )
    assert [(body, corners) for body, corners, *_ in read] == [(0, 12), (1, 12), (2, 12), (3, 12)]
    for body, _, _, size, low in read:
        np.testing.assert_allclose([*size, low], [0.1, 0.1, 0.2, 0.1 * body + 0.05], atol=1e-6)
    assert [colour for *_, colour, _, _ in read] == [None, None, "#ff8000", "#ffffff"]
    by_rule = (
        "[...new Set(document.querySelector('.kv').viewer.stage.layers.get('arm').meshes.map((m) => m.parent))].length"
    )
    assert page.evaluate(by_rule) == 3  # e, f and the missing one
    message = page.locator(".kv-message").first.inner_text()
    for said in (
        "A mesh is not shown, missing.stl: it was not found",
        "The mesh e.stl could not be read",
        "The mesh f.glb",
    ):
        assert said in message


# --- closed chains ---


AT = "(() => { const { model } = document.querySelector('.kv').viewer; return [model.get('variant'), model.get('at')]; })()"


def test_the_slider_moves_along_its_curve_and_a_click_changes_to_the_other_curve(show):
    viewer = four_bar_viewer()
    page = show(viewer)
    first, second = viewer.mode["variants"]
    page.get_by_label("driver").focus()
    settled(page, lambda: page.keyboard.press("ArrowRight"))
    assert page.evaluate(AT) == [first, viewer.at + 1]
    page.get_by_label("Assembly mode").select_option(index=1)
    assert page.evaluate(AT)[0] == second
    place = page.locator(".kv-map").bounding_box()
    rocker = [np.mean([stop["q"][2] for stop in variant["stops"]]) for variant in viewer.mode["variants"].values()]
    share = 0.95 if rocker[0] < rocker[1] else 0.05  # the height of the first curve on the map, from the top
    settled(
        page, lambda: page.mouse.click(place["x"] + place["width"] / 2, place["y"] + share * (place["height"] - 30))
    )
    name, at = page.evaluate(AT)
    assert name == first
    page.locator(".kv-map").focus()
    settled(page, lambda: page.keyboard.press("ArrowUp"))
    assert page.evaluate(AT) == [first, at + 1]


# --- predictions ---


def test_a_question_elsewhere_on_the_page_or_the_reader_removes_the_cover(show):
    page = show(explore(RPR, after=Answered()), explore(RPR, after=Answered()), count=0)
    covers = page.get_by_text("Commit to your prediction above first")
    covers.first.wait_for()
    assert not page.locator(".kv-canvas").first.is_visible()
    page.evaluate("document.querySelector('[data-kinlib-viewer]').dataset.uncovered = ''")
    wait_until_drawn(page)
    assert not covers.first.is_visible()
    page.get_by_role("button", name="Show anyway").last.click()
    wait_until_drawn(page, 2)


# --- messages and failures ---


def test_a_configuration_beyond_its_limits_and_an_arm_that_cannot_be_shown_give_a_message(show):
    limited = kl.Chain(RPR.screws, RPR.home, limits=[(-1, 1), (-np.inf, np.inf), (0, np.inf)])
    page = show(explore(limited), explore(RPR).html().replace('"scene":', '"scheme":'), count=1)
    page.get_by_role("alert").last.get_by_text("The viewer cannot show this arm: ").wait_for()
    message = page.locator(".kv-message").first
    assert not message.is_visible()
    set_q(page, [1.5, 0, -0.2])
    assert "Joint 1 is at 1.500, outside its limits -1 to 1" in message.inner_text()
    assert "Joint 3 is at -0.200, outside its limits 0 to ∞" in message.inner_text()
    set_q(page, [1, 9, 0.2])
    assert not message.is_visible()


# --- the page ---


def test_a_lost_context_is_created_again(show):
    page = show(explore(RPR))
    before = shown_pixels(page)
    page.evaluate("globalThis[Symbol.for('kinlib.renderers')][0]()")
    settled(page, lambda: page.evaluate("document.querySelector('.kv').viewer.stage.draw()"))
    assert shown_pixels(page) == before


def test_labels_in_the_picture_have_sufficient_contrast_in_both_themes_which_follow_the_page(youbot):
    """By WCAG 2 at least 4.5, in the light and the dark theme; test_players_browser.py has the text beside the picture."""
    for background, name in (("white", "light"), ("#111418", "dark")):
        youbot.evaluate("colour => { document.body.style.background = colour; }", background)
        youbot.locator(f".kv[data-theme={name}]").wait_for()
        theme = youbot.evaluate("document.querySelector('.kv').viewer.stage.theme")
        labels = ["ink", "quiet", "axis", "normal", "x", "y", "z", "trail"]
        assert not {label for label in labels if contrast(theme[label], theme["paper"]) < 4.5}


THEMES = {'data-jp-theme-light="false"': "light", 'data-theme="dark"': "light", 'data-theme="auto"': "dark"}
"""How the lab and the site say that they are dark, each with what the reader prefers."""


def test_a_figure_has_the_theme_of_the_page_and_is_printed_light(chromium_without_webgl, tmp_path):
    light, dark = (255, 255, 255), (23, 27, 33)
    with watched(chromium_without_webgl) as page:
        for attributes, preference in {**THEMES, "": "dark"}.items():
            body = static_page(tmp_path, draw_arm(RPR).html())
            body.write_text(body.read_text("utf-8").replace("<body ", f"<body {attributes} "), "utf-8")
            page.goto(body.as_uri())
            for media, paper in (("screen", dark if attributes else light), ("print", light)):
                page.emulate_media(color_scheme=preference, media=media)
                pixels = Image.open(BytesIO(page.locator("figure img").screenshot()))
                assert pixels.convert("RGB").getpixel((3, 3)) == paper, (attributes, media)


def test_every_control_shows_the_focus(youbot):
    controls = youbot.locator(".kv :is(button, input, select, canvas):visible")
    controls.nth(1).focus()
    youbot.keyboard.press("Shift+Tab")
    for _ in range(controls.count()):
        outline = youbot.evaluate("getComputedStyle(document.activeElement).outlineStyle")
        assert outline == "solid", youbot.evaluate("document.activeElement.outerHTML")
        youbot.keyboard.press("Tab")


def test_a_screen_reader_gets_the_arm_and_the_position_of_its_tool(youbot):
    page = youbot
    sliders(page).nth(2).focus()
    page.keyboard.press("PageUp")
    # The arm at home is announced too, when its slider gets the focus: wait for the moved arm.
    page.locator(".kv-canvas[aria-label*='q = (0, 0, 0.175, 0, 0)']").wait_for(state="attached")
    assert "youBot, 5 joints (RRRRR)" in page.locator(".kv-canvas").get_attribute("aria-label")
    assert "The end-effector is at (" in page.locator(".kv-screen-reader").text_content()
    assert sliders(page).nth(2).get_attribute("aria-valuetext") == "0.17 radians, 10 degrees"
