"""Meshes of a URDF: found beside it and in packages that were given, never outside of them, and what is missing is said."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from mesh_files import crane, stl, visual, write

import kinlib as kl
from kinlib.view import explore
from kinlib.view.viewer import meshes

PACKAGE = "package://crane_description/meshes/arm.stl"


@pytest.mark.parametrize(
    "place",
    [
        ("meshes/arm.stl", "crane.urdf", "meshes/arm.stl", ()),
        ("../meshes/arm.stl", "own/urdf/crane.urdf", "own/meshes/arm.stl", ()),
        (PACKAGE, "crane.urdf", "crane_description/meshes/arm.stl", ()),
        (PACKAGE, "crane.urdf", "src/crane_description/meshes/arm.stl", ["src"]),
        (PACKAGE, "crane.urdf", "elsewhere/meshes/arm.stl", {"crane_description": "elsewhere"}),
        (PACKAGE, "crane.urdf", "ros/crane_description/meshes/arm.stl", "ROS_PACKAGE_PATH"),
        (PACKAGE, "crane.urdf", "ros/share/crane_description/meshes/arm.stl", "AMENT_PREFIX_PATH"),
        ("../meshes/arm.stl", "own/left/crane.urdf", "own/meshes/arm.stl", Path("own")),
        ("package:///crane/my%20meshes/arm.stl", "crane.urdf", "crane/my meshes/arm.stl", ()),
        (PACKAGE, "crane-main/urdf/crane.urdf", "crane-main/meshes/arm.stl", ()),
        ("model://crane/arm.stl", "crane.urdf", "crane/arm.stl", ()),
        ("../../../meshes/arm.stl", "own/a/b/c/crane.urdf", "own/meshes/arm.stl", "package.xml"),
    ],
)
def test_a_mesh_is_found_in_the_usual_places(tmp_path, monkeypatch, place):
    name, urdf, file, packages = place
    monkeypatch.chdir(tmp_path)
    write(tmp_path, {urdf: crane(visual(name), ""), file: stl()})
    if str(packages).endswith("PATH"):
        monkeypatch.setenv(packages, str(tmp_path / "ros"))
    if packages == "package.xml":
        write(tmp_path, {"own/package.xml": "<package/>"})
    viewer = explore(kl.Tree.from_urdf(urdf), packages=() if isinstance(packages, str) else packages)
    (arm,) = viewer.scene["arms"]
    assert (viewer.notes, viewer.meshes) == ([], {"0.stl": stl()})
    assert [[mesh["name"] for mesh in body] for body in arm["meshes"]] == [[name], []]
    assert np.reshape(arm["meshes"][0][0]["pose"], (4, 4))[:3, 3].tolist() == [0, 0, 0.05]
    assert arm["rule"] == [True, True]


REFUSED = {
    "package://crane/../../secret/arm.stl": "is outside of the folder",
    "../secret/arm.stl": "is outside of the folder",
    "link/arm.stl": "is outside of the folder",
    "link.stl": "is outside of the folder",
    "file://{tmp}/secret/arm.stl": "is outside of the folder",
    "https://example.org/arm.stl": "is an address, and nothing is downloaded",
    "/etc/passwd": "must end in .stl, .obj, .dae or .glb",
    "loop.stl": "was not found",
    "huge.stl": "has 2000 MB; at most 40 MB are read",
    "package://other/arm.stl": r'Add the folder of its package: packages={"other": folder} in Python',
    "missing.stl": r"was not found. Add the folder of its package: packages=\[...\] in Python",
    "&lt;script>alert(1)&lt;/script>.stl": "was not found",
}


@pytest.mark.parametrize("name", REFUSED)
def test_nothing_is_read_outside_of_what_was_given(tmp_path, name):
    write(tmp_path, {"secret/arm.stl": stl(), "secret/a.mtl": "newmtl a", "crane/a.obj": b"mtllib ../secret/a.mtl"})
    folder = tmp_path / "crane"
    with (folder / "huge.stl").open("wb") as file:
        file.truncate(2_000_000_000)
    (folder / "link").symlink_to(tmp_path / "secret")
    (folder / "link.stl").symlink_to(tmp_path / "secret" / "arm.stl")
    (folder / "loop.stl").symlink_to(folder / "loop.stl")
    write(tmp_path, {"crane/crane.urdf": crane(visual(name.format(tmp=tmp_path)), visual("a.obj"))})
    viewer = explore(kl.Tree.from_urdf(folder / "crane.urdf"))
    assert viewer.meshes == {"0.obj": b"mtllib ../secret/a.mtl"}
    (note,) = viewer.notes
    assert re.search(REFUSED[name], note)
    assert viewer.html().count("<script") == 1
    assert all(viewer.scene["arms"][0]["body"])  # by rule


def test_meshes_of_one_robot_have_a_limit_and_reasons_are_said_once(tmp_path, monkeypatch):
    monkeypatch.setattr(meshes, "MAX_ALL_BYTES", 3 * len(stl()))
    names = [f"{k}.stl" for k in range(8)]
    write(tmp_path, {"crane.urdf": crane(*map(visual, names)), **dict.fromkeys(names, stl())})
    viewer = explore(kl.Tree.from_urdf(tmp_path / "crane.urdf"))
    assert list(viewer.meshes) == ["0.stl", "1.stl", "2.stl"]
    (note,) = viewer.notes
    assert note.startswith("5 meshes are not shown, 3.stl, 4.stl, 5.stl and 2 more: the meshes before")


def test_colour_scale_and_wrong_numbers_of_a_mesh(tmp_path):
    red = '<material name="red"><color rgba="1 0 0 1"/></material>'
    texts = [visual("a.stl", red), visual("a.stl", '<material name="red"/>'), visual("a.stl").replace("0.05", "x")]
    texts[1] = texts[1].replace('a.stl"', 'a.stl" scale="0.001 0.001 0.001"')
    write(tmp_path, {"a.stl": stl(), "crane.urdf": crane(*texts).replace('"crane">', f'"crane">{red}')})
    viewer = explore(kl.Tree.from_urdf(tmp_path / "crane.urdf"))
    found = [(mesh["colour"], mesh["scale"]) for body in viewer.scene["arms"][0]["meshes"] for mesh in body]
    assert found == [("#ff0000", [1, 1, 1]), ("#ff0000", [0.001, 0.001, 0.001])]
    assert len(viewer.meshes) == 1
    (note,) = viewer.notes
    assert "Line 1" in note


def test_a_page_of_its_own_has_the_meshes_and_a_notebook_saves_them_once(tmp_path):
    write(tmp_path, {"arm.stl": stl(), "crane.urdf": crane(visual("arm.stl"), "")})
    viewer = explore(kl.Tree.from_urdf(tmp_path / "crane.urdf"))
    for html, count in ((viewer.html(), 1), (viewer._repr_mimebundle_()[0]["text/html"], 0)):
        state = json.loads(re.search(r'<script type="application/json">(.*?)</script>', html)[1])
        assert len(state.get("meshes", {})) == count
        assert ("loaders" in state) == bool(count)
