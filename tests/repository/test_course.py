"""course.py installs after a change, never uses an incomplete environment, and suggests a remedy in each error."""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
import set_up as course

COURSE = Path(__file__).parents[2] / "course.py"


@pytest.fixture
def calls(tmp_path, monkeypatch):
    """A course in a temporary folder, with its commands recorded instead of run."""
    commands = []

    def call(*command, **_settings):
        commands.append(" ".join(map(str, command[2:])))
        if " venv " in commands[-1] + " ":
            course.VENV.mkdir(exist_ok=True)
        return 0

    monkeypatch.setattr(course, "ROOT", tmp_path)
    monkeypatch.setattr(course, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(course, "STAMP", tmp_path / ".venv" / "stamp.txt")
    monkeypatch.setattr(course, "call", call)
    monkeypatch.setattr(
        course.importlib.util, "find_spec", lambda _: "pip, which an environment made by uv does not have"
    )
    (tmp_path / "pyproject.toml").write_text("[project]")
    (tmp_path / "constraints.txt").write_text("numpy==2.0")
    return commands


def steps(calls):
    """Return the kinds of the commands recorded since the last call."""
    kinds = [re.match(r"(pip|uv venv|uv pip)", line)[0] for line in calls]
    calls.clear()
    return kinds


ALL = ["pip", "uv venv", "uv pip"]


def test_the_first_run_installs_and_the_second_does_not(calls):
    course.prepare("test", newest=False)
    assert steps(calls) == ALL
    course.prepare("test", newest=False)
    assert steps(calls) == []


@pytest.mark.parametrize("name", ["pyproject.toml", "constraints.txt"])
def test_a_changed_file_installs_again(calls, tmp_path, name):
    course.prepare("test", newest=False)
    (tmp_path / name).write_text("changed")
    steps(calls)
    course.prepare("test", newest=False)
    assert steps(calls) == ALL


def test_the_test_group_adds_to_the_lab_and_includes_it(calls):
    course.prepare("lab", newest=False)
    steps(calls)
    course.prepare("test", newest=False)
    assert steps(calls) == ["pip", "uv pip"]
    course.prepare("lab", newest=False)
    assert steps(calls) == []


def test_the_newest_versions_are_installed_each_time_and_never_reused(calls):
    course.prepare("test", newest=False)
    steps(calls)
    course.prepare("test", newest=True)
    assert not any("constraints" in line for line in calls)
    assert steps(calls) == ALL
    course.prepare("test", newest=False)
    assert steps(calls) == ALL


@pytest.mark.parametrize("broken", ["pip install", "uv venv", "uv pip"])
def test_a_failed_step_is_named_and_repeated(calls, monkeypatch, broken):
    with monkeypatch.context() as patch:
        patch.setattr(course, "call", lambda *command, **_: " ".join(map(str, command[2:])).startswith(broken))
        with pytest.raises(SystemExit, match=r"could not \w+ .*Check the network"):
            course.prepare("test", newest=False)
    course.prepare("test", newest=False)
    assert "uv pip" in steps(calls)


@pytest.mark.parametrize(
    ("state", "said"),
    [
        ({}, r"Check the network, close JupyterLab"),
        ({"interrupts": [2]}, r"stopped by Ctrl-C. The same command continues"),
        ({"error": 28, "free": 10**6}, r"disk is full: 1 MB are left. Make room"),
        (
            {"error": 30, "free": 10**10},
            r"cannot be written in .*: Read-only.* Copy the course into a folder of your own",
        ),
        ({"proxy": "http://nobody:secret@localhost:1"}, r"Is the proxy in HTTPS_PROXY right"),
    ],
)
def test_a_failed_step_says_why_as_far_as_it_can_be_seen(calls, monkeypatch, state, said):
    def broken_file(**_):
        raise OSError(state["error"], os.strerror(state["error"]))

    for name in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY", "http_proxy", "https_proxy", "all_proxy"):
        monkeypatch.delenv(name, raising=False)
    if "proxy" in state:
        monkeypatch.setenv("HTTPS_PROXY", state["proxy"])
    if "error" in state:
        monkeypatch.setattr(course.tempfile, "TemporaryFile", broken_file)
        monkeypatch.setattr(course.shutil, "disk_usage", lambda _: SimpleNamespace(free=state["free"]))
    monkeypatch.setattr(course, "INTERRUPTS", state.get("interrupts", []))
    monkeypatch.setattr(course, "call", lambda *_, **__: 1)
    with pytest.raises(SystemExit, match=said) as failure:
        course.prepare("lab", newest=False)
    assert "secret" not in str(failure.value)


def test_the_size_is_said_before_anything_is_installed(calls, capsys):
    course.prepare("lab", newest=False)
    assert re.search(r"about \d+ MB. This happens once", capsys.readouterr().out)


def test_without_pip_the_error_says_how_to_install_it(calls, monkeypatch):
    monkeypatch.setattr(course.importlib.util, "find_spec", lambda _: None)
    with pytest.raises(SystemExit, match="ensurepip"):
        course.prepare("test", newest=False)
    assert steps(calls) == []


@pytest.mark.parametrize(
    ("arguments", "expected"), [([], "python course.py open"), (["fly"], "one of open, test, site, serve; got 'fly'")]
)
def test_a_wrong_or_missing_command_lists_the_commands(arguments, expected):
    done = subprocess.run([sys.executable, COURSE, *arguments], capture_output=True, text=True, check=False)
    assert expected in done.stdout + done.stderr
    assert done.returncode == bool(arguments)


PROGRAM = """
import signal, sys, time
signal.signal(signal.SIGTERM, lambda *_: sys.exit("terminated cleanly"))
print("ready", flush=True)
time.sleep(60)
"""
START_COURSE = """
import sys, set_up as course
course.VENV = None  # otherwise course.py would start itself again if the tests run in .venv
course.prepare = lambda *_, **__: None
course.PYTHON, course.PROGRAMS["open"] = sys.executable, ("-c", sys.argv[1])
course.main("open")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows terminates a program without a signal")
def test_stopping_the_course_stops_the_program_that_it_started():
    """Otherwise JupyterLab and its kernels would keep running."""
    command = [sys.executable, "-c", START_COURSE, PROGRAM]
    root = Path(course.__file__).parent
    with subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as started:
        assert started.stdout.readline() == "ready\n"
        started.terminate()
        output = started.communicate(timeout=30)[1]
    assert output == "terminated cleanly\n"
    assert started.returncode == 128 + 15


def test_an_old_python_gets_a_one_line_error():
    source = COURSE.read_text("ascii")  # Python 2 refuses any other letter
    old = f"import sys; sys.version_info = (3, 8); exec(compile({source!r}, 'course.py', 'exec'))"
    done = subprocess.run([sys.executable, "-c", old], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert re.fullmatch(r"The course needs Python 3\.11 or newer; .*\n", done.stderr)


def test_python_2_can_read_the_file_that_refuses_it():
    """Python 2 has neither f-strings nor annotations nor keyword-only arguments."""
    tree = ast.parse(COURSE.read_text("ascii"), feature_version=(3, 7))
    assert not [node for node in ast.walk(tree) if isinstance(node, (ast.JoinedStr, ast.AnnAssign, ast.FunctionDef))]
