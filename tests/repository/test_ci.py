"""Continuous integration: pinned actions, the same versions of Python everywhere, and a skipped test that fails in CI."""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


@pytest.mark.parametrize("workflow", WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_may_only_read_and_its_actions_are_pinned(workflow):
    """A tag of an action can be moved to other code; a hash cannot."""
    text = workflow.read_text("utf-8")
    assert yaml.safe_load(text)["permissions"] == {"contents": "read"}
    used = re.findall(r"uses: (\S+)(.*)", text)
    assert used
    for action, comment in used:
        is_pinned = re.search(r"@[0-9a-f]{40}$", action) and re.search(r"# v\d", comment)
        assert action.startswith("./") or is_pinned, action


def test_every_python_that_the_project_names_is_tested():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    named = re.findall(r"Python :: (3\.\d+)", "\n".join(project["classifiers"]))
    texts = [(ROOT / ".github" / "workflows" / f"{name}.yml").read_text("utf-8") for name in ("test", "release")]
    matrices = [re.findall(r'"(3\.\d+)"', row) for text in texts for row in re.findall(r"python: (\[.*\])", text)]
    assert matrices == [named, named]


TESTS = """
import pytest

def test_skipped():
    pytest.skip("there is no npm")

@pytest.mark.xfail(reason="a known fault", strict=True)
def test_expected_to_fail():
    assert False
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only CI on Linux must run every test")
@pytest.mark.parametrize(("ci", "summary"), [("true", "1 failed, 1 xfailed, 1 error"), (None, "2 skipped, 1 xfailed")])
def test_in_ci_a_skipped_test_or_module_fails(tmp_path, ci, summary):
    (tmp_path / "conftest.py").write_text((ROOT / "conftest.py").read_text("utf-8"), "utf-8")
    (tmp_path / "test_skips.py").write_text(TESTS, "utf-8")
    (tmp_path / "test_module.py").write_text("import pytest\npytest.importorskip('no_such_package')", "utf-8")
    environment = {name: value for name, value in os.environ.items() if name not in ("CI", "PYTEST_ADDOPTS")}
    environment |= {"CI": ci} if ci else {}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--continue-on-collection-errors", "."]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[-1].startswith(summary), done.stdout
