"""What the lab is built of: each file is the one that we know, and what cannot be had is told, not left out in silence."""

import hashlib
import json
from urllib.error import URLError
from zipfile import ZipFile

import pytest
from built_site import lab
from kinsite import pyodide, wheels


def wheel(folder, name="arm", files=("arm/__init__.py",), requires=()):
    """A wheel that holds next to nothing."""
    path = folder / f"{name}-1.0-py3-none-any.whl"
    told = "".join(f"Requires-Dist: {need}\n" for need in requires)
    with ZipFile(path, "w") as archive:
        for file in files:
            archive.writestr(file, "")
        archive.writestr(f"{name}-1.0.dist-info/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n{told}")
    return path


def distribution(folder, packages, brings):
    """A release of Pyodide with these packages in its lock file, whose source has these files."""
    core = folder / "core"
    core.mkdir()
    (core / "pyodide.mjs").write_text("export {}")
    (core / "pyodide-lock.json").write_text(json.dumps({"info": {"python": "3.12.7"}, "packages": packages}))
    return pyodide.Distribution(core, brings.get)


def locked(name, data, depends=()):
    return {
        "name": name, "version": "1.0", "file_name": f"{name}.whl", "sha256": hashlib.sha256(data).hexdigest(),
        "depends": list(depends), "imports": [name],
    }  # fmt: skip


# --- wheels ---


def test_an_entry_says_what_an_import_loads_and_what_it_needs(tmp_path):
    needs = ["NumPy>=2", "typing_extensions; python_version < '3.12'", "watchfiles; extra == 'dev'", "psygnal"]
    path = wheel(tmp_path, files=("arm/__init__.py", "arm/link.py", "_arm.py", "arm-1.0.data/x.js"), requires=needs)
    entry = wheels.entry(path, "3.12")
    assert entry["imports"] == ["_arm", "arm"]
    assert entry["depends"] == ["numpy", "psygnal"]
    assert entry["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert wheels.entry(path, "3.11")["depends"] == ["numpy", "psygnal", "typing-extensions"]


def test_kinlib_s_wheel_is_named_by_what_it_holds(tmp_path):
    first, again = wheels.build(tmp_path / "one")[0], wheels.build(tmp_path / "two")[0]
    assert first.name == again.name
    assert wheels.sha256_of(first)[:12] in first.name
    assert wheels.entry(first)["imports"] == ["kinlib"]
    assert {"numpy", "sympy", "matplotlib", "anywidget", "defusedxml"} <= set(wheels.entry(first)["depends"])


def test_a_wheel_that_is_another_one_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    (tmp_path / "arm-1.0").mkdir()
    path = wheel(tmp_path / "arm-1.0")
    assert wheels.download("arm", "1.0", sha256=wheels.sha256_of(path)) == path
    with pytest.raises(ValueError, match=r"arm-1\.0-py3-none-any\.whl must have the sha256 beef; got [0-9a-f]{64}"):
        wheels.download("arm", "1.0", sha256="beef")
    assert not path.exists(), "the next build fetches it anew"


def test_what_pip_cannot_fetch_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    with pytest.raises(wheels.Unreachable, match=r"pip could not download arm 1\.0: .*No matching distribution"):
        wheels.download("arm", "1.0")


# --- Pyodide ---


def test_what_is_asked_for_comes_with_all_that_it_needs_and_nothing_else(tmp_path, monkeypatch):
    packages = {name: locked(name, name.encode(), needs) for name, needs in
                {"numpy": ["blas"], "blas": [], "pandas": ["numpy"], "micropip": ["jupyterlab-widgets"]}.items()}  # fmt: skip
    source = distribution(tmp_path, packages, {f"{name}.whl": name.encode() for name in packages})
    (tmp_path / "kinlib").mkdir()
    own = wheel(tmp_path / "kinlib", "kinlib", ["kinlib/__init__.py"], ["numpy"])
    names = pyodide.install(source, [own], tmp_path / "out")
    assert names == ["blas", "kinlib", "micropip", "numpy"]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(
        ["blas.whl", own.name, "micropip.whl", "numpy.whl", "pyodide.mjs", "pyodide-lock.json"]
    )
    lock = json.loads((tmp_path / "out" / "pyodide-lock.json").read_text("utf-8"))["packages"]
    assert lock["micropip"]["depends"] == [], "what the lab has of its own is not asked for"


def test_a_package_that_is_not_the_locked_one_is_refused(tmp_path):
    source = distribution(tmp_path, {"numpy": locked("numpy", b"right")}, {"numpy.whl": b"cut off"})
    (tmp_path / "kinlib").mkdir()
    own = wheel(tmp_path / "kinlib", "kinlib", ["kinlib/__init__.py"], ["numpy"])
    with pytest.raises(ValueError, match=r"numpy\.whl must have the sha256 [0-9a-f]{64}; got .*incomplete"):
        pyodide.install(source, [own], tmp_path / "out")


# --- the lab ---


def test_a_word_that_says_no_python_is_refused(monkeypatch):
    monkeypatch.setenv(lab.VARIABLE, "offical")
    with pytest.raises(ValueError, match=r"KINLIB_LAB must be one of official, offline, none; got 'offical'"):
        lab.build()


@pytest.mark.parametrize(("asked", "fails"), [("", False), ("official", True)])
def test_without_a_network_there_is_no_lab_or_no_site(tmp_path, monkeypatch, capsys, asked, fails):
    def unplugged(address, timeout):
        raise URLError("no route")

    monkeypatch.setenv(lab.VARIABLE, asked)
    monkeypatch.setattr(lab, "LABS", tmp_path / "built")
    monkeypatch.setattr(lab, "EXTENSIONS", (tmp_path / "no kernel",))
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    monkeypatch.setattr(pyodide, "DOWNLOADS", tmp_path)
    monkeypatch.setattr(wheels, "build", lambda _: [wheel(tmp_path, "kinlib", ["kinlib/__init__.py"], ["numpy"])])
    monkeypatch.setattr(pyodide.urllib.request, "urlopen", unplugged)
    core = tmp_path / "pyodide"
    core.mkdir()
    (core / "package.json").write_text('{"version": "9.9.9"}')
    locks = {"info": {"python": "3.14.0"}, "packages": {"numpy": locked("numpy", b"")}}
    (core / "pyodide-lock.json").write_text(json.dumps(locks))
    monkeypatch.setattr(pyodide, "MODULES", tmp_path)
    if fails:
        with pytest.raises(wheels.Unreachable, match=r"v9\.9\.9/full/\S+ could not be downloaded: .*no route"):
            lab.build()
    else:
        assert lab.build() is None
        assert "The site has no lab" in capsys.readouterr().err


def test_a_lab_is_put_among_the_pages_once_and_taken_away_with_its_button(tmp_path):
    built, target = tmp_path / "offline" / "html", tmp_path / "site" / "lab"
    built.mkdir(parents=True)
    (built / "index.html").write_text("a lab")
    lab.hash_file(built.parent).write_text("of this")
    lab.copy_to_site(built, target)
    (target / "index.html").write_text("as it was")
    lab.copy_to_site(built, target)
    assert (target / "index.html").read_text() == "as it was"
    lab.hash_file(built.parent).write_text("of that")
    lab.copy_to_site(built, target)
    assert (target / "index.html").read_text() == "a lab"
    lab.copy_to_site(None, target)
    assert not target.exists()
