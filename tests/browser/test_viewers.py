"""Viewers, players and the placing of frames on one page without a kernel: moved by mouse, touch and keys, and read aloud.

test_jupyterlab.py has them in a lab, where Python is behind them.
"""

import shutil
from io import BytesIO
from itertools import combinations

import numpy as np
import pytest
from answered import Answered
from browser import TIMEOUT_MS, contrast, watched
from mesh_files import crane, dae, glb, obj, stl, visual, write
from PIL import Image
from playwright.sync_api import expect
from urdf_files import TWO_FINGERS

import kinlib as kl
from kincourse import open_sheet
from kincourse.lecture_01_frames.opening import opening
from kincourse.lecture_06_dh_modified.drawings import play_walk
from kinlib.chains.robots import pose
from kinlib.dh.rules import check_frames
from kinlib.mechanisms.linkages import four_bar
from kinlib.view import assign, draw_arm, drive, explore, play_assignment, play_row, slide_frames
from kinlib.view.drawing.picture import ENVIRONMENT_VARIABLE
from kinlib.view.viewer.widget import STATIC

DEGREE = np.pi / 180
YOUBOT, RPR, HRR, PUMA = kl.robots.youbot(), kl.robots.rpr(), kl.robots.hrr(), kl.robots.puma560()
LIMITED = kl.Chain(RPR.screws, RPR.home, limits=[(-1, 1), (-np.inf, np.inf), (0, np.inf)])
LINKAGE = four_bar(0.4, 0.1, 0.35, 0.3)
MODES = LINKAGE.assembly_modes(hold={"A": 1.0})
ARM = open_sheet("07_frame_assignment", "ada").problem(2).shown["arm"]
RIGHT = kl.assign_frames(ARM, convention="standard").frames
UNPLACED = np.array([[[None] * 4] * 3 + [[0, 0, 0, 1]]] * len(RIGHT))
ROW = [0.8, 0.6, 0.6, 1.4]
Q = [0.5, -0.6, 0.7, -0.8, 0.9, -1.0]
MESHES = {
    "a.stl": stl(),
    "b.obj": obj(),
    "c.dae": dae(),
    "d.glb": glb(),
    "e.stl": b"not a mesh",
    "f.glb": glb("https://example.org/a"),
}


def broken():
    """Frames by hand, one of which breaks a rule."""
    hand, frames = assign(ARM, "standard"), RIGHT.copy()
    frames[1, :3, 3] += RIGHT[1, :3, 0]
    hand.frames, hand.asked = frames, 1
    return hand


def frames_at(degrees):
    return {"s": np.eye(4), "b": kl.exp([0, 0, np.radians(degrees), 0.4, 0, 0.1])}


VIEWERS = {
    "arm": lambda: explore(YOUBOT),
    "puma": lambda: explore(PUMA, start=Q),
    "helical": lambda: explore(HRR),
    "prismatic": lambda: explore(LIMITED, start=[0.1, 0.2, 0.3]),
    "tree": lambda: explore(kl.Tree.from_urdf(TWO_FINGERS)),
    "linkage": lambda: drive(
        LINKAGE, MODES[0], across=("A", "D"), curves=[LINKAGE.trace(q, points=240).q for q in MODES]
    ),
    "frames on links": lambda: explore(RPR, frames={"2": RPR.home}),
    "moving frames": lambda: slide_frames(frames_at, "angle", [0, 30, 60]),
    "assignment": lambda: play_assignment(YOUBOT, convention="standard"),
    "row": lambda: play_row(ROW),
    "walk": lambda: play_walk([[0.6, -0.9, 0.4, 0.3]]),
    "film": opening,
    "by hand": lambda: assign(ARM, "standard"),
    "broken": broken,
    "covered": lambda: explore(RPR, after=Answered()),
}


