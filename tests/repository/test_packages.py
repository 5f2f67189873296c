"""The packages as a release has them: wheels with every file. `--quick` leaves these tests out."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("package", ["kinlib", "misstep", "kincourse"])
def test_the_wheel_that_is_built_from_the_source_archive_has_every_file_of_the_package(tmp_path, package):
    """A release builds the wheel from the archive, where the patterns of .gitignore are relative to the package."""
    build = [sys.executable, "-P", "-m", "hatchling", "build", "-d", str(tmp_path)]
    subprocess.run([*build, "-t", "sdist"], cwd=ROOT / package, capture_output=True, check=True)
    (archive,) = tmp_path.glob("*.tar.gz")
    shutil.unpack_archive(archive, tmp_path, filter="data")
    unpacked = tmp_path / archive.name.removesuffix(".tar.gz")
    subprocess.run([*build, "-t", "wheel"], cwd=unpacked, capture_output=True, check=True)
    (wheel,) = tmp_path.glob("*.whl")
    built = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    paths = [path for path in (ROOT / package).rglob("*") if path.is_file() and path.suffix != ".pyc"]
    only_source = (*(f"{package}/{name}" for name in ("pyproject.toml", "README.md", "LICENSE")), f"{package}/docs/")
    files = {path.relative_to(ROOT).as_posix() for path in paths if ".ipynb_checkpoints" not in path.parts}
    assert built == {file for file in files if not file.startswith(only_source)}
    documents = {file.removeprefix(f"{package}/") for file in files if file.startswith(f"{package}/docs/")}
    assert documents <= {path.relative_to(unpacked).as_posix() for path in unpacked.rglob("*")}
