"""The files of the lab: every hash is checked, and a file that cannot be downloaded is reported."""

import gzip
import hashlib
import importlib
import json
import re
from urllib.error import URLError
from zipfile import ZipFile

import pytest
from built_site import lab
from kinsite.browser_lab import pyodide, wheels
from kinsite.browser_lab.precompile import precompile


def wheel(folder, name="arm", files=("arm/__init__.py",), requires=()):
    """Write a wheel with empty files."""
    path = folder / f"{name}-1.0-py3-none-any.whl"
    needs = "".join(f"Requires-Dist: {need}\n" for need in requires)
    with ZipFile(path, "w") as archive:
        for file in files:
            archive.writestr(file, "")
        archive.writestr(
            f"{name}-1.0.dist-info/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n{needs}"
        )
    return path


def distribution(folder, packages, files):
    """Make a release of Pyodide with these packages in its lock file and these files to download."""
    core = folder / "core"
    core.mkdir()
    (core / "pyodide.mjs").write_text("export {}")
    (core / "pyodide-lock.json").write_text(json.dumps({"info": {"python": "3.12.7"}, "packages": packages}))
    return pyodide.Distribution(core, files.get)


def locked(name, data, depends=()):
    return {
        "name": name, "version": "1.0", "file_name": f"{name}.whl", "sha256": hashlib.sha256(data).hexdigest(),
        "depends": list(depends), "imports": [name],
    }  # fmt: skip


# --- wheels ---