class Shown:
    """One of the viewers on the page."""

    def __init__(self, page, which):
        self.page, self.root = page, page.locator(":is([data-kinlib-viewer], [data-kinlib-film])").nth(which)
        self.root.locator(".kv, [data-kinlib-drawing]").first.wait_for()
        self.root.evaluate("root => root.scrollIntoView()")  # its top is at that of the page
        self.root.locator(".kv").wait_for()
        self.canvas = self.root.locator(".kv-canvas")
        self.name = self.root.get_by_role
        self.label = self.root.get_by_label

    def run(self, script, argument=None):
        """Evaluate a script in which `model` and `stage` are those of the viewer, and `x` is the argument."""
        return self.root.evaluate(
            f"(root, x) => {{ const model = root.kinlibModel, stage = root.querySelector('.kv').viewer?.stage; return {script}; }}",
            argument.tolist() if isinstance(argument, np.ndarray) else argument,
        )

    def get(self, trait):
        return self.run("model.get(x)", trait)

    def set(self, **traits):
        for trait, value in traits.items():
            self.run("model.set(...x)", [trait, np.asarray(value).tolist()])

    def wait(self, condition, argument=None):
        self.page.wait_for_function(
            f"([root, x]) => {{ const model = root.kinlibModel, canvas = root.querySelector('.kv-canvas'); return {condition}; }}",
            arg=[self.root.element_handle(), argument],
            timeout=TIMEOUT_MS,
        )

    def settled(self, change):
        """Do something, and wait for the next picture."""
        before = int(self.canvas.get_attribute("data-pictures") or 0)
        change()
        self.wait("Number(canvas.dataset.pictures) > x", before)

    def pixels(self):
        """Return the pixels of the picture, to compare them with another one."""
        return self.run("root.querySelector('.kv-canvas').toDataURL()")

    def names(self):
        """Paint the picture again, and return the labels in it."""
        self.run("stage.paint()")
        return {box["name"] for box in self.run("stage.names")}

    def place_of(self, point):
        """Return where a point of space is on the page, in pixels."""
        return self.run(
            """(({ camera, canvas }) => { const { left, top } = canvas.getBoundingClientRect();
                const { x: across, y: down } = camera.project(camera.target.clone().set(...x));
                return [across + left, down + top]; })(stage)""",
            [float(value) for value in point],
        )

    def click(self, point, off=(0, 0)):
        x, y = self.place_of(point)
        self.page.mouse.click(x + off[0], y + off[1])

    def drag(self, start, end):
        self.page.mouse.move(*start)
        self.page.mouse.down()
        self.page.mouse.move(*end, steps=5)
        self.page.mouse.up()

    def frames(self):
        return np.array(self.get("frames"), dtype=float)

    def type_in(self, field, text):
        field.fill(text)
        field.press("Enter")


def static_page(folder, *parts):
    """Write a page with viewers and without a kernel, and the files that it loads."""
    shutil.copytree(STATIC, folder / "static", dirs_exist_ok=True)
    head = '<!doctype html><html lang="en"><meta charset="utf-8"><title>Arms</title><link rel="icon" href="data:,">'
    body = (
        f"<body style='background:white'><main>{''.join(parts)}</main><script src='static/loader.js'></script></body>"
    )
    (folder / "page.html").write_text(f"{head}{body}</html>", "utf-8")
    return folder / "page.html"


@pytest.fixture(scope="module")
def page(chromium, tmp_path_factory):
    """The page with all viewers, each of which starts and draws only where it is scrolled to."""
    folder = tmp_path_factory.mktemp("viewers")
    names = [*MESHES, "missing.stl"]
    write(folder, {"b.mtl": "newmtl blue\nKd 0 0 1.0\n"})
    write(folder, {"crane.urdf": crane(*map(visual, names), visual("a.stl").replace("0.05", "1")), **MESHES})
    parts = [make().html() for make in VIEWERS.values()]
    parts += [explore(kl.Tree.from_urdf(folder / "crane.urdf")).html(), parts[0].replace('"scene":', '"scheme":')]
    size = {"width": 1000, "height": 620}
    allowed = ["clipboard-read", "clipboard-write"]
    with watched(chromium, viewport=size, reduced_motion="reduce", has_touch=True, permissions=allowed) as page:
        page.goto(static_page(folder, *parts).as_uri())
        yield page


@pytest.fixture
def show(page):
    """Show one of the viewers, and wait until it is drawn."""

    def shown(name):
        viewer = Shown(page, list(VIEWERS).index(name))
        if viewer.canvas.count() and name != "covered":
            viewer.wait("canvas.dataset.pictures")
        return viewer

    return shown


# --- arms ---


@pytest.mark.parametrize(("name", "robot"), [("puma", PUMA), ("helical", HRR), ("prismatic", RPR)])
def test_the_page_computes_poses_as_chain_fk_does(show, name, robot):
    viewer = show(name)
    before, q = viewer.get("q"), np.random.default_rng(7).uniform(-np.pi, np.pi, (100, robot.n))
    found = viewer.run("x.map((q) => { model.set('q', q); return stage.tree.pose(); })", q)
    np.testing.assert_allclose(found, robot.fk(q), rtol=0, atol=1e-12)
    viewer.set(q=before)
    assert viewer.run("globalThis[Symbol.for('kinlib.renderers')].length") == 1, "all share one WebGL context"


