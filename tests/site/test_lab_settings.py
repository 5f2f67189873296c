"""The files of the lab: every hash is checked, and a file that cannot be downloaded is reported."""

import importlib
from zipfile import ZipFile

import pytest
from built_site import lab
from kinsite.browser_lab import wheels
from kinsite.browser_lab.precompile import compile_loaded, rewrite

# --- wheels ---


def test_the_course_becomes_a_wheel_whose_name_contains_its_hash(tmp_path):
    built, again = wheels.build(tmp_path / "one"), wheels.build(tmp_path / "two")
    assert built.name == again.name
    entry = wheels.entry(built)
    assert entry["imports"] == ["kincourse", "kinlib", "misstep"]
    assert entry["sha256"][:12] in entry["file_name"]
    assert {"numpy", "sympy", "matplotlib", "anywidget"} <= set(entry["depends"])


def test_a_wheel_with_another_hash_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    path = tmp_path / "arm-1.0" / "arm-1.0-py3-none-any.whl"
    path.parent.mkdir()
    path.write_bytes(b"a wheel")
    assert wheels.download("arm", "1.0", sha256=wheels.sha256_of(path)) == path
    with pytest.raises(ValueError, match=r"arm-1\.0-py3-none-any\.whl must have the sha256 beef; got [0-9a-f]{64}"):
        wheels.download("arm", "1.0", sha256="beef")
    assert not path.exists(), "the next build downloads it again"


# --- compiled modules ---


def test_loaded_modules_are_compiled_and_nothing_is_kept_that_no_cell_can_use(tmp_path, monkeypatch):
    sources = {
        "arm_one/__init__.py": "from arm_one import link\nfrom arm_one.rest import y",
        "arm_one/link.py": "x = 1",
        "arm_one/rest.py": "y = 2",
        "arm_one/table.csv": "1,2",
    }
    unused = ["arm_one/tests/test_link.py", "arm_one/link.pyi", "arm_one-1.dist-info/RECORD", "arm-1.data/share/lab.js"]
    with ZipFile(tmp_path / "arm.whl", "w") as archive:
        for name, text in (sources | dict.fromkeys(unused, "")).items():
            archive.writestr(name, text)
    loaded = {"arm_one/__init__.py", "arm_one/link.py"}
    for name, with_sources in (("small.whl", False), ("again.whl", False), ("whole.whl", True)):
        compile_loaded(str(tmp_path / "arm.whl"), str(tmp_path / "modules.zip"), with_sources, loaded)
        rewrite(tmp_path / "arm.whl", tmp_path / "modules.zip", tmp_path / name)
    assert (tmp_path / "small.whl").read_bytes() == (tmp_path / "again.whl").read_bytes()
    small, whole = (set(ZipFile(tmp_path / name).namelist()) for name in ("small.whl", "whole.whl"))
    assert small == {"arm_one/__init__.pyc", "arm_one/link.pyc", "arm_one/rest.py", "arm_one/table.csv"}
    assert set(sources) < whole
    assert len(whole) == len(sources) + len(loaded)
    monkeypatch.syspath_prepend(tmp_path / "small.whl")
    arm_one = importlib.import_module("arm_one")
    assert (arm_one.link.x, arm_one.y) == (1, 2)
    assert arm_one.__file__.endswith(".pyc")


# --- the lab ---


def test_without_a_network_the_lab_is_left_out_unless_it_was_requested(tmp_path, monkeypatch, capsys):
    def no_network(folder):
        raise wheels.Unreachable("no route")

    monkeypatch.setattr(lab, "LAB", tmp_path)
    monkeypatch.setattr(lab, "build_with_jupyterlite", no_network)
    monkeypatch.setenv(lab.VARIABLE, "offline")
    with pytest.raises(wheels.Unreachable, match="no route"):
        lab.build()
    monkeypatch.setenv(lab.VARIABLE, "")
    assert lab.build() is None
    assert "The site has no lab" in capsys.readouterr().err
