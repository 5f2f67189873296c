"""Open the course, test it, or build and serve its site. This needs nothing but Python 3.11 or newer and pip.

    python course.py open        start JupyterLab on the first lecture
    python course.py test        run every test, or with --quick those that find most faults in a few minutes
    python course.py site        build the course site into build/site/html
    python course.py serve       serve it on http://127.0.0.1:8000, to this machine only

The first run makes an environment in .venv, with the versions in constraints.txt; later runs use it again.
Further arguments are passed on to JupyterLab or pytest: "open --no-browser", "test -k lie".
With --newest, open and test ignore constraints.txt and install the newest versions.

The tasks of maintainers are in noxfile.py.
"""

import hashlib
import importlib.util
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import uv_settings

ROOT = Path(__file__).resolve().parents[1]
UV = ROOT / ".uv"  # own folder: the system's Python may refuse packages (PEP 668) or lack the venv module
VENV = ROOT / ".venv"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
STAMP = VENV / "stamp.txt"  # what the environment was made from; does not exist while it is being made
PINS = "constraints.txt"

FIRST_LECTURE = "--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb"
PROGRAMS = {
    "open": ("-m", "jupyterlab", f"--ServerApp.root_dir={ROOT}", FIRST_LECTURE),
    "test": (  # on all cores; conftest.py says which tests run on one of them
        "-m",
        "pytest",
        "--numprocesses=auto",
        "--dist=loadscope",
        "--no-loadscope-reorder",
    ),
    "site": ("site/build.py",),
    "serve": ("site/serve.py",),
}
GROUPS = {"open": "lab", "test": "test", "site": "site", "serve": "site"}  # dependency groups of pyproject.toml
MEGABYTES = {"lab": 400, "test": 1400, "site": 500}  # what a group takes on the disk
INCLUDED = {"test": {"test", "lab", "site"}}  # groups that a group includes

INTERRUPTS: list[int] = []  # one entry for each Ctrl-C


def main(command: str = "help", *words: str) -> None:
    # Ctrl-C goes to the program that we start, too: it ends in its own way
    signal.signal(signal.SIGINT, lambda number, _: INTERRUPTS.append(number))
    signal.signal(
        signal.SIGTERM, lambda number, _: sys.exit(128 + number)
    )  # this signal reaches only us: call() passes it on
    if Path(sys.prefix) == VENV:  # an environment cannot remake itself, so the Python that made it does
        sys.exit(call(sys._base_executable, ROOT / "course.py", command, *words))
    if command in PROGRAMS:
        prepare(GROUPS[command], newest="--newest" in words)
        arguments = [word for word in words if word != "--newest"]
        sys.exit(call(PYTHON, *PROGRAMS[command], *arguments))
    elif command in ("help", "-h", "--help"):
        print(__doc__)
    else:
        known = ", ".join(PROGRAMS)
        sys.exit(f"The command must be one of {known}; got {command!r}. Try: python course.py open")


def prepare(group: str, newest: bool) -> None:
    """Make .venv, unless its stamp says that this Python made it in this folder from the same files."""
    sources = [sys.version, str(ROOT), *((ROOT / name).read_text("utf-8") for name in ("pyproject.toml", PINS))]
    fingerprint = hashlib.sha256("\n".join(sources).encode()).hexdigest()
    made_from, _, made_for = STAMP.read_text("utf-8").partition(" ") if STAMP.exists() else ("", "", "")
    made = made_from == fingerprint and not newest
    if made and group in INCLUDED.get(made_for, {made_for}):
        return
    print(f"Installing the course in {VENV}, about {MEGABYTES[group]} MB. This happens once.", flush=True)
    pins = () if newest else ("-c", PINS)
    STAMP.unlink(missing_ok=True)
    install_uv(*pins)
    if not made:
        uv("make the folder .venv", "venv", "--quiet", "--clear", "--python", sys.executable, VENV)
    uv("install the course", "pip", "install", "--python", PYTHON, *pins, "--group", group, "-e", ".")
    if not newest:
        STAMP.write_text(f"{fingerprint} {group}", "utf-8")


def install_uv(*pins: str) -> None:
    if importlib.util.find_spec("pip") is None:
        sys.exit("This Python has no pip. Try: python -m ensurepip; on Debian or Ubuntu: sudo apt install python3-pip")
    settings = {
        "PIP_USER": "0",
        "PIP_REQUIRE_VIRTUALENV": "0",
        "PIP_ROOT_USER_ACTION": "ignore",
    }  # we install into a folder
    step("fetch uv, its installer", "pip", "install", "-q", "--upgrade", "--target", UV, *pins, "uv", **settings)


def uv(purpose: str, *arguments: str | Path) -> None:
    pip = uv_settings.read_pip_settings()
    offline = ["--no-index"] if arguments[0] == "pip" and uv_settings.is_offline(pip) else []
    step(purpose, "uv", *arguments, *offline, PYTHONPATH=str(UV), **uv_settings.variables(pip))


def step(purpose: str, module: str, *arguments: str | Path, **settings: str) -> None:
    command = (sys.executable, "-m", module, *arguments)
    if call(*command, **settings):
        sys.exit(f"course.py could not {purpose}. {remedy(*command, **settings)}")


def remedy(*command: str | Path, **settings: str) -> str:
    """Say why a step has failed, as far as this can be seen, and what to do."""
    again = "The same command continues from here."
    if INTERRUPTS:
        return f"It was stopped by Ctrl-C. {again}"
    try:
        with tempfile.TemporaryFile(dir=ROOT) as file:
            file.write(bytes(10**6))
    except OSError as error:
        if (free := shutil.disk_usage(ROOT).free) < 10**7:
            return f"The disk is full: {free / 1e6:.0f} MB are left. Make room, then try again. {again}"
        return f"Files cannot be written in {ROOT}: {error.strerror}. Copy the course into a folder of your own, and run it there."
    # The step is repeated without effect, because its output must be seen where it fails, with its progress.
    if re.search("certificate|UnknownIssuer", output_of(*command, "--dry-run", **settings), re.IGNORECASE):
        return (
            "A certificate was refused; a proxy that inspects connections may have signed it. Ask your administrator for the "
            f"file with its certificate, run: python -m pip config set global.cert FILE, then try again. {again}"
        )
    if proxies := sorted(name for name in os.environ if name.upper() in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY")):
        return f"See above. Is the proxy in {' and '.join(proxies)} right? If so, check the network, then try again. {again}"
    return f"See above. Check the network, close JupyterLab, then try again. {again}"


def environment(settings: dict[str, str]) -> dict[str, str]:
    # PYTHONPATH is emptied because it adds packages of another Python; for example, ROS sets it and breaks pytest
    return {**os.environ, "PYTHONPATH": "", **settings}


def output_of(*command: str | Path, **settings: str) -> str:
    """Return what a command prints, also if it fails or does not end."""
    options = {"cwd": ROOT, "env": environment(settings), "capture_output": True, "text": True, "errors": "replace"}
    try:
        done = subprocess.run(command, timeout=60, check=False, **options)
    except subprocess.TimeoutExpired:
        return ""
    return done.stdout + done.stderr


def call(*command: str | Path, **settings: str) -> int:
    with subprocess.Popen(command, cwd=ROOT, env=environment(settings)) as program:
        try:
            return program.wait()
        except SystemExit:
            program.terminate()  # `with` waits until it has ended
            raise


if __name__ == "__main__":
    main(*sys.argv[1:])
