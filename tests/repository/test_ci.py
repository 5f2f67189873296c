"""Continuous integration: pinned actions, and the same versions of Python everywhere."""

import re
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
