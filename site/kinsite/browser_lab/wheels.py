"""Wheels for Python in the browser: download or build them, and describe them as Pyodide's lock file does."""

import hashlib
import re
import subprocess
import sys
from email.parser import Parser
from importlib.metadata import version
from pathlib import Path
from typing import Any
from zipfile import ZipFile

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from kinsite.execute import ROOT

DOWNLOADS = ROOT / "build" / "lab" / "downloads"
"""Downloaded files are kept here, and each is downloaded once."""


class Unreachable(Exception):
    """A file of the lab cannot be downloaded, because there is no network or the network does not allow it."""


def download(name: str, release: str = "", python: str = "3.12", sha256: str = "") -> Path:
    """Download the pure Python wheel of a package.

    release  the version; by default the installed one, because the lab contains the scripts that belong to it
    sha256   the required hash of the file

    Raises Unreachable if pip cannot download it, ValueError if the hash is different.
    """
    release = release or version(name)
    folder = DOWNLOADS / f"{canonicalize_name(name)}-{release}"
    if not list(folder.glob("*.whl")):
        pip = f"-m pip download --quiet --disable-pip-version-check --no-deps --python-version={python}"
        pure_python = "--only-binary=:all: --platform=any --abi=none --implementation=py"
        options = [*pip.split(), *pure_python.split(), f"--dest={folder}"]
        command = [sys.executable, *options, f"{name}=={release}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise Unreachable(f"pip could not download {name} {release}: {done.stderr.strip().splitlines()[-1]}")
    (wheel,) = folder.glob("*.whl")
    if sha256 and (found := sha256_of(wheel)) != sha256:
        wheel.unlink()
        raise ValueError(f"{wheel.name} must have the sha256 {sha256}; got {found}. It is deleted: build again.")
    return wheel


def build(folder: Path) -> Path:
    """Build the wheel of the course from this checkout.

    Its name contains a hash of its content. So a browser that caches files by name never uses an old wheel.
    """
    folder.mkdir(parents=True)
    command = (sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder))
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    name, release, rest = wheel.name.split("-", 2)
    return wheel.rename(folder / f"{name}-{release}-0{sha256_of(wheel)[:12]}-{rest}")


def entry(wheel: Path, python: str = "3.12") -> dict[str, Any]:
    """Write the entry of a wheel in Pyodide's lock file, so that an `import` in a cell loads it and what it depends on.

    python  the version of Python in the browser, for which the requirements are evaluated

    Requirements of extras are left out: no cell of the course needs them.
    """
    with ZipFile(wheel) as archive:
        names = archive.namelist()
        path = next(name for name in names if re.fullmatch(r"[^/]+\.dist-info/METADATA", name))
        metadata = Parser().parsestr(archive.read(path).decode())
    tops = {match[1] for name in names if (match := re.match(r"(\w+)(?:\.py$|/__init__\.py$)", name))}
    environment = {"extra": "", "python_version": python, "sys_platform": "emscripten", "platform_system": "Emscripten"}
    requirements = [Requirement(text) for text in metadata.get_all("Requires-Dist", [])]
    return {
        "name": canonicalize_name(metadata["Name"]),
        "version": metadata["Version"],
        "file_name": wheel.name,
        "install_dir": "site",
        "sha256": sha256_of(wheel),
        "package_type": "package",
        "imports": sorted(tops),
        "depends": sorted(
            canonicalize_name(one.name) for one in requirements if not one.marker or one.marker.evaluate(environment)
        ),
        "unvendored_tests": False,
    }


def sha256_of(path: Path) -> str:
    """Hash a file with SHA-256."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
