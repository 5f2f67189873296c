"""course.py, which starts everything: what it installs and when, and what it says if it cannot."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import course

ROOT = Path(__file__).parents[2]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A course of two files, and the commands that would install it."""
    for name in ("pyproject.toml", "constraints.txt"):
        (tmp_path / name).write_text(name, "utf-8")
    for name, value in {"ROOT": "", "VENV": ".venv", "STAMP": ".venv/stamp.txt"}.items():
        monkeypatch.setattr(course, name, tmp_path / value)
    commands = []
    monkeypatch.setattr(course, "install", lambda *command: commands.append(command))
    return tmp_path, commands


def prepare(folder, command):
    folder[1].clear()
    course.prepare(command)
    return folder[1]


def test_the_environment_is_made_once_and_again_when_a_pin_changes(folder):
    made, added = prepare(folder, "open")
    assert made[-1] == "pip"
    assert added[-4:] == ("--group", "lab", "-e", ".")
    assert prepare(folder, "open") == []
    assert len(prepare(folder, "test")) == 1  # the same environment, with more packages
    assert prepare(folder, "open") == prepare(folder, "site") == []  # what the tests need includes what these need
    (folder[0] / "constraints.txt").write_text("other pins", "utf-8")
    assert len(prepare(folder, "open")) == 2


def test_an_environment_that_was_left_half_made_is_made_again(folder, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(course, "install", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
        with pytest.raises(KeyboardInterrupt):
            course.prepare("open")
    assert len(prepare(folder, "open")) == 2


def test_what_a_command_installs_exists():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    words = [word for packages, _ in course.NEEDS.values() for word in packages]
    assert {word for word in words if word.isalpha()} <= {*project["dependency-groups"]}
    extras = {name for word in words if "[" in word for name in word.strip(".[]").split(",")}
    assert extras <= {*project["project"]["optional-dependencies"]}


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        ((), 0, "start JupyterLab on the first lecture"),
        (("opne",), 1, "must be one of open, test, site, serve; got 'opne'"),
    ],
)
def test_a_command_that_does_not_exist_is_answered_with_those_that_do(words, code, said):
    done = subprocess.run([sys.executable, "course.py", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == code
    assert said in done.stdout + done.stderr
