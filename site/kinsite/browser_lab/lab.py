"""The course in the browser: JupyterLite with the notebooks, our wheel and Python, on the same site as the pages.

The environment variable KINLIB_LAB=none leaves it out; with KINLIB_LAB=offline the build fails if the lab cannot be downloaded,
and without the variable the site is then built without a lab.
"""

import gzip
import hashlib
import io
import json
import math
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from zipfile import ZipFile, ZipInfo

from packaging.utils import canonicalize_name

from kinsite.browser_lab import pyodide, wheels
from kinsite.browser_lab.precompile import rewrite
from kinsite.browser_lab.wheels import Unreachable
from kinsite.execute import ROOT, package_hash

VARIABLE = "KINLIB_LAB"

SITE = ROOT / "site"
LAB = ROOT / "build" / "lab" / "built"
LABEXTENSIONS = Path(sys.prefix) / "share" / "jupyter" / "labextensions"
EXTENSIONS = (
    LABEXTENSIONS / "@jupyterlite" / "pyodide-kernel-extension",
    LABEXTENSIONS / "@jupyter-widgets" / "jupyterlab-manager",
    LABEXTENSIONS / "anywidget",
    SITE / "lab" / "extension",
)
"""The kernel, the widgets, and the extension of the course, which adds messages and records solved problems."""

NEVER = ("jedi", "prompt-toolkit", "sqlite3", "wcwidth")
"""What IPython requires for typing in a terminal, for completion and for a history, which a page has not (live/shell.py)."""

WASM, MODULES = "pyodide.asm.wasm", "python_stdlib.zip"
"""The files of Python itself that a page loads compressed, with the ending `.packed`."""

WARM_UP = """
import sympy
from kincourse import open_sheet
sheet = open_sheet("03_poe_space", "a student")
sheet.show(1)
sheet.check(1, sheet.problem(1).answer.value)
"""
"""What loads the modules that are compiled while the lab is built, after live/shell.py has. What only one lecture has is not."""

LIVE_PACKAGES = ("ipython", "kincourse")
"""What a page loads before its first cell runs, with all that they require; a cell may load more."""

LATER = ("matplotlib", "mpmath", "sympy")
"""What these require, but a page loads only when a cell uses it: together they are larger than the rest."""

APPS = ("tree", "notebooks")


def build() -> Path | None:
    """Build the lab unless it is up to date. Returns its folder, or None if the site has no lab.

    Raises ValueError for an unknown value of KINLIB_LAB, Unreachable if the variable asks for a lab and it cannot be downloaded.
    """
    choice = os.environ.get(VARIABLE, "")
    if choice not in ("", "offline", "none"):
        raise ValueError(f"{VARIABLE} must be offline or none; got {choice!r}.")
    if choice == "none":
        return None
    current, finished = input_hash(), LAB / "input_hash.txt"  # which does not exist while the lab is being built
    try:
        if not finished.exists() or finished.read_text("utf-8") != current:
            build_with_jupyterlite(LAB)
            finished.write_text(current, "utf-8")
        return LAB / "html"
    except Unreachable as error:
        if choice:
            raise
        print(f"The site has no lab, and no cell runs on its pages. {error}", file=sys.stderr)
    return None