def test_the_readout_shows_the_pose_and_copy_gives_python_code_with_all_digits(show, page):
    viewer = show("puma")
    cells = [float(text) for text in viewer.root.locator(".kv-pose td").all_inner_texts()]
    np.testing.assert_allclose(np.reshape(cells, (4, 4)), PUMA.fk(Q), atol=5.1e-5)
    viewer.name("button", name="Copy").click()
    viewer.root.get_by_text("copied").wait_for()
    copied = {}
    exec(page.evaluate("navigator.clipboard.readText()"), {"np": np}, copied)
    assert copied["q"].tolist() == Q
    np.testing.assert_allclose(copied["T"], PUMA.fk(Q), rtol=0, atol=1e-14)


def test_a_link_is_dragged_and_its_joint_follows_the_pointer(show):
    viewer = show("arm")
    x, y = viewer.run(
        """(() => { const { left, top } = stage.canvas.getBoundingClientRect();
            for (let x = stage.width; x > 0; x -= 3)
              for (let y = 3; y < stage.height; y += 3) {
                window.held = stage.pick(x, y);
                if (held?.link === 3) return [x + left, y + top]; } })()"""
    )
    viewer.drag((x, y), (x, y - 30))
    q = viewer.get("q")
    assert abs(q[2]) > 0.1
    assert q[:2] + q[3:] == [0, 0, 0, 0]
    height = viewer.run(
        """(() => { stage.tree.root.updateMatrixWorld(true);
            return stage.camera.project(held.body.localToWorld(held.point.clone())).y + stage.canvas.getBoundingClientRect().top; })()"""
    )
    assert height == pytest.approx(y - 30, abs=8)
    viewer.name("button", name="Reset").click()
    assert viewer.get("q") == [0, 0, 0, 0, 0]


def test_joints_are_moved_by_keys_and_by_typed_numbers_and_limits_are_named(show, page):
    viewer = show("prismatic")
    sliders, message = viewer.root.locator("input[type=range]"), viewer.root.locator(".kv-message").first
    viewer.set(q=[0.1, 0.2, 0.3])
    for joint, key, value in [
        (0, "ArrowRight", 0.1 + DEGREE),
        (0, "PageDown", 0.1 - 9 * DEGREE),
        (1, "ArrowLeft", 0.19),
        (2, "Home", 0),
    ]:
        sliders.nth(joint).focus()
        page.keyboard.press(key)
        assert viewer.get("q")[joint] == pytest.approx(value, abs=1e-12)
    assert not message.is_visible()
    field = viewer.label("Joint 1, radians, as a number")
    for typed in ("1.5707963267948966", "90°", "0,5 pi", "\N{MINUS SIGN}270 deg"):
        viewer.type_in(field, typed)
        assert np.sin(viewer.get("q")[0]) == pytest.approx(1), typed
    before = viewer.get("q")
    for typed in ("", "90"):
        viewer.type_in(field, typed)
        assert viewer.get("q") == before
    viewer.name("button", name="90°?").click()
    assert viewer.get("q")[0] == pytest.approx(np.pi / 2)
    viewer.set(q=[1.5, 0, -0.2])
    assert "Joint 1 is at 1.500, outside its limits -1 to 1" in message.inner_text()
    assert "Joint 3 is at -0.200, outside its limits 0 to ∞" in message.inner_text()


def test_play_moves_one_joint_after_the_other_until_it_is_paused(show):
    viewer = show("arm")
    viewer.set(q=[0, 0.5, 0, 0, 0])
    viewer.name("button", name="Play").click()
    viewer.wait("model.get('q')[0] > 0.1")
    viewer.name("button", name="Pause").click()
    stopped = viewer.get("q")
    assert stopped[1:] == [0.5, 0, 0, 0]
    viewer.settled(lambda: viewer.canvas.press("+"))
    assert viewer.get("q") == stopped


