"""The JavaScript of the viewer and of the site: the committed bundle matches its sources, and the linter finds nothing."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from kinlib.view.viewer.widget import STATIC

ROOT = Path(__file__).parents[2]
NPM = shutil.which("npm")
JS = ROOT / "kinlib" / "view" / "js"


@pytest.fixture(scope="module")
def node_modules():
    """The packages that package-lock.json names, installed once."""
    if NPM is None:
        pytest.skip("There is no npm. Install Node 20 or newer to change the JavaScript.")
    lock, installed = JS / "package-lock.json", JS / "node_modules" / ".package-lock.json"
    if not installed.exists() or installed.stat().st_mtime < lock.stat().st_mtime:
        done = subprocess.run([NPM, "ci"], cwd=JS, capture_output=True, text=True, check=False)
        if done.returncode:
            pytest.skip(f"npm ci failed.\n{done.stderr[-500:]}")
    return JS / "node_modules"


@pytest.mark.parametrize("name", ["viewer", "meshes"])
def test_the_committed_bundle_equals_a_new_build(node_modules, tmp_path, name):
    command = json.loads((JS / "package.json").read_text("utf-8"))["scripts"][f"build:{name}"].split()
    entry = [word for word in command if not word.startswith("--outfile")]
    bundle = tmp_path / f"{name}.js"
    # npm finds esbuild in node_modules, on every system
    done = subprocess.run(
        [NPM, "exec", "--offline", "--", *entry, f"--outfile={bundle}"],
        cwd=JS, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert bundle.read_bytes() == (STATIC / f"{name}.js").read_bytes(), "run: npm run build"


def test_the_linter_and_the_formatter_find_nothing_to_change(node_modules):
    done = subprocess.run([NPM, "run", "--silent", "lint"], cwd=JS, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, f"run: npm run format\n{done.stdout}{done.stderr}"
