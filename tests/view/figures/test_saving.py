"""Pictures and viewers are saved with their text alternatives, and kl.show opens them outside notebooks."""

import json
import re
import sys
import webbrowser
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import urlparse
from urllib.request import url2pathname
from xml.etree import ElementTree as ET

import pytest
from answered import Answered

import kinlib as kl
from kinlib import view
from kinlib.view import Picture
from kinlib.view.figures.arm import describe_arm

ALT = "A curve & its <tangent>, 0.5 m long. The two meet at 1."
Q = [0, 0.5, -0.5, 0, 1, 0]
FOUR_BAR = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
SHOWN = {
    "a drawing": lambda: view.draw_arm(kl.robots.puma560(), Q),
    "a plot": lambda: view.plot([1, 2], {"y": [1, 2]}, xlabel="x", ylabel="y", alt=ALT),
    "a viewer": lambda: view.explore(kl.robots.puma560(), start=Q),
    "an assignment": lambda: view.play_assignment(kl.robots.rpr(), convention="standard"),
}


@pytest.mark.parametrize("shown", SHOWN)
def test_a_saved_drawing_contains_its_text_alternative_and_a_saved_page_needs_nothing_else(shown, tmp_path):
    shown = SHOWN[shown]()
    shown.save(tmp_path / "it.SVG")
    image = ET.parse(tmp_path / "it.SVG").getroot()
    title, description = image[:2]
    picture = shown if isinstance(shown, Picture) else shown.picture()
    assert description.tag.endswith("}desc")
    assert description.text == picture.alt
    assert title.tag.endswith("}title")
    assert title.text == picture.caption or picture.alt.startswith(title.text)
    assert image.get("role") == "img"
    assert {element.tag for element in ET.fromstring(picture.svg).iter()} < {element.tag for element in image.iter()}
    shown.save(tmp_path / "it.html")
    text = (tmp_path / "it.html").read_text("utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert not re.search(r"""(src|href)=["'](?!data:)""", text.partition('"use strict"')[0])
    if isinstance(shown, Picture):
        assert "<script" not in text
        return
    state = json.loads(re.search(r'<script type="application/json">(.*?)</script>', text)[1])
    assert state["scene"] == json.loads(json.dumps(shown.scene))
    assert text.endswith("kinlib.startViewers();</script></body></html>")
    assert text.count("</script") == 2  # the script of the viewer does not end its own element


def test_a_viewer_that_waits_for_a_question_is_not_saved(tmp_path):
    viewer = view.explore(kl.robots.rpr(), after=(question := Answered()))
    with pytest.raises(ValueError, match="waits for a question"):
        viewer.save(tmp_path / "arm.html")
    question.committed = True
    viewer.save(tmp_path / "arm.html")


# --- kl.show ---


@pytest.fixture
def opened(monkeypatch, tmp_path):
    """The addresses that would be opened in a web browser."""
    addresses = []
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(webbrowser, "open", lambda address: addresses.append(address) or True)
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: None))
    return addresses


def test_show_opens_a_page_of_the_arm_in_the_browser(opened, capsys):
    kl.show(kl.robots.puma560(), Q)
    (address,) = map(urlparse, opened)
    assert address.scheme == "file"
    text = Path(url2pathname(address.path)).read_text("utf-8")
    assert "<title>PUMA 560, 6 joints (RRRRRR), at q = (0, 0.5, -0.5, 0, 1, 0).</title>" in text
    assert not capsys.readouterr().out


def test_show_takes_every_kind_of_robot_with_values_by_name(opened, tmp_path):
    arm = kl.robots.rpr()
    named = kl.Chain(arm.screws, arm.home, joint_names=("a", "b", "c"))
    table = kl.assign_frames(arm, convention="standard").table
    closed = FOUR_BAR.assembly_modes(hold={"A": 1.0})[0]
    by_name = {"c": 0.3, "a": 0.1, "b": 0.2}
    for robot, q, alt in (
        (named, by_name, describe_arm(named, [0.1, 0.2, 0.3])),
        (table, [0.1, 0.2, 0.3], None),
        (kl.Tree.from_urdf(kl.to_urdf(named)), by_name, None),
        (FOUR_BAR, dict(zip(FOUR_BAR.names, closed, strict=True)), view.draw_linkage(FOUR_BAR, closed).alt),
    ):
        kl.show(robot, q, path=tmp_path / "robot.svg")
        shown = ET.parse(tmp_path / "robot.svg").getroot()[1].text
        assert shown == alt if alt else "at q = (0.1, 0.2, 0.3)" in shown
    kl.show(view.slide(lambda x: view.draw_arm(arm, [x, 0, 0]), "joint 1", [0, 1]), path=tmp_path / "slider.html")
    assert "RPR, 3 joints" in (tmp_path / "slider.html").read_text("utf-8")
    assert view.draw_arm(named, by_name).alt == view.draw_arm(named, [0.1, 0.2, 0.3]).alt
    assert view.explore(named, start=by_name).q == [0.1, 0.2, 0.3]
    assert not opened