def test_an_entry_lists_the_imports_and_the_requirements_of_a_wheel(tmp_path):
    needs = ["NumPy>=2", "typing_extensions; python_version < '3.12'", "watchfiles; extra == 'dev'", "psygnal"]
    path = wheel(tmp_path, files=("arm/__init__.py", "arm/link.py", "_arm.py", "arm-1.0.data/x.js"), requires=needs)
    entry = wheels.entry(path, "3.12")
    assert entry["imports"] == ["_arm", "arm"]
    assert entry["depends"] == ["numpy", "psygnal"]
    assert entry["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert wheels.entry(path, "3.11")["depends"] == ["numpy", "psygnal", "typing-extensions"]


def test_the_course_becomes_a_wheel_whose_name_contains_its_hash(tmp_path):
    built, again = wheels.build(tmp_path / "one"), wheels.build(tmp_path / "two")
    assert built.name == again.name
    entry = wheels.entry(built)
    assert entry["imports"] == ["kincourse", "kinlib", "misstep"]
    assert entry["sha256"][:12] in entry["file_name"]
    assert {"numpy", "sympy", "matplotlib", "anywidget"} <= set(entry["depends"])


def test_a_wheel_with_another_hash_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    (tmp_path / "arm-1.0").mkdir()
    path = wheel(tmp_path / "arm-1.0")
    assert wheels.download("arm", "1.0", sha256=wheels.sha256_of(path)) == path
    with pytest.raises(ValueError, match=r"arm-1\.0-py3-none-any\.whl must have the sha256 beef; got [0-9a-f]{64}"):
        wheels.download("arm", "1.0", sha256="beef")
    assert not path.exists(), "the next build downloads it again"


def test_a_wheel_that_pip_cannot_download_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(wheels, "DOWNLOADS", tmp_path)
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    with pytest.raises(wheels.Unreachable, match=r"pip could not download arm 1\.0: .*No matching distribution"):
        wheels.download("arm", "1.0")


# --- Pyodide ---


def test_a_distribution_contains_the_required_packages_and_no_others(tmp_path, monkeypatch):
    packages = {name: locked(name, name.encode(), needs) for name, needs in
                {"numpy": ["blas"], "blas": [], "pandas": ["numpy"], "micropip": ["jupyterlab-widgets"]}.items()}  # fmt: skip
    source = distribution(tmp_path, packages, {f"{name}.whl": name.encode() for name in packages})
    (tmp_path / "kinlib").mkdir()
    own = wheel(tmp_path / "kinlib", "kinlib", ["kinlib/__init__.py"], ["numpy"])
    names = pyodide.install(source, [own], tmp_path / "out")
    assert names == ["blas", "kinlib", "micropip", "numpy"]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(
        ["blas.whl", own.name, "micropip.whl", "numpy.whl", "pyodide.mjs", "pyodide-lock.json", "sizes.json"]
    )
    sizes = json.loads((tmp_path / "out" / "sizes.json").read_text("utf-8"))
    assert sizes["numpy.whl"] == len("numpy"), "the page shows how much of it has been loaded"
    assert "sizes.json" not in sizes
    lock = json.loads((tmp_path / "out" / "pyodide-lock.json").read_text("utf-8"))["packages"]
    assert lock["micropip"]["depends"] == [], "the lab has its own scripts for widgets"


def test_a_package_whose_hash_is_not_that_of_the_lock_file_is_refused(tmp_path):
    source = distribution(tmp_path, {"numpy": locked("numpy", b"right")}, {"numpy.whl": b"cut off"})
    (tmp_path / "kinlib").mkdir()
    own = wheel(tmp_path / "kinlib", "kinlib", ["kinlib/__init__.py"], ["numpy"])
    with pytest.raises(ValueError, match=r"numpy\.whl must have the sha256 [0-9a-f]{64}; got .*incomplete"):
        pyodide.install(source, [own], tmp_path / "out")


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
        precompile(str(tmp_path / "arm.whl"), str(tmp_path / name), with_sources, loaded)
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


def test_an_unknown_release_is_refused(monkeypatch):
    monkeypatch.setenv(lab.VARIABLE, "offical")
    with pytest.raises(ValueError, match=r"KINLIB_LAB must be one of official, offline, none; got 'offical'"):
        lab.build()


@pytest.mark.parametrize(("choice", "fails"), [("", False), ("official", True)])
def test_without_a_network_the_lab_is_left_out_unless_it_was_requested(tmp_path, monkeypatch, capsys, choice, fails):
    def no_network(address, timeout):
        raise URLError("no route")

    monkeypatch.setenv(lab.VARIABLE, choice)
    monkeypatch.setattr(lab, "LABS", tmp_path / "built")
    monkeypatch.setattr(pyodide.urllib.request, "urlopen", no_network)
    monkeypatch.setattr(pyodide, "DOWNLOADS", tmp_path)
    monkeypatch.setattr(pyodide, "MODULES", tmp_path)
    (tmp_path / "pyodide").mkdir()
    (tmp_path / "pyodide" / "package.json").write_text('{"version": "9.9.9"}')
    locks = {"info": {"python": "3.14.0"}, "packages": {"numpy": locked("numpy", b"")}}
    (tmp_path / "pyodide" / "pyodide-lock.json").write_text(json.dumps(locks))
    monkeypatch.setattr(wheels, "build", lambda _: [wheel(tmp_path, "kinlib", requires=["numpy"])])
    monkeypatch.setattr(lab, "EXTENSIONS", (tmp_path,))
    if fails:
        with pytest.raises(wheels.Unreachable, match=r"v9\.9\.9/full/\S+ could not be downloaded: .*no route"):
            lab.build()
    else:
        assert lab.build() is None
        assert "The site has no lab" in capsys.readouterr().err


def test_the_page_of_a_notebook_begins_with_a_preview_and_the_service_worker_knows_its_version(tmp_path):
    for app in lab.APPS:
        (tmp_path / app).mkdir()
        (tmp_path / app / "index.html").write_text('<html><head></head><body class="x"><div></div></body></html>')
        lab.complete_page(tmp_path / app / "index.html")
    pages = {app: (tmp_path / app / "index.html").read_text() for app in lab.APPS}
    assert all('<html lang="en"><head>' in page and "favicon.svg" in page for page in pages.values())
    assert '<body class="x">\n<style>' in pages["notebooks"]
    assert 'src="../start.js"' in pages["notebooks"]
    assert "start.js" not in pages["tree"]
    (tmp_path / "service-worker.js").write_text("theirs();")
    python = tmp_path / "static" / "pyodide"
    python.mkdir(parents=True)
    needs = {
        "ipython": ["numpy", "jedi"],
        "kincourse": ["sympy"],
        "numpy": [],
        "sympy": [],
        "jedi": [],
        "pillow": ["numpy"],
    }
    packages = {name: {"file_name": f"{name}.whl", "depends": needed} for name, needed in needs.items()}
    for name in packages:
        with ZipFile(python / f"{name}.whl", "w") as archive:
            archive.writestr(f"{name}/__init__.py", f"{name} = 1\n")
    (python / "pyodide-lock.json").write_text(json.dumps({"packages": packages}))
    (python / "pyodide.mjs").write_bytes(bytes(1_000_000))
    (python / f"{lab.WASM}.packed").write_bytes(bytes(11_000_000))
    lab.add_own_files(tmp_path)
    worker = (tmp_path / "service-worker.js").read_text()
    assert re.match(r"const VERSION = '[0-9a-f]{16}';\n", worker)
    assert worker.endswith("theirs();")
    live = tmp_path / "live"
    assert {path.name for path in live.iterdir()} == {
        "live-lock.json", "load.json", "packages.packed", "shell.py", "worker.js"
    }  # fmt: skip
    loads = json.loads((live / "load.json").read_text())
    small = sum((live / name).stat().st_size for name in ("live-lock.json", "packages.packed"))
    assert loads == {"total": 12_000_000 + small, "modules": 1_000_000, "later": {"sympy": ["sympy.whl"]}}
    assert lab.megabytes(tmp_path) == "13"
    sizes, _, contents = gzip.decompress((live / "packages.packed").read_bytes()).partition(b"\n")
    assert list(json.loads(sizes)) == ["ipython/__init__.py", "kincourse/__init__.py", "numpy/__init__.py"]
    assert contents == b"ipython = 1\nkincourse = 1\nnumpy = 1\n"
    lock = json.loads((live / "live-lock.json").read_text())["packages"]
    assert {name: entry["depends"] for name, entry in lock.items()} == {"jedi": [], "pillow": []}


def test_the_lab_is_copied_to_the_site_when_it_changes_and_deleted_when_there_is_none(tmp_path):
    built, target = tmp_path / "offline" / "html", tmp_path / "site" / "lab"
    built.mkdir(parents=True)
    (built / "index.html").write_text("a lab")
    lab.hash_file(built.parent).write_text("first hash")
    lab.copy_to_site(built, target)
    (target / "index.html").write_text("not copied again")
    lab.copy_to_site(built, target)
    assert (target / "index.html").read_text() == "not copied again"
    lab.hash_file(built.parent).write_text("second hash")
    lab.copy_to_site(built, target)
    assert (target / "index.html").read_text() == "a lab"
    lab.copy_to_site(None, target)
    assert not target.exists()