def build_with_jupyterlite(folder: Path) -> None:
    """Build the lab into an empty folder."""
    shutil.rmtree(folder, ignore_errors=True)
    kernel = sorted((EXTENSIONS[0] / "static" / "pypi").glob("*.whl"))
    packages = pyodide.install([wheels.build(folder / "wheel"), *kernel], folder / "python")
    precompile(folder / "python", folder / "static" / "pyodide")
    for path in contents():
        target = folder / "contents" / path.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    shutil.copy(SITE / "lab" / "overrides.json", folder)
    loaded = {"packages": [name for name in pyodide.KERNEL if name in packages]}
    kernel_settings = {"disablePyPIFallback": True, "loadPyodideOptions": loaded}
    settings = {
        "appName": "Forward kinematics",
        "appUrl": "./tree/",
        "litePluginSettings": {"@jupyterlite/pyodide-kernel-extension:kernel": kernel_settings},
    }
    whole = {"jupyter-lite-schema-version": 0, "jupyter-config-data": settings}
    (folder / "jupyter-lite.json").write_text(json.dumps(whole), "utf-8")
    config = {
        "apps": APPS,
        "cache_dir": str(folder / "cache"),
        "contents": [str(folder / "contents")],
        "federated_extensions": [str(path) for path in EXTENSIONS],
        "ignore_sys_prefix": ["federated_extensions"],
        "no_sourcemaps": True,
        "no_unused_shared_packages": True,
        "output_dir": str(folder / "html"),
    }
    (folder / "jupyter_lite_config.json").write_text(json.dumps({"LiteBuildConfig": config}), "utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "jupyterlite_core", "build", f"--lite-dir={folder}"],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        raise ValueError(f"JupyterLite failed:\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    add_own_files(folder / "html")
    for app in APPS:
        complete_page(folder / "html" / app / "index.html")


def precompile(source: Path, target: Path) -> None:
    """Copy the files of Python; those that a page loads with compiled modules and without what no cell can use (precompile.py).

    The WebAssembly of Python and its own modules are there twice: pages load them compressed as a whole, because not every
    server compresses, and because a browser unpacks them faster than Python does.

    Raises ValueError if the modules cannot be compiled.
    """
    lock = json.loads((source / "pyodide-lock.json").read_text("utf-8"))
    entries: dict[str, Any] = {canonicalize_name(name): entry for name, entry in lock["packages"].items()}
    loaded = sorted(required(entries, LIVE_PACKAGES, set(LATER) - {"matplotlib"}))
    archives = {MODULES: False} | {entries[name]["file_name"]: name == LIVE_PACKAGES[1] for name in loaded}
    shutil.copytree(source, target)
    warm_up = source.parent / "warm_up.py"
    warm_up.write_text((SITE / "lab" / "live" / "shell.py").read_text("utf-8") + WARM_UP, "utf-8")
    settings = {"packages": LIVE_PACKAGES, "archives": archives}
    modules = source.parent / "modules"
    modules.mkdir()
    command = (
        shutil.which("node") or "node", Path(__file__).with_name("precompile.mjs"),
        source, modules, warm_up, json.dumps(settings),
    )  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ValueError(f"The modules of Python could not be compiled:\n{done.stderr[-2000:]}")
    for name in archives:
        rewrite(source / name, modules / name, target / name)
    for entry in entries.values():
        entry["sha256"] = wheels.sha256_of(target / entry["file_name"])
    (target / "pyodide-lock.json").write_text(json.dumps(lock), "utf-8")
    for name, data in ((WASM, (target / WASM).read_bytes()), (MODULES, stored(target / MODULES))):
        (target / f"{name}.packed").write_bytes(gzip.compress(data, mtime=0))


def stored(archive: Path) -> bytes:
    """Write an archive again without compressing its files."""
    again = io.BytesIO()
    with ZipFile(archive) as old, ZipFile(again, "w") as new:
        for file in old.infolist():
            new.writestr(ZipInfo(file.filename), old.read(file))
    return again.getvalue()


def pack(archives: Iterable[Path]) -> bytes:
    """Put the files of all archives one after the other, behind a line with their sizes, and compress all of them.

    One package would be loaded like any other, but Python takes five times as long to unpack twenty.
    """
    files: dict[str, bytes] = {}
    for archive in archives:
        with ZipFile(archive) as opened:
            files |= {name: opened.read(name) for name in opened.namelist()}
    alike = sorted(files, key=lambda name: (Path(name).suffix, name))  # which makes the whole smaller
    sizes = json.dumps({name: len(files[name]) for name in alike})
    return gzip.compress(b"\n".join([sizes.encode(), b"".join(files[name] for name in alike)]), mtime=0)


def add_own_files(built: Path) -> None:
    """Add what the pages of the course run in Python."""
    live, python = built / "live", built / "static" / "pyodide"
    shutil.copytree(SITE / "lab" / "live", live)
    whole = json.loads((python / "pyodide-lock.json").read_text("utf-8"))
    lock: dict[str, Any] = {canonicalize_name(name): entry for name, entry in whole["packages"].items()}
    needed = required(lock, LIVE_PACKAGES)
    (live / "packages.packed").write_bytes(pack(python / lock[name]["file_name"] for name in sorted(needed)))
    # no import loads from the lock file of a page what is there already, or what shell.py loads
    elsewhere = {*needed, *LATER}
    whole["packages"] = {
        name: entry | {"depends": [other for other in entry["depends"] if canonicalize_name(other) not in elsewhere]}
        for name, entry in lock.items()
        if name not in elsewhere
    }
    (live / "live-lock.json").write_text(json.dumps(whole), "utf-8")
    files = [*live.glob("*.json"), *live.glob("*.packed"), *python.glob("*.packed"), *python.glob("*.*js")]
    sizes = {path.name: path.stat().st_size for path in files}
    modules = sum(size for name, size in sizes.items() if name.endswith("js"))
    later = {name: sorted(required(lock, [name], {name}) - needed) for name in LATER if name in lock}
    named = {name: [lock[other]["file_name"] for other in others] for name, others in later.items()}
    load = {"total": sum(sizes.values()), "modules": modules, "later": named}
    (live / "load.json").write_text(json.dumps(load), "utf-8")


def required(lock: dict[str, Any], names: Iterable[str], wanted: Iterable[str] = ()) -> set[str]:
    """Return packages and all that they require, without what is loaded never, or later unless it is wanted."""
    needed: set[str] = set()
    todo = list(names)
    while todo:
        name = canonicalize_name(todo.pop())
        if name not in needed and name not in NEVER and (name not in LATER or name in wanted):
            needed.add(name)
            todo += lock[name]["depends"]
    return needed


def megabytes(built: Path | None) -> str:
    """Return how many megabytes of Python a page loads, or nothing if there is no lab."""
    if built is None:
        return ""
    return str(math.ceil(json.loads((built / "live" / "load.json").read_text("utf-8"))["total"] / 1e6))


def complete_page(page: Path) -> None:
    """Add a language and an icon to a page of JupyterLite. Without an icon, browsers request a file that does not exist."""
    icon = '<link rel="icon" type="image/svg+xml" href="../../_static/favicon.svg">'
    text = page.read_text("utf-8").replace("<html>", '<html lang="en">')
    page.write_text(text.replace("<head>", f"<head>\n    {icon}", 1), "utf-8")


def contents() -> Iterable[Path]:
    """List the files in the lab: lectures, their pictures, released sheets and what they link to."""
    yield from sorted((ROOT / "notebooks").glob("*.ipynb"))
    yield from sorted((ROOT / "notebooks" / "pictures").glob("*.svg"))
    yield from sorted(path for path in (ROOT / "exercises").glob("*/*") if path.suffix in (".ipynb", ".json"))
    yield ROOT / "NOTATION.md"


def input_hash() -> str:
    """Hash everything that the lab is built from."""
    digest = hashlib.sha256(package_hash().encode())
    extension = [path for path in (SITE / "lab").rglob("*") if path.is_file()]
    modules = sorted(path for path in Path(__file__).parent.iterdir() if path.is_file())
    for path in (*contents(), *sorted(extension), *modules, SITE / "package-lock.json"):
        digest.update(path.read_bytes())
    return digest.hexdigest()
