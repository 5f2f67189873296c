"""The container for grading: what its file names exists, and the guide and the workflow run it in the same way."""

import json
import re
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
CONTAINERFILE = (ROOT / "deploy" / "Containerfile").read_text("utf-8")
GUIDE = (ROOT / "site" / "instructors.md").read_text("utf-8")
RUN = re.compile(r"(podman|docker) run (.+?) misstep (grade .+)")


def instructions():
    """The instructions of the Containerfile: their names and arguments, without comments."""
    text = re.sub(r"\\\n\s*", "", re.sub(r"^#.*\n", "", CONTAINERFILE, flags=re.MULTILINE))
    return [tuple(line.split(maxsplit=1)) for line in text.splitlines() if line]


def test_its_python_is_one_that_the_packages_support_and_the_tests_use():
    version = re.search(r"python:(\d+\.\d+)-slim", CONTAINERFILE)[1]
    test = yaml.safe_load((ROOT / ".github" / "workflows" / "test.yml").read_text("utf-8"))
    assert version in test["jobs"]["test"]["strategy"]["matrix"]["python"]


def test_it_copies_files_that_exist_and_installs_extras_that_exist():
    copied = [arguments.split()[:-1] for name, arguments in instructions() if name == "COPY"]
    packages = ["kinlib", "misstep", "kincourse"]
    assert copied == [["constraints.txt", "deploy/hub.txt"], *([name] for name in packages), ["deploy/collect.py"]]
    assert all((ROOT / path).exists() for paths in copied for path in paths)
    allowed = (ROOT / "deploy" / "Containerfile.dockerignore").read_text("utf-8").split()
    assert {f"!{path}" for paths in copied for path in paths} <= set(allowed)
    extras = re.search(r"/misstep\[([\w,]+)\]", CONTAINERFILE)[1].split(",")
    project = tomllib.loads((ROOT / "misstep" / "pyproject.toml").read_text("utf-8"))["project"]
    assert set(extras) <= set(project["optional-dependencies"])
    assert f"'./misstep[{','.join(extras)}]'" in GUIDE  # the same as without a container


def test_it_has_no_entry_point_because_the_guides_and_the_hub_name_the_program():
    """Kubernetes passes the command of a student's server as arguments of the entry point."""
    assert not [arguments for name, arguments in instructions() if name == "ENTRYPOINT"]
    (command,) = [json.loads(arguments) for name, arguments in instructions() if name == "CMD"]
    assert command[0] in tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["scripts"]


def test_its_system_calls_include_those_with_which_the_sandbox_is_made():
    profile = json.loads((ROOT / "deploy" / "seccomp.json").read_text("utf-8"))
    refused = {name for rule in profile["syscalls"] for name in rule["names"]}
    needed = {
        "unshare",
        "setns",
        "clone",
        "mount",
        "umount2",
        "pivot_root",
        "prctl",
        "seccomp",
        "setresuid",
        "memfd_create",
    }
    needed |= {"landlock_create_ruleset", "landlock_add_rule", "landlock_restrict_self", "pidfd_open", "capset"}
    assert profile["defaultAction"] == "SCMP_ACT_ALLOW"
    assert not needed & refused
    assert {"ptrace", "bpf", "init_module", "kexec_load"} <= refused


@pytest.mark.parametrize("engine", ["podman", "docker"])
def test_the_workflow_runs_what_the_guide_says(engine):
    workflow = (ROOT / ".github" / "workflows" / "container.yml").read_text("utf-8")
    (in_guide,), (in_workflow,) = (
        [match[2] for match in RUN.finditer(re.sub(r"\\\n\s*", "", text)) if match[1] == engine]
        for text in (GUIDE, workflow)
    )
    assert in_guide == in_workflow
    named = re.search(r"seccomp=(\S+)", in_guide)[1]
    assert (ROOT / named).is_file()
    assert f"{engine} build --tag course --file deploy/Containerfile ." in GUIDE + workflow.replace(
        "${{ matrix.engine }}", engine
    )
