"""Wheels for Python in the browser: fetched as files, and written down as Pyodide's lock file wants to know them."""

import hashlib
import re
import subprocess
import sys
from email.parser import Parser
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any
from zipfile import ZipFile

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from kinsite.execute import PACKAGES, ROOT

FETCHED = ROOT / "build" / "lab" / "fetched"
"""What was fetched once is fetched."""

ANY = "--only-binary=:all: --platform=any --abi=none --implementation=py"
"""A wheel of Python alone, which runs wherever Python does."""


class Unreachable(Exception):
    """What the lab is made of cannot be had: there is no network, or it does not reach that far."""


def fetch(name: str, exactly: str = "", python: str = "3.12", sha256: str = "") -> Path:
    """Fetch the wheel of a package that is Python alone.

    exactly  the version; without it, the one that is installed here, whose other half the lab shows
    sha256   what the file must be

    Raises Unreachable where pip does not get it, ValueError where it is another file.
    """
    exactly = exactly or installed(name)
    folder = FETCHED / f"{canonicalize_name(name)}-{exactly}"
    if not list(folder.glob("*.whl")):
        pip = f"-m pip download --quiet --disable-pip-version-check --no-deps {ANY} --python-version={python}".split()
        asked = [sys.executable, *pip, f"--dest={folder}", f"{name}=={exactly}"]
        said = subprocess.run(asked, capture_output=True, text=True, check=False)
        if said.returncode:
            raise Unreachable(f"pip could not fetch {name} {exactly}: {said.stderr.strip().splitlines()[-1]}")
    (wheel,) = folder.glob("*.whl")
    if sha256 and (found := sha256_of(wheel)) != sha256:
        wheel.unlink()
        raise ValueError(f"{wheel.name} should have the sha256 {sha256}; got {found}. It is not the file that we know.")
    return wheel


def installed(name: str) -> str:
    """The version of a package that is installed here."""
    try:
        return version(name)
    except PackageNotFoundError:
        raise ValueError(f"The lab needs {name}, which is not installed here. Does pyproject.toml name it?") from None


def build(folder: Path) -> list[Path]:
    """Build the wheels of the three packages from this checkout.

    The name of each wheel depends on its content: a browser that keeps files by their names never takes an old one for the
    new one.
    """
    folder.mkdir(parents=True, exist_ok=True)
    return [_build(package, folder) for package in PACKAGES]


def _build(package: str, folder: Path) -> Path:
    for old in folder.glob(f"{package}-*.whl"):
        old.unlink()
    command = (sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder))
    subprocess.run(command, cwd=ROOT / package, check=True, capture_output=True)
    (wheel,) = folder.glob(f"{package}-*.whl")
    name, release, rest = wheel.name.split("-", 2)
    return wheel.rename(folder / f"{name}-{release}-0{sha256_of(wheel)[:12]}-{rest}")


def entry(wheel: Path, python: str = "3.12") -> dict[str, Any]:
    """What Pyodide's lock file says of a package: then a cell's `import` loads it, and what it needs.

    python  the version of the browser's Python, for which requirements are read
    """
    with ZipFile(wheel) as archive:
        names = archive.namelist()
        about = next(name for name in names if re.fullmatch(r"[^/]+\.dist-info/METADATA", name))
        metadata = Parser().parsestr(archive.read(about).decode())
    tops = {match[1] for name in names if (match := re.match(r"(\w+)(?:\.py$|/__init__\.py$)", name))}
    where = {"extra": "", "python_version": python, "sys_platform": "emscripten", "platform_system": "Emscripten"}
    needs = [Requirement(text) for text in metadata.get_all("Requires-Dist", [])]
    return {
        "name": canonicalize_name(metadata["Name"]),
        "version": metadata["Version"],
        "file_name": wheel.name,
        "install_dir": "site",
        "sha256": sha256_of(wheel),
        "package_type": "package",
        "imports": sorted(tops),
        "depends": sorted(
            canonicalize_name(need.name) for need in needs if not need.marker or need.marker.evaluate(where)
        ),
        "unvendored_tests": False,
    }


def sha256_of(path: Path) -> str:
    """The sum by which a file is known."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
