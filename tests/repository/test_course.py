"""course.py installs after a change, never uses an incomplete environment, and suggests a remedy in each error."""

import ast
import os
import re
import subprocess
import sys
import threading
import zipfile
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import SimpleNamespace

import pytest
import set_up as course
import uv_settings

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
    monkeypatch.setattr(course, "output_of", lambda *_, **__: "")
    monkeypatch.setattr(uv_settings, "read_pip_settings", dict)
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
        ({"output": "invalid peer certificate: UnknownIssuer"}, r"pip config set global.cert FILE"),
        ({"output": "SSL: CERTIFICATE_VERIFY_FAILED"}, r"A certificate was refused"),
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
    monkeypatch.setattr(course, "output_of", lambda *_, **__: state.get("output", ""))
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


# --- uv gets what pip is told ---


@pytest.fixture
def pip_conf(tmp_path, monkeypatch):
    """An empty file of pip's settings, without any other and without variables of pip and uv."""
    for name in list(os.environ):
        if name.startswith(("PIP_", "UV_", "SSL_")):
            monkeypatch.delenv(name)
    file = tmp_path / "pip.conf"
    file.touch()
    monkeypatch.setenv("PIP_CONFIG_FILE", str(file))
    return file


MIRROR, OTHER = "https://mirror.example/simple", "https://other.example/simple"


@pytest.mark.parametrize(
    ("text", "variables", "expected"),
    [
        ("[global]\nindex-url = " + MIRROR, {}, {"UV_DEFAULT_INDEX": MIRROR}),
        ("[install]\nindex-url = " + MIRROR, {}, {"UV_DEFAULT_INDEX": MIRROR}),
        ("[global]\nindex-url = " + OTHER, {"PIP_INDEX_URL": MIRROR}, {"UV_DEFAULT_INDEX": MIRROR}),
        ("", {"PIP_INDEX_URL": MIRROR, "UV_DEFAULT_INDEX": OTHER}, {"UV_DEFAULT_INDEX": None}),
        ("", {"PIP_PROXY": OTHER}, {"HTTP_PROXY": OTHER, "HTTPS_PROXY": OTHER}),
        ("[global]\ntrusted-host = a\n  b", {}, {"UV_INSECURE_HOST": "a b"}),
        ("[global]\ncert = /c.pem", {}, {"SSL_CERT_FILE": "/c.pem"}),
        ("[global]\ncert = /", {}, {"SSL_CERT_DIR": "/"}),
        ("", {"PIP_CERT": "/c.pem", "SSL_CERT_FILE": "/own.pem"}, {"SSL_CERT_FILE": None}),
        ("[global]\nfind-links =\n  /\n  /no/such/folder\n  " + OTHER, {}, {"UV_FIND_LINKS": f"/,{OTHER}"}),
        (
            f"[global]\nextra-index-url =\n  {OTHER}\n  {MIRROR}",
            {},
            {"UV_INDEX": f"{OTHER} {MIRROR}", "UV_INDEX_STRATEGY": "unsafe-best-match"},
        ),
    ],
)
def test_settings_of_pip_reach_uv_unless_uv_has_its_own(pip_conf, monkeypatch, text, variables, expected):
    pip_conf.write_text(text, "utf-8")
    for name in ("HTTP_PROXY", "HTTPS_PROXY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    told = uv_settings.variables(uv_settings.read_pip_settings())
    assert {name: told.get(name) for name in expected} == expected


WHEEL_FILES = {
    "tiny.py": "",
    "tiny-0.1.dist-info/METADATA": "Metadata-Version: 2.1\nName: tiny\nVersion: 0.1\n",
    "tiny-0.1.dist-info/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    "tiny-0.1.dist-info/RECORD": "tiny.py,,\n",
}


@pytest.mark.skipif(not course.UV.is_dir(), reason="course.py did not make this environment, so there is no uv")
@pytest.mark.parametrize("kind", ["mirror", "folder"])
def test_what_only_the_mirror_of_pip_has_is_installed_by_uv(pip_conf, tmp_path, monkeypatch, kind):
    package = tmp_path / "mirror" / "tiny"
    package.mkdir(parents=True)
    with zipfile.ZipFile(package / "tiny-0.1-py3-none-any.whl", "w") as wheel:
        for name, text in WHEEL_FILES.items():
            wheel.writestr(name, text)
    monkeypatch.setenv("UV_NO_CACHE", "1")
    if kind == "folder":
        pip_conf.write_text(f"[global]\nno-index = true\nfind-links = {package.as_posix()}\n", "utf-8")
        course.uv("install tiny", "pip", "install", "--target", tmp_path / "installed", "tiny")
    else:
        handler = partial(SimpleHTTPRequestHandler, directory=tmp_path / "mirror")
        with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            monkeypatch.setenv("PIP_INDEX_URL", f"http://127.0.0.1:{server.server_port}")
            course.uv("install tiny", "pip", "install", "--target", tmp_path / "installed", "tiny")
            server.shutdown()
    assert (tmp_path / "installed" / "tiny.py").exists()