def test_every_control_of_the_picture_changes_it_and_frames_are_chosen(show, page):
    """The view by mouse and by keys, layers, the trail, and the link that a slider moves while the pointer is on it."""
    viewer = show("arm")
    viewer.set(q=[0, 0, 0, 0, 0], shown=["axes", "dimensions"])
    box = viewer.canvas.bounding_box()
    start, end = (box["x"] + 20, box["y"] + 15), (box["x"] + 80, box["y"] + 45)

    def shifted():
        page.keyboard.down("Shift")
        viewer.drag(start, end)
        page.keyboard.up("Shift")

    def trail():
        viewer.name("button", name="trail").click()
        for angle in (0.1, 0.4, 0.7, 0):
            viewer.set(q=[angle, 0, 0, 0, 0])

    layers = [viewer.name("button", name=layer) for layer in ("screw axes", "lengths")]
    changes = [lambda: viewer.drag(start, end), shifted, lambda: page.mouse.wheel(0, -300), trail]
    changes += [viewer.root.locator("input[type=range]").nth(2).hover]
    changes += [lambda key=key: viewer.canvas.press(key) for key in ("ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "+")]
    changes += [layer.click for layer in layers]
    seen = {viewer.pixels()}
    for change in changes:
        change()
        viewer.wait("!x.includes(canvas.toDataURL())", [*seen])  # forever, if this control changes nothing
        seen.add(viewer.pixels())
    assert [layer.get_attribute("aria-pressed") for layer in layers] == ["false"] * 2
    choose = viewer.label("Frames")
    choose.select_option(label="standard DH")
    assert {"x0", "z1", "x5"} <= viewer.names()
    viewer.label("Show {1}").uncheck()  # some of them
    assert viewer.names() & {"x0", "z1"} == {"x0"}
    choose.select_option(label="no frames")
    assert not viewer.names() & {"x0", "z1", "x5"}


def test_no_label_covers_another_or_leaves_the_picture(show):
    """The wrist of the PUMA 560 has three frames at one point, each with three letters, and there are six axes."""
    viewer = show("puma")
    for q, frames in ((np.zeros(6), "standard"), (Q, "modified"), ([2, -1, 2.5, 1, -1, 2], "modified")):
        viewer.set(shown=["axes", frames], q=q)
        assert {f"{letter}{i}" for letter in "xz" for i in range(7)} <= viewer.names()
        boxes, size = viewer.run("[stage.names, [stage.width, stage.height]]")
        corners = np.array([[(box["left"], box["top"]), (box["right"], box["bottom"])] for box in boxes])
        assert (corners >= 0).all()
        assert (corners <= size).all()
        for one, other in combinations(corners, 2):
            assert (one[0] >= other[1]).any() or (other[0] >= one[1]).any()


CHANGES = {
    "helical": {"q": [0.4, -1.2, 1.7]},
    "tree": {"q": [0.4, 0.02]},
    "linkage": {"at": 80},
    "frames on links": {"q": [1, 0, 2], "shown": ["axes", "frame 2"]},
    "moving frames": {"at": 2},
    "row": {"at": 3},
    "walk": {"at": 1},
    "by hand": {"frames": RIGHT.tolist()},
}


@pytest.mark.parametrize("name", CHANGES)
def test_the_page_says_what_python_says_of_what_is_drawn(show, name):
    """At first, and after the reader or Python has changed something."""
    viewer, python = show(name), VIEWERS[name]()
    before = {trait: viewer.get(trait) for trait in CHANGES[name]}

    def until_spoken(text):
        viewer.wait("canvas.getAttribute('aria-label')?.split(' Arrow keys')[0] === x", text)

    until_spoken(first := python.alt)
    for trait, value in CHANGES[name].items():
        setattr(python, trait, value)
        viewer.set(**{trait: value})
    assert python.alt != first
    until_spoken(python.alt)
    viewer.set(**before)


def test_a_screen_reader_gets_the_position_of_the_tool_and_the_value_of_a_slider(show):
    viewer = show("arm")
    viewer.set(q=[0, 0, 0, 0, 0])
    slider = viewer.root.locator("input[type=range]").nth(2)
    slider.press("PageUp")
    expect(slider).to_have_attribute("aria-valuetext", "0.17 radians, 10 degrees")
    expect(viewer.root.locator(".kv-screen-reader")).to_contain_text("The end-effector is at (")


def test_meshes_are_shown_and_what_cannot_be_read_or_shown_is_said(page):
    viewer = Shown(page, len(VIEWERS))
    viewer.wait("root.querySelector('.kv').viewer.meshes?.then(() => true)")
    *read, far = viewer.run(
        """stage.meshes.map(({ body, pieces }) => {
            const low = (k) => Math.min(...pieces[0].position.filter((_, i) => i % 3 === k));
            const high = (k) => Math.max(...pieces[0].position.filter((_, i) => i % 3 === k));
            const shaded = Math.hypot(...pieces[0].normal.slice(0, 3)) > 0.9;
            return [body, shaded && pieces[0].index.length, pieces[0].colour, [0, 1, 2].map((k) => high(k) - low(k)), low(2)]; })"""
    )
    assert [(body, corners) for body, corners, *_ in read] == [(0, 12), (1, 12), (2, 12), (3, 12)]
    for body, _, _, size, low in read:
        np.testing.assert_allclose([*size, low], [0.1, 0.1, 0.2, 0.1 * body + 0.05], atol=1e-6)
    assert [colour for *_, colour, _, _ in read] == [None, "#0000ff", "#ff8000", "#ffffff"]
    assert 0 < viewer.place_of((1.2, 0, far[4] + 0.2))[1] - viewer.canvas.bounding_box()["y"] < 100
    drawn_by_rule = "[...new Set(stage.layers.get('arm').meshes.map((mesh) => mesh.parent))].length"
    assert viewer.run(drawn_by_rule) == 3  # e, f and the missing one
    message = viewer.root.locator(".kv-message").first.inner_text()
    assert "A mesh is not shown, missing.stl: it was not found" in message
    assert "The mesh e.stl could not be read" in message
    assert "The mesh f.glb" in message
    broken = page.locator("[data-kinlib-viewer]").last
    broken.scroll_into_view_if_needed()
    broken.get_by_role("alert").get_by_text("The viewer cannot show this arm: ").wait_for()


def test_a_lost_context_is_created_again(show):
    viewer = show("tree")
    expect(viewer.root.locator(".kv-joint").first).to_have_text("turn: -1.00 to 1.00 rad")
    before = viewer.pixels()
    viewer.run("globalThis[Symbol.for('kinlib.renderers')][0]()")
    viewer.settled(lambda: viewer.run("stage.draw()"))
    assert viewer.pixels() == before


def test_a_question_elsewhere_on_the_page_removes_the_cover(show):
    viewer = show("covered")
    cover = viewer.root.get_by_text("Commit to your prediction above first")
    cover.wait_for()
    assert not viewer.canvas.is_visible()
    viewer.run("(root.dataset.uncovered = '')")
    viewer.canvas.wait_for(state="visible")
    assert not cover.is_visible()


def test_without_webgl_the_drawing_is_shown_and_a_message_says_that_it_does_not_move(chromium_without_webgl, tmp_path):
    with watched(chromium_without_webgl) as page:
        page.goto(static_page(tmp_path, explore(YOUBOT).html()).as_uri())
        page.get_by_text("WebGL is not available in this browser, so a flat drawing of the start is shown").wait_for()
        page.locator(".kv-picture").evaluate("picture => (picture.style.height = '100px')")
        assert 0 < page.locator(".kv-still img").bounding_box()["height"] <= 100  # a tall one is shown whole
        viewer = Shown(page, 0)
        viewer.root.locator("input[type=range]").first.press("ArrowRight")
        np.testing.assert_allclose(viewer.run("stage.tree.pose()"), YOUBOT.fk(viewer.get("q")), atol=1e-12)


def test_without_webgl_nothing_is_folded_once_the_prediction_is_made(chromium_without_webgl, tmp_path, monkeypatch):
    monkeypatch.setenv(ENVIRONMENT_VARIABLE, "1")
    with watched(chromium_without_webgl) as page:
        page.goto(static_page(tmp_path, explore(RPR, after=Answered()).html()).as_uri())
        page.get_by_role("button", name="Show anyway").press("Enter")
        expect(page.get_by_role("group", name="Viewer of RPR")).to_be_focused()  # not the page, whose top is far away
        expect(page.locator(".kv-still img")).to_be_visible()
        expect(page.locator(".kv-still")).to_have_text("")


# --- closed chains ---


def test_the_slider_moves_along_its_curve_and_a_click_changes_to_the_other_curve(show, page):
    viewer = show("linkage")
    mode = viewer.get("mode")
    first, second = mode["variants"]
    start, curve = viewer.get("at"), viewer.root.locator(".kv-map")
    viewer.label("place on the curve").focus()
    page.keyboard.press("ArrowRight")
    assert (viewer.get("variant"), viewer.get("at")) == (first, start + 1)
    viewer.label("Curve", exact=True).select_option(index=1)
    assert viewer.get("variant") == second
    rocker = [np.mean([stop["q"][2] for stop in variant["stops"]]) for variant in mode["variants"].values()]
    share = 0.95 if rocker[0] < rocker[1] else 0.05  # the height of the first curve on the map, from the top
    curve.scroll_into_view_if_needed()
    place = curve.bounding_box()
    page.mouse.click(place["x"] + place["width"] / 2, place["y"] + share * (place["height"] - 30))
    at = viewer.get("at")
    assert viewer.get("variant") == first
    curve.focus()
    page.keyboard.press("ArrowUp")
    assert viewer.get("at") == at + 1


# --- the players of steps ---


def test_the_steps_of_an_assignment_are_shown_by_buttons_and_keys_with_the_table_of_either_convention(show, page):
    viewer = show("assignment")
    stops, convention = viewer.get("mode")["variants"]["standard"]["stops"], viewer.label("Convention", exact=True)
    following = viewer.name("button", name="Next step")
    for expected in (1, 2, 3):
        following.click()
        assert viewer.get("at") == expected
    page.keyboard.press("ArrowRight")  # the button has the focus
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowLeft")
    assert viewer.get("at") == 4
    viewer.name("button", name="One step back").click()
    assert viewer.get("at") == 3
    said = viewer.root.locator(".kv-step")
    assert said.locator("p").nth(0).text_content() == stops[3]["text"].replace("O_1", "O1")
    assert viewer.names() & {"z1", "x1", "y1", "normal 1–2"} == {"z1"}
    page.keyboard.press("End")
    assert viewer.get("at") == len(stops) - 1
    assert following.get_attribute("aria-disabled") == "true"
    rows = viewer.root.locator(".kv-dh tr")
    viewer.set(at=next(k for k, stop in enumerate(stops) if stop["row"]))
    assert rows.nth(1).inner_text().split() == ["1", "0.033", "90°", "0.147", "q1"]
    assert rows.nth(2).inner_text().split() == ["2", "·", "·", "·", "·"]
    convention.select_option("modified")
    assert rows.nth(1).inner_text().split() == ["1", "0", "0", "0", "q1"]


def test_the_motions_move_the_frame_to_the_row_s_matrix_in_both_conventions(show, page):
    """A motion is animated unless reduced motion is preferred."""
    viewer = show("row")
    assert not viewer.root.locator(".kv-toggles").is_visible()  # there are no layers, so there is no empty bar

    def carried():
        return np.reshape(viewer.run("stage.tree.arms[0].tool.matrixWorld.elements"), (4, 4)).T

    viewer.run("(window.seen = [], model.on('change:at', () => seen.push(model.get('at'))))")
    for _ in range(4):
        viewer.name("button", name="Next motion").click()
    assert viewer.run("seen") == [1, 2, 3, 4]
    for convention in ("modified", "standard"):
        viewer.label("Convention", exact=True).select_option(convention)
        np.testing.assert_allclose(carried(), kl.dh_transform(*ROW, convention=convention), atol=1e-12)
    viewer.name("button", name="One motion back").click()
    expected = kl.dh_transform(0.8, 0, 0.6, 1.4, convention="standard")
    np.testing.assert_allclose(carried(), expected, atol=1e-12)
    viewer.set(at=2.5)  # on the way
    expected = kl.dh_transform(0.4, 0, 0.6, 1.4, convention="standard")
    np.testing.assert_allclose(carried(), expected, atol=1e-12)
    viewer.set(at=3)
    assert "along the common normal" in viewer.root.locator(".kv-motion-text").first.inner_text()
    page.emulate_media(reduced_motion="no-preference")
    viewer.run("(seen.length = 0)")
    viewer.name("button", name="Play").click()
    viewer.wait("model.get('at') === 4")
    page.emulate_media(reduced_motion="reduce")
    assert len(viewer.run("seen")) > 2


def test_a_film_is_played_and_paused_and_its_text_follows(show):
    viewer, shown = show("film"), opening()
    viewer.name("button", name="Play").click()
    viewer.wait("model.get('at') > 1")
    viewer.name("button", name="Pause").click()
    viewer.label("Time").press("End")
    picture = viewer.root.locator(".kv-film-picture")
    assert picture.get_attribute("aria-label") == shown.texts[-1]["alt"]
    assert picture.locator("img:visible").count() == 1


# --- frames by hand ---


@pytest.fixture
def by_hand(show):
    """No frame is placed yet."""
    viewer = show("by hand")
    viewer.set(frames=UNPLACED)
    viewer.name("button", name="Frame 0").click()
    return viewer


def handle(viewer, T, axis):
    """Return the handle with which a frame gets its z: an end of an axis."""
    mode = viewer.get("mode")
    lines = [mode["axes"][axis] if axis < ARM.n else mode["tool"], *mode["axes"], mode["tool"]]
    line = next(line for line in lines if np.allclose(np.cross(line["along"], T[:3, 2]), 0))
    return line["to" if np.dot(line["along"], T[:3, 2]) > 0 else "from"]


def dial(viewer):
    """The radius of the dial for x."""
    return 0.3 * viewer.get("scene")["size"]


def test_frames_are_placed_by_mouse_and_snap_to_candidates(by_hand):
    """Every click is some pixels away from its candidate, but the frames are exact."""
    for i, T in enumerate(RIGHT):
        by_hand.click(handle(by_hand, T, i), off=(3, -2))
        by_hand.click(T[:3, 3], off=(-2, 2))
        by_hand.click(T[:3, 3] + dial(by_hand) * T[:3, 0], off=(3, 3))
    np.testing.assert_allclose(by_hand.frames(), RIGHT, rtol=0, atol=1e-12)
    assert by_hand.name("button", name="Frame 3, placed").is_visible()


def test_frames_are_placed_by_touch(by_hand, page):
    for point in (handle(by_hand, RIGHT[0], 0), RIGHT[0, :3, 3]):
        x, y = by_hand.place_of(point)
        page.touchscreen.tap(x + 1, y + 1)
    np.testing.assert_allclose(by_hand.frames()[0][:3, 2:], RIGHT[0, :3, 2:], atol=1e-12)


def test_an_origin_is_dragged_along_its_axis_and_x_around_its_dial(by_hand):
    frames = UNPLACED.copy()
    frames[1] = RIGHT[1]
    by_hand.set(frames=frames)
    by_hand.name("button", name="Frame 1, placed").click()
    by_hand.name("button", name="Place O 1 in the picture").click()
    before = by_hand.run("stage.camera.azimuth")
    z, origin = RIGHT[1, :3, 2], RIGHT[1, :3, 3]
    by_hand.drag(by_hand.place_of(origin), by_hand.place_of(origin + 0.9 * z))
    moved = by_hand.frames()[1]
    along = (moved[:3, 3] - origin) @ z
    assert 0.5 < along < 1.3
    np.testing.assert_allclose(moved[:3, 3], origin + along * z, atol=1e-12)  # on its axis, except for rounding errors
    by_hand.name("button", name="Place x 1 in the picture").click()
    x, y = dial(by_hand) * moved[:3, 0], dial(by_hand) * moved[:3, 1]
    by_hand.drag(by_hand.place_of(moved[:3, 3] + x), by_hand.place_of(moved[:3, 3] + 0.08 * x + 0.99 * y))
    turned = by_hand.frames()[1][:3, :3]
    np.testing.assert_allclose(turned[:, 0], moved[:3, 1], atol=1e-12)  # it has snapped to y
    np.testing.assert_allclose(turned.T @ turned, np.eye(3), atol=1e-12)
    assert by_hand.run("stage.camera.azimuth") == before, "the camera must not move during a drag"
    by_hand.name("button", name="Undo the last change").click()
    np.testing.assert_allclose(by_hand.frames()[1], moved)


def choose(viewer, label, wanted):
    """Choose from a list with the arrow keys only."""
    select = viewer.label(label, exact=True)
    values = select.locator("option").evaluate_all("all => all.map((option) => JSON.parse(option.value))")
    there = next(k for k, value in enumerate(values) if value and np.allclose(value, wanted))
    here = select.evaluate("node => node.selectedIndex")
    select.focus()
    for _ in range(abs(there - here)):
        viewer.page.keyboard.press("ArrowDown" if there > here else "ArrowUp")


def test_frames_are_placed_with_keys_only_and_copied_as_python(by_hand, page):
    by_hand.name("button", name="Frame 0, not started").focus()
    for i, T in enumerate(RIGHT):
        choose(by_hand, f"Direction of z {i}", T[:3, 2])
        choose(by_hand, f"Origin of frame {i}", T[:3, 3])
        choose(by_hand, f"Direction of x {i}", T[:3, 0])
        by_hand.name("button", name=f"Frame {i}, placed").focus()
        if i < len(RIGHT) - 1:
            page.keyboard.press("ArrowRight")
    np.testing.assert_allclose(by_hand.frames(), RIGHT, rtol=0, atol=1e-12)
    by_hand.name("button", name="Check the rules").click()
    assert "Checking needs Python, and this page has none." in by_hand.root.locator(".kv-verdict").inner_text()
    by_hand.name("button", name="Copy the frames as Python").click()
    by_hand.root.get_by_text("Copied").wait_for()
    copied = eval(page.evaluate("navigator.clipboard.readText()"), {"pose": pose})
    np.testing.assert_allclose(copied, RIGHT, rtol=0, atol=1e-11)
    assert check_frames(ARM, copied, "standard") == []
    for button in ("Move the origin by 0", "Rotate x by 15 degrees about z"):
        by_hand.name("button", name=button).first.press("Enter")
    changed = by_hand.frames()[3]
    np.testing.assert_allclose(changed[:3, 0] @ RIGHT[3, :3, 0], np.cos(np.radians(15)), atol=1e-12)
    np.testing.assert_allclose(np.cross(changed[:3, 3] - RIGHT[3, :3, 3], RIGHT[3, :3, 2]), 0, atol=1e-12)


def test_an_x_that_is_not_perpendicular_to_a_new_z_is_removed(by_hand):
    by_hand.set(frames=RIGHT)
    by_hand.name("button", name="Frame 3, placed").click()
    z = next(axis for axis in ARM.lines.axis if abs(axis @ RIGHT[3, :3, 0]) > 0.5)
    choose(by_hand, "Direction of z 3", z)
    assert np.isnan(by_hand.frames()[3][:3, :2]).all()
    np.testing.assert_array_equal(by_hand.frames()[3][:3, 2], z)


def test_a_broken_rule_disappears_when_its_frame_changes_and_is_restored_with_it(show):
    viewer = show("broken")
    wrong = viewer.name("button", name="Frame 1, breaks a rule")
    wrong.click()
    viewer.name("button", name="Clear this frame").click()
    assert viewer.get("frames")[1] == UNPLACED[1].tolist()
    assert not wrong.is_visible()
    assert "Check again." in viewer.root.locator(".kv-verdict").inner_text()
    viewer.name("button", name="Undo the last change").click()
    assert wrong.is_visible()


# --- the page ---


@pytest.mark.parametrize(("theme", "background"), [("light", "white"), ("dark", "#111418")])
def test_every_text_has_sufficient_contrast_in_both_themes_which_follow_the_page(page, theme, background):
    """By WCAG 2 at least 4.5, beside the pictures and in them."""
    page.evaluate("colour => { document.body.style.background = colour; }", background)
    page.wait_for_function(
        f"[...document.querySelectorAll('.kv')].every((one) => one.dataset.theme === '{theme}')", timeout=TIMEOUT_MS
    )
    texts = page.evaluate(
        """(() => {
            const background = (node) => { for (; node; node = node.parentElement) {
                const colour = getComputedStyle(node).backgroundColor; if (!/, 0\\)$|transparent/.test(colour)) return colour; } };
            const texts = [...document.querySelectorAll('.kv *')].filter((node) => node.offsetParent
                && [...node.childNodes].some((child) => child.nodeType === 3 && child.data.trim()));
            return texts.map((node) => [node.textContent, getComputedStyle(node).color, background(node)]); })()"""
    )
    assert len(texts) > 200
    # WCAG 1.4.3 allows a low contrast for buttons that are disabled
    off = page.locator(".kv :is([aria-disabled=true], :disabled)").all_inner_texts()
    assert not {text for text, ink, paper in texts if contrast(ink, paper) < 4.5} - set(off)
    drawn = page.evaluate("document.querySelector('.kv').viewer.stage.theme")
    labels = ("ink", "quiet", "axis", "normal", "x", "y", "z", "trail")
    assert not {label for label in labels if contrast(drawn[label], drawn["paper"]) < 4.5}


def test_every_control_has_a_name_its_own_keys_and_a_visible_focus_and_fits_on_a_narrow_page(page):
    page.set_viewport_size({"width": 400, "height": 620})
    overflowing = page.evaluate(
        """[...document.querySelectorAll('.kv *')].filter((node) => node.getBoundingClientRect().right > innerWidth
            && !node.closest('.kv-screen-reader')).map((node) => node.className)"""
    )
    assert not overflowing
    faults = page.locator(".kv canvas, .kv :is(button, input, select):enabled:visible").evaluate_all(
        """all => all.filter((node) => { node.focus({ focusVisible: true });
            return node.dataset.lmSuppressShortcuts !== 'true' || getComputedStyle(node).outlineStyle !== 'solid'
              || (node.getAttribute('aria-label') || node.textContent).trim().length < 2; }).map((node) => node.outerHTML)"""
    )
    assert not faults


def test_a_figure_has_the_theme_of_the_page_and_is_printed_light(chromium_without_webgl, tmp_path):
    """The lab and the site say in their own ways that they are dark; beside each is what the reader prefers."""
    themes = {'data-jp-theme-light="false"': "light", 'data-theme="dark"': "light", 'data-theme="auto"': "dark"}
    light, dark = (255, 255, 255), (23, 27, 33)
    with watched(chromium_without_webgl) as page:
        for attributes, preference in {**themes, "": "dark"}.items():
            body = static_page(tmp_path, draw_arm(RPR).html())
            body.write_text(body.read_text("utf-8").replace("<body ", f"<body {attributes} "), "utf-8")
            page.goto(body.as_uri())
            for media, paper in (("screen", dark if attributes else light), ("print", light)):
                page.emulate_media(color_scheme=preference, media=media)
                pixels = Image.open(BytesIO(page.locator("figure img").screenshot()))
                assert pixels.convert("RGB").getpixel((3, 3)) == paper, (attributes, media)
