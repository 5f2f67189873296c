"""Continuous integration and the tasks of maintainers: their commands exist and are complete, and a skipped test fails in CI."""

import os
import re
import subprocess
import sys
from pathlib import Path

import check_commit_message
import pytest
import yaml

ROOT = Path(__file__).parents[2]


def workflow_steps(workflow):
    """Return the steps of all jobs of a workflow, in order."""
    jobs = yaml.safe_load((ROOT / ".github" / "workflows" / workflow).read_text("utf-8"))["jobs"]
    return [step for job in jobs.values() for step in job.get("steps", ())]


def find_step(workflow, command):
    found = [step for step in workflow_steps(workflow) if command in step.get("run", "")]
    assert len(found) == 1, f"{workflow} must run {command!r} once"
    return found[0]


def test_building_the_published_site_fails_without_the_lab():
    """site/build.py alone reads KINLIB_LAB: set on another step, a failed download would publish a site without a lab."""
    assert find_step("site.yml", "course.py site")["env"]["KINLIB_LAB"] == "official"
    assert [step for step in workflow_steps("site.yml") if "KINLIB_LAB" in step.get("env", {})] == [
        find_step("site.yml", "course.py site")
    ]


WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


@pytest.mark.parametrize("workflow", WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_may_only_read_and_its_actions_are_pinned(workflow):
    """A tag of an action can be moved to other code; a hash cannot."""
    text = workflow.read_text("utf-8")
    assert yaml.safe_load(text)["permissions"] == {"contents": "read"}
    used = re.findall(r"uses: (\S+)(.*)", text)
    assert used
    for action, comment in used:
        assert action.startswith("./") or (re.search(r"@[0-9a-f]{40}$", action) and re.search(r"# v\d", comment)), (
            action
        )


def test_every_python_that_a_package_names_is_tested_tried_and_rehearsed():
    files = [ROOT / folder / "pyproject.toml" for folder in (".", "kinlib", "misstep", "kincourse")]
    named = [re.findall(r"Python :: (3\.\d+)", file.read_text("utf-8")) for file in files]
    matrices = [
        job["strategy"]["matrix"]["python"]
        for workflow in ("test.yml", "release.yml", "fresh.yml")
        for job in yaml.safe_load((ROOT / ".github/workflows" / workflow).read_text("utf-8"))["jobs"].values()
        if "python" in job.get("strategy", {}).get("matrix", {})
    ]
    assert len(matrices) == 3
    assert all(versions == named[0] for versions in (*named, *matrices))


def test_only_a_release_that_was_built_tried_and_tested_is_published():
    jobs = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text("utf-8"))["jobs"]
    assert {*jobs["publish"]["needs"]} == {*jobs} - {"publish"}
    assert [name for name, job in jobs.items() if "id-token" in job.get("permissions", {})] == ["publish"]
    assert "CITATION.cff" in find_step("release.yml", "GITHUB_REF_NAME")["run"]


def test_each_package_ships_the_licence():
    licence = (ROOT / "LICENSE").read_bytes()
    assert all((ROOT / package / "LICENSE").read_bytes() == licence for package in ("kinlib", "misstep", "kincourse"))


def test_every_nox_session_in_the_documents_exists():
    done = subprocess.run([sys.executable, "-m", "nox", "--list"], cwd=ROOT, capture_output=True, text=True, check=True)
    sessions = set(re.findall(r"^[*-] (\w+) ->", done.stdout, re.MULTILINE))
    files = [*(path for path in ROOT.glob("*.md") if path.name != "CHANGELOG.md")]  # it names sessions of old versions
    files += [*ROOT.glob("guides/*.md"), *ROOT.glob("*.toml"), *ROOT.glob("*.py"), *ROOT.glob("site/*.md")]
    named = {name for file in files for name in re.findall(r"nox -s (\w+)", file.read_text("utf-8"))}
    assert {"mutation", "fuzz", "pin", "pdf"} <= named <= sessions


TESTS = """
import pytest

def test_skipped():
    pytest.skip("there is no sandbox")

@pytest.fixture
def browser():
    pytest.skip("there is no browser")

def test_with_a_skipped_fixture(browser):
    pass

@pytest.mark.skipif(True, reason="there is no npm")
def test_marked():
    pass

@pytest.mark.xfail(reason="a known fault", strict=True)
def test_expected_to_fail():
    assert False
"""
MODULE = "import pytest\npytest.importorskip('no_such_package')"


def run_skipping_tests(folder, ci):
    """Run skipped tests and a skipped module with the project's conftest.py; return the last line and all lines of pytest."""
    (folder / "conftest.py").write_text((ROOT / "conftest.py").read_text("utf-8"), "utf-8")
    (folder / "test_skips.py").write_text(TESTS, "utf-8")
    (folder / "test_module.py").write_text(MODULE, "utf-8")
    environment = {name: value for name, value in os.environ.items() if name not in ("CI", "PYTEST_ADDOPTS")}
    environment |= {"CI": "true"} if ci else {}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--continue-on-collection-errors", "."]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    return done.stdout.splitlines()[-1], done.stdout


@pytest.mark.skipif(sys.platform != "linux", reason="only CI on Linux must run every test")
def test_in_ci_a_skipped_test_fails_with_its_reason(tmp_path):
    summary, text = run_skipping_tests(tmp_path, ci=True)
    assert summary.startswith("1 failed, 1 xfailed, 3 errors"), text
    for reason in ("no sandbox", "no browser", "no npm", "no_such_package"):
        assert reason in text


def test_outside_ci_a_skipped_test_is_skipped(tmp_path):
    summary, text = run_skipping_tests(tmp_path, ci=False)
    assert summary.startswith("4 skipped, 1 xfailed"), text


@pytest.mark.parametrize(
    ("message", "said"),
    [
        ("dh, view: embed a question\n\nBecause ...\n# a comment", ""),
        ("Merge branch 'main'", ""),
        ("dh: " + "x" * 69, "at most 72 characters; it has 73"),
        ("dh: refusing duplicate labels", "got 'refusing'"),
        ("refuse duplicate labels", "must name a module"),
        ("dh: refuse duplicate labels\nBecause ...", "must be empty"),
    ],
)
def test_the_subject_of_a_commit_is_a_short_request_to_a_module(message, said):
    found = check_commit_message.faults(message)
    assert len(found) == bool(said)
    assert said in "".join(found)
