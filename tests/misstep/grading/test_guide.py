"""The instructors' guide: every command line of the page runs, in the order of the page, in a fresh copy of the checkout."""

import csv
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from submissions import ROOT, SHEET, as_bytes, handed_in, right
from urdf_files import urdf_text

if sys.platform != "linux":
    pytest.skip("the sandbox is made of Linux", allow_module_level=True)

GUIDE = (ROOT / "site" / "instructors.md").read_text("utf-8")

PROGRAMS = ("misstep", "kincourse", "nbgrader")
"""The programs whose lines run here."""

NOT_RUN = {
    r"python -m venv|source ": "the tests have an environment already",
    r"(\.venv/bin/)?pip install": "it needs a package registry; tests/misstep/courses/test_foreign_course.py installs the wheels",
    r"(podman|docker) ": "it needs a container engine; .github/workflows/container.yml runs it",
    r"dask ": "it opens ports; tests/misstep/grading/platforms/test_cluster.py starts a scheduler and workers",
    r"sudo |sysctl |apt ": "it changes the machine",
}
"""The lines that do not run here, as regular expressions, and why."""

PART = re.compile(
    r"^```(?P<language>\w*)\n(?P<block>.*?)^```|(?<!`)`(?P<inline>[^`\n]+)`(?!`)", re.MULTILINE | re.DOTALL
)
COMPLETE = re.compile(
    rf"({'|'.join([*PROGRAMS, 'dask', 'pip', 'podman', 'docker', 'sudo', 'sysctl', 'apt'])}) \S+ \S+.*|misstep release"
)
"""An inline `command` with its arguments; without them, it is a name."""


def parts():
    """The blocks of Python and the command lines of the guide, in order."""
    for part in PART.finditer(GUIDE):
        if part["language"] == "python":
            yield "python", part["block"]
        elif part["inline"]:
            yield from [("line", part["inline"])] if COMPLETE.fullmatch(part["inline"]) else []
        elif not part["language"]:
            text = re.sub(r"\\\n\s*", "", part["block"])
            yield from (("line", line) for line in text.splitlines() if line and not line.startswith("#"))


LINES = list(dict.fromkeys(text for kind, text in parts() if kind == "line"))


def reason_not_to_run(line):
    return next((reason for pattern, reason in NOT_RUN.items() if re.match(pattern, line)), "")


def checkout(folder):
    """A copy of what a clone has, exercises/ included, with programs that run its code."""
    for name in ("kinlib", "misstep", "kincourse", "solutions", "exercises"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("node_modules"))
    shutil.copy(ROOT / "nbgrader_config.py", folder)
    (folder / "bin").mkdir()
    for name in (*PROGRAMS, "python"):
        module = "" if name == "python" else f"-m {name}"
        (folder / "bin" / name).write_text(f'#!/bin/sh\nexec "{sys.executable}" {module} "$@"\n')
        (folder / "bin" / name).chmod(0o755)
    return folder


def hand_in(folder):
    """What the lines of the guide take: a download with its roster, nbgrader's folder, and a robot."""
    notebooks = {student: as_bytes(handed_in(student, right(student))) for student in ("ada", "bob")}
    with zipfile.ZipFile(folder / "submissions.zip", "w") as archive:
        for number, (student, content) in enumerate(notebooks.items(), start=1):
            archive.writestr(f"x{student}_{number}_9{number}_{SHEET}.ipynb", content)
    roster = "Student,ID,SIS User ID,SIS Login ID,Section\nA,1,,ada,S\nB,2,,bob,S\n"
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    for student, content in notebooks.items():
        (folder / "submitted" / student / SHEET).mkdir(parents=True)
        (folder / "submitted" / student / SHEET / f"{SHEET}.ipynb").write_bytes(content)
    (folder / "robot.urdf").write_text(urdf_text("UR5e"), encoding="utf-8")


def notebooks_of(folder):
    return {path.relative_to(folder): path.read_bytes() for path in (folder / "exercises").rglob("*.ipynb")}


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    """The copy after all lines have run, and for each line the finished process."""
    folder = checkout(tmp_path_factory.mktemp("checkout"))
    hand_in(folder)
    path = os.pathsep.join([str(folder / "bin"), str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    environment = {**os.environ, "PYTHONPATH": str(folder), "PATH": path, "JUPYTER_CONFIG_DIR": str(folder / "none")}
    done = {}
    for kind, text in parts():
        if kind == "python" and "@problem" in text:
            lecture = folder / re.search(r"`(kincourse/lecture_\w+/problems\.py)`", GUIDE)[1]
            lecture.parent.mkdir()
            lecture.with_name("__init__.py").touch()
            lecture.write_text(text, encoding="utf-8")
        elif kind == "python" and text.startswith("from pathlib"):
            subprocess.run([sys.executable, "-c", text], cwd=folder, env=environment, check=True)
        elif kind == "line" and not reason_not_to_run(text) and text not in done:
            done[text] = subprocess.run(
                ["bash", "-c", text], cwd=folder, env=environment, capture_output=True, text=True, check=False
            )
    if any("The sandbox cannot" in process.stderr for process in done.values()):
        pytest.skip("NO GRADING IS TESTED: this machine has no sandbox")
    return folder, done


def test_every_line_of_the_guide_runs_in_a_fresh_copy_and_does_what_the_guide_says(walk):
    folder, done = walk
    failed = {
        line: process.stdout[-2000:] + process.stderr[-2000:] for line, process in done.items() if process.returncode
    }
    assert not failed
    assert len(done) >= 6
    assert "nbgrader generate_assignment 03_poe_space --force" in done
    assert {reason_not_to_run(line) for line in LINES} - {""} <= set(NOT_RUN.values())
    with (folder / "results" / "grades.csv").open(encoding="utf-8-sig", newline="") as table:
        assert {row["student"]: row["points"] for row in csv.DictReader(table)} == {"ada": "28", "bob": "28"}
    assert all((folder / "autograded" / student / SHEET / f"{SHEET}.ipynb").is_file() for student in ("ada", "bob"))
    released, before = notebooks_of(folder), notebooks_of(ROOT)
    assert released.keys() - before.keys() == {Path("exercises/11_warm_up/11_warm_up.ipynb")}
    assert all(released[path] == content for path, content in before.items())  # also after generate_assignment --force
    assert (folder / "solutions" / "my_robot" / "my_robot.json").is_file()
