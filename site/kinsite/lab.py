"""The course in the browser: JupyterLite with the notebooks, kinlib and Python itself, on the same site as the pages.

KINLIB_LAB says which Python it gets:
    official   Pyodide's newest release, which is what the published site serves; it needs the open network
    offline    the older release that tests take, which package registries are enough for
    none       no lab, and no buttons that lead to it
Unless it says so, the official one is tried, and where it cannot be had the site is built without a lab.
"""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from kinsite import pyodide, wheels
from kinsite.execute import ROOT, library
from kinsite.wheels import Unreachable

VARIABLE = "KINLIB_LAB"
SOURCES = {"official": pyodide.official, "offline": pyodide.offline}

SITE = ROOT / "site"
BUILT = ROOT / "build" / "lab"
LABEXTENSIONS = Path(sys.prefix) / "share" / "jupyter" / "labextensions"
EXTENSIONS = (
    LABEXTENSIONS / "@jupyterlite" / "pyodide-kernel-extension",
    LABEXTENSIONS / "@jupyter-widgets" / "jupyterlab-manager",
    LABEXTENSIONS / "anywidget",
    SITE / "lab" / "extension",
)
"""The kernel, widgets, the viewer's frame, and what the course adds: messages, and what was solved."""

PAGES = ("tree", "notebooks")
"""Of JupyterLite's pages, a notebook on its own, and the folder that it lies in."""


def build() -> Path | None:
    """Build the lab, unless nothing that it is made of has changed. Gives its folder, or None where there is none.

    Raises ValueError for a word in KINLIB_LAB that it does not know, Unreachable where what it asks for cannot be had.
    """
    asked = os.environ.get(VARIABLE, "")
    if asked == "none":
        return None
    if asked not in ("", *SOURCES):
        raise ValueError(f"{VARIABLE} should be one of {', '.join([*SOURCES, 'none'])}; got {asked!r}.")
    kind = asked or "official"
    folder = BUILT / kind
    if stamp(folder).exists() and stamp(folder).read_text("utf-8") == made_of():
        return folder / "html"
    try:
        make(kind, folder)
    except Unreachable as error:
        if asked:
            raise
        print(f"The site has no lab: {error}\nTo build without asking, set {VARIABLE}=none.", file=sys.stderr)
        return None
    stamp(folder).write_text(made_of(), "utf-8")
    return folder / "html"


def make(kind: str, folder: Path) -> None:
    """Build the lab anew."""
    shutil.rmtree(folder, ignore_errors=True)
    kernel = sorted((EXTENSIONS[0] / "static" / "pypi").glob("*.whl"))
    source = SOURCES[kind]()
    packages = pyodide.lay_out(source, [*wheels.build(folder / "wheel"), *kernel], folder / "static" / "pyodide")
    for path in sources():
        target = folder / "contents" / path.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    shutil.copy(SITE / "lab" / "overrides.json", folder)
    kernel_settings = {
        "disablePyPIFallback": True,
        "loadPyodideOptions": {"packages": [name for name in pyodide.KERNEL if name in packages]},
    }
    settings = {
        "jupyter-lite-schema-version": 0,
        "jupyter-config-data": {
            "appName": "Forward kinematics",
            "appUrl": "./tree/",
            "litePluginSettings": {"@jupyterlite/pyodide-kernel-extension:kernel": kernel_settings},
        },
    }
    (folder / "jupyter-lite.json").write_text(json.dumps(settings), "utf-8")
    config = {
        "LiteBuildConfig": {
            "apps": PAGES,
            "cache_dir": str(folder / "cache"),
            "contents": [str(folder / "contents")],
            "federated_extensions": [str(path) for path in EXTENSIONS],
            "ignore_sys_prefix": ["federated_extensions"],
            "no_sourcemaps": True,
            "no_unused_shared_packages": True,
            "output_dir": str(folder / "html"),
        }
    }
    (folder / "jupyter_lite_config.json").write_text(json.dumps(config), "utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "jupyterlite_core", "build", f"--lite-dir={folder}"],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        raise ValueError(f"JupyterLite did not build:\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    for page in PAGES:
        dress(folder / "html" / page / "index.html")


def dress(page: Path) -> None:
    """Give a page of JupyterLite what all of ours have: a language and an icon. Without one, browsers ask for a file."""
    text = page.read_text("utf-8")
    icon = '<link rel="icon" type="image/svg+xml" href="../../_static/favicon.svg">'
    page.write_text(text.replace("<html>", '<html lang="en">').replace("<head>", f"<head>\n    {icon}", 1), "utf-8")


def bring(built: Path | None, target: Path) -> None:
    """Put the lab among the pages, unless it is there; or take it away where there is none."""
    if built and stamp(target).exists() and stamp(target).read_bytes() == stamp(built.parent).read_bytes():
        return
    shutil.rmtree(target, ignore_errors=True)
    if built:
        shutil.copytree(built, target)
        shutil.copy(stamp(built.parent), target)


def sources() -> Iterable[Path]:
    """What the lab shows: lectures, sheets as students get them, and what they link to, each where it lies here."""
    yield from sorted((ROOT / "notebooks").glob("*.ipynb"))
    yield from sorted(path for path in (ROOT / "exercises").glob("*/*") if path.suffix in (".ipynb", ".json"))
    yield ROOT / "NOTATION.md"


def made_of() -> str:
    """What the lab depends on, as one name."""
    digest = hashlib.sha256(library().encode())
    ours = [path for path in (SITE / "lab").rglob("*") if path.is_file()]
    modules = [Path(module.__file__ or "") for module in (wheels, pyodide, sys.modules[__name__])]
    for path in (*sources(), *sorted(ours), *modules, SITE / "package-lock.json"):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def stamp(folder: Path) -> Path:
    """Where it is written what a lab was made of; absent while it is being made."""
    return folder / "made_of.txt"
